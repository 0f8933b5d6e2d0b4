"""An episode is judged by its goals, bounded, and leaves the building as it was."""

import hashlib
from pathlib import Path
from typing import Any

import pytest

from episode_tasks import MUG, apple_task, call, mug_task, search_task
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import SkillCall, TaskStart
from mansion_msgs_py.world import Pose2D, SkillStatus
from mansion_skills import Robot
from mansion_tasks.agents.baselines import OracleAgent, RandomAgent
from mansion_tasks.agents.explorer import Explorer
from mansion_tasks.agents.interface import Access, Observation, Stop
from mansion_tasks.episodes.port import LocalPort
from mansion_tasks.episodes.running import EpisodeOptions, run_episode


class Scripted(OracleAgent):
    """Does what a test tells it."""

    name = "scripted"

    def __init__(self, *choices: SkillCall | Stop | MansionError, access: Access | None = None) -> None:
        self.choices = list(choices)
        self.seen: list[Observation] = []
        self.access = access or Access()

    def reset(self, briefing: object) -> None:
        self.briefing = briefing

    def act(self, observation: Observation) -> SkillCall | Stop:
        self.seen.append(observation)
        choice = self.choices.pop(0) if self.choices else Stop("that was all")
        if isinstance(choice, MansionError):
            raise choice
        return choice


def digest(folder: Path) -> dict[str, str]:
    return {
        str(path.relative_to(folder)): hashlib.sha256(path.read_bytes()).hexdigest()
        for path in sorted(folder.rglob("*"))
        if path.is_file()
    }


@pytest.mark.parametrize("task", [mug_task(), apple_task(), search_task()], ids=lambda t: t.id)
def test_the_oracle_does_every_task_and_the_building_stays_as_it_is(building: Path, task: object) -> None:
    before = digest(building)
    log = run_episode(task, building, OracleAgent(), LocalPort())
    end = log.end
    assert (end.success, end.retrieval, end.navigation, end.stop) == (True, 1.0, 1.0, "success")
    assert digest(building) == before


@pytest.mark.parametrize("task", [mug_task(), apple_task(), search_task()], ids=lambda t: t.id)
def test_the_explorer_does_them_without_the_plan(building: Path, task: object) -> None:
    log = run_episode(task, building, Explorer(), LocalPort())
    assert log.end.success
    assert all(step.status is SkillStatus.SUCCESS for step in log.steps)


def test_what_others_left_in_the_building_is_not_seen(building: Path) -> None:
    robot = Robot(building)
    robot.go_near_object(MUG)
    assert robot.pick_up(MUG).status is SkillStatus.SUCCESS
    assert run_episode(mug_task(), building, OracleAgent(), LocalPort()).end.success
    assert robot.where_am_i().held == MUG


def test_chance_is_the_same_for_the_same_seed_and_another_for_another(building: Path) -> None:
    runs = [
        run_episode(mug_task(), building, RandomAgent(), LocalPort(), EpisodeOptions(seed=seed)) for seed in (1, 1, 2)
    ]
    assert runs[0].steps == runs[1].steps
    assert runs[0].end.digest == runs[1].end.digest
    assert runs[0].steps != runs[2].steps


def test_the_limit_of_steps_holds(building: Path) -> None:
    turns = [call("Rotate", degrees=10)] * 9
    log = run_episode(mug_task(max_steps=5), building, Scripted(*turns), LocalPort())
    assert (log.end.stop, log.end.steps, log.end.success) == ("step_limit", 5, False)


def test_an_agents_claim_is_recorded_and_not_believed(building: Path) -> None:
    log = run_episode(mug_task(), building, Scripted(Stop("done!", done=True)), LocalPort())
    assert (log.end.stop, log.end.claimed, log.end.success) == ("agent_stopped", True, False)


def test_an_agent_that_fails_ends_its_episode(building: Path) -> None:
    fault = MansionError(ErrorCode.INTERNAL, "no idea")
    log = run_episode(mug_task(), building, Scripted(fault), LocalPort())
    assert (log.end.stop, log.end.success) == ("agent_failed", False)
    assert "no idea" in log.end.reason


def test_a_fault_in_an_agents_code_ends_its_episode_and_names_the_line(building: Path) -> None:
    class Faulty(Scripted):
        def act(self, observation: Any) -> Any:
            return [][len("no moves left")]

    log = run_episode(mug_task(), building, Faulty(Stop("never")), LocalPort())
    assert (log.end.stop, log.end.success) == ("agent_failed", False)
    assert log.end.reason.startswith("IndexError: list index out of range (test_running.py, line ")


@pytest.mark.parametrize(("choice", "got"), [("hello", "str"), (None, "NoneType"), ({}, "dict")])
def test_an_agent_that_returns_another_type_ends_its_episode(building: Path, choice: Any, got: str) -> None:
    log = run_episode(mug_task(), building, Scripted(choice), LocalPort())
    assert (log.end.stop, log.end.success, log.end.steps) == ("agent_failed", False, 0)
    assert log.end.reason == f"act() returned {got}; accepted: SkillCall or Stop"


def test_what_the_agent_needs_and_is_not_there_ends_the_run(building: Path) -> None:
    fault = MansionError(ErrorCode.UNAVAILABLE, "no model")
    with pytest.raises(MansionError, match="no model"):
        run_episode(mug_task(), building, Scripted(fault), LocalPort())


def test_a_task_of_another_building_is_refused(building: Path) -> None:
    with pytest.raises(MansionError) as caught:
        run_episode(mug_task(building_id="elsewhere"), building, Scripted(), LocalPort())
    assert caught.value.code == ErrorCode.CONFLICT


def test_a_start_on_a_floor_that_is_not_there_is_refused(building: Path) -> None:
    task = mug_task(start=TaskStart(floor=9, pose=Pose2D(x=1, y=1)))
    with pytest.raises(MansionError) as caught:
        run_episode(task, building, Scripted(), LocalPort())
    assert (caught.value.code, caught.value.info.path) == (ErrorCode.NOT_FOUND, "$.start.floor")


def test_the_robot_starts_where_the_task_says(building: Path) -> None:
    agent = Scripted()
    start = TaskStart(floor=3, pose=Pose2D(x=2.0, y=1.0, yaw=90.0))
    run_episode(mug_task(start=start), building, agent, LocalPort())
    assert (agent.seen[0].floor, agent.seen[0].pose) == (3, start.pose)


@pytest.mark.parametrize(
    "bad",
    [
        call("FlyAway"),
        call("Rotate", degrees="a lot"),
        call("Rotate", speed=3),
        call("Rotate", session="default"),
        call("PickUp", object=MUG, token="x"),
        call("PickUp"),
        call("PickUp", name="x", self="y"),
        call("take_control", client="me"),
        call("Cancel"),
    ],
)
def test_a_call_that_is_none_is_an_invalid_action_and_a_step(building: Path, bad: SkillCall) -> None:
    log = run_episode(mug_task(), building, Scripted(bad), LocalPort())
    assert log.steps[0].status is SkillStatus.INVALID_ACTION
    assert log.end.steps == 1


def test_only_the_oracle_is_given_the_plan_and_only_maps_users_a_map(building: Path) -> None:
    plain, mapped = Scripted(), Scripted(access=Access(object_map=True))
    for agent in (plain, mapped):
        run_episode(mug_task(), building, agent, LocalPort())
        assert agent.briefing.plan == ()
    assert plain.seen[0].object_map() == []
    assert MUG in [entry.id for entry in mapped.seen[0].object_map()]
    oracle = Scripted(access=Access(plan=True))
    run_episode(mug_task(), building, oracle, LocalPort())
    assert oracle.briefing.plan == tuple(mug_task().oracle)


def test_an_agent_without_names_gets_numbers_and_may_use_nothing_else(building: Path) -> None:
    agent = Scripted(
        call("GoToLandmark", landmark="L4"),
        call("Rotate", degrees=90),
        call("GoNearObject", object="#1"),
        call("PickUp", object=MUG),
        call("GoToLandmark", landmark="F1/kitchen"),
        call("GoNearObject", object="#999"),
        access=Access(names=False, categories=False),
    )
    log = run_episode(mug_task(), building, agent, LocalPort())
    statuses = [step.status for step in log.steps]
    assert statuses == [SkillStatus.SUCCESS] * 3 + [SkillStatus.INVALID_ACTION] * 3
    assert [step.refused for step in log.steps] == [False] * 3 + [True] * 3
    for seen in agent.seen:
        said = [seen.room, seen.held, *(entry.name for entry in seen.landmarks)]
        for thing in seen.visible:
            said += [thing.ref, thing.room, thing.parent, thing.category, thing.color]
        if seen.last is not None:
            assert seen.last.state is None and seen.last.changed == []
            said += [seen.last.message, seen.last.satisfied_by]
        assert not any("F1/" in word or "mug" in word or "office" in word for word in said)
