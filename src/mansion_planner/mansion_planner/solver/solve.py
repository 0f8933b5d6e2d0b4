"""`solve_floor`: from a FloorProblem to a FloorLayout (Algorithm 2)."""

from collections.abc import Callable

import numpy as np
from mansion_geometry.randomness import item_seed
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.topology import SeedPlan

from mansion_planner.solver.finish import finish
from mansion_planner.solver.grid import Grid, major_lines, make_grid, spaced_lines
from mansion_planner.solver.model import make_model
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.refine import Partition, make_goal, refined_grid
from mansion_planner.solver.search import anneal
from mansion_planner.solver.starts import fit_rectangles, flood, paint_rectangles
from mansion_planner.solver.state import CX, CY, SEED_WEIGHT, SEED_X, SEED_Y, Goal, make_state

__all__ = ["solve_floor"]

SeedCallback = Callable[..., SeedPlan | None]


def _start(
    grid: Grid, goal: Goal, total: int, rng: np.random.Generator
) -> Partition | None:
    """Return one annealed coarse partition."""
    n = len(goal.rooms)
    seeds = goal.rooms[:, SEED_X : SEED_Y + 1].copy()
    missing = goal.rooms[:, SEED_WEIGHT] <= 0
    free = np.argwhere(grid.cells.free)
    pick = free[rng.integers(len(free), size=n)]
    points = np.stack(
        [grid.cells.geometry[pick[:, 0], pick[:, 1], k] for k in (CX, CY)], 1
    )
    seeds[missing] = points[missing]
    labels = grid.base.copy()
    boxes, costs = fit_rectangles(grid.cells, goal, 30)
    boxes, costs = boxes[boxes[:, 0] != 0], costs[boxes[:, 0] != 0]
    if len(boxes):
        paint_rectangles(labels, grid.cells, boxes, costs)
    if not flood(labels, grid.cells, goal, seeds):
        return None
    state = make_state(labels, n, total)
    seeded = bool(len(boxes))
    energy = anneal(
        grid.cells,
        goal,
        state,
        boxes,
        6000 if seeded else 20000,
        0.15 if seeded else 0.6,
        0.005,
        4,
        0.0 if seeded else 0.05,
        0.05 if seeded else 0.0,
        int(rng.integers(2**62)),
    )
    return Partition(grid, state.labels.copy(), energy)


def solve_floor(
    problem: FloorProblem,
    *,
    options: SolverOptions | None = None,
    seed_callback: SeedCallback | None = None,
) -> FloorLayout:
    """Lay out one floor.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` with the reason when no partition can exist.
    """
    options = options or SolverOptions()
    model = make_model(problem, options)
    goal = make_goal(model, options)
    major = major_lines(model)
    n = len(model.rooms)
    total = n + len(model.obstacles) + 1
    spacing = max(0.35, (model.region.area / 900.0) ** 0.5)
    grid = make_grid(model, spaced_lines(major[0], spacing), spaced_lines(major[1], spacing))
    rng = np.random.default_rng(item_seed(problem.seed, "floor", problem.plan_id))
    best: Partition | None = None
    for _ in range(4):
        found = _start(grid, goal, total, rng)
        if found is not None and (best is None or found.energy < best.energy):
            best = found
        if found is not None and (goal.rooms[:, SEED_WEIGHT] > 0).all():
            break
    if best is None:
        raise MansionError(
            ErrorCode.INFEASIBLE, "the rooms do not fit into the free region", path="$.nodes"
        )
    for offsets in ((0.22, 0.1), (0.07, 0.03)):
        finer, labels = refined_grid(model, major, best, offsets)
        state = make_state(labels, n, total)
        none = np.zeros((0, 5), np.int64)
        seed = int(rng.integers(2**62))
        energy = anneal(finer.cells, goal, state, none, 3000, 0.0, 0.0, 4, 0.0, 0.0, seed)
        best = Partition(finer, state.labels.copy(), energy)
    return finish(model, best, options)
