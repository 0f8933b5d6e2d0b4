"""Write out rooms told apart after their number: "2 bedrooms - master, guest", "changing rooms: two for home teams"."""

from dataclasses import replace

from mansion_language import Token
from mansion_language.units import AREA

__all__ = ["kinds_of_rooms", "labelled_rooms"]

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


_LEADS = frozenset({"for", "with", "of"})
_SEPARATORS = frozenset({",", "and", ";"})
_NO_NOUNS = frozenset(
    "a an the need want have has get with and or of for are be we i you our my their these those following".split()
)
_LONGEST_KIND = 8
"""Tokens of one of the kinds, at most."""


def kinds_of_rooms(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the noun before a colon repeated behind the number of each kind."""
    tokens = _with_second_nouns(tokens)
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        counts = _counts(tokens, index)
        if len(counts) < 2:
            result.append(tokens[index])
            index += 1
            continue
        noun = tokens[index - 2 : index] if _is_noun(tokens, index - 2) else tokens[index - 1 : index]
        del result[-len(noun) :]
        for at in range(index + 1, counts[-1] + 1):
            result.append(tokens[at])
            if at in counts:
                several = tokens[at].value != 1
                result += [replace(token, start=tokens[at].end, end=tokens[at].end) for token in noun[:-1]]
                result.append(replace(noun[-1], start=tokens[at].end, end=tokens[at].end, plural=several))
        index = counts[-1] + 1
    return result


def _with_second_nouns(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the noun of "one meeting room for 8 and one for 4" told twice."""
    result: list[Token] = []
    skipped = 0
    for index, token in enumerate(tokens):
        if index < skipped:
            continue
        result.append(token)
        if one_more := _one_more(tokens, index):
            result += [replace(noun, start=token.end, end=token.end, plural=False) for noun in one_more]
            result += tokens[index + 1 : index + 3]
            skipped = index + 3 + (3 if _sized_otherwise(tokens, index + 3) else 0)
            continue
        joined = index and tokens[index - 1].text in ("and", ",", "plus") and token.text in ("one", "another")
        if not joined or not _is_for_many(tokens, index + 1):
            continue
        for last in range(index - 1, max(index - _LONGEST_KIND, 1), -1):
            if _is_for_many(tokens, last) and _is_noun(tokens, last - 1) and not tokens[last - 1].plural:
                first = last - 2 if _is_noun(tokens, last - 2) else last - 1
                result += [replace(noun, start=token.end, end=token.end) for noun in tokens[first:last]]
                break
    return result


_BIGGER = frozenset("bigger larger smaller big large small".split())


def _one_more(tokens: list[Token], index: int) -> list[Token]:
    """Return the noun of the counted rooms that "+ 1 for drums" adds one to; empty where nothing is added."""
    lead = tokens[index - 1].text if index else ""
    one = tokens[index].kind == "number" and tokens[index].value == 1 and lead in ("+", "plus")
    purpose = tokens[index + 1 : index + 3]
    if not one or [token.kind for token in purpose] != ["word", "word"] or purpose[0].text != "for":
        return []
    for last in range(index - 2, max(index - 12, 0), -1):
        if tokens[last].text in (".", ";", "\n"):
            return []
        counted = next((at for at in range(last - 1, max(last - 4, -1), -1) if tokens[at].kind == "number"), None)
        if tokens[last].kind == "word" and tokens[last].plural and counted is not None:
            return tokens[counted + 1 : last + 1]
    return []


def _sized_otherwise(tokens: list[Token], index: int) -> bool:
    """Whether ", bigger" stands at a token before an area."""
    texts = [token.text for token in tokens[index : index + 3]]
    return len(texts) == 3 and texts[0] == "," and texts[1] in _BIGGER and texts[2] == ","


def _is_for_many(tokens: list[Token], index: int) -> bool:
    """Whether "for 8" stands at a token."""
    return index + 1 < len(tokens) and tokens[index].text == "for" and tokens[index + 1].kind == "number"


def _is_noun(tokens: list[Token], index: int) -> bool:
    return index >= 0 and tokens[index].kind == "word" and tokens[index].text not in _NO_NOUNS


def _counts(tokens: list[Token], index: int) -> list[int]:
    """Return the numbers that share out what stands in the plural before a colon at a token."""
    if tokens[index].text != ":" or not _is_noun(tokens, index - 1) or not tokens[index - 1].plural:
        return []
    found: list[int] = []
    at = index + 1
    while at + 1 < len(tokens) and tokens[at].kind == "number" and tokens[at + 1].text in _LEADS:
        found.append(at)
        end = at + 2
        while end < len(tokens) and end - at < _LONGEST_KIND and tokens[end].text not in _SEPARATORS:
            if tokens[end].kind != "word":
                return found
            end += 1
        at = end + 1 + (end + 1 < len(tokens) and tokens[end + 1].text == "and")
    return found
