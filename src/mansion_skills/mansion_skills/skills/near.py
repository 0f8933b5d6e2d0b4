"""GoNearObject: to where the hand reaches an object, or a door, and the camera sees it."""

from math import atan2, ceil, copysign, degrees, dist

import msgspec
import numpy as np

from mansion_msgs_py.scene import Door
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.skills import NearObjectArgs
from mansion_msgs_py.world import ObjectState, SkillChange
from mansion_skills.navigation.search import NO_CELL, nearest_free, region_of
from mansion_skills.skills.doors import DOOR_REACH
from mansion_skills.skills.motion import drive, path_to
from mansion_skills.skills.moving import PITCHES, no_way
from mansion_skills.skills.naming import door_named, object_named
from mansion_skills.skills.outcome import Run, done, invalid, unmet
from mansion_skills.skills.seeing import (
    CAMERA_HEIGHT,
    REACH,
    VIEW_ANGLE,
    closed_carrier,
    in_sight,
    reach_to,
    sight_points,
)
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = ["go_near_object"]

TILT_STEP = 15.0
"""Degrees; also what is left between an object's middle and the edge of the picture."""

COMFORT = 0.9
"""Part of the reach that is made use of, so that rounding costs nothing."""


def go_near_object(world: World, robot: RobotBody, arguments: NearObjectArgs, realtime: bool) -> Run:
    """Go to the nearest place from which an object can be handled, and face it."""
    name = "GoNearObject"
    door = door_named(world, robot, arguments.object)
    if isinstance(door, Door):
        (ax, ay), (bx, by) = door.segment
        middle = ((ax + bx) / 2, (ay + by) / 2)
        spots = _places_beside(world, robot, door, middle)
        return (yield from _approach(world, robot, name, door.id, middle, 1.0, spots, realtime))
    state = object_named(world, robot, arguments.object)
    if isinstance(state, str):
        return invalid(world, robot, name, state, "an id that ListVisible gives, or a door's")
    if state.held_by is not None:
        text = f"{state.id} is in the hand of {state.held_by}"
        return unmet(world, robot, name, text, "Place")
    if state.floor != robot.floor:
        text = f"{state.id} is on floor {state.floor}, the robot on floor {robot.floor}"
        return unmet(world, robot, name, text, f"going to floor {state.floor}")
    assert state.position is not None
    goal = (state.position[0], state.position[1])
    spots = _places_near(world, robot, state)
    return (yield from _approach(world, robot, name, state.id, goal, state.position[2], spots, realtime))


def _approach(
    world: World,
    robot: RobotBody,
    name: str,
    what: str,
    target: Point,
    height: float,
    spots: list[Point],
    realtime: bool,
) -> Run:
    before = robot.pose
    path = path_to(world, robot, spots[0], 0.0) if spots else None
    if path is None:
        return no_way(world, robot, name, target, REACH, what)
    end = path[-1]
    yaw = degrees(atan2(target[1] - end[1], target[0] - end[0]))
    robot.pitch = 0.0
    meters = yield from drive(world, robot, path, yaw, realtime)
    if robot.place != end:
        return no_way(world, robot, name, target, REACH, what)
    robot.pitch = _tilt_towards(height, max(dist(end, target), world.radius))
    return done(
        world,
        robot,
        name,
        f"near {what}",
        SkillChange(what="pose", before=before, after=robot.pose),
        at=what,
        meters=round(meters, 3),
    )


def _tilt_towards(height: float, away: float) -> float:
    """Return the least tilt, in steps, by which something is well inside the picture; mostly the camera stays level."""
    angle = degrees(atan2(height - CAMERA_HEIGHT, away))
    beyond = max(0.0, abs(angle) - (VIEW_ANGLE / 2 - TILT_STEP))
    return copysign(min(PITCHES[1], ceil(beyond / TILT_STEP) * TILT_STEP), angle) if beyond else 0.0


def _reached(world: World, robot: RobotBody) -> np.ndarray[tuple[int, int], np.dtype[np.bool_]]:
    """Return the cells that the robot can get to."""
    blocked = world.blocked_for(robot.session, robot.floor)
    frame = world.view(robot.floor).map.frame
    row, column = frame.cell(*robot.place)
    cell = int(nearest_free(blocked, row, column, int(0.6 / frame.resolution)))
    if cell == NO_CELL:
        return np.zeros_like(blocked)
    reached: np.ndarray[tuple[int, int], np.dtype[np.bool_]] = region_of(
        blocked, cell // frame.columns, cell % frame.columns
    )
    return reached


def _candidates(world: World, robot: RobotBody, center: Point, reach: float) -> list[Point]:
    """Return reachable cell centres around a point, the nearest first."""
    frame = world.view(robot.floor).map.frame
    reached = _reached(world, robot)
    row, column = frame.cell(*center)
    k = int(reach / frame.resolution) + 1
    r0, c0 = max(0, row - k), max(0, column - k)
    rows, columns = np.nonzero(reached[r0 : row + k + 1, c0 : column + k + 1])
    points = [frame.center(int(r) + r0, int(c) + c0) for r, c in zip(rows, columns)]
    away = [(round(dist(point, center), 6), point) for point in points]
    return [point for distance, point in sorted(away) if distance <= reach]


def _places_beside(world: World, robot: RobotBody, door: Door, middle: Point) -> list[Point]:
    """Return places beside a door, clear of its leaf."""
    grid = world.view(robot.floor).map
    return [
        point
        for point in _candidates(world, robot, middle, COMFORT * DOOR_REACH)
        if grid.room_at(*point) in door.rooms and dist(point, middle) > 0.6
    ]


def _places_near(world: World, robot: RobotBody, state: ObjectState) -> list[Point]:
    """Return the first place from which the hand reaches an object and the camera sees it."""
    kind = world.objects.kinds[state.id]
    assert state.position is not None
    center = (state.position[0], state.position[1])
    half = (kind.size[0] ** 2 + kind.size[1] ** 2) ** 0.5 / 2
    shut = closed_carrier(world, state)
    seen = state if shut is None else world.objects.state(shut)
    points = sight_points(seen, world.objects.kinds[seen.id])
    for point in _candidates(world, robot, center, COMFORT * REACH + half):
        there = msgspec.structs.replace(robot.pose, x=point[0], y=point[1])
        body = RobotBody(robot.session, robot.floor, there, robot.radius)
        if reach_to(body, state, kind) > COMFORT * REACH:
            continue
        body.pose.yaw = degrees(atan2(center[1] - point[1], center[0] - point[0]))
        visible = in_sight(world, robot.floor, point, seen, points)
        if any(abs(body.bearing(spot)) < VIEW_ANGLE / 2 - 1.0 for spot in visible):
            return [point]
    return []
