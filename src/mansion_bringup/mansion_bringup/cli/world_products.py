"""``mansion world pack|merge|show``: what finished worlds become: shards for training, one world of several, a page."""

from pathlib import Path
from typing import Annotated

import typer

from mansion_bringup.cli.console import check_output_folder, err, out
from mansion_msgs_py.wording import counted

__all__ = ["merge", "pack", "show"]

_EVERY = 100
"""Buildings between two lines of progress."""


def pack(
    world: Annotated[Path, typer.Argument(help="Folder that `mansion world make` wrote.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="New folder for the shards.")],
    shard_size: Annotated[float, typer.Option(min=0.1, help="Greatest size of a shard, megabytes.")] = 500.0,
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
    buildings, size = sum(shard.samples for shard in shards), sum(shard.bytes for shard in shards) / 1e6
    told = f"{counted(buildings, 'building')} in {counted(len(shards), 'shard')}, {size:.1f} MB"
    out.print(f"{output}: {told}", highlight=False)


def merge(
    worlds: Annotated[list[Path], typer.Argument(help="Folders that `mansion world make` wrote.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="New folder for the world of all.")],
    parquet: Annotated[bool, typer.Option(help="Write the manifest in Parquet too (extra world).")] = True,
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
    for line in merged.dropped:
        typer.echo(f"left out: {line}")
    told = f"{counted(merged.buildings, 'building')} of {counted(len(worlds), 'world')}, {len(merged.dropped)} left out"
    out.print(f"{output}: {told}", highlight=False)


def show(world: Annotated[Path, typer.Argument(help="Folder that `mansion world make` wrote.")]) -> None:
    """Write gallery.html into a world: a picture of each building, filtered by kind, split, difficulty and words.

    Examples:

      mansion world show out/world
    """
    from mansion_msgs_py.files import write_atomic
    from mansion_world.gallery import gallery_page
    from mansion_world.world_folder import WorldFolder

    page = world / "gallery.html"
    write_atomic(page, gallery_page(WorldFolder(world)).encode())
    out.print(f"wrote {page}; open it in a browser", highlight=False)


def _report(buildings: int) -> None:
    if buildings % _EVERY == 0:
        err.print(f"{buildings} buildings", markup=False, highlight=False)
