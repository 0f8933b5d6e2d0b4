"""Read for which of several rooms furniture is: "one of them with a piano", "one with a desk, the other has two"."""

from dataclasses import dataclass, replace

from mansion_planner.brief.facts import BriefFacts, ObjectFact
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["SomeRooms", "furniture_of_each", "some_rooms"]

_EACH = frozenset({"each", "every", "all", "both", "any", "per", "either"})
_HAVING = frozenset({"with", "have", "has", "having", "get", "gets", "hold", "holds"})
_LEADS = frozenset({",", "-", "–", "—", ":", "(", ";", "and", "but", "while", "whereas"})
"""What stands before a number of rooms out of several: not "room one with a desk"."""
_ONES = frozenset({"another", "second", "third", "fourth", "last"})
_REST = frozenset({"other", "rest", "remaining"})


@dataclass(frozen=True)
class SomeRooms:
    """Which of several rooms have their share of furniture: so many, after those that were told of before.

    Attributes
    ----------
    many : int
        0 where all have.
    before : int
    """

    many: int = 0
    before: int = 0


def some_rooms(reading: Reading, room: Phrase | None, again: Phrase | None, phrase: Phrase) -> SomeRooms:
    """Return for which of the rooms of a phrase furniture is; the words that tell it are taken.

    Parameters
    ----------
    room, again : Phrase, optional
        What names the rooms first, and what does so last before the furniture.
    phrase : Phrase
        The furniture.
    """
    if room is None or again is None or again.last > phrase.first:
        return SomeRooms()
    if _EACH.isdisjoint(reading.words(again.last, phrase.first)) and (at := _some_of(reading, again)):
        reading.take(at, at + 1)
        return SomeRooms(int(reading.value(at)))
    if room.last > phrase.first:
        return SomeRooms()
    told, before, first, end = SomeRooms(), 0, 0, 0
    for index in range(room.last, phrase.first):
        if reading.word(index) in _EACH:
            told, end = SomeRooms(), 0
        many, last = _told_at(reading, room, index, before)
        if many and last <= phrase.first:
            told, first, end = SomeRooms(many, before), index, last
            before += many
    if told.many:
        reading.take(first, end)
    return told


def _told_at(reading: Reading, room: Phrase, index: int, before: int) -> tuple[int, int]:
    """Return how many rooms a token tells of, and the token after the words for them; 0 where it tells of none."""
    counts = reading.kind(index) == "number" and 1 <= reading.value(index) <= 100
    if counts and reading.words(index + 1, index + 3) in (("of", "them"), ("of", "which")):
        many = int(reading.value(index))
        return (many if many == 1 or reading.word(index + 3) in _HAVING else 0), index + 3
    several = room.plural or (room.counted and (room.count or 0) > 1)
    if not several or not (reading.word(index - 1) in _LEADS | {"the"} or index == room.last):
        return 0, index
    if counts and reading.word(index + 1) in _HAVING and reading.word(index - 1) in _LEADS:
        return int(reading.value(index)), index + 2
    if reading.word(index) in _REST and reading.word(index - 1) == "the":
        counted = reading.kind(index + 1) == "number"
        left = int(reading.value(index + 1)) if counted else _left(reading, room, index, before)
        led = reading.word(index + 1 + counted) in _HAVING
        return (left if led and left >= 1 else 0), index + 2 + counted
    one = reading.word(index) in _ONES and reading.word(index + 1) in _HAVING
    return int(one), index + 2


def _left(reading: Reading, room: Phrase, index: int, before: int) -> int:
    """Return how many "the other" or "the rest" are: one, or all that nothing was told of."""
    one = reading.word(index) == "other" and not reading.plural(index)
    return 1 if one else (room.count or 0) - before


def _some_of(reading: Reading, room: Phrase) -> int:
    """Return the token of the number in "one of the bedrooms" before a phrase; 0 where it has none."""
    at = room.begin - 1
    at -= reading.word(at) in _POINTS
    counts = reading.word(at) == "of" and reading.kind(at - 1) == "number" and room.plural and not room.counted
    return at - 1 if counts and 1 <= reading.value(at - 1) <= 100 else 0


_POINTS = frozenset({"the", "these", "those", "our", "my", "its"})


def furniture_of_each(facts: BriefFacts) -> list[ObjectFact]:
    """Return the furniture of a brief, that of a room which each of several others has for every such room.

    In "each group has a nap room with ten cots" the number is that of every nap room.
    """
    named = {room.name for room in facts.rooms}
    owners = [room for room in (*facts.rooms, *facts.households) if room.count != 1 or room.each]
    theirs = {child.name for room in owners for child in room.suite if child.count == 1} - named
    return [
        replace(thing, each=True)
        if thing.room in theirs and not (thing.each or thing.some or thing.excluded)
        else thing
        for thing in facts.objects
    ]
