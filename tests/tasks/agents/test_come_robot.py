"""The COME-robot-style loop: plans as code, run, refined, and refused where they are more than calls."""

from collections.abc import Callable
from pathlib import Path
from types import ModuleType

import pytest

from episode_tasks import MUG, mug_task
from mansion_llm import LlmClient
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.world import SkillStatus
from mansion_tasks.agents.come_robot import MAX_PLANS, ComeRobot, map_text
from mansion_tasks.agents.interface import MapEntry
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.running import run_episode
from talk import says, text

Client = Callable[..., LlmClient]
FETCH = f'GoNearObject("{MUG}")\nPickUp("{MUG}")\n'
RIDE = 'GoToLandmark("elevator")\nCallElevator()\nUseElevator(2)\n'
DELIVER = 'GoToLandmark("F2/kitchen")\nPlace("floor", "on")\n'


def test_a_good_plan_is_run_to_its_end(building: Path, chat: ModuleType, client_of: Client) -> None:
    reply = says(chat.Reply, thought="easy", code=FETCH + RIDE + DELIVER)
    with chat.ChatServer(chat.in_turn(reply)) as server:
        log = run_episode(mug_task(), building, ComeRobot(client_of(server)), LocalPort())
    assert log.end.success and len(server.requests) == 1
    assert MUG in text(server.requests[0]) and "F3/kitchen/fridge_1" in text(server.requests[0])


def test_a_failed_call_drops_the_rest_and_is_told_in_the_next_question(
    building: Path, chat: ModuleType, client_of: Client
) -> None:
    plans = [FETCH + "CallElevator()\nUseElevator(2)\n" + DELIVER, RIDE + DELIVER]
    script = chat.in_turn(*(says(chat.Reply, code=code) for code in plans))
    with chat.ChatServer(script) as server:
        log = run_episode(mug_task(), building, ComeRobot(client_of(server)), LocalPort())
    assert log.end.success and len(server.requests) == 2
    assert [step.status for step in log.steps].count(SkillStatus.PRECONDITION_FAILURE) == 1
    told = text(server.requests[1])
    assert "CallElevator() -> PRECONDITION_FAILURE" in told and "3 calls) was dropped" in told


def test_a_hallucinated_object_fails_as_a_skill_and_the_loop_goes_on(
    building: Path, chat: ModuleType, client_of: Client
) -> None:
    script = chat.in_turn(
        says(chat.Reply, code='GoNearObject("F1/ballroom/piano_1")'), says(chat.Reply, code=FETCH + RIDE + DELIVER)
    )
    with chat.ChatServer(script) as server:
        log = run_episode(mug_task(), building, ComeRobot(client_of(server)), LocalPort())
    assert log.steps[0].status is SkillStatus.INVALID_ACTION
    assert log.end.success


@pytest.mark.parametrize(
    "code", ['import os\nos.system("touch broken")', 'open("broken", "w")', "exec('1')", "while True: pass", ""]
)
def test_code_that_is_more_than_calls_is_repaired_or_given_up_and_never_runs(
    building: Path, chat: ModuleType, client_of: Client, code: str, tmp_path: Path,
    monkeypatch: pytest.MonkeyPatch,
) -> None:  # fmt: skip
    monkeypatch.chdir(tmp_path)
    with chat.ChatServer(chat.in_turn(says(chat.Reply, code=code))) as server:
        log = run_episode(mug_task(), building, ComeRobot(client_of(server)), LocalPort())
    assert log.end.stop == "agent_stopped" and log.steps == []
    assert len(server.requests) == 6
    assert not (tmp_path / "broken").exists()


def test_plans_that_lead_nowhere_end(building: Path, chat: ModuleType, client_of: Client) -> None:
    with chat.ChatServer(chat.in_turn(says(chat.Reply, code="Rotate(90)"))) as server:
        log = run_episode(mug_task(), building, ComeRobot(client_of(server)), LocalPort())
    assert len(server.requests) == MAX_PLANS
    assert log.end.stop == "agent_stopped" and len(log.steps) == MAX_PLANS


def test_the_model_may_say_that_it_is_done(building: Path, chat: ModuleType, client_of: Client) -> None:
    with chat.ChatServer(chat.in_turn(says(chat.Reply, thought="all there", done=True))) as server:
        log = run_episode(mug_task(), building, ComeRobot(client_of(server)), LocalPort())
    assert (log.end.claimed, log.end.success, log.end.reason) == (True, False, "all there")


def test_an_endpoint_that_refuses_the_key_ends_the_run(building: Path, chat: ModuleType, client_of: Client) -> None:
    with chat.ChatServer(chat.in_turn(chat.Reply("no", status=401))) as server, pytest.raises(MansionError) as caught:
        run_episode(mug_task(), building, ComeRobot(client_of(server)), LocalPort())
    assert caught.value.code == ErrorCode.UNAVAILABLE


def test_what_a_long_map_leaves_out_is_counted() -> None:
    entries = [
        MapEntry(f"F1/room_{k}/thing_{j}", "thing", "", 1, f"F1/room_{k}", "") for k in range(60) for j in range(40)
    ]
    shown = map_text(entries)
    left_out = int(shown.rsplit("(", 1)[1].split()[0])
    assert shown.count("F1/room_") - shown.count("floor 1, ") == len(entries) - left_out
    assert len(shown) < 41_000
