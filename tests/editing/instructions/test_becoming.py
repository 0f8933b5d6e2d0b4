"""Rooms that become others, and what is loaded onto or into something."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Furnish, Keep, Mention, Move, Remove, Rename, Statement
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    read = read_instruction(text, state)
    assert read.not_understood == [], read.not_understood
    return [statement for statement in read.statements if not isinstance(statement, Mention)]


@pytest.mark.parametrize(
    ("text", "kind"),
    [
        ("The private office becomes a library.", "library"),
        ("The private office turns into a music room.", "music room"),
        ("The private office is now going to be a meeting room.", "meeting room"),
        ("The private office shall be a quiet zone.", "quiet zone"),
        ("Turn the private office into a movement room.", "movement room"),
        ("The private office becomes the new staff lounge.", "staff lounge"),
    ],
)
def test_a_room_becomes_another(furnished_state: SceneState, text: str, kind: str) -> None:
    (turned,) = _asked(text, furnished_state)
    assert isinstance(turned, Furnish) and turned.kind == kind


@pytest.mark.parametrize(
    "text",
    [
        "The private office becomes a movement room. Remove the desk from it and lay out two yoga mats.",
        "The private office becomes a sleeping room: take the desk out and put a single bed in.",
        "The private office is to be a guest room: the desk goes, two single beds come in.",
    ],
)
def test_a_list_tells_what_changes_in_it(editor: SceneEditor, text: str) -> None:
    renamed, *_ = _asked(text, editor.state)
    assert isinstance(renamed, Rename)
    report = instruct(editor, text)
    assert report.done, report.message
    there = {item.category for _, item in editor.state.objects() if item.room == "F2/private_office_1"}
    assert "office_desk" not in there and "floor_lamp" in there and there & {"yoga_mat", "single_bed", "bed"}


def test_what_comes_and_goes_without_a_list_is_no_whole_room(furnished_state: SceneState) -> None:
    text = "Turn the private office into a music room. Remove the floor lamp and put in a piano."
    furnished, *_ = _asked(text, furnished_state)
    assert isinstance(furnished, Furnish)


@pytest.mark.parametrize(
    "text", ["The air becomes bad in the kitchen.", "The desk becomes an office.", "The hall is a library."]
)
def test_not_all_that_becomes_is_a_room(furnished_state: SceneState, text: str) -> None:
    assert read_instruction(text, furnished_state).not_understood


@pytest.mark.parametrize(
    "text",
    [
        "Load the plate from the dining table onto the desk.",
        "Pack the plate from the dining table into the fridge.",
        "Stow the plate in the fridge.",
        "Fill the plate into the fridge.",
    ],
)
def test_what_is_loaded_moves(furnished_state: SceneState, text: str) -> None:
    (moved,) = _asked(text, furnished_state)
    assert isinstance(moved, Move) and moved.things.noun == "plate"


def test_what_opens_is_loaded_inside(furnished_state: SceneState) -> None:
    added = _asked("Load the fridge with two bottles of milk and an apple.", furnished_state)
    assert all(isinstance(one, Add) and one.place.relation == "in" for one in added)


def test_something_that_comes_in_needs_a_room(editor: SceneEditor) -> None:
    assert not instruct(editor, "Put two chairs in.").done


def test_what_stays_is_not_what_another_clause_names_more_closely(furnished_state: SceneState) -> None:
    moved, kept = _asked(
        "Move the two stacks of books from the desk to the dining table. The book stays.", furnished_state
    )
    assert isinstance(moved, Move) and moved.things.noun == "book stack"
    assert isinstance(kept, Keep) and [one.noun for one in kept.things.beside] == ["book stack"]


def test_what_goes_from_furniture_in_a_room_may_go_elsewhere(furnished_state: SceneState) -> None:
    text = "Take the plate from the dining table in the kitchen on the first floor to the desk in the private office."
    (moved,) = _asked(text, furnished_state)
    assert isinstance(moved, Move) and moved.things.place is not None and moved.things.place.rooms is not None
    assert moved.things.place.rooms.words == "kitchen" and not isinstance(moved, Remove)
