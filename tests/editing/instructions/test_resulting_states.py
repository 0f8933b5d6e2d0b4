"""States told after a clause, in lists and below headings, and the doors and lids by which things open."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Keep, Mention, Move, SetState, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [statement for statement in instruction.statements if not isinstance(statement, Mention)]


def _states(text: str, state: SceneState) -> list[tuple[str, bool]]:
    return [(s.state, s.value) for s in _asked(text, state) if isinstance(s, SetState)]


@pytest.mark.parametrize(
    ("told", "states"),
    [
        ("switched on", [("on", True)]),
        ("opened and turned on", [("open", True), ("on", True)]),
        ("both open and switched off", [("open", True), ("on", False)]),
        ("with the lid open", [("open", True)]),
        ("its lid shut", [("open", False)]),
        ("which should be left open", [("open", True)]),
        ("switched on so I can find it", [("on", True)]),
        ("turned on before the guests arrive", [("on", True)]),
    ],
)
def test_what_is_put_somewhere_takes_the_state_told_after_it(
    furnished_state: SceneState, told: str, states: list[tuple[str, bool]]
) -> None:
    text = f"Put the laptop from the hall on the dining table in the kitchen, {told}."
    (moved, *_) = _asked(text, furnished_state)
    assert isinstance(moved, Move) and _states(text, furnished_state) == states


def test_a_second_state_is_that_of_the_same_thing(furnished_state: SceneState) -> None:
    first, second = _asked("The laptop in the hall should be open and switched on.", furnished_state)
    assert isinstance(first, SetState) and isinstance(second, SetState)
    assert first.things == second.things and (first.state, second.state) == ("open", "on")


def test_what_a_relative_clause_leaves_open_is_what_opens(furnished_state: SceneState) -> None:
    unclear = read_instruction("Put the laptop into the fridge, which should be left open.", furnished_state)
    assert unclear.not_understood
    assert _states("Put the mug into the fridge, which should be left open.", furnished_state) == [("open", True)]


@pytest.mark.parametrize(
    "text",
    [
        "Take the mug out of the kitchen. Open the fridge and leave the door open.",
        "Leave the door of the fridge open.",
        "Leave the fridge standing open.",
        "The lid of the fridge should be open.",
    ],
)
def test_the_door_of_furniture_is_its_own(editor: SceneEditor, text: str) -> None:
    assert instruct(editor, text).done
    fridge = editor.state.find("F1/kitchen/fridge_1")
    assert fridge is not None and fridge[1].states["open"]


def test_the_door_is_asked_about_where_nothing_tells_which(editor: SceneEditor) -> None:
    report = instruct(editor, "Shut the door.")
    assert not report.done
    assert len(report.candidates) > 1


def test_the_door_is_one_of_the_room_that_was_mentioned(editor: SceneEditor) -> None:
    assert instruct(editor, "Remove the mug from the kitchen and shut the door to the hall.").done
    closed = [door.id for scene in editor.store.scenes().values() for door in scene.doors if not door.is_open]
    assert closed == ["F1/door_1"]


def test_furniture_is_left_open_with_something_in_it(furnished_state: SceneState) -> None:
    opened, there = _asked("Leave the fridge in the kitchen open with two apples in it.", furnished_state)
    assert isinstance(opened, SetState) and isinstance(there, Ensure)
    assert there.place.relation == "in" and there.place.anchor is not None and there.place.anchor.noun == "fridge"


def test_a_state_after_a_list_is_that_of_all(furnished_state: SceneState) -> None:
    told = _asked("Dishwasher and washing machine in the kitchen both running.", furnished_state)
    assert [s.things.noun for s in told if isinstance(s, SetState)] == ["dishwasher", "washing machine"]


@pytest.mark.parametrize("heading", ["Movie night in the kitchen", "Photo shoot in the kitchen", "Kitchen"])
def test_the_room_of_a_heading_is_that_of_what_follows(furnished_state: SceneState, heading: str) -> None:
    lights, fridge = _asked(f"{heading}: the ceiling lights out, fridge open.", furnished_state)
    assert isinstance(lights, SetState) and isinstance(fridge, SetState)
    assert not lights.value and all(s.things.place is not None and s.things.place.rooms for s in (lights, fridge))


def test_lamps_that_are_out_or_dark_are_off(furnished_state: SceneState) -> None:
    for word in ("out", "dark", "off"):
        assert _states(f"In the kitchen the ceiling lights are {word}.", furnished_state) == [("on", False)]


def test_nothing_changes_in_several_rooms(furnished_state: SceneState) -> None:
    kept = _asked("Open the fridge. Nothing changes in the hall or in the private office.", furnished_state)[1:]
    assert len(kept) == 2 and all(isinstance(s, Keep) for s in kept)


def test_a_state_that_is_not_understood_is_no_remark(furnished_state: SceneState) -> None:
    text = "Put the mug from the kitchen on the sofa in the hall, turned upside down on Monday."
    assert read_instruction(text, furnished_state).not_understood


def test_a_state_is_not_that_of_what_cannot_take_it(furnished_state: SceneState) -> None:
    assert read_instruction("Put the mug from the kitchen in the fridge, open.", furnished_state).not_understood


def test_a_new_thing_after_a_state_is_brought(furnished_state: SceneState) -> None:
    text = "Put a laptop on the sofa in the hall, open, and a mug beside it."
    assert not any(isinstance(s, SetState) and s.things.noun == "mug" for s in _asked(text, furnished_state))


def test_things_after_a_state_are_there_and_not_in_it(furnished_state: SceneState) -> None:
    there = _asked("Kitchen: ceiling lights on, two candles on the dining table.", furnished_state)[-1]
    assert isinstance(there, Ensure) and there.things.noun == "candle" and there.things.amount.number == 2


@pytest.mark.parametrize("lid", [", door shut", " with the door shut"])
def test_a_door_is_that_of_what_things_are_put_in(furnished_state: SceneState, lid: str) -> None:
    read = read_instruction(f"Put three apples in the fridge{lid}.", furnished_state)
    assert read.not_understood == []
    apples, shut = read.statements
    assert isinstance(apples, Add)
    assert isinstance(shut, SetState) and shut.things.noun == "fridge" and not shut.value


@pytest.mark.parametrize(
    ("text", "value"),
    [("Lift the lid of the fridge.", True), ("Raise the fridge lid.", True), ("Lower the lid of the fridge.", False)],
)
def test_a_lid_is_lifted_and_lowered(furnished_state: SceneState, text: str, value: bool) -> None:
    read = read_instruction(text, furnished_state)
    (statement,) = read.statements
    assert read.not_understood == []
    assert isinstance(statement, SetState) and (statement.state, statement.value) == ("open", value)


@pytest.mark.parametrize("text", ["Lift the lid off the fridge.", "Do not lift the lid of the fridge."])
def test_a_lid_that_is_taken_off_or_left_alone_opens_nothing(furnished_state: SceneState, text: str) -> None:
    statements = read_instruction(text, furnished_state).statements
    assert not any(isinstance(statement, SetState) for statement in statements)
