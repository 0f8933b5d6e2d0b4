"""Draw the pictures of docs/floor_solver.md.

    python benchmarks/floorplans/pictures.py PROBLEMS.json --plans docs/images/floor_plans.png
    python benchmarks/floorplans/pictures.py --rounds docs/images/cut_rounds.png
    python benchmarks/floorplans/pictures.py --floors docs/images/synthetic_floors.png

The first shows 12 plans, truth beside result; the second the rounds of one floor and its final layout; the third large
synthetic floors.
"""

import argparse
from pathlib import Path
from typing import Any

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from synthetic import floor

from mansion_geometry.rings import as_polygon
from mansion_msgs_py.codec import decode
from mansion_msgs_py.layout import FloorLayout, FloorProblem, LayoutRoom
from mansion_planner.solver import solve_floor
from mansion_planner.solver.cut_rounds import SeedRequest
from mansion_planner.solver.evaluation import TrueProblem

HUB = "#f4f1e8"


def colours(problem: FloorProblem) -> dict[str, Any]:
    """Return a colour for each node."""
    return {node.id: HUB if node.type == "main" else plt.cm.tab20(k % 20) for k, node in enumerate(problem.nodes)}


def draw(axis: Any, problem: FloorProblem, rooms: list[LayoutRoom], title: str) -> None:
    """Draw rooms, cores and structural walls."""
    colour = colours(problem)
    for room in rooms:
        shape = as_polygon(room.polygon, room.holes)
        axis.fill(*np.array(room.polygon).T, fc=colour.get(room.id, HUB), ec="black", lw=0.8)
        for hole in room.holes:
            axis.fill(*np.array(hole).T, fc="white", ec="black", lw=0.8)
        point = shape.representative_point()
        label = room.id.split("_")[-1] if len(problem.nodes) > 20 else room.id
        axis.text(point.x, point.y, label, ha="center", va="center", fontsize=4.5)
    for core in problem.cores:
        axis.fill(*np.array(core.polygon).T, fc="#444444")
    for wall in problem.structural_walls:
        axis.plot(*np.array(wall).T, color="crimson", lw=2)
    axis.set_title(title, fontsize=7)
    axis.set_aspect("equal")
    axis.axis("off")


def plans(problems: list[TrueProblem], output: Path) -> None:
    """Truth beside result for 12 plans."""
    chosen = problems[:: max(1, len(problems) // 12)][:12]
    figure, axes = plt.subplots(4, 6, figsize=(12, 8.5))
    for k, problem in enumerate(chosen):
        layout = solve_floor(problem)
        pair = axes.flat[2 * k : 2 * k + 2]
        draw(pair[0], problem, problem.truth, f"plan {problem.plan_id}: truth")
        draw(pair[1], problem, layout.rooms, f"plan {problem.plan_id}: solved")
    save(figure, output)


def rounds(output: Path) -> None:
    """The rounds of one floor as a seed callback sees them, and the final layout."""
    seen: list[SeedRequest] = []

    def listen(request: SeedRequest) -> None:
        seen.append(request)

    problem = floor(56, 0)
    layout: FloorLayout = solve_floor(problem, seed_callback=listen)
    shown = seen[:4]
    figure, axes = plt.subplots(1, len(shown) + 1, figsize=(3.4 * (len(shown) + 1), 3.4))
    for axis, request in zip(axes.flat, shown):
        draw(axis, problem, request.layout, f"before the round of {request.parent}")
        own = next(room for room in request.layout if room.id == request.parent)
        axis.fill(*np.array(own.polygon).T, fc="none", ec="darkorange", lw=2)
    draw(axes.flat[len(shown)], problem, layout.rooms, "after the wall search")
    save(figure, output)


def floors(output: Path) -> None:
    """Large floors."""
    figure, axes = plt.subplots(2, 3, figsize=(12, 8))
    for axis, k in zip(axes.flat, (0, 1, 2, 3, 6, 10)):
        problem = floor(k, 0)
        layout = solve_floor(problem)
        unmet = len(layout.unmet_edges)
        draw(axis, problem, layout.rooms, f"{len(layout.rooms)} rooms, {unmet} unmet edges")
    save(figure, output)


def save(figure: Any, output: Path) -> None:
    """Write the figure."""
    output.parent.mkdir(parents=True, exist_ok=True)
    figure.tight_layout()
    figure.savefig(output, dpi=90)


def main() -> None:
    """Draw what is asked for."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("problems", type=Path, nargs="?")
    parser.add_argument("--plans", type=Path)
    parser.add_argument("--rounds", type=Path)
    parser.add_argument("--floors", type=Path)
    args = parser.parse_args()
    if args.plans:
        plans(decode(list[TrueProblem], args.problems.read_bytes()), args.plans)
    if args.rounds:
        rounds(args.rounds)
    if args.floors:
        floors(args.floors)


if __name__ == "__main__":
    main()
