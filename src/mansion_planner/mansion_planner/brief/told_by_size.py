"""Read the one of several rooms that a brief tells by its size: "two bedrooms; the larger bedroom is 16 m2"."""

from dataclasses import dataclass, replace

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["COMPARATIVES", "ToldBySize", "told_by_size"]

COMPARATIVES = frozenset("larger bigger smaller largest biggest smallest".split())
"""Adjectives that tell one of several rooms by its size."""


@dataclass(frozen=True)
class ToldBySize:
    """Rooms that are told by their size.

    Attributes
    ----------
    phrases : list of Phrase
        All phrases; of the rooms that one was told of there is one less.
    others : dict of int to int
        First tokens of the rooms told by their size, and of the phrase of the others.
    """

    phrases: list[Phrase]
    others: dict[int, int]


def told_by_size(reading: Reading, phrases: list[Phrase]) -> ToldBySize:
    """Make a room of its own of each that "the larger bedroom" and the like tell among several."""
    found = list(phrases)
    others: dict[int, int] = {}
    for number, phrase in enumerate(phrases):
        kind = _kind_of_one(reading, phrase)
        if not kind or any(other.name == phrase.name for other in phrases[:number]):
            continue
        several = next((n for n in reversed(range(number)) if _are_several(phrases[n], kind)), None)
        if several is not None and (left := (found[several].count or 1) - 1) >= 0:
            room = found[several]
            found[several] = replace(room, count=left) if left else replace(room, head="unknown", count=1)
            others[phrase.first] = room.first
        elif not _taken_from_number(reading, kind):
            continue
        found[number] = replace(phrase, determiner="a", count=1)
    return ToldBySize(found, others)


def _kind_of_one(reading: Reading, phrase: Phrase) -> str:
    """Return the name of the rooms that a phrase tells one of: "bedroom" of "the larger bedroom"; or nothing."""
    size, _, kind = phrase.name.partition("_")
    single = phrase.head == "room" and phrase.determiner == "the" and not (phrase.plural or phrase.counted)
    return kind if single and size in COMPARATIVES else ""


def _are_several(phrase: Phrase, kind: str) -> bool:
    alike = phrase.head in ("room", "building") and phrase.name == kind and len(phrase.areas) < 2
    return alike and phrase.counted and (phrase.count or 0) > 1


def _taken_from_number(reading: Reading, kind: str) -> bool:
    """Take one from the number of rooms that the building's name tells: "a two-bed flat"; return whether there is."""
    rooms = reading.facts.rooms
    for at, fact in enumerate(rooms):
        if fact.name == kind and (fact.count or 0) > 1:
            rooms[at] = replace(fact, count=(fact.count or 2) - 1)
            return True
    return False
