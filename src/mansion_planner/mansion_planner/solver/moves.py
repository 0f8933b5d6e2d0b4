"""Moves of the annealing: a wall shifts, two rooms swap, a room becomes a rectangle; and the random numbers for them.

Each move paints cells, records in ``changes`` what it painted over, and returns the number of records.
"""

import numpy as np

from mansion_geometry.compiled import Bools, Floats, Ints, kernel
from mansion_planner.solver.partition import COUNT, SIZE, neighbour, repaint
from mansion_planner.solver.problem import TARGET

__all__ = ["draw", "place_rectangle", "random_rectangle", "shift_wall", "swap_rooms", "uniform"]


@kernel
def draw(rng: Ints) -> int:
    """Return 31 random bits and advance `rng`, an array of one integer, so that a seed decides every draw.

    References
    ----------
    D. E. Knuth (1997). The Art of Computer Programming, vol. 2, section 3.3.4 (multiplier of the MMIX generator).
    """
    x = rng[0] * 6364136223846793005 + 1442695040888963407
    rng[0] = x
    # Low bits of a generator modulo 2^64 have short periods (bit k repeats after 2^(k+1) draws), so only the upper 31
    # are used; the fold mixes them once more, because callers take remainders, which look at low bits.
    y = (x >> 33) & 0x7FFFFFFF
    return int((y ^ (y >> 15)) & 0x7FFFFFFF)


@kernel
def uniform(rng: Ints) -> float:
    """Return a random number in [0, 1)."""
    return draw(rng) / 2.0**31


MOST_SWAPPED = 2.0
"""Ratio of areas up to which two rooms may swap."""

LONG_SHARE, PARTIAL_SHARE, DEEPER_SHARE = 3, 6, 3
"""Each is 1 in so many: walls shifted along all rooms behind them, walls cut off at their upper and at their lower end,
and steps that go a line further."""

LONG_BITS, PARTIAL_BITS, OUTWARD_BITS = 4, 12, 20
"""First bits of a random number that decide on these and on the direction; the two lowest decide on the side.

One number serves for all four choices, because drawing numbers is a large part of a short move. The fields are far
enough apart for the remainders to be nearly independent.
"""


@kernel
def _run_length(labels: Ints, free: Bools, j: int, i: int, tj: int, ti: int, sj: int, si: int, whole: bool) -> int:
    """Return how many cells the wall on side (sj, si) of cell (j, i) goes on straight in direction (tj, ti).

    With `whole`, it goes on where another room begins behind it.
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
    """Shift a random straight run of wall, or a part of it, by up to `reach` grid lines.

    The wall is the first one met from a random cell in a random direction; it moves away from the cell's room or into
    it.

    Returns
    -------
    int
        Number of records in `changes`; 0 where there is nothing to shift.
    """
    rows, columns = labels.shape
    j = 1 + draw(rng) % (rows - 2)
    i = 1 + draw(rng) % (columns - 2)
    if not free[j, i]:
        return 0
    bits = draw(rng)
    q = bits & 3
    sj, si = (q == 0) - (q == 1), (q == 2) - (q == 3)
    a = labels[j, i]
    while labels[j + sj, i + si] == a:
        j += sj
        i += si
    if not free[j + sj, i + si]:
        return 0
    tj, ti = abs(si), abs(sj)
    whole = (bits >> LONG_BITS) % LONG_SHARE == 0
    hi = _run_length(labels, free, j, i, tj, ti, sj, si, whole=whole)
    lo = -_run_length(labels, free, j, i, -tj, -ti, sj, si, whole=whole)
    cut = (bits >> PARTIAL_BITS) % PARTIAL_SHARE
    if cut == 0 and hi > 0:
        hi = draw(rng) % (hi + 1)
    elif cut == 1 and lo < 0:
        lo = -(draw(rng) % (1 - lo))
    depth = 1
    while depth < reach and draw(rng) % DEEPER_SHARE == 0:
        depth += 1
    made = 0
    outward = (bits >> OUTWARD_BITS) & 1 == 0
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
    """Swap two random rooms of similar area; return the number of records."""
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


MOST_TAKEN = 0.6
"""Largest share of another room's cells that a rectangle may take."""


@kernel
def _draw_room(links: Ints, need: Floats, contact: Floats, n: int, rng: Ints) -> tuple[int, int]:
    """Draw one of `n` rooms, half of the time one whose link is unmet; return it and its partner, or -1 for none."""
    r, partner = draw(rng) % n, -1
    if links.shape[0] > 0 and draw(rng) & 1 == 0:
        for _ in range(12):
            e = draw(rng) % links.shape[0]
            a, b = links[e, 0], links[e, 1]
            if contact[a, b] < need[e]:
                r, partner = (a, b) if draw(rng) & 1 == 0 else (b, a)
                break
    if r >= n:
        r, partner = partner, r
    return r, partner


@kernel
def _beside(labels: Ints, j: int, i: int, partner: int) -> bool:
    """Tell whether cell (j, i) is no cell of `partner` and next to one."""
    return bool(
        labels[j, i] != partner
        and (
            labels[j, i + 1] == partner
            or labels[j, i - 1] == partner
            or labels[j + 1, i] == partner
            or labels[j - 1, i] == partner
        )
    )


@kernel
def _draw_cell(free: Bools, labels: Ints, partner: int, rng: Ints) -> tuple[int, int]:
    """Draw a free cell, beside `partner` unless that is -1; return its row, 0 when 60 draws found none, and column."""
    rows, columns = labels.shape
    for _ in range(60):
        j = 1 + draw(rng) % (rows - 2)
        i = 1 + draw(rng) % (columns - 2)
        if free[j, i] and (partner < 0 or _beside(labels, j, i, partner)):
            return j, i
    return 0, 0


@kernel
def _range_of_length(lines: Floats, k: int, length: float, rng: Ints) -> tuple[int, int]:
    """Return the range of cells from cell `k` on, upwards or downwards, that is about `length` long."""
    k0, k1 = k, k + 1
    if draw(rng) & 1 == 0:
        while k1 < lines.size - 2 and lines[k1 + 1] - lines[k0] < length + 0.2:
            k1 += 1
    else:
        while k0 > 1 and lines[k1] - lines[k0 - 1] < length + 0.2:
            k0 -= 1
    return k0, k1


@kernel
def random_rectangle(
    xs: Floats,
    ys: Floats,
    free: Bools,
    rooms: Floats,
    links: Ints,
    need: Floats,
    labels: Ints,
    contact: Floats,
    rng: Ints,
    box: Ints,
) -> bool:
    """Draw a room and a rectangle of about its area; write room, rows and columns to `box`.

    Half of the draws take a room with an unmet link and a corner beside the room that it should touch.

    Returns
    -------
    bool
        The rectangle lies inside the frame.
    """
    n = rooms.shape[0]
    r, partner = _draw_room(links, need, contact, n, rng)
    if r == 0 or r >= n:
        return False
    j, i = _draw_cell(free, labels, partner, rng)
    if j == 0:
        return False
    aspect = np.exp(1.4 * (uniform(rng) - 0.5))
    wide = (rooms[r, TARGET] * aspect) ** 0.5
    i0, i1 = _range_of_length(xs, i, wide, rng)
    j0, j1 = _range_of_length(ys, j, rooms[r, TARGET] / wide, rng)
    box[0], box[1], box[2], box[3], box[4] = r, j0, j1, i0, i1
    return True


@kernel
def _longest_neighbour(geometry: Floats, free: Bools, labels: Ints, j: int, i: int) -> int:
    """Return the other room with the longest border to cell (j, i), or -1."""
    best, longest = -1, 1e-9
    r = labels[j, i]
    for q in range(4):
        y, x, border = neighbour(geometry, j, i, q)
        if free[y, x] and labels[y, x] != r and border > longest:
            best, longest = labels[y, x], border
    return best


@kernel
def _takes_too_much(free: Bools, labels: Ints, stats: Floats, r: int, j0: int, j1: int, i0: int, i1: int) -> bool:
    """Tell whether a rectangle of room `r` would take most of another room's cells."""
    lost = np.zeros(stats.shape[0])
    for j in range(j0, j1):
        for i in range(i0, i1):
            if free[j, i]:
                lost[labels[j, i]] += 1.0
    lost[r] = 0.0
    return bool((lost > MOST_TAKEN * stats[:, COUNT]).any())


@kernel
def place_rectangle(
    geometry: Floats,
    near: Ints,
    free: Bools,
    labels: Ints,
    stats: Floats,
    contact: Floats,
    straddle: Floats,
    changes: Ints,
    r: int,
    j0: int,
    j1: int,
    i0: int,
    i1: int,
) -> int:
    """Set room `r` to the cells of a rectangle; each cell that it leaves goes to the neighbour with most border to it.

    Returns
    -------
    int
        Number of records in `changes`; 0 where the rectangle would take too much of another room.
    """
    made = 0
    rows, columns = labels.shape
    if _takes_too_much(free, labels, stats, r, j0, j1, i0, i1):
        return 0
    for j in range(j0, j1):
        for i in range(i0, i1):
            if free[j, i] and labels[j, i] != r:
                made = repaint(geometry, near, labels, stats, contact, straddle, changes, made, j, i, r)
    if made == 0:
        return 0
    left, before = 1, -1
    while left > 0 and made != before:
        left, before = 0, made
        for j in range(1, rows - 1):
            for i in range(1, columns - 1):
                if labels[j, i] != r or (j0 <= j < j1 and i0 <= i < i1):
                    continue
                best = _longest_neighbour(geometry, free, labels, j, i)
                if best < 0:
                    left += 1
                else:
                    made = repaint(geometry, near, labels, stats, contact, straddle, changes, made, j, i, best)
    return made
