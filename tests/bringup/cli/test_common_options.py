"""What all commands share: JSON on request, fewer and more words, colours, and completion."""

import json
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest
import typer.main
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_bringup.cli.settings_file import commands_below, option_key
from mansion_bringup.pipeline.build import build_building
from mansion_msgs_py.request import BuildRequest

ROOT: Any = typer.main.get_command(app)
COMMANDS = list(commands_below(ROOT))
JSON_ALONE = {("call",), ("skill",), ("task", "generate"), ("task", "ground")}
"""Commands that answer in JSON without being asked."""
NO_ANSWER = {("up",), ("test",)}
"""Commands that run until they end."""


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    place = tmp_path_factory.mktemp("shared")
    build_building(BuildRequest(description="a small flat", seed=2), place / "flat")
    return place


@pytest.mark.parametrize(("path", "command"), COMMANDS, ids=[" ".join(path) for path, _ in COMMANDS])
def test_each_command_has_the_common_options(path: tuple[str, ...], command: Any) -> None:
    keys = [option_key(p) for p in command.params if p.param_type_name == "option"]
    assert {"quiet", "verbose"} <= set(keys)
    assert len(keys) == len(set(keys))
    assert ("json" in keys) is (path not in JSON_ALONE | NO_ANSWER)


@pytest.mark.parametrize(
    ("words", "keys"),
    [
        (("plan", "a small flat"), {"floors", "wishes"}),
        (("build", "a small flat", "-o", "again", "--seed", "2"), {"path", "building_id", "faults", "wishes"}),
        (("export", "flat", "--to", "nav2", "-o", "nav2"), {"format", "folder", "files"}),
        (("view", "flat", "-o", "flat.html"), {"page"}),
        (("check", "flat", "--norms"), {"faults", "deviations"}),
        (("config",), {"file", "settings"}),
    ],
    ids=lambda value: value[0] if isinstance(value, tuple) else "",
)
def test_an_answer_in_json_is_all_that_is_printed(
    words: tuple[str, ...], keys: set[str], folder: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(folder)
    done = CliRunner().invoke(app, [*words, "--json"])
    assert keys <= set(json.loads(done.stdout)), done.output


def test_lists_of_names_tasks_and_results_are_json_too(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(folder)
    run = CliRunner()
    assert "BuildRequest" in json.loads(run.invoke(app, ["schema", "--json"]).stdout)
    assert json.loads(run.invoke(app, ["task", "paper", "--json"]).stdout)[0]["sentence"]
    assert run.invoke(app, ["task", "generate", "flat", "-n", "1", "-o", "tasks.json"]).exit_code == 0
    assert len(json.loads(run.invoke(app, ["task", "show", "tasks.json", "--json"]).stdout)["tasks"]) == 1
    (row,) = json.loads(run.invoke(app, ["task", "run", "tasks.json", "--json"]).stdout)
    assert row["success"] is True and row["skills"] > 0


def mansion(folder: Path, *words: str, **environment: str) -> subprocess.CompletedProcess[str]:
    others = ("NO_COLOR", "FORCE_COLOR", "MANSION_CONFIG")
    inherited = {name: value for name, value in os.environ.items() if name not in others}
    return subprocess.run(
        [sys.executable, "-m", "mansion_bringup", *words],
        cwd=folder, env={**inherited, **environment}, capture_output=True, text=True, timeout=120, check=False,
    )  # fmt: skip


def test_a_refusal_is_json_where_json_was_asked_for(tmp_path: Path) -> None:
    done = mansion(tmp_path, "check", "nothing", "--json")
    assert done.returncode == 1
    found = json.loads(done.stdout)
    assert "nothing" in json.dumps(found)
    missing = mansion(tmp_path, "task", "show", "none.json", "--json")
    assert json.loads(missing.stdout)["error"]["code"] == "NOT_FOUND"
    assert missing.stderr.startswith("error: NOT_FOUND")


def test_quiet_leaves_results_and_verbose_adds_times(folder: Path) -> None:
    (folder / "other").mkdir(exist_ok=True)
    (folder / "other" / "mansion.toml").write_text("seed = 2\n")
    quiet = mansion(folder / "other", "build", "a small flat", "-o", "q", "-q")
    assert quiet.returncode == 0 and quiet.stderr == "" and "1 floor" in quiet.stdout
    verbose = mansion(folder / "other", "build", "a small flat", "-o", "v", "--verbose")
    assert "settings of mansion.toml" in verbose.stderr
    assert "total: " in verbose.stderr and "[1/" in verbose.stderr
    refused = mansion(folder / "other", "skill", "GoToLandmark", '{"landmark": "moon"}', "-b", "q", "-q")
    assert refused.returncode == 1 and "moon" in refused.stderr


@pytest.mark.parametrize("words", [("plan", "a small flat"), ("build", "--help")], ids=" ".join)
def test_what_is_piped_has_no_colours(words: tuple[str, ...], tmp_path: Path) -> None:
    done = mansion(tmp_path, *words)
    assert done.returncode == 0
    assert "\x1b" not in done.stdout + done.stderr


def test_no_color_holds_on_a_terminal_too(tmp_path: Path) -> None:
    terminal = pytest.importorskip("pty")
    seen = {}
    for name, environment in {"plain": {"NO_COLOR": "1"}, "coloured": {"COLORTERM": "truecolor"}}.items():
        main, side = terminal.openpty()
        command = [sys.executable, "-m", "mansion_bringup", "task", "paper"]
        inherited = {key: value for key, value in os.environ.items() if key != "NO_COLOR"}
        process = subprocess.Popen(
            command, cwd=tmp_path, env={**inherited, "TERM": "xterm-256color", **environment}, stdout=side, stderr=side
        )
        os.close(side)
        seen[name] = _everything(main)
        assert process.wait(timeout=60) == 0
    colours = (b"\x1b[3", b"\x1b[1;3", b"\x1b[4")
    assert not any(code in seen["plain"] for code in colours)
    assert b"\x1b[" in seen["coloured"]


def _everything(descriptor: int) -> bytes:
    """Read a terminal until the process on its other side ends, which Linux tells by an error."""
    parts = []
    try:
        while data := os.read(descriptor, 4096):
            parts.append(data)
    except OSError:
        pass
    os.close(descriptor)
    return b"".join(parts)


@pytest.mark.parametrize(
    ("typed", "offered"), [("mansion task gen", ["generate"]), ("mansion build --floor-", ["--floor-area"])]
)
def test_the_shell_completes_commands_and_options(typed: str, offered: list[str], tmp_path: Path) -> None:
    done = mansion(
        tmp_path, _MANSION_COMPLETE="complete_bash", COMP_WORDS=typed, COMP_CWORD=str(len(typed.split()) - 1)
    )
    assert done.stdout.split() == offered


def test_the_completion_of_a_shell_is_printed(tmp_path: Path) -> None:
    done = mansion(tmp_path, _MANSION_COMPLETE="source_zsh")
    assert done.returncode == 0
    assert "#compdef mansion" in done.stdout and "_MANSION_COMPLETE=complete_zsh" in done.stdout
