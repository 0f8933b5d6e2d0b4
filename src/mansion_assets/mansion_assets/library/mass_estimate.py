"""Estimate the mass of a model that states none: the volume of its pieces times the density of such furniture."""

from collections.abc import Sequence
from math import prod
from typing import Final, NamedTuple

from mansion_assets.catalogue.asset import Asset
from mansion_assets.convex import volume_of
from mansion_assets.glb_meshes import PieceRecord
from mansion_assets.library.source_model import Look
from mansion_msgs_py.shapes import Size3

__all__ = ["GuessedMass", "guessed_mass"]

_DENSITIES: Final[dict[str, float]] = {
    "fabric": 60.0,
    "leather": 70.0,
    "leaf": 40.0,
    "plastic": 180.0,
    "light": 200.0,
    "screen": 250.0,
    "paint": 300.0,
    "picture": 400.0,
    "metal": 400.0,
    "rubber": 400.0,
    "paper": 500.0,
    "wood": 550.0,
    "ceramic": 700.0,
    "glass": 800.0,
    "food": 900.0,
    "stone": 2000.0,
}
"""Kilograms a cubic metre of furniture of a material: foam under fabric, tube and sheet of metal, no bare stuff."""

_SOFT: Final = frozenset({"fabric", "leather"})
_FRAME, _SLIM = 400.0, 0.15
"""Density of objects with only a soft cover, such as floor lamps, and the share of the box that they fill at most."""

_MIXED: Final = 200.0
"""The same of things of which no material is known."""

_HOLLOW: Final = 0.3
"""Share of that in things with room inside, whose pieces are full."""

_METALLIC, _CLEAR = 0.5, 0.6
"""Metallic factor above which a look is that of metal, and opacity below which it is that of glass."""

_LEAST: Final = 0.02
"""Kilograms that everything has."""


class GuessedMass(NamedTuple):
    """Kilograms, and how they came about."""

    mass: float
    how: str


def guessed_mass(
    pieces: Sequence[PieceRecord], size: Size3, like: Asset | None, look: Look, *, opens: bool
) -> GuessedMass:
    """Return the mass of a model.

    Parameters
    ----------
    pieces : sequence of PieceRecord
        What of it collides.
    size : Size3
        Size of the box around it, metres.
    like : Asset, optional
        An asset of its category, whose main material and hollows count.
    look : Look
        Look of most of the surface; its metal or glass counts where the category says nothing.
    opens : bool
        Whether it has doors or drawers.
    """
    volume = sum(volume_of(piece.shape) for piece in pieces)
    family = like.material.partition("_")[0] if like is not None else _family(look)
    hollow = opens or (like is not None and (like.openable or bool(like.volumes)))
    slim = family in _SOFT and volume < _SLIM * prod(size)
    density = _FRAME if slim else _DENSITIES.get(family, _MIXED) * (_HOLLOW if hollow else 1.0)
    stuff = family if family in _DENSITIES else "mixed materials"
    how = f"{volume:.3g} m3 of pieces at {density:.0f} kg/m3, {_build(slim=slim, hollow=hollow)}{stuff}"
    return GuessedMass(max(_LEAST, float(f"{volume * density:.3g}")), how)


def _build(*, slim: bool, hollow: bool) -> str:
    if slim:
        return "a frame with "
    return "hollow, " if hollow else ""


def _family(look: Look) -> str:
    if look.metallic >= _METALLIC:
        return "metal"
    return "glass" if look.opacity < _CLEAR else ""
