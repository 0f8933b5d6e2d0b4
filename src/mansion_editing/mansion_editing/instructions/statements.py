"""What an instruction says, before it is looked up in a scene: things, places and statements, all in words.

A rules reader and a language model both answer in these terms; `mansion_editing.instructions` carries them out and
checks them. Every statement quotes the words that it was read from.
"""

from typing import Final, Literal, TypeAlias

import msgspec

__all__ = [
    "JOINED",
    "Add",
    "Amount",
    "AmountKind",
    "Ask",
    "Clear",
    "Ensure",
    "Finish",
    "Forbid",
    "Furnish",
    "History",
    "Instruction",
    "Keep",
    "Mention",
    "Move",
    "Paint",
    "Place",
    "Reach",
    "Relation",
    "Remove",
    "Rename",
    "Replace",
    "Reshape",
    "Rooms",
    "SetState",
    "Shift",
    "Spot",
    "Statement",
    "Surface",
    "Swap",
    "Things",
    "Turn",
    "When",
]

JOINED: Final = " / "
"""Between the names of several rooms in `Rooms.words`."""

AmountKind: TypeAlias = Literal[
    "some", "exactly", "at_least", "at_most", "more", "fewer", "all", "all_but", "half", "none"
]
Relation: TypeAlias = Literal[
    "", "on", "in", "under", "above", "beside", "left", "right", "behind", "front", "between", "around", "near",
    "nearest", "farthest",
]  # fmt: skip
Spot: TypeAlias = Literal["", "wall", "corner", "window", "door", "middle"]
Surface: TypeAlias = Literal["walls", "floor", "ceiling"]


class Amount(msgspec.Struct, frozen=True, kw_only=True):
    """How many.

    Attributes
    ----------
    kind : str
        ``some``: the number as it stands ("two mugs", "the two mugs", "a mug"); ``exactly``; ``at_least``;
        ``at_most``; ``more``: besides those that are there ("another", "two more"); ``fewer``: so many of them go
        ("one sofa less"); ``all``; ``all_but`` the number; ``half`` of them, rounded down; ``none``.
    number : int
        0 where no number is given ("mugs", "all mugs").
    of : int
        Size of the whole, where it is given ("two of the four"); 0 otherwise.
    """

    kind: AmountKind = "some"
    number: int = 1
    of: int = 0


class Rooms(msgspec.Struct, frozen=True, kw_only=True, tag=True):
    """Rooms in words.

    Attributes
    ----------
    words : str
        Name or kind ("meeting room 2"), or several of them; empty where only storeys are given.
    floors : tuple of int
        Storeys, the ground being 1; empty for any.
    every : bool
        All of them ("each office", "the bathrooms", "all floors").
    number : int
        How many of them there are ("the two bathrooms"); 0 where it is not said.
    ordinal : int
        Which of them ("the third gallery"); -1 is the last, 0 none.
    size : {"", "largest", "smallest"}
    same : bool
        The room that was mentioned last ("in the same room", "there").
    next_to : str
        Words for a room that it shares a wall or a door with ("the office next to the lobby", "the next room").
    holding : Things, optional
        What stands in it ("the room with the piano").
    up : int
        Storeys above the one of `base`, or of the room that was mentioned last; below it where negative.
    base : str
        Words for the room that `up` counts from.
    over : bool
        Right above or below `base` ("the room above the kitchen").
    others : bool
        Not the one that was mentioned last, or that things come from ("the other bedroom").
    but : tuple of Rooms
        Exceptions ("every room except the toilet").
    """

    words: str = ""
    floors: tuple[int, ...] = ()
    every: bool = False
    number: int = 0
    ordinal: int = 0
    size: Literal["", "largest", "smallest"] = ""
    same: bool = False
    next_to: str = ""
    holding: "Things | None" = None
    up: int = 0
    base: str = ""
    over: bool = False
    others: bool = False
    but: "tuple[Rooms, ...]" = ()


class Things(msgspec.Struct, frozen=True, kw_only=True, tag=True):
    """Objects in words.

    Attributes
    ----------
    noun : str
        In the singular ("coffee table"), or an object's id; empty for anything.
    definite : bool
        Those that are there ("the mugs"), not new ones.
    plural : bool
        The noun stands in the plural.
    colour, material : str
        As a palette has them; empty for any.
    states : dict of str to bool
        ``open`` and ``on``, where they tell which ("the open window").
    ordinal : int
        Which of several ("the second desk"); -1 is the last.
    size : {"", "largest", "smallest", "tallest", "shortest"}
    hints : tuple of str
        Adjectives of size ("the tall lamp"), which tell one of several by what it measures; comparatives ("a bigger
        one") also what new things measure, compared with those in whose place they come; ``left`` and ``right``, which
        tell one of two.
    refers : str
        ``last``: what was mentioned last ("it", "them"); ``others``: those of the kind that were not meant
        ("the others").
    place : Place, optional
        Where they are.
    beside : tuple of Things
        Exceptions ("everything except the vase").
    owned : str
        Words before the noun that tell its room or owner ("the lobby chairs", "the CEO's desk").
    bearing : Things, optional
        What is on or in them ("the table with the lamp on it").
    each : bool
        They are spoken of one by one ("each bed"): an amount of what is at them is that of each, not of all together.
    """

    noun: str = ""
    amount: Amount = Amount()
    definite: bool = False
    plural: bool = False
    colour: str = ""
    material: str = ""
    states: dict[str, bool] = {}
    ordinal: int = 0
    size: Literal["", "largest", "smallest", "tallest", "shortest"] = ""
    hints: tuple[str, ...] = ()
    refers: Literal["", "last", "others"] = ""
    place: "Place | None" = None
    beside: "tuple[Things, ...]" = ()
    owned: str = ""
    bearing: "Things | None" = None
    each: bool = False


class Place(msgspec.Struct, frozen=True, kw_only=True):
    """A place in words: a relation to things, a spot, rooms and storeys; each part may be left open.

    Attributes
    ----------
    relation : str
        To `anchor`, empty for on or in it ("from the dresser"); ``between`` has `other` too, or an anchor in the
        plural. ``nearest`` and ``farthest`` tell which of several is meant, by its distance to `anchor` or `spot`.
    within, apart : float
        Greatest and least distance to the anchor in metres; 0 where none is given.
    spot : {"", "wall", "corner", "window", "door", "middle"}
        Of the room.
    facing : Things, optional
        What the front turns to.
    outside : bool
        Anywhere but there ("not on the table").
    on_floor : bool
        On the floor of its rooms, not on or in furniture.
    former : Things, optional
        What stood there before it went ("in its place", "where the bench stood").
    """

    relation: Relation = ""
    anchor: Things | None = None
    other: Things | None = None
    within: float = 0.0
    apart: float = 0.0
    spot: Spot = ""
    facing: Things | None = None
    rooms: Rooms | None = None
    outside: bool = False
    on_floor: bool = False
    former: Things | None = None


class _Said(msgspec.Struct, frozen=True, kw_only=True, tag=True):
    """Words of the instruction that say it."""

    quote: str = ""


class Add(_Said, kw_only=True, frozen=True):
    """New things at a place, besides those that are there ("add two chairs to the lobby").

    Attributes
    ----------
    each : bool
        So many at each of several places ("on every desk").
    """

    things: Things
    place: Place
    each: bool = False


class Ensure(_Said, kw_only=True, frozen=True):
    """Things are at a place, those that are there counted ("there should be four chairs in the break room").

    Attributes
    ----------
    each : bool
        So many at each of several places.
    lacking : int
        How many of the places have none, where that is told ("two of the desks have no monitor"); 0 otherwise.
    """

    things: Things
    place: Place
    each: bool = False
    lacking: int = 0


class Remove(_Said, kw_only=True, frozen=True):
    """Things leave the building; with `Things.amount` ``at_most`` or ``exactly`` the surplus does."""

    things: Things


class Forbid(_Said, kw_only=True, frozen=True):
    """Nothing of the kind is added at a place ("do not put a chair in the lobby"); what is there stays."""

    things: Things
    place: Place


class Keep(_Said, kw_only=True, frozen=True):
    """Things stay as and where they are ("leave the sofa alone")."""

    things: Things


class Clear(_Said, kw_only=True, frozen=True):
    """Furniture, a room or a part of it is emptied of what is loose; `spare` stays."""

    place: Place
    spare: tuple[Things, ...] = ()


class Move(_Said, kw_only=True, frozen=True):
    """Things that are there go to a place.

    Attributes
    ----------
    or_new : bool
        Where none is there, a new one may be brought ("put the milk in the fridge").
    """

    things: Things
    place: Place
    or_new: bool = False


class Shift(_Said, kw_only=True, frozen=True):
    """Things move so many metres where they stand.

    Attributes
    ----------
    way : str
        ``left``, ``right``, ``front`` and ``behind`` of the thing itself, a point of the compass, or ``towards`` and
        ``away`` from `mark` or the nearest `spot` of the room.
    """

    things: Things
    metres: float
    way: Literal["left", "right", "front", "behind", "north", "south", "east", "west", "towards", "away"]
    mark: Things | None = None
    spot: Spot = ""


class Swap(_Said, kw_only=True, frozen=True):
    """Two things, or two rooms, exchange their places."""

    one: Things | Rooms
    other: Things | Rooms


class Replace(_Said, kw_only=True, frozen=True):
    """Things go, and new ones stand where they were."""

    things: Things
    by: Things


class SetState(_Said, kw_only=True, frozen=True):
    """Things open, close or switch."""

    things: Things
    state: Literal["open", "on"]
    value: bool


class Paint(_Said, kw_only=True, frozen=True):
    """Things take a colour or a material."""

    things: Things
    colour: str = ""
    material: str = ""


class Turn(_Said, kw_only=True, frozen=True):
    """Things turn where they stand: by degrees (counter-clockwise seen from above), or their front to something.

    Attributes
    ----------
    facing : Things, optional
        What the front turns to.
    spot : str
        ``window``, ``door`` or ``wall`` of the room that the front turns to, the nearest.
    """

    things: Things
    degrees: float = 0.0
    facing: Things | None = None
    spot: Spot = ""


class Reach(_Said, kw_only=True, frozen=True):
    """A robot gets from one place to another; without a start from the entrance, without an end to every room."""

    start: Things | Rooms | None = None
    end: Things | Rooms | None = None


class Rename(_Said, kw_only=True, frozen=True):
    """A room takes a name."""

    room: Rooms
    name: str


class Finish(_Said, kw_only=True, frozen=True):
    """Walls, floor or ceiling of rooms take a colour or a material."""

    rooms: Rooms
    part: Surface
    colour: str = ""
    material: str = ""


class Furnish(_Said, kw_only=True, frozen=True):
    """Rooms are furnished anew, as another kind of room where `kind` is given."""

    rooms: Rooms
    kind: str = ""


class Reshape(_Said, kw_only=True, frozen=True):
    """The structure of a storey changes.

    Attributes
    ----------
    what : str
        ``area``: `rooms` grows by `area` m2 (negative: shrinks), or to it where `absolute`; ``door``: a door between
        `rooms` and `other`; ``stair``, ``elevator``: one more.
    share : float
        The area changes by so much of what it is ("a little larger"); 0 where it is given in m2.
    """

    what: Literal["area", "door", "stair", "elevator"]
    rooms: Rooms | None = None
    other: Rooms | None = None
    area: float = 0.0
    absolute: bool = False
    share: float = 0.0


class Ask(_Said, kw_only=True, frozen=True):
    """A question, which changes nothing.

    Attributes
    ----------
    about : str
        ``count`` (how many), ``exists`` (is there), ``where``, ``what`` (what is on the desk), ``state`` (is it
        open), ``rooms`` (which rooms, how many rooms), ``reach`` (can one get there), ``area`` (how large is a room),
        ``colour``.
    """

    about: Literal["count", "exists", "where", "what", "state", "rooms", "reach", "area", "colour"]
    things: Things | None = None
    place: Place | None = None
    rooms: Rooms | None = None
    start: Rooms | None = None
    state: Literal["", "open", "on"] = ""
    value: bool = True


class History(_Said, kw_only=True, frozen=True):
    """An earlier instruction is taken back or done again.

    Attributes
    ----------
    what : str
        ``undo``, ``redo``; ``restore``: only `things` of it go back; ``repeat``: the same once more, at `place` or
        with `things` where they are given ("the same for the next room", "one more"); ``amend``: the last one is
        taken back, and done at `place` or with `things` instead ("I meant the archive").
    times : int
        How many edits are taken back or done again.
    """

    what: Literal["undo", "redo", "restore", "repeat", "amend"]
    things: Things | None = None
    place: Place | None = None
    times: int = 1


class When(_Said, kw_only=True, frozen=True):
    """A statement that is carried out only where a question has the answer `holds`."""

    ask: Ask
    holds: bool
    then: "Statement"


class Mention(_Said, kw_only=True, frozen=True):
    """Background that asks for nothing ("one of our clients is allergic").

    Attributes
    ----------
    rooms : Rooms, optional
        What it tells of, which the next statement may be about ("the dining room is too dark").
    passed_over : bool
        It was not understood, but its form asks for nothing; the answer names it.
    untouched : tuple of Things
        What words that were passed over name, which must be as it was afterwards.
    """

    rooms: Rooms | None = None
    passed_over: bool = False
    untouched: tuple[Things, ...] = ()


Statement: TypeAlias = (
    Add
    | Ensure
    | Remove
    | Forbid
    | Keep
    | Clear
    | Move
    | Shift
    | Swap
    | Replace
    | SetState
    | Paint
    | Turn
    | Reach
    | Rename
    | Finish
    | Furnish
    | Reshape
    | Ask
    | History
    | Mention
    | When
)


class Instruction(msgspec.Struct, frozen=True, kw_only=True):
    """An instruction as it was read.

    Attributes
    ----------
    statements : list of Statement
        In the order in which they are carried out.
    not_understood : list of str
        Words that belong to none.
    ignored : list of str
        Adjectives that are understood but that no scene describes ("clean").
    read_as : str
        The words that it was put in, where it was not understood as it stands.
    undecided : bool
        It can be understood in two ways.
    """

    statements: list[Statement]
    not_understood: list[str] = []
    ignored: list[str] = []
    read_as: str = ""
    undecided: bool = False
