"""Limits and totals told after what comes: ``eight at the least``, ``a vase on each table, nine in all``."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.words import PREPOSITIONS, Word, text_at

__all__ = ["limits_before", "totals_before"]

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


_TOTALS: Final = (("in", "all"), ("in", "total"), ("all", "in", "all"), ("altogether",), ("all", "together"))


def totals_before(words: Sequence[Word]) -> list[Word]:
    """Return words with a total as the number of places that are each given one, or of all that there shall be."""
    out = list(words)
    for at in range(len(out) - 1, 2, -1):
        length = _length_of_total(out, at) if at < len(out) else 0
        each = _each_before(out, at - 1) if length else -1
        if length and each < 0 and _adds(out, at - 1):
            there = [_plain(out[at - 1], text) for text in ("so", "that", "there", "are")]
            out = [*out[:at], *there, out[at], *out[at + 1 + length :]]
        if each < 0:
            continue
        end = at + 1 + length
        end += text_at(out, at - 1) == "(" and text_at(out, end) == ")"
        told = out[each + 1 : at - 1]
        named = next((word for word in told[:3] if word.kind == "number"), None)
        if named is not None and named.value != out[at].value:
            continue  # one of the two numbers is wrong
        first = replace(out[each], text="each", raw="each")
        among = (
            [] if named is not None else [_plain(first, "of"), _plain(first, "the"), replace(out[at], end=first.end)]
        )
        out = [*out[:each], first, *among, *told, *out[end:]]
    return out


def _length_of_total(words: Sequence[Word], at: int) -> int:
    """Return how many words after a number make it a total; 0 where it is none."""
    if words[at].kind != "number" or words[at].value <= 1 or text_at(words, at - 1) not in (",", "(", "-"):
        return 0
    said = tuple(word.text for word in words[at + 1 : at + 4])
    length = next((len(total) for total in _TOTALS if said[: len(total)] == total), 0)
    after = at + 1 + length
    ends = after >= len(words) or words[after].kind == "mark" or text_at(words, after) in ("and", "plus", "please")
    return length if ends else 0


def _each_before(words: Sequence[Word], at: int) -> int:
    """Return where ``each`` or ``every`` stands in the words right before a mark; -1 where there is none."""
    for place in range(at - 1, -1, -1):
        if words[place].kind == "mark":
            break
        if words[place].text in ("each", "every"):
            return place
    return -1


def _adds(words: Sequence[Word], at: int) -> bool:
    """Whether the words right before a mark bring more: ``two more chairs, six in all``."""
    begin = next((k + 1 for k in range(at - 1, -1, -1) if words[k].kind == "mark"), 0)
    return any(word.text in ("more", "another", "additional", "extra") for word in words[begin:at])


def _plain(word: Word, text: str) -> Word:
    return replace(word, text=text, raw=text, kind="word", start=word.end)
