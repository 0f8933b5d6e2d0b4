"""Points, segments and turns in the plane, as plain functions that kernels compile too."""

from collections.abc import Sequence
from math import cos, hypot, radians, sin

from mansion_msgs_py.shapes import Point, Segment

__all__ = ["crosses", "inside_ring", "offset_from_segment", "segment_distance", "turned"]


def crosses(x: float, y: float, ax: float, ay: float, bx: float, by: float) -> bool:
    """Whether a ray from a point in the direction of +x crosses a segment; of a ring, an odd number inside it."""
    return (ay > y) != (by > y) and x < ax + (y - ay) * (bx - ax) / (by - ay)


def inside_ring(ring: Sequence[Point], x: float, y: float) -> bool:
    """Whether a point lies in a ring (even-odd rule).

    Examples
    --------
    >>> square = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)]
    >>> inside_ring(square, 1.0, 1.0), inside_ring(square, 3.0, 1.0)
    (True, False)
    """
    inside = False
    ax, ay = ring[-1]
    for bx, by in ring:
        inside ^= crosses(x, y, ax, ay, bx, by)
        ax, ay = bx, by
    return inside


def offset_from_segment(x: float, y: float, ax: float, ay: float, bx: float, by: float) -> tuple[float, float]:
    """Return the vector to a point from the point of a segment that is nearest to it."""
    dx, dy = bx - ax, by - ay
    length2 = dx * dx + dy * dy
    t = 0.0
    if length2 > 0.0:
        t = min(1.0, max(0.0, ((x - ax) * dx + (y - ay) * dy) / length2))
    return x - ax - t * dx, y - ay - t * dy


def segment_distance(point: Point, segment: Segment) -> float:
    """Return the distance from a point to a segment, metres.

    Examples
    --------
    >>> segment_distance((0.0, 3.0), ((4.0, 0.0), (8.0, 0.0)))
    5.0
    """
    (ax, ay), (bx, by) = segment
    return hypot(*offset_from_segment(point[0], point[1], ax, ay, bx, by))


def turned(x: float, y: float, degrees: float) -> Point:
    """Return a vector turned counter-clockwise.

    Examples
    --------
    >>> turned(2.0, 0.0, 180.0)[0]
    -2.0
    """
    c, s = cos(radians(degrees)), sin(radians(degrees))
    return c * x - s * y, s * x + c * y
