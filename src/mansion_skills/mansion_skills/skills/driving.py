"""Drive along a path or turn on the spot; what blocks the way, and the clearance around the robot."""

from collections.abc import Generator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import atan2, cos, degrees, dist, floor, radians, sin

from mansion_geometry.doorways import LEAFLESS
from mansion_geometry.floor_grid import RESOLUTION
from mansion_geometry.plane import segment_distance
from mansion_geometry.robot_body import in_the_way as blocks_robot
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.world import Pose2D
from mansion_skills.navigation.paths import SNAP, find_path, free_run
from mansion_skills.skills.results import Step
from mansion_skills.world.floor_view import Landmark, bodies_of
from mansion_skills.world.objects import box_distance
from mansion_skills.world.robot_body import RobotBody, turn_between
from mansion_skills.world.world import World

__all__ = [
    "LONGEST_MOVE",
    "SPEED",
    "TURN_SPEED",
    "WayOut",
    "blocking_door",
    "drive",
    "free_around",
    "in_the_way",
    "path_to",
    "turn",
    "way_out",
]

SPEED = 0.5
"""Metres a second."""

TURN_SPEED = 90.0
"""Degrees a second."""

SLICE = 0.1
"""Duration of a step in real time, seconds."""

PATIENCE = 5.0
"""How long a robot waits for another one that blocks it, in real time, seconds."""

LONGEST_MOVE = 20.0
"""Longest distance of MoveAhead, metres."""

WAYS = {"ahead": 0.0, "left": 90.0, "back": 180.0, "right": 270.0}

AWAY = 0.5
"""Least distance of a landmark that counts as a way out, metres."""

MOST_TRIED = 5
"""Landmarks to which a path is sought."""

TURN_STEP = 15.0
"""Step between the directions that are tried where no path leads to a landmark, degrees."""

WALL = "a wall"


def path_to(world: World, robot: RobotBody, goal: Point, snap: float) -> list[Point] | None:
    """Return a path of the robot's floor, clear of walls, closed doors, objects and other robots, or ``None``."""
    grid = world.view(robot.floor).map
    blocked = world.blocked_for(robot.session, robot.floor)
    return find_path(blocked, grid.frame, robot.place, goal, snap)


def blocking_door(world: World, robot: RobotBody, goal: Point, snap: float) -> str | None:
    """Return the first closed door on the way that the robot would take if all were open, or ``None``."""
    view = world.view(robot.floor)
    closed = [
        door for door in view.scene.doors if door.kind not in LEAFLESS and not world.doors.get(door.id, door.is_open)
    ]
    if not closed:
        return None
    view.map.update(bodies_of(robot.floor, world.objects), dict.fromkeys(view.doors, True))
    path = find_path(view.map.blocked, view.map.frame, robot.place, goal, snap)
    world.refresh(robot.floor)
    for point in path or []:
        for door in closed:
            if segment_distance(point, door.segment) < 0.3:
                return door.id
    for a, b in pairwise(path or []):
        for door in closed:
            if _crosses(a, b, *door.segment):
                return door.id
    return None


def _crosses(a: Point, b: Point, c: Point, d: Point) -> bool:
    def side(p: Point, q: Point, r: Point) -> float:
        return (q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0])

    return side(a, b, c) * side(a, b, d) < 0 and side(c, d, a) * side(c, d, b) < 0


def drive(
    world: World, robot: RobotBody, path: Sequence[Point], yaw: float | None, *, realtime: bool, backwards: bool = False
) -> Generator[Step, None, float]:
    """Drive along a path and turn to `yaw`; return the metres driven.

    A robot that another one stops gives up after a while: the metres returned are then fewer than the path's.
    """
    robot.path = list(path)
    total = max(sum(dist(a, b) for a, b in pairwise(path)), 1e-9)
    gone, seconds = 0.0, 0.0
    for a, b in pairwise(path):
        length = dist(a, b)
        if length < 1e-9:
            continue
        heading = degrees(atan2(b[1] - a[1], b[0] - a[0])) + (180.0 if backwards else 0.0)
        if realtime:
            yield from turn(world, robot, heading, realtime=True, fraction=gone / total)
            moved = yield from _go(world, robot, a, b, gone, total)
            gone += moved
            if moved < length - 1e-6:
                return gone
        else:
            seconds += abs(turn_between(robot.pose.yaw, heading)) / TURN_SPEED + length / SPEED
            robot.move(Pose2D(x=b[0], y=b[1], yaw=round(heading % 360.0, 6)))
            gone += length
    if yaw is not None:
        seconds += abs(turn_between(robot.pose.yaw, yaw)) / TURN_SPEED
        if realtime:
            yield from turn(world, robot, yaw, realtime=True)
        robot.move(Pose2D(x=robot.pose.x, y=robot.pose.y, yaw=round(yaw % 360.0, 6)))
    if not realtime:
        yield Step(seconds, 1.0, "driving")
    return gone


def _go(world: World, robot: RobotBody, a: Point, b: Point, gone: float, total: float) -> Generator[Step, None, float]:
    length, moved, waited = dist(a, b), 0.0, 0.0
    while moved < length - 1e-9:
        step = min(SPEED * SLICE, length - moved)
        t = (moved + step) / length
        there = (a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t)
        if _is_obstructed(world, robot, there):
            if waited >= PATIENCE:
                return moved
            waited += SLICE
            yield Step(SLICE, (gone + moved) / total, "waiting for another robot")
            continue
        moved, waited = moved + step, 0.0
        robot.move(Pose2D(x=there[0], y=there[1], yaw=robot.pose.yaw))
        yield Step(step / SPEED, (gone + moved) / total, "driving")
    return moved


def _is_obstructed(world: World, robot: RobotBody, there: Point) -> bool:
    return any(
        dist(there, place) < min(2 * world.radius, dist(robot.place, place) + 1e-9)
        for place in world.others(robot.session, robot.floor)
    ) or (world.view(robot.floor).map.is_free(*robot.place) and not world.view(robot.floor).map.is_free(*there))


def turn(
    world: World, robot: RobotBody, yaw: float, *, realtime: bool, fraction: float = 1.0
) -> Generator[Step, None, None]:
    """Turn on the spot to a direction, the shorter way round."""
    yield from turn_by(world, robot, turn_between(robot.pose.yaw, yaw), realtime=realtime, fraction=fraction)


def turn_by(
    world: World, robot: RobotBody, angle: float, *, realtime: bool, fraction: float = 1.0
) -> Generator[Step, None, None]:
    """Turn on the spot by an angle, counter-clockwise; full turns are made too."""
    left = angle
    most = TURN_SPEED * SLICE if realtime else 360.0
    while abs(left) > 1e-9:
        part = max(-most, min(most, left))
        left -= part
        new = round((robot.pose.yaw + part) % 360.0, 6)
        robot.move(Pose2D(x=robot.pose.x, y=robot.pose.y, yaw=new))
        yield Step(abs(part) / TURN_SPEED, fraction, "turning")


def free_around(world: World, robot: RobotBody) -> dict[str, float]:
    """Return how far the robot could go in its four directions, metres."""
    return {way: _free(world, robot, angle) for way, angle in WAYS.items()}


@dataclass(frozen=True)
class WayOut:
    """The first straight part of the way to a landmark.

    Attributes
    ----------
    degrees : float
        Angle to turn by, counter-clockwise, in (-180, 180].
    meters : float
        Free ahead after that turn, at most to the way's next bend.
    to : str
        The landmark; empty where no way leads to any, and the turn is the one with the most room.
    """

    degrees: float
    meters: float
    to: str


def way_out(world: World, robot: RobotBody) -> WayOut:
    """Return how to get to the middle of the room, or from there to a landmark near by.

    A robot that follows it repeatedly arrives, since the goal stays the same while it is in the room.
    """
    view = world.view(robot.floor)
    room = view.map.room_at(*robot.place)
    marks = [mark for mark in view.landmarks if _apart(robot, mark) > AWAY]
    marks.sort(key=lambda mark: (mark.name != room, _apart(robot, mark), mark.name))
    for mark in marks[:MOST_TRIED]:
        path = path_to(world, robot, (mark.pose.x, mark.pose.y), SNAP)
        bend = next((p for p in path or [] if dist(p, robot.place) > RESOLUTION), None)
        if bend is None:
            continue
        turn = round(robot.bearing(bend), 3)
        free = min(dist(bend, robot.place), _free(world, robot, turn))
        if free > 0.0:
            return WayOut(turn, floor(free * 1000) / 1000, mark.name)
    turns = sorted((turn_between(0.0, i * TURN_STEP) for i in range(int(360.0 / TURN_STEP))), key=abs)
    most, rank = max((_free(world, robot, turn), -i) for i, turn in enumerate(turns))
    return WayOut(turns[-rank], most, "")


def _apart(robot: RobotBody, mark: Landmark) -> float:
    return dist(robot.place, (mark.pose.x, mark.pose.y))


def _free(world: World, robot: RobotBody, angle: float) -> float:
    blocked = world.blocked_for(robot.session, robot.floor)
    frame = world.view(robot.floor).map.frame
    yaw = radians(robot.pose.yaw + angle)
    return round(free_run(blocked, frame, robot.place, yaw, LONGEST_MOVE), 3)


def in_the_way(world: World, robot: RobotBody, angle: float, free: float) -> str:
    """Return what ends a straight way: an object's or a closed door's id, a robot, or a wall.

    Parameters
    ----------
    angle : float
        Direction relative to the robot's heading, degrees.
    free : float
        Metres that are free (`free_around`).
    """
    yaw = radians(robot.pose.yaw + angle)
    ahead = free + RESOLUTION
    point = (robot.pose.x + ahead * cos(yaw), robot.pose.y + ahead * sin(yaw))
    near = _bodies(world, robot, point)
    reach = robot.radius + 2 * RESOLUTION
    away, name = min(near, default=(reach, WALL))
    return name if away < reach else WALL


def _bodies(world: World, robot: RobotBody, point: Point) -> list[tuple[float, str]]:
    """Return the distance from a point to each object, closed door and robot of the floor."""
    view = world.view(robot.floor)
    found = []
    for state in world.objects.on_floor(robot.floor):
        kind = world.objects.kinds[state.id]
        assert state.position is not None
        low = state.position[2] - kind.size[2] / 2
        stands = state.mount not in ("surface", "inside")
        if stands and blocks_robot(low, low + kind.size[2]):
            found.append((box_distance(point, state, kind), state.id))
    for door in view.scene.doors:
        is_open = world.doors.get(door.id, door.is_open)
        if door.kind not in LEAFLESS and not is_open:
            found.append((segment_distance(point, door.segment), door.id))
    for name, other in sorted(world.robots.items()):
        if name != robot.session and other.floor == robot.floor:
            away = max(0.0, dist(point, other.place) - other.radius)
            found.append((away, f"the robot of session {name!r}"))
    return found
