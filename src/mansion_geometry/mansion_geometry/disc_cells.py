"""Cells of a floor grid where a disc robot cannot be, and those that it reaches."""

from collections.abc import Sequence
from math import hypot

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import kernel
from mansion_geometry.floor_grid import GridFrame
from mansion_geometry.free_cells import flood_fill, stamp
from mansion_msgs_py.shapes import Segment

__all__ = ["inflate", "near_boxes", "region_of", "segment_boxes", "stamp_disc"]

Floats = npt.NDArray[np.float64]
Mask = npt.NDArray[np.bool_]


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
