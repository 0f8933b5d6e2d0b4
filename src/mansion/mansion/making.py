"""Buildings made from a sentence, or read from a folder."""

import os
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Literal

from mansion.briefs import GivenPlan, Outline, request_of
from mansion.building import Building
from mansion.homes import Home
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.world import Progress

__all__ = ["build", "load"]

_MOST_JOBS = 8


def build(
    description: str | BuildRequest = "",
    folder: str | Path | None = None,
    *,
    floors: int | None = None,
    area: float | None = None,
    floor_area: float | None = None,
    footprint: Outline | None = None,
    plan: GivenPlan | None = None,
    complete: Sequence[Literal["doors", "windows"]] = (),
    seed: int = 0,
    planner: Literal["rules", "llm"] = "rules",
    assets: str | Sequence[str] = (),
    formats: str | Sequence[str] = (),
    jobs: int = 1,
    force: bool = False,
    progress: bool | Callable[[Progress], None] = False,
) -> Building:
    """Build a furnished building from one sentence.

    Parameters
    ----------
    description : str or BuildRequest
        The brief: English, or any language with the planner ``llm``. A request brings its own options.
    folder : path, optional
        Where it is kept; appears whole or not at all, and an interrupted build continues where it stopped. By default
        a temporary one, which lives as long as the building.
    floors : int, optional
        Number of floors; read from the description when absent.
    area, floor_area : float, optional
        Gross area of the building, or of one floor; square metres.
    footprint : Footprint, sequence of (x, y), or path, optional
        Outline of every floor.
    plan : BuildingPlan, mapping, or path, optional
        A plan to furnish as it is; the description, which may then be empty, says what it is and what is wished beside.
    complete : sequence of {"doors", "windows"}
        What may be added where the plan lacks it.
    seed : int
        Same seed, same building.
    planner : {"rules", "llm"}
    assets : str or sequence of str
        Libraries of own assets that come before the catalogue's, by name, or by a path with a slash in it.
    formats : str or sequence of str
        Formats to write beside plans and pictures, ``["glb", "nav2"]`` or ``"glb,nav2"``, as `Building.export` names
        them; ``"all"`` for maps, AI2-THOR houses, MuJoCo models and the binary glTF.
    jobs : int
        Floors made at once, in forked processes where there are several; 0: one for each core. The result does not
        depend on it.
    force : bool
        Replace a building even if robots have left state in it.
    progress : bool or callable
        Show how far it is on standard error, or call something with each `Progress`.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for options that do not fit, ``NOT_FOUND`` for a format or a library that does not exist,
        ``CONTRADICTION`` or ``INFEASIBLE`` for a brief that nothing meets, ``CONFLICT`` for a folder that holds
        something else.

    Examples
    --------
    >>> b = mansion.build("a small flat for two", seed=4)
    >>> "kitchen" in {room.type for room in b.rooms}
    True
    """
    with importing:
        from mansion_bringup.exporting import format_names
        from mansion_bringup.pipeline.build import build_building
        from mansion_bringup.pipeline.planning import prepare_planner

    request = request_of(
        description, footprint, plan=plan, complete=complete, floors=floors, area=area, floor_area=floor_area,
        seed=seed, planner=planner, assets=assets,
    )  # fmt: skip
    prepare_planner(request)
    home = Home.new() if folder is None else Home(Path(folder))
    workers = jobs or min(os.cpu_count() or 1, _MOST_JOBS)
    with _reporting(progress) as report:
        build_building(request, home.folder, jobs=workers, report=report, formats=format_names(formats), force=force)
    return Building(home)


@contextmanager
def _reporting(progress: bool | Callable[[Progress], None]) -> Iterator[Callable[[Progress], None]]:
    if progress is True:
        with importing:
            from mansion_bringup.cli.console import progress_bar

        with progress_bar() as report:
            yield report
    else:
        yield progress or (lambda payload: None)


def load(folder: str | Path) -> Building:
    """Return the building in a folder that `build` or ``mansion build`` wrote.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when it holds no building.

    Examples
    --------
    >>> mansion.load(b.folder).id == b.id
    True
    """
    return Building(Home(Path(folder)))
