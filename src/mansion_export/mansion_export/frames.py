"""Coordinates of other programs; AI2-THOR's, which the skills use too, come from `mansion_geometry.thor.axes`.

Ours: x right, y up in the plan, z up, right-handed, rotations counter-clockwise from above (REP-103).

AI2-THOR (Unity): x right, y up, z forward, left-handed. Plan y becomes z, so a plan seen from above looks the same in
both, but turns run clockwise: a heading changes its sign. glTF: right-handed, y up; plan y becomes -z.
"""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from mansion_geometry.thor.axes import thor_euler, thor_heading, thor_point
from mansion_msgs_py.shapes import Point

__all__ = ["gltf_points", "gltf_quaternion", "thor_heading", "thor_point", "thor_ring", "thor_rotation"]


def thor_ring(ring: Sequence[Point]) -> list[dict[str, float]]:
    """Return a counter-clockwise ring as AI2-THOR's clockwise floor polygon."""
    return [thor_point(x, y, 0.0) for x, y in reversed(ring)]


def thor_rotation(rotation: float) -> dict[str, float]:
    """Return an object's rotation (front +y at 0, counter-clockwise) as AI2-THOR's Euler angles.

    AI2-THOR's assets face +z at 0 and turn clockwise seen from above.
    """
    return {"x": 0, "y": thor_euler(rotation)["y"], "z": 0}


def gltf_points(points: npt.ArrayLike) -> npt.NDArray[np.float32]:
    """Return z-up points or directions of shape (n, 3) in glTF's y-up axes."""
    array = np.asarray(points, dtype=np.float32).reshape(-1, 3)
    return np.ascontiguousarray(np.stack([array[:, 0], array[:, 2], -array[:, 1]], axis=1))


def gltf_quaternion(rotation: float) -> list[float]:
    """Return a rotation about the vertical (degrees counter-clockwise) as glTF's (x, y, z, w)."""
    half = np.radians(rotation) / 2.0
    return [0.0, round(float(np.sin(half)), 7), 0.0, round(float(np.cos(half)), 7)]
