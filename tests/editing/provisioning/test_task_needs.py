"""A building is made to hold what a task needs, with the fewest edits."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import msgspec
import pytest

from mansion_assets.catalogue.palette import COLOURS
from mansion_editing.editor import SceneEditor
from mansion_editing.provisioning.provision import provision
from mansion_msgs_py.task import Need, Task, TaskKind

EditorFactory = Callable[..., SceneEditor]


def _task(*needs: Need, **more: Any) -> Task:
    return Task(id="t1", kind=TaskKind.DELIVER, instruction="bring it", needs=list(needs), **more)


def test_needs_that_hold_take_no_edit(open_editor: EditorFactory) -> None:
    editor = open_editor()
    task = _task(
        Need(noun="mug", relation="on", receptacle="table", room="kitchen", floor=1, role="target"),
        Need(noun="desk", floor=2, role="destination"),
    )
    report = provision(editor, task)
    assert report.done and report.edits == 0 and editor.store.log() == []


def test_a_receptacle_of_the_colour_is_provided_with_what_lies_on_it(open_editor: EditorFactory) -> None:
    editor = open_editor()
    task = _task(
        Need(noun="cellphone", relation="on", receptacle="couch", receptacle_color="purple", floor=1, role="target"),
        Need(noun="round table", floor=2, role="destination"),
    )
    report = provision(editor, task)
    assert report.done and report.edits == 3, report.message
    phone = next(i for _, i in editor.state.objects() if i.category == "cell_phone")
    _, couch = editor.state.get(phone.parent or "")
    assert couch.category == "sofa" and couch.material.endswith("_purple")
    assert couch.color == COLOURS["purple"]
    assert "F2/" in next(i.id for _, i in editor.state.objects() if i.category == "round_table")
    assert provision(editor, task).edits == 0
    assert [t.what for t in editor.store.log()] == ["task t1: bring it"]


def test_a_colour_that_no_asset_has_is_painted(open_editor: EditorFactory) -> None:
    editor = open_editor()
    report = provision(editor, _task(Need(noun="toolbox", color="orange", floor=2)))
    assert report.done and report.edits == 1
    box = next(i for _, i in editor.state.objects() if i.category == "toolbox")
    assert (box.color, box.material.split("_")[-1]) == (COLOURS["orange"], "orange")


@pytest.mark.parametrize("need", [Need(noun="kitchen"), Need(noun="", room="kitchen", floor=1)])
def test_a_needed_room_is_a_way_to_it(open_editor: EditorFactory, need: Need) -> None:
    report = provision(open_editor(), _task(need))
    assert report.done and report.edits == 0 and "F1/kitchen" in report.facts[0]


@pytest.mark.parametrize(
    "task",
    [
        _task(),
        _task(Need(noun="swimming pool of lava")),
        _task(Need(noun="mug", floor=9)),
        _task(Need(noun="mug", color="invisible")),
        _task(Need(noun="", role="destination")),
        _task(Need(noun="mug", room="ballroom")),
        _task(Need(noun="mug"), building_id="another"),
    ],
)
def test_what_cannot_be_provided_is_refused_with_the_reason(
    open_editor: EditorFactory, folder: Path, task: Task
) -> None:
    editor = open_editor()
    before = (folder / "floors/floor_1/scene.json").read_bytes()
    report = provision(editor, task)
    assert not report.done and report.failed and report.edits == 0
    assert (folder / "floors/floor_1/scene.json").read_bytes() == before


def _placed(editor: SceneEditor, category: str) -> list[str]:
    return [i.room for _, i in editor.state.objects() if i.category == category]


def test_furniture_comes_where_it_belongs_and_not_into_a_corridor(open_editor: EditorFactory) -> None:
    editor = open_editor()
    for noun, category, room in (("bookshelf", "bookshelf", "F2/private_office_1"), ("fridge", "fridge", "F1/kitchen")):
        had = _placed(editor, category)
        assert provision(editor, _task(Need(noun=noun, color="red"))).done
        new = _placed(editor, category)
        assert [r for r in new if new.count(r) > had.count(r)] == [room] * new.count(room)
    report = provision(editor, _task(Need(noun="sofa", color="red", floor=2)))
    assert report.done and "F2/corridor" not in _placed(editor, "sofa")


def test_furniture_comes_into_the_room_that_a_task_names(open_editor: EditorFactory) -> None:
    editor = open_editor()
    report = provision(editor, _task(Need(noun="stool", color="green", room="kitchen", floor=1)))
    assert report.done and _placed(editor, "stool")[-1] == "F1/kitchen"


def test_furniture_that_would_cut_a_room_is_placed_elsewhere(open_editor: EditorFactory) -> None:
    editor = open_editor(autosave=False)
    _, sofa = editor.state.get("F1/hall/sofa_1")
    for number, (x, width) in enumerate(((0.36, 0.6), (3.75, 4.38))):
        wall = msgspec.structs.replace(
            sofa,
            id=f"F1/hall/partition_{number + 1}",
            category="partition",
            position=(x, 3.3, 0.5),
            size=(width, 0.3, 1.0),
            rotation=0.0,
        )
        editor.state.add(1, wall)
    assert not editor.call("CheckPath", {}).cut_rooms
    near = {"asset_id": "pouf_1", "receptacle_id": "F1/hall", "near": "F1/hall/partition_1"}
    for _ in range(6):
        editor.call("PlaceOnSurface", near)
        assert not editor.call("CheckPath", {}).cut_rooms
