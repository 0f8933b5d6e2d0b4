"""Packing of small rectangles on a surface or in a box, in the receptacle's own frame."""

import math

import msgspec
import numpy as np

from mansion_assets.catalogue import Surface, Volume
from mansion_msgs_py.shapes import Point, Size3

__all__ = ["Shelf", "Spot", "shelves_of", "spot_of"]

_GAP = 0.008
"""Least distance between neighbours, metres."""

_TRIES = 24


class Spot(msgspec.Struct, frozen=True):
    """Where a thing lies: centre in the receptacle's frame, degrees, and half extents of its turned rectangle."""

    x: float
    y: float
    turn: float
    half_w: float
    half_d: float


class Shelf:
    """A surface, or the floor of an inner box, with what lies on it.

    Parameters
    ----------
    carrier : Surface or Volume
    most : float
        Greatest share of the area that things may cover.

    Attributes
    ----------
    spots : list of Spot
        What lies here.
    overhead : list of (Spot, float)
        What hangs above, and the height that it leaves free, metres.
    """

    def __init__(self, carrier: Surface | Volume, most: float = 0.6) -> None:
        self.inside = isinstance(carrier, Volume)
        self.kind = carrier.kind
        self.x, self.y = carrier.x, carrier.y
        self.half_w, self.half_d = carrier.w / 2, carrier.d / 2
        if isinstance(carrier, Volume):
            self.z, self.clearance, self.round = carrier.z - carrier.h / 2, carrier.h, False
        else:
            self.z, self.clearance, self.round = carrier.z, carrier.clearance, carrier.round
        self.spots: list[Spot] = []
        self.overhead: list[tuple[Spot, float]] = []
        self._free = most * carrier.w * carrier.d
        self._cursor = -self.half_w

    def at(self, size: Size3, x: float, y: float, turn: float) -> Spot | None:
        """Take the place at (x, y) in the receptacle's frame, or return None where it is not free."""
        spot = spot_of(size, x, y, turn)
        if size[2] > self.clearance - 0.005 or not self._holds(spot) or self._hits(spot):
            return None
        if any(size[2] > room - 0.005 and _meet(spot, other) for other, room in self.overhead):
            return None
        area = 4 * spot.half_w * spot.half_d
        if area > self._free + 1e-9 and self.spots:
            return None
        self._free -= area
        self.spots.append(spot)
        return spot

    def somewhere(self, size: Size3, rng: np.random.Generator, turns: float = 25.0) -> Spot | None:
        """Take a random free place, the thing turned by up to `turns` degrees; None after 24 tries."""
        for _ in range(_TRIES):
            a, b, c = rng.random(3)
            turn = (2 * c - 1) * turns
            probe = spot_of(size, 0.0, 0.0, turn)
            rx, ry = self.half_w - probe.half_w, self.half_d - probe.half_d
            if rx < 0 or ry < 0:
                turn += 90.0
                probe = spot_of(size, 0.0, 0.0, turn)
                rx, ry = self.half_w - probe.half_w, self.half_d - probe.half_d
                if rx < 0 or ry < 0:
                    turn = 0.0 if size[0] <= 2 * self.half_w and size[1] <= 2 * self.half_d else 90.0
                    probe = spot_of(size, 0.0, 0.0, turn)
                    rx, ry = self.half_w - probe.half_w, self.half_d - probe.half_d
            if rx < 0 or ry < 0:
                return None
            spot = self.at(size, self.x + (2 * a - 1) * rx, self.y + (2 * b - 1) * ry, turn)
            if spot is not None:
                return spot
        return None

    def in_line(self, size: Size3) -> Spot | None:
        """Take the next place of a row from left to right along the front; None where the row is full."""
        if size[1] > 2 * self.half_d or size[0] > 2 * self.half_w:
            return None
        x = self.x + self._cursor + size[0] / 2
        y = self.y + max(-self.half_d + size[1] / 2, self.half_d - size[1] / 2 - 0.03)
        self._cursor += size[0] + 0.012
        if self._cursor > self.half_w + 0.012 + 1e-9:
            return None
        return self.at(size, x, y, 0.0)

    def _holds(self, spot: Spot) -> bool:
        dx, dy = abs(spot.x - self.x), abs(spot.y - self.y)
        if self.round:
            corner = (dx + spot.half_w) / self.half_w, (dy + spot.half_d) / self.half_d
            return math.hypot(*corner) <= 1.0
        return dx + spot.half_w <= self.half_w + 1e-6 and dy + spot.half_d <= self.half_d + 1e-6

    def _hits(self, spot: Spot) -> bool:
        return any(_meet(spot, other) for other in self.spots)

    def hang_over(self, spot: Spot, room: float) -> None:
        """Note something above the surface that leaves `room` metres of height below it."""
        self.overhead.append((spot, room))

    def point(self, u: float, v: float) -> Point:
        """Return the point at (u, v) in [0, 1] from the left back corner."""
        return self.x + (2 * u - 1) * self.half_w, self.y + (2 * v - 1) * self.half_d


def _meet(spot: Spot, other: Spot) -> bool:
    return (
        abs(spot.x - other.x) < spot.half_w + other.half_w + _GAP
        and abs(spot.y - other.y) < spot.half_d + other.half_d + _GAP
    )


def spot_of(size: Size3, x: float, y: float, turn: float) -> Spot:
    """Return the spot that a thing of this size takes, turned by `turn` degrees."""
    angle = math.radians(turn)
    c, s = abs(math.cos(angle)), abs(math.sin(angle))
    return Spot(x, y, turn, (c * size[0] + s * size[1]) / 2, (s * size[0] + c * size[1]) / 2)


def shelves_of(surfaces: tuple[Surface, ...], volumes: tuple[Volume, ...]) -> list[Shelf]:
    """Return the places of a receptacle where things can lie, its surfaces first."""
    return [Shelf(s) for s in surfaces] + [Shelf(v, 0.75) for v in volumes]
