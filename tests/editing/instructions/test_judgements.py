"""Clauses that judge how something is beside a request, and what the request is then about."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Clear, Mention, Remove, Reshape, Rooms, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == [], read.not_understood
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    "told",
    [
        "The kitchen is way too cramped.",
        "The kitchen feels cramped.",
        "It's too dark in the kitchen to read.",
        "I can't find anything in the kitchen.",
        "There's a puddle in the kitchen.",
    ],
)
def test_the_request_is_about_the_room_that_is_judged(furnished_state: SceneState, told: str) -> None:
    read = read_instruction(f"{told} Remove the plates.", furnished_state)
    assert read.not_understood == []
    told_of, gone = read.statements
    assert isinstance(told_of, Mention) and told_of.rooms == Rooms(words="kitchen") and isinstance(gone, Remove)


@pytest.mark.parametrize(
    "text",
    [
        "The plate in the kitchen has seen better days. Out with it.",
        "The plate in the kitchen is an eyesore and has to go.",
        "The plate in the kitchen begins to smell, get rid of it.",
    ],
)
def test_what_is_judged_goes(furnished_state: SceneState, text: str) -> None:
    (gone,) = _asked(text, furnished_state)
    assert isinstance(gone, Remove) and gone.things.noun == "plate" and gone.things.place is not None


def test_a_room_that_is_too_small_is_enlarged(furnished_state: SceneState) -> None:
    (larger,) = _asked("The kitchen is too small. Enlarge it by 3 square metres.", furnished_state)
    assert isinstance(larger, Reshape) and larger.area == 3.0


@pytest.mark.parametrize("told", ["The kitchen is bare.", "The dining table is empty."])
def test_what_is_told_to_be_empty_is_not_emptied(furnished_state: SceneState, told: str) -> None:
    (new,) = _asked(f"{told} Put a plant in the kitchen.", furnished_state)
    assert isinstance(new, Add)


def test_to_empty_what_holds_things_does_not_remove_it(furnished_state: SceneState) -> None:
    (emptied,) = _asked("The bin smells. Empty it.", furnished_state)
    assert isinstance(emptied, Clear)


def test_counted_things_are_taken_from_the_room_that_was_mentioned(editor: SceneEditor) -> None:
    report = instruct(editor, "The hall is full. Remove two chairs.")
    assert report.done, report.message
    assert sum(item.category == "chair" and item.room == "F1/hall" for _, item in editor.state.objects()) == 1


def test_how_a_room_shall_feel_is_a_wish_that_is_not_passed_over(furnished_state: SceneState) -> None:
    read = read_instruction("Remove the plates and make the kitchen feel cosier", furnished_state)
    assert read.not_understood == ["make the kitchen feel cosier"]
