"""A place is put right in the same instruction, a room is given contents, and polite frames and remarks are no bar."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Furnish, Mention, Move, SetState, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [statement for statement in instruction.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    "text",
    [
        "Put a vase on the fridge in the kitchen.. no wait, on the dining table",
        "Put a vase on the fridge in the kitchen, sorry, I mean on the dining table there.",
        "Put a vase on the fridge in the kitchen. Actually, make that the dining table.",
        "Put a vase on the fridge - oops, on the dining table in the kitchen please",
    ],
)
def test_another_place_takes_the_place_of_the_first(furnished_state: SceneState, text: str) -> None:
    (statement,) = _asked(text, furnished_state)
    assert isinstance(statement, Add) and statement.things.noun == "vase"
    assert statement.place.relation == "on" and statement.place.anchor is not None
    assert statement.place.anchor.noun == "dining table"
    assert statement.place.rooms is not None and statement.place.rooms.words == "kitchen"


def test_another_room_takes_the_place_of_the_first(furnished_state: SceneState) -> None:
    text = "Move the plate in the kitchen to the hall. Sorry, I meant the private office."
    (statement,) = _asked(text, furnished_state)
    assert isinstance(statement, Move) and statement.place.rooms is not None
    assert statement.place.rooms.words == "private office"


@pytest.mark.parametrize(
    "text", ["Remove the plate, no wait, on the dining table", "No wait, on the dining table", "Sorry, the kitchen"]
)
def test_what_corrects_no_place_is_not_understood(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood


def test_only_the_last_place_gets_it(editor: SceneEditor) -> None:
    before = {item.id for _, item in editor.state.objects()}
    text = "Put an apple on the dining table in the kitchen, no wait, on the dining table in the private office"
    assert instruct(editor, text).done
    (new,) = [item for _, item in editor.state.objects() if item.id not in before]
    assert new.id.startswith("F2/private_office_1/apple")


@pytest.mark.parametrize("remark", ["Guests do eat those.", "The children need the space for their games."])
def test_remarks_on_what_others_do_are_passed_over_and_named(editor: SceneEditor, remark: str) -> None:
    report = instruct(editor, f"Open the fridge. {remark}")
    assert report.done and f"not acted on: {remark.rstrip('.')!r}" in report.message


def test_a_regret_before_a_request_is_passed_over(furnished_state: SceneState) -> None:
    (statement,) = _asked("We never should have bought beer! Open the fridge.", furnished_state)
    assert isinstance(statement, SetState)


@pytest.mark.parametrize(
    "told",
    [
        "We should never have more than two chairs in the hall.",
        "We should have had two chairs in the hall.",
        "Nobody should use it.",
        "Guests want those.",
        "We need the space in the hall.",
    ],
)
def test_what_may_ask_for_something_is_no_remark(furnished_state: SceneState, told: str) -> None:
    instruction = read_instruction(f"{told} Open the fridge.", furnished_state)
    passed = [s for s in instruction.statements if isinstance(s, Mention) and s.passed_over]
    assert instruction.not_understood or not passed


@pytest.mark.parametrize("intent", ["as a welcome", "as a surprise for Marta", "as a treat for the cleaners"])
def test_what_something_is_meant_as_is_passed_over(furnished_state: SceneState, intent: str) -> None:
    instruction = read_instruction(f"Put a plant on the dining table in the kitchen {intent}.", furnished_state)
    assert instruction.not_understood == []
    assert [s.quote for s in instruction.statements if isinstance(s, Mention) and s.passed_over] == [intent]


@pytest.mark.parametrize(
    "frame",
    [
        "Please have the plate in the kitchen taken upstairs to the private office.",
        "May I ask you to have the plate in the kitchen brought to the private office?",
        "Could I ask you to take the plate in the kitchen to the private office?",
    ],
)
def test_polite_frames_ask_for_the_same(furnished_state: SceneState, frame: str) -> None:
    (statement,) = _asked(frame, furnished_state)
    assert isinstance(statement, Move) and statement.things.noun == "plate"
    assert statement.things.place is not None and statement.things.place.rooms is not None
    assert statement.things.place.rooms.words == "kitchen" and not statement.things.place.rooms.floors
    assert statement.place.rooms is not None and statement.place.rooms.words == "private office"


def test_a_second_one_is_another_of_what_was_wished_for(furnished_state: SceneState) -> None:
    text = "It would be lovely if a vase could stand on the fridge, and perhaps a second one on the dining table."
    first, second = _asked(text, furnished_state)
    assert isinstance(first, Add) and isinstance(second, Add)
    assert (first.things.noun, second.things.noun, second.things.amount.kind) == ("vase", "vase", "more")


@pytest.mark.parametrize("contents", [" with a piano", ", must contain a piano", ", it should have a piano"])
def test_a_room_gets_a_use_and_contents(furnished_state: SceneState, contents: str) -> None:
    furnish, ensure = _asked(f"Turn the hall into a music room{contents}.", furnished_state)
    assert isinstance(furnish, Furnish) and furnish.kind == "music room"
    assert isinstance(ensure, Ensure) and ensure.things.noun == "piano"
    assert ensure.place.rooms is not None and ensure.place.rooms.same


@pytest.mark.parametrize(
    ("text", "room"),
    [
        ("Switch on the light in the hall. Sorry, I meant the one in the kitchen.", "kitchen"),
        ("Switch on the light in the hall. Oops, the kitchen was meant.", "kitchen"),
        ("Switch on the light in the hall. Correction: the kitchen.", "kitchen"),
        ("Switch on the light in the hall, no, the kitchen.", "kitchen"),
    ],
)
def test_what_is_switched_may_be_put_right(furnished_state: SceneState, text: str, room: str) -> None:
    (statement,) = _asked(text, furnished_state)
    assert isinstance(statement, SetState) and statement.things.place is not None
    assert statement.things.place.rooms is not None and statement.things.place.rooms.words == room


def test_another_thing_takes_the_place_of_the_first(furnished_state: SceneState) -> None:
    text = "Put a mug on the dining table in the kitchen. Wait, I meant a glass."
    (statement,) = _asked(text, furnished_state)
    assert isinstance(statement, Add) and statement.things.noun == "glass" and statement.place.anchor is not None


def test_one_of_several_is_not_put_right(furnished_state: SceneState) -> None:
    text = "Remove the plate and the mug from the kitchen. Sorry, I meant the vase."
    instruction = read_instruction(text, furnished_state)
    asked = [s for s in instruction.statements if not isinstance(s, Mention)]
    assert instruction.not_understood or any("vase" not in str(s) for s in asked)
