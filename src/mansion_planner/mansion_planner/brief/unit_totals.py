"""Leave out what only sums up flats or names groups: "six units: two flats a floor", "is one living group:"."""

import itertools
from collections.abc import Set as AbstractSet
from dataclasses import replace

from mansion_language import Token

__all__ = ["unit_totals"]

_UNITS = frozenset({"unit", "flat", "apartment", "dwelling", "home", "residence"})
_EACH = frozenset({"each", "every", "per", "a"})
_GROUPS = frozenset({"group", "unit", "ward", "cluster", "department", "section", "wing", "house", "household"})
_ALIKE = frozenset({"identical", "alike", "same", "equal", "repeated"})
_HOUSING = frozenset({"walk", "up", "with", "of", "for", "block", "house", "building"})


def unit_totals(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens without a total that flats on each storey make, and with groups as the storeys that they are.

    "Walk-up with six units: three floors, two flats on every floor" has six flats; "each of floors 2 to 4 is one living
    group: ... The three groups are identical" tells of storeys that are identical.
    """
    return _named_storeys(_without_total(_without_sum(tokens, floor_words), floor_words), floor_words)


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _storeys(tokens: list[Token], floor_words: AbstractSet[str]) -> int:
    """Return how many storeys the brief tells, 0 where it does not."""
    counts = [
        int(token.value)
        for token, noun in itertools.pairwise(tokens)
        if token.kind == "number" and noun.text in floor_words and token.value > 1
    ]
    return max(counts, default=0)


def _without_sum(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens without the flats that a colon after each storey parts: "4 flats on every floor: two ..."."""
    for first in range(len(tokens) - 4):
        total, noun = tokens[first], tokens[first + 1]
        at = first + 2 + (_text(tokens, first + 2) in ("on", "in", "at"))
        apiece = total.kind == "number" and noun.text in _UNITS and _text(tokens, at) in _EACH
        if not apiece or _text(tokens, at + 1) not in floor_words or _text(tokens, at + 2) != ":":
            continue
        end = at + 3
        while end < len(tokens) and tokens[end].text not in (".", "\n", ";"):
            end += 1
        parts = [
            tokens[k].value
            for k in range(at + 3, end - 1)
            if tokens[k].kind == "number" and tokens[k].spaced and tokens[k - 1].text in (":", ",", "and", "plus", "&")
        ]
        if len(parts) > 1 and sum(parts) == total.value:
            return [*tokens[:first], *tokens[first + 2 :]]
    return tokens


def _without_total(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens without the number of flats that is only told again for each storey."""
    storeys = _storeys(tokens, floor_words)
    for at in range(len(tokens) - 3):
        one = tokens[at]
        apiece = one.kind == "number" and _text(tokens, at + 1) in _UNITS
        end = at + 2 + (_text(tokens, at + 2) in ("on", "in", "at"))
        apiece = apiece and _text(tokens, end) in _EACH and _text(tokens, end + 1) in floor_words
        if not apiece or not storeys:
            continue
        for first in range(at - 1, -1, -1):
            total = tokens[first]
            counted = total.kind == "number" and _text(tokens, first + 1) in _UNITS
            if counted and total.value == one.value * storeys and total.value > one.value:
                lead = first - (_text(tokens, first - 1) in ("with", "of"))
                mark = _text(tokens, first + 2) in (":", ",", ";", "-")
                joint = [] if mark or lead == 0 else [Token("mark", ",", total.start, total.start)]
                return [*tokens[:lead], *joint, *tokens[first + 2 :]]
    return tokens


def _named_storeys(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with "floors 2 to 4 are each one group:" as a heading, and the groups as those storeys."""
    for index in range(len(tokens) - 3):
        if _text(tokens, index) not in ("is", "are", "form", "make", "hold", "house"):
            continue
        at = index + 1 + (_text(tokens, index + 1) == "each")
        at += _text(tokens, at) in ("one", "a", "an")
        noun = at
        while (
            noun < at + 3 and _text(tokens, noun) not in _GROUPS and noun < len(tokens) and tokens[noun].kind == "word"
        ):
            noun += 1
        if at == index + 1 or _text(tokens, noun) not in _GROUPS or _text(tokens, noun + 1) not in (":", ",", "with"):
            continue
        first = index
        while first > 0 and tokens[first - 1].text not in (".", "\n", ";", "!"):
            first -= 1
        named = tokens[first:index]
        if not any(token.text in floor_words for token in named):
            continue
        colon = replace(tokens[noun], kind="mark", text=":", plural=False)
        rest = tokens[noun + 1 + (_text(tokens, noun + 1) != "with") :]
        storeys = [token for token in named if token.text not in ("each", "of", "every", "the")]
        return [*tokens[:index], colon, *_again(rest, tokens[noun].text, storeys)]
    return tokens


def _again(tokens: list[Token], noun: str, storeys: list[Token]) -> list[Token]:
    """Return tokens with "all three groups are identical" as said of storeys."""
    for at in range(len(tokens)):
        end = at + (_text(tokens, at) in ("all", "both", "the"))
        end += _text(tokens, end) in ("the", "of")
        end += end < len(tokens) and tokens[end].kind == "number"
        alike = (
            _text(tokens, end) == noun
            and tokens[end].plural
            and _text(tokens, end + 1) in ("are", "is", "should", "must")
        )
        if alike and end > at and not _ALIKE.isdisjoint(token.text for token in tokens[end + 1 : end + 4]):
            place = [replace(token, start=tokens[at].start, end=tokens[end].end) for token in storeys]
            return [*tokens[:at], *place, *tokens[end + 1 :]]
    return tokens
