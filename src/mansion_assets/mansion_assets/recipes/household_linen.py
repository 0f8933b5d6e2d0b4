"""Household linen: pillows, blankets, towels, cloths and sheets."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("pillow")
def pillow(b: Builder) -> None:
    """A cushion, thick in the middle."""
    b.cushion((-b.w / 2, b.w / 2), (-b.d / 2, b.d / 2), (0, b.h), b.mat(), "pillow", 0.95, 16)


@recipe("textile")
def textile(b: Builder) -> None:
    """Cloth that hangs in folds, or lies folded in a stack."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    if b.p.get("style") == "stack":
        count = max(2, round(h / 0.05))
        for k in range(count):
            color = main if k % 2 == 0 else "fabric_light"
            b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (h * k / count, h * (k + 1) / count), color, "folds", 0.8, 8)
        return
    for k in range(5):
        x0 = -w / 2 + k * w / 5
        b.cushion((x0, x0 + w / 5), (-d / 2, d / 2), (0, h), main, "cloth", 0.9, 8)


@recipe("folded_blanket")
def folded_blanket(b: Builder) -> None:
    """A thick blanket in checks, folded twice so that its edges are round, with a fringe at its ends."""
    w, d, h = b.w, b.d, b.h
    checks = "fabric_e8e2d2" if b.mat() != "fabric_grey" else "fabric_red"
    for k in range(3):
        z = (h * k / 3, h * (k + 1) / 3)
        b.cushion((-w * 0.46, w * 0.46), (-d / 2, d / 2), z, b.mat(), "folds", 0.9, 14)
        for j in range(4):
            y = d * (-0.36 + 0.24 * j)
            b.rod((-w * 0.45, y, z[0] + h * 0.16), (w * 0.45, y, z[0] + h * 0.16), h * 0.02, checks, "checks", 4)
    face = DrawnFace.top(b, h * 0.985)
    for k in range(4):
        u, v = w * (-0.34 + 0.21 * k), d * (-0.34 + 0.21 * k)
        face.field((u, u + w * 0.06), (-d * 0.42, d * 0.42), checks, "checks", h * 0.02)
        face.field((-w * 0.42, w * 0.42), (v, v + d * 0.06), checks, "checks", h * 0.024)
    front = DrawnFace.front(b, d / 2 - h * 0.01)
    for k in range(4):
        u = w * (-0.34 + 0.21 * k)
        for j in range(3):
            front.field((u, u + w * 0.06), (h * (j / 3 + 0.08), h * (j / 3 + 0.25)), checks, "checks", h * 0.03)
    for side in (-1, 1):
        for k in range(16):
            y = d * (-0.44 + 0.0587 * k)
            b.rod((side * w * 0.44, y, h * 0.3), (side * w / 2, y, h * 0.12), h * 0.025, checks, "fringe", 5)


@recipe("hung_towel")
def hung_towel(b: Builder) -> None:
    """A towel over a bar, with two coloured stripes above a fringed edge."""
    w, d, h = b.w, b.d, b.h
    bar = h - d * 0.3
    color = b.mat() if b.mat() != "fabric_white" else "fabric_8fc1d9"
    b.rod((-w * 0.5, 0, bar), (w * 0.5, 0, bar), d * 0.16, "metal_chrome", "bar", 10)
    for side in (-1, 1):
        b.ball((side * w * 0.48, 0, bar), (w * 0.02 + 0.006, d * 0.3, d * 0.3), "metal_chrome", "bar", 8)
    x = (-w * 0.44, w * 0.44)
    b.rod((x[0], 0, bar), (x[1], 0, bar), d * 0.3, color, "cloth", 12)
    b.box(x, (d * 0.12, d * 0.42), (h * 0.05, bar), color, "cloth")
    b.box(x, (-d * 0.42, -d * 0.12), (h * 0.05, bar), color, "cloth")
    face = DrawnFace.front(b, d * 0.42)
    for k, v in enumerate((0.12, 0.2)):
        face.field(x, (h * v, h * (v + 0.045)), ("fabric_white", "fabric_2f5fa8")[k], "stripes", d * 0.06)
    for k in range(14):
        u = x[0] + (x[1] - x[0]) * (k + 0.5) / 14
        b.box((u - w * 0.012, u + w * 0.012), (-d * 0.42, d * 0.42), (0, h * 0.055), color, "fringe", solid=False)
    face.line([(-w * 0.2, h * 0.3), (-w * 0.21, bar)], d * 0.05, color, "folds")
    face.line([(w * 0.16, h * 0.3), (w * 0.18, bar)], d * 0.05, color, "folds")


@recipe("towel_ring")
def towel_ring(b: Builder) -> None:
    """A ring on a wall plate with a hand towel drawn through it."""
    w, d, h = b.w, b.d, b.h
    back = -d / 2
    b.rod((0, back, h * 0.9), (0, back + d * 0.3, h * 0.9), w * 0.14, b.mat(), "plate", 18)
    b.rod((0, back + d * 0.2, h * 0.9), (0, d * 0.1, h * 0.9), w * 0.06, b.mat(), "stem", 10)
    r = w * 0.42
    ring = [(math.sin(a) * r, d * 0.1, h * 0.9 - r + math.cos(a) * r) for a in (k * math.tau / 20 for k in range(21))]
    b.path(ring, w * 0.035, b.mat(), "ring")
    low = h * 0.9 - 2 * r
    for y in ((-d * 0.1, d * 0.08), (d * 0.12, d * 0.34)):
        b.prism(
            [(-w * 0.3, low + r * 0.5), (w * 0.3, low + r * 0.5), (w * 0.4, 0), (-w * 0.4, 0)],
            y,
            "fabric_8fc1d9",
            "y",
            "towel",
        )
    b.rod((-w * 0.3, d * 0.1, low + r * 0.5), (w * 0.3, d * 0.1, low + r * 0.5), d * 0.24, "fabric_8fc1d9", "towel", 10)
    b.box((-w * 0.38, w * 0.38), (d * 0.34, d * 0.36), (h * 0.08, h * 0.14), "fabric_white", "stripe", solid=False)


@recipe("dish_cloth")
def dish_cloth(b: Builder) -> None:
    """A checked cloth that lies crumpled: ridges across, a hem, and one corner turned over."""
    w, d, h = b.w, b.d, b.h
    count = 10
    heights = [h * (0.3 + 0.34 * math.sin(k * 1.9) * math.sin(k * 0.7 + 0.4)) for k in range(count + 1)]
    thick = h * 0.16
    for i in range(count):
        y0, y1 = -d / 2 + i * d / count, -d / 2 + (i + 1) * d / count
        profile = [
            (y0, max(0.0, heights[i] - thick)),
            (y1, max(0.0, heights[i + 1] - thick)),
            (y1, heights[i + 1]),
            (y0, heights[i]),
        ]
        for j in range(count):
            x0, x1 = -w / 2 + j * w / count, -w / 2 + (j + 1) * w / count
            striped = (i % 4 == 1) + (j % 4 == 1)
            color = (b.mat(), "fabric_7aa0d6", "fabric_1d4f9e")[striped]
            b.prism(profile, (x0, x1), color, part="cloth", solid=False)
    fold = [(w * 0.08, -d / 2), (w / 2, -d / 2), (w / 2, -d * 0.06)]
    b.prism(fold, (heights[0] * 0.9, h), "fabric_7aa0d6", "z", "fold", solid=False)
