"""Bring flats that are named by their type alone into one form: "2 two-beds and 1 studio", "one 1BR unit"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["flat_types"]

_HOUSING = frozenset(
    """
    apartment flat residential housing studio tenement condominium condo maisonette dwelling penthouse
    """.split()
)
"""Words of a brief that is about flats: elsewhere "two-bed" may be of a hospital."""
_SIZES = frozenset({"bed", "bedroom", "br", "bdr", "bedder", "room", "roomer"})
_UNITS = frozenset({"unit", "apt", "dwelling", "residence"})
_NOUNS = frozenset({"flat", "apartment", "maisonette", "home", "penthouse", "suite"}) | _UNITS
_JOINTS = frozenset({"and", ",", "&", "+", "/", "plus", "or"})
_ENDS = frozenset({"", ".", ";", ")", ":", "\n", "per", "on", "each", "in", "at", "for", "a", "with"}) | _JOINTS


def flat_types(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the noun that "two-bed", "2BR unit" and "three-bedder" leave out."""
    if _HOUSING.isdisjoint(token.text for token in tokens):
        return tokens
    result: list[Token] = []
    for index, token in enumerate(tokens):
        previous = tokens[index - 1] if index else None
        if token.text in _UNITS and index > 1 and _is_size(tokens, index - 1):
            result.append(replace(token, text="flat"))
            continue
        if previous is not None and _is_size(tokens, index):
            many = tokens[index - 2].value if index > 1 and tokens[index - 2].kind == "number" else 1.0
            several = token.plural or many > 1
            counted = token.plural or (index > 1 and (tokens[index - 2].kind == "number" or _is_article(tokens, index)))
            noun = "bed" if token.text == "bedder" else "room" if token.text == "roomer" else token.text
            result.append(replace(token, text=noun, plural=False))
            if counted and _word(tokens, index + 1) in _ENDS and not _shares_noun(tokens, index + 1):
                result.append(Token("word", "flat", token.start, token.end, plural=several))
            continue
        result.append(token)
    return result


def _word(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _is_article(tokens: list[Token], index: int) -> bool:
    return _word(tokens, index - 2) in ("a", "an", "another", "each", "every")


def _is_size(tokens: list[Token], index: int) -> bool:
    """Whether "bed" of "two-bed" stands at a token."""
    size, number = tokens[index], tokens[index - 1]
    return size.text in _SIZES and not size.spaced and number.kind == "number" and 1 <= number.value <= 8


def _shares_noun(tokens: list[Token], index: int) -> bool:
    """Whether types that are joined have their noun at the end: "one 1-bed and two 2-bed flats"."""
    while _word(tokens, index) in _JOINTS:
        while _word(tokens, index) in _JOINTS | {"a", "an"}:
            index += 1
        while index < len(tokens) and (tokens[index].kind == "number" or tokens[index].text in _SIZES):
            index += 1
        if _word(tokens, index) in _NOUNS:
            return index > 1 and _is_size(tokens, index - 1)
    return False
