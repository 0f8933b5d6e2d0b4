"""Limits told after their number: ``eight at the least``, ``four of them minimum`` are at least eight and four."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.words import PREPOSITIONS, Word, text_at

__all__ = ["limits_before"]

_LEAST: Final = ("at", "least")
_MOST: Final = ("at", "most")
_LIMITS: Final = (
    (("at", "the", "very", "least"), _LEAST), (("at", "the", "very", "most"), _MOST),
    (("at", "the", "least"), _LEAST), (("at", "the", "most"), _MOST), (("at", "very", "least"), _LEAST),
    (("as", "a", "minimum"), _LEAST), (("as", "a", "maximum"), _MOST), (("at", "a", "minimum"), _LEAST),
    (("at", "minimum"), _LEAST), (("at", "maximum"), _MOST), (("at", "least"), _LEAST), (("at", "most"), _MOST),
    (("minimum",), _LEAST), (("maximum",), _MOST), (("or", "more"), _LEAST), (("or", "fewer"), _MOST),
)  # fmt: skip
"""Limits, the longer ones first, and how they stand before a number."""

_OF_THEM: Final = (("of", "them"), ("of", "those"), ("of", "these"))
_REACH: Final = 5
"""Most words from a number to the limit after it."""


def limits_before(words: Sequence[Word]) -> list[Word]:
    """Return words with each limit before its number, and without ``the`` in it."""
    out = list(words)
    at = 0
    while at < len(out):
        limit = next(((said, plain) for said, plain in _LIMITS if _texts(out, at, len(said)) == said), None)
        if limit is None:
            at += 1
            continue
        said, plain = limit
        end = at + len(said)
        number = _number_before(out, at) if _ends(out, end) else -1
        if number >= 0:
            between = [word for word in out[number:at] if word.kind != "mark"]
            between = between[:-2] if _texts(between, len(between) - 2, 2) in _OF_THEM else between
            out[number:end] = [*_plainly(out[number], plain), *between[:-1], replace(between[-1], end=out[end - 1].end)]
        elif end < len(out) and out[end].kind == "number" and said[0] == "at":
            out[at:end] = _plainly(out[at], plain)
        at += len(plain)
        if at < len(out) and out[at].kind == "number" and _texts(out, at + 1, 2) in _OF_THEM and said[0] == "at":
            out[at : at + 3] = [replace(out[at], end=out[at + 2].end)]
    return out


def _texts(words: Sequence[Word], at: int, length: int) -> tuple[str, ...]:
    return tuple(word.text for word in words[at : at + length])


def _plainly(first: Word, plain: Sequence[str]) -> list[Word]:
    return [replace(first, text=text, raw=text, kind="word", value=0.0, end=first.start) for text in plain]


def _ends(words: Sequence[Word], at: int) -> bool:
    """Whether nothing follows that the limit may belong to: ``at most three`` chairs."""
    return at >= len(words) or words[at].kind == "mark" or text_at(words, at) in PREPOSITIONS | {"and", "please", "but"}


def _number_before(words: Sequence[Word], at: int) -> int:
    """Return where the number stands that words right before a limit count; -1 where there is none."""
    last = at - 1 - (text_at(words, at - 1) == ",")
    for place in range(last, max(-1, last - _REACH), -1):
        word = words[place]
        if word.kind == "number":
            limited = text_at(words, place - 1) in ("least", "most", "the", "than", "exactly", "only")
            return -1 if limited else place
        if word.kind != "word" or word.text in PREPOSITIONS - {"of"}:
            return -1
    return -1
