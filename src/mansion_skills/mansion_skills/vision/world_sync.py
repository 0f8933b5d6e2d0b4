"""Keep a floor's model up to date with the world: objects, doors, lifts, lamps, hands and robots."""

from collections.abc import Container
from math import cos, radians, sin

from mansion_geometry.plane import turned
from mansion_msgs_py.world import ObjectState
from mansion_skills.vision.articulation import Hinge, hinges_of, leaves_of
from mansion_skills.vision.floor_model import FloorModel, Turn, turn_about_z
from mansion_skills.vision.frame import Names
from mansion_skills.vision.mjcf_model import PART, ROBOTS, robot_body
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["WorldSync", "guests_of"]

LAMPS = ("ceiling_panel", "linear_light", "ceiling_light", "pendant_lamp", "chandelier")
"""Categories that light a whole room."""

DARK = 0.4
"""Brightness of a room with all of them switched off."""

IN_HAND = (0.45, 1.0)
"""Distance ahead of a robot's centre at which what it holds begins, and height at which it ends, metres."""

LEAF_GAP = 0.01
"""Metres below a leaf."""


def guests_of(world: World, floor: int, known: Container[str]) -> list[str]:
    """Return the objects that are on a floor now, or in the hand of a robot that is, beside the `known` ones."""
    return [
        name for name, state in world.objects.changed.items() if name not in known and _floor_of(world, state) == floor
    ]


def _floor_of(world: World, state: ObjectState) -> int | None:
    """Return the floor on which an object can be seen, in a hand or not."""
    if state.held_by is None:
        return state.floor
    robot = world.robots.get(state.held_by)
    return robot.floor if robot is not None else None


class WorldSync:
    """Moves the bodies of one floor's model.

    Parameters
    ----------
    world : World
    floor : int
    model : FloorModel
    names : Names
    """

    def __init__(self, world: World, floor: int, model: FloorModel, names: Names) -> None:
        self._world = world
        self._floor = floor
        self._model = model
        self._names = names
        self._shown: dict[str, ObjectState] = {}
        self._held: set[str] = set()
        self._openings: dict[str, float] = {}
        self._lamps: dict[str, list[str]] = {}
        self._cabins: dict[str, float | None] = {}
        self._robots = 0
        for number in range(ROBOTS):
            model.put_into(robot_body(number), None, shown=False)
        for name in self._bodies():
            kind = world.objects.kinds[name]
            if kind.category in LAMPS:
                self._lamps.setdefault(kind.room, []).append(name)
            self._show(world.objects.state(name))
        for room in self._lamps:
            self._light(room)

    def _bodies(self) -> list[str]:
        return [name for name in self._model.bodies if name in self._world.objects]

    def synchronise(self, eye: RobotBody) -> None:
        """Bring the model up to date; the caller holds the world's lock.

        Parameters
        ----------
        eye : RobotBody
            Robot whose camera looks, and which it does not see.
        """
        self._follow_objects()
        self._follow_doors()
        self._follow_cabins()
        self._follow_robots(eye)
        self._model.settle()

    def _follow_objects(self) -> None:
        objects = self._world.objects
        # Those that came back to where the scene has them are no longer among the changed.
        for name in [*objects.changed, *(n for n in self._shown if n not in objects.changed)]:
            state = objects.state(name)
            if name in self._model.bodies and self._shown.get(name) is not state:
                self._show(state)
                if (room := objects.kinds[name].room) in self._lamps:
                    self._light(room)
        for name in sorted(self._held):
            self._show(objects.state(name))

    def _show(self, state: ObjectState) -> None:
        """Put an object where its state has it."""
        name, model = state.id, self._model
        kind = self._world.objects.kinds[name]
        self._shown[name] = state
        self._held.discard(name)
        if state.held_by is not None:
            self._held.add(name)
        bodies = [name, *self._parts(name)]
        if _floor_of(self._world, state) != self._floor:
            for body in bodies:
                if body in model.bodies:
                    model.put_into(body, None, shown=False)
            return
        x, y, z, yaw = self._pose(state)
        room = state.room
        if room is None:
            room = self._world.view(self._floor).map.room_at(x, y)
        model.place(name, (x, y, z), turn_about_z(yaw))
        model.put_into(name, room)
        opening = 1.0 if state.states.get("open") is True else 0.0
        for body, hinge in zip(self._parts(name), hinges_of(kind)):
            if body in model.bodies:
                position, turn = _hinged((x, y, z), yaw, hinge, opening)
                model.place(body, position, turn)
                model.put_into(body, room)
        if kind.toggleable and "on" in state.states:
            model.switch(name, on=state.states["on"] is True)

    def _parts(self, name: str) -> list[str]:
        hinges = hinges_of(self._world.objects.kinds[name])
        return [f"{name}{PART}{i}" for i in range(len(hinges))]

    def _pose(self, state: ObjectState) -> tuple[float, float, float, float]:
        """Return centre and yaw of an object in the floor's frame, also when it is in a hand."""
        if state.held_by is None and state.position is not None:
            return (*state.position, state.rotation)
        if state.parent is not None and state.position is not None:
            x, y, z, yaw = self._pose(self._world.objects.state(state.parent))
            dx, dy = turned(state.position[0], state.position[1], yaw)
            return x + dx, y + dy, z + state.position[2], yaw + state.rotation
        robot = self._world.robots[str(state.held_by)]
        _, d, h = self._world.objects.kinds[state.id].size
        dx, dy = turned(IN_HAND[0] + d / 2, 0.0, robot.pose.yaw)
        z = max(IN_HAND[1] - h / 2, h / 2)
        return robot.pose.x + dx, robot.pose.y + dy, z, robot.pose.yaw + 90.0

    def _follow_doors(self) -> None:
        world, view = self._world, self._world.view(self._floor)
        for door in view.doors.values():
            is_open = world.doors.get(door.id, door.is_open)
            opening = 1.0 if is_open else 0.0
            for room in door.rooms:
                lift = world.lifts.get(room) if room is not None else None
                if lift is not None:
                    away = abs(lift.position - lift.elevations[self._floor])
                    opening = lift.opening if away < 0.01 else 0.0
            if self._openings.get(door.id) == opening:
                continue
            self._openings[door.id] = opening
            for leaf in leaves_of(door, opening, view.map.room_at):
                if leaf.name in self._model.bodies:
                    place = (leaf.x, leaf.y, LEAF_GAP)
                    self._model.place(leaf.name, place, turn_about_z(leaf.yaw))

    def closed_doors(self) -> list[str]:
        """Return the doors that nobody looks through."""
        return [name for name, opening in self._openings.items() if opening <= 0.0]

    def _follow_cabins(self) -> None:
        for name, lift in self._world.lifts.items():
            if name not in self._model.bodies or self._floor not in lift.elevations:
                continue
            above = lift.position - lift.elevations[self._floor]
            height = above if abs(above) < 3.0 else None
            if self._cabins.get(name, 0.0) == height and name in self._cabins:
                continue
            self._cabins[name] = height
            position, turn = self._model.home(name)
            if height is not None:
                self._model.place(name, (*position[:2], position[2] + height), turn)
            self._model.put_into(name, name, shown=height is not None)

    def _follow_robots(self, eye: RobotBody) -> None:
        others = [
            robot for _, robot in sorted(self._world.robots.items()) if robot is not eye and robot.floor == self._floor
        ][:ROBOTS]
        for number, robot in enumerate(others):
            body = robot_body(number)
            self._model.place(body, (robot.pose.x, robot.pose.y, 0.0), turn_about_z(robot.pose.yaw))
            self._model.put_into(body, None)
            self._model.label[self._model.geoms(body)] = self._names.index(f"robot/{robot.session}")
        for number in range(len(others), self._robots):
            self._model.put_into(robot_body(number), None, shown=False)
        self._robots = len(others)

    def _light(self, room: str) -> None:
        states = [self._world.objects.state(name).states for name in self._lamps[room]]
        shining = sum(state.get("on") is not False for state in states) / len(states)
        if room in self._model.rooms:
            self._model.light(room, DARK + (1.0 - DARK) * shining)


def _hinged(
    center: tuple[float, float, float], yaw: float, hinge: Hinge, opening: float
) -> tuple[tuple[float, float, float], Turn]:
    """Return the pose of a part whose mesh is in its object's frame: turned about its hinge, or slid."""
    half = radians(hinge.angle * opening) / 2
    w, (ax, ay, az) = cos(half), (sin(half) * a for a in hinge.axis)
    # The hinge stays where it is: the origin goes to pivot - R pivot.
    px, py, pz = hinge.pivot
    tx, ty, tz = 2 * (ay * pz - az * py), 2 * (az * px - ax * pz), 2 * (ax * py - ay * px)
    rx = px + w * tx + ay * tz - az * ty
    ry = py + w * ty + az * tx - ax * tz
    rz = pz + w * tz + ax * ty - ay * tx
    local = [p - r + opening * s for p, r, s in zip(hinge.pivot, (rx, ry, rz), hinge.slide)]
    dx, dy = turned(local[0], local[1], yaw)
    cw, _, _, cz = turn_about_z(yaw)
    turn = (cw * w - cz * az, cw * ax - cz * ay, cw * ay + cz * ax, cw * az + cz * w)
    return (center[0] + dx, center[1] + dy, center[2] + local[2]), turn
