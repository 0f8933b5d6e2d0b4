"""Distances to the boxes in which objects stand."""

from math import hypot

from mansion_geometry.object_footprints import footprint_corners, footprint_distance
from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point, Segment
from mansion_msgs_py.world import ObjectState

__all__ = ["box_distance", "corners", "segment_distance"]


def box_distance(point: Point, state: ObjectState, kind: SceneObject) -> float:
    """Return the plan distance from a point to an object's box, metres; 0 inside."""
    assert state.position is not None
    return footprint_distance(point, state.position, kind.size, state.rotation)


def corners(state: ObjectState, kind: SceneObject, scale: float = 1.0) -> list[Point]:
    """Return the corners of an object's box in plan, scaled about its centre."""
    assert state.position is not None
    return footprint_corners(state.position, kind.size, state.rotation, scale=scale)


def segment_distance(point: Point, segment: Segment) -> float:
    """Return the distance from a point to a segment, metres."""
    (ax, ay), (bx, by) = segment
    dx, dy = bx - ax, by - ay
    length2 = dx * dx + dy * dy
    t = 0.0
    if length2 > 0.0:
        t = min(1.0, max(0.0, ((point[0] - ax) * dx + (point[1] - ay) * dy) / length2))
    return hypot(point[0] - ax - t * dx, point[1] - ay - t * dy)
