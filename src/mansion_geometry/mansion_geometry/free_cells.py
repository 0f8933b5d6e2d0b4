"""Kernels on a grid of free cells: shapes, inflation of walls and boxes by a disc, flood fill, 4-connected regions.

A count is 0 where a cell is free; arrays are indexed ``[row (y), column (x)]``.
"""

import math

import numpy as np

from mansion_geometry.boxes import point_inside
from mansion_geometry.compiled import Bools, Counts, Floats, Labels, kernel
from mansion_geometry.plane import offset_from_segment

__all__ = [
    "SLACK",
    "cell_window",
    "connected_components",
    "fill",
    "flood_fill",
    "near_segment",
    "segment_distance2",
    "stamp",
    "wall_counts",
]


SLACK = 1e-9
"""Distances that differ by less are equal, metres."""


_offset = kernel(offset_from_segment)


@kernel
def segment_distance2(x: float, y: float, seg: Floats) -> float:
    """Return the squared distance of a point to a segment ``(ax, ay, bx, by)``."""
    ex, ey = _offset(x, y, seg[0], seg[1], seg[2], seg[3])
    distance2: float = ex * ex + ey * ey
    return distance2


@kernel
def fill(
    grid: Counts, x0: float, y0: float, resolution: float, edges: Floats, value: int, only: int, whatever: bool
) -> None:
    """Set the cells whose centres lie between edges (even-odd rule): `whatever` they are, or those that are `only`.

    One row's crossings tell all its cells, so that a shape costs its rows and what it covers.
    """
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


@kernel
def wall_counts(
    rows: int, cols: int, x0: float, y0: float, cell: float, edges: Floats, walls: Floats, radius: float
) -> Counts:
    """Return 1 where a cell is outside the room or nearer to a wall than `radius`, else 0."""
    counts = np.zeros((rows, cols), dtype=np.int16)
    limit = (radius - SLACK) ** 2
    for r in range(rows):
        y = y0 + (r + 0.5) * cell
        for c in range(cols):
            x = x0 + (c + 0.5) * cell
            if not point_inside(x, y, edges):
                counts[r, c] = 1
                continue
            for k in range(walls.shape[0]):
                if segment_distance2(x, y, walls[k]) < limit:
                    counts[r, c] = 1
                    break
    return counts


@kernel
def near_segment(counts: Counts, x0: float, y0: float, cell: float, segment: Floats, distance: float) -> Labels:
    """Return the flat indices of free cells at most `distance` from a segment."""
    rows, cols = counts.shape
    found = np.empty(rows * cols, dtype=np.int32)
    n = 0
    limit = (distance + SLACK) ** 2
    for r in range(rows):
        for c in range(cols):
            if counts[r, c] == 0:
                x, y = x0 + (c + 0.5) * cell, y0 + (r + 0.5) * cell
                if segment_distance2(x, y, segment) <= limit:
                    found[n] = r * cols + c
                    n += 1
    return found[:n].copy()


@kernel
def cell_window(
    box: Floats, margin: float, x0: float, y0: float, cell: float, rows: int, cols: int
) -> tuple[int, int, int, int]:
    """Return the rows and columns [r0, r1) x [c0, c1) that a box grown by `margin` can touch."""
    ex = abs(box[2]) * box[4] + abs(box[3]) * box[5] + margin
    ey = abs(box[3]) * box[4] + abs(box[2]) * box[5] + margin
    c0 = max(0, math.floor((box[0] - ex - x0) / cell))
    c1 = min(cols, math.ceil((box[0] + ex - x0) / cell) + 1)
    r0 = max(0, math.floor((box[1] - ey - y0) / cell))
    r1 = min(rows, math.ceil((box[1] + ey - y0) / cell) + 1)
    return r0, r1, c0, c1


@kernel
def stamp(counts: Counts, x0: float, y0: float, cell: float, boxes: Floats, radius: float, delta: int) -> int:
    """Add `delta` to each cell nearer to a box than `radius`; return by how many the free cells shrank."""
    rows, cols = counts.shape
    limit = (radius - SLACK) ** 2
    taken = 0
    for k in range(boxes.shape[0]):
        box = boxes[k]
        r0, r1, c0, c1 = cell_window(box, radius, x0, y0, cell, rows, cols)
        for r in range(r0, r1):
            qy = y0 + (r + 0.5) * cell - box[1]
            for c in range(c0, c1):
                qx = x0 + (c + 0.5) * cell - box[0]
                dx = max(abs(qx * box[2] + qy * box[3]) - box[4], 0.0)
                dy = max(abs(-qx * box[3] + qy * box[2]) - box[5], 0.0)
                if dx * dx + dy * dy < limit:
                    before = counts[r, c]
                    counts[r, c] = before + delta
                    if before == 0:
                        taken += 1
                    elif before + delta == 0:
                        taken -= 1
    return taken


@kernel
def flood_fill(counts: Counts | Bools, seeds: Labels, reached: Bools) -> int:
    """Mark in `reached` the free cells 4-connected to free `seeds` (flat indices); return how many there are.

    `counts` may as well be what is blocked.
    """
    rows, cols = counts.shape
    reached[:, :] = False
    stack = np.empty(rows * cols, dtype=np.int32)
    top = 0
    total = 0
    for k in range(seeds.shape[0]):
        r, c = seeds[k] // cols, seeds[k] % cols
        if counts[r, c] == 0 and not reached[r, c]:
            reached[r, c] = True
            stack[top] = seeds[k]
            top += 1
    while top > 0:
        top -= 1
        cell = stack[top]
        total += 1
        r, c = cell // cols, cell % cols
        if r > 0 and counts[r - 1, c] == 0 and not reached[r - 1, c]:
            reached[r - 1, c] = True
            stack[top] = cell - cols
            top += 1
        if r + 1 < rows and counts[r + 1, c] == 0 and not reached[r + 1, c]:
            reached[r + 1, c] = True
            stack[top] = cell + cols
            top += 1
        if c > 0 and counts[r, c - 1] == 0 and not reached[r, c - 1]:
            reached[r, c - 1] = True
            stack[top] = cell - 1
            top += 1
        if c + 1 < cols and counts[r, c + 1] == 0 and not reached[r, c + 1]:
            reached[r, c + 1] = True
            stack[top] = cell + 1
            top += 1
    return total


@kernel
def connected_components(counts: Counts) -> tuple[Labels, Labels]:
    """Label the 4-connected regions of free cells (count 0).

    Returns
    -------
    labels : (rows, cols) array
        From 1; 0 where not free.
    sizes : (k,) array
        Cells of each label.
    """
    rows, cols = counts.shape
    labels = np.zeros((rows, cols), dtype=np.int32)
    sizes = np.zeros(rows * cols // 2 + 1, dtype=np.int32)
    stack = np.empty(rows * cols, dtype=np.int32)
    count = 0
    for r0 in range(rows):
        for c0 in range(cols):
            if counts[r0, c0] != 0 or labels[r0, c0] != 0:
                continue
            count += 1
            labels[r0, c0] = count
            stack[0] = r0 * cols + c0
            top = 1
            while top > 0:
                top -= 1
                r, c = stack[top] // cols, stack[top] % cols
                sizes[count - 1] += 1
                for dr, dc in ((-1, 0), (1, 0), (0, -1), (0, 1)):
                    rr, cc = r + dr, c + dc
                    inside = 0 <= rr < rows and 0 <= cc < cols
                    if inside and counts[rr, cc] == 0 and labels[rr, cc] == 0:
                        labels[rr, cc] = count
                        stack[top] = rr * cols + cc
                        top += 1
    return labels, sizes[:count].copy()
