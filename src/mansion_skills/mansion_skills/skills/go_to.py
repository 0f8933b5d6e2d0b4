"""GoToLandmark, MoveTo and GoNearObject: plan a path to a place of this floor and drive there."""

from math import atan2, ceil, copysign, degrees, dist
from typing import Annotated, Any

import numpy as np

from mansion_geometry.disc_cells import region_of
from mansion_msgs_py.scene import Door
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.skills import SessionArgs
from mansion_msgs_py.wording import choices
from mansion_msgs_py.world import ObjectState, Pose2D, SkillChange, SkillResult, SkillStatus
from mansion_skills.navigation.grid_kernels import NO_CELL, nearest_free
from mansion_skills.skills.declaration import Action, Argument, Card, skill
from mansion_skills.skills.doors import DOOR_REACH
from mansion_skills.skills.driving import blocking_door, drive, path_to
from mansion_skills.skills.manipulation import ObjectArgs
from mansion_skills.skills.motion_primitives import PITCHES
from mansion_skills.skills.references import door_named, object_named
from mansion_skills.skills.results import Run, done, invalid, number, refused, unmet
from mansion_skills.skills.visibility import (
    CAMERA_HEIGHT,
    REACH,
    VIEW_ANGLE,
    closed_carrier,
    in_sight,
    reach_to,
    sight_points,
)
from mansion_skills.world.floor_view import landmark_named
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = [
    "GoToLandmarkArgs",
    "LANDMARK_SNAP",
    "MoveToArgs",
    "NearObjectArgs",
    "go_near_object",
    "go_to_landmark",
    "move_to",
]

LANDMARK_SNAP = 1.5
"""How far beside a landmark's pose the robot may end where something stands in it, metres."""

POINT_SNAP = 0.1
"""How far beside its point MoveTo may end, metres."""

TILT_STEP = 15.0
"""Steps of the camera's tilt, degrees; also the least angle between an object's centre and the edge of the picture."""

COMFORT = 0.9
"""Share of the reach that is used, so that an object at its limit stays in reach after rounding."""


class GoToLandmarkArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A room, a core, or ``elevator`` or ``stairs`` for the nearest of its kind on this floor."""

    landmark: Annotated[Any, Argument("landmark", "room or core, or `elevator` or `stairs` for the nearest one")]


class MoveToArgs(SessionArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """A point of this floor in metres; the robot ends with `yaw` (degrees), or as it arrives."""

    x: Annotated[Any, Argument("number", "metres")]
    y: Annotated[Any, Argument("number", "metres")]
    yaw: Annotated[Any, Argument("number", "heading at the end, degrees; as the robot arrives when absent")] = None


class NearObjectArgs(ObjectArgs, frozen=True, kw_only=True, forbid_unknown_fields=True):
    """An object or a door of this floor."""


@skill(
    "GoToLandmark",
    "Go to a room or a core of this floor.",
    arguments=GoToLandmarkArgs,
    example='{"landmark": "elevator"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PLANNING_FAILURE, SkillStatus.EXECUTION_FAILURE),
    card=Card("go to a landmark of this floor", ("landmark",)),
    actions=(Action(indexed="landmark"),),
)
def go_to_landmark(world: World, robot: RobotBody, arguments: GoToLandmarkArgs, *, realtime: bool) -> Run:
    """Go to a room or a core of the current floor."""
    name = "GoToLandmark"
    view = world.view(robot.floor)
    wanted = arguments.landmark if isinstance(arguments.landmark, str) else ""
    landmark = landmark_named(wanted, view.landmarks, robot.floor, robot.place)
    if landmark is None:
        known = [entry.name for entry in view.landmarks]
        near = choices(arguments.landmark, known, "landmarks")
        text = f"floor {robot.floor} has no landmark {str(arguments.landmark)[:80]!r}; {near}"
        return invalid(world, robot, name, text, "a landmark that ListLandmarks names")
    goal = (landmark.pose.x, landmark.pose.y)
    return (
        yield from _go_along(
            world, robot, name, goal, landmark.pose.yaw, LANDMARK_SNAP, landmark.name, realtime=realtime
        )
    )


@skill(
    "MoveTo",
    "Go to a point of this floor.",
    arguments=MoveToArgs,
    example='{"x": 3.0, "y": 2.5, "yaw": 90}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PLANNING_FAILURE, SkillStatus.EXECUTION_FAILURE),
)
def move_to(world: World, robot: RobotBody, arguments: MoveToArgs, *, realtime: bool) -> Run:
    """Go to a point of the current floor."""
    name = "MoveTo"
    x, y = number(arguments.x), number(arguments.y)
    yaw = None if arguments.yaw is None else number(arguments.yaw)
    if x is None or y is None or (yaw is None and arguments.yaw is not None):
        return invalid(world, robot, name, "x, y and yaw must be finite numbers", "metres, degrees")
    if world.view(robot.floor).map.room_at(x, y) is None:
        text = f"({x:g}, {y:g}) is in no room of floor {robot.floor}"
        return invalid(world, robot, name, text, "a point inside a room")
    where = f"({x:g}, {y:g})"
    return (yield from _go_along(world, robot, name, (x, y), yaw, POINT_SNAP, where, realtime=realtime))


@skill(
    "GoNearObject",
    "Go to where an object can be reached and face it.",
    arguments=NearObjectArgs,
    example='{"object": "F1/lobby/mug_1"}',
    failures=(SkillStatus.INVALID_ACTION, SkillStatus.PRECONDITION_FAILURE, SkillStatus.PLANNING_FAILURE),
    card=Card("go to an object in view, near enough to handle it", ("object",)),
    actions=(Action(indexed="object"),),
)
def go_near_object(world: World, robot: RobotBody, arguments: NearObjectArgs, *, realtime: bool) -> Run:
    """Go to the nearest place from which an object can be handled, and face it."""
    name = "GoNearObject"
    door = door_named(world, robot, arguments.object)
    if isinstance(door, Door):
        (ax, ay), (bx, by) = door.segment
        middle = ((ax + bx) / 2, (ay + by) / 2)
        spots = _places_beside(world, robot, door, middle)
        return (yield from _approach(world, robot, name, door.id, middle, 1.0, spots, realtime=realtime))
    state = object_named(world, robot, arguments.object)
    if isinstance(state, str):
        return invalid(world, robot, name, state, "an id that ListVisible gives, or a door's")
    if state.held_by is not None:
        text = f"{state.id} is held by {state.held_by}"
        return unmet(world, robot, name, text, "Place")
    if state.floor != robot.floor:
        text = f"{state.id} is on floor {state.floor}, the robot on floor {robot.floor}"
        return unmet(world, robot, name, text, f"going to floor {state.floor}")
    assert state.position is not None
    goal = (state.position[0], state.position[1])
    spots = _places_near(world, robot, state)
    return (yield from _approach(world, robot, name, state.id, goal, state.position[2], spots, realtime=realtime))


def _go_along(
    world: World,
    robot: RobotBody,
    name: str,
    goal: Point,
    yaw: float | None,
    snap: float,
    where: str,
    *,
    realtime: bool,
) -> Run:
    """Plan a path to a point and drive there with the camera level."""
    before = robot.pose
    path = path_to(world, robot, goal, snap)
    if path is None:
        return _no_way(world, robot, name, goal, snap, where)
    begin = world.time
    robot.pitch = 0.0
    meters = yield from drive(world, robot, path, yaw, realtime=realtime)
    if robot.place != path[-1]:
        text = f"another robot blocks the way to {where}"
        return refused(world, robot, name, SkillStatus.EXECUTION_FAILURE, text, "try again")
    return done(
        world,
        robot,
        name,
        f"at {where}",
        SkillChange(what="pose", before=before, after=robot.pose),
        at=where,
        meters=round(meters, 3),
        seconds=round(world.time - begin, 3),
    )


def _no_way(world: World, robot: RobotBody, name: str, goal: Point, snap: float, where: str) -> SkillResult:
    """Return a planning failure that says what would help."""
    door = blocking_door(world, robot, goal, snap)
    if door is not None:
        text = f"the way to {where} is blocked by the closed door {door}"
        wish = f"GoNearObject {door} and OpenDoor {door}"
    else:
        text = f"there is no path to {where}: an obstacle is there or on the way"
        wish = "another place, or moving the obstacle"
    return refused(world, robot, name, SkillStatus.PLANNING_FAILURE, text, wish)


def _approach(
    world: World,
    robot: RobotBody,
    name: str,
    what: str,
    target: Point,
    height: float,
    spots: list[Point],
    *,
    realtime: bool,
) -> Run:
    before = robot.pose
    path = path_to(world, robot, spots[0], 0.0) if spots else None
    if path is None:
        return _no_way(world, robot, name, target, REACH, what)
    end = path[-1]
    yaw = degrees(atan2(target[1] - end[1], target[0] - end[0]))
    robot.pitch = 0.0
    meters = yield from drive(world, robot, path, yaw, realtime=realtime)
    if robot.place != end:
        return _no_way(world, robot, name, target, REACH, what)
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
    """Return the least tilt, in steps, that brings a point well inside the picture; 0 for most."""
    angle = degrees(atan2(height - CAMERA_HEIGHT, away))
    beyond = max(0.0, abs(angle) - (VIEW_ANGLE / 2 - TILT_STEP))
    return copysign(min(PITCHES[1], ceil(beyond / TILT_STEP) * TILT_STEP), angle) if beyond else 0.0


def _reached(world: World, robot: RobotBody) -> np.ndarray[tuple[int, int], np.dtype[np.bool_]]:
    """Return the cells that the robot's centre can reach."""
    blocked = world.blocked_for(robot.session, robot.floor)
    frame = world.view(robot.floor).map.frame
    row, column = frame.cell(*robot.place)
    cell = int(nearest_free(blocked, row, column, int(0.6 / frame.resolution)))
    if cell == NO_CELL:
        return np.zeros_like(blocked)
    return region_of(blocked, cell // frame.columns, cell % frame.columns)


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
        yaw = degrees(atan2(center[1] - point[1], center[0] - point[0]))
        body = RobotBody(robot.session, robot.floor, Pose2D(x=point[0], y=point[1], yaw=yaw), robot.radius)
        if reach_to(body, state, kind) > COMFORT * REACH:
            continue
        visible = in_sight(world, robot.floor, point, seen, points)
        if any(abs(body.bearing(spot)) < VIEW_ANGLE / 2 - 1.0 for spot in visible):
            return [point]
    return []
