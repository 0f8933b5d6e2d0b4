"""Where a robot goes through a door: a waypoint on either side and a straight way between them."""

import math
from collections.abc import Sequence
from dataclasses import dataclass

from shapely.geometry import Polygon

from mansion_export.rmf.free_floor import cabin_frame
from mansion_export.rmf.ways import FloorPiece
from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.shapes import Point, Segment

__all__ = ["OPERATED", "Crossing", "crossings"]

OPERATED = ("single", "double", "glazed", "entrance", "balcony", "garage")
"""Kinds of doors that have leaves; the landing doors of lifts belong to the lift."""

BESIDE = (0.5, 0.4, 0.3, 0.25, 0.2, 0.7, 0.9, 0.15)
"""Distances from a wall's centre line that are tried for a waypoint beside a door, metres."""

ALONG = 0.2
"""Distance between the places along an opening that are tried, metres."""


@dataclass(frozen=True, slots=True)
class Crossing:
    """A way through a door.

    Attributes
    ----------
    door : Door
    ends : ((x, y), (x, y))
        Waypoints, the first in the first of `rooms`.
    rooms : (str, str)
        Ids of what they lie in; the second may be a lift.
    """

    door: Door
    ends: tuple[Point, Point]
    rooms: tuple[str, str]


def crossings(scene: FloorScene, pieces: Sequence[FloorPiece]) -> list[Crossing]:
    """Return a way through every door between rooms, or into a lift, that the robot fits through."""
    shapes = {room.id: Polygon(room.polygon, room.holes) for room in scene.rooms if room.kind != "stair"}
    lifts = {core.door: core for core in scene.cores if core.type == "elevator"}
    found = []
    for door in scene.doors:
        if door.id in lifts:
            lift = lifts[door.id]
            room = next((key for key in door.rooms if key in shapes), None)
            crossing = None
            if room is not None:
                frame = cabin_frame(lift, scene)
                cabin = _on_axis(door.segment, frame.facing, (frame.x, frame.y))
                crossing = _into_lift(door, (room, lift.id), frame.facing, cabin, pieces)
        else:
            crossing = _between(door, shapes, pieces)
        if crossing is not None:
            found.append(crossing)
    return found


def _on_axis(segment: Segment, facing: Point, center: Point) -> Point:
    """Return the place before a door's middle that is as deep in the shaft as its centre."""
    (ax, ay), (bx, by) = segment
    x, y = (ax + bx) / 2, (ay + by) / 2
    deep = (x - center[0]) * facing[0] + (y - center[1]) * facing[1]
    return _rounded(x - facing[0] * deep, y - facing[1] * deep)


def _into_lift(
    door: Door, rooms: tuple[str, str], facing: Point, cabin: Point, pieces: Sequence[FloorPiece]
) -> Crossing | None:
    (ax, ay), (bx, by) = door.segment
    x, y = (ax + bx) / 2, (ay + by) / 2
    for beside in BESIDE:
        front = _rounded(x + facing[0] * beside, y + facing[1] * beside)
        if any(piece.clear(front, cabin) for piece in pieces):
            return Crossing(door, (front, cabin), rooms)
    return None


def _between(door: Door, shapes: dict[str, Polygon], pieces: Sequence[FloorPiece]) -> Crossing | None:
    a, b = door.rooms
    if b is None or a not in shapes or b not in shapes:
        return None
    (x0, y0), (x1, y1) = door.segment
    length = math.hypot(x1 - x0, y1 - y0)
    normal = (-(y1 - y0) / length, (x1 - x0) / length)
    places = [(x0 + (x1 - x0) * t, y0 + (y1 - y0) * t) for t in _fractions(length)]
    rooms = {key: shapes[key] for key in (a, b)}
    for x, y in places:
        ends = [_end(x, y, normal, sign, rooms, pieces) for sign in (1.0, -1.0)]
        if ends[0] is None or ends[1] is None:
            continue
        (left, in_left), (right, in_right) = ends[0], ends[1]
        if {in_left, in_right} == {a, b} and any(piece.clear(left, right) for piece in pieces):
            return Crossing(door, (left, right), (in_left, in_right))
    return None


def _fractions(length: float) -> list[float]:
    """Return places along an opening, the middle first, the others by distance from it."""
    count = int(length / 2 / ALONG)
    steps = [0.0] + [sign * k * ALONG / length for k in range(1, count + 1) for sign in (1, -1)]
    return [0.5 + step for step in steps]


def _end(
    x: float, y: float, normal: Point, sign: float, rooms: dict[str, Polygon], pieces: Sequence[FloorPiece]
) -> tuple[Point, str] | None:
    """Return the first good place on one side of a door and the room that it lies in."""
    middle = (x, y)
    for beside in BESIDE:
        point = _rounded(x + normal[0] * sign * beside, y + normal[1] * sign * beside)
        room = next((key for key, shape in rooms.items() if _within(shape, point)), None)
        if room is not None and any(piece.clear(middle, point) for piece in pieces):
            return point, room
    return None


def _within(shape: Polygon, point: Point) -> bool:
    return FloorPiece(shape).holds(point)


def _rounded(x: float, y: float) -> Point:
    return (round(x, 3) + 0.0, round(y, 3) + 0.0)
