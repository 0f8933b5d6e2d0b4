"""A thing without an article is the one that is in the room."""

import pytest

from mansion_editing.instructions.meaning.bare_nouns import with_existing_things
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Move, Remove, Statement
from mansion_editing.state import SceneState


def meant(text: str, state: SceneState) -> Statement:
    """Return the one statement of a text, as the scene makes it understood."""
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    (statement,) = with_existing_things(instruction, state, Context()).statements
    return statement


@pytest.mark.parametrize(
    "text", ["Put dining table beside the fridge in the kitchen.", "Plate next to the fridge in the kitchen please."]
)
def test_the_only_one_in_the_room_is_moved(furnished_state: SceneState, text: str) -> None:
    assert isinstance(meant(text, furnished_state), Move)


@pytest.mark.parametrize(
    "text",
    [
        "Put a dining table beside the fridge in the kitchen.",
        "Add dining table beside the fridge in the kitchen.",
        "Put sofa beside the fridge in the kitchen.",
    ],
)
def test_what_is_new_or_not_there_is_brought(furnished_state: SceneState, text: str) -> None:
    assert isinstance(meant(text, furnished_state), Add | Ensure)


def test_what_goes_into_a_room_is_the_only_one_of_the_building(furnished_state: SceneState) -> None:
    assert isinstance(meant("Fridge into the hall.", furnished_state), Move)
    assert isinstance(meant("A fridge into the hall.", furnished_state), Add | Ensure)
    assert isinstance(meant("Chair into the hall.", furnished_state), Add | Ensure)


def test_what_goes_into_something_after_a_removal_is_not_removed(furnished_state: SceneState) -> None:
    read = read_instruction("In the kitchen: chair out, plate into the fridge.", furnished_state)
    gone, there = read.statements
    assert isinstance(gone, Remove) and gone.things.noun == "chair"
    assert isinstance(there, Ensure) and there.things.noun == "plate"
