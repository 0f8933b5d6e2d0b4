"""The layout of a floor whose rooms are all given: nothing is searched, its edges are measured."""

import shapely
from shapely.geometry import Polygon

from mansion_geometry.rings import ring_of
from mansion_geometry.shared_walls import edge_array, longest_wall, shared_walls, total_length
from mansion_msgs_py.errors import ErrorCode, MansionError
from mansion_msgs_py.layout import FloorLayout, FloorProblem, LayoutRoom, RealisedEdge, UnmetEdge

__all__ = ["given_layout", "is_given"]

_GAP = 2e-3
"""Distance, metres, up to which two given rooms touch."""

_NEIGHBOURS = 0.3
"""Least shared wall of an ``adjacent`` edge, metres."""


def is_given(problem: FloorProblem) -> bool:
    """Whether every node of a problem is a fixed room or a core."""
    known = {room.id for room in problem.fixed_rooms} | {core.id for core in problem.cores}
    return bool(problem.fixed_rooms) and all(node.id in known for node in problem.nodes)


def given_layout(problem: FloorProblem) -> FloorLayout:
    """Return the fixed rooms of a problem as its layout.

    Raises
    ------
    MansionError
        ``INFEASIBLE`` for an edge that names nothing, or a room that is not a simple polygon.
    """
    shapes = {core.id: Polygon(core.polygon) for core in problem.cores}
    for index, room in enumerate(problem.fixed_rooms):
        shapes[room.id] = Polygon(room.polygon, room.holes)
        if not shapes[room.id].is_valid:
            raise MansionError(
                ErrorCode.INFEASIBLE,
                f"{room.id} is not a simple polygon ({shapely.is_valid_reason(shapes[room.id])})",
                path=f"$.fixed_rooms[{index}].polygon",
            )
    edges = [_realised(problem, index, shapes) for index in range(len(problem.edges))]
    unmet = [
        UnmetEdge(source=e.source, target=e.target, kind=e.kind, reason=f"they share {e.length:.2f} m of wall")
        for e in edges
        if not e.satisfied
    ]
    return FloorLayout(
        rooms=[_room(room.id, shapes[room.id]) for room in problem.fixed_rooms],
        topology_satisfied=not unmet,
        unmet_edges=unmet,
        plan_id=problem.plan_id,
        edges=edges,
        hub=next((node.id for node in problem.nodes if node.type == "main"), ""),
        building_id=problem.building_id,
        floor=problem.floor,
    )


def _room(name: str, shape: Polygon) -> LayoutRoom:
    holes = [ring_of(hole, ccw=False) for hole in shape.interiors]
    return LayoutRoom(id=name, polygon=ring_of(shape.exterior), holes=holes)


def _realised(problem: FloorProblem, index: int, shapes: dict[str, Polygon]) -> RealisedEdge:
    edge = problem.edges[index]
    for end in (edge.source, edge.target):
        if end not in shapes:
            raise MansionError(
                ErrorCode.INFEASIBLE,
                f"the edge names {end!r}, which is not a core or fixed room",
                path=f"$.edges[{index}]",
            )
    walls = shared_walls(edge_array(shapes[edge.source]), edge_array(shapes[edge.target]), _GAP)
    wall = longest_wall(walls)
    length = total_length(walls) if edge.kind == "adjacent" else (wall.length if wall is not None else 0.0)
    least = problem.min_access_wall if edge.kind == "access" else _NEIGHBOURS
    return RealisedEdge(
        source=edge.source,
        target=edge.target,
        kind=edge.kind,
        satisfied=length >= least - 1e-3,
        wall=None if wall is None else (wall.start, wall.end),
        length=round(length, 4),
    )
