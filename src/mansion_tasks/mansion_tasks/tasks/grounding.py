"""From a task in words to a task in a building: ids, a start, the oracle's plan, difficulty and a step limit."""

from collections.abc import Callable
from typing import Final

import msgspec

from mansion_msgs_py.codec import to_builtins
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.task import Difficulty, Goal, GoalKind, Need, Task, TaskKind, TaskStart
from mansion_msgs_py.world import Pose2D
from mansion_skills.skills.receptacles import can_contain
from mansion_skills.world.world import World
from mansion_tasks.tasks.needs import describe, matching_objects, matching_rooms
from mansion_tasks.tasks.sandbox import Sandbox
from mansion_tasks.tasks.solving import Solution, solve

__all__ = ["difficulty_of", "ground", "missing_needs", "proven", "steps_for", "with_ids"]

LONG_PLAN: Final = 9
"""Skills from which a plan counts as long."""

MANY_ALIKE: Final = 8
"""Number of objects of the target's kind beside the target from which they count as many."""

LEAST_STEPS, MOST_STEPS, STEPS_PER_SKILL = 30, 200, 5


def difficulty_of(task: Task, solution: Solution, world: World) -> Difficulty:
    """Rate a task by the floors it spans, the length of its plan, and the number of objects of its target's kind.

    Two floors, four floors, a long plan and many similar objects count a point each: none is easy, three are hard.
    """
    targets = {name for goal in task.goals for name in goal.objects}
    kinds = {world.objects.kinds[name].category for name in targets if name in world.objects}
    alike = sum(world.objects.kinds[name].category in kinds for name in world.objects)
    points = (
        (solution.floors_spanned >= 2)
        + (solution.floors_spanned >= 4)
        + (len(solution.plan) >= LONG_PLAN)
        + (alike - len(targets) >= MANY_ALIKE)
    )
    if points == 0:
        return Difficulty.EASY
    return Difficulty.HARD if points >= 3 else Difficulty.MEDIUM


def steps_for(solution: Solution) -> int:
    """Return how many skills an agent may call: several for each of the oracle's."""
    return max(LEAST_STEPS, min(MOST_STEPS, STEPS_PER_SKILL * len(solution.plan)))


_CARRYING: Final = {
    GoalKind.HOLDING,
    GoalKind.OBJECT_IN,
    GoalKind.OBJECT_IN_ROOM,
    GoalKind.OBJECT_NEAR,
    GoalKind.OBJECT_ON,
}


def ground(task: Task, sandbox: Sandbox, *, start_floor: int | None = None) -> Task:
    """Return a task with goals, start, oracle plan, difficulty and number of steps for a building.

    Parameters
    ----------
    task : Task
        With `needs`. Goals without ids say which kinds are wanted; by default the target is to be in the room, or near
        the object, that is the destination.
    sandbox : Sandbox
        The building's sandbox; it is reset.
    start_floor : int, optional
        Where the robot starts when the task has no start; at the building's spawn pose when absent.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when the building lacks what the task needs (``details.missing``), or the oracle finds no way.
    """
    missing = missing_needs(task, sandbox.world)
    if missing:
        lacks = "; ".join(describe(task.needs[index]) for index in missing)
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"the building lacks what task {task.id!r} needs: {lacks}",
            path=f"$.needs[{missing[0]}]",
            details={"missing": [to_builtins(task.needs[index]) for index in missing]},
        )
    made = with_ids(task, sandbox.world)
    start = task.start or _start(sandbox, start_floor, made.goals)
    return proven(msgspec.structs.replace(made, start=start), sandbox)


def with_ids(task: Task, world: World) -> Task:
    """Return a task whose goals name what meets its needs in a building."""
    goals = _goals(task)
    parts = _one_for_each_target(task) if task.kind is TaskKind.COLLECT else []
    if len(parts) != len(goals):
        parts = [task] * len(goals)
    goals = [_filled(goal, part, world) for goal, part in zip(goals, parts)]
    return msgspec.structs.replace(task, building_id=world.building.building_id, goals=goals)


def proven(task: Task, sandbox: Sandbox) -> Task:
    """Return a task with goals and start together with its proof.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` when the oracle cannot do it, or when it is done before it begins.
    """
    solution = solve(task, sandbox)
    if solution is None or not solution.plan:
        why = "cannot be done by the skills" if solution is None else "is done before it begins"
        raise MansionError(ErrorCode.INFEASIBLE, f"task {task.id!r} {why} in {sandbox.building.building_id}")
    return msgspec.structs.replace(
        task,
        oracle=solution.plan,
        floors_spanned=solution.floors_spanned,
        difficulty=difficulty_of(task, solution, sandbox.world),
        max_steps=steps_for(solution),
    )


def missing_needs(task: Task, world: World) -> list[int]:
    """Return the indices of the needs that a building does not meet."""
    return [index for index, need in enumerate(task.needs) if not _meeting(need, task, world)]


def _meeting(need: Need, task: Task, world: World) -> list[str]:
    """Return the ids that meet a need and that its part in the task allows."""
    if not need.noun:
        return matching_rooms(need, world.building)
    found = matching_objects(need, world.building)
    goals = {goal.kind for goal in _goals(task)}
    if need.role == "target" and goals & _CARRYING:
        return [name for name in found if world.objects.kinds[name].pickupable]
    if need.role == "destination":
        return [name for name in found if _can_receive(world, name, goals)]
    return found


def _can_receive(world: World, name: str, goals: set[GoalKind]) -> bool:
    item = world.objects.kinds[name]
    checks: dict[GoalKind, Callable[[], bool]] = {
        GoalKind.OBJECT_ON: lambda: item.receptacle,
        GoalKind.OBJECT_IN: lambda: can_contain(world, item),
        GoalKind.OPEN: lambda: item.openable,
        GoalKind.CLOSED: lambda: item.openable,
    }
    return all(check() for kind, check in checks.items() if kind in goals)


def _goals(task: Task) -> list[Goal]:
    """Return the task's goals, or those of its kind; their ids are filled in later."""
    if task.goals:
        return task.goals
    if task.kind is TaskKind.SEARCH:
        return [Goal(kind=GoalKind.SEEN), Goal(kind=GoalKind.ROBOT_NEAR)]
    if task.kind is TaskKind.OPEN_AND_PUT:
        return [Goal(kind=GoalKind.OBJECT_IN)]
    to_object = any(need.role == "destination" and need.noun for need in task.needs)
    goal = Goal(kind=GoalKind.OBJECT_NEAR if to_object else GoalKind.OBJECT_IN_ROOM)
    if task.kind is TaskKind.COLLECT:
        return [goal for need in task.needs if need.role == "target"]
    return [goal]


def _one_for_each_target(task: Task) -> list[Task]:
    """Return the task as if it had one of its targets alone, for each of them."""
    others = [need for need in task.needs if need.role != "target"]
    return [msgspec.structs.replace(task, needs=[need, *others]) for need in task.needs if need.role == "target"]


def _filled(goal: Goal, task: Task, world: World) -> Goal:
    def ids(role: str, *, rooms: bool) -> list[str]:
        needs = [need for need in task.needs if need.role == role and bool(need.noun) != rooms]
        return list(dict.fromkeys(name for need in needs for name in _meeting(need, task, world)))

    targets = ids("target", rooms=False)
    items = ids("destination", rooms=False)
    rooms = ids("destination", rooms=True)
    match goal.kind:
        case GoalKind.OBJECT_IN_ROOM:
            return msgspec.structs.replace(goal, objects=targets, rooms=rooms)
        case GoalKind.OBJECT_ON | GoalKind.OBJECT_IN | GoalKind.OBJECT_NEAR:
            return msgspec.structs.replace(goal, objects=targets, receptacles=items)
        case GoalKind.ROBOT_IN_ROOM:
            return msgspec.structs.replace(goal, rooms=rooms)
        case GoalKind.HOLDING | GoalKind.SEEN:
            return msgspec.structs.replace(goal, objects=targets)
        case GoalKind.ROBOT_NEAR | GoalKind.OPEN | GoalKind.CLOSED:
            return msgspec.structs.replace(goal, receptacles=items or targets)


def _start(sandbox: Sandbox, floor: int | None, goals: list[Goal]) -> TaskStart:
    """Return the spawn pose, or on another floor the place of a goal there, else its first landmark."""
    sandbox.reset()
    robot, world = sandbox.robot, sandbox.world
    if floor is None or floor == robot.floor:
        return TaskStart(floor=robot.floor, pose=robot.pose)
    if floor not in world.building.floors:
        raise MansionError(
            ErrorCode.INFEASIBLE,
            f"the robot is to start on floor {floor}; floors are {world.building.floors}",
            path="$.start",
        )
    wanted = {room for goal in goals for room in goal.rooms}
    wanted |= {world.objects.state(n).room or "" for goal in goals for n in goal.receptacles}
    marks = world.view(floor).landmarks
    mark = next((mark for mark in marks if mark.name in wanted), marks[0])
    return TaskStart(floor=floor, pose=Pose2D(x=mark.pose.x, y=mark.pose.y, yaw=mark.pose.yaw))
