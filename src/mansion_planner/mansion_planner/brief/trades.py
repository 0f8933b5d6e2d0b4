"""Read what the writer of a brief makes, mends or sells, which tells what a building without a name is for."""

from mansion_planner.brief.phrase import FUNCTION_WORDS
from mansion_planner.brief.reading import Reading

__all__ = ["read_trade"]

_TRADES = {
    "make": "factory", "build": "factory", "produce": "factory", "manufacture": "factory", "craft": "factory",
    "weave": "factory", "restore": "factory", "sell": "shop_building", "repair": "shop_building",
    "fix": "shop_building", "renovate": "", "install": "", "fit": "",
}  # fmt: skip
"""The kind of building that a trade needs, by its verb; empty for one that is done elsewhere."""

_TRADERS = frozenset({"i", "we", "who"})
_NO_GOODS = (FUNCTION_WORDS - {"fitted"}) | _TRADES.keys()


def read_trade(reading: Reading) -> None:
    """Record the building that the writer's trade needs: "I make fitted kitchens", "we repair and sell bicycles".

    The last of several verbs tells most: who repairs and sells has a shop.
    """
    for index in range(len(reading.tokens)):
        if reading.words(index, index + 3) == ("for", "a", "living"):
            reading.take(index, index + 3)
        if reading.word(index) in _TRADERS and _trade_at(reading, index + 1):
            verb = _trade_at(reading, index + 1)
            kind = _TRADES[reading.word(verb)]
            end = verb + 1
            while reading.kind(end) == "word" and reading.word(end) not in _NO_GOODS:
                end += 1
            if end > verb + 1 and reading.plural(end - 1):
                reading.facts.trades += [(kind, reading.span(index, end))] if kind else []
                reading.take(index + 1, end)


def _trade_at(reading: Reading, index: int) -> int:
    """Return the last verb of a trade that stands at a token: of "repair and sell"; or 0."""
    if reading.word(index) not in _TRADES:
        return 0
    joined = reading.word(index + 1) in ("and", "or") and reading.word(index + 2) in _TRADES
    return index + 2 if joined else index
