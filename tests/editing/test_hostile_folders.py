"""A building folder from elsewhere makes the editor write nothing outside of it."""

from collections.abc import Callable
from pathlib import Path

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.storage import BuildingStore
from mansion_msgs_py.building_folder import INDEX
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.editing.changes import DocumentChange, Transaction
from mansion_msgs_py.errors import MansionError

EditorFactory = Callable[..., SceneEditor]
RENAME = {"room_id": "F1/kitchen", "name": "Canteen"}


@pytest.fixture
def victim(folder: Path) -> Path:
    """Return a file of another building, beside the folder."""
    other = folder.parent / f"{folder.name}_other"
    other.mkdir()
    (other / "report.json").write_bytes(b"theirs")
    return other / "report.json"


def test_an_index_that_names_files_elsewhere_is_refused(folder: Path, victim: Path) -> None:
    index = folder / INDEX
    name = f"../{victim.parent.name}/report.json"
    index.write_bytes(index.read_bytes().replace(b'"files": {}', encode_bytes({"files": {"report": name}})[1:-1]))
    assert name.encode() in index.read_bytes()
    with pytest.raises(MansionError, match="inside the folder"):
        BuildingStore(folder)


@pytest.mark.parametrize("after", ["", "0" * 32])
def test_an_unfinished_edit_that_names_files_elsewhere_is_not_finished(folder: Path, victim: Path, after: str) -> None:
    document = DocumentChange(path=f"../{victim.parent.name}/report.json", after=after)
    edit = Transaction(
        number=1, who="x", what="x", changes=[], rooms=[], documents=[document], revisions={}, time=""
    )  # fmt: skip
    (folder / "edits" / "documents").mkdir(parents=True)
    (folder / "edits" / "documents" / ("0" * 32)).write_bytes(b"mine")
    (folder / "edits" / "pending.json").write_bytes(encode_bytes(edit))
    with pytest.raises(MansionError):
        BuildingStore(folder)
    assert victim.read_bytes() == b"theirs"


@pytest.mark.parametrize("place", ["edits", "floors/floor_1"])
def test_links_to_other_places_are_not_followed(folder: Path, place: str, open_editor: EditorFactory) -> None:
    moved = folder.parent / f"{folder.name}_moved"
    (folder / place).mkdir(exist_ok=True)
    (folder / place).rename(moved)
    (folder / place).symlink_to(moved)
    before = {file: file.read_bytes() for file in moved.iterdir()}
    with pytest.raises(MansionError, match="leads out of"):
        open_editor().call("RenameRoom", RENAME)
    assert {file: file.read_bytes() for file in moved.iterdir()} == before
    assert not (folder / "edits" / "pending.json").exists()
