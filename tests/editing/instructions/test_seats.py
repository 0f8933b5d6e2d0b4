"""Tableware for each chair."""

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.state import SceneState


def test_a_plate_for_each_chair_is_not_put_on_the_chairs(furnished_state: SceneState) -> None:
    assert read_instruction("Put a plate for each chair in the hall.", furnished_state).not_understood


def test_a_cushion_is(furnished_state: SceneState) -> None:
    assert not read_instruction("Put a cushion on each chair in the hall.", furnished_state).not_understood
