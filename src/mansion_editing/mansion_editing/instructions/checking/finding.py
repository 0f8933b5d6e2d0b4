"""What the check of one statement finds: why it does not hold, and which differences it accounts for."""

from collections.abc import Sequence
from dataclasses import dataclass, field

import msgspec

from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.meaning.descriptions import all_at, anchors_of, rooms_of
from mansion_editing.instructions.meaning.doors import means_doors
from mansion_editing.instructions.meaning.nouns import is_fixed
from mansion_editing.instructions.meaning.numbers import (
    by_holder,
    counts_each,
    is_one_of_each_room,
    means_any_in_each_room,
    means_several,
)
from mansion_editing.instructions.statements import Amount, Place, Rooms, Things
from mansion_editing.state import SceneState
from mansion_msgs_py.scene import SceneObject

__all__ = ["Finding", "any_number", "at_shares", "joined_by_room", "numbers_meant", "shares_of"]


@dataclass(frozen=True)
class Finding:
    """Outcome of a check.

    Attributes
    ----------
    fault : str
        Why the statement does not hold; empty where it does.
    accounted : set of str
        Ids of the objects that may differ because of it.
    rooms : set of str
        Ids of the rooms, and ``floor N`` for structure, that may differ because of it.
    makes_room : bool
        A small thing may have been moved aside for it.
    """

    fault: str = ""
    accounted: set[str] = field(default_factory=set)
    rooms: set[str] = field(default_factory=set)
    makes_room: bool = False


def numbers_meant(things: Things, fitting: Sequence[SceneObject], *, surplus: bool = False) -> tuple[int, int]:
    """Return the least and the greatest number of things that words mean, of those that they fit.

    Of all, those that are fixed to the building may be left out; the light of a room is all its ceiling lights.

    Parameters
    ----------
    surplus : bool
        ``exactly`` and ``at_most`` mean those beyond the number.
    """
    if counts_each(things):
        one = msgspec.structs.replace(things, place=None)
        bounds = [numbers_meant(one, group, surplus=surplus) for group in by_holder(fitting)]
        return sum(least for least, _ in bounds), sum(most for _, most in bounds)
    amount, count = things.amount, len(fitting)
    loose = sum(not is_fixed(item) for item in fitting) or count
    if amount.kind == "all_but" or (surplus and amount.kind in ("exactly", "at_most")):
        number = max(0, count - amount.number)
        return number, number
    if amount.kind == "none":
        return 0, 0
    if amount.kind == "half":
        return count // 2, count // 2
    if amount.kind == "all" or (things.plural and amount.number <= 1):
        return loose, count
    one_of_many = (things.refers == "last" and not amount.number) or (things.definite and "light" in things.noun)
    if one_of_many and not means_several(things):
        return 1, count
    return max(1, amount.number), max(1, amount.number)


def any_number(things: Things) -> Things:
    """Return the words for the kind alone, with its looks: any number, new or not, anywhere."""
    return msgspec.structs.replace(
        things,
        amount=Amount(kind="all", number=0),
        place=None,
        definite=False,
        refers="",
        ordinal=0,
        size="",
        hints=(),
        owned="",
        beside=(),
        bearing=None,
    )


def shares_of(place: Place, before: SceneState, after: SceneState, context: Context) -> list[Place]:
    """Return the place once for each thing or room that it names, by id.

    They are looked up before the statement, so that new things do not become places of it; after it, where none was
    there.
    """
    if (
        place.relation == "between"
        or place.outside
        or place.former is not None
        or (place.anchor is not None and means_doors(place.anchor))
    ):
        return [place]
    if place.rooms is not None and means_any_in_each_room(place):
        each = rooms_of(before, place.rooms, context)
        return [msgspec.structs.replace(place, rooms=Rooms(words=room)) for room in each]
    if is_one_of_each_room(place) and place.rooms is not None:
        named = rooms_of(before, place.rooms, context)
        own = [msgspec.structs.replace(place, rooms=Rooms(words=room)) for room in named]
        return [share for here in own for share in shares_of(here, before, after, context)]
    if place.anchor is not None:
        found = anchors_of(before, place, context) or anchors_of(after, place, context)
        return [msgspec.structs.replace(place, anchor=Things(noun=item.id), rooms=None) for item in found]
    rooms = place.rooms
    if rooms is None:
        rooms = Rooms(same=True) if context.rooms else Rooms(every=True)
    named = rooms_of(before, rooms, context)
    return [msgspec.structs.replace(place, rooms=Rooms(words=room)) for room in named]


def at_shares(
    state: SceneState, items: Sequence[SceneObject], shares: Sequence[Place], context: Context
) -> list[set[str]]:
    """Return the ids of the objects at each share of a place."""
    return [{item.id for item in all_at(state, items, share, context)} for share in shares]


def joined_by_room(place: Place, shares: Sequence[Place], at: Sequence[set[str]]) -> list[set[str]]:
    """Return the ids at the shares of a place, those of one room together where words mean any one of them."""
    if not is_one_of_each_room(place):
        return list(at)
    joined: dict[str, set[str]] = {}
    for share, ids in zip(shares, at, strict=True):
        room = "" if share.anchor is None else share.anchor.noun.rpartition("/")[0]
        joined.setdefault(room, set()).update(ids)
    return list(joined.values())
