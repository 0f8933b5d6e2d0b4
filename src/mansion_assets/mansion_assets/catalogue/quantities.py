"""How many copies of an object a room gets: by area, as a matrix, and as seats around tables."""

import math
from collections.abc import Sequence

import numpy as np

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.records import Count, Item, MatrixShape

__all__ = ["copies", "grid", "room_extent", "seating_tables", "seats_around", "sits_around", "wanted_seats"]

_AISLE = 0.7
"""Width of the free strip that a matrix leaves along the walls, metres."""


def copies(count: int | Count, area: float, others: dict[str, int], rng: np.random.Generator) -> int:
    """Return the number of copies for a room of `area` square metres.

    Parameters
    ----------
    others : dict
        Number of copies of each item so far, for counts that follow ``each``.

    Notes
    -----
    A count by area varies by up to one in eight from room to room, so that rooms of one size differ.
    """
    if isinstance(count, int):
        return count
    if count.each:
        return min(count.max, max(count.min, round(others.get(count.each, 0) * count.times)))
    if count.per is None:
        return int(rng.integers(count.min, count.max + 1))
    wanted = area / count.per
    if wanted > 2.0:
        wanted *= 1.0 + 0.125 * float(rng.uniform(-1.0, 1.0))
    return min(count.max, max(count.min, math.floor(wanted + 1e-9)))


def room_extent(area: float, extent: tuple[float, float] | None) -> tuple[float, float]:
    """Return a room's longer and shorter side; 5:4 where only its area is known."""
    if extent is None:
        long = math.sqrt(area * 1.25)
        return long, area / long
    return max(extent), min(extent)


def grid(wanted: int, cell: tuple[float, float], shape: MatrixShape, extent: tuple[float, float]) -> tuple[int, int]:
    """Return rows and columns of at most `wanted` copies that fit a room.

    Parameters
    ----------
    cell : (float, float)
        Width and depth of a copy, its paired accessory included.
    extent : (float, float)
        Longer and shorter side of the room; columns run along either.

    Returns
    -------
    (int, int)
        (0, 0) where not even one copy fits.
    """
    best = (0, 0)
    ways = [extent[::-1]] if shape.lengthwise else [extent, extent[::-1]]
    for across, along in ways:
        cols = _fitting(across, cell[0], shape.gap[0], shape.max_cols)
        rows = _fitting(along, cell[1], shape.gap[1], shape.max_rows)
        for r in range(1, rows + 1):
            c = min(cols, wanted // r)
            if c >= 1 and (r * c, -abs(c - 1.3 * r)) > (best[0] * best[1], -abs(best[1] - 1.3 * best[0])):
                best = (r, c)
    return best


def _fitting(length: float, size: float, gap: float, most: int) -> int:
    return max(0, min(most, math.floor((length - 2 * _AISLE + gap) / (size + gap) + 1e-9)))


_PLACE = 0.59
"""Least width of a seat at a table, metres."""

_BEHIND = 1.1
"""Distance from a table's edge to the wall for a chair and a person who passes behind it, metres."""


def seats_around(table: Asset, seat: Asset) -> int:
    """Return how many seats stand side by side around a table, ends included.

    Examples
    --------
    A table of 1.6 x 0.7 m seats six, one of 3.2 x 1.2 m fourteen.
    """
    place = max(_PLACE, seat.size[0] + 0.04)
    along, across = (max(1, int((length + 0.06) / place)) for length in table.size[:2])
    return 2 * (along + across)


def sits_around(item: Item, table: str) -> bool:
    """Return whether copies of an item of a room program stand around another, `table`."""
    return any(relation.kind == "around" and relation.target == table for relation in item.relative)


def wanted_seats(item: Item, area: float, tables: int) -> float:
    """Return how many seats a room of `area` square metres asks for at each of its tables."""
    count = item.count
    if isinstance(count, int):
        return count / max(tables, 1)
    if count.each:
        return count.times
    return _by_area(count, area) / max(tables, 1)


def _by_area(count: Count, area: float) -> float:
    if count.per is None:
        return (count.min + count.max) / 2
    return min(count.max, max(count.min, area / count.per))


def seating_tables(tables: Sequence[Asset], seat: Asset, seats: float, extent: tuple[float, float]) -> list[Asset]:
    """Return the tables that seat a number of people and leave room to pass behind the chairs.

    Parameters
    ----------
    seats : float
    extent : (float, float)
        Longer and shorter side of the room, metres.

    Returns
    -------
    list of Asset
        Those that seat no more than needed; where none seats all, those that seat most.
    """
    long, short = extent
    roomy = [
        table
        for table in tables
        if max(table.size[:2]) <= long - 2 * _BEHIND and min(table.size[:2]) <= short - 2 * _BEHIND
    ]
    choices = roomy or sorted(tables, key=lambda table: table.footprint)[:1]
    enough = [table for table in choices if seats_around(table, seat) >= seats - 0.5]
    if enough:
        least = min(seats_around(table, seat) for table in enough)
        return [table for table in enough if seats_around(table, seat) == least]
    most = max(seats_around(table, seat) for table in choices)
    return [table for table in choices if seats_around(table, seat) == most]
