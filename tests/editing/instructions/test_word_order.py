"""Sentences in an uncommon order, lists that sum up and further rooms of an exception are read as what they ask for."""

import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import JOINED, Add, Clear, Remove, Statement
from mansion_editing.state import SceneState


def _bare(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == []
    return [type(s)(**{f: getattr(s, f) for f in s.__struct_fields__ if f != "quote"}) for s in read.statements]


@pytest.mark.parametrize(
    ("said", "meant"),
    [
        ("Between the hall and the kitchen I want a door.", "I want a door between the hall and the kitchen."),
        ("Between the hall and the kitchen, please add a door.", "Please add a door between the hall and the kitchen."),
        (
            "Both mugs, the one in the hall and the one in the kitchen, should be blue.",
            "The mug in the hall and the mug in the kitchen should be blue.",
        ),
        (
            "The plates on the dining table, the mug too, go into the hall.",
            "The plates and the mug on the dining table go into the hall.",
        ),
        (
            "Clear the dining table in the kitchen: plates, mugs, the lot.",
            "Clear the dining table in the kitchen.",
        ),
        ('Can we from now on call the kitchen "Mess"?', 'Can we call the kitchen "Mess"?'),
        (
            "Put a vase on the dining table. The kitchen I mean, not the office.",
            "Put a vase on the dining table. Sorry, I meant the kitchen.",
        ),
        (
            "Put a vase on the dining table. I mean the kitchen, not the office.",
            "Put a vase on the dining table. Sorry, I meant the kitchen.",
        ),
    ],
)
def test_another_order_is_read_as_the_usual_one(furnished_state: SceneState, said: str, meant: str) -> None:
    assert _bare(said, furnished_state) == _bare(meant, furnished_state)


def test_a_list_that_does_not_sum_up_is_no_clearing_of_all(furnished_state: SceneState) -> None:
    read = read_instruction("Clear the dining table in the kitchen: plates and mugs.", furnished_state)
    cleared = [s for s in read.statements if isinstance(s, Clear)]
    assert read.not_understood or not cleared


def test_both_with_a_single_one_named_is_not_two(furnished_state: SceneState) -> None:
    read = read_instruction("Both mugs, the one in the hall, should be blue.", furnished_state)
    assert read.not_understood


@pytest.mark.parametrize(
    "exception",
    [
        "those in the hall and in the kitchen",
        "those in the hall and the kitchen",
        "the ones in the kitchen and in the hall",
    ],
)
def test_an_exception_goes_on_in_further_rooms(furnished_state: SceneState, exception: str) -> None:
    (removed,) = _bare(f"Remove all chairs, apart from {exception}.", furnished_state)
    assert isinstance(removed, Remove)
    assert {one.noun for one in removed.things.beside} == {"chair"}
    rooms = [one.place.rooms.words for one in removed.things.beside if one.place and one.place.rooms]
    assert set(JOINED.join(rooms).split(JOINED)) == {"hall", "kitchen"}


def test_an_excepted_thing_after_a_room_is_no_further_room(furnished_state: SceneState) -> None:
    (removed,) = _bare("Remove all chairs, except those in the hall and the lamp.", furnished_state)
    assert isinstance(removed, Remove)
    assert [one.noun for one in removed.things.beside] == ["chair", "lamp"]


def test_a_place_between_two_things_is_not_where_a_door_comes(furnished_state: SceneState) -> None:
    (added,) = _bare("Put a plant between the sofa and the desk.", furnished_state)
    assert isinstance(added, Add) and added.things.noun == "plant"
