"""Portal culling: which rooms a camera can see through open doors and glass, clipped in plan.

D. Luebke and C. Georges, Portals and mirrors: simple, fast evaluation of potentially visible sets, 1995.
"""

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from math import atan2, cos, hypot, pi, radians, sin

from mansion_msgs_py.scene import Door, FloorScene
from mansion_msgs_py.shapes import Point, Segment

__all__ = ["SEE_THROUGH", "Portals", "Wedge"]

SEE_THROUGH = ("open", "doorway", "frame", "glazed", "entrance", "balcony")
"""Kinds of doors that never hide what is behind."""

DEPTH = 8
"""Doors in a row through which the camera looks."""

NEAR = 0.35
"""Metres to a portal within which all of the view counts as going through it."""

MARGIN = 0.1
"""Added to both ends of a portal, metres: walls have a thickness, and leaves stand out."""

EPSILON = 1e-3


@dataclass(frozen=True)
class Wedge:
    """Directions from the camera, radians from its heading, left is positive; `low` < `high`."""

    low: float
    high: float

    def clipped(self, other: "Wedge") -> "Wedge | None":
        """Return what both have in common."""
        low, high = max(self.low, other.low), min(self.high, other.high)
        return Wedge(low, high) if high > low else None

    def joined(self, other: "Wedge") -> "Wedge":
        """Return the smallest wedge that holds both."""
        return Wedge(min(self.low, other.low), max(self.high, other.high))

    def holds(self, other: "Wedge") -> bool:
        """Whether another wedge lies inside this one."""
        return self.low <= other.low and other.high <= self.high


class Portals:
    """The openings of a floor by the rooms that they join.

    Parameters
    ----------
    scene : FloorScene
    """

    def __init__(self, scene: FloorScene) -> None:
        self._by_room: dict[str, list[tuple[Door, str]]] = {}
        for door in scene.doors:
            first, second = door.rooms
            if second is None:
                continue
            self._by_room.setdefault(first, []).append((door, second))
            self._by_room.setdefault(second, []).append((door, first))

    def visible(
        self, room: str, place: Point, heading: float, wedge: Wedge, closed: Iterable[str]
    ) -> Mapping[str, Wedge]:
        """Return the rooms and cores that the camera can see, each with the wedge in which it lies.

        Too many rooms may be returned, never too few: walls inside of a room hide nothing here.

        Parameters
        ----------
        room : str
            Where the camera is.
        place : Point
        heading : float
            Degrees counter-clockwise from +x.
        wedge : Wedge
            Horizontal extent of the picture.
        closed : iterable of str
            Ids of doors that hide what is behind.
        """
        shut = set(closed)
        found: dict[str, Wedge] = {room: wedge}
        axis = (cos(radians(heading)), sin(radians(heading)))
        waiting = [(room, wedge, 0)]
        while waiting:
            here, view, depth = waiting.pop(0)
            for door, beyond in self._by_room.get(here, ()):
                if door.id in shut or beyond == room:
                    continue
                opening = _opening(door.segment, place, axis)
                through = view.clipped(opening) if opening is not None else None
                known = found.get(beyond)
                if through is None or (known is not None and known.holds(through)):
                    continue
                found[beyond] = through if known is None else known.joined(through)
                if depth + 1 < DEPTH:
                    waiting.append((beyond, found[beyond], depth + 1))
        return found


def _opening(segment: Segment, place: Point, axis: Point) -> Wedge | None:
    """Return the directions through an opening, or ``None`` when it is behind the camera."""
    (ax, ay), (bx, by) = segment
    length = hypot(bx - ax, by - ay) or 1.0
    ux, uy = (bx - ax) / length * MARGIN, (by - ay) / length * MARGIN
    ends = [(ax - ux, ay - uy), (bx + ux, by + uy)]
    local = [
        (axis[0] * (x - place[0]) + axis[1] * (y - place[1]), axis[0] * (y - place[1]) - axis[1] * (x - place[0]))
        for x, y in ends
    ]
    if _distance(local[0], local[1]) < NEAR:
        return Wedge(-pi, pi)
    (f0, l0), (f1, l1) = sorted(local)
    if f1 <= EPSILON:
        return None
    if f0 < EPSILON:
        t = (EPSILON - f0) / (f1 - f0)
        f0, l0 = EPSILON, l0 + t * (l1 - l0)
    angles = sorted((atan2(l0, f0), atan2(l1, f1)))
    return Wedge(angles[0], angles[1])


def _distance(a: Point, b: Point) -> float:
    """Return the distance of the origin to a segment."""
    dx, dy = b[0] - a[0], b[1] - a[1]
    length2 = dx * dx + dy * dy
    t = 0.0 if length2 == 0.0 else min(1.0, max(0.0, -(a[0] * dx + a[1] * dy) / length2))
    return hypot(a[0] + t * dx, a[1] + t * dy)
