"""Count which facts of a brief a finished building meets, read from its layouts rather than from its program.

A fact is one line of text::

    floors=4   basements=1   type=office   style=modern   method=stair   area=1200   floor_area=400
    shape=L    copy=3-8      setback       absent garage  adjacent kitchen dining_room
    material floor oak       error=CONTRADICTION
    room meeting_room [x2] [@3] [40m2]     named cipher_room [@2]

``x`` counts the rooms (at least one without it), ``@`` pins them to a storey, ``m2`` is the area of each within 15%.
"""

import re
from collections.abc import Callable
from dataclasses import dataclass

from shapely.geometry import Polygon
from shapely.ops import unary_union

from mansion_msgs_py.layout import FloorLayout
from mansion_msgs_py.stages import PlanReply

__all__ = ["FactResult", "FinishedRoom", "finished_rooms", "score_building"]

_ROOM = re.compile(
    r"^(?P<kind>room|named) (?P<name>\w+)(?: x(?P<count>\d+))?(?: @(?P<floor>-?\d+))?(?: (?P<area>[\d.]+)m2)?$"
)
_VERTICES = {"L": 6, "T": 8, "U": 8, "H": 12, "rectangle": 4}
AREA_TOLERANCE = 0.15


@dataclass(frozen=True)
class FactResult:
    """A fact, whether the building meets it, and what was found."""

    fact: str
    met: bool
    found: str


@dataclass(frozen=True)
class FinishedRoom:
    """A room of the finished building: its polygon, with the type of its node."""

    floor: int
    id: str
    room_type: str
    shape: Polygon


def finished_rooms(reply: PlanReply, layouts: list[FloorLayout]) -> list[FinishedRoom]:
    """Return the rooms that the layouts hold."""
    rooms = []
    for topology, layout in zip(reply.topologies, layouts):
        types = {node.id: node.room_type for node in topology.nodes}
        for room in layout.rooms:
            shape = Polygon(room.polygon, room.holes)
            if shape.area > 0.5:
                rooms.append(FinishedRoom(topology.floor, room.id, types.get(room.id, ""), shape))
    return rooms


def score_building(facts: list[str], reply: PlanReply, layouts: list[FloorLayout]) -> list[FactResult]:
    """Check each fact against the finished building.

    Parameters
    ----------
    facts : list of str
        Lines of the form that this module describes.
    reply : PlanReply
        For node types, storeys, cores and materials.
    layouts : list of FloorLayout
        One for each floor, in the order of the program.

    Raises
    ------
    ValueError
        A fact has none of the forms.
    """
    rooms = finished_rooms(reply, layouts)
    return [FactResult(fact, *_check(fact, reply, layouts, rooms)) for fact in facts]


def _check(fact: str, reply: PlanReply, layouts: list[FloorLayout], rooms: list[FinishedRoom]) -> tuple[bool, str]:
    match = _ROOM.match(fact)
    if match is not None:
        return _room(match, rooms)
    if fact.startswith("absent "):
        found = [room.id for room in rooms if room.room_type == fact.split()[1]]
        return not found, ", ".join(found)
    if fact.startswith("adjacent "):
        return _adjacent(*fact.split()[1:], rooms=rooms)
    if fact.startswith("material "):
        return _material(*fact.split()[1:], reply=reply)
    if fact == "setback":
        areas = [_area(layout) for floor, layout in zip(reply.program.floors, layouts) if floor.index >= 1]
        return areas[-1] < 0.97 * areas[0], ", ".join(f"{area:.0f} m2" for area in areas)
    key, _, value = fact.partition("=")
    checks: dict[str, Callable[[], tuple[bool, str]]] = {
        "floors": lambda: _floors(value, rooms),
        "basements": lambda: _basements(value, rooms),
        "type": lambda: (value in (reply.program.building_type, reply.program.kind), reply.program.building_type),
        "style": lambda: (reply.program.style == value, reply.program.style),
        "method": lambda: _method(value, reply),
        "area": lambda: _total(float(value), reply),
        "floor_area": lambda: _floor_area(float(value), reply),
        "shape": lambda: _shape(value, reply, layouts),
        "copy": lambda: _copy(value, reply, layouts),
        "error": lambda: (False, "a building"),
    }
    if key not in checks:
        raise ValueError(f"{fact!r} is not a fact that can be checked")
    return checks[key]()


def _room(match: "re.Match[str]", rooms: list[FinishedRoom]) -> tuple[bool, str]:
    name, by_name = match["name"], match["kind"] == "named"
    chosen = [r for r in rooms if (r.id.startswith(name) if by_name else r.room_type == name)]
    if match["floor"] is not None:
        chosen = [room for room in chosen if room.floor == int(match["floor"])]
    elif not by_name and not chosen:
        chosen = []
    found = f"{len(chosen)}: " + ", ".join(f"F{r.floor}/{r.id} {r.shape.area:.0f}" for r in chosen[:6])
    count = match["count"]
    met = bool(chosen) if count is None else len(chosen) == int(count)
    if match["area"] is not None:
        area = float(match["area"])
        near = [r for r in chosen if abs(r.shape.area - area) <= AREA_TOLERANCE * area]
        met = met and len(near) >= int(count or 1)
    return met, found


def _adjacent(first: str, second: str, *, rooms: list[FinishedRoom]) -> tuple[bool, str]:
    pairs = [
        (a, b) for a in rooms for b in rooms if (a.room_type, b.room_type) == (first, second) and a.floor == b.floor
    ]
    shared = max((a.shape.buffer(0.01).intersection(b.shape).length / 2 for a, b in pairs), default=0.0)
    return shared >= 0.3, f"{shared:.1f} m of shared wall"


def _material(surface: str, text: str, *, reply: PlanReply) -> tuple[bool, str]:
    rooms = [room for floor in reply.program.floors for room in floor.rooms]
    found = {room.floor_material if surface == "floor" else room.wall_material for room in rooms}
    return any(text in material for material in found), "; ".join(sorted(found))


def _floors(value: str, rooms: list[FinishedRoom]) -> tuple[bool, str]:
    count = len({room.floor for room in rooms if room.floor >= 1})
    return count == int(value), str(count)


def _basements(value: str, rooms: list[FinishedRoom]) -> tuple[bool, str]:
    count = len({room.floor for room in rooms if room.floor < 1})
    return count == int(value), str(count)


def _method(value: str, reply: PlanReply) -> tuple[bool, str]:
    kinds = sorted({core.type for core in reply.program.vertical_connectivity.cores})
    expected = {"none": [], "stair": ["stair"], "elevator": ["elevator"]}.get(value, ["elevator", "stair"])
    return kinds == expected, ", ".join(kinds)


def _area(layout: FloorLayout) -> float:
    return float(sum(Polygon(room.polygon, room.holes).area for room in layout.rooms))


def _total(value: float, reply: PlanReply) -> tuple[bool, str]:
    total = sum(Polygon(p.boundary, p.holes).area for p in reply.problems)
    return abs(total - value) <= 0.06 * value, f"{total:.0f} m2"


def _floor_area(value: float, reply: PlanReply) -> tuple[bool, str]:
    areas = [Polygon(p.boundary, p.holes).area for p in reply.problems]
    return all(abs(area - value) <= 0.06 * value for area in areas), ", ".join(f"{a:.0f}" for a in areas)


def _shape(value: str, reply: PlanReply, layouts: list[FloorLayout]) -> tuple[bool, str]:
    parts = [Polygon(room.polygon, room.holes).buffer(0.01, join_style="mitre") for room in layouts[0].rooms]
    parts += [Polygon(core.polygon).buffer(0.01, join_style="mitre") for core in reply.problems[0].cores]
    outline = unary_union(parts).buffer(-0.01, join_style="mitre").simplify(0.05)
    if outline.geom_type != "Polygon":
        return False, "the rooms are not connected"
    holes = [hole for hole in outline.interiors if Polygon(hole).area > 4]
    corners = len(outline.exterior.coords) - 1
    if value == "courtyard":
        return bool(holes), f"{len(holes)} courtyards"
    return corners == _VERTICES[value] and not holes, f"{corners} corners"


def _copy(value: str, reply: PlanReply, layouts: list[FloorLayout]) -> tuple[bool, str]:
    first, last = (int(part) for part in value.split("-"))
    by_floor = {floor.index: floor for floor in reply.program.floors}
    marked = all(by_floor[k].copy == first for k in range(first + 1, last + 1) if k in by_floor)
    del layouts
    return marked, str([by_floor[k].copy for k in range(first, last + 1) if k in by_floor])
