"""Purposes and contrasts after a clause that ask for nothing more: ``so it goes with the one in the hall``."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.word_sets import PEOPLE
from mansion_editing.instructions.phrases.words import DETERMINERS, PERSONS, Word, next_mark, text_at
from mansion_editing.instructions.statements import Finish, Paint, Statement
from mansion_language.colours import COLOUR_WORDS

__all__ = ["end_of_purpose"]

_SUITING: Final = frozenset("match fit suit".split())
_FORMER: Final = frozenset("carpet carpeting tile parquet laminate linoleum lino vinyl concrete wallpaper".split())
"""What floors and walls are covered with; a rug is a thing that lies on them."""
_JOINING: Final = frozenset("and but then or".split())
_LONGEST_SUBJECT: Final = 3


def end_of_purpose(words: Sequence[Word], at: int, clause: Sequence[Statement]) -> int:
    """Return the end of a purpose or a contrast after a clause that has said what shall be; 0 for other words.

    Parameters
    ----------
    clause : sequence of Statement
        What the clause asks for.
    """
    at += text_at(words, at) == ","
    end = next((k for k in range(at, next_mark(words, at)) if words[k].text in _JOINING), next_mark(words, at))
    if not clause or (end < len(words) and words[end].text in _JOINING):
        return 0
    said = words[at:end]
    coloured = all(isinstance(s, Paint | Finish) and (s.colour or s.material) for s in clause)
    laid = all(isinstance(s, Finish) for s in clause)
    held = (coloured and _suits(said)) or _spares_people(said) or (laid and _is_former(said))
    return end if held else 0


def _suits(said: Sequence[Word]) -> bool:
    """Whether words say what a colour goes with: ``so that it matches the sofa``, ``to go with the curtains``."""
    verb = 1
    if text_at(said, 0) == "so":
        verb += (text_at(said, 1) == "that") + 1
        if text_at(said, verb - 1) not in ("it", "they"):
            return False
    elif text_at(said, 0) != "to":
        return False
    length = 1 + (text_at(said, verb) in ("go", "fit") and text_at(said, verb + 1) == "with")
    suits = text_at(said, verb) in _SUITING or length > 1
    named = text_at(said, verb + length) in DETERMINERS and verb + length + 1 < len(said)
    return suits and named and not any(word.text in COLOUR_WORDS or word.text == "not" for word in said)


def _spares_people(said: Sequence[Word]) -> bool:
    """Whether words say what people no longer have to do: ``so that guests needn't walk through the hall``."""
    start = 1 + (text_at(said, 1) == "that")
    denied = next((k for k in range(start, min(len(said), start + _LONGEST_SUBJECT + 2)) if said[k].text == "not"), 0)
    subject = {word.text for word in said[start:denied]} - {"do", "need"}
    people = subject & (PERSONS | PEOPLE | {"they", "one", "nobody", "you"})
    obliged = said[denied].raw == "needn't" if denied else False
    obliged = obliged or text_at(said, denied - 1) == "need"
    obliged = obliged or (text_at(said, denied + 1) in ("have", "need") and text_at(said, denied + 2) == "to")
    return text_at(said, 0) == "so" and bool(denied and people and obliged)


def _is_former(said: Sequence[Word]) -> bool:
    """Whether words name the covering that a new one comes for: ``in place of that grey carpet``."""
    length = {("instead", "of"): 2, ("in", "place"): 3, ("rather", "than"): 2}.get((text_at(said, 0), text_at(said, 1)))
    if length is None or (length == 3 and text_at(said, 2) != "of"):
        return False
    named = [word.text for word in said[length:] if word.text not in DETERMINERS | {"old", "present", "worn"}]
    return bool(named) and named[-1] in _FORMER and all(word in COLOUR_WORDS for word in named[:-1])
