"""Write out what is said of storeys in short: "open plan on first", "the upper floor 8", "(five rooms per floor)"."""

from collections.abc import Set as AbstractSet
from dataclasses import replace

from mansion_language import Token

__all__ = ["storeys_in_full"]

_ENDS = frozenset({"", ".", ",", ";", ":", "\n", ")", "!", "?"})
_NAMED = frozenset({"ground", "top", "upper", "lower", "middle", "bottom"})
_SIDES = frozenset({"below", "down", "downstairs", "above", "upstairs", "up", "underneath"})
"""Words that only repeat on which side of the ground a storey lies: "dressing rooms below in the basement"."""
_CELLARS = frozenset({"basement", "cellar", "attic", "loft"})
_DETERMINERS = frozenset({"a", "an", "the", "all"})


def storeys_in_full(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with such storeys as others are named.

    "On first" gets its noun, "the upper floor 8" counts before the storey as "8 on the upper floor", and "per floor" at
    the end of a list in brackets stands before the list. A storey that houses rooms is no house.
    """
    tokens = _unwanted_there(tokens, floor_words)
    tokens = _of_each_floor(_all_on_one(_of_building(tokens, floor_words), floor_words), floor_words)
    tokens = _counts_before(_lists_per_storey(tokens, floor_words), floor_words)
    storeyed = any(token.text in floor_words for token in tokens)
    result: list[Token] = []
    for index, token in enumerate(tokens):
        if token.text in _SIDES and _names_cellar(tokens, index + 1):
            continue
        if token.text == "house" and _is_verb(tokens, index):
            result.append(replace(token, text="hold", plural=False))
            continue
        result.append(token)
        short = token.kind == "ordinal" or token.text == "ground"
        if storeyed and short and _text(tokens, index - 1) == "on" and _text(tokens, index + 1) in _ENDS:
            result.append(Token("word", "floor", token.end, token.end))
    return result


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _names_cellar(tokens: list[Token], index: int) -> bool:
    """Whether "in the basement" stands at a token."""
    at = index + 1 + (_text(tokens, index + 1) == "the")
    return _text(tokens, index) in ("in", "at") and _text(tokens, at) in _CELLARS


def _is_verb(tokens: list[Token], index: int) -> bool:
    """Whether "houses" tells what a storey or building holds: "the ground floor houses six classrooms"."""
    after = tokens[index + 1] if index + 1 < len(tokens) else None
    listed = after is not None and (after.kind == "number" or after.text in _DETERMINERS)
    before = tokens[index - 1] if index else None
    return tokens[index].plural and listed and before is not None and before.kind == "word" and not before.plural


def _is_storey(tokens: list[Token], index: int, floor_words: AbstractSet[str]) -> bool:
    """Whether a noun for a storey stands at a token, and its name before it: "second floor"."""
    named = index > 0 and (tokens[index - 1].kind == "ordinal" or tokens[index - 1].text in _NAMED)
    return named and _text(tokens, index) in floor_words and not tokens[index].plural


def _counts_before(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return tokens with "six classrooms, the upper floor 8" as "six classrooms, 8 on the upper floor"."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        counts = token.kind == "number" and token.value == int(token.value) and _text(tokens, index + 1) in _ENDS
        if not counts or not _is_storey(tokens, index - 1, floor_words):
            result.append(token)
            continue
        first = len(result) - 2 - (_text(result, len(result) - 3) == "the")
        lead = _text(result, first - 1)
        storey = result[first:]
        if lead not in (",", ";", "and") or not any(before.kind == "number" for before in result[:first]):
            result.append(token)
            continue
        on = Token("word", "on", token.end, token.end)
        result[first:] = [token, on, *storey]
    return result


def _unwanted_there(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return tokens with "no second floor offices" as "no offices on the second floor"."""
    result = list(tokens)
    for index in range(len(tokens) - 4, -1, -1):
        storey = index + 2
        if _text(result, index) not in ("no", "without") or not _is_storey(result, storey, floor_words):
            continue
        end = storey + 1
        while end < len(result) and result[end].kind == "word" and result[end].text not in _JOINTS:
            end += 1
        if storey + 1 < end <= storey + 1 + _WORDS and _text(result, end) in _ENDS | {"and", "or"}:
            at = result[end - 1].end
            place = [Token("word", "on", at, at), Token("word", "the", at, at), *result[index + 1 : storey + 1]]
            result[index + 1 : end] = [*result[storey + 1 : end], *place]
    return result


_JOINTS = frozenset({"and", "or", "please", "with", "for", "in", "on", "is", "are"})
_WORDS = 3
"""Words of a room's name, at most."""
_CLAUSES = frozenset({".", ";", ":", "\n", "!", "?"})


def _all_on_one(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return tokens with "a hall, a store and a bar, all downstairs" as "downstairs: a hall, a store and a bar"."""
    for index in range(2, len(tokens) - 1):
        if _text(tokens, index) != "all" or _text(tokens, index - 1) != ",":
            continue
        at = index + 1
        end = at + 1 if _text(tokens, at) in ("downstairs", "downstair", "upstairs", "upstair") else 0
        if _text(tokens, at) == "on":
            noun = at + 2 + (_text(tokens, at + 1) == "the")
            end = noun + 1 if _is_storey(tokens, noun, floor_words) else 0
        if not end or _text(tokens, end) not in _CLAUSES | {""}:
            continue
        others = {token.text for token in (*tokens[:index], *tokens[end:])}
        if _text(tokens, end - 2) == "ground" and others.isdisjoint({*floor_words, *_SIDES, *_CELLARS}):
            continue  # which is all that there is
        first = index - 1
        while first > 0 and tokens[first - 1].text not in _CLAUSES:
            first -= 1
        told = range(first, index - 1)  # "two storeys, a hall, a store, all downstairs"
        first = next((k + 2 for k in told if tokens[k].text in floor_words and _text(tokens, k + 1) == ","), first)
        colon = Token("mark", ":", tokens[at].start, tokens[at].start)
        moved = [*tokens[:first], *tokens[at:end], colon, *tokens[first : index - 1]]
        return [*moved, *_all_on_one(tokens[end:], floor_words)]
    return tokens


def _of_each_floor(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return tokens with "two storeys of 80 m2: each has a kitchen" as "each floor has a kitchen"."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        result.append(token)
        holds = token.text == "each" and _text(tokens, index + 1) in ("has", "have", "with", "contain", "hold", ":")
        if not holds or _text(tokens, index - 1) not in (":", ",", ".", ";", "-", "("):
            continue
        near = range(max(index - _SIZED, 1), index)
        storeys = max((at for at in near if tokens[at].text in floor_words and tokens[at].plural), default=0)
        between = {tokens[at].text for at in range(storeys + 1, index) if tokens[at].kind == "word"}
        if storeys and between <= _OF_SIZE and not _holds_units(tokens, storeys):
            result.append(Token("word", "floor", token.end, token.end))
    return result


_SIZED = 8
"""Tokens between storeys and what each of them has, at most."""
_OF_SIZE = frozenset({"of", "with", "about", "around", "approx", "each", "at", "the", "same", "identical", "gross"})


_UNITS = frozenset({"flat", "apartment", "suite", "maisonette", "studio", "unit", "townhouse", "home"})


def _holds_units(tokens: list[Token], storeys: int) -> bool:
    """Whether several units lie on the storeys that a token names: "8 flats on two floors, each: a bedroom"."""
    at = storeys - 1
    while at > 0 and tokens[at].text not in (".", ";", "\n", ":"):
        if tokens[at].text in _UNITS and tokens[at].plural:
            return any(token.text in ("on", "over", "across") for token in tokens[at:storeys])
        at -= 1
    return False


def _speaks_of_upper_storeys(tokens: list[Token], index: int) -> bool:
    """Whether the clause before a token is about the upper storeys."""
    while index > 0 and tokens[index - 1].text not in (".", ";", "\n"):
        index -= 1
        if tokens[index].text == "upper":
            return True
    return False


def _of_building(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return tokens with "the ground floor of the school holds" as "school. The ground floor holds", at the start."""
    for index in range(min(len(tokens) - 4, _OPENING)):
        named = _is_storey(tokens, index, floor_words)
        owner = tokens[index + 3]
        of_it = named and [_text(tokens, index + 1), _text(tokens, index + 2)] in (["of", "the"], ["of", "a"])
        if of_it and owner.kind == "word" and _is_told(tokens, index + 4):
            stop = Token("mark", ".", owner.end, owner.end)
            return [owner, stop, *tokens[: index + 1], *tokens[index + 4 :]]
    return tokens


def _is_told(tokens: list[Token], index: int) -> bool:
    """Whether a verb at a token tells what a storey has."""
    return _text(tokens, index) in ("has", "have", "hold", "contain", "house", "get", "is", "need", "comprise")


_OPENING = 4
"""Tokens in which a brief may begin with a storey of the building that it is about."""


def _lists_per_storey(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return tokens with "(five rooms, two baths per floor)" as "(on each floor: five rooms, two baths)"."""
    for index in range(len(tokens) - 2):
        each = _text(tokens, index) in ("per", "each") and _text(tokens, index + 1) in floor_words
        if not each or _text(tokens, index + 2) != ")":
            continue
        start = next((at for at in range(index - 1, -1, -1) if tokens[at].text in ("(", ")")), -1)
        listed = any(tokens[at].text in (",", "and", "+") for at in range(start, index))
        if start < 0 or tokens[start].text != "(" or not listed:
            continue
        at = tokens[start].end
        colon = Token("mark", ":", at, at)
        upper = [Token("word", "upper", at, at)] * _speaks_of_upper_storeys(tokens, start)
        lead = [Token("word", "on", at, at), replace(tokens[index], text="each"), *upper, tokens[index + 1], colon]
        moved = [*tokens[: start + 1], *lead, *tokens[start + 1 : index]]
        return [*moved, *_lists_per_storey(tokens[index + 2 :], floor_words)]
    return tokens
