"""The annealing runs of one floor: on the coarse grid, from a planned layout, and on ever finer grids."""

import numpy as np

from mansion_planner.solver.budget import Budget
from mansion_planner.solver.grid import Grid, make_grid, resample, spaced_lines
from mansion_planner.solver.model import FloorModel
from mansion_planner.solver.objective import total_energy
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.painting import recount
from mansion_planner.solver.refine import Partition, mostly_seeded, refined_grid
from mansion_planner.solver.search import anneal
from mansion_planner.solver.starts import fit_rectangles
from mansion_planner.solver.state import Floats, Goal, Ints, State, make_state

__all__ = ["Annealing"]

FINE_LEVELS = ((0.22, 0.1), (0.07, 0.03))
"""Offsets, in metres, of the lines that each finer grid puts beside the walls."""

LEAN_LEVELS = ((0.18,), (0.06,))
"""The same for floors of many rooms, whose grids would grow too large."""

MANY_ROOMS = 14
"""Rooms from which on a floor is large."""

LONGER = 2
"""Coarse searches of large floors, and of seeded ones whose seeds did not suffice, are so many times longer."""

REFINING = 400
"""Candidates of each finer grid for each room."""

REACH = 4
"""Most grid lines that a wall is shifted by."""

NO_BOXES = np.zeros((0, 5), np.int64)


class Annealing:
    """Runs of the annealing kernel for one floor, each of which takes its candidates from the budget.

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
        self.total = self.rooms + len(model.obstacles) + 1
        self.seeded = mostly_seeded(model)
        self.large = self.rooms >= MANY_ROOMS

    def state(self, partition: Partition) -> State:
        """Return the partition's state with all its statistics."""
        state = make_state(partition.labels, self.rooms, self.total)
        recount(partition.grid.cells, state)
        total_energy(partition.grid.cells, self.goal, state)
        return state

    def energy(self, partition: Partition) -> float:
        """Return the partition's energy under the unchanged goal."""
        return total_energy(partition.grid.cells, self.goal, self.state(partition))

    def boxes(self) -> tuple[Ints, Floats]:
        """Return the rectangles fitted to the seeds; the hub takes what is left and needs none."""
        boxes, costs = fit_rectangles(self.grid.cells, self.goal, 30)
        return boxes[boxes[:, 0] != 0], costs[boxes[:, 0] != 0]

    def warmed(self, labels: Ints, heat: float) -> Partition:
        """Search the coarse grid a little way from a start that follows the seeds, with rectangles fitted to them."""
        boxes, wanted = self.boxes()[0], self.rooms * self.options.seeded_proposals
        return self._run(self.grid, labels, boxes, wanted, (heat, 0.005), (0.0, 0.05))

    def heated(self, labels: Ints) -> Partition:
        """Search the whole coarse grid: a small floor shortly, with more rectangles and swaps, as others may follow."""
        wanted, shares = self.rooms * self.options.proposals, (0.1, 0.4)
        if self.large or self.seeded:
            wanted, shares = LONGER * wanted, (0.05, 0.2)
        return self._run(self.grid, labels, NO_BOXES, wanted, (0.6, 0.01), shares)

    def polished(self, partition: Partition) -> Partition:
        """Search on from a sound partition of the coarse grid, at half the heat and without swaps."""
        wanted = self.rooms * self.options.proposals
        return self._run(self.grid, partition.labels, NO_BOXES, wanted, (0.3, 0.01), (0.0, 0.1))

    def settled(self, planned: Partition) -> Partition:
        """Move the walls of a planned layout, a little at a time, until its edges are realised."""
        xs, ys = planned.grid.cells.xs[1:-1], planned.grid.cells.ys[1:-1]
        spacing = 1.25 * self.options.spacing
        grid = make_grid(self.model, spaced_lines(xs, spacing), spaced_lines(ys, spacing))
        labels = resample(planned.grid, planned.labels, grid)
        wanted = self.rooms * self.options.seeded_proposals // 2
        return self._run(grid, labels, NO_BOXES, wanted, (0.05, 0.005), (0.0, 0.02))

    def refined(
        self, partition: Partition, goal: Goal | None = None, levels: tuple[tuple[float, ...], ...] | None = None
    ) -> Partition:
        """Move the walls to their places on finer grids: by descent, or almost so where no seed says where."""
        usual = LEAN_LEVELS if self.large else FINE_LEVELS
        heat = (0.0, 0.0) if self.seeded else (0.03, 0.002)
        for offsets in levels or usual:
            grid, labels = refined_grid(self.model, self.major, partition, offsets)
            wanted = REFINING * self.rooms
            partition = self._run(grid, labels, NO_BOXES, wanted, heat, (0.0, 0.0), goal)
        return partition

    def _run(
        self,
        grid: Grid,
        labels: Ints,
        boxes: Ints,
        wanted: int,
        heat: tuple[float, float],
        shares: tuple[float, float],
        goal: Goal | None = None,
    ) -> Partition:
        """Anneal `labels` from the first to the second `heat`, with `shares` of swaps and rectangles."""
        state = make_state(labels, self.rooms, self.total)
        energy = anneal(
            grid.cells,
            goal or self.goal,
            state,
            boxes,
            self.budget.take(wanted),
            *heat,
            REACH,
            *shares,
            int(self.rng.integers(2**62)),
        )
        return Partition(grid, state.labels.copy(), energy)
