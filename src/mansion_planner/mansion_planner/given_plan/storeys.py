"""The storeys of a plan in metres: rooms with ids, types and shapes, and faults of their shapes."""

import math
from collections import Counter
from collections.abc import Callable, Iterable, Iterator, Sequence
from dataclasses import dataclass, field, replace
from typing import Final

import shapely
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient

from mansion_geometry.rings import dominant_angle, rotated
from mansion_knowledge import KnowledgeBase, RoomType
from mansion_msgs_py.building_plan import BuildingPlan, PlanDoor, PlanFloor, PlanRoom, PlanUnit, PlanWindow
from mansion_msgs_py.limits import MAX_EXTENT, MAX_FLOOR_AREA
from mansion_msgs_py.shapes import Point
from mansion_planner.given_plan.faults import Findings, Origin
from mansion_planner.given_plan.room_kinds import core_kind, room_kind, slug

__all__ = ["METRES", "PlanStorey", "StoreyRoom", "read_storeys", "suggested_building"]

METRES: Final[dict[PlanUnit, float]] = {"m": 1.0, "cm": 0.01, "mm": 0.001, "ft": 0.3048, "in": 0.0254}

_LEAST_EXTENT = 1.5
_LEAST_AREA = 0.3
_AT_WALL = 0.6
_FAR = 1_000.0
"""Metres from the origin beyond which a plan is moved to it."""

_TURNED = math.radians(0.2)


@dataclass(frozen=True)
class StoreyRoom:
    """A room or a core of a storey.

    Attributes
    ----------
    name : str
        In the plan's words.
    core : str
        ``stair`` or ``elevator``; empty for a room.
    shape : Polygon, optional
        ``None`` where the solver is to draw it.
    known : bool
        The words of the plan name the type, rather than one like it.
    """

    id: str
    name: str
    type: RoomType
    core: str
    shape: Polygon | None
    area: float
    known: bool = True

    @property
    def place(self) -> Point | None:
        """A point in it."""
        if self.shape is None:
            return None
        point = self.shape.representative_point()
        return float(point.x), float(point.y)


@dataclass(frozen=True)
class PlanStorey:
    """A storey of a plan, in metres; an opening of the plan is a door without a leaf here.

    Attributes
    ----------
    names : dict of str to list of str
        Ids of the rooms that a word of the plan may mean, lower case.
    lost : frozenset of str
        Ids of rooms that are left out for their own faults.
    lost_ground : tuple of geometry
        Where they lie, as far as their corners tell.
    """

    index: int
    label: str
    height: float | None
    rooms: list[StoreyRoom]
    doors: list[PlanDoor]
    windows: list[PlanWindow]
    outline: Polygon | None = None
    names: dict[str, list[str]] = field(default_factory=dict)
    lost: frozenset[str | None] = frozenset()
    lost_ground: tuple[shapely.Geometry, ...] = ()

    def beside_lost(self, point: Point) -> bool:
        """Whether a point lies at the walls of a room that is left out, so that nothing can be said of it."""
        return any(ground.distance(shapely.Point(point)) < _AT_WALL for ground in self.lost_ground)

    @property
    def drawn(self) -> bool:
        """Whether the plan has the shapes of all rooms."""
        return all(room.shape is not None for room in self.rooms)

    def with_shapes(self, shapes: Iterable[Polygon | None]) -> "PlanStorey":
        """Return it with other shapes of its rooms, in their order."""
        rooms = [
            replace(room, shape=shape, area=round(shape.area, 4) if shape is not None else room.area)
            for room, shape in zip(self.rooms, shapes, strict=True)
        ]
        return replace(self, rooms=rooms)

    def room(self, name: str) -> StoreyRoom:
        """Return the room of an id."""
        return next(room for room in self.rooms if room.id == name)


def read_storeys(plan: BuildingPlan, knowledge: KnowledgeBase, findings: Findings) -> list[PlanStorey]:
    """Return the storeys of a plan from the lowest to the highest, in metres, along the axes and near the origin.

    Faults of shapes, units, numbers of floors and of names go to `findings`.
    """
    numbers = [floor.floor for floor in plan.floors]
    _check_numbers(numbers, findings)
    points = [point for floor in plan.floors for point in _points(floor)]
    move = _to_metres(plan, points, findings)
    if move is None:
        return []
    floors = sorted(plan.floors, key=lambda floor: floor.floor)
    storeys = [_storey(floor, move, METRES[plan.units], knowledge, findings) for floor in floors]
    return _as_home(storeys, knowledge) if suggested_building(storeys) == "house" else storeys


def suggested_building(storeys: Sequence[PlanStorey]) -> str:
    """Return the building type that most rooms suggest, an office where none suggests any."""
    votes = Counter(room.type.suggests for storey in storeys for room in storey.rooms if room.type.suggests)
    return max(votes, key=lambda name: (votes[name], name)) if votes else "office"


def _as_home(storeys: Sequence[PlanStorey], knowledge: KnowledgeBase) -> list[PlanStorey]:
    """Return storeys in which the hall of a home is a hallway, not the lobby of a public building."""
    hallway = knowledge.room("hallway")

    def at_home(room: StoreyRoom) -> StoreyRoom:
        return replace(room, type=hallway) if room.type.name == "lobby" else room

    return [replace(storey, rooms=[at_home(room) for room in storey.rooms]) for storey in storeys]


def _check_numbers(numbers: Sequence[int], findings: Findings) -> None:
    for number, count in Counter(numbers).items():
        if count > 1:
            findings.fault(number, "", f"{count} entries have this number; give each floor its own")
    there = sorted(set(numbers))
    missing = [n for n in range(min(there[0], 1), max(there[-1], 1) + 1) if n not in there]
    if missing:
        named = ", ".join(str(n) for n in missing)
        findings.fault(
            None, "", f"floors {there} lack {named}: the ground floor is 1, and no floor between may be left out"
        )


def _points(floor: PlanFloor) -> list[Point]:
    rings = [ring for room in floor.rooms for ring in (room.polygon, *room.holes)]
    return [point for ring in (*rings, floor.outline, *floor.holes) for point in ring]


def _to_metres(plan: BuildingPlan, points: Sequence[Point], findings: Findings) -> Callable[[Point], Point] | None:
    """Return what turns points of the file into metres near the origin, along the axes; ``None`` for wrong units."""
    scale = METRES[plan.units]
    if not points:
        return lambda point: point
    rings = [[(x * scale, y * scale) for x, y in room.polygon] for floor in plan.floors for room in floor.rooms]
    angle = dominant_angle([ring for ring in rings if len(ring) > 2])
    turned = rotated([(x * scale, y * scale) for x, y in points], -angle if abs(angle) > _TURNED else 0.0)
    xs, ys = [x for x, _ in turned], [y for _, y in turned]
    extent = max(max(xs) - min(xs), max(ys) - min(ys))
    if extent > MAX_EXTENT or extent < _LEAST_EXTENT:
        findings.fault(None, "", _wrong_units(extent, plan.units))
        return None
    if abs(angle) > _TURNED:
        degrees = math.degrees(angle)
        findings.note(
            None, "walls at an angle", f"the plan turned by {-degrees:.1f} degrees", "walls run along the axes"
        )
    far = max(abs(value) for value in (*xs, *ys)) > _FAR
    shift = (min(xs), min(ys)) if far else (0.0, 0.0)
    if far:
        findings.note(
            None, "coordinates far from the origin", f"the plan moved by ({-shift[0]:.1f}, {-shift[1]:.1f}) m",
            f"lengths are exact within {_FAR:.0f} m",
        )  # fmt: skip

    def move(point: Point) -> Point:
        ((x, y),) = rotated([(point[0] * scale, point[1] * scale)], -angle if abs(angle) > _TURNED else 0.0)
        return round(x - shift[0], 5) + 0.0, round(y - shift[1], 5) + 0.0

    return move


def _wrong_units(extent: float, units: PlanUnit) -> str:
    if extent < _LEAST_EXTENT:
        return (
            f"the plan is {extent:.4g} m from end to end; coordinates are read as {units!r}, and degrees of longitude"
            " and latitude cannot be read: metres in plan are expected"
        )
    fitting = [
        unit for unit, scale in METRES.items() if unit != units and 4.0 <= extent / METRES[units] * scale <= MAX_EXTENT
    ]
    like = {"mm": "millimetres", "cm": "centimetres", "ft": "feet", "in": "inches", "m": "metres"}
    guess = next((unit for unit in ("mm", "cm", "in", "ft") if unit in fitting), None)
    said = f'; the numbers look like {like[guess]}: say "units": "{guess}"' if guess else ""
    return f"the plan is {extent:.0f} m from end to end, at most {MAX_EXTENT:.0f} m are built{said}"


def _storey(
    floor: PlanFloor, move: Callable[[Point], Point], scale: float, knowledge: KnowledgeBase, findings: Findings
) -> PlanStorey:
    ids = _ids(floor, findings)
    findings.origins += _origins(floor, ids, move)
    rooms = [_room(floor.floor, room, name, move, knowledge, findings) for room, name in zip(floor.rooms, ids)]
    outline = None
    if floor.outline:
        outline = _shape(floor.floor, "outline", floor.outline, floor.holes, move, findings)
    names: dict[str, list[str]] = {}
    for room, name in zip(floor.rooms, ids):
        words = (room.id, room.name, name, slug(room.name), slug(room.id))
        for word in dict.fromkeys(word.casefold() for word in words if word):
            names.setdefault(word, []).append(name)
    doors = [*floor.doors, *(_leafless(opening) for opening in floor.openings)]
    return PlanStorey(
        index=floor.floor,
        label=floor.label,
        height=None if floor.height is None else floor.height * scale,
        rooms=[room for room in rooms if room is not None],
        doors=[_moved(door, move, scale) for door in doors],
        windows=[_moved_window(window, move, scale) for window in floor.windows],
        outline=outline,
        names=names,
        lost=frozenset(name for room, name in zip(rooms, ids) if room is None),
        lost_ground=tuple(
            shapely.MultiPoint([move(point) for point in entry.polygon]).convex_hull
            for entry, room in zip(floor.rooms, rooms)
            if room is None and entry.polygon
        ),
    )


def _origins(floor: PlanFloor, ids: Sequence[str], move: Callable[[Point], Point]) -> Iterator[Origin]:
    """Yield where the file has what it names the places of."""
    for room, name in zip(floor.rooms, ids):
        if room.source:
            place = move(room.polygon[0]) if room.polygon else None
            yield Origin(floor.floor, room.name or room.id or room.type or name, place, room.source)
    openings: list[tuple[str, PlanDoor | PlanWindow]] = [("door", door) for door in (*floor.doors, *floor.openings)]
    openings += [("window", window) for window in floor.windows]
    for kind, opening in openings:
        if opening.source:
            (ax, ay), (bx, by) = opening.segment or ((opening.at or (0.0, 0.0)),) * 2
            placed = opening.segment is not None or opening.at is not None
            (x0, y0), (x1, y1) = move((ax, ay)), move((bx, by))
            yield Origin(floor.floor, kind, ((x0 + x1) / 2, (y0 + y1) / 2) if placed else None, opening.source)


def _leafless(opening: PlanDoor) -> PlanDoor:
    placed = opening.segment is not None or opening.at is not None or opening.width is not None
    fields = {name: getattr(opening, name) for name in PlanDoor.__struct_fields__}
    return PlanDoor(**(fields | {"kind": opening.kind or ("doorway" if placed else "open")}))


def _moved(door: PlanDoor, move: Callable[[Point], Point], scale: float) -> PlanDoor:
    return PlanDoor(
        rooms=door.rooms,
        segment=None if door.segment is None else (move(door.segment[0]), move(door.segment[1])),
        at=None if door.at is None else move(door.at),
        width=None if door.width is None else door.width * scale,
        kind=door.kind,
    )


def _moved_window(window: PlanWindow, move: Callable[[Point], Point], scale: float) -> PlanWindow:
    return PlanWindow(
        segment=None if window.segment is None else (move(window.segment[0]), move(window.segment[1])),
        at=None if window.at is None else move(window.at),
        width=None if window.width is None else window.width * scale,
        sill=None if window.sill is None else window.sill * scale,
        height=None if window.height is None else window.height * scale,
    )


def _ids(floor: PlanFloor, findings: Findings) -> list[str]:
    """Return an id for each room: its own, else its name's, numbered where several rooms of the floor have it."""
    stated = Counter(room.id for room in floor.rooms if room.id)
    for name, count in stated.items():
        if count > 1:
            findings.fault(floor.floor, name, f"{count} rooms have this id")
    wished = [slug(room.id or room.name or room.type) or "room" for room in floor.rooms]
    counts = Counter(wished)
    taken = {name for name, count in counts.items() if count == 1}
    ids = []
    for name in wished:
        if counts[name] > 1:
            name = next(free for n in range(1, len(wished) + 2) if (free := f"{name}_{n}") not in taken)
            taken.add(name)
        ids.append(name)
    return ids


def _room(
    number: int, room: PlanRoom, name: str, move: Callable[[Point], Point], knowledge: KnowledgeBase, findings: Findings
) -> StoreyRoom | None:
    called = room.name or room.id or room.type or name
    core = core_kind(room.name or room.id, room.type, knowledge)
    kind = room_kind(room.name or room.id, room.type, knowledge)
    shape = None
    if room.polygon:
        shape = _shape(number, called, room.polygon, room.holes, move, findings)
        if shape is None:
            return None
    elif room.area is None:
        findings.fault(number, called, "has neither a polygon nor an area")
        return None
    area = shape.area if shape is not None else (room.area or 0.0)
    return StoreyRoom(name, called, kind.type, core, shape, round(area, 4), known=kind.known or bool(core))


def _shape(
    number: int,
    name: str,
    ring: Sequence[Point],
    holes: Sequence[Sequence[Point]],
    move: Callable[[Point], Point],
    findings: Findings,
) -> Polygon | None:
    """Return the polygon of rings, or ``None`` with the fault told."""
    rings = [_without_repeats([move(point) for point in each]) for each in (ring, *holes)]
    for points in rings:
        if len(points) < 3:
            findings.fault(number, name, f"a ring of {len(points)} corners; at least three are needed", points[0])
            return None
        alone = Polygon(points)
        if not alone.is_valid:
            place = shapely.get_coordinates(alone)[0]
            reason = shapely.is_valid_reason(alone)
            if "[" in reason:
                x, y = reason.split("[", 1)[1].rstrip("]").split()[:2]
                place = (float(x), float(y))
            findings.fault(number, name, "its boundary crosses or touches itself", (float(place[0]), float(place[1])))
            return None
    shape = Polygon(rings[0], rings[1:])
    point = shape.representative_point()
    if not shape.is_valid:
        findings.fault(number, name, "its holes must lie inside it, apart from each other", (point.x, point.y))
        return None
    if not _LEAST_AREA <= shape.area <= MAX_FLOOR_AREA:
        limits = f"{_LEAST_AREA} to {MAX_FLOOR_AREA:.0f} m2 are built"
        findings.fault(number, name, f"an area of {shape.area:.3g} m2; {limits}", (point.x, point.y))
        return None
    return orient(shape)


def _without_repeats(ring: Sequence[Point]) -> list[Point]:
    return [point for k, point in enumerate(ring) if math.dist(point, ring[k - 1]) > 1e-4]
