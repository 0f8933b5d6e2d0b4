"""What a room cannot be used without: a bathroom's toilet, washbasin and shower or bathtub."""

import re
from collections.abc import Collection, Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from importlib.resources import files
from typing import Final

import msgspec

from mansion_knowledge.object_kinds import answers, seats_of_row, substitutes
from mansion_knowledge.room_names import kin_of
from mansion_msgs_py.codec import prepared

__all__ = ["Need", "Thing", "needs_of", "pieces_there", "still_wanted"]

_BUNKS: Final = 2
"""People who sleep in a bunk bed."""


@dataclass(frozen=True)
class Thing:
    """Something that a room needs, and the categories of objects that are it, the most usual first.

    Attributes
    ----------
    place : float
        Width of one person's place on an object that has several, metres; 0 where it counts as one.
    most : int
        Most places on one object.
    """

    name: str
    categories: tuple[str, ...]
    place: float = 0.0
    most: int = 1

    def pieces(self, category: str, width: float) -> int:
        """Return how many of the thing an object of a category and a width is, 0 where it is none."""
        if category not in self.categories:
            return 0
        if category == "bunk_bed":
            return _BUNKS
        by_width = int(width / self.place + 1e-6) if self.place else 1
        return max(1, min(by_width, self.most), seats_of_row(category, width))


@dataclass(frozen=True)
class Need:
    """So many of any of some things."""

    things: tuple[Thing, ...]
    count: int = 1

    @property
    def name(self) -> str:
        """What is needed, in words.

        Examples
        --------
        >>> [need.name for need in needs_of("bathroom")]
        ['toilet', 'washbasin', 'shower or bathtub']
        """
        return " or ".join(thing.name for thing in self.things)

    @property
    def categories(self) -> tuple[str, ...]:
        """Categories of objects that meet it, the most usual first."""
        return tuple(dict.fromkeys(category for thing in self.things for category in thing.categories))

    def pieces(self, category: str, width: float) -> int:
        """Return how much of the need an object of a category and a width meets."""
        return max(thing.pieces(category, width) for thing in self.things)


class _ThingRecord(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    of: list[str]
    place: float = 0.0
    most: int = 1


class _Use(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    why: str
    needs: list[str]
    rooms: list[str] = []
    names: list[str] = []


class _Essentials(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    things: dict[str, _ThingRecord]
    use: list[_Use]


@cache
def _tables() -> tuple[Mapping[str, tuple[Need, ...]], Mapping[str, tuple[Need, ...]]]:
    """Return the needs by room type, and by what people call a room."""
    text = files("mansion_knowledge").joinpath("data", "room_essentials.toml").read_bytes()
    data = msgspec.toml.decode(text, type=prepared(_Essentials))
    things = {name: _thing(name, record) for name, record in data.things.items()}
    by_type, by_name = dict[str, tuple[Need, ...]](), dict[str, tuple[Need, ...]]()
    for use in data.use:
        needs = tuple(_need(text, things) for text in use.needs)
        by_type |= dict.fromkeys(use.rooms, needs)
        by_name |= dict.fromkeys(use.names, needs)
    return by_type, by_name


def _thing(name: str, record: _ThingRecord) -> Thing:
    categories = [category for head in record.of for category in (head, *substitutes(head))]
    return Thing(name, tuple(dict.fromkeys(categories)), record.place, record.most)


def _need(text: str, things: Mapping[str, Thing]) -> Need:
    names, _, count = text.partition(":")
    return Need(tuple(things[name] for name in names.split("|")), int(count or 1))


def needs_of(room_type: str, names: Iterable[str] = ()) -> tuple[Need, ...]:
    """Return what a room cannot be used without.

    Parameters
    ----------
    room_type : str
        A type that is not known has no needs; one of the user's own has those of its kin.
    names : iterable of str
        What people call the room. "Shower room" or "twin room" says more than the type that it is planned as.

    Examples
    --------
    >>> [need.name for need in needs_of("bathroom", ["Shower Room"])]
    ['shower']
    """
    by_type, by_name = _tables()
    for name in names:
        plain = re.sub(r"_?\d+$", "", re.sub(r"[\W_]+", "_", name.lower()).strip("_"))
        if plain in by_name:
            return by_name[plain]
    return by_type.get(room_type) or by_type.get(kin_of(room_type), ())


def still_wanted(needs: Iterable[Need], unwanted: Collection[str]) -> list[Need]:
    """Return the needs that a brief does not rule out by saying that a room has none of something."""

    def ruled_out(thing: Thing) -> bool:
        return any(answers(category, thing.categories[0]) for category in unwanted)

    return [need for need in needs if not all(ruled_out(thing) for thing in need.things)]


def pieces_there(need: Need, objects: Iterable[tuple[str, float]]) -> int:
    """Return how much of a need is met by objects, each a category and a width in metres.

    Examples
    --------
    >>> pieces_there(needs_of("master_bedroom")[0], [("bed", 1.6)])
    2
    """
    return sum(need.pieces(category, width) for category, width in objects)
