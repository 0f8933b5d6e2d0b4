"""What a brief states: typed facts, each with the words that it was read from."""

from dataclasses import dataclass, field
from typing import Literal, TypeAlias

__all__ = [
    "AdjacencyFact",
    "BriefFacts",
    "CopyFact",
    "FloorRef",
    "MaterialFact",
    "OccupantFact",
    "Quantity",
    "RoomFact",
    "Shape",
    "Span",
    "UseFact",
]

Shape: TypeAlias = Literal["rectangle", "square", "L", "U", "T", "H", "courtyard"]


@dataclass(frozen=True)
class Span:
    """A piece of the brief: its words and where they stand (characters, end exclusive)."""

    words: str
    start: int
    end: int


@dataclass(frozen=True)
class Quantity:
    """A number that the brief states, and where."""

    value: float
    span: Span


@dataclass(frozen=True)
class FloorRef:
    """Which storeys are meant.

    Attributes
    ----------
    kind : str
        ``number``, ``range``, ``top``, ``every``, ``upper``, ``basement``, ``roof``, ``lower`` or ``middle``.
    first, last : int
        Floor numbers, 1 at the ground, for ``number`` and ``range``; `first` is the number of storeys for ``top``.
    """

    kind: Literal["number", "range", "top", "every", "upper", "basement", "roof", "lower", "middle"]
    first: int = 0
    last: int = 0
    span: Span = Span("", 0, 0)


@dataclass(frozen=True)
class RoomFact:
    """Rooms of one type that the brief wants.

    Attributes
    ----------
    room_type : str
        Type of the knowledge base that it is furnished as.
    name : str
        Snake-case name; differs from `room_type` for a room that the knowledge base does not know.
    count : int, optional
        ``None`` for an unnumbered plural.
    area : float, optional
        Of each, square metres.
    floors : tuple of FloorRef
        Empty when the brief does not say where.
    each : bool
        `count` is for every storey that is meant, rather than in all.
    """

    room_type: str
    name: str
    span: Span
    count: int | None = 1
    area: float | None = None
    floors: tuple[FloorRef, ...] = ()
    each: bool = False


@dataclass(frozen=True)
class UseFact:
    """Storeys that are given to a building type ("offices on floors 2 to 5")."""

    building_type: str
    floors: tuple[FloorRef, ...]
    span: Span
    count: int | None = None


@dataclass(frozen=True)
class AdjacencyFact:
    """Two room types that the brief wants side by side."""

    first: str
    second: str
    span: Span


@dataclass(frozen=True)
class CopyFact:
    """Storeys `first` to `last` that are to be identical."""

    first: FloorRef
    span: Span


@dataclass(frozen=True)
class MaterialFact:
    """A material for the floors or the walls of a room type, or of all rooms when `room_type` is empty."""

    surface: Literal["floor", "wall"]
    material: str
    room_type: str
    span: Span


@dataclass(frozen=True)
class OccupantFact:
    """How many people the building is for, and who they are."""

    count: int
    noun: str
    span: Span


@dataclass
class BriefFacts:
    """Everything that a brief states."""

    floors: list[Quantity] = field(default_factory=list)
    basements: list[Quantity] = field(default_factory=list)
    area: list[Quantity] = field(default_factory=list)
    floor_area: list[Quantity] = field(default_factory=list)
    building: list[tuple[str, Span]] = field(default_factory=list)
    rooms: list[RoomFact] = field(default_factory=list)
    uses: list[UseFact] = field(default_factory=list)
    excluded: list[tuple[str, Span]] = field(default_factory=list)
    adjacent: list[AdjacencyFact] = field(default_factory=list)
    copies: list[CopyFact] = field(default_factory=list)
    styles: list[tuple[str, Span]] = field(default_factory=list)
    materials: list[MaterialFact] = field(default_factory=list)
    shapes: list[tuple[Shape, Span]] = field(default_factory=list)
    occupants: list[OccupantFact] = field(default_factory=list)
    setback: list[Span] = field(default_factory=list)
    protruding: list[Span] = field(default_factory=list)
    vertical: list[tuple[str, Span]] = field(default_factory=list)
    size: list[tuple[str, Span]] = field(default_factory=list)
