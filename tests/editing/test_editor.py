"""Edits land whole or not at all, can be undone, and do not lose each other."""

import json
import re
from collections.abc import Callable
from pathlib import Path

import pytest

from mansion_editing.editor import SceneEditor
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.editing.changes import Transaction
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.world import ObjectState, Pose2D, RobotState, WorldState

EditorFactory = Callable[..., SceneEditor]

FRIDGE, TABLE = "F1/kitchen/fridge_1", "F1/kitchen/dining_table_1"
COLA = {"asset_id": "cola_can_1", "container_id": FRIDGE}
SCENE = "floors/floor_1/scene.json"


def _without_revision(folder: Path) -> bytes:
    return re.sub(rb'"revision": \d+', b"", (folder / SCENE).read_bytes())


def test_a_placement_lands_with_the_next_revision(open_editor: EditorFactory, folder: Path) -> None:
    result = open_editor().call("PlaceInContainer", COLA)
    assert result.saved and result.revisions == {"1": 2}
    scene = open_editor().state.scenes[1]
    cola = scene.objects[-1]
    assert (cola.id, cola.mount, cola.parent) == ("F1/kitchen/cola_can_1", "inside", FRIDGE)
    assert scene.revision == 2 and cola.states["temperature"] == "cold"
    assert [t.who for t in open_editor().store.log()] == ["ann"]


def test_the_building_counts_its_objects_after_every_edit(open_editor: EditorFactory, folder: Path) -> None:
    def counts() -> list[int]:
        building = json.loads((folder / "building.json").read_text())
        return [entry["objects"] for entry in building["floors"]]

    editor = open_editor()
    before = counts()
    editor.call("PlaceOnSurface", {"asset_id": "Apple_1", "receptacle_id": "F2/private_office_1/office_desk_1"})
    assert counts() == [before[0], before[1] + 1]
    editor.call("Undo")
    assert counts() == before


def test_undo_restores_the_bytes_and_redo_the_edit(open_editor: EditorFactory, folder: Path) -> None:
    before = _without_revision(folder)
    editor = open_editor()
    editor.call("RemoveObject", {"object_id": TABLE})
    editor.call("PlaceInContainer", COLA)
    after = _without_revision(folder)
    for _ in range(2):
        open_editor().call("Undo")
    assert _without_revision(folder) == before
    for _ in range(2):
        open_editor().call("Redo")
    assert _without_revision(folder) == after
    assert open_editor().state.scenes[1].revision == 7


def test_only_ones_own_edits_are_undone(open_editor: EditorFactory) -> None:
    open_editor("ann").call("PlaceInContainer", COLA)
    with pytest.raises(MansionError) as error:
        open_editor("bob").call("Undo")
    assert error.value.code == "NOT_FOUND"


def test_removing_takes_along_what_is_carried(open_editor: EditorFactory) -> None:
    editor = open_editor()
    result = editor.call("RemoveObject", {"object_id": TABLE})
    assert set(result.object_ids) == {TABLE, "F1/kitchen/mug_1"}


def test_clearing_a_receptacle_leaves_it(open_editor: EditorFactory) -> None:
    editor = open_editor()
    assert editor.call("RemoveObject", {"receptacle_id": TABLE}).object_ids == ["F1/kitchen/mug_1"]
    assert editor.state.find(TABLE) is not None


def test_moving_takes_along_what_is_carried(open_editor: EditorFactory) -> None:
    editor = open_editor()
    editor.call("MoveObject", {"object_id": TABLE, "x": 8.5, "y": 3.2, "rotation": 90})
    _, moved = editor.state.get(TABLE)
    _, mug = editor.state.get("F1/kitchen/mug_1")
    assert moved.position[:2] == (8.5, 3.2) and mug.position[:2] == (8.5, 3.2)
    assert mug.rotation == 90.0


def test_moving_into_something_is_refused(open_editor: EditorFactory) -> None:
    editor = open_editor()
    with pytest.raises(MansionError, match="would overlap F1/kitchen/fridge_1"):
        editor.call("MoveObject", {"object_id": TABLE, "x": 10.8, "y": 0.9})
    assert editor.state.pending == []


def test_moving_to_another_floor_renames(open_editor: EditorFactory) -> None:
    editor = open_editor()
    desk = "F2/private_office_1/office_desk_1"
    result = editor.call("MoveObject", {"object_id": "F1/kitchen/mug_1", "receptacle_id": desk})
    assert result.revisions == {"1": 2, "2": 2}
    assert editor.state.find("F1/kitchen/mug_1") is None
    assert editor.state.get("F2/private_office_1/mug_1")[1].parent == desk


def test_states_are_set_where_they_exist(open_editor: EditorFactory) -> None:
    editor = open_editor()
    editor.call("SetState", {"object_id": FRIDGE, "open": True})
    assert editor.state.get(FRIDGE)[1].states["open"] is True
    with pytest.raises(MansionError, match="does not open"):
        editor.call("SetState", {"object_id": TABLE, "open": True})


def test_edits_wait_for_save_and_are_undone_one_by_one(open_editor: EditorFactory, folder: Path) -> None:
    before = (folder / SCENE).read_bytes()
    editor = open_editor(autosave=False)
    editor.call("PlaceInContainer", COLA)
    editor.call("PlaceInContainer", COLA)
    editor.call("Undo")
    assert len(editor.call("Diff").changes) == 1
    assert (folder / SCENE).read_bytes() == before
    saved = editor.call("Save")
    assert saved.object_ids == ["F1/kitchen/cola_can_1"] and saved.transaction == 1


def test_concurrent_editors_keep_each_others_work(open_editor: EditorFactory) -> None:
    ann, bob = open_editor("ann", autosave=False), open_editor("bob", autosave=False)
    ann.call("PlaceInContainer", COLA)
    bob.call("PlaceInContainer", COLA)
    bob.call("PlaceOnSurface", {"asset_id": "cola_can_1", "receptacle_id": TABLE})
    ann.call("Save")
    assert bob.call("Save").object_ids == ["F1/kitchen/cola_can_2", "F1/kitchen/cola_can_3"]
    colas = [o.id for o in open_editor().state.scenes[1].objects if o.category == "cola_can"]
    assert len(colas) == len(set(colas)) == 3


def test_an_edit_of_what_another_changed_is_a_conflict(open_editor: EditorFactory) -> None:
    ann, bob = open_editor("ann", autosave=False), open_editor("bob")
    ann.call("SetState", {"object_id": FRIDGE, "open": True})
    bob.call("RemoveObject", {"object_id": FRIDGE})
    with pytest.raises(MansionError) as error:
        ann.call("Save")
    assert error.value.code == "CONFLICT"


def test_faults_of_the_validator_refuse_the_edit(open_editor: EditorFactory, folder: Path) -> None:
    before = (folder / SCENE).read_bytes()
    editor = open_editor(validator=lambda old, new: ["ROOM_UNREACHABLE F1/kitchen"])
    with pytest.raises(MansionError, match="ROOM_UNREACHABLE"):
        editor.call("PlaceInContainer", COLA)
    assert (folder / SCENE).read_bytes() == before and editor.store.log() == []
    assert editor.state.pending == []


def test_a_killed_writer_is_finished_by_the_next(open_editor: EditorFactory, folder: Path) -> None:
    before = {name: (folder / name).read_bytes() for name in (SCENE,)}
    editor = open_editor()
    editor.call("PlaceInContainer", COLA)
    log = folder / "edits/log.jsonl"
    line = log.read_bytes()
    wanted = (folder / SCENE).read_bytes()
    for cut in (b"", line[: len(line) // 2]):
        (folder / SCENE).write_bytes(before[SCENE])
        log.write_bytes(cut)
        (folder / "edits/pending.json").write_bytes(line.strip())
        again = open_editor()
        assert (folder / SCENE).read_bytes() == wanted and log.read_bytes() == line
        assert again.state.scenes[1].revision == 2
        assert not (folder / "edits/pending.json").exists()


def test_what_a_running_session_holds_is_left_alone(open_editor: EditorFactory, folder: Path) -> None:
    robot = RobotState(session="r", floor=1, label="1", pose=Pose2D(x=1, y=1), held="F1/kitchen/mug_1")
    world = WorldState(
        building_id="house", session="r", robot=robot, objects=[ObjectState(id=FRIDGE, states={"open": True})]
    )
    file = folder / "state/r/world.json"
    file.parent.mkdir(parents=True)
    file.write_bytes(encode_bytes(world))
    editor = open_editor()
    for tool, arguments in (
        ("RemoveObject", {"object_id": "F1/kitchen/mug_1"}),
        ("SetState", {"object_id": FRIDGE, "open": True}),
    ):
        with pytest.raises(MansionError) as error:
            editor.call(tool, arguments)
        assert error.value.code == "CONFLICT"
    assert editor.call("PlaceOnSurface", {"asset_id": "cola_can_1", "receptacle_id": TABLE}).saved


def test_derived_files_follow_the_revision(open_editor: EditorFactory, folder: Path) -> None:
    editor = open_editor()

    def files(place, scenes, changed):
        assert place == folder
        made = {f"made_{scene.floor}": str(scene.revision).encode() for scene in scenes if scene.floor in changed}
        return {**made, "all": b"x"}

    assert editor.store.refresh(files) == []
    editor.call("PlaceInContainer", COLA)
    assert editor.store.refresh(files) == [1]
    assert (folder / "made_1").read_bytes() == b"2" and not (folder / "made_2").exists()
    assert editor.store.refresh(files) == []


@pytest.mark.parametrize(
    ("tool", "arguments", "code"),
    [
        ("DeleteBuilding", {}, "NOT_FOUND"),
        ("RemoveObject", {}, "INVALID_PAYLOAD"),
        ("RemoveObject", {"object_id": "../../../etc/passwd"}, "NOT_FOUND"),
        ("RemoveObject", {"object_id": "F1/door_1"}, "NOT_FOUND"),
        ("PlaceOnSurface", {"asset_id": "cola_can_1", "receptacle_id": TABLE, "floor": 3}, "INVALID_PAYLOAD"),
        ("PlaceInContainer", {"asset_id": "cola_can_1", "container_id": TABLE}, "INFEASIBLE"),
        ("PlaceOnSurface", {"asset_id": "Fridge_1", "receptacle_id": TABLE}, "INFEASIBLE"),
        ("SearchAssets", {"query": "mug", "top_k": 10_000}, "INVALID_PAYLOAD"),
        ("MoveObject", {"object_id": TABLE, "x": 1e9, "y": 0}, "INVALID_PAYLOAD"),
    ],
)  # fmt: skip
def test_what_is_no_edit_is_refused_with_its_code(
    open_editor: EditorFactory, tool: str, arguments: dict[str, object], code: str
) -> None:
    editor = open_editor()
    with pytest.raises(MansionError) as error:
        editor.call(tool, arguments)
    assert error.value.code == code
    assert editor.state.pending == [] and editor.store.log() == []


def test_the_log_says_who_changed_what(open_editor: EditorFactory) -> None:
    open_editor("ann").call("PlaceInContainer", COLA)
    open_editor("bob").call("RemoveObject", {"object_id": "F1/kitchen/cola_can_1"})
    log: list[Transaction] = open_editor().store.log()
    assert [(t.number, t.who) for t in log] == [(1, "ann"), (2, "bob")]
    assert log[0].what.startswith("PlaceInContainer") and log[1].changes[0].after is None
