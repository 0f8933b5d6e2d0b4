"""Lists before a clause of their own are its subject; they are no objects of the verb before them."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Clear, Keep, Mention, Remove, SetState, Statement
from mansion_editing.state import SceneState


def _statements(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return instruction.statements


def _states(text: str, state: SceneState) -> dict[str, bool]:
    return {s.things.noun: s.value for s in _statements(text, state) if isinstance(s, SetState)}


@pytest.mark.parametrize(
    "text",
    [
        "Open the fridge, the oven and the wardrobe stay closed.",
        "Open the fridge, the oven and the wardrobe should be closed.",
        "Open the fridge, the oven and the wardrobe closed.",
        "The fridge should be open, the oven and the wardrobe stay closed.",
    ],
)
def test_the_list_is_the_subject_of_what_follows(furnished_state: SceneState, text: str) -> None:
    told = _states(text, furnished_state)
    assert told.pop("fridge") is True
    assert set(told) == {"oven", "wardrobe"} and not any(told.values())


def test_a_verb_for_one_thing_has_one_subject(furnished_state: SceneState) -> None:
    told = _states("Open the fridge, the oven and the wardrobe stays closed.", furnished_state)
    assert told == {"fridge": True, "oven": True, "wardrobe": False}


def test_two_lists_are_parted_at_the_comma(furnished_state: SceneState) -> None:
    told = _states("Open the fridge and the oven, the wardrobe and the dresser remain closed.", furnished_state)
    assert told == {"fridge": True, "oven": True, "wardrobe": False, "dresser": False}


@pytest.mark.parametrize(
    "text",
    [
        "Remove the chairs and the mugs and the plates stay.",
        "Remove the chairs, the mugs, and the plates are fine.",
        "Open the fridge, the oven, the wardrobes and the dressers stay closed.",
    ],
)
def test_what_can_be_parted_in_two_ways_is_asked_about(editor: SceneEditor, text: str) -> None:
    before = {item.id: item for _, item in editor.state.objects()}
    report = instruct(editor, text)
    assert not report.done and "which part" in report.message
    assert {item.id: item for _, item in editor.state.objects()} == before


@pytest.mark.parametrize(
    "staying",
    [
        "the mugs and the plates stay",
        "the mugs and the plates may stay",
        "the mugs and the plates are fine",
        "the mugs and the plates as they are",
        "the mugs and the plates we still need",
        "the mugs and the plates must not be touched",
    ],
)
@pytest.mark.parametrize("asked", ["Remove the chairs", "All chairs must go", "Move the chairs to the kitchen"])
def test_things_that_stay_are_not_swept_along(editor: SceneEditor, asked: str, staying: str) -> None:
    kept = {item.id: item for _, item in editor.state.objects() if item.category in ("mug", "plate")}
    instruct(editor, f"{asked}, {staying}.")
    assert kept and {item.id: item for _, item in editor.state.objects() if item.category in ("mug", "plate")} == kept


def test_several_things_stay_together(furnished_state: SceneState) -> None:
    statements = _statements("Open the fridge. The chairs, the mugs and the plates are fine.", furnished_state)
    assert [s.things.noun for s in statements if isinstance(s, Keep)] == ["chair", "mug", "plate"]


@pytest.mark.parametrize(
    "text", ["Make sure the fridge and the oven are open", "I want the fridge and the oven opened"]
)
def test_what_is_wanted_of_two_things_is_wanted_of_both(furnished_state: SceneState, text: str) -> None:
    assert _states(text, furnished_state) == {"fridge": True, "oven": True}


def test_what_goes_goes_once(editor: SceneEditor) -> None:
    before = {item.id for _, item in editor.state.objects()}
    text = "There should be two mugs on the table in the office. The plate is not needed, remove it."
    report = instruct(editor, text)
    gone = before - {item.id for _, item in editor.state.objects()}
    assert report.done and gone == {"F1/kitchen/plate_1"}


def test_nothing_else_is_meant_by_what_is_gone(editor: SceneEditor) -> None:
    report = instruct(editor, "Open the fridge. Remove the plate. Close it.")
    assert not report.done


def test_from_furniture_is_on_and_in_it(furnished_state: SceneState) -> None:
    (cleared,) = _statements("Remove everything from the dresser apart from the lamp.", furnished_state)
    assert isinstance(cleared, Clear) and cleared.place.relation == ""
    assert [things.noun for things in cleared.spare] == ["lamp"]


@pytest.mark.parametrize(
    "text",
    [
        "We have guests at noon and the chairs go.",
        "We have guests at noon so the chairs go.",
        "Open the fridge because we have guests and the chairs go.",
        "Open the fridge because we have guests and remove the chairs.",
        "Open the fridge. The cat sleeps on the table and the chairs go.",
    ],
)
def test_a_request_after_a_reason_is_no_part_of_it(furnished_state: SceneState, text: str) -> None:
    assert [s.things.noun for s in _statements(text, furnished_state) if isinstance(s, Remove)] == ["chair"]


def test_a_request_after_a_purpose_is_asked_about(furnished_state: SceneState) -> None:
    text = "Open the fridge, in case the guests come and switch on the lights."
    assert read_instruction(text, furnished_state).not_understood


def test_a_reason_without_a_request_is_one(furnished_state: SceneState) -> None:
    statements = _statements("Open the fridge because it is warm and sticky.", furnished_state)
    assert [type(s) for s in statements] == [SetState, Mention]
