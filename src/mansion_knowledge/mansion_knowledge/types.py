"""Records of the knowledge base: room types, building types and styles of material."""

import re
from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal, TypeAlias

__all__ = [
    "BuildingGroups",
    "BuildingType",
    "Family",
    "Finish",
    "Parti",
    "RoomEntry",
    "RoomType",
    "RoomWord",
    "Storey",
    "Style",
    "Zone",
    "parse_entry",
]

Zone: TypeAlias = Literal["public", "private", "service", "circulation"]
Finish: TypeAlias = Literal["wood", "carpet", "tile", "vinyl", "concrete", "rubber", "stone"]
Storey: TypeAlias = Literal["any", "ground", "upper", "top", "basement"]
Parti: TypeAlias = Literal["hall", "house", "spine"]
"""The layout idea of a storey: rooms around one big room, around a landing, or along a corridor."""

Family: TypeAlias = Literal[
    "home", "lodging", "office", "education", "health", "culture", "retail", "food", "sport",
    "civic", "worship", "transport", "industry", "mixed",
]  # fmt: skip

_ENTRY = re.compile(r"^(?P<type>[a-z][a-z0-9_]*)(?::(?P<area>\d+(?:\.\d+)?))?(?: x(?P<count>\d+))?(?P<more> \+)?$")


@dataclass(frozen=True)
class RoomEntry:
    """A line of a storey's room list.

    Attributes
    ----------
    room_type : str
    area : float, optional
        Square metres; the type's usual area when absent.
    count : int
    repeat : bool
        More of it may fill what is left of the storey.
    """

    room_type: str
    area: float | None = None
    count: int = 1
    repeat: bool = False


def parse_entry(text: str) -> RoomEntry:
    """Parse ``room_type[:area] [xCOUNT] [+]``.

    Raises
    ------
    ValueError
        The text has another form.

    Examples
    --------
    >>> parse_entry("classroom:54 x3 +")
    RoomEntry(room_type='classroom', area=54.0, count=3, repeat=True)
    """
    match = _ENTRY.match(text.strip())
    if match is None:
        raise ValueError(f'{text!r} is not of the form "room_type[:area] [xCOUNT] [+]"')
    return RoomEntry(
        room_type=match["type"],
        area=float(match["area"]) if match["area"] else None,
        count=int(match["count"] or 1),
        repeat=bool(match["more"]),
    )


@dataclass(frozen=True)
class RoomType:
    """A kind of room.

    Attributes
    ----------
    name : str
        Snake case; what later stages furnish by.
    synonyms : tuple of str
        Other names, lower case, without hyphens.
    least, usual, most : float
        Area in square metres.
    zone : {"public", "private", "service", "circulation"}
    storey : {"any", "ground", "upper", "top", "basement"}
        Where it prefers to be.
    near : tuple of str
        Room types that it likes beside it.
    daylight, wet, open, flexible, unit : bool
        Wants a window; has water; stands open to what it is reached from; may take up a storey's spare area; is a
        dwelling of several rooms.
    sleeping, toilet, food, common, whole : bool
        Somebody sleeps there; has a toilet; food is prepared or kept there; belongs to most storeys, so that a brief
        that asks for one does not rule out others; is of use as one rectangle alone, so that nothing is cut from it.
    finish : str
        Which floor material of a style it takes.
    suite : tuple of RoomEntry
        Rooms that are reached through it (a hotel room's bathroom).
    kin : str
        Room type as which it is furnished, coloured and used, and whose facts fill what its row leaves empty; empty
        for one that stands for itself.
    suggests : str
        Building type that a room of this type suggests where a brief names none; empty for none.
    counts_as : str
        Room type with which it is counted (a guest room is one of "three bedrooms"); mostly its own.
    stack : int
        Rank of rooms that stand nearest to the cores, stacked from storey to storey, 1 the nearest; 0 for others.
    """

    name: str
    least: float
    usual: float
    most: float
    zone: Zone
    storey: Storey
    finish: Finish
    synonyms: tuple[str, ...] = ()
    near: tuple[str, ...] = ()
    daylight: bool = False
    wet: bool = False
    open: bool = False
    flexible: bool = False
    unit: bool = False
    suite: tuple[RoomEntry, ...] = ()
    kin: str = ""
    sleeping: bool = False
    toilet: bool = False
    food: bool = False
    common: bool = False
    whole: bool = False
    suggests: str = ""
    counts_as: str = ""
    stack: int = 0


@dataclass(frozen=True)
class RoomWord:
    """What a word says of the rooms in whose names it stands, known types or not.

    Attributes
    ----------
    word : str
        Snake case.
    like : str
        Room type as which a room of exactly this name is furnished.
    classes : tuple of str
        Classes of a room with this among the words of its name.
    colour : str
        Colour family, on plans, of a room with this as any part of its name.
    thor : str
        AI2-THOR's room type for a room with this as any part of its name.
    uses : tuple of str
        Uses of a room whose name ends with this.
    keeps : tuple of str
        Kinds of things that a room called so usually keeps.
    called : tuple of (str, str)
        Groups of names that people use for each other, and how closely the name belongs to each: empty for the same
        room, ``goal`` where the goal of a task takes it for that, ``talk`` and ``loose`` where people may mean it.
    """

    word: str
    like: str = ""
    classes: tuple[str, ...] = ()
    colour: str = ""
    thor: str = ""
    uses: tuple[str, ...] = ()
    keeps: tuple[str, ...] = ()
    called: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True)
class BuildingType:
    """A kind of building: how large it usually is and what its storeys hold.

    Attributes
    ----------
    floors : (int, int)
        Usual number, and the most that is inferred.
    floor_area : (float, float)
        Least and usual gross area of a storey, square metres.
    hub, hub_upper : str
        Room type of the circulation hub at the entrance storey and above.
    people : float
        Gross square metres for a person, where a brief states occupants only.
    seats : RoomEntry, optional
        The room that occupants are counted by: its type, and occupants per room as `area`.
    places : RoomEntry, optional
        The room in which occupants have a place each: its type, and square metres a place as `area`.
    place : str
        Category of the furniture that is such a place.
    filler : tuple of str
        Room types of general use that fill a storey, instead of the family's.
    storeys : dict of str to tuple of RoomEntry
        ``single``, ``ground``, ``second``, ``upper``, ``top``, ``basement``.
    like : str
        The building type that it is planned like, where it is a kind of another.
    stretcher : bool
        Needs a lift on any number of storeys above one.
    heads : tuple of str
        Nouns that end the names of unknown kinds that are most like it ("agency", "bureau").
    main : frozenset of str
        Room types that such a building is there for: its entrance storey has those of its list whatever a brief adds.
    needed : frozenset of str, optional
        Room types of its lists without which such a building does not work: all that it has of them where a brief tells
        what it is there for. ``None`` where nobody can tell, so that it keeps its lists.
    small : float
        Most gross square metres of a storey that are called small; 0 where a share of the usual ones are.
    """

    name: str
    synonyms: tuple[str, ...]
    family: Family
    floors: tuple[int, int]
    floor_area: tuple[float, float]
    hub: str
    hub_upper: str
    parti: Parti
    height: float
    style: str
    people: float
    storeys: dict[str, tuple[RoomEntry, ...]] = field(default_factory=dict)
    seats: RoomEntry | None = None
    places: RoomEntry | None = None
    place: str = ""
    filler: tuple[str, ...] = ()
    stretcher: bool = False
    like: str = ""
    heads: tuple[str, ...] = ()
    main: frozenset[str] = frozenset()
    needed: frozenset[str] | None = None
    small: float = 0.0

    @property
    def alone(self) -> bool:
        """Whether it is its hub and has no other rooms of its own."""
        return not any(self.storeys.values())


@dataclass(frozen=True)
class BuildingGroups:
    """What many building types have in common: by family, or by the words of their names.

    Attributes
    ----------
    filler : dict of str to tuple of str
        Room types of general use that fill a storey, by family; ``other`` for the families that are not named.
    dwellings : frozenset of str
        Words of types that get the door of a house.
    facades : dict of str to (frozenset of str, tuple of str)
        Words of types, and the materials that their outer walls may have; ``other`` for types without such a word.
    style_facades : dict of str to tuple of str
        Materials of the outer walls by style, for the styles that have their own.
    trims : dict of str to (str, str)
        Materials of the plinth and of the surrounds of windows, by the facade's; empty for none.
    roofs : dict of str to (frozenset of str, tuple of str)
        Likewise the forms of their roofs: ``gable``, ``hip`` or ``flat``.
    outside : dict of str to (frozenset of str, tuple of str)
        Likewise what they show outside: ``marquee``, ``playground``, ``awnings``.
    flat_styles : frozenset of str
        Styles whose roofs are flat.
    room_of : dict of str to str
        Room types that people of a profession have one each of, by the noun for one of them.
    """

    filler: dict[str, tuple[str, ...]]
    dwellings: frozenset[str]
    facades: dict[str, tuple[frozenset[str], tuple[str, ...]]]
    roofs: dict[str, tuple[frozenset[str], tuple[str, ...]]]
    outside: dict[str, tuple[frozenset[str], tuple[str, ...]]]
    flat_styles: frozenset[str]
    style_facades: dict[str, tuple[str, ...]] = field(default_factory=dict)
    trims: dict[str, tuple[str, str]] = field(default_factory=dict)
    room_of: dict[str, str] = field(default_factory=dict)

    def filler_of(self, family: str) -> tuple[str, ...]:
        """Return the room types of general use of a family."""
        return self.filler.get(family, self.filler["other"])

    def is_dwelling(self, building_type: str) -> bool:
        """Whether a building type is a dwelling, by the words of its name."""
        return not self.dwellings.isdisjoint(_words(building_type))

    def facades_of(self, building_type: str, style: str = "") -> tuple[str, ...]:
        """Return the materials that the outer walls of a building type may have in a style."""
        return self.style_facades.get(style) or _of_words(self.facades, building_type)

    def roofs_of(self, building_type: str, style: str) -> tuple[str, ...]:
        """Return the forms that the roof of a building type may have in a style."""
        return ("flat",) if style in self.flat_styles else _of_words(self.roofs, building_type)

    def shown_outside(self, building_type: str) -> tuple[str, ...]:
        """Return what a building type shows outside beyond its walls and roofs.

        Examples
        --------
        >>> from mansion_knowledge import default_knowledge
        >>> default_knowledge().groups.shown_outside("cinema")
        ('marquee', 'posters')
        """
        return _of_words(self.outside, building_type)


def _of_words(groups: Mapping[str, tuple[frozenset[str], tuple[str, ...]]], building_type: str) -> tuple[str, ...]:
    """Return the choices of the first group with a word of a type's name, else those of ``other``."""
    words = _words(building_type)
    return next((choices for names, choices in groups.values() if not names.isdisjoint(words)), groups["other"][1])


def _words(building_type: str) -> list[str]:
    return building_type.lower().replace("-", "_").replace(" ", "_").split("_")


@dataclass(frozen=True)
class Style:
    """Materials: a floor covering for each finish, and a wall covering for each kind of room.

    Attributes
    ----------
    like : str
        The style whose materials it takes, where it is one of another's kind.
    """

    name: str
    synonyms: tuple[str, ...]
    floors: dict[str, str]
    walls: dict[str, str]
    like: str = ""
