"""The energy that the wall search lowers: areas, seeds, shapes and, above all, topology."""

from mansion_planner.solver.jit import kernel
from mansion_planner.solver.state import Cells, Floats, Goal, State

__all__ = [
    "WEIGHTS",
    "edge_energy",
    "room_energy",
    "scan_runs",
    "total_energy",
]

WEIGHTS = ("area", "seed", "corner", "compact", "access", "adjacent", "thin", "apart", "straddle")
"""Order of `Goal.weights`."""

ACCESS = 0
DETOUR = 1.12
"""Compactness (perimeter / 4 sqrt(area)) up to which a room's proportions cost nothing: a rectangle of 1 : 2.6."""


@kernel
def room_energy(goal: Goal, state: State) -> float:
    """Return the part of the energy that areas, seeds and shapes cause."""
    w = goal.weights
    energy = w[8] * state.straddle[0]
    for r in range(goal.target.size):
        a = state.area[r]
        t = goal.target[r]
        if a <= 0.0 or state.count[r] == 0:
            energy += 100.0
            continue
        energy += w[0] * abs(a - t) / t
        if goal.seed_weight[r] > 0.0:
            dx = state.mx[r] / a - goal.seed[r, 0]
            dy = state.my[r] / a - goal.seed[r, 1]
            energy += w[1] * goal.seed_weight[r] * (dx * dx + dy * dy) ** 0.5 / t**0.5
        energy += w[2] * goal.corner_weight[r] * max(0, state.corners[r] - 4)
        shape = state.perimeter[r] / (4.0 * a**0.5)
        energy += w[3] * goal.shape_weight[r] * max(0.0, shape - DETOUR)
    return energy


@kernel
def edge_energy(goal: Goal, state: State, exact: bool) -> float:
    """Return the part of the energy that the room graph causes.

    With `exact` false the straight runs are not known and whole contacts stand in for them, which gives a lower bound.
    """
    w = goal.weights
    energy = 0.0
    for e in range(goal.first.size):
        a, b = goal.first[e], goal.second[e]
        length = state.contact[a, b]
        if exact and goal.kind[e] == ACCESS:
            length = state.run[a, b]
        need = goal.need[e]
        if length >= need - 1e-9:
            continue
        miss = 0.35 + 0.45 * (need - length) / need
        if length <= 0.0 and state.area[a] > 0.0 and state.area[b] > 0.0:
            dx = state.mx[a] / state.area[a] - state.mx[b] / state.area[b]
            dy = state.my[a] / state.area[a] - state.my[b] / state.area[b]
            size = state.area[a] ** 0.5 + state.area[b] ** 0.5
            miss += 0.2 * min(4.0, (dx * dx + dy * dy) ** 0.5 / size)
        energy += miss * (w[4] if goal.kind[e] == ACCESS else w[5])
    for k in range(goal.apart.shape[0]):
        s = state.contact[goal.apart[k, 0], goal.apart[k, 1]]
        if s > 0.0:
            energy += w[7] * min(1.0, s)
    if exact:
        for r in range(goal.target.size):
            energy += w[6] * state.thin[r] / goal.target[r]
    return energy


@kernel
def _flush(goal: Goal, state: State, a: int, b: int, side: int, length: float) -> None:
    """Record a straight wall whose lower (or left) label is `a`; `side` is `a`'s side that it is on (1 or 2)."""
    if a == b:
        return
    if goal.side[a] != 0 and goal.side[a] != side:
        return
    if goal.side[b] != 0 and goal.side[b] != side + 2:
        return
    if length > state.run[a, b]:
        state.run[a, b] = length
        state.run[b, a] = length


@kernel
def scan_runs(cells: Cells, goal: Goal, state: State, width: Floats) -> None:
    """Find the longest straight wall of each pair of labels, and each room's area narrower than its minimum width.

    Parameters
    ----------
    width : (rows, columns) array
        Scratch.
    """
    lab = state.lab
    rows, columns = lab.shape
    n = goal.target.size
    state.run[:, :] = 0.0
    state.thin[:] = 0.0
    for j in range(rows - 1):
        a, b, length = -1, -1, 0.0
        begin = 0
        for i in range(columns):
            x, y = lab[j, i], lab[j + 1, i]
            if x == a and y == b:
                length += cells.hb[j, i]
            else:
                if a >= 0:
                    _flush(goal, state, a, b, 1, length)
                a, b, length = x, y, cells.hb[j, i]
            if i > 0 and x != lab[j, i - 1]:
                span = cells.xs[i] - cells.xs[begin]
                for k in range(begin, i):
                    width[j, k] = span
                begin = i
        _flush(goal, state, a, b, 1, length)
        for k in range(begin, columns):
            width[j, k] = 1e9
    for i in range(columns - 1):
        a, b, length = -1, -1, 0.0
        begin = 0
        for j in range(rows):
            x, y = lab[j, i], lab[j, i + 1]
            if x == a and y == b:
                length += cells.vb[j, i]
            else:
                if a >= 0:
                    _flush(goal, state, a, b, 2, length)
                a, b, length = x, y, cells.vb[j, i]
            if j > 0 and x != lab[j - 1, i]:
                z = lab[j - 1, i]
                if z < n:
                    span = cells.ys[j] - cells.ys[begin]
                    least = goal.min_width[z] - 1e-6
                    for k in range(begin, j):
                        if min(span, width[k, i]) < least:
                            state.thin[z] += cells.area[k, i]
                begin = j
        _flush(goal, state, a, b, 2, length)


@kernel
def total_energy(cells: Cells, goal: Goal, state: State, width: Floats) -> float:
    """Return the whole energy of `state`."""
    scan_runs(cells, goal, state, width)
    return room_energy(goal, state) + edge_energy(goal, state, True)
