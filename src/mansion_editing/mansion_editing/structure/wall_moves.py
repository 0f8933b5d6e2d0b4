"""Moves of stretches of the wall between two rooms, by which one takes floor from the other."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

from shapely import Polygon

from mansion_editing.structure.room_shapes import ShapeLimits, tidied
from mansion_geometry.rings import polygon_parts
from mansion_geometry.shared_walls import SharedWall, edge_array, shared_walls
from mansion_msgs_py.shapes import Point, Segment

__all__ = ["MovedWall", "Plan", "most_area", "plans"]

Shapes = Mapping[str, Polygon]

_SHORTEST = 0.9  # metres of wall that may be moved on their own
_STEP = 0.25  # metres by which a wall is tried further and further
_FARTHEST = 20.0
_LEAST_GIVEN = 0.5
"""Square metres below which a wall is not moved, unless all that is wanted is less."""

_MOST_WALLS = 4
_PARTS = ((0.0, 1.0), (0.0, 0.5), (0.5, 1.0))
"""Stretches of a wall that are tried, as shares of its length."""

_CORNER_PRICE = 0.25


@dataclass(frozen=True)
class MovedWall:
    """A stretch of wall that moved.

    Attributes
    ----------
    gainer, giver : str
        Rooms whose floor grew and shrank.
    segment : Segment
        Where it stood, the gainer to the left.
    shift : Point
        How far it moved, metres.
    """

    gainer: str
    giver: str
    segment: Segment
    shift: Point


@dataclass(frozen=True)
class Plan:
    """Moves that together give the area asked for, and the shapes that they leave."""

    shapes: dict[str, Polygon]
    moves: tuple[MovedWall, ...]


@dataclass(frozen=True)
class _Stretch:
    gainer: str
    giver: str
    start: Point
    end: Point

    @property
    def outward(self) -> Point:
        """Unit vector from the gainer, on the left, into the giver."""
        length = math.dist(self.start, self.end)
        return (self.end[1] - self.start[1]) / length, (self.start[0] - self.end[0]) / length

    def strip(self, depth: float) -> Polygon:
        nx, ny = self.outward
        (ax, ay), (bx, by) = self.start, self.end
        return Polygon([(ax, ay), (ax + nx * depth, ay + ny * depth), (bx + nx * depth, by + ny * depth), (bx, by)])


def _stretches(gainer: str, giver: str, shapes: Shapes) -> Iterator[_Stretch]:
    for wall in shared_walls(edge_array(shapes[gainer]), edge_array(shapes[giver]), 1e-3):
        for low, high in _PARTS:
            if wall.length * (high - low) >= _SHORTEST:
                yield _Stretch(gainer, giver, _at(wall, low), _at(wall, high))


def _at(wall: SharedWall, share: float) -> Point:
    (ax, ay), (bx, by) = wall.start, wall.end
    return ax + (bx - ax) * share, ay + (by - ay) * share


def _taken(stretch: _Stretch, giver: Polygon, depth: float) -> Polygon | None:
    """Return the floor between a wall and where it moves to; None where another room lies in between."""
    parts = [part for part in polygon_parts(stretch.strip(depth).intersection(giver)) if part.area > 1e-6]
    return parts[0] if len(parts) == 1 else None


def _moved(stretch: _Stretch, shapes: Shapes, depth: float) -> dict[str, Polygon] | None:
    taken = _taken(stretch, shapes[stretch.giver], depth)
    if taken is None:
        return None
    larger = tidied(shapes[stretch.gainer].union(taken))
    smaller = tidied(shapes[stretch.giver].difference(taken))
    if larger is None or smaller is None or len(larger.interiors) > len(shapes[stretch.gainer].interiors):
        return None
    return {**shapes, stretch.gainer: larger, stretch.giver: smaller}


@dataclass(frozen=True)
class _Reach:
    """How far a stretch can move, and what that gives."""

    stretch: _Stretch
    depth: float
    area: float
    corners: int


def _reach(stretch: _Stretch, shapes: Shapes, limits: Mapping[str, ShapeLimits]) -> _Reach | None:
    """Return the farthest that a stretch can move with both rooms keeping what they must."""
    best: tuple[float, dict[str, Polygon]] | None = None
    depth = _STEP
    while depth <= _FARTHEST:
        after = _moved(stretch, shapes, depth)
        if after is None or not _allowed(after, stretch, limits):
            break
        best = depth, after
        depth += _STEP
    low, high = depth - _STEP, depth
    for _ in range(6):
        middle = (low + high) / 2
        after = _moved(stretch, shapes, middle)
        if after is not None and _allowed(after, stretch, limits):
            low, best = middle, (middle, after)
        else:
            high = middle
    if best is None:
        return None
    rooms = (stretch.gainer, stretch.giver)
    more = sum(len(best[1][room].exterior.coords) - len(shapes[room].exterior.coords) for room in rooms)
    area = best[1][stretch.gainer].area - shapes[stretch.gainer].area
    return _Reach(stretch, best[0], area, more)


def _allowed(shapes: Shapes, stretch: _Stretch, limits: Mapping[str, ShapeLimits]) -> bool:
    return not any(limits[room].fault(shapes[room]) for room in (stretch.giver, stretch.gainer))


def _reaches(
    room: str, others: Sequence[str], shapes: Shapes, limits: Mapping[str, ShapeLimits], wanted: float, *, grow: bool
) -> list[_Reach]:
    """Return the moves that give enough to be worth a wall."""
    found = []
    for other in others:
        gainer, giver = (room, other) if grow else (other, room)
        found += [_reach(stretch, shapes, limits) for stretch in _stretches(gainer, giver, shapes)]
    return [reach for reach in found if reach is not None and reach.area >= min(_LEAST_GIVEN, wanted) - 1e-6]


def _price(reach: _Reach, wanted: float, shapes: Shapes) -> tuple[bool, float]:
    """Rank a move: those that give all that is wanted first, then by what they take of the giver and their corners."""
    share = min(wanted, reach.area) / float(shapes[reach.stretch.giver].area)
    return reach.area < wanted - 1e-6, round(share + _CORNER_PRICE * max(reach.corners, 0), 6)


def _carried_out(reach: _Reach, shapes: Shapes, wanted: float) -> tuple[dict[str, Polygon], MovedWall] | None:
    """Move a wall as far as it gives an area."""
    stretch, (low, high) = reach.stretch, (0.0, reach.depth)
    if reach.area > wanted:
        for _ in range(40):
            middle = (low + high) / 2
            taken = _taken(stretch, shapes[stretch.giver], middle)
            if taken is not None and taken.area < wanted:
                low = middle
            else:
                high = middle
    after = _moved(stretch, shapes, high)
    if after is None:
        return None
    nx, ny = stretch.outward
    return after, MovedWall(stretch.gainer, stretch.giver, (stretch.start, stretch.end), (nx * high, ny * high))


def plans(
    room: str, change: float, others: Sequence[str], shapes: Shapes, limits: Mapping[str, ShapeLimits]
) -> Iterator[Plan]:
    """Yield ways to change the area of a room, those that disturb least first.

    Parameters
    ----------
    room : str
    change : float
        Square metres that it gains, or loses where negative.
    others : sequence of str
        Neighbours that may give, or take.
    shapes : mapping of str to Polygon
        The room and its neighbours.
    limits : mapping of str to ShapeLimits
        What each keeps.
    """
    grow, wanted = change > 0, abs(change)
    reaches = _reaches(room, others, shapes, limits, wanted, grow=grow)
    firsts = sorted(reaches, key=lambda reach: _price(reach, wanted, shapes))
    for first in firsts:
        plan = _completed(room, wanted, first, others, Plan(dict(shapes), ()), limits, grow=grow)
        if plan is not None:
            yield plan


def _completed(
    room: str,
    wanted: float,
    first: _Reach,
    others: Sequence[str],
    plan: Plan,
    limits: Mapping[str, ShapeLimits],
    *,
    grow: bool,
) -> Plan | None:
    """Carry out a first move and the best ones after it until the area is there; None where it cannot be."""
    start = plan.shapes[room].area
    reach: _Reach | None = first
    while reach is not None and len(plan.moves) < _MOST_WALLS:
        left = wanted - abs(plan.shapes[room].area - start)
        done = _carried_out(reach, plan.shapes, left)
        if done is None:
            return None
        plan = replace(plan, shapes=done[0], moves=(*plan.moves, done[1]))
        left = wanted - abs(plan.shapes[room].area - start)
        if left <= 0.002 * wanted + 2e-3:
            return plan
        further = _reaches(room, others, plan.shapes, limits, left, grow=grow)
        reach = min(further, key=lambda r: _price(r, left, plan.shapes), default=None)
    return None


def most_area(
    room: str, others: Sequence[str], shapes: Shapes, limits: Mapping[str, ShapeLimits], *, grow: bool
) -> float:
    """Return the largest (or least) area that a room can have if its neighbours give (or take) all that they can."""
    now = dict(shapes)
    for _ in range(_MOST_WALLS):
        reaches = _reaches(room, others, now, limits, _LEAST_GIVEN, grow=grow)
        if not reaches:
            break
        best = max(reaches, key=lambda reach: round(reach.area, 4))
        done = _carried_out(best, now, best.area)
        if done is None:
            break
        now = done[0]
    return float(now[room].area)
