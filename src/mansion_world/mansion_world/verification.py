"""A whole world verified from its files."""

from collections.abc import Callable, Iterator, Sequence
from importlib.util import find_spec
from pathlib import Path
from typing import Final, TypeAlias

from msgspec.structs import replace

from mansion_msgs_py.building_folder import TASKS
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.wording import counted
from mansion_world.attempts import Check
from mansion_world.building_measures import folder_digest, task_row
from mansion_world.records import BuildingRow, DoneTask, Record, TaskRow
from mansion_world.world_folder import TABLES, WorldFolder, table_rows

__all__ = ["RedoTasks", "verify_world"]

RedoTasks: TypeAlias = Callable[[Path], Sequence[DoneTask]]
"""Runs the plan of each task in a building's folder."""

_SLACK: Final = 0.05
"""Metres and seconds by which a plan that is run on another machine may differ."""


def verify_world(
    folder: Path, check: Check, report: Callable[[int], None] = lambda buildings: None, *, redo: RedoTasks | None = None
) -> Iterator[tuple[str, str]]:
    """Yield every fault of a world, as the file or building and what is wrong with it.

    Verified are the manifest against the records, the files of each building against its hash, each building by
    `check`, and its tasks by running their plans.

    Parameters
    ----------
    redo : callable, optional
        Runs the plans; tasks are not run when absent.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when `folder` holds no world.
    """
    world = WorldFolder(folder)
    world.index()
    yield from _manifest_faults(world)
    for count, record in enumerate(world.records(), start=1):
        row = record.building
        building = folder / row.path
        if not building.is_dir():
            yield row.path, "is missing"
        elif folder_digest(building)[0] != row.sha256:
            yield row.path, "has changed since it was written: its files have another hash"
        else:
            yield from ((row.path, str(fault)) for fault in check(building))
            if redo is not None:
                yield from ((row.path, fault) for fault in _task_faults(record, building, redo))
        report(count)


def _task_faults(record: Record, building: Path, redo: RedoTasks) -> Iterator[str]:
    row = record.building
    done = redo(building) if (building / TASKS).is_file() else []
    if len(done) != len(record.tasks) or len(done) != row.tasks:
        yield f"has {counted(len(done), 'task')} in {TASKS}; its record says {row.tasks} and lists {len(record.tasks)}"
    for found, wanted in zip(done, record.tasks):
        if not found.success:
            yield f"task {found.task.id}: its plan does not complete it"
        elif not _agrees(found, wanted, row):
            yield f"task {found.task.id}: differs from its row"


def _agrees(found: DoneTask, wanted: TaskRow, row: BuildingRow) -> bool:
    again = task_row(row, found)
    near = abs(again.metres - wanted.metres) <= _SLACK and abs(again.seconds - wanted.seconds) <= 2 * _SLACK
    return near and encode_bytes(_untimed(again)) == encode_bytes(_untimed(wanted))


def _untimed(row: TaskRow) -> TaskRow:
    return replace(row, metres=0.0, seconds=0.0)


def _manifest_faults(world: WorldFolder) -> Iterator[tuple[str, str]]:
    sound = True
    for name in TABLES:
        rows = (encode_bytes(row) for record in world.records() for row in table_rows(record)[name])
        for fault in _differences(world.table(name), rows):
            sound = False
            yield fault
    if sound and any(world.path.glob("manifest/*.parquet")):
        yield from _parquet_faults(world)


def _parquet_faults(world: WorldFolder) -> Iterator[tuple[str, str]]:
    if find_spec("pyarrow") is None:
        yield "manifest", "its Parquet tables cannot be read without the extra 'world'"
        return
    with importing:
        from mansion_world.parquet import parquet_differences

    yield from parquet_differences(world)


def _differences(file: Path, rows: Iterator[bytes]) -> Iterator[tuple[str, str]]:
    """Yield one fault where a table is missing or is not that of the records."""
    name = f"manifest/{file.name}"
    if not file.is_file():
        yield name, "is missing; `mansion world make` writes it"
        return
    with file.open("rb") as lines:
        for number, row in enumerate(rows, start=1):
            if lines.readline() != row + b"\n":
                yield name, f"line {number} differs from the records"
                return
        if lines.readline():
            yield name, "has more rows than there are records"
