"""Read rooms by their numbers: "Units: 1 = perfumery, 2 = shoes" are two shops, "surgery 1-3" three rooms."""

from collections.abc import Set as AbstractSet
from dataclasses import replace

from mansion_language import Token

__all__ = ["numbered_units"]

_SHOPS = frozenset({"unit", "shop", "store", "stall", "kiosk", "boutique"})
_ROOMS = frozenset({"room", "space", "lot", "hall", "office", "studio", "box"})
_SEPARATORS = frozenset({",", ";", "and", "&"})
_ENDS = frozenset({".", "\n", "!", "?"})
_LONGEST_NAME = 4
_MOST = 99
"""Rooms of a series, at most."""


def numbered_units(tokens: list[Token], rooms: AbstractSet[str]) -> list[Token]:
    """Return the tokens of such lists with a noun for each entry, and without the numbers.

    Parameters
    ----------
    tokens : list of Token
    rooms : set of str
        What the names of rooms and buildings end with: such entries have a noun.
    """
    tokens = _series(tokens, rooms)
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        head = tokens[index].text if tokens[index].plural else ""
        colon = index + 1 if index + 1 < len(tokens) and tokens[index + 1].text == ":" else 0
        entries = _entries(tokens, colon + 1) if colon and head in _SHOPS | _ROOMS else []
        if len(entries) < 2:
            result.append(tokens[index])
            index += 1
            continue
        lead = result[-1] if result else None
        headed = lead is None or lead.text in _ENDS | {";", ":"}
        result += [] if headed else [tokens[colon]]
        for first, last in entries:
            result += [replace(tokens[first], spaced=True), *tokens[first + 1 : last]]
            if head in _SHOPS and tokens[last - 1].text not in rooms:
                named = tokens[last - 1]
                result[-1] = replace(named, plural=False)
                result.append(Token("word", "shop", named.end, named.end))
            result.append(Token("mark", ",", tokens[last - 1].end, tokens[last - 1].end))
        result.pop()
        index = entries[-1][1]
    return result


_NO_ROOMS = frozenset("floor level storey deck phase stage building block unit zone".split())


def _series(tokens: list[Token], rooms: AbstractSet[str]) -> list[Token]:
    """Read "surgery 1-3" and "exam rooms 1 to 4" as so many of them."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        noun = result[-1] if result else None
        kinds = [token.kind for token in tokens[index : index + 3]]
        ranged = len(kinds) == 3 and kinds[0] == kinds[2] == "number" and tokens[index + 1].text in ("–", "-", "to")
        closed = index + 3 >= len(tokens) or tokens[index + 3].text in _SEPARATORS | _ENDS | {")", "+"}
        named = noun is not None and noun.kind == "word" and noun.text in rooms - _NO_ROOMS
        counts = ranged and tokens[index].value == 1 < tokens[index + 2].value <= _MOST
        if noun is None or not (closed and named and counts):
            result.append(tokens[index])
            index += 1
            continue
        many = replace(tokens[index + 2], start=tokens[index].start)
        result[-1] = replace(noun, plural=True)
        result += [Token("mark", "(", many.start, many.start), many, Token("mark", ")", many.end, many.end)]
        index += 3
    return result


def _entries(tokens: list[Token], index: int) -> list[tuple[int, int]]:
    """Return where the names of "1 = perfumery, 2 = shoes" begin and end, from a token on."""
    found: list[tuple[int, int]] = []
    at = index
    while at + 2 < len(tokens) and tokens[at].kind == "number" and tokens[at + 1].text == "=":
        first = last = at + 2
        while last < len(tokens) and tokens[last].kind == "word" and tokens[last].text not in _SEPARATORS:
            last += 1
        if not first < last <= first + _LONGEST_NAME:
            break
        found.append((first, last))
        if last >= len(tokens) or tokens[last].text not in _SEPARATORS:
            break
        at = last + 1 + (last + 1 < len(tokens) and tokens[last + 1].text in ("and", "&"))
    return found
