"""From a coarse partition to straight walls at the right places: levels of ever finer grids around the walls."""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np

from mansion_planner.solver.grid import Grid, make_grid, resample
from mansion_planner.solver.model import FloorModel
from mansion_planner.solver.objective import WEIGHTS
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.state import Floats, Goal, Ints
from mansion_planner.solver.zones import Link

__all__ = ["Partition", "make_goal", "mostly_seeded", "refined_grid", "used_lines"]


@dataclass(frozen=True)
class Partition:
    """A labelled grid and its energy."""

    grid: Grid
    labels: Ints
    energy: float


def make_goal(model: FloorModel, options: SolverOptions, left_out: Iterable[Link] = ()) -> Goal:
    """Return the goal arrays of the wall search; links that are `left_out` are not asked for."""
    n = len(model.rooms)
    total = n + len(model.obstacles) + 1
    index = model.index
    dropped = set(left_out)
    links = [link for link in model.links if link not in dropped]
    pairs = np.array([(index[k.source], index[k.target]) for k in links], np.int64)
    pairs = pairs.reshape(-1, 2)
    kind = np.array([0 if k.kind == "access" else 1 for k in links], np.int64)
    need = np.where(kind == 0, model.problem.min_access_wall, options.adjacent_wall).astype(float)
    side = np.zeros(total, np.int64)
    for k, obstacle in enumerate(model.obstacles):
        side[n + k] = obstacle.side
    known = ~np.isnan(model.seeds[:, 0])
    linked = {(min(a, b), max(a, b)) for a, b in pairs.tolist()}
    apart = np.array(
        [(a, b) for a in range(n) for b in range(a + 1, n) if (a, b) not in linked] if (kind == 1).any() else [],
        np.int64,
    ).reshape(-1, 2)
    hub = np.arange(n) == 0
    weights = options.seeded if mostly_seeded(model) else options.unseeded
    rooms = np.stack(
        [
            model.targets,
            np.nan_to_num(model.seeds[:, 0]),
            np.nan_to_num(model.seeds[:, 1]),
            np.where(known, np.where(hub, 0.5, 1.0), 0.0),
            model.min_widths,
            np.where(hub, 0.2, 1.0),
            np.where(hub, 0.5 if mostly_seeded(model) else 1.0, 1.0),
            np.where(known | hub, 0.0, 1.0),
        ],
        axis=1,
    )
    return Goal(
        rooms=np.ascontiguousarray(rooms),
        links=np.column_stack([pairs, kind]),
        need=need + 1e-3,
        side=side,
        apart=apart,
        weights=np.array([getattr(weights, name) for name in WEIGHTS], dtype=float),
    )


def mostly_seeded(model: FloorModel) -> bool:
    """Tell whether most rooms besides the hub have a seed."""
    known = ~np.isnan(model.seeds[1:, 0])
    return bool(known.size and known.mean() > 0.6)


def used_lines(grid: Grid, labels: Ints) -> tuple[Floats, Floats]:
    """Return the lines of `grid` (without its frame) along which labels change."""
    across = (labels[:, 1:] != labels[:, :-1]).any(axis=0)
    along = (labels[1:, :] != labels[:-1, :]).any(axis=1)
    return grid.cells.xs[1:-1][across], grid.cells.ys[1:-1][along]


def _beside(lines: Floats, major: Floats, offsets: tuple[float, ...]) -> Floats:
    """Return the major lines and `lines`, with others at the offsets on both sides of each that is not major."""
    moved = [major, lines]
    for offset in offsets:
        moved.extend([lines - offset, lines + offset])
    low, high = major[0], major[-1]
    merged = np.unique(np.concatenate(moved))
    merged = merged[(merged >= low) & (merged <= high)]
    fixed = np.concatenate([major, lines])
    gap = 0.4 * min(offsets)
    keep: list[float] = []
    for value in merged.tolist():
        near = fixed[np.argmin(np.abs(fixed - value))]
        if value != near and abs(value - near) < gap:
            continue
        if keep and value - keep[-1] < 1e-5:
            continue
        keep.append(value)
    return np.array(keep)


def refined_grid(
    model: FloorModel, major: tuple[Floats, Floats], partition: Partition, offsets: tuple[float, ...]
) -> tuple[Grid, Ints]:
    """Return a grid of the used lines with finer ones around them, and the partition's labels on it."""
    xs, ys = used_lines(partition.grid, partition.labels)
    grid = make_grid(model, _beside(xs, major[0], offsets), _beside(ys, major[1], offsets))
    return grid, resample(partition.grid, partition.labels, grid)
