"""``mansion solve`` and ``mansion place``: files of problems to files of answers."""

import os
from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.console import AsJson, check_output_file, err, print_json, progress_bar
from mansion_msgs_py.wording import counted

__all__ = ["register"]


def register(app: typer.Typer) -> None:
    """Add the commands to `app`."""
    app.command("solve", no_args_is_help=True)(solve)
    app.command("place", no_args_is_help=True)(place)


def solve(
    problems: Annotated[Path, typer.Argument(help="JSON list of floor problems.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="JSON list of layouts to write.")],
    seed: Annotated[int, typer.Option(min=0)] = 0,
    jobs: Annotated[int, typer.Option(min=0, help="Processes, 0: all cores; the result is the same.")] = 1,
    as_json: AsJson = False,
) -> None:
    """Lay out floors: a partition of each floor into rooms that meets its room graph.

    Examples:

      mansion solve problems.json -o layouts.json --seed 3 --jobs 2
    """
    from mansion_planner.solver.batch import solve_file

    check_output_file(output)
    with progress_bar() as report:
        layouts = solve_file(problems, output, seed=seed, jobs=jobs or os.cpu_count() or 1, progress=report)
    met = sum(layout.topology_satisfied for layout in layouts)
    if as_json:
        print_json({"file": str(output), "layouts": len(layouts), "every_edge_met": met})
        return
    count = counted(len(layouts), "layout")
    err.print(f"{output}: {count}, {met} with every edge met", highlight=False)


def place(
    rooms: Annotated[Path, typer.Argument(help="JSON list of rooms with their objects.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="JSON list to write.")],
    seed: Annotated[int, typer.Option(min=0)] = 0,
    jobs: Annotated[int, typer.Option(min=0, help="Processes, 0: all cores; the result is the same.")] = 1,
    as_json: AsJson = False,
) -> None:
    """Furnish rooms: where each object stands, reachable and free of collisions.

    Examples:

      mansion place rooms.json -o placements.json --seed 3
    """
    from mansion_scene.placement.files import place_file

    check_output_file(output)
    with progress_bar() as report:
        results = place_file(rooms, output, seed=seed, jobs=jobs or os.cpu_count() or 1, progress=report)
    placed = sum(len(result.placements) for result in results)
    left = sum(entry.count for result in results for entry in result.discarded)
    if as_json:
        print_json({"file": str(output), "rooms": len(results), "placed": placed, "left_out": left})
        return
    err.print(f"{output}: {counted(placed, 'object')} placed, {left} left out", highlight=False)
