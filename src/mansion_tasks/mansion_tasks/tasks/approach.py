"""The next skill on the way to a place, over floors and through closed doors."""

from collections.abc import Collection, Iterable, Set
from math import dist

from mansion_msgs_py.shapes import Point
from mansion_msgs_py.task import SkillCall
from mansion_msgs_py.world import ObjectState
from mansion_skills.navigation.routes import Leg
from mansion_skills.skills.between_floors import NEAR_ENTRANCE
from mansion_skills.skills.doors import DOOR_REACH, robot_room
from mansion_skills.skills.driving import blocking_door, path_to
from mansion_skills.skills.go_to import LANDMARK_SNAP
from mansion_skills.skills.queries import route_graph
from mansion_skills.skills.visibility import REACH
from mansion_skills.world.objects import segment_distance
from mansion_skills.world.world import World

__all__ = ["Approach"]

FLOOR_COST = 100.0
"""What a floor counts when the nearest of several things is chosen, metres."""


class Approach:
    """Where one robot can go next.

    Parameters
    ----------
    world : World
    session : str
        Of the robot.
    vain : set of str
        Keys of the calls that failed (see `key`); ways through them are not proposed.
    """

    def __init__(self, world: World, session: str, vain: Set[str]) -> None:
        self._world = world
        self._session = session
        self._vain = vain

    def key(self, call: SkillCall, *, yaw: float | None = None) -> str:
        """Return what tells one attempt from another: the skill, its arguments, and where the robot stands."""
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
        if self.key(go) in self._vain and state.room is not None and self._room() != state.room:
            return self.to_a_room([state.room])
        return self._through_doors(go, goal, REACH + 0.5)

    def to_a_room(self, rooms: Collection[str]) -> SkillCall | None:
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
                if call is not None and self.key(call) not in self._vain:
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
