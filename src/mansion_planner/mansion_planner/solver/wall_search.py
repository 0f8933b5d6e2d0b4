"""The wall search over a whole floor: coarse searches from different starts, of which the best are refined."""

from dataclasses import dataclass, replace

import numpy as np

from mansion_geometry.compiled import Floats, Ints
from mansion_planner.solver.annealing import Annealing
from mansion_planner.solver.cut_rounds import RoundsResult, run_rounds
from mansion_planner.solver.energy import W_THIN
from mansion_planner.solver.options import Budget
from mansion_planner.solver.partition import Partition
from mansion_planner.solver.problem import SEED_WEIGHT, SEED_X, SEED_Y, TARGET
from mansion_planner.solver.starts import carve_open_links, flood, paint_rectangles
from mansion_planner.solver.verification import MeasuredPartition, measure
from mansion_planner.solver.walls import LARGE

__all__ = ["AttemptStarts", "WallSearch"]


FOLLOWING_SEEDS = 2
"""Number of attempts that start from the seeds, where most rooms have one."""

CYCLE, CYCLE_LARGE, REROOTED, CARVED = 6, 4, 2, 3
"""Lengths of a cycle of attempts on small and on large floors, and the places in it of two kinds of starts: rounds
from another room, and carved open links.

On large floors without seeds every second attempt is carved: a search from the carved result of another mostly realises
what that left open, and one from elsewhere seldom does.
"""


class AttemptStarts:
    """Starting partitions of the attempts on one floor.

    Parameters
    ----------
    annealing : Annealing
        The floor, its goal and coarse grid, budget and generator.
    """

    def __init__(self, annealing: Annealing) -> None:
        self.annealing = annealing
        self.cycle = CYCLE_LARGE if annealing.large or annealing.seeded else CYCLE
        self.model, self.goal, self.grid = annealing.model, annealing.goal, annealing.grid

    def rounds(self, hub: RoundsResult, attempt: int) -> RoundsResult:
        """Return the rounds that an attempt starts from: the hub's, or those of another room with many edges."""
        graph, model, options = self.model.graph, self.model, self.annealing.options
        roots = [r.id for r in model.rooms[1:] if graph.degree(r.id) > 1]
        roots.sort(key=lambda name: -graph.degree(name))
        turn = attempt // self.cycle
        if attempt % self.cycle != REROOTED or turn >= len(roots):
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
            filled = flood(carved, self.grid.cells, self.goal, self._seed_points(rounds, 0))
            if filled is not None:
                return filled
        seeds, seeded = self._seed_points(rounds, attempt), self.annealing.seeded
        from_rounds = flood(rounds.labels, self.grid.cells, self.goal, seeds)
        rerooted = attempt % self.cycle == REROOTED
        if from_rounds is not None and (rerooted or (attempt == 0 and not seeded)):
            return from_rounds
        base = self.grid.base
        if seeded and attempt < FOLLOWING_SEEDS:
            base = paint_rectangles(base, self.grid.cells, *self.annealing.boxes())
        from_seeds = flood(base, self.grid.cells, self.goal, seeds)
        if from_seeds is None:
            return from_rounds
        if attempt == 0 and from_rounds is not None and self._has_less_energy(from_rounds, from_seeds):
            return from_rounds
        return from_seeds

    def _carves(self, attempt: int) -> bool:
        """Tell whether an attempt starts from what the one before found, with its open links carved."""
        if self.annealing.large and not self.annealing.seeded:
            return attempt % 2 == 1
        return attempt % self.cycle == CARVED

    def _has_less_energy(self, first: Ints, second: Ints) -> bool:
        """Tell whether the first labels on the coarse grid have less energy than the second."""
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


POSTPONED, POSTPONED_LARGE = 6, 4
"""Coarse searches of which only the best is refined, as long as they leave links open or rooms narrow."""

MOST_NARROW = 0.05
"""Share of a room's area (of `LARGE` in larger rooms) that may be narrow after a coarse search."""

SHAPE_SHARE = 0.5
"""Share of the candidates that may be spent on unusable shapes once no edge is open."""

REPAIR_LEVELS = ((0.3, 0.1),)
"""Offsets, metres, of the lines that the grid of a repair puts beside the walls."""

REPAIR_WEIGHT = 6.0
"""Factor of the weight of narrow places in a repair."""


@dataclass(frozen=True)
class CoarseResult:
    """What a coarse search found, the rounds that it started from, and whether links are open or rooms narrow."""

    partition: Partition
    rounds: RoundsResult
    open: bool = False
    narrow: bool = False


class WallSearch:
    """The wall search on one floor.

    Parameters
    ----------
    annealing : Annealing
        The floor, its goal and coarse grid, budget and generator.
    """

    def __init__(self, annealing: Annealing) -> None:
        self.annealing, self.starts = annealing, AttemptStarts(annealing)
        self.model, self.goal = annealing.model, annealing.goal
        self.options, self.budget = annealing.options, annealing.budget
        names = [room.id for room in self.model.rooms] + [o.id for o in self.model.obstacles]
        self.required = {(names[a], names[b]) for a, b in self.goal.links[:, :2].tolist()}

    def run(
        self, rounds: RoundsResult, planned: Partition | None = None
    ) -> tuple[MeasuredPartition | None, RoundsResult]:
        """Return the best partition found within the budget, or None when the rooms do not fit at all.

        Parameters
        ----------
        rounds : RoundsResult
            Rounds from the hub; returned with the partition unless it started from others.
        planned : Partition, optional
            What the seed boxes describe; its walls are moved first.
        """
        best = None if planned is None else self._from_plan(planned)
        chosen, latest, waiting = rounds, None, None
        for attempt in range(self.options.attempts):
            if best is not None and self._is_done(best):
                break
            tried = self.starts.rounds(rounds, attempt)
            start = self.starts.labels(tried, attempt, latest)
            if start is None:
                continue
            coarse = self._search_coarsely(start, tried, attempt)
            latest = coarse.partition
            if waiting is None or self._rank(coarse) <= self._rank(waiting):
                waiting = coarse
            if self._postponed(waiting, attempt):
                continue
            found = self._refined(waiting.partition)
            if best is None or self._better(best, found) is found:
                best, chosen = found, waiting.rounds
            waiting = None
        if best is None and waiting is not None:
            best, chosen = self._refined(waiting.partition), waiting.rounds
        return best, chosen

    def violations(self, measured: MeasuredPartition) -> tuple[int, int]:
        """Return the hard violations of the final polygons (links, pieces, walls) and the soft ones (shapes)."""
        return measured.verdict.violations(self.required)

    def _better(self, first: MeasuredPartition, second: MeasuredPartition) -> MeasuredPartition:
        """Return the one with fewer violations, then less energy; the first of equals."""
        keys = [(self.violations(m), m.partition.energy) for m in (first, second)]
        return second if keys[1] < keys[0] else first

    def _is_done(self, best: MeasuredPartition) -> bool:
        """Tell whether to stop: nothing is violated, only shapes are and their share is spent, or no budget is left."""
        hard, soft = self.violations(best)
        spent = self.budget.used >= SHAPE_SHARE * self.budget.limit
        return self.budget.left == 0 or (hard == 0 and (soft == 0 or spent))

    def _from_plan(self, planned: Partition) -> MeasuredPartition:
        """Repair the shapes of a planned layout; move its walls where that is not enough."""
        best = self._with_shapes_repaired(measure(self.model, planned, self.options))
        if self.violations(best) != (0, 0):
            best = self._better(best, self._refined(self.annealing.adjust_planned(planned)))
        return best

    def _search_coarsely(self, start: Ints, rounds: RoundsResult, attempt: int) -> CoarseResult:
        """Search the coarse grid: from seeds at a low temperature, else at a high one, then on from a valid result."""
        if self.annealing.seeded:
            if attempt < FOLLOWING_SEEDS:
                temperature = 0.15 if attempt == 0 else 0.3
                return CoarseResult(self.annealing.follow_seeds(start, temperature), rounds)
            return CoarseResult(self.annealing.search(start), rounds)
        coarse = self._inspect(self.annealing.search(start), rounds)
        if coarse.open or coarse.narrow or self.annealing.large:
            return coarse
        return self._inspect(self.annealing.continue_search(coarse.partition), rounds)

    def _inspect(self, partition: Partition, rounds: RoundsResult) -> CoarseResult:
        """Return a coarse result with whether it leaves links open or rooms narrow."""
        state = self.annealing.state(partition)
        a, b = self.goal.links[:, 0], self.goal.links[:, 1]
        walls = np.where(self.goal.links[:, 2] == 0, state.straight[a, b], state.contact[a, b])
        narrow = state.thin > MOST_NARROW * np.minimum(LARGE, self.goal.rooms[:, TARGET])
        return CoarseResult(partition, rounds, bool((walls < self.goal.need).any()), bool(narrow.any()))

    def _rank(self, coarse: CoarseResult) -> tuple[bool, float]:
        """Return the key by which coarse searches are compared: open links, then the energy."""
        return coarse.open, coarse.partition.energy

    def _postponed(self, coarse: CoarseResult, attempt: int) -> bool:
        """Tell whether another coarse search is worth more than refining one with violations.

        Refining widens most narrow rooms, but hardly ever realises an open link: on a small floor, where a coarse
        search costs less than refining, one with an open link waits until the attempts or the candidates end.
        """
        if attempt == self.options.attempts - 1 or self.budget.left == 0:
            return False
        turn = POSTPONED_LARGE if self.annealing.large else POSTPONED
        if attempt % turn != turn - 1:
            return coarse.open or coarse.narrow
        return coarse.open and not self.annealing.large

    def _refined(self, partition: Partition) -> MeasuredPartition:
        """Refine a partition, measure it, and repair its shapes."""
        return self._with_shapes_repaired(measure(self.model, self.annealing.refine(partition), self.options))

    def _with_shapes_repaired(self, found: MeasuredPartition) -> MeasuredPartition:
        """Move the walls of rooms that are too narrow or pinched once more, with more weight on width."""
        hard, soft = self.violations(found)
        if hard > 0 or soft == 0 or self.budget.left == 0:
            return found
        weights = self.goal.weights.copy()
        weights[W_THIN] *= REPAIR_WEIGHT
        goal = self.goal._replace(weights=weights)
        wider = self.annealing.refine(found.partition, goal, REPAIR_LEVELS)
        wider = replace(wider, energy=self.annealing.energy(wider))
        return self._better(found, measure(self.model, wider, self.options))
