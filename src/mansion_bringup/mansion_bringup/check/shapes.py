"""Payload geometry as shapely shapes."""

import math
from collections.abc import Sequence

from shapely import Polygon
from shapely.geometry.base import BaseGeometry
from shapely.ops import unary_union

from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_msgs_py.shapes import Point, Ring, Segment

__all__ = ["along", "free_region", "net_area", "room_area", "segment_length", "vertical"]


def room_area(room: SceneRoom) -> Polygon:
    """The room between wall centre lines."""
    return Polygon(room.polygon, room.holes)


def net_area(room: SceneRoom) -> Polygon:
    """The room between wall faces."""
    return Polygon(room.net_polygon, room.net_holes)


def free_region(outline: Ring, holes: Sequence[Ring], cores: Sequence[Ring]) -> BaseGeometry:
    """The floor less courtyards and cores."""
    return Polygon(outline, holes).difference(unary_union([Polygon(core) for core in cores]))


def vertical(item: SceneObject) -> tuple[float, float]:
    """Lower and upper height of the object above the finished floor."""
    return item.position[2] - item.size[2] / 2, item.position[2] + item.size[2] / 2


def segment_length(segment: Segment) -> float:
    """Length in metres."""
    return math.dist(*segment)


def along(wall: Segment, point: Point) -> tuple[float, float]:
    """Return the position of `point` along `wall` and its distance aside, both in metres."""
    (x0, y0), (x1, y1) = wall
    length = math.dist(*wall)
    ux, uy = (x1 - x0) / length, (y1 - y0) / length
    dx, dy = point[0] - x0, point[1] - y0
    return dx * ux + dy * uy, abs(dy * ux - dx * uy)
