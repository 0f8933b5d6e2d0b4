"""Leave out what a brief names and takes back: "a library, no, a bookshop", "a lab - I mean a workshop".

What is named last takes the place of the first, with its number where it has none of its own.
"""

from collections.abc import Sequence
from dataclasses import replace

from mansion_planner.brief.corrections import PAUSES, WEAK, sign_at
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["without_retractions"]

_KINDS = {"room": "place", "building": "place", "object": "thing", "unknown": "thing"}
_ARTICLES = frozenset({"a", "an", "the", "one"})
_LEADS = frozenset({"in", "on", "at", "for", "of"})
_NEEDS_PAUSE = WEAK - {("actually",)}
"""Signs that only a pause after them tells from "no bookshop" and "rather a bookshop"."""


def without_retractions(reading: Reading, phrases: Sequence[Phrase]) -> list[Phrase]:
    """Return the phrases without those that are taken back; the words that take them back are read."""
    found: list[Phrase] = []
    begins = {phrase.begin: number for number, phrase in enumerate(phrases)}
    number = 0
    while number < len(phrases):
        phrase = phrases[number]
        start = _instead(reading, phrase.last)
        later = begins.get(start, -1) if start else -1
        if later <= number or not _alike(phrase, phrases[later]):
            found.append(phrase)
            number += 1
            continue
        new = phrases[later]
        reading.take(phrase.first, new.first)
        if reading.word(new.last) in PAUSES and reading.word(new.last + 1) in _LEADS:
            new = replace(new, last=new.last + 1)  # "a sofa, no, an armchair, in the hall"
        if phrase.counted and not new.counted:
            new = replace(new, count=phrase.count, counted=True)
        phrases = [*phrases[:later], new, *phrases[later + 1 :]]
        number = later
    return found


def _alike(old: Phrase, new: Phrase) -> bool:
    return _KINDS.get(old.head, "") == _KINDS.get(new.head, "-") and old.name != new.name


def _instead(reading: Reading, index: int) -> int:
    """Return where what is wanted instead begins, its article and number left out; 0 where nothing is taken back."""
    at = _after_pauses(reading, index)
    paused, first, sure = at > index, at, False
    while (sign := sign_at(reading.tokens, at)) is not None:
        after = _after_pauses(reading, at + len(sign))
        sure = sure or sign not in _NEEDS_PAUSE or after > at + len(sign)
        at = after
    if at == first or not paused or not sure:
        return 0
    while reading.word(at) in _ARTICLES or reading.kind(at) == "number":
        at += 1
    return at


def _after_pauses(reading: Reading, index: int) -> int:
    while reading.word(index) in PAUSES:
        index += 1
    return index
