"""Logs hold all that a repetition needs; a repetition that differs is told."""

from collections.abc import Callable
from pathlib import Path

import msgspec
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from episode_tasks import call, mug_task, search_task
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.world import Pose2D, SkillStatus
from mansion_tasks.agents.baselines import RandomAgent
from mansion_tasks.agents.explorer import Explorer
from mansion_tasks.agents.interface import Agent
from mansion_tasks.episodes.contact_sheet import chosen_steps, episode_frames, write_contact_sheet, write_gif
from mansion_tasks.episodes.log import EpisodeLog, EpisodeStep, read_log, write_log
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.replaying import replay
from mansion_tasks.episodes.running import run_episode


@pytest.mark.parametrize("agent", [RandomAgent(), Explorer()], ids=lambda agent: agent.name)
def test_a_log_read_back_repeats_to_the_same_result(building: Path, tmp_path: Path, agent: Agent) -> None:
    log = run_episode(mug_task(), building, agent, LocalPort())
    write_log(tmp_path / "log.jsonl", log)
    read = read_log(tmp_path / "log.jsonl")
    assert read == log
    assert replay(read, building, LocalPort()) == []


def with_step(log: EpisodeLog, index: int, **changes: object) -> EpisodeLog:
    steps = [msgspec.structs.replace(step, **changes) if i == index else step for i, step in enumerate(log.steps)]
    return msgspec.structs.replace(log, steps=steps)


def with_end(log: EpisodeLog, **changes: object) -> EpisodeLog:
    return msgspec.structs.replace(log, end=msgspec.structs.replace(log.end, **changes))


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda log: with_step(log, 2, call=call("GoNearObject", object="F1/office/lamp_1")), "step 4, PickUp"),
        (lambda log: msgspec.structs.replace(log, steps=log.steps[:-1]), "success is False"),
        (lambda log: with_end(log, retrieval=0.25), "retrieval and navigation"),
        (lambda log: with_end(log, digest="0"), "the world differs at the end"),
        (lambda log: with_step(log, 0, status=SkillStatus.CANCELED), "step 1, GoToLandmark"),
    ],
)
def test_a_log_that_was_changed_is_found_out(
    building: Path, change: Callable[[EpisodeLog], EpisodeLog], told: str
) -> None:
    log = run_episode(mug_task(), building, Explorer(), LocalPort())
    differences = replay(change(log), building, LocalPort())
    assert any(told in line for line in differences), differences


def test_what_is_no_whole_log_is_refused(building: Path, tmp_path: Path) -> None:
    log = run_episode(mug_task(max_steps=2), building, RandomAgent(), LocalPort())
    path = tmp_path / "log.jsonl"
    write_log(path, log)
    lines = path.read_bytes().splitlines()
    for broken in (lines[:-1], lines[1:], [*lines, lines[-1]], [b'{"line": "poem"}'], []):
        path.write_bytes(b"\n".join(broken))
        with pytest.raises(MansionError) as caught:
            read_log(path)
        assert caught.value.code == ErrorCode.INVALID_PAYLOAD
    with pytest.raises(MansionError) as caught:
        read_log(tmp_path / "none.jsonl")
    assert caught.value.code == ErrorCode.NOT_FOUND


def test_every_line_of_a_log_says_what_it_is(building: Path, tmp_path: Path) -> None:
    log = run_episode(mug_task(max_steps=3), building, RandomAgent(), LocalPort())
    write_log(tmp_path / "log.jsonl", log)
    kinds = [msgspec.json.decode(line)["line"] for line in (tmp_path / "log.jsonl").read_bytes().splitlines()]
    assert kinds == ["start", "step", "step", "step", "end"]


def step(number: int, skill: str) -> EpisodeStep:
    return EpisodeStep(
        step=number, call=call(skill), status=SkillStatus.SUCCESS, message="", floor=1,
        pose=Pose2D(x=0, y=0), room=None, held=None, time=0.0, retrieval=0.0, navigation=0.0,
    )  # fmt: skip


@given(st.lists(st.sampled_from(["Rotate", "PickUp", "GoToLandmark", "Place"]), max_size=80))
@settings(max_examples=50, deadline=None)
def test_a_sheet_shows_start_and_end_and_no_more_than_it_can(skills: list[str]) -> None:
    steps = [step(k, skill) for k, skill in enumerate(skills, start=1)]
    chosen = chosen_steps(steps)
    assert chosen == sorted(set(chosen))
    assert chosen[0] == 0 and chosen[-1] == len(steps)
    assert len(chosen) == min(12, len(steps) + 1)
    telling = [k for k, skill in enumerate(skills, start=1) if skill in ("PickUp", "Place")]
    if len(telling) <= 10:
        assert set(telling) <= set(chosen)


def test_pictures_of_an_episode_are_made_without_a_renderer(building: Path, tmp_path: Path) -> None:
    from PIL import Image

    log = run_episode(search_task(), building, Explorer(), LocalPort())
    frames = episode_frames(log, building, LocalPort())
    assert len(frames) == min(12, len(log.steps) + 1)
    write_contact_sheet(tmp_path / "sheet.png", log, frames)
    write_gif(tmp_path / "sheet.gif", frames)
    with Image.open(tmp_path / "sheet.png") as sheet:
        assert sheet.width > 900 and len(sheet.convert("RGB").getcolors(1 << 20)) > 10
    with Image.open(tmp_path / "sheet.gif") as animation:
        assert animation.n_frames > 1
