"""Read the one of several rooms that a brief tells by its rank: "two bedrooms; the larger bedroom", "the main one"."""

from dataclasses import dataclass, replace
from typing import Literal, TypeAlias

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["COMPARATIVES", "Rank", "ToldBySize", "rank_of", "told_by_size"]

COMPARATIVES = frozenset("larger bigger smaller largest biggest smallest".split())
"""Adjectives that tell one of several rooms by its size."""

Rank: TypeAlias = Literal["", "largest", "smallest"]
"""What a room is to be among those of its kind."""


def rank_of(word: str) -> Rank:
    """Return the rank that an adjective says; empty for none.

    Examples
    --------
    >>> [rank_of(word) for word in ("bigger", "smallest", "large")]
    ['largest', 'smallest', '']
    """
    if word not in COMPARATIVES:
        return ""
    return "smallest" if word.startswith("small") else "largest"


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
        if several is not None and phrase.room_type == "master_bedroom" and _are_in_unit(reading, phrases, several):
            continue
        if several is not None and (left := (found[several].count or 1) - 1) >= 0:
            room = found[several]
            found[several] = replace(room, count=left) if left else replace(room, head="unknown", count=1)
            others[phrase.first] = room.first
        elif phrase.room_type == "master_bedroom" or not _is_of_number(reading, kind):
            continue
        found[number] = replace(phrase, determiner="a", count=1)
    return ToldBySize(found, others)


def _kind_of_one(reading: Reading, phrase: Phrase) -> str:
    """Return the name of the rooms that a phrase tells one of: "bedroom" of "the larger bedroom"; or nothing."""
    size, _, kind = phrase.name.partition("_")
    single = phrase.head == "room" and phrase.determiner == "the" and not (phrase.plural or phrase.counted)
    if single and phrase.room_type == "master_bedroom":
        return "bedroom"  # "three bedrooms; the main bedroom has a bathroom"
    return kind if single and size in COMPARATIVES else ""


def _are_several(phrase: Phrase, kind: str) -> bool:
    alike = phrase.head in ("room", "building") and phrase.name == kind and len(phrase.areas) < 2
    return alike and phrase.counted and (phrase.count or 0) > 1


def _are_in_unit(reading: Reading, phrases: list[Phrase], number: int) -> bool:
    """Whether rooms are what a flat or another unit holds: "a penthouse residence with three bedrooms"."""
    sentence = reading.sentence[phrases[number].first]
    before = [phrase for phrase in phrases[:number] if reading.sentence[phrase.first] == sentence]
    rooms = reading.knowledge.rooms
    return any(phrase.head == "room" and rooms[phrase.room_type].unit for phrase in before if phrase.room_type)


def _is_of_number(reading: Reading, kind: str) -> bool:
    """Whether the building's name tells how many such rooms there are, "a two-bed flat": this is one of them."""
    return any(fact.name == kind and (fact.count or 0) > 1 for fact in reading.facts.rooms)
