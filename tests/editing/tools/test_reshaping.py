"""ReshapeFloor lands a changed storey as whole documents, which Undo brings back."""

import re
from pathlib import Path

import pytest
from shapely import Polygon

import sample_storeys
from mansion_assets.catalogue import Catalogue
from mansion_bringup.edit_hooks import new_faults
from mansion_editing.editor import SceneEditor
from mansion_editing.physics.engine import StaticEngine
from mansion_editing.storage import BuildingStore
from mansion_editing.structure import Storey
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_scene.refurnishing import furnish_room


@pytest.fixture(scope="module")
def storey() -> Storey:
    return sample_storeys.office()


@pytest.fixture
def office_folder(storey: Storey, tmp_path: Path) -> Path:
    return sample_storeys.write_building(storey, tmp_path / "office")


@pytest.fixture
def editor(office_folder: Path, catalogue: Catalogue) -> SceneEditor:
    store = BuildingStore(office_folder, validator=new_faults)
    return SceneEditor(store, catalogue, StaticEngine(), who="ann", furnisher=furnish_room)


def documents(folder: Path) -> dict[str, bytes]:
    files = [file for file in folder.rglob("*.json") if "edits" not in file.parts]
    return {str(file): re.sub(rb'"revision": \d+', b"", file.read_bytes()) for file in files}


def test_a_changed_area_is_in_all_documents_and_undone_whole(editor: SceneEditor, office_folder: Path) -> None:
    before = documents(office_folder)
    reply = editor.call("ReshapeFloor", {"what": "area", "room_id": "meeting room", "area": 6.0})
    assert reply.saved
    assert reply.room_ids == ["F1/open_office_1", "F1/meeting_room_1"]
    assert "F1/meeting_room_1 has 42.0 m2 instead of 36.0 m2." in reply.message
    read = BuildingFolder(office_folder)
    drawn = {room.id: Polygon(room.polygon).area for room in read.layout(1).rooms}
    assert drawn["meeting_room_1"] == pytest.approx(42.0, abs=0.01)
    assert read.entry(1).objects == len(read.scene(1).objects)
    editor.call("Undo")
    assert documents(office_folder) == before


def test_a_door_and_rooms_that_change_places_land_too(editor: SceneEditor) -> None:
    door = {"what": "door", "room_id": "F1/open_office_1", "other_id": "F1/meeting_room_1"}
    assert "is new" in editor.call("ReshapeFloor", door).message
    swap = {"what": "swap", "room_id": "F1/toilet_1", "other_id": "F1/storage"}
    assert "have changed places" in editor.call("ReshapeFloor", swap).message


@pytest.mark.parametrize(
    ("asked", "code", "reason"),
    [
        ({"what": "stair", "room_id": "F1/storage"}, ErrorCode.INFEASIBLE, "one storey needs no stair"),
        ({"what": "door", "room_id": "F1/storage"}, ErrorCode.INVALID_PAYLOAD, "concerns two rooms"),
        ({"what": "area", "room_id": "F1/ballroom", "area": 3.0}, ErrorCode.NOT_FOUND, "names no room"),
        ({"what": "area", "room_id": "F1/storage", "area": 300.0}, ErrorCode.INFEASIBLE, "the largest possible is"),
    ],
)
def test_a_refusal_says_why_and_leaves_the_building_as_it_was(
    editor: SceneEditor, office_folder: Path, asked: dict[str, object], code: ErrorCode, reason: str
) -> None:
    before = documents(office_folder)
    with pytest.raises(MansionError, match=reason) as refusal:
        editor.call("ReshapeFloor", asked)
    assert refusal.value.info.code == code
    assert documents(office_folder) == before


def test_it_waits_with_other_edits_and_lands_with_them(editor: SceneEditor, office_folder: Path) -> None:
    before = documents(office_folder)
    editor.autosave = False
    editor.call("RenameRoom", {"room_id": "F1/meeting_room_1", "name": "Den"})
    reply = editor.call("ReshapeFloor", {"what": "area", "room_id": "den", "area": 6.0})
    assert not reply.saved
    assert documents(office_folder) == before
    assert editor.call("Save").saved
    den = next(room for room in BuildingFolder(office_folder).scene(1).rooms if room.name == "Den")
    assert den.area == pytest.approx(42.0, abs=0.01)
    editor.call("Undo")
    assert documents(office_folder) == before
