"""Rooms that are only named after an order: ``the high chair can go, kitchen``."""

import re
from typing import Final

from mansion_editing.instructions.phrases.lexicon import Lexicon
from mansion_language.inflection import singular

__all__ = ["with_room_first"]

_TRAILING: Final = re.compile(
    r"^(?P<order>[^.!?;:]+?)(?:,| -|[.!]| \() ?(?P<room>(?:(?!and\b|or\b)[A-Za-z'-]+ ){0,3}[\w'-]+)"
    r"(?P<storey>,? (?:on )?(?:the )?(?:\w+ floor|upstairs|downstairs))?(?:,? please)?\)?[.!]?\s*$"
)
_HEADING: Final = re.compile(
    r"^(?P<room>(?:the )?(?:[a-z'-]+ ){0,3}[\w'-]+), (?:on )?(?:the )?(?P<storey>(?:ground|first|second|third|fourth|"
    r"fifth|sixth|top|upper|lower) floor)[.:] ",
    re.IGNORECASE,
)
"""A room and its storey, before what is to be done there."""
_ARTICLE: Final = re.compile(r"^(?:the|our|my) ", re.IGNORECASE)


def with_room_first(text: str, lexicon: Lexicon) -> str:
    """Return ``in the kitchen, the high chair can go`` for ``the high chair can go, kitchen``.

    Only where the order names no room of its own.
    """
    heading = _HEADING.match(text)
    if heading is not None:
        room = tuple(singular(word.lower()) for word in _ARTICLE.sub("", heading["room"]).split())
        where = f"{heading['room']} on the {heading['storey']}: "
        return where + text[heading.end() :] if lexicon.is_own_room(room) else text
    match = _TRAILING.match(text)
    if match is None:
        return text
    name = _ARTICLE.sub("", match["room"].strip())
    words = tuple(singular(word.lower()) for word in name.split())
    if not lexicon.is_own_room(words) or lexicon.is_called(words) or _names_room(match["order"], lexicon):
        return text
    storey = (match["storey"] or "").lstrip(", ")
    storey = storey if not storey or storey.startswith(("on ", "upstairs", "downstairs")) else f"on {storey}"
    numbered = words[-1].isdecimal() or "'" in name
    where = f"in {name if numbered else 'the ' + name} {storey}".strip()
    return f"{where}, {match['order'][:1].lower()}{match['order'][1:]}."


def _names_room(text: str, lexicon: Lexicon) -> bool:
    """Whether a text names a room of the building."""
    words = [singular(word) for word in re.findall(r"[\w'-]+", text.lower())]
    spans = (tuple(words[at : at + count]) for count in (1, 2, 3) for at in range(len(words) - count + 1))
    return any(lexicon.is_own_room(span) for span in spans)
