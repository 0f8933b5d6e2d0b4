"""The energy that the wall search lowers: areas, seeds, shapes and, above all, topology."""

import numpy as np

from mansion_planner.solver.jit import kernel
from mansion_planner.solver.state import (
    AREA,
    CORNER_WEIGHT,
    CORNERS,
    HB,
    MIN_WIDTH,
    MX,
    MY,
    PERIMETER,
    SEED_WEIGHT,
    SEED_X,
    SEED_Y,
    SHAPE_WEIGHT,
    SIZE,
    TARGET,
    VB,
    WALL_WEIGHT,
    Cells,
    Floats,
    Goal,
    Ints,
    State,
)

__all__ = ["WEIGHTS", "edge_energy", "room_energy", "scan_runs", "thin_energy", "total_energy"]

WEIGHTS = (
    "area",
    "seed",
    "corner",
    "compact",
    "access",
    "adjacent",
    "thin",
    "apart",
    "straddle",
    "wall",
)
"""Order of `Goal.weights`."""

W_AREA, W_SEED, W_CORNER, W_COMPACT, W_ACCESS, W_ADJACENT, W_THIN, W_APART, W_STRADDLE, W_WALL = (
    range(10)
)
ACCESS = 0
DETOUR = 1.12
"""Compactness (perimeter / 4 sqrt(area)) up to which a room's proportions cost nothing: a rectangle of 1 : 2.6."""


LARGE = 6.0
"""Area, m2, from which narrow places cost the same in rooms of any size."""

PINCH = 0.1
"""Share of a room's area that a pinch counts as narrow, at least; twice this where nothing is left."""

MOST_NOTCHES = 256


@kernel
def room_energy(
    rooms: Floats, w: Floats, stats: Floats, contact: Floats, straddle: Floats
) -> float:
    """Return the part of the energy that areas, seeds and shapes cause."""
    energy = w[W_STRADDLE] * straddle[0]
    outside = stats.shape[0] - 1
    for r in range(rooms.shape[0]):
        a = stats[r, SIZE]
        t = rooms[r, TARGET]
        if a <= 1e-9:
            energy += 100.0
            continue
        energy += w[W_AREA] * abs(a - t) / t
        weight = rooms[r, SEED_WEIGHT]
        if weight > 0.0:
            dx = stats[r, MX] / a - rooms[r, SEED_X]
            dy = stats[r, MY] / a - rooms[r, SEED_Y]
            energy += w[W_SEED] * weight * np.sqrt((dx * dx + dy * dy) / t)
        energy += w[W_CORNER] * rooms[r, CORNER_WEIGHT] * max(0.0, stats[r, CORNERS] - 4.0)
        shape = stats[r, PERIMETER] / (4.0 * np.sqrt(a))
        energy += w[W_COMPACT] * rooms[r, SHAPE_WEIGHT] * max(0.0, shape - DETOUR)
        weight = rooms[r, WALL_WEIGHT]
        if weight > 0.0:
            energy += w[W_WALL] * weight * max(0.0, 1.0 - contact[r, outside] / (0.6 * np.sqrt(t)))
    return float(energy)


@kernel
def edge_energy(
    links: Ints,
    need: Floats,
    apart: Ints,
    w: Floats,
    stats: Floats,
    contact: Floats,
    run: Floats,
    exact: bool,
) -> float:
    """Return the part of the energy that the room graph causes.

    With `exact` false the straight runs are not known and whole contacts stand in for them, which gives a lower bound.
    """
    energy = 0.0
    for e in range(links.shape[0]):
        a, b = links[e, 0], links[e, 1]
        length = contact[a, b]
        access = links[e, 2] == ACCESS
        if exact and access:
            length = run[a, b]
        if length >= need[e] - 1e-9:
            continue
        miss = 0.35 + 0.45 * (need[e] - length) / need[e]
        if length <= 1e-9 and stats[a, SIZE] > 0.0 and stats[b, SIZE] > 0.0:
            dx = stats[a, MX] / stats[a, SIZE] - stats[b, MX] / stats[b, SIZE]
            dy = stats[a, MY] / stats[a, SIZE] - stats[b, MY] / stats[b, SIZE]
            size = np.sqrt(stats[a, SIZE]) + np.sqrt(stats[b, SIZE])
            miss += 0.2 * min(4.0, np.sqrt(dx * dx + dy * dy) / size)
        energy += miss * (w[W_ACCESS] if access else w[W_ADJACENT])
    for k in range(apart.shape[0]):
        s = contact[apart[k, 0], apart[k, 1]]
        if s > 1e-9:
            energy += w[W_APART] * min(1.0, s)
    return energy


@kernel
def thin_energy(rooms: Floats, w: Floats, thin: Floats) -> float:
    """Return the part of the energy that places narrower than the minimum width cause."""
    energy = 0.0
    for r in range(rooms.shape[0]):
        energy += w[W_THIN] * thin[r] / min(LARGE, rooms[r, TARGET])
    return energy


@kernel
def _flush(run: Floats, side: Ints, a: int, b: int, where: int, length: float) -> None:
    """Record a straight wall whose lower (or left) label is `a`; `where` is `a`'s side that it is on (1 or 2)."""
    if a == b or length <= run[a, b]:
        return
    if side[a] != 0 and side[a] != where:
        return
    if side[b] != 0 and side[b] != where + 2:
        return
    run[a, b] = length
    run[b, a] = length


@kernel
def _notch(sw: int, nw: int, se: int, ne: int, rooms: int) -> int:
    """Return the quarter (0 NE, 1 SW, 2 NW, 3 SE) that is cut out of a room around a vertex, or -1."""
    if sw == nw == se != ne and sw < rooms:
        return 0
    if nw == se == ne != sw and ne < rooms:
        return 1
    if sw == se == ne != nw and ne < rooms:
        return 2
    if sw == nw == ne != se and sw < rooms:
        return 3
    return -1


@kernel
def _add_pinches(
    xs: Floats, ys: Floats, rooms: Floats, notches: Ints, made: int, thin: Floats
) -> None:
    """Add to `thin` where opposite notches of a room (rows: room, quarter, line, line) leave too narrow a neck."""
    for p in range(made):
        quarter = notches[p, 1]
        if quarter == 1 or quarter == 3:
            continue
        r = notches[p, 0]
        for q in range(made):
            if notches[q, 0] != r or notches[q, 1] != quarter + 1:
                continue
            across = xs[notches[p, 2]] - xs[notches[q, 2]]
            if quarter == 2:
                across = -across
            along = ys[notches[p, 3]] - ys[notches[q, 3]]
            neck = max(across, along) / rooms[r, MIN_WIDTH]
            if min(across, along) > -1e-6 and neck < 1.0 - 1e-6:
                thin[r] += min(LARGE, rooms[r, TARGET]) * (PINCH + PINCH * (1.0 - neck))


@kernel
def scan_runs(
    xs: Floats,
    ys: Floats,
    geometry: Floats,
    rooms: Floats,
    side: Ints,
    labels: Ints,
    run: Floats,
    thin: Floats,
    width: Floats,
) -> None:
    """Find the longest straight wall of each pair of labels, and each room's area narrower than its minimum width.

    To that area the one that would make those places wide enough is added, so that a sliver is not cheap, and
    something for each pinch.

    Parameters
    ----------
    width : (rows, columns) array
        Scratch.
    """
    rows, columns = labels.shape
    n = rooms.shape[0]
    run[:, :] = 0.0
    thin[:] = 0.0
    notches = np.empty((MOST_NOTCHES, 4), np.int64)
    made = 0
    for j in range(1, rows - 1):
        begin = 0
        previous = labels[j, 0]
        for i in range(1, columns):
            x = labels[j, i]
            if x != previous:
                if previous < n:
                    span = xs[i] - xs[begin]
                    missing = rooms[previous, MIN_WIDTH] - span
                    narrow = missing > 1e-6
                    if narrow:
                        thin[previous] += missing * (ys[j + 1] - ys[j])
                    for k in range(begin, i):
                        width[j, k] = 1.0 if narrow else 0.0
                begin = i
                previous = x
    for j in range(rows - 1):
        a, b, length = labels[j, 0], labels[j + 1, 0], 0.0
        for i in range(1, columns):
            x, y = labels[j, i], labels[j + 1, i]
            if x != a or y != b:
                if a != b:
                    _flush(run, side, a, b, 1, length)
                quarter = _notch(a, b, x, y, n)
                if quarter >= 0 and made < MOST_NOTCHES:
                    notches[made, 0] = y if quarter == 1 or quarter == 2 else a
                    notches[made, 1], notches[made, 2], notches[made, 3] = quarter, i, j + 1
                    made += 1
                a, b, length = x, y, 0.0
            length += geometry[j, i, HB]
    for i in range(columns - 1):
        a, b, length = labels[0, i], labels[0, i + 1], 0.0
        begin = 0
        for j in range(1, rows):
            x, y = labels[j, i], labels[j, i + 1]
            if x != a or y != b:
                if a != b:
                    _flush(run, side, a, b, 2, length)
                if x != a:
                    if a < n:
                        missing = rooms[a, MIN_WIDTH] - (ys[j] - ys[begin])
                        narrow = missing > 1e-6
                        if narrow:
                            thin[a] += missing * (xs[i + 1] - xs[i])
                        for k in range(begin, j):
                            if narrow or width[k, i] > 0.5:
                                thin[a] += geometry[k, i, AREA]
                    begin = j
                a, b, length = x, y, 0.0
            length += geometry[j, i, VB]
    _add_pinches(xs, ys, rooms, notches, made, thin)


@kernel
def total_energy(cells: Cells, goal: Goal, state: State, width: Floats) -> float:
    """Return the whole energy of `state`."""
    scan_runs(
        cells.xs,
        cells.ys,
        cells.geometry,
        goal.rooms,
        goal.side,
        state.labels,
        state.run,
        state.thin,
        width,
    )
    energy = room_energy(goal.rooms, goal.weights, state.stats, state.contact, state.straddle)
    energy += edge_energy(
        goal.links, goal.need, goal.apart, goal.weights, state.stats, state.contact, state.run, True
    )
    return energy + thin_energy(goal.rooms, goal.weights, state.thin)
