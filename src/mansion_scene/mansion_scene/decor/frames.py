"""Frames of walls and objects, and catalogue assets as objects of the scene."""

import math
from collections.abc import Iterable, Sequence

from shapely import Polygon

from mansion_assets.catalogue import Asset
from mansion_geometry.plane import turned
from mansion_msgs_py.scene import Mount, SceneObject
from mansion_msgs_py.shapes import Point, Point3, Segment

__all__ = ["Ids", "WallEdge", "room_polygon", "scene_object", "to_floor", "to_local", "wall_edges"]


class Ids:
    """Numbers the objects of a room, ``ROOM/category_n``, skipping the ids that are taken."""

    def __init__(self, room_id: str, taken: Iterable[str]) -> None:
        self._room = room_id
        self._taken = set(taken)
        self._last: dict[str, int] = {}

    def new(self, category: str) -> str:
        """Return the next free id of a category."""
        number = self._last.get(category, 0) + 1
        while f"{self._room}/{category}_{number}" in self._taken:
            number += 1
        self._last[category] = number
        name = f"{self._room}/{category}_{number}"
        self._taken.add(name)
        return name


class WallEdge:
    """One straight side of a room: its start, its direction, its inward normal and its length."""

    def __init__(self, start: Point, end: Point) -> None:
        self.start, self.end = start, end
        dx, dy = end[0] - start[0], end[1] - start[1]
        self.length = math.hypot(dx, dy)
        self.along = (dx / self.length, dy / self.length)
        self.inward = (-self.along[1], self.along[0])

    @property
    def rotation(self) -> float:
        """Rotation of an object whose back is at this wall, degrees."""
        return round(math.degrees(math.atan2(-self.inward[0], self.inward[1])) % 360.0, 6)

    def coordinates(self, point: Point) -> tuple[float, float]:
        """Return a point's distance along the wall and into the room."""
        dx, dy = point[0] - self.start[0], point[1] - self.start[1]
        return (dx * self.along[0] + dy * self.along[1], dx * self.inward[0] + dy * self.inward[1])

    def point(self, along: float, inward: float) -> Point:
        """Return the floor point at these wall coordinates."""
        return (
            self.start[0] + along * self.along[0] + inward * self.inward[0],
            self.start[1] + along * self.along[1] + inward * self.inward[1],
        )

    def interval(self, points: Iterable[Point]) -> tuple[float, float, float]:
        """Return the interval that `points` cover along the wall (from, to) and their least distance from it."""
        pairs = [self.coordinates(p) for p in points]
        return min(s for s, _ in pairs), max(s for s, _ in pairs), min(t for _, t in pairs)

    def carries(self, segment: Segment, reach: float = 0.35) -> bool:
        """Tell whether an opening lies in this wall: parallel to it and at most `reach` away."""
        (s0, t0), (s1, t1) = (self.coordinates(p) for p in segment)
        parallel = abs(t0 - t1) < 0.02
        return parallel and abs(t0) <= reach and max(s0, s1) > 0.0 and min(s0, s1) < self.length


def wall_edges(polygon: Sequence[Point], holes: Sequence[Sequence[Point]] = ()) -> list[WallEdge]:
    """Return the sides of a room of at least 1 cm; the room lies to the left of each."""
    rings = [list(polygon), *[list(reversed(_counter_clockwise(hole))) for hole in holes]]
    rings[0] = _counter_clockwise(rings[0])
    out = []
    for ring in rings:
        for start, end in zip(ring, [*ring[1:], ring[0]], strict=True):
            if math.dist(start, end) > 0.01:
                out.append(WallEdge(start, end))
    return out


def _counter_clockwise(ring: Sequence[Point]) -> list[Point]:
    area = sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, [*ring[1:], ring[0]], strict=True))
    return list(ring) if area >= 0 else list(reversed(ring))


def room_polygon(polygon: Sequence[Point], holes: Sequence[Sequence[Point]] = ()) -> Polygon:
    """Return the net interior of a room as a valid polygon."""
    shape = Polygon(polygon, [hole for hole in holes if len(hole) >= 3])
    return shape if shape.is_valid else shape.buffer(0)


def to_floor(obj: SceneObject, point: Point) -> Point:
    """Return a point of an object's own frame in the floor's frame."""
    angle = math.radians(obj.rotation)
    c, s = math.cos(angle), math.sin(angle)
    return (obj.position[0] + c * point[0] - s * point[1], obj.position[1] + s * point[0] + c * point[1])


def to_local(obj: SceneObject, point: Sequence[float]) -> Point:
    """Return a floor point in an object's own frame."""
    return turned(point[0] - obj.position[0], point[1] - obj.position[1], -obj.rotation)


def scene_object(
    asset: Asset,
    identifier: str,
    room: str,
    position: Point3,
    rotation: float,
    *,
    mount: Mount | None = None,
    parent: str | None = None,
    name: str = "",
) -> SceneObject:
    """Return an asset as an object of the scene, in its initial state (closed; ceiling lamps on)."""
    states: dict[str, bool | float | str] = {}
    if asset.openable:
        states["open"] = False
    if asset.toggleable:
        states["on"] = asset.mount == "ceiling"
    return SceneObject(
        id=identifier,
        room=room,
        category=asset.category,
        asset=asset.key,
        position=_rounded(position),
        rotation=round(float(rotation) % 360.0, 4),
        size=asset.size,
        name=name or asset.name,
        asset_id=asset.asset_id,
        mount=mount or asset.mount,
        parent=parent,
        pickupable=asset.pickupable,
        receptacle=asset.receptacle,
        openable=asset.openable,
        toggleable=asset.toggleable,
        material=asset.material,
        color=asset.color,
        states=states,
    )


def _rounded(position: Sequence[float]) -> Point3:
    """Return plain floats, rounded to 0.1 mm, from any number type."""
    x, y, z = (round(float(value), 4) for value in position)
    return x, y, z
