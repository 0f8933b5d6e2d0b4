"""Each building of a world has tasks that were done once, and its record says what they are or why there are none."""

import shutil
from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

from mansion_bringup.worlds import redo_tasks, tasks_for_world
from mansion_msgs_py.building_folder import TASKS, BuildingFolder
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.request import BuildRequest
from mansion_msgs_py.task import TaskSet, read_task_set
from mansion_world.attempts import Assignment, TaskStep, attempt_building
from mansion_world.mixture import load_mixture
from mansion_world.records import MadeTasks
from mansion_world.sampling import sample
from mansion_world.verification import verify_world
from mansion_world.world_folder import WorldFolder

Build = Callable[[BuildRequest, Path], None]


def no_faults(folder: Path) -> list[str]:
    return []


def test_every_task_is_a_row_and_its_plan_does_it(small_world: Path) -> None:
    for record in WorldFolder(small_world).records():
        row = record.building
        tasks = read_task_set(small_world / row.path / TASKS).tasks
        assert row.tasks == len(tasks) == 3 and row.no_tasks == ""
        assert [(task.id, task.kind, task.instruction) for task in tasks] == [
            (entry.id, entry.kind, entry.instruction) for entry in record.tasks
        ]
        for task, entry in zip(tasks, record.tasks, strict=True):
            assert task.building_id == row.id == entry.building
            assert (entry.steps, entry.floors) == (len(task.oracle), task.floors_spanned)
            assert entry.seconds > 0 and entry.metres >= 0 and entry.split == row.split


def test_the_first_tasks_of_many_buildings_are_of_every_kind(small_world: Path) -> None:
    kinds = {entry.kind for record in WorldFolder(small_world).records() for entry in record.tasks}
    assert kinds == {"deliver", "search", "open_and_put", "collect"}


def test_tasks_follow_from_building_and_seed(flat: Path) -> None:
    made = tasks_for_world(flat, 2, 5, 0)
    assert encode_bytes(made) == encode_bytes(tasks_for_world(flat, 2, 5, 0))
    assert encode_bytes(made) != encode_bytes(tasks_for_world(flat, 2, 6, 0))
    assert [done.success for done in made.tasks] == [True, True]


def test_a_building_with_nothing_for_a_task_says_so(tmp_path: Path, flat: Path, build: Build) -> None:
    def bare(request: BuildRequest, folder: Path) -> None:
        shutil.copytree(flat, folder)
        scene = BuildingFolder(flat).scene(1)
        fixed = [item for item in scene.objects if not item.pickupable]
        data = encode_bytes(msgspec.structs.replace(scene, objects=fixed))
        (folder / "floors/floor_1/scene.json").write_bytes(data)

    world, request = WorldFolder(tmp_path), sample(0, 7, load_mixture())
    tasks = TaskStep(2, tasks_for_world)
    record = attempt_building(Assignment(world, 7, 500.0, bare, no_faults, tasks), request).record
    assert record is not None
    assert (record.tasks, record.building.tasks) == ([], 0) and "nothing for a task" in record.building.no_tasks
    assert redo_tasks(world.work(0, 0)) == []
    kept = attempt_building(Assignment(world, 7, 500.0, build, no_faults), sample(1, 7, load_mixture())).record
    assert kept is not None and kept.building.no_tasks == "" and not (world.work(1, 0) / TASKS).exists()


def test_what_the_oracle_did_but_its_plan_does_not_is_replaced(flat: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    from mansion_bringup import worlds

    run, seen = worlds._run_plan, set[str]()

    def first_fails(task, sandbox):  # type: ignore[no-untyped-def]
        seen.add(task.id)
        return msgspec.structs.replace(run(task, sandbox), success=task.id != min(seen))

    monkeypatch.setattr(worlds, "_run_plan", first_fails)
    made: MadeTasks = tasks_for_world(flat, 2, 5, 0)
    assert len(made.tasks) == 2 and made.undone >= 1 and all(done.success for done in made.tasks)


def test_a_changed_plan_a_missing_task_and_another_row_are_found(small_world: Path, tmp_path: Path) -> None:
    world = WorldFolder(shutil.copytree(small_world, tmp_path / "world"))
    rows = list(world.buildings())
    for row, change in zip(rows, (_without_plan, _without_first), strict=False):
        file = world.path / row.path / TASKS
        file.write_bytes(encode_bytes(change(read_task_set(file))))
    faults = list(verify_world(world.path, no_faults, redo=redo_tasks))
    assert {where for where, _ in faults} == {rows[0].path, rows[1].path}, faults
    for record in list(world.records())[:2]:
        _accept_files(world, record.building.index)
    world.write_manifest()
    faults = list(verify_world(world.path, no_faults, redo=redo_tasks))
    assert any(where == rows[0].path and "its plan does not complete it" in fault for where, fault in faults)
    assert any(where == rows[1].path and "has 2 tasks" in fault for where, fault in faults)


def _without_plan(tasks: TaskSet) -> TaskSet:
    first = msgspec.structs.replace(tasks.tasks[0], oracle=[])
    return msgspec.structs.replace(tasks, tasks=[first, *tasks.tasks[1:]])


def _without_first(tasks: TaskSet) -> TaskSet:
    return msgspec.structs.replace(tasks, tasks=tasks.tasks[1:])


def _accept_files(world: WorldFolder, index: int) -> None:
    """Write the hash of a building's files as they are now into its record."""
    from mansion_world.building_measures import folder_digest

    record = world.record(index)
    assert record is not None
    row = msgspec.structs.replace(record.building, sha256=folder_digest(world.building(index))[0])
    file = world.path / "records" / "000" / f"{index:06d}.json"
    file.write_bytes(encode_bytes(msgspec.structs.replace(record, building=row)))
