"""Free places on the floor of a room: with the back to a wall or amid the room, clear of doors and furniture."""

import math
from collections.abc import Callable, Iterator

import msgspec
from shapely import LineString, Polygon, STRtree
from shapely.prepared import prep

from mansion_editing.state import SceneState
from mansion_geometry.object_footprints import footprint, footprint_at
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_msgs_py.shapes import Point
from mansion_msgs_py.wording import with_article
from mansion_scene.decor.frames import room_polygon, wall_edges

__all__ = ["Accept", "free_floor_places", "stand_on_floor"]

DOOR_DEPTH = 0.75
"""Depth of the area before a door that stays clear, metres."""

FRONT = 0.65
"""Free depth before the front of furniture, for a robot to stand in, metres."""

LOW = 0.03
STEP = 0.25
APART = 0.6
"""Distance between places that are judged, metres."""

MOST_REFUSED = 8
BACK_GAP = 0.01


Accept = Callable[[int, SceneObject], bool]
"""Whether the building stays free of new faults with an object on a floor."""


def stand_on_floor(
    state: SceneState,
    thing: SceneObject,
    floor: int,
    room: SceneRoom,
    *,
    near: SceneObject | None = None,
    accept: Accept | None = None,
) -> SceneObject:
    """Return an object standing on the floor of a room; the state is not changed.

    Parameters
    ----------
    near : SceneObject, optional
        What it shall stand beside.
    accept : callable, optional
        Judges a place; others are tried while it refuses.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` for what does not stand on floors, and where the room has no free place.
    """
    if thing.mount in ("wall", "ceiling"):
        raise MansionError(
            ErrorCode.INFEASIBLE, f"{with_article(thing.name)} hangs on {with_article(thing.mount)}, not on the floor"
        )
    w, d, h = thing.size
    refused: list[Point] = []
    for x, y, rotation in free_floor_places(state, floor, room, thing, near):
        if any(math.dist((x, y), other) < APART for other in refused):
            continue
        position = (round(x, 4), round(y, 4), round(h / 2, 4))
        turn = round(rotation % 360.0, 4)
        placed = msgspec.structs.replace(thing, room=room.id, position=position, rotation=turn, mount="floor")
        if accept is None or accept(floor, placed):
            return placed
        refused.append((x, y))
        if len(refused) == MOST_REFUSED:
            break
    why = "keeps all rooms and objects within a robot's reach" if refused else "is free"
    raise MansionError(
        ErrorCode.INFEASIBLE,
        f"no place for {with_article(thing.name)} of {w:.2f} x {d:.2f} m in {room.id} {why}; remove something first",
    )


def free_floor_places(
    state: SceneState, floor: int, room: SceneRoom, thing: SceneObject, near: SceneObject | None = None
) -> Iterator[tuple[float, float, float]]:
    """Yield places (x, y, rotation) on the floor of a room: with the back to a wall first, then amid the room.

    Those next to `near` come first where it is given.
    """
    area = room_polygon(room.net_polygon, room.net_holes)
    inner = prep(area.buffer(1e-4))
    scene = state.scenes[floor]
    others = [
        footprint(item)
        for item in scene.objects
        if item.id != thing.id
        and item.room == room.id
        and item.parent is None
        and item.size[2] > LOW
        and item.position[2] - item.size[2] / 2 < thing.size[2] + 0.02
    ]
    doors = [
        LineString(door.segment).buffer(DOOR_DEPTH, cap_style="flat") for door in scene.doors if room.id in door.rooms
    ]
    furniture = STRtree(others)
    kept_clear = STRtree(doors)
    w, d, _ = thing.size
    poses = list(_poses(room, area, w, d))
    if near is not None:
        poses.sort(key=lambda pose: round(math.dist(pose[:2], near.position[:2]), 6))
    for x, y, rotation in poses:
        body = footprint_at((x, y), (w + 0.02, d), rotation)
        if not inner.covers(footprint_at((x, y), (w, d), rotation)):
            continue
        turn = math.radians(rotation)
        ahead = (d + FRONT) / 2
        before = footprint_at((x - math.sin(turn) * ahead, y + math.cos(turn) * ahead), (w, FRONT), rotation)
        if furniture.query(body, predicate="intersects").size:
            continue
        if kept_clear.query(body, predicate="intersects").size:
            continue
        if furniture.query(before, predicate="intersects").size or not inner.covers(before):
            continue
        yield x, y, rotation


def _poses(room: SceneRoom, area: Polygon, w: float, d: float) -> Iterator[tuple[float, float, float]]:
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
