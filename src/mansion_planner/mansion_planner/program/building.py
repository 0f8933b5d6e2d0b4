"""Assemble the building program of Fig. 23 from decisions, massing and sketches."""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace

import msgspec
import numpy as np

from mansion_knowledge import KnowledgeBase, RoomType
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.limits import MAX_FLOOR_AREA
from mansion_msgs_py.program import (
    AreaSummary,
    BuildingProgram,
    Clutter,
    CorePlan,
    FloorProgram,
    RoomProgram,
    TraceEntry,
    VerticalConnectivity,
)
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wishes import AREA_TOLERANCE
from mansion_msgs_py.wording import with_article
from mansion_planner.brief.facts import BriefFacts, MaterialFact
from mansion_planner.brief_checks import check_total_area
from mansion_planner.program.allocation import allocate
from mansion_planner.program.arrangement import Arrangement, best_arrangement, neighbours, unmet_neighbours
from mansion_planner.program.building_size import called_size
from mansion_planner.program.compact_outline import with_compact_outline
from mansion_planner.program.decisions import Decisions, decide
from mansion_planner.program.massing import MassingWish, choose_shape, storey_area, typical_room, vertical_method
from mansion_planner.program.model import CoreWish, Massing, Placement, PlannedRoom, Sketch, Storey, aliases_of
from mansion_planner.program.outline import Envelope, Frame, bearing_walls
from mansion_planner.program.outside import outside_of
from mansion_planner.program.setbacks import setback_record
from mansion_planner.program.stairs import stair_size, storey_height
from mansion_planner.program.step_record import Record
from mansion_planner.program.storeys import floors_of, is_hall, make_storeys
from mansion_planner.program.wish_ledger import furniture_of, requested_objects, wishes_of

__all__ = ["PlannedBuilding", "clutter_of", "floor_program", "materials_of", "plan_program", "with_elevations"]


@dataclass(frozen=True)
class PlannedBuilding:
    """The program and what it was made from, for the topology stage."""

    program: BuildingProgram
    decisions: Decisions
    massing: Massing
    frame: Frame
    storeys: list[Storey]
    sketches: dict[int, Sketch] = field(default_factory=dict)
    envelopes: dict[int, Envelope] = field(default_factory=dict)


def plan_program(
    request: BuildRequest, facts: BriefFacts, knowledge: KnowledgeBase, building_id: str, generator: np.random.Generator
) -> PlannedBuilding:
    """Decide, distribute the rooms, choose the massing, and sketch every storey.

    Raises
    ------
    MansionError
        See `mansion_planner.plan.plan_building`.
    """
    decisions = decide(request, facts, knowledge, generator)
    bare, of_storeys = make_storeys(decisions, knowledge)
    allocation, of_rooms = allocate(decisions, knowledge, bare)
    method, stairs, lifts, why = vertical_method(decisions, bare, allocation, knowledge)
    cores = CoreWish(stairs, lifts, stair_size(decisions, bare))
    area, of_area = storey_area(decisions, bare, allocation, knowledge, cores)
    if decisions.area_stated and area <= MAX_FLOOR_AREA:
        check_total_area(area * decisions.floors)  # sketching so many rooms would take minutes
    decisions = with_compact_outline(decisions, area, stairs)
    shape, of_shape = choose_shape(decisions, area, stairs, generator)
    wish = MassingWish(
        area, decisions.building, cores, exact=decisions.area_stated or bool(called_size(decisions.facts)),
        room=typical_room(bare, allocation, knowledge), shape=shape, hall=is_hall(decisions),
    )  # fmt: skip
    layout = best_arrangement(decisions, wish, bare, allocation, knowledge)
    unmet = (u for s in layout.storeys for u in unmet_neighbours(decisions, s, layout.sketches[s.index]))
    why_so = Record((TraceEntry(words="", effect=why),), tuple(unmet))
    record = of_storeys + of_rooms + of_area + of_shape + setback_record(decisions, layout.storeys) + why_so
    decisions = replace(
        decisions,
        trace=[*decisions.trace, *record.trace],
        downgrades=[*decisions.downgrades, *record.downgrades],
        furniture=furniture_of(decisions, layout.storeys),
    )
    if request.footprint is None and not any("area" in entry.wish for entry in decisions.downgrades):
        _refuse_other_area(request, layout)
    vertical = VerticalConnectivity(method=method, cores=_cores(layout.massing, layout.frame), justification=why)
    program = _program(request, decisions, layout, vertical, area, building_id, knowledge)
    return PlannedBuilding(
        program, decisions, layout.massing, layout.frame, layout.storeys, layout.sketches, layout.envelopes
    )


def _program(
    request: BuildRequest,
    decisions: Decisions,
    layout: Arrangement,
    vertical: VerticalConnectivity,
    area: float,
    building_id: str,
    knowledge: KnowledgeBase,
) -> BuildingProgram:
    """Write down the program of an arranged building."""
    named = decisions.facts.building_name
    return BuildingProgram(
        building_id=building_id,
        reasoning=_reasoning(decisions, area),
        vertical_connectivity=vertical,
        floors=_floors(decisions, layout, knowledge),
        description=request.description,
        building_type=named or decisions.building.name,
        planned_like=decisions.building.name if named else "",
        style=decisions.style,
        outside=outside_of(decisions.facts.outside, decisions.building.name, decisions.style),
        seed=request.seed,
        trace=decisions.trace,
        downgrades=decisions.downgrades,
        wishes=wishes_of(decisions, knowledge),
    )


def _refuse_other_area(request: BuildRequest, layout: Arrangement) -> None:
    """Raise where the outline that the rooms need does not have the area that the request states.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with the area that would be accepted.
    """
    areas = [layout.envelopes[storey.index].area for storey in layout.storeys]
    stated = (("area", request.area, sum(areas)), ("floor_area", request.floor_area, sum(areas) / len(areas)))
    for name, asked, found in stated:
        if asked is None or abs(found - asked) <= AREA_TOLERANCE * asked:
            continue
        where = f"{len(areas)} storeys" if len(areas) > 1 else "one storey"
        each = " each" if name == "floor_area" and len(areas) > 1 else ""
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"the rooms, stairs and corridors come to {where} of {found:.0f} m2{each or ' in all'}; "
            f"$.{name} = {asked:g} asks for {'less' if found > asked else 'more'}",
            path=f"$.{name}",
            details={"asked": asked, "found": round(found, 1), "stage": "program"},
        )


def _floors(decisions: Decisions, layout: Arrangement, knowledge: KnowledgeBase) -> list[FloorProgram]:
    """Return the floors with their structural walls and elevations."""
    walls = bearing_walls([layout.sketches[storey.index] for storey in layout.storeys], layout.frame)
    floors = [
        floor_program(decisions, storey, layout.sketches[storey.index], layout.envelopes[storey.index], knowledge)
        for storey in layout.storeys
    ]
    return with_elevations([msgspec.structs.replace(floor, structural_walls=list(walls)) for floor in floors])


def materials_of(
    kind: RoomType, style: str, knowledge: KnowledgeBase, wishes: list[MaterialFact] | None = None
) -> tuple[str, str]:
    """Return the floor and the wall material of a room type in a style.

    `wishes` of the brief come before the style, those for a type of room before those for all, which leave wet rooms
    alone.

    Examples
    --------
    >>> from mansion_knowledge import default_knowledge
    >>> base = default_knowledge()
    >>> materials_of(base.room("bathroom"), "neutral", base)
    ('ceramic tile, light gray', 'ceramic wall tile, white')
    """
    chosen = knowledge.styles[style]
    wall = "dry"
    if kind.zone == "circulation":
        wall = "circulation"
    elif kind.wet:
        wall = "wet"
    elif kind.finish == "concrete":
        wall = "industrial"
    floor_text, wall_text = chosen.floors[kind.finish], chosen.walls[wall]
    for wish in sorted(wishes or [], key=lambda wish: bool(wish.room_type)):
        if wish.room_type not in ("", kind.name) or (not wish.room_type and kind.wet):
            continue
        if wish.surface == "floor":
            floor_text = wish.material
        else:
            wall_text = wish.material
    return floor_text, wall_text


def floor_program(
    decisions: Decisions, storey: Storey, sketch: Sketch, envelope: Envelope, knowledge: KnowledgeBase
) -> FloorProgram:
    """Return a storey's rooms, hub first, with the areas that its sketch gives them, square metres."""
    gross = envelope.area
    placed = sum(placement.area for placement in sketch.rooms)
    circulation = gross - placed
    hub_least = min(storey.hub.least, 0.5 * circulation)
    reserve = min(max(0.12 * gross, min(0.25 * gross, circulation - hub_least)), circulation - 1.0)
    hub_area = max(circulation - reserve, 1.0)
    rooms = [_hub_program(decisions, storey, hub_area, knowledge)]
    beside = neighbours(decisions, storey, sketch)
    rooms += [_room_program(decisions, storey, placement, beside, knowledge) for placement in sketch.rooms]
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
        height=storey_height(decisions, storey),
        outline=envelope.outline,
        holes=envelope.holes,
        copy=storey.copy,
    )


def _hub_program(decisions: Decisions, storey: Storey, area: float, knowledge: KnowledgeBase) -> RoomProgram:
    """Return the room that the others of a storey are reached through."""
    floor, wall = materials_of(storey.hub, decisions.style, knowledge, decisions.facts.materials)
    return RoomProgram(
        id=storey.hub.name, area_estimate=round(area, 2), room_type=storey.hub.name,
        floor_material=floor, wall_material=wall, open_relation="open", notes="circulation hub",
        name=_hub_name(decisions, storey), objects=requested_objects(decisions, storey.hub.name, storey),
        clutter=clutter_of(storey.hub.name, decisions),
    )  # fmt: skip


def _room_program(
    decisions: Decisions,
    storey: Storey,
    placement: Placement,
    beside: Mapping[str, list[str]],
    knowledge: KnowledgeBase,
) -> RoomProgram:
    """Return a room with the area that its place in the sketch has."""
    room = placement.room
    floor, wall = materials_of(room.kind, decisions.style, knowledge, decisions.facts.materials)
    return RoomProgram(
        id=room.id, area_estimate=round(placement.area, 2), room_type=room.kind.name,
        floor_material=floor, wall_material=wall,
        open_relation="open" if _stands_open(room, storey) else "door", notes=room.notes,
        adjacent_to=beside.get(room.id, []), name=room.label, aliases=aliases_of(room),
        objects=requested_objects(decisions, room.id, storey), clutter=clutter_of(room.kind.name, decisions),
    )  # fmt: skip


def _stands_open(room: PlannedRoom, storey: Storey) -> bool:
    """Whether a room has no wall to what it is reached from; outside homes kitchens and rooms of the staff have one."""
    of_staff = "staff" in room.label.lower().split()
    return room.kind.open and (storey.use.family == "home" or not (room.kind.food or of_staff))


def clutter_of(kind: str, decisions: Decisions) -> Clutter | msgspec.UnsetType:
    """Return whether few or many things lie about in rooms of a type.

    What is said of such rooms alone counts most, then the request, then what is said of the whole building.
    """
    said = {fact.room_type: fact.clutter for fact in decisions.facts.clutter}
    if decisions.clutter is not msgspec.UNSET:
        said[""] = decisions.clutter
    return said.get(kind, said.get("", msgspec.UNSET))


def _hub_name(decisions: Decisions, storey: Storey) -> str:
    """Return what the brief calls the room that is a storey's hub; empty where it does not name it."""
    for fact in decisions.facts.rooms:
        floors = floors_of(fact.floors, decisions) if fact.floors else [1]
        if fact.room_type == storey.hub.name and fact.count == 1 and storey.index in floors:
            return fact.label
    return ""


def _reserve_notes(ratio: float) -> str:
    if ratio < 0.119:
        return "less than 12% in reserve: no cores, and a large room at the end of a short corridor"
    return "the reserve holds cores, corridors and the rest of the hub"


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
        f"{storey.role} storey of {with_article(use)}: {', '.join(kinds[:8])}"
        if kinds
        else f"{storey.role} storey of {with_article(use)}"
    )


def _reasoning(decisions: Decisions, area: float) -> str:
    levels = f"{decisions.floors} storeys" if decisions.floors > 1 else "one storey"
    each = " each" if decisions.floors + decisions.basements > 1 else ""
    below = f" and {decisions.basements} below ground" if decisions.basements else ""
    kind = with_article(decisions.building.name.replace("_", " ")).capitalize()
    return (
        f"{kind} of {levels}{below}, about {area:.0f} m2{each}; rooms follow "
        f"the brief first, then what such a building usually holds; circulation and cores stay at the same place on "
        f"every floor."
    )


def _cores(massing: Massing, frame: Frame) -> list[CorePlan]:
    cores = []
    for core in massing.cores:
        x0, y0, x1, y1 = frame.area_box(core.box)
        cores.append(CorePlan(id=core.id, type=core.type, x=(x0, x1), y=(y0, y1), door_side=frame.side(core.side)))
    return cores


def with_elevations(floors: list[FloorProgram]) -> list[FloorProgram]:
    """Return the floors with their elevations, upwards and downwards from the ground."""
    elevations = {}
    level = 0.0
    for floor in floors:
        if floor.index >= 1:
            elevations[floor.index] = round(level, 3)
            level += floor.height
    level = 0.0
    for floor in reversed(floors):
        if floor.index < 1:
            level -= floor.height
            elevations[floor.index] = round(level, 3)
    return [msgspec.structs.replace(floor, elevation=elevations[floor.index]) for floor in floors]
