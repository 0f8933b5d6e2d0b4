"""Garage equipment: vehicle lifts, gantry cranes, tyre changers."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("car_lift")
def car_lift(b: Builder) -> None:
    """Two posts on foot plates with a beam overhead; four arms with pads reach from their carriages, at half height."""
    w, d, h = b.w, b.d, b.h
    level = h * 0.4
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - 0.26)))
        b.box((across[0], across[1]), (-0.16, 0.16), (0, h - 0.1), b.mat(), "posts")
        b.box((across[0] - 0.02, across[1] + 0.02), (-0.37, 0.37), (0, 0.03), "metal_dark", "plates")
        inner = side * (w / 2 - 0.26)
        b.box(
            (min(inner, inner - side * 0.1), max(inner, inner - side * 0.1)),
            (-0.2, 0.2),
            (level - 0.1, level + 0.6),
            "metal_dark",
            "carriages",
        )
        for end in (-1, 1):
            tip = (inner - side * w * 0.26, end * min(d * 0.42, 1.2), level)
            b.rod((inner - side * 0.05, end * 0.14, level), tip, 0.07, "paint_yellow", "arms", 6, solid=True)
            b.cyl(tip[0], tip[1], (level, level + 0.14), 0.1, "rubber_black", "pads", n=14)
    b.box((-w / 2, w / 2), (-0.1, 0.1), (h - 0.12, h), b.mat(), "beam")
    if b.p.get("loaded"):
        _raised_car(b, level + 0.14)
    x = w / 2 - 0.13
    b.box((x - 0.15, x + 0.11), (0.16, 0.34), (h * 0.5, h * 0.66), "plastic_light", "controls")
    face = DrawnFace.front(b, 0.34)
    face.disc(-x + 0.06, h * 0.58, 0.05, "paint_red", "controls", 0.02)
    face.disc(-x - 0.07, h * 0.58, 0.05, "plastic_green", "controls", 0.02)
    for side in (-1, 1):
        u = side * (w / 2 - 0.13)
        DrawnFace.front(b, 0.16).write(
            "LIFT", (u - 0.11, u + 0.11), (h * 0.78, h * 0.84), "plastic_white", "letters", 0.005
        )


def _raised_car(b: Builder, level: float) -> None:
    """A car on the pads of a lift, its sill at a height."""
    half, d = b.w * 0.29, b.d
    body = [
        (-d / 2, level + 0.16), (d / 2, level + 0.14), (d / 2 - 0.05, level + 0.48),
        (d * 0.28, level + 0.6), (-d * 0.46, level + 0.64), (-d / 2, level + 0.5),
    ]  # fmt: skip
    cabin = [(-d * 0.42, level + 0.62), (d * 0.22, level + 0.6), (d * 0.06, level + 1.0), (-d * 0.28, level + 1.0)]
    b.prism(body, (-half, half), "paint_red", part="car")
    b.prism(cabin, (-half + 0.08, half - 0.08), "glass_black", part="car")
    for side in (-1, 1):
        for y in (-d * 0.3, d * 0.3):
            b.rod((side * (half - 0.2), y, level), (side * half, y, level), 0.32, "rubber_black", "wheels", 18)


@recipe("gantry_crane")
def gantry_crane(b: Builder) -> None:
    """Two A-shaped legs on wheels, a girder with flanges, and a hoist on it whose chain holds a hook."""
    w, d, h = b.w, b.d, b.h
    girder = h * 0.88
    for side in (-1, 1):
        x = side * w * 0.44
        for foot in (-1, 1):
            b.rod((x, foot * d * 0.44, 0.16), (x, foot * 0.06, girder), 0.06, b.mat(), "legs", 10, solid=True)
            b.rod(
                (x - 0.05, foot * d * 0.44, 0.08), (x + 0.05, foot * d * 0.44, 0.08), 0.08, "rubber_black", "wheels", 14
            )
        b.rod((x, -d * 0.46, 0.18), (x, d * 0.46, 0.18), 0.05, b.mat(), "legs", 10, solid=True)
        b.rod((x, -d * 0.2, h * 0.5), (x, d * 0.2, h * 0.5), 0.04, b.mat(), "legs", 8)
    for up in ((girder, girder + 0.03), (h - 0.03, h)):
        b.box((-w / 2, w / 2), (-0.12, 0.12), up, b.mat(), "girder")
    b.box((-w / 2, w / 2), (-0.03, 0.03), (girder, h), b.mat(), "girder")
    face = DrawnFace.front(b, 0.03)
    face.write("2000 KG", (-w * 0.16, w * 0.16), (girder + 0.05, h - 0.05), "plastic_black", "letters", 0.006)
    b.box((-0.26, 0.26), (-0.16, 0.16), (girder - 0.1, girder), "metal_dark", "trolley")
    b.rod((-0.28, 0, girder - 0.24), (0.28, 0, girder - 0.24), 0.17, "paint_red", "hoist", 18, solid=True)
    for x in (-0.05, 0.05):
        b.rod((x, 0, h * 0.42), (x, 0, girder - 0.3), 0.022, "metal_steel", "chain", 6)
    b.box((-0.12, 0.12), (-0.08, 0.08), (h * 0.36, h * 0.43), "paint_red", "block")
    hook = [(math.sin(a) * 0.14, 0.0, h * 0.24 + math.cos(a) * 0.14) for a in (-0.2 + k * 0.5 for k in range(10))]
    b.path([(0.0, 0.0, h * 0.36), (-0.02, 0.0, h * 0.31), *hook], 0.04, "metal_dark", "hook")
    b.path([(0.2, 0.12, girder - 0.3), (0.34, 0.2, h * 0.5)], 0.012, "rubber_black", "pendant")
    b.box((0.29, 0.39), (0.16, 0.24), (h * 0.38, h * 0.52), "plastic_yellow", "pendant")


@recipe("tyre_changer")
def tyre_changer(b: Builder) -> None:
    """A cabinet with a turntable on which a wheel lies, and a column behind with an arm and a tool down to its rim."""
    w, d, h = b.w, b.d, b.h
    deck = h * 0.5
    b.box((-w * 0.4, w * 0.4), (-d * 0.4, d * 0.4), (h * 0.06, deck - 0.03), b.mat(), "case")
    b.box((-w * 0.42, w * 0.42), (-d * 0.42, d * 0.42), (0, h * 0.06), "metal_dark", "foot")
    b.cyl(0, d * 0.06, (deck - 0.03, deck), w * 0.26, "metal_steel", "turntable", n=24)
    r = min(w, d) * 0.42
    tyre = [
        (r * 0.62, deck),
        (r * 0.94, deck + 0.01),
        (r, deck + 0.05),
        (r, deck + 0.14),
        (r * 0.94, deck + 0.18),
        (r * 0.6, deck + 0.19),
        (r * 0.58, deck + 0.12),
    ]
    b.lathe(tyre, "rubber_black", (0, d * 0.06), "tyre", 28)
    b.cyl(0, d * 0.06, (deck + 0.02, deck + 0.15), r * 0.58, "metal_light", "rim", n=24)
    for k in range(5):
        a = k * 2 * math.pi / 5
        b.cyl(
            r * 0.34 * math.cos(a),
            d * 0.06 + r * 0.34 * math.sin(a),
            (deck + 0.14, deck + 0.152),
            r * 0.12,
            "plastic_dark",
            "rim",
            n=10,
        )
    b.box((-w * 0.07, w * 0.07), (-d / 2, -d * 0.36), (h * 0.06, h), b.mat(), "column")
    b.box((-w * 0.05, w * 0.05), (-d * 0.4, d * 0.12), (h * 0.9, h * 0.97), b.mat(), "arm")
    b.rod((0, d * 0.1, h * 0.92), (0, d * 0.1, deck + 0.2), 0.022, "metal_chrome", "tool")
    b.box((-0.04, 0.04), (d * 0.06, d * 0.16), (deck + 0.17, deck + 0.22), "metal_dark", "tool")
    for k in range(3):
        x = (k - 1) * w * 0.2
        b.box((x - 0.04, x + 0.04), (d * 0.4, d / 2), (h * 0.06, h * 0.09), "metal_dark", "pedals")
    b.box((-w / 2, -w * 0.4), (-d * 0.3, d * 0.3), (h * 0.14, h * 0.2), "paint_yellow", "bead_breaker")
    b.box((w * 0.4, w / 2), (-d * 0.16, d * 0.16), (h * 0.14, h * 0.4), "paint_yellow", "bead_breaker")
