"""Two objects change places with what they carry, or nothing changes."""

from collections.abc import Callable

import pytest

from mansion_bringup.edit_hooks import new_faults
from mansion_editing.editor import SceneEditor
from mansion_msgs_py.errors import MansionError

EditorFactory = Callable[..., SceneEditor]
SOFA, TABLE, FRIDGE, MUG = "F1/hall/sofa_1", "F1/kitchen/dining_table_1", "F1/kitchen/fridge_1", "F1/kitchen/mug_1"
DESK = "F2/private_office_1/office_desk_1"


def _swap(editor: SceneEditor, one: str, other: str) -> list[str]:
    ids: list[str] = editor.call("SwapObjects", {"object_id": one, "other_id": other}).object_ids
    return ids


def test_furniture_changes_rooms_with_what_it_carries(open_editor: EditorFactory) -> None:
    editor = open_editor(validator=new_faults)
    _swap(editor, TABLE, SOFA)
    _, table = editor.state.get(TABLE)
    _, sofa = editor.state.get(SOFA)
    _, mug = editor.state.get(MUG)
    assert (table.room, sofa.room, mug.room) == ("F1/hall", "F1/kitchen", "F1/hall")
    assert table.position[0] == pytest.approx(4.0) and sofa.position[0] == pytest.approx(9.0)
    assert mug.position[:2] == pytest.approx(table.position[:2], abs=1e-3)


def test_small_things_change_surfaces_and_settle(open_editor: EditorFactory) -> None:
    editor = open_editor(validator=new_faults)
    args = {"asset_id": "Apple_1", "receptacle_id": DESK}
    apple = editor.call("PlaceOnSurface", args).object_ids[0]
    ids = _swap(editor, MUG, apple)
    found = {editor.state.get(name)[1].category: editor.state.get(name)[1] for name in ids if editor.state.find(name)}
    assert found["mug"].parent == DESK and found["apple"].parent == TABLE


def test_things_on_one_surface_change_places(open_editor: EditorFactory) -> None:
    editor = open_editor(validator=new_faults)
    args = {"asset_id": "Apple_1", "receptacle_id": TABLE, "near": MUG, "side": "left", "within": 0.2}
    apple = editor.call("PlaceOnSurface", args).object_ids[0]
    before = editor.state.get(MUG)[1].position, editor.state.get(apple)[1].position
    _swap(editor, MUG, apple)
    after = editor.state.get(apple)[1].position, editor.state.get(MUG)[1].position
    for old, new in zip(before, after, strict=True):
        assert new[:2] == pytest.approx(old[:2], abs=0.05)


@pytest.mark.parametrize(
    ("one", "other", "reason"),
    [(TABLE, MUG, "carries the other"), (MUG, SOFA, "does not"), (SOFA, SOFA, "named twice"), (FRIDGE, MUG, "fit")],
)
def test_what_does_not_fit_leaves_all_as_it_was(open_editor: EditorFactory, one: str, other: str, reason: str) -> None:
    editor = open_editor(validator=new_faults)
    before = dict(editor.state.scenes)
    with pytest.raises(MansionError, match=reason):
        _swap(editor, one, other)
    assert editor.state.scenes == before and editor.state.pending == []


def test_a_swap_is_undone_as_one(open_editor: EditorFactory) -> None:
    editor = open_editor(validator=new_faults)
    before = {item.id: item.position for item in editor.state.scenes[1].objects}
    _swap(editor, TABLE, SOFA)
    editor.call("Undo")
    assert {item.id: item.position for item in editor.state.scenes[1].objects} == before
