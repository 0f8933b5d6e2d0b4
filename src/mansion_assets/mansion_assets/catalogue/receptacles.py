"""Where an asset carries or holds other objects: flat surfaces and inner volumes, from the rule of its recipe.

A rule stands beside the mesh recipe that it belongs to (`mansion_assets.registry.receptacles`), and both use the same
dimensions, so that what is packed on a receptacle rests on the mesh. Rules work in a frame with its origin on the floor
below the centre of the asset, metres; `receptacles_of` moves the result to the centre of the bounding box.
"""

from typing import Any, TypeAlias

from mansion_assets import registry
from mansion_assets.catalogue.asset import Surface, Volume
from mansion_msgs_py.shapes import Size3

__all__ = ["BOARD", "Receptacle", "Rectangle", "inset", "receptacles_of", "surface", "volume"]

Rectangle: TypeAlias = tuple[float, float, float, float]
"""Least and greatest x, least and greatest y."""

Receptacle: TypeAlias = Surface | Volume

BOARD = 0.022
"""Thickness of a furniture board, metres."""


def surface(kind: str, box: Rectangle, z: float, clearance: float = 1.0, *, round_: bool = False) -> Surface:
    """Return a face at height `z` with `clearance` metres free above it."""
    x0, x1, y0, y1 = box
    return Surface(
        kind=kind, x=(x0 + x1) / 2, y=(y0 + y1) / 2, z=z, w=x1 - x0, d=y1 - y0, clearance=clearance, round=round_
    )


def volume(kind: str, box: Rectangle, z0: float, z1: float) -> Volume:
    """Return an inner box from height `z0` to `z1`."""
    x0, x1, y0, y1 = box
    return Volume(kind=kind, x=(x0 + x1) / 2, y=(y0 + y1) / 2, z=(z0 + z1) / 2, w=x1 - x0, d=y1 - y0, h=z1 - z0)


def inset(size: Size3, margin: float) -> Rectangle:
    """Return the footprint less a margin on every side, at most an eighth of the width or depth."""
    w, d, _ = size
    margin = min(margin, w / 8, d / 8)
    return (-w / 2 + margin, w / 2 - margin, -d / 2 + margin, d / 2 - margin)


def receptacles_of(
    recipe: str, size: Size3, parameters: dict[str, Any]
) -> tuple[tuple[Surface, ...], tuple[Volume, ...]]:
    """Return the surfaces and inner volumes of an asset in its own frame.

    Parameters
    ----------
    recipe : str
        Name of the mesh recipe; ``carrier`` in `parameters` names another recipe's rule, or ``none``.
    size : (float, float, float)
        Width, depth, height in metres.

    Examples
    --------
    >>> receptacles_of("table", (1.2, 0.8, 0.75), {})[0][0].z
    0.375
    """
    rule = registry.receptacle_rule(str(parameters.get("carrier", recipe)))
    if rule is None:
        return (), ()
    surfaces: list[Surface] = []
    volumes: list[Volume] = []
    half = size[2] / 2
    for found in rule(size, parameters):
        low = min(found.w, found.d)
        if isinstance(found, Surface) and low > 0.04:
            surfaces.append(_lowered(found, half))
        elif isinstance(found, Volume) and low > 0.03 and found.h > 0.03:
            volumes.append(_sunk(found, half))
    return tuple(surfaces), tuple(volumes)


def _lowered(s: Surface, dz: float) -> Surface:
    return Surface(
        kind=s.kind,
        x=round(s.x, 4),
        y=round(s.y, 4),
        z=round(s.z - dz, 4),
        w=round(s.w, 4),
        d=round(s.d, 4),
        clearance=round(s.clearance, 4),
        round=s.round,
    )


def _sunk(v: Volume, dz: float) -> Volume:
    return Volume(
        kind=v.kind,
        x=round(v.x, 4),
        y=round(v.y, 4),
        z=round(v.z - dz, 4),
        w=round(v.w, 4),
        d=round(v.d, 4),
        h=round(v.h, 4),
    )
