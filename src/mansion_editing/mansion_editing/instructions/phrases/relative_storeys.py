"""How many storeys up or down a place is said to be: ``one flight up``, ``two floors below``, ``the floor above``."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.amounts import number_at
from mansion_editing.instructions.phrases.words import Word, text_at

__all__ = ["RelativeStorey", "read_relative_storey"]

RelativeStorey = tuple[int, int]
"""How many storeys up, and the place in the words after them."""

_STEPS: Final = frozenset(["flight", "floor", "level", "storey", "story"])
_UP: Final = {"up": 1, "higher": 1, "above": 1, "upstairs": 1, "down": -1, "lower": -1, "below": -1, "downstairs": -1}
_AHEAD: Final = {"up": 1, "down": -1}


def read_relative_storey(words: Sequence[Word], at: int) -> RelativeStorey | None:
    """Read storeys that are counted from elsewhere; None where the words at a place are none."""
    place = at + (text_at(words, at) in ("on", "at") and text_at(words, at + 1) in ("the", "next"))
    if text_at(words, place) in _AHEAD:
        steps = _steps(words, place + 1)
        return None if steps is None else (_AHEAD[words[place].text] * steps[0], steps[1])
    steps = _steps(words, place)
    if steps is None or text_at(words, steps[1]) not in _UP:
        return None
    number, end = steps
    return _UP[words[end].text] * number, end + 1


def _steps(words: Sequence[Word], at: int) -> tuple[int, int] | None:
    """Read ``one floor``, ``two flights of stairs``, ``another level``, ``the next floor``, ``the floor``."""
    place = at
    number = number_at(words, place)
    if number is not None:
        place += 1
    else:
        number = 1
        while text_at(words, place) in ("a", "an", "another", "the", "next", "single"):
            place += 1
    if text_at(words, place) not in _STEPS or place == at:
        return None
    place += 1
    place += 2 * (text_at(words, place) == "of" and text_at(words, place + 1) in ("stair", "stairs"))
    return number, place
