"""Bags to carry, and the stands that luggage is put on."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("backpack")
def backpack(b: Builder) -> None:
    """A rounded bag with a lid, a front pocket with a zip, side pockets, a loop on top and two straps behind."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w * 0.42, w * 0.42), (-d * 0.34, d * 0.3), (0, h * 0.94), b.mat(), "body", 0.6, 14)
    b.cushion((-w * 0.36, w * 0.36), (d * 0.2, d / 2), (h * 0.04, h * 0.5), b.mat(), "pocket", 0.6, 12)
    b.box((-w * 0.28, w * 0.28), (d * 0.47, d * 0.505), (h * 0.36, h * 0.385), "plastic_black", "zips", solid=False)
    b.box((w * 0.2, w * 0.24), (d * 0.48, d * 0.51), (h * 0.3, h * 0.38), "metal_steel", "zips", solid=False)
    arc = [
        (math.cos(a) * w * 0.34, d * 0.3, h * 0.56 + math.sin(a) * h * 0.26)
        for a in (k * math.pi / 10 for k in range(11))
    ]
    b.path(arc, w * 0.018, "plastic_black", "zips")
    for side in (-1, 1):
        b.cushion(
            (side * w * 0.42 - w * 0.08, side * w * 0.42 + w * 0.08),
            (-d * 0.2, d * 0.2),
            (h * 0.04, h * 0.34),
            "fabric_dark",
            "side_pockets",
            0.5,
        )
        strap = [
            (side * w * 0.2, -d * 0.3, h * 0.88),
            (side * w * 0.28, -d / 2, h * 0.7),
            (side * w * 0.3, -d / 2, h * 0.3),
            (side * w * 0.34, -d * 0.3, h * 0.08),
        ]
        b.path(strap, w * 0.05, "fabric_dark", "straps")
    b.path(
        [
            (-w * 0.1, -d * 0.2, h * 0.92),
            (-w * 0.08, -d * 0.2, h * 0.98),
            (w * 0.08, -d * 0.2, h * 0.98),
            (w * 0.1, -d * 0.2, h * 0.92),
        ],
        w * 0.025,
        "fabric_dark",
        "loop",
    )


@recipe("paper_bag")
def paper_bag(b: Builder) -> None:
    """An open paper bag with a fold at its side and two cord handles; bread, greens and a bottle look out of it."""
    w, d, h = b.w, b.d, b.h
    top, t = h * 0.66, w * 0.015
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, t), b.mat(), "floor")
    for side in (-1, 1):
        y = sorted((side * d / 2, side * (d / 2 - t)))
        b.box((-w / 2, w / 2), (y[0], y[1]), (0, top), b.mat(), "sides")
        x = side * w / 2
        fold = [
            (x, -d / 2),
            (x - side * w * 0.08, 0.0),
            (x, d / 2),
            (x - side * t, d / 2),
            (x - side * (w * 0.08 + t), 0.0),
            (x - side * t, -d / 2),
        ]
        for part in ((0, 1, 4, 5), (1, 2, 3, 4)):
            b.prism([fold[k] for k in part], (0, top), b.mat(), "z", "sides")
        arc = [
            (math.cos(a) * w * 0.2, side * d * 0.47, top * 0.96 + math.sin(a) * h * 0.16)
            for a in (k * math.pi / 8 for k in range(9))
        ]
        b.path(arc, w * 0.016, "paper_white", "handles")
    b.box((-w * 0.18, w * 0.18), (d / 2, d / 2 + 0.001), (top * 0.3, top * 0.66), "paint_2f9a4a", "print", solid=False)
    b.rod((-w * 0.26, 0, top * 0.4), (-w * 0.3, d * 0.05, h * 0.97), d * 0.14, "food_c98a4a", "bread", 12)
    b.ball((w * 0.02, 0, top), (w * 0.16, d * 0.3, h * 0.13), "leaf_5fae3f", "greens", 10)
    b.cyl(w * 0.3, 0, (top * 0.3, top * 1.1), w * 0.1, "plastic_white", "bottle", n=14)
    b.cyl(w * 0.3, 0, (top * 1.1, h * 0.85), w * 0.05, "plastic_3a7bc8", "bottle", n=12)


@recipe("luggage_rack")
def luggage_rack(b: Builder) -> None:
    """Folding stand with straps."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.02)
        b.rod((x, -d / 2 + 0.02, 0.0), (x, d / 2 - 0.02, h - 0.02), 0.018, b.mat(), "legs", solid=True)
        b.rod((x, d / 2 - 0.02, 0.0), (x, -d / 2 + 0.02, h - 0.02), 0.018, b.mat(), "legs")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.012, h), "fabric_dark", "straps")
    for sy in (-1, 1):
        y = sy * (d / 2 - 0.018)
        b.rod((-w / 2, y, h - 0.02), (w / 2, y, h - 0.02), 0.018, b.mat(), "rails")
