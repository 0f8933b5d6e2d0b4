"""Rasters of shapes: the cells of a grid whose centres lie in a shape."""

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from mansion_geometry.compiled import Bools, Floats
from mansion_geometry.floor_grid import GridFrame

__all__ = ["cells_in", "raster_over", "ring_mask"]


def cells_in(shape: BaseGeometry, frame: GridFrame) -> Bools:
    """Return which cells have their centre inside `shape`, as (rows, columns) of bool."""
    if shape.is_empty:
        return np.zeros(frame.shape, dtype=bool)
    shapely.prepare(shape)
    inside: Bools = shapely.contains_xy(shape, *np.meshgrid(*frame.centers()))
    return inside


def raster_over(shape: BaseGeometry, cells: int = 64) -> GridFrame:
    """Return the frame of `cells` x `cells` squares aligned to the bounding box of `shape`.

    A cell's side is the box's longer side divided by `cells`, in both directions; the frame starts at the box's
    lower left corner (the shared raster-space protocol of the supplement's A.1).
    """
    x0, y0, x1, y1 = shape.bounds
    return GridFrame(x0, y0, max(x1 - x0, y1 - y0) / cells, cells, cells)


def ring_mask(ring: Floats, xs: Floats, ys: Floats) -> Bools:
    """Return which points of a grid lie in a ring (even-odd rule), as (rows, columns) of bool.

    Parameters
    ----------
    ring : (n, 2) array
    xs, ys : array
        Centres of the columns and of the rows.
    """
    inside = np.zeros((len(ys), len(xs)), dtype=bool)
    for (ax, ay), (bx, by) in zip(ring, np.roll(ring, -1, axis=0)):
        if ay != by:
            rows = (ay > ys) != (by > ys)
            cross = (bx - ax) * (ys - ay) / (by - ay) + ax
            inside ^= rows[:, None] & (xs[None, :] < cross[:, None])
    return inside
