"""Which of the rooms and things that fit are meant."""

from collections.abc import Callable, Sequence
from typing import TypeAlias

import msgspec

from mansion_assets.catalogue.vocabulary import stems
from mansion_editing.instructions.meaning.context import Context, ambiguous
from mansion_editing.instructions.meaning.descriptions import all_at, anchors_of, rooms_of, things_of
from mansion_editing.instructions.meaning.doors import doors_at, means_doors
from mansion_editing.instructions.meaning.measured import told_by_size
from mansion_editing.instructions.meaning.numbers import (
    by_holder,
    counts_each,
    in_one_room,
    is_one,
    means_one,
    of_one_kind,
)
from mansion_editing.instructions.meaning.room_words import room_title
from mansion_editing.instructions.meaning.sided import told_by_side
from mansion_editing.instructions.meaning.wording import (
    at_words,
    bare_words,
    counted,
    room_words,
    thing_words,
    title_of,
)
from mansion_editing.instructions.phrases.word_sets import MASSES
from mansion_editing.instructions.statements import Amount, Place, Rooms, Things
from mansion_editing.state import SceneState
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject
from mansion_scene.essentials import essentials_of

__all__ = [
    "Fit",
    "able_ones",
    "at_home",
    "concerned",
    "from_there",
    "is_of_its_room",
    "needed_there",
    "one_room_each",
    "things_meant",
    "too_few",
]

Fit: TypeAlias = Callable[[str], bool]
"""Whether a room, by its id, fits the rest of a statement."""


def one_room_each(state: SceneState, rooms: Rooms, context: Context, fits: Fit | None = None) -> list[str]:
    """Return the rooms that words mean: exactly one where they mean one.

    Parameters
    ----------
    fits : callable, optional
        Tells rooms apart that the words fit equally well.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where there is none, or not the number that the words have.
    Ambiguous
        Where words for one room fit several.
    """
    found = rooms_of(state, rooms, context)
    if not found:
        known = ", ".join(dict.fromkeys(room.name or room.room_type.replace("_", " ") for _, room in state.rooms()))
        elsewhere = rooms_of(state, msgspec.structs.replace(rooms, floors=()), context) if rooms.floors else []
        where = " and ".join(f"{room_title(state, name)} on floor {_floor(state, name)}" for name in elsewhere[:4])
        hint = f"there is {where}" if where else f"the rooms are {known[:600]}"
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no {room_words(rooms)}; {hint}")
    if rooms.number > 1 and len(found) != rooms.number:
        if len(found) > rooms.number:
            raise ambiguous(room_words(rooms), [room_title(state, room) for room in found], found)
        message = f"there are {len(found)} rooms called {rooms.words}, not {rooms.number}: {', '.join(found)}"
        raise MansionError(ErrorCode.NOT_FOUND, message)
    if len(found) > 1 and is_one(rooms):
        fitting = [room for room in found if fits is not None and fits(room)]
        fitting = fitting if len(fitting) == 1 else context.brief.rooms_first(fitting or found)
        if len(fitting) != 1:
            candidates = fitting
            raise ambiguous(f"the {room_words(rooms)}", [room_title(state, r) for r in candidates], candidates)
        return fitting
    return found


def _floor(state: SceneState, room: str) -> int:
    found = state.room(room)
    return 0 if found is None else found[0]


def from_there(state: SceneState, things: Things, place: Place, context: Context) -> Context:
    """Return the context in which ``up one floor`` and ``under the bed`` are told from where things are."""
    rooms = place.rooms
    if rooms is None and place.anchor is not None and place.anchor.definite and not place.anchor.refers:
        own = {item.room for item in things_of(state, things, context)}
        return context.followed((), tuple(own), "") if len(own) == 1 else context
    told = rooms is not None and (rooms.up or rooms.others or (rooms.same and not context.rooms))
    if rooms is None or not told or rooms.base:
        return context
    found = [item.room for item in things_of(state, things, context)]
    return context.followed((), tuple(dict.fromkeys(found)), "")


def at_home(state: SceneState, things: Things, place: Place, context: Context) -> Place:
    """Return the place in the one room that things are in, where words name no room and that has such a place."""
    anchor = place.anchor
    if anchor is not None and place.rooms is None and means_doors(anchor):
        rooms = {item.room for item in things_of(state, things, context)}
        ends = {name for door in doors_at(state, place, context) for name in door.rooms}
        here = msgspec.structs.replace(place, rooms=Rooms(words=min(rooms, default="")))
        return here if len(rooms) == 1 and rooms <= ends else place
    if anchor is None or place.rooms is not None or anchor.refers or anchor.owned or anchor.place is not None:
        return place
    if not (means_one(anchor) and anchor.definite) and not anchor.amount.of:
        return place
    own = {item.room for item in things_of(state, things, context)}
    if len(own) != 1:
        return place
    here = msgspec.structs.replace(place, rooms=Rooms(words=own.pop()))
    return here if anchors_of(state, here, context) else place


def concerned(state: SceneState, things: Things, context: Context) -> list[SceneObject]:
    """Return the things that words fit and that a statement may change: of several, not what shall be left.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for an exception that is not there.
    """
    found = things_of(state, things, context)
    loosely = things.definite and things.plural and things.amount.kind in ("some", "all") and things.place is None
    if loosely and not things.refers and not things.owned and context.rooms:
        found = [item for item in found if item.room in context.rooms] or found
    for spared in things.beside:
        if not things_of(state, spared, context):
            raise MansionError(
                ErrorCode.NOT_FOUND, f"there is no {bare_words(spared)}{at_words(spared.place)} to leave out"
            )
    return found if means_one(things) else [item for item in found if item.id not in context.kept]


def able_ones(state: SceneState, things: Things, context: Context, able: Callable[[SceneObject], bool]) -> Things:
    """Return words for what carries the things last mentioned, where ``it`` shall open or switch and only that can."""
    within = things.place is None or things.place == Place(rooms=things.place.rooms)  # a heading tells the room
    if things.refers != "last" or things.noun or not within:
        return things
    last = things_of(state, things, context)
    carriers = list(dict.fromkeys(item.parent for item in last if item.parent is not None)) or [*context.holders]
    found = None if any(able(item) for item in last) or len(carriers) != 1 else state.find(carriers[0])
    return Things(noun=found[1].id, definite=True) if found is not None and able(found[1]) else things


def things_meant(
    state: SceneState,
    things: Things,
    context: Context,
    prefer: Callable[[SceneObject], bool] | None = None,
    *,
    surplus: bool = False,
) -> list[SceneObject]:
    """Return the objects that words mean, their number looked at.

    Of several that may be chosen freely ("two chairs") those that carry nothing come first, then the last.

    Parameters
    ----------
    prefer : callable, optional
        Tells which is meant where words for one thing fit several.
    surplus : bool
        ``exactly`` and ``at_most`` mean those beyond the number, not the number.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where there is none, ``INFEASIBLE`` where there are fewer than the words have.
    Ambiguous
        Where words for one thing, or for a certain number, fit more.
    """
    found = concerned(state, things, context)
    if not found:
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no {bare_words(things)}{at_words(things.place)}")
    if counts_each(things):
        if any(item.parent is None for item in found):
            raise MansionError(ErrorCode.INFEASIBLE, f"say which {bare_words(things)} at each of them is meant")
        groups = by_holder(found)
    else:
        groups = [found if things.place is None else _at_one_place(state, things.place, found, context)]
    return [item for group in groups for item in _counted_out(state, things, group, context, prefer, surplus=surplus)]


def _counted_out(
    state: SceneState,
    things: Things,
    found: list[SceneObject],
    context: Context,
    prefer: Callable[[SceneObject], bool] | None,
    *,
    surplus: bool,
) -> list[SceneObject]:
    """Return as many of the objects that words fit as they say."""
    amount = things.amount
    told = _number_told(things)
    found = of_one_kind(found, told) or (in_one_room(found, told) if things.place is None else None) or found
    count = len(found)
    _refuse_other_whole(things, found)
    if amount.kind == "all":
        if amount.number > 1 and amount.number != count:
            raise too_few(things, found)
        return found
    if amount.kind == "all_but" or (surplus and amount.kind in ("exactly", "at_most")):
        if amount.kind == "all_but" and count < amount.number:
            raise too_few(things, found)
        return _any_of(state, found, max(0, count - amount.number))
    if amount.kind == "none":
        return []
    if amount.kind == "half":
        return _any_of(state, found, _half(things, found))
    if things.plural and amount.number <= 1:
        return found
    if things.refers == "last" and not (things.noun or amount.number) and context.noun in MASSES:
        return found  # "there is beer in the fridge, get rid of it"
    if means_one(things) or (things.refers == "last" and not things.plural and things.noun):
        return _the_one(state, things, found, context, prefer)
    if things.refers == "last" and (not amount.number or amount.number >= count):
        return found
    number = max(1, amount.number)
    if number > count:
        raise too_few(things, found)
    found = _counted_here(state, things, found, number, context)
    if things.definite and not things.refers and number < count and not amount.of:
        asked = context.brief.things_first(found, things.noun)
        if len(asked) == number:
            return asked
        raise ambiguous(thing_words(things), [title_of(state, item) for item in found], [i.id for i in found])
    return _any_of(state, found, number)


def _refuse_other_whole(things: Things, found: list[SceneObject]) -> None:
    """Refuse ``two of the four`` where there are not four.

    Raises
    ------
    MansionError
    """
    amount, count = things.amount, len(found)
    if amount.of and amount.of != count:
        kind = counted(count, bare_words(things))
        message = (
            f"there {'is' if count == 1 else 'are'} {kind}{at_words(things.place)}, not {amount.of}: {_ids(found)}"
        )
        raise MansionError(ErrorCode.INFEASIBLE, message)


def _number_told(things: Things) -> int:
    """Return how many there are by the words themselves: ``the four tables``, ``two of the four``; 0 where untold."""
    amount = things.amount
    return amount.of or (amount.number if things.definite and amount.kind in ("some", "all") else 0)


def _counted_here(
    state: SceneState, things: Things, found: list[SceneObject], number: int, context: Context
) -> list[SceneObject]:
    """Return those in the room that was mentioned last, of which so many are taken where words tell no place.

    Raises
    ------
    Ambiguous
        Where no room was mentioned, or that one has too few, and several have such things.
    """
    rooms = list(dict.fromkeys(item.room for item in found))
    if things.place is not None or things.refers or things.owned or things.definite or len(rooms) < 2:
        return found
    here = [item for item in found if item.room in context.rooms]
    if len(here) >= number:
        return here
    raise ambiguous(thing_words(things), [f"those in {room_title(state, room)}" for room in rooms], rooms)


def _half(things: Things, found: list[SceneObject]) -> int:
    if len(found) < 2:
        raise too_few(msgspec.structs.replace(things, amount=Amount(number=2)), found)
    return len(found) // 2


def _the_one(
    state: SceneState,
    things: Things,
    found: list[SceneObject],
    context: Context,
    prefer: Callable[[SceneObject], bool] | None,
) -> list[SceneObject]:
    last = [item for item in found if item.id in context.things]
    found = last if len(last) == 1 else found
    preferred = [item for item in found if prefer is not None and prefer(item)]
    if len(found) > 1 and len({item.room for item in found}) == 1 and _names_lights(things):
        return [item for item in found if item.mount == "ceiling"] or found
    near = context.nearest([item.room for item in found])
    here = [item for item in found if item.room in near]
    own = [item for item in here if is_of_its_room(state, item, things.noun)]
    asked = context.brief.things_first(here, things.noun)
    sized = told_by_size(told_by_side(here, things.hints), things.hints)
    needed = needed_there(state, here)
    found = next((few for few in (preferred, here, sized, own, asked, needed) if len(few) == 1), found)
    if len(found) > 1 and context.brief.wants_one(asked, things.noun):
        return asked[:1]
    if len(found) > 1:
        raise ambiguous(thing_words(things), [title_of(None, item) for item in found], [item.id for item in found])
    return found


def needed_there(state: SceneState, items: Sequence[SceneObject]) -> list[SceneObject]:
    """Return those of the things of one room that it cannot be used without: the dining table, no console table."""
    rooms = {item.room for item in items}
    room = state.room(items[0].room) if len(rooms) == 1 else None
    if room is None:
        return []
    kinds = {kind for need in essentials_of(room[1]) for thing in need.things for kind in thing.categories}
    return [item for item in items if item.category in kinds]


def is_of_its_room(state: SceneState, item: SceneObject, noun: str) -> bool:
    """Whether a room is named as the thing in it is: the dining table of the dining room."""
    room = state.room(item.room)
    first = stems(noun)[:1]
    return room is not None and len(stems(noun)) > 1 and first == stems(room[1].name or room[1].room_type)[:1]


def _names_lights(things: Things) -> bool:
    return stems(things.noun)[-1:] == ("light",) or stems(things.noun) in (("ceiling", "lamp"), ("lighting",))


def too_few(things: Things, found: list[SceneObject]) -> MansionError:
    only = "only " if things.amount.number >= len(found) else ""
    verb = "is" if len(found) == 1 else "are"
    message = (
        f"there {verb} {only}{counted(len(found), bare_words(things))}{at_words(things.place)},"
        f" not {things.amount.number}: "
    )
    return MansionError(ErrorCode.INFEASIBLE, message + _ids(found))


def _ids(found: Sequence[SceneObject]) -> str:
    return ", ".join(item.id for item in found[:8]) + (", ..." if len(found) > 8 else "")


def _any_of(state: SceneState, found: list[SceneObject], number: int) -> list[SceneObject]:
    """Return so many of the objects: those that carry nothing first, then the last in the order of ids."""
    bearing = {item.parent for _, item in state.objects() if item.parent is not None}
    order = sorted(enumerate(found), key=lambda pair: (pair[1].id in bearing, -pair[0]))
    kept = {item.id for _, item in order[:number]}
    return [item for item in found if item.id in kept]


def _at_one_place(state: SceneState, place: Place, found: list[SceneObject], context: Context) -> list[SceneObject]:
    """Refuse things that lie at several places where the words mean one.

    Raises
    ------
    Ambiguous
    """
    if place.outside:
        return found
    rooms = sorted({item.room for item in found})
    if place.rooms is not None and is_one(place.rooms) and len(rooms) > 1:
        rooms = context.brief.rooms_first(rooms)
        if len(rooms) > 1:
            raise ambiguous(f"the {room_words(place.rooms)}", [room_title(state, room) for room in rooms], rooms)
        found = [item for item in found if item.room == rooms[0]]
    if place.anchor is None or not means_one(place.anchor):
        return found
    anchors = anchors_of(state, place, context)
    if len(anchors) < 2 or any(anchor.id in context.things for anchor in anchors):
        return found
    near = {
        anchor.id: all_at(state, found, msgspec.structs.replace(place, anchor=Things(noun=anchor.id)), context)
        for anchor in anchors
    }
    having = [anchor for anchor in anchors if near[anchor.id]]
    here = [anchor for anchor in having if anchor.room in context.rooms]
    if len(here) == 1:
        return near[here[0].id]
    if len(having) > 1:
        words = thing_words(place.anchor)
        raise ambiguous(words, [title_of(state, item) for item in having], [item.id for item in having])
    return found
