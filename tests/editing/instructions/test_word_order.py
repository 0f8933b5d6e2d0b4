"""Sentences in an uncommon order, lists that sum up and further rooms of an exception are read as what they ask for."""

import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import (
    JOINED,
    Add,
    Clear,
    Ensure,
    Finish,
    Furnish,
    Move,
    Paint,
    Remove,
    Rename,
    Statement,
)
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
        ("Clear the dining table in the kitchen: plates, mugs, the lot.", "Clear the dining table in the kitchen."),
        ('Can we from now on call the kitchen "Mess"?', 'Can we call the kitchen "Mess"?'),
        (
            "Put a vase on the dining table. The kitchen I mean, not the office.",
            "Put a vase on the dining table. Sorry, I meant the kitchen.",
        ),
        (
            "Put a vase on the dining table. I mean the kitchen, not the office.",
            "Put a vase on the dining table. Sorry, I meant the kitchen.",
        ),
        ("In the hall hangs no clock. Add one.", "In the hall there is no clock. Add one."),
        ("Add a clock in the hall, as in the other rooms.", "Add a clock in the hall."),
        ("The kitchen needs a wooden floor, could you see to it?", "The kitchen needs a wooden floor, please?"),
        (
            "Stools instead of chairs around the dining table in the kitchen: remove the chairs, put two stools there.",
            "Around the dining table in the kitchen: remove the chairs, put two stools there.",
        ),
        ("Lamp instead of vase: remove the vase in the hall, add a lamp.", "Remove the vase in the hall, add a lamp."),
        ("sofa: from hall to office", "move sofa from hall to office"),
        ("The sofa: from the hall to the office.", "Move the sofa from the hall to the office."),
        ("sofa -> blue, every single one in the building", "sofa -> blue"),
        ("The kitchen becomes a gym: rename it to Gym.", "Rename the kitchen to Gym."),
        ('The kitchen becomes a gym: change its name to "Gym".', 'Rename the kitchen to "Gym".'),
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


def test_every_one_in_a_room_is_not_every_one_of_the_building(furnished_state: SceneState) -> None:
    assert read_instruction("Paint the chairs blue, every single one in the hall.", furnished_state).not_understood


def test_a_room_that_is_told_to_move_is_not_understood(furnished_state: SceneState) -> None:
    assert read_instruction("kitchen: from hall to office", furnished_state).not_understood


@pytest.mark.parametrize("name", ["rename it to Den", "call it a day", "rename them to Den"])
def test_only_a_room_that_was_told_takes_a_name(furnished_state: SceneState, name: str) -> None:
    assert read_instruction(f"Put a vase in the hall. {name}.", furnished_state).not_understood


def test_another_name_comes_beside_another_use(furnished_state: SceneState) -> None:
    furnished, named = _bare("The kitchen becomes a gym: rename it to Den.", furnished_state)
    assert isinstance(furnished, Furnish) and isinstance(named, Rename)
    assert named.room == furnished.rooms


def test_a_room_that_is_tidied_is_where_all_after_the_colon_is(furnished_state: SceneState) -> None:
    moved = _bare("Tidy the kitchen: all the mugs on the dining table go into the sink.", furnished_state)[-1]
    assert isinstance(moved, Move)
    assert moved.things.place is not None and moved.things.place.rooms is not None
    assert moved.things.place.rooms.words == "kitchen"


def test_a_number_that_is_denied_makes_the_other_exact(furnished_state: SceneState) -> None:
    (wish,) = _bare("Six chairs around the dining table in the kitchen, not four.", furnished_state)
    assert isinstance(wish, Ensure) and (wish.things.amount.kind, wish.things.amount.number) == ("exactly", 6)


@pytest.mark.parametrize(
    "purpose",
    [
        "so it goes with the one in the hall",
        "so that it matches the curtains",
        "to match the sofa",
        "so that guests needn't bring a blanket",
        "so that they do not have to see the stains",
    ],
)
def test_what_a_colour_is_for_asks_for_nothing_more(furnished_state: SceneState, purpose: str) -> None:
    *_, painted = _bare(f"Paint the sofa in the hall blue {purpose}.", furnished_state)
    assert isinstance(painted, Paint) and painted.colour == "blue"


@pytest.mark.parametrize(
    "purpose", ["so that it matches the sofa in red", "to match", "so that the lamp must not be on"]
)
def test_what_may_ask_for_more_is_named(furnished_state: SceneState, purpose: str) -> None:
    assert read_instruction(f"Paint the sofa in the hall blue {purpose}.", furnished_state).not_understood


@pytest.mark.parametrize("former", ["in place of that grey carpet", "instead of the old tiles"])
def test_a_floor_comes_for_the_one_that_was(furnished_state: SceneState, former: str) -> None:
    *_, floor = _bare(f"The kitchen gets a wooden floor {former}.", furnished_state)
    assert isinstance(floor, Finish) and floor.part == "floor"


def test_a_rug_is_no_floor_that_was(furnished_state: SceneState) -> None:
    assert read_instruction("The kitchen gets a wooden floor instead of the rug.", furnished_state).not_understood


def test_things_that_shall_stand_like_others_are_not_understood(furnished_state: SceneState) -> None:
    assert read_instruction("Move the sofa in the hall like in the other room.", furnished_state).not_understood


def test_a_headline_that_asks_for_other_things_is_not_left_out(furnished_state: SceneState) -> None:
    text = "Stools instead of chairs around the dining table: remove the lamp."
    assert read_instruction(text, furnished_state).not_understood
