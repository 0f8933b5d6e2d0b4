"""The topology-aware cutting node (Algorithm 3) and the sequence of rounds (Algorithm 2, lines 3 to 6)."""

from dataclasses import dataclass

import numpy as np

from mansion_geometry.rings import polygon_parts
from mansion_msgs_py.layout import CutRoundRecord, LayoutRoom
from mansion_planner.solver.budget import Budget
from mansion_planner.solver.grid import Grid
from mansion_planner.solver.model import FloorModel
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.polygons import layout_room, shape_of_cells
from mansion_planner.solver.preview import render_preview
from mansion_planner.solver.rounds import CutRound, build_cut_rounds, subtree_areas
from mansion_planner.solver.sampling import base_radii, repelled_batch, sample_batch
from mansion_planner.solver.scoring import grow_batch
from mansion_planner.solver.seeding import SeedCallback, SeedRequest, plan_seeds, seeds_from_plan
from mansion_planner.solver.state import CX, CY, Floats, Goal, Ints

__all__ = ["RoundsResult", "run_rounds"]


@dataclass(frozen=True)
class RoundsResult:
    """The layout after all rounds, and its history.

    Attributes
    ----------
    labels : (rows, columns) int array
        Labels of rooms, obstacles and outside; zones are gone.
    records : list of CutRoundRecord
    seeds : dict
        Seed of each child that was cut, in the model's frame.
    energy : float
        Sum of the rounds' energies ``E(L; w)``.
    history : list of arrays
        Labels after each round.
    """

    labels: Ints
    records: list[CutRoundRecord]
    seeds: dict[str, tuple[float, float]]
    energy: float
    history: list[Ints]


class _Rounds:
    """State of the rounds of one floor."""

    def __init__(
        self,
        model: FloorModel,
        goal: Goal,
        grid: Grid,
        options: SolverOptions,
        budget: Budget,
        rng: np.random.Generator,
        callback: SeedCallback | None,
        root: str,
    ) -> None:
        self.model, self.goal, self.grid, self.options = model, goal, grid, options
        self.budget, self.rng, self.callback = budget, rng, callback
        self.outside = len(model.rooms) + len(model.obstacles)
        self.index = dict(model.index)
        for k, zone in enumerate(model.zones):
            self.index[zone] = self.outside + 1 + k
        self.side = np.zeros(self.outside + 1 + len(model.zones), np.int64)
        self.side[: len(goal.side)] = goal.side
        self.labels = np.where(grid.base < 0, self.index[root], grid.base)
        self.placed = {root, *(o.id for o in model.obstacles)}
        self.seeds: dict[str, tuple[float, float]] = {}
        self.energy = 0.0
        self.records: list[CutRoundRecord] = []
        self.history: list[Ints] = [self.labels.copy()]
        self.spacing = float(np.median(np.diff(grid.cells.xs[1:-1])))

    def cut(self, cut: CutRound, areas: dict[str, float], share: int) -> None:
        """Split one parent (Algorithm 3), looking at no more than `share` candidates."""
        inside = self.labels == self.index[cut.parent]
        cells = self.grid.cells.geometry[inside][:, [CX, CY]]
        targets = np.array([areas[name] for name in cut.children])
        region = float(self.grid.cells.geometry[inside][:, 0].sum())
        if not len(cells):
            self._skip(cut)
            return
        wanted = float(targets.sum()) if cut.vanishes else areas[cut.parent]
        targets = targets * region / wanted
        seeds = self._seed_plan(cut, cells, targets / region)
        after = (self.placed | set(cut.children)) - ({cut.parent} if cut.vanishes else set())
        links, need = self._links(cut, after)
        radii = base_radii(targets / region, self.options) * self.spacing
        used = self.budget.used
        best = self.labels.copy()
        fewest, energy, method = -1, 0.0, "seeds"
        scratch = self.labels.copy()
        for j in range(2 * self.options.retries):
            fallback = j >= self.options.retries
            size = self.budget.take(min(self.options.batch, share - self.budget.used + used))
            if size == 0:
                break
            if fallback:
                batch = repelled_batch(cells, targets, size, self.rng)
            else:
                gamma = self.options.radius_growth**j
                batch = sample_batch(seeds, gamma * radii, size, self.spacing, self.rng)
            unmet, found = self._grow(cut, links, need, batch, targets, scratch)
            if unmet >= 0 and (fewest < 0 or unmet < fewest or (unmet == fewest and found < energy)):
                fewest, energy = unmet, found
                best[:, :] = scratch
                method = "monte_carlo" if fallback else "seeds"
            if fewest == 0:
                break
        self.labels = best
        self.energy += energy
        self.placed = after
        self.seeds.update((n, (float(s[0]), float(s[1]))) for n, s in zip(cut.children, seeds))
        self.history.append(best.copy())
        if fewest != 0:
            method = f"{method}, {fewest} links open" if fewest > 0 else "failed"
        self.records.append(
            CutRoundRecord(
                parent=cut.parent, children=list(cut.children), method=method, candidates=self.budget.used - used
            )
        )

    def _skip(self, cut: CutRound) -> None:
        """Note a round whose parent has no ground left to split."""
        self.records.append(CutRoundRecord(parent=cut.parent, children=list(cut.children), method="failed"))

    def _grow(
        self, cut: CutRound, links: Ints, need: Floats, batch: Floats, targets: Floats, out: Ints
    ) -> tuple[int, float]:
        w = self.options.energy
        cells = self.grid.cells
        return grow_batch(
            cells.xs,
            cells.ys,
            cells.geometry,
            self.labels,
            self.index[cut.parent],
            np.array([self.index[name] for name in cut.children], np.int64),
            self.goal.rooms,
            links,
            need,
            self.side,
            np.ascontiguousarray(batch),
            targets,
            np.array([w.ratio, w.seed, w.corner, w.wall]),
            cut.vanishes,
            out,
        )

    def _links(self, cut: CutRound, after: set[str]) -> tuple[Ints, Floats]:
        """Return the edges between placed ids that this round can make or break."""
        involved = {cut.parent, *cut.children}
        rows, need = [], []
        for a, b, data in self.model.graph.edges(data=True):
            if a in after and b in after and (a in involved or b in involved):
                access = data["kind"] == "access"
                rows.append((self.index[a], self.index[b], 0 if access else 1))
                least = self.model.problem.min_access_wall if access else self.options.adjacent_wall
                need.append(least)
        return np.array(rows, np.int64).reshape(-1, 3), np.array(need, dtype=float)

    def _seed_plan(self, cut: CutRound, cells: Floats, fractions: Floats) -> Floats:
        known = {
            room.id: (float(seed[0]), float(seed[1]))
            for room, seed in zip(self.model.rooms, self.model.seeds)
            if room.id in cut.children and not np.isnan(seed[0])
        }
        if self.callback is not None:
            plan = self.callback(self._request(cut, cells, fractions))
            if plan is not None:
                known.update(seeds_from_plan(plan, cut, self.model.angle))
        placed = dict(self.seeds)
        for obstacle in self.model.obstacles:
            centre = obstacle.polygon.centroid
            placed[obstacle.id] = (centre.x, centre.y)
        return plan_seeds(self.model, cut, cells, placed, known, self.rng)

    def _request(self, cut: CutRound, cells: Floats, fractions: Floats) -> SeedRequest:
        """Describe the round to the callback, with the layout so far and its preview."""
        layout: list[LayoutRoom] = []
        names = {label: name for name, label in self.index.items()}
        for label in np.unique(self.labels).tolist():
            name = names.get(label)
            if name is None or len(self.model.rooms) <= label <= self.outside:
                continue
            shape = shape_of_cells(self.model, self.grid, self.labels == label)
            layout += [layout_room(name, part, self.model.angle) for part in polygon_parts(shape)]
        mine = self.labels == self.index[cut.parent]
        beside = np.zeros_like(mine)
        beside[1:] |= mine[:-1]
        beside[:-1] |= mine[1:]
        beside[:, 1:] |= mine[:, :-1]
        beside[:, :-1] |= mine[:, 1:]
        near = [names[v] for v in np.unique(self.labels[beside & ~mine]).tolist() if v in names]
        own = next((r for r in layout if r.id == cut.parent), None)
        points = np.array(own.polygon) if own else cells
        low, high = points.min(axis=0), points.max(axis=0)
        grid = self.grid.cells
        return SeedRequest(
            parent=cut.parent,
            children=cut.children,
            fractions=dict(zip(cut.children, fractions.tolist())),
            x_range=(float(low[0]), float(high[0])),
            y_range=(float(low[1]), float(high[1])),
            neighbours=tuple(near),
            layout=layout,
            preview=render_preview(
                grid.xs, grid.ys, self.labels, self.index[cut.parent], len(self.model.rooms), self.outside
            ),
        )


def run_rounds(
    model: FloorModel,
    goal: Goal,
    grid: Grid,
    options: SolverOptions,
    budget: Budget,
    rng: np.random.Generator,
    callback: SeedCallback | None = None,
    root: str | None = None,
) -> RoundsResult:
    """Run all cut rounds of a floor on one grid, from the hub or from another room as `root`.

    A round that finds no candidate passing the topology predicate keeps the one with the fewest open links.
    """
    rounds = build_cut_rounds(model, root)
    areas = subtree_areas(model, rounds)
    state = _Rounds(model, goal, grid, options, budget, rng, callback, root or model.hub)
    for k, cut in enumerate(rounds):
        state.cut(cut, areas, -(-budget.left // (len(rounds) - k)))
    return RoundsResult(state.labels, state.records, state.seeds, state.energy, state.history)
