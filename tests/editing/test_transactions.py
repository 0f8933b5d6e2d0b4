"""Transactions of rooms and of whole documents land whole or not at all, and can be undone."""

import re
from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.storage import BuildingStore
from mansion_msgs_py.building_folder import BuildingFolder
from mansion_msgs_py.codec import decode, encode_bytes
from mansion_msgs_py.editing.changes import DocumentChange, Transaction
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.world import Pose2D, RobotState, WorldState

EditorFactory = Callable[..., SceneEditor]

KITCHEN = "F1/kitchen"
SCENE, TOPOLOGY, INDEX = "floors/floor_1/scene.json", "floors/floor_1/topology.json", "building.json"
RENAME = {"room_id": KITCHEN, "name": "Canteen"}
PAINT = {"room_id": KITCHEN, "part": "walls", "color": "blue"}
FLOOR = {"room_id": KITCHEN, "part": "floor", "material": "terrazzo"}


def _documents(folder: Path) -> dict[str, bytes]:
    """Return the building's documents without the revisions that each edit raises."""
    files = [file for file in folder.rglob("*.json") if "edits" not in file.parts]
    return {str(f.relative_to(folder)): re.sub(rb'"revision": \d+', b"", f.read_bytes()) for f in files}


@pytest.mark.parametrize("autosave", [True, False])
def test_undoing_edits_of_rooms_restores_the_bytes(open_editor: EditorFactory, folder: Path, autosave: bool) -> None:
    before = _documents(folder)
    editor = open_editor(autosave=autosave)
    for tool, arguments in (
        ("RenameRoom", RENAME), ("SetFinish", PAINT), ("SetFinish", FLOOR), ("ClearRoom", {"room_id": "canteen"}),
    ):  # fmt: skip
        editor.call(tool, arguments)
    editor.call("Save")
    after = _documents(folder)
    assert {name for name in after if after[name] != before[name]} == {SCENE, TOPOLOGY, INDEX}
    steps = 4 if autosave else 1
    for _ in range(steps):
        open_editor().call("Undo")
    assert _documents(folder) == before
    for _ in range(steps):
        open_editor().call("Redo")
    assert _documents(folder) == after


def test_edits_of_rooms_wait_and_are_told_in_words(open_editor: EditorFactory, folder: Path) -> None:
    before = _documents(folder)
    editor = open_editor(autosave=False)
    editor.call("RenameRoom", RENAME)
    editor.call("SetFinish", PAINT)
    diff = editor.call("Diff")
    assert diff.message == "~ F1/kitchen (name Kitchen -> Canteen; walls white_drywall -> blue_drywall)"
    assert len(diff.rooms) == 1 and diff.changes == []
    assert editor.call("Undo").room_ids == [KITCHEN]
    assert "walls" not in editor.call("Diff").message
    editor.call("Undo")
    assert editor.call("Save").message == "nothing to save"
    assert _documents(folder) == before


def test_two_editors_of_one_room_are_in_conflict_and_of_two_rooms_are_not(open_editor: EditorFactory) -> None:
    ann, bob, eve = (open_editor(who, autosave=False) for who in ("ann", "bob", "eve"))
    ann.call("RenameRoom", RENAME)
    bob.call("SetFinish", PAINT)
    eve.call("SetFinish", {**PAINT, "room_id": "F1/hall"})
    ann.call("Save")
    with pytest.raises(MansionError, match=KITCHEN) as error:
        bob.call("Save")
    assert error.value.code == "CONFLICT"
    assert eve.call("Save").saved
    rooms = {room.id: room for room in open_editor().state.scenes[1].rooms}
    assert (rooms[KITCHEN].name, rooms["F1/hall"].wall_material) == ("Canteen", "blue_drywall")


def test_a_killed_writer_of_a_room_is_finished_by_the_next(open_editor: EditorFactory, folder: Path) -> None:
    before = {name: (folder / name).read_bytes() for name in (SCENE, TOPOLOGY, INDEX)}
    open_editor().call("SetFinish", FLOOR)
    after = {name: (folder / name).read_bytes() for name in before}
    log = folder / "edits/log.jsonl"
    line = log.read_bytes()
    for written in ([], [SCENE], [SCENE, TOPOLOGY], list(before)):
        for name in before:
            (folder / name).write_bytes((after if name in written else before)[name])
        log.write_bytes(b"")
        (folder / "edits/pending.json").write_bytes(line.strip())
        open_editor()
        assert {name: (folder / name).read_bytes() for name in before} == after
        assert log.read_bytes() == line and not (folder / "edits/pending.json").exists()


def test_a_writer_that_fails_before_it_begins_leaves_the_old_state(
    open_editor: EditorFactory, folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = _documents(folder)

    def full(*arguments: object, **options: object) -> None:
        raise OSError("no space left on device")

    editor = open_editor()
    monkeypatch.setattr("mansion_editing.storage.write_atomic", full)
    with pytest.raises(MansionError, match="no space left on device; nothing was changed"):
        editor.call("RenameRoom", RENAME)
    monkeypatch.undo()
    assert _documents(folder) == before and open_editor().store.log() == []


def test_a_log_from_before_rooms_were_edited_loads(open_editor: EditorFactory, folder: Path) -> None:
    open_editor().call("RemoveObject", {"object_id": "F1/kitchen/mug_1"})
    log = folder / "edits/log.jsonl"
    old = msgspec.json.decode(log.read_bytes())
    del old["rooms"], old["documents"]
    log.write_bytes(encode_bytes(old) + b"\n")
    (read,) = open_editor().store.log()
    assert (read.rooms, read.documents) == ([], [])
    assert open_editor().call("Undo").saved


# whole documents


def _store(folder: Path) -> BuildingStore:
    return BuildingStore(folder)


def _new_floor(store: BuildingStore) -> list[DocumentChange]:
    """Return the changes that take the sofa out of the hall and a room out of the floor's graph, and say so."""
    scene = store.scenes()[1]
    emptied = msgspec.structs.replace(scene, objects=[o for o in scene.objects if o.category != "sofa"], label="E")
    graph = BuildingFolder(store.folder).topology(1)
    index = BuildingFolder(store.folder).building
    files = {
        SCENE: emptied,
        TOPOLOGY: msgspec.structs.replace(graph, nodes=graph.nodes[:1]),
        INDEX: msgspec.structs.replace(index, seed=7),
    }
    return [store.documents.replacement(path, encode_bytes(payload, indent=1)) for path, payload in files.items()]


def test_documents_are_replaced_together_and_given_back(folder: Path) -> None:
    store = _store(folder)
    before = _documents(folder)
    done = store.land([], "ann", "a new floor", documents=_new_floor(store))
    assert done.revisions == {"1": 2} and len(done.documents) == 3
    read = BuildingFolder(folder)
    assert (read.scene(1).label, read.scene(1).revision, read.building.seed) == ("E", 2, 7)
    assert len(read.topology(1).nodes) == 1
    assert read.entry(1).objects == len(read.scene(1).objects)
    after = _documents(folder)
    assert store.undo("ann").revisions == {"1": 3}
    assert _documents(folder) == before
    store.redo("ann")
    assert _documents(folder) == after


def test_replacements_wait_with_what_is_done_before_and_after_them(open_editor: EditorFactory, folder: Path) -> None:
    before = _documents(folder)
    editor = open_editor(autosave=False)
    editor.call("RenameRoom", RENAME)
    editor.call("RemoveObject", {"object_id": "F1/kitchen/mug_1"})
    data = editor.document(SCENE)
    assert data is not None and b"Canteen" in data and b"mug_1" not in data
    scene = decode(FloorScene, data)
    editor.replace_documents({SCENE: encode_bytes(msgspec.structs.replace(scene, label="E"), indent=1)}, "a new floor")
    editor.call("RemoveObject", {"object_id": "F1/hall/sofa_1"})
    editor.call("SetFinish", {**FLOOR, "room_id": "canteen"})
    editor.call("RemoveObject", {"object_id": "F2/private_office_1/floor_lamp_1"})
    assert editor.call("Diff").message == (f"~ {SCENE}, ~ {INDEX}, ~ {TOPOLOGY}, - F2/private_office_1/floor_lamp_1")
    assert editor.call("Save").revisions == {"1": 2, "2": 2}
    read = BuildingFolder(folder)
    scene, kitchen = read.scene(1), read.building.program.floors[0].rooms[1]
    assert (scene.label, [o.id for o in scene.objects if o.category in ("sofa", "mug")]) == ("E", [])
    assert (kitchen.name, kitchen.floor_material) == ("Canteen", "terrazzo")
    assert next(n for n in read.topology(1).nodes if n.id == "kitchen").floor_material == "terrazzo"
    open_editor().call("Undo")
    assert _documents(folder) == before


def test_a_waiting_replacement_is_undone_and_redone(open_editor: EditorFactory, folder: Path) -> None:
    before = _documents(folder)
    editor = open_editor(autosave=False)
    scene = editor.state.scenes[1]
    editor.replace_documents({SCENE: encode_bytes(msgspec.structs.replace(scene, label="E"), indent=1)}, "a new floor")
    editor.call("Undo")
    assert editor.state.scenes[1] == scene
    editor.call("Redo")
    assert editor.state.scenes[1].label == "E" and _documents(folder) == before
    editor.call("Save")
    assert BuildingFolder(folder).scene(1).label == "E"


def test_documents_replaced_meanwhile_are_a_conflict(open_editor: EditorFactory, folder: Path) -> None:
    store = _store(folder)
    changes = _new_floor(store)
    open_editor("bob").call("RemoveObject", {"object_id": "F1/kitchen/mug_1"})
    before = _documents(folder)
    with pytest.raises(MansionError, match=SCENE) as error:
        store.land([], "ann", "a new floor", documents=changes)
    assert error.value.code == "CONFLICT" and _documents(folder) == before


def test_what_other_edits_derive_is_no_conflict(open_editor: EditorFactory, folder: Path) -> None:
    store = _store(folder)
    changes = _new_floor(store)
    open_editor("bob").call("RemoveObject", {"object_id": "F2/private_office_1/floor_lamp_1"})
    store.land([], "ann", "a new floor", documents=changes)
    read = BuildingFolder(folder)
    assert [entry.objects for entry in read.building.floors] == [len(scene.objects) for scene in read.scenes()]
    assert read.building.seed == 7


def test_what_later_edits_rest_on_is_not_undone(open_editor: EditorFactory, folder: Path) -> None:
    store = _store(folder)
    store.land([], "ann", "a new floor", documents=_new_floor(store))
    open_editor("bob").call("RemoveObject", {"object_id": "F1/kitchen/mug_1"})
    with pytest.raises(MansionError, match="later edits rest on it"):
        store.undo("ann")
    open_editor("bob").call("Undo")
    assert store.undo("ann").undoes == 1


def test_a_killed_replacement_is_finished_by_the_next(folder: Path) -> None:
    store = _store(folder)
    before = {name: (folder / name).read_bytes() for name in (SCENE, TOPOLOGY, INDEX)}
    store.land([], "ann", "a new floor", documents=_new_floor(store))
    after = {name: (folder / name).read_bytes() for name in before}
    log = folder / "edits/log.jsonl"
    line = log.read_bytes()
    for written in ([], [SCENE], [SCENE, TOPOLOGY], list(before)):
        for name in before:
            (folder / name).write_bytes((after if name in written else before)[name])
        log.write_bytes(b"")
        (folder / "edits/pending.json").write_bytes(line.strip())
        _store(folder)
        assert {name: (folder / name).read_bytes() for name in before} == after and log.read_bytes() == line


def test_faults_of_the_validator_refuse_a_replacement(folder: Path) -> None:
    before = _documents(folder)
    store = BuildingStore(folder, validator=lambda old, new: [] if new[1].label == "1" else ["WALL_MISSING F1/hall"])
    with pytest.raises(MansionError, match="WALL_MISSING"):
        store.land([], "ann", "a new floor", documents=_new_floor(store))
    assert _documents(folder) == before and store.log() == []


def test_a_replaced_scene_takes_no_other_change_of_its_floor(open_editor: EditorFactory, folder: Path) -> None:
    editor = open_editor(autosave=False)
    editor.call("RemoveObject", {"object_id": "F1/kitchen/mug_1"})
    (mug,) = editor.call("Diff").changes
    with pytest.raises(MansionError) as error:
        editor.store.land([mug], "ann", "both", documents=_new_floor(editor.store))
    assert error.value.code == "INVALID_PAYLOAD"


def test_the_floor_of_a_robot_is_not_replaced(folder: Path) -> None:
    robot = RobotState(session="r", floor=1, label="1", pose=Pose2D(x=1, y=1))
    file = folder / "state/r/world.json"
    file.parent.mkdir(parents=True)
    file.write_bytes(encode_bytes(WorldState(building_id="house", session="r", robot=robot, objects=[])))
    store = _store(folder)
    with pytest.raises(MansionError, match="session 'r'") as error:
        store.land([], "ann", "a new floor", documents=_new_floor(store))
    assert error.value.code == "CONFLICT"


def test_a_storey_is_added_and_taken_away_again(open_editor: EditorFactory, folder: Path) -> None:
    store = _store(folder)
    before = _documents(folder)
    text = (folder / "floors/floor_2/scene.json").read_text().replace("F2/", "F3/").replace('"floor": 2', '"floor": 3')
    index = BuildingFolder(folder).building
    entry = msgspec.structs.replace(index.floors[1], floor=3, label="3", files={"scene": "floors/floor_3/scene.json"})
    files = {
        "floors/floor_3/scene.json": text.encode(),
        INDEX: encode_bytes(msgspec.structs.replace(index, floors=[*index.floors, entry]), indent=1),
    }
    other = open_editor("bob")
    store.land([], "ann", "one more", documents=[store.documents.replacement(p, d) for p, d in files.items()])
    assert sorted(other.refreshed().scenes) == [1, 2, 3]
    assert decode(FloorScene, (folder / "floors/floor_3/scene.json").read_bytes()).rooms[0].id == "F3/corridor"
    store.undo("ann")
    assert _documents(folder) == before and sorted(other.refreshed().scenes) == [1, 2]


@pytest.mark.parametrize("path", ["/etc/passwd", "../outside.json", "edits/log.jsonl", "state/r/world.json", ""])
def test_only_documents_of_the_building_are_replaced(folder: Path, path: str) -> None:
    with pytest.raises(MansionError) as error:
        _store(folder).documents.replacement(path, b"{}")
    assert error.value.code == "INVALID_PAYLOAD"


def test_the_log_holds_rooms_and_names_copies_of_documents(open_editor: EditorFactory, folder: Path) -> None:
    open_editor().call("RenameRoom", RENAME)
    store = _store(folder)
    store.land([], "ann", "a new floor", documents=_new_floor(store))
    log: list[Transaction] = store.log()
    assert (log[0].rooms[0].before.room.name, log[0].rooms[0].after.room.name) == ("Kitchen", "Canteen")
    for change in log[1].documents:
        assert store.documents.copy(change.after) != store.documents.copy(change.before)
