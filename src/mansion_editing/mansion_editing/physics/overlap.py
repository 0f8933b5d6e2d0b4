"""How deep one box is in another: the separating axis test, after Gottschalk, Lin and Manocha, "OBBTree" (1996)."""

from typing import NamedTuple

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.shapes import Point3

__all__ = ["OrientedBox", "upright", "depth"]

Matrix = npt.NDArray[np.float64]


class OrientedBox(NamedTuple):
    """A box: centre, full extent, and its axes as the columns of a rotation matrix of shape (3, 3)."""

    center: Point3
    size: Point3
    axes: Matrix


def upright(center: Point3, size: Point3, rotation: float) -> OrientedBox:
    """Return a box that is turned about z alone, degrees counter-clockwise."""
    turn = np.radians(rotation)
    c, s = float(np.cos(turn)), float(np.sin(turn))
    return OrientedBox(center, size, np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]]))


def depth(one: OrientedBox, other: OrientedBox) -> float:
    """Return how far one box would have to move to leave the other, metres; 0 where they are apart."""
    axes = [*one.axes.T, *other.axes.T]
    axes += [np.cross(a, b) for a in one.axes.T for b in other.axes.T]
    between = np.array(other.center) - np.array(one.center)
    least = np.inf
    for axis in axes:
        length = float(np.linalg.norm(axis))
        if length < 1e-6:
            continue
        unit = axis / length
        reach = _reach(one, unit) + _reach(other, unit)
        least = min(least, reach - abs(float(between @ unit)))
        if least <= 0.0:
            return 0.0
    return float(least)


def _reach(box: OrientedBox, unit: Matrix) -> float:
    """Half the length of a box's shadow on a line."""
    return float(np.abs(unit @ box.axes) @ np.array(box.size)) / 2
