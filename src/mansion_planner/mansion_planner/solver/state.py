"""Arrays of the wall search: the cells of a grid, the goal, and the state of one partition.

The partition is a label for each cell: rooms 0 to n-1, obstacles (cores, fixed rooms) n to m-2, and m-1 for the
outside. All statistics that the energy needs are kept up to date cell by cell. The kernels take plain arrays: a named
tuple of many arrays costs more to pass than the work it is passed for.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from mansion_planner.solver.jit import kernel

__all__ = ["Cells", "Goal", "State", "make_state", "paint", "recount"]

Floats = NDArray[np.float64]
Ints = NDArray[np.int64]
Bools = NDArray[np.bool_]

AREA, CX, CY, HB, VB, HS, VS, NEAR = range(8)
"""Last index of `Cells.geometry`."""

SIZE, MX, MY, PERIMETER, COUNT, CORNERS = range(6)
"""Last index of `State.stats`."""

TARGET, SEED_X, SEED_Y, SEED_WEIGHT, MIN_WIDTH, SHAPE_WEIGHT, CORNER_WEIGHT, WALL_WEIGHT = range(8)
"""Last index of `Goal.rooms`."""


class Cells(NamedTuple):
    """A grid of cells between lines, with a frame of outside cells around it.

    ``geometry[j, i]`` holds the area and centroid of the part of cell (j, i) inside the free region (AREA, CX, CY), the
    length of its border with cell (j+1, i) (HB) and with (j, i+1) (VB), the structural wall on these (HS, VS), and the
    length of an obstacle's slanted side through the cell (NEAR), whose label is ``near[j, i]``.
    """

    xs: Floats
    ys: Floats
    geometry: Floats
    near: Ints
    free: Bools


class Goal(NamedTuple):
    """What the search wants.

    ``rooms[r]`` holds target area, seed, weights and minimum width; ``links`` are rows of two labels and a kind (0
    access, 1 adjacent) and the wall length they ``need``; ``side`` gives, for each label, the side on which a core
    may be entered (0 any, 1 north, 2 east, 3 south, 4 west); ``apart`` lists pairs that should not touch.
    """

    rooms: Floats
    links: Ints
    need: Floats
    side: Ints
    apart: Ints
    weights: Floats


class State(NamedTuple):
    """One partition and its running statistics (see `paint`).

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
    """Return an empty state for `labels`; `recount` fills in the statistics."""
    return State(
        labels.copy(),
        np.zeros((total, 6)),
        np.zeros((total, total)),
        np.zeros((total, total)),
        np.zeros(rooms),
        np.zeros(1),
    )


@kernel
def corners_at(labels: Ints, stats: Floats, j: int, i: int, sign: float) -> None:
    """Add (or take away) what the vertex above right of cell (j, i) gives to the corner counts."""
    a, b, c, d = labels[j, i], labels[j, i + 1], labels[j + 1, i], labels[j + 1, i + 1]
    if a == b and c == d:
        return
    if a == c and b == d:
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
            stats[x, CORNERS] += sign
        elif k == 2 and ((a == x and d == x) or (b == x and c == x)):
            stats[x, CORNERS] += 2.0 * sign


@kernel
def _border(
    stats: Floats,
    contact: Floats,
    straddle: Floats,
    old: int,
    new: int,
    other: int,
    length: float,
    wall: float,
) -> None:
    """Move one border of a cell from label `old` to label `new`."""
    if other != old:
        contact[old, other] -= length
        contact[other, old] -= length
        stats[old, PERIMETER] -= length
        stats[other, PERIMETER] -= length
    else:
        straddle[0] -= wall
    if other != new:
        contact[new, other] += length
        contact[other, new] += length
        stats[new, PERIMETER] += length
        stats[other, PERIMETER] += length
    else:
        straddle[0] += wall


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
    """Give cell (j, i) the label `new` and update every statistic."""
    old = labels[j, i]
    corners_at(labels, stats, j, i, -1.0)
    corners_at(labels, stats, j - 1, i, -1.0)
    corners_at(labels, stats, j, i - 1, -1.0)
    corners_at(labels, stats, j - 1, i - 1, -1.0)
    labels[j, i] = new
    corners_at(labels, stats, j, i, 1.0)
    corners_at(labels, stats, j - 1, i, 1.0)
    corners_at(labels, stats, j, i - 1, 1.0)
    corners_at(labels, stats, j - 1, i - 1, 1.0)
    a = geometry[j, i, AREA]
    x, y = a * geometry[j, i, CX], a * geometry[j, i, CY]
    stats[old, COUNT] -= 1.0
    stats[new, COUNT] += 1.0
    stats[old, SIZE] -= a
    stats[new, SIZE] += a
    stats[old, MX] -= x
    stats[new, MX] += x
    stats[old, MY] -= y
    stats[new, MY] += y
    _border(
        stats, contact, straddle, old, new, labels[j, i + 1], geometry[j, i, VB], geometry[j, i, VS]
    )
    _border(
        stats,
        contact,
        straddle,
        old,
        new,
        labels[j, i - 1],
        geometry[j, i - 1, VB],
        geometry[j, i - 1, VS],
    )
    _border(
        stats, contact, straddle, old, new, labels[j + 1, i], geometry[j, i, HB], geometry[j, i, HS]
    )
    _border(
        stats,
        contact,
        straddle,
        old,
        new,
        labels[j - 1, i],
        geometry[j - 1, i, HB],
        geometry[j - 1, i, HS],
    )
    s = geometry[j, i, NEAR]
    if s > 0.0:
        k = near[j, i]
        contact[old, k] -= s
        contact[k, old] -= s
        contact[new, k] += s
        contact[k, new] += s


@kernel
def recount(cells: Cells, state: State) -> None:
    """Compute every statistic of `state` from its labels."""
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
                corners_at(labels, stats, j, i, 1.0)
            for q in range(2):
                if q == 0:
                    if i + 1 >= columns:
                        continue
                    y, s, w = labels[j, i + 1], geometry[j, i, VB], geometry[j, i, VS]
                else:
                    if j + 1 >= rows:
                        continue
                    y, s, w = labels[j + 1, i], geometry[j, i, HB], geometry[j, i, HS]
                if x != y:
                    contact[x, y] += s
                    contact[y, x] += s
                    stats[x, PERIMETER] += s
                    stats[y, PERIMETER] += s
                else:
                    straddle[0] += w
            s = geometry[j, i, NEAR]
            if s > 0.0:
                k = near[j, i]
                contact[x, k] += s
                contact[k, x] += s
