"""Where each attempt of the wall search starts: cut rounds, fitted rectangles, random floods, carved links."""

import numpy as np

from mansion_planner.solver.annealing import Annealing
from mansion_planner.solver.budget import Budget
from mansion_planner.solver.carving import carve_open_links
from mansion_planner.solver.cutting import RoundsResult, run_rounds
from mansion_planner.solver.refine import Partition
from mansion_planner.solver.starts import flood, paint_rectangles
from mansion_planner.solver.state import SEED_WEIGHT, SEED_X, SEED_Y, Floats, Ints

__all__ = ["FOLLOWING_SEEDS", "AttemptStarts"]

FOLLOWING_SEEDS = 2
"""Attempts that start from what the seeds say, where most rooms have one."""

KINDS, KINDS_LARGE, REROOTED, CARVED = 6, 4, 2, 3
"""Of each six attempts (four on large floors) the third starts from rounds from another room, the fourth from carved
open links. On large floors without seeds the second is carved too: a search from the carved result of another mostly
realises what that left open, and one from elsewhere seldom does."""


class AttemptStarts:
    """The starts of one floor's attempts.

    Parameters
    ----------
    annealing : Annealing
        The floor, its goal and coarse grid, budget and generator.
    """

    def __init__(self, annealing: Annealing) -> None:
        self.annealing = annealing
        self.kinds = KINDS_LARGE if annealing.large or annealing.seeded else KINDS
        self.model, self.goal, self.grid = annealing.model, annealing.goal, annealing.grid

    def rounds(self, hub: RoundsResult, attempt: int) -> RoundsResult:
        """Return the rounds that an attempt starts from: the hub's, or those of another room with many edges."""
        graph, model, options = self.model.graph, self.model, self.annealing.options
        roots = [r.id for r in model.rooms[1:] if graph.degree(r.id) > 1]
        roots.sort(key=lambda name: -graph.degree(name))
        turn = attempt // self.kinds
        if attempt % self.kinds != REROOTED or turn >= len(roots):
            return hub
        share = max(1, options.round_candidates // len(model.rooms))
        budget = Budget(min(share, self.annealing.budget.left))
        rng = self.annealing.rng
        found = run_rounds(model, self.goal, self.grid, options, budget, rng, root=roots[turn])
        self.annealing.budget.take(budget.used)
        return found

    def labels(self, rounds: RoundsResult, attempt: int, latest: Partition | None) -> Ints | None:
        """Return the labels that an attempt starts from, or None where no partition was found.

        Parameters
        ----------
        rounds : RoundsResult
            The attempt's rounds.
        latest : Partition, optional
            What the attempt before found; its open links are carved.
        """
        if latest is not None and self._carves(attempt):
            state = self.annealing.state(latest)
            carved = carve_open_links(self.grid.cells, self.goal, state)
            if flood(carved, self.grid.cells, self.goal, self._seed_points(rounds, 0)):
                return carved
        seeds, seeded = self._seed_points(rounds, attempt), self.annealing.seeded
        from_rounds = rounds.labels.copy()
        usable = flood(from_rounds, self.grid.cells, self.goal, seeds)
        rerooted = attempt % self.kinds == REROOTED
        if usable and (rerooted or (attempt == 0 and not seeded)):
            return from_rounds
        labels = self.grid.base.copy()
        if seeded and attempt < FOLLOWING_SEEDS:
            boxes, costs = self.annealing.boxes()
            paint_rectangles(labels, self.grid.cells, boxes, costs)
        if not flood(labels, self.grid.cells, self.goal, seeds):
            return from_rounds if usable else None
        if attempt == 0 and usable and self._lower(from_rounds, labels):
            return from_rounds
        return labels

    def _carves(self, attempt: int) -> bool:
        """Tell whether an attempt starts from what the one before found, with its open links carved."""
        if self.annealing.large and not self.annealing.seeded:
            return attempt % 2 == 1
        return attempt % self.kinds == CARVED

    def _lower(self, first: Ints, second: Ints) -> bool:
        """Tell whether the first labels on the coarse grid have less energy."""
        a, b = (self.annealing.energy(Partition(self.grid, k, 0.0)) for k in (first, second))
        return a < b

    def _seed_points(self, rounds: RoundsResult, attempt: int) -> Floats:
        """Return a starting point for each room: its seed, the rounds' plan at first, later a random cell."""
        free = np.argwhere(self.grid.cells.free)
        pick = free[self.annealing.rng.integers(len(free), size=len(self.model.rooms))]
        points = self.grid.cells.geometry[pick[:, 0], pick[:, 1], 1:3].copy()
        if attempt == 0:
            for k, room in enumerate(self.model.rooms):
                if room.id in rounds.seeds:
                    points[k] = rounds.seeds[room.id]
        known = self.goal.rooms[:, SEED_WEIGHT] > 0.0
        points[known] = self.goal.rooms[known, SEED_X : SEED_Y + 1]
        return points
