"""The wall search over a whole floor: starts, attempts while edges are unmet, then ever finer grids."""

import numpy as np

from mansion_geometry.rings import polygon_parts
from mansion_planner.solver.budget import Budget
from mansion_planner.solver.cutting import RoundsResult
from mansion_planner.solver.grid import Grid, make_grid, resample, spaced_lines
from mansion_planner.solver.model import FloorModel
from mansion_planner.solver.objective import total_energy
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.polygons import room_shapes
from mansion_planner.solver.refine import Partition, mostly_seeded, refined_grid
from mansion_planner.solver.search import anneal
from mansion_planner.solver.starts import fit_rectangles, flood, paint_rectangles
from mansion_planner.solver.state import (
    SEED_WEIGHT,
    SEED_X,
    SEED_Y,
    Floats,
    Goal,
    Ints,
    make_state,
    recount,
)
from mansion_planner.solver.verify import realise_edges

__all__ = ["WallSearch"]

FINE_LEVELS = ((0.22, 0.1), (0.07, 0.03))
"""Offsets, in metres, of the lines that each finer grid puts beside the walls."""

LEAN_LEVELS = ((0.18,), (0.06,))
"""The same for floors of many rooms, whose grids would grow too large."""

MANY_ROOMS = 14

NO_BOXES = np.zeros((0, 5), np.int64)


class WallSearch:
    """One floor's wall search.

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
        names = [room.id for room in model.rooms] + [o.id for o in model.obstacles]
        self.asked = {(names[a], names[b]) for a, b in goal.links[:, :2].tolist()}
        self.seeded = mostly_seeded(model)

    def run(self, rounds: RoundsResult, planned: Partition | None = None) -> Partition | None:
        """Return the best partition found within the budget, or None when the rooms do not fit at all.

        Parameters
        ----------
        planned : Partition, optional
            What the seed boxes describe; its walls are moved first.
        """
        best: Partition | None = None
        fewest = 0
        if planned is not None:
            best = self._refined(self._settled(planned))
            fewest = self.faults(best)
            if fewest == 0:
                return best
        for attempt in range(self.options.attempts):
            start = self._start(rounds, attempt)
            if start is None:
                continue
            found = self._refined(self._searched(start, attempt))
            faults = self.faults(found)
            if best is None or (faults, found.energy) < (fewest, best.energy):
                best, fewest = found, faults
            if fewest == 0 or self.budget.left == 0:
                break
        return best

    def faults(self, partition: Partition) -> int:
        """Return how many links the final polygons leave open, and how many rooms they leave in pieces."""
        shapes = room_shapes(self.model, partition.grid, partition.labels)
        edges = realise_edges(self.model, shapes, self.options)
        open_links = sum(
            not edge.satisfied and (edge.source, edge.target) in self.asked for edge in edges
        )
        return open_links + sum(len(polygon_parts(shape)) != 1 for shape in shapes)

    def energy(self, labels: Ints) -> float:
        """Return the energy of labels on the coarse grid."""
        state = make_state(labels, self.rooms, self.total)
        recount(self.grid.cells, state)
        return total_energy(self.grid.cells, self.goal, state, np.zeros(labels.shape))

    def _start(self, rounds: RoundsResult, attempt: int) -> Ints | None:
        """Return the labels that an attempt starts from."""
        seeds = self._seed_points(rounds, attempt)
        from_rounds = rounds.labels.copy()
        usable = flood(from_rounds, self.grid.cells, self.goal, seeds)
        if attempt == 0 and usable and not self.seeded:
            return from_rounds
        labels = self.grid.base.copy()
        if self.seeded and attempt < 2:
            boxes, costs = self._boxes()
            paint_rectangles(labels, self.grid.cells, boxes, costs)
        if not flood(labels, self.grid.cells, self.goal, seeds):
            return from_rounds if usable else None
        if attempt == 0 and usable and self.energy(from_rounds) < self.energy(labels):
            return from_rounds
        return labels

    def _seed_points(self, rounds: RoundsResult, attempt: int) -> Floats:
        """Return a starting point for each room: its seed, the rounds' plan at first, later a random cell."""
        free = np.argwhere(self.grid.cells.free)
        pick = free[self.rng.integers(len(free), size=self.rooms)]
        points = self.grid.cells.geometry[pick[:, 0], pick[:, 1], 1:3].copy()
        if attempt == 0:
            for k, room in enumerate(self.model.rooms):
                if room.id in rounds.seeds:
                    points[k] = rounds.seeds[room.id]
        known = self.goal.rooms[:, SEED_WEIGHT] > 0.0
        points[known] = self.goal.rooms[known, SEED_X : SEED_Y + 1]
        return points

    def _boxes(self) -> tuple[Ints, Floats]:
        """Return the rectangles fitted to the seeds; the hub takes what is left and needs none."""
        boxes, costs = fit_rectangles(self.grid.cells, self.goal, 30)
        return boxes[boxes[:, 0] != 0], costs[boxes[:, 0] != 0]

    def _searched(self, labels: Ints, attempt: int) -> Partition:
        """Anneal on the coarse grid: cool with fitted rectangles where seeds say much, else hot with random ones."""
        state = make_state(labels, self.rooms, self.total)
        cool = self.seeded and attempt < 2
        boxes = self._boxes()[0] if cool else NO_BOXES
        wanted = self.rooms * (self.options.seeded_proposals if cool else self.options.proposals)
        energy = anneal(
            self.grid.cells,
            self.goal,
            state,
            boxes,
            self.budget.take(wanted if attempt < 4 else 2 * wanted),
            (0.15 if attempt == 0 else 0.3) if cool else 0.6,
            0.005 if cool else 0.01,
            4,
            0.0 if cool else 0.01,
            0.05 if cool else 0.2,
            int(self.rng.integers(2**62)),
        )
        return Partition(self.grid, state.labels.copy(), energy)

    def _settled(self, planned: Partition) -> Partition:
        """Move the walls of a planned layout, a little at a time, until its edges are realised."""
        xs, ys = planned.grid.cells.xs[1:-1], planned.grid.cells.ys[1:-1]
        spacing = 1.25 * self.options.spacing
        grid = make_grid(self.model, spaced_lines(xs, spacing), spaced_lines(ys, spacing))
        state = make_state(resample(planned.grid, planned.labels, grid), self.rooms, self.total)
        energy = anneal(
            grid.cells,
            self.goal,
            state,
            NO_BOXES,
            self.budget.take(self.rooms * self.options.seeded_proposals // 2),
            0.05,
            0.005,
            4,
            0.0,
            0.02,
            int(self.rng.integers(2**62)),
        )
        return Partition(grid, state.labels.copy(), energy)

    def _refined(self, partition: Partition) -> Partition:
        """Move the walls to their places on finer grids: by descent, or almost so where no seed says where."""
        for offsets in FINE_LEVELS if self.rooms < MANY_ROOMS else LEAN_LEVELS:
            grid, labels = refined_grid(self.model, self.major, partition, offsets)
            state = make_state(labels, self.rooms, self.total)
            energy = anneal(
                grid.cells,
                self.goal,
                state,
                NO_BOXES,
                self.budget.take(400 * self.rooms),
                0.0 if self.seeded else 0.03,
                0.0 if self.seeded else 0.002,
                4,
                0.0,
                0.0,
                int(self.rng.integers(2**62)),
            )
            partition = Partition(grid, state.labels.copy(), energy)
        return partition
