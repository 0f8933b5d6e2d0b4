"""The floor grid: a storey as square cells, what is drawn into it, and where a disc robot gets in it.

Nav2's map, the map that robots drive on and AI2-THOR's positions are such grids. Each chooses its resolution, what it
draws and how it grows that by the robot's radius; a `GridFrame` says where the cells lie, and arrays of shape (rows,
columns) say what is in them, indexed ``[row (y), column (x)]``, row 0 at the lowest y. A cell belongs to what holds its
centre. Open-RMF's lanes and the check need no cells: for them `mansion_geometry.floor_regions` has the same floor as
exact polygons.
"""

from collections.abc import Sequence
from dataclasses import dataclass
from math import atan2, cos, degrees, floor, hypot, radians, sin
from typing import Final

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import kernel
from mansion_geometry.free_cells import flood_fill, stamp
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Point, Ring, Segment

__all__ = [
    "FREE",
    "OCCUPIED",
    "RESOLUTION",
    "UNKNOWN",
    "GridFrame",
    "fill_box",
    "fill_rings",
    "fill_strip",
    "inflate",
    "map_frame",
    "near_boxes",
    "region_of",
    "segment_boxes",
    "stamp_disc",
]

Cells = npt.NDArray[np.int16]
Floats = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]

FREE, OCCUPIED, UNKNOWN = 0, 100, -1
"""Values of ``nav_msgs/OccupancyGrid``."""

RESOLUTION: Final = 0.05
"""Edge of a cell of the maps that are driven on, metres."""

MARGIN: Final = 0.5
"""Width of the border around the building, metres."""

_EDGE: Final = 1e-6
"""By how much a box is grown, so that a cell whose centre is on its edge is in it; metres."""


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


# Compiled: numpy would test every cell of a window against every edge, where one row's crossings tell all its cells.
@kernel
def _fill(
    grid: Cells, x0: float, y0: float, resolution: float, edges: Floats, value: int, only: int, whatever: bool
) -> None:
    """Set the cells whose centres lie between edges (even-odd rule): `whatever` they are, or those that are `only`."""
    rows, columns = grid.shape
    low = max(0, int(np.floor((edges[:, 1].min() - y0) / resolution)) - 1)
    high = min(rows, int(np.ceil((edges[:, 1].max() - y0) / resolution)) + 1)
    crossings = np.empty(edges.shape[0], dtype=np.float64)
    for row in range(low, high):
        y = y0 + (row + 0.5) * resolution
        count = 0
        for k in range(edges.shape[0]):
            ax, ay, bx, by = edges[k]
            # Half-open, so that a vertex on the row counts for one of its edges only.
            if (ay > y) != (by > y):
                crossings[count] = ax + (y - ay) * (bx - ax) / (by - ay)
                count += 1
        inside = np.sort(crossings[:count])
        for k in range(0, count - 1, 2):
            first = max(0, int(np.ceil((inside[k] - x0) / resolution - 0.5)))
            last = min(columns - 1, int(np.ceil((inside[k + 1] - x0) / resolution - 0.5)) - 1)
            for column in range(first, last + 1):
                if whatever or grid[row, column] == only:
                    grid[row, column] = value


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
        _fill(grid, frame.x0, frame.y0, frame.resolution, edges, value, only or 0, only is None)


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
    _fill(grid, frame.x0, frame.y0, frame.resolution, edges, value, only or 0, only is None)


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


def near_boxes(frame: GridFrame, boxes: Floats, radius: float) -> Mask:
    """Return the cells whose centres are nearer to a box than `radius`: where the centre of a disc robot cannot be.

    This is the exact distance. `inflate` grows what is drawn already, by half a cell more or less.

    Parameters
    ----------
    frame : GridFrame
    boxes : (n, 6) array
        Turned rectangles as in `mansion_geometry.boxes`.
    radius : float
        Metres.
    """
    counts = np.zeros(frame.shape, dtype=np.int16)
    stamp(counts, frame.x0, frame.y0, frame.resolution, boxes, radius, 1)
    near: Mask = counts > 0
    return near


def segment_boxes(segments: Sequence[Segment]) -> Floats:
    """Return segments as boxes without depth, shape (n, 6) (see `mansion_geometry.boxes`)."""
    rows = []
    for (ax, ay), (bx, by) in segments:
        length = hypot(bx - ax, by - ay)
        ux, uy = ((bx - ax) / length, (by - ay) / length) if length else (1.0, 0.0)
        rows.append(((ax + bx) / 2, (ay + by) / 2, ux, uy, length / 2, 0.0))
    return np.array(rows, dtype=np.float64).reshape(-1, 6)


# Compiled, as `inflate` is, for a disc is stamped at each cell along the edge of what is occupied.
@kernel
def stamp_disc(mask: Mask, row: float, column: float, radius: float) -> None:
    """Set the cells whose centres are nearer than `radius` to a point; all in cells, centres at integers."""
    rows, columns = mask.shape
    limit = radius * radius - 1e-9
    for r in range(max(0, int(row - radius)), min(rows, int(row + radius) + 2)):
        for c in range(max(0, int(column - radius)), min(columns, int(column + radius) + 2)):
            if (r - row) ** 2 + (c - column) ** 2 < limit:
                mask[r, c] = True


@kernel
def inflate(occupied: Mask, radius: float) -> Mask:
    """Return the cells whose centres are nearer than `radius` (in cells) to the centre of an occupied one."""
    rows, columns = occupied.shape
    blocked = occupied.copy()
    for r in range(rows):
        for c in range(columns):
            if not occupied[r, c]:
                continue
            # Discs of interior cells lie within those of the cells at the edge.
            edge = (
                (r > 0 and not occupied[r - 1, c])
                or (r + 1 < rows and not occupied[r + 1, c])
                or (c > 0 and not occupied[r, c - 1])
                or (c + 1 < columns and not occupied[r, c + 1])
            )
            if edge:
                stamp_disc(blocked, float(r), float(c), radius)
    return blocked


def region_of(blocked: Mask, row: int, column: int) -> Mask:
    """Return the 4-connected free region that holds a cell; empty where that is blocked."""
    reached = np.zeros_like(blocked)
    flood_fill(blocked, np.array([row * blocked.shape[1] + column], dtype=np.int32), reached)
    return reached
