"""Clocks, watches and ornaments: candles, globes, decoration of tables."""

import itertools
import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("clock")
def clock(b: Builder) -> None:
    """Wall clock, alarm clock or dart board, its face to the front."""
    w, d, h = b.w, b.d, b.h
    style = b.p.get("style", "wall")
    r = min(w, h) / 2
    cz = h / 2
    b.rod((0, -d / 2, cz), (0, d / 2 - 0.006, cz), r, b.mat(), "rim", 28, solid=True)
    if style == "dart":
        for k, (share, color) in enumerate(
            ((0.9, "fabric_beige"), (0.62, "fabric_green"), (0.55, "fabric_black"), (0.12, "fabric_red"))
        ):
            b.rod((0, d / 2 - 0.008, cz), (0, d / 2 - 0.006 + 0.0015 * (k + 1), cz), r * share, color, "face", 28)
        return
    b.rod((0, d / 2 - 0.008, cz), (0, d / 2 - 0.003, cz), r * 0.9, "paper_white", "face", 28)
    b.rod((0, d / 2 - 0.002, cz), (0, d / 2 - 0.002, cz + r * 0.7), r * 0.03, "plastic_black", "hands", 6)
    b.rod((0, d / 2 - 0.002, cz), (r * 0.42, d / 2 - 0.002, cz + r * 0.2), r * 0.04, "plastic_black", "hands", 6)
    if style == "desk":
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.08), b.mat(), "foot")
        b.box((-w * 0.2, w * 0.2), (-d * 0.2, d * 0.2), (h * 0.94, h), "metal_steel", "bell", solid=False)


@recipe("long_case_clock")
def long_case_clock(b: Builder) -> None:
    """A tall case: a plinth, a waist with a glass door on a brass pendulum and weights, and a hood with the dial."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.2), main, "plinth")
    x, t = w * 0.36, 0.02
    b.box((-x, x), (-d / 2, -d * 0.4), (h * 0.2, h * 0.7), main, "waist")
    for side in (-1, 1):
        ends = sorted((side * x, side * (x - t * 2)))
        b.box((ends[0], ends[1]), (-d / 2, d * 0.4), (h * 0.2, h * 0.7), main, "waist")
    b.box((-x, x), (-d * 0.39, -d * 0.37), (h * 0.2, h * 0.7), "wood_black", "waist", solid=False)
    b.rod((0, 0, h * 0.36), (0, 0, h * 0.7), 0.01, "metal_brass", "pendulum")
    b.rod((0, -0.01, h * 0.34), (0, 0.02, h * 0.34), w * 0.16, "metal_brass", "pendulum", 24)
    for side, z in ((-1, 0.44), (1, 0.5)):
        b.cyl(side * w * 0.2, 0, (h * z, h * (z + 0.09)), 0.028, "metal_brass", "weights", n=14)
    b.box((-w * 0.47, w * 0.47), (-d / 2, d * 0.46), (h * 0.7, h * 0.94), main, "hood")
    b.prism(
        [(-w / 2, h * 0.94), (w / 2, h * 0.94), (w * 0.3, h * 0.97), (0, h), (-w * 0.3, h * 0.97)],
        (-d / 2, d / 2),
        main,
        "y",
        "hood",
    )
    z, r = h * 0.82, w * 0.36
    b.rod((0, d * 0.45, z), (0, d * 0.48, z), r, "metal_brass", "dial", 28)
    b.rod((0, d * 0.47, z), (0, d * 0.49, z), r * 0.9, "paper_white", "dial", 28)
    for k in range(12):
        a = k * math.pi / 6
        start, end = ((math.sin(a) * r * s, d * 0.49, z + math.cos(a) * r * s) for s in (0.68, 0.82))
        b.rod(start, end, 0.006, "plastic_black", "dial", 4)
    for a, reach in ((5.2, 0.45), (0.9, 0.66)):
        b.rod(
            (0, d * 0.49, z),
            (math.sin(a) * r * reach, d * 0.49, z + math.cos(a) * r * reach),
            0.007,
            "plastic_black",
            "hands",
            4,
        )


@recipe("watch")
def watch(b: Builder) -> None:
    """A wristwatch that lies on its side, closed: a strap with its dial to the front."""
    w, d, h = b.w, b.d, b.h
    case, thick = d * 0.22, 0.85
    rx, ry, middle = w / 2, (d - case) / 2, -case / 2
    ends = [(math.cos(a), math.sin(a)) for a in (k * math.pi / 8 for k in range(17))]
    for (c0, s0), (c1, s1) in itertools.pairwise(ends):
        outline = [
            (rx * c0, middle + ry * s0),
            (rx * c1, middle + ry * s1),
            (rx * c1 * thick, middle + ry * s1 * thick),
            (rx * c0 * thick, middle + ry * s0 * thick),
        ]
        b.prism(outline, (h * 0.18, h * 0.82), "leather_black", "z", "strap")
    front, radius = d / 2, min(h / 2, w * 0.45)
    b.rod((0, front - case, h / 2), (0, front - case * 0.2, h / 2), radius, b.mat(), "case", 20, solid=True)
    b.rod((0, front - case * 0.3, h / 2), (0, front, h / 2), radius * 0.84, "plastic_white", "dial", 20)
    for end in ((0.0, radius * 0.6), (radius * 0.42, 0.0)):
        b.rod((0, front, h / 2), (end[0], front, h / 2 + end[1]), radius * 0.06, "plastic_black", "hands", 4)


@recipe("pillar_candle")
def pillar_candle(b: Builder) -> None:
    """A candle of wax that has run down it, on a saucer with a ring, with a black wick and a tall flame."""
    w, d, h = b.w, b.d, b.h
    r, body = min(w, d) / 2, h * 0.68
    b.lathe(
        [(r * 0.7, 0), (r, h * 0.05), (r * 0.94, h * 0.06), (r * 0.6, h * 0.03)], "metal_brass", part="saucer", n=20
    )
    b.lathe(
        [(r * 0.58, h * 0.02), (r * 0.58, body), (r * 0.48, body), (r * 0.4, body * 0.97)], b.mat(), part="wax", n=20
    )
    for k in range(6):
        a = k * 1.1
        x, y, low = math.cos(a) * r * 0.58, math.sin(a) * r * 0.58, body * (0.45 + 0.09 * (k * 2 % 5))
        b.rod((x, y, low), (x, y, body * 0.98), r * 0.09, b.mat(), "drips", 8)
        b.ball((x, y, low), (r * 0.12, r * 0.12, h * 0.025), b.mat(), "drips", 8)
    b.rod((0, 0, body * 0.96), (0, 0, h * 0.76), r * 0.06, "plastic_black", "wick", 6)
    b.lathe(
        [(r * 0.05, h * 0.73), (r * 0.26, h * 0.81), (r * 0.16, h * 0.92), (r * 0.02, h)],
        "light_ffb02f",
        part="flame",
        n=14,
    )
    b.lathe([(r * 0.05, h * 0.75), (r * 0.27, h * 0.81), (r * 0.2, h * 0.84)], "light_fff1a0", part="flame", n=14)


@recipe("table_ornament")
def table_ornament(b: Builder) -> None:
    """A wooden tray with a candle in a glass, a small vase with twigs, and polished balls."""
    w, d, h = b.w, b.d, b.h
    base = h * 0.12
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, base), b.mat(), "tray", 0.5, 16)
    for side in (-1, 1):
        across, along = sorted((side * w * 0.48, side * w * 0.44)), sorted((side * d * 0.48, side * d * 0.43))
        b.box((across[0], across[1]), (-d * 0.44, d * 0.44), (base * 0.6, base * 1.6), b.mat(), "tray")
        b.box((-w * 0.44, w * 0.44), (along[0], along[1]), (base * 0.6, base * 1.6), b.mat(), "tray")
    b.cyl(w * 0.22, d * 0.04, (base, h * 0.6), w * 0.08, "food_f3ead6", "candle", n=18)
    b.cyl(w * 0.22, d * 0.04, (base, h * 0.8), w * 0.11, "glass_clear", "glass", n=18)
    b.lathe(
        [(w * 0.004, h * 0.6), (w * 0.025, h * 0.72), (w * 0.003, h * 0.92)],
        "light_ffb02f",
        (w * 0.22, d * 0.04),
        "flame",
        10,
    )
    b.lathe(
        [(w * 0.05, base), (w * 0.1, base + h * 0.2), (w * 0.035, h * 0.52), (w * 0.05, h * 0.58)],
        "ceramic_4f7f9f",
        (-w * 0.2, -d * 0.12),
        "vase",
        18,
    )
    for k in range(5):
        a = k * 1.3
        tip = (-w * 0.2 + math.cos(a) * w * 0.1, -d * 0.12 + math.sin(a) * d * 0.12, h * (0.88 + 0.03 * k))
        b.rod((-w * 0.2, -d * 0.12, h * 0.5), tip, w * 0.008, "wood_brown", "twigs", 5)
        b.ball(tip, (w * 0.022, w * 0.022, w * 0.022), "fabric_white", "twigs", 8)
    for x, y, color in ((-0.04, 0.22, "metal_brass"), (-0.24, 0.2, "stone_white"), (0.02, -0.04, "wood_walnut")):
        r = min(w, d) * 0.09
        b.ball((w * x, d * y, base + r), (r, r, r), color, "balls", 14)


@recipe("globe")
def globe(b: Builder) -> None:
    """Globe on a stand."""
    w, d, h = b.w, b.d, b.h
    r = min(w, d) * 0.46
    b.cyl(0, 0, (0, h * 0.04), w * 0.36, "wood_walnut", "foot", n=24)
    b.cyl(0, 0, (h * 0.03, h - 2 * r), 0.02 if h < 0.7 else 0.035, "wood_walnut", "stem")
    z = h - r * 1.02
    b.ball((0, 0, z), (r, r, r), b.mat(), "globe", 20)
    for k in range(6):
        a, t = k * 1.1, 0.5 * math.sin(k * 2.1)
        b.ball(
            (0.75 * r * math.cos(a), 0.75 * r * math.sin(a), z + t * r * 0.8),
            (r * 0.3, r * 0.3, r * 0.28),
            "leaf_green",
            "land",
            8,
            solid=False,
        )
    b.lathe(
        [(0.5, z - 0.01), (0.5, z + 0.01), (0.47, z + 0.01)],
        "metal_brass",
        stretch=(w, d),
        part="ring",
        n=28,
        solid=False,
    )
    b.cyl(0, 0, (h - 0.02, h), 0.012, "metal_brass", "pin", solid=False)
