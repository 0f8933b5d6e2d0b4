"""``mansion edit --task``: a building that lacks what a task needs gets it, and the oracle then does the task."""

from pathlib import Path

import msgspec
import pytest

from mansion_assets.catalogue import load_catalogue
from mansion_bringup.editor import open_editor
from mansion_editing.provisioning.provision import provision
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.task import Need, Task, TaskKind, TaskSet, read_tasks
from mansion_scene.decor.frames import scene_object
from mansion_tasks.tasks.grounding import ground
from mansion_tasks.tasks.paper_tasks import PAPER_TASKS
from mansion_tasks.tasks.sandbox import Sandbox
from mansion_tasks.tasks.solving import replay
from sample_building import write_building

LAPTOP = Task(
    id="laptop",
    kind=TaskKind.DELIVER,
    instruction="Take the laptop on the desk in the office on the third floor to the kitchen on the fourth.",
    needs=[
        Need(noun="laptop", relation="on", receptacle="desk", room="office", floor=3, role="target"),
        Need(room="kitchen", floor=4, role="destination"),
    ],
)  # fmt: skip
TASKS = {
    "laptop": LAPTOP,
    **{
        name: PAPER_TASKS[name].task
        for name in ("office_cellphone", "sofa_cloth", "orange_toolbox", "apartment_basketball")
        if all(not need.room for need in PAPER_TASKS[name].task.needs)
    },
}


@pytest.fixture
def tower(tmp_path: Path) -> Path:
    """Return a building whose offices have the catalogue's desks, with nothing on them."""
    folder = write_building(tmp_path / "building", [1, 2, 3, 4])
    asset = load_catalogue().asset("office_desk_1")
    for file in folder.glob("floors/*/scene.json"):
        scene = decode(FloorScene, file.read_bytes())
        old = next(thing for thing in scene.objects if thing.category == "desk")
        x, y = old.position[:2]
        desk = scene_object(asset, old.id, old.room, (x, y, asset.size[2] / 2), old.rotation)
        rest = [t for t in scene.objects if t.id != old.id and t.parent != old.id]
        file.write_bytes(encode_bytes(msgspec.structs.replace(scene, objects=[*rest, desk])))
    return folder


@pytest.mark.parametrize("name", list(TASKS))
def test_a_task_that_could_not_be_done_is_done_by_the_oracle(tower: Path, name: str) -> None:
    task = TASKS[name]
    with pytest.raises(MansionError):
        ground(task, Sandbox(tower))
    report = provision(open_editor(tower, physics="static", who="test"), task)
    assert report.done and report.saved, report.message
    sandbox = Sandbox(tower)
    made = ground(task, sandbox)
    assert replay(made, made.oracle, sandbox).success


def test_tasks_are_read_alone_or_from_a_set(tmp_path: Path) -> None:
    alone, many = tmp_path / "task.json", tmp_path / "tasks.json"
    alone.write_bytes(encode_bytes(LAPTOP))
    tasks = list(TASKS.values())
    many.write_bytes(encode_bytes(TaskSet(building=".", building_id="b", tasks=tasks)))
    assert read_tasks(alone) == [LAPTOP]
    assert read_tasks(many) == tasks
    assert [task.id for task in read_tasks(many, "orange_toolbox")] == ["orange_toolbox"]
    for file, name in ((many, "other"), (tmp_path / "none.json", "")):
        with pytest.raises(MansionError) as error:
            read_tasks(file, name)
        assert error.value.code == "NOT_FOUND"
