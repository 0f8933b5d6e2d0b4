"""What has one already gets no second, however that is said."""

import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Mention, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [statement for statement in instruction.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    "spared",
    [
        "; where there is one already leave it as it is.",
        ". Where there's already one, it stays.",
        ", leave those that have one alone.",
        ", but don't put a second one where there is one already.",
        ", but not where there is one already.",
        "; if a table already has one, that's fine.",
        ". Skip the tables which have one already.",
        "; whatever already has one needs nothing.",
        "; where there's one already you don't need to do anything.",
    ],
)
def test_those_that_have_one_get_no_second(furnished_state: SceneState, spared: str) -> None:
    (statement,) = _asked(f"Put a mug on every dining table{spared}", furnished_state)
    assert isinstance(statement, Ensure) and statement.each
    assert statement.things.noun == "mug" and statement.things.amount.number == 1


@pytest.mark.parametrize("spared", ["if there is one already leave it", "but not where there is one already"])
def test_a_single_place_that_has_one_gets_no_second(furnished_state: SceneState, spared: str) -> None:
    (statement,) = _asked(f"Put a mug on the dining table in the kitchen; {spared}.", furnished_state)
    assert isinstance(statement, Ensure) and not statement.each


@pytest.mark.parametrize(
    "other",
    [
        "where there is one already remove it",
        "where there is one already move it to the hall",
        "where there are two leave one",
        "where there is one already leave nothing",
        "where there is one already it should not stay",
    ],
)
def test_what_else_becomes_of_those_is_not_passed_over(furnished_state: SceneState, other: str) -> None:
    assert read_instruction(f"Put a mug on every dining table; {other}.", furnished_state).not_understood


@pytest.mark.parametrize("amount", ["two mugs", "another mug"])
def test_one_that_is_there_says_nothing_of_other_numbers(furnished_state: SceneState, amount: str) -> None:
    instruction = read_instruction(
        f"Put {amount} on every dining table; where there is one already leave it.", furnished_state
    )
    assert instruction.not_understood and isinstance(instruction.statements[0], Add)
