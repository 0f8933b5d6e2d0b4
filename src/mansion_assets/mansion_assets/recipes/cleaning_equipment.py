"""Cleaning and ironing equipment: vacuum cleaners, mops, brushes, sponges, sprays, ironing boards."""

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


@recipe("mop_bucket")
def mop_bucket(b: Builder) -> None:
    """Bucket on castors with a wringer and a mop."""
    w, d, h = b.w, b.d, b.h
    b.wheels(0.035, 0.06)
    b.lathe([(0.4, 0.06), (0.5, 0.4), (0.46, 0.4), (0.36, 0.1)], b.mat(), stretch=(w, d), part="bucket", n=22)
    b.box((-w * 0.3, w * 0.3), (-d * 0.42, 0.0), (0.36, 0.55), b.mat(), "wringer")
    b.rod((0.05, 0.02, 0.15), (0.1, -d * 0.4, h - 0.02), 0.013, "wood_oak", "mop")
    b.ball((0.05, 0.04, 0.3), (0.1, 0.08, 0.12), "fabric_white", "mop", 8, solid=False)
    b.box((0.08, 0.12), (-d / 2, -d * 0.4), (h - 0.05, h), "plastic_blue", "grip", solid=False)


@recipe("scrub_brush")
def scrub_brush(b: Builder) -> None:
    """A brush that stands on its bristles: stiff tufts spread below a wooden block, a long grip with a loop above."""
    w, d, h = b.w, b.d, b.h
    low, high = h * 0.17, h * 0.27
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (low, high), "wood_oak", "block", 0.35)
    for i in range(5):
        for j in range(5):
            u, v = -0.36 + 0.18 * i, -0.36 + 0.18 * j
            color = "plastic_f4e8c8" if (i + j) % 2 else "plastic_2f6fd0"
            b.taper(
                (w * u, d * v, low + 0.004),
                (w * u * 1.22, d * v * 1.22, 0),
                (w * 0.06, w * 0.085),
                color,
                "bristles",
                6,
            )
    b.taper((0, 0, high - 0.004), (0, 0, h * 0.42), (w * 0.24, w * 0.13), "wood_oak", "grip", 16)
    b.taper((0, 0, h * 0.42), (0, 0, h * 0.9), (w * 0.13, w * 0.17), "wood_oak", "grip", 16)
    b.ball((0, 0, h * 0.9), (w * 0.17, w * 0.17, h * 0.04), "wood_oak", "grip", 16)
    loop = [
        (w * 0.12 * math.cos(a), 0, h * 0.955 + h * 0.04 * math.sin(a)) for a in (k * math.tau / 10 for k in range(11))
    ]
    b.path(loop, 0.005, "fabric_white", "loop")


@recipe("dish_sponge")
def dish_sponge(b: Builder) -> None:
    """A yellow sponge with pores and a green scouring layer on top."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.72), "food_f2d24a", "sponge", 0.25)
    b.box((-w * 0.49, w * 0.49), (-d * 0.49, d * 0.49), (h * 0.7, h), "fabric_2f7a3f", "scourer")
    for k in range(12):
        y, z = d * (-0.42 + 0.84 * ((k * 5) % 12) / 11), h * (0.14 + 0.44 * ((k * 7) % 5) / 4)
        r = h * (0.04 + 0.02 * (k % 3))
        for side in (-1, 1):
            b.rod((side * w * 0.48, y, z), (side * w * 0.502, y, z), r, "food_b8932a", "pores", 8)
        x = y * w / d
        b.rod((x, d * 0.48, z), (x, d * 0.502, z), r, "food_b8932a", "pores", 8)


@recipe("trigger_bottle")
def trigger_bottle(b: Builder) -> None:
    """A bottle with a sloped shoulder and, on its neck, a spray head with a nozzle and a trigger to the front."""
    w, d, h = b.w, b.d, b.h
    body, neck, y = h * 0.6, h * 0.74, -d * 0.08
    deep = d * 0.42
    b.cushion((-w / 2, w / 2), (y - deep, y + deep), (0, body), b.mat(), "body", 0.25, 12)
    b.box(
        (-w * 0.36, w * 0.36),
        (y + deep - 0.001, y + deep + 0.0008),
        (body * 0.2, body * 0.75),
        "paper_white",
        "label",
        solid=False,
    )
    b.lathe([(0.4, body * 0.96), (0.16, neck)], b.mat(), (0, y), "shoulder", 16, (w, d))
    b.cyl(0, y, (neck, h * 0.8), w * 0.24, "plastic_white", "collar")
    b.prism(
        [
            (y - d * 0.24, h * 0.9),
            (y - d * 0.16, h * 0.8),
            (y + d * 0.2, h * 0.8),
            (d * 0.4, h * 0.9),
            (d * 0.4, h),
            (y - d * 0.18, h),
        ],
        (-w * 0.22, w * 0.22),
        "plastic_red",
        part="head",
    )
    b.rod((0, d * 0.4, h * 0.95), (0, d / 2, h * 0.95), w * 0.14, "plastic_white", "nozzle", 10)
    b.path([(0, d * 0.28, h * 0.88), (0, d * 0.34, h * 0.8), (0, d * 0.24, h * 0.7)], w * 0.1, "plastic_red", "trigger")


@recipe("detergent")
def detergent(b: Builder) -> None:
    """A broad canister with a hollow handle at one side, a slanting shoulder, a bright measuring cap and a label."""
    w, d, h = b.w, b.d, b.h
    z = (-d / 2, d / 2)
    b.prism(
        [(-w / 2, 0), (w / 2, 0), (w / 2, h * 0.42), (-w * 0.16, h * 0.42), (-w * 0.16, h * 0.78), (-w / 2, h * 0.7)],
        z,
        b.mat(),
        "y",
        "body",
    )
    b.box((-w * 0.16, w * 0.16), z, (h * 0.4, h * 0.78), b.mat(), "body")
    b.prism(
        [(w * 0.36, h * 0.4), (w / 2, h * 0.4), (w / 2, h * 0.62), (w * 0.36, h * 0.62)],
        (-d * 0.36, d * 0.36),
        b.mat(),
        "y",
        "handle",
    )
    b.prism(
        [(w * 0.12, h * 0.66), (w * 0.36, h * 0.6), (w / 2, h * 0.6), (w * 0.14, h * 0.78)],
        (-d * 0.36, d * 0.36),
        b.mat(),
        "y",
        "handle",
    )
    b.cyl(-w * 0.2, 0, (h * 0.74, h), d * 0.36, "plastic_orange", "cap", d * 0.32)
    b.box((-w * 0.42, w * 0.1), (d / 2, d / 2 + 0.001), (h * 0.12, h * 0.62), "paper_white", "label", solid=False)
    for r, color in ((0.17, "paint_yellow"), (0.11, "paint_red")):
        b.rod((-w * 0.16, d / 2, h * 0.38), (-w * 0.16, d / 2 + 0.003 - 0.01 * r, h * 0.38), w * r, color, "label", 16)


@recipe("ironing_board")
def ironing_board(b: Builder) -> None:
    """Board on crossed legs."""
    w, d, h = b.w, b.d, b.h
    b.prism(
        [(-w / 2, -d / 2), (w * 0.3, -d / 2), (w / 2, -d * 0.12), (w / 2, d * 0.12), (w * 0.3, d / 2), (-w / 2, d / 2)],
        (h - 0.04, h),
        b.mat(),
        "z",
        "board",
    )
    for sy in (-1, 1):
        y = sy * (d / 2 - 0.05)
        b.rod((-w * 0.35, y, 0), (w * 0.25, y * 0.5, h - 0.04), 0.013, "metal_white", "legs")
        b.rod((w * 0.35, y, 0), (-w * 0.25, y * 0.5, h - 0.04), 0.013, "metal_white", "legs")
