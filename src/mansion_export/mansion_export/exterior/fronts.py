"""The side of a building that its main entrance is in, which faces the street."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

import numpy as np
from shapely.geometry import LineString, Polygon
from shapely.geometry import Point as Place

from mansion_export.exterior.entrances import outward
from mansion_export.meshes.solids import Box
from mansion_export.presentation import main_door
from mansion_msgs_py.scene import Door, FloorScene, Window
from mansion_msgs_py.shapes import Point, Segment

__all__ = ["Front", "front_of", "front_windows", "places_beside"]

_ON: Final = 0.3
"""From the middle of a wall to openings in it at most, metres."""


@dataclass(frozen=True)
class Front:
    """The side of a building with its main entrance.

    Attributes
    ----------
    door : Door
    middle : Point
        Of the door, on the outer face of the wall.
    along, out : Point
        Unit vectors along the wall and to the street.
    low, high : float
        From the door's middle to either end of the side, metres.
    """

    door: Door
    middle: Point
    along: Point
    out: Point
    low: float
    high: float

    def at(self, along: float, out: float = 0.0) -> Point:
        """Return the point so far along the wall and before it, metres."""
        return (
            self.middle[0] + along * self.along[0] + out * self.out[0],
            self.middle[1] + along * self.along[1] + out * self.out[1],
        )

    def box(self, along: tuple[float, float], out: tuple[float, float], up: tuple[float, float]) -> Box:
        """Return the box between distances along the wall, before it and above the floor, metres."""
        x, y = self.at(sum(along) / 2, sum(out) / 2)
        heading = math.degrees(math.atan2(self.along[1], self.along[0]))
        size = (along[1] - along[0], out[1] - out[0], up[1] - up[0])
        return Box((x, y, sum(up) / 2), size, heading)

    def interval(self, segment: Segment) -> tuple[float, float] | None:
        """Return where an opening lies along the wall; None for one in another wall."""
        offsets = [(x - self.middle[0], y - self.middle[1]) for x, y in segment]
        if any(abs(dx * self.out[0] + dy * self.out[1]) > 2 * _ON for dx, dy in offsets):
            return None
        first, last = sorted(dx * self.along[0] + dy * self.along[1] for dx, dy in offsets)
        return (first, last) if self.low - _ON <= first and last <= self.high + _ON else None


def front_of(scene: FloorScene) -> Front | None:
    """Return the front of a building; None where nobody comes in on this floor."""
    door = main_door(scene) if scene.floor == 1 else None
    if door is None:
        return None
    outline = Polygon(scene.outline, scene.holes)
    out = outward(door, outline)
    along = (-out[1], out[0])
    (ax, ay), (bx, by) = door.segment
    middle = np.array([(ax + bx) / 2, (ay + by) / 2])
    thick = max((wall.thickness for wall in scene.walls if wall.exterior), default=0.24)
    side = _side(outline, (float(middle[0]), float(middle[1])))
    if side is None:
        return None
    low, high = sorted(float((np.array(end) - middle) @ np.array(along)) for end in side)
    face = middle + (float((np.array(side[0]) - middle) @ np.array(out)) + thick) * np.array(out)
    return Front(door, (float(face[0]), float(face[1])), along, out, low, high)


def _side(outline: Polygon, place: Point) -> Segment | None:
    """Return the side of the outline that a door in the outer wall is in."""
    for ring in (outline.exterior, *outline.interiors):
        points = list(ring.simplify(1e-3).coords)
        for a, b in pairwise(points):
            if LineString([a, b]).distance(Place(place)) < _ON and math.dist(a, b) > 1.0:
                return a, b
    return None


def front_windows(scene: FloorScene, front: Front) -> list[tuple[Window, float, float]]:
    """Return the windows of the front of this floor, with where each begins and ends along it."""
    found = [(window, front.interval(window.segment)) for window in scene.windows]
    return [(window, *interval) for window, interval in found if interval is not None]


def places_beside(scene: FloorScene, front: Front, width: float, most: int) -> Iterator[float]:
    """Yield the middles of up to `most` stretches of bare wall, the nearest to the door first, metres along it."""
    taken = [(low, high) for _, low, high in front_windows(scene, front)]
    doors = (front.interval(door.segment) for door in scene.doors if None in door.rooms)
    taken += [(low - 0.4, high + 0.4) for low, high in filter(None, doors)]
    found = 0
    for step in range(1, int(2 * max(-front.low, front.high))):
        for sign in (-1, 1):
            middle = sign * 0.5 * step
            low, high = middle - width / 2 - 0.1, middle + width / 2 + 0.1
            free = all(high <= a or low >= b for a, b in taken)
            if found < most and free and front.low + 0.2 <= low and high <= front.high - 0.2:
                taken.append((low, high))
                found += 1
                yield middle
