"""What is made for animals, and figures of them: stalls, hives, statues."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

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


@recipe("dog_statue")
def dog_statue(b: Builder) -> None:
    """A dog on four legs with its ears down and its tail up, on a plinth."""
    w, d, h = b.w, b.d, b.h
    base = h * 0.1
    wood = "wood_walnut" if b.mat() != "wood_oak" else "wood_black"
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, base), wood, "plinth")
    main, s = b.mat(), (h - base)
    b.cushion((-w * 0.28, w * 0.2), (-d * 0.3, d * 0.3), (base + s * 0.34, base + s * 0.66), main, "body", 0.8, 12)
    for sx in (-0.22, 0.14):
        for side in (-1, 1):
            b.cyl(w * sx, side * d * 0.2, (base, base + s * 0.5), d * 0.1, main, "legs", d * 0.13, n=10)
            b.ball((w * (sx + 0.03), side * d * 0.2, base + s * 0.04), (w * 0.06, d * 0.11, s * 0.05), main, "paws", 8)
    b.rod((w * 0.14, 0, base + s * 0.56), (w * 0.28, 0, base + s * 0.82), d * 0.2, main, "neck", 12)
    b.ball((w * 0.28, 0, base + s * 0.84), (w * 0.12, d * 0.27, s * 0.15), main, "head", 12)
    b.ball((w * 0.4, 0, base + s * 0.79), (w * 0.1, d * 0.16, s * 0.08), main, "muzzle", 10)
    b.ball((w * 0.48, 0, base + s * 0.82), (w * 0.025, d * 0.06, s * 0.03), "plastic_black", "nose", 8, solid=False)
    for side in (-1, 1):
        b.ball(
            (w * 0.22, side * d * 0.28, base + s * 0.8),
            (w * 0.06, d * 0.07, s * 0.16),
            "stone_grey",
            "ears",
            8,
            solid=False,
        )
        b.ball(
            (w * 0.37, side * d * 0.12, base + s * 0.9),
            (w * 0.02, d * 0.05, s * 0.025),
            "plastic_black",
            "eyes",
            6,
            solid=False,
        )
    b.path(
        [(-w * 0.26, 0, base + s * 0.58), (-w * 0.36, 0, base + s * 0.7), (-w * 0.38, 0, base + s * 0.98)],
        d * 0.07,
        main,
        "tail",
    )


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
