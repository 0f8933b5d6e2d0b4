"""Read what some of several rooms are to be: "toilets, one of them accessible", "12 rooms, two of which are large"."""

import itertools
from dataclasses import replace

from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.qualifiers import is_property
from mansion_planner.brief.reading import Reading
from mansion_planner.brief.sizes import is_size

__all__ = ["with_accessible_ones"]

_OPENERS = frozenset({",", "(", "-", "–", ":", "including", "incl", "with", "whereof", "thereof", "and"})
_VERBS = frozenset("is are be being must should shall will has have to need needs made built also".split())
_USERS = frozenset("disabled handicapped wheelchair impaired disability".split())
_FOLLOWERS = frozenset("people person guest user visitor patient customer access accessible use one toilet wc".split())
_HINDRANCES = frozenset({"barrier", "step"})
_TOILETS = frozenset({"toilet", "restroom"})
"""Room types of which one that a wheelchair can use is a type of its own."""


def with_accessible_ones(reading: Reading, phrases: list[Phrase]) -> list[Phrase]:
    """Return the phrases with the accessible toilets among several as rooms of their own.

    What some other rooms are to be is recorded as not understood, all its words together.
    """
    found: list[Phrase] = []
    read = 0
    for number, phrase in enumerate(phrases):
        if phrase.first < read:
            continue  # its words say what some of the rooms before are to be
        several = phrase.head == "room" and phrase.plural and (phrase.count or 2) > 1
        part = _part(reading, phrase.last) if several else None
        if part is None:
            found.append(phrase)
            continue
        first, count, begin, last = part
        accessible = begin < last and _accessible(reading, begin) == last
        following = itertools.islice(phrases, number + 1, number + 5)
        inside = any(other.first < last and other.head == "room" for other in following)
        if accessible and phrase.room_type in _TOILETS and count < (phrase.count or count + 1):
            read = last
            reading.take(phrase.last, last + (reading.word(last) == ")"))
            found.append(phrase if phrase.count is None else replace(phrase, count=phrase.count - count))
            label = f"accessible {reading.word(phrase.noun_end - 1)}"
            found.append(
                replace(
                    phrase, first=first, begin=begin, noun_end=last, last=last, room_type="accessible_toilet",
                    name="accessible_toilet", label=label, count=count, counted=True, plural=count > 1, areas=(),
                )
            )  # fmt: skip
            continue
        found.append(phrase)
        if not inside:
            read = last
            reading.facts.unread.append(reading.span(first, last))
            reading.take(first, last)
    return found


def _part(reading: Reading, index: int) -> tuple[int, int, int, int] | None:
    """Return where a part of rooms is told after them, how many it is, and the tokens that say what it is to be."""
    at = index
    while reading.word(at) in _OPENERS or (reading.word(at) == "." and not reading.breaks(at)):
        at += 1
    of_which = reading.words(at, at + 2) == ("of", "which")
    at += 2 * of_which
    first = at
    article = reading.word(at) in ("a", "an")
    value = reading.value(at)
    if at == index or not (article or (reading.kind(at) == "number" and 1 <= value <= 100 and value == int(value))):
        return None
    at += 1
    them = reading.word(at) == "of" and reading.word(at + 1) in ("them", "which", "these", "those")
    at += 2 * them
    while reading.word(at) in _VERBS:
        at += 1
    last = _accessible(reading, at)
    if last == at and (them or of_which):
        while is_property(reading.word(last)) or is_size(reading.word(last)):
            last += 1
    closes = reading.breaks(last) or reading.word(last) in (",", ")", "and", "but", "on", "in", "at", "plus", ";")
    if last == at or not closes or (article and reading.word(last - 1) != "one"):
        return None
    return first, 1 if article else int(value), at, last


def _accessible(reading: Reading, index: int) -> int:
    """Return where "wheelchair accessible", "barrier-free", "for disabled guests" end at a token; it, where not so."""
    at = index + (reading.word(index) in ("for", "suitable", "usable"))
    at += at > index and reading.word(at) in ("for", "by", "the")
    at += at > index and reading.word(at) == "the"
    users = at
    while reading.word(users) in _USERS:
        users += 1
    if users > at:
        while reading.word(users) in _FOLLOWERS:
            users += 1
        return users
    if reading.word(index) in _HINDRANCES and reading.word(index + 1) == "free":
        return index + 2 + (reading.word(index + 2) == "one")
    if reading.word(index) == "accessible":
        last = index + 1 + (reading.word(index + 1) == "one")
        by_wheelchair = reading.word(last) in ("by", "for", "to", "with") and reading.word(last + 1) in (
            "wheelchair", "wheelchairs", "disabled",
        )  # fmt: skip
        return last + 2 * by_wheelchair
    return index
