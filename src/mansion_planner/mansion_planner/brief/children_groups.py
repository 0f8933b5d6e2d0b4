"""Give each group of a kindergarten its room: "a kindergarten for 4 groups", "each group has a room of 55 m2"."""

import itertools
from dataclasses import replace

from mansion_language import Token

__all__ = ["children_groups"]

_HOUSES = frozenset({"kindergarten", "nursery", "daycare", "creche", "preschool", "kita"})
_HOLDING = frozenset({"for", "of", "with", "has", "have"})
_OWN = frozenset({"has", "have", "get", "need", "with", "needs", "gets", "a", "an", "its", "own", "one"})


def children_groups(tokens: list[Token]) -> list[Token]:
    """Return the tokens with groups as group rooms, where the brief does not name these itself."""
    texts = [token.text for token in tokens]
    named = ("group", "room") in itertools.pairwise(texts) or _tells_their_rooms(texts)
    if _HOUSES.isdisjoint(texts) or named:
        return tokens
    result: list[Token] = []
    index, counted = 0, False
    while index < len(tokens):
        token = tokens[index]
        following = texts[index + 1] if index + 1 < len(tokens) else ""
        if token.kind == "number" and following == "group" and texts[index - 1] in _HOLDING and not counted:
            counted = True
            if result and result[-1].text in ("for", "of"):
                result[-1] = replace(result[-1], text="with")
            result += [token, replace(tokens[index + 1], plural=False), _room(tokens[index + 1], plural=True)]
            index += 2
            continue
        own = _own_room(texts, index) if counted and token.text in ("each", "every") and following == "group" else 0
        if own:
            result += [token, tokens[index + 1], _room(tokens[own], plural=False)]
            index = own + 1
            continue
        result.append(token)
        index += 1
    return result


def _tells_their_rooms(texts: list[str]) -> bool:
    """Whether the brief tells what room each group plays in: "each group has a playroom and a nap room"."""
    return any(
        texts[at] in ("each", "every") and texts[at + 1] == "group" and not _PLAYING.isdisjoint(texts[at + 2 : at + 7])
        for at in range(len(texts) - 2)
    )


_PLAYING = frozenset({"playroom", "play", "activity"})


def _room(token: Token, *, plural: bool) -> Token:
    return Token("word", "room", token.end, token.end, plural=plural)


def _own_room(texts: list[str], index: int) -> int:
    """Return the token of the room in "each group has its own room"; 0 where there is none."""
    at = index + 2
    while at < len(texts) and texts[at] in _OWN:
        at += 1
    return at if at > index + 2 and texts[at : at + 1] in (["room"], ["classroom"]) else 0
