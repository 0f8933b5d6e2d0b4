"""Trade: taps, belts, carts."""

import math

from mansion_assets.builder import Box, Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("beer_tap")
def beer_tap(b: Builder) -> None:
    """Tower with three taps."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.03), "metal_steel", "tray")
    b.cyl(0, -d * 0.1, (0.03, h * 0.7), 0.035, b.mat(), "tower")
    b.rod((-w * 0.46, -d * 0.1, h * 0.7), (w * 0.46, -d * 0.1, h * 0.7), 0.03, b.mat(), "arm", 12, solid=True)
    for k, color in enumerate(("plastic_black", "paint_red", "wood_walnut")):
        x = -w * 0.3 + k * w * 0.3
        b.rod((x, 0.0, h * 0.7), (x, d * 0.2, h * 0.6), 0.012, b.mat(), "taps")
        b.cyl(x, 0, (h * 0.72, h), 0.014, color, "handles", 0.02, 10, solid=False)


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


@recipe("shopping_cart")
def shopping_cart(b: Builder) -> None:
    """Wire basket on wheels, the handle behind."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    low, high = h * 0.45, h * 0.88
    for k in range(5):
        z = low + (high - low) * k / 4
        g = 0.82 + 0.18 * k / 4
        x, y0, y1 = w / 2 * g, -d * 0.4, d / 2 * g
        b.path([(-x, y0, z), (x, y0, z), (x, y1, z), (-x, y1, z), (-x, y0, z)], 0.006, m, "basket")
    for k in range(9):
        x = -w * 0.41 + k * w * 0.1025
        b.path([(x, y0, high), (x, y0, low), (x, d * 0.41, low), (x * 1.2, d / 2, high)], 0.004, m, "basket")
    for k in range(7):
        y = y0 + k * (d * 0.8) / 6.5
        for sx in (-1, 1):
            b.rod((sx * w * 0.41, y, low), (sx * w / 2, y * 1.05, high), 0.004, m, "basket", 5)
    for sx in (-1, 1):
        b.path(
            [(sx * w * 0.4, d * 0.42, 0.12), (sx * w * 0.42, -d * 0.4, 0.14), (sx * w * 0.44, -d * 0.46, h - 0.02)],
            0.012,
            m,
            "frame",
        )
    b.rod((-w / 2, -d / 2 + 0.02, h - 0.02), (w / 2, -d / 2 + 0.02, h - 0.02), 0.018, "plastic_red", "handle")
    b.wheels(0.06, 0.08)
    b.boxes.append(Box((0.0, 0.02, (low + high) / 2), (w, d * 0.9, high - low)))


@recipe("luggage_cart")
def luggage_cart(b: Builder) -> None:
    """Hotel cart with a birdcage frame."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0.2, 0.25), "fabric_red", "deck")
    b.wheels(0.1, 0.1)
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (w / 2 - 0.03), sy * (d / 2 - 0.03)
            b.path(
                [(x, y, 0.2), (x, y, h * 0.75), (x * 0.6, y * 0.5, h * 0.95), (0, 0, h - 0.03)], 0.022, b.mat(), "frame"
            )
    b.rod((-w / 2 + 0.2, 0, h * 0.9), (w / 2 - 0.2, 0, h * 0.9), 0.015, b.mat(), "bar")
    b.ball((0, 0, h - 0.02), (0.03, 0.03, 0.02), b.mat(), "knob", 8, solid=False)
    b.box((-w * 0.35, 0.0), (-d * 0.3, d * 0.3), (0.25, 0.6), "leather_brown", "cases")
    b.box((0.03, w * 0.35), (-d * 0.3, d * 0.2), (0.25, 0.5), "plastic_blue", "cases")
