"""On which side of a door a room lies."""

from collections.abc import Mapping, Sequence

import numpy as np

from mansion_msgs_py.scene import Door
from mansion_msgs_py.shapes import Point

__all__ = ["contains", "side_of", "swing_side"]

PROBE = 0.25
"""Metres from the wall's centre line at which a side is asked which room it belongs to."""


def contains(ring: Sequence[Point], x: float, y: float) -> bool:
    """Tell whether a point lies in a ring (even-odd rule)."""
    inside = False
    ax, ay = ring[-1]
    for bx, by in ring:
        if (ay > y) != (by > y) and x < (bx - ax) * (y - ay) / (by - ay) + ax:
            inside = not inside
        ax, ay = bx, by
    return inside


def side_of(door: Door, ring: Sequence[Point]) -> int:
    """Return 1 where the ring lies to the left of the door's segment, -1 to the right, 0 neither."""
    (ax, ay), (bx, by) = door.segment
    length = float(np.hypot(bx - ax, by - ay)) or 1.0
    nx, ny = -(by - ay) / length, (bx - ax) / length
    mx, my = (ax + bx) / 2, (ay + by) / 2
    for side in (1, -1):
        if contains(ring, mx + side * PROBE * nx, my + side * PROBE * ny):
            return side
    return 0


def swing_side(door: Door, rings: Mapping[str, Sequence[Point]]) -> int:
    """Return the side (1 left, -1 right of the segment) into which the door's leaf opens.

    Parameters
    ----------
    rings : mapping of str to sequence of Point
        Outer rings of rooms and cores by id. A door without `swing` opens into its first room.
    """
    for name in (door.swing, door.rooms[0]):
        if name is not None and name in rings:
            side = side_of(door, rings[name])
            if side:
                return side
    other = door.rooms[1]
    return -side_of(door, rings[other]) or 1 if other is not None and other in rings else 1
