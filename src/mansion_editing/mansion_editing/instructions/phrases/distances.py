"""Lengths, ``half a metre``, and places told by them: ``within 0.5 m of the sofa``, ``two metres from the desk``."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.noun_phrases import noun_phrase
from mansion_editing.instructions.phrases.words import Word, text_at
from mansion_editing.instructions.statements import Place

__all__ = ["read_distance", "read_length", "read_within"]

_METRES: Final = {"m": 1.0, "metre": 1.0, "cm": 0.01, "centimetre": 0.01, "centimeter": 0.01, "ft": 0.3048}


def read_distance(words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]) -> tuple[Place, int] | None:
    """Read a distance that is told without ``within``; return the place and its end, None where there is none."""
    return _no_further(words, at, lexicon, floors) or _metres_from(words, at, lexicon, floors)


def read_within(words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]) -> tuple[Place, int] | None:
    """Read ``within 0.5 metres of the sofa``."""
    place = at
    while text_at(words, place) in ("a", "about", "half"):
        place += 1
    half = text_at(words, place - 1) == "half"
    if place >= len(words) or not (words[place].kind == "number" or half or words[place].text in ("reach", "metre")):
        return None
    value = words[place].value if words[place].kind == "number" else 0.5 if half else 1.0
    place += words[place].kind == "number"
    unit = text_at(words, place)
    factor = _METRES.get(unit)
    if factor is None:
        return None
    place += 1
    place += text_at(words, place) == "away"
    if text_at(words, place) in ("of", "from"):
        place += 1
    target = noun_phrase(words, place, lexicon, floors)
    if target is None:
        return None
    near = Place(relation="near", anchor=target.things(), within=round(value * factor, 3))
    return near, target.end


def _no_further(words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]) -> tuple[Place, int] | None:
    """Read ``not further than 1 metre from the lectern``, ``no more than 50 cm away from the bed``."""
    more = text_at(words, at) in ("not", "no") and text_at(words, at + 1) in ("further", "farther", "more")
    if not more or text_at(words, at + 2) not in ("than", "away"):
        return None
    at_number = at + 3 + (text_at(words, at + 2) == "away")
    return read_within(words, at_number, lexicon, floors)


_EXACT, _ABOUT, _FAR = 0.2, 0.4, 3.0
"""Metres by which a distance may differ from the one that is told, from about it, and beyond at least it."""


def _metres_from(words: Sequence[Word], at: int, lexicon: Lexicon, floors: Sequence[int]) -> tuple[Place, int] | None:
    """Read ``two metres from the sofa``, ``about 1.5 m away from the desk``, ``at least a metre from the bed``."""
    place = at
    least = (text_at(words, place), text_at(words, place + 1)) == ("at", "least")
    about = text_at(words, place) in ("about", "around", "roughly", "approximately", "some")
    place += 2 * least + (about or text_at(words, place) == "exactly")
    one = text_at(words, place) in ("a", "one") and text_at(words, place + 1) in _METRES
    metres = 1.0 if one else words[place].value if place < len(words) and words[place].kind == "number" else 0.0
    factor = _METRES.get(text_at(words, place + 1), 0.0)
    place += 2
    place += text_at(words, place) == "away"
    if not metres * factor or text_at(words, place) not in ("from", "off"):
        return None
    target = noun_phrase(words, place + 1, lexicon, floors)
    if target is None or target.noun.unknown or target.noun.kind not in ("object", "anything"):
        return None
    told = metres * factor
    slack = _ABOUT if about else _EXACT
    apart = told if least else max(0.0, told - slack)
    within = told + (_FAR if least else slack)
    near = Place(relation="near", anchor=target.things(), within=round(within, 3), apart=round(apart, 3))
    return near, target.end


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
