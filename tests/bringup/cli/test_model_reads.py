"""A brief that a language model reads, from the command line: who read what is in the table and in the files."""

import importlib.util
import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from rich.console import Console

from mansion_bringup.cli.receipt_table import receipt_table
from mansion_msgs_py.building import Building, BuildingReport
from mansion_msgs_py.codec import decode
from mansion_msgs_py.wishes import Wish

BRIEF = "Eine kleine Wohnung mit zwei Schlafzimmern und einem Bad"
ANSWER = {
    "language": "German",
    "statements": [
        {"kind": "building_type", "quote": "Wohnung", "value": {"name": "flat", "type": "flat"}},
        {"kind": "room", "quote": "zwei Schlafzimmern", "value": {"name": "bedroom", "type": "bedroom", "count": 2}},
        {"kind": "room", "quote": "einem Bad", "value": {"name": "bathroom", "type": "bathroom", "count": 1}},
    ],
}


@pytest.fixture
def environment() -> Iterator[dict[str, str]]:
    """Return an environment whose model reads the brief, on loopback."""
    file = Path(__file__).parents[2] / "llm" / "chat_server.py"
    spec = importlib.util.spec_from_file_location("chat_server", file)
    assert spec is not None and spec.loader is not None
    chat: Any = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = chat
    spec.loader.exec_module(chat)
    kept = {name: value for name, value in os.environ.items() if not name.startswith(("MANSION_LLM_", "OPENAI_"))}
    with chat.ChatServer(chat.in_turn(chat.Reply(json.dumps(ANSWER)))) as server:
        settings = {
            "MANSION_LLM_BASE_URL": server.url, "MANSION_LLM_MODEL": "m", "MANSION_LLM_PIECES": "reading",
            "NO_PROXY": "127.0.0.1", "COLUMNS": "140", "NO_COLOR": "1",
        }  # fmt: skip
        yield kept | settings


def mansion(environment: dict[str, str], *arguments: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [sys.executable, "-m", "mansion_bringup", *arguments],
        capture_output=True,
        text=True,
        timeout=240,
        env=environment,
        check=False,
    )


def test_a_german_brief_becomes_a_building_that_says_who_read_it(environment: dict[str, str], tmp_path: Path) -> None:
    folder = tmp_path / "flat"
    done = mansion(environment, "build", BRIEF, "--planner", "llm", "-o", str(folder))
    assert done.returncode == 0, done.stderr
    assert "read by" in done.stdout and "Schlafzimmern" in done.stdout
    building = decode(Building, (folder / "building.json").read_bytes())
    report = decode(BuildingReport, (folder / "report.json").read_bytes())
    assert report.sources["reading"] == "llm"
    for wishes in (building.wishes, report.wishes, building.program.wishes):
        assert [(wish.text, wish.read_by) for wish in wishes] == [
            ("Wohnung", "model"), ("zwei Schlafzimmern", "model"), ("einem Bad", "model"),
        ]  # fmt: skip
    assert [wish.status for wish in building.wishes] == ["met", "met", "met"]
    assert mansion(environment, "check", str(folder)).returncode == 0


def shown(*wishes: Wish) -> str:
    """Return the receipt's table as text."""
    console = Console(width=100, no_color=True)
    with console.capture() as capture:
        console.print(receipt_table(wishes))
    return capture.get()


def test_the_table_says_who_read_a_wish_where_a_model_did() -> None:
    wish = Wish(id="wish_1", text="a sauna", span=(0, 7), kind="room", status="met", read_by="model")
    assert "read by" in shown(wish) and "model" in shown(wish)
    other = Wish(id="wish_1", text="a sauna", span=(0, 7), kind="room", status="met")
    assert "read by" not in shown(other)
