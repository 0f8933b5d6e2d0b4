"""Waypoints and lanes of a building: in its rooms, through its doors and in its lifts."""

import math
from collections import Counter
from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field, replace

import shapely
from shapely.geometry import Polygon

from mansion_export.rmf.free_floor import cabin_frame, walkable
from mansion_export.rmf.lane_paths import FloorPiece, central_point
from mansion_geometry.rings import polygon_parts
from mansion_geometry.robot_body import ROBOT_RADIUS
from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.shapes import Point, Segment

__all__ = ["OPERATED", "Crossing", "Lane", "LevelGraph", "Waypoint", "building_graph", "crossings", "level_name"]

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


SPARE = 0.005
"""What lanes keep off things beyond the radius, for the rounding of coordinates; metres."""

APART = 0.5
"""A start pose nearer to its room's waypoint than this has no waypoint of its own; metres."""


@dataclass(frozen=True, slots=True)
class Waypoint:
    """A place where lanes meet.

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
    """A straight way that can be driven both ways; `door` is the one that it leads through, if any."""

    start: int
    end: int
    door: str = ""


@dataclass(slots=True)
class LevelGraph:
    """The lanes of one floor; `lanes` count the `waypoints` from 0."""

    scene: FloorScene
    waypoints: list[Waypoint] = field(default_factory=list)
    lanes: list[Lane] = field(default_factory=list)

    @property
    def name(self) -> str:
        """What Open-RMF calls the floor, and the map that its robots say they are on."""
        return level_name(self.scene.floor)

    def add(self, place: Point, room: str = "", lift: str = "") -> int:
        """Return the waypoint at a place, a new one if there is none yet."""
        for i, known in enumerate(self.waypoints):
            if known.place == place:
                return i
        self.waypoints.append(Waypoint(place, room=room, lift=lift))
        return len(self.waypoints) - 1

    def mark(self, i: int, **changes: object) -> None:
        """Change what is said of a waypoint."""
        self.waypoints[i] = replace(self.waypoints[i], **changes)  # type: ignore[arg-type]


def level_name(floor: int) -> str:
    """Return what a floor is called: the prefix of the ids on it."""
    return f"F{floor}"


def building_graph(scenes: Sequence[FloorScene], radius: float = ROBOT_RADIUS) -> list[LevelGraph]:
    """Lay lanes over a building.

    Parameters
    ----------
    scenes : sequence of FloorScene
        Its floors, in any order.
    radius : float
        Of the robot, metres: no lane comes nearer to anything, leaves of doors excepted.

    Returns
    -------
    list of LevelGraph
        Ascending; on each the largest piece that lanes and lifts join. Every such piece of the building has a
        charger.
    """
    levels = [_level_graph(scene, radius) for scene in sorted(scenes, key=lambda scene: scene.floor)]
    pieces = _pieces(levels)
    kept = [_largest(level, numbers) for level, numbers in zip(levels, pieces)]
    _add_chargers(kept, _pieces(kept))
    return kept


def _level_graph(scene: FloorScene, radius: float) -> LevelGraph:
    level = LevelGraph(scene)
    floor = [FloorPiece(part) for part in walkable(scene, radius + SPARE)]
    ways = crossings(scene, floor)
    for way in ways:
        lift = way.rooms[1] if _is_lift(scene, way) else ""
        start = level.add(way.ends[0], room=way.rooms[0])
        end = level.add(way.ends[1], room="" if lift else way.rooms[1], lift=lift)
        if lift:
            level.mark(end, name=f"{level.name}/{lift}")
        door = way.door.id if way.door.kind in OPERATED else ""
        level.lanes.append(Lane(start, end, door))
    for room in scene.rooms:
        if room.kind != "stair":
            shape = Polygon(room.polygon, room.holes)
            ends = [end for way in ways for end, key in zip(way.ends, way.rooms) if key == room.id]
            _fill_room(level, room.id, shape, ends, [piece.shape for piece in floor])
    return level


def _is_lift(scene: FloorScene, way: Crossing) -> bool:
    return any(core.door == way.door.id and core.type == "elevator" for core in scene.cores)


def _fill_room(level: LevelGraph, room: str, shape: Polygon, ends: list[Point], floor: Iterable[Polygon]) -> None:
    """Join the places beside a room's doors; the part of the room with most of them has the room's waypoint."""
    parts = [part for piece in floor for part in polygon_parts(piece.intersection(shape))]
    pieces = [FloorPiece(part) for part in parts]
    spawn = level.scene.spawn
    held = [[end for end in dict.fromkeys(ends) if piece.holds(end)] for piece in pieces]
    order = sorted(range(len(pieces)), key=lambda i: (-len(held[i]), -round(parts[i].area, 6), i))
    for rank, i in enumerate(order):
        goals = held[i]
        if rank and not goals:
            break
        root = central_point(parts[i])
        if not pieces[i].holds(root):
            continue
        start = level.add(root, room=room)
        if not rank:
            level.mark(start, name=room)
        if spawn is not None and spawn.room == room:
            place = (round(spawn.x, 3), round(spawn.y, 3))
            if shapely.distance(shapely.Point(place), shapely.Point(root)) < APART:
                level.mark(start, parking=True)
            elif pieces[i].holds(place):
                goals = [*goals, place]
                level.mark(level.add(place, room=room), name=f"{room}/start", parking=True)
        for a, b in pieces[i].tree(root, [goal for goal in goals if goal != root]):
            level.lanes.append(Lane(level.add(a, room=room), level.add(b, room=room)))


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
    lanes = [Lane(number[lane.start], number[lane.end], lane.door) for lane in level.lanes if lane.start in number]
    return LevelGraph(level.scene, [level.waypoints[i] for i in kept], lanes)


def _add_chargers(levels: Sequence[LevelGraph], pieces: Sequence[Sequence[int]]) -> None:
    """Make the lowest parking spot of each piece its charger; its first room where it has none."""
    places: dict[int, list[tuple[bool, int, int]]] = {}
    for k, (level, numbers) in enumerate(zip(levels, pieces)):
        for i, (point, piece) in enumerate(zip(level.waypoints, numbers)):
            if point.name and not point.lift:
                places.setdefault(piece, []).append((not point.parking, k, i))
    for candidates in places.values():
        _, k, i = min(candidates)
        levels[k].mark(i, parking=True, charger=True)
