"""Numbers that are told, and then set: ``The table has one fork. Make it four forks``."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Mention, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == [], read.not_understood
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    "told",
    [
        "The dining table in the kitchen has two mugs but only one plate and one fork.",
        "There is only one plate and one fork on the dining table in the kitchen.",
    ],
)
def test_so_many_are_where_they_were_told_to_be(furnished_state: SceneState, told: str) -> None:
    plates, forks = _asked(f"{told} Make it four plates and three forks.", furnished_state)
    for statement, noun, number in ((plates, "plate", 4), (forks, "fork", 3)):
        assert isinstance(statement, Ensure) and statement.things.noun == noun
        assert (statement.things.amount.kind, statement.things.amount.number) == ("exactly", number)
        assert statement.place.anchor is not None and statement.place.anchor.noun == "dining table"
        assert statement.place.rooms is not None and statement.place.rooms.words == "kitchen"


def test_those_there_are_counted(editor: SceneEditor) -> None:
    report = instruct(editor, "The dining table in the kitchen has one plate, so make it three plates.")
    assert report.done, report.message
    plates = [item for _, item in editor.state.objects() if item.category == "plate" and item.room == "F1/kitchen"]
    assert len(plates) == 3


def test_what_was_asked_for_just_before_is_asked_for_in_another_number(furnished_state: SceneState) -> None:
    (mugs,) = _asked("Put a mug on the dining table in the kitchen. Make it two mugs.", furnished_state)
    assert isinstance(mugs, Add) and mugs.things.amount.number == 2


@pytest.mark.parametrize(
    "text",
    [
        "Make it four plates.",
        "The dining table in the kitchen has one plate. Make it four forks.",
        "The dining table in the kitchen has one plate. Do not make it four plates.",
        "If the dining table in the kitchen has one plate, make it four plates.",
        "The dining tables have one plate. Make it four plates.",
        "Put a mug on every dining table. Make it two mugs.",
    ],
)
def test_where_they_shall_be_must_be_told(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood
