"""Dimensions of building parts, metres, that the structure of every floor uses."""

from typing import Final

__all__ = [
    "APPROACH_DEPTH",
    "CLEAR_WIDTH",
    "DOOR_GAP",
    "DOOR_HEIGHT",
    "EXTERIOR_THICKNESS",
    "GARAGE_DOOR_HEIGHT",
    "INTERIOR_THICKNESS",
    "JAMB",
    "MIN_CLEAR_WIDTH",
    "NIB",
    "PARAPET_HEIGHT",
    "SLAB_THICKNESS",
    "WALL_END",
]

INTERIOR_THICKNESS: Final = 0.12
EXTERIOR_THICKNESS: Final = 0.24
SLAB_THICKNESS: Final = 0.25
PARAPET_HEIGHT: Final = 1.1

DOOR_HEIGHT: Final = 2.1
GARAGE_DOOR_HEIGHT: Final = 2.2
CLEAR_WIDTH: Final = 0.9
"""What every door should leave clear."""
MIN_CLEAR_WIDTH: Final = 0.7
"""What a door may shrink to, as a recorded downgrade, before its wall counts as too short."""

JAMB: Final = 0.09
"""Between a door's clear opening and the nearest wall face or opening."""
WALL_END: Final = INTERIOR_THICKNESS / 2 + JAMB
"""Between a clear opening and the centre line of a wall that meets its wall."""
DOOR_GAP: Final = 0.12
"""Between two openings of one wall line."""
APPROACH_DEPTH: Final = 0.9
"""Floor that a door needs free in front of it."""
NIB: Final = 0.3
"""Wall that stays at both ends where a structural wall stands open."""
