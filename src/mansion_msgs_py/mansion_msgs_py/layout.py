"""The floor solver's input and output: FloorProblem and FloorLayout.

``mansion solve`` reads a JSON list of problems and writes a JSON list of layouts of the same types.
"""

from typing import Annotated, Literal, TypeAlias

import msgspec

from mansion_msgs_py.limits import MAX_OBJECTS, MAX_ROOMS
from mansion_msgs_py.shapes import Area, CompassSide, Identifier, Length, Point, Ring, Segment
from mansion_msgs_py.topology import Edge, EdgeKind, NodeKind, SeedPlan

__all__ = [
    "CutRoundRecord",
    "FixedRoom",
    "FloorLayout",
    "FloorProblem",
    "LayoutRoom",
    "PlanId",
    "ProblemCore",
    "ProblemNode",
    "RealisedEdge",
    "SeedRange",
    "UnmetEdge",
]

PlanId: TypeAlias = str | int | float | bool | None


class ProblemCore(msgspec.Struct, frozen=True, kw_only=True):
    """A stair or lift shaft: ground that no room may take, and a node that edges may name."""

    id: Identifier
    type: Literal["stair", "elevator"]
    polygon: Annotated[Ring, msgspec.Meta(min_length=3)]
    door_side: CompassSide | None = None


class FixedRoom(msgspec.Struct, frozen=True, kw_only=True):
    """A room whose polygon is given; it takes part in edges and is returned unchanged."""

    id: Identifier
    polygon: Annotated[Ring, msgspec.Meta(min_length=3)]
    holes: list[Ring] = []


class SeedRange(msgspec.Struct, frozen=True, kw_only=True):
    """An axis-aligned box in which a room's centroid should lie."""

    x: Point
    y: Point


class ProblemNode(msgspec.Struct, frozen=True, kw_only=True):
    """A node of the problem's room graph, with an optional seed point or box."""

    id: Identifier
    type: NodeKind
    area: Area | None = None
    room_type: str = ""
    open_relation: Literal["open", "door"] = "door"
    seed: Point | None = None
    seed_box: SeedRange | None = None
    min_width: Length | None = None


class FloorProblem(msgspec.Struct, frozen=True, kw_only=True):
    """What the floor solver is asked (Algorithm 2): free region, cores, room graph, areas.

    Attributes
    ----------
    boundary, holes : Ring, list of Ring
        Outline of the floor; either orientation.
    cores : list of ProblemCore
    structural_walls : list of Segment
        Lines that no room may straddle other than along them.
    fixed_rooms : list of FixedRoom
    nodes, edges
        The room graph; nodes of type ``stair`` and ``elevator`` name cores by id.
    min_access_wall : float
        Shortest straight shared wall of an ``access`` edge, in metres (1.20 inside a building).
    """

    boundary: Annotated[Ring, msgspec.Meta(min_length=3)]
    nodes: Annotated[list[ProblemNode], msgspec.Meta(max_length=MAX_ROOMS)]
    edges: Annotated[list[Edge], msgspec.Meta(max_length=MAX_OBJECTS)] = []
    plan_id: PlanId = None
    holes: list[Ring] = []
    cores: list[ProblemCore] = []
    structural_walls: list[Segment] = []
    fixed_rooms: list[FixedRoom] = []
    seeds: SeedPlan | None = None
    min_access_wall: Length = 0.9
    building_id: str = ""
    floor: int = 1
    seed: int = 0
    schema_version: Literal[1] = 1


class LayoutRoom(msgspec.Struct, frozen=True, kw_only=True):
    """A room of the layout: a counter-clockwise polygon on wall centre lines, with clockwise holes."""

    id: Identifier
    polygon: Ring
    holes: list[Ring] = []


class RealisedEdge(msgspec.Struct, frozen=True, kw_only=True):
    """An edge of the room graph on the finished polygons.

    Attributes
    ----------
    wall : Segment, optional
        The longest straight shared wall (``None`` when the two do not touch along a wall).
    length : float
        Its length for ``access``; the total length of all shared walls for ``adjacent``. Metres.
    """

    source: Identifier
    target: Identifier
    kind: EdgeKind
    satisfied: bool
    wall: Segment | None = None
    length: float = 0.0


class UnmetEdge(msgspec.Struct, frozen=True, kw_only=True):
    """An edge that the layout does not realise, and why it was relaxed."""

    source: Identifier
    target: Identifier
    kind: EdgeKind
    reason: str


class CutRoundRecord(msgspec.Struct, frozen=True, kw_only=True):
    """One round of the breadth-first cut schedule: which parent was split into which children, and by which search."""

    parent: str
    children: list[str]
    method: str = ""
    candidates: int = 0


class FloorLayout(msgspec.Struct, frozen=True, kw_only=True):
    """A partition of the floor's free region into rooms (cores left out), ``L_f`` of Algorithm 2.

    Attributes
    ----------
    rooms : list of LayoutRoom
    edges : list of RealisedEdge
    topology_satisfied : bool
        Every edge is realised.
    unmet_edges : list of UnmetEdge
    area_scale : float
        Factor by which the node areas were scaled to fill the free region.
    scores, checks : dict
        Energy terms of section C.2, and what was measured on the final polygons.
    """

    rooms: Annotated[list[LayoutRoom], msgspec.Meta(max_length=MAX_ROOMS)]
    topology_satisfied: bool
    unmet_edges: list[UnmetEdge] = []
    plan_id: PlanId = None
    edges: list[RealisedEdge] = []
    rounds: list[CutRoundRecord] = []
    hub: str = ""
    area_scale: float = 1.0
    scores: dict[str, float] = {}
    checks: dict[str, float] = {}
    messages: list[str] = []
    seconds: float = 0.0
    building_id: str = ""
    floor: int = 1
    schema_version: Literal[1] = 1
