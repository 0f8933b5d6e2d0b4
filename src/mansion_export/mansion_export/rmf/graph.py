"""Waypoints, lanes and chargers of a building: in its rooms, through its doors and in its lifts."""

import math
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, replace

import shapely
from shapely.geometry import Polygon

from mansion_export.rmf.free_floor import cabin_frame, walkable
from mansion_export.rmf.lane_paths import FreeRegion, central_point
from mansion_geometry.rings import polygon_parts
from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.shapes import Point, Segment

__all__ = ["OPERATED", "Crossing", "Lane", "LevelGraph", "Waypoint", "building_graph", "crossings"]

OPERATED = ("single", "double", "glazed", "entrance", "balcony", "garage")
"""Kinds of doors that have leaves; the landing doors of lifts belong to the lift."""

BESIDE = (0.5, 0.4, 0.3, 0.25, 0.2, 0.7, 0.9, 0.15)
"""Distances from a wall's centre line that are tried for a waypoint beside a door, metres."""

ALONG = 0.2
"""Distance between the places along an opening that are tried, metres."""

SPARE = 0.005
"""Clearance of lanes beyond the radius, for the rounding of coordinates; metres."""

APART = 0.5
"""A start pose nearer to its room's waypoint than this has no waypoint of its own; metres."""


@dataclass(frozen=True, slots=True)
class Crossing:
    """A lane through a door.

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


def crossings(scene: FloorScene, pieces: Sequence[FreeRegion]) -> list[Crossing]:
    """Return a lane through every door between rooms, or into a lift, that the robot fits through."""
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
    door: Door, rooms: tuple[str, str], facing: Point, cabin: Point, pieces: Sequence[FreeRegion]
) -> Crossing | None:
    (ax, ay), (bx, by) = door.segment
    x, y = (ax + bx) / 2, (ay + by) / 2
    for beside in BESIDE:
        front = _rounded(x + facing[0] * beside, y + facing[1] * beside)
        if any(piece.connects(front, cabin) for piece in pieces):
            return Crossing(door, (front, cabin), rooms)
    return None


def _between(door: Door, shapes: dict[str, Polygon], pieces: Sequence[FreeRegion]) -> Crossing | None:
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
        if {in_left, in_right} == {a, b} and any(piece.connects(left, right) for piece in pieces):
            return Crossing(door, (left, right), (in_left, in_right))
    return None


def _fractions(length: float) -> list[float]:
    """Return places along an opening, the middle first, the others by distance from it."""
    count = int(length / 2 / ALONG)
    steps = [0.0] + [sign * k * ALONG / length for k in range(1, count + 1) for sign in (1, -1)]
    return [0.5 + step for step in steps]


def _end(
    x: float, y: float, normal: Point, sign: float, rooms: dict[str, Polygon], pieces: Sequence[FreeRegion]
) -> tuple[Point, str] | None:
    """Return the first good place on one side of a door and the room that it lies in."""
    middle = (x, y)
    for beside in BESIDE:
        point = _rounded(x + normal[0] * sign * beside, y + normal[1] * sign * beside)
        room = next((key for key, shape in rooms.items() if _within(shape, point)), None)
        if room is not None and any(piece.connects(middle, point) for piece in pieces):
            return point, room
    return None


def _within(shape: Polygon, point: Point) -> bool:
    return FreeRegion(shape).contains(point)


def _rounded(x: float, y: float) -> Point:
    return (round(x, 3) + 0.0, round(y, 3) + 0.0)


@dataclass(frozen=True, slots=True)
class Waypoint:
    """A place where lanes meet or end.

    Attributes
    ----------
    place : (x, y)
    name : str
        Unique in the building; empty where nobody needs to send a robot.
    room, lift : str
        Id of the room or the lift that it lies in; the other is empty.
    parking, charger : bool
        Where a robot may stay; where it charges.
    """

    place: Point
    name: str = ""
    room: str = ""
    lift: str = ""
    parking: bool = False
    charger: bool = False


@dataclass(frozen=True, slots=True)
class Lane:
    """A straight lane that can be driven both ways; `door` is the id of the one that it leads through, if any."""

    start: int
    end: int
    door: str = ""


@dataclass(frozen=True, slots=True)
class LevelGraph:
    """The lanes of one floor; `lanes` count the `waypoints` from 0."""

    scene: FloorScene
    waypoints: tuple[Waypoint, ...] = ()
    lanes: tuple[Lane, ...] = ()

    @property
    def name(self) -> str:
        """What Open-RMF calls the floor, and the map that its robots say they are on: the prefix of the ids on it."""
        return f"F{self.scene.floor}"


def building_graph(scenes: Sequence[FloorScene], radius: float = ROBOT_RADIUS) -> list[LevelGraph]:
    """Return the lanes of a building.

    Parameters
    ----------
    scenes : sequence of FloorScene
        Its floors, in any order.
    radius : float
        Radius of the robot, metres: no lane comes nearer to anything but the leaves of doors.

    Returns
    -------
    list of LevelGraph
        Ascending; on each the largest piece that lanes and lifts join. Every such piece of the building has a
        charger.
    """
    levels = [_LevelBuilder(scene, radius).graph() for scene in sorted(scenes, key=lambda scene: scene.floor)]
    pieces = _pieces(levels)
    kept = [_largest(level, numbers) for level, numbers in zip(levels, pieces)]
    return _with_chargers(kept, _pieces(kept))


class _LevelBuilder:
    """Lays the lanes of one floor."""

    def __init__(self, scene: FloorScene, radius: float) -> None:
        self._scene = scene
        self._name = LevelGraph(scene).name
        self._floor = [FreeRegion(part) for part in walkable(scene, radius + SPARE)]
        self._waypoints: list[Waypoint] = []
        self._lanes: list[Lane] = []

    def graph(self) -> LevelGraph:
        """Return the lanes through doors, and those in rooms that join them."""
        found = crossings(self._scene, self._floor)
        lifts = {core.door for core in self._scene.cores if core.type == "elevator"}
        for crossing in found:
            lift = crossing.rooms[1] if crossing.door.id in lifts else ""
            start = self._waypoint(crossing.ends[0], room=crossing.rooms[0])
            end = self._waypoint(crossing.ends[1], room="" if lift else crossing.rooms[1], lift=lift)
            if lift:
                self._mark(end, name=f"{self._name}/{lift}")
            door = crossing.door.id if crossing.door.kind in OPERATED else ""
            self._lanes.append(Lane(start, end, door))
        for room in self._scene.rooms:
            if room.kind != "stair":
                shape = Polygon(room.polygon, room.holes)
                ends = [end for each in found for end, key in zip(each.ends, each.rooms) if key == room.id]
                self._fill_room(room.id, shape, ends)
        return LevelGraph(self._scene, tuple(self._waypoints), tuple(self._lanes))

    def _waypoint(self, place: Point, room: str = "", lift: str = "") -> int:
        """Return the number of the waypoint at a place, a new one if there is none yet."""
        for i, known in enumerate(self._waypoints):
            if known.place == place:
                return i
        self._waypoints.append(Waypoint(place, room=room, lift=lift))
        return len(self._waypoints) - 1

    def _mark(self, i: int, *, name: str | None = None, parking: bool = False) -> None:
        known = self._waypoints[i]
        self._waypoints[i] = replace(known, name=known.name if name is None else name, parking=known.parking or parking)

    def _fill_room(self, room: str, shape: Polygon, ends: list[Point]) -> None:
        """Join the waypoints beside a room's doors; the region with most of them has the room's waypoint."""
        parts = [part for region in self._floor for part in polygon_parts(region.shape.intersection(shape))]
        regions = [FreeRegion(part) for part in parts]
        spawn = self._scene.spawn
        held = [[end for end in dict.fromkeys(ends) if region.contains(end)] for region in regions]
        order = sorted(range(len(regions)), key=lambda i: (-len(held[i]), -round(parts[i].area, 6), i))
        for rank, i in enumerate(order):
            goals = held[i]
            if rank and not goals:
                break
            root = central_point(parts[i])
            if not regions[i].contains(root):
                continue
            start = self._waypoint(root, room=room)
            if not rank:
                self._mark(start, name=room)
            if spawn is not None and spawn.room == room:
                place = (round(spawn.x, 3), round(spawn.y, 3))
                if shapely.distance(shapely.Point(place), shapely.Point(root)) < APART:
                    self._mark(start, parking=True)
                elif regions[i].contains(place):
                    goals = [*goals, place]
                    self._mark(self._waypoint(place, room=room), name=f"{room}/start", parking=True)
            for a, b in regions[i].lane_tree(root, [goal for goal in goals if goal != root]):
                self._lanes.append(Lane(self._waypoint(a, room=room), self._waypoint(b, room=room)))


def _pieces(levels: Sequence[LevelGraph]) -> list[list[int]]:
    """Number the connected pieces of a building, lifts included, for each waypoint of each level."""
    offsets = [0]
    for level in levels:
        offsets.append(offsets[-1] + len(level.waypoints))
    piece = list(range(offsets[-1]))

    def top(i: int) -> int:
        while piece[i] != i:
            i = piece[i]
        return i

    def join(i: int, j: int) -> None:
        i, j = sorted((top(i), top(j)))
        piece[j] = i

    lifts: dict[str, int] = {}
    for level, offset in zip(levels, offsets):
        for lane in level.lanes:
            join(offset + lane.start, offset + lane.end)
        for i, waypoint in enumerate(level.waypoints):
            if waypoint.lift:
                join(offset + i, lifts.setdefault(waypoint.lift, offset + i))
    return [[top(offset + i) for i in range(len(level.waypoints))] for level, offset in zip(levels, offsets)]


def _largest(level: LevelGraph, pieces: Sequence[int]) -> LevelGraph:
    """Return a level without what its main piece, the one with most named waypoints, does not reach."""
    size = Counter(piece for piece, point in zip(pieces, level.waypoints) if point.name)
    if not size:
        return LevelGraph(level.scene)
    main = min(size, key=lambda piece: (-size[piece], piece))
    kept = [i for i, piece in enumerate(pieces) if piece == main]
    number = {old: new for new, old in enumerate(kept)}
    lanes = (Lane(number[lane.start], number[lane.end], lane.door) for lane in level.lanes if lane.start in number)
    return LevelGraph(level.scene, tuple(level.waypoints[i] for i in kept), tuple(lanes))


def _with_chargers(levels: Sequence[LevelGraph], pieces: Sequence[Sequence[int]]) -> list[LevelGraph]:
    """Make the lowest parking spot of each piece its charger; its first room where it has none."""
    places: dict[int, list[tuple[bool, int, int]]] = {}
    for k, (level, numbers) in enumerate(zip(levels, pieces)):
        for i, (point, piece) in enumerate(zip(level.waypoints, numbers)):
            if point.name and not point.lift:
                places.setdefault(piece, []).append((not point.parking, k, i))
    chosen = {min(candidates)[1:] for candidates in places.values()}
    return [
        replace(
            level,
            waypoints=tuple(
                replace(point, parking=True, charger=True) if (k, i) in chosen else point
                for i, point in enumerate(level.waypoints)
            ),
        )
        for k, level in enumerate(levels)
    ]
