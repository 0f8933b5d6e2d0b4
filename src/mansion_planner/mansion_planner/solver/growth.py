"""Growth of one local candidate inside a parent's region: rectangles, then L-shapes, then filling."""

import numpy as np

from mansion_planner.solver.cleaning import FREE, clean, fill
from mansion_planner.solver.jit import kernel
from mansion_planner.solver.state import AREA, CX, CY, Floats, Ints

__all__ = ["grow"]

OVERSHOOT = 1.08


@kernel
def _plant(geometry: Floats, work: Ints, seeds: Floats, bounds: Ints, area: Floats) -> bool:
    """Give each child the free cell nearest its seed; return whether all found one."""
    rows, columns = work.shape
    for k in range(seeds.shape[0]):
        best_j, best_i, nearest = -1, -1, 1e18
        for j in range(1, rows - 1):
            for i in range(1, columns - 1):
                if work[j, i] == FREE:
                    dx = geometry[j, i, CX] - seeds[k, 0]
                    dy = geometry[j, i, CY] - seeds[k, 1]
                    d = dx * dx + dy * dy
                    if d < nearest:
                        best_j, best_i, nearest = j, i, d
        if best_j < 0:
            return False
        work[best_j, best_i] = k
        area[k] = geometry[best_j, best_i, AREA]
        bounds[k, 0], bounds[k, 1] = best_j, best_j + 1
        bounds[k, 2], bounds[k, 3] = best_i, best_i + 1
    return True


@kernel
def _strip(bounds: Ints, k: int, side: int) -> tuple[int, int, int, int]:
    """Return the row and column range of the strip beyond side 0 to 3 (north, east, south, west)."""
    j0, j1, i0, i1 = bounds[k, 0], bounds[k, 1], bounds[k, 2], bounds[k, 3]
    if side == 0:
        return j1, j1 + 1, i0, i1
    if side == 1:
        return j0, j1, i1, i1 + 1
    if side == 2:
        return j0 - 1, j0, i0, i1
    return j0, j1, i0 - 1, i0


@kernel
def _hungriest(area: Floats, targets: Floats, done: Ints) -> int:
    """Return the child that lacks most of its target, or -1."""
    best = -1
    for k in range(targets.size):
        if done[k] == 0 and (best < 0 or area[k] * targets[best] < area[best] * targets[k]):
            best = k
    return best


@kernel
def _grow_rectangles(
    xs: Floats, ys: Floats, geometry: Floats, work: Ints, targets: Floats, bounds: Ints, area: Floats
) -> None:
    """Push out whole sides of the rectangles, the hungriest room first, the side that keeps it squarest."""
    done = np.zeros(targets.size, np.int64)
    while True:
        k = _hungriest(area, targets, done)
        if k < 0:
            return
        best, best_cost, best_gain = -1, 1e18, 0.0
        for side in range(4):
            j0, j1, i0, i1 = _strip(bounds, k, side)
            gain, ok = 0.0, True
            for j in range(j0, j1):
                for i in range(i0, i1):
                    if work[j, i] != FREE:
                        ok = False
                    gain += geometry[j, i, AREA]
            if not ok or area[k] + gain > OVERSHOOT * targets[k]:
                continue
            high = ys[max(j1, bounds[k, 1])] - ys[min(j0, bounds[k, 0])]
            wide = xs[max(i1, bounds[k, 3])] - xs[min(i0, bounds[k, 2])]
            cost = max(high / wide, wide / high)
            if cost < best_cost:
                best, best_cost, best_gain = side, cost, gain
        if best < 0:
            done[k] = 1
            continue
        j0, j1, i0, i1 = _strip(bounds, k, best)
        work[j0:j1, i0:i1] = k
        area[k] += best_gain
        bounds[k, 0], bounds[k, 1] = min(bounds[k, 0], j0), max(bounds[k, 1], j1)
        bounds[k, 2], bounds[k, 3] = min(bounds[k, 2], i0), max(bounds[k, 3], i1)


@kernel
def _longest_run(work: Ints, xs: Floats, ys: Floats, k: int, run: Ints) -> float:
    """Find the longest straight run of free cells along child k; write line, begin, end and orientation to `run`."""
    rows, columns = work.shape
    longest = 0.0
    for way in range(4):
        along_x = way < 2
        back = 1 if way % 2 == 0 else -1
        lines = rows if along_x else columns
        steps = columns if along_x else rows
        for u in range(1, lines - 1):
            begin = -1
            for v in range(1, steps):
                if along_x:
                    ok = work[u, v] == FREE and work[u - back, v] == k
                else:
                    ok = work[v, u] == FREE and work[v, u - back] == k
                if ok and begin < 0:
                    begin = v
                if not ok and begin >= 0:
                    length = xs[v] - xs[begin] if along_x else ys[v] - ys[begin]
                    if length > longest + 1e-9:
                        longest = length
                        run[0], run[1], run[2], run[3] = u, begin, v, int(along_x)
                    begin = -1
    return longest


@kernel
def _grow_ells(xs: Floats, ys: Floats, geometry: Floats, work: Ints, targets: Floats, area: Floats) -> None:
    """Let rooms that are still too small grow along their longest free side, which makes them L-shaped."""
    done = np.zeros(targets.size, np.int64)
    run = np.zeros(4, np.int64)
    while True:
        k = _hungriest(area, targets, done)
        if k < 0:
            return
        if area[k] >= 0.97 * targets[k] or _longest_run(work, xs, ys, k, run) <= 0.0:
            done[k] = 1
            continue
        gain = 0.0
        for v in range(run[1], run[2]):
            gain += geometry[run[0], v, AREA] if run[3] == 1 else geometry[v, run[0], AREA]
        if area[k] + gain > 1.25 * targets[k]:
            done[k] = 1
            continue
        for v in range(run[1], run[2]):
            if run[3] == 1:
                work[run[0], v] = k
            else:
                work[v, run[0]] = k
        area[k] += gain


@kernel
def grow(xs: Floats, ys: Floats, geometry: Floats, work: Ints, seeds: Floats, targets: Floats, vanishes: bool) -> bool:
    """Grow one candidate in place; False when there are fewer cells than children.

    Parameters
    ----------
    work : (rows, columns) int array
        FREE in the parent's region, OTHER elsewhere.
    seeds, targets : (children, 2), (children,) arrays
    vanishes : bool
        The parent keeps nothing: its whole region goes to the children.
    """
    children = targets.size
    bounds = np.zeros((children, 4), np.int64)
    area = np.zeros(children)
    if not _plant(geometry, work, seeds, bounds, area):
        return False
    _grow_rectangles(xs, ys, geometry, work, targets, bounds, area)
    _grow_ells(xs, ys, geometry, work, targets, area)
    fill(work, geometry, children, not vanishes)
    clean(work, geometry, children, not vanishes)
    return True
