"""Rooms that are called after a person, named with the person's title: ``Dr. Lee's room`` for the room of Lee."""

import re
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon

__all__ = ["without_titles"]

_TITLED: Final = re.compile(
    r"\b(?:(?:Mr|Mrs|Ms|Mx|Dr|Prof)\b\.?|Miss|Doctor|Professor) (?:(?:Dr|Prof)\.? )?"
    r"(?P<name>[A-Z][\w-]+)(?='s? (?P<room>[a-z]+)\b)"
)


def without_titles(text: str, lexicon: Lexicon) -> str:
    """Return a text without the titles of persons after whom rooms of the building are called."""

    def plain(match: re.Match[str]) -> str:
        name, room = match["name"].lower(), match["room"]
        named = any(lexicon.is_own_room((name, noun)) for noun in (room, "room"))
        return match["name"] if named else match.group()

    return _TITLED.sub(plain, text)
