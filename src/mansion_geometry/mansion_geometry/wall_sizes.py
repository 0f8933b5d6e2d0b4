"""Thickness and least length of walls, and clear width of doors, metres, that plans are read and built with."""

from typing import Final

__all__ = [
    "ACCESS_WALL",
    "ADJACENT_WALL",
    "CLEAR_WIDTH",
    "DOORWAY_DEPTH",
    "DOOR_HEAD",
    "EXTERIOR_THICKNESS",
    "INTERIOR_THICKNESS",
    "MIN_CLEAR_WIDTH",
    "SHARED_SPACE_DEPTH",
    "SHARED_SPACE_WIDTH",
    "SHORTEST_WINDOW",
    "doorway_depth",
]

INTERIOR_THICKNESS: Final = 0.12
EXTERIOR_THICKNESS: Final = 0.24

CLEAR_WIDTH: Final = 0.9
"""Clear width that every door should have."""
MIN_CLEAR_WIDTH: Final = 0.7
"""Least clear width of a door, recorded as a downgrade; a wall that takes no such door is too short for one."""

DOORWAY_DEPTH: Final = 0.6
"""Depth of the floor on either side of a door that furniture leaves clear."""
SHARED_SPACE_WIDTH: Final = 2.5
"""Width from which an opening without a leaf joins two rooms into one space, where one passes anywhere."""
SHARED_SPACE_DEPTH: Final = 0.2
"""Depth of the floor on either side of such an opening that furniture leaves clear."""
DOOR_HEAD: Final = 1.9
"""Height above which what hangs is in no door's way."""

ACCESS_WALL: Final = 1.2
"""Shortest straight wall between two rooms of a building that a door joins."""
ADJACENT_WALL: Final = 0.3
"""Shortest wall that makes two rooms neighbours."""

SHORTEST_WINDOW: Final = 0.2
"""Width below which what is left of a window is left out."""


def doorway_depth(width: float, *, is_open: bool) -> float:
    """Return the depth of the floor on either side of a door or an opening that furniture leaves clear, metres.

    Parameters
    ----------
    width : float
        Metres.
    is_open : bool
        It has no leaf, so that two rooms are one space through it where it is wide.

    Examples
    --------
    >>> doorway_depth(4.0, is_open=True), doorway_depth(1.2, is_open=True), doorway_depth(5.0, is_open=False)
    (0.2, 0.6, 0.6)
    """
    return SHARED_SPACE_DEPTH if is_open and width >= SHARED_SPACE_WIDTH else DOORWAY_DEPTH
