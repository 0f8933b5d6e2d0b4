"""The oracle does what can be done, from wherever it is asked, and says so when nothing can be done."""

import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st

from mansion_msgs_py.task import Goal, GoalKind, SkillCall, Task, TaskKind
from mansion_tasks.tasks.oracle import Oracle
from mansion_tasks.tasks.progress import ProgressTracker
from mansion_tasks.tasks.sandbox import SESSION, Sandbox
from mansion_tasks.tasks.solving import replay, solve
from sample_building import scene

OBJECTS = [entry for floor in (1, 2, 3) for entry in scene(floor, [1, 2, 3]).objects]
CARRIED = [thing.id for thing in OBJECTS if thing.pickupable]
TABLES = [thing.id for thing in OBJECTS if thing.category in ("desk", "table")]
ROOMS = [room.id for floor in (1, 2, 3) for room in scene(floor, [1, 2, 3]).rooms]

goals = st.one_of(
    st.builds(
        lambda thing, table: [Goal(kind=GoalKind.OBJECT_ON, objects=[thing], receptacles=[table])],
        st.sampled_from(CARRIED),
        st.sampled_from(TABLES),
    ),
    st.builds(
        lambda thing, room: [Goal(kind=GoalKind.OBJECT_IN_ROOM, objects=[thing], rooms=[room])],
        st.sampled_from(CARRIED),
        st.sampled_from(ROOMS),
    ),
    st.builds(
        lambda thing, table: [
            Goal(kind=GoalKind.OBJECT_NEAR, objects=[thing], receptacles=[table]),
            Goal(kind=GoalKind.ROBOT_NEAR, receptacles=[table]),
        ],
        st.sampled_from(CARRIED),
        st.sampled_from(TABLES),
    ),
    st.builds(
        lambda thing: [Goal(kind=GoalKind.SEEN, objects=[thing]), Goal(kind=GoalKind.ROBOT_NEAR, receptacles=[thing])],
        st.sampled_from(CARRIED),
    ),
)


def a_task(*wanted: Goal) -> Task:
    return Task(id="t", kind=TaskKind.DELIVER, instruction="", goals=list(wanted))


@pytest.fixture(scope="module")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Sandbox:
    from sample_building import write_building

    return Sandbox(write_building(tmp_path_factory.mktemp("sample") / "building"))


@given(goals)
@settings(max_examples=25, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_any_thing_is_brought_anywhere_and_the_plan_does_it_again(shared: Sandbox, wanted: list[Goal]) -> None:
    task = a_task(*wanted)
    solution = solve(task, shared)
    assert solution is not None
    assert replay(task, solution.plan, shared).success


@given(goals, st.lists(st.integers(0, 6), max_size=10), st.integers(0, 2**16))
@settings(max_examples=20, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])
def test_it_goes_on_from_the_middle_of_a_mess(shared: Sandbox, wanted: list[Goal], mess: list[int], pick: int) -> None:
    task = a_task(*wanted)
    shared.reset()
    tracker = ProgressTracker(task, shared.world, SESSION)
    carried = CARRIED[pick % len(CARRIED)]
    calls = [
        ("GoToLandmark", {"landmark": "office"}),
        ("GoNearObject", {"object": carried}),
        ("PickUp", {"object": carried}),
        ("GoNearObject", {"object": f"F{shared.robot.floor}/door_1"}),
        ("CloseDoor", {}),
        ("Place", {"target": "floor"}),
        ("OpenObject", {"object": "fridge_1"}),
    ]
    for index in mess:
        shared.skill(calls[index][0], **calls[index][1])
        tracker.observe()
    oracle = Oracle(task, shared.world, SESSION)
    for _ in range(60):
        if tracker.observe().success:
            return
        call = oracle.next_call(tracker.seen)
        assert call is not None
        oracle.note(call, shared.run(call))
    pytest.fail("the oracle did not get there")


def test_it_opens_closed_doors_on_its_way(shared: Sandbox) -> None:
    shared.reset()
    for door in ("F1/door_1", "F1/door_2"):
        shared.skill("GoNearObject", object=door)
        shared.skill("CloseDoor", door=door)
    oracle = Oracle(a_task(Goal(kind=GoalKind.HOLDING, objects=["F1/office/mug_1"])), shared.world, SESSION)
    skills = []
    while (call := oracle.next_call()) is not None and len(skills) < 10:
        oracle.note(call, shared.run(call))
        skills.append(call.skill)
    assert "OpenDoor" in skills and skills[-1] == "PickUp"


def test_it_puts_down_what_is_not_wanted(shared: Sandbox) -> None:
    shared.reset()
    shared.skill("GoNearObject", object="F1/office/mug_1")
    shared.skill("PickUp", object="F1/office/mug_1")
    oracle = Oracle(a_task(Goal(kind=GoalKind.HOLDING, objects=["F1/office/ball_1"])), shared.world, SESSION)
    assert oracle.next_call() == SkillCall(skill="Place", arguments={"target": "floor", "relation": "on"})


def test_it_opens_puts_in_and_closes(shared: Sandbox) -> None:
    fridge, mug = "F2/kitchen/fridge_1", "F1/office/mug_1"
    solution = solve(
        a_task(
            Goal(kind=GoalKind.OBJECT_IN, objects=[mug], receptacles=[fridge]),
            Goal(kind=GoalKind.CLOSED, receptacles=[fridge]),
        ),
        shared,
    )
    assert solution is not None
    skills = [call.skill for call in solution.plan]
    assert skills.index("OpenObject") < skills.index("Place") < skills.index("CloseObject")
    assert solution.floors_spanned == 2


def test_it_gives_up_what_cannot_be_done(shared: Sandbox) -> None:
    on_a_mug = Goal(kind=GoalKind.OBJECT_ON, objects=["F1/office/box_1"], receptacles=["F1/office/mug_1"])
    assert solve(a_task(on_a_mug), shared) is None
    desk_in_hand = Goal(kind=GoalKind.HOLDING, objects=["F1/office/desk_1"])
    assert solve(a_task(desk_in_hand), shared) is None


def test_nothing_is_left_to_do_when_it_is_done(shared: Sandbox) -> None:
    shared.reset()
    task = a_task(Goal(kind=GoalKind.ROBOT_IN_ROOM, rooms=["F1/hall"]))
    assert Oracle(task, shared.world, SESSION).next_call() is None
    solution = solve(task, shared)
    assert solution is not None and solution.plan == [] and solution.tries == 0


def test_it_turns_away_from_a_doorway_through_which_it_put_something(shared: Sandbox) -> None:
    mug = "F1/office/mug_1"
    goal = Goal(kind=GoalKind.OBJECT_IN_ROOM, objects=[mug], rooms=["F1/kitchen"])
    shared.reset()
    shared.skill("GoNearObject", object=mug)
    shared.skill("PickUp", object=mug)
    shared.skill("MoveTo", x=6.15, y=4.45, yaw=180.0)
    oracle = Oracle(a_task(goal), shared.world, SESSION)
    down = SkillCall(skill="Place", arguments={"target": "floor", "relation": "on"})
    oracle.note(down, shared.run(down))
    assert shared.world.objects.state(mug).room == "F1/office"
    shared.skill("PickUp", object=mug)
    shared.skill("MoveTo", x=6.15, y=4.45, yaw=180.0)
    assert oracle._put_on_floor() == SkillCall(skill="Rotate", arguments={"degrees": 90.0})
