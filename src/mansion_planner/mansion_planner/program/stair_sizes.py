"""How high storeys are, and how large the stairs are that they need."""

from collections.abc import Sequence
from typing import Final

from mansion_planner.program.decisions import Decisions
from mansion_planner.program.model import PUBLIC_STAIR, Storey

__all__ = ["stair_size", "storey_height"]

_SLAB: Final = 0.25
"""Metres of a storey's height that the slab takes; the rest is the clear height."""

_HEIGHTS: Final = (2.65, 4.2)
"""Least and greatest height of a storey that stairs of one flight pair reach, metres."""

_DOMESTIC_STAIRS: Final = ((3.0, (2, 4)), (_HEIGHTS[1], (2, 5)))
"""Greatest storey height of a home, and width and length of a core with two flights of 0.88 m, metres."""


def storey_height(decisions: Decisions, storey: Storey) -> float:
    """Return the height of a storey: for the ceilings that the brief wants there, or as is usual for its use."""
    kinds = {room.kind.name for top in storey.rooms for room in top.each()}
    wished = [fact.height for fact in decisions.facts.heights if not fact.room_type or fact.room_type in kinds]
    if wished:
        return round(min(max(max(wished) + _SLAB, _HEIGHTS[0]), _HEIGHTS[1]), 3)
    return min(max(storey.use.height, 3.0), _HEIGHTS[1])


def stair_size(decisions: Decisions, storeys: Sequence[Storey]) -> tuple[int, int]:
    """Return the width and length of a stair core in whole metres: a home for one household has a small one.

    Storeys need not have their rooms yet, so ceilings that are asked for in some rooms count everywhere.
    """
    if any(storey.use.family != "home" for storey in storeys):
        return PUBLIC_STAIR
    wished = [fact.height + _SLAB for fact in decisions.facts.heights]
    height = min(max([storey_height(decisions, storey) for storey in storeys] + wished), _HEIGHTS[1])
    return next(size for most, size in _DOMESTIC_STAIRS if height <= most)
