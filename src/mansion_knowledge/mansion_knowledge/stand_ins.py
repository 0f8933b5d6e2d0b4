"""Names in whose place another thing that is known is built: a sofa for a sofa bed, a garage for a carport."""

from functools import cache
from importlib.resources import files
from typing import Literal, TypeAlias

import msgspec

from mansion_msgs_py.codec import prepared

__all__ = ["StandInKind", "answers_when_told", "is_for_animals", "is_for_another_subject", "stands_in"]

StandInKind: TypeAlias = Literal["rooms", "buildings", "objects"]


class _Subjects(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    nouns: list[str]
    shown: list[str]


class _Animals(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    rooms: list[str]
    words: list[str]


class _StandIns(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    rooms: dict[str, list[str]]
    buildings: dict[str, list[str]]
    objects: dict[str, list[str]]
    told: dict[str, list[str]]
    usual: dict[str, list[str]]
    animals: _Animals
    subjects: dict[str, _Subjects]


@cache
def _stand_ins() -> _StandIns:
    text = files("mansion_knowledge").joinpath("data", "stand_ins.toml").read_bytes()
    return msgspec.toml.decode(text, type=prepared(_StandIns))


def stands_in(kind: StandInKind, type_: str, name: str, family: str = "") -> bool:
    """Whether a type only stands in the place of what a name says.

    Parameters
    ----------
    kind : {"rooms", "buildings", "objects"}
    type_ : str
        Room type, building type or category of objects.
    name : str
        What people call it, in the singular, in snake case or words.
    family : str
        That of the building a room is in: the open space of an office is an open office, that of a home is none.

    Examples
    --------
    >>> stands_in("objects", "sofa", "corner sofa"), stands_in("objects", "sofa", "couch")
    (True, False)
    >>> stands_in("rooms", "garage", "double_carport"), stands_in("rooms", "garage", "garage")
    (True, False)
    """
    if kind == "rooms" and family in _stand_ins().usual.get(type_, ()):
        return False
    words = name.lower().replace("_", " ").replace("-", " ").split()
    known: dict[str, list[str]] = getattr(_stand_ins(), kind)
    return any(words[-len(other.split()) :] == other.split() for other in known.get(type_, ()))


def answers_when_told(room_type: str) -> bool:
    """Whether a room type is what a name asks for in which a word tells it: a common room is a youth room.

    Examples
    --------
    >>> answers_when_told("common_room"), answers_when_told("laboratory")
    (True, False)
    """
    return room_type in _stand_ins().told["rooms"]


def is_for_animals(room_type: str, name: str) -> bool:
    """Whether a room's name, in snake case, says that animals live in it, and its type has furniture for people alone.

    Examples
    --------
    >>> is_for_animals("hospital_ward", "bird_ward"), is_for_animals("kennel", "dog_ward")
    (True, False)
    """
    animals = _stand_ins().animals
    return room_type not in animals.rooms and not set(name.split("_")).isdisjoint(animals.words)


def is_for_another_subject(room_type: str, noun: str, word: str) -> bool:
    """Whether a word before the noun of a room's name is about what the furniture of its type has nothing of.

    Examples
    --------
    >>> is_for_another_subject("gallery", "gallery", "jellyfish"), is_for_another_subject("gallery", "gallery", "art")
    (True, False)
    """
    known = _stand_ins().subjects.get(room_type)
    return known is not None and noun in known.nouns and word not in known.shown
