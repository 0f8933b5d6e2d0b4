"""Partitions of a grid into rooms, with statistics that follow every change of a cell.

A partition is a label for each cell: rooms 0 to n-1, obstacles (cores, fixed rooms) n to m-2, and m-1 for the outside.
The kernels take plain arrays: a named tuple of many arrays costs more to pass than the work it is passed for.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from mansion_geometry.compiled import Floats, Ints, kernel
from mansion_planner.solver.grid import AREA, CX, CY, HB, HS, NEAR, VB, VS, Cells, Grid

__all__ = [
    "CORNERS",
    "COUNT",
    "MX",
    "MY",
    "PERIMETER",
    "Partition",
    "SIZE",
    "State",
    "make_state",
    "paint",
    "recount",
    "repaint",
    "still_whole",
]

SIZE, MX, MY, PERIMETER, COUNT, CORNERS = range(6)
"""Last index of `State.stats`."""


class State(NamedTuple):
    """One partition and its running statistics (see `painting.paint`).

    ``stats[label]`` holds area, first moments, perimeter, number of cells, of corners; ``contact`` the wall length of
    each pair of labels, ``run`` the longest straight wall of each pair, ``thin`` each room's area narrower than its
    minimum width, ``straddle`` the length of structural wall inside rooms.
    """

    labels: Ints
    stats: Floats
    contact: Floats
    run: Floats
    thin: Floats
    straddle: Floats


def make_state(labels: Ints, rooms: int, total: int) -> State:
    """Return an empty state for `labels`; `painting.recount` fills in the statistics."""
    return State(
        labels.copy(),
        np.zeros((total, 6)),
        np.zeros((total, total)),
        np.zeros((total, total)),
        np.zeros(rooms),
        np.zeros(1),
    )


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
def recount(cells: Cells, state: State) -> None:
    """Compute every running statistic of `state` from its labels."""
    labels, stats, contact, straddle = state.labels, state.stats, state.contact, state.straddle
    geometry, near = cells.geometry, cells.near
    rows, columns = labels.shape
    stats[:, :] = 0.0
    contact[:, :] = 0.0
    straddle[0] = 0.0
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
def piece_size(geometry: Floats, labels: Ints, j: int, i: int, stack: Ints, seen: Ints, stamp: int) -> int:
    """Return how many cells can be reached from (j, i) across borders within its label; mark them with `stamp`."""
    r = labels[j, i]
    columns = labels.shape[1]
    top = 0
    stack[0] = j * columns + i
    seen[j, i] = stamp
    found = 0
    while top >= 0:
        p = stack[top]
        top -= 1
        y = p // columns
        x = p - y * columns
        found += 1
        if labels[y, x + 1] == r and seen[y, x + 1] != stamp and geometry[y, x, VB] > 1e-6:
            seen[y, x + 1] = stamp
            top += 1
            stack[top] = p + 1
        if labels[y, x - 1] == r and seen[y, x - 1] != stamp and geometry[y, x - 1, VB] > 1e-6:
            seen[y, x - 1] = stamp
            top += 1
            stack[top] = p - 1
        if labels[y + 1, x] == r and seen[y + 1, x] != stamp and geometry[y, x, HB] > 1e-6:
            seen[y + 1, x] = stamp
            top += 1
            stack[top] = p + columns
        if labels[y - 1, x] == r and seen[y - 1, x] != stamp and geometry[y - 1, x, HB] > 1e-6:
            seen[y - 1, x] = stamp
            top += 1
            stack[top] = p - columns
    return found


@kernel
def still_whole(
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
            size = piece_size(geometry, labels, y, x, stack, seen, stamps[0])
            if size != int(stats[labels[y, x], COUNT] + 0.5):
                return False
        for q in range(4):
            yy = y + (q == 0) - (q == 1)
            xx = x + (q == 2) - (q == 3)
            if labels[yy, xx] == z and seen[yy, xx] < first and z < rooms:
                stamps[0] += 1
                size = piece_size(geometry, labels, yy, xx, stack, seen, stamps[0])
                if size != int(stats[z, COUNT] + 0.5):
                    return False
    return True
