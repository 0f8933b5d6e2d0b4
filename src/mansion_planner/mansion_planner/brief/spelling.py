"""Correct misspelt words to the planner's vocabulary, by one edit (two in long words)."""

from dataclasses import replace
from functools import cache

from mansion_knowledge.common_words import common_words
from mansion_language import Token, singular
from mansion_language.numbers import ORDINALS
from mansion_language.spelling import Speller

__all__ = ["GRAMMAR", "corrected", "without_slips"]

GRAMMAR = frozenset(
    [
        "floor",
        "storey",
        "story",
        "level",
        "building",
        "with",
        "without",
        "the",
        "and",
        "for",
        "that",
        "has",
        "have",
        "including",
        "containing",
        "each",
        "every",
        "per",
        "ground",
        "basement",
        "top",
        "upper",
        "lower",
        "square",
        "metre",
        "meter",
        "foot",
        "feet",
        "total",
        "area",
        "room",
        "about",
        "around",
        "people",
        "person",
        "family",
        "next",
        "adjacent",
        "beside",
        "between",
        "above",
        "below",
        "identical",
        "same",
        "elevator",
        "lift",
        "stair",
        "staircase",
        "shaped",
        "courtyard",
        "terrace",
        "setback",
        "material",
        "wooden",
        "style",
        "pupil",
        "student",
        "employee",
        "guest",
        "patient",
        "bed",
        "resident",
        "worker",
        "staff",
        "outline",
        "rectangular",
        "house",
        "home",
        "high",
        "rise",
        "tower",
        "apartment",
        "penthouse",
        "roof",
        "rooftop",
        "underground",
        "contain",
        "include",
        "footprint",
        "typical",
    ]
)


_SHORT = {
    "rm": "room", "bedrm": "bedroom", "bdrm": "bedroom", "bedr": "bedroom", "bathrm": "bathroom", "apt": "apartment",
    "flr": "floor", "bldg": "building", "bsmt": "basement", "mtg": "meeting", "sep": "separate", "ofc": "office",
    "kit": "kitchen",
}  # fmt: skip
"""Short forms in notes, and what they stand for."""


_SLIPS = {
    **dict.fromkeys(("storei", "storeis", "storry", "storrey", "stroey", "stories", "store-y"), "storey"),
    **dict.fromkeys(("aprox", "appr", "cca"), "approx"),
    "flor": "floor", "grund": "ground", "gruond": "ground", "grnd": "ground", "uper": "upper", "evry": "every",
    "rom": "room", "loby": "lobby", "gest": "guest", "lugage": "luggage", "kichen": "kitchen", "bathrom": "bathroom",
    "bedrom": "bedroom", "elavator": "elevator", "toilett": "toilet", "offce": "office",
}  # fmt: skip
"""Slips in the words that storeys and numbers are read by, before the vocabulary is known."""


def without_slips(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the commonest misspellings of words for storeys and estimates put right."""
    return [replace(token, text=_SLIPS[token.text]) if token.text in _SLIPS else token for token in tokens]


def corrected(tokens: list[Token], words: frozenset[str], known: frozenset[str] = frozenset()) -> list[Token]:
    """Return the tokens with misspelt words replaced by the vocabulary's nearest word.

    Parameters
    ----------
    tokens : list of Token
    words : frozenset of str
        The lexicon's words, in singular.
    known : frozenset of str
        Further words in the singular that are no mistakes.
    """
    found: dict[str, str] = {}
    result: list[Token] = []
    for token in tokens:
        if token.text == "kit" and result and result[-1].text in ("drum", "aid", "tool", "repair", "first"):
            result.append(token)
            continue
        if token.text in _SHORT:
            result.append(replace(token, text=_SHORT[token.text]))
            continue
        if token.text.endswith("room") and token.text not in words and token.text[:-4] in words:
            end = token.end - len("room") - token.plural
            result += [
                replace(token, text=token.text[:-4], end=end, plural=False),
                replace(token, text="room", start=end),
            ]
            continue  # "livingroom"
        if token.kind != "word" or len(token.text) < 4 or len(token.text) > 20:
            result.append(token)
            continue
        if token.text not in found:
            held = singular(token.text) in known
            found[token.text] = token.text if held else _nearest(token.text, words)
        text = found[token.text]
        if text == token.text:
            result.append(token)
        elif text in ORDINALS:
            value = float(ORDINALS[text])
            result.append(replace(token, kind="ordinal", text=text, value=value))
        else:
            result.append(replace(token, text=text))
    return result


@cache
def _speller(words: frozenset[str]) -> Speller:
    return Speller(words | set(ORDINALS), GRAMMAR)


def _nearest(word: str, words: frozenset[str]) -> str:
    if word in words or word in GRAMMAR or word in common_words() or singular(word) in words:
        return word
    return _speller(words).nearest(word)
