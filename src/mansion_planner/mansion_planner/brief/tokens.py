"""Split a brief into tokens: words in singular, numbers in figures or words, punctuation; each with its place."""

import re
from dataclasses import dataclass
from typing import Literal

__all__ = ["ORDINALS", "Token", "singular", "tokenize"]

_TOKEN = re.compile(
    r"(?P<number>\d+(?:[.,]\d+)*)(?P<suffix>st|nd|rd|th)?(?![a-z])"
    r"|(?P<unit>m²|m\^2|m2|ft²|ft2|sqm|sqft)(?![a-z0-9])"
    r"|(?P<glued>\d+(?:[.,]\d+)*)(?=[a-z])"
    r"|(?P<word>[a-z]+)(?:['’]s?\b)?"
    r"|(?P<mark>[,.;:()\n&+/?!–—%])"
)

_TRIPLED = re.compile(r"([a-z])\1{2,}")
"""No English word has a letter three times in a row."""

_UNITS = {
    "one": 1, "two": 2, "three": 3, "four": 4, "five": 5, "six": 6, "seven": 7, "eight": 8,
    "nine": 9, "ten": 10, "eleven": 11, "twelve": 12, "thirteen": 13, "fourteen": 14,
    "fifteen": 15, "sixteen": 16, "seventeen": 17, "eighteen": 18, "nineteen": 19,
    "twenty": 20, "thirty": 30, "forty": 40, "fifty": 50, "sixty": 60, "seventy": 70,
    "eighty": 80, "ninety": 90, "dozen": 12, "single": 1, "double": 2, "twin": 2, "triple": 3,
    "pair": 2, "couple": 2,
}  # fmt: skip
_SCALES = {"hundred": 100, "thousand": 1000}

ORDINALS = {
    "first": 1, "second": 2, "third": 3, "fourth": 4, "fifth": 5, "sixth": 6, "seventh": 7,
    "eighth": 8, "ninth": 9, "tenth": 10, "eleventh": 11, "twelfth": 12, "thirteenth": 13,
    "fourteenth": 14, "fifteenth": 15, "sixteenth": 16, "seventeenth": 17, "eighteenth": 18,
    "nineteenth": 19, "twentieth": 20, "thirtieth": 30, "fortieth": 40, "fiftieth": 50,
}  # fmt: skip

_SOFT_NUMBERS = ("single", "double", "twin", "triple", "pair", "couple", "dozen")
_IRREGULAR = {
    "men": "man", "women": "woman", "children": "child", "people": "people", "stories": "story",
    "shelves": "shelf", "glass": "glass", "gas": "gas", "offices": "office", "wcs": "wc",
    "business": "business", "class": "class", "pass": "pass", "access": "access", "mass": "mass",
    "premises": "premises", "less": "less", "canvas": "canvas", "fitness": "fitness",
    "wellness": "wellness", "bus": "bus", "campus": "campus", "this": "this", "is": "is",
    "has": "has", "its": "its", "as": "as", "us": "us", "was": "was", "plus": "plus", "yes": "yes",
    "minus": "minus", "thus": "thus", "cross": "cross", "crossfit": "crossfit", "kids": "kid",
    "press": "press", "tennis": "tennis", "villas": "villa", "cafes": "cafe", "café": "cafe",
    "storeys": "storey", "buses": "bus", "classes": "class", "bed": "bed", "means": "means",
    "chess": "chess", "series": "series", "always": "always", "besides": "besides",
    "serviced": "serviced", "lens": "lens", "houses": "house", "warehouses": "warehouse",
    "nurses": "nurse", "spaces": "space", "terraces": "terrace", "garages": "garage",
    "lounges": "lounge", "residences": "residence", "cottages": "cottage", "suites": "suite",
    "theatres": "theatre", "stores": "store", "studies": "study", "mosques": "mosque",
    "boutiques": "boutique", "theaters": "theater", "entrances": "entrance", "lodges": "lodge",
    "duplexes": "duplex", "churches": "church", "benches": "bench", "branches": "branch",
    "kitchens": "kitchen", "saunas": "sauna", "spas": "spa", "labs": "lab", "atria": "atrium",
    "auditoria": "auditorium", "gymnasia": "gymnasium", "gyms": "gym", "wash": "wash",
}  # fmt: skip


@dataclass(frozen=True)
class Token:
    """A word, number, ordinal, unit or mark of the brief.

    Attributes
    ----------
    kind : {"word", "number", "ordinal", "unit", "mark"}
    text : str
        Normal form: singular for words.
    plural : bool
        The word stood in the plural.
    soft : bool
        A number word that is often no count (``double bedroom``).
    """

    kind: Literal["word", "number", "ordinal", "unit", "mark"]
    text: str
    start: int
    end: int
    value: float = 0.0
    plural: bool = False
    soft: bool = False


def singular(word: str) -> str:
    """Return the singular of an English noun in lower case.

    Examples
    --------
    >>> [singular(word) for word in ("bedrooms", "libraries", "offices", "lobby", "glass")]
    ['bedroom', 'library', 'office', 'lobby', 'glass']
    """
    if word in _IRREGULAR:
        return _IRREGULAR[word]
    if len(word) <= 3 or not word.endswith("s") or word.endswith(("ss", "us", "is")):
        return word
    if word.endswith("ies") and len(word) > 4:
        return word[:-3] + "y"
    if word.endswith(("ches", "shes", "xes", "sses", "zes")):
        return word[:-2]
    return word[:-1]


def _lower(text: str) -> str:
    """Lower case of the same length, so that places stay valid."""
    low = text.lower()
    if len(low) == len(text):
        return low.replace("é", "e").replace("è", "e")
    return "".join(char.lower() if len(char.lower()) == 1 else char for char in text)


def tokenize(text: str) -> list[Token]:
    """Split `text` into tokens; characters of other scripts are skipped."""
    tokens = [_token(match) for match in _TOKEN.finditer(_lower(text))]
    return _join_number_words(tokens)


def _token(match: "re.Match[str]") -> Token:
    start, end = match.span()
    figure = match["number"] or match["glued"]
    if figure:
        kind: Literal["number", "ordinal"] = "ordinal" if match["suffix"] else "number"
        return Token(kind, figure, start, end, value=_figure(figure))
    if match["unit"]:
        return Token("unit", match["unit"], start, end)
    if match["mark"]:
        return Token("mark", match["mark"], start, end)
    word = _TRIPLED.sub(r"\1\1", match["word"])
    if word in ORDINALS:
        return Token("ordinal", word, start, end, value=float(ORDINALS[word]))
    if word in _UNITS:
        return Token("number", word, start, end, value=float(_UNITS[word]), soft=word in _SOFT_NUMBERS)
    base = singular(word)
    return Token("word", base, start, end, plural=base != word)


def _figure(text: str) -> float:
    """Read 1,200 and 1.200 as 1200, and 2.5 or 2,5 as 2.5; at most twelve digits count."""
    parts = re.split(r"[.,]", text[:15])
    if len(parts) > 1 and all(len(part) == 3 for part in parts[1:]) and parts[0] != "0":
        return float("".join(parts))
    if len(parts) == 2:
        return float(f"{parts[0] or 0}.{parts[1] or 0}")
    return float("".join(parts)[:12])


def _join_number_words(tokens: list[Token]) -> list[Token]:
    """Join ``twenty five``, ``two hundred``, ``twenty first`` into one token."""
    joined: list[Token] = []
    for token in tokens:
        last = joined[-1] if joined else None
        spelt = last is not None and last.kind == "number" and last.text.isalpha()
        if token.kind == "word" and token.text in _SCALES:
            scale = _SCALES[token.text]
            if last is not None and last.kind == "number" and last.value < 1000:
                joined[-1] = Token("number", f"{last.text} {token.text}", last.start, token.end, last.value * scale)
            else:
                joined.append(Token("number", token.text, token.start, token.end, float(scale)))
        elif (
            last is not None
            and spelt
            and 20 <= last.value <= 90
            and 1 <= token.value <= 9
            and token.kind in ("number", "ordinal")
            and token.text.isalpha()
            and not token.soft
        ):
            value = last.value + token.value
            joined[-1] = Token(token.kind, f"{last.text} {token.text}", last.start, token.end, value)
        elif (
            last is not None
            and last.kind == "number"
            and last.text.endswith(("hundred", "thousand"))
            and token.kind == "number"
            and token.text.isalpha()
            and token.value < 100
        ):
            joined[-1] = Token("number", f"{last.text} {token.text}", last.start, token.end, last.value + token.value)
        else:
            joined.append(token)
    return joined
