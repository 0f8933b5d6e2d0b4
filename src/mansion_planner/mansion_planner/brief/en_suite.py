"""Read which bedrooms have a bathroom: "five ensuite bedrooms", "four bedrooms, of which one with its own bathroom"."""

import re
from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Final

from mansion_planner.brief.facts import RoomFact, Span
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.suites import PRIVATE, SLEEPING

__all__ = ["bathroom_of_some", "with_bathrooms_by_name", "with_some_en_suite"]

_CALLED: Final = re.compile(r"\ben[- ]?suite\b", re.IGNORECASE)

_BATHROOM: Final = "ensuite_bathroom"


def with_bathrooms_by_name(fact: RoomFact) -> RoomFact:
    """Return rooms to sleep in whose name says that each has a bathroom with that bathroom; others as they are.

    Examples
    --------
    >>> fact = RoomFact("bedroom", "ensuite_bedroom", Span("five ensuite bedrooms", 0, 21), 5)
    >>> with_bathrooms_by_name(fact).suite[0].span
    Span(words='ensuite', start=5, end=12)
    """
    called = _CALLED.search(fact.span.words)
    if called is None or fact.room_type not in SLEEPING or any(child.room_type in PRIVATE for child in fact.suite):
        return fact
    start = fact.span.start + called.start()
    span = Span(called[0], start, fact.span.start + called.end())
    return replace(fact, suite=(*fact.suite, RoomFact(_BATHROOM, _BATHROOM, span, label="ensuite bathroom")))


_OPENERS = frozenset({",", "(", "-", "–", ":", ";"})
_PARTS = frozenset({"which", "them", "these", "those", "whom"})
_MAIN = frozenset("main master principal largest biggest larger bigger parental guest first".split())
_HAVING = frozenset({"with", "has", "have", "having", "get", "getting"})
_VERBS = frozenset("is are be being shall should must will to need".split()) | _HAVING
_OF_THE_ROOM = frozenset("the its an a own private attached separate with small en suite their each".split())


@dataclass(frozen=True)
class _Part:
    """Some of several rooms: tokens `first` to `last` (exclusive) name them, as a phrase of their own or not."""

    first: int
    last: int
    count: int
    named: Phrase | None = None


def with_some_en_suite(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases with those of several rooms to sleep in that have a bathroom as rooms of their own.

    "Three bedrooms, out of which the master bedroom is having attached bathroom" are two bedrooms and a master bedroom
    with a bathroom; what owns the bathroom is read from the words between the two.
    """
    found: list[Phrase] = []
    for phrase in phrases:
        if any(other.begin == phrase.begin for other in found):
            continue  # the room that is singled out
        several = phrase.head == "room" and phrase.counted and (phrase.count or 0) > 1 and phrase.room_type in SLEEPING
        part = _part(reading, phrases, phrase) if several else None
        if part is None or part.count >= (phrase.count or 0):
            found.append(phrase)
            continue
        reading.take(phrase.last, part.last)
        found += [replace(phrase, count=(phrase.count or 0) - part.count), _singled_out(phrase, part)]
    return found


def bathroom_of_some(reading: Reading, phrases: Sequence[Phrase], some: Phrase) -> Phrase | None:
    """Return the bathroom that rooms have which are singled out of several, as many as there are of them.

    Parameters
    ----------
    some : Phrase
        "Two" of "three bedrooms, out of which two are with attached bathroom".
    """
    end = some.last
    while reading.word(end) in _VERBS | _OF_THE_ROOM:
        end += 1
    owned = next((p for p in phrases if p.first <= end <= p.begin + 1 and p.room_type in PRIVATE), None)
    if owned is None or _HAVING.isdisjoint(reading.words(some.last, end)):
        return None
    many = max(some.count or 1, owned.count or 1)
    return replace(owned, count=many, counted=True, plural=many > 1)


def _singled_out(phrase: Phrase, part: _Part) -> Phrase:
    """Return the phrase of the rooms that have a bathroom."""
    if part.named is not None:
        return replace(part.named, determiner="")
    noun = phrase.name.rpartition("_")[2]
    return replace(
        phrase, first=part.first, begin=part.first, noun_end=part.last, last=part.last, count=part.count, counted=True,
        plural=part.count > 1, determiner="each" if part.count > 1 else "", name=f"{noun}_suite",
        label=f"{noun} suite", areas=(),
    )  # fmt: skip


def _part(reading: Reading, phrases: list[Phrase], phrase: Phrase) -> _Part | None:
    """Return the rooms that a clause after several says to have a bathroom, if it says so of some."""
    at = phrase.last
    while reading.word(at) in _OPENERS:
        at += 1
    at += reading.word(at) == "out"
    of_which = reading.word(at) == "of" and reading.word(at + 1) in _PARTS
    at += 2 * of_which
    if at == phrase.last:
        return None
    part = _subject(reading, phrases, at, of_which=of_which)
    if part is None:
        return None
    end = part.last
    while reading.word(end) in _VERBS:
        end += 1
    if _is_bracketed_ensuite(reading, phrases, phrase, part):
        return part
    if _HAVING.isdisjoint(reading.words(part.last, end)):
        return None
    while reading.word(end) in _OF_THE_ROOM:
        end += 1
    owned = any(p.first <= end <= p.begin + 1 and p.room_type in PRIVATE for p in phrases)
    return part if owned else None


def _is_bracketed_ensuite(reading: Reading, phrases: list[Phrase], phrase: Phrase, part: _Part) -> bool:
    """Whether a bracket only tells how many are en suite: "three bedrooms (one en-suite)"."""
    if reading.word(phrase.last) != "(" or part.named is not None:
        return False
    return any(p.begin == part.last and p.room_type == "ensuite_bathroom" for p in phrases)


def _subject(reading: Reading, phrases: list[Phrase], at: int, *, of_which: bool) -> _Part | None:
    """Return what "one", "two of them", "the master bedroom" or "the main one" at a token singles out."""
    value = reading.value(at)
    if reading.kind(at) == "number" and value == int(value) >= 1:
        of_them = reading.word(at + 1) == "of" and reading.word(at + 2) in _PARTS
        return _Part(at, at + 1 + 2 * of_them, int(value))
    definite = reading.word(at) in ("the", "our", "its")
    begin = at + definite
    named = next((p for p in phrases if p.begin == begin and p.head == "room" and p.room_type in SLEEPING), None)
    if named is not None:
        single = named.count == 1 and not named.plural
        return _Part(at, named.last, 1, named) if single and (definite or of_which) else None
    if definite and reading.word(begin) in _MAIN and reading.word(begin + 1) == "one":
        return _Part(at, begin + 2, 1)
    return None
