"""Conventions of AI2-THOR's house JSON: axes, angles, the agent's height and the tree of objects.

The exporter writes houses and the skills' AI2-THOR engine rearranges them, but the skills import no package that makes
buildings. What both need of the format is therefore here, below both; everything else that is known of it is in
`mansion_export.thor`.

AI2-THOR (Unity) has x right, y up and z forward, left-handed, with angles clockwise from above. A plan's y is
AI2-THOR's z, so a plan looks the same from above in both. A heading counts from +z there and from +x here; an object's
rotation counts from facing +z there and from facing +y here, which is the same direction.
"""

from collections.abc import Iterable, Iterator, Mapping
from math import radians
from typing import Any, Final

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.shapes import Point3

__all__ = [
    "AGENT_HEIGHT",
    "floor_heading",
    "floor_point",
    "floor_rotation",
    "object_nodes",
    "rotation_matrix",
    "thor_euler",
    "thor_heading",
    "thor_point",
    "upright",
]

AGENT_HEIGHT: Final = 0.95
"""Height at which ProcTHOR sets the agent down, metres."""

TENTH_OF_A_MILLIMETRE: Final = 4

_SWAP: Final = np.array([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]])
"""Swaps y and z; its own inverse."""


def thor_point(x: float, y: float, z: float, digits: int = TENTH_OF_A_MILLIMETRE) -> dict[str, float]:
    """Return a point of a floor in AI2-THOR's axes, rounded to some digits of a metre."""
    return {"x": round(x, digits), "y": round(z, digits), "z": round(y, digits)}


def floor_point(point: Mapping[str, Any], digits: int = TENTH_OF_A_MILLIMETRE) -> Point3:
    """Return AI2-THOR's point in the floor's frame, rounded to some digits of a metre."""
    return (round(float(point["x"]), digits), round(float(point["z"]), digits), round(float(point["y"]), digits))


def thor_heading(yaw: float) -> float:
    """Return a heading counted from +x counter-clockwise as AI2-THOR's, from +z clockwise; degrees."""
    return round((90.0 - yaw) % 360.0, 3) % 360.0


def floor_heading(degrees: float) -> float:
    """Return AI2-THOR's heading in the floor's frame, degrees."""
    return round((90.0 - degrees) % 360.0, 3) % 360.0


def thor_euler(degrees: float) -> dict[str, float]:
    """Return an object's rotation as AI2-THOR's Euler angles, degrees."""
    return upright(round(-degrees % 360.0, 3) % 360.0)


def upright(degrees: float) -> dict[str, float]:
    """Return AI2-THOR's Euler angles of what is turned about the vertical alone, degrees."""
    return {"x": 0, "y": degrees, "z": 0}


def floor_rotation(degrees: float) -> float:
    """Return AI2-THOR's rotation of an object about the vertical in the floor's frame, degrees."""
    return round(-degrees % 360.0, 3) % 360.0


def rotation_matrix(euler: Mapping[str, Any]) -> npt.NDArray[np.float64]:
    """Return AI2-THOR's Euler angles as a rotation matrix in the floor's frame, shape (3, 3).

    Notes
    -----
    Unity turns about z first, then x, then y, each by the usual matrix though its axes are left-handed; the swap of
    two axes on both sides makes a right-handed rotation of it.
    """
    x, y, z = (radians(float(euler[axis])) for axis in "xyz")
    about_x = np.array([[1, 0, 0], [0, np.cos(x), -np.sin(x)], [0, np.sin(x), np.cos(x)]])
    about_y = np.array([[np.cos(y), 0, np.sin(y)], [0, 1, 0], [-np.sin(y), 0, np.cos(y)]])
    about_z = np.array([[np.cos(z), -np.sin(z), 0], [np.sin(z), np.cos(z), 0], [0, 0, 1]])
    turned: npt.NDArray[np.float64] = _SWAP @ about_y @ about_x @ about_z @ _SWAP
    return turned


def object_nodes(nodes: Iterable[dict[str, Any]]) -> Iterator[dict[str, Any]]:
    """Yield all objects of a house, each before those on and in it.

    Parameters
    ----------
    nodes : iterable of dict
        A house's ``objects``, or the ``children`` of one of them.
    """
    for node in nodes:
        yield node
        yield from object_nodes(node.get("children") or [])
