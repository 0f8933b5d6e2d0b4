"""The scale of a model in metres: from its stated size, or from the usual size of its category."""

from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np

from mansion_assets.catalogue.asset import Asset
from mansion_assets.library.annotations import Annotation
from mansion_geometry.compiled import Floats

__all__ = ["Sizing", "sizing"]

_UNITS: Final = ((1e-3, "millimetres"), (1e-2, "centimetres"), (0.0254, "inches"), (0.3048, "feet"))

_SLACK: Final = 2.0
"""Factor by which a model may be smaller or larger than the assets of its category."""

_THINGS: Final = (0.015, 6.0)
"""Longest edges of things of which the catalogue has none, metres."""

_UNKNOWN: Final = 1.0
"""Longest edge that a thing gets of which nothing is known, metres."""


class Sizing(NamedTuple):
    """Metres for each unit of the model, how that is known, and whether it was stated."""

    scale: float
    how: str
    stated: bool


def sizing(extent: Floats, annotation: Annotation | None, alike: Sequence[Asset]) -> Sizing:
    """Return how a model is scaled.

    Parameters
    ----------
    extent : (3,) array
        Width, depth and height of the model in its units.
    annotation : Annotation, optional
    alike : sequence of Asset
        What the catalogue has of its category.

    Notes
    -----
    A size that is impossible for the category, by more than a factor of two beyond what the catalogue has, is taken
    to be in millimetres, centimetres, inches or feet if that makes it possible; else the longest edge becomes the
    usual one.
    """
    longest = float(extent.max())
    low, high, usual = _bounds(alike)
    said = _stated(extent, annotation)
    scale, how = said or (1.0, "the file's units as metres")
    if low <= longest * scale <= high:
        return Sizing(scale, how, said is not None)
    found = f"{longest * scale:.3g} m is implausible"
    if said is None:
        for unit, name in _UNITS:
            if low <= longest * unit <= high:
                return Sizing(unit, f"{found}: the file's units as {name}", stated=False)
    known = "usual for its category" if alike else "as nothing else is known"
    return Sizing(usual / longest, f"{found}: scaled to {usual:.3g} m, {known}", stated=False)


def _stated(extent: Floats, annotation: Annotation | None) -> tuple[float, str] | None:
    if annotation is None:
        return None
    if annotation.height is not None:
        return annotation.height / float(extent[2]), f"its height by {annotation.source}"
    if annotation.longest is not None:
        return annotation.longest / float(extent.max()), f"its longest side by {annotation.source}"
    if annotation.size is not None:
        return max(annotation.size) / float(extent.max()), f"its size by {annotation.source}"
    return None


def _bounds(alike: Sequence[Asset]) -> tuple[float, float, float]:
    """Return the least and the greatest longest edge that is plausible, and the usual one."""
    if not alike:
        return (*_THINGS, _UNKNOWN)
    edges = sorted(max(asset.size) for asset in alike)
    return edges[0] / _SLACK, edges[-1] * _SLACK, float(np.median(edges))
