"""Carving: a room reaches, through others, a room or core that it must touch."""

import numpy as np

from mansion_planner.solver.jit import kernel
from mansion_planner.solver.state import AREA, COUNT, HB, VB, Cells, Floats, Goal, Ints, State

__all__ = ["carve_open_links"]

ACCESS = 0


@kernel
def _distances(cells: Cells, labels: Ints, a: int) -> tuple[Floats, Ints]:
    """Return, for each free cell, the ground that a way from room `a` to it takes, and the way's cell before it."""
    rows, columns = labels.shape
    far = np.where(labels == a, 0.0, np.inf)
    before = np.full((rows, columns), -1, np.int64)
    changed = True
    while changed:
        changed = False
        for j in range(1, rows - 1):
            for i in range(1, columns - 1):
                if not cells.free[j, i] or labels[j, i] == a:
                    continue
                for q in range(4):
                    y, x = j + (q == 0) - (q == 1), i + (q == 2) - (q == 3)
                    s = cells.geometry[min(j, y), i, HB] if q < 2 else cells.geometry[j, min(i, x), VB]
                    step = far[y, x] + cells.geometry[j, i, AREA]
                    if s > 1e-6 and step < far[j, i] - 1e-9:
                        far[j, i] = step
                        before[j, i] = y * columns + x
                        changed = True
    return far, before


@kernel
def _carve(cells: Cells, labels: Ints, a: int, b: int) -> bool:
    """Give room `a` the cheapest way to the border of `b`, three cells wide; tell whether there is one."""
    rows, columns = labels.shape
    far, before = _distances(cells, labels, a)
    best, least = -1, np.inf
    for j in range(1, rows - 1):
        for i in range(1, columns - 1):
            if labels[j, i] == b or far[j, i] >= least:
                continue
            if labels[j, i + 1] == b or labels[j, i - 1] == b or labels[j + 1, i] == b or labels[j - 1, i] == b:
                best, least = j * columns + i, far[j, i]
    if best < 0:
        return False
    while best >= 0:
        j, i = best // columns, best % columns
        for y in range(j - 1, j + 2):
            for x in range(i - 1, i + 2):
                if cells.free[y, x] and labels[y, x] != b:
                    labels[y, x] = a
        best = before[j, i]
    return True


@kernel
def carve_open_links(cells: Cells, goal: Goal, state: State) -> Ints:
    """Return labels in which the access links that `state` leaves open are carved, as far as there is a way.

    The room with more cells reaches for the other one. Rooms that this leaves in pieces or without a cell are for
    `flood` to mend.
    """
    labels = state.labels.copy()
    rooms = goal.rooms.shape[0]
    for e in range(goal.links.shape[0]):
        a, b = goal.links[e, 0], goal.links[e, 1]
        if goal.links[e, 2] != ACCESS or state.run[a, b] >= goal.need[e]:
            continue
        if a >= rooms or (b < rooms and state.stats[b, COUNT] > state.stats[a, COUNT]):
            a, b = b, a
        if a < rooms:
            _carve(cells, labels, a, b)
    return labels
