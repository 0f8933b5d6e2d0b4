"""Places of a floor that a robot can be sent to: cores and rooms."""

from collections.abc import Iterable
from dataclasses import dataclass
from math import dist

from shapely import Point, Polygon, box
from shapely.affinity import rotate
from shapely.geometry.base import BaseGeometry
from shapely.ops import polylabel, unary_union

from mansion_geometry.rings import largest_polygon
from mansion_msgs_py.scene import FloorScene, SceneObject, SceneRoom
from mansion_msgs_py.world import Pose2D

__all__ = ["Landmark", "floor_landmarks", "landmark_named", "room_at"]

ROBOT_RADIUS = 0.20
WALKABLE_HEIGHT = 0.03
GENERIC = {"elevator": "elevator", "lift": "elevator", "stairs": "stair", "stair": "stair"}


@dataclass(frozen=True)
class Landmark:
    """A named pose on a floor; `kind` is ``room``, ``stair`` or ``elevator``."""

    name: str
    kind: str
    floor: int
    pose: Pose2D


def floor_landmarks(scene: FloorScene) -> list[Landmark]:
    """Return the cores and rooms of a floor, each with a pose where a robot can stand."""
    found = [
        Landmark(core.id, core.type, scene.floor, Pose2D(x=x, y=y, yaw=yaw))
        for core in scene.cores
        for x, y, yaw in [core.entrance]
    ]
    by_room: dict[str, list[SceneObject]] = {}
    for thing in scene.objects:
        by_room.setdefault(thing.room, []).append(thing)
    rooms = [room for room in scene.rooms if room.kind not in ("stair", "elevator")]
    return found + [_room_landmark(scene.floor, room, by_room.get(room.id, [])) for room in rooms]


def _room_landmark(floor: int, room: SceneRoom, things: Iterable[SceneObject]) -> Landmark:
    inside = Polygon(room.net_polygon, room.net_holes)
    standing = [_footprint(t) for t in things if t.mount == "floor" and t.size[2] > WALKABLE_HEIGHT]
    free = inside.difference(unary_union(standing)).buffer(-ROBOT_RADIUS)
    place = free if not free.is_empty else inside
    spot = polylabel(largest_polygon(place), 0.1)
    return Landmark(room.id, "room", floor, Pose2D(x=round(spot.x, 3), y=round(spot.y, 3)))


def _footprint(thing: SceneObject) -> BaseGeometry:
    x, y, _ = thing.position
    w, d, _ = thing.size
    return rotate(box(x - w / 2, y - d / 2, x + w / 2, y + d / 2), thing.rotation)


def landmark_named(
    name: str, landmarks: Iterable[Landmark], floor: int, position: tuple[float, float]
) -> Landmark | None:
    """Return the landmark of that name: an id with or without its floor, or the nearest core of a kind."""
    wanted = name.strip().casefold()
    known = list(landmarks)
    for landmark in known:
        if landmark.name.casefold() in (wanted, f"f{floor}/{wanted}"):
            return landmark
    kind = GENERIC.get(wanted)
    cores = [entry for entry in known if entry.kind == kind]
    return min(cores, key=lambda c: dist(position, (c.pose.x, c.pose.y)), default=None)


def room_at(scene: FloorScene, x: float, y: float) -> str | None:
    """Return the id of the room that holds the point, or ``None``."""
    point = Point(x, y)
    for room in scene.rooms:
        if Polygon(room.polygon, room.holes).covers(point):
            return room.id
    return None
