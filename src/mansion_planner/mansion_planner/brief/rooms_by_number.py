"""Tell apart rooms that a brief gives a number each: "three halls with 120, 80 and 60 seats"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["in_digits", "rooms_by_number"]

_HOLDING = frozenset({"with", "for", "of", "seating", "holding", "("})
_HELD = frozenset(
    """
    seat place people person desk workplace workstation bed cover child pupil student guest visitor chair table cot
    patient spectator computer
    """.split()
)
_STALLS = frozenset({"bay", "stall", "box", "berth", "dock", "kennel", "cage", "pen", "stable", "ramp"})
"""Rooms and places each of which holds one of what it is for."""
_KEPT = frozenset(
    """
    car engine vehicle truck lorry van bus ambulance bike motorcycle boat horse pony cow dog cat animal tractor
    """.split()
)
_FEWEST = 2
_MOST = 8


_NUMBERED = frozenset("bedroom bathroom room office classroom studio lab ward hall flat apartment shop".split())
"""Rooms that are told apart by numbers in words: "bedroom one"."""


def in_digits(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the numbers of rooms in digits: "bedroom one 16 m2" is bedroom 1."""
    result = list(tokens)
    for index, token in enumerate(tokens[1:], 1):
        before, after = tokens[index - 1], tokens[index + 1 : index + 2]
        named = before.text in _NUMBERED and not before.plural and token.kind == "number" and token.text.isalpha()
        ends = not after or after[0].kind == "number" or after[0].text in (",", ":", "(", "-", "of", ".", "and")
        if named and ends and token.value == int(token.value) and not token.soft:
            result[index] = replace(token, text=str(int(token.value)))
    return result


def rooms_by_number(tokens: list[Token]) -> list[Token]:
    """Return the tokens with each of such rooms told by itself.

    "Three halls with 120, 80 and 60 seats" becomes "hall 1 with 120 seats, hall 2 with 80 seats and ...", and "bays
    for three engines" becomes "three bays for three engines".
    """
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        found = _shared_out(tokens, index)
        if found is None:
            result += _counted_stalls(tokens, index)
            index += 1
            continue
        told, index = found
        result += told
    return result


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""


def _shared_out(tokens: list[Token], index: int) -> tuple[list[Token], int] | None:
    """Return the rooms of a list with a number each, and the token after it, where one begins at a token."""
    many = tokens[index]
    if many.kind != "number" or not _FEWEST <= many.value <= _MOST:
        return None
    noun = index + 1
    while noun < index + 4 and noun < len(tokens) and tokens[noun].kind == "word" and not tokens[noun].plural:
        noun += 1
    if noun >= len(tokens) or tokens[noun].kind != "word" or not tokens[noun].plural:
        return None
    at = noun + 1
    bracket = _text(tokens, at) == "("
    if _text(tokens, at) not in _HOLDING:
        return None
    lead = tokens[at]
    at += 1 + (bracket and _text(tokens, at + 1) in ("with", "for"))
    numbers: list[Token] = []
    while at < len(tokens) and tokens[at].kind == "number":
        numbers.append(tokens[at])
        at += 1
        while _text(tokens, at) in (",", "and", "&", "/", "+"):
            at += 1
    held = at < len(tokens) and _text(tokens, at) in _HELD
    if not held or len(numbers) != int(many.value) or len(numbers) < _FEWEST:
        return None
    after = at + 1 + (bracket and _text(tokens, at + 1) == ")")
    return _each(tokens[index + 1 : noun + 1], lead, numbers, tokens[at]), after


def _each(nouns: list[Token], lead: Token, numbers: list[Token], held: Token) -> list[Token]:
    """Return "hall 1 with 120 seats, hall 2 with 80 seats and hall 3 with 60 seats"."""
    result: list[Token] = []
    join = {"(": "with", "seating": "for", "holding": "with"}.get(lead.text, lead.text)
    for position, number in enumerate(numbers):
        first, end = (nouns[0].start, nouns[-1].end) if not position else (number.start, number.end)
        if position:
            text = "and" if position == len(numbers) - 1 else ","
            result.append(Token("word" if text == "and" else "mark", text, number.start, number.start))
        result += [replace(noun, start=first, end=end, plural=False) for noun in nouns]
        result.append(Token("number", str(position + 1), first, end, position + 1.0))
        last = held.end if position == len(numbers) - 1 else number.end
        result += [
            Token("word", join, number.start, number.end),
            replace(number, spaced=True),
            replace(held, start=number.start, end=last),
        ]
    return result


def _counted_stalls(tokens: list[Token], index: int) -> list[Token]:
    """Return a token, with a number before it where it names stalls for so many: "bays for three engines"."""
    token, number = tokens[index], index + 2
    stalls = token.text in _STALLS and token.plural and _text(tokens, index + 1) == "for" and number < len(tokens)
    before = tokens[index - 1] if index else None
    counted = before is not None and (before.kind == "number" or before.text in ("the", "these", "all"))
    if not stalls or counted or tokens[number].kind != "number" or _text(tokens, number + 1) not in _KEPT:
        return [token]
    return [replace(tokens[number], start=token.start, end=token.start), token]
