"""Read the areas of a brief: of the building, of a storey; those of rooms are read with the rooms."""

from mansion_planner.brief.facts import Quantity, Span
from mansion_planner.brief.reading import FLOOR_WORDS, Reading

__all__ = ["area_at", "read_areas"]

_SQUARE_FOOT = 0.09290304
"""Square metres in a square foot, exactly."""

_AREA_UNITS = {"m2": 1.0, "m²": 1.0, "m^2": 1.0, "sqm": 1.0, "sm": 1.0,
              "ft2": _SQUARE_FOOT, "ft²": _SQUARE_FOOT, "sqft": _SQUARE_FOOT, "sf": _SQUARE_FOOT}  # fmt: skip

_METRES = frozenset({"m", "metre", "meter", "mt", "mtr"})

_FEET = frozenset({"ft", "foot", "feet"})


def area_at(reading: Reading, index: int) -> tuple[float, int] | None:
    """Return the area that starts at token `index` in square metres, and the token after it."""
    if reading.kind(index) != "number" or reading.tokens[index].value <= 0:
        return None
    value, last = reading.tokens[index].value, index + 1
    sides = _sides_at(reading, index)
    if sides is not None:
        return sides
    word, following = reading.word(last), reading.word(last + 1)
    if word == "k" and following in _AREA_UNITS:
        value, word, following, last = value * 1000, following, reading.word(last + 2), last + 1
    if word in _AREA_UNITS:
        return value * _AREA_UNITS[word], last + 1
    if word in ("square", "sq"):
        last += 1 + (reading.word(last + 1) == ".")
        unit = reading.word(last)
        if unit in _METRES:
            return value, last + 1
        if unit in _FEET:
            return value * _SQUARE_FOOT, last + 1
    if word == "m" and reading.kind(last + 1) == "number" and reading.word(last + 1) == "2":
        return value, last + 2
    return None


def _sides_at(reading: Reading, index: int) -> tuple[float, int] | None:
    """Read "20 x 15 m" as an area."""
    link = index + 1 + (reading.word(index + 1) in _METRES)
    if reading.word(link) not in ("x", "by") or reading.kind(link + 1) != "number":
        return None
    if reading.word(link + 2) not in _METRES:
        return None
    return reading.tokens[index].value * reading.tokens[link + 1].value, link + 3


def read_areas(reading: Reading) -> None:
    """Read the areas that belong to the building or to a storey; those of rooms are read with the rooms."""
    index = 0
    while index < len(reading.tokens):
        found = None if index in reading.taken else area_at(reading, index)
        if found is None:
            index += 1
            continue
        value, last = found
        fact = Quantity(value, _with_approximation(reading, index, last))
        sides = _sides_at(reading, index) is not None and not _of_room(reading, index, last)
        if sides or _per_floor(reading, index, last):
            reading.facts.floor_area.append(fact)
            reading.take(index, last)
        elif not _of_room(reading, index, last):
            reading.facts.area.append(fact)
            reading.take(index, last)
        index = last


def _with_approximation(reading: Reading, first: int, last: int) -> Span:
    if reading.word(first - 1) in ("about", "around", "approximately", "roughly", "circa", "some"):
        first -= 1
    return reading.span(first, last)


def _per_floor(reading: Reading, first: int, last: int) -> bool:
    after = [reading.word(i) for i in range(last, last + 5)]
    for offset, word in enumerate(after[:-1]):
        mention = reading.mention_at.get(last + offset)
        if word in (",", ".", ";", "with") or (mention and mention.room and not mention.building):
            break
        if word in ("per", "a", "each", "every", "/", "footprint", "plate"):
            follows = after[offset + 1]
            if word in ("footprint", "plate") or follows in FLOOR_WORDS or follows == "footprint":
                return True
        if offset == 0 and word in ("floor", "storey", "level") and after[1] in ("plate", "area", "plan"):
            return True
    before = [reading.word(i) for i in range(first - 6, first)]
    text = f" {' '.join(before)} "
    if any(mark in before for mark in (".", ";")):
        text = text.rsplit(".", 1)[-1].rsplit(";", 1)[-1]
    if "total floor" in text or "gross floor" in text:
        return False
    cues = ("floor area", "footprint", "floor plate", "each floor", "every floor", "per floor",
            "floor of", "storey of", "each storey", "each level", "level of", "every storey", "floor with")  # fmt: skip
    return any(f" {cue} " in text for cue in cues)  # whole words: no "storey of" in "storey office"


def _of_room(reading: Reading, first: int, last: int) -> bool:
    """Whether the area is a room's: "a 40 m2 meeting room", "a meeting room of 40 m2"."""
    after = last
    while reading.kind(after) == "word" and after not in reading.mention_at and after < last + 3:
        if reading.word(after) in ("with", "in", "for", "on", "and", "total", "of", "building"):
            break
        after += 1
    if reading.word(last) == "of" and last + 1 in reading.mention_at:
        after = last + 1
    mention = reading.mention_at.get(after)
    if mention is not None and mention.room and not _is_head(reading, mention.first):
        return True
    unknown = reading.word(after - 1) in ("room", "hall", "area", "space", "studio", "lab", "zone")
    if unknown and after > last + 1 and mention is None:
        return True
    before = first
    while reading.word(before - 1) in (
        "of", "with", "about", "around", "at", "least", "(", "measuring", "is", "has", "approximately",
        "be", "should", "covering", "roughly", "an", "area", "size", "sized", "each", ":", "having",
        "=", "a", "must", "will", "exactly", "occupying", "minimum", "than", "more", "floor", ",", "total",
    ):  # fmt: skip
        before -= 1
    if reading.word(before) == "," or "total" in [reading.word(i) for i in range(before, first)]:
        return False
    mention = reading.mention_ending.get(before)
    return mention is not None and bool(mention.room) and not _is_head(reading, mention.first)


def _is_head(reading: Reading, first: int) -> bool:
    return any(reading.text[s.start : s.end] and s.start == reading.tokens[first].start
               for _, s in reading.facts.building)  # fmt: skip
