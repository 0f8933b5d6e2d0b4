"""Bring rooms that are told one by one after their number into a list: "2 bedrooms - master 17 m2, guest 12 m2"."""

from dataclasses import replace

from mansion_language import Token
from mansion_language.units import AREA

__all__ = ["labelled_rooms"]

_MARKS = frozenset({"-", "–", ":", "("})
_JOINTS = frozenset({",", "and", "&", ";", "plus"})
_LONGEST = 2
"""Words of a label, at most."""


def labelled_rooms(tokens: list[Token]) -> list[Token]:
    """Return the tokens with every such group as "master bedroom 17 m2, guest bedroom 12 m2".

    A group has as many labels with an area as its number says; none of them is told with a noun of its own.
    """
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        group = _group(tokens, index)
        if group is None:
            result.append(tokens[index])
            index += 1
        else:
            made, index = group
            result += made
    return result


def _group(tokens: list[Token], index: int) -> tuple[list[Token], int] | None:
    """Return the list that stands for the group that opens at a token, and where the group ends."""
    if tokens[index].kind != "number" or not 2 <= tokens[index].value <= 9 or index + 3 >= len(tokens):
        return None
    noun, mark = tokens[index + 1], tokens[index + 2]
    if noun.kind != "word" or not noun.plural or noun.text in ("room", "floor", "storey") or mark.text not in _MARKS:
        return None
    made: list[Token] = []
    at, labels = index + 3, 0
    while labels < tokens[index].value:
        others = _others_end(tokens, at) if labels else None
        if others is not None:
            made += _others(tokens, at, others, noun, int(tokens[index].value) - labels)
            at, labels = others + 2, int(tokens[index].value)
            break
        end = _label_end(tokens, at)
        if end is None:
            return None
        head = replace(noun, plural=False, start=tokens[end - 1].end, end=tokens[end - 1].end)
        made += [replace(tokens[at], spaced=True), *tokens[at + 1 : end], head, *tokens[end : end + 2]]
        at, labels = end + 2, labels + 1
        joints = at
        while joints < len(tokens) and tokens[joints].text in _JOINTS:
            joints += 1
        if labels < tokens[index].value:
            made += tokens[at:joints]
            at = joints
    closed = mark.text == "(" and at < len(tokens) and tokens[at].text == ")"
    return made, at + closed


_OTHERS = frozenset({"other", "rest", "remaining", "further"})


def _others_end(tokens: list[Token], index: int) -> int | None:
    """Return where "the other two" ends before an area; none where it does not stand there."""
    end = index
    while end < len(tokens) and end - index < _LONGEST + 1 and tokens[end].kind != "unit":
        number = tokens[end].kind == "number"
        if end + 1 < len(tokens) and number and tokens[end + 1].text in AREA:
            break
        if not (number or tokens[end].text in _OTHERS | {"the"}):
            return None
        end += 1
    said = {token.text for token in tokens[index:end]}
    measured = end + 1 < len(tokens) and tokens[end].kind == "number" and tokens[end + 1].text in AREA
    return end if measured and said & _OTHERS else None


def _others(tokens: list[Token], first: int, end: int, noun: Token, many: int) -> list[Token]:
    """Return so many rooms with the area that follows "the other two"."""
    start, last = tokens[first].start, tokens[end - 1].end
    number = Token("number", str(many), start, last, float(many))
    rooms = replace(noun, plural=many > 1, start=last, end=last)
    each = Token("word", "each", tokens[end + 1].end, tokens[end + 1].end)
    return [number, rooms, Token("word", "of", last, last), *tokens[end : end + 2], each]


def _label_end(tokens: list[Token], index: int) -> int | None:
    """Return where a label of one or two words ends that an area follows; none where no such label stands there."""
    end = index
    while end < len(tokens) and tokens[end].kind == "word" and end - index < _LONGEST:
        end += 1
    measured = end + 1 < len(tokens) and tokens[end].kind == "number" and tokens[end + 1].text in AREA
    return end if end > index and measured else None
