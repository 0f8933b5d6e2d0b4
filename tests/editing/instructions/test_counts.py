"""How many of what is there stay, go or are enough."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Move, Remove
from mansion_editing.state import SceneState


def _left(editor: SceneEditor, category: str, room: str) -> int:
    return sum(item.category == category and item.room == room for _, item in editor.state.objects())


@pytest.mark.parametrize(
    "text",
    [
        "All but two chairs out of the hall.",
        "Every chair but two has to leave the hall.",
        "Every chair except two must go from the hall.",
        "Remove all chairs but two from the hall.",
        "Only two chairs should remain in the hall.",
        "Only two chairs may stay in the hall.",
        "Two chairs are enough in the hall.",
        "In the hall two chairs will do.",
        "Remove every second chair from the hall.",
        "Remove every other chair from the hall.",
    ],
)
def test_two_of_three_chairs_are_left(editor: SceneEditor, text: str) -> None:
    report = instruct(editor, text)
    assert report.done and _left(editor, "chair", "F1/hall") == 2


@pytest.mark.parametrize(
    "text",
    [
        "Two chairs are not enough in the hall.",
        "Four chairs should stay in the hall.",
        "All chairs but two are in the hall.",
        "Two chairs should remain in the hall.",
    ],
)
def test_no_chair_goes_where_none_is_too_many(editor: SceneEditor, text: str) -> None:
    instruct(editor, text)
    assert _left(editor, "chair", "F1/hall") >= 3


def test_only_what_is_named_is_left_out(editor: SceneEditor) -> None:
    report = instruct(editor, "Remove all mugs but the one in the kitchen.")
    assert report.done and report.object_ids == ["F2/private_office_1/mug_1", "F2/private_office_1/mug_2"]


def test_things_taken_out_go_and_things_carried_over_move(state: SceneState) -> None:
    (gone,) = read_instruction("All chairs out of the hall!", state).statements
    (moved,) = read_instruction("Two chairs out of the hall and into the kitchen.", state).statements
    assert isinstance(gone, Remove) and isinstance(moved, Move)
    assert moved.place.rooms is not None and moved.place.rooms.words == "kitchen"


def test_what_stays_is_the_thing_itself(editor: SceneEditor) -> None:
    report = instruct(editor, "Empty the fridge. Leave the fridge itself.")
    assert report.done and editor.state.find("F1/kitchen/fridge_1") is not None
