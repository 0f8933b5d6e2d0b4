"""Where the count of storeys begins: with the ground floor, or with the one above it, as in Britain."""

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.words import Word, text_at

__all__ = ["counted_from_ground", "counts_above_ground"]

_SAID: Final = re.compile(
    r"ground (floor|level|storey) (is|as|being|counts as|=) (zero|0|nought|null)|british (count|way|style|floor)"
    r"|(above|not counting|without) the ground floor", re.IGNORECASE
)  # fmt: skip
_GROUND: Final = re.compile(r"\bground[- ](floor|level|storey)\b", re.IGNORECASE)
_FIRST: Final = re.compile(r"\b(first|1st)[- ](floor|storey|level|upper)\b", re.IGNORECASE)


def counts_above_ground(text: str, brief: str) -> bool:
    """Whether ``first floor`` means the storey above the ground floor, as a text or the building's brief has it.

    Examples
    --------
    >>> counts_above_ground("a plant on the first floor", "Ground floor: lobby. First floor: offices.")
    True
    >>> counts_above_ground("a plant on the first floor", "Ground floor: lobby. Second floor: offices.")
    False
    """
    if _SAID.search(text):
        return True
    return any(_GROUND.search(words) and _FIRST.search(words) for words in (text, brief))


def counted_from_ground(words: Sequence[Word]) -> list[Word]:
    """Return words with the ordinals of storeys as if the ground floor were the first."""
    return [
        replace(word, value=word.value + 1) if word.kind == "ordinal" and _is_of_storey(words, at) else word
        for at, word in enumerate(words)
    ]


def _is_of_storey(words: Sequence[Word], at: int) -> bool:
    after = at + 1
    while text_at(words, after) in ("and", ",", "or", "the") or (after < len(words) and words[after].kind == "ordinal"):
        after += 1
    return text_at(words, after) == "floor"
