"""How many people sit around a table, so that tables and chairs are chosen for each other."""

from collections.abc import Sequence

from mansion_assets.catalogue.asset import Asset
from mansion_assets.catalogue.records import Count, Item

__all__ = ["seating_tables", "seats_around", "sits_around", "wanted_seats"]

_PLACE = 0.59
"""Least width of a place at a table, metres."""

_BEHIND = 1.1
"""From a table's edge to the wall: a chair and somebody who passes behind it, metres."""


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
    """Whether copies of an item of a room program stand around another, `table`."""
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
    """Return the tables that seat so many and leave room to pass behind the chairs.

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
