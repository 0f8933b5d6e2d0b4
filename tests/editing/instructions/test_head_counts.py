"""How many people there are is no number of things."""

import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Mention
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    "told",
    [
        "We're four for dinner tonight, so",
        "There will be five of us for lunch;",
        "There are eight of us in the house now.",
        "There are six guests tonight, so",
        "We'll be ten at the table:",
        "We are six at breakfast tomorrow,",
    ],
)
def test_a_number_of_people_asks_for_nothing(furnished_state: SceneState, told: str) -> None:
    instruction = read_instruction(f"{told} put two plates on the dining table in the kitchen.", furnished_state)
    assert instruction.not_understood == []
    (asked,) = [statement for statement in instruction.statements if not isinstance(statement, Mention)]
    assert isinstance(asked, Add) and asked.things.amount.number == 2


@pytest.mark.parametrize(
    "told", ["We're two short in the kitchen", "We are two chairs short", "There should be six of us"]
)
def test_a_number_that_is_missing_is_not_passed_over(furnished_state: SceneState, told: str) -> None:
    assert read_instruction(f"{told}. Open the fridge.", furnished_state).not_understood
