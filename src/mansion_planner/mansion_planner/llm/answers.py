"""The answers that the planner asks a model for: Figs. 23 to 25 as types, read leniently and checked afterwards."""

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
    "RoomAnswer",
    "SeedAnswer",
    "SeedsAnswer",
    "TopologyAnswer",
]


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
