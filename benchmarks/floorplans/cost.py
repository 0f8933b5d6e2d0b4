"""What a floor costs: processor seconds against the number of rooms, and against the cells of the first grid.

    python benchmarks/floorplans/cost.py [--floors 6] [--seed 0] [-o docs/images/solver_cost.png]

The first series are synthetic floors of 10 to 60 rooms; the second the same floors of 30 rooms at several resolutions.
"""

import argparse
import time
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from synthetic import floor

from mansion_geometry.randomness import item_seed
from mansion_msgs_py.layout import FloorProblem
from mansion_planner.solver import SolverOptions, solve_floor, warm
from mansion_planner.solver.grid import major_lines
from mansion_planner.solver.problem import make_model
from mansion_planner.solver.solve import coarse_grid

ROOMS = (10, 20, 30, 40, 50, 60)
CELLS = (225, 450, 900, 1800, 3600)
FINEST = 0.1


@dataclass(frozen=True)
class Cost:
    """What one floor took: its rooms, the first grid's free cells, processor seconds, candidates, and if all is met."""

    rooms: int
    cells: int
    seconds: float
    candidates: float
    met: bool


def measured(problem: FloorProblem, options: SolverOptions) -> Cost:
    """Solve one floor."""
    model = make_model(problem, options)
    grid = coarse_grid(model, major_lines(model), options)
    begin = time.process_time()
    layout = solve_floor(problem, options=options)
    seconds = time.process_time() - begin
    candidates = layout.checks["candidates"]
    met = layout.topology_satisfied
    free = int(np.count_nonzero(grid.cells.free))
    return Cost(len(problem.nodes), free, seconds, candidates, met)


def table(rows: Iterable[tuple[int, list[Cost]]], title: str) -> str:
    """Return the costs as a table, a row for each setting."""
    lines = [
        f"| {title} | floors; all met | cells | median s | least to largest s | candidates | us a candidate |",
        "| --- | --- | --- | --- | --- | --- | --- |",
    ]
    for setting, costs in rows:
        seconds = [cost.seconds for cost in costs]
        each = [1e6 * cost.seconds / max(cost.candidates, 1.0) for cost in costs]
        lines.append(
            f"| {setting} | {len(costs)}; {sum(c.met for c in costs)} | {np.median([c.cells for c in costs]):.0f} | "
            f"{np.median(seconds):.2f} | {min(seconds):.2f} to {max(seconds):.2f} | "
            f"{np.median([c.candidates for c in costs]):,.0f} | {np.median(each):.1f} |"
        )
    return "\n".join(lines)


def draw(axis: Any, rows: list[tuple[int, list[Cost]]], key: str, label: str) -> None:
    """Draw every floor as a dot and the medians as a line."""
    for _, costs in rows:
        axis.plot([getattr(c, key) for c in costs], [c.seconds for c in costs], "o", c="#9db4c8")
    middles = [
        (np.median([getattr(c, key) for c in costs]), np.median([c.seconds for c in costs])) for _, costs in rows
    ]
    axis.plot(*zip(*middles), "-s", c="#1f4e79", label="median")
    axis.set(xlabel=label, ylabel="processor seconds", yscale="log")
    axis.grid(alpha=0.3, which="both")
    axis.legend(frameon=False)


def main() -> None:
    """Run the benchmark."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--floors", type=int, default=6, help="floors of each setting")
    parser.add_argument("--seed", type=int, default=0)
    parser.add_argument("-o", "--output", type=Path, help="picture to write")
    args = parser.parse_args()
    warm()
    seed = item_seed(args.seed, "cost")
    plain = SolverOptions()
    by_rooms = [(rooms, [measured(floor(k, seed, rooms), plain) for k in range(args.floors)]) for rooms in ROOMS]
    print(table(by_rooms, "rooms"), flush=True)
    by_cells = []
    for cells in CELLS:
        options = SolverOptions(cells=float(cells), unseeded_spacing=FINEST)
        costs = [measured(floor(k, seed, 30), options) for k in range(args.floors)]
        by_cells.append((cells, costs))
    print(table(by_cells, "`cells`"))
    if args.output:
        figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
        draw(left, by_rooms, "rooms", "rooms")
        draw(right, by_cells, "cells", "cells of the first grid (30 rooms)")
        right.set_xscale("log")
        right.set_xticks(CELLS, [str(cells) for cells in CELLS])
        right.minorticks_off()
        figure.savefig(args.output, dpi=110)


if __name__ == "__main__":
    main()
