"""Parts by which a thing opens: the door of the fridge is open when the fridge is, and the lid of the bin alike."""

from collections.abc import Sequence
from dataclasses import replace
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.words import DETERMINERS, Word, text_at

__all__ = ["opened_as_whole"]

_LIDS: Final = frozenset("door lid".split())
_OPENING: Final = frozenset("open close shut leave keep".split())
"""Verbs of what a door or a lid shall be."""

_STATES: Final = frozenset("open closed shut ajar".split())

_LIFTED: Final = {"lift": "open", "raise": "open", "lower": "close"}
"""Verbs of what a lid alone is opened and closed by."""

_OF_ROOMS: Final = frozenset("to between from of into for behind in on at".split())
"""Words that tell which of a room's doors is meant."""

_LONGEST: Final = 5
"""Words of a name with what stands before it."""


def opened_as_whole(words: Sequence[Word], before: Sequence[Word], lexicon: Lexicon) -> list[Word]:
    """Return words with the thing that opens for its door or lid.

    ``The lids of both bins`` are both bins; ``shut the door`` means ``it`` where something that opens was named before.

    Parameters
    ----------
    before : sequence of Word
        Those of the sentence before.
    """
    words = [_opened(words, at) for at in range(len(words))]
    out: list[Word] = []
    at = 0
    while at < len(words):
        word = words[at]
        lid = text_at(words, at + 1) in _LIDS and word.text in ("the", "its", "their")
        if lid and text_at(words, at + 2) == "of" and _opens(words, at + 3, lexicon) and not _room(words, at, lexicon):
            at += 3
            continue
        headed = bool(out) and out[-1].text == ":" and word.text in _LIDS and text_at(words, at + 1) in _STATES
        if headed and _names_what_opens(out, lexicon):
            at += 1
            continue  # "wardrobe in the bedroom: doors open"
        verb = out[-1].text if out else ""
        alone = text_at(words, at + 2) not in _OF_ROOMS
        if lid and alone and word.text == "the" and verb in _OPENING and _names_what_opens([*before, *out], lexicon):
            out.append(replace(word, text="it", raw=words[at + 1].raw, end=words[at + 1].end))
            at += 2
            continue
        out.append(word)
        at += 1
    return out


def _room(words: Sequence[Word], at: int, lexicon: Lexicon) -> bool:
    """Whether ``the door of`` at a place is followed by the name of a room, whose door it is."""
    place = at + 3
    while text_at(words, place) in DETERMINERS:
        place += 1
    texts = [word.text for word in words[place : place + _LONGEST]]
    named = (tuple(texts[:length]) for length in range(1, len(texts) + 1))
    return text_at(words, at + 1) == "door" and any(lexicon.is_own_room(name) for name in named)


def _opened(words: Sequence[Word], at: int) -> Word:
    """Return ``open`` for the verb of ``lift the toilet lid``, any other word as it is."""
    verb = _LIFTED.get(words[at].raw)
    lid = next((k for k in range(at + 1, min(at + _LONGEST, len(words))) if words[k].text == "lid"), 0)
    between = words[at + 1 : lid] if lid else []
    plain = bool(between) and between[0].text in DETERMINERS and all(word.kind == "word" for word in between)
    away = text_at(words, lid + 1) in ("off", "from", "onto", "out", "to")
    return replace(words[at], text=verb) if verb is not None and plain and not away else words[at]


def _opens(words: Sequence[Word], at: int, lexicon: Lexicon) -> bool:
    """Whether a phrase at a place names what opens."""
    while text_at(words, at) in DETERMINERS or (at < len(words) and words[at].kind == "number"):
        at += 1
    texts = [word.text for word in words[at : at + _LONGEST]]
    return any(
        lexicon.takes_state(tuple(texts[first:last]), "open")
        for first in range(len(texts))
        for last in range(first + 1, min(first + 3, len(texts)) + 1)
        if "of" not in texts[:last]
    )


def _names_what_opens(words: Sequence[Word], lexicon: Lexicon) -> bool:
    """Whether words name something that opens."""
    pairs = ((words[k].text, *([words[k + 1].text] if k + 1 < len(words) else [])) for k in range(len(words)))
    return any(lexicon.takes_state(span, "open") for pair in pairs for span in (pair, pair[:1]) if span)
