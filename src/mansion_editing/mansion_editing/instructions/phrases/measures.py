"""Lengths in instructions: ``1 m``, ``half a metre``, ``30 cm``, ``a metre and a half``."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.words import Word, text_at

__all__ = ["read_length"]

_UNITS: Final = {
    "m": 1.0, "metre": 1.0, "cm": 0.01, "centimetre": 0.01, "centimeter": 0.01, "ft": 0.3048, "foot": 0.3048,
    "inch": 0.0254, "mm": 0.001, "dm": 0.1,
}  # fmt: skip


def read_length(words: Sequence[Word], at: int) -> tuple[float, int] | None:
    """Return a length in metres and the place after it; None where the words at a place are none."""
    place = at + (text_at(words, at) in ("about", "by", "some", "around", "exactly", "roughly"))
    value = 0.0
    if place < len(words) and words[place].kind == "number":
        value, place = words[place].value, place + 1
        if text_at(words, place) == "and" and text_at(words, place + 2) == "half":
            value, place = value + 0.5, place + 3
    elif text_at(words, place) == "half":
        value, place = 0.5, place + 1 + (text_at(words, place + 1) in ("a", "an"))
    elif text_at(words, place) in ("a", "one", "another"):
        value, place = 1.0, place + 1
    factor = _UNITS.get(text_at(words, place))
    if not value or factor is None:
        return None
    place += 1
    if tuple(w.text for w in words[place : place + 3]) == ("and", "a", "half"):
        value, place = value + 0.5, place + 3
    return round(value * factor, 3), place
