"""What the robot sees and what its hand reaches from where it stands."""

from collections.abc import Iterator
from math import asin, atan2, degrees, dist, hypot

import numpy as np

from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.world import ObjectState
from mansion_skills.navigation.grid_kernels import sees
from mansion_skills.world.objects import box_distance, corners
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = [
    "CAMERA_HEIGHT",
    "REACH",
    "SIGHT_END",
    "TOP_REACH",
    "VIEW_ANGLE",
    "VIEW_RANGE",
    "closed_carrier",
    "in_sight",
    "is_visible",
    "reach_to",
    "sight_points",
]

REACH = 1.5
"""How far the hand reaches from the robot's centre, metres in plan."""

TOP_REACH = 2.0
"""How high the hand reaches, metres."""

VIEW_RANGE = 8.0
"""How far the robot sees objects, metres."""

VIEW_ANGLE = 90.0
"""Field of view of the camera, horizontally and vertically, degrees."""

CAMERA_HEIGHT = 1.2

SIGHT_END = 3.0
"""Cells before its centre where a line of sight ends, so that objects on walls are seen."""


def reach_to(robot: RobotBody, state: ObjectState, kind: SceneObject) -> float:
    """Return the plan distance from the robot's centre to an object, metres."""
    return box_distance(robot.place, state, kind)


def closed_carrier(world: World, state: ObjectState) -> str | None:
    """Return the closed container that an object lies in, or ``None``."""
    while state.parent is not None:
        inside = state.mount == "inside"
        state = world.objects.state(state.parent)
        if inside and state.states.get("open") is False:
            return state.id
    return None


def in_sight(world: World, floor: int, place: Point, state: ObjectState, points: list[Point]) -> Iterator[Point]:
    """Yield those of an object's `points` that a straight line from `place` meets unhindered."""
    view = world.view(floor)
    frame = view.map.frame
    labels = []
    entry: ObjectState | None = state
    while entry is not None:
        labels.append(view.numbers.get(entry.id, 0))
        entry = world.objects.state(entry.parent) if entry.parent is not None else None
    ours = np.array(labels, dtype=np.int16)
    r0, c0 = frame.coordinates(*place)
    for x, y in points:
        r1, c1 = frame.coordinates(x, y)
        if sees(view.map.view, r0, c0, r1, c1, SIGHT_END, ours):
            yield x, y


def sight_points(state: ObjectState, kind: SceneObject) -> list[Point]:
    """Return the points by which an object is seen: its centre and, a little inside, its corners."""
    assert state.position is not None
    return [(state.position[0], state.position[1]), *corners(state, kind, 0.9)]


def is_visible(world: World, robot: RobotBody, state: ObjectState, distance: float = VIEW_RANGE) -> bool:
    """Whether the camera sees an object: in range, in the field of view, not occluded, in no closed container."""
    kind = world.objects.kinds[state.id]
    if state.floor != robot.floor or state.position is None:
        return False
    away = dist(robot.place, state.position[:2])
    if away > distance + kind.size[0] + kind.size[1] or _beside(robot, state, kind, away):
        return False
    points = [p for p in sight_points(state, kind) if _in_picture(robot, p, state, kind)]
    if not points or reach_to(robot, state, kind) > distance:
        return False
    if closed_carrier(world, state) is not None:
        return False
    return any(True for _ in in_sight(world, robot.floor, robot.place, state, points))


def _beside(robot: RobotBody, state: ObjectState, kind: SceneObject, away: float) -> bool:
    """Whether the circumcircle of an object is outside the field of view: a cheap test that excludes most objects."""
    radius = hypot(kind.size[0], kind.size[1]) / 2
    if away <= radius + robot.radius:
        return False
    assert state.position is not None
    middle = abs(robot.bearing((state.position[0], state.position[1])))
    return middle - degrees(asin(radius / away)) > VIEW_ANGLE / 2


def _in_picture(robot: RobotBody, point: Point, state: ObjectState, kind: SceneObject) -> bool:
    away = dist(robot.place, point)
    if away > robot.radius and abs(robot.bearing(point)) > VIEW_ANGLE / 2:
        return False
    assert state.position is not None
    z, half, flat = state.position[2] - CAMERA_HEIGHT, kind.size[2] / 2, max(away, robot.radius)
    low, high = robot.pitch - VIEW_ANGLE / 2, robot.pitch + VIEW_ANGLE / 2
    return degrees(atan2(z - half, flat)) <= high and degrees(atan2(z + half, flat)) >= low
