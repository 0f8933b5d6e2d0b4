"""Kernels on the floor grid: clearance, the best place of a room, A*, straight lines and rays."""

import heapq
import math

import numpy as np
import numpy.typing as npt

from mansion_geometry.compiled import kernel

__all__ = ["NO_CELL", "astar", "best_cells", "cast_rays", "clearance", "line_is_free", "nearest_free", "sees"]

Mask = npt.NDArray[np.bool_]
Ints = npt.NDArray[np.int64]
Floats = npt.NDArray[np.float64]

NO_CELL = -1
_SQRT2 = math.sqrt(2.0)


@kernel
def clearance(blocked: Mask) -> npt.NDArray[np.int32]:
    """Return each cell's chamfer distance (3 straight, 4 diagonal) to the nearest blocked one.

    Two passes over the grid suffice: the first brings distances from above and the left, the second from below and the
    right.

    Notes
    -----
    G. Borgefors, Distance transformations in digital images, 1986.
    """
    rows, columns = blocked.shape
    far = np.int32(1 << 28)
    d = np.empty((rows, columns), dtype=np.int32)
    for r in range(rows):
        for c in range(columns):
            best = np.int32(0) if blocked[r, c] else far
            if r > 0:
                best = min(best, d[r - 1, c] + 3)
                if c > 0:
                    best = min(best, d[r - 1, c - 1] + 4)
                if c + 1 < columns:
                    best = min(best, d[r - 1, c + 1] + 4)
            if c > 0:
                best = min(best, d[r, c - 1] + 3)
            d[r, c] = best
    for r in range(rows - 1, -1, -1):
        for c in range(columns - 1, -1, -1):
            best = d[r, c]
            if r + 1 < rows:
                best = min(best, d[r + 1, c] + 3)
                if c > 0:
                    best = min(best, d[r + 1, c - 1] + 4)
                if c + 1 < columns:
                    best = min(best, d[r + 1, c + 1] + 4)
            if c + 1 < columns:
                best = min(best, d[r, c + 1] + 3)
            d[r, c] = best
    return d


@kernel
def best_cells(rooms: npt.NDArray[np.int16], distance: npt.NDArray[np.int32], reached: Mask, count: int) -> Ints:
    """Return, for rooms 1 to `count`, the index of the cell with the most free space, reached ones first.

    A room without a cell gets `NO_CELL`.
    """
    rows, columns = rooms.shape
    best = np.full(count + 1, -1, dtype=np.int64)
    found = np.full(count + 1, -1, dtype=np.int64)
    for r in range(rows):
        for c in range(columns):
            room = rooms[r, c]
            if room == 0:
                continue
            # More than any distance, so that a reached cell wins over all others.
            score = distance[r, c] + ((1 << 20) if reached[r, c] else 0)
            if score > best[room]:
                best[room], found[room] = score, r * columns + c
    return found


@kernel
def nearest_free(blocked: Mask, row: int, column: int, reach: int) -> int:
    """Return the index of the free cell nearest to (row, column), at most `reach` cells away, or `NO_CELL`."""
    rows, columns = blocked.shape
    best, found = reach * reach + 1, -1
    for r in range(max(0, row - reach), min(rows, row + reach + 1)):
        for c in range(max(0, column - reach), min(columns, column + reach + 1)):
            away = (r - row) ** 2 + (c - column) ** 2
            if away < best and not blocked[r, c]:
                best, found = away, r * columns + c
    return found


@kernel
def astar(blocked: Mask, start: int, goal: int) -> Ints:
    """Return the cells of a shortest 8-connected path, both ends included; empty when there is none.

    Diagonal steps need both neighbours free, so that no corner is cut. Ties go to the lower cell index.

    Notes
    -----
    P. E. Hart, N. J. Nilsson and B. Raphael, A formal basis for the heuristic determination of minimum cost paths,
    1968.
    """
    rows, columns = blocked.shape
    best = np.full(rows * columns, np.inf, dtype=np.float64)
    came = np.full(rows * columns, -1, dtype=np.int64)
    closed = np.zeros(rows * columns, dtype=np.bool_)
    gr, gc = goal // columns, goal % columns
    best[start] = 0.0
    heap = [(0.0, start)]
    while len(heap) > 0:
        _, cell = heapq.heappop(heap)
        if closed[cell]:
            continue
        closed[cell] = True
        if cell == goal:
            break
        r, c = cell // columns, cell % columns
        for dr in range(-1, 2):
            for dc in range(-1, 2):
                nr, nc = r + dr, c + dc
                if (dr == 0 and dc == 0) or not (0 <= nr < rows and 0 <= nc < columns):
                    continue
                if blocked[nr, nc] or blocked[nr, c] or blocked[r, nc]:
                    continue
                step = _SQRT2 if dr != 0 and dc != 0 else 1.0
                near = nr * columns + nc
                cost = best[cell] + step
                # Sums of steps in another order differ by rounding; that is not an improvement.
                if cost < best[near] - 1e-9:
                    best[near] = cost
                    came[near] = cell
                    # The octile distance: the length of a shortest path without obstacles, hence admissible.
                    h, v = abs(nc - gc), abs(nr - gr)
                    estimate = max(h, v) + (_SQRT2 - 1.0) * min(h, v)
                    heapq.heappush(heap, (cost + estimate, near))
    if not closed[goal]:
        return np.empty(0, dtype=np.int64)
    path = [goal]
    while path[-1] != start:
        path.append(came[path[-1]])
    return np.array(path[::-1], dtype=np.int64)


@kernel
def line_is_free(blocked: Mask, r0: float, c0: float, r1: float, c1: float) -> bool:
    """Whether a segment, in cell coordinates (a cell's centre at +0.5), crosses free cells only.

    Notes
    -----
    Amanatides and Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, 1987.
    """
    rows, columns = blocked.shape
    r, c = math.floor(r0), math.floor(c0)
    end_r, end_c = math.floor(r1), math.floor(c1)
    dr, dc = r1 - r0, c1 - c0
    step_r, step_c = (1 if dr > 0 else -1), (1 if dc > 0 else -1)
    delta_r = abs(1.0 / dr) if abs(dr) > 1e-12 else 1e18
    delta_c = abs(1.0 / dc) if abs(dc) > 1e-12 else 1e18
    next_r = ((r + 1 - r0) if dr > 0 else (r0 - r)) * delta_r
    next_c = ((c + 1 - c0) if dc > 0 else (c0 - c)) * delta_c
    for _ in range(abs(end_r - r) + abs(end_c - c) + 1):
        if not (0 <= r < rows and 0 <= c < columns) or blocked[r, c]:
            return False
        if next_r < next_c:
            r, next_r = r + step_r, next_r + delta_r
        else:
            c, next_c = c + step_c, next_c + delta_c
    return 0 <= end_r < rows and 0 <= end_c < columns and not blocked[end_r, end_c]


@kernel
def cast_rays(occupied: Mask, row: float, column: float, angles: Floats, reach: float) -> Floats:
    """Return how far each ray goes before it meets an occupied cell, in cells; `reach` where it meets none.

    Parameters
    ----------
    row, column : float
        Start in cell coordinates.
    angles : (n,) array
        Radians, counter-clockwise from the direction of growing columns.
    reach : float
        Longest range, cells.

    Notes
    -----
    Amanatides and Woo, A Fast Voxel Traversal Algorithm for Ray Tracing, 1987.
    """
    rows, columns = occupied.shape
    ranges = np.full(angles.shape[0], reach, dtype=np.float64)
    for i in range(angles.shape[0]):
        dc, dr = math.cos(angles[i]), math.sin(angles[i])
        r, c = math.floor(row), math.floor(column)
        step_r, step_c = (1 if dr > 0 else -1), (1 if dc > 0 else -1)
        delta_r = abs(1.0 / dr) if abs(dr) > 1e-12 else 1e18
        delta_c = abs(1.0 / dc) if abs(dc) > 1e-12 else 1e18
        next_r = ((r + 1 - row) if dr > 0 else (row - r)) * delta_r
        next_c = ((c + 1 - column) if dc > 0 else (column - c)) * delta_c
        travelled = 0.0
        while travelled < reach:
            if next_r < next_c:
                travelled, r, next_r = next_r, r + step_r, next_r + delta_r
            else:
                travelled, c, next_c = next_c, c + step_c, next_c + delta_c
            if not (0 <= r < rows and 0 <= c < columns):
                break
            if occupied[r, c]:
                ranges[i] = min(travelled, reach)
                break
    return ranges


@kernel
def sees(
    view: npt.NDArray[np.int16], r0: float, c0: float, r1: float, c1: float, short: float, ours: npt.NDArray[np.int16]
) -> bool:
    """Whether a line of sight meets no labels but `ours`; cell coordinates, the last `short` cells left out."""
    rows, columns = view.shape
    length = math.hypot(r1 - r0, c1 - c0)
    steps = int(length * 4) + 1
    for i in range(steps + 1):
        gone = length * i / steps
        if gone > length - short:
            return True
        t = i / steps
        r, c = math.floor(r0 + t * (r1 - r0)), math.floor(c0 + t * (c1 - c0))
        if not (0 <= r < rows and 0 <= c < columns):
            return False
        label = view[r, c]
        if label != 0:
            known = False
            for k in range(ours.shape[0]):
                known = known or ours[k] == label
            if not known:
                return False
    return True
