"""Places and some of several that lack something are each given one; what has one already gets no second."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import (
    Add,
    Ensure,
    Mention,
    Move,
    Place,
    Remove,
    Reshape,
    Rooms,
    SetState,
    Statement,
)
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == [], read.not_understood
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize("lacking", ["that has none yet", "which does not have one", "that doesn't have a mug"])
def test_one_for_each_that_has_none_counts_those_there(furnished_state: SceneState, lacking: str) -> None:
    (one,) = _asked(f"Put a mug on every dining table {lacking}.", furnished_state)
    assert isinstance(one, Ensure) and one.each and one.things.amount.number == 1


@pytest.mark.parametrize(
    "text",
    [
        "Put two mugs on every dining table that has none.",
        "Put a red mug on every dining table that has none.",
        "Put a mug on every dining table that has no plate.",
        "Put a mug on the dining table that has none.",
        "Put a mug on every dining table, where the cook eats.",
    ],
)
def test_what_cannot_be_counted_afterwards_is_not_guessed(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood


def test_a_table_that_has_one_gets_no_other(editor: SceneEditor) -> None:
    before = {item.id for _, item in editor.state.objects()}
    report = instruct(editor, "Put a plate on every dining table that has none yet.")
    assert report.done, report.message
    new = [item for _, item in editor.state.objects() if item.id not in before]
    assert [item.id.split("/")[1] for item in new] == ["private_office_1"]


def test_what_is_there_already_is_only_told(furnished_state: SceneState) -> None:
    (move,) = _asked("Move the plate onto the desk, where there is already one.", furnished_state)
    assert isinstance(move, Move)


@pytest.mark.parametrize("text", ["We want a door between the hall and the kitchen, can you add one?",
                                  "I would like a door between the hall and the kitchen."])  # fmt: skip
def test_a_door_can_be_wished_for(furnished_state: SceneState, text: str) -> None:
    (door,) = _asked(text, furnished_state)
    assert isinstance(door, Reshape) and door.what == "door"


@pytest.mark.parametrize(("said", "sign"), [("a little larger", 1), ("a bit bigger", 1), ("slightly smaller", -1)])
def test_a_little_is_a_share_of_the_area(furnished_state: SceneState, said: str, sign: int) -> None:
    (change,) = _asked(f"Make the kitchen {said}.", furnished_state)
    assert isinstance(change, Reshape) and change.share * sign > 0 and change.area == 0


def test_much_larger_says_no_area(furnished_state: SceneState) -> None:
    assert read_instruction("Make the kitchen much larger.", furnished_state).not_understood


def test_a_further_room_after_and_means_the_same_there(furnished_state: SceneState) -> None:
    first, second = _asked("Turn off the ceiling lights in the kitchen and in the hall.", furnished_state)
    assert isinstance(first, SetState) and isinstance(second, SetState) and second.things.place is not None
    assert second.things.place.rooms == Rooms(words="hall") and second.value == first.value


def test_a_number_in_two_rooms_is_not_guessed(furnished_state: SceneState) -> None:
    assert read_instruction("Remove two chairs in the hall and in the kitchen.", furnished_state).not_understood
    assert all(isinstance(s, Remove) for s in _asked("Remove the chairs in the hall and in the kitchen.",
                                                     furnished_state))  # fmt: skip


def test_the_window_of_a_room_is_in_it(furnished_state: SceneState) -> None:
    (chair,) = _asked("Put a chair by the kitchen window.", furnished_state)
    assert isinstance(chair, Add) and chair.place == Place(spot="window", rooms=Rooms(words="kitchen"))


def test_one_for_every_plate_lies_beside_it(furnished_state: SceneState) -> None:
    (mug,) = _asked("A mug for every plate on the table in the kitchen.", furnished_state)
    assert isinstance(mug, Add) and mug.place.relation == "beside" and mug.each


@pytest.mark.parametrize("text", ["mov the plate frm the kitchen to the hall", "pls mov the plate nxt to the mug"])
def test_a_letter_left_out_of_a_short_word_is_mended(furnished_state: SceneState, text: str) -> None:
    (move,) = _asked(text, furnished_state)
    assert isinstance(move, Move) and move.things.noun == "plate"


@pytest.mark.parametrize(
    "text",
    [
        "Every dining table should have a mug. Add one only where it's missing.",
        "Every dining table should have a mug. Some have none yet, add one only where it is missing.",
        "Put a mug on every dining table, but only add one where there is none.",
        "Put a mug on every dining table, add one to those that have none.",
        "Every dining table should have a mug, fill in what is missing.",
    ],
)
def test_filling_in_what_is_missing_counts_those_there(furnished_state: SceneState, text: str) -> None:
    (one,) = _asked(text, furnished_state)
    assert isinstance(one, Ensure) and one.each and one.things.noun == "mug" and one.things.amount.number == 1


@pytest.mark.parametrize(
    "text",
    [
        "Add one only where it's missing.",
        "Every dining table should have two mugs, add one only where it is missing.",
        "Every dining table should have a mug, do not add one where it is missing.",
        "Every dining table should have a mug, add none where it is missing.",
        "Every dining table should have a mug, add one only where it's not missing.",
        "Every dining table should have a mug, add a plate only where it's missing.",
        "Remove the mugs from the dining tables. Add one only where it's missing.",
    ],
)
def test_what_is_to_be_filled_in_must_be_clear(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood


@pytest.mark.parametrize(
    "text",
    [
        "Two of the chairs in the hall have no cup. Put one on each of those.",
        "Two of the chairs in the hall have no cup. Give them one.",
        "Two chairs in the hall lack a cup; put one on each of them.",
        "Two of the three chairs in the hall are without a cup, so put one on both.",
        "Two of the chairs in the hall do not have a cup yet. Please add a cup to each of these.",
    ],
)
def test_those_that_lack_it_are_given_one(furnished_state: SceneState, text: str) -> None:
    read = read_instruction(text, furnished_state)
    (asked,) = [statement for statement in read.statements if not isinstance(statement, Mention)]
    assert read.not_understood == [] and isinstance(asked, Ensure)
    assert (asked.things.noun, asked.each, asked.lacking) == ("cup", True, 2)
    assert asked.place.anchor is not None and asked.place.anchor.noun == "chair"


def _cups(editor: SceneEditor) -> int:
    return sum(item.category == "cup" for _, item in editor.state.objects())


def test_another_number_than_lacks_it_is_refused(editor: SceneEditor) -> None:
    report = instruct(editor, "Two of the chairs in the hall have no cup. Put one on each of those.")
    assert not report.done and "3 have no cup, not 2" in report.message
    assert instruct(editor, "Put a cup on chair 1 in the hall.").done
    assert instruct(editor, "Two of the chairs in the hall have no cup. Put one on each of those.").done
    assert _cups(editor) == 3


@pytest.mark.parametrize("other", ["Remove them.", "Put a plant on each of those.", "Switch them on."])
def test_what_else_is_asked_of_them_is_not_understood(furnished_state: SceneState, other: str) -> None:
    read = read_instruction(f"Two of the chairs in the hall have no cup. {other}", furnished_state)
    assert read.not_understood


@pytest.mark.parametrize(
    "spared",
    [
        "; where there is one already leave it as it is.",
        ". Where there's already one, it stays.",
        ", leave those that have one alone.",
        ", but don't put a second one where there is one already.",
        ", but not where there is one already.",
        "; if a table already has one, that's fine.",
        ". Skip the tables which have one already.",
        "; whatever already has one needs nothing.",
        "; where there's one already you don't need to do anything.",
    ],
)
def test_those_that_have_one_get_no_second(furnished_state: SceneState, spared: str) -> None:
    (statement,) = _asked(f"Put a mug on every dining table{spared}", furnished_state)
    assert isinstance(statement, Ensure) and statement.each
    assert statement.things.noun == "mug" and statement.things.amount.number == 1


@pytest.mark.parametrize("spared", ["if there is one already leave it", "but not where there is one already"])
def test_a_single_place_that_has_one_gets_no_second(furnished_state: SceneState, spared: str) -> None:
    (statement,) = _asked(f"Put a mug on the dining table in the kitchen; {spared}.", furnished_state)
    assert isinstance(statement, Ensure) and not statement.each


@pytest.mark.parametrize(
    "other",
    [
        "where there is one already remove it",
        "where there is one already move it to the hall",
        "where there are two leave one",
        "where there is one already leave nothing",
        "where there is one already it should not stay",
    ],
)
def test_what_else_becomes_of_those_is_not_passed_over(furnished_state: SceneState, other: str) -> None:
    assert read_instruction(f"Put a mug on every dining table; {other}.", furnished_state).not_understood


@pytest.mark.parametrize("amount", ["two mugs", "another mug"])
def test_one_that_is_there_says_nothing_of_other_numbers(furnished_state: SceneState, amount: str) -> None:
    instruction = read_instruction(
        f"Put {amount} on every dining table; where there is one already leave it.", furnished_state
    )
    assert instruction.not_understood and isinstance(instruction.statements[0], Add)
