"""Panoramas: the viewpoint of a lift or a stair, and views of one place stitched on to a cylinder."""

from collections.abc import Sequence
from functools import lru_cache
from math import atan2, cos, degrees, hypot, pi, radians, sin
from typing import Final

import numpy as np

from mansion_geometry.compiled import Floats, Ints
from mansion_msgs_py.scene import SceneCore
from mansion_skills.navigation.floor_map import FloorMap
from mansion_skills.vision.frame import Intrinsics, Picture

__all__ = ["FARTHEST", "HEIGHT", "VIEW", "VIEWS", "WIDTH", "core_viewpoint", "stitch", "view_yaws"]

FARTHEST: Final = 1.4
"""Metres from the standard pose: from there door and sign fill the height of a panorama."""

STEP: Final = 0.1
FAN: Final = (0.0, 15.0, -15.0, 30.0, -30.0, 45.0, -45.0)
"""Directions that are tried, degrees from straight ahead; among equals the first counts."""

VIEWS = 6
"""Views of a round."""

VIEW = Intrinsics(400, 400, 90.0)
"""The camera of a view."""

WIDTH, HEIGHT = 1024, 256
"""Size of a panorama, pixels."""

SLOPE = HEIGHT * pi / WIDTH
"""Tangent of the highest direction; so pixels are as high as they are wide in the middle."""


def core_viewpoint(grid: FloorMap, core: SceneCore, farthest: float = FARTHEST) -> tuple[float, float, float]:
    """Return a place from which the door of a core is in view, and the direction of the door.

    The way from the core's standard pose is free and stays in its room, so nothing that stands there hides the door; of
    such places it is the farthest, one straight ahead before one aside.

    Parameters
    ----------
    grid : FloorMap
        The floor's grids.
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
        score = away * cos(radians(aside)) ** 2
        if score > best + 1e-9:
            best, found = score, (x0 + away * cos(turn), y0 + away * sin(turn))
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


def view_yaws(middle: float) -> list[float]:
    """Return the directions of the views, degrees, clockwise; the panorama's middle looks along `middle`."""
    return [middle + 180.0 - (i + 0.5) * 360.0 / VIEWS for i in range(VIEWS)]


def stitch(views: Sequence[Picture]) -> Picture:
    """Project views on to a cylinder.

    Parameters
    ----------
    views : sequence of (400, 400, 3) arrays
        Views in the directions of `view_yaws`.

    Returns
    -------
    (256, 1024, 3) array of uint8
        The full circle from left to right, clockwise as one turns to the right.
    """
    view, corner, weight = _map()
    stack = np.stack(views)
    rows, columns = corner
    down, right = weight
    blended = np.zeros((*view.shape, 3))
    for dy, wy in ((0, 1.0 - down), (1, down)):
        for dx, wx in ((0, 1.0 - right), (1, right)):
            blended += (wy * wx)[..., None] * stack[view, rows + dy, columns + dx]
    picture: Picture = np.round(blended).astype(np.uint8)
    return picture


@lru_cache(maxsize=1)
def _map() -> tuple[Ints, tuple[Ints, Ints], tuple[Floats, Floats]]:
    """Return for each pixel its view, the upper left of the four pixels that it lies between, and where between."""
    column = (np.arange(WIDTH) + 0.5) / WIDTH
    slope = SLOPE * (1.0 - 2.0 * (np.arange(HEIGHT) + 0.5) / HEIGHT)
    view = np.minimum((column * VIEWS).astype(np.int64), VIEWS - 1)
    aside = 2 * pi * (column - (view + 0.5) / VIEWS)
    cx, cy = VIEW.center
    x = np.broadcast_to(cx + VIEW.focal * np.tan(aside), (HEIGHT, WIDTH))
    y = cy - VIEW.focal * slope[:, None] / np.cos(aside)
    left = np.clip(np.floor(x), 0, VIEW.width - 2).astype(np.int64)
    top = np.clip(np.floor(y), 0, VIEW.height - 2).astype(np.int64)
    return (
        np.broadcast_to(view, (HEIGHT, WIDTH)),
        (top, left),
        (np.clip(y - top, 0.0, 1.0), np.clip(x - left, 0.0, 1.0)),
    )
