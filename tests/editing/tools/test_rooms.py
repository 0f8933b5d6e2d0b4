"""Rooms are renamed, finished and cleared; their program and room graph follow."""

from collections.abc import Callable
from pathlib import Path

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.state import SceneState
from mansion_editing.tools.finishes import finish_named
from mansion_editing.tools.perception import find_rooms
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene, SceneRoom

EditorFactory = Callable[..., SceneEditor]
KITCHEN = "F1/kitchen"


def _room(editor: SceneEditor, room_id: str = KITCHEN) -> SceneRoom:
    found = editor.state.room(room_id)
    assert found is not None
    return found[1]


def _scene(editor: SceneEditor) -> FloorScene:
    return editor.state.scenes[1]


def test_a_renamed_room_goes_by_its_new_and_its_old_name(open_editor: EditorFactory, folder: Path) -> None:
    editor = open_editor()
    for name in ("Canteen", "The Trough"):
        result = editor.call("RenameRoom", {"room_id": KITCHEN, "name": name})
        assert result.saved and result.room_ids == [KITCHEN] and result.object_ids == []
    room = _room(editor)
    assert (room.id, room.name, room.aliases) == (KITCHEN, "The Trough", ["Kitchen", "Canteen"])
    for words in ("the trough", "canteen", "kitchen", KITCHEN):
        assert [found.id for _, found in find_rooms(editor.state, words)] == [KITCHEN]
    (program,) = [r for r in BuildingFolder(folder).building.program.floors[0].rooms if r.id == "kitchen"]
    assert (program.name, program.aliases) == ("The Trough", ["Kitchen", "Canteen"])


def test_an_old_name_that_is_taken_up_again_is_no_other_name(open_editor: EditorFactory) -> None:
    editor = open_editor()
    for name in ("Canteen", "Kitchen"):
        editor.call("RenameRoom", {"room_id": KITCHEN, "name": name})
    assert _room(editor).aliases == ["Canteen"]


@pytest.mark.parametrize(
    ("name", "code"), [(" ", "INVALID_PAYLOAD"), ("a\x07b", "INVALID_PAYLOAD"), ("HALL", "CONFLICT")]
)
def test_names_are_printable_and_one_room_s_on_a_floor(open_editor: EditorFactory, name: str, code: str) -> None:
    editor = open_editor()
    with pytest.raises(MansionError) as error:
        editor.call("RenameRoom", {"room_id": KITCHEN, "name": name})
    assert error.value.code == code and editor.store.log() == []


def test_walls_change_on_the_side_of_the_room_alone(open_editor: EditorFactory) -> None:
    editor = open_editor()
    editor.call("SetFinish", {"room_id": "the kitchen", "part": "walls", "color": "blue"})
    shared, outer = _scene(editor).walls
    assert (shared.left_material, shared.right_material) == ("white_drywall", "blue_drywall")
    assert (outer.left_material, outer.right_material) == ("blue_drywall", "facade_render")
    assert _room(editor).wall_material == "blue_drywall"
    assert _room(editor, "F1/hall").wall_material == "white_drywall"


def test_a_finish_is_told_to_program_and_room_graph(open_editor: EditorFactory, folder: Path) -> None:
    editor = open_editor()
    editor.call("SetFinish", {"room_id": KITCHEN, "part": "floor", "material": "oak parquet"})
    read = BuildingFolder(folder)
    material = _room(editor).floor_material
    assert material == "herringbone_oak"
    assert next(r for r in read.building.program.floors[0].rooms if r.id == "kitchen").floor_material == material
    assert next(n for n in read.topology(1).nodes if n.id == "kitchen").floor_material == material


@pytest.mark.parametrize(
    ("use", "material", "color", "present", "name"),
    [
        ("wall", "", "blue", "white_ceramic", "blue_drywall"),
        ("wall", "tiles", "blue", "", "blue_wall_tiles"),
        ("wall", "red_brick", "", "", "red_brick"),
        ("wall", "red brick", "", "", "red_brick"),
        ("floor", "", "blue", "grey_carpet", "blue_carpet"),
        ("floor", "", "dark", "oak_hardwood", "dark_hardwood"),
        ("floor", "carpet", "navy", "", "blue_carpet"),
        ("ceiling", "acoustic tiles", "", "", "acoustic_ceiling"),
    ],
)  # fmt: skip
def test_words_name_materials(use: str, material: str, color: str, present: str, name: str) -> None:
    assert finish_named(use, material, color, present).name == name  # type: ignore[arg-type]


@pytest.mark.parametrize(("material", "color"), [("velvet", ""), ("marble", "green"), ("", "purple")])
def test_a_finish_that_there_is_not_is_refused_with_those_that_there_are(material: str, color: str) -> None:
    with pytest.raises(MansionError, match=r"there are .*white_ceramic") as error:
        finish_named("floor", material, color, "oak_hardwood")
    assert error.value.code == "INFEASIBLE"


def test_a_cleared_room_keeps_what_is_fixed(open_editor: EditorFactory) -> None:
    editor = open_editor()
    assert editor.call("ClearRoom", {"room_id": "F1/hall"}).object_ids == ["F1/hall/sofa_1"]
    assert [item.id for item in _scene(editor).objects if item.room == "F1/hall"] == ["F1/hall/smoke_detector_1"]
    assert editor.call("ClearRoom", {"room_id": "F1/hall"}).message == "F1/hall holds nothing loose"
    assert len(editor.call("ClearRoom", {"room_id": KITCHEN}).object_ids) == 3


def test_a_lamp_s_light_goes_with_it(open_editor: EditorFactory) -> None:
    editor = open_editor()
    office = "F2/private_office_1"
    assert [light.id for light in editor.state.scenes[2].lights if "lamp_light" in light.id] == [
        f"{office}/lamp_light_1"
    ]
    editor.call("ClearRoom", {"room_id": office})
    assert not [light.id for light in editor.state.scenes[2].lights if "lamp_light" in light.id]


@pytest.mark.parametrize(("words", "code"), [("ballroom", "NOT_FOUND"), ("", "NOT_FOUND"), ("stair_1", "NOT_FOUND")])
def test_a_room_that_there_is_not_is_refused_with_the_rooms(state: SceneState, words: str, code: str) -> None:
    from mansion_editing.tools.rooms import room_named

    with pytest.raises(MansionError, match=KITCHEN) as error:
        room_named(state, words)
    assert error.value.code == code
