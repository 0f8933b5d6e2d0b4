"""Numbers told after what is brought, and limits told after their number."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return instruction.statements


@pytest.mark.parametrize(
    "text",
    [
        "Fill up the fridge with apples, there should be eight at the least.",
        "Stock the fridge with apples, eight or more.",
        "Put apples in the fridge, at the very least eight of them.",
        "There should be eight apples as a minimum in the fridge.",
        "The fridge should hold eight apples at minimum.",
    ],
)
def test_a_limit_may_follow_its_number(furnished_state: SceneState, text: str) -> None:
    (there,) = _asked(text, furnished_state)
    assert isinstance(there, Ensure) and there.things.noun == "apple"
    assert (there.things.amount.kind, there.things.amount.number) == ("at_least", 8)
    assert there.place.anchor is not None and there.place.anchor.noun == "fridge"


@pytest.mark.parametrize("number", ["three", "three of them"])
def test_a_number_after_the_place_is_of_what_is_brought(furnished_state: SceneState, number: str) -> None:
    (added,) = _asked(f"Put apples on the desk in private office 1, {number}.", furnished_state)
    assert isinstance(added, Add) and added.things.amount.number == 3


def test_at_most_so_many_are_brought_all_the_same(editor: SceneEditor) -> None:
    assert instruct(editor, "Fill the fridge with apples, there should be four at the most.").done
    assert sum(item.category == "apple" for _, item in editor.state.objects()) == 4


def test_one_of_those_in_a_room_goes_to_another(editor: SceneEditor) -> None:
    assert instruct(editor, "Bring one of the chairs in the hall to the kitchen.").done
    rooms = [item.room for _, item in editor.state.objects() if item.category == "chair"]
    assert sorted(rooms) == ["F1/hall", "F1/hall", "F1/kitchen"]


@pytest.mark.parametrize("told", ["a law book", "two art books", "fashion magazines"])
def test_what_a_new_book_is_about_is_not_recorded(furnished_state: SceneState, told: str) -> None:
    read = read_instruction(f"Put {told} on the desk in private office 1.", furnished_state)
    assert read.not_understood == [] and read.ignored == [told.split()[-2]]


def test_what_a_book_is_about_does_not_tell_which_goes(furnished_state: SceneState) -> None:
    assert read_instruction("Remove the law books.", furnished_state).not_understood
