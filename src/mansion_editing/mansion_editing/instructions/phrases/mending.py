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
    words = _with_parts_joined(words, lexicon)
    out: list[Word] = []
    for at, word in enumerate(words):
        if word.kind != "word" or word.text in FUNCTION_WORDS | VAGUE | VERB_WORDS:
            out.append(word)
            continue
        following = words[at + 1] if at + 1 < len(words) else None
        out += _mended(word, following, lexicon)
    return out


def _with_parts_joined(words: Sequence[Word], lexicon: Lexicon) -> list[Word]:
    """Return ``fireplace`` for ``fire place``, where only the whole names a thing or a room here."""
    out: list[Word] = []
    for word in words:
        last = out[-1] if out else None
        if last is not None and _is_name_in_parts(last, word, lexicon):
            out[-1] = replace(word, text=last.text + word.text, raw=last.raw + word.raw, start=last.start)
            continue
        out.append(word)
    return out


def _is_name_in_parts(first: Word, second: Word, lexicon: Lexicon) -> bool:
    plain = first.kind == second.kind == "word" and not (first.plural or first.genitive)
    if not plain or min(len(first.text), len(second.text)) < _LEAST_PART or first.text in FUNCTION_WORDS | VAGUE:
        return False
    parts, whole = (first.text, second.text), (first.text + second.text,)
    return not _is_name(parts, lexicon) and (lexicon.is_called(whole) or lexicon.is_own_room(whole))


def _mended(word: Word, following: Word | None, lexicon: Lexicon) -> list[Word]:
    speller = lexicon.speller
    if following is not None and len(word.text) >= _SHORT:
        full = lexicon.written_in_full(word.text, following.text)
        if full != word.text:
            return [replace(word, text=full)]
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
