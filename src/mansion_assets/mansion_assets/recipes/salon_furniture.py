"""Furniture of hair and nail salons: basins, dryer hoods, dressing and nail tables."""

import math
from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, surface
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.recipes.tables import desk
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@receptacles("salon_station")
def _salon_shelf(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, _ = size
    return [surface("shelf", (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.07, d / 2 - 0.02), 0.82, 0.8)]


@recipe("salon_station")
def salon_station(b: Builder) -> None:
    """Mirror with lights above a shelf and drawers, a hair dryer, scissors on the wall, and the word SALON."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.04), (0, h), b.mat(), "panel")
    b.box((-w / 2, w / 2), (-d / 2 + 0.04, d / 2), (0.78, 0.82), b.mat(), "shelf")
    b.box((-w / 2 + 0.03, -w / 2 + 0.4), (-d / 2 + 0.04, d / 2 - 0.05), (0.35, 0.78), b.mat(), "drawers")
    b.box(
        (-w / 2 + 0.12, w / 2 - 0.12),
        (-d / 2 + 0.04, -d / 2 + 0.055),
        (0.95, h - 0.1),
        "glass_mirror",
        "mirror",
        solid=False,
    )
    for sx in (-1, 1):
        for k in range(4):
            z = 1.0 + k * (h - 1.2) / 3
            b.ball((sx * (w / 2 - 0.06), -d / 2 + 0.06, z), (0.03, 0.03, 0.03), "light_warm", "bulbs", 8, solid=False)
    face = DrawnFace.front(b, -d / 2 + 0.055)
    face.write("SALON", (-w * 0.3, w * 0.3), (h - 0.3, h - 0.16), "plastic_black", "letters", 0.004)
    x, y = -w * 0.3, d * 0.1
    b.rod((x, y, 0.72), (x, y, 0.56), 0.022, "plastic_black", "dryer", 10)
    b.rod((x + 0.09, y, 0.73), (x - 0.12, y, 0.73), 0.04, "paint_red", "dryer", 14)
    b.rod((x - 0.12, y, 0.73), (x - 0.18, y, 0.73), 0.026, "plastic_black", "dryer", 12)
    for side in (-1, 1):
        face.line([(-side * 0.06, 1.06), (side * 0.05, 1.34)], 0.01, "metal_dark", "scissors", 0.004)
        ring = [
            (-side * 0.075 + math.cos(a) * 0.035, 1.03 + math.sin(a) * 0.035)
            for a in (k * math.tau / 10 for k in range(11))
        ]
        face.line(ring, 0.009, "plastic_black", "scissors", 0.004)


@recipe("salon_chair")
def salon_chair(b: Builder) -> None:
    """A barber's chair: a buttoned back with a head rest, scissors on its side, a pump lever, a foot plate."""
    w, d, h = b.w, b.d, b.h
    seat, main = h * 0.5, b.mat()
    back, front = -d * 0.34, d * 0.16
    b.lathe([(0.34, 0.0), (0.34, 0.03), (0.1, 0.07)], "metal_chrome", (0, -d * 0.08), "base", 28)
    b.cyl(0, -d * 0.08, (0.06, seat - 0.14), 0.06, "metal_chrome", "column", n=18)
    b.path(
        [(0.06, -d * 0.08, 0.16), (w * 0.4, d * 0.02, 0.16), (w * 0.46, d * 0.06, 0.2)], 0.014, "metal_chrome", "lever"
    )
    half = w * 0.36
    b.cushion((-half, half), (back, front), (seat - 0.14, seat), main, "seat", 0.35, 14)
    b.cushion((-half, half), (-d / 2 + 0.03, back + 0.04), (seat - 0.02, h * 0.84), main, "back", 0.35, 14)
    buttons = DrawnFace.front(b, back + 0.038)
    for row in range(3):
        for column in range(3):
            spot = ((column - 1) * half * 0.55, seat + 0.1 + row * (h * 0.84 - seat - 0.14) / 2.6)
            buttons.disc(*spot, 0.016, "metal_d9b45a", "buttons", 0.006, 10)
    for x in (-0.05, 0.05):
        b.rod((x, -d / 2 + 0.08, h * 0.8), (x, -d / 2 + 0.08, h * 0.9), 0.01, "metal_chrome", "head", 8)
    b.cushion((-0.13, 0.13), (-d / 2, back), (h * 0.88, h), main, "head", 0.5)
    for side in (-1, 1):
        outer = sorted((side * w / 2, side * half * 1.06))
        b.box((outer[0], outer[1]), (back, front - 0.04), (seat - 0.12, seat + 0.16), "metal_light", "sides")
        b.cushion((outer[0] - 0.01, outer[1] + 0.01), (back, front), (seat + 0.16, seat + 0.22), main, "arms", 0.5)
    _scissors(DrawnFace.side(b, w / 2), ((back + front) / 2 - 0.01, seat + 0.02), 0.11)
    for x in (-0.12, 0.12):
        b.path([(x, front - 0.02, seat - 0.1), (x, d * 0.3, 0.3), (x, d * 0.36, 0.12)], 0.016, "metal_chrome", "rest")
    plate = [(d * 0.3, 0.1), (d * 0.3, 0.13), (d / 2, 0.2), (d / 2, 0.17)]
    b.prism(plate, (-w * 0.3, w * 0.3), "metal_chrome", part="rest")
    for k in range(3):
        b.rod(
            (-w * 0.28, d * (0.36 + 0.05 * k), 0.16 + 0.018 * k),
            (w * 0.28, d * (0.36 + 0.05 * k), 0.16 + 0.018 * k),
            0.009,
            "rubber_black",
            "rest",
            6,
        )


def _scissors(face: DrawnFace, at: tuple[float, float], r: float) -> None:
    """The sign of hairdressers: open scissors."""
    u, v = at
    for side in (-1, 1):
        face.line(
            [(u - r * 0.5, v - side * r * 0.35), (u + r, v + side * r * 0.45)], r * 0.09, "plastic_26272b", "sign"
        )
        ring = [
            (
                u - r * 0.72 + math.cos(k * math.tau / 10) * r * 0.28,
                v - side * r * 0.5 + math.sin(k * math.tau / 10) * r * 0.28,
            )
            for k in range(11)
        ]
        face.line(ring, r * 0.07, "plastic_c8201e", "sign")


@recipe("hair_wash_chair")
def hair_wash_chair(b: Builder) -> None:
    """A chair that leans back, and behind it a white basin with a neck rest, a tap and a hand shower on a pillar."""
    w, d, h = b.w, b.d, b.h
    seat, main = 0.44, b.mat()
    b.cushion((-w * 0.4, w * 0.4), (-d * 0.02, d * 0.36), (seat - 0.14, seat), main, "seat", 0.4)
    b.prism(
        [(-d * 0.02, seat - 0.1), (d * 0.06, seat), (-d * 0.14, h * 0.82), (-d * 0.2, h * 0.8)],
        (-w * 0.38, w * 0.38),
        main,
        part="back",
    )
    b.prism(
        [(d * 0.34, seat - 0.12), (d * 0.36, seat), (d / 2, seat * 0.42), (d * 0.46, seat * 0.36)],
        (-w * 0.34, w * 0.34),
        main,
        part="leg_rest",
    )
    b.box((-w * 0.34, w * 0.34), (-d * 0.02, d * 0.3), (0, seat - 0.12), "plastic_dark", "base")
    for side in (-1, 1):
        across = sorted((side * w / 2, side * w * 0.38))
        b.cushion((across[0], across[1]), (-d * 0.06, d * 0.28), (seat + 0.1, seat + 0.17), main, "arms", 0.5)
        b.box(
            (side * w * 0.44 - 0.02, side * w * 0.44 + 0.02),
            (d * 0.0, d * 0.2),
            (seat - 0.1, seat + 0.1),
            "metal_chrome",
            "arms",
        )
    _neck_basin(b)


def _neck_basin(b: Builder) -> None:
    """A basin with a neck rest on a pillar, a tap and a hand shower."""
    w, d, h = b.w, b.d, b.h
    y = -d * 0.32
    b.box((-w * 0.2, w * 0.2), (-d * 0.44, y + 0.06), (0, h * 0.62), "ceramic_white", "pillar")
    rim = h * 0.92
    b.lathe(
        [(0.14, h * 0.6), (0.3, h * 0.76), (0.32, rim), (0.28, rim), (0.22, h * 0.74), (0.05, h * 0.68)],
        "ceramic_white",
        (0, y),
        "basin",
        24,
        (w * 1.3, d * 0.54),
    )
    b.cyl(0, y, (h * 0.7, h * 0.72), 0.04, "metal_dark", "drain", n=12)
    b.cushion((-0.13, 0.13), (-d * 0.2, -d * 0.12), (rim - 0.07, rim + 0.02), "rubber_black", "neck_rest", 0.8)
    b.path([(0, -d * 0.47, h * 0.86), (0, -d * 0.47, h), (0, -d * 0.38, h)], 0.02, "metal_chrome", "tap")
    b.path(
        [(w * 0.16, -d * 0.46, h * 0.88), (w * 0.2, -d * 0.46, h * 0.99), (w * 0.12, -d * 0.34, h * 0.99)],
        0.016,
        "metal_chrome",
        "shower",
    )
    b.rod((w * 0.12, -d * 0.34, h * 0.99), (w * 0.12, -d * 0.32, h * 0.94), 0.04, "metal_chrome", "shower", 14)


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


@recipe("nail_table")
def nail_table(b: Builder) -> None:
    """A table with NAILS and a varnished hand on its side."""
    desk(b)
    w, d, h = b.w, b.d, b.h
    side = DrawnFace.side(b, w / 2 - 0.04)
    side.write("NAILS", (-d * 0.34, d * 0.34), (h * 0.66, h * 0.88), "paint_d6287f", "letters", 0.004)
    side.field((-d * 0.12, d * 0.14), (h * 0.14, h * 0.36), "plastic_f0cfae", "hand", 0.004)
    for k in range(4):
        u, top = d * (-0.09 + 0.07 * k), h * (0.54 + 0.03 * (k in (1, 2)))
        side.line([(u, h * 0.34), (u, top)], d * 0.03, "plastic_f0cfae", "hand", 0.0)
        side.disc(u, top, d * 0.032, "paint_d6287f", "hand", 0.03, 12)
    side.line([(d * 0.12, h * 0.2), (d * 0.24, h * 0.36)], d * 0.034, "plastic_f0cfae", "hand", 0.0)
    side.disc(d * 0.24, h * 0.37, d * 0.035, "paint_d6287f", "hand", 0.03, 12)
