"""Room graphs as plans: the problems that ``mansion solve`` reads, and the room graphs that buildings have.

The rooms of a problem that states true polygons (``truth``, as data sets of floor plans do) are taken as they are;
otherwise the solver draws them.
"""

import math
from typing import Any

from mansion_msgs_py.building_plan import BuildingPlan, PlanDoor, PlanFloor, PlanRoom
from mansion_msgs_py.codec import convert
from mansion_msgs_py.layout import FloorProblem, LayoutRoom
from mansion_msgs_py.topology import FloorTopology

__all__ = ["is_room_graph", "plan_from_graph"]


def is_room_graph(value: dict[str, Any]) -> bool:
    """Whether a JSON object is a problem of the floor solver or a room graph."""
    return isinstance(value.get("nodes"), list) and isinstance(value.get("edges", []), list)


def plan_from_graph(value: dict[str, Any]) -> BuildingPlan:
    """Return a problem or a room graph as the plan of one floor.

    A room graph has no outline: it gets a rectangle of three to four that holds its areas.

    Raises
    ------
    MansionError
        ``INVALID_PAYLOAD`` with the JSON path of the fault.
    """
    truth = value.get("truth")
    known = {name: said for name, said in value.items() if name != "truth"}
    if "boundary" in value:
        problem = convert(FloorProblem, known)
        polygons = {room.id: (room.polygon, room.holes) for room in convert(list[LayoutRoom], truth or [])}
        polygons |= {room.id: (room.polygon, room.holes) for room in problem.fixed_rooms}
        polygons |= {core.id: (core.polygon, []) for core in problem.cores}
        rooms = [_room(node.id, node.type, node.room_type, node.area, polygons.get(node.id)) for node in problem.nodes]
        edges, outline, holes = problem.edges, problem.boundary, problem.holes
    else:
        graph = convert(FloorTopology, known)
        rooms = [_room(node.id, node.type, node.room_type, node.area, None) for node in graph.nodes]
        side = math.sqrt(sum(node.area for node in graph.nodes) / 12.0)
        outline, holes = [(0.0, 0.0), (4 * side, 0.0), (4 * side, 3 * side), (0.0, 3 * side)], []
        edges = graph.edges
    doors = [PlanDoor(rooms=[edge.source, edge.target]) for edge in edges if edge.kind == "access"]
    drawn = all(room.polygon for room in rooms)
    return BuildingPlan(
        floors=[PlanFloor(rooms=rooms, doors=doors, outline=[] if drawn else outline, holes=[] if drawn else holes)],
        complete=["doors", "windows"],
    )


def _room(
    name: str, node: str, kind: str, area: float | None, rings: tuple[list[Any], list[list[Any]]] | None
) -> PlanRoom:
    core = {"stair": "stairs", "elevator": "elevator"}.get(node, "")
    polygon, holes = rings or ([], [])
    called = (kind or name).replace("_", " ") if kind else name
    return PlanRoom(
        name=called.capitalize() if kind else name, id=name, type=core or kind, polygon=polygon, holes=holes,
        area=None if polygon else area,
    )  # fmt: skip
