"""The room graph of one floor (schema of Fig. 24) and the seed plan of a cut round (Fig. 25)."""

from typing import Annotated, Literal, TypeAlias

import msgspec

from mansion_msgs_py.shapes import Area, Identifier, Point

__all__ = ["Edge", "EdgeKind", "FloorTopology", "NodeKind", "SeedBox", "SeedPlan", "TopologyNode"]

NodeKind: TypeAlias = Literal["main", "Entities", "area", "stair", "elevator"]
"""``main`` is the hub; an ``area`` is a zone that is split completely and vanishes."""

EdgeKind: TypeAlias = Literal["access", "adjacent"]


class TopologyNode(msgspec.Struct, frozen=True, kw_only=True):
    """A room, a zone or a core of the room graph."""

    id: Identifier
    type: NodeKind
    area: Area
    floor_material: str = ""
    wall_material: str = ""
    open_relation: Literal["open", "door"] = "door"
    room_type: str = ""


class Edge(msgspec.Struct, kw_only=True, frozen=True):
    """A wanted connection (``access``: a door or an opening) or neighbourhood (``adjacent``)."""

    source: Identifier
    target: Identifier
    kind: EdgeKind = "access"


class FloorTopology(msgspec.Struct, frozen=True, kw_only=True):
    """Symbolic connectivity of one floor, ``G_i`` of Algorithm 1, line 7; cores included."""

    nodes: Annotated[list[TopologyNode], msgspec.Meta(min_length=1)]
    edges: list[Edge]
    building_id: str = ""
    floor: int = 1
    schema_version: Literal[1] = 1


class SeedBox(msgspec.Struct, frozen=True, kw_only=True):
    """Where a child room should lie within its parent.

    Attributes
    ----------
    room_id : str
    x, y : (float, float)
        Lower and upper coordinate, metres.
    area : float, optional
        Fraction of the parent's area, 0 to 1.
    reason : str
    """

    room_id: Identifier
    x: Point
    y: Point
    area: Annotated[float, msgspec.Meta(ge=0.0, le=1.0)] | None = None
    reason: str = ""


class SeedPlan(msgspec.Struct, frozen=True, kw_only=True):
    """Seed boxes for the cut rounds of one floor, ``sigma_t`` of Algorithm 3, line 3."""

    boxes: list[SeedBox]
    building_id: str = ""
    floor: int = 1
    schema_version: Literal[1] = 1
