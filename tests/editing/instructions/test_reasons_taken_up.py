"""A reason that names things, and a request that goes on with them by a pronoun."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Mention, Remove, Rooms, Statement, Turn
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == [], read.not_understood
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    "text",
    [
        "My mother keeps tripping over the plate in the kitchen, remove it.",
        "Sold the plate in the kitchen, take it away.",
        "Gave the plate in the kitchen away, so remove it.",
        "The plate in the kitchen is in the way. Remove it.",
    ],
)
def test_the_thing_of_a_reason_is_what_it_means(furnished_state: SceneState, text: str) -> None:
    (gone,) = _asked(text, furnished_state)
    assert isinstance(gone, Remove) and gone.things.noun == "plate" and not gone.things.plural
    assert gone.things.place is not None and gone.things.place.rooms == Rooms(words="kitchen")


@pytest.mark.parametrize(
    "text",
    [
        "Sold the plate and the fridge, take them out of the kitchen.",
        "We sold the plate and the fridge. Please remove both of them.",
        "The plate and the fridge are broken. Remove them.",
        "The dog chewed the plate and the fridge, throw them out.",
    ],
)
def test_them_is_the_whole_list(furnished_state: SceneState, text: str) -> None:
    assert [s.things.noun for s in _asked(text, furnished_state) if isinstance(s, Remove)] == ["plate", "fridge"]


def test_one_thing_of_a_list_is_not_guessed(furnished_state: SceneState) -> None:
    assert read_instruction("Sold the plate and the fridge, take it away.", furnished_state).not_understood


def test_a_reason_does_not_make_one_thing_all_of_its_kind(editor: SceneEditor) -> None:
    report = instruct(editor, "My mother keeps tripping over the chair, remove it.")
    assert not report.done and "say which" in report.message


@pytest.mark.parametrize(
    "text",
    [
        "Turn the dining table in the kitchen by 180 degrees, the head end is on the wrong side.",
        "Turn the dining table in the kitchen by 180 degrees, it is the wrong way round.",
        "The dining table in the kitchen faces the wrong way, turn it by 180 degrees.",
    ],
)
def test_what_stands_wrong_is_why_it_shall_be_turned(furnished_state: SceneState, text: str) -> None:
    read = read_instruction(text, furnished_state)
    (turn,) = [statement for statement in read.statements if not isinstance(statement, Mention)]
    assert read.not_understood == []
    assert isinstance(turn, Turn) and turn.degrees == 180.0 and turn.things.noun == "dining table"


@pytest.mark.parametrize(
    "text",
    [
        "Turn the dining table in the kitchen by 180 degrees, the fridge is on the wrong side.",
        "The dining table in the kitchen is not the wrong way round, turn it by 180 degrees.",
        "If the dining table in the kitchen is the wrong way round, turn it by 180 degrees.",
        "The dining table in the kitchen is on the wrong side. Put a mug on the fridge.",
    ],
)
def test_other_complaints_of_sides_are_not_passed_over(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood


@pytest.mark.parametrize("room", ["kitchen (ground floor)", "kitchen on the ground floor"])
def test_a_list_comes_out_of_what_was_told_of(furnished_state: SceneState, room: str) -> None:
    read = read_instruction(
        f"The fridge in the {room} is not a bar. Remove the wine and the beer from it.", furnished_state
    )
    assert read.not_understood == []
    gone = [statement.things for statement in read.statements if isinstance(statement, Remove)]
    assert [things.noun for things in gone] == ["wine", "beer"]
    for things in gone:
        assert things.place is not None and things.place.anchor is not None and things.place.anchor.noun == "fridge"
