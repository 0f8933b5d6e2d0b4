"""Requests implied rather than asked: ``I'd put a bin there``, ``clocks missing: 1x hall``, ``a cart is needed``."""

from collections.abc import Callable
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.rewritten_words import (
    COUNTED,
    PLACING,
    SPEAKERS,
    ends_at,
    like,
    over,
    said_at,
    sentence_start,
)
from mansion_editing.instructions.phrases.words import DETERMINERS, PREPOSITIONS, Word, next_mark, text_at

__all__ = ["WANTS"]

_SUPPOSING: Final = frozenset(
    "if unless but because yesterday before earlier already once when until rather never not normally usually".split()
)
"""Words by which ``I would`` supposes and ``I'd put`` tells what was, rather than advises."""
_LACKED: Final = frozenset("missing needed need lacking required require".split())


def _advised(words: list[Word]) -> list[Word]:
    """Return ``put a bin in the hall`` for ``I'd put a bin in the hall``; ``I'd put the bin ...`` may tell what was."""
    start = sentence_start(words)
    would = text_at(words, start + 1) == "would"
    contracted = start < len(words) and words[start].raw.endswith("'d")
    verb = start + 1 + would
    verb += text_at(words, verb) in ("also", "still")
    thing = words[verb + 1] if verb + 1 < len(words) else None
    speaks = text_at(words, start) in SPEAKERS and (would or contracted)
    if not speaks or text_at(words, verb) not in PLACING or thing is None:
        return words
    counted = thing.text in COUNTED or thing.kind == "number"
    if not counted or any(word.text in _SUPPOSING or word.text == "?" for word in words[verb:]):
        return words
    return [*words[:start], replace(words[verb], start=words[start].start), *words[verb + 1 :]]


def _missing_in(words: list[Word]) -> list[Word]:
    """Return ``put one clock in room A, one clock in room B`` for ``clocks missing: 1x A, 1x B``."""
    start = sentence_start(words)
    colon = next_mark(words, start)
    name = words[start : colon - 1]
    missing = text_at(words, colon) == ":" and text_at(words, colon - 1) in ("missing", "lacking", "needed")
    if not missing or not name or not all(word.kind == "word" for word in name):
        return words
    name = name[1:] if name[0].text in DETERMINERS else name
    out = [*words[:start], *like(("put",), words[start])]
    at = colon + 1
    while at < len(words):
        end = next_mark(words, at)
        times = words[at].text
        room = words[at + 1 : end]
        if words[at].kind != "code" or not (times[:-1].isdecimal() and times.endswith("x")) or not room:
            return words
        number = replace(words[at], text=times[:-1], raw=times[:-1], kind="number", value=float(times[:-1]))
        out += over(words[at:end], [number, *name, *like(("in",), words[at]), *room])
        out += words[end : end + 1]
        at = end + 1
    return out


def _needed_there(words: list[Word]) -> list[Word]:
    """Return ``we need a trolley there`` for ``a trolley is missing there``, ``... is needed in it``."""
    start = sentence_start(words)
    end = next_mark(words, start)
    verb = next((k for k in range(start + 2, end - 2) if words[k].text in ("is", "are")), 0)
    lacked = verb + 1 + (text_at(words, verb + 1) in ("still", "also", "now"))
    things = words[start:verb]
    counted = bool(things) and (things[0].text in COUNTED or things[0].kind == "number")
    plain = all(word.kind == "word" and word.text not in PREPOSITIONS for word in things[1:])
    there = said_at(words, lacked + 1, ("there",), ("in", "it"), ("in", "there"))
    if not (verb and counted and plain and there and text_at(words, lacked) in _LACKED):
        return words
    if not ends_at(words, lacked + 1 + there):
        return words
    wanted = [*like(("we", "need"), words[start]), *things, *like(("there",), words[lacked])]
    return [*words[:start], *over(words[start : lacked + 1 + there], wanted), *words[lacked + 1 + there :]]


WANTS: Final[tuple[Callable[[list[Word]], list[Word]], ...]] = (_advised, _missing_in, _needed_there)
"""What puts each of them as a plain request."""
