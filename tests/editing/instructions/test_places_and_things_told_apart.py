"""Places and things in the words that people use for them: storeys, sides, spots where something stood, floors."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.places import read_place
from mansion_editing.instructions.phrases.unnamed_places import read_former_spot
from mansion_editing.instructions.phrases.words import split_words
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Clear, Ensure, Move, Place, Remove, Replace, SetState
from mansion_editing.state import SceneState


def _place(state: SceneState, text: str) -> Place:
    lexicon = Lexicon(state)
    words = split_words(text, lexicon.speller, lexicon.kept)
    read = read_place(words, 0, lexicon, tuple(state.floors))
    assert read is not None and read.end == len(words)
    return read.place


def test_a_storey_stands_before_a_name_of_several_words(state: SceneState) -> None:
    rooms = _place(state, "in the second floor private office").rooms
    assert rooms is not None and rooms.words == "private office" and rooms.floors == (2,)


def test_the_floor_of_a_room_is_a_place(state: SceneState) -> None:
    for text in ("on the floor of the kitchen", "on the kitchen floor"):
        place = _place(state, text)
        assert place.on_floor and place.rooms is not None and place.rooms.words == "kitchen"


@pytest.mark.parametrize("text", ["where it stood", "in its old place", "in the spot where it stood"])
def test_a_place_is_told_by_what_stood_there(state: SceneState, text: str) -> None:
    lexicon = Lexicon(state)
    found = read_former_spot(split_words(text, lexicon.speller, lexicon.kept), 0, lexicon, (1, 2))
    assert found is not None and found[0].refers == "last"


def test_a_mark_between_two_things_on_furniture_may_come_after_a_comma(state: SceneState) -> None:
    (statement,) = read_instruction("put a mug on the dining table, between the two glasses", state).statements
    assert isinstance(statement, Add) and statement.place.relation == "between"
    anchor = statement.place.anchor
    assert anchor is not None and anchor.place is not None and anchor.place.relation == "on"


def test_the_left_one_is_told_by_its_side(state: SceneState) -> None:
    (statement,) = read_instruction("put a mug on the left dining table in the kitchen", state).statements
    assert isinstance(statement, Add) and statement.place.anchor is not None
    assert statement.place.anchor.hints == ("left",)


def test_what_comes_where_something_stood_replaces_it(state: SceneState) -> None:
    text = "remove the dining table in the kitchen and put a plant where it stood"
    (statement,) = read_instruction(text, state).statements
    assert isinstance(statement, Replace) and statement.by.noun == "plant"


def test_which_one_moves_may_be_told_afterwards(state: SceneState) -> None:
    text = "Move the mug to the hall. There are two, take the one from the dining table."
    statements = [s for s in read_instruction(text, state).statements if isinstance(s, Move | Remove)]
    (statement,) = statements
    assert isinstance(statement, Move) and statement.things.place is not None


def test_only_what_may_stay_is_spared(state: SceneState) -> None:
    for text in (
        "Clear the dining table: only the mug, the plate and one glass may stay.",
        "Clear the dining table, only the plate may stay.",
        "Only the plate may stay on the dining table.",
    ):
        instruction = read_instruction(text, state)
        (statement,) = instruction.statements
        assert not instruction.not_understood and isinstance(statement, Clear) and statement.spare


def test_what_may_stay_is_never_dropped(editor: SceneEditor) -> None:
    report = instruct(editor, "Clear the dining table in the kitchen, only the plate may stay.")
    assert report.done and "F1/kitchen/plate_1" not in report.object_ids


def test_nothing_is_put_on_a_counter_top_for_what_lies_on_top(state: SceneState) -> None:
    statements = read_instruction("Dining table in the kitchen: mug on top.", state).statements
    told = [s for s in statements if isinstance(s, Add | Ensure)]
    assert len(told) == 1 and told[0].place.anchor is not None and told[0].place.anchor.noun != "top"


def test_all_that_came_to_each_place_has_a_state(state: SceneState) -> None:
    statements = read_instruction("Candle on each table, lit.", state).statements
    assert isinstance(statements[-1], SetState) and statements[-1].things.amount.kind == "all"


def test_things_come_to_a_place_and_are_put_together(state: SceneState) -> None:
    first, second = read_instruction("put both mugs on the dining table next to each other", state).statements
    assert isinstance(first, Move) and first.place.relation == "on"
    assert isinstance(second, Move) and second.things.refers == "last"


def test_a_colour_alone_is_no_vegetable(state: SceneState) -> None:
    assert "lettuce" not in str(read_instruction("put a chair in the hall, green", state).statements)


def test_chairs_go_along_with_the_one_table_that_is_chosen(editor: SceneEditor) -> None:
    before = {item.id for _, item in editor.state.objects() if item.category == "chair"}
    report = instruct(editor, "Remove one dining table and its chairs.")
    after = {item.id for _, item in editor.state.objects() if item.category == "chair"}
    assert not report.done or before - after != before


def test_one_new_thing_comes_for_both(state: SceneState, editor: SceneEditor) -> None:
    report = instruct(editor, "Replace both mugs in the private office with one glass.")
    assert report.done
    made = [item for _, item in editor.state.objects() if item.category == "glass" and item.room.startswith("F2")]
    assert len(made) == 1


def test_what_only_some_of_the_things_meant_can_do_is_refused(editor: SceneEditor) -> None:
    report = instruct(editor, "Switch both mugs on the dining table on.")
    assert not report.done


def test_what_is_in_furniture_goes_to_other_furniture(state: SceneState) -> None:
    (statement,) = read_instruction("put the mug in the fridge on the dining table", state).statements
    assert isinstance(statement, Move) and statement.things.place is not None
    assert statement.things.place.anchor is not None and statement.things.place.anchor.noun == "fridge"
    assert statement.place.anchor is not None and statement.place.anchor.noun == "dining table"


def test_chairs_go_beside_the_table_that_they_belong_to(state: SceneState) -> None:
    (statement,) = read_instruction("The chair in the hall goes to the dining table in the kitchen.", state).statements
    assert isinstance(statement, Move) and statement.place.relation == "beside"


def test_a_room_at_the_beginning_is_that_of_a_window(state: SceneState) -> None:
    (statement,) = read_instruction("In the hall, move the chair to the window.", state).statements
    assert isinstance(statement, Move) and statement.place.spot == "window" and statement.place.rooms is not None
