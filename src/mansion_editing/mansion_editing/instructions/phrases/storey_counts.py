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

_AFTER_UP: Final = frozenset("please is are has have need".split())


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


def counted_from_ground(words: Sequence[Word], text: str, brief: str, floors: Sequence[int]) -> list[Word]:
    """Return words with the ordinals of storeys as if the ground floor were the first.

    A number beside the ordinal tells how it counts, ``first floor (level 2)``; so does a storey that the building
    would not have. ``The first floor up`` is above the ground floor, however the others count.

    Parameters
    ----------
    floors : sequence of int
        Those of the building.
    """
    named = [at for at, word in enumerate(words) if word.kind == "ordinal" and _is_of_storey(words, at)]
    told = next((level for at in named if (level := _level_beside(words, at)) is not None), None)
    if told is not None:
        above = told[1] == told[0] + 1
    else:
        outside = any(words[at].value >= floors[-1] for at in named if not _is_up(words, at))
        known = all(words[at].value <= floors[-1] for at in named)
        above = counts_above_ground(text, brief) and (bool(_SAID.search(text)) or not (outside and known))
    up = {at for at in named if _is_up(words, at)}
    return [
        replace(word, value=word.value + 1) if at in named and (above or at in up) else word
        for at, word in enumerate(words)
        if at - 2 not in up
    ]


def _is_up(words: Sequence[Word], at: int) -> bool:
    """Whether ``floor up`` follows an ordinal, and no way that leads up."""
    following = words[at + 3] if at + 3 < len(words) else None
    ends = following is None or following.kind == "mark" or following.text in _AFTER_UP
    return (text_at(words, at + 1), text_at(words, at + 2)) == ("floor", "up") and ends


def _level_beside(words: Sequence[Word], at: int) -> tuple[float, float] | None:
    """Return an ordinal and the number of its storey: 1 and 2 of ``first floor (level 2)``; None for others."""
    place = at + 2 + _is_up(words, at)
    if text_at(words, at + 1) != "floor" or text_at(words, place) not in ("(", ",") or place + 1 >= len(words):
        return None
    level = words[place + 1]
    if level.text == "floor" and place + 2 < len(words) and words[place + 2].kind == "number":
        level = words[place + 2]
    elif level.kind != "level":
        return None
    return words[at].value, level.value


def _is_of_storey(words: Sequence[Word], at: int) -> bool:
    after = at + 1
    while text_at(words, after) in ("and", ",", "or", "the") or (after < len(words) and words[after].kind == "ordinal"):
        after += 1
    return text_at(words, after) == "floor"
