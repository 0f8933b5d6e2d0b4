"""Free places on the floor of a room: along a wall or away from the walls, clear of doors and furniture."""

import math
from collections.abc import Collection, Iterator
from itertools import chain
from typing import TypeAlias

import msgspec
from shapely import LineString, Polygon, STRtree
from shapely.prepared import prep

from mansion_editing.state import SceneState
from mansion_editing.tools.destinations import InRoom
from mansion_editing.tools.placing_wishes import hangs, refusal
from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprint, footprint_at
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.wording import with_article
from mansion_scene.decor.frames import room_polygon, wall_edges

__all__ = ["FloorSpace", "Pose", "floor_poses", "free_floor_places", "stand_on_floor"]

DOOR_DEPTH = 0.75
"""Depth of the area before a door that stays clear, metres."""

FRONT = 0.65
"""Free depth before the front of furniture, for a robot to stand in, metres."""

STEP = 0.25
APART = 0.6
"""Distance between places that are judged, metres."""

MOST_REFUSED = 16
BACK_GAP = 0.01

Pose: TypeAlias = tuple[float, float, float]
"""x, y (metres) and rotation (degrees) on a floor."""


def stand_on_floor(state: SceneState, thing: SceneObject, where: InRoom) -> SceneObject:
    """Return an object standing on the floor of a room, near to what its wish names; the state is not changed.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` for what does not stand on floors, and where the room has no free place.
    """
    if thing.mount in ("wall", "ceiling"):
        raise hangs(thing, "not on the floor")
    room = where.room
    w, d, h = thing.size
    refused: list[Point] = []
    tried = [free_floor_places(state, thing, where)]
    if not thing.openable:
        tried.append(free_floor_places(state, thing, where, to_be_reached=False))
    for x, y, rotation in chain.from_iterable(tried):
        if any(math.dist((x, y), other) < APART for other in refused):
            continue
        position = (round(x, 4), round(y, 4), round(h / 2, 4))
        turn = round(rotation % 360.0, 4)
        placed = msgspec.structs.replace(thing, room=room.id, position=position, rotation=turn, mount="floor")
        if where.accept is None or where.accept(where.floor, placed):
            return placed
        refused.append((x, y))
        if len(refused) == MOST_REFUSED:
            break
    why = "keeps all rooms and objects within a robot's reach" if refused else "is free"
    raise refusal(
        f"no place for {with_article(thing.name)} of {w:.2f} x {d:.2f} m in {room.id} {why}; remove something first"
    )


def free_floor_places(
    state: SceneState, thing: SceneObject, where: InRoom, *, to_be_reached: bool = True
) -> Iterator[Pose]:
    """Yield places (x, y, rotation) on the floor of a room: with the back to a wall first, then away from the walls.

    Those next to what the wish names come first.

    Parameters
    ----------
    to_be_reached : bool
        A robot is to stand before its front, which is free then; else it may stand close to something.
    """
    near = where.wish.near
    space = FloorSpace(state.scenes[where.floor], where.room, thing, flat=thing.size[2] <= WALKABLE_HEIGHT)
    poses = list(floor_poses(where.room, thing))
    if near is not None:
        poses.sort(key=lambda pose: round(math.dist(pose[:2], near.position[:2]), 6))
    for pose in poses:
        if space.is_free(pose) if to_be_reached else not space.hindrances(pose):
            yield pose


class FloorSpace:
    """What stands or opens on the floor of a room, as far as it is in the way of one thing.

    Parameters
    ----------
    skip : collection of str
        Objects that are not obstacles, because they are being moved.

    Notes
    -----
    What is flat lies below furniture: only what is as flat is in its way when `flat` is set.
    """

    def __init__(
        self, scene: FloorScene, room: SceneRoom, thing: SceneObject, skip: Collection[str] = (), *, flat: bool = False
    ) -> None:
        area = room_polygon(room.net_polygon, room.net_holes)
        self._inner = prep(area.buffer(1e-4))
        self._size, self._flat = thing.size, flat
        self._wall = f"the wall of {room.id}"
        others = [
            item
            for item in scene.objects
            if item.id != thing.id
            and item.id not in skip
            and item.room == room.id
            and (item.parent is None or item.mount == "floor")
            and (item.size[2] > WALKABLE_HEIGHT) is not flat
            and item.bottom < thing.size[2] + 0.02
        ]
        own = [] if flat else [door for door in scene.doors if room.id in door.rooms]
        self._names = [item.id for item in others]
        self._doors = [door.id for door in own]
        self._furniture = STRtree([footprint(item) for item in others])
        self._kept_clear = STRtree([LineString(door.segment).buffer(DOOR_DEPTH, cap_style="flat") for door in own])

    def is_free(self, pose: Pose) -> bool:
        """Whether nothing is in the way of a pose, nor before its front."""
        return not self.hindrances(pose) and (self._flat or not self.before(pose))

    def hindrances(self, pose: Pose, ignored: Collection[str] = ()) -> list[str]:
        """Return what is in the way of a pose: objects, doors and walls, in words."""
        x, y, rotation = pose
        w, d, _ = self._size
        if not self._inner.covers(footprint_at((x, y), (w, d), rotation)):
            return [self._wall]
        body = footprint_at((x, y), (w + 0.02, d), rotation)
        found = self._named(body, ignored)
        if found:
            return found
        return [f"the door {self._doors[n]}" for n in sorted(self._kept_clear.query(body, predicate="intersects"))]

    def before(self, pose: Pose, ignored: Collection[str] = ()) -> list[str]:
        """Return what is in the way of a robot before the front of a pose."""
        x, y, rotation = pose
        w, d, _ = self._size
        turn = math.radians(rotation)
        ahead = (d + FRONT) / 2
        area = footprint_at((x - math.sin(turn) * ahead, y + math.cos(turn) * ahead), (w, FRONT), rotation)
        found = self._named(area, ignored)
        return found if found or self._inner.covers(area) else [self._wall]

    def _named(self, shape: Polygon, ignored: Collection[str]) -> list[str]:
        numbers = sorted(self._furniture.query(shape, predicate="intersects").tolist())
        return [self._names[n] for n in numbers if self._names[n] not in ignored]


def floor_poses(room: SceneRoom, thing: SceneObject) -> Iterator[Pose]:
    """Yield poses for an object in an empty room: with the back to a wall first, then from the middle of the room."""
    area = room_polygon(room.net_polygon, room.net_holes)
    w, d, _ = thing.size
    for wall in wall_edges(room.net_polygon, room.net_holes):
        if wall.length < w:
            continue
        count = int((wall.length - w) / STEP)
        slack = wall.length - w
        offsets = [slack * k / max(1, count) for k in range(count + 1)]
        for offset in offsets:
            x, y = wall.point(offset + w / 2, d / 2 + BACK_GAP)
            yield x, y, wall.rotation
    x0, y0, x1, y1 = area.bounds
    turn = wall_edges(room.net_polygon)[0].rotation if len(room.net_polygon) > 2 else 0.0
    center: Point = (area.centroid.x, area.centroid.y)
    points = [
        (x0 + STEP * i, y0 + STEP * j)
        for i in range(int((x1 - x0) / STEP) + 1)
        for j in range(int((y1 - y0) / STEP) + 1)
    ]
    for x, y in sorted(points, key=lambda p: (round(math.dist(p, center), 6), p)):
        yield x, y, turn
