"""Tokens of an English text: words in the singular, numbers, units and punctuation, each with its place.

Reads from left to right without stepping back, so the time is proportional to the length of the text.
"""

import re
from dataclasses import dataclass
from typing import Literal, TypeAlias

from mansion_language.inflection import singular
from mansion_language.numbers import CARDINALS, ORDINALS, SCALES, SOFT_NUMBERS, figure
from mansion_language.units import AREA, AREA_PATTERN, LENGTH_PATTERN

__all__ = ["Kind", "Token", "lower_without_accents", "tokenize"]

Kind: TypeAlias = Literal["word", "number", "ordinal", "unit", "level", "mark"]


@dataclass(frozen=True)
class Token:
    """A word, number, unit or mark of a text.

    Attributes
    ----------
    kind : {"word", "number", "ordinal", "unit", "level", "mark"}
        ``level`` is a storey in short form, such as ``L2`` or ``4F``.
    text : str
        Lower case and in the singular; units and marks by one spelling each (``m2``, ``-`` for every dash).
    start, end : int
        Place in the text, in characters, end exclusive.
    value : float
        Value of a number, an ordinal or a level.
    plural : bool
        The word stands in the plural.
    soft : bool
        A number word that may also be an adjective, such as ``double``.
    spaced : bool
        White space or the start of the text comes before; not a hyphen.
    capital : bool
        The word is written with a capital letter.
    """

    kind: Kind
    text: str
    start: int
    end: int
    value: float = 0.0
    plural: bool = False
    soft: bool = False
    spaced: bool = True
    capital: bool = False


# Alternatives are tried in this order. Quantifiers of figures are possessive: "85sqm" is never read as 8 and "5sqm".
_TOKEN = re.compile(
    r"(?P<blank>[^\S\n]++)"
    r"|(?P<ordinal>\d++(?=(?:st|nd|rd|th)(?![a-z]))(?:st|nd|rd|th))"
    r"|(?P<without>w/o(?![a-z]))"
    r"|(?P<level>(?:l|lvl|f)[ .]?\d{1,3}(?![\w.,]*\d)(?![a-z])|\d{1,3}+f(?![a-z\d]))"
    r"|(?P<compound>[23]d(?![a-z\d])|[a-z]&[a-z](?![a-z]))"
    r"|(?P<number>\d{1,3}(?:[ ,.'’]\d{3})++(?!\d)|\d++(?:[.,]\d++)?+)(?P<thousand>k(?=[ ]?(?:m2|m²|sq|ft)))?"
    rf"|(?P<area>{AREA_PATTERN})"
    rf"|(?P<length>(?<=[\d ])(?:{LENGTH_PATTERN}))"
    r"|(?P<range>(?<=[\d])[-–—‑−](?=\d))"
    r"|(?P<hyphen>(?<=[^\s])[-‑](?=[^\s]))"
    r"|(?P<dash>[-–—−]+)"
    r"|(?P<times>[×✕])"
    r"|(?P<bullet>[•*·▪◦])"
    r"|(?P<quote>[\"“”«»„])"
    r"|(?P<mark>[,.;:()\[\]\n&+/?!%=|#])"
    r"|(?P<word>[a-z]++(?:['’](?!s\b)[a-z]++)?)(?P<genitive>['’]s?+(?![a-z]))?"
)

_CONTRACTIONS = {
    "don't": "not",
    "doesn't": "not",
    "isn't": "not",
    "aren't": "not",
    "won't": "not",
    "can't": "not",
    "mustn't": "not",
    "shouldn't": "not",
    "needn't": "not",
    "wouldn't": "not",
    "didn't": "not",
    "couldn't": "not",
    "there's": "there",
    "it's": "it",
    "we'd": "we",
    "i'd": "i",
    "we're": "we",
    "i'm": "i",
    "let's": "let",
    "we've": "we",
    "i've": "i",
    "that's": "that",
    "you'll": "you",
    "we'll": "we",
    "cannot": "not",
    "w": "with",
    "bldg": "building",
    "lvl": "level",
    "hse": "house",
    "alltogether": "altogether",
}

_CONTRACTIONS |= {
    written.replace("'", ""): read
    for written, read in tuple(_CONTRACTIONS.items())
    if read == "not" and written not in ("can't", "won't")
}
"""Denials are written without their apostrophe too; two of them are words of another meaning then."""

_TRIPLED = re.compile(r"([a-z])\1{2,}")
"""No English word has a letter three times in a row."""

_ACCENTS = str.maketrans("éèêàáâäöôóüûúïîíçñåø", "eeeaaaaooouuuiiicnao")


def tokenize(text: str) -> list[Token]:
    """Split `text` into tokens; characters of other scripts are skipped.

    Examples
    --------
    >>> [(token.kind, token.text) for token in tokenize("Two flats of 85sqm")]
    [('number', 'two'), ('word', 'flat'), ('word', 'of'), ('number', '85'), ('unit', 'm2')]
    """
    tokens: list[Token] = []
    end = -1
    for match in _TOKEN.finditer(lower_without_accents(text)):
        if match["hyphen"]:
            end = match.end()
        if match["blank"] or match["hyphen"]:
            continue
        token = _token(match, text, spaced=match.start() != end)
        end = match.end()
        tokens.append(token)
    return _join_number_words(tokens)


def lower_without_accents(text: str) -> str:
    """Return lower case without accents, of the same length, so that places stay valid."""
    low = text.lower()
    if len(low) != len(text):
        low = "".join(char.lower() if len(char.lower()) == 1 else char for char in text)
    return low.translate(_ACCENTS)


def _token(match: re.Match[str], text: str, *, spaced: bool) -> Token:
    start, end = match.span()
    kind = match.lastgroup or ""
    if match["number"]:
        value = figure(match["number"]) * (1000 if match["thousand"] else 1)
        return Token("number", match["number"], start, end, value, spaced=spaced)
    if match["ordinal"]:
        return Token("ordinal", match["ordinal"], start, end, figure(match["ordinal"][:-2]), spaced=spaced)
    if match["level"]:
        return Token("level", match["level"], start, end, float(re.sub(r"\D", "", match["level"])), spaced=spaced)
    if match["area"]:
        return Token("unit", next(unit for unit in AREA if match[unit]), start, end, spaced=spaced)
    if match["length"]:
        return Token("unit", next(u for u in ("cm", "m", "ft") if match[u]), start, end, spaced=spaced)
    if match["without"]:
        return Token("word", "without", start, end, spaced=spaced)
    if match["compound"]:
        return Token("word", match["compound"], start, end, spaced=spaced, capital=text[start:end][:1].isupper())
    if match["word"]:
        return _word(match["word"], text[start:end], start, end, spaced=spaced)
    marks = {"range": "–", "dash": "-", "times": "x", "bullet": "*", "quote": '"'}
    return Token("mark", marks.get(kind, match.group()), start, end, spaced=spaced)


def _word(word: str, written: str, start: int, end: int, *, spaced: bool) -> Token:
    word = _CONTRACTIONS.get(word.replace("’", "'"), word.partition("'")[0].partition("’")[0])
    word = _TRIPLED.sub(r"\1\1", word)
    capital = written[:1].isupper()
    if word in ORDINALS:
        return Token("ordinal", word, start, end, float(ORDINALS[word]), spaced=spaced, capital=capital)
    if word in CARDINALS:
        soft = word in SOFT_NUMBERS
        return Token("number", word, start, end, float(CARDINALS[word]), soft=soft, spaced=spaced, capital=capital)
    if word in ("lvls", "flrs"):
        word = "levels"
    base = singular(word)
    base = "people" if base == "person" and word == "people" else base
    return Token("word", base, start, end, plural=base != word or word == "people", spaced=spaced, capital=capital)


def _join_number_words(tokens: list[Token]) -> list[Token]:
    """Join ``twenty five``, ``two hundred and forty``, ``twenty first`` into one token."""
    joined: list[Token] = []
    for number, token in enumerate(tokens):
        last = joined[-1] if joined else None
        following = tokens[number + 1] if number + 1 < len(tokens) else None
        spelt = last is not None and last.kind == "number" and last.text[0].isalpha() and not last.soft
        if token.text in SCALES:
            if last is not None and last.kind == "number" and last.value < 1000:
                value = last.value * SCALES[token.text]
                joined[-1] = Token("number", f"{last.text} {token.text}", last.start, token.end, value)
            else:
                joined.append(Token("number", token.text, token.start, token.end, float(SCALES[token.text])))
        elif (
            last is not None
            and spelt
            and token.text == "and"
            and last.text.endswith(("hundred", "thousand"))
            and following is not None
            and following.text in CARDINALS
            and not following.soft
            and following.value < 100
        ):
            joined[-1] = Token("number", f"{last.text} and", last.start, token.end, last.value)
        elif last is not None and spelt and token.text[0].isalpha() and not token.soft and _adds(last, token):
            kind: Kind = token.kind
            joined[-1] = Token(kind, f"{last.text} {token.text}", last.start, token.end, last.value + token.value)
        else:
            joined.append(token)
    return joined


def _adds(last: Token, token: Token) -> bool:
    """Whether two number words make one number by addition."""
    if token.kind not in ("number", "ordinal"):
        return False
    tens = 20 <= last.value <= 90 and last.value % 10 == 0 and 1 <= token.value <= 9 and token.start - last.end <= 1
    return tens or (last.text.endswith(("hundred", "thousand", "and")) and token.value < 100)
