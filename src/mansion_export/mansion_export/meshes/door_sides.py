"""Which way doors face: the side of a wall that a leaf opens to, and the side of a shaft that its door is on."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from mansion_geometry.plane import inside_ring
from mansion_msgs_py.scene import Door, FloorScene, SceneCore
from mansion_msgs_py.shapes import Point

__all__ = ["Shaft", "shaft_of", "side_of", "swing_side"]

PROBE = 0.25
"""Metres from the wall's centre line at which a side is asked which room it belongs to."""


def side_of(door: Door, ring: Sequence[Point]) -> int:
    """Return 1 where the ring lies to the left of the door's segment, -1 to the right, 0 neither."""
    (ax, ay), (bx, by) = door.segment
    length = float(np.hypot(bx - ax, by - ay)) or 1.0
    nx, ny = -(by - ay) / length, (bx - ax) / length
    mx, my = (ax + bx) / 2, (ay + by) / 2
    for side in (1, -1):
        if inside_ring(ring, mx + side * PROBE * nx, my + side * PROBE * ny):
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


@dataclass(frozen=True, slots=True)
class Shaft:
    """An upright rectangle in a frame whose y axis points out of the shaft through its door.

    Attributes
    ----------
    x, y : float
        Centre, metres.
    rotation : float
        Degrees counter-clockwise from the plan's axes: a multiple of 90.
    width, depth : float
        Along the door's wall and away from it.
    """

    x: float
    y: float
    rotation: float
    width: float
    depth: float


def shaft_of(core: SceneCore, scene: FloorScene) -> Shaft:
    """Return the bounding rectangle of a core's polygon, seen from its door on this floor."""
    points = np.asarray(core.polygon, dtype=float)
    (x0, y0), (x1, y1) = points.min(0), points.max(0)
    cx, cy = float((x0 + x1) / 2), float((y0 + y1) / 2)
    door = next((door for door in scene.doors if door.id == core.door), None)
    ex, ey = core.entrance[0], core.entrance[1]
    if door is not None:
        (ax, ay), (bx, by) = door.segment
        ex, ey = (ax + bx) / 2, (ay + by) / 2
    right, up = (ex - cx) / max(x1 - x0, 1e-6), (ey - cy) / max(y1 - y0, 1e-6)
    if abs(right) > abs(up):
        return Shaft(cx, cy, -90.0 if right > 0 else 90.0, float(y1 - y0), float(x1 - x0))
    return Shaft(cx, cy, 0.0 if up >= 0 else 180.0, float(x1 - x0), float(y1 - y0))
