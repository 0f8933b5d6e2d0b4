"""Tell areas that are bounds: "no more than 60 m2", "keep it under 60 m2", "12 m2 at least"."""

from typing import Literal, TypeAlias

from mansion_planner.brief.reading import Reading

__all__ = ["Limit", "limit_of", "within_bound"]

Limit: TypeAlias = Literal["", "most", "least"]
"""What an area bounds: no more of it, or no less, is wanted."""

_BEFORE: dict[tuple[str, ...], Limit] = {
    ("more", "than"): "least",
    ("larger", "than"): "least",
    ("bigger", "than"): "least",
    ("greater", "than"): "least",
    ("over",): "least",
    ("above",): "least",
    ("at", "least"): "least",
    ("minimum",): "least",
    ("min",): "least",
    ("upwards", "of"): "least",
    ("less", "than"): "most",
    ("smaller", "than"): "most",
    ("fewer", "than"): "most",
    ("under",): "most",
    ("below",): "most",
    ("within",): "most",
    ("up", "to"): "most",
    ("at", "most"): "most",
    ("at", "the", "most"): "most",
    ("maximum",): "most",
    ("max",): "most",
    ("exceed",): "least",
    ("pass",): "least",
    ("surpass",): "least",
    ("go", "over"): "least",
    ("go", "beyond"): "least",
    ("go", "above"): "least",
    ("exceeding",): "least",
    ("limited", "to"): "most",
    ("capped", "at"): "most",
}
"""Words right before an area; a negation before them turns them round."""
_AFTER: dict[tuple[str, ...], Limit] = {
    ("or", "less"): "most",
    ("or", "smaller"): "most",
    ("at", "most"): "most",
    ("maximum",): "most",
    ("max",): "most",
    ("tops",): "most",
    ("or", "more"): "least",
    ("or", "larger"): "least",
    ("or", "bigger"): "least",
    ("at", "least"): "least",
    ("minimum",): "least",
    ("min",): "least",
}
_BETWEEN = frozenset("of a an the total area size about floor be".split())
_NEGATIONS = frozenset({"no", "not", "never"})
_MARGIN = 0.08
"""Share by which a room is planned within its bound, so that the walls that are found for it keep to it."""


def limit_of(reading: Reading, first: int, last: int) -> Limit:
    """Return what the area of tokens `first` to `last` (exclusive) bounds; empty where it is the area that is wanted.

    The words that say so are taken.
    """
    index = first
    while first - index < 4 and (reading.word(index - 1) in _BETWEEN or _abbreviates(reading, index - 1)):
        index -= 1
    for end in dict.fromkeys((first, index)):
        for words, limit in _BEFORE.items():
            begin = end - len(words)
            if begin < 0 or reading.words(begin, end) != words:
                continue
            negation = next((i for i in (begin - 1, begin - 2) if reading.word(i) in _NEGATIONS), begin)
            reading.take(negation, end)
            return _turned(limit) if negation < begin else limit
    last += reading.word(last) in ("each", "apiece", ",", "(", "total", "overall", "altogether")
    for words, limit in _AFTER.items():
        if reading.words(last, last + len(words)) == words:
            reading.take(last, last + len(words))
            return limit
    return ""


def _abbreviates(reading: Reading, index: int) -> bool:
    return reading.word(index) == "." and not reading.breaks(index)


def _turned(limit: Limit) -> Limit:
    return "most" if limit == "least" else "least"


def within_bound(area: float, limit: Limit) -> float:
    """Return the area that a room is planned with to keep to a bound.

    Examples
    --------
    >>> within_bound(20.0, "least") > 20.0, within_bound(20.0, "most") < 20.0, within_bound(20.0, "")
    (True, True, 20.0)
    """
    return area * {"most": 1.0 - _MARGIN, "least": 1.0 + _MARGIN, "": 1.0}[limit]
