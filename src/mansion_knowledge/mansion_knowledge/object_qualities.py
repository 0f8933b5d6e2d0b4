"""Whether an object is as a word says: as wide as a bed that is called so, long, round, of a substance or a colour."""

import math
from collections.abc import Mapping, Sequence

__all__ = ["has_quality"]

_WIDTHS_OF_BEDS = {"single": (0.7, 1.1), "double": (1.3, 2.3), "queen": (1.45, 2.3), "king": (1.7, 2.3)}
"""Widths of beds that are called so, metres: those of usual mattresses with their frames, and a little less."""
_LONG = 1.8
"""Metres from which on a table, a bench or a counter is long."""
_LENGTHS = {
    "bed": (1.2, 1.6), "bookshelf": (0.8, 1.2), "coffee_table": (0.8, 1.2), "conference_table": (1.8, 3.2),
    "counter": (1.8, 2.4), "desk": (1.1, 1.5), "dresser": (0.8, 1.2), "painting": (0.6, 1.0),
    "reception_desk": (1.8, 2.4), "rug": (1.6, 2.4), "sofa": (1.7, 2.1), "table": (0.95, 1.6), "television": (1.0, 1.2),
    "tv": (1.0, 1.2), "wardrobe": (1.0, 1.5), "whiteboard": (1.2, 1.8),
}  # fmt: skip
"""By category or its last word, metres up to which a piece is small and from which on it is large: the width of a bed,
the longer side of other things, as they are usually sold."""
_HEIGHTS = {
    "bookshelf": (1.2, 1.8), "cabinet": (1.2, 1.7), "locker": (1.2, 1.7), "plant": (0.4, 1.0), "shelf": (1.2, 1.7),
    "stool": (0.5, 0.65), "table": (0.55, 0.95), "unit": (1.2, 1.7), "wardrobe": (1.5, 2.1),
}  # fmt: skip
"""The same for what is low and what is high."""
_LARGE = frozenset({"large", "big", "huge", "generous", "oversized", "spacious"})
_SMALL = frozenset({"small", "tiny", "little", "compact", "mini"})
_HIGH = frozenset({"high", "tall"})
_SQUARE = 0.06
"""Metres by which the sides of what is square differ at most."""
_MATERIALS = {
    "wooden": "wood", "timber": "wood", "steel": "metal", "stainless": "metal", "iron": "metal", "velvet": "fabric",
    "gray": "grey",
}  # fmt: skip
"""Words for substances and colours that materials are called by otherwise."""


def has_quality(category: str, size: Sequence[float], material: str, words: str) -> bool:
    """Tell whether an object is as words say; where nothing is known of a word it is not.

    Parameters
    ----------
    category : str
    size : sequence of float
        Width along the front, depth and height, metres.
    material : str
        Name of its main material, ``family_colour``.
    words : str
        "double", "dark green".

    Examples
    --------
    >>> has_quality("bed", (1.6, 2.0, 0.5), "fabric_white", "double"), has_quality("bed", (0.9, 2.0, 0.5), "", "double")
    (True, False)
    >>> has_quality("sofa", (2.1, 0.9, 0.8), "leather_brown", "leather")
    True
    """
    said = words.lower().replace("-", " ").split()
    return all(_is_so(category, size, material, word) for word in said if word not in ("size", "sized"))


def _is_so(category: str, size: Sequence[float], material: str, word: str) -> bool:
    if category in ("bed", "single_bed") and word in _WIDTHS_OF_BEDS:
        low, high = _WIDTHS_OF_BEDS[word]
        return low <= size[0] <= high
    if word in _LARGE | _SMALL:
        small, large = _bounds(_LENGTHS, category)
        extent = size[0] if category.endswith("bed") else max(size[:2])
        return extent >= large if word in _LARGE else extent <= small
    if word in _HIGH or word == "low":
        low, high = _bounds(_HEIGHTS, category)
        return size[2] <= low if word == "low" else size[2] >= high
    if word in ("square", "rectangular") and "round" not in category.split("_"):
        return (abs(size[0] - size[1]) <= _SQUARE) == (word == "square")
    if word == "long":
        return max(size[:2]) >= _LONG
    if word == "round":
        return "round" in category.split("_")
    return _MATERIALS.get(word, word) in material.split("_")


def _bounds(known: Mapping[str, tuple[float, float]], category: str) -> tuple[float, float]:
    """Return up to which measure things of a category are small, and from which on they are large; none if unknown."""
    last = category.rpartition("_")[2]
    return known.get(category) or known.get(last) or (-math.inf, math.inf)
