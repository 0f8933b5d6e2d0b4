"""What belongs to furniture, exceptions of places, results of what is brought, and words that would be lost."""

import pytest

from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import (
    Add,
    Ensure,
    Forbid,
    Mention,
    Move,
    Place,
    Remove,
    Replace,
    Rooms,
    SetState,
    Statement,
    Swap,
)
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == [], read.not_understood
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize("joint", ["and", "along with", "together with"])
def test_the_chairs_of_a_table_are_those_around_it_and_go_first(furnished_state: SceneState, joint: str) -> None:
    chairs, table = _asked(f"Remove the dining table {joint} its chairs from the kitchen.", furnished_state)
    assert isinstance(chairs, Remove) and isinstance(table, Remove)
    assert chairs.things.place is not None and chairs.things.place.relation == "around"
    assert table.things.noun == "dining table" and table.things.place == Place(rooms=Rooms(words="kitchen"))


@pytest.mark.parametrize(
    "text",
    [
        "Apart from the mug, move everything from the dining table to the shelf.",
        "Apart from the mug, everything on the dining table should go onto the shelf.",
    ],
)
def test_an_exception_before_a_clause_stays(furnished_state: SceneState, text: str) -> None:
    (moved,) = _asked(text, furnished_state)
    assert isinstance(moved, Move) and [one.noun for one in moved.things.beside] == ["mug"]


def test_an_exception_before_one_thing_is_named(furnished_state: SceneState) -> None:
    assert read_instruction("Apart from the mug, put a plant in the hall.", furnished_state).not_understood


def test_rooms_and_furniture_are_excepted_from_what_each_is_given(furnished_state: SceneState) -> None:
    (rooms,) = _asked("Put a clock in every room except the hall.", furnished_state)
    assert isinstance(rooms, Add) and rooms.place.rooms is not None
    assert rooms.place.rooms.but == (Rooms(words="hall"),)
    (tables,) = _asked("Put an apple on every dining table except the one in the kitchen.", furnished_state)
    assert isinstance(tables, Add) and tables.place.anchor is not None and len(tables.place.anchor.beside) == 1


def test_no_such_thing_comes_to_another_place(furnished_state: SceneState) -> None:
    _, spared = _asked("Put a mug on the dining table, but none on the shelf.", furnished_state)
    assert isinstance(spared, Forbid) and spared.things.noun == "mug"


def test_new_things_come_where_the_next_clause_puts_them(furnished_state: SceneState) -> None:
    (new,) = _asked("Add three plates to the kitchen and lay them on the dining table.", furnished_state)
    assert isinstance(new, Add) and new.place.anchor is not None and new.place.rooms == Rooms(words="kitchen")


def test_companions_stand_before_the_place(furnished_state: SceneState) -> None:
    desk, chair = _asked("Add two desks with a chair each to the hall.", furnished_state)
    assert isinstance(desk, Add) and isinstance(chair, Add)
    assert desk.place == chair.place == Place(rooms=Rooms(words="hall")) and chair.things.amount.number == 2


def test_so_that_there_are_so_many_counts_those_there(furnished_state: SceneState) -> None:
    (chairs,) = _asked("Add chairs to the hall so that there are six.", furnished_state)
    assert isinstance(chairs, Ensure) and chairs.things.amount.number == 6


def test_until_so_many_are_left_takes_all_but_these(furnished_state: SceneState) -> None:
    (gone,) = _asked("Take the chairs out of the hall until only one is left.", furnished_state)
    assert isinstance(gone, Remove) and gone.things.amount.kind == "all_but"


def test_in_each_of_them_are_the_rooms_named_before(furnished_state: SceneState) -> None:
    _, new = _asked("Both offices should have a bin, and I want one plant in each of them.", furnished_state)
    assert isinstance(new, Add) and new.place.rooms is not None and new.place.rooms.words == "office"


def test_what_is_fetched_is_left_somewhere_else(furnished_state: SceneState) -> None:
    (moved,) = _asked("Take the plate out of the kitchen and leave it in the hall.", furnished_state)
    assert isinstance(moved, Move) and moved.place == Place(rooms=Rooms(words="hall"))


@pytest.mark.parametrize(
    "text", ["Give the hall the plate from the kitchen.", "Let the hall have the plate from the kitchen."]
)
def test_what_is_given_from_somewhere_moves(furnished_state: SceneState, text: str) -> None:
    (moved,) = _asked(text, furnished_state)
    assert isinstance(moved, Move) and moved.things.place == Place(rooms=Rooms(words="kitchen"))


def test_one_thing_swaps_places_with_another(furnished_state: SceneState) -> None:
    (swap,) = _asked("The plate in the kitchen should swap places with the chair in the hall.", furnished_state)
    assert isinstance(swap, Swap)


def test_off_with_what_switches_turns_it_off(furnished_state: SceneState) -> None:
    (off,) = _asked("The floor lamp has been on all night; off with it.", furnished_state)
    assert isinstance(off, SetState) and not off.value


def test_what_comes_elsewhere_instead_is_no_replacement(furnished_state: SceneState) -> None:
    gone, new = _asked("I'd like a footstool in front of the sofa instead of the plate.", furnished_state)
    assert isinstance(gone, Remove) and isinstance(new, Add) and not isinstance(new, Replace)


def test_a_later_clause_has_a_place_of_its_own(furnished_state: SceneState) -> None:
    _, gone = _asked("Put a plant in the hall, and in the kitchen remove the plates.", furnished_state)
    assert isinstance(gone, Remove) and gone.things.place == Place(rooms=Rooms(words="kitchen"))


@pytest.mark.parametrize(
    "text",
    [
        "Each office gets one of the three chairs from the hall.",
        "Put the sofa in the hall against the wall opposite the door.",
        "All offices get a plant, only the hall gets three.",
        "We need a plant for the gizmo.",
    ],
)
def test_words_that_no_statement_has_are_named(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood


@pytest.mark.parametrize(
    "text", ["There is one chair too few in the hall, please add it.", "We are one chair short in the hall."]
)
def test_what_is_missing_comes(furnished_state: SceneState, text: str) -> None:
    (new,) = _asked(text, furnished_state)
    assert isinstance(new, Add) and new.place == Place(rooms=Rooms(words="hall")) and new.things.amount.kind == "more"


@pytest.mark.parametrize(
    "text", ["Four chairs for the hall, not five.", "The hall needs four chairs, there are only three."]
)
def test_a_number_told_apart_from_that_which_is_there_is_one_in_all(furnished_state: SceneState, text: str) -> None:
    (chairs,) = _asked(text, furnished_state)
    assert isinstance(chairs, Ensure) and chairs.things.amount.number == 4


def test_none_of_the_rooms_has_what_each_is_given(furnished_state: SceneState) -> None:
    (new,) = _asked("Neither office has a clock, hang one in each of them.", furnished_state)
    assert isinstance(new, Add) and new.place.rooms is not None and new.place.rooms.every


@pytest.mark.parametrize(
    "text", ["We don't want any new plates in the kitchen.", "Don't add any plates in the kitchen."]
)
def test_what_shall_not_come_removes_nothing(furnished_state: SceneState, text: str) -> None:
    (spared,) = _asked(text, furnished_state)
    assert isinstance(spared, Forbid) and spared.things.noun == "plate"


def test_to_empty_a_room_completely_takes_its_furniture_too(furnished_state: SceneState) -> None:
    furniture, _ = _asked("Empty the kitchen completely.", furnished_state)
    assert isinstance(furniture, Remove) and furniture.things.noun == "furniture"
