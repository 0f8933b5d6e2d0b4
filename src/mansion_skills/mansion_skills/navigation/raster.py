"""Fill polygons and boxes into grids; cells are indexed ``[row (y), column (x)]``, values are set by cell centre."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import kernel
from mansion_msgs_py.shapes import Point

__all__ = ["GridFrame", "fill_box", "fill_ring"]

Cells = npt.NDArray[np.int16]
Floats = npt.NDArray[np.float64]


@dataclass(frozen=True)
class GridFrame:
    """Where a grid lies in the floor's frame.

    Attributes
    ----------
    x0, y0 : float
        Lower left corner of cell (0, 0), metres.
    resolution : float
        Edge of a cell, metres.
    rows, columns : int
    """

    x0: float
    y0: float
    resolution: float
    rows: int
    columns: int

    @staticmethod
    def around(points: Sequence[Point], margin: float, resolution: float) -> "GridFrame":
        """Return the frame that holds `points` with a margin, its corner on a multiple of the resolution."""
        corners = np.asarray(points, dtype=float)
        low = np.floor((corners.min(0) - margin) / resolution)
        high = np.ceil((corners.max(0) + margin) / resolution)
        return GridFrame(
            x0=round(float(low[0]) * resolution, 9),
            y0=round(float(low[1]) * resolution, 9),
            resolution=resolution,
            rows=int(high[1] - low[1]),
            columns=int(high[0] - low[0]),
        )

    def cell(self, x: float, y: float) -> tuple[int, int]:
        """Return row and column of the cell that holds a point; they may lie outside."""
        row = int(np.floor((y - self.y0) / self.resolution))
        return row, int(np.floor((x - self.x0) / self.resolution))

    def center(self, row: int, column: int) -> Point:
        """Return the centre of a cell, metres."""
        x = self.x0 + (column + 0.5) * self.resolution
        return round(x, 6), round(self.y0 + (row + 0.5) * self.resolution, 6)

    def holds(self, row: int, column: int) -> bool:
        """Whether the cell exists."""
        return 0 <= row < self.rows and 0 <= column < self.columns

    def array(self) -> Floats:
        """Return (x0, y0, resolution) for kernels."""
        return np.array([self.x0, self.y0, self.resolution])


@kernel
def _fill(grid: Cells, frame: Floats, ring: Floats, value: int, only: int) -> None:
    rows, columns = grid.shape
    x0, y0, res = frame[0], frame[1], frame[2]
    low = max(0, int(np.floor((ring[:, 1].min() - y0) / res)) - 1)
    high = min(rows, int(np.ceil((ring[:, 1].max() - y0) / res)) + 1)
    n = ring.shape[0]
    crossings = np.empty(n, dtype=np.float64)
    for row in range(low, high):
        y = y0 + (row + 0.5) * res
        count = 0
        for i in range(n):
            j = i + 1 if i + 1 < n else 0
            ay, by = ring[i, 1], ring[j, 1]
            # Half-open, so that a vertex on the row counts for one of its edges only.
            if (ay > y) != (by > y):
                crossings[count] = ring[i, 0] + (y - ay) * (ring[j, 0] - ring[i, 0]) / (by - ay)
                count += 1
        inside = np.sort(crossings[:count])
        for k in range(0, count - 1, 2):
            first = max(0, int(np.ceil((inside[k] - x0) / res - 0.5)))
            last = min(columns - 1, int(np.ceil((inside[k + 1] - x0) / res - 0.5)) - 1)
            for column in range(first, last + 1):
                if only < 0 or grid[row, column] == only:
                    grid[row, column] = value


def fill_ring(grid: Cells, frame: GridFrame, ring: Sequence[Point], value: int, only: int = -1) -> None:
    """Set the cells whose centres lie in a ring (even-odd rule), or of these just those that are `only`."""
    if len(ring) >= 3:
        _fill(grid, frame.array(), np.asarray(ring, dtype=np.float64), value, only)


def fill_box(
    grid: Cells, frame: GridFrame, center: Point, size: tuple[float, float], rotation: float, value: int, only: int = -1
) -> None:
    """Set the cells whose centres lie in a rotated box; a thin one still fills a cell's width."""
    angle = np.radians(rotation)
    c, s = float(np.cos(angle)), float(np.sin(angle))
    a = max(size[0], frame.resolution) / 2 + 1e-6
    b = max(size[1], frame.resolution) / 2 + 1e-6
    corners = [(-a, -b), (a, -b), (a, b), (-a, b)]
    ring = [(center[0] + c * u - s * v, center[1] + s * u + c * v) for u, v in corners]
    fill_ring(grid, frame, ring, value, only)
