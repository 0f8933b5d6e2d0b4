"""Furniture named with its room before it: ``on the living room dresser`` as on the dresser in the living room."""

import re
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_language.inflection import singular

__all__ = ["with_room_after"]

_OWNED: Final = re.compile(
    r"\b(?P<on>on|in|off|from|under|beside|behind|out of|next to) the "
    r"(?P<words>(?:(?!(?:the|an?|our|my|all|both|and)\b)[a-z]+(?:'s)? ){1,4}?[a-z]+)"
    r"(?= (?:up |down |over |across |back )*(?:to|into|onto|go|goes|belongs?|must|should|has to|have to|can)\b)",
    re.IGNORECASE,
)


def with_room_after(text: str, lexicon: Lexicon) -> str:
    """Return ``on the dresser in the hall go to ...`` for ``on the hall dresser go to ...``.

    Only before words that say where something goes, with which the room would else be joined.
    """

    def parted(match: re.Match[str]) -> str:
        words = match["words"].split()
        for count in range(len(words) - 1, 0, -1):
            room = [word.removesuffix("'s") for word in words[:count]]
            holder = [singular(word.lower()) for word in words[count:]]
            name = tuple(singular(word.lower()) for word in room)
            if lexicon.is_own_room(name) and lexicon.is_object(tuple(holder)):
                return f"{match['on']} the {' '.join(words[count:])} in the {' '.join(room)}"
        return match.group()

    return _OWNED.sub(parted, text)
