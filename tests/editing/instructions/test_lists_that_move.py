"""Lists that come from one place, what comes with them, and what was only told before them."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Mention, Move, Place, Reach, Remove, Statement, When
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == [], read.not_understood
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    "text",
    [
        "Kitchen: put the plate and the mug from the dining table into the fridge.",
        "Put the plate and the mug from the dining table in the kitchen into the fridge.",
        "The plate and the mug from the dining table in the kitchen into the fridge, please.",
    ],
)
def test_all_of_a_list_come_from_its_place(furnished_state: SceneState, text: str) -> None:
    moves = _asked(text, furnished_state)
    assert [m.things.noun for m in moves if isinstance(m, Move)] == ["plate", "mug"]
    places = [m.things.place for m in moves if isinstance(m, Move)]
    assert places[0] == places[1] and places[0] is not None and places[0].anchor is not None


def test_what_comes_too_goes_where_they_went(furnished_state: SceneState) -> None:
    text = "Bring the plate from the dining table in the kitchen to the desk, and a bowl too."
    moved, added = _asked(text, furnished_state)
    assert isinstance(moved, Move) and isinstance(added, Add) and added.place == moved.place


def test_it_is_what_opens_of_a_list_that_went_into_it(editor: SceneEditor) -> None:
    report = instruct(editor, "Kitchen: put the plate from the dining table into the fridge and open it.")
    assert report.done, report.message
    (fridge,) = [item for _, item in editor.state.objects() if item.category == "fridge"]
    assert fridge.states["open"]


@pytest.mark.parametrize(("what", "kind"), [("cheese", "all"), ("a mug", "some")])
def test_a_mass_on_a_condition_is_all_of_it(furnished_state: SceneState, what: str, kind: str) -> None:
    (when,) = _asked(f"If there is {what} in the fridge, throw it away.", furnished_state)
    assert isinstance(when, When) and isinstance(when.then, Remove) and when.then.things.amount.kind == kind


@pytest.mark.parametrize(
    "text",
    [
        "A child in a wheelchair has to be able to drive from the hall to the kitchen.",
        "After that a visitor on crutches must be able to get from the hall to the kitchen.",
        "In the end a trolley must be able to roll from the hall to the kitchen.",
    ],
)
def test_who_must_get_somewhere_may_need_an_aid(furnished_state: SceneState, text: str) -> None:
    (way,) = _asked(text, furnished_state)
    assert isinstance(way, Reach)


def test_another_ability_is_no_way(furnished_state: SceneState) -> None:
    text = "A child in a wheelchair has to be able to write at the desk."
    assert read_instruction(text, furnished_state).not_understood


def test_what_is_in_the_way_is_where_it_was_told_to_be(furnished_state: SceneState) -> None:
    (moved,) = _asked("The sofa in the hall is in the way, carry it over to the kitchen.", furnished_state)
    assert isinstance(moved, Move) and moved.things.place is not None and moved.things.place.anchor is None


def test_there_is_where_a_small_thing_was_taken_from(editor: SceneEditor) -> None:
    report = instruct(editor, "Away with the plate in the kitchen; put a bowl there.")
    assert report.done, report.message
    (bowl,) = [item for _, item in editor.state.objects() if item.category == "bowl"]
    assert bowl.parent == "F1/kitchen/dining_table_1"


def test_there_is_a_room_for_what_stands(furnished_state: SceneState) -> None:
    _, added = _asked("Remove the sofa from the hall and put an armchair there.", furnished_state)
    assert isinstance(added, Add) and added.place.rooms is not None and added.place != Place()
