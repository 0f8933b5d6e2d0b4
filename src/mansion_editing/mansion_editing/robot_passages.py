"""Where a robot's body fits between the furniture of a floor: the parts of each room's floor, and the doors of each."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from functools import lru_cache

import msgspec
import shapely
from shapely.geometry import LineString, Point, Polygon

from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprint
from mansion_geometry.robot_body import BODY_RADIUS, CLEARANCE, THIN
from mansion_msgs_py.scene import Door, FloorScene, SceneObject, SceneRoom
from mansion_scene.spawn import free_region

__all__ = ["Passages", "passages_of"]

_DOORWAY = 0.40
"""How far before a door's middle line the robot's centre must have come, metres."""

_LARGE_AREA, _LARGE_SHARE = 1.0, 0.2
"""Area for the robot's centre, square metres and share of the room's, from which a part is more than a nook."""


@dataclass(frozen=True)
class Passages:
    """How one floor hangs together for a robot.

    Attributes
    ----------
    parts : mapping from room id to list of Polygon
        Where the robot's centre may be, connected parts, the largest first. A room too narrow for a robot when empty
        is left out: furniture does not close it.
    doors : mapping from (room id, door id) to list of int
        Numbers of the room's parts that the door leads to.
    cuts : mapping from room id to list of str
        Objects that stand before a door without leaving it a part, or between two parts of a room that each matter: a
        door leads to it, or it is large.
    """

    parts: Mapping[str, Sequence[Polygon]]
    doors: Mapping[tuple[str, str], Sequence[int]]
    cuts: Mapping[str, Sequence[str]]

    def at_door(self, room: str, door: str) -> Sequence[int]:
        """Return the parts of a room that a door leads to; its only one for a place that is not looked into."""
        return self.doors.get((room, door), (0,))

    def at_point(self, room: str, x: float, y: float) -> int:
        """Return the part nearest to a point."""
        parts = self.parts.get(room, ())
        here = Point(x, y)
        return min(range(len(parts)), key=lambda n: float(parts[n].distance(here)), default=0)


def passages_of(scene: FloorScene) -> Passages:
    """Return the passages of a floor as it is furnished."""
    standing: dict[str, list[SceneObject]] = {}
    for item in scene.objects:
        if _is_obstacle(item):
            standing.setdefault(item.room, []).append(item)
    parts: dict[str, Sequence[Polygon]] = {}
    doors: dict[tuple[str, str], Sequence[int]] = {}
    cuts: dict[str, Sequence[str]] = {}
    for room in scene.rooms:
        own = [door for door in scene.doors if room.id in door.rooms]
        found = _passages_in(_furnished(room, standing.get(room.id, []), own))
        if found is None:
            continue
        parts[room.id] = found.parts
        doors |= {(room.id, door.id): numbers for door, numbers in zip(own, found.doors, strict=True)}
        if found.cuts is not None:
            cuts[room.id] = found.cuts
    return Passages(parts, doors, cuts)


@dataclass(frozen=True)
class _Furnished:
    """A room with what stands in it; equal to another where all that passages depend on is."""

    mark: bytes
    room: SceneRoom = field(compare=False)
    things: Sequence[SceneObject] = field(compare=False)
    doors: Sequence[Door] = field(compare=False)


def _furnished(room: SceneRoom, things: Sequence[SceneObject], doors: Sequence[Door]) -> _Furnished:
    poses = [(item.id, item.position, item.size, item.rotation, item.mount) for item in things]
    shape = (room.id, room.kind, room.net_polygon, room.net_holes, [(door.id, door.segment) for door in doors])
    return _Furnished(msgspec.json.encode((shape, poses)), room, things, doors)


@dataclass(frozen=True)
class _InRoom:
    """The passages of one room; `cuts` is None where nothing cuts it."""

    parts: Sequence[Polygon]
    doors: Sequence[Sequence[int]]
    cuts: Sequence[str] | None


@lru_cache(maxsize=2048)
def _passages_in(furnished: _Furnished) -> _InRoom | None:
    """Return the passages of a room, None for stairs, lifts and rooms that no robot enters when they are empty."""
    room, things, own = furnished.room, furnished.things, furnished.doors
    empty = free_region(room, [], BODY_RADIUS)
    if room.kind in ("stair", "elevator") or not empty:
        return None
    found = free_region(room, things, BODY_RADIUS) if things else empty
    doors = [_parts_at_door(door, found, empty) for door in own]
    shut = [door for door, numbers in zip(own, doors, strict=True) if not numbers]
    if shut:
        return _InRoom(found, doors, _objects_at_doors(shut, things))
    return _InRoom(found, doors, _objects_between_parts(found, {n for numbers in doors for n in numbers}, things))


def _is_obstacle(item: SceneObject) -> bool:
    low, high = item.bottom, item.top
    thin = item.mount == "wall" and item.size[1] <= THIN
    return item.mount in ("floor", "wall") and low < CLEARANCE and high > WALKABLE_HEIGHT and not thin


def _parts_at_door(door: Door, found: Sequence[Polygon], empty: Sequence[Polygon]) -> list[int]:
    """Return the parts before a door; all of them where even the empty room has none there (a door in a deep wall)."""
    line = LineString(door.segment)
    if not (shapely.distance(list(empty), line) <= _DOORWAY).any():
        return list(range(len(found)))
    return [n for n, part in enumerate(found) if part.distance(line) <= _DOORWAY]


def _objects_at_doors(shut: Sequence[Door], things: Sequence[SceneObject]) -> list[str]:
    """Return the objects in front of doors."""
    lines = [LineString(door.segment) for door in shut]
    return sorted(
        item.id for item in things if (shapely.distance(lines, footprint(item)) <= _DOORWAY + BODY_RADIUS).any()
    )


def _objects_between_parts(
    found: Sequence[Polygon], entered: set[int], things: Sequence[SceneObject]
) -> list[str] | None:
    """Return the objects between the parts of a room that matter, None where only one part matters."""
    whole = sum(part.area for part in found)
    large = {n for n, part in enumerate(found) if part.area >= max(_LARGE_AREA, _LARGE_SHARE * whole)}
    matter = sorted(entered | large)
    if len(matter) < 2:
        return None
    shapes = [footprint(item) for item in things]
    near = sum((shapely.distance(shapes, found[n]) <= BODY_RADIUS + 0.02).astype(int) for n in matter)
    return sorted(item.id for item, sides in zip(things, near, strict=True) if sides > 1)
