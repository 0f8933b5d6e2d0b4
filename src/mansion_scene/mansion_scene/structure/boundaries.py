"""Straight boundary segments between two regions of a floor, or between a region and the outside.

All edges of all rings are sorted on to their supporting lines; a sweep along each line then knows, between any two
breakpoints, which region lies to its left and which to its right.
"""

import math
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace
from itertools import pairwise

from shapely.geometry import Polygon

from mansion_msgs_py.shapes import Point, Ring, Segment
from mansion_scene.structure.dimensions import CLEAR_WIDTH, EXTERIOR_THICKNESS, INTERIOR_THICKNESS
from mansion_scene.structure.regions import FloorRegions, ring_points

__all__ = ["corner_key", "BoundarySegment", "boundary_segments", "reentrant_corners", "usable_part"]

_ANGLE = 1e-4  # radians between lines that count as parallel
_SNAP = 2e-3  # metres between points, or lines, that count as one
_OFF_LINE = 5e-3  # metres between a door or window and the line of its boundary
_DOOR = CLEAR_WIDTH + INTERIOR_THICKNESS
"""Shortest boundary, on centre lines, that takes a door of full width, metres."""


@dataclass(frozen=True)
class BoundarySegment:
    """A straight piece of boundary that has the same region, or none, on each side along its whole length.

    Attributes
    ----------
    start, end : Point
        Ends on the boundary; `left` lies to the left of start -> end.
    left : str
        Region id; an exterior boundary has its region here.
    right : str, optional
        Region id; ``None`` for the outside, and for floor that the layout gave to no room.
    exterior : bool
        Whether it lies on the floor's outline or one of its holes.
    structural : bool
        Whether it lies on a structural wall of the program.
    """

    start: Point
    end: Point
    left: str
    right: str | None
    exterior: bool
    structural: bool

    @property
    def length(self) -> float:
        """Length, metres."""
        return math.dist(self.start, self.end)

    @property
    def direction(self) -> Point:
        """Unit vector from start to end."""
        length = self.length
        return (self.end[0] - self.start[0]) / length, (self.end[1] - self.start[1]) / length

    def span_of(self, segment: Segment) -> tuple[float, float] | None:
        """Return between which distances from the start a segment runs along it, metres; ``None`` off its line."""
        (x0, y0), (dx, dy) = self.start, self.direction
        if any(abs((x - x0) * dy - (y - y0) * dx) > _OFF_LINE for x, y in segment):
            return None
        low, high = sorted((x - x0) * dx + (y - y0) * dy for x, y in segment)
        return low, high

    def at(self, distance: float) -> Point:
        """Return the point at a distance from the start."""
        dx, dy = self.direction
        return self.start[0] + dx * distance, self.start[1] + dy * distance

    def part(self, low: float, high: float) -> "BoundarySegment":
        """Return the part between two distances from the start."""
        return replace(self, start=self.at(low), end=self.at(high))


@dataclass
class _Line:
    """A supporting line: unit direction, signed distance from the origin, and what lies along it."""

    direction: Point
    offset: float
    spans: list[tuple[float, float, int, str]] = field(default_factory=list)

    def along(self, point: Point) -> float:
        return self.direction[0] * point[0] + self.direction[1] * point[1]

    def across(self, point: Point) -> float:
        return self.direction[0] * point[1] - self.direction[1] * point[0]

    def point(self, along: float) -> Point:
        (dx, dy), offset = self.direction, self.offset
        return round(dx * along - dy * offset, 4) + 0.0, round(dy * along + dx * offset, 4) + 0.0


# Owners of spans that are not a region.
_OUTLINE = "\x00outline"
_STRUCTURE = "\x00structure"


def _edges(ring: Ring) -> Iterable[Segment]:
    for index, point in enumerate(ring):
        yield ring[index - 1], point


class _Lines:
    """Supporting lines by rounded angle, so that an edge finds its line among few."""

    def __init__(self) -> None:
        self.lines: list[_Line] = []
        self._buckets: dict[int, list[_Line]] = {}

    def add(self, edge: Segment, owner: str) -> None:
        (x0, y0), (x1, y1) = edge
        length = math.hypot(x1 - x0, y1 - y0)
        if length < _SNAP:
            return
        dx, dy = (x1 - x0) / length, (y1 - y0) / length
        # Every line runs towards +x (+y where vertical), so that opposite edges share one; `side` tells them apart.
        side = 1
        if dx < -_ANGLE or (abs(dx) <= _ANGLE and dy < 0.0):
            dx, dy, side = -dx, -dy, -1
        line = self._find((dx, dy), edge)
        t0, t1 = sorted((line.along(edge[0]), line.along(edge[1])))
        line.spans.append((t0, t1, side, owner))

    def _find(self, direction: Point, edge: Segment) -> _Line:
        dx, dy = direction
        middle = (edge[0][0] + edge[1][0]) / 2, (edge[0][1] + edge[1][1]) / 2
        # A parallel line may have its angle rounded into the next bucket.
        key = round(math.atan2(dy, dx) / (2 * _ANGLE))
        for near in (key, key - 1, key + 1):
            for line in self._buckets.get(near, ()):
                turn = abs(line.direction[0] * dy - line.direction[1] * dx)
                if turn < _ANGLE and abs(line.across(middle) - line.offset) < _SNAP:
                    return line
        line = _Line(direction, dx * middle[1] - dy * middle[0])
        self.lines.append(line)
        self._buckets.setdefault(key, []).append(line)
        return line


def _breakpoints(line: _Line) -> list[float]:
    ends = sorted(t for span in line.spans for t in span[:2])
    points: list[float] = []
    for t in ends:
        if not points or t - points[-1] > _SNAP:
            points.append(t)
    return points


def _sweep(line: _Line) -> list[BoundarySegment]:
    boundaries: list[BoundarySegment] = []
    points = _breakpoints(line)
    for low, high in pairwise(points):
        middle = (low + high) / 2
        here = [span for span in line.spans if span[0] <= middle <= span[1]]
        left = next((o for _, _, side, o in here if side > 0 and o[0] != "\x00"), None)
        right = next((o for _, _, side, o in here if side < 0 and o[0] != "\x00"), None)
        owners = {span[3] for span in here}
        start, end = line.point(low), line.point(high)
        if left is None:
            start, end, left, right = end, start, right, None
        if left is None:
            continue
        boundaries.append(
            BoundarySegment(
                start, end, left, right, exterior=right is None and _OUTLINE in owners, structural=_STRUCTURE in owners
            )
        )
    return _joined_for_doors(_merge(boundaries))


def _merge(boundaries: Sequence[BoundarySegment]) -> list[BoundarySegment]:
    merged: list[BoundarySegment] = []
    for boundary in boundaries:
        last = merged[-1] if merged else None
        same = last is not None and (last.left, last.right, last.exterior, last.structural) == (
            boundary.left,
            boundary.right,
            boundary.exterior,
            boundary.structural,
        )
        if last is not None and same and math.dist(last.end, boundary.start) < _SNAP:
            merged[-1] = replace(boundary, start=last.start)
        elif last is not None and same and math.dist(last.start, boundary.end) < _SNAP:
            merged[-1] = replace(boundary, end=last.end)
        else:
            merged.append(boundary)
    return merged


def _joined_for_doors(boundaries: Sequence[BoundarySegment]) -> list[BoundarySegment]:
    """Join a structural piece of a wall with its other part where neither takes a door; the whole is structural."""
    joined: list[BoundarySegment] = []
    for boundary in boundaries:
        last = joined[-1] if joined else None
        if (
            last is not None
            and last.right is not None
            and (last.left, last.right) == (boundary.left, boundary.right)
            and max(last.length, boundary.length) < _DOOR
            and math.dist(last.end, boundary.start) < _SNAP
        ):
            joined[-1] = replace(last, end=boundary.end, structural=True)
        else:
            joined.append(boundary)
    return joined


def boundary_segments(floor: FloorRegions, structural: Sequence[Segment] = ()) -> list[BoundarySegment]:
    """Return all boundary segments of a floor, in a fixed order.

    Parameters
    ----------
    floor : FloorRegions
    structural : sequence of Segment
        Centre lines of structural walls; a segment on one is marked.

    Returns
    -------
    list of BoundarySegment
        Ordered by supporting line, as the regions first touch it, then along the line.
    """
    lines = _Lines()
    for region in floor.regions:
        for ring in (region.polygon.exterior, *region.polygon.interiors):
            for edge in _edges(ring_points(ring)):
                lines.add(edge, region.id)
    for ring in (floor.outline.exterior, *floor.outline.interiors):
        for edge in _edges(ring_points(ring)):
            lines.add(edge, _OUTLINE)
    for segment in structural:
        lines.add(segment, _STRUCTURE)
    return [boundary for line in lines.lines for boundary in _sweep(line)]


def reentrant_corners(outline: Polygon) -> frozenset[Point]:
    """Return the corners of an outline (and of its courtyards) where the building turns around the outside."""
    corners = set()
    for ring in (outline.exterior, *outline.interiors):
        points = ring_points(ring)
        for index, (x, y) in enumerate(points):
            (ax, ay), (bx, by) = points[index - 1], points[(index + 1) % len(points)]
            if (x - ax) * (by - y) - (y - ay) * (bx - x) < 0.0:
                corners.add(corner_key((x, y)))
    return frozenset(corners)


def corner_key(point: Point) -> Point:
    """Return a corner rounded to 1 cm, by which rings that share it find each other."""
    return round(point[0], 2) + 0.0, round(point[1], 2) + 0.0


def usable_part(boundary: BoundarySegment, corners: frozenset[Point]) -> BoundarySegment | None:
    """Return the part of an exterior segment that openings may use; ``None`` when nothing is left.

    At a re-entrant corner the other wall's body stands on the segment's end.
    """
    low = EXTERIOR_THICKNESS if corner_key(boundary.start) in corners else 0.0
    high = boundary.length - (EXTERIOR_THICKNESS if corner_key(boundary.end) in corners else 0.0)
    if high - low < 1e-3:
        return None
    if low == 0.0 and high == boundary.length:
        return boundary
    return boundary.part(low, high)
