"""Where the leaves of a door are when it is open, closed, or half way."""

from collections.abc import Callable
from dataclasses import dataclass
from math import atan2, cos, degrees, hypot, radians, sin

from mansion_msgs_py.scene import Door
from mansion_skills.navigation.floor_map import LEAFLESS

__all__ = ["Leaf", "leaves_of"]

OPEN_ANGLE = 86.0
"""Degrees by which an open leaf stands off its frame, as in the building's models."""

JAMB = 0.04
"""Metres of the frame on either side."""

ASIDE = 0.92
"""How far an open sliding panel has moved, in its widths."""

PROBE = 0.25
"""Metres from the door at which a side is asked which room it belongs to."""


@dataclass(frozen=True)
class Leaf:
    """A leaf as its body shows it; x, y in metres, yaw in degrees.

    Attributes
    ----------
    name : str
        Of its body.
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
