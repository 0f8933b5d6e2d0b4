"""Arrays of the wall search: the cells of a grid, the goal, and the state of one partition.

The partition is a label for each cell: rooms 0 to n-1, obstacles (cores, fixed rooms) n to m-2, and m-1 for the
outside. All statistics that the energy needs are kept up to date cell by cell.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from mansion_planner.solver.jit import kernel

__all__ = ["Cells", "Goal", "State", "make_state", "paint", "recount"]

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]


class Cells(NamedTuple):
    """A grid of cells between lines, with a frame of outside cells around it.

    ``area``, ``cx``, ``cy`` describe the part of each cell inside the free region. ``hb[j, i]`` is the length of the
    border between cells (j, i) and (j+1, i), ``vb[j, i]`` between (j, i) and (j, i+1); ``hs`` and ``vs`` are the
    lengths of structural wall on those borders. ``near`` and ``near_length`` name an obstacle whose slanted side
    runs through the cell.
    """

    xs: Floats
    ys: Floats
    area: Floats
    cx: Floats
    cy: Floats
    hb: Floats
    vb: Floats
    hs: Floats
    vs: Floats
    near: Ints
    near_length: Floats
    free: Bools


class Goal(NamedTuple):
    """What the search wants; arrays over rooms, edges (label pairs) and weights.

    ``kind`` is 0 for access and 1 for adjacent; ``side`` gives, for each label, the only side on which a core may be
    entered (0 any, 1 north, 2 east, 3 south, 4 west).
    """

    target: Floats
    seed: Floats
    seed_weight: Floats
    min_width: Floats
    shape_weight: Floats
    corner_weight: Floats
    first: Ints
    second: Ints
    kind: Ints
    need: Floats
    side: Ints
    apart: Ints
    weights: Floats


class State(NamedTuple):
    """One partition and its running statistics (see `paint`)."""

    lab: Ints
    count: Ints
    area: Floats
    mx: Floats
    my: Floats
    perimeter: Floats
    corners: Ints
    contact: Floats
    run: Floats
    thin: Floats
    straddle: Floats


def make_state(labels: Ints, rooms: int, total: int) -> State:
    """Return an empty state for `labels`; `recount` fills in the statistics."""
    return State(
        labels.copy(),
        np.zeros(total, np.int64),
        np.zeros(total),
        np.zeros(total),
        np.zeros(total),
        np.zeros(total),
        np.zeros(total, np.int64),
        np.zeros((total, total)),
        np.zeros((total, total)),
        np.zeros(rooms),
        np.zeros(1),
    )


@kernel
def corners_at(state: State, j: int, i: int, sign: int) -> None:
    """Add (or take away) what the vertex above right of cell (j, i) gives to the corner counts."""
    lab = state.lab
    a, b, c, d = lab[j, i], lab[j, i + 1], lab[j + 1, i], lab[j + 1, i + 1]
    if a == b and c == d and a == c:
        return
    for q in range(4):
        if q == 0:
            x = a
        elif q == 1:
            x = b
            if x == a:
                continue
        elif q == 2:
            x = c
            if x in (a, b):
                continue
        else:
            x = d
            if x in (a, b, c):
                continue
        k = (a == x) + (b == x) + (c == x) + (d == x)
        if k == 1 or k == 3:
            state.corners[x] += sign
        elif k == 2 and ((a == x and d == x) or (b == x and c == x)):
            state.corners[x] += 2 * sign


@kernel
def _border(state: State, old: int, new: int, other: int, length: float, wall: float) -> None:
    """Move one border of a cell from label `old` to label `new`."""
    if other != old:
        state.contact[old, other] -= length
        state.contact[other, old] -= length
        state.perimeter[old] -= length
        state.perimeter[other] -= length
    else:
        state.straddle[0] -= wall
    if other != new:
        state.contact[new, other] += length
        state.contact[other, new] += length
        state.perimeter[new] += length
        state.perimeter[other] += length
    else:
        state.straddle[0] += wall


@kernel
def paint(cells: Cells, state: State, j: int, i: int, new: int) -> None:
    """Give cell (j, i) the label `new` and update every statistic."""
    lab = state.lab
    old = lab[j, i]
    for q in range(4):
        corners_at(state, j - (q >> 1), i - (q & 1), -1)
    lab[j, i] = new
    for q in range(4):
        corners_at(state, j - (q >> 1), i - (q & 1), 1)
    a = cells.area[j, i]
    state.count[old] -= 1
    state.count[new] += 1
    state.area[old] -= a
    state.area[new] += a
    state.mx[old] -= a * cells.cx[j, i]
    state.mx[new] += a * cells.cx[j, i]
    state.my[old] -= a * cells.cy[j, i]
    state.my[new] += a * cells.cy[j, i]
    _border(state, old, new, lab[j, i + 1], cells.vb[j, i], cells.vs[j, i])
    _border(state, old, new, lab[j, i - 1], cells.vb[j, i - 1], cells.vs[j, i - 1])
    _border(state, old, new, lab[j + 1, i], cells.hb[j, i], cells.hs[j, i])
    _border(state, old, new, lab[j - 1, i], cells.hb[j - 1, i], cells.hs[j - 1, i])
    if cells.near_length[j, i] > 0.0:
        k = cells.near[j, i]
        s = cells.near_length[j, i]
        state.contact[old, k] -= s
        state.contact[k, old] -= s
        state.contact[new, k] += s
        state.contact[k, new] += s


@kernel
def recount(cells: Cells, state: State) -> None:
    """Compute every statistic of `state` from its labels."""
    lab = state.lab
    rows, columns = lab.shape
    state.count[:] = 0
    state.area[:] = 0.0
    state.mx[:] = 0.0
    state.my[:] = 0.0
    state.perimeter[:] = 0.0
    state.corners[:] = 0
    state.contact[:, :] = 0.0
    state.straddle[0] = 0.0
    for j in range(rows):
        for i in range(columns):
            x = lab[j, i]
            a = cells.area[j, i]
            state.count[x] += 1
            state.area[x] += a
            state.mx[x] += a * cells.cx[j, i]
            state.my[x] += a * cells.cy[j, i]
            if j + 1 < rows and i + 1 < columns:
                corners_at(state, j, i, 1)
            for q in range(2):
                if q == 0:
                    if i + 1 >= columns:
                        continue
                    y, s, w = lab[j, i + 1], cells.vb[j, i], cells.vs[j, i]
                else:
                    if j + 1 >= rows:
                        continue
                    y, s, w = lab[j + 1, i], cells.hb[j, i], cells.hs[j, i]
                if x != y:
                    state.contact[x, y] += s
                    state.contact[y, x] += s
                    state.perimeter[x] += s
                    state.perimeter[y] += s
                else:
                    state.straddle[0] += w
            if cells.near_length[j, i] > 0.0:
                k = cells.near[j, i]
                state.contact[x, k] += cells.near_length[j, i]
                state.contact[k, x] += cells.near_length[j, i]
