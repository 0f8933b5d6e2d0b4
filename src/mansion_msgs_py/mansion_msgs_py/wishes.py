"""The ledger of a brief: every wish that was read in it, where it holds, and what became of it."""

from typing import Final, Literal, TypeAlias

import msgspec

from mansion_msgs_py.shapes import Identifier

__all__ = ["AREA_TOLERANCE", "MOST_WORDS", "Scope", "Wish", "WishKind", "WishStatus", "WishValue"]

AREA_TOLERANCE: Final = 0.1
"""Share by which an area may miss the one that is asked for and still meet it."""

MOST_WORDS: Final = 12
"""Most words of the phrase that a wish quotes."""

WishKind: TypeAlias = Literal[
    "building_type",
    "floors",
    "basements",
    "total_area",
    "floor_area",
    "outline",
    "style",
    "use",
    "copy",
    "stair",
    "elevator",
    "room",
    "no_room",
    "adjacent",
    "apart",
    "object",
    "no_object",
    "height",
    "material",
    "facade",
    "roof",
    "grounds",
    "clutter",
    "occupants",
    "only",
    "unread",
]

WishStatus: TypeAlias = Literal["", "met", "partly", "not_met", "not_understood"]
"""Empty before the building is finished."""


class WishValue(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """What a wish asks for; which fields are set follows from its kind.

    Attributes
    ----------
    name : str
        Name of the room, the building type, the style, the outline, the material, the form of the roof (empty where
        only its covering is stated) or the use of a part of the plot, in snake case.
    type : str
        Room type or asset category that stands for `name`; empty where nothing does. Of a roof, what covers it.
    other : str
        The second room of a relation.
    count : int, optional
        How many; where absent, several rooms or objects, and at least one stair or lift. For a relation, how many
        rooms of the second kind one of the first lies beside, where that is more than one.
    area, height : float, optional
        Square metres, of each where there are several; metres.
    unwanted : bool
        None of it is wanted.
    whole : bool
        The area is that of a unit: of the room with all that are reached through it alone.
    exact : bool
        No more furniture than `count` is to be called by the same noun in the room.
    unheeded : list of str
        Words that say how it is to be ("soundproof"), and that nothing is made of.
    limit : {"", "most", "least"}
        The area is a bound: no more, or no less, is wanted. For furniture, no more than `count` is wanted anywhere.
    door : bool
        A door or an opening is to join the two rooms of a relation.
    rank : {"", "largest", "smallest"}
        What the room is to be among those of its type.
    """

    name: str = ""
    type: str = ""
    other: str = ""
    other_type: str = ""
    count: int | None = None
    area: float | None = None
    height: float | None = None
    unwanted: bool = False
    whole: bool = False
    exact: bool = False
    unheeded: list[str] = []
    limit: Literal["", "most", "least"] = ""
    door: bool = False
    rank: Literal["", "largest", "smallest"] = ""


class Scope(msgspec.Struct, frozen=True, kw_only=True, omit_defaults=True):
    """Where a wish holds.

    Attributes
    ----------
    floors : list of int
        Floor numbers; everywhere when empty.
    room, room_type : str
        The room that furniture is wanted in; anywhere when empty.
    unit, unit_type : str
        The flat or other unit of which each holds the rooms for itself; the count is for each.
    each : bool
        The count is for every such floor or room, not for all together.
    some : int
        Of how many of the rooms each has its share of the count, whatever the others have; 0 where it is not for some.
    """

    floors: list[int] = []
    room: str = ""
    room_type: str = ""
    unit: str = ""
    unit_type: str = ""
    each: bool = False
    some: int = 0


class Wish(msgspec.Struct, frozen=True, kw_only=True):
    """Something that the brief asks for.

    Attributes
    ----------
    text : str
        The words of the brief, a phrase of at most twelve words.
    span : (int, int)
        Where they stand in the description: characters, end exclusive.
    reason : str
        Why it is not met, and what was built instead; what it was taken for, where the words are not known.
    read_by : {"rules", "model"}
        Who read it in the text.
    rooms, objects : list of str
        What answers to it: ``F1/kitchen``, ``F1/kitchen/stove_1``.
    """

    id: Identifier
    text: str
    span: tuple[int, int]
    kind: WishKind
    value: WishValue = WishValue()
    scope: Scope = Scope()
    status: WishStatus = ""
    reason: str = ""
    read_by: Literal["rules", "model"] = "rules"
    rooms: list[str] = []
    objects: list[str] = []
