"""Agents try the tasks of a world; the manifest has a row for each trial, and the statistics their success."""

import json
import shutil
from pathlib import Path

import pytest
from typer.testing import CliRunner

from mansion_bringup.cli.app import app
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_world.records import Trial
from mansion_world.statistics import AGENTS, world_statistics
from mansion_world.statistics_page import statistics_page
from mansion_world.trials import read_trials, task_sets, tried_tasks, write_trials
from mansion_world.world_folder import WorldFolder


@pytest.fixture
def world(small_world: Path, tmp_path: Path) -> WorldFolder:
    return WorldFolder(shutil.copytree(small_world, tmp_path / "world"))


def trial(building: str, task: str, *, success: bool, agent: str = "explorer") -> Trial:
    return Trial(
        building=building, task=task, agent=agent, success=success, retrieval=1.0, navigation=1.0, steps=4, seconds=9.0
    )


def test_the_command_tries_every_task_with_every_agent(world: WorldFolder) -> None:
    command = ["world", "agents", str(world.path), "--agents", "random,oracle", "--jobs", "1"]
    done = CliRunner().invoke(app, command)
    assert done.exit_code == 0, done.output
    trials = list(read_trials(world))
    tasks = [(task.building, task.id) for record in world.records() for task in record.tasks]
    assert [(one.building, one.task) for one in trials if one.agent == "oracle"] == tasks
    assert len(trials) == 2 * len(tasks)
    assert all(one.success for one in trials if one.agent == "oracle")
    assert CliRunner().invoke(app, command).exit_code == 0
    assert list(read_trials(world)) == trials
    shown = CliRunner().invoke(app, ["world", "stats", str(world.path), "--json", "--no-page"])
    assert all(text.startswith("100.0%") for name, text in json.loads(shown.stdout)[AGENTS].items() if "oracle" in name)


def test_success_is_counted_by_agent_and_difficulty(world: WorldFolder) -> None:
    rows = [task for record in world.records() for task in record.tasks if task.difficulty == "easy"]
    write_trials(world, [trial(task.building, task.id, success=task is rows[0]) for task in rows])
    statistics = world_statistics(world)
    assert statistics.success() == {("explorer", "easy"): pytest.approx(1 / len(rows))}
    assert f"of {len(rows)}" in statistics_page(world, statistics)


def test_trials_of_tasks_that_are_gone_count_nothing(world: WorldFolder) -> None:
    assert list(tried_tasks(world, [trial("another", "deliver_1", success=True)])) == []


def test_a_world_that_nobody_tried_has_no_table_of_agents(world: WorldFolder) -> None:
    assert list(read_trials(world)) == []
    assert world_statistics(world).tables()[AGENTS] == []


def test_only_the_first_buildings_are_tried_where_a_number_is_given(world: WorldFolder) -> None:
    assert len(task_sets(world, 2)) == 2
    assert len(task_sets(world)) == 3


def test_a_folder_without_tasks_is_refused(tmp_path: Path) -> None:
    with pytest.raises(MansionError) as refused:
        task_sets(WorldFolder(tmp_path))
    assert refused.value.code == ErrorCode.NOT_FOUND


def test_an_unknown_agent_is_refused_before_anything_runs(world: WorldFolder) -> None:
    done = CliRunner().invoke(app, ["world", "agents", str(world.path), "--agents", "nobody"])
    assert done.exit_code != 0
    assert not (world.path / "agents").exists()
