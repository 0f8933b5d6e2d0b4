"""A bench of agents that ask a model: lessons go from episode to episode, and an outage stops it without a verdict."""

import json
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from episode_tasks import mug_task, search_task, write_tasks
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_tasks.episodes.bench import Bench, run_bench
from mansion_tasks.episodes.log import read_log
from talk import question, says


def hasty(chat: ModuleType) -> Any:
    """Return a model that calls a lift where there is none, and gives up."""
    turn = [0]

    def script(request: dict[str, Any]) -> Any:
        assert question(request) == "bumble_skill"
        turn[0] += 1
        return says(chat.Reply, skill=("CallElevator", "Stop")[(turn[0] - 1) % 2])

    return script


def use(server: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    for name, value in (
        ("BASE_URL", server.url),
        ("MODEL", "test"),
        ("RETRIES", "0"),
        ("REPAIRS", "0"),
        ("TIMEOUT", "5"),
    ):
        monkeypatch.setenv(f"MANSION_LLM_{name}", value)


def test_lessons_go_on_and_finished_episodes_are_not_asked_again(
    building: Path, chat: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    file = write_tasks(building, mug_task(), search_task())
    bench = Bench((file,), ("bumble",), tmp_path / "out")
    with chat.ChatServer(hasty(chat)) as server:
        use(server, monkeypatch)
        result = run_bench(bench)
        asked = len(server.requests)
        again = run_bench(bench)
        assert len(server.requests) == asked == 4
    assert again == result
    logs = [read_log(tmp_path / "out" / row.log) for row in result.episodes]
    assert logs[0].start.lessons == [] and len(logs[0].end.lessons) == 1
    assert logs[1].start.lessons == logs[0].end.lessons


def test_an_outage_keeps_what_is_finished_and_the_next_run_goes_on(
    building: Path, chat: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    file = write_tasks(building, mug_task(), search_task())
    bench = Bench((file,), ("bumble",), tmp_path / "out")
    good, asked = hasty(chat), [0]

    def failing(request: dict[str, Any]) -> Any:
        asked[0] += 1
        return good(request) if asked[0] <= 2 else chat.Reply("out of order", status=500)

    with chat.ChatServer(failing) as server:
        use(server, monkeypatch)
        with pytest.raises(MansionError) as caught:
            run_bench(bench)
    assert caught.value.code == ErrorCode.UNAVAILABLE
    assert len(list((tmp_path / "out").rglob("*.jsonl"))) == 1
    with chat.ChatServer(hasty(chat)) as server:
        use(server, monkeypatch)
        result = run_bench(bench)
        assert len(server.requests) == 2
    assert [row.task for row in result.episodes] == ["mug_up", "find_fridge"]
    assert json.loads((tmp_path / "out" / "results.json").read_text())["summary"]


def test_a_recorded_bench_repeats_without_the_model(
    building: Path, chat: ModuleType, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    file = write_tasks(building, mug_task(), search_task())
    with chat.ChatServer(hasty(chat)) as server:
        use(server, monkeypatch)
        monkeypatch.setenv("MANSION_LLM_RECORD", str(tmp_path / "tape.jsonl"))
        live = run_bench(Bench((file,), ("bumble",), tmp_path / "live"))
    monkeypatch.delenv("MANSION_LLM_RECORD")
    monkeypatch.setenv("MANSION_LLM_REPLAY", str(tmp_path / "tape.jsonl"))
    replayed = run_bench(Bench((file,), ("bumble",), tmp_path / "replayed"))
    assert len(replayed.episodes) == 2
    for one, other in zip(live.episodes, replayed.episodes):
        first = read_log(tmp_path / "live" / one.log)
        second = read_log(tmp_path / "replayed" / other.log)
        assert first.steps == second.steps and first.end.lessons == second.end.lessons
