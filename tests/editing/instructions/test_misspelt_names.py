"""Mistakes in names of rooms and things that the words around them, or the building, put right."""

import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("a mug on the dinning table in the kitchen", "dining table"),
        ("a mug on the diningtable in the kitchen", "dining table"),
        ("a mug on the dinnig table in the kitchen", "dining table"),
        ("a mug on the desck in the kitchen", "desk"),
        ("a mug in the frige in the kitchen", "fridge"),
    ],
)
def test_a_misspelt_receptacle_is_known(state: SceneState, said: str, meant: str) -> None:
    instruction = read_instruction(f"put {said}", state)
    assert instruction.not_understood == []
    (statement,) = instruction.statements
    assert isinstance(statement, Add) and statement.place.anchor is not None
    assert statement.place.anchor.noun == meant


@pytest.mark.parametrize(("said", "meant"), [("aples", "apple"), ("plnts", "plant"), ("lemmons", "lemon")])
def test_a_letter_left_out_of_a_short_name_is_added(state: SceneState, said: str, meant: str) -> None:
    instruction = read_instruction(f"put two {said} in the kitchen", state)
    (statement,) = instruction.statements
    assert instruction.not_understood == [] and isinstance(statement, Add) and statement.things.noun == meant


@pytest.mark.parametrize("other", ["chai", "harp", "bare mug", "kilt"])
def test_other_words_are_no_mistakes(state: SceneState, other: str) -> None:
    assert read_instruction(f"put a {other} on the dining table in the kitchen", state).not_understood
