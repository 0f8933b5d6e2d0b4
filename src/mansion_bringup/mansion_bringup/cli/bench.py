"""``mansion bench``: the benchmarks that users run on their own problems and machines."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer
from msgspec.structs import replace

from mansion_bringup.cli.bench_agents import agents
from mansion_bringup.cli.console import AsJson, check_output_folder, err, print_json, progress_bar
from mansion_msgs_py.building_folder import file_in
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import read_payload, write_atomic
from mansion_msgs_py.placement import PlacementResult

if TYPE_CHECKING:
    from mansion_planner.solver.evaluation import TrueProblem

__all__ = ["gallery", "register"]


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
    as_json: AsJson = False,
) -> None:
    """Solve floor problems and score them against the truth on a 64x64 raster (section A.1).

    Examples:

      mansion bench floorplans problems.json

      mansion bench floorplans problems.json --no-seeds
    """
    from mansion_planner.solver.evaluation import TrueProblem, run_protocol, table

    read = read_payload(list[TrueProblem], problems, "a JSON list of floor problems")
    if not seeds:
        read = [_without_seeds(problem) for problem in read]
    scores, _ = run_protocol(read, seed=seed)
    print_json(scores) if as_json else typer.echo(table(scores))


def _without_seeds(problem: "TrueProblem") -> "TrueProblem":
    nodes = [replace(node, seed=None, seed_box=None) for node in problem.nodes]
    return replace(problem, seeds=None, nodes=nodes)


def placement(
    rooms: Annotated[Path, typer.Argument(help="JSON list of rooms with their objects.")],
    seeds: Annotated[int, typer.Option(min=1, help="How many seeds.")] = 10,
    as_json: AsJson = False,
) -> None:
    """Place rooms under several seeds and print what is reached, room by room.

    Examples:

      mansion bench placement rooms.json --seeds 3
    """
    from mansion_scene.placement.evaluation import bench, table
    from mansion_scene.placement.files import load_rooms

    runs = bench(load_rooms(rooms), range(seeds))
    measures = {name: [found for _, found in pairs] for name, pairs in runs.items()}
    print_json(measures) if as_json else typer.echo(table(measures))


def graph(
    brief: Annotated[str, typer.Option(help="What to build.")] = "a two-storey house",
    repeat: Annotated[int, typer.Option(min=1)] = 3,
    as_json: AsJson = False,
) -> None:
    """Time a build in one process and through a private node graph, and compare the bytes.

    Examples:

      mansion bench graph --brief "a four-storey office" --repeat 5
    """
    from mansion_bringup.graph.build_timing import compare_builds

    with progress_bar() as report:
        result = compare_builds(brief, repeat, report)
    print_json(result) if as_json else typer.echo(str(result))


def gallery(
    rooms: Annotated[Path, typer.Argument(help="JSON list of rooms with their objects.")],
    systems: Annotated[list[str], typer.Argument(help="NAME=PLACEMENTS.json for each system; may be repeated.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder for pages, form and key.")],
    seed: Annotated[int, typer.Option(min=0, help="Decides the order of panels.")] = 0,
    runs: Annotated[int, typer.Option(min=1, help="Runs of a room shown for a system.")] = 2,
    answers: Annotated[list[Path] | None, typer.Option(help="Saved answers: print their tally instead.")] = None,
    as_json: AsJson = False,
) -> None:
    """Lay the same rooms of several systems side by side, unlabelled, with a key file.

    A system's files may hold several runs of a room, or be given several times.

    Examples:

      mansion bench gallery rooms.json ours=a.json ours=b.json other=c.json -o gallery

      mansion bench gallery rooms.json ours=a.json other=c.json -o gallery --answers answers.json
    """
    from mansion_export.pictures.gallery import Answer, GalleryKey, gallery_files, tally
    from mansion_scene.placement.files import load_rooms

    if answers:
        key = read_payload(GalleryKey, output / "key.json")
        given = [entry for file in answers for entry in read_payload(list[Answer], file)]
        found = tally(given, key)
        if as_json:
            print_json(found)
            return
        for question, shares in found.items():
            line = ", ".join(f"{name} {share:.0%}" for name, share in shares.items())
            typer.echo(f"{question:10} {line}")
        return
    check_output_folder(output)
    results: dict[str, list[PlacementResult]] = {}
    for entry in systems:
        name, separator, file = entry.partition("=")
        if not name or not separator:
            raise MansionError(
                ErrorCode.INVALID_PAYLOAD, f"{entry!r} is not of the form NAME=PLACEMENTS.json", path="$.systems"
            )
        results.setdefault(name, []).extend(read_payload(list[PlacementResult], Path(file)))
    files = gallery_files(load_rooms(rooms), results, seed=seed, runs=runs)
    for file_name, data in files.items():
        write_atomic(file_in(output, file_name), data)
    err.print(f"wrote {len(files) - 2} pages, form.html and key.json to {output}", highlight=False)
    if as_json:
        print_json({"folder": str(output), "files": list(files)})
