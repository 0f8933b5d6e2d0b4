"""Machines of studios, print rooms and laundries: looms, potter's wheels, kilns, presses, sewing machines."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("loom")
def loom(b: Builder) -> None:
    """A weaver's floor loom: a timber frame, threads from the beam behind through two heddles, and cloth in front."""
    w, d, h = b.w, b.d, b.h
    main, t, level = b.mat(), w * 0.035, h * 0.55
    for x in (-w / 2 + t, w / 2 - t):
        for y, high in ((-d / 2 + t, level * 1.08), (d / 2 - t, level), (0.0, h)):
            b.box((x - t, x + t), (y - t, y + t), (0, high), main, "posts")
        for z in (h * 0.16, level * 0.92):
            b.box((x - t * 0.8, x + t * 0.8), (-d / 2, d / 2), (z, z + t * 2), main, "rails")
    b.box((-w / 2, w / 2), (-t * 1.2, t * 1.2), (h - t * 3, h), main, "castle")
    for y in (-d / 2 + t, d / 2 - t):
        b.rod((-w / 2, y, level), (w / 2, y, level), t * 1.4, main, "beams", 14, solid=True)
    b.rod(
        (-w * 0.44, d / 2 - t, h * 0.3),
        (w * 0.44, d / 2 - t, h * 0.3),
        t * 2.4,
        "fabric_red",
        "cloth_roll",
        16,
        solid=True,
    )
    _weave(b, level, t)


def _weave(b: Builder, level: float, t: float) -> None:
    """Heddles, warp, cloth and treadles of a loom whose beams are at `level`, its timbers `t` thick."""
    w, d, h = b.w, b.d, b.h
    for y in (-d * 0.1, d * 0.02):
        for z in (level * 0.74, level * 1.32):
            b.box((-w * 0.4, w * 0.4), (y - t * 0.3, y + t * 0.3), (z, z + t), "wood_birch", "heddles")
        for k in range(15):
            x = -w * 0.38 + k * w * 0.76 / 14
            b.rod((x, y, level * 0.74), (x, y, level * 1.34), t * 0.1, "plastic_white", "heddles", 4)
        for side in (-1, 1):
            b.rod((side * w * 0.3, y, level * 1.34), (side * w * 0.3, 0, h - t), t * 0.14, "fabric_white", "cords", 4)
    for k in range(25):
        x = -w * 0.38 + k * w * 0.76 / 24
        b.rod((x, -d / 2 + t, level + t), (x, d * 0.2, level + t), t * 0.13, "fabric_beige", "warp", 4)
    for k, color in enumerate(("fabric_red", "fabric_white", "fabric_blue", "fabric_white", "fabric_red")):
        y0 = d * 0.2 + k * (d * 0.28) / 5
        b.box(
            (-w * 0.39, w * 0.39),
            (y0, y0 + d * 0.28 / 5),
            (level + t * 0.6, level + t * 1.5),
            color,
            "cloth",
            solid=False,
        )
    b.box((-w * 0.42, w * 0.42), (d * 0.14, d * 0.18), (level * 0.9, level * 1.2), "wood_walnut", "reed", solid=False)
    for k in range(4):
        x = (k - 1.5) * w * 0.14
        b.prism(
            [(-d * 0.2, h * 0.03), (d * 0.36, h * 0.1), (d * 0.36, h * 0.13), (-d * 0.2, h * 0.06)],
            (x - t, x + t),
            "wood_walnut",
            part="treadles",
        )


@recipe("pottery_wheel")
def pottery_wheel(b: Builder) -> None:
    """A round wheel head with a bowl of clay in a wide splash pan, on a stand with a pedal."""
    w, d, h = b.w, b.d, b.h
    y, pan = -d * 0.06, h * 0.62
    for sx in (-1, 1):
        for sy in (-1, 1):
            b.rod(
                (sx * w * 0.4, y + sy * d * 0.32, 0),
                (sx * w * 0.32, y + sy * d * 0.26, pan * 0.9),
                w * 0.03,
                b.mat(),
                "legs",
                8,
                solid=True,
            )
    b.box((-w * 0.36, w * 0.36), (y - d * 0.28, y + d * 0.28), (pan * 0.5, pan * 0.9), b.mat(), "motor_box")
    b.lathe(
        [(0.44, pan * 0.88), (0.5, pan * 0.94), (0.5, h * 0.76), (0.47, h * 0.76), (0.46, pan)],
        "plastic_3d6a9e",
        (0, y),
        "splash_pan",
        28,
        (w, d * 0.84),
    )
    _clay(b, y, pan)


def _clay(b: Builder, y: float, pan: float) -> None:
    """The wheel head with a bowl on it, a pedal, a sponge, and tools on the rim of the pan."""
    w, d, h = b.w, b.d, b.h
    b.cyl(0, y, (pan, h * 0.7), w * 0.3, "metal_light", "wheel_head", n=28)
    b.lathe(
        [
            (0.13, h * 0.7),
            (0.15, h * 0.72),
            (0.24, h * 0.86),
            (0.2, h * 0.95),
            (0.22, h),
            (0.18, h),
            (0.16, h * 0.92),
            (0.18, h * 0.84),
        ],
        "food_a9683f",
        (0, y),
        "clay",
        24,
        (w, w),
    )
    b.prism(
        [(d * 0.3, 0), (d / 2, 0), (d / 2, h * 0.06), (d * 0.3, h * 0.14)],
        (w * 0.2, w * 0.42),
        "rubber_black",
        part="pedal",
    )
    b.ball((-w * 0.36, y + d * 0.26, h * 0.78), (w * 0.07, w * 0.06, h * 0.04), "food_e8d67a", "sponge", 8, solid=False)
    for k in range(3):
        a = 0.6 + k * 0.1
        b.rod(
            (-w * a / 1.5, y - d * 0.16, h * 0.74),
            (-w * a / 1.8, y + d * 0.04, h * 0.77),
            w * 0.012,
            "wood_oak",
            "tools",
            6,
        )


@recipe("kiln")
def kiln(b: Builder) -> None:
    """A potter's kiln: eight-sided, of pale brick in steel hoops, with a raised lid, a control box and peep holes."""
    w, d, h = b.w, b.d, b.h
    legs, top = h * 0.16, h * 0.84
    octagon = [
        (0.5 * math.cos(math.pi / 8 + k * math.pi / 4), 0.5 * math.sin(math.pi / 8 + k * math.pi / 4)) for k in range(8)
    ]
    for x, y in octagon[::2]:
        b.cyl(x * w * 0.84, y * d * 0.84, (0, legs), 0.025, "metal_dark", "legs", n=8)
    for z0, z1, share, color in (
        (legs, top, 0.96, "stone_d9c39a"),
        (legs, legs + h * 0.05, 1.0, b.mat()),
        (h * 0.48, h * 0.53, 1.0, b.mat()),
        (top - h * 0.05, top, 1.0, b.mat()),
        (h * 0.9, h * 0.98, 1.0, b.mat()),
    ):
        b.prism([(x * w * share, y * d * share) for x, y in octagon], (z0, z1), color, "z", "shell")
    b.prism([(x * w * 0.94, y * d * 0.94) for x, y in octagon], (top, h * 0.9), "light_f0702a", "z", "glow")
    b.rod((0, d * 0.4, h * 0.94), (0, d / 2, h * 0.94), 0.02, "wood_oak", "grip")
    b.box((w * 0.4, w / 2), (-d * 0.16, d * 0.16), (h * 0.24, h * 0.74), "metal_dark", "control")
    b.box(
        (w * 0.5 - 0.002, w * 0.5 + 0.002),
        (-d * 0.1, d * 0.1),
        (h * 0.58, h * 0.68),
        "screen_green",
        "control",
        solid=False,
    )
    for z in (0.36, 0.66):
        b.rod((0, d * 0.43, h * z), (0, d * 0.47, h * z), 0.03, "light_f0702a", "peep_holes", 12)
    b.rod((0, -d * 0.4, h * 0.97), (0, -d * 0.4, h), 0.03, "metal_dark", "hinge")


@recipe("sewing")
def sewing(b: Builder) -> None:
    """Sewing machine on its table."""
    w, d, h = b.w, b.d, b.h
    z = 0.75
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - 0.03, z), b.mat(), "top")
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.06)
        b.box((x - 0.03, x + 0.03), (-d / 2 + 0.05, d / 2 - 0.05), (0, z - 0.03), "metal_dark", "legs")
    b.box((-0.22, 0.24), (-0.1, 0.08), (z, z + 0.05), "plastic_white", "machine")
    b.box((0.12, 0.24), (-0.08, 0.06), (z + 0.05, h), "plastic_white", "machine")
    b.box((-0.2, 0.24), (-0.07, 0.05), (h - 0.11, h), "plastic_white", "machine")
    b.cyl(-0.17, 0, (z + 0.05, h - 0.1), 0.012, "metal_steel", "needle", n=8, solid=False)
    b.rod((0.24, 0, h - 0.08), (0.27, 0, h - 0.08), 0.05, "metal_steel", "wheel", 16)
    b.box((-w * 0.45, -0.25), (-d * 0.3, d * 0.3), (z, z + 0.02), "fabric_blue", "cloth", solid=False)


@recipe("printing_press")
def printing_press(b: Builder) -> None:
    """Rollers with the four inks between two cheeks, a printed sheet that leaves them, and piles of paper."""
    w, d, h = b.w, b.d, b.h
    for side in (-1, 1):
        along = sorted((side * d / 2, side * d * 0.4))
        cheek = [
            (-w * 0.24, 0),
            (w * 0.24, 0),
            (w * 0.24, h * 0.75),
            (w * 0.14, h),
            (-w * 0.14, h),
            (-w * 0.24, h * 0.75),
        ]
        b.prism(cheek, (along[0], along[1]) if side < 0 else (d * 0.4, d * 0.42), b.mat(), "y", "cheeks")
    reach = (-d * 0.4, d * 0.47)
    inks = ("plastic_22a6d6", "plastic_d6258c", "plastic_yellow", "plastic_black")
    for k, color in enumerate(inks):
        a = math.pi * (0.12 + 0.25 * k)
        x, z = math.cos(a) * w * 0.16, h * 0.56 + math.sin(a) * h * 0.26
        b.rod((x, reach[0], z), (x, reach[1], z), h * 0.085, color, "inks", 18, solid=True)
        b.rod((x, reach[1], z), (x, d / 2, z), h * 0.03, "metal_steel", "axles", 10)
    for x, z, r in ((0.0, h * 0.52, h * 0.17), (0.0, h * 0.2, h * 0.14)):
        b.rod((x, reach[0], z), (x, reach[1], z), r, "metal_chrome", "cylinders", 24, solid=True)
        b.rod((x, reach[1], z), (x, d / 2, z), h * 0.04, "metal_dark", "axles", 12)
    for side in (-1, 1):
        across = sorted((side * w / 2, side * w * 0.27))
        b.box((across[0], across[1]), (-d * 0.4, d * 0.42), (0, h * 0.12), "metal_dark", "feeders")
        b.box((across[0] + 0.03, across[1] - 0.03), (-d * 0.34, d * 0.36), (h * 0.12, h * 0.34), "paper_white", "piles")
        b.box((across[0], across[1]), (-d * 0.42, -d * 0.4), (0, h * 0.5), b.mat(), "feeders")
    top = DrawnFace.top(b, h * 0.34)
    for k, color in enumerate(inks):
        u = w * (-0.45 + 0.035 * k)
        top.field((u, u + w * 0.03), (-d * 0.3, d * 0.26), color, "print", 0.004)
    sheet = [(w * 0.08, h * 0.36), (w * 0.3, h * 0.46), (w * 0.3, h * 0.465), (w * 0.08, h * 0.365)]
    b.prism(sheet, (-d * 0.34, d * 0.36), "paper_white", "y", "sheet")
    for k, color in enumerate(inks):
        x = w * (0.11 + 0.045 * k)
        z = h * (0.367 + (x / w - 0.08) / 0.22 * 0.1)
        line = [(x, z), (x + w * 0.03, z + h * 0.0136), (x + w * 0.03, z + h * 0.018), (x, z + h * 0.0044)]
        b.prism(line, (-d * 0.28, d * 0.3), color, "y", "print")
    b.box((-w * 0.23, -w * 0.1), (d * 0.42, d / 2), (h * 0.6, h * 0.78), "plastic_dark", "controls")
    DrawnFace.front(b, d / 2).field((w * 0.115, w * 0.215), (h * 0.66, h * 0.76), "screen_green", "controls", 0.003)


@recipe("ironing_press")
def ironing_press(b: Builder) -> None:
    """A padded buck like an ironing board on a cabinet, a heated head lifted over it, pedals."""
    w, d, h = b.w, b.d, b.h
    b.box((-w * 0.26, w * 0.2), (-d * 0.36, d * 0.2), (0.04, h * 0.5), "metal_light", "cabinet")
    b.box((-w * 0.3, w * 0.24), (-d * 0.4, d * 0.46), (0, 0.04), "metal_dark", "base")
    for k in range(2):
        x = -w * 0.14 + k * w * 0.16
        b.box((x, x + w * 0.1), (d * 0.24, d * 0.46), (0.04, 0.08), "rubber_black", "pedals")
    _press_buck(b)
    _press_head(b)
    _press_gauge(b)


def _press_buck(b: Builder) -> None:
    """A padded board with a rounded end, and a blue shirt on it."""
    w, d, h = b.w, b.d, b.h
    buck = [
        (w / 2, 0.0),
        (w * 0.42, d * 0.16),
        (w * 0.1, d * 0.34),
        (-w * 0.44, d * 0.34),
        (-w / 2, d * 0.2),
        (-w / 2, -d * 0.14),
        (-w * 0.44, -d * 0.22),
        (w * 0.1, -d * 0.22),
        (w * 0.42, -d * 0.12),
    ]
    b.prism(buck, (h * 0.5, h * 0.54), "metal_dark", "z", "buck")
    b.prism([(x * 0.98, y * 0.96) for x, y in buck], (h * 0.54, h * 0.6), "fabric_e8e2d2", "z", "pad")
    b.prism(
        [(-w * 0.3, d * 0.3), (-w * 0.3, -d * 0.18), (w * 0.2, -d * 0.14), (w * 0.24, d * 0.22)][::-1],
        (h * 0.6, h * 0.612),
        "fabric_4f86c6",
        "z",
        "shirt",
    )
    b.box((-w * 0.28, -w * 0.1), (d * 0.05, d * 0.2), (h * 0.61, h * 0.625), "fabric_white", "shirt", solid=False)


def _press_head(b: Builder) -> None:
    """A heated head lifted on two arms, with a handle and steam below it."""
    w, d, h = b.w, b.d, b.h
    for x in (-w * 0.18, w * 0.12):
        b.path([(x, -d * 0.3, h * 0.5), (x, -d * 0.44, h * 0.7), (x, -d * 0.3, h * 0.92)], 0.03, "metal_dark", "arms")
    rise = 0.34
    head = [
        (-d * 0.34, h * 0.76),
        (d * 0.26, h * (0.76 + rise * 0.42)),
        (d * 0.22, h * (0.86 + rise * 0.4)),
        (-d * 0.38, h * 0.86),
    ]
    b.prism(head, (-w * 0.44, w * 0.4), "metal_steel", part="head")
    b.path(
        [
            (-w * 0.3, d * 0.26, h * 0.93),
            (-w * 0.3, d * 0.42, h * 0.93),
            (w * 0.26, d * 0.42, h * 0.93),
            (w * 0.26, d * 0.26, h * 0.93),
        ],
        0.018,
        "plastic_black",
        "handle",
    )
    for k in range(5):
        x = w * (-0.3 + 0.13 * k)
        b.ball((x, d * 0.02, h * (0.7 + 0.02 * (k % 2))), (w * 0.04, d * 0.08, h * 0.028), "glass_white", "steam", 8)


def _press_gauge(b: Builder) -> None:
    """A gauge, and the word STEAM."""
    w, d, h = b.w, b.d, b.h
    face = DrawnFace.front(b, d * 0.2)
    face.disc(w * 0.14, h * 0.38, w * 0.05, "plastic_white", "gauge", 0.02)
    face.line([(w * 0.14, h * 0.38), (w * 0.16, h * 0.41)], 0.005, "paint_red", "gauge", 0.022)
    face.write("STEAM", (-w * 0.16, w * 0.08), (h * 0.32, h * 0.44), "paint_red", "letters", 0.004)
