"""One attempt at a building of a world, in a worker: built, checked and measured, or the reason why not."""

import errno
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Final

import msgspec

from mansion_msgs_py.building_folder import TASKS, BuildingFolder, is_building_folder
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import write_atomic
from mansion_msgs_py.request import BuildRequest, building_id_of
from mansion_msgs_py.task import TaskSet
from mansion_world.building_measures import measure_building
from mansion_world.records import MadeTasks, Record, SetAside
from mansion_world.sampling import WorldRequest
from mansion_world.world_folder import WorldFolder

__all__ = [
    "NO_TASKS",
    "Assignment",
    "Build",
    "Check",
    "Outcome",
    "TaskStep",
    "WorkersGone",
    "WorkerLost",
    "attempt_building",
]

Build = Callable[[BuildRequest, Path], object]
"""Builds a request into a folder, which appears whole or not at all; raises `MansionError`."""

Check = Callable[[Path], Sequence[object]]
"""Returns the faults of a building folder."""


def _none(folder: Path, count: int, seed: int, first: int) -> MadeTasks:
    return MadeTasks()


@dataclass(frozen=True)
class TaskStep:
    """What makes the tasks of a finished building.

    Attributes
    ----------
    count : int
        Tasks for each building.
    make : callable
        Gets the building's folder, the number of tasks, the building's seed, and how many tasks the buildings before
        it have together, as if all had theirs; the same arguments give the same tasks.
    """

    count: int = 0
    make: Callable[[Path, int, int, int], MadeTasks] = _none


NO_TASKS: Final = TaskStep()

_NO_SPACE: Final = (errno.ENOSPC, errno.EDQUOT)

_NOT_OF_THE_REQUEST: Final = (ErrorCode.CONFLICT, ErrorCode.UNAVAILABLE)
"""Errors of the place that is written to: another request would meet them too."""


class WorkerLost(Exception):
    """A worker ended during an attempt; the other workers go on."""


class WorkersGone(Exception):
    """Nobody can be asked to build any more; the message says why."""


class Outcome(msgspec.Struct, frozen=True, kw_only=True):
    """What became of an attempt: its record, or why it was set aside, or why nothing can be written."""

    record: Record | None = None
    aside: SetAside | None = None
    full: str = ""


@dataclass(frozen=True)
class Assignment:
    """What a worker needs for an attempt: the world and its seed, the largest floor allowed, and what it calls."""

    world: WorldFolder
    seed: int
    floor_area: float
    build: Build
    check: Check
    tasks: TaskStep = NO_TASKS


def attempt_building(assignment: Assignment, request: WorldRequest) -> Outcome:
    """Build, check and measure one request of a world and make its tasks, in the folder for work."""
    try:
        return _attempt(assignment, request)
    except (OSError, MansionError) as error:
        if full := _no_space(error):
            return Outcome(full=full)
        if isinstance(error, OSError) or error.code in _NOT_OF_THE_REQUEST:
            raise
        return Outcome(aside=SetAside(request=request, reason="refused", details=[str(error)]))


def _attempt(assignment: Assignment, request: WorldRequest) -> Outcome:
    folder = assignment.world.work(request.index, request.attempt)
    if not _is_built(folder, request):
        folder.parent.mkdir(parents=True, exist_ok=True)
        assignment.build(request.request, folder)
    if faults := assignment.check(folder):
        return Outcome(aside=SetAside(request=request, reason="faults", details=[str(fault) for fault in faults]))
    areas = [entry.area for entry in BuildingFolder(folder).building.floors]
    if max(areas) > assignment.floor_area:
        details = [f"a floor of {max(areas):.1f} m2; at most {assignment.floor_area:.0f} m2"]
        return Outcome(aside=SetAside(request=request, reason="floor too large", details=details))
    record = measure_building(assignment.seed, request, folder, _made_tasks(request, folder, assignment.tasks))
    assignment.world.save_built(record)
    return Outcome(record=record)


def _is_built(folder: Path, request: WorldRequest) -> bool:
    """Whether an interrupted run left the building of this very request."""
    return is_building_folder(folder) and BuildingFolder(folder).building.building_id == building_id_of(request.request)


def _made_tasks(request: WorldRequest, folder: Path, tasks: TaskStep) -> MadeTasks:
    """Make the tasks of a building and write them into its folder."""
    if not tasks.count:
        return MadeTasks()
    made = tasks.make(folder, tasks.count, request.request.seed, request.index * tasks.count)
    found = TaskSet(
        building=".", building_id=request.request.building_id or "", tasks=[done.task for done in made.tasks]
    )
    write_atomic(folder / TASKS, encode_bytes(found, indent=1))
    return made


def _no_space(error: BaseException | None) -> str:
    while error is not None:
        if isinstance(error, OSError) and error.errno in _NO_SPACE:
            return error.strerror or "no space left"
        error = error.__cause__ or error.__context__
    return ""
