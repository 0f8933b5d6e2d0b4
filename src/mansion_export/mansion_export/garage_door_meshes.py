"""Garage doors: slats that fill the opening when it is closed, and their roll above it."""

from mansion_export.appearance import named
from mansion_export.model import Surface
from mansion_export.solids import Box
from mansion_export.solids3d import boxes_surface
from mansion_msgs_py.scene import Door

__all__ = ["garage_slats"]

SLAT = 0.44
"""Height of a slat, metres."""

GROOVE = 0.012
THICKNESS = 0.05
ROLL = 0.26
"""Height of the roll of an open door, metres."""


def garage_slats(width: float, height: float, door: Door) -> list[Surface]:
    """Return the door's surfaces, its lower left corner at the origin, x along the opening.

    Parameters
    ----------
    width, height : float
        Of the opening inside its frame, metres.
    door : Door
        Open or closed; an open one is a roll below the head of the opening.
    """
    if door.is_open:
        roll = Box((width / 2, 0.0, height - ROLL / 2), (width, 4 * THICKNESS, ROLL))
        return [boxes_surface([roll], named("brushed_steel"))]
    count = max(1, round(height / SLAT))
    step = height / count
    slats = [Box((width / 2, 0.0, (i + 0.5) * step), (width, THICKNESS, step - GROOVE)) for i in range(count)]
    core = Box((width / 2, 0.0, height / 2), (width, THICKNESS - 2 * GROOVE, height))
    grip = [Box((width / 2, side * (THICKNESS / 2 + 0.015), 0.7 * step), (0.22, 0.03, 0.03)) for side in (-1, 1)]
    return [boxes_surface(slats, named("signal_white")), boxes_surface([core, *grip], named("painted_steel"))]
