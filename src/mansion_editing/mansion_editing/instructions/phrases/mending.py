"""Mistakes that only the words around them, or the building's names, tell: ``dinning room``, ``coffeetable``."""

from collections.abc import Iterator, Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import VERB_WORDS
from mansion_editing.instructions.phrases.words import FUNCTION_WORDS, VAGUE, Word

__all__ = ["mended"]

_SHORT: Final = 4
"""Letters of words that are too short for any but the plainest mistake; still shorter ones may be people's names."""
_TELLING: Final = 6
"""Least letters of an English word that may stand for another one in a name."""
_LEAST_PART: Final = 3


def mended(words: Sequence[Word], lexicon: Lexicon) -> list[Word]:
    """Return words with what only fits a name of the building or the catalogue put right."""
    out: list[Word] = []
    for at, word in enumerate(words):
        if word.kind != "word" or word.text in FUNCTION_WORDS | VAGUE | VERB_WORDS:
            out.append(word)
            continue
        following = words[at + 1] if at + 1 < len(words) else None
        out += _mended(word, following, lexicon)
    return out


def _mended(word: Word, following: Word | None, lexicon: Lexicon) -> list[Word]:
    speller = lexicon.speller
    known = word.text in speller.words
    name = word.capital and len(word.text) < _SHORT
    if _LEAST_PART <= len(word.text) <= _SHORT and not (known or name) and word.text not in lexicon.kept:
        return [replace(word, text=speller.completed(word.text))]
    if len(word.text) < _TELLING or known:
        return [word]
    if following is not None and not _is_name((word.text, following.text), lexicon):
        near = speller.nearest(word.text)
        if near != word.text and _is_name((near, following.text), lexicon):
            return [replace(word, text=near)]
    parts = next((pair for pair in _halves(word) if _is_name((pair[0].text, pair[1].text), lexicon)), None)
    return [word] if parts is None or word.text in lexicon.kept else list(parts)


def _is_name(words: tuple[str, str], lexicon: Lexicon) -> bool:
    return lexicon.is_room(words) or lexicon.is_called(words)


def _halves(word: Word) -> Iterator[tuple[Word, Word]]:
    for at in range(_LEAST_PART, len(word.text) - _LEAST_PART + 1):
        middle = word.start + at
        first = replace(word, text=word.text[:at], raw=word.raw[:at], end=middle, plural=False, genitive=False)
        yield first, replace(word, text=word.text[at:], raw=word.raw[at:], start=middle)
