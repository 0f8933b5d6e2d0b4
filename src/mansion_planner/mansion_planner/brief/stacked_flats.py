"""Bring flats that lie one above the other into one form: "two flats, one above the other" are floors with one each."""

from collections.abc import Set as AbstractSet
from dataclasses import replace

from mansion_language import Token

__all__ = ["stacked_flats"]

_FLATS = frozenset({"flat", "apartment", "maisonette"})
_STACKED = (
    ("one", "above", "the", "other"),
    ("one", "over", "the", "other"),
    ("one", "on", "top", "of", "the", "other"),
)
_ALIKE = frozenset({"alike", "identical", "equal"})
_OTHER_STOREYS = frozenset({"ground", "upstairs", "downstairs", "top", "basement", "cellar", "above", "over", "attic"})
"""Words of storeys that hold something else: the flats are then not all that there is."""


def stacked_flats(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with flats told so as storeys with a flat each, where the brief tells of no other storey."""
    texts = [token.text for token in tokens]
    for index in range(len(tokens) - 2):
        if tokens[index].kind != "number" or texts[index + 1] not in _FLATS or not tokens[index + 1].plural:
            continue
        at = index + 2 + (texts[index + 2] == ",")
        last = next((at + len(words) for words in _STACKED if tuple(texts[at : at + len(words)]) == words), 0)
        elsewhere = {
            text for k, text in enumerate(texts)
            if not index <= k < last and (text in _OTHER_STOREYS or (text in floor_words and texts[k - 1] != "own"))
        }  # fmt: skip
        if last and not elsewhere:
            told = _floors(tokens[index], tokens[index + 1], alike=not _ALIKE.isdisjoint(texts[last : last + 2]))
            return [*tokens[:index], *told, *tokens[last:]]
    return tokens


def _floors(number: Token, noun: Token, *, alike: bool) -> list[Token]:
    """Return the tokens of "two floors, each with one flat"."""

    def word(text: str) -> Token:
        return Token("word", text, noun.start, noun.end)

    return [
        number,
        *([word("identical")] * alike),
        replace(noun, text="floor"),
        Token("mark", ",", noun.end, noun.end),
        word("each"),
        word("with"),
        Token("number", "one", noun.start, noun.end, 1.0),
        replace(noun, plural=False),
    ]
