"""Totals told after what comes: ``a vase on each table, nine in all``, ``two more chairs, six in all``."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.words import Word, text_at

__all__ = ["totals_before"]

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
