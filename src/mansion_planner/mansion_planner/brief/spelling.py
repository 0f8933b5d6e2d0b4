"""Correct misspelt words to the planner's vocabulary, by one edit (two in long words)."""

from dataclasses import replace
from functools import cache

from mansion_knowledge.words import common_words
from mansion_language import Token, singular
from mansion_language.numbers import ORDINALS

__all__ = ["GRAMMAR", "corrected"]

GRAMMAR = frozenset(
    [
        "floor",
        "storey",
        "story",
        "level",
        "building",
        "with",
        "without",
        "the",
        "and",
        "for",
        "that",
        "has",
        "have",
        "including",
        "containing",
        "each",
        "every",
        "per",
        "ground",
        "basement",
        "top",
        "upper",
        "lower",
        "square",
        "metre",
        "meter",
        "foot",
        "feet",
        "total",
        "area",
        "room",
        "about",
        "around",
        "people",
        "person",
        "family",
        "next",
        "adjacent",
        "beside",
        "between",
        "above",
        "below",
        "identical",
        "same",
        "elevator",
        "lift",
        "stair",
        "staircase",
        "shaped",
        "courtyard",
        "terrace",
        "setback",
        "material",
        "wooden",
        "style",
        "pupil",
        "student",
        "employee",
        "guest",
        "patient",
        "bed",
        "resident",
        "worker",
        "staff",
        "outline",
        "rectangular",
        "house",
        "home",
        "high",
        "rise",
        "tower",
        "apartment",
        "penthouse",
        "roof",
        "rooftop",
        "underground",
        "contain",
        "include",
        "footprint",
        "typical",
    ]
)


_SHORT = {
    "rm": "room", "bedrm": "bedroom", "bdrm": "bedroom", "bathrm": "bathroom", "apt": "apartment", "flr": "floor",
    "bldg": "building", "bsmt": "basement", "mtg": "meeting", "ofc": "office", "kit": "kitchen",
}  # fmt: skip
"""Short forms in notes, and what they stand for."""


def corrected(tokens: list[Token], words: frozenset[str], known: frozenset[str] = frozenset()) -> list[Token]:
    """Return the tokens with misspelt words replaced by the vocabulary's nearest word.

    Parameters
    ----------
    tokens : list of Token
    words : frozenset of str
        The lexicon's words, in singular.
    known : frozenset of str
        Further words in the singular that are no mistakes.
    """
    found: dict[str, str] = {}
    result: list[Token] = []
    for token in tokens:
        if token.text == "kit" and result and result[-1].text in ("drum", "aid", "tool", "repair", "first"):
            result.append(token)
        elif token.text in _SHORT:
            result.append(replace(token, text=_SHORT[token.text]))
            continue
        if token.kind != "word" or len(token.text) < 4 or len(token.text) > 20:
            result.append(token)
            continue
        if token.text not in found:
            held = singular(token.text) in known
            found[token.text] = token.text if held else _nearest(token.text, words)
        text = found[token.text]
        if text == token.text:
            result.append(token)
        elif text in ORDINALS:
            value = float(ORDINALS[text])
            result.append(replace(token, kind="ordinal", text=text, value=value))
        else:
            result.append(replace(token, text=text))
    return result


@cache
def _index(words: frozenset[str]) -> dict[str, list[str]]:
    """Vocabulary words by each form that they take with one letter left out."""
    index: dict[str, list[str]] = {}
    for word in sorted(words | GRAMMAR | set(ORDINALS)):
        if len(word) >= 4:
            for form in _deletions(word):
                index.setdefault(form, []).append(word)
    return index


def _deletions(word: str) -> list[str]:
    return [word, *sorted({word[:i] + word[i + 1 :] for i in range(len(word))})]


def _nearest(word: str, words: frozenset[str]) -> str:
    if word in words or word in GRAMMAR or word in common_words() or singular(word) in words:
        return word
    if word[0] == "f" and "ph" + word[1:] in words:
        return "ph" + word[1:]
    index = _index(words)
    limit = 2 if len(word) >= 8 else 1
    best, best_distance = word, limit + 1
    forms = _deletions(word)
    if limit == 2:
        forms = [*forms, *(form for one in forms[1:] for form in _deletions(one)[1:])]
    for form in forms:
        for candidate in index.get(form, ()):
            if candidate[0] != word[0] or abs(len(candidate) - len(word)) > limit:
                continue
            if len(word) < 5 and candidate not in GRAMMAR:
                continue
            distance = _edit_distance(word, candidate, limit)
            if (distance, candidate not in GRAMMAR, candidate) < (best_distance, best not in GRAMMAR, best):
                best, best_distance = candidate, distance
    return best


def _edit_distance(a: str, b: str, limit: int) -> int:
    """Edits between two words, a swap of neighbours counting one; `limit` + 1 when there are more."""
    before: list[int] = []
    row = list(range(len(b) + 1))
    for i, left in enumerate(a, 1):
        before, last, row = row, before, [i]
        for j, right in enumerate(b, 1):
            cost = min(before[j] + 1, row[j - 1] + 1, before[j - 1] + (left != right))
            if i > 1 and j > 1 and left == b[j - 2] and a[i - 2] == right:
                cost = min(cost, last[j - 2] + 1)
            row.append(cost)
        if min(row) > limit:
            return limit + 1
    return row[-1]
