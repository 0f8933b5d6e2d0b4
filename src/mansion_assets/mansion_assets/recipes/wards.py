"""Machines and furniture of wards and salons that people lie in or sit under."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("infant_incubator")
def infant_incubator(b: Builder) -> None:
    """A trolley with a clear, rounded hood over a baby on its mattress; round ports to reach in by, and a screen."""
    w, d, h = b.w, b.d, b.h
    base = float(b.p.get("base", h * 0.63))
    b.wheels(0.05, 0.1)
    b.box((-w * 0.44, w * 0.44), (-d * 0.4, d * 0.4), (0.1, 0.15), "plastic_grey", "base")
    b.box((-w * 0.12, w * 0.12), (-d * 0.2, d * 0.2), (0.15, base - 0.2), b.mat(), "column")
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (base - 0.22, base - 0.03), b.mat(), "case", 0.3)
    b.box(
        (-w * 0.2, w * 0.3),
        (d / 2 - 0.004, d / 2 + 0.002),
        (base - 0.18, base - 0.08),
        "screen_green",
        "screen",
        solid=False,
    )
    b.box((-w * 0.48, w * 0.48), (-d * 0.48, d * 0.48), (base - 0.03, base), "plastic_3a7bc8", "tray")
    b.box((-w * 0.4, w * 0.4), (-d * 0.38, d * 0.38), (base, base + 0.03), "fabric_white", "mattress")
    _baby(b, base + 0.03, w, d)
    _clear_hood(b, base)


def _clear_hood(b: Builder, base: float) -> None:
    """Clear panes with light edges over the tray at `base`, and two round ports in front."""
    w, d, h = b.w, b.d, b.h
    hood = [
        (-d * 0.47, base),
        (d * 0.47, base),
        (d * 0.47, h * 0.84),
        (d * 0.3, h),
        (-d * 0.3, h),
        (-d * 0.47, h * 0.84),
    ]
    for x in (-w * 0.47, w * 0.46):
        b.prism(hood, (x, x + w * 0.01), "glass_clear", part="hood")
    for (y0, z0), (y1, z1) in zip(hood[1:], [*hood[2:], hood[0]], strict=True):
        b.prism(
            [(y0, z0), (y1, z1), (y1 * 0.98, z1 - 0.004), (y0 * 0.98, z0)],
            (-w * 0.47, w * 0.47),
            "glass_clear",
            part="hood",
        )
        for x in (-w * 0.47, w * 0.47):
            b.rod((x, y0, z0), (x, y1, z1), 0.008, "plastic_light", "edges", 6)
    for x in (-w * 0.22, w * 0.22):
        turns = [
            (
                x + 0.085 * math.cos(k * math.pi / 8),
                d * 0.48,
                base + (h * 0.84 - base) * 0.5 + 0.085 * math.sin(k * math.pi / 8),
            )
            for k in range(17)
        ]
        b.path(turns, 0.012, "plastic_3a7bc8", "ports")


def _baby(b: Builder, z: float, w: float, d: float) -> None:
    b.cushion((-w * 0.12, w * 0.24), (-d * 0.13, d * 0.13), (z, z + 0.11), "fabric_pink", "blanket", 0.8)
    b.ball((-w * 0.22, 0, z + 0.06), (w * 0.085, d * 0.12, 0.065), "fabric_skin", "baby", 12)
    for side in (-1, 1):
        b.rod(
            (-w * 0.1, side * d * 0.1, z + 0.07),
            (-w * 0.18, side * d * 0.24, z + 0.04),
            0.022,
            "fabric_skin",
            "baby",
            8,
        )


@recipe("ventilator")
def ventilator(b: Builder) -> None:
    """A screen with curves of breath on a case with valves, on a trolley; two ribbed hoses meet in a mask in front."""
    w, d, h = b.w, b.d, b.h
    b.wheels(0.05, 0.07)
    b.box((-w * 0.46, w * 0.46), (-d * 0.46, d * 0.4), (0.08, 0.14), "plastic_grey", "base")
    b.box((-w * 0.1, w * 0.1), (-d * 0.3, -d * 0.1), (0.14, h * 0.52), "metal_light", "column")
    b.cushion((-w * 0.42, w * 0.42), (-d * 0.42, d * 0.2), (h * 0.5, h * 0.72), b.mat(), "case", 0.25)
    b.box((-w * 0.38, w * 0.38), (d * 0.2 - 0.003, d * 0.2 + 0.003), (h * 0.52, h * 0.56), "plastic_3a7bc8", "case")
    b.box((-w * 0.46, w * 0.46), (-d * 0.16, -d * 0.06), (h * 0.73, h), "plastic_dark", "screen")
    b.box(
        (-w * 0.42, w * 0.42), (-d * 0.06, -d * 0.055), (h * 0.745, h * 0.985), "plastic_black", "screen", solid=False
    )
    for k, color in enumerate(("light_e5b920", "light_green", "light_4f9bf0")):
        z = h * (0.93 - 0.07 * k)
        wave = (0.0, 0.035, 0.035, 0.006, 0.0)
        line = [(w * (-0.38 + 0.76 * j / 15), -d * 0.05, z + h * wave[j % 5]) for j in range(16)]
        b.path(line, w * 0.012, color, "curves")
    mask = (0.0, d * 0.4, h * 0.36)
    for side in (-1, 1):
        hose = [
            (side * w * 0.2, d * 0.2, h * 0.6),
            (side * w * 0.36, d * 0.38, h * 0.58),
            (side * w * 0.4, d * 0.46, h * 0.46),
            (side * w * 0.12, d * 0.46, h * 0.38),
            mask,
        ]
        b.path(hose, w * 0.045, ("plastic_4f9bf0", "plastic_white")[side > 0], "hoses")
        b.rod(hose[0], (hose[0][0], d * 0.26, h * 0.6), w * 0.07, "plastic_grey", "valves", 14)
    b.ball(mask, (w * 0.14, d * 0.08, h * 0.06), "plastic_4f9bf0", "mask", 12)
    b.ball((0, d * 0.45, h * 0.36), (w * 0.11, d * 0.05, h * 0.045), "plastic_white", "mask", 12)


@recipe("dryer_hood")
def dryer_hood(b: Builder) -> None:
    """A salon's hair dryer: a hood open below, tilted over a client's chair, with a visor, on a stand with castors."""
    w, d, h = b.w, b.d, b.h
    y = -d * 0.3
    for k in range(5):
        a = math.pi / 2 + k * 2 * math.pi / 5
        foot = (math.cos(a) * w * 0.46, y * 0.4 + math.sin(a) * d * 0.4, 0.03)
        b.rod((0, y * 0.4, 0.09), foot, 0.016, "metal_chrome", "feet")
        b.ball(foot, (0.03, 0.03, 0.03), "rubber_black", "castors", 8)
    b.rod((0, y * 0.4, 0.06), (0, y * 0.4, h * 0.5), 0.022, "metal_chrome", "pole", solid=True)
    b.path(
        [(0, y * 0.4, h * 0.5), (0, -d * 0.44, h * 0.62), (0, -d * 0.44, h * 0.86), (0, -d * 0.2, h * 0.93)],
        0.02,
        "metal_chrome",
        "arm",
    )
    _hood(b, h * 0.68)
    _chair(b, w, d, h)


def _hood(b: Builder, low: float) -> None:
    """A dome that is open below, with a rim, a grille and a control box at its side."""
    w, d, h = b.w, b.d, b.h
    b.lathe(
        [
            (0.4, low + 0.02),
            (0.42, low),
            (0.46, low),
            (0.46, low + (h - low) * 0.45),
            (0.38, low + (h - low) * 0.8),
            (0.16, h),
        ],
        b.mat(),
        (0, 0),
        "hood",
        28,
        (w, d),
    )
    b.lathe([(0.41, low - 0.003), (0.41, low + 0.004)], "plastic_black", (0, 0), "mouth", 28, (w, d), solid=False)
    b.lathe([(0.465, low), (0.465, low + 0.035)], "plastic_pink", (0, 0), "rim", 28, (w, d), solid=False)
    for k in range(3):
        b.box(
            (-w * 0.12, w * 0.12),
            (d * 0.4, d * 0.47),
            (low + 0.12 + 0.035 * k, low + 0.135 + 0.035 * k),
            "plastic_dark",
            "grille",
            solid=False,
        )
    b.box((w * 0.36, w * 0.5), (-d * 0.12, d * 0.12), (low + 0.06, low + 0.22), "plastic_dark", "control")
    for k in range(2):
        b.rod(
            (w * 0.49, d * (-0.05 + 0.1 * k), low + 0.14),
            (w / 2 + 0.006, d * (-0.05 + 0.1 * k), low + 0.14),
            0.02,
            "paint_red",
            "control",
            10,
        )


def _chair(b: Builder, w: float, d: float, h: float) -> None:
    """The seat below the hood."""
    b.cushion((-w * 0.34, w * 0.34), (-d * 0.16, d * 0.4), (h * 0.24, h * 0.31), "leather_black", "seat", 0.5)
    b.cushion((-w * 0.32, w * 0.32), (-d * 0.26, -d * 0.14), (h * 0.28, h * 0.58), "leather_black", "seat", 0.5)
    b.cyl(0, d * 0.1, (h * 0.04, h * 0.25), 0.03, "metal_chrome", "seat")
    b.cyl(0, d * 0.1, (0, h * 0.04), w * 0.3, "metal_chrome", "seat")
    for side in (-1, 1):
        b.box(
            (side * w * 0.38 - 0.025, side * w * 0.38 + 0.025),
            (-d * 0.1, d * 0.3),
            (h * 0.38, h * 0.4),
            "leather_black",
            "seat",
        )
        b.rod((side * w * 0.38, d * 0.1, h * 0.26), (side * w * 0.38, d * 0.1, h * 0.39), 0.014, "metal_chrome", "seat")
