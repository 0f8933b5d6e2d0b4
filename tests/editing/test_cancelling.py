"""An edit that is cancelled ends at its next step, and nothing of it lands."""

import itertools
from collections.abc import Callable
from pathlib import Path

import pytest

from mansion_editing.editor import SceneEditor
from mansion_editing.instructions.instruct import instruct
from mansion_msgs_py.errors import ErrorCode, MansionError

EditorFactory = Callable[..., SceneEditor]

COLA = {"asset_id": "cola_can_1", "container_id": "F1/kitchen/fridge_1"}
INSTRUCTION = "Put a cola in the fridge, and remove the dining table."


def files(folder: Path) -> dict[str, bytes]:
    """Return what a building folder holds."""
    return {str(path): path.read_bytes() for path in sorted(folder.rglob("*")) if path.is_file()}


def after(asked: int) -> Callable[[], bool]:
    """Return a question that is answered with no so often, and with yes from then on."""
    count = itertools.count()
    return lambda: next(count) >= asked


def test_a_cancelled_edit_changes_nothing_and_the_next_one_is_done(open_editor: EditorFactory, folder: Path) -> None:
    before = files(folder)
    editor = open_editor()
    for asked in (0, 1):
        with editor.cancellable(after(asked)), pytest.raises(MansionError) as ended:
            editor.call("PlaceInContainer", COLA)
        assert ended.value.code == ErrorCode.CANCELED
        assert files(folder) == before
    assert editor.call("PlaceInContainer", COLA).saved


def test_an_instruction_can_be_cancelled_at_each_of_its_steps(open_editor: EditorFactory, folder: Path) -> None:
    before = files(folder)
    editor = open_editor()
    steps = 0
    for asked in itertools.count():
        try:
            with editor.cancellable(after(asked)):
                report = instruct(editor, INSTRUCTION)
        except MansionError as ended:
            assert ended.code == ErrorCode.CANCELED
            assert files(folder) == before
            steps += 1
        else:
            break
    assert steps >= 4
    assert report.done and report.saved


def test_what_fails_of_itself_is_told_as_it_is(open_editor: EditorFactory) -> None:
    editor = open_editor()
    with editor.cancellable(lambda: False), pytest.raises(MansionError) as refused:
        editor.call("PlaceInContainer", {**COLA, "container_id": "F1/kitchen/safe_1"})
    assert refused.value.code == ErrorCode.NOT_FOUND
