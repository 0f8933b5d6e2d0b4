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
from mansion_planner.solver.scoring import grow_batch
from mansion_planner.solver.seeding import (
    SeedCallback,
    SeedRequest,
    plan_seeds,
    seeds_from_plan,
)
from mansion_planner.solver.state import CX, CY, Floats, Goal, Ints

__all__ = ["RoundsResult", "base_radii", "run_rounds", "sample_batch"]


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


def base_radii(shares: Floats, options: SolverOptions) -> Floats:
    """Return ``R_r^(0) = r_base + k a_r / |Omega(p_t)|`` in grid cells."""
    return options.base_radius + options.radius_gain * shares


def sample_batch(
    seeds: Floats, radii: Floats, size: int, separation: float, rng: np.random.Generator
) -> Floats:
    """Draw perturbed seeds uniformly from the discs around `seeds`; the first candidate is unperturbed.

    Seeds closer than `separation` are drawn again, up to eight times, then kept as they are.

    Returns
    -------
    (size, children, 2) array
    """
    count = len(seeds)

    def draw(number: int) -> Floats:
        angle = rng.uniform(0.0, 2.0 * np.pi, (number, count))
        reach = radii * np.sqrt(rng.uniform(0.0, 1.0, (number, count)))
        step = np.stack([reach * np.cos(angle), reach * np.sin(angle)], axis=-1)
        return np.asarray(seeds + step)

    batch = draw(size)
    batch[0] = seeds
    for _ in range(8):
        close = _too_close(batch, separation)
        close[0] = False
        if not close.any():
            break
        batch[close] = draw(int(close.sum()))
    return batch


def _too_close(batch: Floats, separation: float) -> "np.ndarray[tuple[int], np.dtype[np.bool_]]":
    gap = np.linalg.norm(batch[:, :, None] - batch[:, None, :], axis=-1)
    k = np.arange(batch.shape[1])
    gap[:, k, k] = np.inf
    return np.asarray(gap.min(axis=(1, 2), initial=np.inf) < separation)


def _repelled(cells: Floats, targets: Floats, size: int, rng: np.random.Generator) -> Floats:
    """Draw seeds uniformly in the region, larger rooms first, each away from those before it (the fallback)."""
    order = np.argsort(-targets, kind="stable")
    batch = np.empty((size, len(targets), 2))
    reach = 0.5 * np.sqrt(targets)
    for b in range(size):
        done: list[int] = []
        for k in order.tolist():
            point = cells[rng.integers(len(cells))]
            for _ in range(12):
                if all(
                    np.hypot(*(point - batch[b, m])) >= 0.8 * (reach[k] + reach[m]) for m in done
                ):
                    break
                point = cells[rng.integers(len(cells))]
            batch[b, k] = point
            done.append(k)
    return batch


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
    ) -> None:
        self.model, self.goal, self.grid, self.options = model, goal, grid, options
        self.budget, self.rng, self.callback = budget, rng, callback
        self.outside = len(model.rooms) + len(model.obstacles)
        self.index = dict(model.index)
        for k, zone in enumerate(model.zones):
            self.index[zone] = self.outside + 1 + k
        self.side = np.zeros(self.outside + 1 + len(model.zones), np.int64)
        self.side[: len(goal.side)] = goal.side
        self.labels = np.where(grid.base < 0, self.index[model.hub], grid.base)
        self.placed = {model.hub, *(o.id for o in model.obstacles)}
        self.seeds: dict[str, tuple[float, float]] = {}
        self.energy = 0.0
        self.records: list[CutRoundRecord] = []
        self.history: list[Ints] = [self.labels.copy()]
        self.spacing = float(np.median(np.diff(grid.cells.xs[1:-1])))

    def cut(self, cut: CutRound, areas: dict[str, float]) -> None:
        """Split one parent (Algorithm 3)."""
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
            size = self.budget.take(self.options.batch)
            if size == 0:
                break
            if fallback:
                batch = _repelled(cells, targets, size, self.rng)
            else:
                gamma = self.options.radius_growth**j
                batch = sample_batch(seeds, gamma * radii, size, self.spacing, self.rng)
            unmet, found = self._grow(cut, links, need, batch, targets, scratch)
            if unmet >= 0 and (
                fewest < 0 or unmet < fewest or (unmet == fewest and found < energy)
            ):
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
                parent=cut.parent,
                children=list(cut.children),
                method=method,
                candidates=self.budget.used - used,
            )
        )

    def _skip(self, cut: CutRound) -> None:
        """Note a round whose parent has no ground left to split."""
        self.records.append(
            CutRoundRecord(parent=cut.parent, children=list(cut.children), method="failed")
        )

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
                grid.xs,
                grid.ys,
                self.labels,
                self.index[cut.parent],
                len(self.model.rooms),
                self.outside,
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
) -> RoundsResult:
    """Run all cut rounds of a floor on one grid.

    A round that finds no candidate passing the topology predicate keeps the one with the fewest open links.
    """
    rounds = build_cut_rounds(model)
    areas = subtree_areas(model, rounds)
    state = _Rounds(model, goal, grid, options, budget, rng, callback)
    for cut in rounds:
        state.cut(cut, areas)
    return RoundsResult(state.labels, state.records, state.seeds, state.energy, state.history)
