"""Tasks in the sample building."""

from pathlib import Path

from mansion_msgs_py.codec import encode_bytes
from mansion_msgs_py.task import Goal, GoalKind, SkillCall, Task, TaskKind, TaskSet, TaskStart
from mansion_msgs_py.world import Pose2D

MUG = "F1/office/mug_1"


def call(skill: str, **arguments: object) -> SkillCall:
    """Return a call."""
    return SkillCall(skill=skill, arguments=arguments)


def mug_task(**changes: object) -> Task:
    """Return the task to carry the mug from the office to the kitchen one floor up."""
    fields = {
        "id": "mug_up",
        "kind": TaskKind.DELIVER,
        "instruction": "Find a mug on the desk in the office and bring it to the kitchen on the second floor.",
        "building_id": "sample",
        "goals": [Goal(kind=GoalKind.OBJECT_IN_ROOM, objects=[MUG], rooms=["F2/kitchen"])],
        "oracle": [
            call("GoNearObject", object=MUG),
            call("PickUp", object=MUG),
            call("GoToLandmark", landmark="elevator"),
            call("CallElevator"),
            call("UseElevator", target_floor=2),
            call("GoToLandmark", landmark="F2/kitchen"),
            call("Place", target="floor"),
        ],
        "floors_spanned": 2,
        "max_steps": 40,
    }
    return Task(**{**fields, **changes})


def apple_task(**changes: object) -> Task:
    """Return the task to put the mug into the fridge of the same floor."""
    fields = {
        "id": "mug_in_fridge",
        "kind": TaskKind.OPEN_AND_PUT,
        "instruction": "Take the mug from the office, open the fridge in the kitchen and put it inside.",
        "goals": [Goal(kind=GoalKind.OBJECT_IN, objects=[MUG], receptacles=["F1/kitchen/fridge_1"])],
        "oracle": [
            call("GoNearObject", object=MUG),
            call("PickUp", object=MUG),
            call("GoNearObject", object="F1/kitchen/fridge_1"),
            call("OpenObject", object="F1/kitchen/fridge_1"),
            call("Place", target="F1/kitchen/fridge_1", relation="in"),
        ],
        "floors_spanned": 1,
    }
    return mug_task(**{**fields, **changes})


def search_task(**changes: object) -> Task:
    """Return the task to find the fridge of floor 3, from a corner of the hall on floor 1."""
    fields = {
        "id": "find_fridge",
        "kind": TaskKind.SEARCH,
        "instruction": "Find the fridge on the third floor.",
        "goals": [Goal(kind=GoalKind.ROBOT_NEAR, receptacles=["F3/kitchen/fridge_1"])],
        "oracle": [
            call("GoToLandmark", landmark="stairs"),
            call("TakeStairs", direction="Up"),
            call("TakeStairs", direction="Up"),
            call("GoNearObject", object="F3/kitchen/fridge_1"),
        ],
        "start": TaskStart(floor=1, pose=Pose2D(x=11.7, y=0.3, yaw=-45.0)),
        "floors_spanned": 3,
    }
    return mug_task(**{**fields, **changes})


def write_tasks(building: Path, *tasks: Task) -> Path:
    """Write a task set of a building and return its file."""
    found = TaskSet(
        building=f"../{building.name}",
        building_id="sample",
        tasks=list(tasks or (mug_task(), apple_task(), search_task())),
    )
    file = building.parent / "tasks" / "sample.json"
    file.parent.mkdir(exist_ok=True)
    file.write_bytes(encode_bytes(found, indent=1))
    return file
