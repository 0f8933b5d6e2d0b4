"""Count the rooms of homes that stand side by side: "two semi-detached houses, each with three bedrooms upstairs".

Each home goes over all storeys, so what one has is counted once for each of them in the building that they make.
"""

import itertools
from collections.abc import Set as AbstractSet
from dataclasses import replace

from mansion_language import Token
from mansion_language.units import AREA

__all__ = ["twin_homes"]

_HOMES = frozenset({"home", "house", "dwelling", "townhouse", "villa", "unit", "half", "cottage", "family"})
_SIDE_BY_SIDE = frozenset(
    "semi detached mirrored mirror terraced twin attached row identical adjoining side-by-side paired".split()
)
"""Words for homes that share walls, none of which lies above another."""
_STOREYS = frozenset("upstairs downstairs below above up down upstair downstair".split())
_HAVING = frozenset({"has", "have", "with", "having", "contain", "get", "comprise", "include", "hold", ":", "consist"})
_ARTICLES = frozenset({"a", "an", "one"})
_LINKS = frozenset({",", "and", "+", "plus", "&", "with", "/", ":", "of", "has", "have", "having"})
_ALIKE = frozenset({"same", "mirrored", "identical", "alike", ",", "are", "and", "equal", "halves"})
_ENDS = frozenset({".", "\n", "!", "?"})
_MOST = 12


def twin_homes(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with the rooms and the area of such homes counted for all of them together."""
    texts = [token.text for token in tokens]
    found = _homes(tokens)
    several = any(text in floor_words for text in texts) or not _STOREYS.isdisjoint(texts)
    if found is None or not several:
        return tokens
    first, noun, many = found
    given = _each_of_them(tokens, noun + 1)
    if given is None:
        return tokens
    opened, begin, end = given
    house = (
        tokens[noun] if first == noun else replace(tokens[noun], text="house", plural=False, start=tokens[first].start)
    )
    between = _with_all_areas(_without_sides(tokens[noun + 1 : opened]), many)
    link = (
        []
        if opened < begin and texts[opened - 1] in _ENDS | {";"}
        else [replace(tokens[begin - 1], text=":", kind="mark")]
    )
    listed = _counted_for_all(tokens[begin:end], many, floor_words)
    return [*tokens[:first], house, *between, *link, *listed, *_with_all_areas(tokens[end:], many)]


_SIDES = (("side", "by", "side"), ("under", "one", "roof"), ("next", "to", "each", "other"), ("wall", "to", "wall"))


def _without_sides(tokens: list[Token]) -> list[Token]:
    """Return tokens without the words for how the homes stand, and without "each" after their storeys."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        texts = [token.text for token in tokens[index : index + 4]]
        said = next((len(words) for words in _SIDES if tuple(texts[: len(words)]) == words), 0)
        index += said or 1
        if not said:
            result.append(tokens[index - 1])
    return result


def _homes(tokens: list[Token]) -> tuple[int, int, int] | None:
    """Return the first token, the noun and the number of homes side by side that a brief tells of."""
    texts = [token.text for token in tokens]
    halves = ("both", "half") in itertools.pairwise(texts) or ("each", "half") in itertools.pairwise(texts)
    if "duplex" in texts and halves:
        noun = texts.index("duplex")
        return noun, noun, 2
    for first, token in enumerate(tokens):
        if (families := _families(tokens, first)) is not None:
            return families
        if token.kind != "number" or not 2 <= token.value <= _MOST or token.value != int(token.value):
            continue
        noun, said = first + 1, set[str]()
        while noun < len(tokens) and noun - first < 6 and tokens[noun].text not in _HOMES:
            said.add(tokens[noun].text)
            noun += 1
        if noun >= len(tokens) or tokens[noun].text not in _HOMES or not tokens[noun].plural:
            continue
        after = {token.text for token in tokens[noun + 1 : noun + 8]}
        beside = bool(said & _SIDE_BY_SIDE) or "side" in after or bool(after & {"mirrored", "attached", "adjoining"})
        plain = all(other.kind == "word" for other in tokens[first + 1 : noun])
        if beside and plain and "on" not in said:
            return first, noun, int(token.value)
    return None


def _families(tokens: list[Token], first: int) -> tuple[int, int, int] | None:
    """Return the same of a house for several families whose homes share a wall: "two-family house, side by side"."""
    number, texts = tokens[first], [token.text for token in tokens[first + 1 : first + 12]]
    named = number.kind == "number" and 2 <= number.value <= _MOST and texts[:1] == ["family"]
    if not named or texts[1:2] not in (["house"], ["home"], ["building"]):
        return None
    beside = any(tuple(texts[at : at + 3]) == _SIDES[0] for at in range(len(texts)))
    return (first, first + 2, int(number.value)) if beside or not _SIDE_BY_SIDE.isdisjoint(texts[2:8]) else None


def _each_of_them(tokens: list[Token], index: int) -> tuple[int, int, int] | None:
    """Return where "each home has" opens and ends, and where the list after it ends; none where there is none."""
    for at in range(index, len(tokens)):
        if tokens[at].text not in ("each", "every", "both", "all", "per"):
            continue
        begin = at + 1
        while begin < len(tokens) and begin - at < 8 and tokens[begin].text not in _HAVING:
            begin += 1
        if begin >= len(tokens) or tokens[begin].text not in _HAVING:
            continue
        named = [token.text for token in tokens[at + 1 : begin]]
        if not set(named) <= _HOMES | _ALIKE | {"of", "them", "the", "one", "these", "two"}:
            continue
        begin += 1 + (begin + 1 < len(tokens) and tokens[begin + 1].text in ("of", "its", "their"))
        end = begin
        while end < len(tokens) and tokens[end].text not in _ENDS:
            end += 1
        return at, begin, end
    return None


def _counted_for_all(tokens: list[Token], many: int, floor_words: AbstractSet[str]) -> list[Token]:
    """Return a list of rooms with their numbers times that of the homes; storeys they have in common."""
    result: list[Token] = []
    for index, token in enumerate(tokens):
        following = tokens[index + 1] if index + 1 < len(tokens) else None
        before = tokens[index - 1].text if index else ","
        measured = following is not None and (following.kind == "unit" or following.text in floor_words)
        if token.kind == "number" and not measured and before not in ("of", "for", "x"):
            result.append(_number(token, int(token.value) * many))
        elif token.text in _ARTICLES or (token.text in ("its", "own", "their") and before in _LINKS):
            result.append(_number(token, many))
        elif token.kind == "word" and before in _STOREYS | {",", "and", "+", "plus", "&", "/"} and _is_bare(token):
            result += [_number(replace(token, end=token.start), many), token]
        elif token.text not in ("own", "its"):
            result.append(token)
    return result


def _is_bare(token: Token) -> bool:
    """Whether a noun without an article may be an entry of a list: "kitchen, living room"."""
    return token.text not in _STOREYS | _LINKS | {"the", "on", "in", "at", "all", "both", "each", "to", "no", "not"}


def _number(token: Token, value: int) -> Token:
    return replace(token, kind="number", text=str(value), value=float(value), plural=False, soft=False)


def _with_all_areas(tokens: list[Token], many: int) -> list[Token]:
    """Return tokens with "2 x 110 m2", "of 110 m2 each" and "110 m2 per home" as the area of all."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        texts = [token.text for token in tokens[index : index + 4]]
        token = tokens[index]
        times = token.kind == "number" and texts[1:2] == ["x"] and len(texts) > 3 and texts[3] in AREA
        apiece = token.kind == "number" and len(texts) > 1 and texts[1] in AREA
        after = texts[2:3] + [t.text for t in tokens[index + 3 : index + 4]]
        each = after[:1] in (["each"], ["apiece"]) or (
            after[:1] in (["per"], ["a"]) and after[1:] and after[1] in _HOMES
        )
        before = [other.text for other in result[-2:]]
        of_each = len(before) > 1 and before[0] in ("each", "every", "per") and before[1] in _HOMES
        if apiece and of_each:
            result[-2:] = [_total(token, token.value * many), tokens[index + 1]]
            index += 2
        elif times and token.value == many:
            area = tokens[index + 2]
            result += [_total(replace(area, start=token.start), area.value * many), tokens[index + 3]]
            index += 4
        elif apiece and each:
            result += [_total(token, token.value * many), tokens[index + 1]]
            index += 3 + (after[0] in ("per", "a"))
        else:
            result.append(token)
            index += 1
    return result


def _total(token: Token, value: float) -> Token:
    return replace(token, kind="number", text=f"{value:g}", value=value)
