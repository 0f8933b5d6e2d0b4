"""An oracle that knows the whole world: the next skill towards the goals, over floors and through closed doors."""

from collections.abc import Callable, Collection, Iterable
from math import dist
from typing import Final

from mansion_geometry.plane import segment_distance
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.task import Goal, GoalKind, SkillCall, Task
from mansion_msgs_py.world import ObjectState, SkillResult, SkillStatus
from mansion_skills.navigation.routes import Leg
from mansion_skills.skills.between_floors import NEAR_ENTRANCE
from mansion_skills.skills.doors import DOOR_REACH, robot_room
from mansion_skills.skills.driving import blocking_door, path_to
from mansion_skills.skills.go_to import LANDMARK_SNAP
from mansion_skills.skills.manipulation import out_of_reach
from mansion_skills.skills.queries import route_graph
from mansion_skills.skills.visibility import REACH, closed_carrier, reach_to
from mansion_skills.world.world import World
from mansion_tasks.tasks.goals import unmet_goals

__all__ = ["RouteFollower", "Oracle"]

FLOOR_COST = 100.0
"""Metres that a change of floor counts for when the nearest of several objects is chosen."""


class RouteFollower:
    """Chooses the next skill on a robot's way to a place, and remembers calls that failed.

    Parameters
    ----------
    world : World
    session : str
        Session of the robot.
    """

    def __init__(self, world: World, session: str) -> None:
        self._world = world
        self._session = session
        self._failed: set[str] = set()

    def record_failure(self, call: SkillCall) -> None:
        """Remember that a call failed from where the robot is."""
        self._failed.add(self._key(call))

    def has_failed(self, call: SkillCall, *, yaw: float | None = None) -> bool:
        """Whether a call failed from where the robot is, at `yaw` degrees instead of its own heading if given."""
        return self._key(call, yaw=yaw) in self._failed

    def forget_blocked_routes(self) -> None:
        """Forget failed motions: an obstacle was taken away or a door opened."""
        self._failed = {key for key in self._failed if not key.startswith("Go")}

    def _key(self, call: SkillCall, *, yaw: float | None = None) -> str:
        """Identify an attempt by the skill, its arguments and, where it matters, the robot's pose."""
        robot = self._world.robots[self._session]
        facing = robot.pose.yaw if yaw is None else yaw
        values = " ".join(f"{name}={call.arguments[name]}" for name in sorted(call.arguments))
        x, y = robot.place
        if call.skill == "Place" and call.arguments.get("target") != "floor":
            return f"{call.skill} {values} {robot.floor} {x:.1f} {y:.1f}"
        if call.skill == "Place":
            return f"{call.skill} {values} {robot.floor} {x:.1f} {y:.1f} {round(facing) % 360}"
        if call.skill == "GoNearObject":
            return f"{call.skill} {values} {self._room()}"
        return f"{call.skill} {values}"

    def _room(self) -> str:
        robot = self._world.robots[self._session]
        return self._world.view(robot.floor).map.room_at(*robot.place) or ""

    def nearest(self, names: Iterable[str]) -> list[str]:
        """Return the objects of these that are somewhere, the nearest to the robot first."""
        robot = self._world.robots[self._session]

        def cost(state: ObjectState) -> float:
            if state.floor is None or state.position is None:
                return 0.0
            return dist(robot.place, state.position[:2]) + FLOOR_COST * abs(state.floor - robot.floor)

        objects = self._world.objects
        known = [objects.state(name) for name in names if name in objects]
        free = [state for state in known if state.held_by in (None, self._session)]
        return [state.id for state in sorted(free, key=lambda s: (cost(s), s.id))]

    def to_object(self, name: str) -> SkillCall | None:
        """Return the next skill towards standing before an object; ``None`` when there is no way."""
        state = self._world.objects.state(name)
        if state.floor is None or state.position is None:
            return None
        goal = (state.position[0], state.position[1])
        robot = self._world.robots[self._session]
        if robot.floor != state.floor:
            return self._to_floor(state.floor, state.room or "", goal)
        go = SkillCall(skill="GoNearObject", arguments={"object": name})
        if self.has_failed(go) and state.room is not None and self._room() != state.room:
            return self.to_room([state.room])
        return self._through_doors(go, goal, REACH + 0.5)

    def to_room(self, rooms: Collection[str]) -> SkillCall | None:
        """Return the next skill towards the nearest of some rooms."""
        robot, world = self._world.robots[self._session], self._world
        floors = sorted(world.building.floors, key=lambda f: (abs(f - robot.floor), f))
        for floor in floors:
            if not any(room.id in rooms for room in world.building.scene(floor).rooms):
                continue
            marks = [mark for mark in world.view(floor).landmarks if mark.name in rooms]
            if floor == robot.floor:
                marks.sort(key=lambda m: (dist(robot.place, (m.pose.x, m.pose.y)), m.name))
            for mark in marks:
                goal = (mark.pose.x, mark.pose.y)
                if floor != robot.floor:
                    call = self._to_floor(floor, mark.name, goal)
                else:
                    go = SkillCall(skill="GoToLandmark", arguments={"landmark": mark.name})
                    call = self._through_doors(go, goal, LANDMARK_SNAP)
                if call is not None and not self.has_failed(call):
                    return call
        return None

    def _through_doors(self, go: SkillCall, goal: Point, snap: float) -> SkillCall:
        """Return `go`, or what opens the closed door on its way."""
        world, robot = self._world, self._world.robots[self._session]
        if path_to(world, robot, goal, snap) is not None:
            return go
        name = blocking_door(world, robot, goal, snap)
        if name is None:
            return go
        door = world.view(robot.floor).doors[name]
        near = segment_distance(robot.place, door.segment) <= DOOR_REACH
        if near and robot_room(world, robot, door) is not None:
            return SkillCall(skill="OpenDoor", arguments={"door": name})
        return SkillCall(skill="GoNearObject", arguments={"object": name})

    def _to_floor(self, floor: int, room: str, goal: Point) -> SkillCall | None:
        """Return the next skill of the quickest way to a place on another floor."""
        world, robot = self._world, self._world.robots[self._session]
        start = (robot.floor, self._room(), robot.place)
        legs = route_graph(world).route(start, (floor, room, goal), world.doors)
        ride = next((leg for leg in legs or [] if leg.kind != "walk"), None)
        return None if ride is None else self._ride(ride)

    def _ride(self, ride: Leg) -> SkillCall:
        world, robot = self._world, self._world.robots[self._session]
        core = world.core_near(robot, ride.kind, NEAR_ENTRANCE)
        if core is None or core.id != ride.via:
            mark = next(m for m in world.view(robot.floor).landmarks if m.name == ride.via)
            go = SkillCall(skill="GoToLandmark", arguments={"landmark": ride.via})
            return self._through_doors(go, (mark.pose.x, mark.pose.y), LANDMARK_SNAP)
        if ride.kind == "stair":
            way = "Up" if ride.to_floor > ride.floor else "Down"
            return SkillCall(skill="TakeStairs", arguments={"direction": way})
        lift = world.lifts[core.id]
        if robot.call == core.id and lift.is_open_at(robot.floor):
            return SkillCall(skill="UseElevator", arguments={"target_floor": ride.to_floor})
        return SkillCall(skill="CallElevator")


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
"""Order in which unmet goals are pursued: those that keep the hand full or need only presence come last."""

NEAR_LANDMARK = 1.6
"""Greatest distance between a room's landmark and a robot that has gone to it, metres."""


class Oracle:
    """Knows the whole world; remembers only what it tried in failed.

    Parameters
    ----------
    task : Task
        With goals.
    world : World
    session : str
        Session of the robot.
    """

    def __init__(self, task: Task, world: World, session: str) -> None:
        self._task = task
        self._world = world
        self._session = session
        self._gone_near: set[str] = set()
        self._cleared: set[str] = set()
        self._follower = RouteFollower(world, session)
        self._work: dict[GoalKind, Callable[[Goal], SkillCall | None]] = {
            GoalKind.OBJECT_IN: lambda goal: self._put(goal, "in"),
            GoalKind.OBJECT_ON: lambda goal: self._put(goal, "on"),
            GoalKind.OBJECT_IN_ROOM: self._put_in_room,
            GoalKind.OBJECT_NEAR: self._bring_near,
            GoalKind.OPEN: lambda goal: self._set_open(goal, is_open=True),
            GoalKind.CLOSED: lambda goal: self._set_open(goal, is_open=False),
            GoalKind.HOLDING: lambda goal: self._fetch(goal.objects),
            GoalKind.SEEN: self._look_at,
            GoalKind.ROBOT_NEAR: self._stand_near,
            GoalKind.ROBOT_IN_ROOM: lambda goal: self._follower.to_room(goal.rooms),
        }

    def next_call(self, seen: Collection[str] = ()) -> SkillCall | None:
        """Return the next skill, or ``None`` when the task is done or nothing is left to try."""
        unmet = unmet_goals(self._task, self._world, self._session, seen)
        for goal in sorted(unmet, key=lambda goal: _ORDER.index(goal.kind)):
            call = self._work[goal.kind](goal)
            if call is not None:
                return call
        return self._clear_obstacles() if unmet else None

    def _clear_obstacles(self) -> SkillCall | None:
        """Pick up objects from the floor near the robot, the last resort: they may block the way."""
        world, robot = self._world, self._world.robots[self._session]
        if world.objects.held_by(self._session) is not None:
            return None
        around = [
            state.id
            for state in world.objects.on_floor(robot.floor)
            if state.mount == "floor" and world.objects.kinds[state.id].pickupable and state.id not in self._cleared
        ]
        for name in self._follower.nearest(around):
            call = self._approach(name)
            if call is None:
                self._cleared.add(name)
                return SkillCall(skill="PickUp", arguments={"object": name})
            if not self._follower.has_failed(call):
                return call
        return None

    def note(self, call: SkillCall, result: SkillResult) -> None:
        """Record what a skill did, so that a failed call is not tried again from the same place."""
        failed = result.status is not SkillStatus.SUCCESS
        if failed or (call.skill == "Place" and self._missed_room(result)):
            self._follower.record_failure(call)
        elif call.skill in ("PickUp", "OpenDoor"):
            self._follower.forget_blocked_routes()
        elif call.skill == "GoNearObject":
            name = call.arguments["object"]
            if name in self._world.objects and not self._can_handle(name):
                self._follower.record_failure(call)

    def _missed_room(self, result: SkillResult) -> bool:
        """Whether an object was put down from within its target room, but through the door, outside of it."""
        world, robot = self._world, self._world.robots[self._session]
        name = str(result.data.get("object", ""))
        here = world.view(robot.floor).map.room_at(*robot.place)
        return any(
            goal.kind is GoalKind.OBJECT_IN_ROOM
            and name in goal.objects
            and here in goal.rooms
            and world.objects.state(name).room not in goal.rooms
            for goal in self._task.goals
        )

    def _can_handle(self, name: str) -> bool:
        """Whether the hand reaches an object, or the closed object that it lies in."""
        world, robot = self._world, self._world.robots[self._session]
        state = world.objects.state(name)
        shut = closed_carrier(world, state)
        if shut is not None:
            state = world.objects.state(shut)
        return out_of_reach(world, robot, "", state) is None

    def _approach(self, name: str) -> SkillCall | None:
        """Return the next skill on the way to handling an object, or ``None`` when it can be handled."""
        return None if self._can_handle(name) else self._follower.to_object(name)

    def _fetch(self, names: Collection[str]) -> SkillCall | None:
        world, session = self._world, self._session
        held = world.objects.held_by(session)
        if held is not None and held not in names:
            return self._put_on_floor()
        for name in self._follower.nearest(names):
            shut = closed_carrier(world, world.objects.state(name))
            if not self._can_handle(name):
                call = self._follower.to_object(name)
            elif shut is not None:
                call = SkillCall(skill="OpenObject", arguments={"object": shut})
            else:
                call = SkillCall(skill="PickUp", arguments={"object": name})
            if call is not None and not self._follower.has_failed(call):
                return call
        return None

    def _holds_target(self, goal: Goal) -> bool:
        return self._world.objects.held_by(self._session) in goal.objects

    def _put(self, goal: Goal, relation: str) -> SkillCall | None:
        if not self._holds_target(goal):
            return self._fetch(goal.objects)
        for name in self._follower.nearest(goal.receptacles):
            state = self._world.objects.state(name)
            call = self._approach(name)
            if call is None and relation == "in" and state.states.get("open") is False:
                call = SkillCall(skill="OpenObject", arguments={"object": name})
            if call is None and not self._can_handle(name):
                continue
            call = call or SkillCall(skill="Place", arguments={"target": name, "relation": relation})
            if not self._follower.has_failed(call):
                return call
        return None

    def _put_in_room(self, goal: Goal) -> SkillCall | None:
        if not self._holds_target(goal):
            return self._fetch(goal.objects)
        robot = self._world.robots[self._session]
        view = self._world.view(robot.floor)
        for mark in view.landmarks:
            here = dist(robot.place, (mark.pose.x, mark.pose.y)) < NEAR_LANDMARK
            if mark.name in goal.rooms and here and view.map.room_at(*robot.place) == mark.name:
                return self._put_on_floor()
        return self._follower.to_room(goal.rooms)

    def _put_on_floor(self) -> SkillCall | None:
        """Put what is held on the floor before the robot, turning until there is room; else on what stands near."""
        down = SkillCall(skill="Place", arguments={"target": "floor", "relation": "on"})
        if not self._follower.has_failed(down):
            return down
        turn = SkillCall(skill="Rotate", arguments={"degrees": 90.0})
        robot = self._world.robots[self._session]
        turns = [(robot.pose.yaw + 90.0 * i) % 360.0 for i in range(1, 4)]
        if not all(self._follower.has_failed(down, yaw=yaw) for yaw in turns):
            return turn
        return self._put_on_nearby_furniture()

    def _put_on_nearby_furniture(self) -> SkillCall | None:
        world, robot = self._world, self._world.robots[self._session]
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
            if not self._follower.has_failed(call):
                return call
        return None

    def _bring_near(self, goal: Goal) -> SkillCall | None:
        return self._stand_near(goal) if self._holds_target(goal) else self._fetch(goal.objects)

    def _set_open(self, goal: Goal, *, is_open: bool) -> SkillCall | None:
        skill = "OpenObject" if is_open else "CloseObject"
        for name in self._follower.nearest(goal.receptacles):
            call = self._approach(name)
            if call is None and not self._can_handle(name):
                continue
            call = call or SkillCall(skill=skill, arguments={"object": name})
            if not self._follower.has_failed(call):
                return call
        return None

    def _look_at(self, goal: Goal) -> SkillCall | None:
        for name in self._follower.nearest(goal.objects):
            shut = closed_carrier(self._world, self._world.objects.state(name))
            if shut is not None and self._can_handle(name):
                call: SkillCall | None = SkillCall(skill="OpenObject", arguments={"object": shut})
            else:
                call = self._follower.to_object(name)
            if call is not None and not self._follower.has_failed(call):
                return call
        return None

    def _stand_near(self, goal: Goal) -> SkillCall | None:
        for name in self._follower.nearest(goal.receptacles):
            call = self._follower.to_object(name)
            if call is not None and not self._follower.has_failed(call):
                return call
        return None
