"""What the parts of the agent exchange: facts with the objects that they mean, actions, outcomes and verdicts."""

from collections.abc import Generator
from dataclasses import KW_ONLY, dataclass, field
from typing import Any, Literal, TypeAlias

from mansion_assets.catalogue.vocabulary import stems, vocabulary_of
from mansion_editing.state import SceneState
from mansion_editing.tools.placement import COOLING
from mansion_language.colours import colour_of
from mansion_msgs_py.editing import ObjectInfo, ObjectList, ReceptacleReport
from mansion_msgs_py.errors import MansionError

__all__ = [
    "Action",
    "Fact",
    "ObjectDescription",
    "ObjectFact",
    "ObjectSearch",
    "Outcome",
    "PathFact",
    "Policy",
    "Scope",
    "Unmet",
    "Verdict",
    "ask",
    "exactly_named",
    "find_objects",
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
    base : str
        What the receptacle stands on (a tray on a table).
    """

    relation: Relation = "room"
    receptacle: str = ""
    rooms: tuple[str, ...] = ()
    floor: int | None = None
    colour: str = ""
    base: str = ""

    def __str__(self) -> str:
        carrier = " ".join(word for word in (self.colour, self.receptacle) if word)
        parts = [f"{self.relation} the {carrier}"] if self.receptacle else []
        parts += [f"on the {self.base}"] if self.base else []
        if self.rooms:
            parts.append(f"in {' or '.join(self.rooms[:4])}")
        elif self.floor is not None:
            parts.append(f"on floor {self.floor}")
        return " ".join(parts) or "in the building"


@dataclass(frozen=True)
class ObjectDescription:
    """A noun with its attributes and a number; `count` 0 means as many as there are."""

    noun: str
    count: int = 1
    colour: str = ""
    _: KW_ONLY
    cold: bool = False

    def __str__(self) -> str:
        words = [
            str(self.count) if self.count else "the",
            *(["cold"] if self.cold else []),
            *([self.colour] if self.colour else []),
            self.noun,
        ]
        return " ".join(words)


@dataclass(frozen=True)
class ObjectFact:
    """A number of objects is there."""

    object: ObjectDescription
    where: Scope = field(default_factory=Scope)

    def __str__(self) -> str:
        return f"{self.object} {self.where}"


@dataclass(frozen=True)
class PathFact:
    """A path leads from one place to another; the default is from the entrance to every room."""

    start: str = ""
    end: str = ""

    def __str__(self) -> str:
        return f"a path from {self.start or 'the entrance'} to {self.end or 'every room'}"


Fact: TypeAlias = ObjectFact | PathFact


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


def rooms_of(where: Scope, state: SceneState) -> list[str]:
    """Return the rooms of a scope, the large ones first."""
    rooms = [
        (-room.area, room.id)
        for floor, room in state.rooms()
        if where.floor in (None, floor) and (not where.rooms or room.id in where.rooms)
    ]
    return [name for _, name in sorted(rooms)]
