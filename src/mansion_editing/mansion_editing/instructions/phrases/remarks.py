"""Words within a clause that no scene records: for whom something is, from when on it holds, numbers called so."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.verb_words import BY_WORDS
from mansion_editing.instructions.phrases.word_sets import PEOPLE
from mansion_editing.instructions.phrases.words import (
    BE,
    DETERMINERS,
    HAVE,
    MODALS,
    NEED,
    PERSONS,
    PREPOSITIONS,
    PRONOUNS,
    Word,
    text_at,
)

__all__ = ["without_remarks"]

_DAYS: Final = frozenset("monday tuesday wednesday thursday friday saturday sunday".split())
_MONTHS: Final = frozenset("january february march april june july august september october november december".split())
_SPANS: Final = frozenset("week month year term semester season weekend morning afternoon evening night".split())
_MOMENTS: Final = frozenset("tomorrow today tonight noon midnight".split())
_WHICH: Final = frozenset("next this coming following".split())
_DURING: Final = frozenset("for over during through throughout".split())
_SINCE: Final = frozenset("from starting until till by".split())
_OWNERS: Final = frozenset("the my our your his her their".split())
_KIN: Final = frozenset(
    "husband wife partner son daughter mother father mum dad brother sister aunt uncle grandma grandpa boss doctor "
    "assistant secretary resident nurse".split()
)
_NUMBERED: Final = frozenset("no nr number".split())
_FOLLOWING: Final = PREPOSITIONS | PRONOUNS | DETERMINERS | BE | MODALS | {"and", "please", "i", "we", "he", "she"}
"""What stands after a remark, and not after the modifier of a noun."""


def without_remarks(words: Sequence[Word]) -> list[Word]:
    """Return words without persons that something is for, and without the days and weeks from which it holds.

    ``no. 2`` after a room is its number, and a storey after a comma is where the room is.
    """
    words = _without_brackets(words)
    out: list[Word] = []
    at = 0
    while at < len(words):
        end = _end_of_person(words, at) or _end_of_time(words, at)
        if end:
            at = end + (text_at(words, end) == "," and not out)
            continue
        if _closes_storey(out, words, at):
            at += 1
            continue
        if _is_number_word(words, at):
            if out and out[-1].text == ",":
                out.pop()
            at += 1
            continue
        if _is_storey_apart(out, words, at):
            out.append(replace(words[at], text="on", raw="on", kind="word"))
            at += 1
            continue
        out.append(words[at])
        at += 1
    return out


def _ends(words: Sequence[Word], at: int) -> bool:
    return at >= len(words) or words[at].kind == "mark"


def _end_of_person(words: Sequence[Word], at: int) -> int:
    """Return the end of ``for him``, ``for my husband``; 0 where the person is part of a name, as in a guest room."""
    if text_at(words, at) != "for" or at == 0 or text_at(words, at - 1) in BE or text_at(words, at - 3) == "as":
        return 0
    end = at + 1
    if text_at(words, end) in ("him", "her"):
        end += 1
    elif text_at(words, end) in _OWNERS and text_at(words, end + 1) in (PEOPLE | PERSONS | _KIN) - {"robot"}:
        end += 2
    else:
        return 0
    bare = _ends(words, end) or text_at(words, end) in PREPOSITIONS - {"of", "with", "for"} | {"until", "and"}
    return end if bare and not words[end - 1].genitive else 0


def _end_of_time(words: Sequence[Word], at: int) -> int:
    """Return the end of ``from next week``, ``as of Monday``; 0 for others."""
    place = at
    if (text_at(words, place), text_at(words, place + 1)) == ("as", "of"):
        place += 2
    elif text_at(words, place) in _SINCE:
        place += 1 + (text_at(words, place + 1) in ("from", "with"))
    elif text_at(words, place) in _DURING and text_at(words, place + 1) in ("the", *_WHICH) and place:
        return place + 3 if text_at(words, place + 2) in _SPANS and _ends(words, place + 3) else 0
    else:
        return 0
    which = text_at(words, place) in _WHICH
    place += which
    named = text_at(words, place) in (_DAYS | _MONTHS | _MOMENTS | (_SPANS if which else frozenset()))
    if not named or words[place].genitive:
        return 0
    end = place + 1
    end += text_at(words, end) in _SPANS and words[place].text in _DAYS | _MOMENTS
    if text_at(words, end) in ("on", "onward", "onwards"):
        end += 1
    verb = (text_at(words, end),) in BY_WORDS and not words[end].plural if end < len(words) else False
    return end if _ends(words, end) or verb or text_at(words, end) in _FOLLOWING else 0


def _is_number_word(words: Sequence[Word], at: int) -> bool:
    """Whether ``no.`` or ``number`` stands between a noun and its number."""
    if text_at(words, at) not in _NUMBERED or at == 0 or at + 1 >= len(words):
        return False
    before = words[at - 2] if words[at - 1].text == "," and at > 1 else words[at - 1]
    plain = before.kind == "word" and before.text not in BE | PREPOSITIONS | DETERMINERS | {"there", "have", "has"}
    return plain and words[at + 1].raw.isdecimal() and (_ends(words, at + 2) or text_at(words, at + 2) in _FOLLOWING)


_STOREYS: Final = frozenset("ground top upper lower first second third fourth fifth sixth".split())


def _without_brackets(words: Sequence[Word]) -> Sequence[Word]:
    """Return ``the freezer in the laboratory on second floor is`` for ``in the laboratory (second floor) is``."""
    out: list[Word] = []
    at = 0
    while at < len(words):
        start = at + 1 + (text_at(words, at + 1) == "the")
        storey = text_at(words, start) in _STOREYS or (start < len(words) and words[start].kind == "ordinal")
        closed = storey and (text_at(words, start + 1), text_at(words, start + 2)) == ("floor", ")")
        if words[at].text == "(" and closed and out and out[-1].kind != "mark":
            floor = replace(words[start + 1], end=words[start + 2].end)
            out += [replace(words[at], text="on", raw="on", kind="word"), *words[at + 1 : start + 1], floor]
            at = start + 3
            continue
        out.append(words[at])
        at += 1
    return out


def _is_storey_apart(before: Sequence[Word], words: Sequence[Word], at: int) -> bool:
    """Whether a comma only parts a numbered room from its storey: ``room 4, ground floor, needs a lamp``."""
    if text_at(words, at) != "," or len(before) < 2 or not before[-1].raw.isdecimal():
        return False
    place = at + 1 + (text_at(words, at + 1) == "the")
    storey = text_at(words, place) in _STOREYS or (place < len(words) and words[place].kind == "ordinal")
    numbered = before[-2].kind == "word" and before[-2].text not in ("floor", "and") and not before[-2].plural
    return storey and text_at(words, place + 1) == "floor" and numbered and not _lists_storeys(words, place + 2)


def _closes_storey(before: Sequence[Word], words: Sequence[Word], at: int) -> bool:
    """Whether a comma ends such a storey before the verb of its room or person."""
    told = text_at(before, len(before) - 1) == "floor" and any(word.raw == "on" for word in before[-4:-2])
    return text_at(words, at) == "," and told and text_at(words, at + 1) in BE | NEED | HAVE | MODALS


def _lists_storeys(words: Sequence[Word], at: int) -> bool:
    return any(word.text == "floor" for word in words[at : at + 4])
