"""Build a list of briefs as a world is built, and write a table of what became of each brief."""

from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path
from typing import Final

from mansion_bringup.worlds import build_for_world, check_for_world
from mansion_msgs_py.files import write_atomic
from mansion_world.brief_list import BriefList, Result, results, results_as_csv
from mansion_world.making import Workers, WorldProgress, make_world
from mansion_world.world_folder import WorldFolder

__all__ = ["TABLE", "build_list"]

TABLE: Final = "table.csv"
"""File of the table in the folder of a list."""


def build_list(
    briefs: BriefList,
    folder: Path,
    *,
    workers: Workers,
    jobs: int = 1,
    formats: Sequence[str] = (),
    report: Callable[[WorldProgress], None] = lambda progress: None,
) -> list[Result]:
    """Build the briefs of a list into a folder, or continue an interrupted run; return and write what became of each.

    Parameters
    ----------
    briefs : BriefList
    folder : Path
        A world's folder (`mansion_world.world_folder`), its buildings under their names.
    workers : callable
        Makes an executor of `jobs` workers.
    formats : sequence of str
        Export formats to write in addition to plans and pictures.

    Raises
    ------
    MansionError
        As `make_world`. A brief that cannot be built is not an error: its result says why.
    """
    make_world(
        folder,
        len(briefs),
        requests=briefs,
        build=partial(build_for_world, formats=tuple(formats)),
        check=check_for_world,
        workers=workers,
        jobs=jobs,
        report=report,
    )
    rows = results(WorldFolder(folder), briefs)
    write_atomic(folder / TABLE, results_as_csv(rows))
    return rows
