"""Household linen: pillows, blankets, towels, cloths and sheets."""

import math

import numpy as np

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe
from mansion_assets.solids import sheet

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
    """A cloth as it was dropped: checks within a hem, raised in its middle, with folds that run out to its edges."""
    count = 14
    grid = np.array(
        [[_dropped(b, 2 * j / count - 1, 2 * i / count - 1) for j in range(count + 1)] for i in range(count + 1)]
    )
    checks = (b.mat() if b.mat() != "fabric_white" else "fabric_2f6fc0", "fabric_9fbfe8")
    shades = ("fabric_f4f4f0", _SHADES.get(b.mat(), checks[1]), checks[0])
    for i in range(count):
        for j in range(count):
            hem = i in (0, count - 1) or j in (0, count - 1)
            color = shades[0] if hem else shades[(i % 2) + (j % 2)]
            b.raw(*sheet(grid[i : i + 2, j : j + 2], b.h * 0.1), color, "cloth")


_SHADES = {"fabric_blue": "fabric_9fb6d6", "fabric_red": "fabric_dfa09a"}
"""The paler colour where only the stripes of one direction run."""


def _dropped(b: Builder, u: float, v: float) -> tuple[float, float, float]:
    """Return the place of a point of a cloth, whose edges are at -1 and 1, after it was dropped."""
    out, turn = min(1.0, math.hypot(u, v)), math.atan2(v, u)
    fold = math.sin(5 * turn + 0.7) * out**1.4
    height = 0.12 + 0.5 * math.exp(-3.0 * out * out) + 0.26 * (1 + fold) * (0.35 + 0.65 * out) * (1 - 0.35 * out)
    drawn = 1.0 - 0.1 * abs(math.sin(2 * turn)) - 0.05 * fold
    return u * drawn * b.w / 2, v * drawn * b.d / 2, b.h * min(1.0, height)
