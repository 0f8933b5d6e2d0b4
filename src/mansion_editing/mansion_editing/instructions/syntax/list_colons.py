"""Colons between a verb and the list of its objects, which only slow the reader: ``on each I need: a lamp, a mug``."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.syntax.tagged_words import TaggedWord

__all__ = ["without_list_colons"]

_TAKING_LISTS: Final = frozenset("need want like have get require add put bring remove take add".split())


def without_list_colons(words: Sequence[TaggedWord]) -> list[TaggedWord]:
    """Return words without the colons that part a verb from its objects."""
    return [
        word
        for at, word in enumerate(words)
        if not (word.text == ":" and at and _takes_list(words, at - 1) and at + 1 < len(words))
    ]


def _takes_list(words: Sequence[TaggedWord], at: int) -> bool:
    return words[at].verb in _TAKING_LISTS or (words[at].tag == "have" and words[at].text != "having")
