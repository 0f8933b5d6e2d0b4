"""An oracle: from the goals and the world as it is at any moment, the next skill towards them."""

from collections.abc import Callable, Collection
from math import dist
from typing import Final

from mansion_msgs_py.task import Goal, GoalKind, SkillCall, Task
from mansion_msgs_py.world import SkillResult, SkillStatus
from mansion_skills.skills.manipulation import out_of_reach
from mansion_skills.skills.visibility import closed_carrier, reach_to
from mansion_skills.world.world import World
from mansion_tasks.tasks.approach import Approach
from mansion_tasks.tasks.goals import unmet_goals

__all__ = ["Oracle"]

_ORDER: Final = (
    GoalKind.OBJECT_IN,
    GoalKind.OBJECT_ON,
    GoalKind.OBJECT_IN_ROOM,
    GoalKind.OPEN,
    GoalKind.CLOSED,
    GoalKind.HOLDING,
    GoalKind.OBJECT_NEAR,
    GoalKind.SEEN,
    GoalKind.ROBOT_NEAR,
    GoalKind.ROBOT_IN_ROOM,
)
"""Which unmet goal is worked on first: what needs an empty hand later comes last."""

NEAR_LANDMARK = 1.6
"""How near to a room's landmark a robot stands that has gone there, metres."""


class Oracle:
    """Knows the whole world; remembers only what it tried in vain.

    Parameters
    ----------
    task : Task
        With goals.
    world : World
    session : str
        Of its robot.
    """

    def __init__(self, task: Task, world: World, session: str) -> None:
        self._task = task
        self._world = world
        self._robot_of = session
        self._vain: set[str] = set()
        self._gone_near: set[str] = set()
        self._cleared: set[str] = set()
        self._way = Approach(world, session, self._vain)
        self._work: dict[GoalKind, Callable[[Goal], SkillCall | None]] = {
            GoalKind.OBJECT_IN: self._put_in,
            GoalKind.OBJECT_ON: self._put_on,
            GoalKind.OBJECT_IN_ROOM: self._put_in_room,
            GoalKind.OBJECT_NEAR: self._bring_near,
            GoalKind.OPEN: lambda goal: self._set_open(goal, True),
            GoalKind.CLOSED: lambda goal: self._set_open(goal, False),
            GoalKind.HOLDING: self._hold,
            GoalKind.SEEN: self._look_at,
            GoalKind.ROBOT_NEAR: self._stand_near,
            GoalKind.ROBOT_IN_ROOM: lambda goal: self._way.to_a_room(goal.rooms),
        }

    def next_call(self, seen: Collection[str] = ()) -> SkillCall | None:
        """Return the next skill, or ``None`` when the task is done or nothing is left to try."""
        unmet = unmet_goals(self._task, self._world, self._robot_of, seen)
        for goal in sorted(unmet, key=lambda goal: _ORDER.index(goal.kind)):
            call = self._work[goal.kind](goal)
            if call is not None:
                return call
        return self._clear_the_way() if unmet else None

    def _clear_the_way(self) -> SkillCall | None:
        """Take up what stands on the floor near the robot, where nothing else is left: it may block the way."""
        world, robot = self._world, self._world.robots[self._robot_of]
        if world.objects.held_by(self._robot_of) is not None:
            return None
        around = [
            state.id
            for state in world.objects.on_floor(robot.floor)
            if state.mount == "floor" and world.objects.kinds[state.id].pickupable and state.id not in self._cleared
        ]
        for name in self._way.nearest(around):
            call = self._approach(name)
            if call is None:
                self._cleared.add(name)
                return SkillCall(skill="PickUp", arguments={"object": name})
            if self._way.key(call) not in self._vain:
                return call
        return None

    def note(self, call: SkillCall, result: SkillResult) -> None:
        """Take notice of what a skill did, so that what failed is not tried again from the same place."""
        failed = result.status is not SkillStatus.SUCCESS
        if failed or (call.skill == "Place" and self._missed_the_room(result)):
            self._vain.add(self._way.key(call))
        elif call.skill in ("PickUp", "OpenDoor"):
            # Ways may be free now that were not.
            self._vain -= {key for key in self._vain if key.startswith("Go")}
        elif call.skill == "GoNearObject":
            name = call.arguments["object"]
            if name in self._world.objects and not self._handles(name):
                self._vain.add(self._way.key(call))

    def _missed_the_room(self, result: SkillResult) -> bool:
        """Whether a thing was put down from the room where it shall be, but through the door of that."""
        world, robot = self._world, self._world.robots[self._robot_of]
        name = str(result.data.get("object", ""))
        here = world.view(robot.floor).map.room_at(*robot.place)
        return any(
            goal.kind is GoalKind.OBJECT_IN_ROOM
            and name in goal.objects
            and here in goal.rooms
            and world.objects.state(name).room not in goal.rooms
            for goal in self._task.goals
        )

    def _handles(self, name: str) -> bool:
        """Whether the hand reaches a thing, or the closed thing that it lies in."""
        world, robot = self._world, self._world.robots[self._robot_of]
        state = world.objects.state(name)
        shut = closed_carrier(world, state)
        if shut is not None:
            state = world.objects.state(shut)
        return out_of_reach(world, robot, "", state) is None

    def _approach(self, name: str) -> SkillCall | None:
        """Return the next skill on the way to handling a thing, or ``None`` when it can be handled."""
        return None if self._handles(name) else self._way.to_object(name)

    def _fetch(self, names: Collection[str]) -> SkillCall | None:
        world, session = self._world, self._robot_of
        held = world.objects.held_by(session)
        if held is not None and held not in names:
            return self._put_away()
        for name in self._way.nearest(names):
            shut = closed_carrier(world, world.objects.state(name))
            if not self._handles(name):
                call = self._way.to_object(name)
            elif shut is not None:
                call = SkillCall(skill="OpenObject", arguments={"object": shut})
            else:
                call = SkillCall(skill="PickUp", arguments={"object": name})
            if call is not None and self._way.key(call) not in self._vain:
                return call
        return None

    def _held_one(self, goal: Goal) -> bool:
        return self._world.objects.held_by(self._robot_of) in goal.objects

    def _put_on(self, goal: Goal) -> SkillCall | None:
        return self._put(goal, "on") if self._held_one(goal) else self._fetch(goal.objects)

    def _put_in(self, goal: Goal) -> SkillCall | None:
        return self._put(goal, "in") if self._held_one(goal) else self._fetch(goal.objects)

    def _put(self, goal: Goal, relation: str) -> SkillCall | None:
        for name in self._way.nearest(goal.receptacles):
            state = self._world.objects.state(name)
            call = self._approach(name)
            if call is None and relation == "in" and state.states.get("open") is False:
                call = SkillCall(skill="OpenObject", arguments={"object": name})
            if call is None and not self._handles(name):
                continue
            call = call or SkillCall(skill="Place", arguments={"target": name, "relation": relation})
            if self._way.key(call) not in self._vain:
                return call
        return None

    def _put_in_room(self, goal: Goal) -> SkillCall | None:
        if not self._held_one(goal):
            return self._fetch(goal.objects)
        robot = self._world.robots[self._robot_of]
        view = self._world.view(robot.floor)
        for mark in view.landmarks:
            here = dist(robot.place, (mark.pose.x, mark.pose.y)) < NEAR_LANDMARK
            if mark.name in goal.rooms and here and view.map.room_at(*robot.place) == mark.name:
                return self._put_away()
        return self._way.to_a_room(goal.rooms)

    def _put_away(self) -> SkillCall | None:
        """Put what is held on the floor before the robot, turning until there is room; else on what stands near."""
        down = SkillCall(skill="Place", arguments={"target": "floor", "relation": "on"})
        if self._way.key(down) not in self._vain:
            return down
        turn = SkillCall(skill="Rotate", arguments={"degrees": 90.0})
        robot = self._world.robots[self._robot_of]
        turns = [(robot.pose.yaw + 90.0 * i) % 360.0 for i in range(1, 4)]
        if any(self._way.key(down, yaw=yaw) not in self._vain for yaw in turns):
            return turn
        return self._put_on_what_is_near()

    def _put_on_what_is_near(self) -> SkillCall | None:
        world, robot = self._world, self._world.robots[self._robot_of]
        room = world.view(robot.floor).map.room_at(*robot.place)
        around = [
            state
            for state in world.objects.on_floor(robot.floor)
            if state.room == room and world.objects.kinds[state.id].receptacle
        ]
        around.sort(key=lambda s: (reach_to(robot, s, world.objects.kinds[s.id]), s.id))
        for state in around:
            place = SkillCall(skill="Place", arguments={"target": state.id, "relation": "on"})
            call = self._approach(state.id) or place
            if self._way.key(call) not in self._vain:
                return call
        return None

    def _bring_near(self, goal: Goal) -> SkillCall | None:
        return self._stand_near(goal) if self._held_one(goal) else self._fetch(goal.objects)

    def _hold(self, goal: Goal) -> SkillCall | None:
        return self._fetch(goal.objects)

    def _set_open(self, goal: Goal, wanted: bool) -> SkillCall | None:
        skill = "OpenObject" if wanted else "CloseObject"
        for name in self._way.nearest(goal.receptacles):
            call = self._approach(name)
            if call is None and not self._handles(name):
                continue
            call = call or SkillCall(skill=skill, arguments={"object": name})
            if self._way.key(call) not in self._vain:
                return call
        return None

    def _look_at(self, goal: Goal) -> SkillCall | None:
        for name in self._way.nearest(goal.objects):
            shut = closed_carrier(self._world, self._world.objects.state(name))
            if shut is not None and self._handles(name):
                call: SkillCall | None = SkillCall(skill="OpenObject", arguments={"object": shut})
            else:
                call = self._way.to_object(name)
            if call is not None and self._way.key(call) not in self._vain:
                return call
        return None

    def _stand_near(self, goal: Goal) -> SkillCall | None:
        for name in self._way.nearest(goal.receptacles):
            call = self._way.to_object(name)
            if call is not None and self._way.key(call) not in self._vain:
                return call
        return None
