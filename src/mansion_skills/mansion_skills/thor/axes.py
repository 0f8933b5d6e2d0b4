"""AI2-THOR's coordinates: x right, y up, z forward, left-handed, angles clockwise from above.

A plan's y is AI2-THOR's z. A heading counts from +z, ours from +x; an object's rotation counts from facing +z, ours
from facing +y, which is the same direction.
"""

from collections.abc import Mapping
from typing import Any

from mansion_msgs_py.shapes import Point3

__all__ = ["from_point", "heading", "rotation", "thor_euler", "thor_heading", "thor_point"]


def thor_point(x: float, y: float, z: float) -> dict[str, float]:
    """Return a point of a floor in AI2-THOR's axes, to a tenth of a millimetre."""
    return {"x": round(x, 4), "y": round(z, 4), "z": round(y, 4)}


def from_point(point: Mapping[str, Any]) -> Point3:
    """Return AI2-THOR's point in the floor's frame, to a tenth of a millimetre."""
    return round(float(point["x"]), 4), round(float(point["z"]), 4), round(float(point["y"]), 4)


def thor_heading(yaw: float) -> float:
    """Return a heading counted from +x counter-clockwise as AI2-THOR's, from +z clockwise; degrees."""
    return round((90.0 - yaw) % 360.0, 3) % 360.0


def heading(degrees: float) -> float:
    """Return AI2-THOR's heading as ours, degrees."""
    return round((90.0 - degrees) % 360.0, 3) % 360.0


def thor_euler(degrees: float) -> dict[str, float]:
    """Return an object's rotation as AI2-THOR's Euler angles."""
    return {"x": 0.0, "y": round(-degrees % 360.0, 3) % 360.0, "z": 0.0}


def rotation(degrees: float) -> float:
    """Return AI2-THOR's rotation about the vertical as ours, degrees."""
    return round(-degrees % 360.0, 3) % 360.0
