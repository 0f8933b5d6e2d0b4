"""What goes elsewhere from furniture that is cleared: the very thing that stands there, not a new one."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Clear, Mention, Move, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == []
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    "text",
    [
        "Clear the dining table in the kitchen, the plate that lies on it goes onto the desk.",
        "Take everything off the dining table in the kitchen; the plate that lies on it goes onto the desk.",
    ],
)
def test_what_lies_on_it_leaves_before_the_rest_is_cleared(furnished_state: SceneState, text: str) -> None:
    move, clear = _asked(text, furnished_state)
    assert isinstance(move, Move) and isinstance(clear, Clear)
    assert move.things.place == clear.place and not move.or_new


def test_one_relative_clause_tells_of_all_things_of_its_list(furnished_state: SceneState) -> None:
    text = "Clear the dining table in the kitchen, the plate and the mug that lie on it go onto the desk."
    plate, mug, clear = _asked(text, furnished_state)
    assert isinstance(plate, Move) and isinstance(mug, Move) and isinstance(clear, Clear)
    assert plate.things.place == mug.things.place == clear.place


def test_one_of_those_that_are_there_leaves_first_too(furnished_state: SceneState) -> None:
    move, clear = _asked("Clear the desk and put one of the mugs on the table in the kitchen.", furnished_state)
    assert isinstance(move, Move) and isinstance(clear, Clear)


def test_what_comes_onto_it_comes_after_the_clearing(furnished_state: SceneState) -> None:
    clear, move = _asked("Clear the desk, then put the mug from the kitchen on it.", furnished_state)
    assert isinstance(clear, Clear) and isinstance(move, Move)


def test_furniture_beside_it_moves_after_the_clearing(furnished_state: SceneState) -> None:
    clear, move = _asked("Clear the table in the kitchen and move the chairs to the hall.", furnished_state)
    assert isinstance(clear, Clear) and isinstance(move, Move)


def test_the_same_plate_lies_elsewhere_afterwards(editor: SceneEditor) -> None:
    text = "Clear the dining table in the kitchen, the plate that lies on it goes onto the table in the private office."
    report = instruct(editor, text)
    assert report.done, report.message
    plates = [item for _, item in editor.state.objects() if item.category == "plate"]
    assert len(plates) == 1 and plates[0].parent == "F2/private_office_1/dining_table_1"
