"""Cut rounds: the schedule of Algorithm 2 and the topology-aware cutting node of Algorithm 3, with its seeds."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from mansion_geometry.compiled import Bools, Floats, Ints
from mansion_geometry.rings import polygon_parts, rotated
from mansion_msgs_py.layout import CutRoundRecord, LayoutRoom
from mansion_msgs_py.topology import SeedPlan
from mansion_planner.solver.candidates import grow_batch
from mansion_planner.solver.grid import AREA, CX, CY, Grid
from mansion_planner.solver.options import Budget, SolverOptions
from mansion_planner.solver.partition import Partition
from mansion_planner.solver.polygons import layout_room, shape_of_cells
from mansion_planner.solver.preview import render_preview
from mansion_planner.solver.problem import FloorModel, Goal, planned_shares
from mansion_planner.solver.room_graph import breadth_first_parents

__all__ = [
    "RoundsResult",
    "SeedCallback",
    "SeedRequest",
    "base_radii",
    "build_cut_rounds",
    "planned_rounds",
    "planned_targets",
    "run_rounds",
    "sample_batch",
    "subtree_areas",
]


@dataclass(frozen=True)
class CutRound:
    """One round ``(p_t, C_t)``; a vanishing parent (a zone) keeps no cell."""

    parent: str
    children: tuple[str, ...]
    vanishes: bool


def _order(model: FloorModel) -> list[str]:
    return [room.id for room in model.rooms] + list(model.zones)


def build_cut_rounds(model: FloorModel, root: str | None = None) -> list[CutRound]:
    """Return the rounds, grouped by depth and parent; vertical cores and fixed rooms take no part.

    No child comes before its parent. Rooms that no edge reaches join the first room's round.

    Parameters
    ----------
    root : str, optional
        Room to start from instead of the hub.
    """
    root = root or model.hub
    barred = {o.id for o in model.obstacles}
    order = _order(model)
    parent = breadth_first_parents(model.graph, root, order, barred)
    rounds: list[CutRound] = []
    queue = [root]
    while queue:
        current = queue.pop(0)
        children = tuple(name for name in order if parent.get(name) == current)
        if children:
            rounds.append(CutRound(current, children, current in model.zones))
            queue.extend(children)
    return rounds


def subtree_areas(model: FloorModel, rounds: list[CutRound]) -> dict[str, float]:
    """Return, for each room and zone, the area of all rooms cut from it, its own included."""
    areas = {room.id: float(target) for room, target in zip(model.rooms, model.targets)}
    areas.update(dict.fromkeys(model.zones, 0.0))
    for cut in reversed(rounds):
        areas[cut.parent] += sum(areas[child] for child in cut.children)
    return areas


DRAWS = 64


@dataclass(frozen=True)
class SeedRequest:
    """What a seed callback is asked before a round.

    Attributes
    ----------
    parent : str
    children : tuple of str
    fractions : dict
        Wished share of the parent's area for each child, ``alpha_r``.
    x_range, y_range : (float, float)
        The parent's bounding box, metres.
    neighbours : tuple of str
        Rooms and cores that touch the parent's region.
    layout : list of LayoutRoom
        The layout so far.
    preview : bytes
        PNG image of it with the parent highlighted.
    """

    parent: str
    children: tuple[str, ...]
    fractions: dict[str, float]
    x_range: tuple[float, float]
    y_range: tuple[float, float]
    neighbours: tuple[str, ...]
    layout: list[LayoutRoom]
    preview: bytes


SeedCallback = Callable[[SeedRequest], SeedPlan | None]


def seeds_from_plan(plan: SeedPlan, cut: CutRound, angle: float) -> dict[str, tuple[float, float]]:
    """Return the centre of each child's box, in the model's frame; boxes of other rooms are ignored."""
    centres = {}
    for box in plan.boxes:
        if box.room_id in cut.children:
            centre = ((box.x[0] + box.x[1]) / 2, (box.y[0] + box.y[1]) / 2)
            if np.isfinite(centre).all():
                centres[box.room_id] = rotated([centre], angle)[0]
    return centres


def plan_seeds(
    model: FloorModel,
    cut: CutRound,
    cells: Floats,
    placed: dict[str, tuple[float, float]],
    known: dict[str, tuple[float, float]],
    rng: np.random.Generator,
) -> Floats:
    """Return a seed for each child: the known ones, and the best of some random draws for the others.

    A draw is good when its seeds are far apart, near the neighbours that are already `placed`, and near each other
    where the graph joins them.

    Parameters
    ----------
    cells : (n, 2) array
        Centres of the parent's cells.
    """
    fixed = np.array([name in known for name in cut.children])
    seeds = np.zeros((len(cut.children), 2))
    for k, name in enumerate(cut.children):
        if fixed[k]:
            seeds[k] = known[name]
    if fixed.all():
        return seeds
    spread = max(0.5, float(np.sqrt(np.prod(np.ptp(cells, axis=0) + 0.5) / len(seeds))))
    draws = cells[rng.integers(len(cells), size=(DRAWS, len(seeds)))]
    trials = np.where(fixed[None, :, None], seeds, draws)
    best: Floats = trials[int(np.argmin(_plan_costs(model, cut, trials, placed, spread)))]
    return best


def _plan_costs(
    model: FloorModel, cut: CutRound, trials: Floats, placed: dict[str, tuple[float, float]], spread: float
) -> Floats:
    """Return the cost of each trial, an array (draws, children, 2) of seeds."""
    a, b = np.triu_indices(trials.shape[1], 1)
    gap = np.linalg.norm(trials[:, a] - trials[:, b], axis=-1)
    cost: Floats = np.maximum(0.0, spread - gap).sum(axis=1)
    at = {name: trials[:, k] for k, name in enumerate(cut.children)}
    for name in cut.children:
        for other in model.graph[name]:
            where = at.get(other)
            if where is None and other in placed and other != cut.parent:
                where = np.array(placed[other])
            if where is not None:
                cost += 0.3 * np.linalg.norm(at[name] - where, axis=-1)
    return cost


MOST_CHANGE = 2.0
"""Factor by which a seed plan's fraction may change the area that a room grows to in its round."""


def planned_targets(cut: CutRound, targets: Floats, region: float, shares: dict[str, float]) -> Floats:
    """Return the areas that the children grow to: the seed plan's fraction of the parent's region where it gives one.

    The plan's fractions are to be consistent with the rooms' areas, so that they change these within bounds; what the
    parent is to keep stays its own.

    Parameters
    ----------
    targets : (children,) array
        Wished areas, square metres.
    region : float
        Area of the parent's region, square metres.
    """
    planned = np.array([shares.get(name, np.nan) for name in cut.children]) * region
    grown = np.where(np.isnan(planned), targets, np.clip(planned, targets / MOST_CHANGE, targets * MOST_CHANGE))
    total = float(targets.sum())
    scale = total / float(grown.sum())
    return np.asarray(grown * scale if cut.vanishes or scale < 1.0 else grown)


def base_radii(shares: Floats, options: SolverOptions) -> Floats:
    """Return ``R_r^(0) = r_base + k a_r / |Omega(p_t)|`` in grid cells."""
    return options.base_radius + options.radius_gain * shares


def sample_batch(seeds: Floats, radii: Floats, size: int, separation: float, rng: np.random.Generator) -> Floats:
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


def monte_carlo_batch(cells: Floats, targets: Floats, size: int, rng: np.random.Generator) -> Floats:
    """Draw seeds uniformly in the region, larger rooms first, each repelled by those before it (lines 16 to 18)."""
    order = np.argsort(-targets, kind="stable")
    batch = np.empty((size, len(targets), 2))
    reach = 0.5 * np.sqrt(targets)
    for b in range(size):
        done: list[int] = []
        for k in order.tolist():
            point = cells[rng.integers(len(cells))]
            for _ in range(12):
                if all(np.hypot(*(point - batch[b, m])) >= 0.8 * (reach[k] + reach[m]) for m in done):
                    break
                point = cells[rng.integers(len(cells))]
            batch[b, k] = point
            done.append(k)
    return batch


@dataclass(frozen=True)
class RoundsResult:
    """The layout after all rounds, and its record.

    Attributes
    ----------
    labels : (rows, columns) int array
        Labels of rooms, obstacles and outside; zones are gone.
    records : list of CutRoundRecord
    seeds : dict
        Seed of each child that was cut, in the model's frame.
    energy : float
        Sum of the rounds' energies ``E(L; w)``.
    """

    labels: Ints
    records: list[CutRoundRecord]
    seeds: dict[str, tuple[float, float]]
    energy: float


@dataclass(frozen=True)
class _RoundGoal:
    """What the candidates of one round grow from and towards.

    Attributes
    ----------
    cells : (n, 2) array
        Centres of the parent's cells.
    seeds, radii, targets : (children, 2), (children,), (children,) arrays
        Planned seeds, the discs around them that the first batch is drawn from (metres), and areas (m2).
    links, need : (e, 3), (e,) arrays
        Edges that the round can make or break, and their wall lengths.
    """

    cells: Floats
    seeds: Floats
    radii: Floats
    targets: Floats
    links: Ints
    need: Floats


class _Rounds:
    """The layout of one floor while its rounds are cut."""

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
        self.shares = planned_shares(model.problem.seeds)
        self.energy = 0.0
        self.records: list[CutRoundRecord] = []
        self.spacing = float(np.median(np.diff(grid.cells.xs[1:-1])))

    def cut(self, cut: CutRound, areas: dict[str, float], share: int) -> None:
        """Split one parent (Algorithm 3), looking at no more than `share` candidates."""
        inside = self.labels == self.index[cut.parent]
        if not inside.any():
            self._record(cut, "failed", 0)
            return
        after = (self.placed | set(cut.children)) - ({cut.parent} if cut.vanishes else set())
        goal = self._round_goal(cut, areas, inside, after)
        used = self.budget.used
        method = self._search(cut, goal, share)
        self.placed = after
        self.seeds.update((n, (float(s[0]), float(s[1]))) for n, s in zip(cut.children, goal.seeds))
        self._record(cut, method, self.budget.used - used)

    def _record(self, cut: CutRound, method: str, candidates: int) -> None:
        self.records.append(
            CutRoundRecord(parent=cut.parent, children=list(cut.children), method=method, candidates=candidates)
        )

    def _round_goal(self, cut: CutRound, areas: dict[str, float], inside: Bools, after: set[str]) -> _RoundGoal:
        """Return seeds and areas of the children in the cells `inside` their parent, and the edges `after` the cut."""
        geometry = self.grid.cells.geometry[inside]
        cells, region = geometry[:, [CX, CY]], float(geometry[:, AREA].sum())
        targets = np.array([areas[name] for name in cut.children])
        wanted = float(targets.sum()) if cut.vanishes else areas[cut.parent]
        targets = targets * region / wanted
        seeds = self._seed_plan(cut, cells, targets / region)
        targets = planned_targets(cut, targets, region, self.shares)
        radii = base_radii(targets / region, self.options) * self.spacing
        return _RoundGoal(cells, seeds, radii, targets, *self._links(cut, after))

    def _search(self, cut: CutRound, goal: _RoundGoal, share: int) -> str:
        """Set the labels to the best of the candidates, drawn in batches; return the name of what led to them.

        The first batches lie around the planned seeds, in discs that widen with each; the later ones lie anywhere.
        """
        last = self.budget.used + share
        best, scratch = self.labels.copy(), self.labels.copy()
        fewest, energy, method = -1, 0.0, "seeds"
        for j in range(2 * self.options.retries):
            fallback = j >= self.options.retries
            size = self.budget.take(min(self.options.batch, last - self.budget.used))
            if size == 0:
                break
            if fallback:
                batch = monte_carlo_batch(goal.cells, goal.targets, size, self.rng)
            else:
                gamma = self.options.radius_growth**j
                batch = sample_batch(goal.seeds, gamma * goal.radii, size, self.spacing, self.rng)
            unmet, found = self._grow(cut, goal, batch, scratch)
            if unmet >= 0 and (fewest < 0 or unmet < fewest or (unmet == fewest and found < energy)):
                fewest, energy = unmet, found
                best[:, :] = scratch
                method = "monte_carlo" if fallback else "seeds"
            if fewest == 0:
                break
        self.labels = best
        self.energy += energy
        if fewest == 0:
            return method
        return f"{method}, {fewest} links open" if fewest > 0 else "failed"

    def _grow(self, cut: CutRound, goal: _RoundGoal, batch: Floats, out: Ints) -> tuple[int, float]:
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
            goal.links,
            goal.need,
            self.side,
            np.ascontiguousarray(batch),
            goal.targets,
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
                self.shares |= planned_shares(plan)
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
    return RoundsResult(state.labels, state.records, state.seeds, state.energy)


def planned_rounds(model: FloorModel, partition: Partition) -> RoundsResult:
    """Return the cut schedule of a planned layout, for its record."""
    records = [
        CutRoundRecord(parent=cut.parent, children=list(cut.children), method="planned")
        for cut in build_cut_rounds(model)
    ]
    seeds = {room.id: (x, y) for room, (x, y) in zip(model.rooms, model.seeds.tolist())}
    return RoundsResult(partition.labels, records, seeds, 0.0)
