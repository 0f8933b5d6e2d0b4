"""What the parts of the agent exchange: facts of an instruction, actions, outcomes and verdicts."""

from collections.abc import Generator
from dataclasses import KW_ONLY, dataclass, field
from typing import Any, Literal, TypeAlias

from mansion_msgs_py.errors import MansionError

__all__ = [
    "AbsentFact",
    "Action",
    "Fact",
    "MoveFact",
    "ObjectFact",
    "Outcome",
    "PathFact",
    "Policy",
    "Scope",
    "StateFact",
    "ObjectDescription",
    "Verdict",
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
    """

    summary: str
    facts: list[str] = field(default_factory=list)
    failed: list[str] = field(default_factory=list)


Policy: TypeAlias = Generator[Action, Outcome, Verdict]
"""Yields actions, is sent outcomes, returns a verdict."""
