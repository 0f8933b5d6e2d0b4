"""``mansion world agents|pack|merge|show``: what finished worlds serve for: trials, shards, a joined world, a page."""

import os
from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.console import AsJson, check_output_folder, err, out, print_json
from mansion_msgs_py.wording import counted

__all__ = ["agents", "merge", "pack", "show"]

_EVERY = 100
"""Buildings between two lines of progress."""


def agents(
    world: Annotated[Path, typer.Argument(help="Folder that `mansion world make` wrote.")],
    names: Annotated[
        str, typer.Option("--agents", "-a", help="Names with commas between them.")
    ] = "random,explorer,oracle",
    buildings: Annotated[int, typer.Option("--count", "-n", min=0, help="Only the first so many buildings.")] = 0,
    seed: Annotated[int, typer.Option(min=0)] = 0,
    jobs: Annotated[int, typer.Option(min=0, help="Processes, 0: all cores; the result is the same.")] = 0,
    as_json: AsJson = False,
) -> None:
    """Let agents try the tasks of a world: logs in its folder `agents`, a row each in manifest/trials.jsonl.

    An interrupted run goes on where it ended. `mansion world stats` then shows success by difficulty.

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
    world: Annotated[Path, typer.Argument(help="Folder that `mansion world make` wrote.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="New folder for the shards.")],
    shard_size: Annotated[float, typer.Option(min=0.1, help="Greatest size of a shard, megabytes.")] = 500.0,
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
    output: Annotated[Path, typer.Option("--output", "-o", help="New folder for the world of all.")],
    parquet: Annotated[bool, typer.Option(help="Write the manifest in Parquet too (extra world).")] = True,
    as_json: AsJson = False,
) -> None:
    """Join worlds that were made apart; a line for each building that is there already and is left out.

    Examples:

      mansion world merge out/flats out/offices -o out/both
    """
    from mansion_bringup.cli.world import need_parquet, write_parquet_tables
    from mansion_world.merging import merge_worlds

    check_output_folder(output)
    if parquet:
        need_parquet()
    merged = merge_worlds(worlds, output, _report)
    if parquet:
        write_parquet_tables(output)
    if as_json:
        print_json(merged)
        return
    for line in merged.dropped:
        typer.echo(f"left out: {line}")
    told = f"{counted(merged.buildings, 'building')} of {counted(len(worlds), 'world')}, {len(merged.dropped)} left out"
    out.print(f"{output}: {told}", highlight=False)


def show(
    world: Annotated[Path, typer.Argument(help="Folder that `mansion world make` wrote.")], as_json: AsJson = False
) -> None:
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
