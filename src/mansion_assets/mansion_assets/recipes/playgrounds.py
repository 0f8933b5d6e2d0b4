"""Equipment of playgrounds."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("slide")
def slide(b: Builder) -> None:
    """Ladder behind, chute to the front."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.72
    y = -d * 0.22
    b.prism(
        [
            (d / 2, 0.05),
            (d / 2, 0.09),
            (d * 0.3, 0.1),
            (y, top + 0.02),
            (-d * 0.36, top + 0.02),
            (-d * 0.36, top - 0.03),
            (y, top - 0.03),
        ],
        (-w * 0.42, w * 0.42),
        "plastic_yellow",
        part="chute",
    )
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * w * 0.42))
        b.prism([(d / 2, 0.0), (d / 2, 0.14), (y, top + 0.14), (y, top - 0.06)], (lo, hi), b.mat(), part="sides")
        b.rod(
            (sx * (w / 2 - 0.02), -d / 2 + 0.02, 0),
            (sx * (w / 2 - 0.02), -d * 0.34, h - 0.02),
            0.02,
            b.mat(),
            "posts",
            solid=True,
        )
        b.rod((sx * (w / 2 - 0.02), -d * 0.34, h - 0.02), (sx * (w / 2 - 0.02), y, top + 0.1), 0.02, b.mat(), "rails")
    for k in range(4):
        z = 0.15 + k * top / 4.4
        b.box(
            (-w / 2, w / 2),
            (-d / 2 + 0.01 + k * 0.03, -d / 2 + 0.07 + k * 0.03),
            (z, z + 0.03),
            "plastic_blue",
            "steps",
        )
    b.box((-w / 2, w / 2), (-d * 0.36, -d * 0.34), (h - 0.03, h), b.mat(), "rails", solid=False)


@recipe("sandbox")
def sandbox(b: Builder) -> None:
    """A square of boards with seats in its corners, full of sand, with a castle, a bucket and a spade."""
    w, d, h = b.w, b.d, b.h
    t, sand = 0.05, h * 0.45
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, d / 2 - t), (0, sand), "food_e2c98a", "sand")
    for side in (-1, 1):
        x, y = sorted((side * w / 2, side * (w / 2 - t))), sorted((side * d / 2, side * (d / 2 - t)))
        b.box((x[0], x[1]), (-d / 2, d / 2), (0, h * 0.65), b.mat(), "boards")
        b.box((-w / 2, w / 2), (y[0], y[1]), (0, h * 0.65), b.mat(), "boards")
        for other in (-1, 1):
            corner = [(side * w / 2, other * d / 2), (side * w * 0.28, other * d / 2), (side * w / 2, other * d * 0.28)]
            b.prism(corner, (h * 0.62, h * 0.7), b.mat(), "z", "seats")
    for k, (u, v) in enumerate(((-0.16, -0.1), (0.04, -0.1), (-0.16, 0.1), (0.04, 0.1), (-0.06, 0.0))):
        high = h if k == 4 else h * 0.85
        b.cyl(w * u, d * v, (sand, high), w * 0.055, "food_d3b36a", "castle", w * 0.04, n=12)
    b.box((-w * 0.16, w * 0.04), (-d * 0.1, d * 0.1), (sand, h * 0.66), "food_d3b36a", "castle")
    b.lathe(
        [(0.06, sand), (0.09, sand + h * 0.4), (0.08, sand + h * 0.4), (0.05, sand + h * 0.1)],
        "plastic_red",
        (w * 0.24, d * 0.1),
        "bucket",
        16,
        (w, w),
    )
    b.rod((w * 0.1, d * 0.3, sand + 0.015), (w * 0.26, d * 0.26, sand + 0.015), 0.014, "wood_oak", "spade")
    b.box((w * 0.02, w * 0.11), (d * 0.26, d * 0.34), (sand, sand + 0.015), "plastic_3a7bc8", "spade")


@recipe("trampoline")
def trampoline(b: Builder) -> None:
    """Round mat in a padded ring on legs."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.42, h - 0.03), (0.5, h - 0.05), (0.5, h), (0.42, h)], "plastic_blue", stretch=(w, d), part="ring", n=32)
    b.lathe([(0.42, h - 0.035), (0.42, h - 0.02)], b.mat(), stretch=(w, d), part="mat", n=32)
    for k in range(6):
        a = k * math.pi / 3
        b.cyl(math.cos(a) * w * 0.46, math.sin(a) * d * 0.46, (0, h - 0.05), 0.016, "metal_steel", "legs", n=8)
