"""Directions in which things move, as vectors in the plane of a storey: x to the east, y to the north."""

import math
from typing import Final

import msgspec
from shapely import LineString, Point
from shapely.ops import nearest_points

from mansion_editing.instructions.meaning.choices import things_meant
from mansion_editing.instructions.meaning.context import Context
from mansion_editing.instructions.statements import Place, Rooms, Shift, Spot
from mansion_editing.state import SceneState
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject
from mansion_scene.decor.frames import wall_edges

__all__ = ["direction_of", "faced_point", "rotation_towards"]

_COMPASS: Final = {"east": (1.0, 0.0), "north": (0.0, 1.0), "west": (-1.0, 0.0), "south": (0.0, -1.0)}
_OWN: Final = {"front": 90.0, "left": 180.0, "behind": 270.0, "right": 0.0}
"""Angles of an object's own sides from its x axis; its front looks along y."""


def direction_of(statement: Shift, item: SceneObject, state: SceneState, context: Context) -> tuple[float, float]:
    """Return the unit vector along which a thing moves.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where what it moves towards is not in its room.
    """
    if statement.way in _COMPASS:
        return _COMPASS[statement.way]
    if statement.way in _OWN:
        angle = math.radians(_OWN[statement.way] + item.rotation)
        return math.cos(angle), math.sin(angle)
    x, y = item.position[:2]
    to_x, to_y = _mark(statement, item, state, context)
    length = math.dist((x, y), (to_x, to_y)) or 1.0
    sign = 1.0 if statement.way == "towards" else -1.0
    return sign * (to_x - x) / length, sign * (to_y - y) / length


def _mark(statement: Shift, item: SceneObject, state: SceneState, context: Context) -> tuple[float, float]:
    """Return the point that a thing moves towards or away from."""
    if statement.mark is not None:
        here = Place(rooms=Rooms(words=item.room))
        mark = msgspec.structs.replace(statement.mark, place=statement.mark.place or here)
        found = min(
            things_meant(state, mark, context), key=lambda other: (math.dist(other.position, item.position), other.id)
        )
        return found.position[0], found.position[1]
    line = _nearest_of_spot(statement.spot, item, state)
    point = nearest_points(line, Point(item.position[0], item.position[1]))[0]
    return point.x, point.y


def faced_point(spot: Spot, item: SceneObject, state: SceneState) -> tuple[float, float]:
    """Return the middle of the window or door that a thing turns to, or the point of the wall before it.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` where its room has none.
    """
    line = _nearest_of_spot(spot, item, state)
    here = Point(item.position[0], item.position[1])
    point = nearest_points(line, here)[0] if spot == "wall" else line.centroid
    return point.x, point.y


def rotation_towards(item: SceneObject, point: tuple[float, float]) -> float:
    """Return the rotation at which the front of an object points to a point, degrees."""
    dx, dy = point[0] - item.position[0], point[1] - item.position[1]
    return round(math.degrees(math.atan2(-dx, dy)) % 360.0, 4)


def _nearest_of_spot(spot: Spot, item: SceneObject, state: SceneState) -> LineString:
    """Return the window, door or wall of its room that is nearest to a thing."""
    found_room = state.room(item.room)
    assert found_room is not None
    room, scene = found_room[1], state.scenes[found_room[0]]
    lines = {
        "window": [LineString(window.segment) for window in scene.windows if window.room == room.id],
        "door": [LineString(door.segment) for door in scene.doors if room.id in door.rooms],
    }.get(spot)
    if lines is None:
        lines = [LineString([edge.start, edge.end]) for edge in wall_edges(room.net_polygon, room.net_holes)]
    if not lines:
        raise MansionError(ErrorCode.NOT_FOUND, f"{room.id} has no {spot}")
    here_now = Point(item.position[0], item.position[1])
    return min(lines, key=lambda line: (round(line.distance(here_now), 4), line.wkt))
