"""Doors of the building: opened, closed, asked about, and things put by one of them."""

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_editing.instructions.sentences.reader import read_instruction
from mansion_editing.instructions.statements import Move, Reshape, SetState
from mansion_editing.state import SceneState
from mansion_editing.tools.relations import relation_holds


def _closed(editor: SceneEditor) -> list[str]:
    return sorted(door.id for scene in editor.store.scenes().values() for door in scene.doors if not door.is_open)


@pytest.mark.parametrize(
    ("text", "closed"),
    [
        ("Close the kitchen door.", ["F1/door_1"]),
        ("Shut the door between the kitchen and the hall, please.", ["F1/door_1"]),
        ("The door to the private office should be closed.", ["F2/door_1"]),
        ("Close the front door.", ["F1/door_out"]),
        ("Close the door of the kitchen, the other doors remain open.", ["F1/door_1"]),
        ("Shut all doors upstairs.", ["F2/door_1", "F2/door_stair"]),
        ("Shut every door upstairs except the one of the office.", ["F2/door_stair"]),
    ],
)
def test_doors_are_closed_by_the_rooms_that_they_join(editor: SceneEditor, text: str, closed: list[str]) -> None:
    report = instruct(editor, text)
    assert report.done, report.message
    assert _closed(editor) == closed


def test_a_door_of_several_is_asked_about(editor: SceneEditor) -> None:
    report = instruct(editor, "Close the door of the hall.")
    assert not report.done
    assert set(report.candidates) >= {"F1/door_1", "F1/door_out"}
    assert _closed(editor) == []


@pytest.mark.parametrize("text", ["Remove the kitchen door.", "Paint the kitchen door red.", "Close the cellar door."])
def test_doors_are_neither_removed_nor_painted(editor: SceneEditor, text: str) -> None:
    assert not instruct(editor, text).done


def test_closing_a_door_is_undone(editor: SceneEditor) -> None:
    instruct(editor, "Close the kitchen door.")
    assert instruct(editor, "Undo that.").done
    assert _closed(editor) == []


def test_whether_a_door_is_open_is_answered(editor: SceneEditor) -> None:
    assert instruct(editor, "Is the kitchen door open?").message.endswith("is open")


def test_a_new_door_is_not_one_that_opens(furnished_state: SceneState) -> None:
    (statement,) = read_instruction("Add a door between the kitchen and the hall.", furnished_state).statements
    assert isinstance(statement, Reshape)


def test_the_fridge_door_is_the_fridge(furnished_state: SceneState) -> None:
    (statement,) = read_instruction("Close the fridge door.", furnished_state).statements
    assert isinstance(statement, SetState) and statement.things.noun == "fridge"


def test_things_go_by_a_certain_door(editor: SceneEditor) -> None:
    report = instruct(editor, "Put the sofa next to the door to the kitchen.")
    assert report.done, report.message
    sofa = editor.state.get("F1/hall/sofa_1")[1]
    assert relation_holds(editor.state, sofa, spot="door", door="F1/door_1")


def test_a_door_of_another_room_is_no_door_of_this_one(editor: SceneEditor) -> None:
    assert not instruct(editor, "Put the sofa next to the door of the private office.").done


def test_any_door_of_the_room_is_the_door(furnished_state: SceneState) -> None:
    (statement,) = read_instruction("Move the sofa next to the door.", furnished_state).statements
    assert isinstance(statement, Move) and statement.place.spot == "door"
