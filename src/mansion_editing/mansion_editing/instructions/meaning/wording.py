"""Things, places and rooms in words, for replies."""

from typing import Final

import msgspec

from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import rooms_of
from mansion_editing.instructions.meaning.numbers import means_several
from mansion_editing.instructions.statements import JOINED, Place, Rooms, Things
from mansion_editing.state import SceneState
from mansion_language import plural
from mansion_msgs_py.scene import SceneObject

__all__ = [
    "at_words",
    "bare_words",
    "counted",
    "place_in",
    "place_words",
    "room_words",
    "there_were",
    "thing_words",
    "title_of",
]

_RELATIONS: Final = {
    "beside": "beside", "left": "to the left of", "right": "to the right of", "front": "in front of",
    "around": "around", "near": "near", "behind": "behind", "between": "between", "on": "on", "in": "in",
    "under": "under", "above": "above", "": "on or in", "nearest": "nearest to", "farthest": "farthest from",
}  # fmt: skip


def thing_words(things: Things) -> str:
    """Return words for things as a reply has them ("the two red mugs on the desk")."""
    if things.refers == "last" and not things.noun:
        return "them" if means_several(things) else "it"
    article = "the " if things.definite else ""
    number = f"{things.amount.number} " if things.amount.number > 1 else ""
    named = msgspec.structs.replace(things, noun=plural(things.noun or "thing")) if means_several(things) else things
    return f"{article}{number}{bare_words(named)}{at_words(things.place)}"


def counted(number: int, noun: str) -> str:
    """Return a number with a noun.

    Examples
    --------
    >>> counted(1, "mug"), counted(0, "mug")
    ('1 mug', 'no mugs')
    """
    return f"{number or 'no'} {noun if number == 1 else plural(noun)}"


def there_were(number: int, noun: str) -> str:
    """Return that there was a number of things.

    Examples
    --------
    >>> there_were(1, "mug"), there_were(0, "mug")
    ('there was 1 mug', 'there were no mugs')
    """
    return f"there {'was' if number == 1 else 'were'} {counted(number, noun)}"


def place_in(state: SceneState, place: Place, context: Context) -> str:
    """Return words for a place, its room called by its name where the words mean one."""
    rooms = place.rooms
    if rooms is None or rooms.every:
        return place_words(place)
    found = rooms_of(state, rooms, context)
    room = state.room(found[0]) if len(found) == 1 else None
    if room is None or not room[1].name:
        return place_words(place)
    floors = rooms.floors
    return place_words(
        msgspec.structs.replace(place, rooms=Rooms(words=room[1].name.removeprefix("the "), floors=floors))
    )


def place_words(place: Place) -> str:
    """Return words for a place ("on the desk in the office on floor 2")."""
    parts = ["not"] if place.outside else []
    if place.anchor is not None:
        parts.append(f"{_RELATIONS[place.relation]} {thing_words(place.anchor)}")
    if place.other is not None:
        parts.append(f"and {thing_words(place.other)}")
    if place.spot and place.relation in ("nearest", "farthest"):
        parts.append(f"{_RELATIONS[place.relation]} the {place.spot}")
    elif place.spot:
        parts.append({"middle": "in the middle", "corner": "in a corner"}.get(place.spot, f"at the {place.spot}"))
    if place.former is not None:
        stood = f"the {bare_words(place.former)}" if place.former.noun else "it"
        parts.append(f"where {stood} was")
    if place.on_floor:
        parts.append("on the floor")
    if place.rooms is not None:
        where = _in_rooms(place.rooms)
        parts.append(f"of{where.removeprefix('in')}" if place.spot and where.startswith("in ") else where)
    if place.facing is not None:
        parts.append(f"facing {thing_words(place.facing)}")
    return " ".join(parts)


def _in_rooms(rooms: Rooms) -> str:
    if not (rooms.words or rooms.size or rooms.next_to or rooms.holding or rooms.over):
        if rooms.floors or rooms.up:
            return room_words(rooms).removeprefix("rooms").removeprefix("room").strip()
        return "there" if rooms.same else "in every room" if rooms.every else "in the room"
    return f"in {'' if rooms.every else 'the '}{room_words(rooms)}"


def room_words(rooms: Rooms) -> str:
    """Return words for rooms ("kitchen on floor 2")."""
    named = " and ".join(rooms.words.split(JOINED))
    words = (plural(named) if rooms.every and named and JOINED not in rooms.words else named) or (
        "rooms" if rooms.every else "room"
    )
    sized = f"{rooms.size} {words}" if rooms.size else words
    floors = f" on floor {' or '.join(map(str, rooms.floors))}" if rooms.floors else ""
    beside = f" next to {rooms.next_to}" if rooms.next_to else ""
    if rooms.up:
        side = "above" if rooms.up > 0 else "below"
        far = "" if rooms.over else f"{counted_floors(abs(rooms.up))} "
        beside += f" {far}{side} {f'the {rooms.base}' if rooms.base else 'here'}"
    holding = f" with {thing_words(rooms.holding)}" if rooms.holding is not None else ""
    return f"{sized}{beside}{holding}{floors}"


def counted_floors(number: int) -> str:
    """Return a number of storeys in words."""
    return "one floor" if number == 1 else f"{number} floors"


def bare_words(things: Things) -> str:
    states = [f"{'' if value else 'not '}{name}" for name, value in things.states.items()]
    words = [things.size, *states, things.colour, things.material, things.owned, things.noun or "thing"]
    return " ".join(word for word in words if word)


def at_words(place: Place | None) -> str:
    return "" if place is None else f" {place_words(place)}"


def title_of(state: SceneState | None, item: SceneObject) -> str:
    room = None if state is None else state.room(item.room)
    name = item.room.split("/", 1)[-1].replace("_", " ") if room is None else room[1].name
    return f"{item.id} in {name or item.room.split('/', 1)[-1].replace('_', ' ')}"
