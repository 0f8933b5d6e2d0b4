"""Marks of notes: arrows, ``mug from the sink -> shelf``, and colons before lists, ``on each I need: lamp, mug``."""

import re
from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.words import DETERMINERS, STATE_WORDS
from mansion_editing.instructions.syntax.tagged_words import TaggedWord
from mansion_language.colours import COLOUR_WORDS

__all__ = ["without_arrows", "without_list_colons"]

_NOTE: Final = re.compile(
    r"(?:^|(?<=[.;!?,\n] ))(?P<thing>[^.;!?,:\n]+?)(?:(?: from| off|:) (?P<source>[^.;!?,\n]+?))? (?:->|=>|→|-->) "
    r"(?P<goal>[^.;!?\n]+?)(?=[.;!?\n]|, [^,]*(?:->|=>|→)|$)",
    re.IGNORECASE,
)
_PLACING: Final = (
    "on top of",
    "next to",
    "in front of",
    "on",
    "in",
    "under",
    "beside",
    "behind",
    "by",
    "near",
    "inside",
)


def without_arrows(text: str) -> str:
    """Return a text in which each note with an arrow is an order.

    Examples
    --------
    >>> without_arrows("wine bottle from pantry fridge -> on top of china cabinet")
    'put the wine bottle from the pantry fridge on top of the china cabinet'
    >>> without_arrows("lamp -> off")
    'lamp -> off'
    """
    return _NOTE.sub(_order, text)


def _order(note: re.Match[str]) -> str:
    goal, thing, source = note["goal"], note["thing"], note["source"]
    first, *more = goal.lower().split()
    state = first in STATE_WORDS and not more
    if state or first in COLOUR_WORDS or any(part[:1].isdigit() for part in (thing, goal)):
        return note.group()
    placing = next((said for said in _PLACING if goal.lower().startswith(f"{said} ")), "")
    where = f"{placing} {_known(goal[len(placing) :].strip())}" if placing else f"to {_known(goal)}"
    start = f" from {_known(source)}" if source else ""
    return f"{'put' if placing else 'move'} {_known(thing)}{start} {where}"


def _known(name: str) -> str:
    """Return a name with an article."""
    said = name.split()
    bare = said[0].lower() not in DETERMINERS and not said[0][0].isdigit()
    return f"the {name[0].lower()}{name[1:]}" if bare else name


_TAKING_LISTS: Final = frozenset("need want like have get require add put bring remove take add".split())


def without_list_colons(words: Sequence[TaggedWord]) -> list[TaggedWord]:
    """Return words without the colons that part a verb from its objects."""
    return [
        word
        for at, word in enumerate(words)
        if not (word.text == ":" and at and _takes_list(words, at - 1) and at + 1 < len(words))
    ]


def _takes_list(words: Sequence[TaggedWord], at: int) -> bool:
    return words[at].verb in _TAKING_LISTS or (words[at].tag == "have" and words[at].text != "having")
