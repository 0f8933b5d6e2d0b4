"""Dimensions of building parts, metres, that the structure of every floor uses."""

from typing import Final

from mansion_geometry.wall_sizes import CLEAR_WIDTH, EXTERIOR_THICKNESS, INTERIOR_THICKNESS, MIN_CLEAR_WIDTH

__all__ = [
    "APPROACH_DEPTH",
    "BAY_DOOR_HEIGHT",
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

SLAB_THICKNESS: Final = 0.25
PARAPET_HEIGHT: Final = 1.1

DOOR_HEIGHT: Final = 2.1
GARAGE_DOOR_HEIGHT: Final = 2.2
BAY_DOOR_HEIGHT: Final = 3.6

JAMB: Final = 0.09
"""Distance between a door's clear opening and the nearest wall face or opening."""
WALL_END: Final = INTERIOR_THICKNESS / 2 + JAMB
"""Distance between a clear opening and the centre line of a wall that meets its wall."""
DOOR_GAP: Final = 0.12
"""Distance between two openings of one wall line."""
APPROACH_DEPTH: Final = 0.9
"""Depth of the free floor that a door needs in front of it."""
NIB: Final = 0.3
"""Length of wall that stays at both ends of an opened structural wall."""
