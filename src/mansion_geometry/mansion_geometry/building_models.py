"""Conventions that a building's 3D models share with what moves their parts: hinges, geom groups, masses."""

from collections.abc import Sequence
from math import prod
from typing import Final

__all__ = [
    "ASIDE",
    "CEILING_GROUP",
    "COLLISION_GROUP",
    "JAMB",
    "OBJECT_GROUP",
    "OPEN_ANGLE",
    "STRUCTURE_GROUP",
    "object_mass",
]

OPEN_ANGLE: Final = 86.0
"""Degrees by which an open leaf stands off its frame."""

JAMB: Final = 0.04
"""Metres of a door's frame on either side."""

ASIDE: Final = 0.92
"""How far an open sliding panel has moved, in its widths."""

STRUCTURE_GROUP: Final = 0
OBJECT_GROUP: Final = 1
CEILING_GROUP: Final = 2
COLLISION_GROUP: Final = 3
"""Geom groups; MuJoCo draws 0 to 2, so that boxes to collide with stay unseen. Switch 2 off to look from above."""

_DENSITY: Final = 300.0
"""Density of objects, kilograms a cubic metre: much of each is air."""

_LEAST_MASS: Final = 0.02


def object_mass(size: Sequence[float]) -> float:
    """Return the mass of an object by its width, depth and height in metres, kilograms.

    Examples
    --------
    >>> object_mass((1.0, 0.5, 0.2))
    30.0
    """
    return max(_LEAST_MASS, _DENSITY * prod(size))
