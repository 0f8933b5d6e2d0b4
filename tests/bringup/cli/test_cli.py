"""The command line as a user meets it: real processes, exit statuses, messages."""

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ENVIRONMENT = {**os.environ, "COLUMNS": "120", "NO_COLOR": "1"}


def mansion(*arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "mansion_bringup", *arguments],
        capture_output=True,
        text=True,
        timeout=120,
        env=ENVIRONMENT,
        check=False,
    )


COMMANDS = ("build", "plan", "up", "call", "echo", "graph", "solve", "place", "schema", "check", "test")


def test_help_lists_every_command_and_each_has_examples() -> None:
    listing = mansion("--help").stdout
    for command in COMMANDS:
        assert command in listing


@pytest.mark.parametrize("command", COMMANDS)
def test_each_command_shows_an_example(command: str) -> None:
    shown = mansion(command, "--help")
    assert shown.returncode == 0
    assert f"mansion {command}" in shown.stdout


def test_an_infeasible_brief_ends_with_status_2_and_the_reason(tmp_path: Path) -> None:
    done = mansion("build", "a hospital", "--floors", "9", "--area", "12", "-o", str(tmp_path / "h"))
    assert done.returncode == 2
    assert "INFEASIBLE" in done.stderr
    assert "Traceback" not in done.stderr


@pytest.mark.parametrize(
    "arguments",
    [
        ("build", "a flat", "--footprint", "/nowhere.json", "-o", "x"),
        ("build", "a flat", "--planner", "oracle", "-o", "x"),
        ("check", "/nowhere"),
        ("schema", "Nonsense"),
        ("solve", "/nowhere.json", "-o", "x.json"),
        ("place", "/nowhere.json", "-o", "x.json"),
    ],
)
def test_bad_input_ends_with_one_line_and_status_1(arguments: tuple[str, ...], tmp_path: Path) -> None:
    done = mansion(*arguments)
    assert done.returncode == 1
    assert done.stderr.startswith("error: ")
    assert "Traceback" not in done.stderr


def test_schema_prints_json() -> None:
    assert "BuildRequest" in mansion("schema").stdout.split()
    assert json.loads(mansion("schema", "FloorScene").stdout)["$defs"]["Door"]


def test_plan_prints_the_program_and_its_trace() -> None:
    shown = mansion("plan", "a two-storey library with a reading room")
    assert shown.returncode == 0
    assert "floor 2" in shown.stdout
    assert "two-storey" in shown.stdout
    program = json.loads(mansion("plan", "a two-storey library", "--json").stdout)
    assert len(program["floors"]) == 2


@pytest.mark.parametrize(
    "brief", ["- what: a small shop\n- storeys: 2", "-2 storeys, a small shop", "-- a shop of 2 storeys"]
)
def test_a_description_may_begin_with_a_dash(brief: str) -> None:
    shown = mansion("plan", brief, "--json")
    assert shown.returncode == 0
    assert len(json.loads(shown.stdout)["floors"]) == 2
