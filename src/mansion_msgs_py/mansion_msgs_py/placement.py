"""The object placer's input and output for one room (Algorithm 4): ``mansion place``."""

from typing import Annotated, Literal, TypeAlias

import msgspec

from mansion_msgs_py.shapes import Elevation, Identifier, Point, Ring, Segment, Size3

__all__ = [
    "Discarded",
    "GlobalConstraint",
    "MatrixStructure",
    "PairedStructure",
    "PlacedObject",
    "PlacementObject",
    "PlacementOpening",
    "PlacementResult",
    "PlacementRoom",
    "Relation",
    "RelationKind",
    "SingleStructure",
    "Structure",
]

GlobalConstraint: TypeAlias = Literal["edge", "middle", "unconstrained"]
RelationKind: TypeAlias = Literal["near", "far", "in_front_of", "around", "side_of", "center_aligned"]
Count: TypeAlias = Annotated[int, msgspec.Meta(ge=1, le=10_000)]


class SingleStructure(msgspec.Struct, frozen=True, tag_field="kind", tag="single"):
    """Copies stand on their own."""


class MatrixStructure(msgspec.Struct, frozen=True, tag_field="kind", tag="matrix"):
    """`rows` x `cols` copies in one grid."""

    rows: Count
    cols: Count


class PairedStructure(msgspec.Struct, frozen=True, tag_field="kind", tag="paired"):
    """One copy for each copy of the object named in ``with``."""

    with_: str = msgspec.field(name="with")


Structure: TypeAlias = SingleStructure | MatrixStructure | PairedStructure


class Relation(msgspec.Struct, frozen=True, kw_only=True):
    """A wish about another object of the room, by name."""

    kind: RelationKind
    target: str


class PlacementObject(msgspec.Struct, frozen=True, kw_only=True):
    """An object to place, `quantity` times.

    Attributes
    ----------
    name : str
        Unique in the room.
    size : (float, float, float)
        Width along the front, depth, height; metres. Never changed.
    smaller : list of Size3
        Sizes of smaller assets of the category that may stand in (only where the catalogue chose the first).
    first : bool
        Whether it is placed before what is not, and matters more.
    """

    name: Identifier
    size: Size3
    category: str = ""
    quantity: Count = 1
    global_: GlobalConstraint = msgspec.field(name="global", default="unconstrained")
    structure: Structure = msgspec.field(default_factory=SingleStructure)
    relative: list[Relation] = []
    smaller: list[Size3] = []
    first: bool = False


class PlacementOpening(msgspec.Struct, frozen=True, kw_only=True):
    """A door or window of the room: the segment of its wall that it takes.

    Attributes
    ----------
    sill : float
        Height below which furniture may stand before it; 0 for a door.
    is_open : bool
        It is a door without a leaf: two rooms are one space through it where it is wide.
    is_outer : bool
        It is a door that leads outside.
    """

    segment: Segment
    id: str = ""
    sill: Elevation = 0.9
    is_open: bool = False
    is_outer: bool = False


class PlacementRoom(msgspec.Struct, frozen=True, kw_only=True):
    """One room to furnish; its polygon is the net interior."""

    room_id: Identifier
    polygon: Annotated[Ring, msgspec.Meta(min_length=3)]
    objects: list[PlacementObject] = []
    room_type: str = ""
    doors: list[PlacementOpening] = []
    windows: list[PlacementOpening] = []
    holes: list[Ring] = []


class PlacedObject(msgspec.Struct, frozen=True, kw_only=True):
    """A copy of an object where it stands; at rotation 0 its front faces +y, degrees counter-clockwise."""

    id: Identifier
    name: str
    center: Point
    rotation: float
    size: Size3


class Discarded(msgspec.Struct, frozen=True, kw_only=True):
    """Copies that could not be placed, and why."""

    name: str
    count: int
    reason: str


class PlacementResult(msgspec.Struct, frozen=True, kw_only=True):
    """Where every object of a room went."""

    room_id: Identifier
    placements: list[PlacedObject]
    discarded: list[Discarded] = []
    seconds: float = 0.0
