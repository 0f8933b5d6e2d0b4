"""The flat top of a body that the catalogue gives no surface there: of a fridge, a washing machine, a wardrobe."""

from functools import lru_cache
from typing import Final

import msgspec
import numpy as np

from mansion_assets.catalogue import Asset
from mansion_editing.tools.ledges import Ledge, ledges_of
from mansion_editing.tools.receptacle_bodies import heights_at
from mansion_msgs_py.codec import prepared

__all__ = ["carries_on_top", "places_on"]

_ROWS: Final = 13
_LEVEL: Final = 0.004
"""Greatest difference in height of what counts as flat, metres."""

_LEAST_DEPTH: Final = 0.15
_LEAST_HEIGHT: Final = 0.25
"""Least height of a body whose top carries things: what is lower is no furniture, metres."""

_OVER: Final = 0.005
"""What is as deep as the body may lie on it: metres beyond its edges."""

_UNDER_CEILING: Final = 2.65
"""Height that is free in every room, metres."""


def places_on(asset: Asset, *, inside: bool) -> list[Ledge]:
    """Return the ledges on, or in, a receptacle, and its flat top where the catalogue has no surface that high."""
    ledges = ledges_of(asset, inside=inside)
    top = None if inside else _flat_top(asset)
    return ledges if top is None else [*ledges, top]


def carries_on_top(asset: Asset) -> bool:
    """Whether something can be put on an asset: on a surface, or on its flat top."""
    return bool(asset.surfaces) or _flat_top(asset) is not None


def _flat_top(asset: Asset) -> Ledge | None:
    """Return the level top of furniture; None where the catalogue has a surface there, or it is not level."""
    h = asset.size[2]
    known = any(surface.z > h / 2 - 0.05 for surface in asset.surfaces)
    if known or asset.mount != "floor" or asset.pickupable or not _LEAST_HEIGHT <= h <= _UNDER_CEILING - _LEAST_HEIGHT:
        return None
    depth = _level_depth(msgspec.msgpack.encode(asset))
    if depth < _LEAST_DEPTH:
        return None
    w, d, _ = asset.size
    middle = round((depth - d) / 2, 4)
    return Ledge("top", False, 0.0, middle, h / 2, w + _OVER, depth + _OVER, _UNDER_CEILING - h)


@lru_cache(maxsize=1024)
def _level_depth(payload: bytes) -> float:
    """Return how far from its back the top of an asset is level over its whole width; doors in front may be lower."""
    asset = msgspec.msgpack.decode(payload, type=prepared(Asset))
    w, d, h = asset.size
    xs, ys = np.linspace(-0.46 * w, 0.46 * w, 5), np.linspace(-0.46 * d, 0.46 * d, _ROWS)
    for row, y in enumerate(ys):
        heights = [heights_at(asset, np.array([(x, y)]), h / 2 - _LEVEL, h / 2 + _LEVEL) for x in xs]
        if not all(found.size for found in heights):
            return float(ys[row - 1] + d / 2) if row else 0.0
    return float(d)
