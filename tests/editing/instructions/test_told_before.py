"""What people say before and beside a request: what they do, what is there, what would be nice."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Mention, Remove, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [statement for statement in instruction.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    "told",
    ["My back hurts.", "Grandma is visiting, so", "Everyone is tired.", "Our guests arrived early,", "The dog barked."],
)
def test_what_only_tells_something_asks_for_nothing(state: SceneState, told: str) -> None:
    (statement,) = _asked(f"{told} put a mug on the dining table in the kitchen.", state)
    assert isinstance(statement, Add) and statement.things.noun == "mug"


@pytest.mark.parametrize(
    "told",
    [
        "Two would be better.",
        "The mug goes.",
        "It has to leave.",
        "Not the red one.",
        "The fridge should be there.",
        "Everything stays.",
    ],
)
def test_what_may_ask_for_something_is_not_passed_over(state: SceneState, told: str) -> None:
    instruction = read_instruction(f"Put a mug on the dining table in the kitchen. {told}", state)
    assert instruction.not_understood or len(instruction.statements) > 1
    assert not isinstance(instruction.statements[-1], Mention)


@pytest.mark.parametrize(
    "told",
    [
        "Nobody uses the plate on the dining table any more.",
        "The dog licked the plate on the dining table.",
        "I see a plate on the dining table.",
        "Grandma hates the plate on the dining table.",
        "The plate on the dining table smells.",
    ],
)
def test_it_is_what_was_told_of(editor: SceneEditor, told: str) -> None:
    report = instruct(editor, f"{told} Throw it away.")
    assert report.done and report.object_ids == ["F1/kitchen/plate_1"]


@pytest.mark.parametrize(
    "wish",
    [
        "It would be nice if there was a plant in the hall.",
        "It would be good to have a plant in the hall.",
        "We could use a plant in the hall.",
        "The hall could use a plant.",
        "The hall could do with a plant.",
        "The guests in the hall want a plant there.",
    ],
)
def test_a_goal_may_be_a_wish(state: SceneState, wish: str) -> None:
    (statement,) = _asked(wish, state)
    assert isinstance(statement, Add | Ensure) and statement.things.noun == "plant"
    assert statement.place.rooms is not None and statement.place.rooms.words == "hall"


def test_what_was_there_once_is_not_asked_for(state: SceneState) -> None:
    instruction = read_instruction("There was a plant in the hall. Put a mug on the dining table.", state)
    assert [type(statement) for statement in instruction.statements] == [Mention, Add]


def test_somebody_who_is_asked_to_do_something_is_not_asked_whether(editor: SceneEditor) -> None:
    report = instruct(editor, "Could somebody bring the plate from the dining table to the hall?")
    assert not report.question and (not report.done or report.object_ids)


@pytest.mark.parametrize("there", ["in there", "inside"])
def test_in_there_is_in_what_was_mentioned(state: SceneState, there: str) -> None:
    for before in ("There's a fridge in the kitchen.", "Open the fridge and"):
        *_, statement = _asked(f"{before} put an apple {there}.", state)
        assert isinstance(statement, Add) and statement.place.relation == "in"
        assert statement.place.anchor is not None


def test_furniture_goes_in_the_room_that_there_means(state: SceneState) -> None:
    *_, statement = _asked("There is a fridge in the kitchen. Put a chair in there.", state)
    assert isinstance(statement, Add) and statement.place.anchor is None


@pytest.mark.parametrize("words", ["throw {} away", "throw {} out", "throw {} in the rubbish", "{} goes in the trash"])
def test_rubbish_leaves_the_building(state: SceneState, words: str) -> None:
    (statement,) = _asked(words.format("the plate on the dining table"), state)
    assert isinstance(statement, Remove)


def test_what_is_thrown_over_furniture_stays(state: SceneState) -> None:
    (statement,) = _asked("Throw a blanket over the chair in the hall.", state)
    assert isinstance(statement, Add) and statement.place.relation == "on"


def test_it_is_the_room_that_was_renamed(editor: SceneEditor) -> None:
    report = instruct(editor, 'Rename the kitchen to "Canteen" and put a plant in it.')
    assert report.done and any("F1/kitchen/" in name and "plant" in name for name in report.object_ids)
