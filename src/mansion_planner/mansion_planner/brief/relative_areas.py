"""Read areas told as a share or a multiple of the one said last: "a showroom half that size", "twice as large"."""

from dataclasses import replace

from mansion_language import Token
from mansion_language.units import AREA

__all__ = ["relative_areas"]

_FACTORS = {"half": 0.5, "twice": 2.0, "double": 2.0, "triple": 3.0, "third": 1 / 3, "quarter": 0.25}
_SHARES = frozenset({"third", "quarter"})
"""Factors that only an article before them makes one: "a third of that"."""
_THAT = frozenset({"that", "this"})
_SIZES = frozenset({"size", "area", "space", "surface"})
_MEASURED = frozenset({"large", "big", "spacious"})
_CLOSERS = frozenset({"", ",", ".", ";", ":", ")", "\n", "and", "with", "for", "but", "!"})


def relative_areas(tokens: list[Token]) -> list[Token]:
    """Return the tokens with such shares as areas; those of no area said before are left as they are."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        last = _share_end(tokens, index)
        base = _area_before(result) if last != index else None
        if last == index or base is None:
            result.append(tokens[index])
            index += 1
            continue
        if tokens[index].text in _SHARES:
            result.pop()  # the article
        first, end = tokens[index], tokens[last - 1].end
        value = round(_FACTORS[first.text] * base[0].value, 1)
        result.append(Token("number", f"{value:g}", first.start, first.end, value, spaced=first.spaced))
        result.append(replace(base[1], start=first.end, end=end))
        index = last
    return result


def _share_end(tokens: list[Token], index: int) -> int:
    """Return where "half that size", "twice as large", "a third of that" end that begin at a token; it, if none."""
    texts = ["" if not 0 <= at < len(tokens) else tokens[at].text for at in range(index - 1, index + 6)]
    before, factor, rest = texts[0], texts[1], texts[2:]
    if factor not in _FACTORS or (factor in _SHARES and before not in ("a", "one")):
        return index
    at = int(rest[0] == "of")
    if rest[at] in _THAT:
        sized = rest[at + 1] in _SIZES
        return index + 2 + at + sized if sized or rest[at + 1] in _CLOSERS else index
    if rest[0] != "as" or rest[1] not in _MEASURED:
        return index
    again = rest[2] == "as" and rest[3] in _THAT | {"it"}
    if rest[2] == "as" and rest[3] in _ARTICLES:
        return _noun_end(tokens, index + 5)
    return index + 3 + 2 * again if again or rest[2] in _CLOSERS else index


def _noun_end(tokens: list[Token], index: int) -> int:
    """Return where the noun ends whose size something is a multiple of: "as an exhibition room"."""
    end = index
    while end < len(tokens) and tokens[end].kind == "word" and tokens[end].text not in _CLOSERS:
        end += 1
    return min(end, index + _WORDS)


_ARTICLES = frozenset({"a", "an", "the", "one"})
_WORDS = 3
"""Words of such a noun, at most."""


def _area_before(tokens: list[Token]) -> tuple[Token, Token] | None:
    """Return the number and the unit of the area said last."""
    for at in range(len(tokens) - 1, 0, -1):
        if tokens[at].text in AREA and tokens[at].kind == "unit" and tokens[at - 1].kind == "number":
            return tokens[at - 1], tokens[at]
    return None
