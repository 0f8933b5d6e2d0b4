"""Read a floor that is all there is: "an office floor of 400 m2", "a hospital floor with 16 rooms"."""

from dataclasses import replace
from typing import Final

from mansion_language import Token
from mansion_planner.brief.counted_compounds import NAME_ENDS

__all__ = ["single_floors"]

_OPENERS: Final = frozenset({"a", "an", "one", "single", "entire", "whole", "the"})
_BEFORE: Final = frozenset("design build make create generate plan give me i we want need please us would like".split())
_FLOORS: Final = frozenset({"floor", "storey", "level"})
_AFTER: Final = frozenset({"", ".", ",", ":", "of", "with", "for", "in", "that", "where", "having", "\n"})
_STOPS: Final = _FLOORS | NAME_ENDS

_LONGEST: Final = 4


def single_floors(tokens: list[Token], heads: frozenset[str]) -> list[Token]:
    """Return the tokens with a floor of a building as a building of one storey, where the brief opens with it.

    Parameters
    ----------
    heads : frozenset of str
        Words that end the names of kinds of buildings.
    """
    begin = 0
    while begin < len(tokens) and tokens[begin].text in _BEFORE:
        begin += 1
    first = begin
    while first < len(tokens) and tokens[first].text in _OPENERS:
        first += 1
    end = first
    while end < min(first + _LONGEST, len(tokens)) and tokens[end].kind == "word" and tokens[end].text not in _STOPS:
        end += 1
    if end >= len(tokens) or tokens[end].text not in _FLOORS:
        return tokens
    after = tokens[end + 1].text if end + 1 < len(tokens) else ""
    if first == begin or end <= first or tokens[end].plural or tokens[end - 1].text not in heads or after not in _AFTER:
        return tokens
    floor = tokens[end]
    one = Token("number", "one", floor.start, floor.end, value=1.0)
    storey = replace(floor, text="storey", spaced=False)
    return [*tokens[:first], one, storey, *tokens[first:end], *tokens[end + 1 :]]
