"""Pieces for rewording a sentence: where it begins, what is said at a place, and words that stand in for others."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.words import Word

__all__ = ["COUNTED", "PLACING", "SPEAKERS", "ends_at", "like", "over", "said_at", "sentence_start"]

SPEAKERS: Final = frozenset("i we".split())
COUNTED: Final = frozenset("a an another some".split())
PLACING: Final = frozenset("put place set add hang stand lay".split())


def sentence_start(words: Sequence[Word]) -> int:
    """Return where a sentence begins after the mark that ends the one before."""
    return next((k for k, word in enumerate(words) if word.kind != "mark"), len(words))


def said_at(words: Sequence[Word], at: int, *phrases: tuple[str, ...]) -> int:
    """Return how many words the longest of some phrases has that stands at a place, 0 for none."""
    first = words[at].text if at < len(words) else ""
    begun = (said for said in phrases if said[0] == first)
    found = (len(said) for said in begun if tuple(w.text for w in words[at : at + len(said)]) == said)
    return max(found, default=0)


def over(phrase: Sequence[Word], words: Sequence[Word]) -> list[Word]:
    """Return words that all stand where a phrase does, so that what is quoted of them is the phrase."""
    start, end = phrase[0].start, phrase[-1].end
    return [replace(word, start=start, end=end) for word in words]


def like(texts: Sequence[str], word: Word) -> list[Word]:
    """Return plain words that stand where a word does."""
    return [replace(word, text=text, raw=text, kind="word", plural=False, genitive=False) for text in texts]


def ends_at(words: Sequence[Word], at: int) -> bool:
    """Whether a clause or the text ends before a place."""
    return at >= len(words) or words[at].kind == "mark"
