"""Give each kind its noun where a colon shares rooms out: "changing rooms: two for home teams, one for referees"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["kinds_of_rooms"]

_LEADS = frozenset({"for", "with", "of"})
_SEPARATORS = frozenset({",", "and", ";"})
_NO_NOUNS = frozenset(
    "a an the need want have has get with and or of for are be we i you our my their these those following".split()
)
_LONGEST = 8
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
    for index, token in enumerate(tokens):
        result.append(token)
        joined = index and tokens[index - 1].text in ("and", ",", "plus") and token.text in ("one", "another")
        if not joined or not _is_for_many(tokens, index + 1):
            continue
        for last in range(index - 1, max(index - _LONGEST, 1), -1):
            if _is_for_many(tokens, last) and _is_noun(tokens, last - 1) and not tokens[last - 1].plural:
                first = last - 2 if _is_noun(tokens, last - 2) else last - 1
                result += [replace(noun, start=token.end, end=token.end) for noun in tokens[first:last]]
                break
    return result


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
        while end < len(tokens) and end - at < _LONGEST and tokens[end].text not in _SEPARATORS:
            if tokens[end].kind != "word":
                return found
            end += 1
        at = end + 1 + (end + 1 < len(tokens) and tokens[end + 1].text == "and")
    return found
