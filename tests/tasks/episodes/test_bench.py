"""A bench goes on where it ended, gives the same for any number of processes, and says how sure its figures are."""

import json
from pathlib import Path

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from typer.testing import CliRunner

from episode_tasks import mug_task, write_tasks
from mansion_bringup.cli.app import app
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.world import Progress
from mansion_tasks.agents.registry import AGENTS, make_agent
from mansion_tasks.episodes import bench as benching
from mansion_tasks.episodes.bench import TAKEN_OVER, Bench, run_bench
from mansion_tasks.episodes.results import BenchResult, bootstrap_interval, render, wilson_interval


def bench(building: Path, output: Path, *agents: str, **more: object) -> Bench:
    return Bench((write_tasks(building),), agents or ("oracle", "random"), output, **more)


def facts(result: BenchResult) -> list[tuple[object, ...]]:
    return [
        (r.agent, r.task, r.success, r.retrieval, r.navigation, r.steps, r.time, r.stop, r.log) for r in result.episodes
    ]


def test_the_oracle_succeeds_and_chance_does_not(building: Path, tmp_path: Path) -> None:
    told: list[Progress] = []
    result = run_bench(bench(building, tmp_path / "out"), progress=told.append)
    groups = {(g.agent, g.floors): g for g in result.summary}
    assert groups["oracle", 0].success == 1.0 and groups["oracle", 0].episodes == 3
    assert groups["random", 0].success < 0.5
    assert [key[1] for key in groups if key[0] == "oracle"] == [1, 2, 3, 0]
    assert [(p.done, p.total) for p in told] == [(k, 6) for k in range(1, 7)]
    assert render(result.summary).count("\n") == 9
    assert json.loads((tmp_path / "out" / "results.json").read_text())["episodes"]


def test_processes_do_not_change_the_result(building: Path, tmp_path: Path) -> None:
    told: list[Progress] = []
    one = run_bench(bench(building, tmp_path / "one"))
    two = run_bench(bench(building, tmp_path / "two"), jobs=2, progress=told.append)
    assert facts(one) == facts(two)
    assert [(p.done, p.total, p.stage) for p in told] == [(k, 6, "bench") for k in range(1, 7)]


def test_episodes_of_an_earlier_run_are_told_as_such(building: Path, tmp_path: Path) -> None:
    first = run_bench(bench(building, tmp_path / "out"))
    (tmp_path / "out" / first.episodes[2].log).unlink()
    for jobs in (1, 2):
        told: list[Progress] = []
        run_bench(bench(building, tmp_path / "out"), jobs=jobs, progress=told.append)
        assert sum(p.stage == TAKEN_OVER for p in told) == (5 if jobs == 1 else 6)
        assert len(told) == 6


def test_what_fails_in_a_process_is_raised_here(building: Path, tmp_path: Path) -> None:
    file = write_tasks(building)
    tasks = json.loads(file.read_text())
    tasks["tasks"][1]["building_id"] = "another"
    file.write_text(json.dumps(tasks))
    with pytest.raises(MansionError, match="is for building 'another'"):
        run_bench(Bench((file,), ("random", "oracle"), tmp_path / "out"), jobs=2)


def test_a_finished_episode_is_not_run_again_and_a_damaged_log_is(
    building: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    wanted = bench(building, tmp_path / "out")
    first = run_bench(wanted)
    damaged = tmp_path / "out" / first.episodes[1].log
    damaged.write_bytes(damaged.read_bytes()[:200])
    run: list[str] = []
    true_run = benching.run_episode

    def counted(task, *arguments):  # type: ignore[no-untyped-def]
        run.append(task.id)
        return true_run(task, *arguments)

    monkeypatch.setattr(benching, "run_episode", counted)
    assert facts(run_bench(wanted)) == facts(first)
    assert run == [first.episodes[1].task]
    run_bench(bench(building, tmp_path / "out", seed=1))
    assert len(run) == 7


def test_an_interrupted_bench_goes_on(building: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    wanted = bench(building, tmp_path / "out")
    true_run, left = benching.run_episode, [4]

    def interrupted(*arguments):  # type: ignore[no-untyped-def]
        left[0] -= 1
        if left[0] < 0:
            raise KeyboardInterrupt
        return true_run(*arguments)

    monkeypatch.setattr(benching, "run_episode", interrupted)
    with pytest.raises(KeyboardInterrupt):
        run_bench(wanted)
    assert not (tmp_path / "out" / "results.json").exists()
    left[0] = 2
    whole = run_bench(wanted)
    monkeypatch.undo()
    assert facts(whole) == facts(run_bench(bench(building, tmp_path / "fresh")))


def test_agents_that_do_not_exist_and_files_that_are_none_are_refused(building: Path, tmp_path: Path) -> None:
    with pytest.raises(MansionError, match="did you mean oracle\\? agents: random, oracle") as caught:
        run_bench(bench(building, tmp_path, "oracel"))
    assert caught.value.code == ErrorCode.NOT_FOUND
    with pytest.raises(MansionError) as caught:
        run_bench(Bench((tmp_path / "none.json",), ("random",), tmp_path))
    assert caught.value.code == ErrorCode.NOT_FOUND


def test_agents_that_ask_a_model_say_that_none_is_configured(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    for name in ("MANSION_LLM_BASE_URL", "MANSION_LLM_MODEL", "OPENAI_BASE_URL", "MANSION_LLM_REPLAY"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    assert [make_agent(name).name for name in AGENTS[:3]] == ["random", "oracle", "explorer"]
    with pytest.raises(MansionError) as caught:
        make_agent("bumble")
    assert caught.value.code == ErrorCode.UNAVAILABLE
    assert "take an agent of random, oracle, explorer" in str(caught.value)
    assert "planner" not in str(caught.value)


def test_the_command_prints_the_table_writes_pictures_and_repeats_a_log(building: Path, tmp_path: Path) -> None:
    file, out = write_tasks(building, mug_task()), tmp_path / "out"
    runner = CliRunner()
    command = ["bench", "agents", "--tasks", str(file.parent), "--agents", "explorer", "-o", str(out)]
    done = runner.invoke(app, [*command, "--sheets", "1"])
    assert done.exit_code == 0, done.output
    assert "| explorer | 2 | 1 | 100.0" in done.output
    assert len(list((out / "sheets").iterdir())) == 2
    log = next(out.rglob("*.jsonl"))
    again = runner.invoke(app, ["bench", "agents", "--replay", str(log)])
    assert again.exit_code == 0 and again.output.startswith("the same: 8 skills")
    log.write_text(log.read_text().replace('"digest":"', '"digest":"x'))
    assert runner.invoke(app, ["bench", "agents", "--replay", str(log)]).exit_code == 1


@given(st.integers(1, 400), st.data())
@settings(max_examples=60, deadline=None)
def test_the_score_interval_holds_the_rate_and_narrows(trials: int, data: st.DataObject) -> None:
    successes = data.draw(st.integers(0, trials))
    low, high = wilson_interval(successes, trials)
    assert 0.0 <= low <= successes / trials <= high <= 1.0
    wider = wilson_interval(successes * 10, trials * 10)
    assert wider[1] - wider[0] < high - low


@given(st.lists(st.floats(0.0, 1.0), min_size=1, max_size=30))
@settings(max_examples=30, deadline=None)
def test_the_bootstrap_interval_lies_within_the_values(values: list[float]) -> None:
    low, high = bootstrap_interval(values)
    assert min(values) - 1e-9 <= low <= high <= max(values) + 1e-9
    assert bootstrap_interval(values) == (low, high)
