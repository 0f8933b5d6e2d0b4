"""The verb at a place in an instruction, told from nouns that are spelt alike."""

from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.verb_words import BY_WORDS, GERUNDS, LONGEST, Deed
from mansion_editing.instructions.phrases.words import DETERMINERS, PREPOSITIONS, PRONOUNS, Word

__all__ = ["verb_at"]

_AFTER_A_VERB: Final = (
    DETERMINERS
    | PRONOUNS
    | frozenset(
        "me us him her more two three four five six seven eight nine ten twelve a everything everyone nothing up down "
        "out away off on in over back rid sure there exactly".split()
    )
)


_PARTICLES: Final = frozenset(["on", "off", "up", "down", "out", "over", "away"])
"""They belong to a verb as often as they begin a place."""


_BEGIN_NAMES: Final = frozenset("hand power name flip swivel filing".split())
"""Verbs that are the first words of names and that nobody gives an order with without an article."""


def verb_at(words: Sequence[Word], at: int, lexicon: Lexicon) -> tuple[Deed, int] | None:
    """Return what the verb at a place asks for, and the place after it; None where there is no verb.

    Notes
    -----
    A word that is a noun as well ("light", "plant", "book") is a verb where an article, a number or a pronoun follows.
    """
    for length in range(LONGEST, 0, -1):
        span = tuple(w.text for w in words[at : at + length])
        if len(span) < length:
            continue
        if span not in BY_WORDS:
            span = (GERUNDS.get(span[0], span[0]), *span[1:])
        if span not in BY_WORDS:
            continue
        if length == 1 and _is_noun_here(words, at, lexicon):
            return None
        return BY_WORDS[span], at + length
    return None


def _is_noun_here(words: Sequence[Word], at: int, lexicon: Lexicon) -> bool:
    word = words[at]
    if word.plural or word.genitive:
        return True
    following = words[at + 1] if at + 1 < len(words) else None
    if following is not None and word.text in _BEGIN_NAMES and lexicon.is_called((word.text, following.text)):
        return True
    if not (lexicon.is_object((word.text,)) or lexicon.is_own_room((word.text,)) or word.text in ("light", "open")):
        return False
    if following is None:
        return True
    after = words[at + 2] if at + 2 < len(words) else None
    beside = following.text in PREPOSITIONS - _PARTICLES
    if beside and after is not None and after.text in DETERMINERS:
        return True
    if following.kind in ("number", "ordinal") or following.text in _AFTER_A_VERB:
        return False
    if following.text in PREPOSITIONS or following.kind == "mark":
        return True
    pair = (word.text, following.text)
    return lexicon.is_object(pair) or lexicon.is_own_room(pair)
