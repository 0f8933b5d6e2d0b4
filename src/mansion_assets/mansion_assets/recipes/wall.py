"""Boxes, shelves and signs on walls."""

from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, inset, surface
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@recipe("wall_box")
def wall_box(b: Builder) -> None:
    """Boxes on walls: first aid, air conditioners."""
    style = str(b.p.get("style", "plain"))
    front = _FRONTS.get(style)
    body = b.d * (0.9 if front is not None else 1.0)
    b.box((-b.w / 2, b.w / 2), (-b.d / 2, -b.d / 2 + body), (0, b.h), b.mat(), "case")
    if front is not None:
        front(b, (-b.d / 2 + body, b.d / 2))
    elif style == "vent":
        _slats(b)


def _cross(b: Builder, y: tuple[float, float]) -> None:
    """Cross of first aid."""
    w, h = b.w, b.h
    main = b.mat()
    other = "plastic_white" if main != "plastic_white" else "plastic_green"
    b.box((-w * 0.3, w * 0.3), y, (h * 0.42, h * 0.58), other, "cross", solid=False)
    b.box((-w * 0.09, w * 0.09), y, (h * 0.24, h * 0.76), other, "cross", solid=False)


def _slats(b: Builder) -> None:
    """Slats of an air outlet, and a lamp."""
    w, d, h = b.w, b.d, b.h
    for k in range(4):
        z = h * (0.08 + 0.07 * k)
        b.box((-w * 0.42, w * 0.42), (d / 2 - 0.003, d / 2), (z, z + h * 0.03), "plastic_dark", "slats", solid=False)
    b.box((w * 0.3, w * 0.4), (d / 2 - 0.003, d / 2), (h * 0.75, h * 0.82), "light_green", "led", solid=False)


_FRONTS = {"cross": _cross}
"""What stands out on the front of a box, from the case to the asset's front at `y`."""


@receptacles("wall_shelf")
def _wall_shelf_top(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    return [surface("shelf", inset(size, 0.015), size[2], 0.45)]


@recipe("wall_shelf")
def wall_shelf(b: Builder) -> None:
    """Board on two brackets, its upper face at the top."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.025, h), b.mat(), "board")
    for sx in (-1, 1):
        x = sx * w * 0.36
        b.box((x - 0.01, x + 0.01), (-d / 2, -d / 2 + 0.012), (0, h - 0.025), "metal_black", "brackets")
        b.rod((x, -d / 2 + 0.01, 0.01), (x, d / 2 - 0.03, h - 0.03), 0.007, "metal_black", "brackets")


@recipe("sign")
def sign(b: Builder) -> None:
    """Plate with a symbol; exit signs with an arrow and a running figure of bars."""
    w, d, h = b.w, b.d, b.h
    z1 = h * 0.62 if b.p.get("style") == "hanging" else h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.002), (0, z1), b.mat(), "plate")
    if z1 < h:
        for sx in (-1, 1):
            b.rod((sx * w * 0.35, 0, z1), (sx * w * 0.35, 0, h), 0.006, "metal_steel", "rods")
    light = "light_white" if b.mat() == "plastic_green" else "plastic_dark"
    b.prism(
        [(w * 0.08, z1 * 0.5), (w * 0.25, z1 * 0.25), (w * 0.25, z1 * 0.75)],
        (d / 2 - 0.002, d / 2),
        light,
        "y",
        "arrow",
        solid=False,
    )
    b.box((w * 0.25, w * 0.42), (d / 2 - 0.002, d / 2), (z1 * 0.42, z1 * 0.58), light, "arrow", solid=False)
    b.box((-w * 0.4, -w * 0.1), (d / 2 - 0.002, d / 2), (z1 * 0.2, z1 * 0.8), light, "symbol", solid=False)
