"""Which categories answer for which: a dining chair is a chair, a wall screen is a television."""

from functools import cache
from importlib.resources import files
from typing import Final

import msgspec

from mansion_assets.catalogue.asset import Asset

__all__ = [
    "added_for",
    "answers",
    "idle_without",
    "pair_of_seats",
    "pieces",
    "single_seat",
    "single_seat_categories",
    "stand_ins",
]

_FILE: Final = "kinds.json"


class _Kinds(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    stand_ins: dict[str, list[str]]
    added: dict[str, str]
    single_seats: dict[str, str]
    idle_without: dict[str, list[str]]


@cache
def _kinds() -> _Kinds:
    text = files("mansion_assets.catalogue").joinpath("data", _FILE).read_bytes()
    return msgspec.json.decode(text, type=_Kinds)


def stand_ins(category: str) -> list[str]:
    """Return the categories that answer for one besides itself, the most usual first."""
    return _kinds().stand_ins.get(category, [])


def answers(requested: str, category: str) -> bool:
    """Tell whether an object of a category is what a brief means by `requested`.

    Examples
    --------
    >>> answers("chair", "office_chair"), answers("office_chair", "chair"), answers("bed", "bunk_bed")
    (True, False, False)
    """
    return category == requested or category in stand_ins(requested)


def pieces(requested: str, asset: Asset) -> int:
    """Return how many of `requested` an asset is: the seats of a row, else one; 0 where it does not answer."""
    if not answers(requested, asset.category):
        return 0
    return int(asset.parameters.get("seats", 1)) if asset.recipe == "seat_row" else 1


def idle_without(category: str) -> list[str]:
    """Return the categories that a room has no use for without one: a television stand without a television."""
    return _kinds().idle_without.get(category, [])


def added_for(requested: str) -> str:
    """Return the category that a room gets for `requested` where its program has none that answers."""
    return _kinds().added.get(requested, requested)


def pair_of_seats(row: Asset) -> Asset:
    """Return two seats of a row of three or more, both at an aisle when rows stand side by side; else the asset."""
    number = pieces(row.category, row)
    if number < 3:
        return row
    size = (2 * row.size[0] / number, row.size[1], row.size[2])
    return msgspec.structs.replace(row, size=size, parameters={**row.parameters, "seats": 2})


def single_seat(category: str) -> str:
    """Return the category of one seat of a row of seats; `category` itself where it is no such row."""
    return _kinds().single_seats.get(category, category)


def single_seat_categories() -> frozenset[str]:
    """Return the categories of single seats of rows."""
    return frozenset(_kinds().single_seats.values())
