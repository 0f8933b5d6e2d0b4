"""The part of an outer wall that openings may use: what the other wall of a re-entrant corner leaves."""

from shapely.geometry import Polygon

from mansion_msgs_py.shapes import Point
from mansion_scene.structure.dimensions import EXTERIOR_THICKNESS
from mansion_scene.structure.regions import ring_points
from mansion_scene.structure.stretches import Stretch

__all__ = ["reentrant_corners", "usable_part"]


def reentrant_corners(outline: Polygon) -> frozenset[Point]:
    """Return the corners of an outline (and of its courtyards) where the building turns around the outside."""
    corners = set()
    for ring in (outline.exterior, *outline.interiors):
        points = ring_points(ring)
        for index, (x, y) in enumerate(points):
            (ax, ay), (bx, by) = points[index - 1], points[(index + 1) % len(points)]
            if (x - ax) * (by - y) - (y - ay) * (bx - x) < 0.0:
                corners.add(_key((x, y)))
    return frozenset(corners)


def _key(point: Point) -> Point:
    return round(point[0], 2) + 0.0, round(point[1], 2) + 0.0


def usable_part(stretch: Stretch, corners: frozenset[Point]) -> Stretch | None:
    """Return an exterior stretch less the other wall at re-entrant corners; ``None`` when nothing is left."""
    low = EXTERIOR_THICKNESS if _key(stretch.start) in corners else 0.0
    high = stretch.length - (EXTERIOR_THICKNESS if _key(stretch.end) in corners else 0.0)
    if high - low < 1e-3:
        return None
    if low == 0.0 and high == stretch.length:
        return stretch
    return Stretch(stretch.at(low), stretch.at(high), stretch.left, None, stretch.exterior, stretch.structural)
