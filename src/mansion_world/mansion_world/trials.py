"""Results of agents at the tasks of a world: a row for each task that an agent tried."""

from collections.abc import Iterable, Iterator, Mapping
from itertools import islice
from pathlib import Path

from mansion_msgs_py.building_folder import TASKS
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.files import decode_from
from mansion_world.records import TaskRow, Trial
from mansion_world.world_folder import WorldFolder

__all__ = ["read_trials", "task_sets", "tried_tasks", "write_trials"]


def task_sets(world: WorldFolder, most: int = 0) -> list[Path]:
    """Return the task sets of the buildings that have tasks, by ascending index.

    Parameters
    ----------
    world : WorldFolder
    most : int
        Number of buildings, from the first on, whose tasks are returned; 0 for all.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` for a folder without a world, or a world without tasks.
    """
    world.index()
    rows = (row for row in world.buildings() if row.tasks)
    found = [world.path / row.path / TASKS for row in islice(rows, most or None)]
    if not found:
        raise MansionError(ErrorCode.NOT_FOUND, f"{world.path} has no tasks; `mansion world make --tasks N` makes some")
    return found


def write_trials(world: WorldFolder, trials: Iterable[Trial]) -> None:
    """Write ``manifest/trials.jsonl``, which replaces the trials that were there."""
    file = world.table("trials")
    file.parent.mkdir(exist_ok=True)
    fresh = file.with_name(f".{file.name}")
    with fresh.open("wb") as lines:
        lines.writelines(encode_bytes(trial) + b"\n" for trial in trials)
    fresh.rename(file)


def read_trials(world: WorldFolder) -> Iterator[Trial]:
    """Yield the trials of a world; none where no agent has tried its tasks."""
    file = world.table("trials")
    if not file.is_file():
        return
    with file.open("rb") as lines:
        for line in lines:
            yield decode_from(Trial, line, file)


def tried_tasks(world: WorldFolder, trials: Iterable[Trial]) -> Iterator[tuple[TaskRow, Trial]]:
    """Yield each trial with the row of its task; trials of tasks that are no longer there are passed over."""
    tasks: Mapping[tuple[str, str], TaskRow] = {
        (task.building, task.id): task for record in world.records() for task in record.tasks
    }
    for trial in trials:
        task = tasks.get((trial.building, trial.task))
        if task is not None:
            yield task, trial
