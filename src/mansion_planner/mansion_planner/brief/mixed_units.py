"""Read flats of several sizes told one by one: "three flats each, of which one has one bedroom, two have two"."""

from dataclasses import dataclass, replace

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["Share", "parted", "shares_of"]

_HAVING = frozenset({"has", "have", "with", "of", "having"})
_PASSED = frozenset({",", ";", ":", "and", "of", "which", "them", "these", "those", "the", "in", "(", "where", "each"})
_BEDROOMS = frozenset({"bedroom", "bed", "bedroomed", "room"})
_REACH = 14
"""Tokens between the flats and what is said of the first of them, at most."""
_FILLERS = 6
"""Words between a number of flats and that of their bedrooms, at most: "the two on the park side have one"."""
_MOST_BEDROOMS = 6


@dataclass(frozen=True)
class Share:
    """Some of several flats: the token of their number, how many they are, that of their bedrooms, and how many."""

    first: int
    count: int
    bedrooms: int
    last: int
    beds: int


def shares_of(reading: Reading, unit: Phrase) -> list[Share]:
    """Return the shares of some flats, where they are all told of; else an empty list."""
    if not unit.counted or (unit.count or 0) < 2:
        return []
    for start in range(unit.last, min(unit.last + _REACH, len(reading.tokens))):
        if reading.kind(start) != "number" or start in reading.taken:
            continue
        shares = _shares(reading, start)
        if len(shares) > 1 and sum(share.count for share in shares) == unit.count:
            return shares
    return []


def _shares(reading: Reading, index: int) -> list[Share]:
    found: list[Share] = []
    while reading.kind(index) == "number" and reading.value(index) < 20:
        share = _share(reading, index, told=bool(found))
        if share is None:
            break
        found.append(share)
        index = share.last
        while reading.word(index) in _PASSED:
            index += 1
    return found


def _share(reading: Reading, index: int, *, told: bool) -> Share | None:
    """Return "one has two bedrooms" at a token; after the first share the verb and the noun may be left out."""
    at, has = index + 1, False
    while at - index <= _FILLERS and reading.kind(at) == "word":
        has = has or reading.word(at) in _HAVING
        at += 1
    beds = reading.value(at) if reading.kind(at) == "number" else 0.0
    if not (has or (told and at > index + 1)) or not 1 <= beds <= _MOST_BEDROOMS:
        return None
    named = reading.word(at + 1) in _BEDROOMS
    last = at + 1 + named
    last += reading.word(last) == "each"
    if not named and not told:
        return None
    return Share(index, int(reading.value(index)), at, last, int(beds))


def parted(unit: Phrase, share: Share) -> Phrase:
    """Return the phrase of some of the flats."""
    return replace(
        unit, first=share.first, begin=share.first, noun_end=share.first + 1, last=share.first + 1, count=share.count
    )
