"""Open buildings are limited in number, and questions write nothing."""

from collections.abc import Callable
from pathlib import Path

import pytest

from mansion_editing.editor import MOST_EDITORS, OpenEditors, SceneEditor
from mansion_msgs_py.errors import ErrorCode, MansionError

EditorFactory = Callable[..., SceneEditor]


def test_the_editor_used_longest_ago_gives_way(open_editor: EditorFactory) -> None:
    editors = OpenEditors()
    for number in range(MOST_EDITORS):
        editors.put(str(number), open_editor())
    editors.get("0")
    editors.put("one more", open_editor())
    assert editors.get("0") and editors.get("one more")
    with pytest.raises(MansionError, match="scene/open") as caught:
        editors.get("1")
    assert caught.value.code == ErrorCode.NOT_LOADED


def test_an_editor_with_edits_that_wait_is_kept(open_editor: EditorFactory) -> None:
    editors = OpenEditors()
    for number in range(MOST_EDITORS):
        editor = open_editor(autosave=False)
        editor.call("RenameRoom", {"room_id": "F1/kitchen", "name": "Canteen"})
        editors.put(str(number), editor)
    with pytest.raises(MansionError, match="save those of one") as caught:
        editors.put("one more", open_editor())
    assert caught.value.code == ErrorCode.CONFLICT
    editors.get("3").call("Save")
    editors.put("one more", open_editor())
    assert editors.get("0").state.pending


def test_questions_write_nothing(open_editor: EditorFactory, folder: Path) -> None:
    before = {file: file.stat().st_mtime_ns for file in folder.rglob("*")}
    editor = open_editor()
    editor.call("ListObjects")
    editor.call("SearchContents", {"keyword": "fridge"})
    assert editor.store.refresh(lambda *changed: {}) == []
    assert {file: file.stat().st_mtime_ns for file in folder.rglob("*")} == before
