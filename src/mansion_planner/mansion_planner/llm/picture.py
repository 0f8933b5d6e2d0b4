"""The outline of the first floor as a PNG: the picture that goes with the program's prompt (Fig. 23)."""

import numpy as np
import shapely
from shapely.geometry import Polygon

from mansion_msgs_py.program import CorePlan
from mansion_planner.solver.preview import png_bytes

__all__ = ["outline_picture"]

_SIZE = 320
_MARGIN = 8


def outline_picture(outline: Polygon, cores: list[CorePlan]) -> bytes:
    """Return a plan, y up: the floor white on grey, its edge dark, stairs red, lifts blue.

    Examples
    --------
    >>> outline_picture(Polygon([(0, 0), (9, 0), (9, 6), (0, 6)]), [])[1:4]
    b'PNG'
    """
    x0, y0, x1, y1 = outline.bounds
    scale = (_SIZE - 2 * _MARGIN) / max(x1 - x0, y1 - y0)
    columns = int((x1 - x0) * scale) + 2 * _MARGIN
    rows = int((y1 - y0) * scale) + 2 * _MARGIN
    xs = x0 + (np.arange(columns) - _MARGIN + 0.5) / scale
    ys = y1 - (np.arange(rows) - _MARGIN + 0.5) / scale
    grid_x, grid_y = np.meshgrid(xs, ys)
    inside = shapely.contains_xy(outline, grid_x, grid_y)
    pixels = np.full((rows, columns, 3), 170, np.uint8)
    pixels[inside] = 255
    for core in cores:
        box = (grid_x > core.x[0]) & (grid_x < core.x[1]) & (grid_y > core.y[0]) & (grid_y < core.y[1])
        pixels[box & inside] = (205, 70, 60) if core.type == "stair" else (60, 90, 205)
    edge = np.zeros_like(inside)
    edge[1:] |= inside[1:] != inside[:-1]
    edge[:, 1:] |= inside[:, 1:] != inside[:, :-1]
    pixels[edge] = 20
    return png_bytes(pixels)
