"""The BUMBLE-style loop against a model that answers well, badly, or not at all."""

import json
from collections.abc import Callable
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from episode_tasks import MUG, mug_task
from mansion_llm import LlmClient
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.world import SkillStatus
from mansion_skills import Robot
from mansion_tasks.agents.bumble import Bumble
from mansion_tasks.agents.skill_cards import CARDS
from mansion_tasks.episodes.observations import Snapshot
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.running import EpisodeOptions, run_episode
from talk import pictures, question, says, text

Client = Callable[..., LlmClient]
PLAN: list[dict[str, Any]] = [
    {"skill": "GoToLandmark", "landmark": "L4"},
    {"skill": "Rotate", "degrees": 90},
    {"skill": "GoNearObject", "object": "the mug"},
    {"skill": "PickUp", "object": "the mug"},
    {"skill": "GoToLandmark", "landmark": "elevator"},
    {"skill": "CallElevator"},
    {"skill": "UseElevator", "target_floor": 2},
    {"skill": "GoToLandmark", "landmark": "L5"},
    {"skill": "Place", "target": "floor", "relation": "on"},
]


class FakePictures:
    """Pictures that tell what they are."""

    def view(self) -> bytes:
        return b"\x89PNG view"

    def landmarks(self) -> list[bytes]:
        return [b"\x89PNG page 1", b"\x89PNG page 2"]

    def lift_panel(self) -> bytes:
        return b"\x89PNG panel"

    def stairs(self) -> bytes:
        return b""


def fake_pictures(snapshot: Snapshot) -> FakePictures:
    return FakePictures()


def marks_of_the_mug(building: Path) -> list[str]:
    """Return the numbers that the mug has when the robot sees it first, and when it stands before it."""
    robot = Robot(building, "scout", world="scout")
    found = []
    robot.go_to_landmark("F1/office")
    robot.rotate(90)
    for _ in range(2):
        names = [thing.id for thing in robot.list_visible().objects]
        found.append(f"#{names.index(MUG) + 1}")
        robot.go_near_object(MUG)
    return found


def scripted(chat: ModuleType, building: Path, plan: list[dict[str, Any]] | None = None) -> Any:
    """Return a model that follows a plan, one skill after the other."""
    marks = marks_of_the_mug(building)
    steps = [dict(step) for step in plan or PLAN]
    at = [0]

    def script(request: dict[str, Any]) -> Any:
        step = steps[min(at[0], len(steps) - 1)]
        if question(request) == "bumble_skill":
            if not set(step) - {"skill"}:
                at[0] += 1
            return says(chat.Reply, skill=step["skill"], thought="so be it", subgoal="go on")
        at[0] += 1
        fields = {key: value for key, value in step.items() if key != "skill"}
        if fields.get("object") == "the mug":
            fields["object"] = marks.pop(0)
        return says(chat.Reply, **fields)

    return script


def test_it_does_a_task_by_numbers_alone(building: Path, chat: ModuleType, client_of: Client) -> None:
    with chat.ChatServer(scripted(chat, building)) as server:
        log = run_episode(mug_task(), building, Bumble(client_of(server)), LocalPort())
    assert log.end.success
    assert [step.call.skill for step in log.steps] == [step["skill"] for step in PLAN]
    assert log.steps[3].call.arguments == {"object": MUG}
    for request in server.requests:
        asked = text(request).replace(mug_task().instruction, "")
        assert "mug" not in asked and "F1/" not in asked and "office" not in asked


def test_the_text_variant_tells_kinds_only_while_the_skill_is_chosen(
    building: Path, chat: ModuleType, client_of: Client
) -> None:
    with chat.ChatServer(scripted(chat, building)) as server:
        agent = Bumble(client_of(server), types=True)
        log = run_episode(mug_task(), building, agent, LocalPort())
    assert log.end.success
    told = {name: [] for name in ("bumble_skill", "bumble_parameters")}
    for request in server.requests:
        asked = text(request).replace(mug_task().instruction, "")
        told[question(request)].append("desk" in asked)
        assert "F1/" not in asked
    assert any(told["bumble_skill"])
    assert not any(told["bumble_parameters"])


def test_each_question_comes_with_the_picture_that_shows_its_choices(
    building: Path, chat: ModuleType, client_of: Client
) -> None:
    options = EpisodeOptions(pictures=fake_pictures)
    with chat.ChatServer(scripted(chat, building)) as server:
        run_episode(mug_task(), building, Bumble(client_of(server)), LocalPort(), options)
    shown = [(question(request), pictures(request)) for request in server.requests]
    assert all(found == [b"\x89PNG view"] for name, found in shown if name == "bumble_skill")
    parameters = [found for name, found in shown if name == "bumble_parameters"]
    assert parameters[0] == [b"\x89PNG page 1", b"\x89PNG page 2"]
    assert [b"\x89PNG panel"] in parameters


@pytest.mark.parametrize(
    "bad",
    [
        "I would rather not.",
        "",
        "{",
        '{"skill": "FlyAway"}',
        '{"skill": 7}',
        '{"skill": "__import__"}',
        '{"landmark": "the ballroom", "object": "#99", "target_floor": 99}',
        '{"object": "F1/office/mug_1", "landmark": "F1/office"}',
        '{"skill": "PickUp", "session": "default", "object": "../../etc"}',
        "[" * 3000,
    ],
)
def test_useless_answers_are_asked_for_again_and_cost_no_more_than_a_look_around(
    building: Path, chat: ModuleType, client_of: Client, bad: str
) -> None:
    with chat.ChatServer(chat.in_turn(chat.Reply(bad))) as server:
        log = run_episode(mug_task(), building, Bumble(client_of(server)), LocalPort())
    assert log.end.stop == "agent_stopped" and "no usable answer" in log.end.reason
    assert {step.call.skill for step in log.steps} == {"Rotate"}
    assert len(log.steps) == 2 and len(server.requests) <= 12


def test_one_bad_answer_in_between_does_not_end_the_task(building: Path, chat: ModuleType, client_of: Client) -> None:
    good = scripted(chat, building)
    bad = [
        chat.Reply("what?"),
        chat.Reply("", status=500),
        chat.Reply("slow down", status=429, headers={"retry-after": "0"}),
        chat.Reply('{"skill": "Fly", "landmark": "L77", "object": "#77"}'),
        chat.Reply(raw=b"<html>"),
    ]
    asked = [0]

    def script(request: dict[str, Any]) -> Any:
        asked[0] += 1
        return bad.pop(0) if asked[0] % 3 == 1 and bad else good(request)

    with chat.ChatServer(script) as server:
        log = run_episode(mug_task(), building, Bumble(client_of(server)), LocalPort())
    assert not bad
    assert log.end.success


@pytest.mark.parametrize("kind", ["500", "429", "timeout"])
def test_an_endpoint_that_gives_no_answers_is_no_verdict_on_the_agent(
    building: Path, chat: ModuleType, client_of: Client, kind: str
) -> None:
    reply = chat.Reply("{}", delay=0.4) if kind == "timeout" else chat.Reply("no", status=int(kind))
    with chat.ChatServer(chat.in_turn(reply)) as server:
        client = client_of(server, timeout=0.1, retries=0)
        with pytest.raises(MansionError) as caught:
            run_episode(mug_task(), building, Bumble(client), LocalPort())
    assert caught.value.code == ErrorCode.UNAVAILABLE
    assert len(server.requests) <= 6


def test_failures_of_one_episode_are_told_in_the_next(building: Path, chat: ModuleType, client_of: Client) -> None:
    plan = [{"skill": "CallElevator"}, {"skill": "Stop"}]
    with chat.ChatServer(scripted(chat, building, plan)) as server:
        first = run_episode(mug_task(), building, Bumble(client_of(server)), LocalPort())
    assert first.end.stop == "agent_stopped" and first.end.claimed and not first.end.success
    assert first.steps[0].status is SkillStatus.PRECONDITION_FAILURE
    assert len(first.end.lessons) == 1 and "CallElevator" in first.end.lessons[0]
    options = EpisodeOptions(lessons=tuple(first.end.lessons))
    with chat.ChatServer(scripted(chat, building, [{"skill": "Stop"}])) as server:
        run_episode(mug_task(), building, Bumble(client_of(server)), LocalPort(), options)
    assert first.end.lessons[0] in text(server.requests[0])


def test_what_failed_before_is_told_within_the_episode(building: Path, chat: ModuleType, client_of: Client) -> None:
    plan = [{"skill": "CallElevator"}, {"skill": "Stop"}]
    with chat.ChatServer(scripted(chat, building, plan)) as server:
        run_episode(mug_task(), building, Bumble(client_of(server)), LocalPort())
    assert "CallElevator() -> PRECONDITION_FAILURE" in text(server.requests[-1])


def test_whatever_a_model_chooses_is_a_skill_with_a_card(building: Path, chat: ModuleType, client_of: Client) -> None:
    names = iter([*CARDS, "Cancel", "LoadBuilding", "ListVisible", "TakeControl"] * 10)

    def script(request: dict[str, Any]) -> Any:
        if question(request) == "bumble_skill":
            return says(chat.Reply, skill=next(names))
        return says(
            chat.Reply, landmark="elevator", object="#1", target="floor", relation="on", direction="Up",
            target_floor=2, distance=0.1, degrees=30,
        )  # fmt: skip

    with chat.ChatServer(script) as server:
        task = mug_task(max_steps=16)
        log = run_episode(task, building, Bumble(client_of(server)), LocalPort())
    assert len(log.steps) == 16
    assert {step.call.skill for step in log.steps} <= set(CARDS)
    assert json.dumps([step.notes for step in log.steps])
