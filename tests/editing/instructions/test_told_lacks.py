"""What is told to be missing somewhere is not removed: it tells where what comes next is meant."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Mention, Remove, Rooms
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[object]:
    read = read_instruction(text, state)
    assert not read.not_understood
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    "told",
    [
        "The hall and the kitchen have no plant.",
        "The hall and the kitchen have got no plant.",
        "Neither the hall nor the kitchen has a plant.",
        "The hall and the kitchen do not have a plant.",
    ],
)
def test_several_rooms_that_lack_something_are_each_given_one(told: str, state: SceneState) -> None:
    (added,) = _asked(f"{told} Put one in each.", state)
    assert isinstance(added, Add | Ensure)
    assert added.things.noun == "plant" and added.place.rooms == Rooms(words="hall / kitchen", every=True, number=2)


@pytest.mark.parametrize(
    "told",
    [
        "The hall and the kitchen have no chairs.",
        "The hall doesn't have any chairs.",
        "The hall hasn't got any chairs.",
        "The hall has no chairs and no sofa.",
        "The hall on floor 1 and the corridor on floor 2 have no chairs.",
    ],
)
def test_nothing_is_removed_where_it_is_only_told_to_be_missing(told: str, editor: SceneEditor) -> None:
    for text in (told, f"{told} Put two plants in the kitchen."):
        report = instruct(editor, text)
        assert editor.state.find("F1/hall/chair_1") is not None
        assert "removed" not in report.message


@pytest.mark.parametrize(
    "asked",
    [
        "The hall and the kitchen should have no chairs.",
        "Make sure the hall and the kitchen have no chairs.",
        "I'd like the hall and the kitchen to have no chairs.",
    ],
)
def test_rooms_that_shall_have_none_lose_theirs(asked: str, state: SceneState) -> None:
    removed = _asked(asked, state)
    assert [s.things.place.rooms.words for s in removed if isinstance(s, Remove)] == ["hall", "kitchen"]  # type: ignore[union-attr]


def test_a_roll_is_one_of_the_paper_that_was_told_to_be_missing(state: SceneState) -> None:
    (added,) = _asked("The kitchen has no toilet paper. Put a roll on the dining table.", state)
    assert isinstance(added, Add) and added.things.noun == "toilet paper"
    assert added.place.rooms is not None and added.place.rooms.words == "kitchen"


def test_a_roll_of_something_is_that(state: SceneState) -> None:
    (added,) = _asked("Put a roll of toilet paper on the dining table.", state)
    assert isinstance(added, Add) and added.things.noun == "toilet paper"
