"""What no statement accounts for is named, and nothing is done: half an instruction is never carried out as a whole."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    ("text", "word"),
    [
        ("put a mug on the dining table or the counter in the kitchen", "or"),
        ("There is a mug in the kitchen! Get all of it out of there.", "Get all of it"),
        ("remove the sofa from the hall if there is a second one", "second one"),
        ("put a mug on every second chair in the hall", "every second"),
    ],
)
def test_a_word_that_is_left_out_is_named(furnished_state: SceneState, text: str, word: str) -> None:
    assert any(word in part for part in read_instruction(text, furnished_state).not_understood)


def test_neither_brings_nothing(editor: SceneEditor) -> None:
    report = instruct(editor, "Neither the hall nor the kitchen should have a sofa.")
    assert report.done and not [item for _, item in editor.state.objects() if item.category == "sofa"]


def test_the_whole_building_is_not_emptied_at_once(editor: SceneEditor) -> None:
    before = len(list(editor.state.objects()))
    report = instruct(editor, "Delete everything in the building.")
    assert not report.done and "say which room" in report.message and len(list(editor.state.objects())) == before


def test_what_shall_be_closed_must_be_there(editor: SceneEditor) -> None:
    report = instruct(editor, "close the curtains in the hall")
    assert not report.done and "no curtain" in report.message


def test_a_part_is_done_only_where_that_is_asked_for(editor: SceneEditor) -> None:
    text = "remove the sofa from the hall and frobnicate the mug"
    assert not instruct(editor, text).done
    report = instruct(editor, text, partly=True)
    assert report.done and "not done: not understood: 'frobnicate the mug'" in report.message
    assert not [item for _, item in editor.state.objects() if item.category == "sofa"]


def test_a_part_that_cannot_be_done_leaves_the_rest(editor: SceneEditor) -> None:
    text = "put a piano on the plate in the kitchen and remove the sofa from the hall"
    assert not instruct(editor, text).done
    report = instruct(editor, text, partly=True)
    assert report.done and "sofa_1 removed" in report.message and "not done:" in report.message
    assert not [item for _, item in editor.state.objects() if item.category == "piano"]


def test_a_plate_for_each_chair_is_not_put_on_the_chairs(furnished_state: SceneState) -> None:
    assert read_instruction("Put a plate for each chair in the hall.", furnished_state).not_understood


def test_a_cushion_is(furnished_state: SceneState) -> None:
    assert not read_instruction("Put a cushion on each chair in the hall.", furnished_state).not_understood
