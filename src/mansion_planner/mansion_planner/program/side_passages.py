"""Small rooms around a passage of their own: toilets, stores and cells that would else be cut out of a larger room.

A passage opens to the corridor, with rooms on one side or both and one across its end, so that each of them is a
rectangle and no classroom or office is left as an L.
"""

import itertools
import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

from mansion_planner.program.model import Box, Corridor, box_area
from mansion_planner.program.widths import widened

__all__ = ["PASSAGE", "Cluster", "SidePassage", "Wish", "cluster_layout", "cluster_width", "with_passages"]

PASSAGE = 1.5
"""Width of a side passage between the middles of its walls, metres."""

_DOOR_SIDE = 1.4
"""Least length of wall along a passage for a room's door, metres."""

_LONGEST = 4.0
"""Most metres of a passage: with the way to the middle of the corridor, the dead end that the rules allow in public."""

_DEEPER = (1.0, 0.8, 1.25)
"""Lengths of a passage that are tried, as multiples of the one at which all rooms keep their proportions."""

_TO_THE_WALL = 0.4
"""What a passage that goes on to the outer wall costs, in units of long side to short one."""

_OFF, _SLACK = 8.0, 0.15
"""The same for each share by which a room is smaller or larger than asked for, beyond a slack."""


_LACKING = 200.0
"""The same for each metre that a side lacks."""


@dataclass(frozen=True)
class Wish:
    """A room for a passage: its area, and its least short and long side in metres."""

    area: float
    short: float
    long: float


@dataclass(frozen=True)
class Cluster:
    """Rooms at a passage in the frame of their block, the corridor at ``y = 0``.

    Attributes
    ----------
    rooms : tuple of Box
        In the order of the wishes, the largest first.
    passage : Box
    price : float
        The long side to the short one of the worst room, tenfold the metres that sides lack, and shares of area.
    """

    rooms: tuple[Box, ...]
    passage: Box
    price: float


def cluster_width(wishes: tuple[Wish, ...], depth: float) -> float:
    """Return the metres of corridor that rooms take around a passage, together about as large as asked for.

    Examples
    --------
    >>> round(cluster_width((Wish(8.0, 1.6, 1.6), Wish(6.0, 1.6, 1.6)), 6.0), 1)
    3.0
    """
    asked = sum(wish.area for wish in wishes)
    first = asked / depth + PASSAGE / 2
    return (asked + PASSAGE * cluster_layout(wishes, first, depth).passage[3]) / depth


@lru_cache(maxsize=8192)
def cluster_layout(wishes: tuple[Wish, ...], width: float, depth: float) -> Cluster:
    """Return the best way to lay two rooms or more out around a passage in ``width x depth``."""
    laid = (
        _laid(wishes, width, depth, order, deeper)
        for order in _orders(len(wishes))
        for deeper in (_DEEPER if order[2] is not None else (1.0,))
    )
    return min(laid, key=lambda cluster: round(cluster.price, 6))


_Order = tuple[tuple[int, ...], tuple[int, ...], int | None]
"""Rooms on the left of a passage from the corridor on, those on its right, and the one across its end."""


@lru_cache(maxsize=8)
def _orders(count: int) -> tuple[_Order, ...]:
    return tuple(_each_order(count))


def _each_order(count: int) -> Iterator[_Order]:
    """Yield the ways to divide rooms, the largest first, between the sides of a passage and its end.

    One of the two largest lies across the end, or the passage goes on to the outer wall.
    """
    for end in (0, 1, None):
        others = [number for number in range(count) if number != end]
        for sides in itertools.product((0, 1), repeat=len(others)):
            if sides[0] == 0:
                left, right = (tuple(n for n, side in zip(others, sides) if side == which) for which in (0, 1))
                yield left, right, end


def _laid(wishes: Sequence[Wish], width: float, depth: float, order: _Order, deeper: float) -> Cluster:
    """Return rooms laid out in one way, those along the passage `deeper` times as deep as their areas ask for."""
    left, right, end = order
    sides = max(width - PASSAGE, 0.1)
    beside = [sum(wishes[n].area for n in column) for column in (left, right)]
    along = depth
    boxes: dict[int, Box] = {}
    if end is not None:
        share = sum(beside) / wishes[end].area * width
        along = min(deeper * share * depth / (sides + share), depth - 0.1)
        boxes[end] = (0.0, along, width, depth)
    wide = [sides * area / sum(beside) for area in beside]
    least = [max([_DOOR_SIDE, *(wishes[n].short for n in column)]) for column in (left, right)]
    wide = widened(wide, least) if right else wide
    for column, (x0, x1) in zip((left, right), ((0.0, wide[0]), (wide[0] + PASSAGE, width))):
        total = sum(wishes[n].area for n in column)
        lengths = [_length_beside(wishes[n], x1 - x0) for n in column]
        rises = widened([along * wishes[n].area / total for n in column], lengths)
        for number, y0, high in zip(column, itertools.accumulate(rises, initial=0.0), rises):
            boxes[number] = (x0, y0, x1, y0 + high)
    rooms = tuple(boxes[number] for number in range(len(wishes)))
    price = _price(wishes, rooms) + (_TO_THE_WALL if end is None else 0.0)
    doors = min(box[3] - box[1] for number, box in boxes.items() if number != end)
    price = max(price, 10.0 * (_DOOR_SIDE - doors)) + 10.0 * max(along - _LONGEST, 0.0)
    return Cluster(rooms, (wide[0], 0.0, wide[0] + PASSAGE, along), price)


def _length_beside(wish: Wish, wide: float) -> float:
    """Return the least length along a passage of a room that is so wide across it, metres."""
    return max(_DOOR_SIDE, wish.short if wide >= wish.long else wish.long)


def _price(wishes: Sequence[Wish], rooms: Sequence[Box]) -> float:
    """Return the price of the worst room, and of the areas that are farthest from what is asked for."""
    scale = sum(map(box_area, rooms)) / sum(wish.area for wish in wishes)
    if scale <= 0.0:
        return math.inf  # cores have left no length for them
    off = max(abs(box_area(box) / (scale * wish.area) - 1.0) for wish, box in zip(wishes, rooms))
    worst = max(_price_of_sides(wish, box) for wish, box in zip(wishes, rooms))
    return worst + _OFF * max(off - _SLACK, 0.0)


def _price_of_sides(wish: Wish, box: Box) -> float:
    short, long = sorted((box[2] - box[0], box[3] - box[1]))
    return long / max(short, 0.1) + _LACKING * max(wish.short - short, wish.long - long, 0.0)


@dataclass(frozen=True)
class SidePassage:
    """A passage with a place: its bar, the edge of the corridor, where it begins and ends along that, and its box."""

    bar: str
    front: float
    x0: float
    x1: float
    box: Box


def with_passages(
    corridors: Sequence[Corridor], mains: Sequence[Corridor], passages: Sequence[SidePassage]
) -> list[Corridor]:
    """Return the corridors, each with the passages that open to it; `mains` are the pieces of the main one."""
    boxes: dict[str, list[Box]] = {}
    for passage in passages:
        owner = passage.bar
        if owner == "main":
            owner = max(mains, key=lambda c: min(c.boxes[0][2], passage.x1) - max(c.boxes[0][0], passage.x0)).id
        boxes.setdefault(owner, []).append(passage.box)
    return [replace(c, boxes=[*c.boxes, *boxes.get(c.id, [])]) for c in corridors]
