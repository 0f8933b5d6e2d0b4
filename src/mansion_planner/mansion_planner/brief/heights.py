"""Read how high ceilings are to be, and in which room."""

import itertools

from mansion_language.units import LENGTH
from mansion_planner.brief.facts import HeightFact
from mansion_planner.brief.finishes import room_after
from mansion_planner.brief.reading import Reading

__all__ = ["read_heights"]


def read_heights(reading: Reading) -> None:
    """Read "ceilings 5 m high", "a ceiling height of 3.5 m in the hall", "4.5 m ceiling"."""
    for index, token in enumerate(reading.tokens):
        if token.text not in ("ceiling", "headroom") or index in reading.taken:
            continue
        number = _height_near(reading, index)
        if number is None:
            continue
        height = reading.value(number) * LENGTH[reading.word(number + 1)]
        first, last = min(index, number), max(index + 1, number + 2)
        last += reading.word(last) in ("high", "height")
        room = room_after(reading, last + 1) if reading.word(last) in ("in", "for") else ""
        reading.facts.heights.append(HeightFact(height, room, reading.span(first, last)))
        reading.take(first, last)


def _height_near(reading: Reading, index: int) -> int | None:
    """Return the number of metres or feet that is said of a ceiling: after it in its sentence, else before it."""
    after = itertools.takewhile(lambda number: not reading.breaks(number), range(index + 1, index + 7))
    for number in (*after, *range(index - 1, index - 5, -1)):
        if reading.kind(number) == "number" and reading.word(number + 1) in LENGTH and number not in reading.taken:
            height = reading.value(number) * LENGTH[reading.word(number + 1)]
            return number if 1.8 <= height <= 30 else None
    return None
