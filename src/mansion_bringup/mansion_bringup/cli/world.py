"""``mansion world``: many buildings drawn from a mixture, as one data set."""

import os
from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.console import EXIT_INTERRUPTED, AsJson, check_output_folder, err, out, print_json
from mansion_bringup.cli.pace import pace_reporter
from mansion_bringup.cli.world_products import agents, merge, pack, show
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.wording import counted
from mansion_world.making import Jobs, Workers

__all__ = ["need_parquet", "register", "write_parquet_tables"]


def register(app: typer.Typer) -> None:
    """Add the commands to `app`."""
    group = typer.Typer(
        help="Worlds of many buildings: make, check, describe, try, show, pack, join.", no_args_is_help=True
    )
    group.command("make", no_args_is_help=True)(make)
    group.command("stats", no_args_is_help=True)(stats)
    group.command("check", no_args_is_help=True)(check)
    for command in (agents, show, pack, merge):
        group.command(command.__name__, no_args_is_help=True)(command)
    app.add_typer(group, name="world")


def make(
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder of the world.")],
    count: Annotated[int, typer.Option("--count", "-n", min=1, max=1_000_000, help="Buildings.")],
    seed: Annotated[int, typer.Option(min=0, help="Same seed and mixture, same world.")] = 0,
    mix: Annotated[Path | None, typer.Option(help="TOML file of kinds and shares; MansionWorld's own if none.")] = None,
    tasks: Annotated[int, typer.Option(min=0, max=100, help="Tasks for each building, done by the oracle.")] = 3,
    parquet: Annotated[bool, typer.Option(help="Write the manifest in Parquet too (extra world).")] = True,
    jobs: Annotated[
        int, typer.Option(min=0, help="Buildings in work at once; 0: all cores, or all threads of the cluster.")
    ] = 0,
    cluster: Annotated[
        str, typer.Option(help="Address of a dask scheduler whose workers build; they share the folder.")
    ] = "",
    as_json: AsJson = False,
) -> None:
    """Make a world of buildings, or go on with one.

    Run again, the command goes on where it was; with a larger number it adds buildings to those that are there.

    Examples:

      mansion world make -o out/world -n 100 --seed 7

      mansion world make -o out/flats -n 20 --mix flats.toml --tasks 0 --jobs 2

      mansion world make -o /shared/world -n 10000 --cluster tcp://127.0.0.1:8786
    """
    from mansion_bringup.worlds import build_for_world, check_for_world, tasks_for_world
    from mansion_world.attempts import TaskStep
    from mansion_world.making import make_world
    from mansion_world.mixture import load_mixture
    from mansion_world.requests import Sampled

    mixture = load_mixture(mix)
    check_output_folder(output)
    if parquet:
        need_parquet()
    workers, width = _on_cluster(cluster, jobs) if cluster else _in_processes(jobs)
    try:
        made = make_world(
            output,
            count,
            requests=Sampled(seed, mixture),
            build=build_for_world,
            check=check_for_world,
            workers=workers,
            jobs=width,
            tasks=TaskStep(tasks, tasks_for_world),
            report=pace_reporter(),
        )
    except KeyboardInterrupt:
        err.print("interrupted; the same command goes on from the buildings that are done")
        raise typer.Exit(EXIT_INTERRUPTED) from None
    if parquet:
        write_parquet_tables(output)
    if as_json:
        print_json(made)
        raise typer.Exit(1 if made.missing else 0)
    missing = f", {made.missing} places left empty" if made.missing else ""
    out.print(f"{output}: {counted(made.done, 'building')}, {made.set_aside} set aside{missing}", highlight=False)
    if made.missing:
        raise typer.Exit(1)


def need_parquet() -> None:
    """Install the extra for Parquet, or say how to do without it."""
    from mansion_bringup.extras import ensure_extra

    try:
        ensure_extra("world")
    except MansionError as error:
        raise error.with_message(f"{error.info.message}; or leave the Parquet out: --no-parquet") from None


def write_parquet_tables(output: Path) -> None:
    """Write the manifest of a world in Parquet."""
    from mansion_world.parquet import write_parquet
    from mansion_world.world_folder import WorldFolder

    world = WorldFolder(output)
    with world.locked():
        write_parquet(world)


def _in_processes(jobs: int) -> tuple[Workers, int]:
    from mansion_bringup.worlds import world_workers

    number = jobs or min(os.cpu_count() or 1, 64)
    return world_workers(number), number


def _on_cluster(address: str, jobs: int) -> tuple[Workers, Jobs]:
    from mansion_bringup.cluster import Cluster
    from mansion_bringup.extras import ensure_extra

    ensure_extra("cluster")
    found = Cluster(address, jobs, lambda text: err.print(text, markup=False, highlight=False))
    return found.workers, found.jobs


def stats(
    world: Annotated[Path, typer.Argument(help="Folder that `mansion world make` wrote.")],
    page: Annotated[bool, typer.Option(help="Also write statistics.html into the folder.")] = True,
    as_json: AsJson = False,
) -> None:
    """Describe a world: its mixture against the asked one, floors, areas, rooms, objects, tasks and how agents did.

    Examples:

      mansion world stats out/world
    """
    from mansion_msgs_py.files import write_atomic
    from mansion_world.statistics import world_statistics
    from mansion_world.statistics_page import statistics_page
    from mansion_world.world_folder import WorldFolder

    folder = WorldFolder(world)
    statistics = world_statistics(folder)
    tables = {title: rows for title, rows in statistics.tables().items() if rows}
    if as_json:
        print_json({title: dict(rows) for title, rows in tables.items()})
    else:
        for title, rows in tables.items():
            typer.echo(title)
            width = max(len(name) for name, _ in rows)
            for name, value in rows:
                typer.echo(f"  {name:<{width}}  {value}")
    if page:
        write_atomic(world / "statistics.html", statistics_page(folder, statistics).encode())
        err.print(f"wrote {world / 'statistics.html'}", highlight=False)


def check(
    world: Annotated[Path, typer.Argument(help="Folder that `mansion world make` wrote.")], as_json: AsJson = False
) -> None:
    """Verify a world: manifest, hashes, each building and its tasks; exit status 1 and a line for each fault.

    Examples:

      mansion world check out/world
    """
    from mansion_bringup.worlds import check_for_world, redo_tasks
    from mansion_world.verification import verify_world

    checked = 0
    faults: list[dict[str, str]] = []

    def count(buildings: int) -> None:
        nonlocal checked
        checked = buildings

    for where, fault in verify_world(world, check_for_world, count, redo=redo_tasks):
        faults.append({"building": str(where), "fault": str(fault)})
        if not as_json:
            typer.echo(f"{where}: {fault}")
    if as_json:
        print_json({"buildings": checked, "faults": faults})
    err.print(f"{world}: {counted(checked, 'building')}, {counted(len(faults), 'fault')}", highlight=False)
    if faults:
        raise typer.Exit(1)
