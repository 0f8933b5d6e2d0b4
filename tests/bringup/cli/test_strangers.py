"""What somebody who does not know Mansion may type: no traceback, a status other than 0, a message that helps."""

import os
import select
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
import typer.main
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_msgs_py.errors import MansionError
from sample_building import write_building

ON_BUILDINGS = (
    ("check", "{}"),
    ("view", "{}"),
    ("export", "{}", "--to", "thor"),
    ("edit", "{}", "put an apple on a table"),
    ("edit", "{}", "ListObjects"),
    ("look", "{}", "-o", "look.png"),
    ("task", "generate", "{}", "-n", "1"),
    ("task", "ground", "office_laptop", "{}"),
    ("skill", "WhereAmI", "--building", "{}"),
)
ON_FILES = (
    ("solve", "{}", "-o", "out.json"),
    ("place", "{}", "-o", "out.json"),
    ("task", "show", "{}"),
    ("task", "run", "{}"),
    ("task", "ground", "{}", "sample"),
    ("record", "episode", "{}", "-o", "episode.mcap"),
    ("record", "task", "{}", "any", "-o", "task.mcap"),
    ("bench", "floorplans", "{}"),
    ("bench", "placement", "{}"),
    ("bench", "agents", "--tasks", "{}", "-o", "bench"),
    ("bench", "agents", "--replay", "{}"),
    ("bench", "gallery", "{}", "a={}", "-o", "gallery"),
    ("build", "a flat", "--footprint", "{}", "-o", "flat"),
    ("edit", "sample", "--task", "{}"),
)
FOLDERS = ("missing", "file.json", "empty", "truncated", "incomplete")
FILES = ("missing.json", "empty", "truncated.json", "list.json", "wrong.json")


@pytest.fixture(scope="module")
def things(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with a building, and with what is none."""
    root = tmp_path_factory.mktemp("things")
    write_building(root / "sample")
    (root / "empty").mkdir()
    (root / "file.json").write_text("{}")
    (root / "truncated.json").write_text('[{"id": ')
    (root / "list.json").write_text("[1, 2]")
    (root / "wrong.json").write_text('{"tasks": 3, "rooms": "x"}')
    for name in ("truncated", "incomplete"):
        shutil.copytree(root / "sample", root / name)
    scene = root / "truncated" / "floors" / "floor_1" / "scene.json"
    scene.write_bytes(scene.read_bytes()[:900])
    (root / "incomplete" / "floors" / "floor_1" / "scene.json").unlink()
    return root


def refused(words: tuple[str, ...], thing: str, root: Path, monkeypatch: pytest.MonkeyPatch) -> str:
    """Run a command in `root` and return the message with which it ends."""
    monkeypatch.chdir(root)
    before = sorted(root.rglob("*"))
    done = CliRunner().invoke(app, [word.replace("{}", thing) for word in words])
    assert done.exit_code != 0
    # A MansionError is what the entry point prints as one line; any other exception would be a traceback.
    assert isinstance(done.exception, MansionError | SystemExit), done.exc_info
    new = [path for path in sorted(root.rglob("*")) if path not in before]
    assert not [path for path in new if path.suffix in (".json", ".png", ".html", ".mcap")]
    return str(done.exception) if isinstance(done.exception, MansionError) else done.output


@pytest.mark.parametrize("words", ON_BUILDINGS, ids=" ".join)
@pytest.mark.parametrize("folder", FOLDERS)
def test_what_is_no_whole_building_is_named(
    words: tuple[str, ...], folder: str, things: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    message = refused(words, folder, things, monkeypatch)
    assert folder in message
    assert "mansion build" in message or "not JSON" in message or "scene.json" in message


@pytest.mark.parametrize("words", ON_FILES, ids=" ".join)
@pytest.mark.parametrize("file", FILES)
def test_what_is_no_such_file_is_named(
    words: tuple[str, ...], file: str, things: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert file in refused(words, file, things, monkeypatch)


def commands() -> list[tuple[tuple[str, ...], Any]]:
    def below(path: tuple[str, ...], command: Any) -> list[tuple[tuple[str, ...], Any]]:
        inner = getattr(command, "commands", {})
        if not inner:
            return [(path, command)]
        return [entry for name in inner for entry in below((*path, name), inner[name])]

    return below((), typer.main.get_command(app))


@pytest.mark.parametrize("path", [path for path, _ in commands()], ids=" ".join)
def test_each_command_has_an_example_of_its_own(path: tuple[str, ...]) -> None:
    shown = CliRunner().invoke(app, [*path, "--help"])
    assert shown.exit_code == 0
    assert f"mansion {' '.join(path)}" in shown.output.split("Examples:")[1]


@pytest.mark.parametrize(
    "path", [path for path, command in commands() if any(p.required for p in command.params)], ids=" ".join
)
def test_a_command_without_what_it_needs_says_so(path: tuple[str, ...]) -> None:
    shown = CliRunner().invoke(app, list(path))
    assert shown.exit_code != 0
    assert "Usage:" in shown.output


WRITING = (
    ("view", "sample", "-o", "{}/view.html"),
    ("export", "sample", "--to", "thor", "-o", "{}"),
    ("look", "sample", "-o", "{}/look.png"),
    ("task", "generate", "sample", "-n", "1", "-o", "{}/tasks.json"),
    ("task", "paper", "office_laptop", "-o", "{}/task.json"),
    ("solve", "none.json", "-o", "{}/layouts.json"),
    ("place", "none.json", "-o", "{}/placements.json"),
    ("record", "episode", "none.json", "-o", "{}/episode.mcap"),
    ("bench", "agents", "--tasks", "none.json", "-o", "{}"),
    ("build", "a small flat", "-o", "{}"),
)


@pytest.mark.parametrize("words", WRITING, ids=" ".join)
def test_an_output_below_a_file_is_named(words: tuple[str, ...], things: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (things / "none.txt").write_text("[]")
    words = tuple(word.replace("none.json", "none.txt") for word in words)
    assert "file.json" in refused(words, "file.json/below", things, monkeypatch)


@pytest.mark.skipif(os.geteuid() == 0, reason="root may write everywhere")
def test_a_folder_that_cannot_be_written_is_named(
    things: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    closed = tmp_path / "closed"
    closed.mkdir(mode=0o500)
    assert str(closed) in refused(WRITING[0], str(closed), things, monkeypatch)


def test_an_output_that_the_system_refuses_is_one_line(things: Path) -> None:
    done = subprocess.run(
        [sys.executable, "-m", "mansion_bringup", "task", "paper", "office_laptop", "-o",
         "/proc/nowhere/task.json"],
        capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip
    assert done.returncode == 1
    assert done.stderr.startswith("error: ") and done.stderr.count("\n") == 1


@pytest.mark.parametrize("seconds", [0.0, 1.5], ids=["at once", "later"])
@pytest.mark.parametrize(
    "words",
    [("build", "a four-storey office", "-o", "{}/office"), ("bench", "graph"), ("echo", "nothing")],
    ids=" ".join,
)
def test_an_interrupt_ends_a_command_without_a_traceback(
    words: tuple[str, ...], seconds: float, tmp_path: Path
) -> None:
    """The interrupt comes once the command has said something: before, the interpreter may not have started yet."""
    process = subprocess.Popen(
        [sys.executable, "-u", "-m", "mansion_bringup", *(w.replace("{}", str(tmp_path)) for w in words)],
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        start_new_session=True,
    )
    assert process.stdout is not None
    assert select.select([process.stdout], [], [], 60)[0]
    time.sleep(seconds)
    os.killpg(process.pid, signal.SIGINT)
    said = process.communicate(timeout=60)[0].decode()
    # CPython ends by the signal itself where the interrupt fell into an exec of text, as dataclasses are made by.
    assert process.returncode in (0, 1, 130, -signal.SIGINT)
    assert "Traceback" not in said
    assert not (tmp_path / "office").exists()
