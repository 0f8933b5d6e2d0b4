"""What is said beside a request or before it, and what it means for the request."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.paraphrases.reading import read_in_other_words
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Clear, Ensure, Finish, Furnish, Move, Remove, Rename, Swap
from mansion_editing.state import SceneState


def test_what_was_done_is_not_asked_for(furnished_state: SceneState) -> None:
    read = read_in_other_words("The hall was furnished like a nursery. Take the chairs out.", furnished_state)
    assert not any(isinstance(one, Furnish) for one in read.statements)
    assert any(isinstance(one, Remove) for one in read.statements)


def test_a_number_is_put_right(furnished_state: SceneState) -> None:
    read = read_instruction("Put 6 more chairs in the hall. No wait, 5.", furnished_state)
    (added,) = [one for one in read.statements if isinstance(one, Add)]
    assert added.things.amount.number == 5


def test_so_many_are_put_where_none_are(furnished_state: SceneState) -> None:
    read = read_in_other_words("Guests in the hall complained: no towels. Put three on the sofa.", furnished_state)
    assert not any(isinstance(one, Move) for one in read.statements)


def test_those_that_are_there_already_count(furnished_state: SceneState) -> None:
    read = read_in_other_words(
        "Put a mug on every table. One is there already, so that makes two more.", furnished_state
    )
    assert any(isinstance(one, Ensure) and one.each for one in read.statements)


def test_it_may_be_the_room_that_was_renamed(furnished_state: SceneState) -> None:
    renamed, finish = read_instruction("Rename the hall to Den and paint it green.", furnished_state).statements
    assert isinstance(renamed, Rename) and isinstance(finish, Finish) and finish.rooms == renamed.room


def test_it_may_be_what_something_is_swapped_with(furnished_state: SceneState) -> None:
    (swap,) = read_instruction("Swap the sofa with the chair next to it.", furnished_state).statements
    assert isinstance(swap, Swap) and not isinstance(swap.other, type(None))


@pytest.mark.parametrize("text", ["Clear the hall except for the sofa.", "The hall must be empty apart from the sofa."])
def test_a_room_that_only_furniture_stays_in_loses_the_other_furniture(editor: SceneEditor, text: str) -> None:
    read = read_instruction(text, editor.state)
    assert any(isinstance(one, Clear) for one in read.statements)
    assert instruct(editor, text).done
    left = {item.category for _, item in editor.state.objects() if item.room == "F1/hall" and item.mount == "floor"}
    assert "chair" not in left and "sofa" in left


def test_a_list_comes_to_the_last_goal(furnished_state: SceneState) -> None:
    read = read_instruction("Carry the chair near the sofa and the plant over to the kitchen.", furnished_state)
    moves = [one for one in read.statements if isinstance(one, Move)]
    assert all(one.place.rooms is not None and one.place.rooms.words == "kitchen" for one in moves)
