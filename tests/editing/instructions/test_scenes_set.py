"""Clauses that tell what is there or missing, and a pronoun or a number in the next one."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Mention, Move, Remove, SetState, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [statement for statement in instruction.statements if not isinstance(statement, Mention)]


def _chairs(editor: SceneEditor) -> list[str]:
    return sorted(item.id for _, item in editor.state.objects() if item.id.startswith("F1/hall/chair"))


@pytest.mark.parametrize(
    "told",
    [
        "On the dining table in the kitchen is a plate.",
        "On the dining table in the kitchen lies one plate.",
        "In the kitchen there is a plate.",
    ],
)
def test_it_is_what_was_told_to_be_there(furnished_state: SceneState, told: str) -> None:
    (statement,) = _asked(f"{told} Take it to the hall.", furnished_state)
    assert isinstance(statement, Move) and statement.things.noun == "plate" and statement.things.definite
    assert statement.things.place is not None and statement.things.place.rooms is not None


@pytest.mark.parametrize("told", ["On the second dining table stand two mugs", "In the hall stand three chairs"])
def test_an_order_to_stand_something_up_is_no_description(furnished_state: SceneState, told: str) -> None:
    assert any(isinstance(s, Add) for s in read_instruction(f"{told}. Open the fridge.", furnished_state).statements)


def test_what_shall_be_the_case_is_brought_about(furnished_state: SceneState) -> None:
    (statement,) = _asked("On the dining table in the kitchen is a mug.", furnished_state)
    assert isinstance(statement, Ensure) and statement.things.noun == "mug"


@pytest.mark.parametrize("told", ["", ", that is too many", ", it's too much"])
@pytest.mark.parametrize("asked", ["Remove all but one.", "Remove all but one of them."])
def test_all_but_one_of_what_was_told_go(editor: SceneEditor, told: str, asked: str) -> None:
    assert len(_chairs(editor)) == 3
    assert instruct(editor, f"In the hall there are three chairs{told}. {asked}").done
    assert len(_chairs(editor)) == 1


def test_a_wrong_number_is_not_passed_over(editor: SceneEditor) -> None:
    report = instruct(editor, "In the hall there are four chairs. Remove all but one.")
    assert not report.done and len(_chairs(editor)) == 3


@pytest.mark.parametrize(
    "told", ["The hall is the only room without a plant.", "The hall is the only one that has no plant,"]
)
def test_what_one_room_alone_lacks_is_added_there(furnished_state: SceneState, told: str) -> None:
    (statement,) = _asked(f"{told} add one.", furnished_state)
    assert isinstance(statement, Add) and statement.things.noun == "plant"
    assert statement.place.rooms is not None and statement.place.rooms.words == "hall"


def test_what_is_missing_is_added_once(furnished_state: SceneState) -> None:
    (statement,) = _asked("The kitchen is missing a mug on the dining table, add it.", furnished_state)
    assert isinstance(statement, Add | Ensure) and statement.things.noun == "mug"


def test_what_is_put_somewhere_may_be_open_there(furnished_state: SceneState) -> None:
    put, opened = _asked("Put a laptop on the dining table in the kitchen with the lid open.", furnished_state)
    assert isinstance(put, Add) and isinstance(opened, SetState)
    assert (opened.state, opened.value, opened.things.refers) == ("open", True, "last")


def test_what_goes_is_not_opened(furnished_state: SceneState) -> None:
    assert read_instruction("Remove the fridge with the door open.", furnished_state).not_understood


def test_the_thing_of_a_complaint_goes(furnished_state: SceneState) -> None:
    (statement,) = _asked(
        "My mother keeps stumbling over the plate in the kitchen so please remove it.", furnished_state
    )
    assert isinstance(statement, Remove) and statement.things.noun == "plate"
