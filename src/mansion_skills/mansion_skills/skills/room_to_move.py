"""Where a robot could go straight from where it stands, and what is in its way: the hints of MoveAhead."""

from dataclasses import dataclass
from math import cos, dist, floor, radians, sin

from mansion_msgs_py.shapes import Point
from mansion_skills.navigation.floor_map import CLEARANCE, FLAT, LEAFLESS, RESOLUTION
from mansion_skills.navigation.paths import SNAP, free_run
from mansion_skills.skills.motion import path_to
from mansion_skills.world.footprint import box_distance, segment_distance
from mansion_skills.world.landmarks import Landmark
from mansion_skills.world.robot_body import RobotBody, turn_between
from mansion_skills.world.world import World

__all__ = ["LONGEST_MOVE", "WayOut", "free_around", "in_the_way", "way_out"]

LONGEST_MOVE = 20.0
"""Of MoveAhead, metres."""

WAYS = {"ahead": 0.0, "left": 90.0, "back": 180.0, "right": 270.0}

AWAY = 0.5
"""How far a landmark has to be to be a way out, metres."""

MOST_TRIED = 5
"""Landmarks to which a way is sought."""

TURN_STEP = 15.0
"""Between the directions that are tried where there is no way, degrees."""

WALL = "a wall"


def free_around(world: World, robot: RobotBody) -> dict[str, float]:
    """Return how far the robot could go in its four directions, metres."""
    return {way: _free(world, robot, angle) for way, angle in WAYS.items()}


@dataclass(frozen=True)
class WayOut:
    """The first straight part of the way to a landmark.

    Attributes
    ----------
    degrees : float
        To turn by, in (-180, 180], counter-clockwise.
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

    Who follows it again and again arrives: the goal stays the same as long as the room does.
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
        From the robot's front, degrees.
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
    """Return the distance from a point to each thing, closed door and robot of the floor."""
    view = world.view(robot.floor)
    found = []
    for state in world.objects.on_floor(robot.floor):
        kind = world.objects.kinds[state.id]
        assert state.position is not None
        low = state.position[2] - kind.size[2] / 2
        stands = state.mount not in ("surface", "inside")
        if stands and low < CLEARANCE and low + kind.size[2] > FLAT:
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
