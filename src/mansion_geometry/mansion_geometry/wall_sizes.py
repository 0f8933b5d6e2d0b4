"""Thickness of walls and clear width of doors, metres, that plans are read and built with."""

from typing import Final

__all__ = ["CLEAR_WIDTH", "EXTERIOR_THICKNESS", "INTERIOR_THICKNESS", "MIN_CLEAR_WIDTH"]

INTERIOR_THICKNESS: Final = 0.12
EXTERIOR_THICKNESS: Final = 0.24

CLEAR_WIDTH: Final = 0.9
"""Clear width that every door should have."""
MIN_CLEAR_WIDTH: Final = 0.7
"""Least clear width of a door, recorded as a downgrade; a wall that takes no such door is too short for one."""
