"""Tell garages that are the whole building: "a garage for four cars", "garage for repairing cars, six lifts"."""

from dataclasses import replace

from mansion_language import Token

__all__ = ["garages"]

_REPAIRS = frozenset(
    "repair repairs repairing repaired mechanic mechanics workshop servicing service tyre tire bodywork".split()
)
_PARKED = frozenset({"car", "vehicle", "truck", "bus", "van", "motorbike", "motorcycle", "space", "bay", "place"})
_HOLDING = frozenset({"for", "with", "of"})
_LIFTS = frozenset({"lift", "hoist", "ramp"})
_BEFORE = frozenset(
    {"a", "an", "the", "our", "new", "small", "large", "big", "public", "car", "i", "we", "need", "want"}
)


def garages(tokens: list[Token], buildings: frozenset[str]) -> list[Token]:
    """Return the tokens with such a garage as a parking or repair garage.

    Parameters
    ----------
    buildings : frozenset of str
        Words that end the names of kinds of buildings; where the brief has one beside the garage, that is the building.
    """
    texts = [token.text for token in tokens]
    first = next((at for at, text in enumerate(texts) if text == "garage"), -1)
    if first < 0 or not set(texts[:first]) <= _BEFORE or texts.count("garage") > 1:
        return tokens
    if any(text in buildings - _REPAIRS for text in texts[:first] + texts[first + 1 :]):
        return tokens
    repaired = not _REPAIRS.isdisjoint(texts)
    after = texts[first + 1 : first + 6]
    parked = after[:1] and after[0] in _HOLDING and not _PARKED.isdisjoint(after)
    if not (repaired or parked):
        return tokens
    kind = "repair" if repaired else "parking"
    result: list[Token] = []
    for at, token in enumerate(tokens):
        if at == first:
            result.append(replace(token, text=kind, plural=False, end=token.start))
        elif repaired and token.text in _LIFTS and token.plural and at and tokens[at - 1].kind == "number":
            result.append(replace(token, text="car", plural=False, end=token.start))
        result.append(token)
    return result
