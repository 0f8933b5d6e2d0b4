"""The doors of a building that words mean: of a room, between two rooms, to the outside."""

from collections.abc import Iterable, Sequence

import msgspec

from mansion_editing.instructions.meaning.context import Context, ambiguous
from mansion_editing.instructions.meaning.descriptions import rooms_of
from mansion_editing.instructions.meaning.numbers import means_several
from mansion_editing.instructions.meaning.room_words import room_title
from mansion_editing.instructions.phrases.word_sets import DOOR_KINDS, OUTER_DOORS
from mansion_editing.instructions.statements import Place, Rooms, Things
from mansion_editing.state import SceneState
from mansion_geometry.doorways import LEAFLESS
from mansion_knowledge import is_class
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import Door

__all__ = ["door_title", "doors_at", "doors_fitting", "doors_meant", "means_doors", "sides_of"]


def means_doors(things: Things) -> bool:
    """Whether words mean doors of the building, not those of furniture."""
    kind, _, noun = things.noun.rpartition(" ")
    return noun == "door" and (not kind or kind in OUTER_DOORS or kind in DOOR_KINDS)


def doors_fitting(state: SceneState, things: Things, context: Context) -> list[Door]:
    """Return the doors that words fit, in the order of the storeys; only those with a leaf, lifts left out."""
    pool = [door for floor in state.floors for door in state.scenes[floor].doors if _has_leaf(door)]
    for name, value in things.states.items():
        pool = [door for door in pool if name == "open" and door.is_open == value]
    kind = things.noun.rpartition(" ")[0]
    words = things.owned.removesuffix("'s").removesuffix("’s")
    if things.place is not None:
        pool = _at_place(state, pool, things.place, context)
    if kind in OUTER_DOORS:
        pool = [door for door in pool if None in door.rooms and door.kind != "balcony"]
    elif kind in DOOR_KINDS:
        pool = [door for door in pool if door.kind == DOOR_KINDS[kind]]
    if words:
        pool = _of_rooms(pool, rooms_of(state, Rooms(words=words, every=means_several(things)), context))
    elif things.place is None and context.rooms and not kind:
        pool = _of_rooms(pool, context.rooms)
    spared = {door.id for but in things.beside for door in doors_fitting(state, but, context)}
    return [door for door in pool if door.id not in spared]


def doors_meant(state: SceneState, things: Things, context: Context) -> list[Door]:
    """Return the doors that words mean, their number looked at.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where there is none, ``INFEASIBLE`` where there is another number of them.
    Ambiguous
        Where words for one door fit several.
    """
    found = doors_fitting(state, things, context)
    if not found:
        raise MansionError(ErrorCode.NOT_FOUND, "there is no such door that opens and closes")
    number = things.amount.number if things.amount.kind in ("some", "all") else -1
    if number < 0 or things.refers or things.ordinal:
        raise MansionError(ErrorCode.INFEASIBLE, "say which doors are meant by the rooms that they lead to")
    if number > 1 and number != len(found):
        raise MansionError(ErrorCode.INFEASIBLE, f"there are {len(found)} such doors, not {number}: {_ids(found)}")
    if means_several(things) or len(found) == 1:
        return found
    here = _of_rooms(found, context.rooms)
    if len(here) == 1:
        return here  # the door to the hall of the room that was mentioned last
    entries = [door for door in found if _leads_to_circulation(state, door)]
    if len(entries) == 1 and (things.owned or things.place is not None):
        return entries  # a bedroom's door, not the one of its bathroom
    raise ambiguous("the door", [door_title(state, door) for door in found], [door.id for door in found])


def doors_at(state: SceneState, place: Place, context: Context) -> list[Door]:
    """Return the doors that something at a place is at; any of several to the outside of one room serves.

    Raises
    ------
    MansionError, Ambiguous
        As `doors_meant`.
    """
    anchor = place.anchor or Things()
    if place.rooms is not None and anchor.place is None:
        anchor = msgspec.structs.replace(anchor, place=Place(rooms=place.rooms))
    fitting = doors_fitting(state, anchor, context)
    if len({door.rooms for door in fitting}) == 1:
        return fitting
    return doors_meant(state, anchor, context)


def sides_of(state: SceneState, place: Place, context: Context) -> list[tuple[str, Door]]:
    """Return the rooms in which something is at the door that a place is about, each with the door.

    Raises
    ------
    MansionError
        As `doors_meant`, and ``NOT_FOUND`` where the door is not one of the rooms that the place names.
    Ambiguous
        Where the door may be told from either side.
    """
    within = None if place.rooms is None else set(rooms_of(state, place.rooms, context))
    out: list[tuple[str, Door]] = []
    for door in doors_at(state, place, context):
        sides = [name for name in door.rooms if name is not None and state.room(name) is not None]
        sides = [name for name in sides if within is None or name in within]
        sides = [name for name in sides if name in context.rooms] or sides
        if not sides:
            raise MansionError(ErrorCode.NOT_FOUND, f"{door_title(state, door)} is no door of such a room")
        if len(sides) > 1:
            raise ambiguous("at the door", [room_title(state, name) for name in sides], sides)
        out.append((sides[0], door))
    return out


def door_title(state: SceneState, door: Door) -> str:
    """Return what a reply calls a door: the rooms that it joins, with its id."""
    one, other = ("outside" if name is None else room_title(state, name) for name in door.rooms)
    return f"{door.id} between {one} and {other}"


def _has_leaf(door: Door) -> bool:
    return door.kind not in LEAFLESS and door.kind != "sliding"


def _at_place(state: SceneState, pool: Sequence[Door], place: Place, context: Context) -> list[Door]:
    if place.relation == "between" and place.anchor is not None and place.other is not None:
        ends = [set(_rooms_called(state, end, context)) for end in (place.anchor, place.other)]
        return [door for door in pool if _joins(door, *ends)]
    if place.rooms is None or place.anchor is not None:
        return []
    found = set(rooms_of(state, place.rooms, context))
    if place.rooms.next_to:
        return [
            door
            for door in pool
            if _joins(door, found, set(rooms_of(state, Rooms(words=place.rooms.next_to), context)))
        ]
    return _of_rooms(pool, found)


def _rooms_called(state: SceneState, end: Things, context: Context) -> list[str]:
    floors = end.place.rooms.floors if end.place is not None and end.place.rooms is not None else ()
    return rooms_of(state, Rooms(words=end.noun, floors=floors, every=True), context)


def _joins(door: Door, ones: set[str], others: set[str]) -> bool:
    first, second = door.rooms
    return (first in ones and second in others) or (first in others and second in ones)


def _of_rooms(pool: Iterable[Door], rooms: Iterable[str]) -> list[Door]:
    wanted = set(rooms)
    return [door for door in pool if wanted.intersection(name for name in door.rooms if name is not None)]


def _leads_to_circulation(state: SceneState, door: Door) -> bool:
    ends = [state.room(name) for name in door.rooms if name is not None]
    return any(found is not None and is_class(found[1].room_type, "circulation") for found in ends)


def _ids(doors: Sequence[Door]) -> str:
    return ", ".join(door.id for door in doors[:8])
