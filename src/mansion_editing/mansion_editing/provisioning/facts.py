"""Facts that a task needs of a building: objects at places, and paths."""

from dataclasses import KW_ONLY, dataclass, field
from typing import Literal, TypeAlias

from mansion_language.inflection import plural

__all__ = ["Fact", "ObjectDescription", "ObjectFact", "PathFact", "Scope"]

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
            self.noun if self.count == 1 or "_" in self.noun else plural(self.noun),
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
