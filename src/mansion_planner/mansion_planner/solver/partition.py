"""Partitions of a grid into rooms: statistics that follow every change of a cell, and whether a room is one piece.

A partition is a label for each cell: rooms 0 to n-1, obstacles (cores, fixed rooms) n to m-2, and m-1 for the outside.
The kernels take plain arrays: a named tuple of many arrays costs more to pass than the work it is passed for.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from mansion_geometry.compiled import Floats, Ints, kernel
from mansion_planner.solver.grid import AREA, CX, CY, HB, HS, NEAR, VB, VS, Cells, Grid
from mansion_planner.solver.problem import Goal
from mansion_planner.solver.walls import border_sums, scan_walls

__all__ = [
    "CORNERS",
    "COUNT",
    "LEAST_BORDER",
    "MX",
    "MY",
    "PERIMETER",
    "Partition",
    "SIZE",
    "State",
    "component",
    "make_state",
    "neighbour",
    "paint",
    "repaint",
    "rooms_connected",
]

SIZE, MX, MY, PERIMETER, COUNT, CORNERS = range(6)
"""Last index of `State.stats`."""


LEAST_BORDER = 1e-6
"""Length of a border, metres, above which it connects its cells."""


class State(NamedTuple):
    """One partition and its statistics, updated by `paint` (``straight`` and ``thin`` by `scan_walls`).

    ``stats[label]`` holds area (m2), first moments (m3), perimeter (m), number of cells and of corners; ``contact`` the
    length of wall that each pair of labels shares and ``straight`` the longest straight part of it (m); ``thin`` each
    room's area that is narrower than its minimum width (m2); ``straddle`` the length of structural wall inside rooms
    (m), in an array of one number so that kernels can update it.
    """

    labels: Ints
    stats: Floats
    contact: Floats
    straight: Floats
    thin: Floats
    straddle: Floats


@dataclass(frozen=True)
class Partition:
    """A labelled grid and its energy."""

    grid: Grid
    labels: Ints
    energy: float


@kernel
def _corners_at(stats: Floats, a: int, b: int, c: int, d: int, sign: float) -> None:
    """Add (or take away) what a vertex between cells a, b (below, left to right) and c, d (above) gives to corners.

    A label at one or three of the cells has a corner there, one at two cells across has two.
    """
    if (a == b and c == d) or (a == c and b == d):
        return
    if a == d:
        if b == a:
            stats[a, CORNERS] += sign
            stats[c, CORNERS] += sign
        elif c == a:
            stats[a, CORNERS] += sign
            stats[b, CORNERS] += sign
        else:
            stats[a, CORNERS] += 2.0 * sign
            stats[b, CORNERS] += sign
            stats[c, CORNERS] += sign
    elif b == c:
        if a == b:
            stats[b, CORNERS] += sign
            stats[d, CORNERS] += sign
        elif d == b:
            stats[b, CORNERS] += sign
            stats[a, CORNERS] += sign
        else:
            stats[b, CORNERS] += 2.0 * sign
            stats[a, CORNERS] += sign
            stats[d, CORNERS] += sign
    else:
        if a != b and a != c:
            stats[a, CORNERS] += sign
        if b != a and b != d:
            stats[b, CORNERS] += sign
        if c != a and c != d:
            stats[c, CORNERS] += sign
        if d != b and d != c:
            stats[d, CORNERS] += sign


@kernel
def _border(contact: Floats, straddle: Floats, old: int, new: int, other: int, length: float, wall: float) -> float:
    """Move one border of a cell from label `old` to `new`; return what both perimeters gain by their common wall."""
    if other == old:
        contact[old, new] += length
        contact[new, old] += length
        straddle[0] -= wall
        return length
    if other == new:
        contact[old, new] -= length
        contact[new, old] -= length
        straddle[0] += wall
        return -length
    contact[old, other] -= length
    contact[other, old] -= length
    contact[new, other] += length
    contact[other, new] += length
    return 0.0


@kernel
def paint(
    geometry: Floats,
    near: Ints,
    labels: Ints,
    stats: Floats,
    contact: Floats,
    straddle: Floats,
    j: int,
    i: int,
    new: int,
) -> None:
    """Give cell (j, i) the label `new`, which it has not, and update every statistic."""
    old = labels[j, i]
    n, s, e, w = labels[j + 1, i], labels[j - 1, i], labels[j, i + 1], labels[j, i - 1]
    ne, nw = labels[j + 1, i + 1], labels[j + 1, i - 1]
    se, sw = labels[j - 1, i + 1], labels[j - 1, i - 1]
    _corners_at(stats, old, e, n, ne, -1.0)
    _corners_at(stats, w, old, nw, n, -1.0)
    _corners_at(stats, s, se, old, e, -1.0)
    _corners_at(stats, sw, s, w, old, -1.0)
    _corners_at(stats, new, e, n, ne, 1.0)
    _corners_at(stats, w, new, nw, n, 1.0)
    _corners_at(stats, s, se, new, e, 1.0)
    _corners_at(stats, sw, s, w, new, 1.0)
    labels[j, i] = new
    a = geometry[j, i, AREA]
    x, y = a * geometry[j, i, CX], a * geometry[j, i, CY]
    east, west = geometry[j, i, VB], geometry[j, i - 1, VB]
    north, south = geometry[j, i, HB], geometry[j - 1, i, HB]
    both = _border(contact, straddle, old, new, e, east, geometry[j, i, VS])
    both += _border(contact, straddle, old, new, w, west, geometry[j, i - 1, VS])
    both += _border(contact, straddle, old, new, n, north, geometry[j, i, HS])
    both += _border(contact, straddle, old, new, s, south, geometry[j - 1, i, HS])
    stats[old, COUNT] -= 1.0
    stats[old, SIZE] -= a
    stats[old, MX] -= x
    stats[old, MY] -= y
    stats[new, COUNT] += 1.0
    stats[new, SIZE] += a
    stats[new, MX] += x
    stats[new, MY] += y
    apart = 0.0
    apart += east if e != old and e != new else 0.0
    apart += west if w != old and w != new else 0.0
    apart += north if n != old and n != new else 0.0
    apart += south if s != old and s != new else 0.0
    stats[old, PERIMETER] += both - apart
    stats[new, PERIMETER] += both + apart
    length = geometry[j, i, NEAR]
    if length > 0.0:
        k = near[j, i]
        contact[old, k] -= length
        contact[k, old] -= length
        contact[new, k] += length
        contact[k, new] += length


@kernel
def repaint(
    geometry: Floats,
    near: Ints,
    labels: Ints,
    stats: Floats,
    contact: Floats,
    straddle: Floats,
    changes: Ints,
    made: int,
    j: int,
    i: int,
    new: int,
) -> int:
    """Paint a cell, record its row, column and old label, and return the new number of records."""
    changes[made, 0] = j
    changes[made, 1] = i
    changes[made, 2] = labels[j, i]
    paint(geometry, near, labels, stats, contact, straddle, j, i, new)
    return made + 1


@kernel
def _meet(stats: Floats, contact: Floats, x: int, y: int, length: float) -> None:
    """Count a border between labels `x` and `y`."""
    contact[x, y] += length
    contact[y, x] += length
    stats[x, PERIMETER] += length
    stats[y, PERIMETER] += length


@kernel
def _count(cells: Cells, state: State) -> None:
    """Add every running statistic to the zeros of a new `state`."""
    labels, stats, contact, straddle = state.labels, state.stats, state.contact, state.straddle
    geometry, near = cells.geometry, cells.near
    rows, columns = labels.shape
    for j in range(rows):
        for i in range(columns):
            x = labels[j, i]
            a = geometry[j, i, AREA]
            stats[x, COUNT] += 1.0
            stats[x, SIZE] += a
            stats[x, MX] += a * geometry[j, i, CX]
            stats[x, MY] += a * geometry[j, i, CY]
            if j + 1 < rows and i + 1 < columns:
                _corners_at(stats, x, labels[j, i + 1], labels[j + 1, i], labels[j + 1, i + 1], 1.0)
            if i + 1 < columns and labels[j, i + 1] != x:
                _meet(stats, contact, x, labels[j, i + 1], geometry[j, i, VB])
            elif i + 1 < columns:
                straddle[0] += geometry[j, i, VS]
            if j + 1 < rows and labels[j + 1, i] != x:
                _meet(stats, contact, x, labels[j + 1, i], geometry[j, i, HB])
            elif j + 1 < rows:
                straddle[0] += geometry[j, i, HS]
            length = geometry[j, i, NEAR]
            if length > 0.0:
                contact[x, near[j, i]] += length
                contact[near[j, i], x] += length


@kernel
def make_state(cells: Cells, goal: Goal, labels: Ints) -> State:
    """Return the state of a partition with every statistic counted from its `labels`."""
    rooms, total = goal.rooms.shape[0], goal.side.size
    state = State(
        labels.copy(),
        np.zeros((total, 6)),
        np.zeros((total, total)),
        np.zeros((total, total)),
        np.zeros(rooms),
        np.zeros(1),
    )
    _count(cells, state)
    scan_walls(
        cells.xs,
        cells.ys,
        border_sums(cells.geometry),
        goal.rooms,
        goal.side,
        labels,
        state.straight,
        state.thin,
        np.empty(labels.shape, np.int64),
        np.empty(labels.shape),
    )
    return state


@kernel
def neighbour(geometry: Floats, j: int, i: int, q: int) -> tuple[int, int, float]:
    """Return the cell north, south, east or west (`q` 0 to 3) of cell (j, i), and the length of their border."""
    y, x = j + (q == 0) - (q == 1), i + (q == 2) - (q == 3)
    border = geometry[min(j, y), i, HB] if q < 2 else geometry[j, min(i, x), VB]
    return y, x, float(border)


@kernel
def component(geometry: Floats, labels: Ints, j: int, i: int, stack: Ints, seen: Ints, stamp: int) -> tuple[int, float]:
    """Return the number of cells and the area, m2, of the connected component of cell (j, i); mark it with `stamp`.

    Cells that meet along a border inside the free region are connected (depth-first search).

    Parameters
    ----------
    stack : (rows * columns,) int array
        Scratch.
    seen : (rows, columns) int array
        Receives the stamp.
    """
    r = labels[j, i]
    columns = labels.shape[1]
    stack[0] = j * columns + i
    seen[j, i] = stamp
    top, cells, area = 0, 0, 0.0
    while top >= 0:
        p = stack[top]
        top -= 1
        y = p // columns
        x = p - y * columns
        cells += 1
        area += geometry[y, x, AREA]
        # Written out, because this search takes a large part of the time of an annealing run.
        if labels[y + 1, x] == r and seen[y + 1, x] != stamp and geometry[y, x, HB] > LEAST_BORDER:
            seen[y + 1, x] = stamp
            top += 1
            stack[top] = p + columns
        if labels[y - 1, x] == r and seen[y - 1, x] != stamp and geometry[y - 1, x, HB] > LEAST_BORDER:
            seen[y - 1, x] = stamp
            top += 1
            stack[top] = p - columns
        if labels[y, x + 1] == r and seen[y, x + 1] != stamp and geometry[y, x, VB] > LEAST_BORDER:
            seen[y, x + 1] = stamp
            top += 1
            stack[top] = p + 1
        if labels[y, x - 1] == r and seen[y, x - 1] != stamp and geometry[y, x - 1, VB] > LEAST_BORDER:
            seen[y, x - 1] = stamp
            top += 1
            stack[top] = p - 1
    return cells, area


@kernel
def rooms_connected(
    geometry: Floats,
    labels: Ints,
    stats: Floats,
    changes: Ints,
    made: int,
    stack: Ints,
    seen: Ints,
    stamps: Ints,
    rooms: int,
) -> bool:
    """Tell whether every room that the recorded changes touched is one piece and not empty."""
    first = stamps[0] + 1
    for k in range(made):
        y, x = changes[k, 0], changes[k, 1]
        z = changes[k, 2]
        if stats[z, COUNT] < 0.5:
            return False
        if seen[y, x] < first:
            stamps[0] += 1
            size = component(geometry, labels, y, x, stack, seen, stamps[0])[0]
            if size != int(stats[labels[y, x], COUNT] + 0.5):
                return False
        for q in range(4):
            yy, xx, _ = neighbour(geometry, y, x, q)
            if labels[yy, xx] == z and seen[yy, xx] < first and z < rooms:
                stamps[0] += 1
                size = component(geometry, labels, yy, xx, stack, seen, stamps[0])[0]
                if size != int(stats[z, COUNT] + 0.5):
                    return False
    return True
