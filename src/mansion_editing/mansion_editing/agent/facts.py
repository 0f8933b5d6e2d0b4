"""What the parts of the agent exchange: facts with the objects that they mean, actions, outcomes and verdicts."""

import math
from collections.abc import Generator
from dataclasses import KW_ONLY, dataclass, field, replace
from typing import Any, Final, Literal, TypeAlias

from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.state import SceneState
from mansion_editing.tools.perception import matching_objects
from mansion_editing.tools.placement import COOLING
from mansion_language.colours import colour_of
from mansion_msgs_py.editing import ObjectInfo, ObjectList, ReceptacleReport
from mansion_msgs_py.errors import ErrorCode, MansionError

__all__ = [
    "AbsentFact",
    "Action",
    "Fact",
    "MoveFact",
    "ObjectDescription",
    "ObjectFact",
    "ObjectSearch",
    "Outcome",
    "PathFact",
    "Policy",
    "Scope",
    "StateFact",
    "Unmet",
    "Verdict",
    "ask",
    "each_place",
    "exactly_named",
    "find_landmarks",
    "find_objects",
    "is_next_to",
    "list_contents",
    "matches",
    "receptacles",
    "rooms_of",
]

Relation: TypeAlias = Literal["on", "in", "room"]


@dataclass(frozen=True)
class Scope:
    """A place: on or in a receptacle, in a room, on a floor; each part may be left open.

    Attributes
    ----------
    receptacle : str
        A noun or an id; empty when only the room or the floor is given.
    rooms : tuple of str
        Ids of the rooms that the words may refer to; empty for any.
    colour : str
        Colour of the receptacle.
    near : str
        Noun or id of a landmark next to which the place is.
    base : str
        What the receptacle stands on (a tray on a table).
    """

    relation: Relation = "room"
    receptacle: str = ""
    rooms: tuple[str, ...] = ()
    floor: int | None = None
    colour: str = ""
    near: str = ""
    base: str = ""

    def __str__(self) -> str:
        carrier = " ".join(word for word in (self.colour, self.receptacle) if word)
        parts = [f"{self.relation} the {carrier}"] if self.receptacle else []
        parts += [f"on the {self.base}"] if self.base else []
        parts += [f"next to the {self.near}"] if self.near else []
        if self.rooms:
            parts.append(f"in {' or '.join(self.rooms[:4])}")
        elif self.floor is not None:
            parts.append(f"on floor {self.floor}")
        return " ".join(parts) or "in the building"

    def on_receptacle_of(self, other: "Scope") -> "Scope":
        """Return the place with the receptacle of another."""
        return replace(self, relation=other.relation, receptacle=other.receptacle, colour=other.colour, base=other.base)

    def completed(self, other: "Scope | None") -> "Scope":
        """Return the place with its open parts as another has them."""
        if other is None:
            return self
        return replace(
            self if self.receptacle else self.on_receptacle_of(other),
            rooms=self.rooms or other.rooms,
            floor=other.floor if self.floor is None else self.floor,
            near=self.near or other.near,
        )


@dataclass(frozen=True)
class ObjectDescription:
    """A noun with its attributes and a number; `count` 0 means as many as there are.

    Attributes
    ----------
    every : bool
        The words mean all of them (every lamp, the lamps), not one.
    """

    noun: str
    count: int = 1
    colour: str = ""
    _: KW_ONLY
    cold: bool = False
    every: bool = False

    def __str__(self) -> str:
        words = [
            str(self.count) if self.count else "every" if self.every else "the",
            *(["cold"] if self.cold else []),
            *([self.colour] if self.colour else []),
            self.noun,
        ]
        return " ".join(words)

    def to_move(self) -> "ObjectDescription":
        """Return the description with the number to move: all where all are meant, else at least one."""
        return replace(self, count=0 if self.every and not self.count else max(1, self.count))


@dataclass(frozen=True)
class ObjectFact:
    """A number of objects is there.

    Attributes
    ----------
    exact, more, most : bool
        Exactly the number; the number besides those that are there; at most the number.
    """

    object: ObjectDescription
    where: Scope = field(default_factory=Scope)
    _: KW_ONLY
    exact: bool = False
    more: bool = False
    most: bool = False

    def __str__(self) -> str:
        if self.most:
            return f"at most {self.object} {self.where}"
        manner = "exactly " if self.exact else "another " if self.more else ""
        return f"{manner}{self.object} {self.where}"


@dataclass(frozen=True)
class AbsentFact:
    """No such object is there; an empty noun means everything except what is spared."""

    object: ObjectDescription
    where: Scope = field(default_factory=Scope)
    spare: tuple[ObjectDescription, ...] = ()

    def __str__(self) -> str:
        what = str(self.object) if self.object.noun else "everything"
        if self.spare:
            what += f" but {' and '.join(thing.noun for thing in self.spare)}"
        return f"gone: {what} {self.where}"


@dataclass(frozen=True)
class MoveFact:
    """An object moves from one place to another."""

    object: ObjectDescription
    source: Scope
    target: Scope

    def __str__(self) -> str:
        return f"{self.object} {self.source} moved to {self.target}"


@dataclass(frozen=True)
class StateFact:
    """An object is open or closed, on or off."""

    object: ObjectDescription
    where: Scope
    state: Literal["open", "on"]
    _: KW_ONLY
    value: bool

    def __str__(self) -> str:
        word = {("open", True): "open", ("open", False): "closed", ("on", True): "on"}
        return f"{self.object} {self.where} {word.get((self.state, self.value), 'off')}"


@dataclass(frozen=True)
class PathFact:
    """A path leads from one place to another; the default is from the entrance to every room."""

    start: str = ""
    end: str = ""

    def __str__(self) -> str:
        return f"a path from {self.start or 'the entrance'} to {self.end or 'every room'}"


Fact: TypeAlias = ObjectFact | AbsentFact | MoveFact | StateFact | PathFact


@dataclass(frozen=True)
class Action:
    """One turn: a thought and a call of a tool; arguments are JSON."""

    thought: str
    tool: str
    arguments: dict[str, Any] = field(default_factory=dict)


@dataclass(frozen=True)
class Outcome:
    """What a tool answered: its reply, or why it refused."""

    value: Any = None
    error: MansionError | None = None


@dataclass(frozen=True)
class Verdict:
    """How a policy ends.

    Attributes
    ----------
    facts : list of str
        What was asked for, in words.
    failed : list of str
        What does not hold, each with its reason.
    question : bool
        It was only asked; `summary` is the answer.
    candidates : list of str
        Ids of what words may mean that fit several things.
    """

    summary: str
    facts: list[str] = field(default_factory=list)
    failed: list[str] = field(default_factory=list)
    question: bool = False
    candidates: list[str] = field(default_factory=list)


Policy: TypeAlias = Generator[Action, Outcome, Verdict]
"""Yields actions, is sent outcomes, returns a verdict."""


class Unmet(Exception):
    """Why a fact does not hold."""


def ask(thought: str, tool: str, arguments: dict[str, Any]) -> Generator[Action, Outcome, Any]:
    """Call a tool and return its reply.

    Raises
    ------
    Unmet
        Where the tool refuses.
    """
    answer = yield Action(thought, tool, arguments)
    if answer.error is not None:
        raise Unmet(str(answer.error))
    return answer.value


ObjectSearch = Generator[Action, Outcome, list[ObjectInfo]]
"""Ends with the objects found."""


def matches(thing: ObjectDescription, item: ObjectInfo, state: SceneState) -> bool:
    """Whether an object fits a description."""
    if thing.noun and thing.noun != item.id:
        scene_object = state.find(item.id)
        ends = "_" in thing.noun and item.id.endswith(f"/{thing.noun}")
        if not ends and (scene_object is None or vocabulary_of(state.catalogue).rank(scene_object[1], thing.noun) < 2):
            return False
    if thing.colour:
        material = state.find(item.id)
        if material is None or colour_of(material[1].material) != thing.colour:
            return False
    return not thing.cold or item.states.get("temperature") == "cold" or _is_cooled(item, state)


def _is_cooled(item: ObjectInfo, state: SceneState) -> bool:
    parent = state.find(item.parent or "")
    return parent is not None and item.mount == "inside" and parent[1].category in COOLING


def receptacles(where: Scope, state: SceneState) -> ObjectSearch:
    """Find the receptacles of a scope."""
    if not where.receptacle:
        return []
    found = yield from _listed(where, where.receptacle, 200, f"Which {where.receptacle} is there")
    mine = [i for i in found if matches(ObjectDescription(where.receptacle, 0, where.colour), i, state)]
    if stems(where.receptacle)[-1:] == (where.receptacle.lower().rpartition(" ")[2],):
        mine = exactly_named(where.receptacle, mine) or mine
    return [i for i in mine if not where.base or _is_on(i, where.base, state)]


def _listed(where: Scope, keyword: str, limit: int, question: str) -> ObjectSearch:
    """List the objects that a keyword names in the rooms, or on the floor, of a scope."""
    found: list[ObjectInfo] = []
    for room in where.rooms or ("",):
        arguments = {"room": room, "keyword": keyword, "limit": limit}
        listed: ObjectList = yield from ask(f"{question}{f' in {room}' if room else ''}?", "ListObjects", arguments)
        found += listed.objects
    return [i for i in found if where.floor in (None, i.floor)]


def exactly_named(noun: str, items: list[ObjectInfo]) -> list[ObjectInfo]:
    """Return the objects whose whole name is the noun: of a fridge and a display fridge, the fridge."""
    words = stems(noun)
    return [i for i in items if stems(i.category.replace("_", " ")) == words]


def _is_on(item: ObjectInfo, base: str, state: SceneState) -> bool:
    found = state.find(item.parent or "")
    return found is not None and (found[1].id == base or vocabulary_of(state.catalogue).rank(found[1], base) >= 2)


def list_contents(receptacle: ObjectInfo, relation: str) -> ObjectSearch:
    """List the objects on or in a receptacle."""
    tool = "SearchContents" if relation == "in" else "CheckSurface"
    report: ReceptacleReport = yield from ask(f"What is {relation} {receptacle.id}?", tool, {"id": receptacle.id})
    return report.receptacles[0].objects


def find_objects(thing: ObjectDescription, where: Scope, state: SceneState) -> ObjectSearch:
    """Find the objects in a scope that fit a description."""
    if not where.receptacle:
        there = yield from _listed(where, thing.noun, 500, f"Which {thing.noun or 'things'} are there")
        return [i for i in there if matches(thing, i, state)]
    found: list[ObjectInfo] = []
    carriers = yield from receptacles(where, state)
    for carrier in carriers[:40]:
        for relation in ("in", "on"):
            there = yield from list_contents(carrier, relation)
            found += [i for i in there if i not in found]
    return [i for i in found if where.floor in (None, i.floor) and matches(thing, i, state)]


NEXT_TO: Final = 0.6
"""Greatest distance between objects that are next to each other, metres."""


def find_landmarks(where: Scope, state: SceneState) -> ObjectSearch:
    """Find what a scope names as ``near``, within the rest of the scope."""
    around = Scope(where.relation, where.receptacle, where.rooms, where.floor, where.colour)
    return (yield from find_objects(ObjectDescription(where.near, 0), around, state))


def is_next_to(item: ObjectInfo, anchor: ObjectInfo, state: SceneState) -> bool:
    """Whether two objects of one room have at most `NEXT_TO` between them."""
    one, other = state.find(item.id), state.find(anchor.id)
    if one is None or other is None or item.room != anchor.room or item.floor != anchor.floor:
        return False
    reach = sum(max(thing.size[:2]) / 2 for _, thing in (one, other))
    return math.dist(one[1].position[:2], other[1].position[:2]) - reach <= NEXT_TO


def rooms_of(where: Scope, state: SceneState) -> list[str]:
    """Return the rooms of a scope, the large ones first."""
    rooms = [
        (-room.area, room.id)
        for floor, room in state.rooms()
        if where.floor in (None, floor) and (not where.rooms or room.id in where.rooms)
    ]
    return [name for _, name in sorted(rooms)]


def each_place(state: SceneState, where: Scope, each: str) -> list[Scope]:
    """Return a scope for each place that a quantified scope covers.

    Parameters
    ----------
    each : {"", "receptacle", "room", "floor"}
        Part of the scope that is quantified.

    Raises
    ------
    MansionError
        ``NOT_FOUND`` when there is none.
    """
    if each == "receptacle" and where.receptacle:
        found = [
            Scope(where.relation, item.id, (item.room,), floor, where.colour)
            for floor, item in matching_objects(state, where.receptacle, list(where.rooms) or None, where.floor)
            if where.colour in ("", colour_of(item.material))
        ]
    elif each == "room":
        found = [replace(where, rooms=(room,)) for room in where.rooms]
    elif each == "floor":
        found = [replace(where, floor=floor, rooms=_on_floor(where.rooms, floor)) for floor in state.floors]
        found = [scope for scope in found if scope.rooms or not where.rooms]
    else:
        return [where]
    if not found:
        place = replace(where, receptacle="", colour="")
        raise MansionError(ErrorCode.NOT_FOUND, f"there is no {where.receptacle or 'room'} {place}")
    return found


def _on_floor(rooms: tuple[str, ...], floor: int) -> tuple[str, ...]:
    return tuple(room for room in rooms if room.startswith(f"F{floor}/"))
