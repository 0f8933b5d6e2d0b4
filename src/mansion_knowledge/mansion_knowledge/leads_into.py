"""Pairs of rooms with a door between them because of what people do there, such as a kitchen and its store."""

import re
from dataclasses import dataclass
from functools import cache, lru_cache
from importlib.resources import files

import msgspec

from mansion_knowledge.base import default_knowledge
from mansion_msgs_py.codec import prepared

__all__ = ["CalledRoom", "leading_rules"]


@dataclass(frozen=True)
class CalledRoom:
    """A room's type, and what people call it."""

    room_type: str
    name: str = ""


class _Rule(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    why: str
    rooms: list[str]
    into: list[str]
    families: list[str] = []


class _Rules(msgspec.Struct, frozen=True, forbid_unknown_fields=True):
    rule: list[_Rule]


@cache
def _rules() -> tuple[_Rule, ...]:
    text = files("mansion_knowledge").joinpath("data", "leads_into.toml").read_bytes()
    return tuple(msgspec.toml.decode(text, type=prepared(_Rules)).rule)


@lru_cache(maxsize=8192)
def leading_rules(room: CalledRoom, into: CalledRoom, family: str = "") -> tuple[int, ...]:
    """Return the numbers of the rules by which a room leads into another; none where no door belongs between them.

    Parameters
    ----------
    room, into : CalledRoom
    family : str
        Family of the building's type.

    Examples
    --------
    >>> bool(leading_rules(CalledRoom("commercial_kitchen"), CalledRoom("cafeteria"), "office"))
    True
    >>> bool(leading_rules(CalledRoom("assembly_hall"), CalledRoom("storage", "chair store"), "civic"))
    True
    >>> leading_rules(CalledRoom("assembly_hall"), CalledRoom("storage"), "civic")
    ()
    >>> leading_rules(CalledRoom("changing_room", "men's changing room"), CalledRoom("shower_area", "women's shower"))
    ()
    """
    if _are_apart(room.name, into.name):
        return ()
    return tuple(
        number
        for number, rule in enumerate(_rules())
        if (not rule.families or family in rule.families) and _is_one(room, rule.rooms) and _is_one(into, rule.into)
    )


_MALE = frozenset({"man", "men", "mens", "boy", "boys", "gents", "gentlemen", "male"})
_FEMALE = frozenset({"woman", "women", "womens", "girl", "girls", "ladies", "lady", "female"})


def _are_apart(name: str, other: str) -> bool:
    """Whether one of two rooms is for men and the other for women."""
    words, others = (set(re.findall("[a-z]+", text.lower().replace("'", ""))) for text in (name, other))
    return bool((words & _MALE and others & _FEMALE) or (words & _FEMALE and others & _MALE))


def _is_one(room: CalledRoom, names: list[str]) -> bool:
    """Whether a room is of one of the types, or is called by one of the names."""
    known = default_knowledge().rooms
    called = f" {' '.join(re.findall('[a-z]+', room.name.lower()))} "
    return room.room_type in names or any(name not in known and f" {name} " in called for name in names)
