"""What stands on furniture is told in general, and then cleared: ``half the kitchen is on the counter. Clear it``."""

import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Clear, Mention, Remove, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [statement for statement in instruction.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    "told",
    [
        "Somebody left half the kitchen on top of the dining table in the kitchen. Clear the top of it",
        "Someone left a mess on the dining table in the kitchen. Clear it",
        "The dining table in the kitchen is full of stuff. Empty the top of it",
        "The dining table in the kitchen looks like a battlefield. Clear it",
        "Clear the top of the dining table in the kitchen",
    ],
)
@pytest.mark.parametrize("staying", ["", ", only the mug may stay", " except for the mug"])
def test_it_is_emptied_and_does_not_go(furnished_state: SceneState, told: str, staying: str) -> None:
    (cleared,) = _asked(f"{told}{staying}.", furnished_state)
    assert isinstance(cleared, Clear) and cleared.place.anchor is not None
    assert cleared.place.anchor.noun == "dining table"
    assert [things.noun for things in cleared.spare] == (["mug"] if staying else [])


def test_what_is_loose_is_cleared_away(furnished_state: SceneState) -> None:
    (gone,) = _asked("Somebody left a plate on the dining table in the kitchen. Clear it.", furnished_state)
    assert isinstance(gone, Remove) and gone.things.noun == "plate"
