"""Stairs and lifts of a plan: rooms that lie above one another on all floors, as the cores of the building."""

from collections.abc import Sequence
from dataclasses import dataclass, replace

import shapely
from shapely.geometry import Polygon, box

from mansion_geometry.dog_legs import dog_leg, landing_depth
from mansion_geometry.wall_sizes import CLEAR_WIDTH, INTERIOR_THICKNESS, MIN_CLEAR_WIDTH
from mansion_knowledge import KnowledgeBase
from mansion_msgs_py.program import CorePlan
from mansion_msgs_py.shapes import CompassSide, Segment
from mansion_planner.given_plan.faults import Findings
from mansion_planner.given_plan.storey_walls import StoreyWall
from mansion_planner.given_plan.storeys import PlanStorey, StoreyRoom

__all__ = ["CoreDoor", "core_boxes", "landing_door", "landing_of", "stair_height", "with_cores"]

_SAME = 0.5  # share of their area in which two cores overlap in plan
_SHIFT = 0.3  # metres by which they may be drawn apart
_SNAP = 2e-3
_SHAFT = 1.1
_RECTANGLE = 0.98
_HEIGHTS = (3.0, 2.8, 2.65)
"""Storey heights to choose from where a stair is too short for the usual one, metres."""


@dataclass(frozen=True)
class _Stack:
    """Rooms of one core, by floor."""

    id: str
    kind: str
    rooms: dict[int, StoreyRoom]


def with_cores(storeys: Sequence[PlanStorey], knowledge: KnowledgeBase, findings: Findings) -> list[PlanStorey]:
    """Return the storeys with one id and one box for each core.

    On a single storey a stair or a lift leads nowhere, and is a hallway.
    """
    if len(storeys) == 1:
        return [_without_cores(storeys[0], knowledge, findings)]
    stacks = _stacks(storeys, findings)
    if not stacks and not any(storey.lost for storey in storeys):
        message = "nothing joins its floors: each needs a room of type stairs or elevator at the same place"
        findings.fault(None, "", message)
    result = list(storeys)
    for stack in stacks:
        core = _core_box(stack, findings)
        if core is not None:
            result = [_with_core(storey, stack, core) for storey in result]
    return result


def _without_cores(storey: PlanStorey, knowledge: KnowledgeBase, findings: Findings) -> PlanStorey:
    rooms = []
    for room in storey.rooms:
        if room.core:
            findings.note(storey.index, room.name, "a hallway", "there is no other floor that it could lead to")
            room = replace(room, core="", type=knowledge.room("hallway"))
        rooms.append(room)
    return replace(storey, rooms=rooms)


def _stacks(storeys: Sequence[PlanStorey], findings: Findings) -> list[_Stack]:
    stacks: list[_Stack] = []
    for storey in storeys:
        for room in storey.rooms:
            if not room.core:
                continue
            if room.shape is None:
                findings.fault(storey.index, room.name, "a stair or a lift needs a polygon")
                continue
            above = [s for s in stacks if s.kind == room.core and _over(room, next(iter(s.rooms.values())))]
            if above:
                above[0].rooms[storey.index] = room
            else:
                number = sum(s.kind == room.core for s in stacks) + 1
                stacks.append(_Stack(f"{room.core}_{number}", room.core, {storey.index: room}))
    for stack in stacks:
        lacking = [storey.index for storey in storeys if storey.index not in stack.rooms]
        room = next(iter(stack.rooms.values()))
        if lacking:
            where = ", ".join(str(n) for n in lacking)
            findings.fault(
                next(iter(stack.rooms)), room.name,
                f"nothing lies over it on floor {where}: stairs and lifts go through all floors", room.place,
            )  # fmt: skip
    return stacks


def _over(room: StoreyRoom, other: StoreyRoom) -> bool:
    if room.shape is None or other.shape is None:
        return False
    return bool(room.shape.intersection(other.shape).area > _SAME * max(room.shape.area, other.shape.area))


def _core_box(stack: _Stack, findings: Findings) -> tuple[float, float, float, float] | None:
    """Return the box of a core on its lowest floor; the others must have it there too."""
    core: tuple[float, float, float, float] | None = None
    sound = True
    for floor, room in stack.rooms.items():
        shape = room.shape
        assert shape is not None
        x0, y0, x1, y1 = (round(float(value), 4) for value in shape.bounds)
        if shape.area < _RECTANGLE * box(x0, y0, x1, y1).area:
            findings.fault(floor, room.name, "must be a rectangle along the walls, as stairs and lifts are", room.place)
            sound = False
        elif core is None:
            core = (x0, y0, x1, y1)
        elif max(abs(a - b) for a, b in zip(core, (x0, y0, x1, y1))) > _SHIFT:
            findings.fault(floor, room.name, "is not at the same place as on the floor below", room.place)
            sound = False
    if core is None or not sound:
        return None
    floor, room = next(iter(stack.rooms.items()))
    if stack.kind == "elevator" and min(core[2] - core[0], core[3] - core[1]) < _SHAFT:
        findings.fault(floor, room.name, f"a lift needs {_SHAFT} x {_SHAFT} m between wall centre lines", room.place)
        return None
    return core


def _with_core(storey: PlanStorey, stack: _Stack, core: tuple[float, float, float, float]) -> PlanStorey:
    """Give a core its box on a storey; rooms beside it follow where the box differs from what is drawn there."""
    room = stack.rooms.get(storey.index)
    if room is None or room.shape is None:
        return storey
    drawn = room.shape.bounds
    shapes: list[Polygon | None] = [each.shape for each in storey.rooms]
    for axis in (0, 1):
        for old, new in ((drawn[axis], core[axis]), (drawn[axis + 2], core[axis + 2])):
            if abs(old - new) > 1e-6:
                shapes = [shape and _shifted(shape, axis, float(old), new) for shape in shapes]
    rooms = storey.with_shapes(shapes).rooms
    rooms = [
        replace(each, id=stack.id, shape=box(*core)) if before.id == room.id else each
        for each, before in zip(rooms, storey.rooms)
    ]
    names = {word: [stack.id if name == room.id else name for name in found] for word, found in storey.names.items()}
    return replace(storey, rooms=rooms, names=names)


def _shifted(shape: Polygon, axis: int, old: float, new: float) -> Polygon:
    """Move the walls of a room that lie on a line across an axis."""
    points = shapely.get_coordinates(shape)
    points[abs(points[:, axis] - old) < _SNAP, axis] = new
    return shapely.set_coordinates(shapely.from_wkb(shapely.to_wkb(shape)), points)


def core_boxes(storey: PlanStorey) -> list[CorePlan]:
    """Return the cores of a storey as the program has them."""
    found = []
    for room in storey.rooms:
        if room.core and room.shape is not None:
            x0, y0, x1, y1 = (round(float(value), 4) for value in room.shape.bounds)
            kind = "stair" if room.core == "stair" else "elevator"
            found.append(CorePlan(id=room.id, type=kind, x=(x0, x1), y=(y0, y1)))  # type: ignore[arg-type]
    return found


def _inside(core: CorePlan) -> tuple[float, float]:
    """Return length and width of a core inside its walls."""
    sides = sorted((core.x[1] - core.x[0], core.y[1] - core.y[0]))
    return sides[1] - INTERIOR_THICKNESS, sides[0] - INTERIOR_THICKNESS


def stair_height(core: CorePlan, usual: float, stated: float | None) -> float | None:
    """Return the height of a storey that a stair climbs: the stated one, else the usual or a lower one."""
    for height in (stated,) if stated is not None else (usual, *(h for h in _HEIGHTS if h < usual)):
        if dog_leg(*_inside(core), height) is not None:
            return height
    return None


@dataclass(frozen=True)
class CoreDoor:
    """The door of a stair on one floor: the walls that it may stand in, and where the plan has it, if it says."""

    floor: int
    walls: Sequence[StoreyWall]
    segment: Segment | None


def landing_of(core: CorePlan, doors: Sequence[CoreDoor]) -> CorePlan:
    """Return a stair that says at which end its landings are: where its doors on all floors open on to them.

    Where both ends qualify, the one nearer to the doors of the plan is taken.
    """
    if core.type != "stair" or not doors:
        return core
    ends: tuple[CompassSide, CompassSide] = ("south", "north") if _along_y(core) else ("west", "east")
    axis = 1 if _along_y(core) else 0
    low, high = core.y if axis else core.x
    middles = [(d.segment[0][axis] + d.segment[1][axis]) / 2 for d in doors if d.segment is not None]

    def rank(end: CompassSide) -> tuple[float, float]:
        fitting = min(max((b - a for _, a, b in _on_landing(core, end, d.walls)), default=0.0) for d in doors)
        edge = low if end in ("south", "west") else high
        return round(min(fitting, CLEAR_WIDTH), 3), -sum(abs(middle - edge) for middle in middles)

    best = max(ends, key=rank)
    return CorePlan(id=core.id, type=core.type, x=core.x, y=core.y, landing=best)


def _along_y(core: CorePlan) -> bool:
    return core.y[1] - core.y[0] >= core.x[1] - core.x[0]


def _on_landing(core: CorePlan, end: CompassSide, walls: Sequence[StoreyWall]) -> list[tuple[StoreyWall, float, float]]:
    """Return the pieces of walls through which a door opens on to the floor landing at an end of a stair."""
    length, _ = _inside(core)
    depth = landing_depth(length) + INTERIOR_THICKNESS / 2
    (x0, x1), (y0, y1) = core.x, core.y
    zones: dict[CompassSide, tuple[float, float, float, float]] = {
        "south": (x0, y0, x1, y0 + depth),
        "north": (x0, y1 - depth, x1, y1),
        "west": (x0, y0, x0 + depth, y1),
        "east": (x1 - depth, y0, x1, y1),
    }
    zone = box(*zones[end]).buffer(_SNAP, join_style="mitre")
    pieces = []
    for wall in walls:
        part = shapely.LineString([wall.start, wall.end]).intersection(zone)
        if part.geom_type == "LineString" and part.length > 0.1:
            along = sorted(wall.along((float(x), float(y))) for x, y in part.coords)
            low, high = max(along[0], wall.low), min(along[-1] - _SNAP, wall.high)
            if high > low:
                pieces.append((wall, low, high))
    return pieces


def landing_door(core: CorePlan, door: CoreDoor, width: float) -> Segment | None:
    """Return where the door of a stair stands so that it opens on to the landing; ``None`` where no wall is there.

    It is nearest to where the plan has it, else in the middle of the longest piece of wall.
    """
    pieces = [
        (w, a, b) for w, a, b in _on_landing(core, core.landing or "south", door.walls) if b - a >= MIN_CLEAR_WIDTH
    ]
    if not pieces:
        return None
    if door.segment is None:
        wall, low, high = max(pieces, key=lambda piece: round(piece[2] - piece[1], 3))
        middle = (low + high) / 2
    else:
        (ax, ay), (bx, by) = door.segment
        drawn = ((ax + bx) / 2, (ay + by) / 2)
        wall, low, high = min(pieces, key=lambda piece: round(piece[0].distance(drawn), 3))
        middle = wall.along(drawn)
    width = min(width, high - low)
    start = min(max(middle - width / 2, low), high - width)
    return wall.at(start, start + width)
