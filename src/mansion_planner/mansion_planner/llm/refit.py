"""Lay chosen rooms, the model's or the rules', out in a given massing: the offline sketch of another program."""

from dataclasses import dataclass, replace

import msgspec

from mansion_knowledge import RoomType
from mansion_msgs_py.program import AreaSummary, CorePlan, FloorProgram, RoomProgram
from mansion_planner.llm.palette import Palette
from mansion_planner.program.arrangement import apart_pairs, unwanted_pairs, wanted_pairs
from mansion_planner.program.building import PlannedBuilding, clutter_of
from mansion_planner.program.footprint import sketch_free
from mansion_planner.program.model import CoreBox, PlannedRoom, Sketch, Storey, aliases_of, box_area
from mansion_planner.program.outline import bearing_walls
from mansion_planner.program.storey_forms import capacity, form_of, sketched
from mansion_planner.program.storey_rooms import fit_areas
from mansion_planner.program.wish_ledger import furniture_of, requested_objects

__all__ = ["ChosenFloor", "ChosenRoom", "chosen_of_storey", "refit", "with_cores"]


@dataclass(frozen=True)
class ChosenRoom:
    """A room of a floor's program.

    Attributes
    ----------
    fixed : bool
        The brief states its area.
    stated : bool
        The brief asks for the room.
    suite_of : str
        Id of the room that it is reached through; empty for one at the hub or a corridor.
    base : str
        The name that it shares with others, which differ by a number in their ids.
    label : str
        What the brief calls it; empty where it does not.
    """

    id: str
    kind: RoomType
    area: float
    fixed: bool = False
    stated: bool = False
    suite_of: str = ""
    base: str = ""
    label: str = ""
    floor_material: str = ""
    wall_material: str = ""
    notes: str = ""


@dataclass(frozen=True)
class ChosenFloor:
    """A floor's hub and rooms; `copy` names the floor that it repeats."""

    index: int
    hub: ChosenRoom
    rooms: tuple[ChosenRoom, ...]
    requirement: str = ""
    copy: int | None = None


def chosen_of_storey(storey: Storey, hub_area: float) -> ChosenFloor:
    """Return what the offline planner chose for a storey."""
    rooms = []
    for top in storey.rooms:
        for room in top.each():
            owner = next((r.id for r in top.each() if any(c is room for c in r.suite)), "")
            rooms.append(
                ChosenRoom(
                    room.id, room.kind, room.area, room.fixed, room.stated, owner, room.base, room.label,
                    notes=room.notes,
                )
            )  # fmt: skip
    hub = ChosenRoom(storey.hub.name, storey.hub, hub_area)
    return ChosenFloor(storey.index, hub, tuple(rooms), copy=storey.copy)


def with_cores(planned: PlannedBuilding, cores: list[CorePlan], method: str, why: str) -> PlannedBuilding:
    """Return the plan with other cores; its sketches then have areas and a graph, but no places."""
    connectivity = msgspec.structs.replace(
        planned.program.vertical_connectivity, cores=list(cores), method=method, justification=why
    )
    boxes = tuple(CoreBox(c.id, c.type, (c.x[0], c.y[0], c.x[1], c.y[1])) for c in cores)
    return replace(
        planned,
        program=msgspec.structs.replace(planned.program, vertical_connectivity=connectivity),
        massing=replace(planned.massing, cores=boxes),
    )


def refit(
    planned: PlannedBuilding, floors: list[ChosenFloor], palette: Palette, *, placed: bool = True
) -> PlannedBuilding:
    """Return the plan of other rooms within the same outlines and cores.

    Parameters
    ----------
    planned : PlannedBuilding
    floors : list of ChosenFloor
        One for each storey, ascending.
    placed : bool
        Whether the sketch may give rooms places; not where the cores have moved.
    """
    own: dict[int, Storey] = {}
    sketches: dict[int, Sketch] = {}
    bare = [_storey(storey, floor) for storey, floor in zip(planned.storeys, floors)]
    for storey in bare:
        if storey.copy is None:
            own[storey.index] = _fitted(planned, storey, placed=placed)
            sketches[storey.index] = _sketch(planned, own[storey.index], placed=placed)
    storeys = [own[s.index] if s.copy is None else _repeating(s, own[s.copy]) for s in bare]
    decisions = replace(planned.decisions, furniture=furniture_of(planned.decisions, storeys))
    sketches = {s.index: sketches[s.index if s.copy is None else s.copy] for s in storeys}
    out = replace(planned, decisions=decisions, storeys=storeys, sketches=sketches)
    walls = bearing_walls([sketches[s.index] for s in storeys], planned.frame)
    chosen = {floor.index: floor for floor in floors}
    filled = []
    for program, storey in zip(planned.program.floors, storeys):
        source = chosen[storey.copy if storey.copy is not None else storey.index]
        made = _filled(program, storey, out, source, palette)
        filled.append(msgspec.structs.replace(made, structural_walls=list(walls)))
    return replace(out, program=msgspec.structs.replace(planned.program, floors=filled))


def _storey(storey: Storey, floor: ChosenFloor) -> Storey:
    """Return the storey with the chosen rooms, suites behind their room."""
    names = {room.id for room in floor.rooms}
    tops = tuple(_with_suite(room, floor) for room in floor.rooms if room.suite_of not in names)
    return replace(storey, hub=floor.hub.kind, rooms=tops, copy=floor.copy)


def _with_suite(room: ChosenRoom, floor: ChosenFloor) -> PlannedRoom:
    suite = tuple(_with_suite(child, floor) for child in floor.rooms if child.suite_of == room.id)
    return msgspec.structs.replace(_planned(room), suite=suite)


def _repeating(storey: Storey, source: Storey) -> Storey:
    return replace(storey, rooms=source.rooms, hub=source.hub)


def _planned(room: ChosenRoom) -> PlannedRoom:
    least = room.area if room.fixed else min(room.kind.least, room.area)
    most = room.area if room.fixed else max(room.kind.most, room.area)
    return PlannedRoom(
        id=room.id, kind=room.kind, area=room.area, least=least, most=most, fixed=room.fixed,
        stated=room.fixed or room.stated, notes=room.notes, base=room.base or room.id, label=room.label,
    )  # fmt: skip


def _fitted(planned: PlannedBuilding, storey: Storey, *, placed: bool) -> Storey:
    """Return the storey with the areas of its rooms scaled to what there is for them."""
    massing = planned.massing
    if planned.decisions.free_form or not placed:
        room = 0.84 * _free_area(planned, storey)
    else:
        room = capacity(massing, storey)
        if form_of(massing, storey).hall:
            asked = sum(r.gross for r in storey.rooms)
            share = max(storey.hub.usual, 0.38 * room)
            room = min(room - share, max(asked, 0.45 * room))
    return replace(storey, rooms=fit_areas(storey.rooms, room))


def _free_area(planned: PlannedBuilding, storey: Storey) -> float:
    return planned.envelopes[storey.index].area - sum(box_area(core.box) for core in planned.massing.cores)


def _sketch(planned: PlannedBuilding, storey: Storey, *, placed: bool) -> Sketch:
    massing, decisions = planned.massing, planned.decisions
    hub = storey.hub.name
    if decisions.free_form or not placed:
        return sketch_free(storey, hub, _free_area(planned, storey))
    return sketched(massing, storey, hub, wanted_pairs(decisions), unwanted_pairs(decisions))


def _filled(
    floor: FloorProgram, storey: Storey, planned: PlannedBuilding, chosen: ChosenFloor, palette: Palette
) -> FloorProgram:
    """Return the floor with its rooms, their areas in the sketch, and what that leaves in reserve."""
    sketch, gross = planned.sketches[storey.index], floor.gross_floor_area
    left = gross - sum(placement.area for placement in sketch.rooms)
    reserve = min(max(0.12 * gross, min(0.25 * gross, left - 0.5 * storey.hub.least)), left - 1.0)
    given = {room.id: room for room in chosen.rooms}
    beside = _wished(planned, storey, sketch)
    hub = _room(chosen.hub, storey.hub.name, max(left - reserve, 1.0), palette, "circulation hub")
    lying = clutter_of(storey.hub.name, planned.decisions)
    rooms = [msgspec.structs.replace(hub, open_relation="open", clutter=lying)]
    for placement in sketch.rooms:
        room = given[placement.room.id]
        entry = _room(room, room.id, placement.area, palette, room.notes)
        rooms.append(
            msgspec.structs.replace(
                entry,
                adjacent_to=beside.get(room.id, []),
                name=room.label,
                aliases=aliases_of(placement.room),
                objects=requested_objects(planned.decisions, placement.room.id, storey),
                clutter=clutter_of(room.kind.name, planned.decisions),
            )
        )
    total = sum(room.area_estimate for room in rooms)
    summary = AreaSummary(
        sum_rooms=round(total, 2),
        reserve_ratio=round(1.0 - total / gross, 4),
        fits_within_gfa=total <= gross,
        notes="the reserve holds cores, corridors and the rest of the hub",
    )
    requirement = chosen.requirement or floor.requirement
    return msgspec.structs.replace(floor, rooms=rooms, area_summary=summary, copy=storey.copy, requirement=requirement)


def _room(room: ChosenRoom, name: str, area: float, palette: Palette, notes: str) -> RoomProgram:
    floor, wall = palette.materials(room.kind.name, room.floor_material, room.wall_material)
    return RoomProgram(
        id=name, area_estimate=round(area, 2), room_type=room.kind.name, floor_material=floor,
        wall_material=wall, open_relation="open" if room.kind.open else "door", notes=notes,
    )  # fmt: skip


def _wished(planned: PlannedBuilding, storey: Storey, sketch: Sketch) -> dict[str, list[str]]:
    """Return the neighbours that the brief wishes and the floor can give, by room id."""
    beside: dict[str, list[str]] = {}
    apart = apart_pairs(planned.decisions, storey, sketch)
    for fact in planned.decisions.facts.adjacent:
        firsts = [p.room.id for p in sketch.rooms if p.room.kind.name == fact.first]
        seconds = [p.room.id for p in sketch.rooms if p.room.kind.name == fact.second]
        pair = next(((a, b) for a in firsts for b in seconds if a != b), None)
        if pair is not None and fact not in apart:
            beside.setdefault(pair[0], []).append(pair[1])
    return beside
