"""Progress tells retrieval and navigation apart, never falls, and is complete with success."""

from pathlib import Path

import pytest

from mansion_msgs_py.task import Goal, GoalKind, ProgressScore, Task, TaskKind
from mansion_tasks.tasks.progress import ProgressTracker
from mansion_tasks.tasks.sandbox import SESSION, Sandbox

MUG = "F2/office/mug_1"


@pytest.fixture
def sandbox(building: Path) -> Sandbox:
    return Sandbox(building)


def deliver() -> Task:
    goal = Goal(kind=GoalKind.OBJECT_IN_ROOM, objects=[MUG], rooms=["F3/kitchen"])
    return Task(id="t", kind=TaskKind.DELIVER, instruction="", goals=[goal])


def scores(sandbox: Sandbox, task: Task, skills: list[tuple[str, dict[str, object]]]) -> list[str]:
    tracker = ProgressTracker(task, sandbox.world, SESSION)
    tracker.observe()
    found = []
    for skill, arguments in skills:
        sandbox.skill(skill, **arguments)
        score = tracker.observe()
        found.append(f"{score.retrieval:g} {score.navigation:g} {score.success}")
    return found


UP = ("TakeStairs", {"direction": "Up"})
TO_STAIRS = ("GoToLandmark", {"landmark": "stairs"})


def test_each_part_of_a_delivery_counts_once(sandbox: Sandbox) -> None:
    steps = [
        TO_STAIRS,
        UP,
        ("GoNearObject", {"object": MUG}),
        ("PickUp", {"object": MUG}),
        TO_STAIRS,
        UP,
        ("GoToLandmark", {"landmark": "kitchen"}),
        ("Place", {"target": "floor"}),
    ]
    assert scores(sandbox, deliver(), steps) == [
        "0 0 False",
        "0 0.25 False",
        "0.5 0.5 False",
        "1 0.5 False",
        "1 0.5 False",
        "1 0.75 False",
        "1 1 False",
        "1 1 True",
    ]


def test_who_walks_the_way_with_an_empty_hand_has_navigated_only(sandbox: Sandbox) -> None:
    steps = [TO_STAIRS, UP, ("GoToLandmark", {"landmark": "office"}), TO_STAIRS, UP]
    steps.append(("GoToLandmark", {"landmark": "kitchen"}))
    assert scores(sandbox, deliver(), steps)[-1] == "0 1 False"


def test_the_destination_counts_only_after_the_source(sandbox: Sandbox) -> None:
    steps = [TO_STAIRS, UP, UP, ("GoToLandmark", {"landmark": "kitchen"})]
    assert scores(sandbox, deliver(), steps)[-1] == "0 0.25 False"


def test_standing_still_is_no_progress(sandbox: Sandbox) -> None:
    tracker = ProgressTracker(deliver(), sandbox.world, SESSION)
    assert tracker.observe() == ProgressScore() == tracker.observe()


def test_a_search_is_done_before_the_thing(sandbox: Sandbox) -> None:
    goals = [
        Goal(kind=GoalKind.SEEN, objects=["F1/office/mug_1"]),
        Goal(kind=GoalKind.ROBOT_NEAR, receptacles=["F1/office/mug_1"]),
    ]
    task = Task(id="t", kind=TaskKind.SEARCH, instruction="", goals=goals)
    steps = [("GoToLandmark", {"landmark": "office"}), ("GoNearObject", {"object": "desk_1"})]
    assert scores(sandbox, task, steps)[-1] == "1 1 True"


def test_a_view_that_the_caller_took_gives_the_same_score(sandbox: Sandbox) -> None:
    task = deliver()
    ours = ProgressTracker(task, sandbox.world, SESSION)
    theirs = ProgressTracker(task, sandbox.world, SESSION)
    for skill, arguments in [TO_STAIRS, UP, ("GoNearObject", {"object": MUG})]:
        sandbox.skill(skill, **arguments)
        near = {MUG: 1.0} if sandbox.robot.floor == 2 and skill == "GoNearObject" else {}
        assert ours.observe() == theirs.observe(near)
    assert ours.seen == theirs.seen == {MUG}
