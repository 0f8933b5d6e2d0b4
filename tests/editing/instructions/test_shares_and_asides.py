"""How many where, and words after a request that change nothing of it."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Furnish, Mention, Remove, Swap, Things
from mansion_editing.state import SceneState


def test_one_here_and_one_there_are_two(state: SceneState) -> None:
    instruction = read_instruction("Two mugs for the kitchen, one on the dining table and one on the counter.", state)
    assert instruction.not_understood == []
    assert [s.things.amount.number for s in instruction.statements if isinstance(s, Add)] == [1, 1]


def test_certain_things_are_not_shared_out_as_new_ones(state: SceneState) -> None:
    text = "Put the two mugs in the kitchen, one on the dining table and one on the counter."
    assert read_instruction(text, state).not_understood


@pytest.mark.parametrize("text", ["a plant for the hall", "two plants for the hall", "2 plants for the hall, please"])
def test_so_many_are_added_without_a_verb(state: SceneState, text: str) -> None:
    (statement,) = read_instruction(text, state).statements
    assert isinstance(statement, Add)


def test_a_bare_name_asks_that_it_is_there(state: SceneState) -> None:
    (statement,) = read_instruction("Plant in the hall", state).statements
    assert isinstance(statement, Ensure)


@pytest.mark.parametrize("aside", ["if there is room", "if it fits", "before the guests come", "until Monday"])
def test_an_aside_after_a_request_changes_nothing(state: SceneState, aside: str) -> None:
    instruction = read_instruction(f"Put a mug on the dining table in the kitchen {aside}.", state)
    assert instruction.not_understood == []
    assert [type(s) for s in instruction.statements if not isinstance(s, Mention)] == [Add]


@pytest.mark.parametrize("aside", ["if there is room service", "until the fridge is open", "before 3 mugs come"])
def test_an_aside_that_names_something_is_no_aside(state: SceneState, aside: str) -> None:
    instruction = read_instruction(f"Put a mug on the dining table in the kitchen {aside}.", state)
    asked = [s for s in instruction.statements if not isinstance(s, Mention)]
    assert instruction.not_understood or [type(s) for s in asked] != [Add]


def test_what_is_not_liked_stays_until_it_is_to_go(editor: SceneEditor) -> None:
    assert not instruct(editor, "I don't like the plate on the dining table.").done
    report = instruct(editor, "I don't like the plate on the dining table. Remove it.")
    assert report.done and report.object_ids == ["F1/kitchen/plate_1"]


def test_only_what_is_left_is_more_than_what_was_removed(state: SceneState) -> None:
    text = "Take the mugs off the dining table in the kitchen and leave only the plate."
    assert read_instruction(text, state).not_understood


def test_it_is_the_room_that_was_emptied(state: SceneState) -> None:
    statement = read_instruction("Empty the hall and furnish it anew as a study.", state).statements[-1]
    assert isinstance(statement, Furnish) and statement.rooms.same


def test_both_of_a_swap_are_in_the_room_told_first(state: SceneState) -> None:
    (statement,) = read_instruction("In the kitchen, swap the plate with the mug.", state).statements
    assert isinstance(statement, Swap)
    for end in (statement.one, statement.other):
        assert isinstance(end, Things) and end.place is not None and end.place.rooms is not None
        assert end.place.rooms.words == "kitchen"


@pytest.mark.parametrize(
    "text",
    [
        "No mugs in the kitchen and none in the hall either.",
        "No mugs in the kitchen, none in the hall.",
        "There should be no mugs in the kitchen and none in the hall.",
    ],
)
def test_none_elsewhere_are_none_of_the_same(furnished_state: SceneState, text: str) -> None:
    read = read_instruction(text, furnished_state)
    assert read.not_understood == []
    gone = [s.things for s in read.statements if isinstance(s, Remove) and s.things.noun == "mug"]
    rooms = [t.place.rooms.words for t in gone if t.place is not None and t.place.rooms is not None]
    assert rooms == ["kitchen", "hall"]


@pytest.mark.parametrize(
    "text",
    [
        "Remove all mugs in the kitchen and none in the hall.",
        "Put no mugs in the kitchen and none in the hall.",
        "No mugs in the kitchen but the red one and none in the hall.",
        "No mugs in the kitchen and none from the hall.",
    ],
)
def test_none_after_other_requests_is_not_guessed(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood
