"""RenameRoom and ClearRoom, and how the tools for rooms find a room and its description."""

import unicodedata
from collections.abc import Callable, Collection, Iterable

import msgspec

from mansion_editing.room_parts import parts_of
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import find_rooms
from mansion_knowledge.object_kinds import is_fixed
from mansion_msgs_py.editing.changes import RoomChange, RoomParts
from mansion_msgs_py.editing.rooms import ClearRoomArgs, RenameRoomArgs
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_msgs_py.topology import TopologyNode
from mansion_scene.lighting import room_lights

__all__ = ["RoomRecords", "change_room", "clear_room", "names_on_floor", "rename_room", "room_named", "with_carriers"]

RoomRecords = Callable[[int, str], tuple[RoomProgram | None, TopologyNode | None]]
"""Gets a floor and a room's id, and returns the room as the program and the room graph have it."""


def room_named(state: SceneState, reference: str) -> tuple[int, SceneRoom]:
    """Return floor and room that an id or words name.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for none, ``CONFLICT`` for several, with ids to choose from.
    """
    found = find_rooms(state, reference) if reference.strip() else []
    if len(found) == 1 and found[0][1].kind not in ("stair", "elevator"):
        return found[0]
    known = [room.id for _, room in (found if len(found) > 1 else state.rooms())]
    what = f"names {len(found)} rooms; give an id: " if len(found) > 1 else "names no room; rooms are "
    raise MansionError(
        ErrorCode.CONFLICT if len(found) > 1 else ErrorCode.NOT_FOUND,
        f"{reference[:120]!r} {what}{', '.join(known[:40])}",
        path="$.room_id",
        details={"rooms": known},
    )


def change_room(
    state: SceneState, floor: int, room_id: str, records: RoomRecords, change: Callable[[RoomParts], RoomParts]
) -> bool:
    """Change the description of a room; return whether anything changed."""
    before = parts_of(state.scenes[floor], room_id, *records(floor, room_id))
    assert before is not None
    after = change(before)
    if after != before:
        state.apply(RoomChange(floor=floor, before=before, after=after))
    return after != before


def rename_room(state: SceneState, args: RenameRoomArgs, records: RoomRecords) -> tuple[SceneRoom, str]:
    """Give a room another name; return the room and its old name, which stays one of its other names.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a name that is blank or not printable, ``CONFLICT`` for one that another room of the
        floor has.
    """
    floor, room = room_named(state, args.room_id)
    name = " ".join(args.name.split())
    if not name or any(unicodedata.category(letter).startswith("C") for letter in name):
        raise MansionError(ErrorCode.INVALID_PAYLOAD, "give a name of printable letters", path="$.name")
    holder = names_on_floor(state, floor, without=room.id).get(name.casefold())
    if holder is not None:
        raise MansionError(ErrorCode.CONFLICT, f"{holder} on the same floor is called {name!r}", path="$.name")

    def renamed(parts: RoomParts) -> RoomParts:
        other = _aliases(parts.room.aliases, parts.room.name, name)
        program = parts.program
        if program is not None:
            aliases = _aliases(program.aliases, parts.room.name, name)
            program = msgspec.structs.replace(program, name=name, aliases=aliases)
        return msgspec.structs.replace(
            parts, room=msgspec.structs.replace(parts.room, name=name, aliases=other), program=program
        )

    change_room(state, floor, room.id, records, renamed)
    return state.room(room.id)[1], room.name  # type: ignore[index]


def _aliases(known: Collection[str], old: str, name: str) -> list[str]:
    """Return the other names of a room that has got a name."""
    names = dict.fromkeys([*known, *([old] if old else [])])
    return [other for other in names if other.casefold() != name.casefold()]


def names_on_floor(state: SceneState, floor: int, *, without: str = "") -> dict[str, str]:
    """Return the rooms of a floor by their names, in small letters; `without` is the id of one to leave out."""
    rooms = [room for room in state.scenes[floor].rooms if room.id != without]
    return {room.name.casefold(): room.id for room in rooms if room.name}


def clear_room(state: SceneState, args: ClearRoomArgs, records: RoomRecords) -> tuple[SceneRoom, list[str]]:
    """Take out all that is not fixed to the building, and its light; return the room and the ids."""
    floor, room = room_named(state, args.room_id)
    items = [item for item in state.scenes[floor].objects if item.room == room.id]
    staying = with_carriers(state, [item for item in items if is_fixed(item.category)])
    gone = [item for item in items if item.id not in staying]
    for item in gone:
        state.remove(floor, item)
    left = [item for item in items if item.id in staying]

    def cleared(parts: RoomParts) -> RoomParts:
        return msgspec.structs.replace(parts, lights=room_lights(parts.room, left))

    if gone:
        change_room(state, floor, room.id, records, cleared)
    return room, [item.id for item in gone]


def with_carriers(state: SceneState, items: Iterable[SceneObject]) -> set[str]:
    """Return the ids of objects and of all that carries them."""
    out: set[str] = set()
    for item in items:
        carried: SceneObject | None = item
        while carried is not None and carried.id not in out:
            out.add(carried.id)
            found = state.find(carried.parent or "")
            carried = found[1] if found else None
    return out
