"""The floor that an object takes from the robot."""

from math import cos, radians, sin

from shapely.geometry import Polygon

from mansion_msgs_py.scene import SceneObject

__all__ = ["footprint", "oblique_margin"]


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
