"""Put what a compound counts behind its building: "a 20-room boutique hotel" is a boutique hotel with 20 rooms."""

from dataclasses import replace
from typing import Final

from mansion_language import Token

__all__ = ["BUILDING_HEADS", "NAME_ENDS", "counted_compounds"]

_HELD: Final = frozenset(
    """
    room classroom bay screen lane chair court unit shop key suite cabin cell stall seat pump platform gate studio
    flat apartment berth table desk auditorium ward stage ring booth kennel
    """.split()
)
"""What buildings have so many of."""

_SERVED: Final = frozenset("pupil student child kid place patient guest car vehicle resident employee worker".split())
"""For how many, or how much, they are."""

_MEANT: Final = {"key": "room", "place": "child"}
"""What trades call otherwise: a hotel of 60 keys, a nursery of 40 places."""

BUILDING_HEADS: Final = frozenset(
    """
    hotel theatre theater restaurant cinema garage alley station office center centre library cafe salon dormitory gym
    pharmacy nursery park school
    """.split()
)
"""Heads of names of buildings that are heads of names of rooms as well."""

_HOMES: Final = frozenset("flat apartment house home condo bungalow cottage villa studio maisonette duplex".split())
"""Whose rooms are counted in ways of their own; a guest house is none."""

NAME_ENDS: Final = frozenset("with and or of for in on at by near from to without plus that which is has where".split())

_LONGEST: Final = 5


def counted_compounds(tokens: list[Token], heads: frozenset[str]) -> list[Token]:
    """Return the tokens with what such compounds count after the names of their buildings.

    Parameters
    ----------
    heads : frozenset of str
        Words that end the names of kinds of buildings, and of nothing else.
    """
    result: list[Token] = []
    at = 0
    while at < len(tokens):
        end = _end(tokens, at, heads | BUILDING_HEADS)
        if end:
            number, noun = tokens[at], tokens[at + 1]
            name, rest = tokens[at + 2 : end], tokens[end : end + 1]
            start, stop = number.start, noun.end
            text = _MEANT.get(noun.text, noun.text)
            counted = replace(noun, text=text, plural=True, spaced=True, start=start, end=stop)
            joint = Token("word", "for" if noun.text in _SERVED else "with", start, stop)
            result += [*name, joint, replace(number, start=start, end=stop), counted]
            if rest and rest[0].text == "with":
                result.append(replace(rest[0], text="and"))
                end += 1
            at = end
        else:
            result.append(tokens[at])
            at += 1
    return result


def _end(tokens: list[Token], at: int, heads: frozenset[str]) -> int:
    """Return where the compound ends whose number is at a token, 0 where none begins there."""
    if at + 2 >= len(tokens) or tokens[at].kind != "number" or tokens[at].soft or tokens[at].value < 2:
        return 0
    noun = tokens[at + 1]
    if noun.plural or noun.text not in _HELD | _SERVED or (noun.text, tokens[at + 2].text) == ("car", "garage"):
        return 0  # "a two-car garage" is a room
    end = at + 2
    while end < len(tokens) and tokens[end].kind == "word" and tokens[end].text not in NAME_ENDS:
        end += 1
    last = tokens[end - 1]
    home = last.text in _HOMES and tokens[end - 2].text != "guest"
    named = 0 < end - at - 2 <= _LONGEST and last.text in heads | {"house"} and not last.plural and not home
    return end if named else 0
