"""Take a mezzanine for the storey above the ground floor: "a mezzanine for the office", "Mezzanine: lounge".

The plans have no storeys that cover a part of another, so rooms on a mezzanine lie on the first upper one.
"""

from collections.abc import Set as AbstractSet
from dataclasses import replace

from mansion_language import Token
from mansion_planner.brief.storey_forms import ABOVE_GROUND

__all__ = ["mezzanines"]

_NAMES = frozenset({"mezzanine", "entresol"})
_DENIALS = frozenset({"no", "not", "without", "never", "any"})
_HOLDING = frozenset({"with", "holding", "for", "containing", "where", "housing", "has", "hold", "contain", ":", "is"})
_LEADS = frozenset({"with", "and", "plus", ",", "+", "has", "have", "is", "there"})
_ARTICLES = frozenset({"a", "an", "the", "one", "small", "open", "its", "internal"})
_STARTS = frozenset({"", ".", ";", "\n", "!", "?", "*", "-"})


def mezzanines(tokens: list[Token], floor_words: AbstractSet[str]) -> list[Token]:
    """Return the tokens with each mezzanine that rooms or things are on as a level above the ground."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        token = tokens[index]
        if _tells_use(tokens, index):
            index += 1
            continue
        if token.text in _NAMES and _text(tokens, index + 1) == "free" and not tokens[index + 1].spaced:
            index += 2  # "a mezzanine-free level"
            continue
        if token.text not in _NAMES or not _DENIALS.isdisjoint(t.text for t in tokens[max(index - 3, 0) : index]):
            result.append(token)
            index += 1
            continue
        end = index + 1 + (_text(tokens, index + 1) in floor_words | {"area"})
        level = Token("level", ABOVE_GROUND, token.start, tokens[end - 1].end, 1.0, spaced=token.spaced)
        opens = _text(result, len(result) - 1) in _STARTS
        if _text(tokens, end) in _HOLDING:
            colon = replace(tokens[end], kind="mark", text=":", plural=False)
            result += [level, colon] if opens else [*_led(result, token), level, colon]
            end += 1 + (_text(tokens, end + 1) in ("is", "are"))
        else:
            result.append(level)
        index = end
    return result


def _tells_use(tokens: list[Token], index: int) -> bool:
    """Whether a word only says what a mezzanine is for: "an office mezzanine with three offices"."""
    within = tokens[index].kind == "word" and tokens[index].text not in _LEADS | _ARTICLES | _DENIALS
    listed = _text(tokens, index + 2) in ("with", ":", "holding", "containing")
    return within and _text(tokens, index + 1) in _NAMES and listed and _text(tokens, index - 1) in _ARTICLES


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _led(before: list[Token], noun: Token) -> list[Token]:
    """Leave out the words that lead to a mezzanine ("with a small"); return those that lead to a storey."""
    if before and before[-1].text in ("on", "at", "in"):
        return []
    while before and before[-1].text in _ARTICLES:
        before.pop()
    if before and before[-1].text in ("on", "at", "in"):
        return []
    if before and before[-1].text in _LEADS:
        before.pop()
    at = noun.start
    return [Token("mark", ";", at, at), Token("word", "on", at, at), Token("word", "the", at, at)]
