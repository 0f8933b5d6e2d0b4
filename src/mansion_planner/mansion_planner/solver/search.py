"""Search over partitions by moving walls: simulated annealing with a fixed number of proposals.

A proposal shifts a straight run of wall by some grid lines, swaps two rooms, or sets one room to a rectangle from a
list. It is kept when every room that it touched is still one piece and the energy allows it (Metropolis).
"""

import numpy as np

from mansion_planner.solver.jit import kernel
from mansion_planner.solver.objective import edge_energy, room_energy, scan_runs, total_energy
from mansion_planner.solver.state import Cells, Floats, Goal, Ints, State, paint, recount

__all__ = ["anneal", "draw", "one_piece"]


@kernel
def draw(rng: Ints) -> int:
    """Return 31 random bits and advance `rng` (a 64-bit linear congruential generator with output mixing)."""
    x = rng[0] * 6364136223846793005 + 1442695040888963407
    rng[0] = x
    y = (x >> 33) & 0x7FFFFFFF
    return (y ^ (y >> 15)) & 0x7FFFFFFF


@kernel
def uniform(rng: Ints) -> float:
    """Return a random number in [0, 1)."""
    return draw(rng) / 2147483648.0


@kernel
def one_piece(cells: Cells, state: State, r: int, j: int, i: int, stack: Ints, seen: Ints, stamp: int) -> bool:
    """Tell whether all cells of label `r` can be reached from its cell (j, i) across borders."""
    lab = state.lab
    columns = lab.shape[1]
    top = 0
    stack[0] = j * columns + i
    seen[j, i] = stamp
    found = 0
    while top >= 0:
        p = stack[top]
        top -= 1
        y, x = p // columns, p % columns
        found += 1
        if lab[y, x + 1] == r and seen[y, x + 1] != stamp and cells.vb[y, x] > 1e-6:
            seen[y, x + 1] = stamp
            top += 1
            stack[top] = p + 1
        if lab[y, x - 1] == r and seen[y, x - 1] != stamp and cells.vb[y, x - 1] > 1e-6:
            seen[y, x - 1] = stamp
            top += 1
            stack[top] = p - 1
        if lab[y + 1, x] == r and seen[y + 1, x] != stamp and cells.hb[y, x] > 1e-6:
            seen[y + 1, x] = stamp
            top += 1
            stack[top] = p + columns
        if lab[y - 1, x] == r and seen[y - 1, x] != stamp and cells.hb[y - 1, x] > 1e-6:
            seen[y - 1, x] = stamp
            top += 1
            stack[top] = p - columns
    return found == state.count[r]


@kernel
def _still_whole(
    cells: Cells, state: State, changes: Ints, old: Ints, made: int, stack: Ints, seen: Ints,
    stamps: Ints, rooms: int,
) -> bool:
    """Tell whether every label that the recorded changes touched is one piece and not empty."""
    lab = state.lab
    columns = lab.shape[1]
    first = stamps[0] + 1
    for k in range(made):
        y, x = changes[k] // columns, changes[k] % columns
        r = lab[y, x]
        if seen[y, x] < first:
            stamps[0] += 1
            if not one_piece(cells, state, r, y, x, stack, seen, stamps[0]):
                return False
        z = old[k]
        if state.count[z] == 0:
            return False
        for q in range(4):
            yy = y + (q == 0) - (q == 1)
            xx = x + (q == 2) - (q == 3)
            if lab[yy, xx] == z and seen[yy, xx] < first and z < rooms:
                stamps[0] += 1
                if not one_piece(cells, state, z, yy, xx, stack, seen, stamps[0]):
                    return False
    return True


@kernel
def _set(cells: Cells, state: State, j: int, i: int, new: int, changes: Ints, old: Ints, made: int) -> int:
    """Paint a cell, record it, and return the new number of records."""
    changes[made] = j * state.lab.shape[1] + i
    old[made] = state.lab[j, i]
    paint(cells, state, j, i, new)
    return made + 1


@kernel
def _undo(cells: Cells, state: State, changes: Ints, old: Ints, made: int) -> None:
    """Take the recorded changes back, last first."""
    columns = state.lab.shape[1]
    for k in range(made - 1, -1, -1):
        paint(cells, state, changes[k] // columns, changes[k] % columns, old[k])


@kernel
def _shift_wall(cells: Cells, state: State, reach: int, rng: Ints, changes: Ints, old: Ints) -> int:
    """Shift a random straight run of wall; return the number of recorded cell changes (0: nothing to do)."""
    lab, free = state.lab, cells.free
    rows, columns = lab.shape
    j = 1 + draw(rng) % (rows - 2)
    i = 1 + draw(rng) % (columns - 2)
    if not free[j, i]:
        return 0
    d = draw(rng) % 4
    sj, si = (d == 0) - (d == 1), (d == 2) - (d == 3)
    a = lab[j, i]
    while lab[j + sj, i + si] == a:
        j += sj
        i += si
    b = lab[j + sj, i + si]
    if not free[j + sj, i + si]:
        return 0
    tj, ti = abs(si), abs(sj)
    whole_side = draw(rng) % 3 == 0
    lo = 0
    while True:
        y, x = j + (lo - 1) * tj, i + (lo - 1) * ti
        z = lab[y + sj, x + si]
        if lab[y, x] != a or z == a or not free[y + sj, x + si] or (z != b and not whole_side):
            break
        lo -= 1
    hi = 0
    while True:
        y, x = j + (hi + 1) * tj, i + (hi + 1) * ti
        z = lab[y + sj, x + si]
        if lab[y, x] != a or z == a or not free[y + sj, x + si] or (z != b and not whole_side):
            break
        hi += 1
    cut = draw(rng) % 6
    if cut == 0 and hi > 0:
        hi = draw(rng) % (hi + 1)
    elif cut == 1 and lo < 0:
        lo = -(draw(rng) % (1 - lo))
    depth = 1
    while depth < reach and draw(rng) % 3 == 0:
        depth += 1
    made = 0
    if draw(rng) % 2 == 0:
        for k in range(lo, hi + 1):
            for s in range(1, depth + 1):
                y, x = j + k * tj + s * sj, i + k * ti + s * si
                if not free[y, x]:
                    break
                if lab[y, x] != a:
                    made = _set(cells, state, y, x, a, changes, old, made)
    else:
        for k in range(lo, hi + 1):
            y, x = j + k * tj, i + k * ti
            new = lab[y + sj, x + si]
            for s in range(depth):
                if lab[y - s * sj, x - s * si] != a:
                    break
                made = _set(cells, state, y - s * sj, x - s * si, new, changes, old, made)
    return made


@kernel
def _swap_rooms(cells: Cells, state: State, rooms: int, rng: Ints, changes: Ints, old: Ints) -> int:
    """Let two random rooms change places; return the number of recorded cell changes."""
    a = draw(rng) % rooms
    b = draw(rng) % rooms
    made = 0
    if a == b:
        return 0
    rows, columns = state.lab.shape
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            x = state.lab[j, i]
            if x == a:
                made = _set(cells, state, j, i, b, changes, old, made)
            elif x == b:
                made = _set(cells, state, j, i, a, changes, old, made)
    return made


@kernel
def _place_rectangle(
    cells: Cells, state: State, boxes: Ints, rng: Ints, changes: Ints, old: Ints
) -> int:
    """Set a random room to a random rectangle of its list; its old ground goes to whoever it touches."""
    lab, free = state.lab, cells.free
    row = draw(rng) % boxes.shape[0]
    r, j0, j1, i0, i1 = boxes[row, 0], boxes[row, 1], boxes[row, 2], boxes[row, 3], boxes[row, 4]
    made = 0
    rows, columns = lab.shape
    for j in range(j0, j1):
        for i in range(i0, i1):
            if free[j, i] and lab[j, i] != r:
                made = _set(cells, state, j, i, r, changes, old, made)
    if made == 0:
        return 0
    left = 1
    while left > 0:
        left = 0
        before = made
        for j in range(1, rows - 1):
            for i in range(1, columns - 1):
                if lab[j, i] != r or (j0 <= j < j1 and i0 <= i < i1):
                    continue
                best, longest = -1, 0.0
                for q in range(4):
                    y, x = j + (q == 0) - (q == 1), i + (q == 2) - (q == 3)
                    if not free[y, x] or lab[y, x] == r:
                        continue
                    s = (cells.hb[min(j, y), i] if q < 2 else cells.vb[j, min(i, x)])
                    if s > longest:
                        best, longest = lab[y, x], s
                if best < 0:
                    left += 1
                else:
                    made = _set(cells, state, j, i, best, changes, old, made)
        if made == before:
            break
    return made


@kernel
def anneal(
    cells: Cells, goal: Goal, state: State, boxes: Ints, proposals: int, hot: float, cold: float,
    reach: int, swaps: float, jumps: float, seed: int,
) -> float:
    """Lower the energy of `state` in place and leave it at the best partition met.

    Parameters
    ----------
    boxes : (k, 5) int array
        Rectangles to try: room, first and last-but-one row, first and last-but-one column.
    proposals : int
        Candidates to look at.
    hot, cold : float
        First and last temperature (geometric schedule); 0 for descent.
    reach : int
        Most grid lines that a wall is shifted by.
    swaps, jumps : float
        Shares of room swaps and of rectangles among the proposals.

    Returns
    -------
    float
        Energy of the best partition.
    """
    lab = state.lab
    rows, columns = lab.shape
    rooms = goal.target.size
    rng = np.array([seed], dtype=np.int64)
    for _ in range(4):
        draw(rng)
    capacity = 4 * rows * columns
    changes = np.empty(capacity, np.int64)
    old = np.empty(capacity, np.int64)
    stack = np.empty(4 * rows * columns, np.int64)
    seen = np.zeros((rows, columns), np.int64)
    stamps = np.zeros(1, np.int64)
    width = np.empty((rows, columns))
    recount(cells, state)
    energy = total_energy(cells, goal, state, width)
    best = energy
    best_lab = lab.copy()
    ratio = (cold / hot) ** (1.0 / max(1, proposals)) if hot > 0.0 else 1.0
    heat = hot
    for _ in range(proposals):
        heat *= ratio
        u = uniform(rng)
        if u < swaps:
            made = _swap_rooms(cells, state, rooms, rng, changes, old)
        elif u < swaps + jumps and boxes.shape[0] > 0:
            made = _place_rectangle(cells, state, boxes, rng, changes, old)
        else:
            made = _shift_wall(cells, state, reach, rng, changes, old)
        if made == 0:
            continue
        limit = energy + 1e-12
        if heat > 0.0:
            limit = energy - heat * np.log(uniform(rng) + 1e-12)
        fixed = room_energy(goal, state)
        ok = fixed + edge_energy(goal, state, False) <= limit
        ok = ok and _still_whole(cells, state, changes, old, made, stack, seen, stamps, rooms)
        if ok:
            scan_runs(cells, goal, state, width)
            found = fixed + edge_energy(goal, state, True)
            if found <= limit:
                energy = found
                if energy < best - 1e-9:
                    best = energy
                    best_lab[:, :] = lab
                continue
        _undo(cells, state, changes, old, made)
    lab[:, :] = best_lab
    recount(cells, state)
    return total_energy(cells, goal, state, width)
