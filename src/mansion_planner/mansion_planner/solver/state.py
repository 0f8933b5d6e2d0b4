"""Arrays of the wall search: the cells of a grid, the goal, and the state of one partition.

The partition is a label for each cell: rooms 0 to n-1, obstacles (cores, fixed rooms) n to m-2, and m-1 for the
outside. All statistics that the energy needs are kept up to date cell by cell. The kernels take plain arrays: a named
tuple of many arrays costs more to pass than the work it is passed for.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

__all__ = ["Cells", "Goal", "State", "make_state"]

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
