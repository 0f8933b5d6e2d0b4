"""Stitch views of one place into a cylindrical panorama."""

from collections.abc import Sequence
from functools import lru_cache
from math import pi

import numpy as np
import numpy.typing as npt

from mansion_skills.vision.frame import Intrinsics, Picture

__all__ = ["HEIGHT", "VIEW", "VIEWS", "WIDTH", "stitch", "view_yaws"]

VIEWS = 6
"""Views of a round."""

VIEW = Intrinsics(400, 400, 90.0)
"""The camera of a view."""

WIDTH, HEIGHT = 1024, 256
"""Of a panorama, pixels."""

SLOPE = HEIGHT * pi / WIDTH
"""Tangent of the highest direction; so pixels are as high as they are wide in the middle."""


def view_yaws(middle: float) -> list[float]:
    """Return the directions of the views, degrees, clockwise; the panorama's middle looks along `middle`."""
    return [middle + 180.0 - (i + 0.5) * 360.0 / VIEWS for i in range(VIEWS)]


def stitch(views: Sequence[Picture]) -> Picture:
    """Project views on to a cylinder.

    Parameters
    ----------
    views : sequence of (400, 400, 3) arrays
        In the directions of `view_yaws`.

    Returns
    -------
    (256, 1024, 3) array of uint8
        A whole round from left to right, clockwise as one turns to the right.
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


_Ints = npt.NDArray[np.int64]
_Floats = npt.NDArray[np.float64]


@lru_cache(maxsize=1)
def _map() -> tuple[_Ints, tuple[_Ints, _Ints], tuple[_Floats, _Floats]]:
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
