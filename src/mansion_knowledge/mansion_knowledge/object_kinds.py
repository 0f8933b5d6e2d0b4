"""What kinds of objects are to each other and to a building: a dining chair is a chair, a basin is fixed."""

from functools import cache
from importlib.resources import files
from typing import Final

import msgspec

from mansion_msgs_py.codec import prepared

__all__ = [
    "SEAT_WIDTH",
    "added_for",
    "answers",
    "idle_without",
    "is_fixed",
    "is_service",
    "noun_of",
    "of_one_kind",
    "seats_of_row",
    "single_seat",
    "single_seat_categories",
    "substitutes",
]

SEAT_WIDTH: Final = 0.64
"""Width of one seat of a row, metres, halfway between the narrow and the wide ones."""


class _Kinds(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    substitutes: dict[str, list[str]]
    added: dict[str, str]
    single_seats: dict[str, str]
    idle_without: dict[str, list[str]]
    nouns: dict[str, str]
    services: list[str]
    installed: list[str]


@cache
def _kinds() -> _Kinds:
    text = files("mansion_knowledge").joinpath("data", "object_kinds.json").read_bytes()
    return msgspec.json.decode(text, type=prepared(_Kinds))


def substitutes(category: str) -> list[str]:
    """Return the categories that answer for one besides itself, the most usual first."""
    return _kinds().substitutes.get(category, [])


def answers(requested: str, category: str) -> bool:
    """Tell whether an object of a category is what a brief means by `requested`.

    Examples
    --------
    >>> answers("chair", "office_chair"), answers("office_chair", "chair"), answers("bed", "bunk_bed")
    (True, False, False)
    """
    return category == requested or category in substitutes(requested)


def noun_of(category: str) -> str:
    """Return the noun that people count objects of a category by: its last word as a rule.

    Examples
    --------
    >>> noun_of("office_desk"), noun_of("library_stack")
    ('desk', 'bookshelf')
    """
    return _kinds().nouns.get(category, category.rpartition("_")[2])


def of_one_kind(one: str, other: str) -> bool:
    """Tell whether one category answers for another, or both for a third.

    Examples
    --------
    >>> of_one_kind("round_table", "cafe_table"), of_one_kind("round_table", "desk")
    (True, False)
    """
    kinds = _kinds().substitutes
    third = any(one in held and other in held for held in kinds.values())
    return third or answers(one, other) or answers(other, one)


def idle_without(category: str) -> list[str]:
    """Return the categories that a room has no use for without one: a television stand without a television."""
    return _kinds().idle_without.get(category, [])


def is_service(category: str) -> bool:
    """Tell whether objects of a category belong to the building's services, whatever a room is used for.

    Examples
    --------
    >>> is_service("smoke_detector"), is_service("toilet"), is_service("painting")
    (True, False, False)
    """
    return category in _kinds().services


def is_fixed(category: str) -> bool:
    """Tell whether objects of a category are fixed to the building: services, sanitary ware, lamps, fitted kitchens.

    Examples
    --------
    >>> is_fixed("smoke_detector"), is_fixed("toilet"), is_fixed("painting")
    (True, True, False)
    """
    return is_service(category) or category in _kinds().installed


def added_for(requested: str) -> str:
    """Return the category that a room gets for `requested` where its program has none that answers."""
    return _kinds().added.get(requested, requested)


def single_seat(category: str) -> str:
    """Return the category of one seat of a row of seats; `category` itself where it is no such row."""
    return _kinds().single_seats.get(category, category)


def single_seat_categories() -> frozenset[str]:
    """Return the categories of single seats of rows."""
    return frozenset(_kinds().single_seats.values())


def seats_of_row(category: str, width: float) -> int:
    """Return how many seats a row of seats of a width has, 1 for what is no such row.

    Examples
    --------
    >>> seats_of_row("auditorium_seat", 1.65), seats_of_row("chair", 1.65)
    (3, 1)
    """
    return max(1, round(width / SEAT_WIDTH)) if category in _kinds().single_seats else 1
