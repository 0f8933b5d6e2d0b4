"""The robot's start pose: a reachable free position in the hub (Algorithm 1, line 17)."""

import math
from collections.abc import Sequence
from typing import Final

import numpy as np
import shapely
from shapely.geometry import LineString, Point, Polygon

from mansion_geometry.floor_regions import largest_first
from mansion_geometry.object_footprints import footprint, oblique_margin
from mansion_geometry.rings import polygon_parts
from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import Door, SceneObject, SceneRoom, SpawnPose

__all__ = ["free_region", "place_spawn"]

_GRID: Final = 0.25
_SPACIOUS: Final = 1.0  # metres of clearance that are enough
_HEADROOM: Final = 1.8  # an object that starts above this height is not an obstacle


def _is_obstacle(item: SceneObject) -> bool:
    bottom, top = item.bottom, item.top
    return item.mount in ("floor", "wall") and bottom < _HEADROOM and top > 0.05


def free_region(room: SceneRoom, objects: Sequence[SceneObject], radius: float = ROBOT_RADIUS) -> list[Polygon]:
    """Return the region where a disc robot's centre may be in a room, as connected parts, largest first."""
    net = Polygon(room.net_polygon, room.net_holes)
    mine = [item for item in objects if item.room == room.id and _is_obstacle(item)]
    boxes = [footprint(item) for item in mine]
    free = net.buffer(-radius, join_style="mitre")
    if boxes:
        free = free.difference(
            shapely.union_all(shapely.buffer(boxes, [radius + oblique_margin(item) for item in mine]))
        )
    return largest_first(polygon_parts(free))


def place_spawn(room: SceneRoom, doors: Sequence[Door], objects: Sequence[SceneObject]) -> SpawnPose:
    """Choose the start in a room: with clearance, in the part that most doors lead to, facing the longest view.

    Parameters
    ----------
    room : SceneRoom
        The hub.
    doors : sequence of Door
        Doors of the floor; those of the room count, the building's entrance first.
    objects : sequence of SceneObject
        Objects of the floor.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when furniture leaves no free position for a robot of radius 0.20 m.
    """
    own = [door for door in doors if room.id in door.rooms]
    own.sort(key=lambda door: door.kind != "entrance")
    for radius in (ROBOT_RADIUS + 0.1, ROBOT_RADIUS + 0.02):
        parts = free_region(room, objects, radius)
        if parts:
            break
    else:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"{room.id} has no free position for a robot of radius {ROBOT_RADIUS} m",
            path="$.layout.rooms",
        )
    segments = [LineString(door.segment) for door in own]
    near = radius + 0.2
    part = max(parts, key=lambda p: sum(p.distance(segment) <= near for segment in segments))
    x, y = _roomiest(part, segments[0] if segments else None)
    return SpawnPose(x=x, y=y, yaw=_longest_view(part, x, y), room=room.id)


def _roomiest(part: Polygon, entrance: LineString | None) -> tuple[float, float]:
    x0, y0, x1, y1 = part.bounds
    xs = np.arange(math.ceil(x0 / _GRID), math.floor(x1 / _GRID) + 1) * _GRID
    ys = np.arange(math.ceil(y0 / _GRID), math.floor(y1 / _GRID) + 1) * _GRID
    grid_x, grid_y = (grid.ravel() for grid in np.meshgrid(xs, ys, indexing="ij"))
    inside = shapely.contains_xy(part, grid_x, grid_y)
    if not inside.any():
        point = part.representative_point()
        return round(point.x, 3), round(point.y, 3)
    points = shapely.points(grid_x[inside], grid_y[inside])
    score = np.minimum(shapely.distance(part.boundary, points), _SPACIOUS)
    if entrance is not None:
        score = score - 0.02 * shapely.distance(entrance, points)
    best = points[int(np.argmax(np.round(score, 6)))]
    return round(float(best.x), 3), round(float(best.y), 3)


def _longest_view(part: Polygon, x: float, y: float) -> float:
    """Return the quarter turn, degrees from +x, in which the free part extends farthest."""
    here, far = Point(x, y), sum(part.bounds[2:]) - sum(part.bounds[:2])
    views = []
    for quarter in range(4):
        turn = math.pi / 2 * quarter
        ray = LineString([here, (x + far * math.cos(turn), y + far * math.sin(turn))])
        pieces = shapely.get_parts(ray.intersection(part))
        first = max((p.length for p in pieces if p.distance(here) < 1e-6), default=0.0)
        views.append((-round(first, 3), quarter))
    return 90.0 * min(views)[1]
