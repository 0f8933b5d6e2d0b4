"""How many things words mean."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.statements import Place, Rooms, Things
from mansion_msgs_py.scene import SceneObject

__all__ = [
    "LEAST_PLURAL",
    "by_holder",
    "counts_each",
    "in_one_room",
    "is_one",
    "is_one_of_each_room",
    "is_shared_out",
    "means_any_in_each_room",
    "means_one",
    "means_several",
    "new_number",
    "of_one_kind",
]

LEAST_PLURAL: Final = 2
"""How many things a plural without a number means at least."""


def means_several(things: Things) -> bool:
    """Whether words mean more than one thing: the plural, a number above one, all."""
    amount = things.amount
    whole = amount.kind in ("all", "all_but", "half", "none")
    return things.plural or whole or amount.number > 1


def new_number(things: Things) -> int:
    """Return how many things words want to be there, or want more of; a plural without a number wants two.

    Examples
    --------
    >>> new_number(Things(noun="chair", plural=True, amount=Amount(number=0))), new_number(Things(noun="chair"))
    (2, 1)
    """
    kind, number = things.amount.kind, things.amount.number
    if kind in ("exactly", "at_most", "none") or number > 1:
        return 0 if kind == "none" else number
    return LEAST_PLURAL if things.plural else 1


def means_one(things: Things) -> bool:
    """Whether words mean one certain thing ("the mug")."""
    return things.definite and not means_several(things)


def means_any_in_each_room(place: Place) -> bool:
    """Whether words mean one thing in each of several rooms, whichever of them: ``a desk in every bedroom``."""
    anchor, rooms = place.anchor, place.rooms
    if anchor is None or rooms is None or not rooms.words or not (rooms.every or rooms.number > 1):
        return False
    told = anchor.definite or anchor.refers or anchor.owned or anchor.place is not None or means_several(anchor)
    return not told and place.relation != "between"


def counts_each(things: Things) -> bool:
    """Whether the number is that of each thing they are at ("one pillow from each bed"), not of all together."""
    return things.place is not None and things.place.anchor is not None and things.place.anchor.each


def by_holder(items: Sequence[SceneObject]) -> list[list[SceneObject]]:
    """Return objects in groups of those that the same thing holds, in the order in which they come."""
    groups: dict[str, list[SceneObject]] = {}
    for item in items:
        groups.setdefault(item.parent or "", []).append(item)
    return list(groups.values())


def is_one(rooms: Rooms) -> bool:
    return (
        not rooms.every
        and rooms.number < 2
        and bool(rooms.words or rooms.next_to or rooms.holding or rooms.same or rooms.over)
    )


def is_one_of_each_room(place: Place) -> bool:
    """Whether a place is at one certain thing of each of several rooms: ``on the desk in each guest room``."""
    anchor, rooms = place.anchor, place.rooms
    if anchor is None or rooms is None or place.relation == "between" or place.outside:
        return False
    one = means_one(anchor) and not (anchor.each or anchor.refers)
    return one and (rooms.every or rooms.number > 1)


def is_shared_out(things: Things, place: Place, *, each: bool) -> bool:
    """Whether a number is that of all places together: ``five boxes on the shelves``, not ``on each shelf``.

    One thing for a plural ("a vase on the tables") is one for each of them.
    """
    anchor = place.anchor
    if (
        anchor is None
        or each
        or anchor.each
        or place.relation not in ("on", "in")
        or things.amount.number < LEAST_PLURAL
    ):
        return False
    counted = things.amount.kind in ("some", "more", "at_least") and not things.amount.of
    plain = anchor.definite and anchor.plural and anchor.amount.kind == "some" and not anchor.amount.of
    return counted and plain and anchor.amount.number <= things.amount.number


def of_one_kind(items: Sequence[SceneObject], number: int) -> list[SceneObject] | None:
    """Return the only kind of which there are just so many: of five tables the four that are reading tables."""
    kinds: dict[str, list[SceneObject]] = {}
    for item in items:
        kinds.setdefault(item.category, []).append(item)
    fitting = [group for group in kinds.values() if len(group) == number]
    return fitting[0] if len(fitting) == 1 and number > 1 and len(items) > number else None


def in_one_room(items: Sequence[SceneObject], number: int) -> list[SceneObject] | None:
    """Return those of the only room that has just so many: of ten tables the eight in the cafe."""
    rooms: dict[str, list[SceneObject]] = {}
    for item in items:
        rooms.setdefault(item.room, []).append(item)
    fitting = [group for group in rooms.values() if len(group) == number]
    return fitting[0] if len(fitting) == 1 and number > 2 and len(items) > number else None
