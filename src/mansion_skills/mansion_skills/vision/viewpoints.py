"""From where a lift or a stair is seen best: before its door, as far away as its surroundings let a robot stand."""

from math import atan2, cos, degrees, hypot, radians, sin
from typing import Final

from mansion_msgs_py.scene import SceneCore
from mansion_skills.navigation.floor_map import FloorMap

__all__ = ["FARTHEST", "core_viewpoint"]

FARTHEST: Final = 1.4
"""Metres from the standard pose: from there door and sign fill the height of a panorama."""

STEP: Final = 0.1
FAN: Final = (0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0)
"""Directions that are tried, degrees from straight ahead; among equals the first counts."""


def core_viewpoint(grid: FloorMap, core: SceneCore, farthest: float = FARTHEST) -> tuple[float, float, float]:
    """Return a place from which the door of a core is in view, and the direction of the door.

    The way from the core's standard pose is free and stays in its room, so nothing that stands there hides the door; of
    such places it is the farthest, one straight ahead before one aside.

    Parameters
    ----------
    grid : FloorMap
        Of the floor.
    core : SceneCore
    farthest : float
        Metres from the core's standard pose.

    Returns
    -------
    x, y, yaw : float
        Metres and degrees.
    """
    x0, y0, outward = core.entrance
    room = grid.room_at(x0, y0)

    def stands(x: float, y: float) -> bool:
        return grid.is_free(x, y) and grid.room_at(x, y) == room

    best, found = 0.0, (x0, y0)
    for aside in FAN:
        turn = radians(outward + aside)
        away = 0.0
        while away < farthest - 1e-9 and stands(x0 + (away + STEP) * cos(turn), y0 + (away + STEP) * sin(turn)):
            away += STEP
        # Obliquely a door looks narrower; beyond the square of the cosine its sign cannot be read.
        worth = away * cos(radians(aside)) ** 2
        if worth > best + 1e-9:
            best, found = worth, (x0 + away * cos(turn), y0 + away * sin(turn))
    x, y = found
    dx, dy = _door(grid, core)
    if hypot(dx - x, dy - y) < 1e-6:
        return x, y, outward + 180.0
    return x, y, degrees(atan2(dy - y, dx - x))


def _door(grid: FloorMap, core: SceneCore) -> tuple[float, float]:
    """Return the middle of a core's door; without one, a step into the core."""
    for door in grid.scene.doors:
        if door.id == core.door:
            (ax, ay), (bx, by) = door.segment
            return (ax + bx) / 2, (ay + by) / 2
    x, y, yaw = core.entrance
    return x - cos(radians(yaw)), y - sin(radians(yaw))
