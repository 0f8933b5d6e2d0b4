"""Reasons and purposes ask for nothing; what asks for something is not taken for one."""

import msgspec
import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Clear, Mention, Reach, Remove
from mansion_editing.state import SceneState


@pytest.mark.parametrize("aside", [", for reading", " for working", ". Beside the table it is always in the way"])
def test_an_aside_asks_for_nothing(state: SceneState, aside: str) -> None:
    instruction = read_instruction(f"Put a chair in the kitchen{aside}.", state)
    assert instruction.not_understood == []
    assert [type(s) for s in instruction.statements] == [Add, Mention]


@pytest.mark.parametrize("more", [", for painting it red", ", for removing the fridge"])
def test_what_asks_for_something_is_no_aside(state: SceneState, more: str) -> None:
    assert read_instruction(f"Put a chair in the kitchen{more}.", state).not_understood


@pytest.mark.parametrize(
    "free", ["Make sure nothing blocks it.", "Nothing may block the way.", "Make sure that nothing is in the way."]
)
def test_a_way_is_checked_again(state: SceneState, free: str) -> None:
    instruction = read_instruction(f"A robot must be able to drive from the hall to the kitchen. {free}", state)
    assert instruction.not_understood == []
    assert [type(s) for s in instruction.statements] == [Reach, Reach]


def test_a_room_that_is_cleared_out_completely_loses_its_furniture(state: SceneState) -> None:
    instruction = read_instruction("Clear out the kitchen completely.", state)
    assert instruction.not_understood == []
    assert [type(s) for s in instruction.statements] == [Remove, Clear]


@pytest.mark.parametrize("verb", ["switch on both lamps", "turn off the lamp", "remove both chairs", "open the fridge"])
def test_a_verb_may_follow_the_number_of_a_room(state: SceneState, verb: str) -> None:
    (bare,) = read_instruction(f"In office 1, {verb}", state).statements
    (joined,) = read_instruction(f"In office 1 {verb}", state).statements
    assert joined == bare and '"office 1"' in msgspec.json.encode(joined).decode()
