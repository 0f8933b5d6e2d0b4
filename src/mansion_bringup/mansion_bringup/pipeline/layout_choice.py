"""Choose among several layouts of a floor the one that falls least short of its plan."""

import re
from collections.abc import Iterator, Mapping

import msgspec
from shapely.geometry import Polygon

from mansion_geometry.randomness import item_seed
from mansion_geometry.shared_walls import edge_array, shared_walls, total_length
from mansion_msgs_py.layout import FloorLayout, FloorProblem
from mansion_msgs_py.program import RoomProgram
from mansion_msgs_py.stages import PlanReply

__all__ = ["Shortfall", "reseeded", "shortfall"]

Shortfall = tuple[bool, float]
"""Whether a room is cut off or of no usable shape, and the square metres that are missed, relations among them."""

RELATION = 0.1
"""Share of a floor that a relation which is not met counts as: areas come before neighbours."""

_KEPT = 0.15
"""Share by which a room's area may differ from the planned one."""

_WALL = 0.3
"""Metres of wall from which on rooms are side by side."""

_GAP = 2e-3
"""Distance, metres, up to which two rooms touch."""

_MOST_TRIES, _ROOMS_TRIED = 8, 110
"""How often a floor is solved again at most, and about how many rooms are placed in all tries: many rooms take long."""


def shortfall(plan: PlanReply, index: int, layout: FloorLayout) -> Shortfall:
    """Return what a layout of the floor at position `index` does not give; rooms that nearly keep their area do."""
    problem = plan.problems[index]
    shapes = {room.id: Polygon(room.polygon, room.holes) for room in layout.rooms if len(room.polygon) > 2}
    wanted = [(node.area, shapes[node.id].area) for node in problem.nodes if node.area and node.id in shapes]
    missed = sum(abs(found - area) for area, found in wanted if abs(found - area) > _KEPT * area)
    asked = [(edge.source, edge.target) for edge in problem.edges if edge.kind == "adjacent"]
    unmet = sum(not _side_by_side(shapes, *pair) for pair in asked)
    unmet += sum(any(_side_by_side(shapes, *pair) for pair in pairs) for pairs in _apart(plan, index))
    floor = sum(node.area or 0.0 for node in problem.nodes)
    broken = any(edge.kind == "access" for edge in layout.unmet_edges)
    broken = broken or any(line.partition(":")[0] in shapes for line in layout.messages)
    return broken, float(missed + RELATION * floor * unmet)


def reseeded(problem: FloorProblem) -> Iterator[FloorProblem]:
    """Yield a problem with other seeds for its random draws."""
    for number in range(1, min(_MOST_TRIES, _ROOMS_TRIED // len(problem.nodes) - 1) + 1):
        yield msgspec.structs.replace(problem, seed=item_seed(problem.seed, "again", number))


def _side_by_side(shapes: Mapping[str, Polygon], first: str, second: str) -> bool:
    if first not in shapes or second not in shapes:
        return False
    walls = shared_walls(edge_array(shapes[first]), edge_array(shapes[second]), _GAP)
    return total_length(walls) >= _WALL


def _apart(plan: PlanReply, index: int) -> Iterator[list[tuple[str, str]]]:
    """Yield the pairs of rooms of a floor that each wish wants apart."""
    rooms = plan.program.floors[index].rooms
    for wish in plan.program.wishes:
        if wish.kind == "apart":
            firsts = [room.id for room in rooms if _is_called(room, wish.value.name, wish.value.type)]
            seconds = [room.id for room in rooms if _is_called(room, wish.value.other, wish.value.other_type)]
            yield [(one, other) for one in firsts for other in seconds if one != other]


def _is_called(room: RoomProgram, name: str, kind: str) -> bool:
    """Whether a room has a name, maybe numbered, or is of the type where the name says no more than that."""
    return re.sub(r"_\d+$", "", room.id) == name or (name == kind and room.room_type == kind)
