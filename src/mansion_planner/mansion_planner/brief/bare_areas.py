"""Read lists of rooms with bare numbers as areas: "Kitchen 10, living room 22, bath 5", "kitchen: 10"."""

from collections.abc import Sequence
from dataclasses import replace

from mansion_language.units import AREA
from mansion_planner.brief.phrase import Phrase
from mansion_planner.brief.reading import Reading

__all__ = ["with_bare_areas"]

_LEAST, _MOST = 0.7, 1.6
"""Share of the least and of the most area of its kind that a number must lie within to be the area of a room."""


def with_bare_areas(reading: Reading, phrases: Sequence[Phrase]) -> list[Phrase]:
    """Return the phrases, each room of such a list with its area; the numbers are taken.

    Two rooms or more of different names have a number, and every number fits the kind of its room: "bedroom 1, bedroom
    2" are names, and "office 4, toilet 3" says how many.
    """
    found = {n: tokens for n, phrase in enumerate(phrases) if (tokens := _numbers_after(reading, phrase))}
    unit = _unit_of_all(reading)
    if unit is not None:
        return _measured(reading, phrases, found, unit)
    values = {n: tuple(reading.value(at) for at in tokens) for n, tokens in found.items()}
    listed = [n for n, tokens in found.items() if _ends_entry(reading, tokens[-1] + 1)]
    if len({phrases[n].name for n in listed}) < 2:
        return list(phrases)
    if not all(_fits(reading, phrases[n], value) for n in found for value in values[n]):
        return list(phrases)
    for tokens in found.values():
        reading.taken.update(tokens)
    return [replace(phrase, areas=values[n]) if n in found else phrase for n, phrase in enumerate(phrases)]


def _unit_of_all(reading: Reading) -> int | None:
    """Return the token of the unit of all bare numbers: "(all in m2)", "areas in m2"; none where none is told."""
    for index, token in enumerate(reading.tokens):
        measured = token.kind == "unit" and token.text in AREA and reading.word(index - 1) == "in"
        if measured and reading.word(index - 2) in _ALL:
            return index
    return None


_ALL = frozenset({"all", "area", "size", "figure", "number", "everything", "room", "("})


def _measured(
    reading: Reading, phrases: Sequence[Phrase], found: dict[int, tuple[int, ...]], unit: int
) -> list[Phrase]:
    """Return the phrases with the numbers after them as areas in the unit that is told of all."""
    factor = AREA[reading.word(unit)]
    reading.take(unit - 2 + (reading.word(unit - 2) == "("), unit + 1)
    reading.taken.update(at for tokens in found.values() for at in tokens)
    areas = {n: tuple(reading.value(at) * factor for at in tokens) for n, tokens in found.items()}
    return [replace(phrase, areas=areas[n]) if n in found else phrase for n, phrase in enumerate(phrases)]


def _numbers_after(reading: Reading, phrase: Phrase) -> tuple[int, ...]:
    """Return the tokens of the bare numbers behind a room: one, or one for each of several; or none."""
    if (
        phrase.head not in ("room", "building")
        or not phrase.room_type
        or phrase.areas
        or (phrase.plural and not phrase.counted)
    ):
        return ()
    if phrase.count == 1 and reading.word(phrase.last) == "(" and reading.word(phrase.last + 2) == ")":
        bracketed = phrase.last + 1
        return (bracketed,) if reading.kind(bracketed) == "number" and bracketed not in reading.taken else ()
    index = phrase.last + (reading.word(phrase.last) in (":", "=", "-"))
    if phrase.counted and phrase.count == 2 and reading.word(index) == "(":
        return _pair_in_brackets(reading, index + 1)
    bare = reading.kind(index) == "number" and index not in reading.taken
    last = index + 1
    goes_on = reading.word(last) in _GOES_ON and reading.kind(last) != "unit"
    return (index,) if bare and (goes_on or _ends_entry(reading, last)) else ()


def _pair_in_brackets(reading: Reading, index: int) -> tuple[int, ...]:
    """Return the tokens of "25 + 18)"."""
    joined = reading.word(index + 1) in ("+", "and", "/", ",", "&") and reading.word(index + 3) == ")"
    bare = all(reading.kind(at) == "number" and at not in reading.taken for at in (index, index + 2))
    return (index, index + 2) if joined and bare else ()


def _ends_entry(reading: Reading, index: int) -> bool:
    """Whether the entry of a list is over at a token."""
    last = index + (reading.word(index) == "each")
    return last >= len(reading.tokens) or reading.breaks(last) or reading.word(last) in (",", ")")


_GOES_ON = frozenset("( with off attached adjacent adjoining next beside and".split())
"""Words that go on with a room after its area: "kitchen 24 with serving side to the hall"."""


def _fits(reading: Reading, phrase: Phrase, value: float) -> bool:
    kind = reading.knowledge.room(phrase.room_type)
    return _LEAST * kind.least <= value <= _MOST * kind.most
