"""Moves of the wall search that keep to the rooms' order: a run of wall shifts, two rooms change places.

Each move paints cells and records what it changed.
"""

from mansion_planner.solver.draws import draw
from mansion_planner.solver.jit import kernel
from mansion_planner.solver.painting import repaint
from mansion_planner.solver.state import SIZE, Bools, Floats, Ints

__all__ = ["shift_wall", "swap_rooms"]

MOST_SWAPPED = 2.0
"""Ratio of areas up to which rooms change places."""


@kernel
def _run_end(labels: Ints, free: Bools, j: int, i: int, tj: int, ti: int, sj: int, si: int, whole: bool) -> int:
    """Return how many cells the wall beside cell (j, i) goes on in direction (tj, ti).

    The wall is on side (sj, si) of the cell; with `whole` it may border several rooms.
    """
    a, b = labels[j, i], labels[j + sj, i + si]
    k = 0
    while True:
        y, x = j + (k + 1) * tj, i + (k + 1) * ti
        z = labels[y + sj, x + si]
        if labels[y, x] != a or z == a or not free[y + sj, x + si] or (z != b and not whole):
            return k
        k += 1


@kernel
def shift_wall(
    geometry: Floats,
    near: Ints,
    free: Bools,
    labels: Ints,
    stats: Floats,
    contact: Floats,
    straddle: Floats,
    changes: Ints,
    rng: Ints,
    reach: int,
) -> int:
    """Shift a random straight run of wall by up to `reach` lines; return the number of records (0: nothing to do)."""
    rows, columns = labels.shape
    j = 1 + draw(rng) % (rows - 2)
    i = 1 + draw(rng) % (columns - 2)
    if not free[j, i]:
        return 0
    d = draw(rng)
    sj, si = (d & 3 == 0) - (d & 3 == 1), (d & 3 == 2) - (d & 3 == 3)
    a = labels[j, i]
    while labels[j + sj, i + si] == a:
        j += sj
        i += si
    if not free[j + sj, i + si]:
        return 0
    tj, ti = abs(si), abs(sj)
    whole = (d >> 4) % 3 == 0
    hi = _run_end(labels, free, j, i, tj, ti, sj, si, whole)
    lo = -_run_end(labels, free, j, i, -tj, -ti, sj, si, whole)
    cut = (d >> 12) % 6
    if cut == 0 and hi > 0:
        hi = draw(rng) % (hi + 1)
    elif cut == 1 and lo < 0:
        lo = -(draw(rng) % (1 - lo))
    depth = 1
    while depth < reach and draw(rng) % 3 == 0:
        depth += 1
    made = 0
    outward = (d >> 20) & 1 == 0
    for k in range(lo, hi + 1):
        y, x = j + k * tj, i + k * ti
        new = a if outward else labels[y + sj, x + si]
        step = 1 if outward else 0
        for _ in range(depth):
            yy, xx = y + step * sj, x + step * si
            if not free[yy, xx]:
                break
            if outward:
                step += 1
            else:
                if labels[yy, xx] != a:
                    break
                step -= 1
            if labels[yy, xx] != new:
                made = repaint(geometry, near, labels, stats, contact, straddle, changes, made, yy, xx, new)
    return made


@kernel
def swap_rooms(
    geometry: Floats,
    near: Ints,
    labels: Ints,
    stats: Floats,
    contact: Floats,
    straddle: Floats,
    changes: Ints,
    rng: Ints,
    rooms: Floats,
) -> int:
    """Let two random rooms of similar area change places; return the number of records."""
    a = draw(rng) % rooms.shape[0]
    b = draw(rng) % rooms.shape[0]
    made = 0
    s, t = stats[a, SIZE], stats[b, SIZE]
    if a == b or max(s, t) > MOST_SWAPPED * min(s, t):
        return 0
    rows, columns = labels.shape
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            x = labels[j, i]
            if x in (a, b):
                made = repaint(
                    geometry, near, labels, stats, contact, straddle, changes, made, j, i, b if x == a else a
                )
    return made
