"""Read lists of rooms with bare numbers as areas: "Kitchen 10, living room 22, bath 5", "kitchen: 10"."""

from collections.abc import Sequence
from dataclasses import replace

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
    found = {n: index for n, phrase in enumerate(phrases) if (index := _number_after(reading, phrase)) >= 0}
    names = {phrases[n].name for n in found}
    if len(names) < 2 or not all(_fits(reading, phrases[n], reading.value(index)) for n, index in found.items()):
        return list(phrases)
    for index in found.values():
        reading.take(index, index + 1)
    return [
        replace(phrase, areas=(reading.value(found[n]),)) if n in found else phrase for n, phrase in enumerate(phrases)
    ]


def _number_after(reading: Reading, phrase: Phrase) -> int:
    """Return the bare number that ends the entry of a room, or -1."""
    if (
        phrase.head not in ("room", "building")
        or not phrase.room_type
        or phrase.areas
        or (phrase.plural and not phrase.counted)
    ):
        return -1
    index = phrase.last + (reading.word(phrase.last) in (":", "=", "-"))
    last = index + 1 + (reading.word(index + 1) == "each")
    ends = last >= len(reading.tokens) or reading.breaks(last) or reading.word(last) == ","
    return index if reading.kind(index) == "number" and index not in reading.taken and ends else -1


def _fits(reading: Reading, phrase: Phrase, value: float) -> bool:
    kind = reading.knowledge.room(phrase.room_type)
    return _LEAST * kind.least <= value <= _MOST * kind.most
