"""The answers that the planner asks a model for, as types: what a brief states, and Figs. 23 to 25.

They are read leniently and checked afterwards.
"""

import msgspec

__all__ = [
    "CoreAnswer",
    "CoresAnswer",
    "EdgeAnswer",
    "FloorAnswer",
    "MaterialAnswer",
    "MaterialsAnswer",
    "NodeAnswer",
    "NumbersAnswer",
    "ProgramAnswer",
    "ReadingAnswer",
    "RoomAnswer",
    "SeedAnswer",
    "SeedsAnswer",
    "StatementAnswer",
    "StatementScope",
    "StatementValue",
    "TopologyAnswer",
]


class StatementValue(msgspec.Struct, frozen=True):
    """What a statement of the brief asks for, as `mansion_msgs_py.wishes.WishValue`.

    Attributes
    ----------
    several : bool
        There is a plural and no number.
    """

    name: str = ""
    type: str = ""
    other: str = ""
    other_type: str = ""
    count: int | None = None
    several: bool = False
    area: float | None = None
    height: float | None = None
    unwanted: bool = False


class StatementScope(msgspec.Struct, frozen=True):
    """Where a statement holds; floors are numbers or words such as ``top``."""

    floors: list[int | str] = []
    room: str = ""
    each: bool = False


class StatementAnswer(msgspec.Struct, frozen=True):
    """A statement of the brief, with the words that it was read from."""

    kind: str
    quote: str
    value: StatementValue = StatementValue()
    scope: StatementScope = StatementScope()


class ReadingAnswer(msgspec.Struct, frozen=True):
    """Everything that a brief states, in the order of the text; a bare array fills `statements`."""

    statements: list[StatementAnswer]
    language: str = ""


class NumbersAnswer(msgspec.Struct, frozen=True):
    """Type, style and numbers of a building (section C.1)."""

    reasoning: str
    building_type: str
    style: str
    floors: int
    floor_area: float


class MaterialAnswer(msgspec.Struct, frozen=True):
    """Materials of one room type."""

    room_type: str
    floor_material: str
    wall_material: str


class MaterialsAnswer(msgspec.Struct, frozen=True):
    """The palette of a building."""

    palette: list[MaterialAnswer]


class CoreAnswer(msgspec.Struct, frozen=True):
    """A stair or lift of Fig. 23."""

    type: str
    x: tuple[float, float]
    y: tuple[float, float]


class CoresAnswer(msgspec.Struct, frozen=True):
    """``vertical_connectivity`` of Fig. 23."""

    method: str
    cores: list[CoreAnswer]
    justification: str = ""


class RoomAnswer(msgspec.Struct, frozen=True):
    """A room of Fig. 23: an id and no type."""

    id: str
    area_estimate: float
    floor_material: str = ""
    wall_material: str = ""
    notes: str = ""


class FloorAnswer(msgspec.Struct, frozen=True):
    """A floor of Fig. 23, or the short form ``{"index": k, "copy": j}``."""

    index: int
    copy: int | None = None
    requirement: str = ""
    rooms: list[RoomAnswer] = []
    reserve_justification: str = ""


class ProgramAnswer(msgspec.Struct, frozen=True):
    """Fig. 23. The area summary is worked out here rather than believed."""

    reasoning: str
    vertical_connectivity: CoresAnswer
    floors: list[FloorAnswer]


class NodeAnswer(msgspec.Struct, frozen=True):
    """A node of Fig. 24."""

    id: str
    type: str
    area: float
    floor_material: str = ""
    wall_material: str = ""
    open_relation: str = "door"


class EdgeAnswer(msgspec.Struct, frozen=True):
    """An edge of Fig. 24."""

    source: str
    target: str
    kind: str = "access"


class TopologyAnswer(msgspec.Struct, frozen=True):
    """Fig. 24."""

    nodes: list[NodeAnswer]
    edges: list[EdgeAnswer]


class SeedAnswer(msgspec.Struct, frozen=True):
    """A box of Fig. 25."""

    room_id: str
    x: tuple[float, float]
    y: tuple[float, float]
    area: float | None = None
    reason: str = ""


class SeedsAnswer(msgspec.Struct, frozen=True):
    """Fig. 25; a bare array fills `boxes`."""

    boxes: list[SeedAnswer]
