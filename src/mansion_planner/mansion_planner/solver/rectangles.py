"""The move that sets a room to a rectangle, and the rectangles worth trying."""

import numpy as np

from mansion_planner.solver.draws import draw, uniform
from mansion_planner.solver.jit import kernel
from mansion_planner.solver.painting import repaint
from mansion_planner.solver.state import COUNT, HB, TARGET, VB, Bools, Floats, Ints

__all__ = ["place_rectangle", "random_rectangle"]

MOST_TAKEN = 0.6
"""Share of another room's cells that a rectangle may take."""


@kernel
def _drawn_room(links: Ints, need: Floats, contact: Floats, n: int, rng: Ints) -> tuple[int, int]:
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
def _drawn_cell(free: Bools, labels: Ints, partner: int, rng: Ints) -> tuple[int, int]:
    """Draw a free cell, beside `partner` unless that is -1; return its row, 0 when 60 draws found none, and column."""
    rows, columns = labels.shape
    for _ in range(60):
        j = 1 + draw(rng) % (rows - 2)
        i = 1 + draw(rng) % (columns - 2)
        if free[j, i] and (partner < 0 or _beside(labels, j, i, partner)):
            return j, i
    return 0, 0


@kernel
def _stretched(lines: Floats, k: int, length: float, rng: Ints) -> tuple[int, int]:
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

    Half of the draws take a room whose link is unmet and a corner beside the room that it should touch.

    Returns
    -------
    bool
        The rectangle lies inside the frame.
    """
    n = rooms.shape[0]
    r, partner = _drawn_room(links, need, contact, n, rng)
    if r == 0 or r >= n:
        return False
    j, i = _drawn_cell(free, labels, partner, rng)
    if j == 0:
        return False
    aspect = np.exp(1.4 * (uniform(rng) - 0.5))
    wide = (rooms[r, TARGET] * aspect) ** 0.5
    i0, i1 = _stretched(xs, i, wide, rng)
    j0, j1 = _stretched(ys, j, rooms[r, TARGET] / wide, rng)
    box[0], box[1], box[2], box[3], box[4] = r, j0, j1, i0, i1
    return True


@kernel
def _heir(geometry: Floats, free: Bools, labels: Ints, j: int, i: int) -> int:
    """Return the other room with the longest border to cell (j, i), or -1."""
    best, longest = -1, 1e-9
    r = labels[j, i]
    for q in range(4):
        y, x = j + (q == 0) - (q == 1), i + (q == 2) - (q == 3)
        if not free[y, x] or labels[y, x] == r:
            continue
        s = geometry[min(j, y), i, HB] if q < 2 else geometry[j, min(i, x), VB]
        if s > longest:
            best, longest = labels[y, x], s
    return best


@kernel
def _buries(free: Bools, labels: Ints, stats: Floats, r: int, j0: int, j1: int, i0: int, i1: int) -> bool:
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
    """Set room `r` to the cells of a rectangle; its old ground goes to whoever it touches."""
    made = 0
    rows, columns = labels.shape
    if _buries(free, labels, stats, r, j0, j1, i0, i1):
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
                best = _heir(geometry, free, labels, j, i)
                if best < 0:
                    left += 1
                else:
                    made = repaint(geometry, near, labels, stats, contact, straddle, changes, made, j, i, best)
    return made
