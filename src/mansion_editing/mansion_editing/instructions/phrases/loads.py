"""What furniture carries and takes along: ``with everything that lies on it``."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.words import Word, text_at

__all__ = ["end_of_load"]

_WITH: Final = (("along", "with"), ("together", "with"), ("with",), ("including",), ("and",), ("plus",))
_ALL: Final = frozenset("everything all whatever anything".split())
_RESTS: Final = frozenset("is are lie lies stand stands rest rests sit sits".split())
_HELD: Final = frozenset("standing lying sitting resting stored kept".split())


def end_of_load(words: Sequence[Word], at: int) -> int:
    """Return the end of words for all that is on or in what goes: ``with all that's on it``; 0 for others."""
    at += text_at(words, at) == ","
    joint = next((len(said) for said in _WITH if tuple(w.text for w in words[at : at + len(said)]) == said), 0)
    if not joint:
        return 0
    place = at + joint
    if text_at(words, place) == "its" and text_at(words, place + 1) in ("content", "load"):
        return place + 2
    what = text_at(words, place) == "what"
    if text_at(words, place) not in _ALL and not what:
        return 0
    contracted = what and words[place].raw == "what's"
    if what and text_at(words, place + 1) not in _RESTS and not contracted:
        return 0
    place += 1 + (text_at(words, place + 1) == "thing")
    contracted = contracted or (place < len(words) and words[place].raw in ("that's", "which's"))
    relative = text_at(words, place) in ("that", "which")
    place += relative
    if text_at(words, place) in _RESTS and (relative or text_at(words, place - 1) in ("whatever", "what")):
        place += 1
    elif relative and not contracted:
        return 0
    while text_at(words, place) in _HELD or text_at(words, place) in ("currently", "now", "still"):
        place += 1
    if text_at(words, place) in ("inside", "there") or (text_at(words, place), text_at(words, place + 1)) == (
        "on",
        "top",
    ):
        return place + 1 + (text_at(words, place) == "on")
    held = text_at(words, place) in ("on", "in") and text_at(words, place + 1) in ("it", "them", "there")
    return place + 2 if held else 0
