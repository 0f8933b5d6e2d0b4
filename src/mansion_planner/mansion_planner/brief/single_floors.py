"""Read what is all of a building: "an office floor of 400 m2", a ground-floor flat, "a cafe in a ground-floor unit"."""

from dataclasses import replace
from typing import Final

from mansion_language import Token
from mansion_planner.brief.counted_compounds import NAME_ENDS

__all__ = ["single_flats", "single_floors", "single_units"]

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


_FLATS: Final = frozenset({"flat", "apartment", "maisonette", "condo", "studio", "bedsit"})
_WHERE: Final = frozenset(
    {"ground", "top", "upper", "lower", "basement", "garden", "first", "second", "third", "fourth"}
)

_OTHERS: Final = _FLATS | frozenset({"shop", "above", "below", "beneath", "over", "under", "house", "building"})
"""What else is spoken of where a flat is one of several parts."""


def single_flats(tokens: list[Token]) -> list[Token]:
    """Return the tokens without the storey that a flat lies on, where the brief opens with one flat and that is all.

    Nothing is said of the building around it, which is not built.
    """
    begin = 0
    while begin < len(tokens) and tokens[begin].text in _BEFORE:
        begin += 1
    if begin + 2 >= len(tokens):
        return tokens
    led = tokens[begin].text in ("a", "an", "one", "my", "our")
    at = begin + led
    while at < len(tokens) and tokens[at].kind == "word" and tokens[at].text not in _WHERE | _FLATS | NAME_ENDS:
        at += 1  # "a small ground-floor flat"
    end = at
    while end < len(tokens) and (tokens[end].text in _WHERE | _FLOORS or tokens[end].kind in ("ordinal", "level")):
        end += 1
    single = end < len(tokens) and tokens[end].text in _FLATS and not tokens[end].plural
    alone = _OTHERS.isdisjoint(token.text for token in tokens[end + 1 :])
    if not single or not alone:
        return tokens
    if end > at:
        return [*tokens[:at], *tokens[end:]] if led else tokens
    behind = _storey_behind(tokens, end + 1)
    other_storeys = any(token.text in _ELSEWHERE or token.kind == "level" for token in tokens[behind:])
    return [*tokens[: end + 1], *tokens[behind:]] if behind and not other_storeys else tokens


def _storey_behind(tokens: list[Token], index: int) -> int:
    """Return where the storey of a flat ends: "flat on the third floor", "flat, third floor walk-up"; or 0."""
    at = index
    while at < len(tokens) and tokens[at].text in (",", "on", "at", "in", "the", "(") and at - index < 3:
        at += 1
    placed = at > index and at + 1 < len(tokens) and (tokens[at].kind == "ordinal" or tokens[at].text in _WHERE)
    if not placed or tokens[at + 1].text not in _FLOORS or tokens[at + 1].plural:
        return 0
    end = at + 2
    end += 2 * ([token.text for token in tokens[end : end + 2]] == ["walk", "up"])
    end += end < len(tokens) and tokens[end].text == ")"
    return end if end == len(tokens) or tokens[end].text in (",", ".", ":", ";", "\n", "with") else 0


_UNITS: Final = frozenset({"unit", "premises"})
_ELSEWHERE: Final = _FLOORS | frozenset(
    {"upstairs", "upstair", "basement", "cellar", "above", "below", "mezzanine", "flat", "apartment", "house"}
)
"""Words of storeys or homes beside a unit, which is then one part of several."""


def single_units(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the part of a building that a business lies in as one storey: "a ground-floor unit"."""
    for at in range(1, len(tokens) - 2):
        floor, unit = tokens[at + 1], tokens[at + 2]
        if tokens[at].text not in ("ground", "street") or floor.text not in _FLOORS or unit.text not in _UNITS:
            continue
        others = {token.text for token in (*tokens[:at], *tokens[at + 3 :])}
        if (unit.plural and unit.text == "unit") or not others.isdisjoint(_ELSEWHERE):
            return tokens
        first = at - (tokens[at - 1].text in ("a", "an", "one", "the", "our", "my"))
        one = Token("number", "one", tokens[at].start, tokens[at].end, value=1.0)
        return [*tokens[:first], one, replace(floor, text="storey", end=unit.end, spaced=False), *tokens[at + 3 :]]
    return tokens
