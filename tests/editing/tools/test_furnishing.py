"""Rooms are furnished anew by the placer that the editor was given."""

import re
from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

from mansion_assets.catalogue import Catalogue
from mansion_editing.editor import SceneEditor
from mansion_editing.tools.furnishing import room_type_named
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene, SceneObject
from mansion_scene.refurnishing import furnish_room

EditorFactory = Callable[..., SceneEditor]
OFFICE, KITCHEN, HALL = "F2/private_office_1", "F1/kitchen", "F1/hall"


def _in(editor: SceneEditor, room_id: str) -> list[SceneObject]:
    return [item for _, item in editor.state.objects() if item.room == room_id]


def _documents(folder: Path) -> dict[str, bytes]:
    files = [file for file in folder.rglob("*.json") if "edits" not in file.parts]
    return {str(f.relative_to(folder)): re.sub(rb'"revision": \d+', b"", f.read_bytes()) for f in files}


def test_a_room_gets_what_its_type_has(open_editor: EditorFactory, folder: Path) -> None:
    before = _documents(folder)
    editor = open_editor(furnisher=furnish_room)
    result = editor.call("FurnishRoom", {"room_id": KITCHEN})
    categories = {item.category for item in _in(editor, KITCHEN)}
    assert result.saved and len(categories) > 8 and "fridge" in categories
    ids = [item.id for _, item in editor.state.objects()]
    assert len(ids) == len(set(ids))
    editor.call("Undo")
    assert _documents(folder) == before


def test_furnishing_twice_gives_another_arrangement_and_the_same_bytes_again(
    open_editor: EditorFactory, folder: Path
) -> None:
    editor = open_editor(furnisher=furnish_room)

    def stand() -> set[tuple[object, ...]]:
        return {(i.asset, i.position) for i in _in(editor, OFFICE) if i.mount == "floor"}

    editor.call("FurnishRoom", {"room_id": OFFICE})
    first, documents = stand(), _documents(folder)
    editor.call("FurnishRoom", {"room_id": OFFICE})
    assert len(first & stand()) < len(first | stand()) / 2
    for _ in range(2):
        editor.call("Undo")
    editor.call("FurnishRoom", {"room_id": OFFICE})
    assert _documents(folder) == documents


def test_services_and_what_is_to_be_kept_stay_with_what_carries_them(open_editor: EditorFactory) -> None:
    editor = open_editor(furnisher=furnish_room)
    kept = {item.id: item for item in _in(editor, KITCHEN) if item.category in ("dining_table", "mug")}
    editor.call("FurnishRoom", {"room_id": KITCHEN, "keep": ["F1/kitchen/mug_1"]})
    there = {item.id: item for item in _in(editor, KITCHEN)}
    assert {name: there[name] for name in kept} == kept
    assert [item.id for item in there.values() if item.category == "dining_table"] == ["F1/kitchen/dining_table_1"]
    detector = next(item for item in _in(editor, HALL) if item.category == "smoke_detector")
    editor.call("FurnishRoom", {"room_id": HALL})
    assert [item for item in _in(editor, HALL) if item.category == "smoke_detector"] == [detector]


def test_the_robot_starts_where_the_new_furniture_leaves_room(open_editor: EditorFactory) -> None:
    editor = open_editor(furnisher=furnish_room)
    editor.call("FurnishRoom", {"room_id": HALL})
    spawn = editor.state.scenes[1].spawn
    assert spawn is not None and spawn.room == HALL
    near = [i for i in _in(editor, HALL) if i.mount == "floor" and i.size[2] > 0.03]
    assert all(abs(i.position[0] - spawn.x) + abs(i.position[1] - spawn.y) > 0.2 for i in near)


def test_what_a_model_chose_is_no_longer_said_to_be_its_choice(open_editor: EditorFactory, folder: Path) -> None:
    file = folder / "floors/floor_1/scene.json"
    sources = {f"objects/{HALL}": "llm", f"objects/{KITCHEN}": "llm"}
    file.write_bytes(encode_bytes(msgspec.structs.replace(BuildingFolder(folder).scene(1), sources=sources), indent=1))
    before = _documents(folder)
    editor = open_editor(furnisher=furnish_room)
    editor.call("FurnishRoom", {"room_id": HALL})
    assert list(editor.state.scenes[1].sources.values()) == ["rules: furnished anew", "llm"]
    editor.call("Undo")
    assert _documents(folder) == before


def test_another_type_is_told_to_all_documents(open_editor: EditorFactory, folder: Path) -> None:
    before = _documents(folder)
    editor = open_editor(furnisher=furnish_room)
    editor.call("FurnishRoom", {"room_id": OFFICE, "room_type": "conference room"})
    scene: FloorScene = editor.state.scenes[2]
    room = next(room for room in scene.rooms if room.id == OFFICE)
    assert (room.room_type, room.name, room.aliases) == ("meeting_room", "Meeting room", [])
    assert any(item.category == "conference_table" for item in _in(editor, OFFICE))
    read = BuildingFolder(folder)
    program = next(r for r in read.building.program.floors[1].rooms if r.id == "private_office_1")
    node = next(n for n in read.topology(2).nodes if n.id == "private_office_1")
    assert (program.room_type, program.name, node.room_type) == ("meeting_room", "", "meeting_room")
    editor.call("Undo")
    assert _documents(folder) == before


@pytest.mark.parametrize(("name", "after"), [("Neptune", "Neptune"), ("Private offices 1", "Bedroom")])
def test_a_name_of_its_own_stays_and_one_of_its_kind_does_not(
    open_editor: EditorFactory, name: str, after: str
) -> None:
    editor = open_editor(furnisher=furnish_room)
    editor.call("RenameRoom", {"room_id": OFFICE, "name": name})
    editor.call("FurnishRoom", {"room_id": name, "room_type": "bedroom"})
    found = editor.state.room(OFFICE)
    assert found is not None and (found[1].name, found[1].room_type, found[1].aliases) == (after, "bedroom", [])


def test_an_arrangement_with_a_fault_is_not_taken(open_editor: EditorFactory, folder: Path) -> None:
    before = _documents(folder)
    editor = open_editor(furnisher=furnish_room, validator=lambda old, new: ["SPAWN floor 1"])
    with pytest.raises(MansionError, match="SPAWN floor 1"):
        editor.call("FurnishRoom", {"room_id": KITCHEN})
    assert _documents(folder) == before and editor.state.pending == []


@pytest.mark.parametrize(
    ("arguments", "code"),
    [
        ({"room_id": OFFICE, "room_type": "zzyzx"}, "NOT_FOUND"),
        ({"room_id": OFFICE, "room_type": "balcony"}, "INFEASIBLE"),
        ({"room_id": HALL, "room_type": "bedroom"}, "INFEASIBLE"),
        ({"room_id": OFFICE, "keep": ["F1/kitchen/mug_1"]}, "NOT_FOUND"),
        ({"room_id": OFFICE, "keep": ["F2/nothing"]}, "NOT_FOUND"),
    ],
)  # fmt: skip
def test_what_cannot_be_furnished_is_refused(
    open_editor: EditorFactory, folder: Path, arguments: dict[str, object], code: str
) -> None:
    before = _documents(folder)
    editor = open_editor(furnisher=furnish_room)
    with pytest.raises(MansionError) as error:
        editor.call("FurnishRoom", arguments)
    assert error.value.code == code and _documents(folder) == before


def test_an_editor_without_a_placer_says_so(open_editor: EditorFactory) -> None:
    with pytest.raises(MansionError) as error:
        open_editor().call("FurnishRoom", {"room_id": KITCHEN})
    assert error.value.code == "UNAVAILABLE"


@pytest.mark.parametrize(
    ("words", "name"), [("Meeting room", "meeting_room"), ("sitting room", "living_room"), ("restrooms", "restroom")]
)
def test_words_name_room_types(catalogue: Catalogue, words: str, name: str) -> None:
    assert room_type_named(catalogue, words) == name
