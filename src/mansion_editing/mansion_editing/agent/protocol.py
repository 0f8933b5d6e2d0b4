"""What the parts of the agent exchange: facts of an instruction, actions, outcomes and verdicts."""

from collections.abc import Generator
from dataclasses import dataclass, field
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
    "Thing",
    "Verdict",
]

Relation: TypeAlias = Literal["on", "in", "room"]


@dataclass(frozen=True)
class Scope:
    """Where: on or in a receptacle, in a room, on a floor; each part may be left open.

    Attributes
    ----------
    receptacle : str
        A noun or an id; empty when only the room or the floor is given.
    rooms : tuple of str
        Ids of the rooms that the words may mean; empty for any.
    colour : str
        Of the receptacle.
    near : str
        A noun or an id of what lies or stands beside it.
    base : str
        What the receptacle itself stands on (a tray on a table).
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
class Thing:
    """A noun with its attributes and how many; `count` 0 is as many as there are.

    Attributes
    ----------
    every : bool
        Said of all of them (every lamp, the lamps), not of one.
    """

    noun: str
    count: int = 1
    colour: str = ""
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
    """So many things are there.

    Attributes
    ----------
    exact, more, most : bool
        Neither more nor less; so many besides those that are there; no more, and fewer will do.
    """

    thing: Thing
    where: Scope = field(default_factory=Scope)
    exact: bool = False
    more: bool = False
    most: bool = False

    def __str__(self) -> str:
        if self.most:
            return f"at most {self.thing} {self.where}"
        manner = "exactly " if self.exact else "another " if self.more else ""
        return f"{manner}{self.thing} {self.where}"


@dataclass(frozen=True)
class AbsentFact:
    """Things are gone from there; an empty noun means everything, but for what is spared."""

    thing: Thing
    where: Scope = field(default_factory=Scope)
    spare: tuple[Thing, ...] = ()

    def __str__(self) -> str:
        what = str(self.thing) if self.thing.noun else "everything"
        if self.spare:
            what += f" but {' and '.join(thing.noun for thing in self.spare)}"
        return f"gone: {what} {self.where}"


@dataclass(frozen=True)
class MoveFact:
    """A thing that is there now stands elsewhere."""

    thing: Thing
    source: Scope
    target: Scope

    def __str__(self) -> str:
        return f"{self.thing} {self.source} moved to {self.target}"


@dataclass(frozen=True)
class StateFact:
    """A thing is open or closed, on or off."""

    thing: Thing
    where: Scope
    state: Literal["open", "on"]
    value: bool

    def __str__(self) -> str:
        word = {("open", True): "open", ("open", False): "closed", ("on", True): "on"}
        return f"{self.thing} {self.where} {word.get((self.state, self.value), 'off')}"


@dataclass(frozen=True)
class PathFact:
    """A way leads from one place to another; from the entrance, and to every room, where left out."""

    start: str = ""
    end: str = ""

    def __str__(self) -> str:
        return f"a way from {self.start or 'the entrance'} to {self.end or 'every room'}"


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
