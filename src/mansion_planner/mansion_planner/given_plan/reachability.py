"""Whether everything on a floor can be reached, and the doors that are added where that is asked for."""

from collections.abc import Mapping, Sequence
from typing import TypeAlias

import networkx as nx

from mansion_geometry.wall_sizes import CLEAR_WIDTH
from mansion_knowledge import is_class
from mansion_msgs_py.openings import GivenDoor
from mansion_msgs_py.program import GROUND_FLOOR
from mansion_planner.given_plan.faults import Findings
from mansion_planner.given_plan.storeys import PlanStorey, StoreyRoom

__all__ = ["WallRoom", "complete_doors", "entrance_of", "main_room", "report_unreached"]

WallRoom: TypeAlias = Mapping[frozenset[str | None], float]
"""Metres of wall that a door may take, between two rooms or a room and the outside."""

_LAST = 9
_COMPLETE = '"complete": ["doors"] (--complete doors) adds one'


def entrance_of(doors: Sequence[GivenDoor]) -> str | None:
    """Return the room of the first outer door that people use; ``None`` where there is none."""
    return next((door.rooms[0] for door in doors if door.rooms[1] is None and door.kind != "garage"), None)


def main_room(storey: PlanStorey, doors: Sequence[GivenDoor]) -> StoreyRoom:
    """Return the room that a floor is walked from: the one with most doors, those that people pass through first."""
    count = {room.id: 0 for room in storey.rooms}
    for door in doors:
        for name in door.rooms:
            if name in count:
                count[name] += 1
    entered = entrance_of(doors)

    def rank(room: StoreyRoom) -> tuple[bool, bool, int, float]:
        passing = is_class(room.type.name, "circulation") and count[room.id] > 1
        return passing, not _is_bad_passage(room), count[room.id] + 2 * (room.id == entered), room.area

    return max((room for room in storey.rooms if not room.core), key=rank)


def _is_bad_passage(room: StoreyRoom) -> bool:
    return any(is_class(room.type.name, name) for name in ("outdoor", "wet", "store", "vehicle"))


def _graph(storey: PlanStorey, doors: Sequence[GivenDoor]) -> "nx.Graph[str]":
    """Return which rooms open to which; nobody walks through a core."""
    graph: nx.Graph[str] = nx.Graph()
    graph.add_nodes_from([*(room.id for room in storey.rooms if not room.core), *sorted(filter(None, storey.lost))])
    cores = {room.id for room in storey.rooms if room.core}
    pairs = [door.rooms for door in doors if door.rooms[1] is not None]
    graph.add_edges_from((a, b) for a, b in pairs if a not in cores and b not in cores)
    return graph


def _starts(storey: PlanStorey, doors: Sequence[GivenDoor]) -> list[str]:
    """Return the rooms that a floor is entered by: from outside, from stairs and lifts."""
    cores = {room.id for room in storey.rooms if room.core}
    found = [door.rooms[0] for door in doors if door.rooms[1] is None and door.kind != "garage"]
    if storey.index != GROUND_FLOOR:
        found = []
    for door in doors:
        a, b = door.rooms
        if b is not None and (a in cores) != (b in cores):
            found.append(b if a in cores else a)
    return found


def _reached(storey: PlanStorey, doors: Sequence[GivenDoor]) -> set[str]:
    graph = _graph(storey, doors)
    starts = _starts(storey, doors) or [main_room(storey, doors).id]
    if storey.index == GROUND_FLOOR and (entered := entrance_of(doors)) is not None:
        starts = [entered]
    reached: set[str] = set()
    for start in starts[:1]:
        reached |= nx.node_connected_component(graph, start)
    cores = {room.id for room in storey.rooms if room.core}
    for a, b in (door.rooms for door in doors if door.rooms[1] is not None):
        if a in cores and b in reached:
            reached.add(a)
        elif b in cores and a in reached:
            reached.add(b or "")
    return reached


def report_unreached(storey: PlanStorey, doors: Sequence[GivenDoor], findings: Findings) -> None:
    """Report a ground floor without an entrance, rooms that cannot be reached, and cores with several doors."""
    if storey.index == GROUND_FLOOR and entrance_of(doors) is None:
        findings.fault(storey.index, "", f"has no entrance: no door leads from a room to the outside; {_COMPLETE}")
    reached = _reached(storey, doors)
    own = {name for door in doors for name in door.rooms}
    for room in storey.rooms:
        if room.id not in reached:
            why = "the rooms behind its doors are cut off too" if room.id in own else "it has no door"
            findings.fault(storey.index, room.name, f"cannot be reached: {why}; {_COMPLETE}", room.place)
    for core in (room for room in storey.rooms if room.core):
        leading = [door for door in doors if core.id in door.rooms]
        if len(leading) > 1 or any(None in door.rooms for door in leading):
            findings.fault(
                storey.index,
                core.name,
                "opens by one door to one room of each floor, and not to the outside",
                core.place,
            )


def complete_doors(
    storey: PlanStorey, doors: Sequence[GivenDoor], walls: WallRoom, findings: Findings
) -> list[GivenDoor]:
    """Return the doors of a floor with those that it needs so that all of it is reached, each of them noted."""
    made = list(doors)
    if storey.index == GROUND_FLOOR and entrance_of(made) is None:
        made += _entrance(storey, made, walls, findings)
    while True:
        reached = _reached(storey, made)
        rooms = {room.id: room for room in storey.rooms}
        choices = [
            (_cost(rooms[lost], rooms[other]), -round(walls[frozenset((lost, other))], 3), lost, other)
            for pair in walls
            if None not in pair
            for lost, other in (tuple(sorted(map(str, pair))), tuple(sorted(map(str, pair), reverse=True)))
            if lost not in reached and other in reached and not rooms[other].core
        ]
        choices = [entry for entry in choices if -entry[1] >= CLEAR_WIDTH - 1e-3] or choices
        if not choices:
            return made
        _, _, lost, other = min(choices)
        made.append(GivenDoor(rooms=(other, lost)))
        got = f"a door between {rooms[other].name} and {rooms[lost].name} added"
        findings.note(storey.index, f"a way to {rooms[lost].name}", got, "no door of the plan leads there")


def _cost(lost: StoreyRoom, other: StoreyRoom) -> int:
    """Rank a new door: best to where people pass, last to a bathroom, a store or the open air."""
    if is_class(other.type.name, "circulation"):
        rank = 0
    elif is_class(other.type.name, "living"):
        rank = 1
    elif _is_bad_passage(other):
        rank = 6
    else:
        rank = 4 if is_class(other.type.name, "sleeping") else 2
    return rank + (3 if lost.core and rank else 0)


def _entrance(storey: PlanStorey, doors: Sequence[GivenDoor], walls: WallRoom, findings: Findings) -> list[GivenDoor]:
    main = main_room(storey, doors)
    outer = [
        room
        for room in storey.rooms
        if not room.core and walls.get(frozenset((room.id, None)), 0.0) >= CLEAR_WIDTH - 1e-3
    ]
    if not outer:
        return []

    def rank(room: StoreyRoom) -> tuple[int, float]:
        if is_class(room.type.name, "welcome"):
            return 0, -room.area
        if room is main and not _is_bad_passage(room):
            return 1, -room.area
        if is_class(room.type.name, "circulation"):
            return 2, -room.area
        if is_class(room.type.name, "living"):
            return 3, -room.area
        return (_LAST if _is_bad_passage(room) or is_class(room.type.name, "sleeping") else 4), -room.area

    room = min(outer, key=rank)
    findings.note(storey.index, "an entrance", f"a door of {room.name} to the outside added", "no door leads outside")
    return [GivenDoor(rooms=(room.id, None))]
