"""A building is made to hold what a task needs, with the fewest edits."""

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from mansion_msgs_py.task import Need, Task, TaskKind
from mansion_scene.catalogue.palette import COLOURS
from mansion_scene.editing.agent.instruct import provision
from mansion_scene.editing.editor import SceneEditor

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


def test_a_receptacle_of_the_colour_is_provided_with_what_lies_on_it(
    open_editor: EditorFactory,
) -> None:
    editor = open_editor()
    task = _task(
        Need(
            noun="cellphone",
            relation="on",
            receptacle="couch",
            receptacle_color="purple",
            floor=1,
            role="target",
        ),
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
