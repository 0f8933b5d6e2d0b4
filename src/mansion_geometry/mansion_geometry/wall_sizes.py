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
    "SHORTEST_WINDOW",
]

INTERIOR_THICKNESS: Final = 0.12
EXTERIOR_THICKNESS: Final = 0.24

CLEAR_WIDTH: Final = 0.9
"""Clear width that every door should have."""
MIN_CLEAR_WIDTH: Final = 0.7
"""Least clear width of a door, recorded as a downgrade; a wall that takes no such door is too short for one."""

DOORWAY_DEPTH: Final = 0.6
"""Depth of the floor on either side of a door that furniture leaves clear."""
DOOR_HEAD: Final = 1.9
"""Height above which what hangs is in no door's way."""

ACCESS_WALL: Final = 1.2
"""Shortest straight wall between two rooms of a building that a door joins."""
ADJACENT_WALL: Final = 0.3
"""Shortest wall that makes two rooms neighbours."""

SHORTEST_WINDOW: Final = 0.2
"""Width below which what is left of a window is left out."""
