"""Carriers of things: flat rectangles and inner boxes, as the rules of recipes make them.

Rules work in a frame with its origin on the floor below the centre of the asset, metres.
"""

from collections.abc import Callable
from typing import Any

from mansion_assets.catalogue.asset import Surface, Volume
from mansion_msgs_py.shapes import Size3

__all__ = ["BOARD", "Carrier", "Rectangle", "Rule", "inset", "rect", "volume"]

Rectangle = tuple[float, float, float, float]
"""Least and greatest x, least and greatest y."""

Carrier = Surface | Volume
Rule = Callable[[Size3, dict[str, Any]], list[Carrier]]

BOARD = 0.022
"""Thickness of a furniture board, metres."""


def rect(kind: str, box: Rectangle, z: float, clearance: float = 1.0, round_: bool = False) -> Surface:
    """Return a face at height `z`, `clearance` free above it."""
    x0, x1, y0, y1 = box
    return Surface(
        kind=kind, x=(x0 + x1) / 2, y=(y0 + y1) / 2, z=z, w=x1 - x0, d=y1 - y0, clearance=clearance, round=round_
    )


def volume(kind: str, box: Rectangle, z0: float, z1: float) -> Volume:
    """Return an inner box from `z0` to `z1`."""
    x0, x1, y0, y1 = box
    return Volume(kind=kind, x=(x0 + x1) / 2, y=(y0 + y1) / 2, z=(z0 + z1) / 2, w=x1 - x0, d=y1 - y0, h=z1 - z0)


def inset(size: Size3, margin: float) -> Rectangle:
    """Return the footprint less a margin on every side, at most an eighth of the width or depth."""
    w, d, _ = size
    margin = min(margin, w / 8, d / 8)
    return (-w / 2 + margin, w / 2 - margin, -d / 2 + margin, d / 2 - margin)
