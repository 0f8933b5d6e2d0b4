"""Wall objects, on lengths of wall free of doors, windows, tall furniture and each other."""

from collections.abc import Iterator, Sequence

import msgspec
import numpy as np

from mansion_assets.catalogue import Asset, HangRequest
from mansion_geometry.boxes import TOUCH
from mansion_geometry.object_footprints import footprint_corners
from mansion_msgs_py.scene import Door, SceneObject, Wall, Window
from mansion_msgs_py.shapes import Point, Point3, Size3
from mansion_scene.decor.frames import Ids, WallEdge, scene_object
from mansion_scene.decor.rugs import matches

__all__ = ["BACK_GAP", "WallSpace", "hanging_height", "height_above", "wall_objects"]

_SIDE = 0.06
"""Least distance to neighbours on the wall and to door and window frames, metres."""

_ABOVE = 0.04
"""Least distance to the furniture below, metres."""

BACK_GAP = 0.002
"""Distance from a wall to the back of what hangs on it, metres."""

_SIDES = "another wall of the room"
"""What is named where the room is too shallow before a wall."""


class _Block(msgspec.Struct, frozen=True):
    """A length of wall that is taken between two heights; `distance` is the gap between the wall and what takes it."""

    start: float
    end: float
    low: float
    high: float
    distance: float = 0.0
    name: str = ""


def _without(free: list[tuple[float, float]], start: float, end: float) -> list[tuple[float, float]]:
    """Return intervals less what lies between `start` and `end`."""
    return [p for a, b in free for p in ((a, min(b, start)), (max(a, end), b)) if p[1] >= p[0]]


def _within(start: Point, end: Point, depth: float) -> tuple[float, float] | None:
    """Return the stretch of a wall before which a side, in that wall's coordinates, is nearer than `depth`."""
    (s0, t0), (s1, t1) = (start, end) if start[1] <= end[1] else (end, start)
    if t1 <= TOUCH or t0 >= depth - TOUCH:
        return None
    cuts = [s0 + (s1 - s0) * min(1.0, max(0.0, (t - t0) / max(t1 - t0, TOUCH))) for t in (0.0, depth)]
    return min(cuts), max(cuts)


class WallSpace:
    """A side of the room and what hangs on it or stands before it.

    Parameters
    ----------
    edge : WallEdge
        The side.
    room : sequence of WallEdge, optional
        All sides of the room, this one among them: nothing hangs where another is too near.
    """

    def __init__(self, edge: WallEdge, room: Sequence[WallEdge] = ()) -> None:
        self.edge = edge
        self.blocks: list[_Block] = []
        self.hung: list[tuple[float, str]] = []
        self._sides = [(edge.coordinates(side.start), edge.coordinates(side.end)) for side in room if side is not edge]

    def gaps(self, width: float, low: float, high: float, depth: float) -> list[tuple[float, float]]:
        """Return the intervals in which the centre of an object of this width may lie."""
        margin = width / 2 + _SIDE
        free = [(margin - _SIDE + 0.02, self.edge.length - margin + _SIDE - 0.02)]
        for block in self.blocks:
            if block.low >= high or block.high <= low or block.distance >= depth + 0.02:
                continue
            free = _without(free, block.start - margin, block.end + margin)
        for start, end in self._shallow(depth):
            free = _without(free, start - width / 2, end + width / 2)
        return free

    def _shallow(self, depth: float) -> list[tuple[float, float]]:
        """Return the stretches before which another side of the room is nearer than what is so deep."""
        crossings = [_within(*side, depth + BACK_GAP) for side in self._sides]
        return [crossing for crossing in crossings if crossing is not None]

    def hindrances(self, along: float, center: float, size: Size3) -> list[str]:
        """Return the openings and objects, by id, that leave no room for an object whose centre is there."""
        w, d, h = size
        low, high = center - h / 2, center + h / 2
        near = w / 2 + _SIDE
        sides = [_SIDES for start, end in self._shallow(d) if start - w / 2 < along < end + w / 2]
        return sides[:1] + [
            block.name
            for block in self.blocks
            if block.low < high
            and block.high > low
            and block.distance < d + 0.02
            and block.start - near < along < block.end + near
        ]

    def block_openings(self, doors: Sequence[Door], windows: Sequence[Window]) -> None:
        """Note the doors and windows in this wall."""
        for door in doors:
            if self.edge.carries(door.segment):
                a, b, _ = self.edge.interval(door.segment)
                self.blocks.append(_Block(a - 0.06, b + 0.06, -1.0, 99.0, name=door.id))
        for window in windows:
            if self.edge.carries(window.segment):
                a, b, _ = self.edge.interval(window.segment)
                low, high = window.sill - 0.05, window.sill + window.height + 0.05
                self.blocks.append(_Block(a, b, low, high, name=window.id))

    def block_above(self, walls: Sequence[Wall]) -> None:
        """Note the air above walls, so that nothing hangs over a parapet."""
        for wall in walls:
            if self.edge.carries(wall.segment):
                a, b, _ = self.edge.interval(wall.segment)
                self.blocks.append(_Block(a, b, wall.height, 99.0, name=wall.id))

    def block_object(self, obj: SceneObject) -> None:
        """Note an object where it is close to this wall."""
        a, b, distance = self.edge.interval(footprint_corners(obj.position, obj.size, obj.rotation))
        if distance < 1.0 and b > 0.0 and a < self.edge.length:
            high = obj.top + _ABOVE
            low = obj.bottom
            self.blocks.append(_Block(a, b, low, high, max(distance, 0.0), obj.id))

    def hang(self, asset: Asset, along: float, center: float) -> None:
        """Note an asset that hangs on this wall."""
        half_w, half_h = asset.size[0] / 2, asset.size[2] / 2
        self.blocks.append(_Block(along - half_w, along + half_w, center - half_h - _SIDE, center + half_h + _SIDE))
        self.hung.append((along, asset.category))


def wall_objects(
    requests: Sequence[HangRequest],
    edges: Sequence[WallEdge],
    doors: Sequence[Door],
    windows: Sequence[Window],
    height: float,
    placed: Sequence[SceneObject],
    ids: Ids,
    room_id: str,
    rng: np.random.Generator,
    low_walls: Sequence[Wall] = (),
) -> list[SceneObject]:
    """Return the wall objects of a room; those above furniture and beside doors are hung first."""
    walls = [WallSpace(edge, edges) for edge in edges]
    standing = [obj for obj in placed if obj.size[2] > 0.03]
    for wall in walls:
        wall.block_openings(doors, windows)
        wall.block_above(low_walls)
        for obj in standing:
            wall.block_object(obj)
    order = {"facing_seats": 0, "above": 1, "door": 2, "facing_door": 3}
    out: list[SceneObject] = []
    for request in sorted(requests, key=lambda w: order.get(w.place, 4)):
        left = request.count
        for wall, along, center in _places(request, walls, doors, height, placed, rng):
            if left <= 0:
                break
            if not _fits(wall, request.asset, along, center):
                continue
            left -= 1
            wall.hang(request.asset, along, center)
            out.append(_hang(request.asset, wall.edge, along, center, ids, room_id))
            for other in walls:
                if other is not wall:
                    other.block_object(out[-1])
    return out


def _hang(asset: Asset, edge: WallEdge, along: float, center: float, ids: Ids, room_id: str) -> SceneObject:
    x, y = edge.point(along, asset.size[1] / 2 + BACK_GAP)
    position: Point3 = (x, y, center)
    return scene_object(asset, ids.new(asset.category), room_id, position, edge.rotation, mount="wall")


def _fits(wall: WallSpace, asset: Asset, along: float, center: float) -> bool:
    w, d, h = asset.size
    return any(a - 1e-9 <= along <= b + 1e-9 for a, b in wall.gaps(w, center - h / 2, center + h / 2, d))


Place = tuple[WallSpace, float, float]


def _places(
    request: HangRequest,
    walls: Sequence[WallSpace],
    doors: Sequence[Door],
    height: float,
    placed: Sequence[SceneObject],
    rng: np.random.Generator,
) -> Iterator[Place]:
    """Yield candidate places: wall, distance along it and height of the centre, the best first."""
    asset = request.asset
    center = hanging_height(asset, height, request.height)
    if center is None:
        return
    if request.place == "above":
        yield from _above(request, walls, height, placed)
    elif request.place == "door":
        yield from _beside_doors(asset, walls, doors, center)
    else:
        yield from _free(request, walls, doors, center, placed, rng)


def hanging_height(asset: Asset, ceiling: float, wanted: float | None = None) -> float | None:
    """Return the height of the centre at which an asset hangs on a wall, metres; None where it is too high for it.

    Parameters
    ----------
    ceiling : float
        Clear height of the room, metres.
    wanted : float, optional
        Height of the centre that is asked for; the asset's usual one when absent.
    """
    center = min(wanted or _usual_height(asset), ceiling - asset.size[2] / 2 - 0.05)
    if center - asset.size[2] / 2 < 0.02:
        center = asset.size[2] / 2 + 0.02
    return None if center + asset.size[2] / 2 > ceiling else center


def height_above(asset: Asset, ceiling: float, obj: SceneObject, wanted: float | None = None) -> float | None:
    """Return the height of the centre at which an asset hangs above an object; None where the ceiling is too low."""
    h = asset.size[2]
    top = obj.top
    clearance = float(asset.parameters.get("above", _ABOVE + 0.01))
    low = max(top + clearance, (wanted or _usual_height(asset)) - h / 2)
    center = low + h / 2
    return None if center + h / 2 > ceiling - 0.02 else center


def _usual_height(asset: Asset) -> float:
    return float(asset.parameters.get("hang", 1.55))


def _above(
    request: HangRequest, walls: Sequence[WallSpace], height: float, placed: Sequence[SceneObject]
) -> Iterator[Place]:
    """Yield places over the objects that have their back at a wall."""
    for obj in placed:
        if not matches(obj, request.above):
            continue
        center = height_above(request.asset, height, obj, request.height)
        if center is None:
            continue
        for wall in walls:
            same = abs((wall.edge.rotation - obj.rotation + 180.0) % 360.0 - 180.0) < 5.0
            along, away = wall.edge.coordinates((obj.position[0], obj.position[1]))
            if same and 0.0 < along < wall.edge.length and away < obj.size[1] / 2 + 0.3:
                yield wall, along, center


def _beside_doors(asset: Asset, walls: Sequence[WallSpace], doors: Sequence[Door], center: float) -> Iterator[Place]:
    """Yield places beside each door, on the side of its latch first, up to 1.6 m away."""
    for door in doors:
        for wall in walls:
            if not wall.edge.carries(door.segment):
                continue
            (s0, _), (s1, _) = (wall.edge.coordinates(p) for p in door.segment)
            hinge_first = (door.hinge == "start") == (s0 < s1)
            a, b = min(s0, s1), max(s0, s1)
            for distance in (0.16, 0.3, 0.5, 0.8, 1.2, 1.6):
                reach = distance + asset.size[0] / 2
                sides = (b + reach, a - reach) if hinge_first else (a - reach, b + reach)
                for along in sides:
                    yield wall, along, center


def _free(
    request: HangRequest,
    walls: Sequence[WallSpace],
    doors: Sequence[Door],
    center: float,
    placed: Sequence[SceneObject],
    rng: np.random.Generator,
) -> Iterator[Place]:
    """Yield the middles of free lengths, the wide ones and those without a like neighbour first."""
    w, d, h = request.asset.size
    for _ in range(request.count):
        options: list[tuple[float, int, WallSpace, float]] = []
        for number, wall in enumerate(walls):
            for a, b in wall.gaps(w, center - h / 2, center + h / 2, d):
                length = min(b - a, 4.0)
                near = sum(0.8 for s, kind in wall.hung if abs(s - (a + b) / 2) < 1.5 + w / 2)
                score = length * 0.35 - near + float(rng.uniform(0.0, 1.2))
                if request.place == "facing_door":
                    score += 2.0 * _faces_door(wall, doors)
                elif request.place == "facing_seats":
                    score += 4.0 * _faced_by_seats(wall, placed)
                along = (a + b) / 2
                if b - a > 2.4 and request.place == "free":
                    along = float(rng.uniform(a + 0.6, b - 0.6))
                options.append((score, -number, wall, along))
        if not options:
            return
        best = max(options, key=lambda o: (o[0], o[1]))
        yield best[2], best[3], center


def _faces_door(wall: WallSpace, doors: Sequence[Door]) -> float:
    """Return 1 for a wall that the room's first door looks at, else 0."""
    if not doors:
        return 0.0
    (x0, y0), (x1, y1) = doors[0].segment
    along, away = wall.edge.coordinates(((x0 + x1) / 2, (y0 + y1) / 2))
    parallel = abs(wall.edge.coordinates(doors[0].segment[0])[1] - wall.edge.coordinates(doors[0].segment[1])[1])
    return float(away > 1.0 and parallel < 0.05 and -0.5 < along < wall.edge.length + 0.5)


def _faced_by_seats(wall: WallSpace, placed: Sequence[SceneObject]) -> float:
    """Return the share of the room's seats that look at a wall."""
    seats = [obj for obj in placed if "seat" in obj.category or "chair" in obj.category]
    opposite = wall.edge.rotation + 180.0
    looking = sum(
        abs((obj.rotation - opposite + 180.0) % 360.0 - 180.0) < 5.0
        and wall.edge.coordinates((obj.position[0], obj.position[1]))[1] > 0.0
        for obj in seats
    )
    return looking / len(seats) if seats else 0.0
