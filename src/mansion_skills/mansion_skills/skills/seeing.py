"""What a robot sees and what it can reach from where it stands."""

from math import atan2, degrees, dist

import numpy as np

from mansion_msgs_py.scene import SceneObject
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.world import ObjectState
from mansion_skills.navigation.floor_map import RESOLUTION
from mansion_skills.navigation.search import sees
from mansion_skills.world.footprint import box_distance, corners
from mansion_skills.world.robot_body import RobotBody
from mansion_skills.world.world import World

__all__ = [
    "CAMERA_HEIGHT",
    "REACH",
    "TOP_REACH",
    "VIEW_ANGLE",
    "VIEW_RANGE",
    "closed_carrier",
    "in_sight",
    "is_visible",
    "reach_to",
]

REACH = 1.5
"""How far the hand reaches from the robot's centre, metres in plan."""

TOP_REACH = 2.0
"""How high the hand reaches, metres."""

VIEW_RANGE = 8.0
"""How far the robot sees objects, metres."""

VIEW_ANGLE = 90.0
"""Of the camera, across and up and down, degrees."""

CAMERA_HEIGHT = 1.2

_THIN = 3.0
"""Cells before its centre where a line of sight ends, for things that hang on walls."""


def reach_to(robot: RobotBody, state: ObjectState, kind: SceneObject) -> float:
    """Return the plan distance from the robot's centre to an object, metres."""
    return box_distance(robot.place, state, kind)


def closed_carrier(world: World, state: ObjectState) -> str | None:
    """Return the closed thing that an object lies in, or ``None``."""
    while state.parent is not None:
        inside = state.mount == "inside"
        state = world.objects.state(state.parent)
        if inside and state.states.get("open") is False:
            return state.id
    return None


def in_sight(world: World, floor: int, place: Point, state: ObjectState) -> list[Point]:
    """Return those of an object's centre and corners that a straight line from `place` meets unhindered."""
    view = world.view(floor)
    frame = view.map.frame
    labels = []
    entry: ObjectState | None = state
    while entry is not None:
        labels.append(view.numbers.get(entry.id, 0))
        entry = world.objects.state(entry.parent) if entry.parent is not None else None
    ours = np.array(labels, dtype=np.int16)
    assert state.position is not None
    points = [(state.position[0], state.position[1])]
    points += corners(state, world.objects.kinds[state.id], 0.9)
    r0, c0 = (place[1] - frame.y0) / RESOLUTION, (place[0] - frame.x0) / RESOLUTION
    return [
        (x, y)
        for x, y in points
        if sees(
            view.map.view,
            r0,
            c0,
            (y - frame.y0) / RESOLUTION,
            (x - frame.x0) / RESOLUTION,
            _THIN,
            ours,
        )
    ]


def is_visible(
    world: World, robot: RobotBody, state: ObjectState, distance: float = VIEW_RANGE
) -> bool:
    """Whether the camera has an object in its picture: near enough, in front, in sight, and not shut away."""
    kind = world.objects.kinds[state.id]
    if state.floor != robot.floor or state.position is None:
        return False
    if reach_to(robot, state, kind) > distance or closed_carrier(world, state) is not None:
        return False
    points = [(state.position[0], state.position[1]), *corners(state, kind, 0.9)]
    if not any(_in_picture(robot, point, state, kind) for point in points):
        return False
    seen = in_sight(world, robot.floor, robot.place, state)
    return any(_in_picture(robot, point, state, kind) for point in seen)


def _in_picture(robot: RobotBody, point: Point, state: ObjectState, kind: SceneObject) -> bool:
    away = dist(robot.place, point)
    if away > robot.radius and abs(robot.bearing(point)) > VIEW_ANGLE / 2:
        return False
    assert state.position is not None
    half = kind.size[2] / 2
    heights = (state.position[2] - half, state.position[2], state.position[2] + half)
    angles = [degrees(atan2(z - CAMERA_HEIGHT, max(away, robot.radius))) for z in heights]
    low, high = robot.pitch - VIEW_ANGLE / 2, robot.pitch + VIEW_ANGLE / 2
    return min(angles) <= high and max(angles) >= low
