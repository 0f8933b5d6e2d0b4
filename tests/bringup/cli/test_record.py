"""``mansion record``: episodes and tasks from the shell."""

import json
from pathlib import Path

import pytest
from typer.testing import CliRunner

from episode_tasks import mug_task
from mansion_bringup.cli.app import app
from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.task import TaskSet
from mansion_tasks.agents.baselines import OracleAgent
from mansion_tasks.episodes.log import write_log
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.running import EpisodeOptions, run_episode
from sample_building import write_building

pytest.importorskip("mcap_ros2")


@pytest.fixture
def place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder with a building, a task set of it and the log of an episode."""
    monkeypatch.chdir(tmp_path)
    write_building(tmp_path / "sample")
    tasks = TaskSet(building="sample", building_id="sample", tasks=[mug_task()])
    (tmp_path / "tasks.json").write_bytes(encode_bytes(tasks))
    options = EpisodeOptions(building="sample")
    write_log(tmp_path / "log.jsonl", run_episode(mug_task(), tmp_path / "sample", OracleAgent(), LocalPort(), options))
    return tmp_path


def test_a_task_and_the_log_of_the_same_episode_give_the_same_messages(place: Path) -> None:
    run = CliRunner()
    first = run.invoke(app, ["record", "task", "tasks.json", "mug_up", "-o", "task.mcap", "--json"])
    second = run.invoke(app, ["record", "episode", "log.jsonl", "-o", "episode.mcap", "--json"])
    made = json.loads(first.stdout)
    assert made["messages"] == json.loads(second.stdout)["messages"]
    assert made["messages"]["/mansion/robot_pose"] == made["messages"]["/mansion/skill_events"] + 1
    assert (place / "task.mcap").read_bytes()[:5] == b"\x89MCAP"


def test_a_name_that_ends_in_rrd_makes_a_recording_for_rerun(place: Path) -> None:
    pytest.importorskip("rerun")
    run = CliRunner()
    made = run.invoke(app, ["record", "task", "tasks.json", "mug_up", "-o", "task.rrd", "--json"])
    same = run.invoke(app, ["record", "episode", "log.jsonl", "-o", "episode.mcap", "--json"])
    assert json.loads(made.stdout)["messages"] == json.loads(same.stdout)["messages"]
    assert (place / "task.rrd").read_bytes()[:3] == b"RRF"


def test_what_is_not_there_is_named(place: Path) -> None:
    run = CliRunner()
    for words, said in (
        (["record", "task", "tasks.json", "mug_down", "-o", "x.mcap"], "tasks: mug_up"),
        (["record", "episode", "none.jsonl", "-o", "x.mcap"], "none.jsonl"),
        (["record", "episode", "log.jsonl", "-b", "elsewhere", "-o", "x.mcap"], "elsewhere"),
        (["record", "episode", "log.jsonl", "-o", "sample"], "it is a folder"),
    ):
        done = run.invoke(app, words)
        assert isinstance(done.exception, MansionError) and said in str(done.exception)
    assert not (place / "x.mcap").exists()
