"""An agent that runs into a corner gets out of it (the first failure case of section F.5)."""

import json
from collections.abc import Callable
from math import dist
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from episode_tasks import mug_task, search_task
from mansion_llm import LlmClient
from mansion_msgs_py.task import SkillCall
from mansion_msgs_py.world import Pose2D, SkillResult, SkillStatus
from mansion_tasks.agents.bumble import Bumble
from mansion_tasks.agents.explorer import Explorer
from mansion_tasks.agents.interface import Observation
from mansion_tasks.agents.recovery import CornerRecovery, escape_moves
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.running import run_episode

CORNER = search_task().start


def blocked(**free: float) -> SkillResult:
    return SkillResult(
        skill="MoveAhead",
        status=SkillStatus.EXECUTION_FAILURE,
        message="only 0.00 m of 1.00 m are free",
        data={"free": {"ahead": 0.0, "left": 0.0, "back": 0.0, "right": 0.0, **free}},
    )


@pytest.mark.parametrize(
    ("free", "turn", "distance"),
    [({"back": 3.0}, 180.0, 1.5), ({"left": 0.8}, 90.0, 0.75), ({"right": 2.0, "left": 1.0}, -90.0, 1.5)],
)
def test_the_way_out_leads_where_most_is_free(free: dict[str, float], turn: float, distance: float) -> None:
    way = escape_moves(blocked(**free))
    assert way is not None
    assert [call.arguments for call in way] == [{"degrees": turn}, {"distance": distance}]


def test_without_free_space_there_is_no_way_out_to_name() -> None:
    assert escape_moves(blocked()) is None
    assert escape_moves(None) is None


def test_one_blocked_move_is_the_agents_own_affair() -> None:
    watch = CornerRecovery()
    move = SkillCall(skill="MoveAhead", arguments={"distance": 1.0})
    seen = Observation("", 1, 9, 1, (1,), Pose2D(x=0, y=0), last_call=move, last=blocked(back=2.0))
    assert watch.step(seen) is None
    turned = SkillResult(skill="Rotate", status=SkillStatus.SUCCESS, message="")
    rotate = SkillCall(skill="Rotate")
    assert watch.step(Observation("", 2, 9, 1, (1,), Pose2D(x=0, y=0), last_call=rotate, last=turned)) is None
    assert watch.step(seen) == SkillCall(skill="Rotate", arguments={"degrees": 180.0})


def test_a_model_that_only_drives_ahead_is_led_out_of_the_corner(
    building: Path, chat: ModuleType, client_of: Callable[..., LlmClient]
) -> None:
    def stubborn(request: dict[str, Any]) -> Any:
        parameters = "parameters" in json.dumps(request.get("response_format", ""))
        answer = {"distance": 2.0} if parameters else {"skill": "MoveAhead"}
        return chat.Reply(json.dumps(answer))

    task = mug_task(start=CORNER, max_steps=8)
    with chat.ChatServer(stubborn) as server:
        log = run_episode(task, building, Bumble(client_of(server)), LocalPort())
    skills = [step.call.skill for step in log.steps]
    assert skills[:5] == ["MoveAhead", "MoveAhead", "Rotate", "MoveAhead", "GoToLandmark"]
    assert [step.status for step in log.steps[2:5]] == [SkillStatus.SUCCESS] * 3
    assert CORNER is not None
    corner = (CORNER.pose.x, CORNER.pose.y)
    assert dist(corner, (log.steps[3].pose.x, log.steps[3].pose.y)) > 1.0


def test_the_explorer_starts_in_a_corner_and_finds_its_way(building: Path) -> None:
    log = run_episode(search_task(), building, Explorer(), LocalPort())
    assert log.end.success
