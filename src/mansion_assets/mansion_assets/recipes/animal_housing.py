"""Housing of animals: stalls, hives, cages, troughs, baskets."""

import math
from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, surface
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


def _quadruped(b: Builder, y: tuple[float, float], z: tuple[float, float], wide: float, main: str, dark: str) -> None:
    """Add an animal on four legs that looks to the front, within the span of `y` and of `z`."""
    (y0, y1), (z0, z1) = y, z
    length, high = y1 - y0, z1 - z0
    b.cushion(
        (-wide * 0.42, wide * 0.42),
        (y0 + length * 0.06, y0 + length * 0.72),
        (z0 + high * 0.38, z0 + high * 0.76),
        main,
        "body",
        0.8,
        12,
    )
    for side in (-1, 1):
        for u in (0.14, 0.62):
            b.cyl(
                side * wide * 0.26, y0 + length * u, (z0, z0 + high * 0.5), wide * 0.11, main, "legs", wide * 0.13, n=10
            )
        ear = (side * wide * 0.26, y0 + length * 0.78, z0 + high * 0.92)
        b.ball(ear, (wide * 0.1, length * 0.04, high * 0.09), dark, "ears", 8, solid=False)
    b.rod(
        (0, y0 + length * 0.62, z0 + high * 0.62),
        (0, y0 + length * 0.8, z0 + high * 0.84),
        wide * 0.2,
        main,
        "neck",
        10,
    )
    b.ball((0, y0 + length * 0.82, z0 + high * 0.84), (wide * 0.26, length * 0.11, high * 0.15), main, "head", 12)
    b.ball((0, y1 - length * 0.08, z0 + high * 0.78), (wide * 0.15, length * 0.08, high * 0.09), dark, "snout", 10)
    b.path(
        [(0, y0 + length * 0.08, z0 + high * 0.7), (0, y0, z0 + high * 0.84), (0, y0 + length * 0.02, z1)],
        wide * 0.06,
        main,
        "tail",
    )


@recipe("animal_stall")
def animal_stall(b: Builder) -> None:
    """A pen with a timber back, fences of rails at its sides, a gate in front, straw, a trough, and a cow in it."""
    w, d, h = b.w, b.d, b.h
    timber, rail = "wood_oak", 0.03
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.04), (0, h), timber, "back")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.05), "food_d9b84a", "straw")
    for k in range(14):
        x, y = w * (0.4 - 0.8 * ((k * 5) % 13) / 12), d * (0.44 - 0.88 * ((k * 3) % 11) / 10)
        b.rod((x, y, 0.06), (x + 0.12 * math.cos(k), y + 0.12 * math.sin(k), 0.07), 0.012, "food_e8cf72", "straw", 4)
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.03)
        for y in (-d / 2 + 0.06, 0.0, d / 2 - 0.03):
            b.cyl(x, y, (0, h * 0.78), 0.03, b.mat(), "posts", n=10)
        for z in (0.22, 0.4, 0.58, 0.76):
            b.rod((x, -d / 2, z * h), (x, d / 2, z * h), rail * 0.7, b.mat(), "rails", solid=True)
    for z in (0.22, 0.4, 0.58, 0.76):
        b.rod(
            (-w / 2 + 0.03, d / 2 - 0.03, z * h),
            (w / 2 - 0.03, d / 2 - 0.03, z * h),
            rail * 0.7,
            b.mat(),
            "gate",
            solid=True,
        )
    b.box((-w * 0.4, w * 0.4), (-d / 2 + 0.04, -d / 2 + 0.3), (0.05, h * 0.3), "wood_walnut", "trough")
    _quadruped(b, (-d * 0.36, d * 0.44), (0.05, h * 0.92), w * 0.62, "fabric_white", "fabric_skin")
    for x, y, z in ((0.2, -0.1, 0.64), (-0.2, 0.06, 0.56), (0.24, 0.12, 0.5), (0.05, -0.22, 0.66)):
        b.ball((w * x, d * y, h * z), (w * 0.08, d * 0.08, h * 0.1), "fabric_black", "patches", 8, solid=False)


@recipe("beehive")
def beehive(b: Builder) -> None:
    """A hive of two white boxes with grips, a metal roof, a slit over a landing board on legs, and bees about it."""
    w, d, h = b.w, b.d, b.h
    b.legs((0, h * 0.14), 0.025, "wood_oak", 0.03)
    b.prism(
        [(d * 0.3, h * 0.14), (d / 2, h * 0.1), (d / 2, h * 0.13), (d * 0.3, h * 0.18)],
        (-w * 0.4, w * 0.4),
        "wood_oak",
        part="landing_board",
    )
    for z0, z1, color in ((0.14, 0.46, b.mat()), (0.47, 0.7, "paint_yellow"), (0.71, 0.88, b.mat())):
        b.box((-w * 0.44, w * 0.44), (-d * 0.44, d * 0.4), (h * z0, h * z1), color, "boxes")
        middle = h * (z0 + z1) / 2
        b.box(
            (-w * 0.14, w * 0.14),
            (d * 0.4, d * 0.403),
            (middle, middle + h * 0.03),
            "wood_walnut",
            "grips",
            solid=False,
        )
        b.box(
            (w * 0.44, w * 0.443),
            (-d * 0.14, d * 0.14),
            (middle, middle + h * 0.03),
            "wood_walnut",
            "grips",
            solid=False,
        )
    b.box((-w * 0.32, w * 0.32), (d * 0.4, d * 0.404), (h * 0.18, h * 0.21), "plastic_black", "slit", solid=False)
    b.box((-w / 2, w / 2), (-d / 2, d * 0.46), (h * 0.88, h), "metal_steel", "roof")
    for k in range(7):
        x, z = w * (-0.3 + 0.1 * k), h * (0.24 + 0.07 * ((k * 3) % 5))
        y = d * 0.4 + w * 0.03
        b.ball((x, y, z), (w * 0.035, w * 0.025, w * 0.025), "paint_e5b920", "bees", 8, solid=False)
        b.ball((x + w * 0.02, y, z), (w * 0.012, w * 0.027, w * 0.027), "plastic_black", "bees", 6, solid=False)


@recipe("wire_cage")
def wire_cage(b: Builder) -> None:
    """A cage of bars on a blue tray, with a gate, a bowl and a ring to carry it by."""
    w, d, h = b.w, b.d, b.h
    low, high, r = h * 0.08, h * 0.95, 0.006
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.012), "plastic_3d6ac8", "tray")
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * (w / 2 - 0.012))), sorted((side * d / 2, side * (d / 2 - 0.012)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (0, low), "plastic_3d6ac8", "tray")
        b.box((-w / 2, w / 2), (along[0], along[1]), (0, low), "plastic_3d6ac8", "tray")
    for z in (low, (low + high) / 2, high):
        ring = [(-w / 2, -d / 2, z), (w / 2, -d / 2, z), (w / 2, d / 2, z), (-w / 2, d / 2, z), (-w / 2, -d / 2, z)]
        b.path(ring, r * 1.6, b.mat(), "frame")
    bars = 11
    for k in range(bars):
        x, y = -w / 2 + w * k / (bars - 1), -d / 2 + d * k / (bars - 1)
        for side in (-1, 1):
            b.rod((x, side * d / 2, low), (x, side * d / 2, high), r, b.mat(), "bars", 5)
            b.rod((side * w / 2, y, low), (side * w / 2, y, high), r, b.mat(), "bars", 5)
        b.rod((x, -d / 2, high), (x, d / 2, high), r, b.mat(), "bars", 5)
    gate = [
        (-w * 0.2, low + 0.05),
        (w * 0.2, low + 0.05),
        (w * 0.2, high * 0.72),
        (-w * 0.2, high * 0.72),
        (-w * 0.2, low + 0.05),
    ]
    DrawnFace.front(b, d / 2).line(gate, r * 2, "metal_dark", "gate", 0.008)
    DrawnFace.front(b, d / 2).field((w * 0.15, w * 0.21), (high * 0.4, high * 0.46), "metal_brass", "gate", 0.02)
    b.path(
        [(-w * 0.14, 0, high), (-w * 0.1, 0, h), (w * 0.1, 0, h), (w * 0.14, 0, high)], 0.012, "metal_dark", "handle"
    )
    b.lathe([(0.05, 0.012), (0.09, 0.06), (0.08, 0.06), (0.05, 0.02)], "plastic_red", (w * 0.2, d * 0.1), "bowl", 16)


@recipe("hay_trough")
def hay_trough(b: Builder) -> None:
    """A trough with slanted sides on crossed legs, heaped with hay whose stalks stick out."""
    w, d, h = b.w, b.d, b.h
    low, rim = h * 0.3, h * 0.7
    for side in (-1, 1):
        wall = [(side * d * 0.16, low), (side * d * 0.22, low), (side * d / 2, rim), (side * (d / 2 - 0.03), rim)]
        b.prism(wall, (-w / 2, w / 2), b.mat(), part="sides")
        across = sorted((side * w / 2, side * (w / 2 - 0.03)))
        b.prism(
            [(-d * 0.16, low), (d * 0.16, low), (d / 2 - 0.03, rim), (-d / 2 + 0.03, rim)],
            (across[0], across[1]),
            b.mat(),
            part="ends",
        )
        for end in (-1, 1):
            b.rod(
                (side * w * 0.4, end * d * 0.46, 0),
                (side * w * 0.4, -end * d * 0.2, low + 0.08),
                0.03,
                "wood_brown",
                "legs",
                6,
                solid=True,
            )
    b.box((-w / 2, w / 2), (-d * 0.2, d * 0.2), (low - 0.02, low + 0.02), b.mat(), "floor")
    for k in range(7):
        x = w * (-0.39 + 0.13 * k)
        b.ball(
            (x, 0.03 * (-1) ** k, rim - 0.02),
            (w * 0.12, d * 0.4, h * (0.18 + 0.03 * (k % 3))),
            ("food_d9b84a", "food_c9a53a", "food_e8cc66")[k % 3],
            "hay",
            10,
        )
    for k in range(60):
        a, x = k * 2.4, w * (((k * 0.618) % 1.0) - 0.5) * 0.9
        y = d * (((k * 0.382) % 1.0) - 0.5) * 0.7
        z = rim + h * 0.12 * math.cos(y / d * 3)
        tip = (x + math.cos(a) * 0.1, y + math.sin(a) * 0.09, min(z + 0.06 + 0.05 * (k % 3), h))
        b.rod((x, y, z - 0.03), tip, 0.005, ("food_e8cc66", "food_b98f2a", "food_f2dc88")[k % 3], "stalks", 4)


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


@recipe("cat_tree")
def cat_tree(b: Builder) -> None:
    """Post with platforms and a box."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.04), b.mat(), "base")
    b.cyl(-w * 0.2, -d * 0.2, (0.04, h - 0.04), 0.05, "fabric_beige", "post")
    b.cyl(w * 0.25, d * 0.2, (0.04, h * 0.5), 0.05, "fabric_beige", "post")
    b.box((0.0, w / 2), (0.0, d / 2), (h * 0.5, h * 0.53), b.mat(), "boards")
    b.box((-w / 2, w * 0.1), (-d / 2, d * 0.1), (h - 0.04, h), b.mat(), "boards")
    b.box((-w / 2, w * 0.08), (-d / 2, d * 0.3), (0.04, h * 0.3), b.mat(), "box")


@receptacles("pet_bed")
def _pet_cushion(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    """Return the cushion within the ring."""
    w, d, h = size
    return [surface("mattress", (-w * 0.36, w * 0.36, -d * 0.36, d * 0.36), h * 0.5)]
