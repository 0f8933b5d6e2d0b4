"""Give the master bedroom its bathroom: "two bathrooms, one of them en suite to the master"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["masters_bathroom"]

_BATHS = frozenset({"bathroom", "bath", "shower"})
_OWNERS = frozenset({"master", "main", "principal", "primary", "parent", "parental", "owner"})
_ATTACHED = frozenset(
    "en suite ensuite attached adjoining adjacent connected opening off next to private is being for from of".split()
)
_NAMING = frozenset({"en", "ensuite", "attached", "adjoining", "adjacent", "connected", "off", "private", "next"})
_LONGEST = 9


def masters_bathroom(tokens: list[Token]) -> list[Token]:
    """Return the tokens with one of several bathrooms as that of the master bedroom.

    "Two bathrooms, one of them en suite to the master" becomes "one bathroom, the master bedroom with an en-suite
    bathroom".
    """
    for index in range(len(tokens) - 6):
        many = tokens[index]
        if many.kind != "number" or many.value < 2 or tokens[index + 1].text not in _BATHS:
            continue
        first = index + 2
        opens = tokens[first].text in (",", "(", "-", "–", ":") and tokens[first + 1].text == "one"
        found = _attached(tokens, first + 2) if opens else None
        if found is None:
            continue
        end, closes = found
        fewer = replace(many, text=str(int(many.value) - 1), value=many.value - 1)
        return [
            *tokens[:index],
            fewer,
            tokens[index + 1],
            *_suite(tokens[first], tokens[end - 1]),
            *tokens[end + closes :],
        ]
    return tokens


def _attached(tokens: list[Token], index: int) -> tuple[int, bool] | None:
    """Return where "of them en suite to the master bedroom" ends, and whether a bracket closes there."""
    at = index
    if tokens[at].text == "of" and at + 1 < len(tokens) and tokens[at + 1].text in ("them", "which", "these"):
        at += 2
    begin = at
    while at < len(tokens) and tokens[at].text in _ATTACHED and at - begin < _LONGEST:
        at += 1
    said = {token.text for token in tokens[begin:at]}
    at += at < len(tokens) and tokens[at].text in ("the", "our")
    if not said & _NAMING or at >= len(tokens) or tokens[at].text not in _OWNERS:
        return None
    at += 1
    at += at < len(tokens) and tokens[at].text in ("bedroom", "suite", "room")
    return at, at < len(tokens) and tokens[at].text == ")"


def _suite(mark: Token, last: Token) -> list[Token]:
    """Return the tokens of ", the master bedroom with an en-suite bathroom" in the place of others."""
    start = mark.end

    def word(text: str) -> Token:
        return Token("word", text, start, last.end)

    comma = Token("mark", ",", mark.start, mark.start)
    return [comma, *(word(text) for text in ("the", "master", "bedroom", "with", "an", "ensuite", "bathroom"))]
