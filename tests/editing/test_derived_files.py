"""Files that are made from scenes are written in a process of their own."""

import os
import queue
import signal
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from mansion_editing import derived_files
from mansion_editing.derived_files import DerivedFiles
from mansion_editing.editor import SceneEditor
from mansion_msgs_py.allowed_folders import EVERYWHERE

EditorFactory = Callable[..., SceneEditor]
COLA = {"asset_id": "cola_can_1", "container_id": "F1/kitchen/fridge_1"}
HOOKS = """
import os

def kept_files(folder, scenes, changed):
    if (folder / "refuse").exists():
        raise OSError("no space left on device")
    return {"made": f"{os.getpid()} {os.nice(0)} {changed}".encode()}
"""
PATIENCE = 120.0


@pytest.fixture
def told() -> "queue.SimpleQueue[Any]":
    return queue.SimpleQueue()


@pytest.fixture
def derived(
    tmp_path_factory: pytest.TempPathFactory, told: "queue.SimpleQueue[Any]", monkeypatch: pytest.MonkeyPatch
) -> Iterator[DerivedFiles]:
    place = tmp_path_factory.mktemp("hooks")
    (place / "kept_for_a_test.py").write_text(HOOKS, encoding="utf-8")
    monkeypatch.setattr(sys, "path", [*sys.path, str(place)])
    files = DerivedFiles(
        "kept_for_a_test",
        EVERYWHERE,
        lambda folder, floors: told.put((folder, floors)),
        lambda folder, error: told.put((folder, str(error))),
    )
    yield files
    files.close()


def maker_of(folder: Path) -> tuple[int, int]:
    """Return the process that made the file, and its niceness."""
    number, niceness = (folder / "made").read_text(encoding="utf-8").split()[:2]
    return int(number), int(niceness)


def test_they_follow_edits_in_a_process_that_stands_back(
    derived: DerivedFiles, told: "queue.SimpleQueue[Any]", folder: Path, open_editor: EditorFactory
) -> None:
    editor = open_editor()
    editor.call("PlaceInContainer", COLA)
    derived.update(folder)
    assert told.get(timeout=PATIENCE) == (folder.resolve(), [1])
    maker, niceness = maker_of(folder)
    assert maker != os.getpid() and niceness == min(19, os.nice(0) + derived_files.NICENESS)
    editor.call("Undo")
    derived.update(folder)
    assert told.get(timeout=PATIENCE) == (folder.resolve(), [1])
    assert maker_of(folder)[0] == maker


def test_what_cannot_be_written_is_told_and_written_after_the_next_edit(
    derived: DerivedFiles, told: "queue.SimpleQueue[Any]", folder: Path, open_editor: EditorFactory
) -> None:
    open_editor().call("PlaceInContainer", COLA)
    (folder / "refuse").touch()
    derived.update(folder)
    assert told.get(timeout=PATIENCE) == (folder.resolve(), "no space left on device")
    (folder / "refuse").unlink()
    derived.update(folder)
    assert told.get(timeout=PATIENCE) == (folder.resolve(), [1])


def test_a_killed_process_is_replaced(
    derived: DerivedFiles, told: "queue.SimpleQueue[Any]", folder: Path, open_editor: EditorFactory
) -> None:
    editor = open_editor()
    editor.call("PlaceInContainer", COLA)
    derived.update(folder)
    assert told.get(timeout=PATIENCE)[1] == [1]
    maker, _ = maker_of(folder)
    os.kill(maker, signal.SIGKILL)
    editor.call("Undo")
    derived.update(folder)
    while told.get(timeout=PATIENCE)[1] != [1]:  # that it ended may be told first
        derived.update(folder)
    assert maker_of(folder)[0] != maker


def test_the_process_ends_when_nobody_edits(
    derived: DerivedFiles,
    told: "queue.SimpleQueue[Any]",
    folder: Path,
    open_editor: EditorFactory,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setattr(derived_files, "IDLE", 0.05)
    open_editor().call("PlaceInContainer", COLA)
    derived.update(folder)
    assert told.get(timeout=PATIENCE)[1] == [1]
    maker, _ = maker_of(folder)
    while Path(f"/proc/{maker}").exists():
        pass


def test_edits_while_it_rests_are_brought_up_to_date_together(
    derived: DerivedFiles,
    told: "queue.SimpleQueue[Any]",
    folder: Path,
    open_editor: EditorFactory,
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    times, rests, rested = iter([10.0, 13.0]), queue.SimpleQueue[float](), threading.Event()

    def rest(seconds: float) -> None:
        rests.put(seconds)
        rested.wait(PATIENCE)

    monkeypatch.setattr(derived, "_clock", lambda: next(times, 20.0))
    monkeypatch.setattr(derived, "_rest", rest)
    editor = open_editor()
    editor.call("PlaceInContainer", COLA)
    derived.update(folder)
    assert told.get(timeout=PATIENCE)[1] == [1]
    assert rests.get(timeout=PATIENCE) == 3.0 * derived_files.REST
    for tool in ("Undo", "Redo", "Undo"):
        editor.call(tool)
        derived.update(folder)
    assert told.empty()
    rested.set()
    assert told.get(timeout=PATIENCE)[1] == [1]
    rests.get(timeout=PATIENCE)
    assert told.empty()
