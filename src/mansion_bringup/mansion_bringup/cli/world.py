"""``mansion world``: many buildings as one data set: made, checked, described, tried, shown, packed and joined."""

import os
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from mansion_bringup.cli.console import (
    EXIT_INTERRUPTED,
    AsJson,
    buildings_reporter,
    check_output_folder,
    err,
    out,
    print_json,
)
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.wording import counted

if TYPE_CHECKING:
    from mansion_world.making import Jobs, Workers, WorldProgress
    from mansion_world.requests import Requests

__all__ = ["register"]

World = Annotated[Path, typer.Argument(help="Folder that `mansion world make` wrote.")]

_EVERY = 100
"""Buildings between two lines of progress."""


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
    mix: Annotated[Path | None, typer.Option(help="TOML file of kinds and shares; MansionWorld's by default.")] = None,
    tasks: Annotated[int, typer.Option(min=0, max=100, help="Tasks for each building, done by the oracle.")] = 3,
    parquet: Annotated[bool, typer.Option(help="Write the manifest in Parquet too (extra world).")] = True,
    jobs: Annotated[
        int, typer.Option(min=0, help="Buildings built at once; 0: all cores, or all threads of the cluster.")
    ] = 0,
    cluster: Annotated[
        str, typer.Option(help="Address of a dask scheduler whose workers build; they share the folder.")
    ] = "",
    as_json: AsJson = False,
) -> None:
    """Make a world of buildings, or continue one.

    Run again, the command continues where it stopped; with a larger number it adds buildings to the existing ones.

    Examples:

      mansion world make -o out/world -n 100 --seed 7

      mansion world make -o out/flats -n 20 --mix flats.toml --tasks 0 --jobs 2

      mansion world make -o /shared/world -n 10000 --cluster tcp://127.0.0.1:8786
    """
    from mansion_world.mixture import load_mixture
    from mansion_world.requests import Sampled

    requests = Sampled(seed, load_mixture(mix))
    check_output_folder(output)
    if parquet:
        _need_parquet()
    workers, width = _on_cluster(cluster, jobs) if cluster else _in_processes(jobs)
    made = _made(output, count, requests, tasks, workers, width)
    if parquet:
        _write_parquet_tables(output)
    if as_json:
        print_json(made)
    else:
        missing = f", {made.missing} places left empty" if made.missing else ""
        out.print(f"{output}: {counted(made.done, 'building')}, {made.set_aside} set aside{missing}", highlight=False)
    if made.missing:
        raise typer.Exit(1)


def _made(
    output: Path, count: int, requests: "Requests", tasks: int, workers: "Workers", width: "int | Jobs"
) -> "WorldProgress":
    """Make a world; when interrupted, say how to go on, and end."""
    from mansion_bringup.worlds import build_for_world, check_for_world, tasks_for_world
    from mansion_world.attempts import TaskStep
    from mansion_world.making import make_world

    try:
        return make_world(
            output,
            count,
            requests=requests,
            build=build_for_world,
            check=check_for_world,
            workers=workers,
            jobs=width,
            tasks=TaskStep(tasks, tasks_for_world),
            report=buildings_reporter(),
        )
    except KeyboardInterrupt:
        err.print("interrupted; run the same command again to continue with the remaining buildings")
        raise typer.Exit(EXIT_INTERRUPTED) from None


def _need_parquet() -> None:
    """Install the extra for Parquet, or say how to do without it."""
    from mansion_bringup.extras import ensure_extra

    try:
        ensure_extra("world")
    except MansionError as error:
        raise error.with_message(f"{error.info.message}; or use --no-parquet") from None


def _write_parquet_tables(output: Path) -> None:
    """Write the manifest of a world in Parquet."""
    from mansion_world.parquet import write_parquet
    from mansion_world.world_folder import WorldFolder

    world = WorldFolder(output)
    with world.locked():
        write_parquet(world)


def _in_processes(jobs: int) -> "tuple[Workers, int]":
    from mansion_bringup.worlds import world_workers

    number = jobs or min(os.cpu_count() or 1, 64)
    return world_workers(number), number


def _on_cluster(address: str, jobs: int) -> "tuple[Workers, Jobs]":
    from mansion_bringup.cluster import Cluster
    from mansion_bringup.extras import ensure_extra

    ensure_extra("cluster")
    found = Cluster(address, jobs, lambda text: err.print(text, markup=False, highlight=False))
    return found.workers, found.jobs


def stats(
    world: World,
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


def check(world: World, as_json: AsJson = False) -> None:
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


def agents(
    world: World,
    names: Annotated[
        str, typer.Option("--agents", "-a", help="Names with commas between them.")
    ] = "random,explorer,oracle",
    buildings: Annotated[
        int, typer.Option("--count", "-n", min=0, help="Only this many buildings, from the first on.")
    ] = 0,
    seed: Annotated[int, typer.Option(min=0)] = 0,
    jobs: Annotated[int, typer.Option(min=0, help="Processes, 0: all cores; the result is the same.")] = 0,
    as_json: AsJson = False,
) -> None:
    """Let agents try the tasks of a world: logs in its folder `agents`, a row each in manifest/trials.jsonl.

    An interrupted run continues where it stopped. `mansion world stats` then shows success by difficulty.

    Examples:

      mansion world agents out/world

      mansion world agents out/world --agents explorer -n 50 --jobs 2
    """
    from mansion_bringup.cli.bench_agents import chosen_agents, follow_bench, provide_for_agents
    from mansion_bringup.worlds import trials_of
    from mansion_tasks.episodes.bench import Bench
    from mansion_tasks.episodes.results import render
    from mansion_world.trials import task_sets, write_trials
    from mansion_world.world_folder import WorldFolder

    folder, chosen = WorldFolder(world), chosen_agents(names)
    bench = Bench(files=tuple(task_sets(folder, buildings)), agents=chosen, output=world / "agents", seed=seed)
    provide_for_agents(chosen)
    result, _ = follow_bench(bench, jobs or os.cpu_count() or 1)
    write_trials(folder, trials_of(result))
    print_json(result.summary) if as_json else typer.echo(render(result.summary))
    err.print(f"{folder.table('trials')}: {counted(len(result.episodes), 'trial')}", highlight=False)


def pack(
    world: World,
    output: Annotated[Path, typer.Option("--output", "-o", help="New folder for the shards.")],
    shard_size: Annotated[float, typer.Option(min=0.1, help="Largest size of a shard, megabytes.")] = 500.0,
    as_json: AsJson = False,
) -> None:
    """Write a world as WebDataset shards with its manifest and a data card.

    Shards are tar files, each of one split; a building is a sample, and greater than a shard only where it alone is.

    Examples:

      mansion world pack out/world -o out/world-shards --shard-size 500
    """
    from mansion_world.packing import pack_world
    from mansion_world.world_folder import WorldFolder

    check_output_folder(output)
    shards = pack_world(WorldFolder(world), output, shard_bytes=int(shard_size * 1e6), report=_report)
    if as_json:
        print_json(shards)
        return
    buildings, size = sum(shard.samples for shard in shards), sum(shard.bytes for shard in shards) / 1e6
    told = f"{counted(buildings, 'building')} in {counted(len(shards), 'shard')}, {size:.1f} MB"
    out.print(f"{output}: {told}", highlight=False)


def merge(
    worlds: Annotated[list[Path], typer.Argument(help="Folders that `mansion world make` wrote.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="New folder for the joined world.")],
    parquet: Annotated[bool, typer.Option(help="Write the manifest in Parquet too (extra world).")] = True,
    as_json: AsJson = False,
) -> None:
    """Join worlds that were made apart; a line for each building that is there already and is left out.

    Examples:

      mansion world merge out/flats out/offices -o out/both
    """
    from mansion_world.merging import merge_worlds

    check_output_folder(output)
    if parquet:
        _need_parquet()
    merged = merge_worlds(worlds, output, _report)
    if parquet:
        _write_parquet_tables(output)
    if as_json:
        print_json(merged)
        return
    for line in merged.dropped:
        typer.echo(f"left out: {line}")
    told = f"{counted(merged.buildings, 'building')} of {counted(len(worlds), 'world')}, {len(merged.dropped)} left out"
    out.print(f"{output}: {told}", highlight=False)


def show(world: World, as_json: AsJson = False) -> None:
    """Write gallery.html into a world: a picture of each building, filtered by kind, split, difficulty and words.

    Examples:

      mansion world show out/world
    """
    from mansion_msgs_py.files import write_atomic
    from mansion_world.gallery import gallery_page
    from mansion_world.world_folder import WorldFolder

    page = world / "gallery.html"
    write_atomic(page, gallery_page(WorldFolder(world)).encode())
    if as_json:
        print_json({"page": str(page)})
    else:
        out.print(f"wrote {page}; open it in a browser", highlight=False)


def _report(buildings: int) -> None:
    if buildings % _EVERY == 0:
        err.print(f"{buildings} buildings", markup=False, highlight=False)
