"""The straight walls between rooms of a drawn storey and to the outside, each with the stretch where a door may be."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import shapely
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient

from mansion_geometry.rings import ring_of
from mansion_geometry.shared_walls import edge_array, shared_walls
from mansion_geometry.wall_sizes import EXTERIOR_THICKNESS, INTERIOR_THICKNESS
from mansion_msgs_py.shapes import Point, Segment

__all__ = ["StoreyWall", "storey_walls"]

_GAP = 3e-3
_SHORTEST = 0.3


@dataclass(frozen=True)
class StoreyWall:
    """A straight wall: the room on its left, and the room, or the outside, on its right.

    Attributes
    ----------
    low, high : float
        Between which distances from its start a door may stand: clear of the walls that meet it.
    """

    left: str
    right: str | None
    start: Point
    end: Point
    low: float
    high: float

    @property
    def rooms(self) -> frozenset[str | None]:
        """What it parts."""
        return frozenset((self.left, self.right))

    @property
    def direction(self) -> Point:
        """Unit vector from start to end."""
        length = math.dist(self.start, self.end)
        return (self.end[0] - self.start[0]) / length, (self.end[1] - self.start[1]) / length

    def along(self, point: Point) -> float:
        """Return how far along a point lies."""
        dx, dy = self.direction
        return (point[0] - self.start[0]) * dx + (point[1] - self.start[1]) * dy

    def at(self, low: float, high: float) -> Segment:
        """Return the piece between two distances from the start."""
        (x, y), (dx, dy) = self.start, self.direction
        first, second = ((round(x + dx * t, 4) + 0.0, round(y + dy * t, 4) + 0.0) for t in (low, high))
        return first, second

    def distance(self, point: Point) -> float:
        """Return how far a point lies from it."""
        return float(shapely.distance(shapely.LineString([self.start, self.end]), shapely.Point(point)))

    @property
    def room(self) -> float:
        """Metres of it that a door may take."""
        return self.high - self.low


def storey_walls(shapes: Mapping[str, Polygon], outline: Polygon) -> list[StoreyWall]:
    """Return the walls of a storey; those shorter than 0.3 m are left out.

    Parameters
    ----------
    shapes : mapping of str to Polygon
        Rooms and cores, which share their boundaries.
    outline : Polygon
        All of them together.
    """
    names = list(shapes)
    edges = {name: edge_array(shape) for name, shape in shapes.items()}
    first, second = shapely.STRtree([shapes[name] for name in names]).query(
        [shapes[name] for name in names], predicate="dwithin", distance=_GAP
    )
    walls = [
        _inner(names[i], names[j], wall.start, wall.end)
        for i, j in sorted(zip(first.tolist(), second.tolist()))
        if i < j
        for wall in shared_walls(edges[names[i]], edges[names[j]], _GAP)
    ]
    around = edge_array(outline)[:, [2, 3, 0, 1]]
    corners = _turning_out(outline)
    walls += [
        _outer(name, wall.start, wall.end, corners)
        for name in names
        for wall in shared_walls(edges[name], around, _GAP)
    ]
    return [wall for wall in walls if math.dist(wall.start, wall.end) >= _SHORTEST]


def _inner(left: str, right: str, start: Point, end: Point) -> StoreyWall:
    half = INTERIOR_THICKNESS / 2
    return StoreyWall(left, right, start, end, half, math.dist(start, end) - half)


def _outer(name: str, start: Point, end: Point, corners: list[Point]) -> StoreyWall:
    """Return an outer wall: at a corner where the outline turns out, the body of the next wall stands on its end."""
    ends = [
        EXTERIOR_THICKNESS if any(math.dist(point, corner) < 0.01 for corner in corners) else INTERIOR_THICKNESS / 2
        for point in (start, end)
    ]
    return StoreyWall(name, None, start, end, ends[0], math.dist(start, end) - ends[1])


def _turning_out(outline: Polygon) -> list[Point]:
    whole = orient(outline)
    rings = [ring_of(whole.exterior), *(ring_of(hole, ccw=False) for hole in whole.interiors)]
    found = []
    for ring in rings:
        for k, (x, y) in enumerate(ring):
            (ax, ay), (bx, by) = ring[k - 1], ring[(k + 1) % len(ring)]
            if (x - ax) * (by - y) - (y - ay) * (bx - x) < -1e-9:
                found.append((x, y))
    return found
