"""What a brief states: typed facts, each with the words that it was read from."""

from dataclasses import dataclass, field
from typing import Literal, TypeAlias

from mansion_msgs_py.outside import GroundUse
from mansion_msgs_py.program import Clutter

__all__ = [
    "AdjacencyFact",
    "BriefFacts",
    "CopyFact",
    "FloorRef",
    "HeightFact",
    "MaterialFact",
    "ObjectFact",
    "OutsideFact",
    "OutsidePart",
    "OccupantFact",
    "Quantity",
    "RoomFact",
    "Shape",
    "Span",
    "UseFact",
]

Shape: TypeAlias = Literal["rectangle", "square", "L", "U", "T", "H", "courtyard"]


OutsidePart: TypeAlias = Literal["facade", "roof", "grounds"]


@dataclass(frozen=True)
class Span:
    """A piece of the brief: its words and where they stand (characters, end exclusive)."""

    words: str
    start: int
    end: int


@dataclass(frozen=True)
class Quantity:
    """A number that the brief states, and where; `limit`: an area of which no more, or no less, is wanted."""

    value: float
    span: Span
    limit: Literal["", "most", "least"] = ""


@dataclass(frozen=True)
class FloorRef:
    """Which storeys are meant.

    Attributes
    ----------
    kind : str
        ``number``, ``range``, ``top``, ``below_top``, ``every``, ``upper``, ``basement``, ``roof``, ``lower``,
        ``middle``, ``odd``, ``even`` or ``not_top`` (all but the uppermost); ``rest`` (those that nothing else
        names) only while a brief is read.
    first, last : int
        Floor numbers, 1 at the ground, for ``number`` and ``range``; `first` is the number of storeys for ``top``, the
        storeys below the uppermost for ``below_top``, and how many storeys are meant for ``upper`` (0: all).
    """

    kind: Literal[
        "number",
        "range",
        "top",
        "below_top",
        "every",
        "upper",
        "basement",
        "roof",
        "lower",
        "middle",
        "odd",
        "even",
        "not_top",
        "rest",
    ]
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
        Snake-case name in the user's words; differs from `room_type` where the user calls it otherwise.
    count : int, optional
        ``None`` for an unnumbered plural.
    area : float, optional
        Of each, square metres.
    floors : tuple of FloorRef
        Empty when the brief does not say where.
    each : bool
        `count` is for every storey that is meant, rather than in all.
    exact : bool
        No more of them are wanted than stated.
    label : str
        What the user calls it, as written.
    suite : tuple of RoomFact
        Rooms that each of these has for itself ("each with a bathroom").
    known : bool
        The knowledge base has the user's words; otherwise `room_type` is only the nearest kind.
    limit : {"", "most", "least"}
        What `area` bounds.
    size : {"", "large", "small"}
        How large each is to be, in words; of none whose area is stated.
    unit : bool
        A dwelling or another unit of several rooms: `suite` is what the brief says it holds, `area` that of all.
    """

    room_type: str
    name: str
    span: Span
    count: int | None = 1
    area: float | None = None
    floors: tuple[FloorRef, ...] = ()
    each: bool = False
    exact: bool = True
    label: str = ""
    suite: tuple["RoomFact", ...] = ()
    known: bool = True
    unit: bool = False
    limit: Literal["", "most", "least"] = ""
    size: Literal["", "large", "small"] = ""


@dataclass(frozen=True)
class UseFact:
    """Storeys that are given to a building type ("offices on floors 2 to 5")."""

    building_type: str
    floors: tuple[FloorRef, ...]
    span: Span
    count: int | None = None


@dataclass(frozen=True)
class AdjacencyFact:
    """Two rooms, by type, that the brief wants side by side (or apart, in `BriefFacts.apart`).

    Attributes
    ----------
    first_name, second_name : str
        The user's own names, where the rooms have some.
    each : bool
        Several rooms are spoken of, and every one of them is to lie so.
    door : bool
        One is to be entered from the other.
    sides : int
        How many of the second the first lies beside: two in "a store between the shops".
    beyond : tuple of str
        What is asked for besides that the two are side by side: "opposite".
    """

    first: str
    second: str
    span: Span
    first_name: str = ""
    second_name: str = ""
    each: bool = False
    door: bool = False
    sides: int = 1
    beyond: tuple[str, ...] = ()


@dataclass(frozen=True)
class ObjectFact:
    """Furniture that the brief wants.

    Attributes
    ----------
    words : str
        As written.
    noun : str
        What the text calls it, without numbers: "steel tanks".
    category : str
        Of the asset catalogue; empty where it has nothing like it.
    count : int, optional
        ``None`` for an unnumbered plural.
    room : str
        Name of the room, in snake case; empty when the brief does not say where.
    each : bool
        `count` is for every such room.
    excluded : bool
        None of it is wanted.
    exact : bool
        No more of them are wanted.
    some : int
        Of how many such rooms each has its share; 0 where all do.
    others : int
        How many such rooms the brief has told what they have before: it is none of these.
    rows : int
        In how many rows it stands, of a length that the brief does not tell; 0 where it tells no rows.
    """

    words: str
    category: str
    span: Span
    count: int | None = 1
    room: str = ""
    room_type: str = ""
    each: bool = False
    excluded: bool = False
    floors: tuple[FloorRef, ...] = ()
    noun: str = ""
    exact: bool = False
    some: int = 0
    others: int = 0
    rows: int = 0
    most: bool = False


@dataclass(frozen=True)
class HeightFact:
    """The clear height of rooms, metres; of a room type, or of all rooms when `room_type` is empty."""

    height: float
    room_type: str
    span: Span


@dataclass(frozen=True)
class CopyFact:
    """Storeys `first` to `last` that are to be identical."""

    first: FloorRef
    span: Span


@dataclass(frozen=True)
class MaterialFact:
    """A material for the floors or the walls of a room type, or of all rooms when `room_type` is empty.

    With `throughout`, no room is to be without it.
    """

    surface: Literal["floor", "wall"]
    material: str
    room_type: str
    span: Span
    throughout: bool = False


@dataclass(frozen=True)
class OutsideFact:
    """What the outside is to be: the material of the walls, the roof, or a part of the plot.

    Attributes
    ----------
    part : {"facade", "roof", "grounds"}
    name : str
        Material of the walls, or form of the roof (empty where only its covering is stated).
    covering : str
        Material of the roof; empty where only its form is stated.
    count : int
        Number of places to park; 0 where none is stated.
    use : GroundUse, optional
        What a part of the plot is for.
    """

    part: OutsidePart
    name: str
    span: Span
    covering: str = ""
    count: int = 0
    use: GroundUse | None = None


@dataclass(frozen=True)
class ClutterFact:
    """Fewer or more things than usual in the rooms of a type, or in all rooms when `room_type` is empty."""

    clutter: Clutter
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
    """Everything that a brief states.

    Attributes
    ----------
    households : list of RoomFact
        What every unit of a kind holds whose number the brief leaves open ("every flat has two bedrooms").
    excluded : list of (str, Span)
        Room types that are nowhere wanted; ``basement``.
    excluded_on : list of (str, FloorRef, Span)
        Room types that are not wanted on some storeys.
    apart : list of AdjacencyFact
        Rooms that must not share a wall.
    floors : list of Quantity
        The one that counts first.
    only : list of Span
        Words such as "nothing else": no room is added to those that the brief names.
    only_on : list of (Span, tuple of FloorRef)
        The same of some storeys: "nothing but five bedrooms on the second floor".
    building_name : str
        What the user calls the kind of building, in snake case, where that is not the name of the known kind.
    building_like : str
        The known kind that an unknown one is most like by its last word; empty for none.
    building_span : list of Span
        Its words, where the knowledge base does not have them.
    trades : list of (str, Span)
        Kinds of building that what the writer makes or sells needs.
    unread : list of Span
        Words that no fact was read from.
    unheeded : list of Span
        Words within other facts' that say how something is to be, and that nothing is made of.
    above_ground : list of Span
        Areas of the storeys above ground alone: "240 m2 without the basement".
    combined : list of str
        Room types that a room of several uses stands for: none of them is added.
    corrections : list of Span
        From a number that the brief takes back to the end of the one that it gives instead.
    """

    floors: list[Quantity] = field(default_factory=list)
    basements: list[Quantity] = field(default_factory=list)
    area: list[Quantity] = field(default_factory=list)
    floor_area: list[Quantity] = field(default_factory=list)
    building: list[tuple[str, Span]] = field(default_factory=list)
    building_name: str = ""
    building_like: str = ""
    building_span: list[Span] = field(default_factory=list)
    trades: list[tuple[str, Span]] = field(default_factory=list)
    rooms: list[RoomFact] = field(default_factory=list)
    households: list[RoomFact] = field(default_factory=list)
    uses: list[UseFact] = field(default_factory=list)
    excluded: list[tuple[str, Span]] = field(default_factory=list)
    excluded_on: list[tuple[str, FloorRef, Span]] = field(default_factory=list)
    adjacent: list[AdjacencyFact] = field(default_factory=list)
    apart: list[AdjacencyFact] = field(default_factory=list)
    objects: list[ObjectFact] = field(default_factory=list)
    heights: list[HeightFact] = field(default_factory=list)
    copies: list[CopyFact] = field(default_factory=list)
    styles: list[tuple[str, Span]] = field(default_factory=list)
    clutter: list[ClutterFact] = field(default_factory=list)
    materials: list[MaterialFact] = field(default_factory=list)
    outside: list[OutsideFact] = field(default_factory=list)
    shapes: list[tuple[Shape, Span]] = field(default_factory=list)
    occupants: list[OccupantFact] = field(default_factory=list)
    setback: list[Span] = field(default_factory=list)
    protruding: list[Span] = field(default_factory=list)
    vertical: list[tuple[str, Span]] = field(default_factory=list)
    lifts: list[Quantity] = field(default_factory=list)
    stairs: list[Quantity] = field(default_factory=list)
    size: list[tuple[str, Span]] = field(default_factory=list)
    only: list[Span] = field(default_factory=list)
    only_on: list[tuple[Span, tuple[FloorRef, ...]]] = field(default_factory=list)
    unread: list[Span] = field(default_factory=list)
    unheeded: list[Span] = field(default_factory=list)
    above_ground: list[Span] = field(default_factory=list)
    combined: list[str] = field(default_factory=list)
    corrections: list[Span] = field(default_factory=list)
