"""Bring the number of people whom a room holds into one form: "where 64 people eat" and "that seats 20" are "for"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["seated_people"]

_PLACES = (("where",), ("in", "which"), ("at", "which"))
_ABOUT = frozenset({"up", "to", "about", "around", "some", "at", "least", "max", "roughly", "all", "the"})
_CAN = frozenset(
    {"can", "could", "may", "will", "should", "must", "be", "are", "is", "to", "all", "comfortably", "easily"}
)
_SITTING = frozenset(
    "sit seated eat dine lunch gather meet fit worship pray watch listen stand assemble celebrate eats sits".split()
)
_SEATING = frozenset(
    {"seat", "sit", "hold", "fit", "take", "accommodate", "seating", "fitting", "accommodating", "holding"}
)
_TOGETHER = (
    ("at", "once"),
    ("at", "a", "time"),
    ("at", "the", "same", "time"),
    ("together",),
    ("down",),
    ("comfortably",),
)
_GROUPS = frozenset(
    """
    people person guest visitor diner customer student pupil child kid adult worker employee staff resident member
    spectator listener viewer worshipper passenger delegate us cover pax
    """.split()
)
"""Nouns for those who sit, eat or meet in a room."""
_LEADS = frozenset({"to", "that", "which", "can", "should", "must", "will"})
_FEWEST = 3


def seated_people(tokens: list[Token]) -> list[Token]:
    """Return the tokens with "a dining hall where 64 people eat" and "a hall that seats 64" as "... for 64 people"."""
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        found = None
        if index and tokens[index - 1].kind == "word":
            found = _clause(tokens, index) or _verb(tokens, index)
        if found is None:
            result.append(tokens[index])
            index += 1
            continue
        number, end = found
        first = tokens[index]
        many = replace(tokens[number], end=max(tokens[number].end, tokens[end - 1].end))
        people = Token("word", "people", many.end, many.end, plural=True)
        result += [replace(first, kind="word", text="for", plural=False, end=first.start), many, people]
        index = end
    return result


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _number(tokens: list[Token], at: int) -> int:
    """Return where the number of people stands at a token, words such as "up to" aside; -1 for none."""
    while _text(tokens, at) in _ABOUT:
        at += 1
    counts = at < len(tokens) and tokens[at].kind == "number" and tokens[at].value >= _FEWEST
    return at if counts and tokens[at].value == int(tokens[at].value) else -1


def _after_people(tokens: list[Token], at: int) -> int:
    at += _text(tokens, at) == "of"
    return at + (_text(tokens, at) in _GROUPS)


def _together(tokens: list[Token], at: int) -> int:
    for words in _TOGETHER:
        if tuple(token.text for token in tokens[at : at + len(words)]) == words:
            return at + len(words)
    return at


def _clause(tokens: list[Token], index: int) -> tuple[int, int] | None:
    """Return the number and the end of "where 64 people eat", "in which up to twenty can sit", "where we seat 30"."""
    lead = next((len(p) for p in _PLACES if tuple(t.text for t in tokens[index : index + len(p)]) == p), 0)
    if not lead:
        return None
    number = _number(tokens, index + lead)
    if number >= 0:
        at = _after_people(tokens, number + 1)
        while _text(tokens, at) in _CAN:
            at += 1
        return (number, _together(tokens, at + 1)) if _text(tokens, at) in _SITTING else None
    at = index + lead + (_text(tokens, index + lead) in ("we", "they", "you", "one"))
    at += _text(tokens, at) in _CAN
    number = _number(tokens, at + 1) if _text(tokens, at) in _SEATING and at > index + lead else -1
    return (number, _together(tokens, _after_people(tokens, number + 1))) if number >= 0 else None


def _verb(tokens: list[Token], index: int) -> tuple[int, int] | None:
    """Return the number and the end of "that seats 20", "big enough to seat 20 people", "seating forty"."""
    seats = _text(tokens, index) == "with" and _text(tokens, index + 1) in ("seat", "seating", "place", "cover")
    if seats and _text(tokens, index + 2) == "for":
        number = _number(tokens, index + 3)
        return (number, _after_people(tokens, number + 1)) if number >= 0 else None
    at = index
    while _text(tokens, at) in _LEADS | {"big", "large", "enough", ","} and at - index < 4:
        at += 1
    if _text(tokens, at) not in _SEATING:
        return None
    alone = at == index and _text(tokens, at) not in ("seating", "fitting", "accommodating")
    number = _number(tokens, at + 1)
    if alone or number < 0:
        return None
    end = _after_people(tokens, number + 1)
    people = end > number + 1
    sitting = _text(tokens, at) in ("seat", "seating", "sit")
    closes = _text(tokens, end) in (",", ".", ";", ")", "and", "\n", "", "with", "in", "at", "on")
    return (number, _together(tokens, end)) if people or (sitting and closes) else None
