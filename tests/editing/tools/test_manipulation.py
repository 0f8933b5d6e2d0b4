"""SetState of doors, which scenes keep open or closed."""

from collections.abc import Callable

import pytest

from mansion_editing.editor import SceneEditor
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import Door


def _door(editor: SceneEditor, name: str) -> Door:
    return next(door for scene in editor.store.scenes().values() for door in scene.doors if door.id == name)


def test_a_door_closes_and_undo_opens_it_again(open_editor: Callable[..., SceneEditor]) -> None:
    editor = open_editor()
    editor.call("SetState", {"object_id": "F1/door_1", "open": False})
    assert not _door(editor, "F1/door_1").is_open
    editor.call("Undo")
    assert _door(editor, "F1/door_1").is_open


def test_a_door_closes_together_with_what_waits_on_its_floor(open_editor: Callable[..., SceneEditor]) -> None:
    editor = open_editor(autosave=False)
    editor.call("SetState", {"object_id": "F1/kitchen/fridge_1", "open": True})
    editor.call("SetState", {"object_id": "F1/door_1", "open": False})
    editor.call("RemoveObject", {"object_id": "F1/kitchen/mug_1"})
    editor.call("Save")
    scene = editor.store.scenes()[1]
    assert not _door(editor, "F1/door_1").is_open
    assert {item.id: item.states.get("open") for item in scene.objects}["F1/kitchen/fridge_1"] is True
    assert "F1/kitchen/mug_1" not in {item.id for item in scene.objects}


def test_a_door_does_not_switch(open_editor: Callable[..., SceneEditor]) -> None:
    with pytest.raises(MansionError, match="a door is open or closed"):
        open_editor().call("SetState", {"object_id": "F1/door_1", "on": True})
