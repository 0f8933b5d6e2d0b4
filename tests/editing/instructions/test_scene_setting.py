"""Sentences that tell where things are before something is asked of them, in whatever words it takes them up."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Mention, Move, Statement, Swap, Things
from mansion_editing.state import SceneState


def _asked(text: str, state: SceneState) -> list[Statement]:
    instruction = read_instruction(text, state)
    assert instruction.not_understood == []
    return [statement for statement in instruction.statements if not isinstance(statement, Mention)]


def _room_of(things: Things) -> str:
    place = things.place
    assert place is not None
    rooms = place.rooms or (place.anchor.place.rooms if place.anchor is not None and place.anchor.place else None)
    return "" if rooms is None else rooms.words


@pytest.mark.parametrize(
    "text",
    [
        "Somebody left a plate on the dining table in the kitchen. I'd rather have that plate on the sofa in the hall.",
        "One of the kids has put a plate on the kitchen's dining table. Please bring it to the sofa in the hall.",
        "There's a plate on the dining table in the kitchen. Put that plate on the sofa in the hall.",
        "The plate lies on the dining table in the kitchen, but tonight it sleeps on the sofa in the hall.",
        "In the kitchen the dining table has a plate on it. Take it to the sofa in the hall.",
    ],
)
def test_what_was_told_of_is_moved_and_nothing_is_added(editor: SceneEditor, text: str) -> None:
    count = len(list(editor.state.objects()))
    assert instruct(editor, text).done
    plates = [item for _, item in editor.state.objects() if item.category == "plate"]
    assert [item.parent for item in plates] == ["F1/hall/sofa_1"] and len(list(editor.state.objects())) == count


@pytest.mark.parametrize("pair", ["both", "them", "the two", "these two"])
@pytest.mark.parametrize(
    "told",
    [
        "On the dining table in the kitchen there are a plate and a mug.",
        "A plate and a mug are standing on the dining table in the kitchen.",
        "Somebody forgot a plate and a mug on the dining table in the kitchen.",
        "The dining table in the kitchen has a plate and a mug on it.",
    ],
)
def test_a_pronoun_for_several_means_each_that_was_told_of(furnished_state: SceneState, told: str, pair: str) -> None:
    asked = _asked(f"{told} Move {pair} to the hall.", furnished_state)
    assert [s.things.noun for s in asked if isinstance(s, Move)] == ["plate", "mug"]
    assert [_room_of(s.things) for s in asked if isinstance(s, Move)] == ["kitchen", "kitchen"]


def test_what_is_carried_and_put_down_goes_to_one_place(furnished_state: SceneState) -> None:
    text = (
        "The dining table in the kitchen has a plate and a mug on it. Take both to the hall and put them on the sofa."
    )
    asked = _asked(text, furnished_state)
    assert len(asked) == 2
    for statement in asked:
        assert isinstance(statement, Move) and statement.place.anchor is not None
        assert statement.place.rooms is not None and statement.place.rooms.words == "hall"


@pytest.mark.parametrize(
    "text",
    [
        "The kitchen has a plate and the private office has a mug. Swap these two.",
        "The kitchen works with a plate and the private office with a mug. Swap them.",
        "There is a plate in the kitchen and a mug in the private office. Let these two change places.",
        "There is a plate in the kitchen and a mug in the private office. Swap the two, so that each is where the other"
        " one was.",
    ],
)
def test_two_that_were_told_of_change_places(furnished_state: SceneState, text: str) -> None:
    (statement,) = _asked(text, furnished_state)
    assert isinstance(statement, Swap) and isinstance(statement.one, Things) and isinstance(statement.other, Things)
    assert (statement.one.noun, _room_of(statement.one)) == ("plate", "kitchen")
    assert (statement.other.noun, _room_of(statement.other)) == ("mug", "private office")


@pytest.mark.parametrize(
    "text",
    [
        "Swap these two.",
        "The gizmo lives in the fridge in the kitchen. Put it on the sofa in the hall.",
        "Put a mug on the sofa in the hall, switched on so I can find it.",
    ],
)
def test_what_is_not_told_surely_is_refused(editor: SceneEditor, text: str) -> None:
    assert not instruct(editor, text).done


@pytest.mark.parametrize(
    "told",
    [
        "Mr. Smith in the private office is thirsty.",
        "Our guest sleeps in the private office.",
        "Dr. Miller in private office 1, second floor, wants to read.",
    ],
)
def test_the_desk_of_somebody_is_in_the_room_that_was_told(furnished_state: SceneState, told: str) -> None:
    (statement,) = _asked(f"{told} Put a glass on his desk.", furnished_state)
    place = getattr(statement, "place", None)
    assert place is not None and place.rooms is not None and place.rooms.words.startswith("private office")


def test_what_is_added_there_comes_where_the_scene_was(furnished_state: SceneState) -> None:
    text = "There is a plate and a mug on the dining table in the kitchen. Remove both and put two glasses there."
    *_, added = _asked(text, furnished_state)
    place = getattr(added, "place", None)
    assert place is not None and place.anchor is not None and place.anchor.noun == "dining table"


def test_orders_for_the_things_of_somebody_are_no_remarks(furnished_state: SceneState) -> None:
    text = "Mr. Smith sits in the private office. Turn on his floor lamp. Put a plant in the hall."
    assert len(_asked(text, furnished_state)) == 2


def test_the_room_of_nobody_is_not_guessed(editor: SceneEditor) -> None:
    assert not instruct(editor, "Put a plant in his room.").done


def test_what_comes_instead_of_a_thing_only_told_of_is_not_guessed(furnished_state: SceneState) -> None:
    told = "Nobody likes the plate on the dining table, put a bowl there instead."
    assert read_instruction(told, furnished_state).not_understood == ["put a bowl there"]
    asked = "Remove the plate from the dining table and put a bowl there instead."
    assert read_instruction(asked, furnished_state).not_understood == []
