"""The robot's body, and the floor that objects take from it: the one place where their sizes stand."""

from math import cos, radians, sin
from typing import Final

from shapely.geometry import Polygon

from mansion_msgs_py.scene import SceneObject

__all__ = ["BODY_RADIUS", "ROBOT_RADIUS", "footprint", "oblique_margin"]

ROBOT_RADIUS: Final = 0.20
"""Of the disc that the robot covers, metres."""

BODY_RADIUS: Final = ROBOT_RADIUS - 1e-3
"""What a way must be wide enough for on both sides, metres: the robot, less the rounding of coordinates."""


def footprint(item: SceneObject) -> Polygon:
    """Return the rectangle that an object covers on the floor."""
    x, y, _ = item.position
    half_w, half_d = item.size[0] / 2, item.size[1] / 2
    turn = radians(item.rotation)
    c, s = cos(turn), sin(turn)
    corners = ((-half_w, -half_d), (half_w, -half_d), (half_w, half_d), (-half_w, half_d))
    return Polygon([(x + u * c - v * s, y + u * s + v * c) for u, v in corners])


def oblique_margin(item: SceneObject) -> float:
    """Return what a way past an object must be wider, metres: the skills' grid of 0.05 m is coarser along a slant."""
    turn = item.rotation % 90.0
    return 0.021 if min(turn, 90.0 - turn) > 0.5 else 0.0
