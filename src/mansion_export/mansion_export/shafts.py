"""Where a core's shaft lies and which way its door faces."""

from dataclasses import dataclass

import numpy as np

from mansion_msgs_py.scene import FloorScene, SceneCore

__all__ = ["Shaft", "shaft_of"]


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
