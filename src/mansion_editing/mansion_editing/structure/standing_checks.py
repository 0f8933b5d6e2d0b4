"""Check where an object stands: inside its room, clear of doors, windows and other objects."""

import math
from collections.abc import Collection, Iterable, Sequence
from functools import cached_property

import msgspec
import shapely
from shapely import LineString, Polygon
from shapely.prepared import prep

from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprint
from mansion_geometry.wall_sizes import DOOR_HEAD, doorway_depth
from mansion_msgs_py.scene import Door, SceneObject, SceneRoom, Window
from mansion_msgs_py.shapes import Point
from mansion_scene.decor.frames import room_polygon, wall_edges

__all__ = ["RoomSpace", "collides", "shifted", "turned_about"]

NEW_DOOR_DEPTH = 0.75
"""Depth of the floor that is made clear before a new door, metres."""

_SLACK = 1e-3
_AT_WALL = 0.06
_AT_WINDOW = 0.3


def _depth(door: Door, new_doors: Collection[str]) -> float:
    """Return the depth of the floor that is left clear on either side of a door, metres."""
    if door.id in new_doors:
        return NEW_DOOR_DEPTH
    return doorway_depth(math.dist(*door.segment), is_open=door.kind == "open")


class RoomSpace:
    """A room with its doors and windows, in which objects stand, hang and lie.

    Parameters
    ----------
    room : SceneRoom
    doors : sequence of Door
        Doors of the floor.
    windows : sequence of Window
        Windows of the floor.
    new_doors : collection of str
        Ids of the doors that were not there before.
    """

    def __init__(
        self, room: SceneRoom, doors: Sequence[Door], windows: Sequence[Window], new_doors: Collection[str] = ()
    ) -> None:
        self.room = room
        self.net = room_polygon(room.net_polygon, room.net_holes)
        self._inner = prep(self.net.buffer(2e-3))
        self._ways = [
            LineString(door.segment).buffer(_depth(door, new_doors), cap_style="flat")
            for door in doors
            if room.id in door.rooms
        ]
        self._windows = [
            (LineString(window.segment).buffer(_AT_WINDOW, cap_style="flat"), window.sill, window.sill + window.height)
            for window in windows
            if window.room == room.id
        ]

    @cached_property
    def walls(self) -> list[tuple[Point, Point, float]]:
        """Start, end and rotation of what stands with its back to it, of each side of the room."""
        edges = wall_edges(self.room.net_polygon, self.room.net_holes)
        return [(edge.start, edge.point(edge.length, 0.0), edge.rotation) for edge in edges]

    def holds(self, item: SceneObject) -> bool:
        """Whether an object is inside, off doors, and where it hangs on a wall also at one and off windows."""
        shape = footprint(item)
        if not self._inner.covers(shape):
            return False
        low, high = item.bottom, item.top
        if high > self.room.ceiling_height + 0.03:
            return False
        blocks = item.mount in ("floor", "wall") and low < DOOR_HEAD and item.size[2] > WALKABLE_HEIGHT
        if blocks and any(way.intersection(shape).area > _SLACK for way in self._ways):
            return False
        if item.mount != "wall":
            return True
        if any(
            sill < high and low < top and area.intersection(shape).area > _SLACK for area, sill, top in self._windows
        ):
            return False
        return self.backs_on_wall(item)

    def backs_on_wall(self, item: SceneObject) -> bool:
        """Whether the middle of an object's back is at a wall."""
        turn = math.radians(item.rotation)
        x, y, _ = item.position
        back = shapely.Point(x + math.sin(turn) * item.size[1] / 2, y - math.cos(turn) * item.size[1] / 2)
        return bool(self.net.boundary.distance(back) <= _AT_WALL)


def collides(item: SceneObject, shape: Polygon, others: Iterable[tuple[SceneObject, Polygon]]) -> bool:
    """Whether an object meets one of others."""
    if item.size[2] <= WALKABLE_HEIGHT:
        return False
    low, high = item.bottom, item.top
    for other, area in others:
        if other.size[2] <= WALKABLE_HEIGHT or other.id == item.id:
            continue
        below, above = other.bottom, other.top
        if (
            min(high, above) - max(low, below) > 5e-3
            and shape.intersects(area)
            and shape.intersection(area).area > 5e-4
        ):
            return True
    return False


def shifted(item: SceneObject, shift: Point) -> SceneObject:
    """Return an object moved along the floor."""
    x, y, z = item.position
    return msgspec.structs.replace(item, position=(round(x + shift[0], 4), round(y + shift[1], 4), z))


def turned_about(item: SceneObject, before: SceneObject, after: SceneObject) -> SceneObject:
    """Return what an object carries where it is when the carrier went from one pose to another."""
    turn = after.rotation - before.rotation
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    dx, dy = item.position[0] - before.position[0], item.position[1] - before.position[1]
    position = (
        round(after.position[0] + c * dx - s * dy, 4),
        round(after.position[1] + s * dx + c * dy, 4),
        round(item.position[2] + after.position[2] - before.position[2], 4),
    )
    rotation = round((item.rotation + turn) % 360.0, 4) if turn else item.rotation
    return msgspec.structs.replace(item, position=position, rotation=rotation)
