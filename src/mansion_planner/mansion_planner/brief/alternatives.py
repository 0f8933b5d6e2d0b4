"""Choose where a brief leaves the choice: of "either three bedrooms and a study or four bedrooms" the first."""

from mansion_language import Token

__all__ = ["chosen"]

_ENDS = frozenset({".", ";", "\n", "!", "?", ")"})
_CLOSERS = _ENDS | {",", "-", "–", "(", ":", "but"}
_WHERE = frozenset({"in", "on", "at", "upstairs", "downstairs", "upstair", "downstair"})
"""Words that lead to where both of them would be."""
_REACH = 16
"""Tokens between "either" and "or", and of what is left out, at most."""


def chosen(tokens: list[Token]) -> list[Token]:
    """Return the tokens with the first of what may be built one way or the other.

    "Three or four bedrooms" is a range, of which another part of the reader makes a number.
    """
    result: list[Token] = []
    index = 0
    while index < len(tokens):
        bracket = _bracketed(tokens, index)
        if bracket:
            index = bracket
            continue
        found = _alternatives(tokens, index) if tokens[index].text == "either" else None
        if found is None:
            result.append(tokens[index])
            index += 1
            continue
        joint, last = found
        result += tokens[index + 1 : joint]
        index = last
    return result


def _bracketed(tokens: list[Token], index: int) -> int:
    """Return where "(either five or six, five is enough)" ends after something that has a number; else 0."""
    if tokens[index].text != "(" or [token.text for token in tokens[index + 1 : index + 2]] != ["either"]:
        return 0
    numbers = index + 4 < len(tokens) and tokens[index + 2].kind == tokens[index + 4].kind == "number"
    end = next((at for at in range(index, min(index + _REACH, len(tokens))) if tokens[at].text == ")"), 0)
    counted = any(token.kind == "number" for token in tokens[max(index - 3, 0) : index])
    return end + 1 if numbers and counted and end and tokens[index + 3].text == "or" else 0


def _alternatives(tokens: list[Token], index: int) -> tuple[int, int] | None:
    """Return where "or" stands after "either", and where what it leads to ends; nothing for a range of numbers."""
    joint = index + 1
    while joint < len(tokens) and tokens[joint].text != "or":
        if tokens[joint].text in _ENDS or joint - index > _REACH:
            return None
        joint += 1
    words = [token for token in tokens[index + 1 : joint] if token.kind == "word" and token.text not in ("a", "an")]
    last = joint + 1
    while last < len(tokens) and tokens[last].text not in _CLOSERS | _WHERE and last - joint <= _REACH:
        last += 1
    led = tokens[index - 1].text in ("on", "in", "at", "to") if index else False
    return (joint, last) if words and joint < len(tokens) and last > joint + 1 and not led else None
