"""Games, water and fire."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("pingpong")
def pingpong(b: Builder) -> None:
    """Table tennis: the net lies across."""
    w, d, h = b.w, b.d, b.h
    z = h - 0.15
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - 0.025, z), b.mat(), "top")
    b.box((-0.01, 0.01), (-d / 2, d / 2), (z, z + 0.001), "plastic_white", "lines", solid=False)
    for sx in (-1, 1):
        for sy in (-1, 1):
            b.box(
                (sx * w * 0.36 - 0.025, sx * w * 0.36 + 0.025),
                (sy * d * 0.3 - 0.025, sy * d * 0.3 + 0.025),
                (0, z),
                "metal_black",
                "legs",
            )
            lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.02)))
            b.box((lo, hi), (-d / 2, d / 2), (z, z + 0.001), "plastic_white", "lines", solid=False)
    b.box((-w / 2, w / 2), (-0.004, 0.004), (z, h), "fabric_dark", "net")


@recipe("pool_table")
def pool_table(b: Builder) -> None:
    """Cloth, rails, pockets and balls; air hockey has a white top and no balls."""
    w, d, h = b.w, b.d, b.h
    rail = 0.13
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, d / 2 - 0.05), (h - 0.3, h - 0.05), "wood_walnut", "body")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - rail)))
        b.box((lo, hi), (-d / 2, d / 2), (h - 0.12, h), "wood_walnut", "rails")
        for sy in (-1, 1):
            b.lathe(
                [(0.09, 0), (0.06, h * 0.2), (0.1, h - 0.3)],
                "wood_walnut",
                (sx * (w / 2 - 0.2), sy * (d / 2 - 0.25)),
                "legs",
                14,
            )
            b.cyl(
                sx * (w / 2 - rail),
                sy * (d / 2 - rail),
                (h - 0.02, h + 0.0),
                0.06,
                "leather_black",
                "pockets",
                n=14,
                solid=False,
            )
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2, sy * (d / 2 - rail)))
        b.box((-w / 2, w / 2), (lo, hi), (h - 0.12, h), "wood_walnut", "rails")
    b.box((-w / 2 + rail, w / 2 - rail), (-d / 2 + rail, d / 2 - rail), (h - 0.06, h - 0.035), b.mat(), "cloth")
    if b.mat().startswith("fabric"):
        for k in range(10):
            row = int((math.sqrt(8 * k + 1) - 1) / 2)
            x = (k - row * (row + 1) / 2 - row / 2) * 0.06
            b.ball(
                (x, -d * 0.2 - row * 0.052, h - 0.007),
                (0.028, 0.028, 0.028),
                ("paint_red", "paint_yellow", "paint_blue", "paint_green")[k % 4],
                "balls",
                8,
                solid=False,
            )
        b.ball((0, d * 0.25, h - 0.007), (0.028, 0.028, 0.028), "plastic_white", "balls", 8, solid=False)


@recipe("foosball")
def foosball(b: Builder) -> None:
    """Table football."""
    w, d, h = b.w, b.d, b.h
    bw = w - 0.3 if w > 1.3 else w * 0.8
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2, sy * (d / 2 - 0.04)))
        b.box((-bw / 2, bw / 2), (lo, hi), (h - 0.28, h), b.mat(), "box")
    for sx in (-1, 1):
        lo, hi = sorted((sx * bw / 2, sx * (bw / 2 - 0.04)))
        b.box((lo, hi), (-d / 2, d / 2), (h - 0.28, h), b.mat(), "box")
        for sy in (-1, 1):
            x, y = sx * (bw / 2 - 0.06), sy * (d / 2 - 0.06)
            b.box((x - 0.05, x + 0.05), (y - 0.05, y + 0.05), (0, h - 0.2), b.mat(), "legs")
    b.box((-bw / 2, bw / 2), (-d / 2, d / 2), (h - 0.2, h - 0.18), "plastic_green", "field")
    for k in range(6):
        x = -bw * 0.4 + k * bw * 0.16
        b.rod((x, -d / 2, h - 0.06), (x, d / 2, h - 0.06), 0.009, "metal_steel", "rods")
        for j in range(3):
            b.box(
                (x - 0.012, x + 0.012),
                (-d * 0.3 + j * d * 0.3 - 0.015, -d * 0.3 + j * d * 0.3 + 0.015),
                (h - 0.16, h - 0.03),
                ("plastic_red", "plastic_blue")[k % 2],
                "men",
                solid=False,
            )
    b.rod((-w / 2, 0, h - 0.1), (w / 2, 0, h - 0.1), 0.012, "plastic_black", "grips")


@recipe("pool")
def pool(b: Builder) -> None:
    """Raised basin: hot tub with water, or a pit of balls."""
    w, d, h = b.w, b.d, b.h
    t = min(0.18, w * 0.12)
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - t)))
        b.cushion((lo, hi), (-d / 2, d / 2), (0, h), b.mat(), "rim", 0.3)
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2, sy * (d / 2 - t)))
        b.cushion((-w / 2, w / 2), (lo, hi), (0, h), b.mat(), "rim", 0.3)
    if b.p.get("fill") == "balls":
        n = 8
        for i in range(n):
            for j in range(n):
                x, y = (-w / 2 + t + (i + 0.5) * (w - 2 * t) / n, -d / 2 + t + (j + 0.5) * (d - 2 * t) / n)
                b.ball(
                    (x, y, h * 0.6 + 0.02 * ((i + j) % 3)),
                    (0.07, 0.07, 0.07),
                    ("plastic_red", "plastic_yellow", "plastic_blue", "plastic_green")[(i * 3 + j) % 4],
                    "balls",
                    8,
                    solid=False,
                )
        b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, d / 2 - t), (0, h * 0.55), "plastic_blue", "floor")
    else:
        b.box(
            (-w / 2 + t * 0.8, w / 2 - t * 0.8),
            (-d / 2 + t * 0.8, d / 2 - t * 0.8),
            (0, h * 0.86),
            "glass_blue",
            "water",
        )


@recipe("fountain")
def fountain(b: Builder) -> None:
    """Two bowls and a spout."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.5, 0), (0.5, h * 0.3), (0.45, h * 0.3), (0.44, h * 0.22)], b.mat(), stretch=(w, d), n=32)
    b.cyl(0, 0, (h * 0.22, h * 0.25), w * 0.44, "glass_blue", "water", n=32, solid=False)
    b.lathe(
        [(0.08, h * 0.2), (0.05, h * 0.55), (0.24, h * 0.68), (0.22, h * 0.68), (0.04, h * 0.6)],
        b.mat(),
        stretch=(w, d),
        n=24,
        part="bowl",
    )
    b.cyl(0, 0, (h * 0.6, h), w * 0.03, b.mat(), "spout", w * 0.01)


@recipe("hearth")
def hearth(b: Builder) -> None:
    """Fireplace with logs and flames."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.07, h), b.mat(), "mantel")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w * 0.46, sx * w * 0.28))
        b.box((lo, hi), (-d / 2, d / 2 - 0.04), (0, h - 0.07), b.mat(), "sides")
    b.box((-w * 0.28, w * 0.28), (-d / 2, d / 2 - 0.04), (h * 0.68, h - 0.07), b.mat(), "front")
    b.box((-w * 0.28, w * 0.28), (-d / 2, -d / 2 + 0.05), (0, h * 0.68), "stone_black", "back")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.05), b.mat(), "floor")
    for k in range(3):
        b.rod(
            (-w * 0.2, -0.02 + 0.05 * k, 0.1 + 0.03 * (k % 2)),
            (w * 0.2, 0.03 - 0.03 * k, 0.1),
            0.035,
            "wood_brown",
            "logs",
        )
        b.ball(((k - 1) * w * 0.1, 0, 0.24), (0.05, 0.04, 0.12), "light_orange", "fire", 8, solid=False)
