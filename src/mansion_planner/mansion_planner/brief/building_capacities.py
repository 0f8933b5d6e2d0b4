"""Tell what buildings hold: garages cars to park or to repair, kindergartens groups of children with rooms."""

import itertools
from dataclasses import replace

from mansion_language import Token

__all__ = ["children_groups", "garages"]

_REPAIRS = frozenset(
    "repair repairs repairing repaired mechanic mechanics workshop servicing service tyre tire bodywork".split()
)
_PARKED = frozenset({"car", "vehicle", "truck", "bus", "van", "motorbike", "motorcycle", "space", "bay", "place"})
_HOLDING_CARS = frozenset({"for", "with", "of"})
_LIFTS = frozenset({"lift", "hoist", "ramp"})
_BEFORE = frozenset(
    {"a", "an", "the", "our", "new", "small", "large", "big", "public", "car", "i", "we", "need", "want"}
)


def garages(tokens: list[Token], buildings: frozenset[str]) -> list[Token]:
    """Return the tokens with such a garage as a parking or repair garage.

    Parameters
    ----------
    buildings : frozenset of str
        Words that end the names of kinds of buildings; where the brief has one beside the garage, that is the building.
    """
    texts = [token.text for token in tokens]
    first = next((at for at, text in enumerate(texts) if text == "garage"), -1)
    if first < 0 or not set(texts[:first]) <= _BEFORE or texts.count("garage") > 1:
        return tokens
    if any(text in buildings - _REPAIRS for text in texts[:first] + texts[first + 1 :]):
        return tokens
    repaired = not _REPAIRS.isdisjoint(texts)
    after = texts[first + 1 : first + 6]
    parked = after[:1] and after[0] in _HOLDING_CARS and not _PARKED.isdisjoint(after)
    if not (repaired or parked):
        return tokens
    kind = "repair" if repaired else "parking"
    result: list[Token] = []
    for at, token in enumerate(tokens):
        if at == first:
            result.append(replace(token, text=kind, plural=False, end=token.start))
        elif repaired and token.text in _LIFTS and token.plural and at and tokens[at - 1].kind == "number":
            result.append(replace(token, text="car", plural=False, end=token.start))
        result.append(token)
    return result


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
