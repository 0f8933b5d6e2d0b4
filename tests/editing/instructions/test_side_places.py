"""Places that stand apart from the rest of a clause, and what is told of a thing before "it"."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, SetState
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    "limit",
    ["not further than 1 metre from", "no more than 1 m away from", "not more than 100 cm from", "within 1 m of"],
)
@pytest.mark.parametrize("joint", [" ", ", "])
def test_the_greatest_distance_is_read(state: SceneState, limit: str, joint: str) -> None:
    instruction = read_instruction(f"add a chair in the kitchen{joint}{limit} the dining table", state)
    assert instruction.not_understood == []
    (statement,) = instruction.statements
    assert isinstance(statement, Add)
    place = statement.place
    assert (place.relation, place.within) == ("near", 1.0) and place.rooms is not None
    assert place.anchor is not None and place.anchor.noun == "dining table"


def test_the_least_distance_is_not_the_greatest(state: SceneState) -> None:
    assert read_instruction("add a chair in the kitchen, not less than 1 m from the dining table", state).not_understood


def test_what_something_faces_may_stand_apart(state: SceneState) -> None:
    instruction = read_instruction("Could we get a chair in the kitchen, facing the fridge?", state)
    assert instruction.not_understood == []
    (statement,) = instruction.statements
    assert isinstance(statement, Add | Ensure) and statement.place.facing is not None
    assert statement.place.facing.noun == "fridge" and statement.place.rooms is not None


def test_the_place_of_it_is_told_once(furnished_state: SceneState) -> None:
    statements = read_instruction("The mug is on the dining table. Open it.", furnished_state).statements
    statement = statements[-1]
    assert isinstance(statement, SetState) and statement.things.place is not None
    assert statement.things.place.anchor is not None and statement.things.place.anchor.place is None


def test_it_is_found_where_it_was_told_to_be(editor: SceneEditor) -> None:
    report = instruct(editor, "The plate is on the dining table. Remove it and open the fridge.")
    assert report.done and report.object_ids == ["F1/kitchen/plate_1", "F1/kitchen/fridge_1"]


@pytest.mark.parametrize("joint", [" ", ", "])
@pytest.mark.parametrize("room", ["", " in the kitchen"])
def test_beside_something_on_a_surface_is_on_that_surface(state: SceneState, joint: str, room: str) -> None:
    instruction = read_instruction(f"put a mug on the dining table{room}{joint}next to the plate", state)
    assert instruction.not_understood == []
    (statement,) = instruction.statements
    assert isinstance(statement, Add)
    place = statement.place
    assert place.relation == "beside" and place.anchor is not None and place.anchor.noun == "plate"
    holder = place.anchor.place
    assert holder is not None and holder.anchor is not None and holder.anchor.noun == "dining table"


def test_one_thing_said_to_be_at_two_places_is_brought_once(editor: SceneEditor) -> None:
    report = instruct(editor, "Put a mug on the dining table in the kitchen, next to the plate.")
    assert report.done and report.object_ids == ["F1/kitchen/mug_2"]


def test_things_are_brought_over_from_where_they_are(editor: SceneEditor) -> None:
    report = instruct(editor, "bring two chairs over from the hall to the kitchen")
    assert report.done and report.object_ids == ["F1/hall/chair_2", "F1/hall/chair_3"]
    assert sum(item.room == "F1/kitchen" and item.category == "chair" for _, item in editor.state.objects()) == 2


@pytest.mark.parametrize("words", ["in one of the corners of the kitchen", "in the kitchen, in a corner"])
def test_any_corner_may_be_meant(state: SceneState, words: str) -> None:
    instruction = read_instruction(f"put a plant {words}", state)
    (statement,) = instruction.statements
    assert isinstance(statement, Add) and statement.place.spot == "corner" and statement.place.rooms is not None
    assert instruction.not_understood == []


@pytest.mark.parametrize(
    "words", ["a chair for the kitchen please, by the window", "a chair for the kitchen, please, by the window"]
)
def test_a_courtesy_parts_no_place_from_its_thing(state: SceneState, words: str) -> None:
    instruction = read_instruction(words, state)
    (statement,) = instruction.statements
    assert isinstance(statement, Add | Ensure) and statement.place.spot == "window"
    assert instruction.not_understood == []


def test_what_each_shall_have_on_it_is_on_each(state: SceneState) -> None:
    (statement,) = read_instruction("Every dining table should have a mug on it.", state).statements
    assert isinstance(statement, Ensure) and statement.each
    assert statement.place.relation == "on" and statement.place.anchor is not None
    assert statement.place.anchor.noun == "dining table"


@pytest.mark.parametrize(
    "mark",
    [
        "opposite to the two which are there",
        "behind the ones that stand there",
        "opposite the existing ones",
        "next to the ones which are already there",
    ],
)
def test_a_mark_after_a_comma_is_of_the_same_kind(furnished_state: SceneState, mark: str) -> None:
    read = read_instruction(f"In the hall we want one more chair, {mark}.", furnished_state)
    (added,) = read.statements
    assert read.not_understood == [] and isinstance(added, Add)
    assert added.place.anchor is not None and added.place.anchor.noun == "chair"


def test_one_beside_several_is_one(editor: SceneEditor) -> None:
    before = sum(1 for _ in editor.state.objects())
    assert instruct(editor, "Put a stool next to the chairs in the hall.").done
    assert sum(1 for _ in editor.state.objects()) == before + 1


@pytest.mark.parametrize(
    "apart", [", same floor (ground floor)", " (same floor)", ", also on the ground floor", ", ground floor"]
)
def test_a_storey_may_stand_after_the_room(furnished_state: SceneState, apart: str) -> None:
    read = read_instruction(f"Put a mug on the dining table in the kitchen{apart}.", furnished_state)
    (added,) = read.statements
    assert read.not_understood == [] and isinstance(added, Add)
    assert added.place.rooms is not None and added.place.rooms.words == "kitchen"


@pytest.mark.parametrize(
    ("where", "relation"), [("on it", "on"), ("in the middle of it", "on"), ("next to it", "beside")]
)
def test_one_it_is_not_several_new_things(furnished_state: SceneState, where: str, relation: str) -> None:
    text = f"Two more chairs at the dining table in the kitchen and a lamp {where}."
    read = read_instruction(text, furnished_state)
    lamp = next(s for s in read.statements if isinstance(s, Add | Ensure) and s.things.noun == "lamp")
    assert read.not_understood == [] and lamp.place.relation == relation
    assert lamp.place.anchor is not None and lamp.place.anchor.noun == "dining table"
