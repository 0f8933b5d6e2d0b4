"""Read the model's program: ids to room types, circulation left out, what the brief states marked."""

import dataclasses

from mansion_llm import Fault
from mansion_msgs_py.wording import with_article
from mansion_planner.llm.answers import FloorAnswer, RoomAnswer
from mansion_planner.llm.chosen import ChosenFloor, ChosenRoom
from mansion_planner.llm.cleaning import clean_id, clean_text, is_core_name, material_fault, room_kind
from mansion_planner.llm.context import Context
from mansion_planner.program.building import PlannedBuilding

__all__ = ["MOST_ROOMS", "floor_piece", "read_floor"]

MOST_ROOMS = 40


def floor_piece(index: int) -> str:
    """Return the name of a floor's program among the pieces."""
    return f"program/F{index}"


def read_floor(
    answer: FloorAnswer, context: Context, planned: PlannedBuilding
) -> tuple[ChosenFloor | None, list[Fault]]:
    """Return a floor's rooms, and what is wrong with them apart from the rest of the building.

    Corridors and cores among the rooms are passed over: they come out of the reserve.
    """
    piece = floor_piece(answer.index)
    faults: list[str] = []
    known = {fact.name: fact.room_type for fact in planned.decisions.facts.rooms}
    rooms: list[ChosenRoom] = []
    for number, entry in enumerate(answer.rooms):
        room = _room(entry, number == 0, context, known, faults)
        if room is not None:
            rooms.append(room)
    if not rooms or not answer.rooms or clean_id(answer.rooms[0].id) != rooms[0].id:
        faults.append("rooms must begin with the circulation hub")
        return None, [Fault(f"floor {answer.index}: {text}", piece) for text in faults]
    own = next(storey for storey in planned.storeys if storey.index == answer.index)
    if len(rooms) < 2 and own.rooms:
        faults.append("a floor needs rooms besides its hub")
    if len(rooms) > MOST_ROOMS:
        faults.append(f"{len(rooms)} rooms are too many; at most {MOST_ROOMS}")
    ids = [room.id for room in rooms]
    repeated = sorted({name for name in ids if ids.count(name) > 1})
    if repeated:
        faults.append(f"the id {', '.join(repeated)} is used more than once")
    hub = rooms[0]
    if hub.kind.wet or (hub.kind.zone in ("private", "service") and hub.kind.name != "living_room"):
        faults.append(f"{hub.id} cannot be the circulation hub; use a lobby, hall, corridor or main room")
    floor = ChosenFloor(
        index=answer.index,
        hub=dataclasses.replace(hub, id=hub.kind.name),
        rooms=_with_suites(_apart_from(hub.kind.name, rooms[1:])),
        requirement=clean_text(answer.requirement, 240),
    )
    return floor, [Fault(f"floor {answer.index}: {text}", piece) for text in faults]


def _room(
    entry: RoomAnswer, first: bool, context: Context, known: dict[str, str], faults: list[str]
) -> ChosenRoom | None:
    name = clean_id(entry.id)
    if not name:
        faults.append(f"{clean_text(entry.id, 40)!r} is no id; use lower-case letters, digits and _")
        return None
    if is_core_name(name):
        return None
    kind = room_kind(name, context.knowledge, known)
    if kind.zone == "circulation" and not first:
        return None
    if not 0.5 <= entry.area_estimate <= 5000.0:
        faults.append(f"area_estimate of {name} is {entry.area_estimate:g}; it must be a positive area in m2")
        return None
    if entry.area_estimate < 0.8 * kind.least and not first:
        faults.append(f"{name} has {entry.area_estimate:g} m2; {with_article(kind.name)} needs at least {kind.least:g}")
    for text, is_floor in ((entry.floor_material, True), (entry.wall_material, False)):
        fault = material_fault(text, kind, floor=is_floor)
        if fault:
            faults.append(f"{name}: {fault}")
    return ChosenRoom(
        id=name,
        kind=kind,
        area=float(entry.area_estimate),
        floor_material=entry.floor_material,
        wall_material=entry.wall_material,
        notes=clean_text(entry.notes, 120),
    )


def _apart_from(hub: str, rooms: list[ChosenRoom]) -> list[ChosenRoom]:
    """Rename a room that is called as the hub will be."""
    names = {room.id for room in rooms}
    out = []
    for room in rooms:
        name, number = room.id, 2
        while name == hub or (name != room.id and name in names):
            name, number = f"{room.id}_{number}", number + 1
        out.append(dataclasses.replace(room, id=name))
    return out


def _with_suites(rooms: list[ChosenRoom]) -> tuple[ChosenRoom, ...]:
    """Hang wet rooms and closets that are named after a room (``bedroom_1_bathroom``) on it."""
    names = [room.id for room in rooms]
    out = []
    for room in rooms:
        owners = [n for n in names if n != room.id and room.id.startswith(n + "_")]
        suits = room.kind.wet or room.kind.zone == "service"
        suffix = room.id[len(max(owners, key=len)) + 1 :] if owners else ""
        owner = max(owners, key=len) if owners and suits and not suffix.isdigit() else ""
        out.append(dataclasses.replace(room, suite_of=owner))
    return tuple(out)
