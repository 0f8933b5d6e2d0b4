"""Radiators, fireplaces, thermostats, fans and air outlets."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("radiator")
def radiator(b: Builder) -> None:
    """Ribbed radiator with a valve."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2 - 0.06), (-d * 0.3, d * 0.3), (0.04, h - 0.04), b.mat(), "core")
    count = round(w / 0.06)
    for k in range(count - 1):
        x = -w / 2 + k * w / count
        b.box((x + 0.008, x + 0.05), (-d / 2, d / 2), (0, h), b.mat(), "ribs", solid=False)
    b.cyl(w / 2 - 0.025, 0, (0.06, 0.14), 0.025, "plastic_white", "valve", solid=False)


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


@recipe("thermostat")
def thermostat(b: Builder) -> None:
    """A round dial on a square plate: a ring of marks from blue to red about a dark face with the figure 21."""
    w, d, h = b.w, b.d, b.h
    plate, r, z = -d * 0.2, min(w, h) * 0.45, h / 2
    b.cushion((-w / 2, w / 2), (-d / 2, plate), (0, h), b.mat(), "plate", 0.3)
    b.rod((0, plate - 0.001, z), (0, d * 0.42, z), r, "metal_chrome", "dial", 32)
    b.rod((0, d * 0.4, z), (0, d * 0.46, z), r * 0.9, "plastic_black", "face", 32)
    for k in range(15):
        a = math.radians(-40 + 260 * k / 14)
        start, end = ((math.cos(a) * r * s, d * 0.46, z + math.sin(a) * r * s) for s in (0.68, 0.84))
        b.rod(start, end, r * 0.035, "light_4f9bf0" if k > 9 else "light_red" if k < 5 else "light_white", "marks", 4)
    y = (d * 0.46, d / 2)
    x, s = r * 0.24, r * 0.2
    for level in (0.0, 1.0, 2.0):
        b.box(
            (x - s * 0.7, x + s * 0.7),
            y,
            (z + (level - 1) * s * 1.4 - s * 0.14, z + (level - 1) * s * 1.4 + s * 0.14),
            "light_white",
            "figure",
            solid=False,
        )
    b.box((x - s * 0.7, x - s * 0.42), y, (z, z + s * 1.4), "light_white", "figure", solid=False)
    b.box((x + s * 0.42, x + s * 0.7), y, (z - s * 1.4, z), "light_white", "figure", solid=False)
    b.box((-x - s * 0.14, -x + s * 0.14), y, (z - s * 1.5, z + s * 1.5), "light_white", "figure", solid=False)


@recipe("fan")
def fan(b: Builder) -> None:
    """Ceiling fan with four blades."""
    w, d, h = b.w, b.d, b.h
    b.cyl(0, 0, (h * 0.35, h), 0.015, "metal_steel", "rod")
    b.lathe(
        [(0.03, 0), (0.09, h * 0.1), (0.1, h * 0.35), (0.04, h * 0.42)], "metal_steel", part="hub", stretch=(1.0, 1.0)
    )
    b.box((-w / 2, w / 2), (-0.07, 0.07), (h * 0.24, h * 0.27), b.mat(), "blades")
    b.box((-0.07, 0.07), (-d / 2, d / 2), (h * 0.24, h * 0.27), b.mat(), "blades")


@recipe("air_vent")
def air_vent(b: Builder) -> None:
    """A square outlet: a frame, and rings of vanes within it, which lean outwards, over a dark duct."""
    w, d, h = b.w, b.d, b.h
    b.box((-w * 0.4, w * 0.4), (-d * 0.4, d * 0.4), (h * 0.4, h * 0.6), "plastic_black", "duct")
    for k in range(4):
        outer = 0.5 - 0.11 * k
        inner = outer - (0.07 if k == 0 else 0.045)
        for side in (-1, 1):
            across = sorted((side * w * outer, side * w * inner))
            along = sorted((side * d * outer, side * d * inner))
            b.box((across[0], across[1]), (-d * outer, d * outer), (0, h), b.mat(), "vanes")
            b.box((-w * outer, w * outer), (along[0], along[1]), (0, h), b.mat(), "vanes")
    b.box((-w * 0.06, w * 0.06), (-d * 0.06, d * 0.06), (0, h), b.mat(), "middle")
