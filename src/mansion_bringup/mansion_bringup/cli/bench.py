"""``mansion bench``: the benchmarks that users run on their own problems and machines."""

from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.bench_agents import agents
from mansion_bringup.cli.console import progress_bar
from mansion_bringup.cli.gallery import gallery
from mansion_msgs_py.reading import read_payload

__all__ = ["register"]


def register(app: typer.Typer) -> None:
    """Add the command group to `app`."""
    group = typer.Typer(help="Measure solvers, agents and the graph.", no_args_is_help=True)
    group.command("floorplans", no_args_is_help=True)(floorplans)
    group.command("placement", no_args_is_help=True)(placement)
    group.command("agents", no_args_is_help=True)(agents)
    group.command("graph")(graph)
    group.command("gallery")(gallery)
    app.add_typer(group, name="bench")


def floorplans(
    problems: Annotated[Path, typer.Argument(help="JSON list of problems with their truth.")],
    seeds: Annotated[bool, typer.Option(help="Use the problems' seed points.")] = True,
    seed: Annotated[int, typer.Option(min=0)] = 0,
) -> None:
    """Solve floor problems and score them against the truth on a 64x64 raster (section A.1).

    Examples:

      mansion bench floorplans problems.json

      mansion bench floorplans problems.json --no-seeds
    """
    from mansion_planner.solver.evaluation import TrueProblem, run_protocol, table

    read = read_payload(list[TrueProblem], problems, "a JSON list of floor problems")
    if not seeds:
        for problem in read:
            problem.seeds = None
            for node in problem.nodes:
                node.seed = node.seed_box = None
    scores, _ = run_protocol(read, seed=seed)
    typer.echo(table(scores))


def placement(
    rooms: Annotated[Path, typer.Argument(help="JSON list of rooms with their objects.")],
    seeds: Annotated[int, typer.Option(min=1, help="How many seeds.")] = 10,
) -> None:
    """Place rooms under several seeds and print what is reached, room by room.

    Examples:

      mansion bench placement rooms.json --seeds 3
    """
    from mansion_scene.placement.evaluation import bench, table
    from mansion_scene.placement.files import load_rooms

    runs = bench(load_rooms(rooms), range(seeds))
    typer.echo(table({name: [found for _, found in pairs] for name, pairs in runs.items()}))


def graph(
    brief: Annotated[str, typer.Option(help="What to build.")] = "a two-storey house",
    repeat: Annotated[int, typer.Option(min=1)] = 3,
) -> None:
    """Time a build in one process and through a private node graph, and compare the bytes.

    Examples:

      mansion bench graph --brief "a four-storey office" --repeat 5
    """
    from mansion_bringup.graph.timing import compare_builds

    with progress_bar() as report:
        result = compare_builds(brief, repeat, report)
    typer.echo(str(result))
