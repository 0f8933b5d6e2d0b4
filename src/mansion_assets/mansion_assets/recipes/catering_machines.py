"""Machines of bars and large kitchens: ice, popcorn, frying, dough, beer."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("ice_machine")
def ice_machine(b: Builder) -> None:
    """A steel head above an open bin full of cubes of ice, with a scoop in them and the word ICE in blue."""
    w, d, h = b.w, b.d, b.h
    bin_top, front = h * 0.56, d / 2 - 0.02
    b.box((-w / 2, w / 2), (-d / 2, d * 0.1), (0.06, h), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d / 2, front), (bin_top + h * 0.06, h), b.mat(), "head")
    b.box((-w / 2, w / 2), (d * 0.1, front), (0.06, h * 0.36), b.mat(), "bin")
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - 0.03)))
        b.prism(
            [(d * 0.1, h * 0.36), (front, h * 0.36), (front, h * 0.4), (d * 0.1, bin_top + h * 0.06)],
            (across[0], across[1]),
            b.mat(),
            part="bin",
        )
    b.legs((0, 0.06), 0.02, "metal_dark", 0.03)
    for i in range(6):
        for j in range(4):
            x, y = w * (-0.38 + 0.15 * i), d * (0.14 + 0.085 * j)
            z = h * (0.34 + 0.03 * ((i * 5 + j * 3) % 3)) + (front - y) * 0.3
            s = 0.036
            b.box(
                (x - s, x + s),
                (y - s * 0.8, y + s * 0.8),
                (z, z + 2 * s),
                ("plastic_dff2fb", "plastic_bfe3f5")[(i + j) % 2],
                "ice",
                solid=False,
            )
    b.rod((w * 0.1, d * 0.3, h * 0.5), (w * 0.3, d * 0.42, h * 0.6), 0.016, "metal_chrome", "scoop", 8)
    b.ball((w * 0.06, d * 0.28, h * 0.49), (0.06, 0.05, 0.035), "metal_chrome", "scoop", 10)
    face = DrawnFace.front(b, front)
    face.write("ICE", (-w * 0.4, w * 0.2), (h * 0.7, h * 0.92), "plastic_2f7fd0", "letters", 0.008)
    for k in range(3):
        a = k * math.pi / 3
        arm = (math.cos(a) * w * 0.1, math.sin(a) * w * 0.1)
        face.line(
            [(w * 0.34 - arm[0], h * 0.81 - arm[1]), (w * 0.34 + arm[0], h * 0.81 + arm[1])],
            0.01,
            "plastic_2f7fd0",
            "flake",
            0.006,
        )
    face.field((-w * 0.4, w * 0.4), (h * 0.64, h * 0.66), "metal_dark", "vent", 0.004)
    for k in range(4):
        face.field((-w * 0.34, w * 0.34), (h * (0.12 + 0.05 * k), h * (0.14 + 0.05 * k)), "metal_dark", "vent", 0.004)


@recipe("popcorn_machine")
def popcorn_machine(b: Builder) -> None:
    """A red cart with a case of glass, full of popcorn below a kettle, under a roof that bears its name."""
    w, d, h = b.w, b.d, b.h
    low, high = h * 0.46, h * 0.84
    b.box((-w * 0.46, w * 0.46), (-d * 0.46, d * 0.46), (0.1, low - 0.04), b.mat(), "cart")
    b.wheels(0.06, 0.08)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (low - 0.04, low), "metal_brass", "counter")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (high, h * 0.95), b.mat(), "roof")
    b.prism([(-d / 2, h * 0.95), (d / 2, h * 0.95), (d * 0.2, h), (-d * 0.2, h)], (-w / 2, w / 2), b.mat(), part="roof")
    for x in (-w * 0.47, w * 0.47):
        for y in (-d * 0.47, d * 0.47):
            b.box((x - 0.02, x + 0.02), (y - 0.02, y + 0.02), (low, high), "metal_brass", "posts")
    face = DrawnFace.front(b, d / 2)
    face.write("POPCORN", (-w * 0.46, w * 0.46), (high + 0.02, h * 0.94), "paint_yellow", "letters", 0.006)
    side = DrawnFace.side(b, w / 2)
    side.write("POPCORN", (-d * 0.46, d * 0.46), (high + 0.02, h * 0.94), "paint_yellow", "letters", 0.006)
    for plate, half, out in (
        (DrawnFace.front(b, d * 0.46), w * 0.46, 0.006),
        (DrawnFace.side(b, w * 0.46), d * 0.46, 0.006),
    ):
        for k in range(4):
            u = -half + 2 * half * (2 * k + 0.5) / 8
            plate.field((u, u + half / 4), (0.12, low - 0.06), "plastic_white", "stripes", out)
    for i in range(6):
        for j in range(5):
            x, y = w * (-0.38 + 0.152 * i), d * (-0.36 + 0.18 * j)
            rise = 0.2 + 0.06 * math.cos(x / w * 4) * math.cos(y / d * 4) + 0.02 * ((i * 3 + j * 5) % 3)
            color = ("food_f4e3a1", "food_fdf6e3", "food_f0cf6a")[(i + 2 * j) % 3]
            b.cushion((x - 0.07, x + 0.07), (y - 0.07, y + 0.07), (low, low + rise), color, "popcorn", 0.9, 8)
    b.lathe([(0.09, high - 0.24), (0.12, high - 0.18), (0.12, high - 0.1)], "metal_chrome", part="kettle", n=18)
    b.cyl(0, 0, (high - 0.1, high), 0.02, "metal_dark", "kettle", n=8)
    for x in (-w * 0.48, w * 0.475):
        b.box((x, x + 0.004), (-d * 0.46, d * 0.46), (low, high), "glass_clear", "glass", solid=False)
    b.box((-w * 0.46, w * 0.46), (d * 0.475, d * 0.48), (low, high), "glass_clear", "glass", solid=False)


@recipe("deep_fryer")
def deep_fryer(b: Builder) -> None:
    """A steel cabinet with two wells of hot oil, a wire basket of fries in each with its handle to the front."""
    w, d, h = b.w, b.d, b.h
    depth = float(b.p.get("depth", h * 0.13))
    deck, t = h - depth, w * 0.05
    b.box((-w / 2, w / 2), (-d / 2, d * 0.42), (h * 0.1, deck - 0.02), b.mat(), "case")
    b.legs((0, h * 0.1), 0.02, "metal_dark")
    for k in range(2):
        x0 = -w / 2 + k * w / 2
        b.box((x0 + 0.012, x0 + w / 2 - 0.012), (d * 0.42, d * 0.44), (h * 0.14, h * 0.62), "metal_light", "doors")
        b.box((x0 + w * 0.14, x0 + w * 0.36), (d * 0.44, d * 0.47), (h * 0.56, h * 0.58), "plastic_black", "doors")
        b.rod(
            (x0 + w * 0.25, d * 0.42, h * 0.72),
            (x0 + w * 0.25, d * 0.46, h * 0.72),
            w * 0.06,
            "plastic_black",
            "knobs",
            14,
        )
    for x in ((-w / 2, -w / 2 + t), (-t / 2, t / 2), (w / 2 - t, w / 2)):
        b.box(x, (-d * 0.38, d * 0.42), (deck - 0.02, deck + depth * 0.3), b.mat(), "rim")
    b.box((-w / 2, w / 2), (d * 0.36, d * 0.42), (deck - 0.02, deck + depth * 0.3), b.mat(), "rim")
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.38), (deck - 0.02, h), b.mat(), "splash_back")
    for side in (-1, 1):
        x0, x1 = sorted((side * t, side * (w / 2 - t * 1.4)))
        _fry_basket(b, (x0, x1), deck, depth)


def _fry_basket(b: Builder, x: tuple[float, float], deck: float, depth: float) -> None:
    """Oil across the span of `x`, and in it a wire basket of fries with its handle to the front."""
    w, d = b.w, b.d
    middle, wide, high = (x[0] + x[1]) / 2, x[1] - x[0], (deck, deck + depth * 0.5)
    b.box((x[0] - 0.01, x[1] + 0.01), (-d * 0.38, d * 0.36), (deck - 0.02, deck - 0.01), "food_c08a1e", "oil")
    for y in (-d * 0.3, d * 0.3):
        b.box(x, (y - 0.006, y + 0.006), high, "metal_dark", "baskets")
    for side in x:
        b.box((side - 0.004, side + 0.004), (-d * 0.3, d * 0.3), high, "metal_dark", "baskets")
    b.rod((middle, d * 0.3, high[1]), (middle, d * 0.46, deck + depth * 0.8), 0.008, "metal_dark", "handles")
    grip = ((middle, d * 0.4, deck + depth * 0.7), (middle, d / 2, deck + depth * 0.95))
    b.rod(*grip, 0.016, "plastic_black", "handles")
    for k in range(16):
        u, y = x[0] + wide * (0.12 + 0.25 * (k % 4)), -d * 0.22 + d * 0.14 * (k // 4)
        end = (u + w * 0.04 * (k % 3 - 1), y + d * 0.05, high[1])
        b.rod((u, y, deck), end, 0.012, "food_f2c54a", "fries", 4)


@recipe("dough_mixer")
def dough_mixer(b: Builder) -> None:
    """A column behind with a head over a round steel bowl of dough, a hook that reaches into it, and a switch."""
    w, d, h = b.w, b.d, b.h
    y, rim = d * 0.14, h * 0.58
    b.box((-w * 0.42, w * 0.42), (-d / 2, d * 0.44), (0, h * 0.1), "paint_white", "foot")
    b.cushion((-w * 0.36, w * 0.36), (-d / 2, -d * 0.22), (h * 0.06, h), "paint_white", "column", 0.25)
    b.cushion((-w * 0.34, w * 0.34), (-d / 2, d * 0.36), (h * 0.78, h), "paint_white", "head", 0.4)
    bowl = [
        (0.2, h * 0.14),
        (0.38, h * 0.24),
        (0.48, rim),
        (0.5, rim),
        (0.5, rim + 0.02),
        (0.46, rim + 0.02),
        (0.4, h * 0.34),
    ]
    b.lathe(bowl, b.mat(), (0, y), "bowl", 28, (w, d * 0.72))
    b.ball((0, y, rim - h * 0.06), (w * 0.4, d * 0.28, h * 0.1), "food_f0ddb0", "dough", 14)
    b.cyl(0, y, (h * 0.1, h * 0.16), w * 0.24, "metal_dark", "drive")
    b.path(
        [(0, y, h * 0.8), (0, y, h * 0.7), (w * 0.12, y, h * 0.64), (0, y + d * 0.06, h * 0.54)],
        w * 0.04,
        "metal_chrome",
        "hook",
    )
    b.box((w * 0.32, w * 0.35), (-d * 0.44, -d * 0.28), (h * 0.5, h * 0.66), "plastic_dark", "switch", solid=False)
    b.rod((w * 0.34, -d * 0.36, h * 0.6), (w * 0.37, -d * 0.36, h * 0.6), 0.025, "paint_red", "switch", 10)


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
