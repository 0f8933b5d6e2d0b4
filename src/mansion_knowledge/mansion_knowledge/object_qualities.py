"""Whether an object is as a word says: as wide as a bed that is called so, long, round, of a substance or a colour."""

from collections.abc import Sequence

__all__ = ["has_quality"]

_WIDTHS_OF_BEDS = {"single": (0.7, 1.1), "double": (1.3, 2.3), "queen": (1.45, 2.3), "king": (1.7, 2.3)}
"""Widths of beds that are called so, metres: those of usual mattresses with their frames, and a little less."""
_LONG = 1.8
"""Metres from which on a table, a bench or a counter is long."""
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
    if word == "long":
        return max(size[:2]) >= _LONG
    if word == "round":
        return "round" in category.split("_")
    return _MATERIALS.get(word, word) in material.split("_")
