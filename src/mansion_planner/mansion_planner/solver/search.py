"""Search over partitions by moving walls: simulated annealing with a fixed number of proposals.

A proposal shifts a straight run of wall by some grid lines, swaps two rooms, or sets one room to a rectangle from a
list. It is kept when every room that it touched is still one piece and the energy allows it (Metropolis).
"""

import numpy as np

from mansion_planner.solver.jit import kernel
from mansion_planner.solver.moves import (
    draw,
    place_rectangle,
    random_rectangle,
    shift_wall,
    swap_rooms,
    undo,
    uniform,
)
from mansion_planner.solver.objective import (
    edge_energy,
    room_energy,
    scan_runs,
    thin_energy,
    total_energy,
)
from mansion_planner.solver.state import COUNT, HB, VB, Cells, Floats, Goal, Ints, State, recount

__all__ = ["anneal", "piece_size"]


@kernel
def piece_size(
    geometry: Floats, labels: Ints, j: int, i: int, stack: Ints, seen: Ints, stamp: int
) -> int:
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
def _still_whole(
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


@kernel
def anneal(
    cells: Cells,
    goal: Goal,
    state: State,
    boxes: Ints,
    proposals: int,
    hot: float,
    cold: float,
    reach: int,
    swaps: float,
    jumps: float,
    seed: int,
) -> float:
    """Lower the energy of `state` in place and leave it at the best partition met.

    Parameters
    ----------
    boxes : (k, 5) int array
        Rectangles to try: room, first row, last row + 1, first column, last column + 1. None: random ones.
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
    xs, ys, geometry, near, free = cells.xs, cells.ys, cells.geometry, cells.near, cells.free
    labels, stats, contact = state.labels, state.stats, state.contact
    run, thin, straddle = state.run, state.thin, state.straddle
    rooms, links, need, side = goal.rooms, goal.links, goal.need, goal.side
    apart, weights = goal.apart, goal.weights
    rows, columns = labels.shape
    n = rooms.shape[0]
    rng = np.array([seed], dtype=np.int64)
    for _ in range(4):
        draw(rng)
    changes = np.empty((4 * rows * columns, 3), np.int64)
    stack = np.empty(4 * rows * columns, np.int64)
    seen = np.zeros((rows, columns), np.int64)
    stamps = np.zeros(1, np.int64)
    width = np.zeros((rows, columns))
    box = np.zeros(5, np.int64)
    recount(cells, state)
    energy = total_energy(cells, goal, state, width)
    best = energy
    best_labels = labels.copy()
    ratio = (cold / hot) ** (1.0 / max(1, proposals)) if hot > 0.0 else 1.0
    heat = hot
    for _ in range(proposals):
        heat *= ratio
        u = uniform(rng)
        if u < swaps:
            made = swap_rooms(geometry, near, labels, stats, contact, straddle, changes, rng, rooms)
        elif u < swaps + jumps:
            if boxes.shape[0] > 0:
                box[:] = boxes[draw(rng) % boxes.shape[0]]
            elif not random_rectangle(xs, ys, free, rooms, links, need, labels, contact, rng, box):
                continue
            made = place_rectangle(
                geometry,
                near,
                free,
                labels,
                stats,
                contact,
                straddle,
                changes,
                box[0],
                box[1],
                box[2],
                box[3],
                box[4],
            )
        else:
            made = shift_wall(
                geometry, near, free, labels, stats, contact, straddle, changes, rng, reach
            )
        if made == 0:
            continue
        limit = energy + 1e-12
        if heat > 0.0:
            limit = energy - heat * np.log(uniform(rng) + 1e-12)
        shape = room_energy(rooms, weights, stats, contact, straddle)
        ok = False
        if shape <= limit:
            bound = edge_energy(links, need, apart, weights, stats, contact, run, False)
            ok = shape + bound <= limit
        if ok and _still_whole(geometry, labels, stats, changes, made, stack, seen, stamps, n):
            scan_runs(xs, ys, geometry, rooms, side, labels, run, thin, width)
            found = shape + thin_energy(rooms, weights, thin)
            found += edge_energy(links, need, apart, weights, stats, contact, run, True)
            if found <= limit:
                energy = found
                if energy < best - 1e-9:
                    best = energy
                    best_labels[:, :] = labels
                continue
        undo(geometry, near, labels, stats, contact, straddle, changes, made)
    labels[:, :] = best_labels
    recount(cells, state)
    return total_energy(cells, goal, state, width)
