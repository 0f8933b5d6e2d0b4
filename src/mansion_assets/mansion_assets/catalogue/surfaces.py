"""What carries and what holds things, from an asset's recipe, size and parameters.

Mesh recipes build to these rectangles and boxes, so that what is packed on them rests on the mesh. Rules work in a
frame on the floor (see `carriers`); `surfaces_of` moves the result to the box centre.
"""

from typing import Any

from mansion_assets.catalogue.asset import Surface, Volume
from mansion_assets.catalogue.carriers import Rule
from mansion_assets.catalogue.fixture_carriers import FIXTURES
from mansion_assets.catalogue.furniture_carriers import FURNITURE
from mansion_msgs_py.shapes import Size3

__all__ = ["surfaces_of"]

_RULES: dict[str, Rule] = {**FURNITURE, **FIXTURES}


def surfaces_of(recipe: str, size: Size3, parameters: dict[str, Any]) -> tuple[tuple[Surface, ...], tuple[Volume, ...]]:
    """Return the surfaces and inner volumes of an asset in its own frame.

    Parameters
    ----------
    recipe : str
        Name of the mesh recipe; ``carrier`` in `parameters` names another rule, or ``none``.
    size : (float, float, float)
        Width, depth, height in metres.

    Examples
    --------
    >>> surfaces_of("table", (1.2, 0.8, 0.75), {})[0][0].z
    0.375
    """
    rule = _RULES.get(str(parameters.get("carrier", recipe)))
    if rule is None:
        return (), ()
    surfaces: list[Surface] = []
    volumes: list[Volume] = []
    half = size[2] / 2
    for carrier in rule(size, parameters):
        low = min(carrier.w, carrier.d)
        if isinstance(carrier, Surface) and low > 0.04:
            surfaces.append(_lowered(carrier, half))
        elif isinstance(carrier, Volume) and low > 0.03 and carrier.h > 0.03:
            volumes.append(_sunk(carrier, half))
    return tuple(surfaces), tuple(volumes)


def _lowered(s: Surface, dz: float) -> Surface:
    return Surface(
        kind=s.kind,
        x=_mm(s.x),
        y=_mm(s.y),
        z=_mm(s.z - dz),
        w=_mm(s.w),
        d=_mm(s.d),
        clearance=_mm(s.clearance),
        round=s.round,
    )


def _sunk(v: Volume, dz: float) -> Volume:
    return Volume(kind=v.kind, x=_mm(v.x), y=_mm(v.y), z=_mm(v.z - dz), w=_mm(v.w), d=_mm(v.d), h=_mm(v.h))


def _mm(value: float) -> float:
    return round(value, 4)
