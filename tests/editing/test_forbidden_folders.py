"""A building where the process may not write is answered for, and stays as it is."""

from collections.abc import Callable
from pathlib import Path

import pytest

from mansion_assets.catalogue import Catalogue
from mansion_editing.editor import SceneEditor
from mansion_editing.physics.engine import StaticEngine
from mansion_editing.storage import BuildingStore
from mansion_msgs_py.allowed_folders import AllowedFolders
from mansion_msgs_py.errors import ErrorCode, MansionError

EditorFactory = Callable[..., SceneEditor]


def reader_of(folder: Path, catalogue: Catalogue) -> SceneEditor:
    """An editor that may write beside the folder, and not in it."""
    allowed = AllowedFolders((folder.parent / "elsewhere",))
    return SceneEditor(BuildingStore(folder, allowed=allowed), catalogue, StaticEngine())


def contents(folder: Path) -> dict[Path, bytes]:
    return {file: file.read_bytes() for file in folder.rglob("*") if file.is_file()}


def test_questions_are_answered_and_edits_refused(folder: Path, catalogue: Catalogue) -> None:
    before = contents(folder)
    editor = reader_of(folder, catalogue)
    assert editor.call("ListObjects").objects
    for tool, arguments in (
        ("RenameRoom", {"room_id": "F1/kitchen", "name": "Canteen"}),
        ("ReshapeFloor", {"what": "door", "room_id": "F1/kitchen", "other_id": "F1/hall"}),
        ("Undo", {}),
    ):
        with pytest.raises(MansionError):
            editor.call(tool, arguments)
    assert editor.store.refresh(lambda place, scenes, floors: {"plan.svg": b""}) == []
    assert contents(folder) == before


def test_the_refusal_names_where_edits_would_be_accepted(folder: Path, catalogue: Catalogue) -> None:
    with pytest.raises(MansionError, match="elsewhere, or start the graph with") as caught:
        reader_of(folder, catalogue).call("RenameRoom", {"room_id": "F1/kitchen", "name": "Canteen"})
    assert caught.value.code == ErrorCode.FORBIDDEN


def test_what_a_killed_editor_left_stays_for_one_that_may_write(
    folder: Path, catalogue: Catalogue, open_editor: EditorFactory
) -> None:
    remains = folder / f".building.json.{'0' * 16}"
    remains.write_bytes(b"")
    reader_of(folder, catalogue)
    assert remains.exists()
    open_editor()
    assert not remains.exists()


def test_copies_of_documents_are_kept_below_the_folder_alone(folder: Path, catalogue: Catalogue) -> None:
    outside = folder.parent / f"{folder.name}_outside"
    outside.mkdir()
    store = BuildingStore(folder)
    (folder / "edits").rmdir() if (folder / "edits").exists() else None
    (folder / "edits").symlink_to(outside)
    with pytest.raises(MansionError, match="leads out of"):
        store.documents.replacement("report.json", b"new")
    assert list(outside.iterdir()) == []
