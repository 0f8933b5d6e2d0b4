"""Toys, and playground equipment: slides, sandboxes, trampolines."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("teddy")
def teddy(b: Builder) -> None:
    """Sitting bear or doll."""
    w, d, h = b.w, b.d, b.h
    b.ball((0, -d * 0.1, h * 0.32), (w * 0.3, d * 0.36, h * 0.32), b.mat(), "body", 12)
    b.ball(
        (0, -d * 0.05, h * 0.74),
        (w * 0.24, d * 0.3, h * 0.2),
        "fabric_skin" if b.mat() != "fabric_brown" else b.mat(),
        "head",
        12,
    )
    for sx in (-1, 1):
        b.ball((sx * w * 0.2, -d * 0.1, h * 0.93), (w * 0.08, d * 0.1, h * 0.07), b.mat(), "ears", 8, solid=False)
        b.ball((sx * w * 0.36, 0, h * 0.42), (w * 0.14, d * 0.18, h * 0.12), b.mat(), "arms", 8, solid=False)
        b.ball((sx * w * 0.24, d * 0.28, h * 0.12), (w * 0.13, d * 0.22, h * 0.12), b.mat(), "legs", 8, solid=False)
        b.ball(
            (sx * w * 0.08, d * 0.2, h * 0.78),
            (w * 0.025, d * 0.04, h * 0.025),
            "plastic_black",
            "eyes",
            6,
            solid=False,
        )
    b.ball((0, d * 0.22, h * 0.7), (w * 0.07, d * 0.08, h * 0.05), "fabric_beige", "snout", 8, solid=False)


@recipe("doll")
def doll(b: Builder) -> None:
    """A girl of cloth: a round face with eyes, a smile and pink cheeks, yellow plaits, a flared dress, and shoes."""
    w, d, h = b.w, b.d, b.h
    r = w * 0.3
    z = h * 0.78
    b.ball((0, 0, z), (r, d * 0.36, h * 0.15), "fabric_f0cfae", "head", 16)
    b.ball((0, -d * 0.08, z + h * 0.035), (r * 1.12, d * 0.36, h * 0.16), "fabric_f2c94c", "hair", 14)
    b.box((-r * 0.86, r * 0.86), (d * 0.16, d * 0.34), (z + h * 0.07, z + h * 0.12), "fabric_f2c94c", "hair")
    for side in (-1, 1):
        _plait(b, side, r, z)
        b.ball((side * r * 1.32, d * 0.03, z - h * 0.24), (w * 0.08, d * 0.12, h * 0.03), b.mat(), "bows", 8)
        b.ball((side * r * 0.4, d * 0.33, z + h * 0.005), (w * 0.04, d * 0.04, h * 0.022), "plastic_black", "eyes", 8)
        b.ball(
            (side * r * 0.62, d * 0.28, z - h * 0.045), (w * 0.05, d * 0.04, h * 0.018), "fabric_e88f8f", "cheeks", 8
        )
        b.rod((side * w * 0.1, 0, h * 0.54), (side * w * 0.42, d * 0.1, h * 0.42), w * 0.06, "fabric_f0cfae", "arms", 8)
        b.rod((side * w * 0.13, 0, h * 0.04), (side * w * 0.13, 0, h * 0.3), w * 0.075, "fabric_white", "legs", 10)
        b.cushion(
            (side * w * 0.13 - w * 0.1, side * w * 0.13 + w * 0.1),
            (-d * 0.2, d * 0.36),
            (0, h * 0.08),
            "leather_black",
            "shoes",
            0.8,
        )
    b.path(
        [(-r * 0.3, d * 0.345, z - h * 0.05), (0, d * 0.36, z - h * 0.07), (r * 0.3, d * 0.345, z - h * 0.05)],
        w * 0.014,
        "fabric_red",
        "smile",
    )
    b.lathe(
        [(0.48, h * 0.22), (0.46, h * 0.25), (0.22, h * 0.5), (0.2, h * 0.6), (0.1, h * 0.64)],
        b.mat(),
        stretch=(w, d),
        part="dress",
        n=18,
    )
    b.lathe([(0.49, h * 0.215), (0.49, h * 0.25)], "fabric_white", stretch=(w, d), part="hem", n=18)
    b.box((-w * 0.14, w * 0.14), (d * 0.2, d * 0.4), (h * 0.28, h * 0.46), "fabric_white", "apron", solid=False)


def _plait(b: Builder, side: int, r: float, z: float) -> None:
    """A plait of four knots at one side of a head of radius `r` at height `z`."""
    w, d, h = b.w, b.d, b.h
    for k in range(4):
        b.ball(
            (side * r * (1.08 + 0.08 * k), d * 0.02, z - h * (0.03 + 0.06 * k)),
            (w * 0.075, d * 0.11, h * 0.036),
            "fabric_f2c94c",
            "plaits",
            8,
        )


@recipe("toy_blocks")
def toy_blocks(b: Builder) -> None:
    """Coloured bricks, some in a small tower."""
    w, d, h = b.w, b.d, b.h
    s = h / 3
    spots = (
        (-0.4, -0.3, 0),
        (0.0, -0.2, 0),
        (0.0, -0.2, 1),
        (0.0, -0.2, 2),
        (0.35, 0.25, 0),
        (-0.25, 0.3, 0),
        (0.36, -0.3, 0),
    )
    for k, (u, v, level) in enumerate(spots):
        x = max(-w / 2 + s / 2, min(w / 2 - s / 2, u * w))
        y = max(-d / 2 + s / 2, min(d / 2 - s / 2, v * d))
        b.box(
            (x - s / 2, x + s / 2),
            (y - s / 2, y + s / 2),
            (level * s, (level + 1) * s - 0.001 * (level < 2)),
            ("paint_red", "paint_blue", "paint_yellow", "paint_green")[k % 4],
            "bricks",
        )
    b.box((-w / 2, -w / 2 + s), (d / 2 - s, d / 2), (0, s), "paint_green", "bricks")
    b.box((w / 2 - s, w / 2), (-d / 2, -d / 2 + s), (0, s), "paint_red", "bricks")


@recipe("rocking_horse")
def rocking_horse(b: Builder) -> None:
    """Horse on rockers."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.02)
        points = [(x, -d / 2 + k * d / 8, 0.02 + 0.12 * ((k - 4) / 4) ** 2) for k in range(9)]
        b.path(points, 0.02, b.mat(), "rockers")
        for y in (-d * 0.22, d * 0.2):
            b.rod((x, y, 0.05), (x * 0.5, y * 0.8, h * 0.5), 0.02, b.mat(), "legs")
    b.cushion((-w * 0.28, w * 0.28), (-d * 0.3, d * 0.26), (h * 0.42, h * 0.66), b.mat(), "body", 0.7)
    b.rod((0, d * 0.2, h * 0.55), (0, d * 0.36, h * 0.88), 0.06, b.mat(), "neck", solid=True)
    b.cushion((-0.05, 0.05), (d * 0.28, d * 0.5), (h * 0.8, h), b.mat(), "head", 0.6)
    b.box((-w * 0.24, w * 0.24), (-d * 0.12, d * 0.1), (h * 0.64, h * 0.68), "fabric_red", "saddle", solid=False)


@recipe("toy_car")
def toy_car(b: Builder) -> None:
    """Toy car."""
    w, d, h = b.w, b.d, b.h
    r = h * 0.22
    b.cushion((-w * 0.42, w * 0.42), (-d / 2, d / 2), (r * 0.7, h * 0.62), b.mat(), "body", 0.4)
    b.cushion((-w * 0.36, w * 0.36), (-d * 0.25, d * 0.15), (h * 0.55, h), "glass_black", "cabin", 0.4)
    for sx in (-1, 1):
        for sy in (-1, 1):
            b.rod((sx * w * 0.34, sy * d * 0.3, r), (sx * w / 2, sy * d * 0.3, r), r, "rubber_black", "wheels", 12)


@recipe("toy_kitchen")
def toy_kitchen(b: Builder) -> None:
    """A small stove with red rings and knobs, an oven with a window, a sink with its tap."""
    d, h = b.d, b.h
    top, face = h * 0.54, d / 2 - 0.03
    _toy_stove(b, face, top)
    _toy_hob_and_sink(b, top)
    _toy_doors(b, face, top)
    _toy_wall(b, top)


def _toy_stove(b: Builder, face: float, top: float) -> None:
    """The case with its top, its back and a shelf."""
    w, d, h = b.w, b.d, b.h
    b.hollow((-w / 2, w / 2), (-d / 2, face), (0.04, top - 0.03), 0.02, b.mat())
    b.box((-w * 0.01, w * 0.01), (-d / 2, face), (0.04, top - 0.03), b.mat(), "case")
    b.box((-w / 2, w / 2), (face - 0.02, face), (top - 0.13, top - 0.03), b.mat(), "case")
    b.box((-w * 0.47, w * 0.47), (-d * 0.47, face - 0.03), (0, 0.04), "plastic_dark", "plinth")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (top - 0.03, top), "wood_birch", "top")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.03), (top, h), b.mat(), "back")
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.2), (h - 0.03, h), "wood_birch", "shelf")


def _toy_hob_and_sink(b: Builder, top: float) -> None:
    """Two red rings with a pot beside them, and a sink with its tap."""
    w, d = b.w, b.d
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


def _toy_doors(b: Builder, face: float, top: float) -> None:
    """The doors of the oven and the cupboard, and the knobs above them."""
    w = b.w
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


def _toy_wall(b: Builder, top: float) -> None:
    """A clock and three ladles on the back."""
    w, d, h = b.w, b.d, b.h
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


@recipe("slide")
def slide(b: Builder) -> None:
    """Ladder behind, chute to the front."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.72
    y = -d * 0.22
    b.prism(
        [
            (d / 2, 0.05),
            (d / 2, 0.09),
            (d * 0.3, 0.1),
            (y, top + 0.02),
            (-d * 0.36, top + 0.02),
            (-d * 0.36, top - 0.03),
            (y, top - 0.03),
        ],
        (-w * 0.42, w * 0.42),
        "plastic_yellow",
        part="chute",
    )
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * w * 0.42))
        b.prism([(d / 2, 0.0), (d / 2, 0.14), (y, top + 0.14), (y, top - 0.06)], (lo, hi), b.mat(), part="sides")
        b.rod(
            (sx * (w / 2 - 0.02), -d / 2 + 0.02, 0),
            (sx * (w / 2 - 0.02), -d * 0.34, h - 0.02),
            0.02,
            b.mat(),
            "posts",
            solid=True,
        )
        b.rod((sx * (w / 2 - 0.02), -d * 0.34, h - 0.02), (sx * (w / 2 - 0.02), y, top + 0.1), 0.02, b.mat(), "rails")
    for k in range(4):
        z = 0.15 + k * top / 4.4
        b.box(
            (-w / 2, w / 2),
            (-d / 2 + 0.01 + k * 0.03, -d / 2 + 0.07 + k * 0.03),
            (z, z + 0.03),
            "plastic_blue",
            "steps",
        )
    b.box((-w / 2, w / 2), (-d * 0.36, -d * 0.34), (h - 0.03, h), b.mat(), "rails", solid=False)


@recipe("sandbox")
def sandbox(b: Builder) -> None:
    """A square of boards with seats in its corners, full of sand, with a castle, a bucket and a spade."""
    w, d, h = b.w, b.d, b.h
    t, sand = 0.05, h * 0.45
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, d / 2 - t), (0, sand), "food_e2c98a", "sand")
    for side in (-1, 1):
        x, y = sorted((side * w / 2, side * (w / 2 - t))), sorted((side * d / 2, side * (d / 2 - t)))
        b.box((x[0], x[1]), (-d / 2, d / 2), (0, h * 0.65), b.mat(), "boards")
        b.box((-w / 2, w / 2), (y[0], y[1]), (0, h * 0.65), b.mat(), "boards")
        for other in (-1, 1):
            corner = [(side * w / 2, other * d / 2), (side * w * 0.28, other * d / 2), (side * w / 2, other * d * 0.28)]
            b.prism(corner, (h * 0.62, h * 0.7), b.mat(), "z", "seats")
    for k, (u, v) in enumerate(((-0.16, -0.1), (0.04, -0.1), (-0.16, 0.1), (0.04, 0.1), (-0.06, 0.0))):
        high = h if k == 4 else h * 0.85
        b.cyl(w * u, d * v, (sand, high), w * 0.055, "food_d3b36a", "castle", w * 0.04, n=12)
    b.box((-w * 0.16, w * 0.04), (-d * 0.1, d * 0.1), (sand, h * 0.66), "food_d3b36a", "castle")
    b.lathe(
        [(0.06, sand), (0.09, sand + h * 0.4), (0.08, sand + h * 0.4), (0.05, sand + h * 0.1)],
        "plastic_red",
        (w * 0.24, d * 0.1),
        "bucket",
        16,
        (w, w),
    )
    b.rod((w * 0.1, d * 0.3, sand + 0.015), (w * 0.26, d * 0.26, sand + 0.015), 0.014, "wood_oak", "spade")
    b.box((w * 0.02, w * 0.11), (d * 0.26, d * 0.34), (sand, sand + 0.015), "plastic_3a7bc8", "spade")


@recipe("trampoline")
def trampoline(b: Builder) -> None:
    """Round mat in a padded ring on legs."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.42, h - 0.03), (0.5, h - 0.05), (0.5, h), (0.42, h)], "plastic_blue", stretch=(w, d), part="ring", n=32)
    b.lathe([(0.42, h - 0.035), (0.42, h - 0.02)], b.mat(), stretch=(w, d), part="mat", n=32)
    for k in range(6):
        a = k * math.pi / 3
        b.cyl(math.cos(a) * w * 0.46, math.sin(a) * d * 0.46, (0, h - 0.05), 0.016, "metal_steel", "legs", n=8)
