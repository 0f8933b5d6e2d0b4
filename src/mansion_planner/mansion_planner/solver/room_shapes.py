"""What shape rooms of a kind have in real flats, as the wall search prefers it where no seeds say where they lie."""

from dataclasses import dataclass
from typing import Final

__all__ = ["ANY", "RoomShape", "shape_of"]


@dataclass(frozen=True)
class RoomShape:
    """Preferences for the rooms of one kind, each a factor of a weight of `SearchWeights` or a length.

    Attributes
    ----------
    compact : float
        Factor of the weight of a perimeter beyond `detour`.
    detour : float
        Compactness (perimeter / 4 sqrt(area)) up to which proportions cost nothing: 1 is a square, 1.01 a rectangle of
        1 : 1.33, 1.12 one of 1 : 2.6.
    corner : float
        Factor of the weight of each corner beyond four.
    wall : float
        Factor of the weight of missing contact with the envelope.
    facade : float
        Contact with the envelope that is wanted, in units of the square root of the room's area.
    """

    compact: float = 1.0
    detour: float = 1.12
    corner: float = 1.0
    wall: float = 1.0
    facade: float = 0.6


ANY: Final = RoomShape()
"""A room of which nothing more is known: a rectangle that touches the envelope."""

_BEDROOM: Final = RoomShape(compact=3.0, detour=1.02, corner=1.4)
"""Bedrooms of real flats (ResPlan) are 1 : 1.24 and fill .95 of their rectangle; those of a free search 1 : 1.7, .85.

Chosen on 20 plans; what else was tried is in docs/floor_solver.md.
"""

_SHAPES: Final[dict[str, RoomShape]] = {"bedroom": _BEDROOM, "master_bedroom": _BEDROOM}


def shape_of(room_type: str) -> RoomShape:
    """Return the shape that rooms of a type should have.

    Examples
    --------
    >>> shape_of("bedroom").detour < shape_of("storage").detour
    True
    """
    return _SHAPES.get(room_type, ANY)
