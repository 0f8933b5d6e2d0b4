"""Give the noun to what is named without it: "12 doubles per floor", "an office, open-plan, with a lobby"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["shortened_nouns"]

_BEDS = frozenset({"double", "single", "twin", "triple"})
_LODGINGS = frozenset(
    "hotel hostel dorm dormitory inn guesthouse lodge residence motel pension coliving resort guest student".split()
)
"""Words of a brief that is about rooms to sleep in."""
_OFFICES = frozenset("office headquarter headquarters workspace workstation coworking desk startup agency".split())
"""Words of a brief that is about places to work."""
_ENDS = frozenset({"", ",", ".", ";", ":", ")", "\n", "with", "and", "or", "per", "on", "in", "each", "plus"})

_HAIR = frozenset("hair hairdresser hairdressing barber barbershop salon".split())
"""Words of a brief that is about a hairdresser's."""


def shortened_nouns(tokens: list[Token]) -> list[Token]:
    """Return the tokens with rooms where "doubles" are counted, offices where "open-plan" ends, and "w/" as "with".

    The stations of a hairdresser are styling chairs.
    """
    texts = {token.text for token in tokens}
    result: list[Token] = []
    for index, token in enumerate(tokens):
        before, after = _text(tokens, index - 1), _text(tokens, index + 1)
        if token.text == "/" and before == "with" and not token.spaced:
            continue
        result.append(token)
        if after not in _ENDS:
            continue
        counted = index > 0 and tokens[index - 1].kind == "number"
        if token.text in _BEDS and token.plural and counted and not _LODGINGS.isdisjoint(texts):
            result[-1] = replace(token, plural=False)
            result.append(Token("word", "room", token.end, token.end, plural=True))
        elif token.text == "station" and counted and not _HAIR.isdisjoint(texts):
            result[-1:] = [Token("word", "styling", token.start, token.start), replace(token, text="chair")]
        elif (before, token.text) == ("open", "plan") and not _OFFICES.isdisjoint(texts):
            result.append(Token("word", "office", token.end, token.end))
    return result


def _text(tokens: list[Token], index: int) -> str:
    return tokens[index].text if 0 <= index < len(tokens) else ""
