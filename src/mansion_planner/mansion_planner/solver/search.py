"""Search over partitions by moving walls: simulated annealing with a fixed number of proposals.

A proposal shifts a straight run of wall by some grid lines, swaps two rooms, or sets one room to a rectangle from a
list. It is kept when every room that it touched is still one piece and the energy allows it (Metropolis).
"""

import numpy as np

from mansion_planner.solver.draws import draw, uniform
from mansion_planner.solver.jit import kernel
from mansion_planner.solver.moves import shift_wall, swap_rooms
from mansion_planner.solver.objective import (
    edge_energy,
    room_cost,
    room_energy,
    thin_energy,
    total_energy,
)
from mansion_planner.solver.painting import recount
from mansion_planner.solver.pieces import still_whole
from mansion_planner.solver.rectangles import place_rectangle, random_rectangle
from mansion_planner.solver.state import Cells, Floats, Goal, Ints, State
from mansion_planner.solver.widths import border_sums, scan_runs

__all__ = ["anneal"]


@kernel
def _touched(labels: Ints, changes: Ints, made: int, marks: Ints, found: Ints) -> int:
    """List the labels that the recorded changes took cells from or gave cells to; return how many there are."""
    count = 0
    for k in range(made):
        old, new = changes[k, 2], labels[changes[k, 0], changes[k, 1]]
        if marks[old] == 0:
            marks[old] = 1
            found[count] = old
            count += 1
        if marks[new] == 0:
            marks[new] = 1
            found[count] = new
            count += 1
    for k in range(count):
        marks[found[k]] = 0
    return count


@kernel
def _copy(
    stats: Floats,
    contact: Floats,
    costs: Floats,
    to_stats: Floats,
    to_contact: Floats,
    to_costs: Floats,
    touched: Ints,
    count: int,
) -> None:
    """Copy all statistics that a move of the `touched` labels can have changed."""
    total = stats.shape[0]
    for x in range(total):
        for k in range(stats.shape[1]):
            to_stats[x, k] = stats[x, k]
    for k in range(count):
        t = touched[k]
        if t < costs.size:
            to_costs[t] = costs[t]
        for x in range(total):
            to_contact[t, x] = contact[t, x]
            to_contact[x, t] = contact[x, t]


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
    n, total = rooms.shape[0], stats.shape[0]
    rng = np.array([seed], dtype=np.int64)
    for _ in range(4):
        draw(rng)
    changes = np.empty((4 * rows * columns, 3), np.int64)
    stack = np.empty(4 * rows * columns, np.int64)
    seen = np.zeros((rows, columns), np.int64)
    stamps = np.zeros(1, np.int64)
    few = np.empty((rows, columns), np.int64)
    narrow = np.empty((rows, columns))
    sums = border_sums(geometry)
    box = np.zeros(5, np.int64)
    marks, touched = np.zeros(total, np.int64), np.empty(total, np.int64)
    recount(cells, state)
    energy = total_energy(cells, goal, state)
    costs = np.empty(n)
    for r in range(n):
        costs[r] = room_cost(rooms, weights, stats, contact, total - 1, r)
    kept_stats, kept_contact, kept_costs = stats.copy(), contact.copy(), costs.copy()
    kept_straddle = straddle[0]
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
        count = _touched(labels, changes, made, marks, touched)
        limit = energy + 1e-12
        if heat > 0.0:
            limit = energy - heat * np.log(uniform(rng) + 1e-12)
        for k in range(count):
            r = touched[k]
            if r < n:
                costs[r] = room_cost(rooms, weights, stats, contact, total - 1, r)
        shape = room_energy(rooms, weights, stats, straddle, costs)
        ok = False
        if shape <= limit:
            bound = edge_energy(links, need, apart, weights, stats, contact, run, False)
            ok = shape + bound <= limit
        if ok and still_whole(geometry, labels, stats, changes, made, stack, seen, stamps, n):
            scan_runs(xs, ys, sums, rooms, side, labels, run, thin, few, narrow)
            found = shape + thin_energy(rooms, weights, thin)
            found += edge_energy(links, need, apart, weights, stats, contact, run, True)
            if found <= limit:
                energy = found
                if energy < best - 1e-9:
                    best = energy
                    best_labels[:, :] = labels
                _copy(stats, contact, costs, kept_stats, kept_contact, kept_costs, touched, count)
                kept_straddle = straddle[0]
                continue
        for k in range(made - 1, -1, -1):
            labels[changes[k, 0], changes[k, 1]] = changes[k, 2]
        _copy(kept_stats, kept_contact, kept_costs, stats, contact, costs, touched, count)
        straddle[0] = kept_straddle
    labels[:, :] = best_labels
    recount(cells, state)
    return total_energy(cells, goal, state)
