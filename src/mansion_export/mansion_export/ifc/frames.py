"""Where the elements of an IFC file stand: frames that turn about the vertical axis, one inside another."""

import math
from dataclasses import dataclass

import numpy as np

from mansion_export.meshes.model import Node
from mansion_geometry.compiled import Floats
from mansion_msgs_py.shapes import Point

__all__ = ["FLOOR", "Frame"]


@dataclass(frozen=True, slots=True)
class Frame:
    """A frame on a floor: metres, and degrees counter-clockwise about z."""

    x: float = 0.0
    y: float = 0.0
    z: float = 0.0
    rotation: float = 0.0

    @classmethod
    def along(cls, start: Point, end: Point) -> "Frame":
        """Return the frame at `start` whose x axis points to `end`."""
        return cls(start[0], start[1], 0.0, math.degrees(math.atan2(end[1] - start[1], end[0] - start[0])))

    @property
    def axis(self) -> tuple[float, float]:
        """Direction of its x axis."""
        angle = math.radians(self.rotation)
        return math.cos(angle), math.sin(angle)

    def inside(self, x: float, y: float, z: float) -> "Frame":
        """Return the frame of equal direction at a point of this one, on the floor."""
        c, s = self.axis
        return Frame(self.x + c * x - s * y, self.y + s * x + c * y, self.z + z, self.rotation)

    def vertices(self, node: Node, vertices: Floats) -> Floats:
        """Return the vertices of a node's mesh in this frame, (n, 3)."""
        placed = vertices * np.array(node.scale)
        placed = _turned(placed, node.rotation) + np.array(node.position) - np.array([self.x, self.y, self.z])
        return _turned(placed, -self.rotation)


FLOOR = Frame()
"""The frame of the floor itself."""


def _turned(points: Floats, degrees: float) -> Floats:
    if degrees % 360.0 == 0.0:
        return points
    c, s = math.cos(math.radians(degrees)), math.sin(math.radians(degrees))
    return np.stack([points[:, 0] * c - points[:, 1] * s, points[:, 0] * s + points[:, 1] * c, points[:, 2]], axis=1)
