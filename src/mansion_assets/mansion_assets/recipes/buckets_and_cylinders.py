"""Buckets, tins of paint, and cylinders of gas."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("bail_bucket")
def bail_bucket(b: Builder) -> None:
    """A tapered bucket with ribs under its rim and a wire handle with a grip, which hangs down in front."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.34, 0), (0.45, h * 0.96), (0.48, h), (0.43, h), (0.32, 0.012)], b.mat(), n=28, stretch=(w, d))
    for z in (0.86, 0.78):
        b.lathe(
            [(0.44, h * z), (0.47, h * (z + 0.02)), (0.44, h * (z + 0.04))],
            b.mat(),
            n=28,
            stretch=(w, d),
            part="ribs",
            solid=False,
        )
    turns = [k * math.pi / 12 for k in range(13)]
    arc = [(w * 0.5 * math.cos(a), d * 0.52 * math.sin(a), h * (0.9 - 0.45 * math.sin(a))) for a in turns]
    b.path(arc, w * 0.014, "metal_steel", "handle")
    b.path(arc[5:8], w * 0.04, "plastic_white", "grip")
    for side in (-1, 1):
        b.rod((side * w * 0.42, 0, h * 0.9), (side * w * 0.5, 0, h * 0.9), w * 0.04, "metal_steel", "ears", 10)


@recipe("paint_can")
def paint_can(b: Builder) -> None:
    """An open tin of paint with a wire handle, paint that runs down its side, and a label."""
    w, d, h = b.w, b.d, b.h
    can, color = h * 0.8, "paint_3a7bc8"
    b.lathe([(0.46, 0), (0.46, can * 0.96), (0.48, can), (0.42, can), (0.4, can * 0.9)], b.mat(), n=28, stretch=(w, d))
    b.lathe([(0.41, can * 0.8), (0.41, can * 0.96)], color, n=28, stretch=(w, d), part="paint", solid=False)
    b.lathe([(0.468, can * 0.15), (0.468, can * 0.72)], "paper_white", n=28, stretch=(w, d), part="label", solid=False)
    b.lathe([(0.472, can * 0.3), (0.472, can * 0.5)], color, n=28, stretch=(w, d), part="label", solid=False)
    for a, low in ((1.2, 0.5), (1.5, 0.2), (1.75, 0.62), (0.95, 0.72)):
        x, y = 0.47 * w * math.cos(a), 0.47 * d * math.sin(a)
        b.rod((x, y, can * low), (x, y, can * 0.99), w * 0.035, color, "drips")
    turns = [
        (-math.cos(k * math.pi / 10) * w * 0.48, 0.0, can * 0.84 + math.sin(k * math.pi / 10) * (h - can * 0.84))
        for k in range(11)
    ]
    b.path(turns, w * 0.018, "metal_dark", "handle")


@recipe("gas_cylinder")
def gas_cylinder(b: Builder) -> None:
    """A tall steel bottle with round shoulders, a valve with a hand wheel and a guard, and a hazard label."""
    w, d, h = b.w, b.d, b.h
    b.lathe(
        [(0.48, 0), (0.5, h * 0.01), (0.5, h * 0.8), (0.44, h * 0.855), (0.3, h * 0.89), (0.14, h * 0.91)],
        b.mat(),
        n=24,
        stretch=(w, d),
    )
    b.lathe(
        [(0.502, h * 0.74), (0.502, h * 0.8), (0.45, h * 0.85)],
        "paint_white",
        n=24,
        stretch=(w, d),
        part="band",
        solid=False,
    )
    b.cyl(0, 0, (h * 0.9, h * 0.96), w * 0.1, "metal_brass", "valve")
    b.rod((0, 0, h * 0.94), (0, d * 0.26, h * 0.94), w * 0.07, "metal_brass", "outlet")
    b.cyl(0, 0, (h * 0.97, h), w * 0.26, "paint_red", "wheel", n=12)
    b.prism(
        [(0, h * 0.5), (w * 0.2, h * 0.54), (0, h * 0.58), (-w * 0.2, h * 0.54)],
        (d * 0.47, d * 0.505),
        "paint_yellow",
        "y",
        "hazard",
        solid=False,
    )
