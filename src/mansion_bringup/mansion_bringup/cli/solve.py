"""``mansion solve`` and ``mansion place``: files of problems to files of answers."""

from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.console import check_output_file, err, progress_bar
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
    jobs: Annotated[int, typer.Option(min=1, help="Processes; the result is the same.")] = 1,
) -> None:
    """Lay out floors: a partition of each floor into rooms that meets its room graph.

    Examples:

      mansion solve problems.json -o layouts.json --seed 3 --jobs 2
    """
    from mansion_planner.solver.batch import solve_file

    check_output_file(output)
    with progress_bar() as report:
        layouts = solve_file(problems, output, seed=seed, jobs=jobs, progress=report)
    met = sum(layout.topology_satisfied for layout in layouts)
    count = counted(len(layouts), "layout")
    err.print(f"{output}: {count}, {met} with every edge met", highlight=False)


def place(
    rooms: Annotated[Path, typer.Argument(help="JSON list of rooms with their objects.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="JSON list to write.")],
    seed: Annotated[int, typer.Option(min=0)] = 0,
    jobs: Annotated[int, typer.Option(min=1, help="Processes; the result is the same.")] = 1,
) -> None:
    """Furnish rooms: where each object stands, reachable and free of collisions.

    Examples:

      mansion place rooms.json -o placements.json --seed 3
    """
    from mansion_scene.placement.files import place_file

    check_output_file(output)
    with progress_bar() as report:
        results = place_file(rooms, output, seed=seed, jobs=jobs, progress=report)
    placed = sum(len(result.placements) for result in results)
    left = sum(entry.count for result in results for entry in result.discarded)
    err.print(f"{output}: {counted(placed, 'object')} placed, {left} left out", highlight=False)
