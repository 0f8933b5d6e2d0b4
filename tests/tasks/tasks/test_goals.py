"""Goals are statements about the world, and hold exactly when the world is so."""

from pathlib import Path

import pytest

from mansion_msgs_py.errors import MansionError
from mansion_msgs_py.task import Goal, GoalKind, Task, TaskKind, TaskStart
from mansion_msgs_py.world import Pose2D
from mansion_tasks.tasks.goals import done, holds, unmet_goals
from mansion_tasks.tasks.sandbox import SESSION, Sandbox

MUG, DESK, BOX = "F1/office/mug_1", "F1/office/desk_1", "F1/office/box_1"
BALL, FRIDGE, APPLE = "F1/office/ball_1", "F1/kitchen/fridge_1", "F1/kitchen/apple_1"
TABLE = "F1/kitchen/table_1"


@pytest.fixture
def sandbox(building: Path) -> Sandbox:
    return Sandbox(building)


def check(sandbox: Sandbox, kind: GoalKind, **more: object) -> bool:
    return holds(Goal(kind=kind, **more), sandbox.world, SESSION)


def test_an_object_is_in_its_room_until_it_is_in_the_hand(sandbox: Sandbox) -> None:
    in_office = {"objects": [MUG], "rooms": ["F1/office"]}
    assert check(sandbox, GoalKind.OBJECT_IN_ROOM, **in_office)
    assert not check(sandbox, GoalKind.OBJECT_IN_ROOM, objects=[MUG], rooms=["F2/office"])
    sandbox.skill("GoNearObject", object=MUG)
    sandbox.skill("PickUp", object=MUG)
    assert not check(sandbox, GoalKind.OBJECT_IN_ROOM, **in_office)
    assert check(sandbox, GoalKind.HOLDING, objects=["F2/office/mug_1", MUG])
    assert not check(sandbox, GoalKind.HOLDING, objects=[BALL])


def test_on_and_in_are_not_the_same(sandbox: Sandbox) -> None:
    assert check(sandbox, GoalKind.OBJECT_ON, objects=[MUG], receptacles=[DESK])
    assert not check(sandbox, GoalKind.OBJECT_IN, objects=[MUG], receptacles=[DESK])
    assert check(sandbox, GoalKind.OBJECT_IN, objects=[BALL], receptacles=[BOX])
    assert not check(sandbox, GoalKind.OBJECT_ON, objects=[BALL], receptacles=[BOX])


def test_what_lies_in_a_box_on_a_table_is_on_the_table(sandbox: Sandbox) -> None:
    goal = {"objects": [BALL], "receptacles": [TABLE]}
    assert not check(sandbox, GoalKind.OBJECT_ON, **goal)
    sandbox.skill("GoNearObject", object=BOX)
    sandbox.skill("PickUp", object=BOX)
    assert not check(sandbox, GoalKind.OBJECT_IN, objects=[BALL], receptacles=[BOX])
    sandbox.skill("GoNearObject", object=TABLE)
    sandbox.skill("Place", target=TABLE, relation="on")
    assert check(sandbox, GoalKind.OBJECT_ON, **goal)
    assert check(sandbox, GoalKind.OBJECT_IN, objects=[BALL], receptacles=[BOX])


def test_near_is_measured_to_the_nearest_side_on_the_same_floor(sandbox: Sandbox) -> None:
    assert not check(sandbox, GoalKind.ROBOT_NEAR, receptacles=[TABLE])
    sandbox.skill("GoNearObject", object=TABLE)
    assert check(sandbox, GoalKind.ROBOT_NEAR, receptacles=[TABLE])
    assert not check(sandbox, GoalKind.ROBOT_NEAR, receptacles=["F2/kitchen/table_1"])
    assert not check(sandbox, GoalKind.ROBOT_NEAR, receptacles=[TABLE], distance=0.05)


def test_what_is_held_is_near_what_the_robot_is_near(sandbox: Sandbox) -> None:
    goal = {"objects": [MUG], "receptacles": [TABLE]}
    assert not check(sandbox, GoalKind.OBJECT_NEAR, **goal)
    sandbox.skill("GoNearObject", object=MUG)
    sandbox.skill("PickUp", object=MUG)
    assert not check(sandbox, GoalKind.OBJECT_NEAR, **goal)
    sandbox.skill("GoNearObject", object=TABLE)
    assert check(sandbox, GoalKind.OBJECT_NEAR, **goal)
    sandbox.skill("Place", target=TABLE, relation="on")
    assert check(sandbox, GoalKind.OBJECT_NEAR, **goal)


def test_open_and_closed_follow_the_door_of_a_fridge(sandbox: Sandbox) -> None:
    assert check(sandbox, GoalKind.CLOSED, receptacles=[FRIDGE])
    sandbox.skill("GoNearObject", object=FRIDGE)
    sandbox.skill("OpenObject", object=FRIDGE)
    assert check(sandbox, GoalKind.OPEN, receptacles=[FRIDGE])
    assert not check(sandbox, GoalKind.CLOSED, receptacles=[FRIDGE])


def test_the_robot_is_in_one_room_and_has_seen_what_it_is_told_it_has_seen(sandbox: Sandbox) -> None:
    assert check(sandbox, GoalKind.ROBOT_IN_ROOM, rooms=["F1/hall"])
    assert not check(sandbox, GoalKind.ROBOT_IN_ROOM, rooms=["F2/hall", "F1/office"])
    goal = Goal(kind=GoalKind.SEEN, objects=[APPLE, MUG])
    assert not holds(goal, sandbox.world, SESSION)
    assert holds(goal, sandbox.world, SESSION, {MUG})


def test_all_goals_must_hold_and_a_task_without_any_is_refused(sandbox: Sandbox) -> None:
    goals = [Goal(kind=GoalKind.ROBOT_IN_ROOM, rooms=["F1/hall"]), Goal(kind=GoalKind.HOLDING, objects=[MUG])]
    task = Task(id="t", kind=TaskKind.DELIVER, instruction="Get a mug.", goals=goals)
    assert unmet_goals(task, sandbox.world, SESSION) == goals[1:]
    assert not done(task, sandbox.world, SESSION)
    with pytest.raises(MansionError, match="has no goals"):
        done(Task(id="t", kind=TaskKind.DELIVER, instruction=""), sandbox.world, SESSION)


def test_ids_that_are_not_in_the_building_never_help(sandbox: Sandbox) -> None:
    for kind in GoalKind:
        goal = Goal(kind=kind, objects=["F9/x/y_1"], receptacles=["F9/x/z_1"], rooms=["F9/x"])
        assert not holds(goal, sandbox.world, SESSION)


def test_a_sandbox_that_was_reset_is_as_a_new_one(building: Path) -> None:
    used, fresh = Sandbox(building), Sandbox(building)
    sandbox_skills = [
        ("GoNearObject", {"object": BOX}),
        ("PickUp", {"object": BOX}),
        ("GoNearObject", {"object": "F1/door_1"}),
        ("CloseDoor", {}),
        ("GoToLandmark", {"landmark": "elevator"}),
        ("CallElevator", {}),
        ("UseElevator", {"target_floor": 3}),
        ("Place", {"target": "floor"}),
    ]
    for skill, arguments in sandbox_skills:
        used.skill(skill, **arguments)
    start = TaskStart(floor=2, pose=Pose2D(x=6.0, y=1.5, yaw=90.0))
    used.reset(start)
    fresh.reset(start)
    a, b = used.world, fresh.world
    assert a.state(used.robot) == b.state(fresh.robot)
    for floor in a.building.floors:
        assert a.objects.on_floor(floor) == b.objects.on_floor(floor)
        assert (a.view(floor).map.blocked == b.view(floor).map.blocked).all()
        assert a.view(floor).numbers == b.view(floor).numbers
    assert not (building / "state").exists()


def test_a_robot_cannot_start_where_there_is_nothing(sandbox: Sandbox) -> None:
    for floor, x in ((7, 6.0), (1, 60.0)):
        with pytest.raises(MansionError):
            sandbox.reset(TaskStart(floor=floor, pose=Pose2D(x=x, y=1.5)))
