"""Rename, Finish, Furnish, Reshape and the exchange of rooms: what changes a room rather than a thing in it."""

from typing import Any, Final

from mansion_editing.instructions.doing.work import Done, Work
from mansion_editing.instructions.meaning.choices import one_room_each
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.room_words import room_title
from mansion_editing.instructions.statements import Finish, Furnish, Rename, Reshape, Rooms
from mansion_editing.runs.policies import Unmet, ask
from mansion_editing.state import SceneState
from mansion_msgs_py.scene import SceneRoom

__all__ = ["finish", "furnish_rooms", "rename", "reshape", "swap_rooms"]


_LEAST_CHANGE: Final = 1.0
"""Square metres by which a room becomes a little larger or smaller, at least."""


def _one(state: SceneState, rooms: Rooms, context: Context) -> SceneRoom:
    found = one_room_each(state, rooms, context)
    room = state.room(found[0])
    if len(found) != 1 or room is None:
        raise Unmet(f"say which of {', '.join(found)} is meant")
    return room[1]


def rename(statement: Rename, state: SceneState, context: Context) -> Work:
    """Give a room a name."""
    room = _one(state, statement.room, context)
    before = room_title(state, room.id)
    if room.name == statement.name:
        return Done(f"{before} has this name already", context.followed((), (room.id,), ""))
    yield from ask("It takes the name.", "RenameRoom", {"room_id": room.id, "name": statement.name})
    return Done(f"{before} is now called {statement.name}", context.followed((), (room.id,), ""))


def finish(statement: Finish, state: SceneState, context: Context) -> Work:
    """Give walls, floors or ceilings of rooms a colour or a material."""
    rooms = one_room_each(state, statement.rooms, context)
    look = " ".join(word for word in (statement.colour, statement.material) if word)
    for room in rooms:
        arguments: dict[str, Any] = {"room_id": room, "part": statement.part}
        arguments |= {"material": statement.material, "color": statement.colour}
        yield from ask(f"The {statement.part} of {room} should be {look}.", "SetFinish", arguments)
    return Done(f"the {statement.part} of {', '.join(rooms)} now {look}", context.followed((), rooms, ""))


def furnish_rooms(statement: Furnish, state: SceneState, context: Context) -> Work:
    """Furnish rooms anew."""
    rooms = one_room_each(state, statement.rooms, context)
    for room in rooms:
        kept = sorted(item.id for _, item in state.objects() if item.room == room and item.id in context.kept)
        kind = statement.kind.replace(" ", "_").lower()
        arguments = {"room_id": room, "room_type": kind, "keep": kept}
        yield from ask(f"{room} is furnished anew.", "FurnishRoom", arguments)
    as_what = f" as {statement.kind}" if statement.kind else ""
    return Done(f"{', '.join(rooms)} furnished anew{as_what}", context.followed((), rooms, ""))


def swap_rooms(one: Rooms, other: Rooms, state: SceneState, context: Context) -> Work:
    """Let two rooms exchange what they are."""
    first, second = _one(state, one, context), _one(state, other, context)
    if first.id == second.id:
        raise Unmet(f"{first.id} cannot change places with itself")
    arguments = {"what": "swap", "room_id": first.id, "other_id": second.id}
    report = yield from ask("They change places.", "ReshapeFloor", arguments)
    return Done(str(report.message), context.followed((), (first.id, second.id), ""))


def reshape(statement: Reshape, state: SceneState, context: Context) -> Work:
    """Change the structure of a storey."""
    arguments: dict[str, Any] = {"what": statement.what}
    if statement.rooms is not None:
        arguments["room_id"] = _one(state, statement.rooms, context).id
    if statement.other is not None:
        arguments["other_id"] = _one(state, statement.other, context).id
    if statement.share and statement.rooms is not None:
        now = float(_one(state, statement.rooms, context).area)
        change = max(_LEAST_CHANGE, abs(statement.share) * now)
        arguments["area"] = round(change if statement.share > 0 else -change, 1)
    if statement.area:
        arguments |= {"area": statement.area, "absolute": statement.absolute}
    report = yield from ask("The storey changes.", "ReshapeFloor", arguments)
    rooms = tuple(arguments[name] for name in ("room_id", "other_id") if name in arguments)
    return Done(str(report.message), context.followed((), rooms, ""))
