"""Read the areas of some of several rooms: "two bedrooms (the larger 16 m2)", "ours 18 m2, the two for the boys 13"."""

from dataclasses import replace

from mansion_planner.brief.area_words import Measure
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.sizes import is_size
from mansion_planner.brief.told_by_size import COMPARATIVES

__all__ = ["with_one_sized"]

_OPENERS = frozenset({",", "(", "-", "–", ";", ":"})
_PARTS = frozenset({"which", "them", "these", "those"})
_LEADS = frozenset(
    """
    is being be should shall must with at of about around approx roughly ca circa some measuring has ( one to and a an
    """.split()
)
"""Words between the room that is told and its area."""
_MOST_LEADS = 6


def with_one_sized(reading: Reading, measures: list[Measure], phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases with those of several rooms whose area is told apart as phrases of their own.

    The areas read are added to `reading.named_areas`.
    """
    begins = {measure.first: measure for measure in measures if len(measure.values) == 1 and not measure.sides}
    found: list[Phrase] = []
    owned: set[int] = set()
    for phrase in phrases:
        if phrase.first in owned:
            continue
        parts = _owners_parts(reading, phrase, begins) if _are_several(phrase) else []
        if parts:
            left = (phrase.count or 0) - sum(many for many, _, _ in parts)
            if left:
                found.append(replace(phrase, count=left, plural=left > 1))
            for many, first, measure in parts:
                _take(reading, first, measure)
                owned.update(range(first, measure.last))
                own = replace(phrase, first=first, begin=first, noun_end=measure.last, last=measure.last)
                found.append(replace(own, count=many, plural=many > 1, areas=measure.values, limit=measure.limit))
            continue
        told = _told(reading, phrase, begins) if _are_several(phrase) else None
        if told is None:
            found.append(phrase)
            continue
        many, first, measure = told
        _take(reading, first, measure)
        left = (phrase.count or 0) - many
        rank = next((word for word in reading.words(first, measure.first) if word in COMPARATIVES), "")
        own = replace(phrase, first=first, begin=first, noun_end=measure.last, last=measure.last)
        if rank:
            own = replace(own, name=f"{rank}_{phrase.name}", label=f"{rank} {phrase.name.replace('_', ' ')}")
        found += [
            replace(phrase, count=left, plural=left > 1),
            replace(own, count=many, plural=many > 1, areas=measure.values, limit=measure.limit),
        ]
    return found


def _take(reading: Reading, first: int, measure: Measure) -> None:
    reading.take(first, measure.last)
    reading.named_areas.add(measure.first)


_MOST_TOLD = 60
"""Tokens after several rooms in which it is told whose each is."""
_OWN = frozenset({"ours", "mine", "his", "hers", "theirs"})
"""Whose one of several rooms is, in the place of its noun."""


def _owners_parts(reading: Reading, phrase: Phrase, begins: dict[int, Measure]) -> list[tuple[int, int, Measure]]:
    """Return the parts of several rooms that are told by whose they are: how many, the first token and the area each.

    "Three bedrooms - ours 18 m2 with a bathroom, the two for the boys 13 m2 each".
    """
    found: list[tuple[int, int, Measure]] = []
    at = phrase.last
    while at - phrase.last < _MOST_TOLD and not reading.breaks(at):
        opens = reading.word(at - 1) in _OPENERS | {"and"}
        many, end = _owner_at(reading, at) if opens else (0, at)
        while many and end not in begins and _leads(reading, end) and end - at < _MOST_LEADS + 4:
            end += 1
        if many and end in begins:
            found.append((many, at, begins[end]))
            at = begins[end].last
        else:
            at += 1
    return found if sum(many for many, _, _ in found) <= (phrase.count or 0) else []


def _owner_at(reading: Reading, index: int) -> tuple[int, int]:
    """Return how many rooms "ours" or "the two for the boys" at a token are, and where that ends; 0 for neither."""
    if reading.word(index) in _OWN:
        return 1, index + 1
    counted = reading.word(index) == "the" and reading.kind(index + 1) == "number"
    if not (counted and reading.word(index + 2) == "for"):
        return 0, index
    noun = index + 3 + (reading.word(index + 3) in ("the", "our", "my"))
    return int(reading.value(index + 1)), noun + 1


def _are_several(phrase: Phrase) -> bool:
    rooms = phrase.head in ("room", "building") and bool(phrase.room_type)
    return rooms and phrase.counted and (phrase.count or 0) > 1 and not phrase.areas


def _told(reading: Reading, phrase: Phrase, begins: dict[int, Measure]) -> tuple[int, int, Measure] | None:
    """Return how many of some rooms are told after them, the first token of that, and their area; if any are."""
    first = phrase.last
    while reading.word(first) in _OPENERS:
        first += 1
    value = reading.value(first)
    at, many = first, 1
    if reading.kind(first) == "number" and first not in begins and 1 <= value < (phrase.count or 0):
        if reading.word(first + 1) != "of" or reading.word(first + 2) not in _PARTS:
            return None
        at, many = first + 3, int(value)
    elif _is_the_larger(reading, first):
        at = first + 2
    else:
        return None
    end = at
    while end not in begins and end - at < _MOST_LEADS and _leads(reading, end):
        end += 1
    return (many, first, begins[end]) if end in begins and first > phrase.last else None


def _is_the_larger(reading: Reading, index: int) -> bool:
    """Whether "the larger" stands at a token, and no noun or "one" after it, which makes a phrase of its own."""
    larger = reading.word(index) == "the" and reading.word(index + 1) in COMPARATIVES
    return larger and (reading.kind(index + 2) == "number" or reading.word(index + 2) in _LEADS - {"one"})


def _leads(reading: Reading, index: int) -> bool:
    word = reading.word(index)
    return word in _LEADS | COMPARATIVES or is_size(word)
