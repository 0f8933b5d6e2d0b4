"""The floor grid: a storey as square cells, and what is drawn into them.

Nav2's map, the map that robots drive on and AI2-THOR's positions are such grids. Each chooses its resolution, what it
draws and how it grows that by the robot's radius; a `GridFrame` says where the cells lie, and arrays of shape (rows,
columns) say what is in them, indexed ``[row (y), column (x)]``, row 0 at the lowest y. A cell belongs to what holds its
centre. `mansion_geometry.disc_cells` tells where a disc robot gets in them. Open-RMF's lanes and the check need no
cells: for them `mansion_geometry.floor_regions` has the same floor as exact polygons.
"""

import sys
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import cache
from math import atan2, ceil, cos, degrees, floor, hypot, radians, sin
from typing import Final

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.limits import MAX_CELLS
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Point, Ring, Segment

__all__ = [
    "FREE",
    "OCCUPIED",
    "RESOLUTION",
    "UNKNOWN",
    "GridFrame",
    "check_cells",
    "fill_box",
    "fill_rings",
    "fill_strip",
    "map_frame",
]

Cells = npt.NDArray[np.int16]
Floats = npt.NDArray[np.float64]

FREE, OCCUPIED, UNKNOWN = 0, 100, -1
"""Values of ``nav_msgs/OccupancyGrid``."""

RESOLUTION: Final = 0.05
"""Edge of a cell of the maps that are driven on, metres."""

MARGIN: Final = 0.5
"""Width of the border around the building, metres."""

_EDGE: Final = 1e-6
"""By how much a box is grown, so that a cell whose centre is on its edge is in it; metres."""


def check_cells(rows: int, columns: int) -> None:
    """Refuse a grid that would take minutes and gigabytes.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with the limit.
    """
    if rows * columns > MAX_CELLS:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"a grid of {rows} x {columns} cells is too large; at most {MAX_CELLS} cells are allowed",
            details={"rows": rows, "columns": columns, "limit": MAX_CELLS},
        )


@dataclass(frozen=True)
class GridFrame:
    """Where the cells of a grid lie in the plane.

    Attributes
    ----------
    x0, y0 : float
        Lower left corner of cell (0, 0), metres.
    resolution : float
        Edge of a cell, metres.
    rows, columns : int
        Cells along y and along x.

    Raises
    ------
    MansionError
        As `check_cells`.
    """

    x0: float
    y0: float
    resolution: float
    rows: int
    columns: int

    def __post_init__(self) -> None:
        check_cells(self.rows, self.columns)

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

    @staticmethod
    def through(point: Point, points: Sequence[Point], resolution: float) -> "GridFrame":
        """Return the frame with a cell's centre at every whole step from `point`, as far as `points` reach."""
        corners = np.asarray(points, dtype=float)
        low = np.floor((corners.min(0) - point) / resolution)
        high = np.ceil((corners.max(0) - point) / resolution)
        return GridFrame(
            x0=point[0] + (float(low[0]) - 0.5) * resolution,
            y0=point[1] + (float(low[1]) - 0.5) * resolution,
            resolution=resolution,
            rows=int(high[1] - low[1]) + 1,
            columns=int(high[0] - low[0]) + 1,
        )

    def refined(self, parts: int) -> "GridFrame":
        """Return the frame whose every `parts`-th row and column has its centres at those of this one."""
        shift = (self.resolution - self.resolution / parts) / 2
        return GridFrame(
            x0=self.x0 + shift,
            y0=self.y0 + shift,
            resolution=self.resolution / parts,
            rows=(self.rows - 1) * parts + 1,
            columns=(self.columns - 1) * parts + 1,
        )

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        return self.rows, self.columns

    def cell(self, x: float, y: float) -> tuple[int, int]:
        """Return row and column of the cell that holds a point; they may lie outside."""
        return floor((y - self.y0) / self.resolution), floor((x - self.x0) / self.resolution)

    def coordinates(self, x: float, y: float) -> tuple[float, float]:
        """Return a point as row and column with fractions: whole at a cell's lower left corner."""
        return (y - self.y0) / self.resolution, (x - self.x0) / self.resolution

    def center(self, row: int, column: int) -> Point:
        """Return the centre of a cell, metres."""
        x = self.x0 + (column + 0.5) * self.resolution
        return round(x, 6), round(self.y0 + (row + 0.5) * self.resolution, 6)

    def centers(self) -> tuple[Floats, Floats]:
        """Return x of all columns' centres and y of all rows', metres."""
        x = self.x0 + (np.arange(self.columns) + 0.5) * self.resolution
        return x, self.y0 + (np.arange(self.rows) + 0.5) * self.resolution

    def holds(self, row: int, column: int) -> bool:
        """Whether the cell exists."""
        return 0 <= row < self.rows and 0 <= column < self.columns

    def window(self, x: float, y: float, half: float) -> tuple[slice, slice]:
        """Return the rows and columns of the cells in a square about a point, at least `half` to each side."""
        row, column = self.cell(x, y)
        reach = int(half / self.resolution) + 1
        return (
            slice(max(0, row - reach), min(self.rows, row + reach + 1)),
            slice(max(0, column - reach), min(self.columns, column + reach + 1)),
        )


def map_frame(scene: FloorScene, resolution: float = RESOLUTION) -> GridFrame:
    """Return the frame of a storey's maps: around all that is built, with a border of `MARGIN`."""
    points: Ring = [*scene.outline, *(point for room in scene.rooms for point in room.polygon)]
    points += [point for wall in scene.walls for point in wall.segment]
    points += [point for core in scene.cores for point in core.polygon]
    return GridFrame.around(points, MARGIN, resolution)


def _fill(grid: Cells, frame: GridFrame, edges: Floats, value: int, only: int | None) -> None:
    """Set the cells whose centres lie between edges (ax, ay, bx, by), by the even-odd rule.

    Importing numba takes longer than drawing all maps of a building without it. So an export draws with numpy; what
    has loaded numba anyway, as a robot has, draws the same cells with the kernel, which is several times as fast.
    """
    if "numba" in sys.modules:
        _compiled()(grid, frame.x0, frame.y0, frame.resolution, edges, value, only or 0, only is None)
    else:
        _fill_by_numpy(grid, frame, edges, value, only)


@cache
def _compiled() -> Callable[[Cells, float, float, float, Floats, int, int, bool], None]:
    with importing:
        from mansion_geometry.free_cells import fill

    return fill


def _fill_by_numpy(grid: Cells, frame: GridFrame, edges: Floats, value: int, only: int | None) -> None:
    """Do as `mansion_geometry.free_cells.fill`: each crossing of a row toggles the cells to its right."""
    low, high = _span(frame.y0, frame.resolution, edges[:, 1], frame.rows)
    left, right = _span(frame.x0, frame.resolution, edges[:, 0], frame.columns)
    if low >= high or left >= right:
        return
    ax, ay, bx, by = edges.T
    y = frame.y0 + (np.arange(low, high) + 0.5) * frame.resolution
    # Half-open, so that a vertex on the row counts for one of its edges only.
    row, edge = np.nonzero((ay > y[:, None]) != (by > y[:, None]))
    ax, ay, bx, by = ax[edge], ay[edge], bx[edge], by[edge]
    crossing = ax + (y[row] - ay) * (bx - ax) / (by - ay)
    first = np.ceil((crossing - frame.x0) / frame.resolution - 0.5).astype(np.int64)
    width = right - left + 1
    places = row * width + np.minimum(np.maximum(first - left, 0), width - 1)
    toggles = np.bincount(places, minlength=(high - low) * width).astype(np.uint8).reshape(-1, width)
    inside = np.add.accumulate(toggles[:, :-1], axis=1, dtype=np.uint8) % 2 == 1
    there = grid[low:high, left:right]
    there[inside if only is None else inside & (there == only)] = value


def _span(origin: float, resolution: float, values: Floats, count: int) -> tuple[int, int]:
    """Return the first row or column that values can touch, and the one after the last."""
    low, high = floor((values.min() - origin) / resolution), ceil((values.max() - origin) / resolution)
    return max(0, low - 1), min(count, high + 1)


def fill_rings(
    grid: Cells, frame: GridFrame, rings: Sequence[Sequence[Point]], value: int, only: int | None = None
) -> None:
    """Set the cells whose centres lie in a polygon.

    Parameters
    ----------
    grid : (rows, columns) array of int16
    frame : GridFrame
    rings : sequence of rings
        Outline and holes in any order: a cell is inside where an odd number of them holds its centre.
    value : int
    only : int, optional
        Cells of other values stay as they are.
    """
    loops = [np.asarray(ring, dtype=np.float64) for ring in rings if len(ring) >= 3]
    if loops:
        edges = np.concatenate([np.hstack([loop, np.concatenate([loop[1:], loop[:1]])]) for loop in loops])
        _fill(grid, frame, edges, value, only)


def fill_box(
    grid: Cells,
    frame: GridFrame,
    center: Sequence[float],
    size: Sequence[float],
    rotation: float,
    value: int,
    only: int | None = None,
) -> None:
    """Set the cells whose centres lie in a turned rectangle; a thin one still fills a cell's width.

    Parameters
    ----------
    grid : (rows, columns) array of int16
    frame : GridFrame
    center, size : sequence of float
        x and y of the centre, width and depth, metres; further numbers are ignored.
    rotation : float
        Degrees counter-clockwise.
    value : int
    only : int, optional
        Cells of other values stay as they are.
    """
    c, s = cos(radians(rotation)), sin(radians(rotation))
    a = max(size[0], frame.resolution) / 2 + _EDGE
    b = max(size[1], frame.resolution) / 2 + _EDGE
    x, y = center[0], center[1]
    corners = [(x + c * u - s * v, y + s * u + c * v) for u, v in ((-a, -b), (a, -b), (a, b), (-a, b))]
    edges = np.array([(*p, *q) for p, q in zip(corners, (*corners[1:], corners[0]))])
    _fill(grid, frame, edges, value, only)


def fill_strip(
    grid: Cells,
    frame: GridFrame,
    segment: Segment,
    depth: float,
    value: int,
    *,
    longer: float = 0.0,
    only: int | None = None,
) -> None:
    """Set the cells in the strip of a `depth` along a segment, lengthened by `longer` altogether (see `fill_box`)."""
    (ax, ay), (bx, by) = segment
    size = (hypot(bx - ax, by - ay) + longer, depth)
    middle = ((ax + bx) / 2, (ay + by) / 2)
    fill_box(grid, frame, middle, size, degrees(atan2(by - ay, bx - ax)), value, only)
