"""``mansion build --from``: the briefs of a file, one building each."""

import os
from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import typer
from rich.table import Table
from rich.text import Text

from mansion_bringup.cli.console import EXIT_INTERRUPTED, buildings_reporter, check_output_folder, err, out
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.wording import counted

if TYPE_CHECKING:
    from mansion_world.brief_list import BriefList, Result

__all__ = ["build_briefs"]


def build_briefs(source: Path, output: Path, defaults: BuildRequest, jobs: int, formats: Sequence[str]) -> None:
    """Build all briefs of a file; exit status 1 where one of them failed.

    Parameters
    ----------
    source : Path
        See `mansion_world.brief_files.read_briefs`.
    defaults : BuildRequest
        What holds where a row says nothing.
    jobs : int
        Buildings that are built at once; 0: all cores.
    """
    from mansion_bringup.build_list import TABLE, build_list
    from mansion_bringup.plan_files import plan_from_file
    from mansion_bringup.worlds import world_workers
    from mansion_world.brief_files import read_briefs
    from mansion_world.brief_list import BriefList

    briefs = BriefList.of(read_briefs(source, defaults, plan_from_file))
    _prepare_planners(briefs)
    check_output_folder(output)
    workers = min(jobs or os.cpu_count() or 1, len(briefs))
    try:
        rows = build_list(
            briefs, output, workers=world_workers(workers), jobs=workers, formats=formats, report=buildings_reporter()
        )
    except KeyboardInterrupt:
        err.print("interrupted; run the same command again to continue with the remaining buildings")
        raise typer.Exit(EXIT_INTERRUPTED) from None
    out.print(_table(rows))
    failed = sum(1 for row in rows if row.reason)
    end = f", {failed} of {len(rows)} briefs failed" if failed else ""
    out.print(f"{output}: {counted(len(rows) - failed, 'building')}{end}; {output / TABLE}", highlight=False)
    if failed:
        raise typer.Exit(1)


def _prepare_planners(briefs: "BriefList") -> None:
    from mansion_bringup.pipeline.planning import prepare_planner

    for planner in {entry.request.planner: entry.request for entry in briefs.entries}.values():
        prepare_planner(planner)


def _table(rows: Sequence["Result"]) -> Table:
    table = Table(show_edge=False, pad_edge=False)
    table.add_column("name", overflow="fold")
    for title in ("floors", "rooms", "objects", "wishes met"):
        table.add_column(title, justify="right")
    table.add_column("reason", overflow="fold")
    for row in rows:
        met = f"{row.wishes_met} of {row.wishes}"
        numbers = [""] * 4 if row.reason else [str(row.floors), str(row.rooms), str(row.objects), met]
        table.add_row(Text(row.name), *numbers, Text(row.reason))
    return table
