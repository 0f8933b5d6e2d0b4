"""Instructions are read into statements; words that belong to none are named."""

import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Mention, Remove, SetState, Swap
from mansion_editing.state import SceneState


def _kinds(state: SceneState, text: str) -> list[str]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [type(statement).__name__ for statement in instruction.statements]


@pytest.mark.parametrize(
    ("text", "kinds"),
    [
        ("Add three chairs to the kitchen.", ["Add"]),
        ("There should be three chairs in the kitchen", ["Ensure"]),
        ("make sure there is a mug on the dining table and a way to the kitchen", ["Ensure", "Reach"]),
        ("Make sure there are no chairs in the kitchen", ["Remove"]),
        ("Don't put a chair in the kitchen", ["Forbid"]),
        ("leave the dining table as it is and remove the chairs around it", ["Keep", "Remove"]),
        ("take the mug from the dining table and put it into the fridge", ["Mention", "Move"]),
        ("take the mug and the plate off the dining table and set them on the counter", ["Move", "Move"]),
        ("turn on the lamp in the kitchen, all the other lights as they are", ["SetState", "Keep"]),
        ("a mug on the dining table and one more plant in the kitchen", ["Ensure", "Add"]),
        ("Put a plant in the kitchen. Put a chair in the hall.", ["Add", "Add"]),
        ("We want some cutlery on the dining table. Put two forks there", ["Mention", "Add"]),
        ("Swap the mug and the plate", ["Swap"]),
        ("replace the chair by two stools", ["Replace"]),
        ("turn the lamp off and open the fridge", ["SetState", "SetState"]),
        ("paint the chair red", ["Paint"]),
        ("rotate the sofa by 90 degrees", ["Turn"]),
        ("Rename the kitchen to Den", ["Rename"]),
        ("make the walls of the kitchen light blue", ["Finish"]),
        ("turn the kitchen into an office", ["Furnish"]),
        ("make the kitchen 5 m2 larger", ["Reshape"]),
        ("Clear the dining table except for the plate", ["Clear"]),
        ("how many chairs are in the kitchen?", ["Ask"]),
        ("is the fridge closed?", ["Ask"]),
        ("one more, please", ["History"]),
        ("put it back", ["History"]),
        (
            "The plates are dirty. We have guests tonight, so put two mugs on the dining table",
            ["Mention", "Mention", "Add"],
        ),
    ],
)
def test_each_clause_is_one_statement(state: SceneState, text: str, kinds: list[str]) -> None:
    assert _kinds(state, text) == kinds


@pytest.mark.parametrize(
    ("words", "kind", "number", "whole"),
    [
        ("two of the four chairs", "some", 2, 4),
        ("all but one of the chairs", "all_but", 1, 0),
        ("one of the chairs", "some", 1, 0),
        ("every chair", "all", 0, 0),
        ("the chairs", "all", 0, 0),
        ("both chairs", "all", 2, 2),
    ],
)
def test_how_many_go_is_read(state: SceneState, words: str, kind: str, number: int, whole: int) -> None:
    (statement,) = read_instruction(f"remove {words} from the kitchen", state).statements
    assert isinstance(statement, Remove)
    amount = statement.things.amount
    assert (amount.kind, amount.number, amount.of) == (kind, number, whole)


def test_no_more_makes_a_number_exact(state: SceneState) -> None:
    (statement,) = read_instruction("two forks on the dining table, no more", state).statements
    assert isinstance(statement, Ensure) and statement.things.amount.kind == "exactly"


def test_where_a_thing_is_may_be_told_in_another_sentence(state: SceneState) -> None:
    for text in (
        "Put a mug on the desk. The desk is in the kitchen.",
        "The desk is in the kitchen. Put a mug on the desk.",
    ):
        asked = [s for s in read_instruction(text, state).statements if not isinstance(s, Mention)]
        (statement,) = asked
        assert isinstance(statement, Add) and statement.place.rooms is not None
        assert statement.place.rooms.words == "kitchen"


def test_the_same_is_done_with_what_is_joined(state: SceneState) -> None:
    first, second = read_instruction("In the kitchen, turn the lamp on and the oven too", state).statements
    assert isinstance(first, SetState) and isinstance(second, SetState)
    assert (second.things.noun, second.value) == ("oven", True)


@pytest.mark.parametrize(
    ("text", "words"),
    [
        ("Remove every third chair from the kitchen", "every third chair"),
        ("Put a mug on the dining table if it rains", "if it rains"),
        ("frobnicate the kitchen", "frobnicate"),
        ("put a mug on the dining table and blorf the fridge", "blorf"),
    ],
)
def test_words_that_belong_to_no_statement_are_named(state: SceneState, text: str, words: str) -> None:
    assert any(words in part for part in read_instruction(text, state).not_understood)


@pytest.mark.parametrize(
    "text",
    [
        "Let the fridge and the dining table change places.",
        "The fridge and the dining table should swap places.",
        "The kitchen and the hall trade places, please.",
    ],
)
def test_subjects_that_change_places_are_swapped(furnished_state: SceneState, text: str) -> None:
    instruction = read_instruction(text, furnished_state)
    assert instruction.not_understood == []
    assert [type(s) for s in instruction.statements] == [Swap]
