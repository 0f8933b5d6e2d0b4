"""Things of a household: what one cleans, dries, waters, lights and feeds with."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("upright_vacuum")
def upright_vacuum(b: Builder) -> None:
    """An upright cleaner: a wide floor head, a clear cup of dust, a stem that leans back to its grip, a hose."""
    w, d, h = b.w, b.d, b.h
    b.prism(
        [(0.0, 0.0), (d / 2, 0.0), (d / 2, 0.05), (d * 0.2, 0.1), (0.0, 0.1)], (-w / 2, w / 2), b.mat(), part="head"
    )
    b.box((-w * 0.46, w * 0.46), (d * 0.44, d / 2 + 0.002), (0.01, 0.035), "plastic_black", "brush", solid=False)
    for side in (-1, 1):
        b.rod((side * w * 0.36, -d * 0.04, 0.06), (side * w * 0.5, -d * 0.04, 0.06), 0.06, "rubber_black", "wheels", 16)

    def at(z: float) -> float:
        """Say where the leaning stem is at a height."""
        return d * 0.1 - d * 0.52 * z / h

    b.rod((0, at(0.06), 0.06), (0, at(h * 0.28), h * 0.28), w * 0.19, b.mat(), "motor", 16, solid=True)
    b.rod((0, at(h * 0.28), h * 0.28), (0, at(h * 0.56), h * 0.56), w * 0.14, "plastic_grey", "dust", 16)
    b.rod((0, at(h * 0.28), h * 0.28), (0, at(h * 0.6), h * 0.6), w * 0.2, "glass_clear", "cup", 18)
    b.rod((0, at(h * 0.6), h * 0.6), (0, at(h * 0.66), h * 0.66), w * 0.21, b.mat(), "cup", 18)
    b.rod((0, at(h * 0.64), h * 0.64), (0, at(h * 0.9), h * 0.9), 0.018, "metal_chrome", "stem", 10, solid=True)
    grip = [
        (0, at(h * 0.88), h * 0.88),
        (0, at(h * 0.97) - 0.02, h * 0.985),
        (0, at(h) + 0.09, h * 0.98),
        (0, at(h * 0.9) + 0.05, h * 0.9),
    ]
    b.path(grip, 0.016, "plastic_black", "grip")
    hose = [
        (w * 0.18, at(h * 0.2), h * 0.2),
        (w * 0.36, at(h * 0.3), h * 0.34),
        (w * 0.36, at(h * 0.5), h * 0.56),
        (w * 0.16, at(h * 0.66), h * 0.66),
    ]
    b.path(hose, 0.02, "plastic_grey", "hose")
    coil = [
        (-w * 0.06 * math.cos(k), at(h * 0.76) - 0.03, h * (0.74 + 0.1 * math.sin(k)))
        for k in (j * 0.8 for j in range(9))
    ]
    b.path(coil, 0.007, "rubber_black", "cable")
    DrawnFace.front(b, d * 0.32).disc(0, 0.085, 0.03, "light_white", "lamp", 0.02)


@recipe("bracket_lamp")
def bracket_lamp(b: Builder) -> None:
    """A round plate on the wall, an arm that curves up from it, and a lit shade of cloth; a switch hangs down."""
    w, d, h = b.w, b.d, b.h
    back, y = -d / 2, d * 0.1
    arm = b.mat() if not b.mat().startswith("fabric") else "metal_brass"
    b.rod((0, back, h * 0.26), (0, back + d * 0.08, h * 0.26), w * 0.32, arm, "plate", 20, solid=True)
    b.rod((0, back + d * 0.06, h * 0.26), (0, back + d * 0.12, h * 0.26), w * 0.14, arm, "plate", 16)
    b.path(
        [(0, back + d * 0.1, h * 0.26), (0, -d * 0.1, h * 0.2), (0, y, h * 0.26), (0, y, h * 0.5)], w * 0.05, arm, "arm"
    )
    b.cyl(0, y, (h * 0.36, h * 0.4), w * 0.14, arm, "socket", n=14)
    r = min(w / 2, d * 0.4)
    b.lathe([(r, h * 0.44), (r * 0.6, h), (r * 0.56, h), (r * 0.96, h * 0.445)], "light_fff1d0", (0, y), "shade", 22)
    for z, share in ((h * 0.44, 1.02), (h * 0.98, 0.64)):
        b.lathe([(r * share, z), (r * share, z + h * 0.02)], arm, (0, y), "rims", 22)
    b.ball((0, y, h * 0.44), (r * 0.3, r * 0.3, h * 0.08), "light_white", "bulb", 10)
    b.rod((w * 0.1, y, h * 0.02), (w * 0.1, y, h * 0.4), w * 0.014, arm, "switch", 6)
    b.ball((w * 0.1, y, h * 0.02), (w * 0.04, w * 0.04, h * 0.02), arm, "switch", 8)


@recipe("sprinkling_can")
def sprinkling_can(b: Builder) -> None:
    """A can with a wide top, a long spout that rises to a pierced rose."""
    w, d, h = b.w, b.d, b.h
    y, r = -d * 0.16, min(w / 2, d * 0.28)
    high = h * 0.66
    b.lathe([(r, 0), (r * 0.92, high), (r * 0.84, high), (r * 0.84, high * 0.8)], b.mat(), (0, y), "can", 22)
    b.lathe([(r * 0.86, high * 0.8), (r * 0.86, high * 0.82)], "glass_blue", (0, y), "water", 22)
    for z in (0.0, high * 0.5, high * 0.95):
        b.lathe([(r * 1.03, z), (r * 1.03, z + h * 0.03)], b.mat(), (0, y), "bands", 22)
    b.rod((0, y + r * 0.8, h * 0.14), (0, d * 0.4, h * 0.82), w * 0.075, b.mat(), "spout", 12, solid=True)
    b.rod((0, y + r * 0.9, high * 0.86), (0, d * 0.26, h * 0.62), w * 0.025, b.mat(), "stay", 8)
    b.rod((0, d * 0.38, h * 0.79), (0, d * 0.45, h * 0.91), w * 0.09, b.mat(), "rose", 14)
    b.rod((0, d * 0.44, h * 0.9), (0, d * 0.47, h * 0.95), w * 0.2, "metal_brass", "rose", 18)
    bow = [
        (0, y - r * 0.9, high * 0.3),
        (0, y - r * 1.5, high * 0.7),
        (0, y - r * 1.1, h * 0.97),
        (0, y, h * 0.97),
        (0, y + r * 0.7, high),
    ]
    b.path(bow, w * 0.05, b.mat(), "handle")


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


@recipe("bath_curtain")
def bath_curtain(b: Builder) -> None:
    """A waved curtain with blue spots on rings along a rod, with a hem that is wet at its foot."""
    w, d, h = b.w, b.d, b.h
    rod = h - 0.03
    b.rod((-w / 2, 0, rod), (w / 2, 0, rod), min(0.014, d * 0.1), "metal_chrome", "rod", 10, solid=True)
    for side in (-1, 1):
        b.rod((side * w * 0.46, 0, rod), (side * w / 2, 0, rod), 0.028, "metal_chrome", "rod", 12)
    folds = 8
    for k in range(folds):
        x = -w * 0.46 + w * 0.92 * (k + 0.5) / folds
        y = d * 0.2 * (-1) ** k
        b.lathe(
            [(w * 0.075, 0.0), (w * 0.06, rod - 0.07)],
            ("fabric_white", "fabric_dfe9ee")[k % 2],
            (x, y),
            "cloth",
            10,
            (1.0, d * 0.3 / (w * 0.075)),
        )
        b.path([(x, 0, rod + 0.02), (x, y * 0.3, rod - 0.07)], 0.005, "metal_chrome", "rings")
        for j in range(5):
            z = h * (0.1 + 0.17 * j + 0.08 * (k % 2))
            if z < rod - 0.15:
                front = y + d * 0.3
                b.rod((x, front - d * 0.08, z), (x, front + 0.003, z), w * 0.034, "fabric_4f9bd9", "spots", 10)


@recipe("high_chair")
def high_chair(b: Builder) -> None:
    """A child's chair on four tall legs that splay, with a tray before it, a step for feet, arms and red straps."""
    w, d, h = b.w, b.d, b.h
    seat = float(b.p.get("seat", h * 0.58))
    for sx in (-1, 1):
        for sy in (-1, 1):
            b.rod(
                (sx * w * 0.46, sy * d * 0.46, 0),
                (sx * w * 0.34, sy * d * 0.28, seat),
                0.02,
                b.mat(),
                "legs",
                10,
                solid=True,
            )
        b.rod(
            (sx * w * 0.43, -d * 0.41, seat * 0.28), (sx * w * 0.43, d * 0.41, seat * 0.28), 0.013, b.mat(), "rails", 8
        )
        b.box(
            (sx * w * 0.38 - 0.015, sx * w * 0.38 + 0.015),
            (-d * 0.28, d * 0.24),
            (seat + 0.17, seat + 0.2),
            b.mat(),
            "arms",
        )
        b.box((sx * w * 0.38 - 0.012, sx * w * 0.38 + 0.012), (d * 0.16, d * 0.2), (seat, seat + 0.17), b.mat(), "arms")
    b.box((-w * 0.38, w * 0.38), (-d * 0.32, d * 0.28), (seat - 0.03, seat), b.mat(), "seat")
    b.prism(
        [(-d * 0.34, seat), (-d * 0.28, seat), (-d * 0.34, h), (-d * 0.4, h)],
        (-w * 0.36, w * 0.36),
        b.mat(),
        part="back",
    )
    b.cushion((-w * 0.3, w * 0.3), (-d * 0.28, -d * 0.2), (seat + 0.04, h - 0.06), "fabric_8fc1d9", "pad", 0.4)
    for side in (-1, 1):
        b.rod(
            (side * w * 0.14, -d * 0.19, h - 0.12),
            (side * w * 0.06, -d * 0.1, seat + 0.01),
            0.012,
            "fabric_red",
            "straps",
            6,
        )
    tray = (seat + 0.2, seat + 0.225)
    b.cushion((-w / 2, w / 2), (d * 0.02, d / 2), tray, "plastic_white", "tray", 0.5)
    for x, y in (
        ((-w / 2, w / 2), (d * 0.47, d / 2)),
        ((-w / 2, -w * 0.46), (d * 0.04, d / 2)),
        ((w * 0.46, w / 2), (d * 0.04, d / 2)),
    ):
        b.box(x, y, (tray[0], tray[1] + 0.02), "plastic_white", "tray")
    b.lathe(
        [(0.05, tray[1]), (0.07, tray[1] + 0.04), (0.062, tray[1] + 0.04), (0.045, tray[1] + 0.01)],
        "plastic_orange",
        (w * 0.12, d * 0.26),
        "bowl",
        16,
    )
    b.box((-w * 0.34, w * 0.34), (d * 0.3, d * 0.46), (seat * 0.42, seat * 0.46), b.mat(), "step")


@recipe("toy_kitchen")
def toy_kitchen(b: Builder) -> None:
    """A small stove with red rings and knobs, an oven with a window, a sink with its tap."""
    w, d, h = b.w, b.d, b.h
    top, face = h * 0.54, d / 2 - 0.03
    b.hollow((-w / 2, w / 2), (-d / 2, face), (0.04, top - 0.03), 0.02, b.mat())
    b.box((-w * 0.01, w * 0.01), (-d / 2, face), (0.04, top - 0.03), b.mat(), "case")
    b.box((-w / 2, w / 2), (face - 0.02, face), (top - 0.13, top - 0.03), b.mat(), "case")
    b.box((-w * 0.47, w * 0.47), (-d * 0.47, face - 0.03), (0, 0.04), "plastic_dark", "plinth")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (top - 0.03, top), "wood_birch", "top")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.03), (top, h), b.mat(), "back")
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.2), (h - 0.03, h), "wood_birch", "shelf")
    plate = DrawnFace.top(b, top)
    plate.field((-w * 0.45, -w * 0.05), (-d * 0.36, d * 0.3), "plastic_black", "hob", 0.006)
    for k in range(2):
        u = -w * (0.34 - 0.19 * k)
        plate.disc(u, -d * 0.04, w * 0.075, "paint_red", "rings", 0.012)
        plate.disc(u, -d * 0.04, w * 0.05, "plastic_black", "rings", 0.014)
    b.lathe(
        [(0.07, top + 0.014), (0.08, top + 0.07), (0.07, top + 0.07), (0.06, top + 0.02)],
        "plastic_4f9bd9",
        (w * 0.15, d * 0.04),
        "pot",
        16,
    )
    b.rod(
        (w * 0.15 + 0.07, d * 0.04, top + 0.05),
        (w * 0.15 + 0.16, d * 0.04, top + 0.06),
        0.012,
        "plastic_black",
        "pot",
        8,
    )
    plate.field((w * 0.1, w * 0.42), (-d * 0.3, d * 0.24), "metal_steel", "sink", 0.004)
    plate.field((w * 0.14, w * 0.38), (-d * 0.24, d * 0.18), "metal_dark", "sink", 0.006)
    b.path(
        [
            (-w * 0.26, -d * 0.32, top),
            (-w * 0.26, -d * 0.32, top + 0.14),
            (-w * 0.26, -d * 0.08, top + 0.14),
            (-w * 0.26, -d * 0.08, top + 0.1),
        ],
        0.014,
        "metal_chrome",
        "tap",
    )
    front = DrawnFace.front(b, face)
    panel = (face + 0.001, face + 0.014)
    door = DrawnFace.front(b, panel[1])
    with b.door((w * 0.02, w * 0.47), panel, (0.06, top - 0.14), "bottom"):
        b.box((w * 0.02, w * 0.47), panel, (0.06, top - 0.14), "plastic_4f9bd9", "oven")
        door.field((-w * 0.41, -w * 0.08), (0.11, top - 0.22), "plastic_dark", "oven", 0.004)
        door.field((-w * 0.38, -w * 0.11), (top - 0.19, top - 0.17), "metal_chrome", "oven", 0.014)
    with b.door((-w * 0.47, -w * 0.02), panel, (0.06, top - 0.14), "left"):
        b.box((-w * 0.47, -w * 0.02), panel, (0.06, top - 0.14), "plastic_pink", "cupboard")
        door.disc(w * 0.08, top * 0.45, 0.018, "metal_chrome", "cupboard", 0.014)
    for k, color in enumerate(("red", "yellow", "green", "blue")):
        front.disc(w * (-0.4 + 0.105 * k), top - 0.08, 0.028, f"plastic_{color}", "knobs", 0.026)
    wall = DrawnFace.front(b, -d / 2 + 0.03)
    wall.disc(w * 0.3, top + (h - top) * 0.55, 0.07, "plastic_yellow", "clock", 0.01)
    wall.disc(w * 0.3, top + (h - top) * 0.55, 0.055, "plastic_white", "clock", 0.014)
    wall.line(
        [(w * 0.3, top + (h - top) * 0.75), (w * 0.3, top + (h - top) * 0.55), (w * 0.34, top + (h - top) * 0.55)],
        0.006,
        "plastic_black",
        "clock",
        0.016,
    )
    for k in range(3):
        u = -w * (0.4 - 0.14 * k)
        wall.line(
            [(u, h - 0.06), (u, top + 0.12)], 0.01, ("wood_birch", "plastic_red", "plastic_green")[k], "tools", 0.03
        )
        wall.disc(u, top + 0.13, 0.035, ("wood_birch", "plastic_red", "plastic_green")[k], "tools", 0.04)


@recipe("dog_basket")
def dog_basket(b: Builder) -> None:
    """A round bolster, lower in front, about a soft pad on which a white bone lies; the sign of a paw on its front."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.42, 0), (0.42, h * 0.44), (0.36, h * 0.5)], "fabric_beige", stretch=(w, d), part="cushion", n=28)
    steps = 22
    for k in range(steps):
        a, n = k * math.tau / steps, (k + 1) * math.tau / steps
        if abs(math.degrees(math.atan2(math.cos((a + n) / 2), math.sin((a + n) / 2)))) < 26:
            continue
        r = h * 0.4
        b.rod(
            (math.cos(a) * (w / 2 - r), math.sin(a) * (d / 2 - r), h - r),
            (math.cos(n) * (w / 2 - r), math.sin(n) * (d / 2 - r), h - r),
            r,
            b.mat(),
            "bolster",
            10,
            solid=True,
        )
        b.ball((math.cos(a) * (w / 2 - r), math.sin(a) * (d / 2 - r), h - r), (r, r, r), b.mat(), "bolster", 8)
    b.lathe([(0.46, 0), (0.49, h * 0.2), (0.46, h * 0.34)], b.mat(), stretch=(w, d), part="base", n=28)
    z, s = h * 0.56, w * 0.14
    b.rod((-s, d * 0.06, z), (s, -d * 0.04, z), s * 0.22, "plastic_white", "bone", 10)
    for x, y in ((-s, d * 0.06), (s, -d * 0.04)):
        for side in (-1, 1):
            b.ball((x * 1.08, y + side * s * 0.26, z), (s * 0.28, s * 0.28, s * 0.24), "plastic_white", "bone", 8)


@recipe("basin_tap")
def basin_tap(b: Builder) -> None:
    """A mixer: a base plate, a stem, a spout that bends down with a drop of water, and levers marked red and blue."""
    w, d, h = b.w, b.d, b.h
    back, r = -d * 0.34, min(0.026, w * 0.34, h * 0.12)
    b.cyl(0, back, (0, h * 0.06), r * 1.5, b.mat(), "base", n=18)
    b.box((-w * 0.5, w * 0.5), (back - r * 2, d * 0.3), (0, h * 0.03), b.mat(), "plate")
    b.cyl(0, back, (0, h * 0.62), r, b.mat(), "stem", n=16)
    bend = [
        (0, back + (d * 0.72) * (1 - math.cos(a)) / 2, h * 0.6 + h * 0.32 * math.sin(a))
        for a in (k * math.pi / 8 for k in range(9))
    ]
    b.path([*bend, (0, d * 0.38, h * 0.5)], r * 0.74, b.mat(), "spout")
    b.cyl(0, d * 0.38, (h * 0.44, h * 0.5), r * 0.95, "metal_dark", "spout", n=14)
    b.ball((0, d * 0.38, h * 0.34), (r * 0.4, r * 0.4, h * 0.06), "plastic_5aa9e6", "drop", 10)
    for side, color in ((-1, "paint_3d6ac8"), (1, "paint_red")):
        reach = side * min(w * 0.45, r * 3.4)
        b.rod((0, back, h * 0.24), (reach, back, h * 0.24), r * 0.55, b.mat(), "levers", 12)
        b.rod((reach, back, h * 0.2), (reach, back, h * 0.4), r * 0.8, b.mat(), "levers", 14)
        b.rod((reach, back, h * 0.4), (reach, back, h * 0.43), r * 0.7, color, "levers", 14)
