"""Places of several things that are told by these things alone: ``next to each other``, ``side by side``."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.words import Word, text_at
from mansion_editing.instructions.statements import Things

__all__ = ["EACH_OTHER", "end_of_each_other"]

EACH_OTHER: Final = Things(noun="each other", definite=True, plural=True)
"""What each of several things is beside."""

_BEGINNINGS: Final = (("right", "next", "to"), ("next", "to"), ("close", "to"), ("beside",), ("by",))
_THEMSELVES: Final = (("each", "other"), ("one", "another"))


def end_of_each_other(words: Sequence[Word], at: int) -> int:
    """Return the end of ``next to each other`` at a place in the words, 0 where it is not there."""
    if tuple(text_at(words, at + k) for k in range(3)) == ("side", "by", "side"):
        return at + 3
    for begin in _BEGINNINGS:
        end = at + len(begin)
        if tuple(text_at(words, at + k) for k in range(len(begin))) != begin:
            continue
        if (text_at(words, end), text_at(words, end + 1)) in _THEMSELVES:
            return end + 2
    return 0
