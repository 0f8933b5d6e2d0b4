"""The answers that a model gives about an instruction, as types: statements with quotes, and turns with tools.

They are read leniently and checked afterwards; the fields are those of the statements that they become.
"""

from typing import Any

import msgspec

__all__ = ["PlaceAnswer", "ReadingAnswer", "RoomsAnswer", "StatementAnswer", "ThingsAnswer", "TurnAnswer"]


class ThingsAnswer(msgspec.Struct, frozen=True):
    """Objects in words, as `Things`.

    Attributes
    ----------
    amount : str
        Kind of an `Amount`, `number` being its number where one is given.
    excepted : list of ThingsAnswer
        `Things.beside`.
    """

    noun: str = ""
    amount: str = "some"
    number: int | None = None
    of: int = 0
    definite: bool = False
    plural: bool = False
    colour: str = ""
    material: str = ""
    open: bool | None = None
    on: bool | None = None
    ordinal: int = 0
    size: str = ""
    refers: str = ""
    owned: str = ""
    place: "PlaceAnswer | None" = None
    excepted: "list[ThingsAnswer]" = []


class RoomsAnswer(msgspec.Struct, frozen=True):
    """Rooms in words, as `Rooms`."""

    words: str = ""
    floors: list[int] = []
    every: bool = False
    number: int = 0
    ordinal: int = 0
    size: str = ""
    same: bool = False
    next_to: str = ""
    holding: "ThingsAnswer | None" = None


class PlaceAnswer(msgspec.Struct, frozen=True):
    """A place in words, as `Place`."""

    relation: str = ""
    anchor: "ThingsAnswer | None" = None
    other: "ThingsAnswer | None" = None
    within: float = 0.0
    spot: str = ""
    facing: "ThingsAnswer | None" = None
    rooms: "RoomsAnswer | None" = None
    outside: bool = False


class StatementAnswer(msgspec.Struct, frozen=True):
    """A statement of the instruction, with the words that it was read from.

    Attributes
    ----------
    other, other_rooms : optional
        The second of two: what something is swapped with, replaced by, turned to, or where a way starts.
    what : str
        What is asked, reshaped, or which surface is finished.
    state, value : str, bool
        ``open`` or ``on``, and whether it is to be.
    number : float
        Degrees of a turn, square metres of a room.
    """

    kind: str
    quote: str
    things: ThingsAnswer | None = None
    other: ThingsAnswer | None = None
    place: PlaceAnswer | None = None
    rooms: RoomsAnswer | None = None
    other_rooms: RoomsAnswer | None = None
    spare: list[ThingsAnswer] = []
    each: bool = False
    or_new: bool = False
    what: str = ""
    name: str = ""
    colour: str = ""
    material: str = ""
    state: str = ""
    value: bool = True
    number: float = 0.0
    absolute: bool = False


class ReadingAnswer(msgspec.Struct, frozen=True):
    """Everything that an instruction says, in the order of the text; a bare array fills `statements`."""

    statements: list[StatementAnswer]


class TurnAnswer(msgspec.Struct, frozen=True):
    """A turn with tools: a call of one, or the end of the work.

    Attributes
    ----------
    statements : list of StatementAnswer
        At the end: what has been done, each with the words of the wish that it is for.
    unmet : list of str
        At the end: what cannot be met, with the reason.
    """

    thought: str
    tool: str = ""
    arguments: dict[str, Any] = {}
    finished: bool = False
    statements: list[StatementAnswer] = []
    unmet: list[str] = []
