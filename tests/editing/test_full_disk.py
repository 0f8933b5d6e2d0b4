"""An edit that cannot be written changes nothing, says so in one line, and does not land later."""

import errno
import os
from collections.abc import Callable
from pathlib import Path

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.storage import BuildingStore
from mansion_msgs_py.building_folder import INDEX
from mansion_msgs_py.errors import ErrorCode, MansionError

EditorFactory = Callable[..., SceneEditor]
RENAME = {"room_id": "F1/kitchen", "name": "Canteen"}
MOST_WRITES = 40


def files(folder: Path) -> dict[str, bytes]:
    """Return all files but locks and the copies of documents, which nothing refers to."""
    found = [
        file for file in folder.rglob("*") if file.is_file() and file.name != "lock" and "documents" not in file.parts
    ]
    return {str(file.relative_to(folder)): file.read_bytes() for file in found}


def edit(editor: SceneEditor) -> None:
    """Change a room, an object and the index at once."""
    editor.autosave = False
    editor.call("RenameRoom", RENAME)
    editor.call("RemoveObject", {"object_id": "F1/kitchen/mug_1"})
    editor.call("Save")


def writes_failing_from(monkeypatch: pytest.MonkeyPatch, number: int, *, links: bool) -> list[int]:
    """Let every durable write from one on fail as on a full disk, and return what counts them."""
    done: list[int] = []
    fsync = os.fsync

    def full(descriptor: int) -> None:
        done.append(descriptor)
        if len(done) >= number:
            raise OSError(errno.ENOSPC, "No space left on device")
        fsync(descriptor)

    def refuse(*arguments: object, **options: object) -> None:
        raise OSError(errno.EPERM, "Operation not permitted")

    monkeypatch.setattr(os, "fsync", full)
    if not links:
        monkeypatch.setattr(os, "link", refuse)
    return done


@pytest.mark.parametrize("links", [True, False])
def test_a_full_disk_at_any_write_leaves_the_building_as_it_was(
    folder: Path, open_editor: EditorFactory, links: bool
) -> None:
    before = files(folder)
    for number in range(1, MOST_WRITES):
        editor = open_editor()
        with pytest.MonkeyPatch.context() as patch:
            count = writes_failing_from(patch, number, links=links)
            try:
                edit(editor)
            except MansionError as error:
                assert error.code == ErrorCode.UNAVAILABLE
                assert "No space left on device; nothing was changed" in error.info.message
            else:
                break
        assert len(count) == number, "what is put back needs no space"
        assert files(folder) == before
        BuildingStore(folder)
        assert files(folder) == before
    assert number > 5
    after = files(folder)
    changed = {name for name in after if after[name] != before.get(name)}
    assert changed == {"floors/floor_1/scene.json", INDEX, "edits/log.jsonl"}
    assert before.keys() <= after.keys() and len(after) == len(before) + 1


def test_an_interrupted_edit_does_not_land_later(
    folder: Path, open_editor: EditorFactory, monkeypatch: pytest.MonkeyPatch
) -> None:
    before = files(folder)
    editor = open_editor()

    def interrupt(*arguments: object) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr(BuildingStore, "_recount", interrupt)
    with pytest.raises(KeyboardInterrupt):
        edit(editor)
    monkeypatch.undo()
    BuildingStore(folder)
    assert files(folder) == before
