"""Rooms with too many things, and how many of them are left; what furniture that is cleared keeps by number."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Clear, Ensure, Mention, Remove, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == [], read.not_understood
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


def _count(editor: SceneEditor, category: str, room: str) -> int:
    return sum(item.category == category and item.room == room for _, item in editor.state.objects())


@pytest.mark.parametrize(
    "text",
    [
        "Three chairs are too much for the hall. Leave two of them.",
        "The hall has far too many chairs, keep only two of them.",
        "We don't need three chairs in the hall, two are enough.",
        "There is one chair too many in the hall, leave two.",
        "There are too many chairs in the hall; leave two.",
        "Keep two of the chairs in the hall.",
        "The hall has too many chairs: two suffice.",
    ],
)
def test_so_many_are_left(editor: SceneEditor, text: str) -> None:
    report = instruct(editor, text)
    assert report.done, report.message
    assert _count(editor, "chair", "F1/hall") == 2


def test_what_is_left_with_them_is_in_the_same_room(furnished_state: SceneState) -> None:
    chairs, lamps = _asked("Three chairs are too many for the hall. Leave two of them, and one lamp.", furnished_state)
    assert isinstance(chairs, Ensure) and isinstance(lamps, Ensure)
    assert chairs.place == lamps.place and chairs.things.amount.kind == lamps.things.amount.kind == "exactly"


def test_what_is_too_many_goes(furnished_state: SceneState) -> None:
    (gone,) = _asked("There are two chairs too many in the hall.", furnished_state)
    assert isinstance(gone, Remove) and gone.things.amount.number == 2


def test_numbers_that_contradict_each_other_are_refused(editor: SceneEditor) -> None:
    report = instruct(editor, "There are two chairs too many in the hall, leave two.")
    assert not report.done and "not 4" in report.message
    assert _count(editor, "chair", "F1/hall") == 3


@pytest.mark.parametrize(
    "text",
    [
        "The hall has too many chairs. Put a plant in the corner.",
        "There are too many chairs in the hall. Switch on the floor lamp.",
        "Three chairs are too many for the hall.",
        "Tidy up the dining table; two plates may stay.",
    ],
)
def test_a_complaint_is_not_passed_over(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood


@pytest.mark.parametrize(
    "text",
    [
        "Clear the dining table in the private office, only one mug should be left on it.",
        "Empty the dining table in the private office except for one mug.",
        "Clear the dining table in the private office; one mug may stay.",
        "Clear the dining table in the private office so that nothing but one mug is left there.",
    ],
)
def test_so_many_stay_of_what_is_cleared(editor: SceneEditor, text: str) -> None:
    report = instruct(editor, text)
    assert report.done, report.message
    assert _count(editor, "mug", "F2/private_office_1") == 1


def test_more_than_there_are_cannot_stay(editor: SceneEditor) -> None:
    report = instruct(editor, "Clear the dining table in the private office except for three mugs.")
    assert not report.done and "there are 2 mugs, not 3" in report.message


def test_what_stays_without_a_number_stays_whole(furnished_state: SceneState) -> None:
    (cleared,) = _asked("Clear the dining table in the kitchen, nothing but the mug may stay on it.", furnished_state)
    assert isinstance(cleared, Clear) and cleared.spare[0].amount.kind == "all"
