"""What is said to stay as it is is kept, and checked: it is neither dropped nor refused."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Clear, Keep, Mention, Remove, SetState, Turn
from mansion_editing.state import SceneState


def _ids(editor: SceneEditor, category: str) -> list[str]:
    return sorted(item.id for _, item in editor.state.objects() if item.category == category)


@pytest.mark.parametrize(
    "staying",
    [
        "The mugs that are standing there stay.",
        "The kitchen stays as it is.",
        "The kitchen keeps its chairs.",
        "The chairs are good.",
        "The plates are fine as they are.",
        "what's on the dining table is fine",
        "What is in the kitchen may stay.",
        "The second floor is to stay as it is.",
        "Nothing on the second floor may change.",
        "Nothing in the kitchen should be moved.",
        "On the second floor nothing may be touched.",
        "The chairs must not be moved.",
        "Leave the kitchen as it is.",
        "Do not touch the kitchen.",
    ],
)
def test_what_is_said_to_stay_is_kept(furnished_state: SceneState, staying: str) -> None:
    instruction = read_instruction(f"Open the fridge. {staying}", furnished_state)
    assert instruction.not_understood == []
    assert [type(statement) for statement in instruction.statements[1:]] == [Keep]


@pytest.mark.parametrize(
    "staying",
    [
        "The second floor stays as it is.",
        "Nothing on the second floor may change.",
        "The ones on the second floor stay.",
        "Those on the second floor stay as they are.",
        "What is on the second floor is fine.",
    ],
)
def test_what_stays_is_spared(editor: SceneEditor, staying: str) -> None:
    upstairs = [name for name in _ids(editor, "dining_table") if name.startswith("F2")]
    assert upstairs and upstairs != _ids(editor, "dining_table")
    assert instruct(editor, f"Remove all dining tables. {staying}").done
    assert _ids(editor, "dining_table") == upstairs


@pytest.mark.parametrize(
    "asked", ["Add a mug to the kitchen", "Paint the walls of the kitchen green", "Rename the kitchen to Den"]
)
def test_a_room_that_stays_gets_nothing_new(editor: SceneEditor, asked: str) -> None:
    report = instruct(editor, f"{asked}. Nothing in the kitchen may change.")
    assert not report.done and "not as it was" in report.message


@pytest.mark.parametrize("text", ["The lamp would be fine", "Nothing is on the dining table", "The mug is not good"])
def test_not_every_word_of_praise_keeps(furnished_state: SceneState, text: str) -> None:
    assert not any(isinstance(s, Keep) for s in read_instruction(text, furnished_state).statements)


def test_what_was_named_before_is_the_kind_that_is_kept(furnished_state: SceneState) -> None:
    statements = read_instruction("Remove one mug. The kitchen keeps its own.", furnished_state).statements
    assert isinstance(statements[0], Remove) and isinstance(statements[1], Keep)
    assert statements[1].things.noun == "mug" and statements[1].things.place is not None


@pytest.mark.parametrize(
    "staying",
    [
        "The mugs should of course remain.",
        "The mugs can also stay there.",
        "Kitchen untouched.",
        "mugs stay",
        "The fridge and the dining table stay as is.",
    ],
)
def test_what_stays_may_be_said_in_short_or_with_more_words(furnished_state: SceneState, staying: str) -> None:
    instruction = read_instruction(f"Switch off the ceiling lights. {staying}", furnished_state)
    assert instruction.not_understood == []
    assert {type(statement) for statement in instruction.statements[1:]} == {Keep}


@pytest.mark.parametrize(
    "rest",
    [
        "Everything else in the kitchen stays as it is please.",
        "Everything else upstairs can of course stay.",
        "The rest of the room is to remain untouched.",
        "The rest of the furniture stays where it is.",
        "The rest is good like this.",
    ],
)
def test_that_all_the_rest_stays_asks_for_nothing(furnished_state: SceneState, rest: str) -> None:
    instruction = read_instruction(f"Open the fridge. {rest}", furnished_state)
    assert instruction.not_understood == []
    assert [type(s) for s in instruction.statements] == [SetState, Mention]


@pytest.mark.parametrize("rest", ["Everything else in the kitchen goes.", "The rest is to leave.", "Two mugs stay."])
def test_what_is_to_go_is_not_said_to_stay(furnished_state: SceneState, rest: str) -> None:
    instruction = read_instruction(f"Open the fridge. {rest}", furnished_state)
    asked = [s for s in instruction.statements[1:] if not isinstance(s, Mention)]
    assert instruction.not_understood or asked
    assert not any(isinstance(s, Keep) for s in asked)


def test_what_stays_on_what_is_cleared_is_spared(furnished_state: SceneState) -> None:
    text = "Clear the dining table, keep the plate and the mug on it"
    (cleared,) = read_instruction(text, furnished_state).statements
    assert isinstance(cleared, Clear) and [things.noun for things in cleared.spare] == ["plate", "mug"]


def test_what_shall_look_at_something_is_turned(furnished_state: SceneState) -> None:
    (turned,) = read_instruction("The chair in the hall must look towards the fridge.", furnished_state).statements
    assert isinstance(turned, Turn) and turned.facing is not None and turned.facing.noun == "fridge"
