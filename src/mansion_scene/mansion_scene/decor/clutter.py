"""The amount of clutter in a room: fewer small objects where it is to be tidy, more where it is to be crammed."""

from collections.abc import Sequence

from msgspec.structs import replace

from mansion_assets.catalogue.records import Arrangement, Scatter, Slot
from mansion_msgs_py.program import Clutter

__all__ = ["with_clutter"]

_FACTORS = {"sparse": 0.35, "dense": 2.5}
"""How many times as many scattered objects as usual there are."""


def with_clutter(arrangements: Sequence[Arrangement], clutter: Clutter) -> list[Arrangement]:
    """Return arrangements of small objects that lay out fewer or more than usual.

    Place settings stay as they are: a laid table is no clutter.

    Examples
    --------
    >>> shelf = Arrangement(name="shelf", on=["bookcase"], scatter=[Scatter(category="book", min=2, max=4, p=0.5)])
    >>> [(s.min, s.max, s.p) for s in with_clutter([shelf], "dense")[0].scatter]
    [(5, 10, 0.875)]
    >>> [(s.min, s.max, s.p) for s in with_clutter([shelf], "sparse")[0].scatter]
    [(1, 1, 0.25)]
    """
    return [
        replace(
            arrangement,
            p=_likelihood(arrangement.p, clutter),
            slots=[_slot(slot, clutter) for slot in arrangement.slots],
            scatter=[_scatter(scatter, clutter) for scatter in arrangement.scatter],
        )
        for arrangement in arrangements
    ]


def _slot(slot: Slot, clutter: Clutter) -> Slot:
    """Return a slot as it is filled; what is there always, as a screen on its desk, stays."""
    return slot if slot.p >= 1.0 else replace(slot, p=_likelihood(slot.p, clutter))


def _scatter(scatter: Scatter, clutter: Clutter) -> Scatter:
    factor = _FACTORS[clutter]
    least, most = (round(factor * number) for number in (scatter.min, scatter.max))
    return replace(scatter, min=least, max=max(most, 1), p=_likelihood(scatter.p, clutter))


def _likelihood(p: float, clutter: Clutter) -> float:
    """Return how likely something is laid out: half as likely as usual, or in one of three attempts."""
    return 1.0 - (1.0 - p) ** 3 if clutter == "dense" else p / 2
