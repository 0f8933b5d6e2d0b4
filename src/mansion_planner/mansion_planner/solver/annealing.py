"""Simulated annealing of partitions: random moves of walls, kept or undone by the Metropolis rule.

A proposal shifts a straight run of wall by some grid lines, swaps two rooms, or sets one room to a rectangle. It is
kept when every room that it touched is still connected and the energy allows it.

References
----------
S. Kirkpatrick, C. D. Gelatt and M. P. Vecchi (1983). Optimization by simulated annealing. Science 220, 671-680.
"""

from typing import NamedTuple

import numpy as np

from mansion_geometry.compiled import Floats, Ints, kernel
from mansion_planner.solver.energy import edge_energy, room_cost, room_costs, room_energy, thin_energy, total_energy
from mansion_planner.solver.grid import Cells, Grid, make_grid, refined_grid, resample, spaced_lines
from mansion_planner.solver.moves import draw, place_rectangle, random_rectangle, shift_wall, swap_rooms, uniform
from mansion_planner.solver.options import Budget, SolverOptions
from mansion_planner.solver.partition import Partition, State, make_state, rooms_connected
from mansion_planner.solver.problem import FloorModel, Goal, mostly_seeded
from mansion_planner.solver.starts import fit_rectangles
from mansion_planner.solver.walls import border_sums, scan_walls

__all__ = ["Annealing", "Schedule", "anneal"]


class Schedule(NamedTuple):
    """How long a run goes on, how warm it is, and what it proposes.

    ``proposals`` candidates are looked at, while the temperature falls geometrically from ``start_temperature`` to
    ``end_temperature`` (0 for descent). ``swap_share`` and ``rectangle_share`` are the shares of room swaps and of
    rectangles among the proposals; all others shift a wall, by up to ``reach`` grid lines.
    """

    proposals: int
    start_temperature: float
    end_temperature: float
    reach: int
    swap_share: float
    rectangle_share: float


class _Scratch(NamedTuple):
    """Working arrays of one run, made once, because allocating them for each proposal would cost more than the move.

    ``changes`` records the cells that a proposal paints, ``touched`` the labels that gain or lose cells (``marks``
    tells which are listed); the others belong to `rooms_connected` (``stack``, ``seen``, ``stamps``), `scan_walls`
    (``sums``, ``compressed``, ``narrow``) and the rectangles (``box``).
    """

    changes: Ints
    marks: Ints
    touched: Ints
    stack: Ints
    seen: Ints
    stamps: Ints
    sums: Floats
    compressed: Ints
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
def _changed_labels(labels: Ints, changes: Ints, made: int, marks: Ints, found: Ints) -> int:
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
def _copy_statistics(
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
    cells: Cells, goal: Goal, state: State, boxes: Ints, scratch: _Scratch, rng: Ints, schedule: Schedule
) -> int:
    """Paint one random move; return the number of records (0: nothing to do)."""
    geometry, near, free, labels = cells.geometry, cells.near, cells.free, state.labels
    stats, contact, straddle = state.stats, state.contact, state.straddle
    changes, box = scratch.changes, scratch.box
    u = uniform(rng)
    if u < schedule.swap_share:
        return swap_rooms(geometry, near, labels, stats, contact, straddle, changes, rng, goal.rooms)
    if u >= schedule.swap_share + schedule.rectangle_share:
        return shift_wall(geometry, near, free, labels, stats, contact, straddle, changes, rng, schedule.reach)
    if boxes.shape[0] > 0:
        box[:] = boxes[draw(rng) % boxes.shape[0]]
    elif not random_rectangle(cells.xs, cells.ys, free, goal.rooms, goal.links, goal.need, labels, contact, rng, box):
        return 0
    return place_rectangle(
        geometry, near, free, labels, stats, contact, straddle, changes, box[0], box[1], box[2], box[3], box[4]
    )


@kernel
def _energy_below(
    cells: Cells, goal: Goal, state: State, costs: Floats, scratch: _Scratch, made: int, limit: float
) -> float:
    """Return the energy after a move, or infinity where a lower bound exceeds `limit` or a room falls apart.

    The cheap parts come first: most moves need neither the search for components nor the scan of all walls.
    """
    rooms, links, need, apart = goal.rooms, goal.links, goal.need, goal.apart
    weights, stats, contact, straight = goal.weights, state.stats, state.contact, state.straight
    shape = room_energy(rooms, weights, stats, state.straddle, costs)
    if shape > limit:
        return np.inf
    if shape + edge_energy(links, need, apart, weights, stats, contact, straight, exact=False) > limit:
        return np.inf
    if not rooms_connected(
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
    scan_walls(
        cells.xs,
        cells.ys,
        scratch.sums,
        rooms,
        goal.side,
        state.labels,
        straight,
        state.thin,
        scratch.compressed,
        scratch.narrow,
    )
    found = shape + thin_energy(rooms, weights, state.thin)
    return found + edge_energy(links, need, apart, weights, stats, contact, straight, exact=True)


@kernel
def _undo(labels: Ints, changes: Ints, made: int) -> None:
    """Restore the labels from the records, last first, because a move may paint a cell twice."""
    for k in range(made - 1, -1, -1):
        labels[changes[k, 0], changes[k, 1]] = changes[k, 2]


@kernel
def _cooling(schedule: Schedule) -> float:
    """Return the factor by which the temperature falls with each proposal."""
    if schedule.start_temperature <= 0.0:
        return 1.0
    return float((schedule.end_temperature / schedule.start_temperature) ** (1.0 / max(1, schedule.proposals)))


@kernel
def _metropolis(
    cells: Cells,
    goal: Goal,
    state: State,
    boxes: Ints,
    scratch: _Scratch,
    rng: Ints,
    costs: Floats,
    energy: float,
    schedule: Schedule,
) -> Ints:
    """Propose moves and keep or undo each; return the labels of the partition with the lowest energy met.

    `energy` and `costs` (see `room_costs`) are those of `state`. The statistics of a rejected move are restored from a
    copy rather than painted back, which would cost as much as the move and let rounding errors grow.

    The loop is written out, as `shift_wall` and `paint` are: with helper kernels for their parts a search takes a tenth
    longer.
    """
    labels, stats, contact, straddle = state.labels, state.stats, state.contact, state.straddle
    changes, touched = scratch.changes, scratch.touched
    n, outside = goal.rooms.shape[0], stats.shape[0] - 1
    kept_stats, kept_contact, kept_costs = stats.copy(), contact.copy(), costs.copy()
    kept_straddle = straddle[0]
    best, best_labels = energy, labels.copy()
    temperature, cooling = schedule.start_temperature, _cooling(schedule)
    for _ in range(schedule.proposals):
        temperature *= cooling
        made = _propose(cells, goal, state, boxes, scratch, rng, schedule)
        if made == 0:
            continue
        count = _changed_labels(labels, changes, made, scratch.marks, touched)
        # The Metropolis rule accepts a rise d with probability exp(-d / T). Drawing the number first turns it into a
        # limit on the new energy, so that `_energy_below` may stop at the first bound above it.
        limit = energy + 1e-12
        if temperature > 0.0:
            limit = energy - temperature * np.log(uniform(rng) + 1e-12)
        for k in range(count):
            r = touched[k]
            if r < n:
                costs[r] = room_cost(goal.rooms, goal.weights, stats, contact, outside, r)
        found = _energy_below(cells, goal, state, costs, scratch, made, limit)
        if found <= limit:
            energy = found
            if energy < best - 1e-9:
                best = energy
                best_labels[:, :] = labels
            _copy_statistics(stats, contact, costs, kept_stats, kept_contact, kept_costs, touched, count)
            kept_straddle = straddle[0]
        else:
            _undo(labels, changes, made)
            _copy_statistics(kept_stats, kept_contact, kept_costs, stats, contact, costs, touched, count)
            straddle[0] = kept_straddle
    return best_labels


@kernel
def anneal(cells: Cells, goal: Goal, labels: Ints, boxes: Ints, schedule: Schedule, seed: int) -> tuple[Ints, float]:
    """Lower the energy of a partition by simulated annealing.

    Parameters
    ----------
    labels : (rows, columns) int array
        The partition to start from.
    boxes : (k, 5) int array
        Rectangles to try: room, first row, last row + 1, first column, last column + 1. None: random ones.
    seed : int
        Decides every random draw.

    Returns
    -------
    labels : (rows, columns) int array
        The best partition met.
    energy : float
        Its energy.
    """
    rng = np.array([seed], dtype=np.int64)
    # The first numbers of a linear congruential generator still resemble its seed.
    for _ in range(4):
        draw(rng)
    state = make_state(cells, goal, labels)
    scratch = _make_scratch(cells, goal.side.size)
    costs, energy = room_costs(goal, state), total_energy(goal, state)
    best = _metropolis(cells, goal, state, boxes, scratch, rng, costs, energy, schedule)
    return best, total_energy(goal, make_state(cells, goal, best))


FINE_LEVELS = ((0.22, 0.1), (0.07, 0.03))
"""Offsets, in metres, of the lines that each finer grid puts beside the walls."""

LEAN_LEVELS = ((0.18,), (0.06,))
"""The same for floors of many rooms, whose grids would grow too large."""

MANY_ROOMS = 14
"""Number of rooms from which on a floor is large."""

LONGER = 2
"""Factor of the candidates of a coarse search on large floors, and on seeded ones whose seeds did not suffice."""

REFINING = 400
"""Candidates for each room on each finer grid."""

REACH = 4
"""Most grid lines that a wall is shifted by."""

NO_BOXES = np.zeros((0, 5), np.int64)


class Annealing:
    """Annealing runs for one floor, each of which takes its candidates from the budget.

    Parameters
    ----------
    goal : Goal
    grid : Grid
        The first, coarse grid.
    major : pair of arrays
        Lines that every finer grid keeps.
    """

    def __init__(
        self,
        model: FloorModel,
        goal: Goal,
        grid: Grid,
        major: tuple[Floats, Floats],
        options: SolverOptions,
        budget: Budget,
        rng: np.random.Generator,
    ) -> None:
        self.model, self.goal, self.grid, self.major = model, goal, grid, major
        self.options, self.budget, self.rng = options, budget, rng
        self.rooms = len(model.rooms)
        self.seeded = mostly_seeded(model)
        self.large = self.rooms >= MANY_ROOMS

    def state(self, partition: Partition) -> State:
        """Return the partition's state with all its statistics."""
        return make_state(partition.grid.cells, self.goal, partition.labels)

    def energy(self, partition: Partition) -> float:
        """Return the partition's energy under the unchanged goal."""
        return total_energy(self.goal, self.state(partition))

    def boxes(self) -> tuple[Ints, Floats]:
        """Return the rectangles fitted to the seeds; the hub takes what is left and needs none."""
        boxes, costs = fit_rectangles(self.grid.cells, self.goal, 30)
        return boxes[boxes[:, 0] != 0], costs[boxes[:, 0] != 0]

    def follow_seeds(self, labels: Ints, temperature: float) -> Partition:
        """Search the coarse grid near a start that follows the seeds, with rectangles fitted to them."""
        boxes, wanted = self.boxes()[0], self.rooms * self.options.seeded_proposals
        return self._run(self.grid, labels, boxes, wanted, (temperature, 0.005), (0.0, 0.05))

    def search(self, labels: Ints) -> Partition:
        """Search the whole coarse grid: a small floor briefly, with more rectangles and swaps, as others may follow."""
        wanted, shares = self.rooms * self.options.proposals, (0.1, 0.4)
        if self.large or self.seeded:
            wanted, shares = LONGER * wanted, (0.05, 0.2)
        return self._run(self.grid, labels, NO_BOXES, wanted, (0.6, 0.01), shares)

    def continue_search(self, partition: Partition) -> Partition:
        """Search on from a valid partition of the coarse grid, at half the temperature and without swaps."""
        wanted = self.rooms * self.options.proposals
        return self._run(self.grid, partition.labels, NO_BOXES, wanted, (0.3, 0.01), (0.0, 0.1))

    def adjust_planned(self, planned: Partition) -> Partition:
        """Move the walls of a planned layout a little, at low temperature, so that its edges are realised."""
        xs, ys = planned.grid.cells.xs[1:-1], planned.grid.cells.ys[1:-1]
        spacing = 1.25 * self.options.spacing
        grid = make_grid(self.model, spaced_lines(xs, spacing), spaced_lines(ys, spacing))
        labels = resample(planned.grid, planned.labels, grid)
        wanted = self.rooms * self.options.seeded_proposals // 2
        return self._run(grid, labels, NO_BOXES, wanted, (0.05, 0.005), (0.0, 0.02))

    def refine(
        self, partition: Partition, goal: Goal | None = None, levels: tuple[tuple[float, ...], ...] | None = None
    ) -> Partition:
        """Move the walls on finer grids around them: by descent, or at low temperature where rooms have no seeds.

        Parameters
        ----------
        goal : Goal, optional
            The goal of this run, if it is not that of the floor.
        levels : tuple of tuples, optional
            Offsets, metres, of the lines that each finer grid puts beside the walls.
        """
        usual = LEAN_LEVELS if self.large else FINE_LEVELS
        temperatures = (0.0, 0.0) if self.seeded else (0.03, 0.002)
        for offsets in levels or usual:
            grid, labels = refined_grid(self.model, self.major, partition.grid, partition.labels, offsets)
            wanted = REFINING * self.rooms
            partition = self._run(grid, labels, NO_BOXES, wanted, temperatures, (0.0, 0.0), goal)
        return partition

    def _run(
        self,
        grid: Grid,
        labels: Ints,
        boxes: Ints,
        wanted: int,
        temperatures: tuple[float, float],
        shares: tuple[float, float],
        goal: Goal | None = None,
    ) -> Partition:
        """Anneal `labels` from the first to the second of `temperatures`, with `shares` of swaps and rectangles."""
        schedule = Schedule(self.budget.take(wanted), *temperatures, REACH, *shares)
        found, energy = anneal(grid.cells, goal or self.goal, labels, boxes, schedule, int(self.rng.integers(2**62)))
        return Partition(grid, found, energy)
