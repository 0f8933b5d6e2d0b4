"""Which of two things in a row ``left`` and ``right`` mean: the left bedside table, the right sink."""

import math
from collections.abc import Sequence
from typing import Final

from mansion_editing.instructions.phrases.runs import SIDES
from mansion_msgs_py.scene import SceneObject

__all__ = ["told_by_side"]

_OF_WHO_RESTS: Final = ("bed", "sofa", "loveseat", "chair", "stool", "bench", "pouf", "side_table", "nightstand")
"""Ends of the categories whose left is that of who sits or lies there; of others it is that of who stands before."""
_SAME_WAY: Final = 5.0
"""Degrees by which the fronts of two things in a row differ at most."""
_APART: Final = 0.1
"""Metres by which one is further to a side at least."""


def told_by_side(items: Sequence[SceneObject], hints: Sequence[str]) -> list[SceneObject]:
    """Return the one of two things of a room that ``left`` or ``right`` tells; all where none of these words is there.

    Things that look different ways, or more than two, have no left one: all are returned.
    """
    side = next((hint for hint in hints if hint in SIDES), "")
    if not side or len(items) != 2 or items[0].room != items[1].room:
        return list(items)
    one, other = items
    turned = abs((one.rotation - other.rotation + 180.0) % 360.0 - 180.0)
    angle = math.radians(one.rotation)
    across = [item.position[0] * math.cos(angle) + item.position[1] * math.sin(angle) for item in items]
    if turned > _SAME_WAY or abs(across[0] - across[1]) < _APART:
        return list(items)
    seen_from_it = one.category.endswith(_OF_WHO_RESTS)
    first = (across[0] < across[1]) == ((side == "left") == seen_from_it)
    return [one if first else other]
