"""How a robot drives along a path, and why it cannot."""

from collections.abc import Generator, Sequence
from itertools import pairwise
from math import atan2, degrees, dist

from mansion_msgs_py.shapes import Point
from mansion_msgs_py.world import Pose2D
from mansion_skills.navigation.floor_map import LEAFLESS
from mansion_skills.navigation.paths import find_path
from mansion_skills.skills.outcome import Step
from mansion_skills.world.floor_view import bodies_of
from mansion_skills.world.footprint import segment_distance
from mansion_skills.world.robot_body import RobotBody, turn_between
from mansion_skills.world.world import World

__all__ = ["SPEED", "TURN_SPEED", "blocking_door", "drive", "path_to", "turn"]

SPEED = 0.5
"""Metres a second."""

TURN_SPEED = 90.0
"""Degrees a second."""

SLICE = 0.1
"""Seconds of motion between two steps in real time."""

PATIENCE = 5.0
"""Seconds that a robot waits for another one to leave its way, in real time."""


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
    world: World, robot: RobotBody, path: Sequence[Point], yaw: float | None, realtime: bool, *, backwards: bool = False
) -> Generator[Step, None, float]:
    """Drive along a path and turn to `yaw`; return the metres driven.

    A robot that another one stops gives up after a while: the metres returned are then fewer than the path's.
    """
    robot.path = list(path)
    whole = max(sum(dist(a, b) for a, b in pairwise(path)), 1e-9)
    gone, seconds = 0.0, 0.0
    for a, b in pairwise(path):
        length = dist(a, b)
        if length < 1e-9:
            continue
        heading = degrees(atan2(b[1] - a[1], b[0] - a[0])) + (180.0 if backwards else 0.0)
        if realtime:
            yield from turn(world, robot, heading, True, gone / whole)
            moved = yield from _go(world, robot, a, b, gone, whole)
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
            yield from turn(world, robot, yaw, True, 1.0)
        robot.move(Pose2D(x=robot.pose.x, y=robot.pose.y, yaw=round(yaw % 360.0, 6)))
    if not realtime:
        yield Step(seconds, 1.0, "driving")
    return gone


def _go(world: World, robot: RobotBody, a: Point, b: Point, gone: float, whole: float) -> Generator[Step, None, float]:
    length, moved, waited = dist(a, b), 0.0, 0.0
    while moved < length - 1e-9:
        step = min(SPEED * SLICE, length - moved)
        t = (moved + step) / length
        there = (a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t)
        if _in_the_way(world, robot, there):
            if waited >= PATIENCE:
                return moved
            waited += SLICE
            yield Step(SLICE, (gone + moved) / whole, "waiting for another robot")
            continue
        moved, waited = moved + step, 0.0
        robot.move(Pose2D(x=there[0], y=there[1], yaw=robot.pose.yaw))
        yield Step(step / SPEED, (gone + moved) / whole, "driving")
    return moved


def _in_the_way(world: World, robot: RobotBody, there: Point) -> bool:
    return any(
        dist(there, place) < min(2 * world.radius, dist(robot.place, place) + 1e-9)
        for place in world.others(robot.session, robot.floor)
    ) or (world.view(robot.floor).map.is_free(*robot.place) and not world.view(robot.floor).map.is_free(*there))


def turn(
    world: World, robot: RobotBody, yaw: float, realtime: bool, fraction: float = 1.0
) -> Generator[Step, None, None]:
    """Turn on the spot to a direction, the shorter way round."""
    left = turn_between(robot.pose.yaw, yaw)
    most = TURN_SPEED * SLICE if realtime else 360.0
    while abs(left) > 1e-9:
        part = max(-most, min(most, left))
        left -= part
        new = round((robot.pose.yaw + part) % 360.0, 6)
        robot.move(Pose2D(x=robot.pose.x, y=robot.pose.y, yaw=new))
        yield Step(abs(part) / TURN_SPEED, fraction, "turning")
