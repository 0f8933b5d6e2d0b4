"""`solve_floor`: from a FloorProblem to a FloorLayout (Algorithm 2)."""

from collections.abc import Callable

import numpy as np
from mansion_geometry.randomness import item_seed
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout, FloorProblem, LayoutRoom, UnmetEdge
from mansion_msgs_py.topology import SeedPlan

from mansion_planner.solver.grid import major_lines, make_grid, spaced_lines
from mansion_planner.solver.model import FloorModel, make_model
from mansion_planner.solver.options import SolverOptions
from mansion_planner.solver.polygons import room_shapes
from mansion_planner.solver.refine import Partition, make_goal, refined_grid
from mansion_planner.solver.search import anneal
from mansion_planner.solver.starts import fit_rectangles, flood, paint_rectangles
from mansion_planner.solver.state import make_state
from mansion_planner.solver.verify import judge
from mansion_planner.solver.finish import finish

__all__ = ["solve_floor"]


def solve_floor(problem, *, options=None, seed_callback=None):
    options = options or SolverOptions()
    model = make_model(problem, options)
    goal = make_goal(model, options)
    major = major_lines(model)
    n = len(model.rooms)
    total = n + len(model.obstacles) + 1
    spacing = max(0.35, (model.region.area / 900.0) ** 0.5)
    grid = make_grid(model, spaced_lines(major[0], spacing), spaced_lines(major[1], spacing))
    rng = np.random.default_rng(item_seed(problem.seed, "floor", problem.plan_id))
    best = None
    for attempt in range(4):
        seeds = goal.seed.copy()
        missing = goal.seed_weight <= 0
        free = np.argwhere(grid.cells.free)
        pick = free[rng.integers(len(free), size=n)]
        seeds[missing] = np.stack([grid.cells.cx[pick[:,0],pick[:,1]], grid.cells.cy[pick[:,0],pick[:,1]]],1)[missing]
        labels = grid.base.copy()
        boxes, costs = fit_rectangles(grid.cells, goal, 30)
        sel = boxes[:, 0] != 0
        boxes, costs = boxes[sel], costs[sel]
        if len(boxes):
            paint_rectangles(labels, grid.cells, boxes, costs)
        if not flood(labels, grid.cells, goal, seeds):
            continue
        state = make_state(labels, n, total)
        seeded = bool(len(boxes))
        e = anneal(grid.cells, goal, state, boxes, 6000 if seeded else 30000, 0.15 if seeded else 0.6, 0.005, 4, 0.0 if seeded else 0.05, 0.05 if seeded else 0.0, int(rng.integers(2**62)))
        part = Partition(grid, state.lab.copy(), e)
        if best is None or e < best.energy:
            best = part
        if seeded:
            break
    if best is None:
        raise MansionError(ErrorCode.INFEASIBLE, "the rooms do not fit into the free region", path="$.nodes")
    for offsets, proposals in (((0.22, 0.1), 3000), ((0.07, 0.03), 3000)):
        g, labels = refined_grid(model, major, best, offsets)
        state = make_state(labels, n, total)
        e = anneal(g.cells, goal, state, np.zeros((0, 5), np.int64), proposals, 0.0, 0.0, 4, 0.0, 0.0, int(rng.integers(2**62)))
        best = Partition(g, state.lab.copy(), e)
    return finish(model, best, options)
