"""Where the doors and windows of a plan stand on the walls of its storeys."""

import math
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

import shapely

from mansion_geometry.wall_sizes import CLEAR_WIDTH, INTERIOR_THICKNESS, MIN_CLEAR_WIDTH, SHORTEST_WINDOW
from mansion_knowledge import is_class
from mansion_msgs_py.building_plan import PlanDoor, PlanWindow
from mansion_msgs_py.openings import GivenDoor, GivenWindow
from mansion_msgs_py.program import GROUND_FLOOR
from mansion_msgs_py.shapes import Point, Segment
from mansion_msgs_py.wording import choices
from mansion_planner.given_plan.faults import Findings
from mansion_planner.given_plan.storey_walls import StoreyWall
from mansion_planner.given_plan.storeys import PlanStorey
from mansion_planner.given_plan.wall_lines import THICKEST_WALL

__all__ = ["OUTSIDE", "doors_between", "placed_doors", "placed_windows"]

OUTSIDE = "outside"
"""What a door of a plan calls the outside."""

_NEAR = THICKEST_WALL
"""Metres from a wall at which a door may be drawn."""

_WINDOW = 1.2
_GARAGE = 2.4
_ROUNDING = 1e-3


@dataclass(frozen=True)
class _Place:
    """A door on a wall, between two distances from its start."""

    wall: StoreyWall
    low: float
    high: float


def doors_between(storey: PlanStorey, findings: Findings) -> list[tuple[PlanDoor, list[str | None] | None]]:
    """Return each door with the ids of what it says that it joins; ``None`` where it says nothing, or what is wrong."""
    return [(door, _sides(storey, door, findings)) for door in storey.doors]


def _sides(storey: PlanStorey, door: PlanDoor, findings: Findings) -> list[str | None] | None:
    sides: list[str | None] = []
    for name in door.rooms:
        if name.casefold() == OUTSIDE:
            sides.append(None)
            continue
        found = storey.names.get(name.casefold(), [])
        if len(found) == 1:
            sides.append(found[0])
            continue
        if found:
            message = f"{name!r} is the name of {len(found)} rooms; name it by its id: {', '.join(found)}"
        else:
            known = [room.name for room in storey.rooms] + [OUTSIDE]
            message = f"there is no room {name!r} on this floor; {choices(name, known, 'rooms')}"
        findings.fault(storey.index, "door", message, _middle(door))
        return None
    if len(sides) == 2 and sides[0] == sides[1]:
        findings.fault(storey.index, "door", f"joins {door.rooms[0]} with itself", _middle(door))
        return None
    return sides


def _middle(door: PlanDoor) -> Point | None:
    if door.segment is not None:
        (ax, ay), (bx, by) = door.segment
        return (ax + bx) / 2, (ay + by) / 2
    return door.at


def placed_doors(
    storey: PlanStorey, walls: Sequence[StoreyWall], findings: Findings
) -> tuple[list[GivenDoor], list[GivenDoor]]:
    """Return the doors of a drawn storey, those with a place on their walls, and the doors that cannot be built.

    The reasons go to `findings`, except for doors of rooms whose own fault is reported already.
    """
    given: list[GivenDoor] = []
    failed: list[GivenDoor] = []
    taken: list[_Place] = []
    for door, sides in doors_between(storey, findings):
        if sides is None:
            continue
        middle = _middle(door)
        unsure = len(sides) < 2 and middle is not None and storey.beside_lost(middle)
        if unsure or not storey.lost.isdisjoint(sides):
            failed += _failed(sides)
            continue
        if middle is None or door.kind == "open":
            made = list(_unplaced(storey, door, sides, walls, findings))
            given += made
            failed += [] if made else _failed(sides)
            continue
        place = _place(storey, door, middle, sides, walls, findings)
        if place is None:
            failed += _failed(sides)
            continue
        clash = next((o for o in taken if o.wall is place.wall and o.low < place.high and place.low < o.high), None)
        if clash is not None:
            findings.fault(storey.index, _label(storey, place.wall), "two doors overlap", middle)
            continue
        taken.append(place)
        if _leads_nowhere(storey, place.wall):
            room = storey.room(place.wall.left).name
            findings.note(storey.index, f"door from {room} to the outside", "none", "the floor is not at the ground")
            continue
        given.append(_given(storey, door, place))
    return given, failed


def _failed(sides: Sequence[str | None]) -> list[GivenDoor]:
    """Return a door that cannot be built, by what it was to join, if that is known."""
    named = [side for side in sides if side is not None]
    if len(sides) < 2 or not named:
        return []
    return [GivenDoor(rooms=(named[0], named[1] if len(named) > 1 else None))]


def _leads_nowhere(storey: PlanStorey, wall: StoreyWall) -> bool:
    return wall.right is None and storey.index != GROUND_FLOOR


def _given(storey: PlanStorey, door: PlanDoor, place: _Place) -> GivenDoor:
    rooms = (place.wall.left, place.wall.right)
    kind = door.kind
    if rooms[1] is None:
        drives = door.kind == "garage" or is_class(storey.room(rooms[0]).type.name, "vehicle")
        kind = "garage" if drives and place.high - place.low >= _GARAGE - _ROUNDING else None
    elif kind == "garage":
        kind = None
    return GivenDoor(rooms=rooms, segment=place.wall.at(place.low, place.high), kind=kind)


def _label(storey: PlanStorey, wall: StoreyWall) -> str:
    return f"door between {_called(storey, wall.left)} and {_called(storey, wall.right)}"


def _called(storey: PlanStorey, name: str | None) -> str:
    return "the outside" if name is None else storey.room(name).name


def _unplaced(
    storey: PlanStorey, door: PlanDoor, sides: Sequence[str | None], walls: Sequence[StoreyWall], findings: Findings
) -> Iterator[GivenDoor]:
    """Yield a door without a place, where a wall of its two sides takes it."""
    if len(sides) < 2:
        findings.fault(storey.index, "door", "says neither where it is nor which two rooms it joins")
        return
    if all(side is None for side in sides):
        return
    first, second = sides if sides[0] is not None else (sides[1], sides[0])
    assert first is not None
    between = f"door between {_called(storey, first)} and {_called(storey, second)}"
    if second is None and storey.index != GROUND_FLOOR:
        findings.note(storey.index, between, "none", "the floor is not at the ground")
        return
    shared = [wall for wall in walls if wall.rooms == {first, second}]
    if not shared:
        findings.fault(storey.index, between, "they share no wall", storey.room(first).place)
        return
    width = door.width or (CLEAR_WIDTH if second is None else MIN_CLEAR_WIDTH)
    longest = max(shared, key=lambda wall: wall.room)
    if door.kind != "open" and longest.room < min(width, MIN_CLEAR_WIDTH) - _ROUNDING:
        findings.fault(storey.index, between, _too_short(longest), longest.start)
        return
    if door.width is not None and door.width < MIN_CLEAR_WIDTH - _ROUNDING:
        findings.fault(storey.index, between, _too_narrow(door.width), longest.start)
        return
    yield GivenDoor(rooms=(first, second), width=door.width, kind=None if second is None else door.kind)


def _too_short(wall: StoreyWall) -> str:
    length = math.dist(wall.start, wall.end)
    least = MIN_CLEAR_WIDTH + length - wall.room
    return f"their wall is {length:.2f} m long; a door of {MIN_CLEAR_WIDTH} m needs {least:.2f} m of it"


def _too_narrow(width: float) -> str:
    return f"a clear width of {width:.2f} m; at least {MIN_CLEAR_WIDTH} m are needed to get through"


def _place(
    storey: PlanStorey,
    door: PlanDoor,
    middle: Point,
    sides: Sequence[str | None],
    walls: Sequence[StoreyWall],
    findings: Findings,
) -> _Place | None:
    """Return where a door is on the wall of its sides that is nearest to where it is drawn."""
    fitting = [wall for wall in walls if set(sides) <= wall.rooms]
    along = [wall for wall in fitting if door.segment is None or _runs_along(wall, door.segment)]
    if not along:
        named = " and ".join(_called(storey, side) for side in sides)
        message = f"there is no wall between {named or 'two rooms'} that runs along it"
        findings.fault(storey.index, "door", message, middle)
        return None
    wall = min(along, key=lambda each: (round(each.distance(middle), 3), -each.room))
    distance = wall.distance(middle)
    if distance > _NEAR:
        named = " and ".join(_called(storey, side) for side in sides) or "any room"
        findings.fault(storey.index, "door", f"is on no wall of {named}: the nearest is {distance:.2f} m away", middle)
        return None
    width = abs(wall.along(door.segment[1]) - wall.along(door.segment[0])) if door.segment else door.width
    width = CLEAR_WIDTH if width is None else round(width, 4)
    if width < MIN_CLEAR_WIDTH - _ROUNDING:
        findings.fault(storey.index, _label(storey, wall), _too_narrow(width), middle)
        return None
    if wall.room < MIN_CLEAR_WIDTH - _ROUNDING:
        findings.fault(storey.index, _label(storey, wall), _too_short(wall), middle)
        return None
    if wall.room < width - _ROUNDING:
        findings.note(
            storey.index, f"{_label(storey, wall)}, {width:.2f} m", f"{wall.room:.2f} m clear", "its wall is not longer"
        )
    width = min(width, wall.room)
    low = min(max(wall.along(middle) - width / 2, wall.low), wall.high - width)
    return _Place(wall, low, low + width)


def _runs_along(wall: StoreyWall, segment: Segment) -> bool:
    (ax, ay), (bx, by) = segment
    length = math.dist(*segment)
    dx, dy = wall.direction
    return length < 1e-6 or abs((bx - ax) * dx + (by - ay) * dy) > 0.9 * length


def placed_windows(
    storey: PlanStorey, walls: Sequence[StoreyWall], doors: Sequence[GivenDoor], findings: Findings
) -> list[GivenWindow]:
    """Return the windows of a drawn storey on its outer walls, clear of the doors there."""
    outdoor = {room.id for room in storey.rooms if is_class(room.type.name, "outdoor")}
    leading_out = [door.segment for door in doors if door.segment is not None and door.rooms[1] is None]
    given = []
    for window in storey.windows:
        middle = window.at if window.segment is None else _middle(PlanDoor(segment=window.segment))
        if middle is None:
            findings.fault(storey.index, "window", "does not say where it is")
            continue
        wall = _outer_wall(storey, walls, window.segment, middle, outdoor, findings)
        if wall is None:
            continue
        low, high = _window_span(wall, window, middle, leading_out)
        if high - low < SHORTEST_WINDOW:
            place = f"window of {_called(storey, wall.left)}"
            findings.fault(storey.index, place, "has no place beside what is there", middle)
            continue
        given.append(GivenWindow(segment=wall.at(low, high), sill=window.sill, height=window.height))
    return _apart(given)


def _outer_wall(
    storey: PlanStorey,
    walls: Sequence[StoreyWall],
    segment: Segment | None,
    middle: Point,
    outdoor: set[str],
    findings: Findings,
) -> StoreyWall | None:
    """Return the outer wall that a window is drawn on, or record why there is none for it."""
    along = [wall for wall in walls if segment is None or _runs_along(wall, segment)]
    near = [wall for wall in along if wall.right is None and wall.distance(middle) <= _NEAR]
    if near:
        wall = min(near, key=lambda each: (round(each.distance(middle), 3), -each.room))
        if wall.left not in outdoor:
            return wall
        place = f"window of {_called(storey, wall.left)}"
        findings.note(storey.index, place, "none", "a parapet stands around what is outdoors")
        return None
    inner = min(along, key=lambda each: (round(each.distance(middle), 3), each.right is not None), default=None)
    if inner is not None and inner.right is not None and {inner.left, inner.right} & outdoor:
        rooms = f"{_called(storey, inner.left)} and {_called(storey, inner.right)}"
        findings.note(storey.index, f"window between {rooms}", "none", "windows are built in outer walls alone")
    elif not storey.beside_lost(middle):
        outer = [wall.distance(middle) for wall in walls if wall.right is None]
        far = f": the nearest is {min(outer):.2f} m away" if outer else ""
        findings.fault(storey.index, "window", f"is on no outer wall{far}", middle)
    return None


def _window_span(wall: StoreyWall, window: PlanWindow, middle: Point, doors: Sequence[Segment]) -> tuple[float, float]:
    """Return the piece of a wall, as distances from its start, that a window takes beside the doors there."""
    segment = window.segment
    width = abs(wall.along(segment[1]) - wall.along(segment[0])) if segment else (window.width or _WINDOW)
    low, high = max(wall.along(middle) - width / 2, wall.low), min(wall.along(middle) + width / 2, wall.high)
    for door in doors:
        low, high = _clear_of(wall, door, low, high)
    return low, high


def _clear_of(wall: StoreyWall, door: Segment, low: float, high: float) -> tuple[float, float]:
    """Return the longer piece of a span beside a door that stands in it."""
    if any(wall.distance(point) > 0.01 for point in door):
        return low, high
    start, end = sorted(wall.along(point) for point in door)
    if end <= low or high <= start:
        return low, high
    return max(((low, start), (end, high)), key=lambda piece: piece[1] - piece[0])


def _apart(windows: Sequence[GivenWindow]) -> list[GivenWindow]:
    """Return windows without those that stand in others."""
    kept: list[GivenWindow] = []
    for window in windows:
        line = shapely.LineString(window.segment)
        if all(shapely.LineString(other.segment).buffer(1e-3).intersection(line).length < 0.05 for other in kept):
            kept.append(window)
    return kept


def wall_room(walls: Sequence[StoreyWall]) -> Mapping[frozenset[str | None], float]:
    """Return how many metres of wall a door may take between each two rooms."""
    room: dict[frozenset[str | None], float] = {}
    for wall in walls:
        room[wall.rooms] = max(room.get(wall.rooms, 0.0), wall.room)
    return room


LEAST_WALL = MIN_CLEAR_WIDTH + INTERIOR_THICKNESS
"""Shortest wall on centre lines that takes a door, metres."""
