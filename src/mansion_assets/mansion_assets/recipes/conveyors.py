"""Conveyors, baggage belts, and baggage scanners."""

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


@recipe("carousel")
def carousel(b: Builder) -> None:
    """Baggage belt of overlapping plates round a central panel, with suitcases standing on it."""
    w, d, h = b.w, b.d, b.h
    deep, floor = min(0.8, d * 0.42), h * 0.36
    r = d / 2
    half = [-math.pi / 2 + k * math.pi / 16 for k in range(17)]
    outline = [(w / 2 - r + r * math.cos(a), r * math.sin(a)) for a in half]
    outline += [(-x, -y) for x, y in outline]
    b.prism(outline, (0, floor - 0.04), b.mat(), "z", "base")
    b.prism([(x * 0.985, y * 0.97) for x, y in outline], (floor - 0.04, floor), "rubber_black", "z", "belt")
    b.box((-w / 2 + deep, w / 2 - deep), (-d / 2 + deep, d / 2 - deep), (floor, h * 0.62), b.mat(), "core")
    _belt_plates(b, deep, floor)
    cases = ("plastic_2f6fd0", "plastic_red", "leather_brown", "plastic_yellow", "plastic_26272b")
    for k, color in enumerate(cases):
        x = w * (-0.33 + 0.165 * k)
        _suitcase(b, (x, d / 2 - deep * 0.5, floor), h - floor - 0.02 - 0.06 * (k % 2), color)


def _belt_plates(b: Builder, deep: float, z: float) -> None:
    """The joints of the belt's plates: across along the straights, like spokes round the ends."""
    w, d = b.w, b.d
    r = d / 2
    count = max(6, round((w - d) / 0.3))
    for k in range(count + 1):
        x = -(w / 2 - r) + (w - d) * k / count
        for side in (-1, 1):
            b.rod((x, side * (r - deep), z), (x, side * r * 0.95, z), 0.008, "metal_grey", "plates", 6)
    for k in range(1, 8):
        a = -math.pi / 2 + k * math.pi / 8
        for side in (-1, 1):
            inner, outer = ((side * (w / 2 - r + s * math.cos(a)), s * math.sin(a), z) for s in (r - deep, r * 0.95))
            b.rod(inner, outer, 0.008, "metal_grey", "plates", 6)


def _suitcase(b: Builder, at: tuple[float, float, float], tall: float, color: str) -> None:
    """A suitcase that stands on its wheels: a ribbed shell, a grip on top, and a label that hangs from it."""
    x, y, z = at
    wide, deep, shell = tall * 0.66, tall * 0.36, tall * 0.86
    b.cushion(
        (x - wide / 2, x + wide / 2), (y - deep / 2, y + deep / 2), (z + tall * 0.04, z + shell), color, "cases", 0.2
    )
    for k in range(4):
        u = x + wide * (-0.3 + 0.2 * k)
        b.rod((u, y + deep / 2, z + tall * 0.14), (u, y + deep / 2, z + shell * 0.9), 0.012, color, "cases", 8)
    grip = [(x - wide * 0.2, y, z + shell), (x - wide * 0.2, y, z + tall), (x + wide * 0.2, y, z + tall)]
    b.path([*grip, (x + wide * 0.2, y, z + shell)], 0.014, "plastic_26272b", "grips")
    for side in (-1, 1):
        b.ball((x + side * wide * 0.36, y, z + tall * 0.04), (0.04, 0.04, 0.04), "rubber_black", "wheels", 8)
    label = (y + deep / 2 + 0.012, y + deep / 2 + 0.018)
    b.box(
        (x + wide * 0.18, x + wide * 0.34),
        label,
        (z + shell * 0.6, z + shell * 0.86),
        "paper_white",
        "labels",
        solid=False,
    )


@recipe("scanner_belt")
def scanner_belt(b: Builder) -> None:
    """Baggage scanner: tunnel over a belt that runs along y."""
    w, d, h = b.w, b.d, b.h
    b.box((-w * 0.4, w * 0.4), (-d / 2, d / 2), (0.55, 0.7), "metal_grey", "belt")
    b.box((-w * 0.36, w * 0.36), (-d / 2, d / 2), (0.7, 0.71), "rubber_black", "belt", solid=False)
    for y in (-d * 0.42, d * 0.42):
        b.box((-w * 0.36, w * 0.36), (y - 0.05, y + 0.05), (0, 0.55), "metal_dark", "legs")
    b.box((-w / 2, w / 2), (-d * 0.25, d * 0.25), (0.1, 0.6), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d * 0.25, d * 0.25), (1.12, h), b.mat(), "case")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * w * 0.38))
        b.box((lo, hi), (-d * 0.25, d * 0.25), (0.6, 1.12), b.mat(), "case")
    for sy in (-1, 1):
        for k in range(6):
            x = -w * 0.36 + k * w * 0.12
            b.box(
                (x, x + w * 0.11),
                (sy * d * 0.25 - 0.004, sy * d * 0.25 + 0.004),
                (0.72, 1.12),
                "rubber_black",
                "flaps",
                solid=False,
            )
    b.box((-0.2, 0.2), (-0.15, 0.15), (h - 0.01, h), "plastic_black", "top", solid=False)
