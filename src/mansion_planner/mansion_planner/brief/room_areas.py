"""Areas that a brief gives to a room: "a 40 m2 gym", "a gym of about 40 m2"."""

from mansion_planner.brief.areas import area_at
from mansion_planner.brief.reading import Reading

__all__ = ["area_after", "area_ending"]


def area_ending(reading: Reading, end: int) -> tuple[float, int] | None:
    """Return the area that ends before token `end`, and its first token; its tokens are taken."""
    for start in range(end - 4, end - 1):
        if start >= 0 and start not in reading.taken:
            found = area_at(reading, start)
            if found is not None and found[1] == end:
                reading.take(start, end)
                return found[0], start
    return None


def area_after(reading: Reading, index: int) -> tuple[float, int] | None:
    """Return the area that a room phrase ending at token `index` is given, and the token after it."""
    begin = index
    while index - begin < 6 and reading.word(index) in (
        "of", "with", "(", "measuring", "about", "around", "at", "least", "is", "has", "an", "area", "be",
        "should", "roughly", "approximately", "each", ":", "a", "having", "covering", "sized", "size", "must",
        "will", "exactly", "occupying", "minimum", "more", "than", "floor",
    ):  # fmt: skip
        index += 1
    found = area_at(reading, index) if index not in reading.taken else None
    if found is None:
        return None
    value, end = found
    return value, end + (reading.word(end) == ")")
