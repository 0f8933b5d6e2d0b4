"""Walls of a house in pairs of faces with at most one hole each, and the doors and windows in them."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, TypeAlias

import numpy as np

from mansion_export.thor.vocabulary import DOORFRAMES, DOORWAYS, WINDOWS, best_fitting, wall_material
from mansion_geometry.compiled import Floats
from mansion_geometry.rings import signed_area
from mansion_geometry.thor.house_format import thor_point
from mansion_msgs_py.scene import Door, FloorScene, SceneRoom, Window
from mansion_msgs_py.shapes import Point, Ring, Segment
from mansion_scene.structure.materials import DEFAULT_FACADE, facade_of

__all__ = ["Stretch", "Structure", "build_structure", "stretches"]

Json: TypeAlias = dict[str, Any]


COLLINEAR = 0.02
"""Metres by which two edges may lie apart and still be one boundary."""

SLIVER = 0.005
"""Shorter stretches are rounding, not boundary."""

REACH = 0.3
"""Metres between an opening's wall and the polygon edge that stands for it, at most."""


@dataclass(frozen=True, slots=True)
class Stretch:
    """A straight piece of a polygon's boundary with the same neighbour all along.

    Attributes
    ----------
    start, end : Point
        In the direction that has the owner's interior on its left.
    owner : str
        Id of the polygon.
    neighbour : str or None
        Id of the polygon on the other side; ``None`` is outside.
    """

    start: Point
    end: Point
    owner: str
    neighbour: str | None

    @property
    def length(self) -> float:
        """Length in metres."""
        return float(np.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1]))


def stretches(polygons: Mapping[str, Sequence[Ring]]) -> list[Stretch]:
    """Split the boundaries of polygons that tile a floor into stretches with one neighbour each.

    Parameters
    ----------
    polygons : mapping of str to sequence of Ring
        Outer ring and then holes of each polygon, in any orientation.

    Returns
    -------
    list of Stretch
        Two opposite ones with the same end points for each stretch that two polygons share, one for each stretch
        without a neighbour; in the order of `polygons` and of their vertices.

    Examples
    --------
    >>> left, right = [(0, 0), (1, 0), (1, 1), (0, 1)], [(1, 0), (2, 0), (2, 1), (1, 1)]
    >>> [s.neighbour for s in stretches({"a": [left], "b": [right]}) if s.owner == "a"]
    [None, 'b', None, None]
    """
    owners, starts, ends = _edges(polygons)
    if not owners:
        return []
    vectors = ends - starts
    lengths = np.hypot(vectors[:, 0], vectors[:, 1])
    units = vectors / lengths[:, None]
    shared: list[list[tuple[float, float, Stretch]]] = [[] for _ in owners]
    for i in range(len(owners)):
        for j, low, high in _opposites(i, owners, starts, ends, units, lengths):
            a, b = _along(starts[i], units[i], low), _along(starts[i], units[i], high)
            shared[i].append((low, high, Stretch(a, b, owners[i], owners[j])))
            t = float(np.dot(np.array(b) - starts[j], units[j]))
            shared[j].append((t, t + high - low, Stretch(b, a, owners[j], owners[i])))
    found: list[Stretch] = []
    for i, owner in enumerate(owners):
        found += _fill(owner, starts[i], units[i], float(lengths[i]), shared[i])
    return found


def _edges(polygons: Mapping[str, Sequence[Ring]]) -> tuple[list[str], Floats, Floats]:
    owners: list[str] = []
    starts: list[Point] = []
    ends: list[Point] = []
    for name, rings in polygons.items():
        for position, ring in enumerate(rings):
            points = list(ring)
            if (signed_area(points) > 0) != (position == 0):
                points.reverse()
            for a, b in zip(points, points[1:] + points[:1]):
                if np.hypot(b[0] - a[0], b[1] - a[1]) > 1e-6:
                    owners.append(name)
                    starts.append(a)
                    ends.append(b)
    return owners, np.array(starts, dtype=float), np.array(ends, dtype=float)


def _opposites(
    i: int, owners: list[str], starts: Floats, ends: Floats, units: Floats, lengths: Floats
) -> list[tuple[int, float, float]]:
    """Return later edges that run against edge `i` on its line, with the interval of `i` that they cover."""
    later = slice(i + 1, len(owners))
    ux, uy = units[i]
    against = units[later] @ units[i] < -0.999
    near_start = starts[later] - starts[i]
    near_end = ends[later] - starts[i]
    off = np.maximum(
        np.abs(near_start[:, 0] * uy - near_start[:, 1] * ux), np.abs(near_end[:, 0] * uy - near_end[:, 1] * ux)
    )
    low = np.maximum(near_end @ units[i], 0.0)
    high = np.minimum(near_start @ units[i], lengths[i])
    hits = np.flatnonzero(against & (off < COLLINEAR) & (high - low > SLIVER))
    return [(int(k) + i + 1, float(low[k]), float(high[k])) for k in hits if owners[int(k) + i + 1] != owners[i]]


def _fill(
    owner: str, start: Floats, unit: Floats, length: float, shared: list[tuple[float, float, Stretch]]
) -> list[Stretch]:
    """Return the shared stretches of one edge in order, and outer ones between them."""
    found: list[Stretch] = []
    reached = 0.0
    for low, high, stretch in sorted(shared, key=lambda item: item[0]):
        if low - reached > SLIVER:
            found.append(Stretch(_along(start, unit, reached), stretch.start, owner, None))
        found.append(stretch)
        reached = max(reached, high)
    if length - reached > SLIVER:
        found.append(Stretch(_along(start, unit, reached), _along(start, unit, length), owner, None))
    return found


def _along(start: Floats, unit: Floats, distance: float) -> Point:
    x, y = start + unit * distance
    return (round(float(x), 6), round(float(y), 6))


@dataclass(frozen=True, slots=True)
class _Hole:
    """An opening's interval along a stretch of boundary, metres."""

    low: float
    high: float
    opening: Door | Window


@dataclass(slots=True)
class Structure:
    """Walls, doors and windows of a house, and what its rooms share.

    Attributes
    ----------
    neighbours : list of (str, str)
        Rooms that share a wall, ids in order.
    merged : list of (str, str)
        Rooms between which a wall is missing; they share light.
    misplaced : list of str
        Ids of openings for which no wall was found.
    facade : str
        Material of the outer walls' outer faces.
    """

    walls: list[Json] = field(default_factory=list)
    doors: list[Json] = field(default_factory=list)
    windows: list[Json] = field(default_factory=list)
    neighbours: list[tuple[str, str]] = field(default_factory=list)
    facade: str = DEFAULT_FACADE
    merged: list[tuple[str, str]] = field(default_factory=list)
    misplaced: list[str] = field(default_factory=list)

    def add_piece(
        self, stretch: Stretch, low: float, high: float, hole: _Hole | None, rooms: dict[str, SceneRoom], height: float
    ) -> None:
        """Add both faces of a piece of wall, and what is in its hole."""
        a, b = _point(stretch, low), _point(stretch, high)
        number = len(self.walls) // 2
        owner, other = rooms[stretch.owner], rooms.get(stretch.neighbour or "")
        near, far = f"wall|{owner.id}|{number}", f"wall|{other.id if other else 'exterior'}|{number}"
        gone = hole is not None and isinstance(hole.opening, Door) and hole.opening.kind == "open"
        # The owner's interior lies to the left of start -> end; AI2-THOR shows the right side of p0 -> p1.
        faces = [
            _face(near, owner.id, b, a, height, owner.wall_material, empty=gone),
            _face(
                far,
                other.id if other else owner.id,
                a,
                b,
                height,
                other.wall_material if other else self.facade,
                empty=gone,
            ),
        ]
        self.walls += faces
        if hole is None:
            return
        if gone:
            if other is not None:
                self.merged.append((owner.id, other.id))
            return
        forward = (hole.low - low, hole.high - low)
        backward = (high - hole.high, high - hole.low)
        if isinstance(hole.opening, Window):
            self.windows.append(_window(hole.opening, near, far, owner.id, backward))
            return
        door = hole.opening
        if other is not None and door.swing == owner.id:
            self.doors.append(_door(door, (far, near), (other.id, owner.id), forward, inside=True))
        else:
            names = (owner.id, other.id if other else owner.id)
            self.doors.append(_door(door, (near, far), names, backward, inside=other is not None))


def build_structure(scene: FloorScene, height: float) -> Structure:
    """Make walls, doors and windows of the rooms of a floor; cores count as outside.

    Parameters
    ----------
    height : float
        Height of all walls, metres: AI2-THOR hangs one ceiling over the house.
    """
    rooms = {room.id: room for room in scene.rooms if room.kind not in ("stair", "elevator")}
    made = Structure(facade=facade_of(scene))
    waiting: list[Door | Window] = [*scene.doors, *scene.windows]
    for stretch in stretches({key: [room.polygon, *room.holes] for key, room in rooms.items()}):
        other = stretch.neighbour
        if other is not None:
            if other < stretch.owner:
                continue
            made.neighbours.append((stretch.owner, other))
        holes = _holes_on(stretch, waiting, rooms)
        for hole in holes:
            waiting.remove(hole.opening)
        for low, high, inside in _pieces(stretch, holes):
            made.add_piece(stretch, low, high, inside, rooms, height)
    made.misplaced = [item.id for item in waiting if _concerns(item, rooms)]
    return made


def _concerns(opening: Door | Window, rooms: dict[str, SceneRoom]) -> bool:
    if isinstance(opening, Window):
        return opening.room in rooms
    return any(name in rooms for name in opening.rooms)


def _holes_on(stretch: Stretch, waiting: Sequence[Door | Window], rooms: dict[str, SceneRoom]) -> list[_Hole]:
    """Return the openings that lie on a stretch and join what it divides, along its direction.

    Where openings lie behind one another, as in two walls close together, the nearest is taken; the others keep theirs.
    """
    found = []
    for number, opening in enumerate(waiting):
        if not _joins(opening, stretch, rooms):
            continue
        interval = _interval(stretch, opening.segment)
        if interval is not None:
            found.append((_distance(stretch, opening.segment), number, _Hole(*interval, opening)))
    holes: list[_Hole] = []
    for _, _, hole in sorted(found, key=lambda entry: entry[:2]):
        if all(hole.high <= other.low or other.high <= hole.low for other in holes):
            holes.append(hole)
    return sorted(holes, key=lambda hole: hole.low)


def _distance(stretch: Stretch, segment: Segment) -> float:
    """Return how far a segment's middle lies from the line of a stretch, in steps of 1 mm."""
    (ax, ay), (bx, by) = stretch.start, stretch.end
    x, y = (segment[0][0] + segment[1][0]) / 2, (segment[0][1] + segment[1][1]) / 2
    return round(abs((x - ax) * (by - ay) - (y - ay) * (bx - ax)) / stretch.length, 3)


def _joins(opening: Door | Window, stretch: Stretch, rooms: dict[str, SceneRoom]) -> bool:
    if isinstance(opening, Window):
        return stretch.neighbour is None and opening.room == stretch.owner
    ends = {name if name in rooms else None for name in opening.rooms}
    return ends == {stretch.owner, stretch.neighbour}


def _interval(stretch: Stretch, segment: Segment) -> tuple[float, float] | None:
    """Return where a segment lies along a stretch, if it lies on it."""
    a = np.array(stretch.start)
    unit = (np.array(stretch.end) - a) / stretch.length
    rel = np.array(segment) - a
    along = rel @ unit
    off = np.abs(rel[:, 0] * unit[1] - rel[:, 1] * unit[0])
    low, high = max(float(along.min()), 0.0), min(float(along.max()), stretch.length)
    width = float(along.max() - along.min())
    if off.max() > REACH or high - low < 0.8 * width or high - low < 0.05:
        return None
    return low, high


def _pieces(stretch: Stretch, holes: list[_Hole]) -> list[tuple[float, float, _Hole | None]]:
    """Cut a stretch so that no piece has two holes; a missing wall is a piece of its own."""
    pieces: list[tuple[float, float, _Hole | None]] = []
    reached = 0.0
    for i, hole in enumerate(holes):
        if isinstance(hole.opening, Door) and hole.opening.kind == "open":
            if hole.low > reached + 1e-3:
                pieces.append((reached, hole.low, None))
            pieces.append((hole.low, hole.high, hole))
            reached = hole.high
            continue
        following = holes[i + 1] if i + 1 < len(holes) else None
        end = stretch.length
        if following is not None:
            gone = isinstance(following.opening, Door) and following.opening.kind == "open"
            end = following.low if gone else (hole.high + following.low) / 2
        pieces.append((reached, end, hole))
        reached = end
    if stretch.length > reached + 1e-3:
        pieces.append((reached, stretch.length, None))
    return pieces


def _point(stretch: Stretch, along: float) -> Point:
    (ax, ay), (bx, by) = stretch.start, stretch.end
    t = along / stretch.length
    return (round(ax + (bx - ax) * t, 4), round(ay + (by - ay) * t, 4))


def _face(name: str, room: str, p0: Point, p1: Point, height: float, material: str, *, empty: bool) -> Json:
    wall: Json = {
        "id": name,
        "roomId": room,
        "polygon": [thor_point(*p, z) for z in (0.0, height) for p in (p0, p1)],
        "material": wall_material(material),
    }
    if empty:
        wall["empty"] = True
    return wall


def _rectangle(interval: tuple[float, float], bottom: float, top: float) -> Json:
    """Return ``holePolygon`` (lowest and highest corner along `wall0`) and the centre of what fills it."""
    low, high = interval
    return {
        "holePolygon": [
            {"x": round(low, 4), "y": round(bottom, 4), "z": 0},
            {"x": round(high, 4), "y": round(top, 4), "z": 0},
        ],
        "assetPosition": {"x": round((low + high) / 2, 4), "y": round((bottom + top) / 2, 4), "z": 0},
    }


def _door(
    door: Door, walls: tuple[str, str], rooms: tuple[str, str], interval: tuple[float, float], *, inside: bool
) -> Json:
    """Return a door, which opens away from `room0`; without ground beyond it, at cores and outside, it stays closed."""
    frame = door.kind in ("doorway", "frame") and inside
    width = interval[1] - interval[0]
    asset, wide, tall = best_fitting(DOORFRAMES if frame else DOORWAYS, width, door.height)
    return {
        "id": door.id,
        "assetId": asset,
        "scale": {"x": round(wide, 4), "y": round(tall, 4), "z": 1},
        "openable": not frame,
        "openness": 1 if inside and not frame and door.is_open else 0,
        "room0": rooms[0],
        "room1": rooms[1],
        "wall0": walls[0],
        "wall1": walls[1],
        **_rectangle(interval, 0.0, door.height),
    }


def _window(window: Window, near: str, far: str, room: str, interval: tuple[float, float]) -> Json:
    asset, wide, tall = best_fitting(WINDOWS, interval[1] - interval[0], window.height)
    return {
        "id": window.id,
        "assetId": asset,
        "scale": {"x": round(wide, 4), "y": round(tall, 4), "z": 1},
        "room0": room,
        "room1": room,
        "wall0": near,
        "wall1": far,
        **_rectangle(interval, window.sill, window.sill + window.height),
    }
