"""Times of day in headings, which no scene records: ``Client meeting at ten in the conference room: ...``."""

import re
from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.words import PREPOSITIONS, SENTENCE_ENDS, Word, text_at

__all__ = ["without_times_of_headings"]

_BEFORE: Final = frozenset("at from by until till around about between".split())
_THROUGH: Final = frozenset(["to", "-", "until", "till", "and"])
_HALVES: Final = frozenset(["am", "pm", "o", "h", "hour"])
_NOONS: Final = frozenset(["noon", "midnight", "midday"])
_CODE: Final = re.compile(r"\d{1,2}(h|am|pm)")
_HOURS: Final = 24


def without_times_of_headings(words: Sequence[Word]) -> list[Word]:
    """Return words without the times of day that stand between the beginning of a sentence and its colon."""
    out: list[Word] = []
    start = 0
    for at, word in enumerate(words):
        ends = word.kind == "mark" and word.text in SENTENCE_ENDS
        if ends or at + 1 == len(words):
            out += _without_times(words[start : at + 1])
            start = at + 1
    return out


def _without_times(sentence: Sequence[Word]) -> list[Word]:
    colon = next((k for k, word in enumerate(sentence) if word.text == ":" and not _is_within_time(sentence, k)), 0)
    out: list[Word] = []
    at = 0
    while at < colon:
        end = _end_of_time(sentence, at)
        if end and end <= colon:
            at = end
            continue
        out.append(sentence[at])
        at += 1
    kept = [word for k, word in enumerate(out) if word.text != "," or text_at(out, k + 1) not in (",", "")]
    return [*kept, *sentence[colon:]]


def _is_within_time(words: Sequence[Word], at: int) -> bool:
    """Whether a colon stands between hours and minutes: ``14:30``."""
    if not 0 < at < len(words) - 1 or words[at].text != ":":
        return False
    before, after = words[at - 1], words[at + 1]
    touching = before.end == words[at].start and words[at].end == after.start
    return touching and before.raw.isdecimal() and after.raw.isdecimal()


def _end_of_time(words: Sequence[Word], at: int) -> int:
    """Return the end of ``at ten``, ``from 9 to 12``, ``8 am``; 0 for others."""
    told = text_at(words, at) in _BEFORE
    place = at + told + (text_at(words, at + told) in ("around", "about"))
    end = _end_of_clock(words, place, bare=told)
    if end and text_at(words, end) in _THROUGH:
        end = _end_of_clock(words, end + 1, bare=True) or end
    follows = end >= len(words) or words[end].kind == "mark" or text_at(words, end) in PREPOSITIONS
    return end if end and follows else 0


def _end_of_clock(words: Sequence[Word], at: int, *, bare: bool) -> int:
    """Return the end of one time of day; a `bare` number is one only after its preposition."""
    if text_at(words, at) in _NOONS:
        return at + 1
    if text_at(words, at) in ("half", "quarter") and text_at(words, at + 1) in ("past", "to"):
        return _end_of_clock(words, at + 2, bare=True)
    if at >= len(words):
        return 0
    if words[at].kind == "code" and _CODE.fullmatch(words[at].raw):
        return at + 1
    if words[at].kind != "number" or not 0 <= words[at].value <= _HOURS:
        return 0
    end = at + 3 if _is_within_time(words, at + 1) else at + 1
    named = text_at(words, end) in _HALVES
    return end + named if named or bare or end > at + 1 else 0
