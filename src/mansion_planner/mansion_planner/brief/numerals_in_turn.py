"""Give each of several flats the numeral that is told for it: "the three flats have 1, 2 and 3 bedrooms".

So do the flats of each storey: "two flats per floor, ground floor flats 2 bedrooms each, top floor flats 3".
"""

from collections.abc import Set as AbstractSet
from dataclasses import dataclass, replace

from mansion_language import Token

__all__ = ["numerals_in_turn"]

_FLATS = frozenset({"flat", "apartment", "unit", "dwelling", "home", "maisonette", "house"})
_BEDROOMS = frozenset({"bedroom", "bed", "br"})
_VERBS = frozenset({"have", "has", "with", "of", "having", "contain", "get", "be", "are", "offer", "comprise"})
_JOINTS = frozenset({",", "and", "&", "plus", "+", "/"})
_ENDS = frozenset({".", ";", "\n", "!", "?"})
_REACH = 12
"""Tokens between the flats and their numerals, at most: "the three flats on each floor have ..."."""


def numerals_in_turn(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with a numeral for each of several flats as what one flat has, and then the next.

    "Two apartments each, one with two bedrooms and one studio" are one two-bedroom apartment and one studio.
    """
    result = _flats_of_storeys(list(tokens), floor_words)
    for index in range(len(result) - 4, -1, -1):
        number, noun = result[index], result[index + 1]
        several = number.kind == "number" and 1 < number.value <= _REACH and noun.plural
        if several and noun.text in _FLATS:
            result = _with_numerals(result, index) or _with_parts(result, index) or result
    return result


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _is_count(tokens: list[Token], index: int) -> bool:
    return index < len(tokens) and tokens[index].kind == "number" and 0 < tokens[index].value <= _REACH


def _flats_of_storeys(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with the flats of each storey told by that storey, and no longer for all of them together."""
    whole = next((at for at in range(len(tokens) - 4) if _is_per_floor(tokens, at, floor_words)), -1)
    own = [at for at in range(whole + 4, len(tokens) - 2) if _told_of_storey(tokens, at, floor_words)]
    if whole < 0 or len(own) < _STOREYS:
        return tokens
    result = [*tokens[:whole]]
    index = whole + 4
    while index < len(tokens):
        if index not in own:
            result.append(tokens[index])
            index += 1
            continue
        numeral = _numeral_of(tokens, index)
        at = tokens[index].start
        while result and result[-1].text in (",", "and", "the"):
            result.pop()
        flat = replace(tokens[index + 2], start=tokens[numeral].end, end=tokens[numeral].end)
        sized = replace(tokens[numeral + 1], text="bedroom", plural=False, spaced=False)
        marks = [Token("mark", ";", at, at), Token("mark", ":", tokens[index + 1].end, tokens[index + 1].end)]
        count = replace(tokens[whole], start=tokens[numeral].start, end=tokens[numeral].start)
        result += [marks[0], *tokens[index : index + 2], marks[1], count, tokens[numeral], sized, flat]
        index = numeral + 2 + (_text(tokens, numeral + 2) in ("each", "apiece"))
    return result


_STOREYS = 2
"""Storeys whose flats are told apart, at least."""
_NAMED = frozenset({"ground", "top", "upper", "lower", "middle", "first"})


def _is_per_floor(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> bool:
    """Whether "two flats per floor" stands at a token."""
    flats = _is_count(tokens, index) and tokens[index + 1].plural and _text(tokens, index + 1) in _FLATS
    return flats and _text(tokens, index + 2) in ("per", "a", "each") and _text(tokens, index + 3) in floor_words


def _told_of_storey(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> bool:
    """Whether "ground floor flats 2 bedrooms" stands at a token."""
    storey = _text(tokens, index) in _NAMED or tokens[index].kind == "ordinal"
    flats = storey and _text(tokens, index + 1) in floor_words and _text(tokens, index + 2) in _FLATS
    numeral = _numeral_of(tokens, index) if flats else 0
    return flats and _is_count(tokens, numeral) and _text(tokens, numeral + 1) in _BEDROOMS


def _numeral_of(tokens: list[Token], index: int) -> int:
    """Return where the number of bedrooms of a storey's flats is told."""
    return index + 3 + (_text(tokens, index + 3) in _VERBS | {":"})


def _with_numerals(tokens: list[Token], index: int) -> list[Token] | None:
    """Return the tokens with "have 1, 2 and 3 bedrooms" told of one flat after the other."""
    many = int(tokens[index].value)
    for at in range(index + 2, min(index + _REACH, len(tokens) - many)):
        if tokens[at].text in _ENDS:
            return None
        if not _is_count(tokens, at) or _text(tokens, at - 1) not in _VERBS | {":", "("}:
            continue
        numerals, end = [tokens[at]], at + 1
        while _text(tokens, end) in _JOINTS:
            end += 1
            if _is_count(tokens, end):
                numerals.append(tokens[end])
                end += 1
        end += _text(tokens, end) == "respectively"
        if len(numerals) != many or _text(tokens, end) not in _BEDROOMS:
            return None
        last = end + 1 + (_text(tokens, end + 1) == "respectively")
        return [*tokens[: at - 1], *_one_by_one(numerals, tokens[end]), *tokens[last:]]
    return None


def _one_by_one(numerals: list[Token], noun: Token) -> list[Token]:
    """Return the tokens of ", of which one has 1 bedroom, one has 2 bedrooms"."""
    first = numerals[0].start
    told = [Token("mark", ",", first, first), Token("word", "of", first, first), Token("word", "which", first, first)]
    for place, numeral in enumerate(numerals):
        at = numeral.start
        told += [Token("mark", ",", at, at)] if place else []
        told += [Token("number", "one", at, at, 1.0), Token("word", "has", at, at), numeral]
        told.append(replace(noun, text="bedroom", start=numeral.end, end=numeral.end, plural=numeral.value > 1))
    return told


@dataclass(frozen=True)
class _Part:
    """Some of the flats: their number, and the number of their bedrooms, or the noun of a flat without any."""

    count: Token
    beds: Token | None
    noun: Token

    def tokens(self, flat: Token) -> list[Token]:
        """Return the tokens of "one two-bedroom flat" or "one studio"."""
        if self.beds is None:
            return [self.count, self.noun]
        sized = replace(self.noun, text="bedroom", plural=False, spaced=False)
        named = replace(flat, start=self.noun.end, end=self.noun.end, plural=self.count.value > 1)
        return [self.count, self.beds, sized, named]


def _with_parts(tokens: list[Token], index: int) -> list[Token] | None:
    """Return the tokens with flats of which some are studios told as what they are, each by its own name."""
    each = _text(tokens, index + 2) == "each"
    at = index + 2 + each
    if _text(tokens, at) not in (",", ":", "-", "("):
        return None
    bracket, at = _text(tokens, at) == "(", at + 1
    parts: list[_Part] = []
    while (found := _part(tokens, at)) is not None:
        parts.append(found[0])
        at = found[1]
        while _text(tokens, at) in _JOINTS:
            at += 1
    told = sum(part.count.value for part in parts) == tokens[index].value
    if not told or all(part.beds is not None for part in parts) or len(parts) < 2:
        return None
    at += bracket and _text(tokens, at) == ")"
    named: list[Token] = []
    for part in sorted(parts, key=lambda part: part.beds is None):
        joint = part.count.start
        named += [Token("word", "and", joint, joint)] if named else []
        named += part.tokens(tokens[index + 1])
    return [*tokens[:index], *named, *([tokens[index + 2]] if each else []), *tokens[at:]]


def _part(tokens: list[Token], index: int) -> tuple[_Part, int] | None:
    """Read "one with two bedrooms" or "one studio" at a token; return it and where it ends."""
    count = tokens[index] if index < len(tokens) else None
    if count is not None and count.text in ("a", "an"):
        count = Token("number", "one", count.start, count.end, 1.0)
    if count is None or count.kind != "number":
        return None
    if _text(tokens, index + 1) == "studio":
        return _Part(count, None, tokens[index + 1]), index + 2
    at = index + 1 + (_text(tokens, index + 1) in _VERBS)
    if not _is_count(tokens, at) or _text(tokens, at + 1) not in _BEDROOMS:
        return None
    return _Part(count, tokens[at], tokens[at + 1]), at + 2 + (_text(tokens, at + 2) in _FLATS)
