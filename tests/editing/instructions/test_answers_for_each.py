"""Questions about every room and storey are answered for each of them."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct


@pytest.mark.parametrize(
    ("question", "begins", "told"),
    [
        ("Is there a fridge on each floor?", "Not everywhere", "floor 2"),
        ("Is there a dining table on each floor?", "Yes", ""),
        ("Is there a chair in every room on floor 1?", "Not everywhere", "F1/kitchen"),
        ("Is there a piano on each floor?", "No", ""),
    ],
)
def test_all_of_them_are_looked_at(editor: SceneEditor, question: str, begins: str, told: str) -> None:
    report = instruct(editor, question)
    assert report.question and report.message.startswith(begins) and told in report.message


def test_one_is_of_the_kind_that_was_asked_for(editor: SceneEditor) -> None:
    report = instruct(editor, "How many chairs are there on floor 1, and is there one in the kitchen?")
    assert "No, there is no chair in the kitchen" in report.message


def test_a_question_may_follow_a_heading(editor: SceneEditor) -> None:
    report = instruct(editor, "Inventory check: how many chairs are there in the hall?")
    assert report.question and report.message.startswith("There are 3 chairs")
