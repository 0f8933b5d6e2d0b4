"""Distances to the boxes in which objects stand."""

from math import cos, hypot, radians, sin

from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point, Segment
from mansion_msgs_py.world import ObjectState

__all__ = ["box_distance", "corners", "segment_distance"]


def box_distance(point: Point, state: ObjectState, kind: SceneObject) -> float:
    """Return the plan distance from a point to an object's box, metres; 0 inside."""
    assert state.position is not None
    dx, dy = point[0] - state.position[0], point[1] - state.position[1]
    c, s = cos(radians(state.rotation)), sin(radians(state.rotation))
    across, along = abs(c * dx + s * dy) - kind.size[0] / 2, abs(c * dy - s * dx) - kind.size[1] / 2
    return hypot(max(across, 0.0), max(along, 0.0))


def corners(state: ObjectState, kind: SceneObject, scale: float = 1.0) -> list[Point]:
    """Return the corners of an object's box in plan, scaled about its centre."""
    assert state.position is not None
    x, y, _ = state.position
    c, s = cos(radians(state.rotation)), sin(radians(state.rotation))
    a, b = scale * kind.size[0] / 2, scale * kind.size[1] / 2
    return [(x + c * u - s * v, y + s * u + c * v) for u, v in ((-a, -b), (a, -b), (a, b), (-a, b))]


def segment_distance(point: Point, segment: Segment) -> float:
    """Return the distance from a point to a segment, metres."""
    (ax, ay), (bx, by) = segment
    dx, dy = bx - ax, by - ay
    length2 = dx * dx + dy * dy
    t = 0.0
    if length2 > 0.0:
        t = min(1.0, max(0.0, ((point[0] - ax) * dx + (point[1] - ay) * dy) / length2))
    return hypot(point[0] - ax - t * dx, point[1] - ay - t * dy)
