"""The room that a sentence which asks for nothing is about, and which the next request may be about too."""

from collections.abc import Sequence

import msgspec

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_editing.instructions.phrases.noun_phrases import noun_phrase
from mansion_editing.instructions.phrases.words import Word
from mansion_editing.instructions.statements import Mention, Rooms

__all__ = ["about_its_room"]


def about_its_room(told: Mention, words: Sequence[Word], lexicon: Lexicon, floors: Sequence[int]) -> Mention:
    """Return what is only told with the one room of the building that its words name, if they name just one.

    Parameters
    ----------
    words : sequence of Word
        Those of its quote.
    """
    if told.rooms is not None:
        return told
    named: list[Rooms] = []
    at = 0
    while at < len(words):
        phrase = noun_phrase(words, at, lexicon, floors)
        if phrase is None or phrase.end <= at:
            at += 1
            continue
        noun = phrase.noun
        if (
            noun.kind == "room"
            and not noun.unknown
            and lexicon.is_own_room((*noun.words, *filter(None, [noun.number])))
        ):
            named.append(phrase.rooms())
        at = phrase.end
    one = named[0] if len({msgspec.json.encode(rooms) for rooms in named}) == 1 else None
    return told if one is None or one.every or one.number > 1 else msgspec.structs.replace(told, rooms=one)
