"""Rasters over a plan: which cells' centres a shape holds."""

from dataclasses import dataclass

import numpy as np
import shapely
from shapely.geometry.base import BaseGeometry

from mansion_geometry.compiled import Bools, Floats

__all__ = ["Raster", "raster_over", "ring_mask"]


@dataclass(frozen=True)
class Raster:
    """A grid of square cells.

    Attributes
    ----------
    x0, y0 : float
        Lower left corner, metres.
    side : float
        Edge of a cell, metres.
    rows, columns : int
    """

    x0: float
    y0: float
    side: float
    rows: int
    columns: int

    def centres(self) -> tuple[Floats, Floats]:
        """Return x and y of all cell centres, each of shape (rows, columns)."""
        x = self.x0 + (np.arange(self.columns) + 0.5) * self.side
        y = self.y0 + (np.arange(self.rows) + 0.5) * self.side
        grid_x, grid_y = np.meshgrid(x, y)
        return grid_x, grid_y

    def mask(self, shape: BaseGeometry) -> Bools:
        """Return which cells have their centre inside `shape`, as (rows, columns) of bool."""
        if shape.is_empty:
            return np.zeros((self.rows, self.columns), dtype=bool)
        shapely.prepare(shape)
        x, y = self.centres()
        inside: Bools = shapely.contains_xy(shape, x, y)
        return inside


def raster_over(shape: BaseGeometry, cells: int = 64) -> Raster:
    """Return the raster of `cells` x `cells` squares aligned to the bounding box of `shape`.

    A cell's side is the box's longer side divided by `cells`, in both directions; the raster starts at the box's
    lower left corner (the shared raster-space protocol of the supplement's A.1).
    """
    x0, y0, x1, y1 = shape.bounds
    return Raster(x0, y0, max(x1 - x0, y1 - y0) / cells, cells, cells)


def ring_mask(ring: Floats, xs: Floats, ys: Floats) -> Bools:
    """Return which points of a grid lie in a ring (even-odd rule), as (rows, columns) of bool.

    Parameters
    ----------
    ring : (n, 2) array
    xs, ys : array
        Of the columns and of the rows.
    """
    inside = np.zeros((len(ys), len(xs)), dtype=bool)
    for (ax, ay), (bx, by) in zip(ring, np.roll(ring, -1, axis=0)):
        if ay != by:
            rows = (ay > ys) != (by > ys)
            cross = (bx - ax) * (ys - ay) / (by - ay) + ax
            inside ^= rows[:, None] & (xs[None, :] < cross[:, None])
    return inside
