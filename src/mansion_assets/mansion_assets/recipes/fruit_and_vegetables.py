"""Fruit and vegetables, told apart by their shape, stalks, leaves and skins."""

import math

import numpy as np

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe
from mansion_assets.solids import sheet
from mansion_geometry.compiled import Floats

__all__: list[str] = []


@recipe("ball")
def ball(b: Builder) -> None:
    """Round things: apples, potatoes, half shells."""
    w, d, h = b.w, b.d, b.h
    style = b.p.get("style", "plain")
    if style == "dome":
        b.lathe(
            [(0.5, 0), (0.5, h * 0.12), (0.42, h * 0.16), (0.36, h * 0.6), (0.18, h * 0.95), (0.02, h)],
            b.mat(),
            stretch=(w, d),
            n=20,
        )
        return
    top = h * (0.93 if style == "apple" else 1.0)
    b.ball((0, 0, top / 2), (w / 2, d / 2, top / 2), b.mat(), "body", 16)
    if style == "apple":
        b.rod((0, 0, top * 0.95), (0, 0, h), max(0.002, w * 0.03), "wood_brown", "stalk", 6)


@recipe("banana")
def banana(b: Builder) -> None:
    """A bent fruit."""
    w, d, h = b.w, b.d, b.h
    points = [
        (-w * 0.46, d * 0.3, h * 0.5),
        (-w * 0.3, -d * 0.1, h * 0.5),
        (0, -d * 0.3, h * 0.5),
        (w * 0.3, -d * 0.1, h * 0.5),
        (w * 0.46, d * 0.3, h * 0.5),
    ]
    b.path(points, h * 0.4, b.mat(), "fruit")
    b.boxes.append(b.whole_box())
    b.rod(points[-1], (w / 2, d / 2, h * 0.5), h * 0.15, "food_brown", "tip")


def _leaf(b: Builder, start: tuple[float, float, float], end: tuple[float, float, float]) -> None:
    """Add a leaf between two points, thick in its middle."""
    middle = tuple((s + e) / 2 for s, e in zip(start, end, strict=True))
    size = math.dist(start, end)
    b.ball(
        (middle[0], middle[1], middle[2]),
        (abs(end[0] - start[0]) / 2 + size * 0.12, abs(end[1] - start[1]) / 2 + size * 0.16, size * 0.07),
        "leaf_3f8f3a",
        "leaf",
        10,
    )


@recipe("orange")
def orange(b: Builder) -> None:
    """An orange with the green star of its stalk and a leaf, beside it two segments with their white skin."""
    w, d, h = b.w, b.d, b.h
    r = w * 0.42
    x, y = w * 0.06, -d * 0.06
    b.ball((x, y, h * 0.46), (r, r, h * 0.46), "food_ee8420", "fruit", 20)
    for k in range(5):
        a = k * math.tau / 5
        b.rod(
            (x, y, h * 0.92),
            (x + math.cos(a) * r * 0.16, y + math.sin(a) * r * 0.16, h * 0.9),
            r * 0.06,
            "leaf_green",
            "star",
            6,
        )
    b.cyl(x, y, (h * 0.9, h * 0.97), r * 0.06, "wood_brown", "stalk", n=8)
    _leaf(b, (x, y, h * 0.94), (x - r * 0.8, y + r * 0.4, h * 0.98))
    for k in range(14):
        a, t = k * 2.4, math.radians(-40 + 7 * k)
        spot = (
            x + math.cos(a) * math.cos(t) * r * 0.985,
            y + math.sin(a) * math.cos(t) * r * 0.985,
            h * 0.46 + math.sin(t) * h * 0.455,
        )
        b.ball(spot, (r * 0.035, r * 0.035, r * 0.035), "food_d96f14", "pores", 6)
    s = d * 0.3
    cut = (-w * 0.24, d * 0.34)
    b.cyl(*cut, (0, h * 0.14), s * 0.66, "food_ee8420", "slice", n=20)
    b.cyl(*cut, (h * 0.14, h * 0.16), s * 0.6, "food_fbe7c6", "slice", n=20)
    for k in range(8):
        a = k * math.pi / 4
        b.rod(
            (cut[0] + math.cos(a) * s * 0.1, cut[1] + math.sin(a) * s * 0.1, h * 0.155),
            (cut[0] + math.cos(a) * s * 0.44, cut[1] + math.sin(a) * s * 0.44, h * 0.155),
            s * 0.11,
            "food_f59a35",
            "slice",
            6,
        )


@recipe("lemon")
def lemon(b: Builder) -> None:
    """A yellow fruit pointed at both ends, with a leaf, and the half of another with its segments."""
    w, d, h = b.w, b.d, b.h
    b.ball((w * 0.08, -d * 0.06, h * 0.5), (w * 0.38, d * 0.34, h * 0.46), "food_f2d22e", "fruit", 18)
    for side in (-1, 1):
        y = -d * 0.06 + side * d * 0.33
        b.rod(
            (w * 0.08, y - side * d * 0.05, h * 0.5),
            (w * 0.08, y + side * d * 0.07, h * 0.5),
            h * 0.13,
            "food_f2d22e",
            "tips",
            12,
        )
    b.rod((w * 0.08, -d * 0.44, h * 0.5), (w * 0.08, -d / 2, h * 0.52), h * 0.06, "leaf_green", "stalk", 8)
    _leaf(b, (w * 0.08, -d * 0.42, h * 0.62), (w * 0.42, -d * 0.2, h * 0.98))
    x, y, r = -w * 0.26, d * 0.26, h * 0.36
    b.rod((x, y - d * 0.06, r), (x, y + d * 0.08, r), r, "food_f2d22e", "half", 20)
    b.rod((x, y + d * 0.08, r), (x, y + d * 0.085, r), r * 0.92, "food_fdf6d8", "half", 20)
    for k in range(8):
        a = k * math.pi / 4
        b.rod(
            (x + math.cos(a) * r * 0.2, y + d * 0.088, r + math.sin(a) * r * 0.2),
            (x + math.cos(a) * r * 0.7, y + d * 0.088, r + math.sin(a) * r * 0.7),
            r * 0.17,
            "food_f7e26a",
            "half",
            6,
        )


@recipe("tomato")
def tomato(b: Builder) -> None:
    """A flat red fruit in soft ribs, with the green star of its calyx and a bent stalk."""
    w, d, h = b.w, b.d, b.h
    high = h * 0.84
    b.ball((0, 0, high / 2), (w * 0.46, d * 0.46, high * 0.5), "food_d8281e", "fruit", 20)
    for k in range(6):
        a = k * math.pi / 3
        b.ball(
            (math.cos(a) * w * 0.2, math.sin(a) * d * 0.2, high * 0.49),
            (w * 0.3, d * 0.3, high * 0.48),
            "food_d8281e",
            "ribs",
            14,
        )
    for k in range(6):
        a = k * math.pi / 3 + 0.3
        points = [
            (0, 0, high * 0.97),
            (math.cos(a) * w * 0.16, math.sin(a) * d * 0.16, high * 1.02),
            (math.cos(a) * w * 0.32, math.sin(a) * d * 0.32, high * 0.94),
        ]
        b.path([(float(x), float(y), float(z)) for x, y, z in points], w * 0.028, "leaf_3f8f3a", "calyx")
    b.path([(0, 0, high * 0.96), (0, 0, high * 1.08), (w * 0.06, d * 0.04, h)], w * 0.026, "leaf_4f7f2f", "stalk")


@recipe("lettuce")
def lettuce(b: Builder) -> None:
    """A head of lettuce: rings of frilly leaves with pale stalks and ribs, open round a yellow heart."""
    w, d, h = b.w, b.d, b.h
    b.ball((0, 0, h * 0.36), (w * 0.27, d * 0.27, h * 0.36), "food_e8f0b0", "heart", 12)
    rings = ((7, 0.5, 0.6, "food_3f8f2f"), (6, 0.4, 0.82, "food_6fb83f"), (5, 0.27, 1.0, "food_a8d860"))
    thick = min(w, h) * 0.012
    for number, (count, reach, high, color) in enumerate(rings):
        for k in range(count):
            angle = math.tau * (k + 0.37 * number) / count
            leaf = _frilly_leaf(b, angle, (reach, high), 1.5 * math.pi / count, 9)
            b.raw(*sheet(leaf[:3], thick), "food_d2e8a4", "stalks")
            b.raw(*sheet(leaf[2:], thick), color, "leaves")
            rib = _frilly_leaf(b, angle, (reach * 1.03, high), 0.16 * math.pi / count, 2)
            b.raw(*sheet(rib[2:-1], thick), "food_dff0b8", "ribs")


def _frilly_leaf(b: Builder, angle: float, size: tuple[float, float], wide: float, columns: int) -> Floats:
    """Return the grid of a leaf, (rows, columns, 3), from its stalk upwards: broad at its tip and waved at its edge.

    `size` is how far it reaches out, as a share of the width, and how high, as a share of the height.
    """
    rows, (reach, high) = 6, size
    grid = np.empty((rows, columns, 3))
    for i in range(rows):
        up = i / (rows - 1)
        half = wide * math.sin(math.pi * (0.14 + 0.56 * up))
        for j in range(columns):
            side = 1 - 2 * j / (columns - 1)
            wave = math.sin(j * 2.6 + 3 * angle) * up * up * (0.3 + 0.7 * abs(side))
            out = (0.12 + (reach - 0.12) * math.sin(up * math.pi * 0.62)) * (1 + 0.2 * wave)
            turn = angle + side * half
            level = high * (0.04 + 0.9 * up**1.3 - 0.12 * side * side * up + 0.07 * wave)
            grid[i, j] = math.cos(turn) * out * b.w, math.sin(turn) * out * b.d, b.h * level
    return grid
