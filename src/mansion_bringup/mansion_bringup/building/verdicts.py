"""A verdict on a wish: met, partly met or not met, with the reason in words."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import Final, TypeAlias

from mansion_bringup.building.judged_building import JudgedBuilding
from mansion_msgs_py.wishes import Wish, WishStatus

__all__ = ["BOUNDS", "Judge", "Verdict", "comma_separated", "keeps_to", "met_if"]


@dataclass(frozen=True)
class Verdict:
    """What becomes of a wish, why, and the ids of the rooms and objects that it is about."""

    status: WishStatus
    reason: str = ""
    rooms: Sequence[str] = ()
    objects: Sequence[str] = ()


Judge: TypeAlias = Callable[[Wish, JudgedBuilding], Verdict]
"""Gives the verdict on a wish for a building."""


def met_if(ok: bool, reason: str, *, partly: bool = False, rooms: Sequence[str] = ()) -> Verdict:
    """Return that a wish is met, or else why it is not, or only in part."""
    return Verdict("met", "", rooms) if ok else Verdict("partly" if partly else "not_met", reason, rooms)


BOUNDS: Final = {"most": "at most ", "least": "at least ", "": ""}
"""What comes before an area in words, by the limit of the wish for it."""


def keeps_to(wish: Wish, area: float) -> bool:
    """Whether an area keeps to a wish's bound, but for a hundredth."""
    wanted = wish.value.area or 0.0
    return area <= 1.01 * wanted if wish.value.limit == "most" else area >= 0.99 * wanted


def comma_separated(values: Sequence[object]) -> str:
    """Return values with commas between them."""
    return ", ".join(str(value) for value in values)
