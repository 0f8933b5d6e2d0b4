"""A reason that names things, and a request that goes on with them by a pronoun."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Mention, Remove, Rooms, Statement
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
