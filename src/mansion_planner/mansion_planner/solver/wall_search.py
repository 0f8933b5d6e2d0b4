"""The wall search over a whole floor: starts, attempts while edges are unmet, then ever finer grids."""

from dataclasses import replace

import numpy as np

from mansion_planner.solver.budget import Budget
from mansion_planner.solver.carving import carve_open_links
from mansion_planner.solver.cutting import RoundsResult, run_rounds
from mansion_planner.solver.grid import Grid, make_grid, resample, spaced_lines
from mansion_planner.solver.measured import Measured, measure
from mansion_planner.solver.model import FloorModel
from mansion_planner.solver.objective import WEIGHTS, total_energy
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.painting import recount
from mansion_planner.solver.refine import Partition, mostly_seeded, refined_grid
from mansion_planner.solver.search import anneal
from mansion_planner.solver.starts import fit_rectangles, flood, paint_rectangles
from mansion_planner.solver.state import (
    SEED_WEIGHT,
    SEED_X,
    SEED_Y,
    TARGET,
    Floats,
    Goal,
    Ints,
    State,
    make_state,
)
from mansion_planner.solver.widths import LARGE

__all__ = ["WallSearch"]

FINE_LEVELS = ((0.22, 0.1), (0.07, 0.03))
"""Offsets, in metres, of the lines that each finer grid puts beside the walls."""

LEAN_LEVELS = ((0.18,), (0.06,))
"""The same for floors of many rooms, whose grids would grow too large."""

MANY_ROOMS = 14

KINDS, REROOTED, CARVED = 4, 2, 3
"""Of each four attempts the third starts from rounds from another room, the last from carved open links."""

POSTPONED = 4
"""Coarse searches of which only the best is refined, as long as they leave links open or rooms narrow."""

MOST_NARROW = 0.05
"""Share of a room's area (of `LARGE` in larger rooms) that may be narrow after a coarse search."""

SHAPE_SHARE = 0.5
"""Share of the candidates that rooms of an unusable shape are worth when no edge is open."""

REPAIR_LEVELS = ((0.3, 0.1),)

REPAIRS = (6.0,)
"""Factors of the weight of narrow places."""

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
        self.latest: Partition | None = None

    def run(
        self, rounds: RoundsResult, planned: Partition | None = None
    ) -> tuple[Measured | None, RoundsResult]:
        """Return the best partition found within the budget, or None when the rooms do not fit at all.

        Parameters
        ----------
        rounds : RoundsResult
            Rounds from the hub; returned with the partition unless it started from others.
        planned : Partition, optional
            What the seed boxes describe; its walls are moved first.
        """
        best = None
        if planned is not None:
            best = self._repaired(measure(self.model, planned, self.options))
            if self.faults(best) != (0, 0):
                best = self._better(best, self._finished(self._settled(planned)))
        chosen, waiting = rounds, None
        for attempt in range(self.options.attempts):
            if best is not None and self._enough(best):
                break
            tried = self._rounds(rounds, attempt)
            start = self._start(tried, attempt)
            if start is None:
                continue
            coarse = self._searched(start, attempt)
            if waiting is not None and waiting.energy < coarse.energy:
                coarse = waiting
            waiting = coarse
            if self._postponed(coarse, attempt):
                continue
            waiting = None
            found = self._finished(coarse)
            if best is None or self._better(best, found) is found:
                best, chosen = found, tried
        if best is None and waiting is not None:
            best = self._finished(waiting)
        return best, chosen

    def faults(self, measured: Measured) -> tuple[int, int]:
        """Return what the final polygons miss: links, whole rooms and structural walls; and usable shapes."""
        return measured.verdict.faults(self.asked)

    def _better(self, first: Measured, second: Measured) -> Measured:
        """Return the one with fewer faults, then less energy; the first of equals."""
        keys = [(self.faults(m), m.partition.energy) for m in (first, second)]
        return second if keys[1] < keys[0] else first

    def _enough(self, best: Measured) -> bool:
        """Tell whether to stop: no fault is left, only shapes after their share of the budget, or no budget."""
        hard, soft = self.faults(best)
        spent = self.budget.used >= SHAPE_SHARE * self.budget.limit
        return self.budget.left == 0 or (hard == 0 and (soft == 0 or spent))

    def _postponed(self, coarse: Partition, attempt: int) -> bool:
        """Tell whether another coarse search is worth more than refining one with faults."""
        last = attempt % POSTPONED == POSTPONED - 1 or attempt == self.options.attempts - 1
        if self.seeded or last or self.budget.left == 0:
            return False
        state = self._state(coarse)
        a, b = self.goal.links[:, 0], self.goal.links[:, 1]
        walls = np.where(self.goal.links[:, 2] == 0, state.run[a, b], state.contact[a, b])
        narrow = state.thin > MOST_NARROW * np.minimum(LARGE, self.goal.rooms[:, TARGET])
        return bool((walls < self.goal.need).any() or narrow.any())

    def _state(self, partition: Partition) -> State:
        """Return the partition's state with all its statistics."""
        state = make_state(partition.labels, self.rooms, self.total)
        recount(partition.grid.cells, state)
        total_energy(partition.grid.cells, self.goal, state)
        return state

    def _finished(self, partition: Partition) -> Measured:
        """Refine a partition, measure it, and mend its shapes."""
        return self._repaired(measure(self.model, self._refined(partition), self.options))

    def _repaired(self, found: Measured) -> Measured:
        """Move the walls of rooms that are too narrow or pinched, with more weight on width each time."""
        for weight in REPAIRS:
            hard, soft = self.faults(found)
            if hard > 0 or soft == 0 or self.budget.left == 0:
                break
            weights = self.goal.weights.copy()
            weights[WEIGHTS.index("thin")] *= weight
            wider = self._refined(
                found.partition, self.goal._replace(weights=weights), REPAIR_LEVELS
            )
            wider = replace(wider, energy=self._energy(wider))
            found = self._better(found, measure(self.model, wider, self.options))
        return found

    def _energy(self, partition: Partition) -> float:
        """Return the partition's energy under the unchanged goal."""
        cells, state = partition.grid.cells, self._state(partition)
        return total_energy(cells, self.goal, state)

    def _rounds(self, rounds: RoundsResult, attempt: int) -> RoundsResult:
        """Return the rounds that an attempt starts from: the hub's, or those of another room with many edges."""
        graph = self.model.graph
        roots = [r.id for r in self.model.rooms[1:] if graph.degree(r.id) > 1]
        roots.sort(key=lambda name: -graph.degree(name))
        turn = attempt // KINDS
        if attempt % KINDS != REROOTED or turn >= len(roots):
            return rounds
        share = max(1, self.options.round_candidates // self.rooms)
        budget = Budget(min(share, self.budget.left))
        found = run_rounds(
            self.model, self.goal, self.grid, self.options, budget, self.rng, root=roots[turn]
        )
        self.budget.take(budget.used)
        return found

    def _start(self, rounds: RoundsResult, attempt: int) -> Ints | None:
        """Return the labels that an attempt starts from."""
        if attempt % KINDS == CARVED and self.latest is not None:
            carved = carve_open_links(self.grid.cells, self.goal, self._state(self.latest))
            if flood(carved, self.grid.cells, self.goal, self._seed_points(rounds, 0)):
                return carved
        seeds = self._seed_points(rounds, attempt)
        from_rounds = rounds.labels.copy()
        usable = flood(from_rounds, self.grid.cells, self.goal, seeds)
        rerooted = attempt % KINDS == REROOTED
        if usable and (rerooted or (attempt == 0 and not self.seeded)):
            return from_rounds
        labels = self.grid.base.copy()
        if self.seeded and attempt < 2:
            boxes, costs = self._boxes()
            paint_rectangles(labels, self.grid.cells, boxes, costs)
        if not flood(labels, self.grid.cells, self.goal, seeds):
            return from_rounds if usable else None
        if attempt == 0 and usable and self._lower(from_rounds, labels):
            return from_rounds
        return labels

    def _lower(self, first: Ints, second: Ints) -> bool:
        """Tell whether the first labels on the coarse grid have less energy."""
        a, b = (self._energy(Partition(self.grid, k, 0.0)) for k in (first, second))
        return a < b

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
            self.budget.take(wanted),
            (0.15 if attempt == 0 else 0.3) if cool else 0.6,
            0.005 if cool else 0.01,
            4,
            0.0 if cool else 0.05,
            0.05 if cool else 0.2,
            int(self.rng.integers(2**62)),
        )
        self.latest = Partition(self.grid, state.labels.copy(), energy)
        return self.latest

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

    def _refined(
        self,
        partition: Partition,
        goal: Goal | None = None,
        levels: tuple[tuple[float, ...], ...] | None = None,
    ) -> Partition:
        """Move the walls to their places on finer grids: by descent, or almost so where no seed says where."""
        usual = FINE_LEVELS if self.rooms < MANY_ROOMS else LEAN_LEVELS
        for offsets in levels or usual:
            grid, labels = refined_grid(self.model, self.major, partition, offsets)
            state = make_state(labels, self.rooms, self.total)
            energy = anneal(
                grid.cells,
                goal or self.goal,
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
