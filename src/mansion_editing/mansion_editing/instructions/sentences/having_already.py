"""Clauses by which those that have one already get no other: ``desks which have one don't need another``."""

from collections.abc import Sequence, Set
from typing import Final

from mansion_editing.instructions.phrases.words import FUNCTION_WORDS, Word

__all__ = ["spares_those_having"]

_IDLE: Final = frozenset("already got , - ( ) so then please though still and but anyway".split())
_OWNERS: Final = frozenset(
    "who whoever those the one room place all any of them that which where there is it they in on at for to".split()
)
_HAVING: Final = frozenset("have has with".split())
_DENYING: Final = frozenset("not no without never".split())
_GETTING: Final = frozenset("need get require want have take add do give put".split())
_FURTHER: Final = frozenset("another second more one extra new further".split())
_OF_DENIALS: Final = _DENYING | _GETTING | _FURTHER | frozenset("any a an it there them can could should must".split())
_ENOUGH: Final = frozenset("fine ok okay enough good has have leave skip skipped spare spared".split())
_OF_ENOUGH: Final = _ENOUGH | frozenset("is are be stay that this it they them one as well alone out at can".split())
_SPARING: Final = (("not",), ("skip",), ("spare",), ("except",), ("except", "for"), ("leave", "out"), ("apart", "from"))


def spares_those_having(words: Sequence[Word], asked: Sequence[Word]) -> bool:
    """Whether words only say that what has one already is to get no other.

    ``Who has one has one``, ``those with a vase need no second``, ``but not where there is one already``: all of them
    are words of such clauses, so that nothing else is asked for.

    Parameters
    ----------
    asked : sequence of Word
        The request before, which names what each gets, and who.
    """
    named = {word.text for word in asked if word.kind == "word"} - FUNCTION_WORDS
    texts = [word.text for word in words if word.text not in _IDLE]
    opening = max((len(said) for said in _SPARING if tuple(texts[: len(said)]) == said), default=0)
    owner, after = _having_one(texts[opening:], named)
    if not owner:
        return False
    if opening:
        return not after
    denied = bool(_DENYING & {*after}) and bool(_GETTING & {*after} or "without" in after) and {*after} <= _OF_DENIALS
    return (denied and bool(_FURTHER & {*after})) or (bool(_ENOUGH & {*after}) and {*after} <= _OF_ENOUGH)


def _having_one(texts: Sequence[str], named: Set[str]) -> tuple[bool, Sequence[str]]:
    """Return whether words begin with an owner that has one, and the words after that."""
    for at, text in enumerate(texts):
        there = text in ("is", "are") and texts[at - 1 : at] == ["there"] and "where" in texts[:at]
        if text not in _HAVING and not there:
            continue
        owner = {*texts[:at]}
        end = at + 1 + (texts[at + 1 : at + 2] in (["a"], ["an"], ["any"], ["its"], ["their"]))
        start = end
        while end < len(texts) and texts[end] in named:
            end += 1
        end += texts[end : end + 1] == ["one"] and end <= at + 1
        return bool(owner) and owner <= _OWNERS | named and (end > start), texts[end:]
    return False, texts
