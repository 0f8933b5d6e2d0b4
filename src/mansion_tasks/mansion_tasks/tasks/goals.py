"""The goals of a task: whether they hold in a world."""

from collections.abc import Callable, Collection, Iterable, Iterator
from math import dist
from typing import Final

from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.task import Goal, GoalKind, Task
from mansion_msgs_py.world import ObjectState
from mansion_skills.world.objects import box_distance
from mansion_skills.world.world import World

__all__ = ["done", "holds", "unmet_goals"]

_SLACK = 1e-9


def holds(goal: Goal, world: World, session: str, seen: Collection[str] = ()) -> bool:
    """Whether a goal holds now.

    Parameters
    ----------
    goal : Goal
    world : World
    session : str
        Whose robot is judged.
    seen : collection of str
        Ids of the objects that the robot has had in view (see `ProgressTracker.seen`).

    Notes
    -----
    What a robot holds lies in no room and on nothing, but it is near what the robot is near.
    """
    return _CHECKS[goal.kind](goal, world, session, seen)


def unmet_goals(task: Task, world: World, session: str, seen: Collection[str] = ()) -> list[Goal]:
    """Return the goals of a task that do not hold now, in the order of the task.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` for a task without goals: it has not been grounded in a building.
    """
    if not task.goals:
        raise MansionError(
            ErrorCode.INVALID_PAYLOAD, f"task {task.id!r} has no goals; ground it in a building first", path="$.goals"
        )
    return [goal for goal in task.goals if not holds(goal, world, session, seen)]


def done(task: Task, world: World, session: str, seen: Collection[str] = ()) -> bool:
    """Whether every goal of a task holds now; raises as `unmet_goals` does."""
    return not unmet_goals(task, world, session, seen)


def _states(world: World, names: Iterable[str]) -> Iterator[ObjectState]:
    return (world.objects.state(name) for name in names if name in world.objects)


def _object_in_room(goal: Goal, world: World, session: str, seen: Collection[str]) -> bool:
    return any(state.floor is not None and state.room in goal.rooms for state in _states(world, goal.objects))


def _carried(goal: Goal, world: World, mount: str) -> bool:
    """Whether one of the objects is on (in) a receptacle, possibly in a box that stands there."""
    for state in _states(world, goal.objects):
        link = state
        while link.floor is not None and link.parent is not None:
            how = link.mount or world.objects.kinds[link.id].mount
            if link.parent in goal.receptacles and how == mount:
                return True
            link = world.objects.state(link.parent)
    return False


def _object_on(goal: Goal, world: World, session: str, seen: Collection[str]) -> bool:
    return _carried(goal, world, "surface")


def _object_in(goal: Goal, world: World, session: str, seen: Collection[str]) -> bool:
    return _carried(goal, world, "inside")


def _is_near(world: World, floor: int, point: Point, goal: Goal) -> bool:
    for state in _states(world, goal.receptacles):
        if state.floor != floor or state.position is None:
            continue
        kind = world.objects.kinds[state.id]
        far = goal.distance + kind.size[0] + kind.size[1]
        if dist(point, state.position[:2]) > far:
            continue
        if box_distance(point, state, kind) <= goal.distance + _SLACK:
            return True
    return False


def _object_near(goal: Goal, world: World, session: str, seen: Collection[str]) -> bool:
    for state in _states(world, goal.objects):
        if state.held_by is not None:
            holder = world.robots.get(state.held_by)
            if holder is not None and _is_near(world, holder.floor, holder.place, goal):
                return True
        elif state.floor is not None and state.position is not None:
            point = (state.position[0], state.position[1])
            if _is_near(world, state.floor, point, goal):
                return True
    return False


def _robot_near(goal: Goal, world: World, session: str, seen: Collection[str]) -> bool:
    robot = world.robots[session]
    held = any(state.held_by == session for state in _states(world, goal.receptacles))
    return held or _is_near(world, robot.floor, robot.place, goal)


def _robot_in_room(goal: Goal, world: World, session: str, seen: Collection[str]) -> bool:
    robot = world.robots[session]
    return world.view(robot.floor).map.room_at(*robot.place) in goal.rooms


def _holding(goal: Goal, world: World, session: str, seen: Collection[str]) -> bool:
    return world.objects.held_by(session) in goal.objects


def _open(goal: Goal, world: World, session: str, seen: Collection[str]) -> bool:
    return any(state.states.get("open") is True for state in _states(world, goal.receptacles))


def _closed(goal: Goal, world: World, session: str, seen: Collection[str]) -> bool:
    return any(state.states.get("open") is False for state in _states(world, goal.receptacles))


def _seen(goal: Goal, world: World, session: str, seen: Collection[str]) -> bool:
    return any(name in seen for name in goal.objects)


_CHECKS: Final[dict[GoalKind, Callable[[Goal, World, str, Collection[str]], bool]]] = {
    GoalKind.OBJECT_IN_ROOM: _object_in_room,
    GoalKind.OBJECT_ON: _object_on,
    GoalKind.OBJECT_IN: _object_in,
    GoalKind.OBJECT_NEAR: _object_near,
    GoalKind.ROBOT_NEAR: _robot_near,
    GoalKind.ROBOT_IN_ROOM: _robot_in_room,
    GoalKind.HOLDING: _holding,
    GoalKind.OPEN: _open,
    GoalKind.CLOSED: _closed,
    GoalKind.SEEN: _seen,
}
