"""Clauses that depend on a condition are carried out only where it holds."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct


def _number(editor: SceneEditor, category: str, room: str) -> int:
    return sum(item.category == category and item.room == room for _, item in editor.state.objects())


@pytest.mark.parametrize(
    "text",
    [
        "Add a chair to the hall if there is none yet.",
        "Add a chair to the hall unless it already has one.",
        "Put a chair in the hall only if there isn't one.",
        "If there is no chair in the hall, put one there.",
        "If the hall has no chair, add one.",
    ],
)
def test_nothing_is_added_where_it_is_there(editor: SceneEditor, text: str) -> None:
    report = instruct(editor, text)
    assert report.done and not report.edits and _number(editor, "chair", "F1/hall") == 3


@pytest.mark.parametrize(
    "text",
    [
        "Add a chair to the kitchen if there is none yet.",
        "Add a chair to the kitchen unless it already has one.",
        "If there is no chair in the kitchen, put one there.",
    ],
)
def test_what_is_missing_is_added(editor: SceneEditor, text: str) -> None:
    assert instruct(editor, text).done and _number(editor, "chair", "F1/kitchen") == 1


def test_a_state_decides(editor: SceneEditor) -> None:
    closed = instruct(editor, "If the fridge is open, remove the sofa from the hall.")
    assert closed.done and not closed.edits and "not so" in closed.message
    done = instruct(editor, "If the fridge is closed, remove the sofa from the hall.")
    assert done.done and _number(editor, "sofa", "F1/hall") == 0


def test_the_answer_to_a_question_decides(editor: SceneEditor) -> None:
    assert not instruct(editor, "Is the fridge closed? If not, close it.").edits
    assert instruct(editor, "Is the fridge closed? If so, open it.").edits == 1
    fridge = editor.state.get("F1/kitchen/fridge_1")[1]
    assert fridge.states["open"]


def test_to_check_whether_is_a_question(editor: SceneEditor) -> None:
    report = instruct(editor, "Check if the fridge is open")
    assert report.question and not report.edits and report.message.startswith("No")


@pytest.mark.parametrize("answer", ["If so,", "If it is,", "If yes,", "If that is the case,"])
def test_a_question_affirmed_is_a_condition(editor: SceneEditor, answer: str) -> None:
    report = instruct(editor, f"Is the fridge closed? {answer} open it.")
    assert report.done and report.object_ids == ["F1/kitchen/fridge_1"]


@pytest.mark.parametrize("answer", ["If not,", "If it isn't,", "If no,"])
def test_a_question_denied_is_a_condition(editor: SceneEditor, answer: str) -> None:
    report = instruct(editor, f"Is the fridge closed? {answer} close it.")
    assert report.done and report.object_ids == []


def test_what_is_missing_is_brought(editor: SceneEditor) -> None:
    report = instruct(editor, "Is there a plant in the kitchen? If there is none, put one there.")
    assert report.done and len(report.object_ids) == 1 and "plant" in report.object_ids[0]


def test_what_is_there_is_not_brought_again(editor: SceneEditor) -> None:
    report = instruct(editor, "Is there a fridge in the kitchen? If not, put one there.")
    assert report.done and report.object_ids == []


@pytest.mark.parametrize("joint", [", otherwise", "; otherwise", ". Otherwise", ". If not,"])
@pytest.mark.parametrize(("asked", "opened"), [("open", True), ("closed", False)])
def test_what_is_done_otherwise_depends_too(editor: SceneEditor, joint: str, asked: str, opened: bool) -> None:
    report = instruct(
        editor, f"If the fridge is {asked}, put an apple in it{joint} put a mug on the dining table in the kitchen."
    )
    assert report.done and len(report.object_ids) == 1
    assert ("mug" if opened else "apple") in report.object_ids[0]


def test_a_condition_is_looked_at_once(editor: SceneEditor) -> None:
    report = instruct(
        editor, "Is there a plate on the dining table in the kitchen? If so, remove it, otherwise add one."
    )
    assert report.done and report.object_ids == ["F1/kitchen/plate_1"] and _number(editor, "plate", "F1/kitchen") == 0


def test_what_happens_otherwise_is_no_condition(editor: SceneEditor) -> None:
    report = instruct(editor, "Open the fridge, otherwise the mug goes bad.")
    assert report.done and report.object_ids == ["F1/kitchen/fridge_1"]
    assert not instruct(editor, "Close the fridge, otherwise remove the mug.").done


@pytest.mark.parametrize(
    "text",
    [
        "If there's still a plate in the kitchen, carry it over to the sofa in the hall; if there is none left, put a"
        " new one there.",
        "Should there still be a plate in the kitchen, bring it to the sofa in the hall. If not, put a new one there.",
        "If the plate is still on the dining table in the kitchen, put it on the sofa in the hall; if it isn't, put a"
        " new one there.",
    ],
)
@pytest.mark.parametrize("there", [True, False])
def test_a_new_one_comes_where_the_old_one_would_have_gone(editor: SceneEditor, text: str, there: bool) -> None:
    if not there:
        assert instruct(editor, "Remove the plate from the kitchen.").done
    assert instruct(editor, text).done
    assert _number(editor, "plate", "F1/hall") == 1 and _number(editor, "plate", "F1/kitchen") == 0


def test_a_second_thing_is_replaced_likewise(editor: SceneEditor) -> None:
    text = "Replace the mug on the dining table in the kitchen with a vase, and the plate in the kitchen too."
    assert instruct(editor, text).done
    assert _number(editor, "plate", "F1/kitchen") == 0 and _number(editor, "vase", "F1/kitchen") == 2
