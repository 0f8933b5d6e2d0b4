"""Bring exceptions among storeys into one form: "every floor has six rooms, except the top floor, which has a bar".

The excepted storey stands behind the storeys that it is taken from, and what is said of it in a sentence of its own.
"""

from collections.abc import Set as AbstractSet
from dataclasses import replace
from typing import NamedTuple

from mansion_language import Token

__all__ = ["excepted_storeys"]

_EXCEPT = (("except", "for"), ("except", "on"), ("except",), ("apart", "from"), ("but", "not"), ("other", "than"))
_PLACES = frozenset({"ground", "top", "first", "last", "uppermost"})
_WHERE = frozenset({"where", "which", "that"})
_VERBS = frozenset({"there", "is", "are", "has", "have", "instead", "you", "we", "find", "only", "hold", "contain"})
_EVERY = frozenset({"each", "every", "all"})
_ENDS = frozenset({".", ";", "\n", "!", "?"})


class _Exception(NamedTuple):
    """Tokens of an exception: its first one, that of the storey, the end of the storey, where what it has begins."""

    first: int
    place: int
    end: int
    listed: int


def excepted_storeys(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with each exception behind the storeys that it is taken from.

    Where a clause tells what the excepted storey has, it becomes a sentence headed by that storey.
    """
    for index in range(len(tokens)):
        found = _exception(tokens, index, floor_words)
        every = 0 if found is None else _taken_from(tokens, index, floor_words)
        if found is None or not every or (found.listed == found.end and every == index):
            continue
        words = replace(tokens[index], text="except"), *tokens[found.place : found.end]
        comma = index - (tokens[index - 1].text == "," and every < index)
        before = [*tokens[:every], *words, *tokens[every:comma]]
        if found.listed == found.end:
            return [*before, *excepted_storeys(tokens[found.end :], floor_words)]
        mark, place = tokens[found.end], tokens[found.place : found.end]
        place += [replace(place[0], text="floor", spaced=True)] * (len(place) == 1)
        stop, colon = (replace(mark, kind="mark", text=text, plural=False) for text in (".", ":"))
        return [*before, stop, *place, colon, *excepted_storeys(tokens[found.listed :], floor_words)]
    return tokens


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _exception(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> _Exception | None:
    """Return the storey that is excepted at a token, and the clause that tells what it has."""
    words = next((w for w in _EXCEPT if tuple(t.text for t in tokens[index : index + len(w)]) == w), ())
    place = index + len(words)
    place += _text(tokens, place) == "the"
    if not words or _text(tokens, place) not in _PLACES:
        return None
    end = place + 1 + (_text(tokens, place + 1) in floor_words | {"one"})
    clause = end + (_text(tokens, end) == ",")
    if _text(tokens, clause) not in _WHERE:
        return _Exception(index, place, end, end)
    listed = clause + 1
    while _text(tokens, listed) in _VERBS:
        listed += 1
    return _Exception(index, place, end, listed)


def _taken_from(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> int:
    """Return where "every floor" ends in the sentence of an exception; 0 where it does not say so."""
    at = index - 1
    while at > 0 and tokens[at].text not in _ENDS:
        if tokens[at].text in floor_words and _text(tokens, at - 1) in _EVERY:
            return at + 1
        at -= 1
    return 0
