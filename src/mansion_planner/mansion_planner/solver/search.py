"""Search over partitions by moving walls: simulated annealing with a fixed number of proposals.

A proposal shifts a straight run of wall by some grid lines, swaps two rooms, or sets one room to a rectangle from a
list. It is kept when every room that it touched is still one piece and the energy allows it (Metropolis).
"""

from typing import NamedTuple

import numpy as np

from mansion_planner.solver.draws import draw, uniform
from mansion_planner.solver.jit import kernel
from mansion_planner.solver.moves import shift_wall, swap_rooms
from mansion_planner.solver.objective import edge_energy, room_cost, room_energy, thin_energy, total_energy
from mansion_planner.solver.painting import recount
from mansion_planner.solver.pieces import still_whole
from mansion_planner.solver.rectangles import place_rectangle, random_rectangle
from mansion_planner.solver.state import Cells, Floats, Goal, Ints, State
from mansion_planner.solver.widths import border_sums, scan_runs

__all__ = ["anneal"]


class _Scratch(NamedTuple):
    """Working arrays of one search, made once and passed to the kernels of each proposal.

    ``changes`` records a proposal's painted cells, ``touched`` the labels that they concern (``marks`` tells which are
    listed); the others belong to `still_whole` (``stack``, ``seen``, ``stamps``), `scan_runs` (``sums``, ``few``,
    ``narrow``) and the rectangles (``box``).
    """

    changes: Ints
    marks: Ints
    touched: Ints
    stack: Ints
    seen: Ints
    stamps: Ints
    sums: Floats
    few: Ints
    narrow: Floats
    box: Ints


@kernel
def _make_scratch(cells: Cells, total: int) -> _Scratch:
    """Return working arrays for a grid and `total` labels."""
    rows, columns = cells.free.shape
    return _Scratch(
        np.empty((4 * rows * columns, 3), np.int64),
        np.zeros(total, np.int64),
        np.empty(total, np.int64),
        np.empty(4 * rows * columns, np.int64),
        np.zeros((rows, columns), np.int64),
        np.zeros(1, np.int64),
        border_sums(cells.geometry),
        np.empty((rows, columns), np.int64),
        np.empty((rows, columns)),
        np.zeros(5, np.int64),
    )


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
def _propose(
    cells: Cells,
    goal: Goal,
    state: State,
    boxes: Ints,
    scratch: _Scratch,
    rng: Ints,
    reach: int,
    swaps: float,
    jumps: float,
) -> int:
    """Paint one random move; return the number of records (0: nothing to do)."""
    geometry, near, free, labels = cells.geometry, cells.near, cells.free, state.labels
    stats, contact, straddle = state.stats, state.contact, state.straddle
    changes, box = scratch.changes, scratch.box
    u = uniform(rng)
    if u < swaps:
        return swap_rooms(geometry, near, labels, stats, contact, straddle, changes, rng, goal.rooms)
    if u >= swaps + jumps:
        return shift_wall(geometry, near, free, labels, stats, contact, straddle, changes, rng, reach)
    if boxes.shape[0] > 0:
        box[:] = boxes[draw(rng) % boxes.shape[0]]
    elif not random_rectangle(cells.xs, cells.ys, free, goal.rooms, goal.links, goal.need, labels, contact, rng, box):
        return 0
    return place_rectangle(
        geometry, near, free, labels, stats, contact, straddle, changes, box[0], box[1], box[2], box[3], box[4]
    )


@kernel
def _energy_within(
    cells: Cells, goal: Goal, state: State, costs: Floats, scratch: _Scratch, made: int, limit: float
) -> float:
    """Return the energy after a move, or infinity where a bound is above `limit` or a touched room is in pieces.

    The cheap parts come first: most moves need neither the search for pieces nor the scan of all walls.
    """
    rooms, links, need, apart = goal.rooms, goal.links, goal.need, goal.apart
    weights, stats, contact, run = goal.weights, state.stats, state.contact, state.run
    shape = room_energy(rooms, weights, stats, state.straddle, costs)
    if shape > limit:
        return np.inf
    if shape + edge_energy(links, need, apart, weights, stats, contact, run, False) > limit:
        return np.inf
    if not still_whole(
        cells.geometry,
        state.labels,
        stats,
        scratch.changes,
        made,
        scratch.stack,
        scratch.seen,
        scratch.stamps,
        rooms.shape[0],
    ):
        return np.inf
    scan_runs(
        cells.xs, cells.ys, scratch.sums, rooms, goal.side, state.labels, run, state.thin, scratch.few, scratch.narrow
    )
    found = shape + thin_energy(rooms, weights, state.thin)
    return found + edge_energy(links, need, apart, weights, stats, contact, run, True)


@kernel
def _repaint_back(labels: Ints, changes: Ints, made: int) -> None:
    """Undo the recorded changes of labels, last first."""
    for k in range(made - 1, -1, -1):
        labels[changes[k, 0], changes[k, 1]] = changes[k, 2]


@kernel
def _walk(
    cells: Cells,
    goal: Goal,
    state: State,
    boxes: Ints,
    scratch: _Scratch,
    rng: Ints,
    costs: Floats,
    energy: float,
    proposals: int,
    hot: float,
    cold: float,
    reach: int,
    swaps: float,
    jumps: float,
) -> Ints:
    """Propose, and keep or undo, from a state of known `energy` and `costs`; return the labels of the best met."""
    labels, stats, contact, straddle = state.labels, state.stats, state.contact, state.straddle
    changes, touched = scratch.changes, scratch.touched
    n, outside = goal.rooms.shape[0], stats.shape[0] - 1
    kept_stats, kept_contact, kept_costs = stats.copy(), contact.copy(), costs.copy()
    kept_straddle = straddle[0]
    best, best_labels = energy, labels.copy()
    ratio = (cold / hot) ** (1.0 / max(1, proposals)) if hot > 0.0 else 1.0
    heat = hot
    for _ in range(proposals):
        heat *= ratio
        made = _propose(cells, goal, state, boxes, scratch, rng, reach, swaps, jumps)
        if made == 0:
            continue
        count = _touched(labels, changes, made, scratch.marks, touched)
        limit = energy + 1e-12
        if heat > 0.0:
            limit = energy - heat * np.log(uniform(rng) + 1e-12)
        for k in range(count):
            r = touched[k]
            if r < n:
                costs[r] = room_cost(goal.rooms, goal.weights, stats, contact, outside, r)
        found = _energy_within(cells, goal, state, costs, scratch, made, limit)
        if found <= limit:
            energy = found
            if energy < best - 1e-9:
                best = energy
                best_labels[:, :] = labels
            _copy(stats, contact, costs, kept_stats, kept_contact, kept_costs, touched, count)
            kept_straddle = straddle[0]
        else:
            _repaint_back(labels, changes, made)
            _copy(kept_stats, kept_contact, kept_costs, stats, contact, costs, touched, count)
            straddle[0] = kept_straddle
    return best_labels


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
    outside = state.stats.shape[0] - 1
    rng = np.array([seed], dtype=np.int64)
    for _ in range(4):
        draw(rng)
    scratch = _make_scratch(cells, outside + 1)
    recount(cells, state)
    energy = total_energy(cells, goal, state)
    costs = np.empty(goal.rooms.shape[0])
    for r in range(costs.size):
        costs[r] = room_cost(goal.rooms, goal.weights, state.stats, state.contact, outside, r)
    state.labels[:, :] = _walk(
        cells, goal, state, boxes, scratch, rng, costs, energy, proposals, hot, cold, reach, swaps, jumps
    )
    recount(cells, state)
    return total_energy(cells, goal, state)
