"""Mass, centre of mass and inertia of objects, from their convex pieces."""

from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np

from mansion_assets.convex import Convex, Hull, volume_of
from mansion_assets.solids import Vec3
from mansion_geometry.compiled import Floats

__all__ = ["FRICTION", "MassProperties", "mass_properties"]

FRICTION: Final = 1.0
"""Coefficient of sliding friction of everything, which SDFormat assumes where a world says nothing."""

LEAST: Final = 5e-3
"""Metres that a piece counts as thick at least: sheets and wires need an inertia that engines can reckon with."""


class MassProperties(NamedTuple):
    """Mass in kilograms, centre of mass in metres, and inertia about it, (3, 3), along the body's axes."""

    mass: float
    center: Vec3
    inertia: Floats


def mass_properties(pieces: Sequence[Convex], mass: float) -> MassProperties:
    """Return the mass properties of a rigid body of one density whose pieces are these.

    A hull counts as a box of its bounds with the hull's volume.

    Examples
    --------
    >>> mass_properties([Box((0.0, 0.0, 0.5), (1.0, 1.0, 1.0))], 6.0).center
    (0.0, 0.0, 0.5)
    """
    bounds = [_bounds(piece) for piece in pieces]
    sizes = np.maximum(np.array([size for _, size in bounds]), LEAST)
    weights = np.array([max(volume_of(piece), LEAST**3) for piece in pieces])
    masses = weights * (mass / weights.sum())
    centers = np.array([center for center, _ in bounds])
    middle = masses @ centers / mass
    away = centers - middle
    squares = sizes**2
    own = (squares.sum(axis=1, keepdims=True) - squares) / 12
    inertia = np.diag(masses @ (own + (away**2).sum(axis=1, keepdims=True)))
    inertia = inertia - np.einsum("i,ij,ik->jk", masses, away, away)
    return MassProperties(mass, (float(middle[0]), float(middle[1]), float(middle[2])), inertia)


def _bounds(piece: Convex) -> tuple[Floats, Floats]:
    """Return the centre and the size of the box around a piece."""
    if isinstance(piece, Hull):
        low, high = piece.vertices.min(axis=0), piece.vertices.max(axis=0)
        return (low + high) / 2, high - low
    return np.array(piece.center), np.array(piece.size)
