"""Where things go: the places that words mean, one for each."""

import math
from collections.abc import Set
from dataclasses import dataclass, replace

from mansion_editing.instructions.meaning.choices import Fit, is_of_its_room, needed_there, one_room_each, too_few
from mansion_editing.instructions.meaning.context import Context, ambiguous
from mansion_editing.instructions.meaning.descriptions import anchors_of, things_of
from mansion_editing.instructions.meaning.doors import means_doors, sides_of
from mansion_editing.instructions.meaning.measured import told_by_size
from mansion_editing.instructions.meaning.numbers import is_one, means_one
from mansion_editing.instructions.meaning.room_words import room_title
from mansion_editing.instructions.meaning.sided import told_by_side
from mansion_editing.instructions.meaning.wording import bare_words, room_words, thing_words, title_of
from mansion_editing.instructions.statements import Place, Things
from mansion_editing.state import SceneState
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject

__all__ = ["Target", "names_any", "places_of"]


@dataclass(frozen=True)
class Target:
    """Where something may go.

    Attributes
    ----------
    room : str
        Id of the room.
    anchor, other : SceneObject, optional
        What it goes on, in, beside, ...; `other` is the second one of ``between``.
    facing : SceneObject, optional
        What it shall face.
    door : str
        Id of the door that it shall be at; empty for none.
    """

    room: str
    anchor: SceneObject | None = None
    other: SceneObject | None = None
    facing: SceneObject | None = None
    door: str = ""


def places_of(
    state: SceneState,
    place: Place,
    context: Context,
    *,
    each: bool = False,
    fits: Fit | None = None,
    besides: Set[str] = frozenset(),
) -> list[Target]:
    """Return the places that words mean, each of which serves where the words mean one; empty where there is none.

    Parameters
    ----------
    each : bool
        The words mean all of them ("on every desk").
    fits : callable, optional
        Tells rooms apart that the words fit equally well.
    besides : set of str
        Ids of what is no landmark where others are: what moves is not "the one that is already there".

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for rooms that are not there.
    Ambiguous
        Where words for one place fit several, and which of them is taken matters.
    """
    if place.anchor is not None and means_doors(place.anchor):
        return [
            _facing(state, place, Target(room, door=door.id), context) for room, door in sides_of(state, place, context)
        ]
    if place.anchor is None:
        rooms = [] if place.rooms is None else one_room_each(state, place.rooms, context, fits)
        return [_facing(state, place, Target(room), context) for room in rooms]
    anchor, found = place.anchor, anchors_of(state, place, context)
    found = [item for item in found if item.id not in besides] or found
    if not found:
        if place.rooms is not None:
            one_room_each(state, place.rooms, context, fits)
        return []
    found = _at_one_room(state, place, found, context)
    if means_one(anchor) and not each and len(found) > 1:
        found = _alike(state, place, anchor, found, context)
    elif names_any(place) and place.rooms is None and not each:
        found = [item for item in found if item.room in context.rooms] or found
    elif anchor.definite and anchor.amount.kind == "some" and 1 < anchor.amount.number != len(found):
        if anchor.amount.number > len(found):
            raise too_few(anchor, found)
        raise ambiguous(thing_words(anchor), [title_of(state, item) for item in found], [i.id for i in found])
    if place.relation == "between":
        return _between(state, place, found, context)
    return [_facing(state, place, Target(item.room, item), context) for item in found]


def names_any(place: Place) -> bool:
    """Whether words mean any one of the things that a place is at: "a shelf", "one of the shelves"."""
    anchor = place.anchor
    if anchor is None or anchor.definite or anchor.refers or anchor.owned or anchor.place is not None:
        return False
    return anchor.amount.kind == "some" and anchor.amount.number == 1 and not anchor.plural


def _at_one_room(state: SceneState, place: Place, found: list[SceneObject], context: Context) -> list[SceneObject]:
    rooms = sorted({item.room for item in found})
    if place.rooms is not None and is_one(place.rooms) and len(rooms) > 1:
        rooms = context.brief.rooms_first(rooms)
        if len(rooms) == 1:
            return [item for item in found if item.room == rooms[0]]
        raise ambiguous(f"the {room_words(place.rooms)}", [room_title(state, room) for room in rooms], rooms)
    return found


def _alike(
    state: SceneState, place: Place, anchor: Things, found: list[SceneObject], context: Context
) -> list[SceneObject]:
    """Return what "the table" may be: any table of one kind in one room, where something shall be on or at it."""
    last = [item for item in found if item.id in context.things]
    if last:
        return last if place.relation in ("on", "in") else last[:1]
    near = context.nearest([item.room for item in found])
    found = [item for item in found if item.room in near]
    own = {item.id for item in found if is_of_its_room(state, item, anchor.noun)}
    found = [item for item in found if item.id in own] or found
    found = told_by_size(told_by_side(found, anchor.hints), anchor.hints)
    found = context.brief.things_first(found, anchor.noun)
    needed = needed_there(state, found)
    found = needed if len(needed) == 1 else found
    kinds = {(item.room, item.category) for item in found}
    if len(found) == 1 or (len(kinds) == 1 and place.relation not in ("", "between")):
        return found
    raise ambiguous(thing_words(anchor), [title_of(state, item) for item in found], [item.id for item in found])


def _between(state: SceneState, place: Place, found: list[SceneObject], context: Context) -> list[Target]:
    ends = found if place.other is None else things_of(state, place.other, context)
    pairs = [
        (math.dist(one.position[:2], other.position[:2]), one, other)
        for one in found
        for other in ends
        if one.room == other.room and one.id != other.id and (place.other is not None or one.id < other.id)
    ]
    pairs.sort(key=lambda pair: (round(pair[0], 4), pair[1].id, pair[2].id))
    return [_facing(state, place, Target(one.room, one, other), context) for _, one, other in pairs]


def _facing(state: SceneState, place: Place, target: Target, context: Context) -> Target:
    if place.facing is None:
        return target
    found = [item for item in things_of(state, place.facing, context) if item.room == target.room]
    if not found:
        message = f"there is no {bare_words(place.facing)} in {target.room} to face"
        raise MansionError(ErrorCode.NOT_FOUND, message)
    if len(found) > 1 and means_one(place.facing):
        raise ambiguous(thing_words(place.facing), [title_of(state, item) for item in found], [i.id for i in found])
    return replace(target, facing=found[0])
