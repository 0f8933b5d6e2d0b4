"""The geometry of a building's payloads: areas and heights, walls that rooms share, and the form of an outline."""

import math
from collections.abc import Iterator, Sequence
from itertools import pairwise

from shapely import MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient
from shapely.ops import unary_union

from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_msgs_py.shapes import Point, Ring, Segment

__all__ = [
    "along",
    "free_region",
    "is_upright",
    "net_area",
    "outline_forms",
    "room_area",
    "segment_length",
    "shared_wall",
    "vertical",
]


def room_area(room: SceneRoom) -> Polygon:
    """The room between wall centre lines."""
    return Polygon(room.polygon, room.holes)


def net_area(room: SceneRoom) -> Polygon:
    """The room between wall faces."""
    return Polygon(room.net_polygon, room.net_holes)


def free_region(outline: Ring, holes: Sequence[Ring], cores: Sequence[Ring]) -> BaseGeometry:
    """The floor less courtyards and cores."""
    return Polygon(outline, holes).difference(unary_union([Polygon(core) for core in cores]))


def is_upright(ring: Ring) -> bool:
    """Whether all sides of an outline run along the axes, to a millimetre."""
    return all(min(abs(bx - ax), abs(by - ay)) < 1e-3 for (ax, ay), (bx, by) in pairwise([*ring, ring[0]]))


def vertical(item: SceneObject) -> tuple[float, float]:
    """Lower and upper height of the object above the finished floor."""
    return item.bottom, item.top


def segment_length(segment: Segment) -> float:
    """Length in metres."""
    return math.dist(*segment)


def along(wall: Segment, point: Point) -> tuple[float, float]:
    """Return the position of `point` along `wall` and its distance from the wall, both in metres."""
    (x0, y0), (x1, y1) = wall
    length = math.dist(*wall)
    ux, uy = (x1 - x0) / length, (y1 - y0) / length
    dx, dy = point[0] - x0, point[1] - y0
    return dx * ux + dy * uy, abs(dy * ux - dx * uy)


_APART = 0.05
"""Metres between the lines of two edges that are one wall."""

_SMALL_BAY = 0.02
"""Share of the hull below which a recess does not count as part of the form."""


def shared_wall(first: SceneRoom, second: SceneRoom) -> float:
    """Return the length of the longest straight wall that two rooms have in common, in metres."""
    stretches: list[float] = []
    for one in _edges(first):
        spans = [_overlap(one, other) for other in _edges(second)]
        stretches += _joined(sorted(span for span in spans if span is not None))
    return max(stretches, default=0.0)


def _edges(room: SceneRoom) -> Iterator[Segment]:
    for ring in (room.polygon, *room.holes):
        yield from pairwise(_corners(ring))


def _corners(ring: Sequence[Point]) -> list[Point]:
    """Return the corners of a closed ring, those on a straight line left out, the first again at the end."""
    kept = [
        here
        for before, here, after in zip([ring[-1], *ring[:-1]], ring, [*ring[1:], ring[0]], strict=True)
        if abs(_turn(before, here, after)) > 1e-6
    ]
    return [*kept, *kept[:1]]


def _turn(before: Point, here: Point, after: Point) -> float:
    return (here[0] - before[0]) * (after[1] - here[1]) - (here[1] - before[1]) * (after[0] - here[0])


def _overlap(one: Segment, other: Segment) -> tuple[float, float] | None:
    """Return from where to where along `one` the edge `other` lies on it."""
    (x0, y0), (x1, y1) = one
    length = math.dist(*one)
    if length < 1e-6:
        return None
    ux, uy = (x1 - x0) / length, (y1 - y0) / length
    ends = [((x - x0) * ux + (y - y0) * uy, abs((y - y0) * ux - (x - x0) * uy)) for x, y in other]
    low, high = max(0.0, min(t for t, _ in ends)), min(length, max(t for t, _ in ends))
    return (low, high) if max(aside for _, aside in ends) <= _APART and high > low else None


def _joined(spans: Sequence[tuple[float, float]]) -> list[float]:
    """Return the lengths of ordered spans, those that touch taken as one."""
    lengths: list[float] = []
    end = -math.inf
    for low, high in spans:
        if low <= end + 1e-6 and lengths:
            lengths[-1] += max(high - end, 0.0)
        else:
            lengths.append(high - low)
        end = max(end, high)
    return lengths


def outline_forms(outline: Ring, holes: Sequence[Ring]) -> set[str]:
    """Return the names of the forms that an outline has, by the recesses that its convex hull has and it has not.

    Examples
    --------
    >>> outline_forms([(0, 0), (9, 0), (9, 4), (4, 4), (4, 9), (0, 9)], [])
    {'L'}
    >>> sorted(outline_forms([(0, 0), (5, 0), (5, 5), (0, 5)], []))
    ['rectangle', 'square']
    """
    if holes:
        return {"courtyard"}
    shape = Polygon(outline)
    hull = shape.convex_hull
    rest = hull.difference(shape)
    pieces = [piece for piece in (rest.geoms if isinstance(rest, MultiPolygon) else [rest]) if not piece.is_empty]
    bays = [piece for piece in pieces if piece.area > _SMALL_BAY * hull.area]
    sides = sorted(len(_corners(orient(bay).exterior.coords[:-1])) - 1 for bay in bays)
    if not bays:
        west, south, east, north = shape.bounds
        even = 0.9 <= (east - west) / (north - south) <= 1.1
        return {"rectangle", "square"} if even else {"rectangle"}
    if sides == [3]:
        return {"L"}
    if sides == [4]:
        return {"U", "courtyard"}
    if sides == [3, 3]:
        return {"T"} if _mirrored(bays) else {"Z"}
    return {"H"} if sides == [4, 4] else set()


def _mirrored(bays: Sequence[Polygon]) -> bool:
    """Whether the long sides of two triangles rise to different sides, as the bays beside the stem of a T do."""
    slopes = []
    for bay in bays:
        corners = list(bay.exterior.coords)
        (x0, y0), (x1, y1) = max(pairwise(corners), key=lambda side: math.dist(*side))
        slopes.append((x1 - x0) * (y1 - y0))
    return bool(slopes[0] * slopes[1] < 0)
