"""Devices on walls and in ceilings by which people do something: hand dryers, intercoms, air vents."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("hand_dryer")
def hand_dryer(b: Builder) -> None:
    """A rounded case with a round steel button and a sign of warm air on it, and a spout that points down."""
    w, d, h = b.w, b.d, b.h
    low, front = h * 0.2, d * 0.32
    b.cushion((-w / 2, w / 2), (-d / 2, front), (low, h), b.mat(), "case", 0.4, 14)
    b.rod((0, d * 0.02, h * 0.42), (0, d * 0.16, 0), d * 0.17, "metal_chrome", "spout", 18, solid=True)
    b.rod((0, d * 0.16, 0), (0, d * 0.157, h * 0.012), d * 0.13, "plastic_black", "spout", 18)
    b.rod((0, front - 0.004, h * 0.78), (0, d / 2, h * 0.78), w * 0.15, "metal_chrome", "button", 20)
    b.rod((0, d * 0.48, h * 0.78), (0, d / 2 + 0.001, h * 0.78), w * 0.1, "metal_light", "button", 20)
    for k in range(3):
        x = (k - 1) * w * 0.16
        line = [
            (x, front + 0.001, h * 0.56),
            (x - w * 0.05, front + 0.001, h * 0.5),
            (x + w * 0.05, front + 0.001, h * 0.44),
            (x, front + 0.001, h * 0.36),
        ]
        b.path(line, w * 0.018, "paint_red", "sign")


@recipe("intercom")
def intercom(b: Builder) -> None:
    """A door telephone: a handset on its rest with a curled cord, beside a small screen and call buttons."""
    w, d, h = b.w, b.d, b.h
    back, face = -d / 2, d * 0.05
    b.cushion((-w / 2, w / 2), (back, face), (h * 0.06, h), b.mat(), "case", 0.3)
    b.box((w * 0.0, w * 0.42), (face - 0.002, face + 0.001), (h * 0.56, h * 0.88), "screen_dark", "screen", solid=False)
    for k in range(6):
        z = h * (0.44 - 0.1 * (k // 2))
        x = w * (0.1 + 0.2 * (k % 2))
        b.rod(
            (x, face - 0.002, z),
            (x, face + 0.004, z),
            w * 0.055,
            ("plastic_green", "plastic_red")[k % 2] if k < 2 else "plastic_grey",
            "buttons",
            10,
        )
    x = -w * 0.26
    b.cushion((x - w * 0.09, x + w * 0.09), (d * 0.12, d * 0.34), (h * 0.26, h * 0.86), "plastic_dark", "handset", 0.7)
    for z in ((h * 0.74, h * 0.96), (h * 0.16, h * 0.38)):
        b.cushion((x - w * 0.14, x + w * 0.14), (face - 0.002, d / 2), z, "plastic_dark", "handset", 0.6)
    coil = [
        (x + w * 0.06 * math.sin(k * 1.57), d * 0.2 + d * 0.08 * math.cos(k * 1.57), h * (0.2 - 0.2 * k / 16))
        for k in range(17)
    ]
    b.path(coil, w * 0.016, "plastic_black", "cord")


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
