"""Whose something is: the owner that a pronoun stands for."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.words import FUNCTION_WORDS, Word

__all__ = ["owners_named"]

_OPENING: Final = frozenset("door lid doors".split())


def owners_named(words: Sequence[Word], lexicon: Lexicon) -> list[Word]:
    """Return words with the owner for a pronoun: the mayor's for ``his office``, the umbrella's for ``its stand``."""
    out: list[Word] = []
    for at, word in enumerate(words):
        following = words[at + 1].text if at + 1 < len(words) else ""
        if word.text in _OPENING and out and out[-1].text in ("its", "their"):
            it = "it" if out[-1].text == "its" else "them"
            out[-1] = Word(it, it, "word", out[-1].start, word.end)  # "leave its door open"
            continue
        if word.text in ("its", "their") and following in _OPENING:
            out.append(word)
            continue
        if word.text in ("his", "her", "their", "its") and following:
            owner = next((w for w in reversed(out) if _owns(w, following, lexicon)), None)
            owner = None if out and out[-1].text == "and" and word.text in ("its", "their") else owner
            if owner is None and word.text == "its":
                word = Word("the", word.raw, "word", word.start, word.end)
            if owner is not None:
                out.append(Word("the", "the", "word", word.start, word.start))
                word = Word(owner.text, owner.raw, "word", word.start, word.end)
        out.append(word)
    return out


def _owns(owner: Word, noun: str, lexicon: Lexicon) -> bool:
    """Whether two words make the name of a room of the building, or of an object that no room owns."""
    if owner.kind != "word" or owner.text in FUNCTION_WORDS:
        return False
    pair = (owner.text, noun)
    thing = lexicon.is_object(pair) and lexicon.is_here(" ".join(pair)) and not lexicon.is_own_room((owner.text,))
    return thing or lexicon.is_own_room(pair)
