"""Read how large rooms are to be in words: "a large kitchen", "the bedrooms should be spacious", "a tiny office".

Such a word bounds the area by the usual one of the kind of room. Words that no room is found for, and those of which a
text asks for more or for less than they say ("as large as possible", "not too small"), stay unread.
"""

from collections.abc import Sequence
from dataclasses import replace
from typing import Literal, TypeAlias

from mansion_planner.brief.bounds import Limit
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["Size", "is_size", "size_bound", "size_of", "sized"]

Size: TypeAlias = Literal["", "large", "small"]
"""How large a room is to be, compared with the usual ones of its kind."""

_LARGE = frozenset(
    "large big huge vast spacious generous roomy ample oversized enormous sizeable sizable giant sprawling".split()
)
_SMALL = frozenset("small little tiny compact modest petite mini".split())
_LARGER, _SMALLER, _TIGHTER = 1.2, 0.85, 1.2
"""Shares of the usual area of its kind that bound large and small rooms, and of the least one: such are small."""
_BE = frozenset({"be", "is", "are"})
_NEGATIONS = frozenset({"not", "too", "nor", "never"})
_DEGREES = frozenset({"very", "quite", "rather", "really", "fairly", "extra", "pretty"})


def size_bound(size: Size, least: float, usual: float) -> tuple[float, Limit]:
    """Return the area that bounds a room of a size, and which way.

    Parameters
    ----------
    least, usual : float
        Areas of such rooms where nothing is said of them, square metres.

    Examples
    --------
    >>> size_bound("large", 6.0, 10.0), size_bound("small", 8.0, 20.0), size_bound("small", 2.5, 3.0)
    ((12.0, 'least'), (17.0, 'most'), (3.0, 'most'))
    """
    if not size:
        return usual, ""
    if size == "large":
        return round(_LARGER * usual, 1), "least"
    return round(min(max(_SMALLER * usual, _TIGHTER * least), usual), 1), "most"


def is_size(word: str) -> bool:
    """Whether a word says how large a thing is."""
    return word in _LARGE | _SMALL


def sized(reading: Reading, phrases: Sequence[Phrase], building: int | None) -> list[Phrase]:
    """Return the phrases, those of rooms with their sizes; the words of sizes that follow their room are taken.

    Parameters
    ----------
    building : int, optional
        The phrase that names the building itself.
    """
    return [
        _with_size(reading, phrase) if number != building and _is_room(reading, phrase) else phrase
        for number, phrase in enumerate(phrases)
    ]


def _is_room(reading: Reading, phrase: Phrase) -> bool:
    """Whether a phrase names single rooms: a flat's usual area is that of none of its rooms."""
    return (
        phrase.head in ("room", "building")
        and bool(phrase.room_type)
        and not reading.knowledge.room(phrase.room_type).unit
    )


def _with_size(reading: Reading, phrase: Phrase) -> Phrase:
    size: Size = next((size_of(word) for word in reading.words(phrase.begin, phrase.noun_end) if is_size(word)), "")
    if size and not _NEGATIONS.isdisjoint(reading.words(max(phrase.begin - 3, 0), phrase.noun_end)):
        return phrase
    if not size:
        index = _after(reading, phrase.last)
        size = size_of(reading.word(index))
        if size:
            reading.take(index, index + 1)
    return replace(phrase, size=size) if size else phrase


def _after(reading: Reading, last: int) -> int:
    """Return the token that may say the size of a room before it: "kitchen (large)", "the kitchen should be large"."""
    if reading.word(last) == "(":
        return last + 1
    index = last + (reading.word(last) in ("should", "must", "shall"))
    index += reading.word(index) in _BE
    index += 2 if reading.words(index, index + 2) == ("to", "be") else 0
    return index + (reading.word(index) in _DEGREES) if index > last else -1


def size_of(word: str) -> Size:
    """Return the size that a word says; empty for none."""
    return "large" if word in _LARGE else "small" if word in _SMALL else ""
