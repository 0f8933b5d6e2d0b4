"""The robot and its world as ROS 2 messages, written as dictionaries of their fields (REP-103, REP-105).

Names and contents follow the topics of the skill server; everything is in the frame ``map``, where each floor has its
elevation.
"""

from collections.abc import Sequence
from math import cos, radians, sin
from typing import Any

from mansion_geometry.floor_grid import RESOLUTION
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.world import Pose2D
from mansion_skills.world.world import World

__all__ = ["MAP", "header", "image", "nanoseconds", "occupancy_grid", "path", "pose_stamped", "stamp", "transform"]

MAP = "map"
"""The fixed frame."""

_SECOND = 1_000_000_000


def nanoseconds(seconds: float) -> int:
    """Return a time of the world's clock as MCAP has it."""
    return round(seconds * _SECOND)


def stamp(seconds: float) -> dict[str, int]:
    """Return ``builtin_interfaces/Time``."""
    whole, rest = divmod(nanoseconds(seconds), _SECOND)
    return {"sec": whole, "nanosec": rest}


def header(seconds: float, frame: str = MAP) -> dict[str, Any]:
    """Return ``std_msgs/Header``."""
    return {"stamp": stamp(seconds), "frame_id": frame}


def pose_stamped(seconds: float, pose: Pose2D, z: float) -> dict[str, Any]:
    """Return ``geometry_msgs/PoseStamped`` of a planar pose at a height."""
    return {"header": header(seconds), "pose": _pose(pose, z)}


def transform(seconds: float, child: str, pose: Pose2D, z: float, parent: str = MAP) -> dict[str, Any]:
    """Return ``geometry_msgs/TransformStamped``."""
    translation = {"x": pose.x, "y": pose.y, "z": z}
    return {
        "header": header(seconds, parent),
        "child_frame_id": child,
        "transform": {"translation": translation, "rotation": _heading(pose.yaw)},
    }


def path(seconds: float, points: Sequence[Point], z: float) -> dict[str, Any]:
    """Return ``nav_msgs/Path`` along a polyline."""
    poses = [pose_stamped(seconds, Pose2D(x=x, y=y), z) for x, y in points]
    return {"header": header(seconds), "poses": poses}


def occupancy_grid(seconds: float, world: World, floor: int) -> dict[str, Any]:
    """Return ``nav_msgs/OccupancyGrid`` of a floor as its doors and objects are now."""
    grid = world.view(floor).map
    origin = _pose(Pose2D(x=grid.frame.x0, y=grid.frame.y0), world.building.entry(floor).elevation)
    info = {
        "map_load_time": stamp(seconds),
        "resolution": RESOLUTION,
        "width": grid.frame.columns,
        "height": grid.frame.rows,
        "origin": origin,
    }
    return {"header": header(seconds), "info": info, "data": grid.occupancy().ravel().tolist()}


def image(seconds: float, data: bytes, kind: str, frame: str) -> dict[str, Any]:
    """Return ``sensor_msgs/CompressedImage``; `kind` is ``png`` or ``jpeg``."""
    return {"header": header(seconds, frame), "format": kind, "data": data}


def _pose(pose: Pose2D, z: float) -> dict[str, Any]:
    return {"position": {"x": pose.x, "y": pose.y, "z": z}, "orientation": _heading(pose.yaw)}


def _heading(degrees: float) -> dict[str, float]:
    half = radians(degrees) / 2
    return {"x": 0.0, "y": 0.0, "z": sin(half), "w": cos(half)}
