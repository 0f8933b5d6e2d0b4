"""What comes with new things, what is excepted after a clause, and forms that other languages lend to English."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import (
    Add,
    Ensure,
    Furnish,
    Keep,
    Mention,
    Move,
    Remove,
    Replace,
    SetState,
    Statement,
)
from mansion_editing.state import SceneState


def _statements(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [s for s in instruction.statements if not isinstance(s, Mention)]


@pytest.mark.parametrize("joint", ["with", "w/"])
def test_what_replaces_something_may_bring_furniture(furnished_state: SceneState, joint: str) -> None:
    replaced, added = _statements(f"Swap the fridge for a desk {joint} a chair.", furnished_state)
    assert isinstance(replaced, Replace) and replaced.by.noun == "desk"
    assert isinstance(added, Add) and (added.things.noun, added.place.relation) == ("chair", "beside")


def test_furniture_before_its_place_may_bring_more(furnished_state: SceneState) -> None:
    table, chairs = _statements("Put a small table with two stools in the hall.", furnished_state)
    assert isinstance(table, Add) and table.place.rooms is not None and table.place.rooms.words == "hall"
    assert isinstance(chairs, Add) and (chairs.things.amount.number, chairs.place.relation) == (2, "around")


@pytest.mark.parametrize("tail", [" with a stool each", ", with a stool each", ", each with a stool"])
def test_each_of_several_brings_one(furnished_state: SceneState, tail: str) -> None:
    easels, stools = _statements(f"Another two easels in the kitchen would be great{tail}.", furnished_state)
    assert isinstance(easels, Add | Ensure) and easels.things.amount.number == 2
    assert isinstance(stools, Add) and (stools.things.noun, stools.things.amount.number) == ("stool", 2)


def test_what_lies_in_new_furniture_is_not_where_it_goes(furnished_state: SceneState) -> None:
    wardrobe, towels = _statements("Add a wardrobe with folded towels in it to the hall.", furnished_state)
    assert isinstance(wardrobe, Add) and wardrobe.place.anchor is None and wardrobe.place.rooms is not None
    assert isinstance(towels, Add) and towels.place.anchor is not None and towels.place.anchor.refers == "last"


@pytest.mark.parametrize(("state", "value"), [("open", True), ("closed", False)])
def test_a_lid_is_that_of_what_is_put_somewhere(furnished_state: SceneState, state: str, value: bool) -> None:
    text = f"Put a laptop on the dining table in the kitchen with the lid {state}."
    added, opened = _statements(text, furnished_state)
    assert isinstance(added, Add) and isinstance(opened, SetState)
    assert (opened.things.refers, opened.state, opened.value) == ("last", "open", value)


@pytest.mark.parametrize("words", ["except for the one in the kitchen", ", apart from those in the kitchen"])
def test_an_exception_may_follow_a_predicate(furnished_state: SceneState, words: str) -> None:
    (switched,) = _statements(f"All the ceiling lights should be switched off {words}.", furnished_state)
    assert isinstance(switched, SetState) and [one.noun for one in switched.things.beside] == ["ceiling light"]


def test_the_place_of_an_exception_is_not_that_of_the_rest(editor: SceneEditor) -> None:
    report = instruct(editor, "Remove all dining tables except the one in the kitchen.")
    assert report.done
    tables = [item.id for _, item in editor.state.objects() if item.category == "dining_table"]
    assert tables == ["F1/kitchen/dining_table_1"]


@pytest.mark.parametrize(
    "text", ["The plate in the kitchen please bring to the hall.", "The plate in the kitchen please move to the hall."]
)
def test_an_object_may_stand_before_please(furnished_state: SceneState, text: str) -> None:
    (moved,) = _statements(text, furnished_state)
    assert isinstance(moved, Move) and moved.things.noun == "plate" and moved.place.rooms is not None


@pytest.mark.parametrize("more", ["more", "any more", "no more"])
def test_a_pronoun_may_repeat_an_object(furnished_state: SceneState, more: str) -> None:
    (gone,) = _statements(f"The third chair we do not need it {more}.", furnished_state)
    assert isinstance(gone, Remove) and (gone.things.noun, gone.things.ordinal) == ("chair", 3)


def test_something_is_changed_by_something_new(furnished_state: SceneState) -> None:
    (replaced,) = _statements("Change the fridge in the kitchen by a wardrobe in green colour.", furnished_state)
    assert isinstance(replaced, Replace) and (replaced.by.noun, replaced.by.colour) == ("wardrobe", "green")


def test_one_from_several_is_one_of_them(furnished_state: SceneState) -> None:
    (gone,) = _statements("Take away one from the three chairs what are in the hall.", furnished_state)
    assert isinstance(gone, Remove) and (gone.things.amount.number, gone.things.amount.of) == (1, 3)


def test_a_name_in_two_words_is_one(furnished_state: SceneState) -> None:
    (added,) = _statements("Add a fire place to the hall.", furnished_state)
    assert isinstance(added, Add) and added.things.noun == "fireplace"


def test_a_room_of_somebody_is_theirs(furnished_state: SceneState) -> None:
    (gone,) = _statements("Remove the mugs in the office of the private.", furnished_state)
    assert isinstance(gone, Remove) and gone.things.place is not None and gone.things.place.rooms is not None
    assert gone.things.place.rooms.words == "private office"


def test_everything_else_in_a_room_stays(furnished_state: SceneState) -> None:
    (gone,) = _statements("Remove the fridge. Everything else in the kitchen stays as it is.", furnished_state)
    assert isinstance(gone, Remove)


@pytest.mark.parametrize("words", [" with a piano", ", must contain a piano", " w/ a piano"])
def test_a_room_that_becomes_another_holds_what_is_named(furnished_state: SceneState, words: str) -> None:
    furnished, there = _statements(f"Make the kitchen a music room{words}.", furnished_state)
    assert isinstance(furnished, Furnish) and isinstance(there, Ensure) and there.things.noun == "piano"
    assert there.place.rooms is not None and there.place.rooms.same


def test_what_is_included_goes_with_the_furniture(furnished_state: SceneState) -> None:
    told = _statements("kitchen: clear all furniture incl. plate, hall untouched", furnished_state)
    assert [s.things.noun for s in told if isinstance(s, Remove)] == ["furniture", "plate"]
    assert isinstance(told[-1], Keep)


def test_a_number_that_includes_others_is_not_understood(furnished_state: SceneState) -> None:
    assert read_instruction("Add 4 chairs incl. 1 armchair to the hall.", furnished_state).not_understood
