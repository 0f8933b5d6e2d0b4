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
    """Baggage belt round a central panel, with cases on it."""
    w, d, h = b.w, b.d, b.h
    ring = min(0.8, d * 0.42)
    outline = []
    r = d / 2
    for k in range(17):
        a = -math.pi / 2 + k * math.pi / 16
        outline.append((w / 2 - r + r * math.cos(a), r * math.sin(a)))
    outline += [(-x, -y) for x, y in outline]
    b.prism(outline, (0, h * 0.6), b.mat(), "z", "base")
    b.prism([(x * 0.985, y * 0.97) for x, y in outline], (h * 0.6, h * 0.66), "rubber_black", "z", "belt")
    b.box((-w / 2 + ring, w / 2 - ring), (-d / 2 + ring, d / 2 - ring), (h * 0.6, h), b.mat(), "core")
    for k, color in enumerate(("plastic_blue", "plastic_red", "leather_brown")):
        x = -w * 0.3 + k * w * 0.28
        b.cushion((x, x + 0.5), (d / 2 - ring + 0.1, d / 2 - ring + 0.45), (h * 0.66, h * 0.98), color, "cases", 0.3)


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
