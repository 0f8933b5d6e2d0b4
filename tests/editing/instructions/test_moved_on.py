"""Several things that are moved together, and what holds others where it is itself put."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Add, Ensure, Move, Remove, Rename, Swap, Things
from mansion_editing.state import SceneState


@pytest.mark.parametrize(
    "text",
    [
        "The mug and the plate on the dining table in the kitchen belong upstairs. Put both on the desk in the office.",
        "The mug and the plate lying on the dining table in the kitchen must go upstairs, put them on the desk there.",
        "The mug and the plate on the dining table in the kitchen belong upstairs. Put the two on the desk.",
    ],
)
def test_all_that_moved_goes_on(editor: SceneEditor, text: str) -> None:
    report = instruct(editor, text)
    assert report.done, report.message
    moved = [i for _, i in editor.state.objects() if i.category in ("mug", "plate") and "office_desk" in str(i.parent)]
    assert sorted(item.category for item in moved) == ["mug", "plate"]


def test_another_number_than_moved_is_refused(editor: SceneEditor) -> None:
    told = "The mug and the plate on the dining table in the kitchen belong upstairs."
    assert not instruct(editor, f"{told} Put all three on the desk in private office 1.").done


def test_a_place_after_a_list_is_that_of_all(furnished_state: SceneState) -> None:
    read = read_instruction("The mug and the plate on the dining table belong in the hall.", furnished_state)
    places = [s.things.place for s in read.statements if isinstance(s, Move)]
    assert len(places) == 2 and places[0] == places[1] is not None


def test_furniture_is_not_on_what_small_things_are(furnished_state: SceneState) -> None:
    read = read_instruction("The sofa and the mug on the dining table must go.", furnished_state)
    places = [s.things.place for s in read.statements if isinstance(s, Remove)]
    assert places[0] is None and places[1] is not None


@pytest.mark.parametrize("told", ["bowl", "the bowl"])
def test_what_holds_things_is_put_with_them(editor: SceneEditor, told: str) -> None:
    bowls = {item.id for _, item in editor.state.objects() if item.category == "bowl"}
    report = instruct(editor, f"Apple in a bowl, {told} on the desk in private office 1.")
    assert report.done, report.message
    (bowl,) = [i for _, i in editor.state.objects() if i.category == "bowl" and i.id not in bowls]
    (apple,) = [item for _, item in editor.state.objects() if item.category == "apple"]
    assert apple.parent == bowl.id and bowl.room == "F2/private_office_1"


@pytest.mark.parametrize("text", ["Apple in a bowl, a mug on the desk", "Apple in the bowl, mug on the desk"])
def test_another_thing_has_a_place_of_its_own(furnished_state: SceneState, text: str) -> None:
    assert len(read_instruction(text, furnished_state).statements) == 2


@pytest.mark.parametrize(
    "text",
    [
        "Turn private office 1 into a guest room: the desk with what is on it and the lamp go out, a bed comes in.",
        "Turn private office 1 into a guest room: the desk goes out, a nightstand with a table lamp comes in.",
    ],
)
def test_a_list_after_a_colon_tells_all_that_changes(furnished_state: SceneState, text: str) -> None:
    read = read_instruction(text, furnished_state)
    assert read.not_understood == [] and isinstance(read.statements[0], Rename)
    assert any(isinstance(s, Remove) and s.things.noun == "desk" for s in read.statements)
    assert any(isinstance(s, Add) for s in read.statements)


@pytest.mark.parametrize(
    ("text", "noun", "relation"),
    [
        ("Open the fridge and put inside two apples.", "apple", "in"),
        ("Open the fridge, put in it an apple.", "apple", "in"),
        ("Go to the dining table in the kitchen and put on it a bowl.", "bowl", "on"),
        ("Make open the fridge and put inside an apple for the trip.", "apple", "in"),
    ],
)
def test_a_holder_may_come_before_what_is_new(furnished_state: SceneState, text: str, noun: str, relation: str) -> None:
    read = read_instruction(text, furnished_state)
    (added,) = [s for s in read.statements if isinstance(s, Add | Ensure)]
    assert read.not_understood == [] and added.things.noun == noun
    assert added.place.relation == relation and added.place.anchor is not None


@pytest.mark.parametrize(
    "text",
    [
        "The sofa in the hall to the kitchen.",
        "The plate in the kitchen goes to the office and the sofa in the hall to the kitchen.",
    ],
)
def test_a_thing_in_a_room_goes_to_another_without_a_verb(furnished_state: SceneState, text: str) -> None:
    moved = read_instruction(text, furnished_state).statements[-1]
    assert isinstance(moved, Move) and moved.things.noun == "sofa"
    assert moved.things.place is not None and moved.things.place.rooms is not None and moved.place.rooms is not None
    assert (moved.things.place.rooms.words, moved.place.rooms.words) == ("hall", "kitchen")


@pytest.mark.parametrize(
    "text",
    ["Move the two mugs in the hall to the kitchen.", "Two of the four mugs in the hall must go to the kitchen."],
)
def test_what_is_not_there_has_not_arrived_either(editor: SceneEditor, text: str) -> None:
    report = instruct(editor, text)
    assert not report.done and "there is no mug" in report.message


@pytest.mark.parametrize(
    "text",
    [
        "Swap the dining tables of the kitchen and private office 1.",
        "Exchange the dining tables in the kitchen and private office 1.",
    ],
)
def test_the_things_of_two_rooms_change_places(furnished_state: SceneState, text: str) -> None:
    (swapped,) = read_instruction(text, furnished_state).statements
    assert isinstance(swapped, Swap) and isinstance(swapped.one, Things) and isinstance(swapped.other, Things)
    rooms = [end.place.rooms.words for end in (swapped.one, swapped.other) if end.place and end.place.rooms]
    assert rooms == ["kitchen", "private office 1"]


@pytest.mark.parametrize(
    "text",
    [
        "Remove the mug from the dining table in the kitchen and put a bowl there.",
        "Put a mug on the dining table in the kitchen and a bowl there.",
    ],
)
def test_what_is_loose_goes_where_the_other_was(editor: SceneEditor, text: str) -> None:
    assert instruct(editor, text).done
    (bowl,) = [item for _, item in editor.state.objects() if item.category == "bowl"]
    assert bowl.parent == "F1/kitchen/dining_table_1"


def test_what_comes_instead_of_what_was_only_told_is_refused(furnished_state: SceneState) -> None:
    text = "Open the fridge. She hates the mug on the dining table in the kitchen, give her a glass there instead."
    assert read_instruction(text, furnished_state).not_understood
