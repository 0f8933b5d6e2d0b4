"""Where the gardens, pools, places to park and playgrounds lie that a brief asks for, around the building."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np
from shapely.geometry import Point as Place
from shapely.geometry import Polygon

from mansion_knowledge import default_knowledge
from mansion_msgs_py.outside import GroundArea, GroundUse, GroundWish
from mansion_msgs_py.scene import Door
from mansion_msgs_py.shapes import Point, Ring

__all__ = ["AISLE", "BAY", "ground_areas"]

BAY: Final = (2.5, 5.0)
"""Width and length of a place to park, metres."""

AISLE: Final = 6.0
"""Width of the way between two rows of places to park, metres."""

OFF: Final = 3.0
"""From the walls to what lies on the plot, metres."""

USUAL_PLACES: Final = 10
"""Places to park where the brief states no number."""

LONGEST_ROW: Final = 14
"""Most places to park in a row."""

POOL: Final = {True: (8.0, 4.0), False: (12.5, 6.0)}
"""Length and width of an outdoor pool, of homes and of others, metres."""

DECK: Final = 1.6
"""Paving around a pool, metres."""

POOL_OFF: Final = 1.2
"""From the paving around a pool to the edge of its garden, metres."""

PLAYGROUND: Final = (10.0, 7.0)
GARDEN: Final = {True: 9.0, False: 12.0}
"""Width and least depth of a garden, of homes and of others, metres."""

_USES: Final[tuple[GroundUse, ...]] = ("garden", "pool", "parking", "playground")
"""Uses that take a part of the plot; a hedge and a fence stand around it."""


@dataclass(frozen=True)
class _Sides:
    """The box around a building, seen from its street: x to the right along the front, y from the street back."""

    bounds: tuple[float, float, float, float]
    turn: int

    @property
    def size(self) -> Point:
        """Width along the street and depth, metres."""
        x0, y0, x1, y1 = self.bounds
        return (x1 - x0, y1 - y0) if self.turn % 2 == 0 else (y1 - y0, x1 - x0)

    def ring(self, low: Point, high: Point) -> Ring:
        """Return the rectangle between two corners in plan, counter-clockwise."""
        corners = [(low[0], low[1]), (high[0], low[1]), (high[0], high[1]), (low[0], high[1])]
        return [self._placed(x, y) for x, y in corners]

    def _placed(self, x: float, y: float) -> Point:
        x0, y0, x1, y1 = self.bounds
        placed = {0: (x0 + x, y0 + y), 1: (x1 - y, y0 + x), 2: (x1 - x, y1 - y), 3: (x0 + y, y1 - x)}[self.turn]
        return round(placed[0], 4), round(placed[1], 4)


def ground_areas(
    wishes: Sequence[GroundWish], outline: Polygon, doors: Sequence[Door], building_type: str
) -> list[GroundArea]:
    """Return the parts of the plot that are asked for, none over another or before the front.

    A garden lies to the right of the front with the pool in it, where one sees both from the street; places to park
    lie to the left, a playground in the garden's place or behind.

    Parameters
    ----------
    outline : Polygon
        Of the ground floor.
    doors : sequence of Door
        Of the ground floor.
    """
    home = default_knowledge().is_dwelling(building_type)
    sides = _Sides(outline.bounds, _turn(outline, doors))
    wanted = {wish.use: wish.count for wish in wishes}
    return [area for use in _USES if use in wanted for area in _area(use, wanted, sides, home=home)]


def _turn(outline: Polygon, doors: Sequence[Door]) -> int:
    """Return by how many quarter turns the front looks away from south."""
    entrances = [door for door in doors if None in door.rooms and door.kind != "garage"]
    main = max(entrances, key=lambda door: (door.kind == "entrance", door.width), default=None)
    if main is None:
        return 0
    (ax, ay), (bx, by) = main.segment
    middle, along = np.array([(ax + bx) / 2, (ay + by) / 2]), np.array([bx - ax, by - ay])
    normal = np.array([along[1], -along[0]]) / max(float(np.linalg.norm(along)), 1e-9)
    if outline.buffer(-0.05).contains(Place(middle + 0.6 * normal)):
        normal = -normal
    # South (0, -1) is no turn; counter-clockwise quarter turns follow.
    return round(math.atan2(normal[0], -normal[1]) / (math.pi / 2)) % 4


def _area(use: GroundUse, wanted: dict[GroundUse, int], sides: _Sides, *, home: bool) -> Iterator[GroundArea]:
    """Yield the area of a use; places to park may take several rows."""
    width, depth = sides.size
    long, across = POOL[home]
    right, wide = width + OFF, GARDEN[home]
    if use == "garden":
        if "pool" in wanted:
            wide = across + 2 * (DECK + POOL_OFF)
        deep = max(depth, long + 2 * (DECK + POOL_OFF) if "pool" in wanted else GARDEN[home])
        yield GroundArea(use=use, polygon=sides.ring((right, 0.0), (right + wide, deep)))
    elif use == "pool":
        low = (right + DECK + POOL_OFF, DECK + POOL_OFF)
        yield GroundArea(use=use, polygon=sides.ring(low, (low[0] + across, low[1] + long)))
    elif use == "parking":
        yield from _parking(wanted[use] or USUAL_PLACES, sides)
    else:
        beside = width + OFF if not wanted.keys() & {"garden", "pool"} else (PLAYGROUND[0] - width) / -2
        behind = 0.0 if beside > width else depth + OFF
        high = (beside + PLAYGROUND[0], behind + PLAYGROUND[1])
        yield GroundArea(use=use, polygon=sides.ring((beside, behind), high))


def _parking(count: int, sides: _Sides) -> Iterator[GroundArea]:
    """Yield one car park after another to the left, each of two rows along a way that leads to the street."""
    x, left = -OFF, count
    while left > 0:
        here = min(left, 2 * LONGEST_ROW)
        length = math.ceil(here / 2) * BAY[0]
        wide = 2 * BAY[1] + AISLE
        yield GroundArea(use="parking", polygon=sides.ring((x - wide, 0.0), (x, length)), count=here)
        x, left = x - wide - 1.0, left - here
