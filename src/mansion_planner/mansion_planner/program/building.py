"""Assemble the building program of Fig. 23 from decisions, massing and sketches."""

from dataclasses import dataclass, field, replace

import numpy as np

from mansion_geometry.randomness import item_generator
from mansion_msgs_py.program import (
    AreaSummary,
    BuildingProgram,
    CorePlan,
    Downgrade,
    FloorProgram,
    RoomProgram,
    VerticalConnectivity,
)
from mansion_msgs_py.request import BuildRequest
from mansion_planner.brief.facts import AdjacencyFact, BriefFacts
from mansion_planner.knowledge import KnowledgeBase
from mansion_planner.program.allocation import Allocation, allocate, make_storeys
from mansion_planner.program.bearing import bearing_walls
from mansion_planner.program.decisions import Decisions, decide
from mansion_planner.program.envelope import Envelope, envelope_of
from mansion_planner.program.filling import fill_storey, fit_areas, hub_area, name_rooms
from mansion_planner.program.footprint import free_cores, free_massing, sketch_free
from mansion_planner.program.frame import Frame
from mansion_planner.program.hall import sketch_hall
from mansion_planner.program.inference import note
from mansion_planner.program.massing import (
    MassingWish,
    choose_massing,
    choose_shape,
    rectangle_massing,
)
from mansion_planner.program.materials import materials_of
from mansion_planner.program.model import Massing, Storey, box_area
from mansion_planner.program.placement import Sketch, short_edges, touching
from mansion_planner.program.sizes import storey_area, typical_room
from mansion_planner.program.sketch import capacity, sketch_storey
from mansion_planner.program.vertical import vertical_method

__all__ = ["PlannedBuilding", "plan_program"]


@dataclass
class PlannedBuilding:
    """The program and what it was made from, for the topology stage."""

    program: BuildingProgram
    decisions: Decisions
    massing: Massing
    frame: Frame
    storeys: list[Storey]
    sketches: dict[int, Sketch] = field(default_factory=dict)
    envelopes: dict[int, Envelope] = field(default_factory=dict)


def hub_name(storey: Storey) -> str:
    """Return the id of a storey's hub."""
    return storey.hub.name


def plan_program(
    request: BuildRequest,
    facts: BriefFacts,
    knowledge: KnowledgeBase,
    building_id: str,
    generator: np.random.Generator,
) -> PlannedBuilding:
    """Decide, distribute the rooms, choose the massing, and sketch every storey.

    Raises
    ------
    MansionError
        See `mansion_planner.plan.plan_building`.
    """
    decisions = decide(request, facts, knowledge, generator)
    storeys = make_storeys(decisions, knowledge)
    allocation = allocate(decisions, knowledge, storeys)
    method, stairs, lifts, why = vertical_method(decisions, storeys, allocation, knowledge)
    area = storey_area(decisions, storeys, allocation, knowledge, stairs, lifts)
    wish = MassingWish(
        area, decisions.building, stairs, lifts, exact=decisions.area_stated,
        room=typical_room(storeys, allocation, knowledge), shape=choose_shape(decisions, area, generator),
    )  # fmt: skip
    massing, frame, sketches, envelopes = _best_layout(
        decisions, wish, storeys, allocation, knowledge
    )
    walls = bearing_walls([sketches[storey.index] for storey in storeys], frame)
    program = BuildingProgram(
        building_id=building_id,
        reasoning=_reasoning(decisions, area),
        vertical_connectivity=VerticalConnectivity(
            method=method, cores=_cores(massing, frame), justification=why
        ),
        floors=[
            _floor(decisions, storey, sketches[storey.index], envelopes[storey.index], knowledge)
            for storey in storeys
        ],
        description=request.description,
        building_type=decisions.building.name,
        style=decisions.style,
        seed=request.seed,
        trace=decisions.trace,
        downgrades=decisions.downgrades,
    )
    for floor in program.floors:
        floor.structural_walls = list(walls)
    _set_elevations(program)
    note(decisions.trace, None, f"{why}")
    return PlannedBuilding(program, decisions, massing, frame, storeys, sketches, envelopes)


_Layout = tuple[Massing, Frame, dict[int, Sketch], dict[int, Envelope]]


def _best_layout(
    decisions: Decisions,
    wish: MassingWish,
    storeys: list[Storey],
    allocation: Allocation,
    knowledge: KnowledgeBase,
) -> _Layout:
    """Lay the building out; when rooms lack a door's wall or wished neighbours stay apart, try other proportions."""
    best: tuple[int, _Layout] | None = None
    attempts = 6 if decisions.outline is None and not decisions.free_form else 1
    for attempt in range(attempts):
        growth = 1.0 if decisions.area_stated else 1.0 + 0.03 * attempt
        generator = item_generator(decisions.seed, "massing", attempt)
        layout = _lay_out(
            decisions,
            replace(wish, area=wish.area * growth, variant=attempt),
            storeys,
            allocation,
            knowledge,
            generator,
        )
        apart = sum(len(apart_pairs(decisions, s, layout[2][s.index])) for s in storeys)
        short = sum(len(short_edges(layout[2][s.index])) for s in storeys if s.copy is None)
        missed = apart + short
        if best is None or missed < best[0]:
            best = (missed, layout)
        if missed == 0:
            break
    assert best is not None
    return best[1]


def _lay_out(
    decisions: Decisions,
    wish: MassingWish,
    storeys: list[Storey],
    allocation: Allocation,
    knowledge: KnowledgeBase,
    generator: np.random.Generator,
) -> _Layout:
    massing = _massing(decisions, wish, generator)
    frame = _frame(decisions, massing, storeys, generator)
    sketches: dict[int, Sketch] = {}
    envelopes: dict[int, Envelope] = {}
    pairs = wanted_pairs(decisions)
    for storey in storeys:
        source = next((s for s in storeys if s.index == storey.copy), None)
        if source is None:
            _furnish(storey, massing, allocation, knowledge, decisions)
            sketches[storey.index] = _sketch(decisions, massing, storey, pairs)
        else:
            storey.rooms = source.rooms
            sketches[storey.index] = sketches[source.index]
        envelopes[storey.index] = (
            Envelope.of(decisions.outline)
            if decisions.free_form and decisions.outline is not None
            else envelope_of(massing, storey, frame)
        )
    return massing, frame, sketches, envelopes


def _massing(decisions: Decisions, wish: MassingWish, generator: np.random.Generator) -> Massing:
    shape = decisions.outline
    if shape is None:
        return choose_massing(wish, generator)
    if decisions.free_form:
        return free_massing(shape, free_cores(shape, wish.stairs, wish.lifts))
    x0, y0, x1, y1 = shape.bounds
    return rectangle_massing(wish, max(x1 - x0, y1 - y0), min(x1 - x0, y1 - y0))


def _frame(
    decisions: Decisions, massing: Massing, storeys: list[Storey], generator: np.random.Generator
) -> Frame:
    """Turn and mirror by chance; a given outline stays where it is."""
    mirror_x, mirror_y, swap = (bool(value) for value in generator.random(3) < 0.5)
    length = massing.length + max(storey.extension for storey in storeys)
    bounds = (0.0, -massing.drop, length, massing.depth)
    shape = decisions.outline
    if shape is None:
        return Frame(bounds, mirror_x, mirror_y, swap)
    if decisions.free_form:
        return Frame((0.0, 0.0, 0.0, 0.0))
    x0, y0, x1, y1 = shape.bounds
    return Frame(bounds, mirror_x, mirror_y, y1 - y0 > x1 - x0, origin=(x0, y0))


def _sketch(
    decisions: Decisions, massing: Massing, storey: Storey, pairs: list[tuple[str, str]]
) -> Sketch:
    if decisions.free_form and decisions.outline is not None:
        cores = sum(box_area(core.box) for core in massing.cores)
        return sketch_free(storey, hub_name(storey), decisions.outline.area - cores)
    lay_out = sketch_hall if massing.hall else sketch_storey
    return lay_out(massing, storey, hub_name(storey), pairs)


def _furnish(
    storey: Storey,
    massing: Massing,
    allocation: Allocation,
    knowledge: KnowledgeBase,
    decisions: Decisions,
) -> None:
    """Choose a storey's rooms, settle their areas and name them."""
    stated = hub_area(storey, allocation)
    if decisions.free_form and decisions.outline is not None:
        cores = sum(box_area(core.box) for core in massing.cores)
        room, share = 0.84 * (decisions.outline.area - cores), 0.0
    else:
        room, share = capacity(massing, storey), 0.0
    if massing.hall:
        share = stated or max(storey.hub.usual, 0.38 * room)
    storey.rooms = fill_storey(storey, allocation, knowledge, room, hub_share=share)
    if massing.hall:
        asked = sum(r.gross for r in storey.rooms)
        fit_areas(
            storey.rooms, room - share if stated else min(room - share, max(asked, 0.45 * room))
        )
    else:
        fit_areas(storey.rooms, room)
    name_rooms(storey, hub_name(storey))


def wanted_pairs(decisions: Decisions) -> list[tuple[str, str]]:
    """Return room types to be side by side: the brief's wishes last, so that they win."""
    usual = [
        ("kitchen", "dining_room"),
        ("commercial_kitchen", "restaurant"),
        ("commercial_kitchen", "cafeteria"),
    ]
    return usual + [(fact.first, fact.second) for fact in decisions.facts.adjacent]


def _reasoning(decisions: Decisions, area: float) -> str:
    levels = f"{decisions.floors} storeys" if decisions.floors > 1 else "one storey"
    below = f" and {decisions.basements} below ground" if decisions.basements else ""
    return (
        f"A {decisions.building.name.replace('_', ' ')} of {levels}{below}, about {area:.0f} m2 each; rooms follow "
        f"the brief first, then what such a building usually holds; circulation and cores stay at the same place on "
        f"every floor."
    )


def _cores(massing: Massing, frame: Frame) -> list[CorePlan]:
    cores = []
    for core in massing.cores:
        x0, y0, x1, y1 = frame.area_box(core.box)
        cores.append(
            CorePlan(
                id=core.id,
                type=core.type,
                x=(x0, x1),
                y=(y0, y1),
                door_side=frame.side(core.side),
            )
        )
    return cores


def _floor(
    decisions: Decisions,
    storey: Storey,
    sketch: Sketch,
    envelope: Envelope,
    knowledge: KnowledgeBase,
) -> FloorProgram:
    gross = envelope.area
    placed = sum(placement.area for placement in sketch.rooms)
    circulation = gross - placed
    hub_least = min(storey.hub.least, 0.5 * circulation)
    reserve = min(max(0.12 * gross, min(0.25 * gross, circulation - hub_least)), circulation - 1.0)
    hub_area = max(circulation - reserve, 1.0)
    floor, wall = materials_of(storey.hub, decisions.style, knowledge, decisions.facts.materials)
    rooms = [
        RoomProgram(
            id=hub_name(storey), area_estimate=round(hub_area, 2), room_type=storey.hub.name,
            floor_material=floor, wall_material=wall, open_relation="open", notes="circulation hub",
        )
    ]  # fmt: skip
    beside = _neighbours(decisions, storey, sketch)
    for placement in sketch.rooms:
        room = placement.room
        floor, wall = materials_of(room.kind, decisions.style, knowledge, decisions.facts.materials)
        rooms.append(
            RoomProgram(
                id=room.id, area_estimate=round(placement.area, 2), room_type=room.kind.name,
                floor_material=floor, wall_material=wall,
                open_relation="open" if room.kind.open else "door", notes=room.notes,
                adjacent_to=beside.get(room.id, []),
            )
        )  # fmt: skip
    total = sum(room.area_estimate for room in rooms)
    summary = AreaSummary(
        sum_rooms=round(total, 2),
        reserve_ratio=round(1.0 - total / gross, 4),
        fits_within_gfa=total <= gross,
        notes=_reserve_notes(1.0 - total / gross),
    )
    return FloorProgram(
        index=storey.index,
        requirement=_requirement(storey),
        gross_floor_area=round(gross, 2),
        rooms=rooms,
        area_summary=summary,
        label="G" if storey.index == 1 and decisions.floors > 1 else _label(storey.index),
        height=min(max(storey.use.height, 3.0), 4.2),
        outline=envelope.outline,
        holes=envelope.holes,
        copy=storey.copy,
    )


def _reserve_notes(ratio: float) -> str:
    if ratio < 0.119:
        return "less than 12% in reserve: no cores, and a large room at the end of a short corridor"
    return "the reserve holds cores, corridors and the rest of the hub"


def apart_pairs(decisions: Decisions, storey: Storey, sketch: Sketch) -> list[AdjacencyFact]:
    """Return the wished neighbours that both are on the storey and do not touch."""
    apart = []
    for fact in decisions.facts.adjacent:
        firsts = [p for p in sketch.rooms if p.room.kind.name == fact.first]
        seconds = [p for p in sketch.rooms if p.room.kind.name == fact.second]
        if storey.hub.name in (fact.first, fact.second) or not firsts or not seconds:
            continue
        if not any(a is not b and touching(a, b) for a in firsts for b in seconds):
            apart.append(fact)
    return apart


def _neighbours(decisions: Decisions, storey: Storey, sketch: Sketch) -> dict[str, list[str]]:
    """Return the neighbours that the brief wishes, by room id; what the storey cannot give is recorded."""
    beside: dict[str, list[str]] = {}
    apart = apart_pairs(decisions, storey, sketch) if not decisions.free_form else []
    for fact in decisions.facts.adjacent:
        firsts = [p for p in sketch.rooms if p.room.kind.name == fact.first]
        seconds = [p for p in sketch.rooms if p.room.kind.name == fact.second]
        pairs = [(a, b) for a in firsts for b in seconds if a is not b]
        if fact in apart:
            decisions.downgrades.append(
                Downgrade(
                    wish=fact.span.words, got="both on one storey, reached from one corridor", stage="program",
                    reason="their sizes leave no place side by side", floor=storey.index,
                )
            )  # fmt: skip
        elif pairs and storey.hub.name not in (fact.first, fact.second):
            pair = next((p for p in pairs if decisions.free_form or touching(*p)), pairs[0])
            beside.setdefault(pair[0].room.id, []).append(pair[1].room.id)
    return beside


def _label(index: int) -> str:
    return str(index) if index >= 1 else f"B{1 - index}"


def _requirement(storey: Storey) -> str:
    kinds: list[str] = []
    for room in storey.rooms:
        name = room.kind.name.replace("_", " ")
        if name not in kinds:
            kinds.append(name)
    use = storey.use.name.replace("_", " ")
    return (
        f"{storey.role} storey of a {use}: {', '.join(kinds[:8])}"
        if kinds
        else f"{storey.role} storey of a {use}"
    )


def _set_elevations(program: BuildingProgram) -> None:
    level = 0.0
    for floor in program.floors:
        if floor.index >= 1:
            floor.elevation = round(level, 3)
            level += floor.height
    level = 0.0
    for floor in reversed(program.floors):
        if floor.index < 1:
            level -= floor.height
            floor.elevation = round(level, 3)
