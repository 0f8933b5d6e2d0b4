"""Find which storeys a brief speaks of: "on the third floor", "ground-floor", "in the basement", "floors 3 to 8"."""

import itertools
from dataclasses import dataclass

from mansion_planner.brief.facts import FloorRef
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["Place", "find_places"]

_PREPOSITIONS = frozenset({"on", "in", "at", "to", "across", "throughout", "occupying", "for"})
_ENDS = frozenset({"", ".", ",", ";", "!", "and", "but", "with"})
_KINDS = {"top": "top", "uppermost": "top", "highest": "top", "last": "top", "upper": "upper",
          "higher": "upper", "lower": "lower", "middle": "middle", "intermediate": "middle",
          "every": "every", "each": "every", "all": "every", "typical": "middle"}  # fmt: skip


@dataclass(frozen=True)
class Place:
    """A floor reference in the brief: tokens `first` to `last` (exclusive).

    Attributes
    ----------
    refs : tuple of FloorRef
    led : bool
        It is led by a preposition ("on the top floor"), so it may belong to what stands before it.
    """

    first: int
    last: int
    refs: tuple[FloorRef, ...]
    led: bool


def find_places(reading: Reading) -> list[Place]:
    """Return the floor references of the brief from left to right, and take their tokens."""
    british = _counts_from_ground(reading)
    places: list[Place] = []
    index = 0
    while index < len(reading.tokens):
        found = None if index in reading.taken else _place_at(reading, index, british)
        if found is None:
            index += 1
            continue
        places.append(found)
        reading.take(found.first, found.last)
        index = max(found.last, index + 1)
    return places


def _counts_from_ground(reading: Reading) -> bool:
    """Whether the first floor is the one above the ground floor: the brief uses both names, as the British do."""
    words = [token.text for token in reading.tokens]
    pairs = list(itertools.pairwise(words))
    ground = ("ground", "floor") in pairs or ("ground", "level") in pairs
    return ground and ("first", "floor") in pairs and ("second", "storey") not in pairs


def _place_at(reading: Reading, index: int, british: bool) -> Place | None:
    refs, last = _refs_at(reading, index, british)
    if not refs:
        return None
    first = index
    if reading.word(first - 1) in ("the", "its", "both", "all", "our", "whole"):
        first -= 1
    led = reading.word(first - 1) in _PREPOSITIONS
    if led:
        first -= 1
    # "two classrooms per floor", "6 rooms each floor": it follows its rooms without a preposition.
    led = led or (refs[0].kind == "every" and reading.kind(first - 1) in ("word", "number"))
    return Place(first, last, refs, led)


def _every_storey(reading: Reading, index: int) -> int:
    """Return where "per floor", "each floor" or "each of the 2 floors" ends; `index` where it is none."""
    word, last = reading.word(index), index + 1
    if word == "per" and reading.kind(index - 1) != "unit":
        return last + 1 if reading.word(last) in FLOOR_WORDS else index
    if _KINDS.get(word) != "every":
        return index
    if reading.word(last) == "of":
        last += 1 + (reading.word(last + 1) in ("the", "its", "our"))
        last += reading.kind(last) == "number"
    return last + 1 if reading.word(last) in FLOOR_WORDS else index


def _number(reading: Reading, index: int, kind: str) -> int | None:
    if reading.kind(index) != kind or index in reading.taken:
        return None
    value = reading.tokens[index].value
    return int(value) if value == int(value) and abs(value) <= 1000 else None


def _refs_at(reading: Reading, index: int, british: bool) -> tuple[tuple[FloorRef, ...], int]:
    word = reading.word(index)
    following = reading.word(index + 1)
    if word in ("basement", "cellar", "underground") and following != "car":
        last = index + 2 if following in FLOOR_WORDS else index + 1
        if index in reading.mention_at and reading.mention_at[index].last > last:
            return (), index
        if word != "underground" or following in FLOOR_WORDS:
            return (FloorRef("basement", span=reading.span(index, last)),), last
    if word in ("rooftop", "roof") and following not in ("terrace", "garden", "bar", "deck"):
        last = index + 2 if following in FLOOR_WORDS else index + 1
        if index not in reading.mention_at or reading.word(index - 1) in ("the", "on"):
            return (FloorRef("roof", span=reading.span(index, last)),), last
    if word in ("upstair", "downstair"):
        span = reading.span(index, index + 1)
        if word == "upstair":
            return (FloorRef("upper", span=span),), index + 1
        return (FloorRef("number", 1, 1, span),), index + 1
    if word in ("ground", "street", "entrance", "entry") and following in FLOOR_WORDS:
        return _with_others(reading, index, 1, index + 2, british)
    many = _number(reading, index + 1, "number")
    if many and reading.word(index + 2) in FLOOR_WORDS:
        span = reading.span(index, index + 3)
        if word in ("top", "last", "upper", "uppermost"):
            return (FloorRef("top", many, many, span),), index + 3
        if word in ("first", "bottom", "lower", "lowest"):
            return (FloorRef("range", 1, many, span),), index + 3
        if word in ("other", "remaining"):
            return (FloorRef("upper", span=span),), index + 3
    if word == "typical" and following in FLOOR_WORDS:
        refs, last = _numbered(reading, index + 1)
        if refs:
            return refs, last
    if word == "top" and reading.word(index - 1) == "on" and following in _ENDS:
        return (FloorRef("top", span=reading.span(index, index + 1)),), index + 1
    every = _every_storey(reading, index)
    if every > index:
        return (FloorRef("every", span=reading.span(index, every)),), every
    if word in _KINDS and following in FLOOR_WORDS:
        return (FloorRef(_KINDS[word], span=reading.span(index, index + 2)),), index + 2  # type: ignore[arg-type]
    if word == "other" and following in FLOOR_WORDS:
        return (FloorRef("upper", span=reading.span(index, index + 2)),), index + 2
    if word in FLOOR_WORDS:
        return _numbered(reading, index)
    number = _number(reading, index, "ordinal")
    if number is not None:
        return _ordinals(reading, index, number, british)
    return (), index


def _with_others(
    reading: Reading, index: int, floor: int, last: int, british: bool
) -> tuple[tuple[FloorRef, ...], int]:
    """Read "ground floor and first floor" as two references."""
    refs = [FloorRef("number", floor, floor, reading.span(index, last))]
    number = _number(reading, last + 1, "ordinal")
    if reading.word(last) == "and" and number and reading.word(last + 2) in FLOOR_WORDS:
        more = number + british
        refs.append(FloorRef("number", more, more, reading.span(last + 1, last + 3)))
        last += 3
    return tuple(refs), last


def _numbered(reading: Reading, index: int) -> tuple[tuple[FloorRef, ...], int]:
    """Read "floor 3", "floors 3 to 8", "levels 2 and 3", "floors 2, 3 and 5"."""
    first = _number(reading, index + 1, "number")
    if first is None or reading.word(index + 2) in ("m2", "m²", "sqm", "square", "sq"):
        return (), index
    last = index + 2
    link, second = reading.word(last), _number(reading, last + 1, "number")
    if link in ("to", "through", "until", "–", "—", "thru") and second is not None:
        low, high = min(first, second), max(first, second)
        return (FloorRef("range", low, high, reading.span(index, last + 2)),), last + 2
    adjoining = _number(reading, last, "number")
    if (
        adjoining is not None
        and adjoining > first
        and reading.text[reading.tokens[index + 1].end : reading.tokens[last].start] in ("-", "‑", "−")
    ):
        return (FloorRef("range", first, adjoining, reading.span(index, last + 1)),), last + 1
    numbers = [first]
    while reading.word(last) in (",", "and", "&"):
        step = 2 if reading.word(last) == "," and reading.word(last + 1) == "and" else 1
        more = _number(reading, last + step, "number")
        if more is None or reading.tokens[index].plural is False:
            break
        if more <= numbers[-1] or reading.word(last + step + 1) not in (",", "and", "&", ".", "", ":"):
            break
        numbers.append(more)
        last += step + 1
    span = reading.span(index, last)
    return tuple(FloorRef("number", number, number, span) for number in numbers), last


def _ordinals(reading: Reading, index: int, number: int, british: bool) -> tuple[tuple[FloorRef, ...], int]:
    """Read "third floor", "second and third floors", "third to eighth floors"."""
    numbers, last, ranged = [number], index + 1, False
    while reading.word(last) in ("and", ",", "&", "to", "through", "–", "floor"):
        link = reading.word(last)
        if link == "floor" and reading.word(last + 1) not in ("to", "through", "–"):
            break
        step = 2 if link == "floor" or (link == "," and reading.word(last + 1) == "and") else 1
        step += reading.word(last + step) == "the"
        more = _number(reading, last + step, "ordinal")
        if more is None:
            break
        ranged = ranged or link in ("to", "through", "–", "floor")
        numbers.append(more)
        last += step + 1
    if reading.word(last) not in FLOOR_WORDS:
        return (), index
    last += 1
    span = reading.span(index, last)
    numbers = [value + british for value in numbers]
    if ranged and len(numbers) == 2:
        return (FloorRef("range", min(numbers), max(numbers), span),), last
    return tuple(FloorRef("number", value, value, span) for value in numbers), last
