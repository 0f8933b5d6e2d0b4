"""Workshops, warehouses, cleaning, garden."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("conveyor")
def conveyor(b: Builder) -> None:
    """Rollers between side rails on legs, with a motor below."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2 + 0.04, d / 2 - 0.04), (h - 0.1, h - 0.06), "metal_dark", "bed")
    count = max(8, round(w / 0.11))
    for k in range(count):
        x = -w / 2 + w * (k + 0.5) / count
        b.rod((x, -d / 2 + 0.02, h - 0.03), (x, d / 2 - 0.02, h - 0.03), 0.03, "metal_chrome", "rollers", 10)
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2, sy * (d / 2 - 0.04)))
        b.box((-w / 2, w / 2), (lo, hi), (h - 0.16, h - 0.004), b.mat(), "rails")
    for k in range(max(2, round(w))):
        x = -w / 2 + 0.1 + k * (w - 0.2) / (max(2, round(w)) - 1)
        for sy in (-1, 1):
            b.box(
                (x - 0.03, x + 0.03),
                (sy * (d / 2 - 0.02) - 0.02, sy * (d / 2 - 0.02) + 0.02),
                (0, h - 0.1),
                b.mat(),
                "legs",
            )
        b.box((x - 0.02, x + 0.02), (-d / 2, d / 2), (0.2, 0.24), b.mat(), "legs", solid=False)
    b.box((w * 0.3, w * 0.42), (-d * 0.2, d * 0.2), (h - 0.32, h - 0.12), "paint_blue", "motor", solid=False)


@recipe("drill_press")
def drill_press(b: Builder) -> None:
    """Base, column, table and head with a wheel."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.07), b.mat(), "base")
    b.cyl(0, -d * 0.28, (0.07, h * 0.95), 0.05, "metal_steel", "column")
    b.box((-w * 0.4, w * 0.4), (-d * 0.2, d * 0.4), (h * 0.42, h * 0.45), "metal_grey", "table")
    b.box((-w * 0.3, w * 0.3), (-d / 2, d * 0.4), (h * 0.74, h), b.mat(), "head")
    b.cyl(0, d * 0.18, (h * 0.56, h * 0.74), 0.02, "metal_steel", "bit", n=10)
    for k in range(3):
        a = k * 2.094
        b.rod(
            (w * 0.3, d * 0.1, h * 0.82),
            (w * 0.36, d * 0.1 + 0.16 * math.cos(a), h * 0.82 + 0.16 * math.sin(a)),
            0.01,
            "metal_steel",
            "wheel",
        )


@recipe("table_saw")
def table_saw(b: Builder) -> None:
    """Table with a blade, fence and cabinet."""
    w, d, h = b.w, b.d, b.h
    z = h - 0.12
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - 0.05, z), b.mat(), "table")
    b.box((-w * 0.3, w * 0.3), (-d * 0.35, d * 0.35), (0.0, z - 0.05), "metal_dark", "cabinet")
    b.rod((-0.002, 0, z), (0.002, 0, z), 0.12, "metal_steel", "blade", 28)
    b.box((w * 0.22, w * 0.27), (-d / 2, d / 2), (z, z + 0.06), "metal_blue", "fence", solid=False)
    b.rod((-w * 0.1, d * 0.35, 0.4), (-w * 0.1, d * 0.42, 0.4), 0.07, "plastic_black", "wheel", 16)


@recipe("sewing")
def sewing(b: Builder) -> None:
    """Sewing machine on its table."""
    w, d, h = b.w, b.d, b.h
    z = 0.75
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - 0.03, z), b.mat(), "top")
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.06)
        b.box((x - 0.03, x + 0.03), (-d / 2 + 0.05, d / 2 - 0.05), (0, z - 0.03), "metal_dark", "legs")
    b.box((-0.22, 0.24), (-0.1, 0.08), (z, z + 0.05), "plastic_white", "machine")
    b.box((0.12, 0.24), (-0.08, 0.06), (z + 0.05, h), "plastic_white", "machine")
    b.box((-0.2, 0.24), (-0.07, 0.05), (h - 0.11, h), "plastic_white", "machine")
    b.cyl(-0.17, 0, (z + 0.05, h - 0.1), 0.012, "metal_steel", "needle", n=8, solid=False)
    b.rod((0.24, 0, h - 0.08), (0.27, 0, h - 0.08), 0.05, "metal_steel", "wheel", 16)
    b.box((-w * 0.45, -0.25), (-d * 0.3, d * 0.3), (z, z + 0.02), "fabric_blue", "cloth", solid=False)


@recipe("forklift")
def forklift(b: Builder) -> None:
    """Truck with mast and forks to the front."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    rear, mast = -d / 2, d * 0.08
    b.cushion((-w / 2, w / 2), (rear, mast - 0.3), (0.15, h * 0.5), m, "body", 0.2, 12)
    b.box((-w * 0.3, w * 0.3), (rear + 0.3, mast - 0.5), (h * 0.5, h * 0.56), "leather_black", "seat")
    b.box((-w * 0.3, w * 0.3), (rear + 0.28, rear + 0.4), (h * 0.54, h * 0.76), "leather_black", "seat")
    b.box((-w * 0.46, w * 0.46), (mast - 0.35, mast - 0.1), (0.2, h * 0.48), m, "front")
    for sx in (-1, 1):
        b.rod((sx * w * 0.42, rear + 0.25, h * 0.45), (sx * w * 0.4, rear + 0.35, h - 0.03), 0.03, "metal_dark", "cage")
        b.rod((sx * w * 0.42, mast - 0.2, h * 0.45), (sx * w * 0.4, mast - 0.35, h - 0.03), 0.03, "metal_dark", "cage")
        b.box((sx * w * 0.28 - 0.05, sx * w * 0.28 + 0.05), (mast, mast + 0.1), (0.05, h), "metal_dark", "mast")
        b.box((sx * w * 0.25 - 0.07, sx * w * 0.25 + 0.07), (mast + 0.1, d / 2), (0.03, 0.08), "metal_dark", "forks")
        for y, r in ((rear + 0.45, 0.22), (mast - 0.18, 0.28)):
            b.rod((sx * w * 0.36, y, r), (sx * w * 0.5, y, r), r, "rubber_black", "wheels", 20)
    b.box((-w * 0.42, w * 0.42), (rear + 0.3, mast - 0.3), (h - 0.06, h - 0.02), "metal_dark", "cage", solid=False)
    b.box((-w * 0.4, w * 0.4), (mast + 0.1, mast + 0.15), (0.06, h * 0.35), "metal_dark", "carriage")


@recipe("pallet_jack")
def pallet_jack(b: Builder) -> None:
    """Two forks and a drawbar."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        b.box((sx * w * 0.35 - 0.08, sx * w * 0.35 + 0.08), (-d * 0.25, d / 2), (0.06, 0.12), b.mat(), "forks")
        b.rod(
            (sx * w * 0.35 - 0.05, d * 0.42, 0.04),
            (sx * w * 0.35 + 0.05, d * 0.42, 0.04),
            0.04,
            "rubber_black",
            "wheels",
            12,
        )
    b.box((-w / 2, w / 2), (-d * 0.34, -d * 0.22), (0.06, 0.4), b.mat(), "body")
    b.rod((-0.08, -d * 0.3, 0.09), (0.08, -d * 0.3, 0.09), 0.09, "rubber_black", "wheels", 16)
    b.rod((0, -d * 0.32, 0.35), (0, -d * 0.46, h - 0.1), 0.025, b.mat(), "drawbar", solid=True)
    b.path(
        [
            (-0.14, -d / 2 + 0.02, h - 0.12),
            (-0.14, -d / 2 + 0.02, h - 0.02),
            (0.14, -d / 2 + 0.02, h - 0.02),
            (0.14, -d / 2 + 0.02, h - 0.12),
            (-0.14, -d / 2 + 0.02, h - 0.12),
        ],
        0.018,
        "plastic_black",
        "handle",
    )


@recipe("hand_truck")
def hand_truck(b: Builder) -> None:
    """Frame with a plate and two wheels."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.06)
        b.path(
            [(x, d * 0.1, 0.02), (x, -d * 0.2, h * 0.75), (x * 0.8, -d / 2 + 0.02, h - 0.02)], 0.018, b.mat(), "frame"
        )
        b.rod((sx * (w / 2 - 0.05), -d * 0.1, 0.13), (sx * w / 2, -d * 0.1, 0.13), 0.13, "rubber_black", "wheels", 18)
    for z in (0.3, 0.6, 0.9):
        y = d * 0.1 - 0.3 * d * z / (h * 0.75)
        b.box((-w / 2 + 0.06, w / 2 - 0.06), (y - 0.01, y + 0.01), (z, z + 0.03), b.mat(), "bars")
    b.box((-w * 0.4, w * 0.4), (0.02, d / 2), (0, 0.02), b.mat(), "plate")
    b.rod((-w * 0.3, -d / 2 + 0.02, h - 0.02), (w * 0.3, -d / 2 + 0.02, h - 0.02), 0.018, "plastic_black", "grip")


@recipe("ladder")
def ladder(b: Builder) -> None:
    """Step ladder."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.02)
        b.prism(
            [(d / 2, 0), (d / 2 - 0.05, 0), (-0.04, h - 0.03), (0.02, h - 0.03)],
            (x - 0.02, x + 0.02),
            b.mat(),
            part="rails",
        )
        b.rod((x, -d / 2 + 0.015, 0), (x, -0.02, h - 0.05), 0.014, b.mat(), "rails")
    count = max(4, round(h / 0.28))
    for k in range(1, count):
        z = k * h / count
        y = d / 2 - 0.03 - (d / 2) * z / h
        b.box((-w / 2 + 0.02, w / 2 - 0.02), (y - 0.04, y + 0.04), (z, z + 0.025), b.mat(), "steps")
    b.box((-w / 2, w / 2), (-0.1, 0.1), (h - 0.03, h), "plastic_red", "top")


@recipe("mop_bucket")
def mop_bucket(b: Builder) -> None:
    """Bucket on castors with a wringer and a mop."""
    w, d, h = b.w, b.d, b.h
    b.wheels(0.035, 0.06)
    b.lathe([(0.4, 0.06), (0.5, 0.4), (0.46, 0.4), (0.36, 0.1)], b.mat(), stretch=(w, d), part="bucket", n=22)
    b.box((-w * 0.3, w * 0.3), (-d * 0.42, 0.0), (0.36, 0.55), b.mat(), "wringer")
    b.rod((0.05, 0.02, 0.15), (0.1, -d * 0.4, h - 0.02), 0.013, "wood_oak", "mop")
    b.ball((0.05, 0.04, 0.3), (0.1, 0.08, 0.12), "fabric_white", "mop", 8, solid=False)
    b.box((0.08, 0.12), (-d / 2, -d * 0.4), (h - 0.05, h), "plastic_blue", "grip", solid=False)


@recipe("mower")
def mower(b: Builder) -> None:
    """Lawn mower with grass box and handle."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2 + 0.04, w / 2 - 0.04), (0.0, d / 2), (0.06, 0.3), b.mat(), "deck", 0.5)
    b.cyl(0, d * 0.25, (0.28, 0.45), 0.14, "plastic_black", "motor")
    b.cushion((-w * 0.4, w * 0.4), (-d * 0.36, 0.0), (0.08, 0.45), "fabric_dark", "box", 0.4)
    for sx in (-1, 1):
        b.path([(sx * w * 0.4, 0.0, 0.25), (sx * w * 0.4, -d / 2 + 0.02, h - 0.02)], 0.015, "metal_steel", "handle")
        for y in (0.12, d * 0.42):
            b.rod((sx * (w / 2 - 0.05), y, 0.1), (sx * w / 2, y, 0.1), 0.1, "rubber_black", "wheels", 16)
    b.rod((-w * 0.4, -d / 2 + 0.02, h - 0.02), (w * 0.4, -d / 2 + 0.02, h - 0.02), 0.016, "rubber_black", "handle")


@recipe("grill")
def grill(b: Builder) -> None:
    """Gas barbecue with side tables."""
    w, d, h = b.w, b.d, b.h
    bw = w * 0.5
    b.box((-bw / 2, bw / 2), (-d / 2, d / 2 - 0.04), (0.1, h * 0.62), b.mat(), "cabinet")
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.04), (h * 0.74, h * 0.77), "metal_steel", "tables")
    b.box((-bw / 2, bw / 2), (-d / 2, d / 2 - 0.02), (h * 0.62, h * 0.76), "metal_steel", "panel")
    b.cushion((-bw / 2, bw / 2), (-d / 2, d / 2 - 0.05), (h * 0.74, h), b.mat(), "lid", 0.6, 14)
    b.rod((-bw * 0.35, d / 2 - 0.02, h * 0.86), (bw * 0.35, d / 2 - 0.02, h * 0.86), 0.015, "metal_steel", "handle")
    for k in range(4):
        b.rod(
            (-bw * 0.35 + k * bw * 0.23, d / 2 - 0.03, h * 0.69),
            (-bw * 0.35 + k * bw * 0.23, d / 2, h * 0.69),
            0.025,
            "plastic_black",
            "knobs",
            12,
        )
    b.legs((0, 0.12), 0.03, "plastic_black", w * 0.25)
