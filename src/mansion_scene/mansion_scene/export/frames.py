"""Coordinates of other programs, converted here and nowhere else.

Ours: x right, y up in the plan, z up, right-handed, rotations counter-clockwise from above (REP-103).

AI2-THOR (Unity): x right, y up, z forward, left-handed. Plan y becomes z, so a plan seen from above looks the same in
both, but turns run clockwise: a heading changes its sign. glTF: right-handed, y up; plan y becomes -z.
"""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.shapes import Point

__all__ = [
    "gltf_points",
    "gltf_quaternion",
    "thor_heading",
    "thor_point",
    "thor_ring",
    "thor_rotation",
]


def thor_point(x: float, y: float, z: float) -> dict[str, float]:
    """Return a plan point in AI2-THOR's axes, to a tenth of a millimetre."""
    return {"x": round(x, 4), "y": round(z, 4), "z": round(y, 4)}


def thor_ring(ring: Sequence[Point]) -> list[dict[str, float]]:
    """Return a counter-clockwise ring as AI2-THOR's clockwise floor polygon."""
    return [thor_point(x, y, 0.0) for x, y in reversed(ring)]


def thor_rotation(rotation: float) -> dict[str, float]:
    """Return an object's rotation (front +y at 0, counter-clockwise) as AI2-THOR's Euler angles.

    AI2-THOR's assets face +z at 0 and turn clockwise seen from above.
    """
    return {"x": 0, "y": round(-rotation % 360.0, 3) % 360.0, "z": 0}


def thor_heading(yaw: float) -> float:
    """Return a heading counted from +x counter-clockwise as AI2-THOR's, from +z clockwise."""
    return round((90.0 - yaw) % 360.0, 3) % 360.0


def gltf_points(points: npt.ArrayLike) -> npt.NDArray[np.float32]:
    """Return z-up points or directions of shape (n, 3) in glTF's y-up axes."""
    array = np.asarray(points, dtype=np.float32).reshape(-1, 3)
    return np.ascontiguousarray(np.stack([array[:, 0], array[:, 2], -array[:, 1]], axis=1))


def gltf_quaternion(rotation: float) -> list[float]:
    """Return a rotation about the vertical (degrees counter-clockwise) as glTF's (x, y, z, w)."""
    half = np.radians(rotation) / 2.0
    return [0.0, round(float(np.sin(half)), 7), 0.0, round(float(np.cos(half)), 7)]
