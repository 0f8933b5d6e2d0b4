"""Some of several are told to lack something, and are each given one: no more, and only where that is so."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Ensure, Mention
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    "text",
    [
        "Two of the chairs in the hall have no cup. Put one on each of those.",
        "Two of the chairs in the hall have no cup. Give them one.",
        "Two chairs in the hall lack a cup; put one on each of them.",
        "Two of the three chairs in the hall are without a cup, so put one on both.",
        "Two of the chairs in the hall do not have a cup yet. Please add a cup to each of these.",
    ],
)
def test_those_that_lack_it_are_given_one(furnished_state: SceneState, text: str) -> None:
    read = read_instruction(text, furnished_state)
    (asked,) = [statement for statement in read.statements if not isinstance(statement, Mention)]
    assert read.not_understood == [] and isinstance(asked, Ensure)
    assert (asked.things.noun, asked.each, asked.lacking) == ("cup", True, 2)
    assert asked.place.anchor is not None and asked.place.anchor.noun == "chair"


def _cups(editor: SceneEditor) -> int:
    return sum(item.category == "cup" for _, item in editor.state.objects())


def test_another_number_than_lacks_it_is_refused(editor: SceneEditor) -> None:
    report = instruct(editor, "Two of the chairs in the hall have no cup. Put one on each of those.")
    assert not report.done and "3 have no cup, not 2" in report.message
    assert instruct(editor, "Put a cup on chair 1 in the hall.").done
    assert instruct(editor, "Two of the chairs in the hall have no cup. Put one on each of those.").done
    assert _cups(editor) == 3


@pytest.mark.parametrize("other", ["Remove them.", "Put a plant on each of those.", "Switch them on."])
def test_what_else_is_asked_of_them_is_not_understood(furnished_state: SceneState, other: str) -> None:
    read = read_instruction(f"Two of the chairs in the hall have no cup. {other}", furnished_state)
    assert read.not_understood
