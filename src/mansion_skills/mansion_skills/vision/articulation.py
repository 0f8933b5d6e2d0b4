"""Parts that open: leaves of doors, and the doors, lids and drawers of furniture."""

from collections.abc import Callable
from dataclasses import dataclass
from math import atan2, cos, degrees, hypot, radians, sin

import numpy as np
import numpy.typing as npt

from mansion_geometry.building_models import ASIDE, JAMB, OPEN_ANGLE
from mansion_geometry.doorways import LEAFLESS
from mansion_msgs_py.scene import Door, SceneObject

__all__ = ["Hinge", "Leaf", "Triangles", "hinges_of", "leaves_of", "part_of", "read_stl"]

PROBE = 0.25
"""Metres from the door at which a side is asked which room it belongs to."""

Triangles = npt.NDArray[np.float64]
"""Shape (n, 3, 3), metres."""

LIDDED = ("box", "lunch_box", "toolbox", "kettle", "chest", "waste_bin", "bin", "laundry_basket")
"""Categories that open at the top."""

RIGID = ("book", "laptop", "umbrella", "curtain", "blinds")
"""Categories whose meshes look the same open and closed."""

DRAWERS = ("filing_cabinet", "cash_register", "nightstand", "dresser")
"""Categories whose fronts are pulled out."""

FRONT, LID = 0.12, 0.25
"""How deep a front is at most, metres; how much of its height a lid takes at most."""

SWING = 105.0
"""Degrees by which an open leaf stands off."""

DOUBLE = 0.7
"""Metres of width from which there are two leaves."""

WHOLE = 0.6
"""From this part of the width on, a piece is one leaf across both halves."""

WELD = 1e-5

_STL = np.dtype([("normal", "<f4", 3), ("corners", "<f4", (3, 3)), ("attribute", "<u2")])


@dataclass(frozen=True)
class Leaf:
    """A leaf as its body shows it; x, y in metres, yaw in degrees.

    Attributes
    ----------
    name : str
        Name of its body.
    """

    name: str
    x: float
    y: float
    yaw: float


def leaves_of(door: Door, opening: float, room_at: Callable[[float, float], str | None]) -> list[Leaf]:
    """Return where the leaves of a door are.

    Parameters
    ----------
    opening : float
        How far it stands open, 0 to 1.
    room_at : callable
        The room at a point; tells on which side the room lies into which the leaf opens.
    """
    if door.kind in LEAFLESS:
        return []
    (ax, ay), (bx, by) = door.segment
    length = hypot(bx - ax, by - ay) or 1.0
    ux, uy = (bx - ax) / length, (by - ay) / length
    rotation = degrees(atan2(uy, ux))
    if door.kind == "garage":
        return [Leaf(f"{door.id}/leaf", ax + ux * JAMB, ay + uy * JAMB, rotation)]
    if door.kind == "sliding" or door.hinge == "none":
        width = length / 2 - JAMB
        starts = (JAMB - ASIDE * width * opening, length / 2 + ASIDE * width * opening)
        return [
            Leaf(f"{door.id}/leaf_{i}", ax + ux * at, ay + uy * at, rotation) for i, at in enumerate(starts, start=1)
        ]
    both = door.hinge == "both" or door.kind == "double"
    angle = OPEN_ANGLE * opening * _side(door, room_at)
    ends = (False, True) if both else (door.hinge == "end",)
    found = []
    for i, at_end in enumerate(ends, start=1):
        along = length - JAMB if at_end else JAMB
        yaw = rotation + (180.0 - angle if at_end else angle)
        name = f"{door.id}/leaf_{i}" if both else f"{door.id}/leaf"
        found.append(Leaf(name, ax + ux * along, ay + uy * along, yaw))
    return found


def _side(door: Door, room_at: Callable[[float, float], str | None]) -> int:
    """Return 1 where the leaf opens to the left of the door's segment, -1 to the right."""
    (ax, ay), (bx, by) = door.segment
    turn = radians(90.0) + atan2(by - ay, bx - ax)
    dx, dy = PROBE * cos(turn), PROBE * sin(turn)
    left = room_at((ax + bx) / 2 + dx, (ay + by) / 2 + dy)
    right = room_at((ax + bx) / 2 - dx, (ay + by) / 2 - dy)
    for name in (door.swing, door.rooms[0]):
        if name is not None and name in (left, right):
            return 1 if name == left else -1
    return -1 if door.rooms[1] is not None and door.rooms[1] == left else 1


@dataclass(frozen=True)
class Hinge:
    """How the cut part moves when its object opens, in the object's frame.

    Attributes
    ----------
    pivot : (x, y, z)
        What it turns about, metres.
    axis : (x, y, z)
    angle : float
        Degrees.
    slide : (x, y, z)
        How it is moved instead, metres.
    """

    pivot: tuple[float, float, float]
    axis: tuple[float, float, float] = (0.0, 0.0, 1.0)
    angle: float = 0.0
    slide: tuple[float, float, float] = (0.0, 0.0, 0.0)


def hinges_of(kind: SceneObject) -> tuple[Hinge, ...]:
    """Return how the parts of an openable object move: none, one, or the left and the right leaf of a wide one."""
    w, d, h = kind.size
    if not kind.openable or kind.category in RIGID:
        return ()
    if kind.category in LIDDED:
        return (Hinge((0.0, -d / 2, h / 2), (1.0, 0.0, 0.0), 100.0),)
    if kind.category in DRAWERS:
        return (Hinge((0.0, 0.0, 0.0), slide=(0.0, min(0.35, 0.6 * d), 0.0)),)
    left = Hinge((-w / 2, d / 2 - 0.02, 0.0), angle=SWING)
    right = Hinge((w / 2, d / 2 - 0.02, 0.0), angle=-SWING)
    return (left, right) if w > DOUBLE else (left,)


def read_stl(data: bytes) -> Triangles:
    """Return the triangles of a binary STL file."""
    count = int.from_bytes(data[80:84], "little")
    corners = np.frombuffer(data, _STL, count, offset=84)["corners"]
    return corners.astype(np.float64)


def _pieces(triangles: Triangles) -> npt.NDArray[np.int64]:
    """Return the number of the connected piece that each triangle belongs to."""
    keys = np.round(triangles.reshape(-1, 3) / WELD).astype(np.int64)
    _, vertex = np.unique(keys, axis=0, return_inverse=True)
    corner = vertex.reshape(-1, 3)
    label = np.arange(int(vertex.max()) + 1 if len(vertex) else 0)
    while True:
        lowest: npt.NDArray[np.int64] = label[corner].min(axis=1)
        after = label.copy()
        np.minimum.at(after, corner.ravel(), np.repeat(lowest, 3))
        if np.array_equal(after, label):
            return lowest
        label = after


def part_of(triangles: Triangles, kind: SceneObject) -> npt.NDArray[np.int64]:
    """Return which of `hinges_of` moves each triangle, or -1 for what stays: whole pieces move.

    Parameters
    ----------
    triangles : (n, 3, 3) array
        All of the object, in its frame, the origin the centre of its box: front at +y.
    kind : SceneObject
    """
    part = np.full(len(triangles), -1)
    hinges = hinges_of(kind)
    if not hinges or not len(triangles):
        return part
    _, d, h = kind.size
    axis, least = (1, d / 2 - min(FRONT, 0.3 * d))
    if kind.category in LIDDED:
        axis, least = (2, h / 2 - LID * h)
    piece = _pieces(triangles)
    lowest = np.full(int(piece.max()) + 1, np.inf)
    np.minimum.at(lowest, piece, triangles[:, :, axis].min(axis=1))
    moves = lowest[piece] >= least - WELD
    part[moves] = 0
    if len(hinges) == 2:
        left, right = np.full(len(lowest), np.inf), np.full(len(lowest), -np.inf)
        np.minimum.at(left, piece, triangles[:, :, 0].min(axis=1))
        np.maximum.at(right, piece, triangles[:, :, 0].max(axis=1))
        # A leaf as wide as the furniture takes all with it; else each half has its own.
        if not (moves & (right[piece] - left[piece] > WHOLE * kind.size[0])).any():
            part[moves & (left[piece] + right[piece] > 0.0)] = 1
    return part
