"""Stationery: paper, pencils, scissors, staplers, tape."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("paper_stack")
def paper_stack(b: Builder) -> None:
    """Sheets of paper one on another, not quite square, the uppermost with a heading and lines of print."""
    w, d, h = b.w, b.d, b.h
    count = 9
    for k in range(count):
        x, y = w * (0.03 * ((k * 5) % 4) - 0.045), d * (0.02 * ((k * 3) % 4) - 0.03)
        color = "paper_white" if k % 2 == 0 else "paper_d5d5d0"
        z = (h * k / count, h * (k + 1) / count)
        b.box((-w * 0.455 + x, w * 0.455 + x), (-d * 0.47 + y, d * 0.47 + y), z, color, "sheets")
    b.box((-w * 0.1, w * 0.34), (-d * 0.4, -d * 0.35), (h, h * 1.01), "plastic_black", "heading", solid=False)
    for k in range(11):
        row, end = d * (-0.27 + 0.058 * k), -w * (0.34 if k % 4 != 3 else 0.1)
        b.box((end, w * 0.34), (row, row + d * 0.018), (h, h * 1.01), "plastic_grey", "print", solid=False)


@recipe("envelope")
def envelope(b: Builder) -> None:
    """A letter: the flap comes to a point over the back, with a stamp and the seams of the folds."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.6), b.mat(), "paper")
    for side in (-1, 1):
        b.prism(
            [(side * w / 2, -d / 2), (side * w * 0.04, 0.0), (side * w * 0.07, 0.02 * d), (side * w / 2, -d * 0.44)],
            (h * 0.6, h * 0.66),
            "paper_grey",
            "z",
            "seams",
        )
    b.prism([(-w / 2, d / 2), (0, -d * 0.08), (w / 2, d / 2)], (h * 0.6, h * 0.8), "paper_grey", "z", "shadow")
    b.prism([(-w * 0.48, d / 2), (0, -d * 0.03), (w * 0.48, d / 2)], (h * 0.7, h * 0.9), b.mat(), "z", "flap")
    b.cyl(0, d * 0.03, (h * 0.9, h), d * 0.1, "paint_red", "seal", n=16)


@recipe("pencil")
def pencil(b: Builder) -> None:
    """A six-sided shaft with a pink rubber in a metal band behind and a sharpened point in front."""
    w, d, h = b.w, b.d, b.h
    r, z = min(w, h) / 2, h / 2
    b.rod((0, -d / 2, z), (0, -d * 0.44, z), r * 0.9, "rubber_pink", "rubber", 10)
    b.rod((0, -d * 0.44, z), (0, -d * 0.36, z), r * 0.95, "metal_light", "band", 10)
    b.rod((0, -d * 0.36, z), (0, d * 0.34, z), r, b.mat(), "shaft", 6, solid=True)
    for k in range(4):
        share = 0.86 - 0.2 * k
        b.rod((0, d * (0.34 + 0.03 * k), z), (0, d * (0.37 + 0.03 * k), z), r * share, "wood_birch", "point", 8)
    b.rod((0, d * 0.46, z), (0, d / 2, z), r * 0.16, "plastic_black", "lead", 6)


@recipe("pen_cup")
def pen_cup(b: Builder) -> None:
    """Cup with pens."""
    low = b.h * 0.55
    b.lathe([(0.48, 0), (0.5, low), (0.45, low), (0.42, 0.01)], b.mat(), n=14, stretch=(b.w, b.d))
    for k, color in enumerate(("plastic_red", "plastic_blue", "plastic_black", "wood_yellow")):
        x, y = (0.16, -0.16)[k % 2] * b.w, (0.15, -0.1)[k // 2] * b.d
        b.rod((x * 0.5, y * 0.5, 0.01), (x, y, b.h - 0.012 * k), 0.005, color, "pens", 6)


@recipe("crayons")
def crayons(b: Builder) -> None:
    """An open carton of crayons that lie side by side, their points out in front, each of another colour."""
    w, d, h = b.w, b.d, b.h
    mouth = d * 0.1
    b.box((-w / 2, w / 2), (-d / 2, mouth), (0, h), b.mat(), "box")
    b.box((-w * 0.4, w * 0.4), (-d * 0.36, mouth - d * 0.08), (h, h * 1.02), "paint_2f9a4a", "label", solid=False)
    b.box((-w * 0.3, w * 0.3), (-d * 0.28, mouth - d * 0.2), (h, h * 1.04), "paper_yellow", "label", solid=False)
    colors = ("red", "orange", "yellow", "green", "blue", "purple", "pink", "brown")
    r = w / len(colors) / 2
    for k, color in enumerate(colors):
        x = -w / 2 + (2 * k + 1) * r
        reach = d * (0.36 if k % 2 else 0.32)
        b.rod((x, mouth - 0.004, h * 0.5), (x, reach, h * 0.5), r * 0.86, f"plastic_{color}", "crayons", 10)
        b.rod((x, reach - d * 0.06, h * 0.5), (x, reach - d * 0.03, h * 0.5), r * 0.9, "plastic_black", "crayons", 10)
        for j in range(3):
            b.rod(
                (x, reach + d * 0.045 * j, h * 0.5),
                (x, reach + d * 0.045 * (j + 1), h * 0.5),
                r * (0.66 - 0.2 * j),
                f"plastic_{color}",
                "points",
                8,
            )


@recipe("scissors")
def scissors(b: Builder) -> None:
    """Two blades that cross at a screw, opened to the front, each with a ring for the fingers behind."""
    w, d, h = b.w, b.d, b.h
    pivot, r = -d * 0.02, min(w * 0.24, d * 0.17)
    for side, z in ((-1, (h * 0.1, h * 0.5)), (1, (h * 0.5, h * 0.9))):
        tip, tail = side * w * 0.3, -side * w * 0.24
        across = w * 0.09
        b.prism(
            [
                (-across, pivot - d * 0.05),
                (across, pivot - d * 0.05),
                (tip + across * 0.2, d / 2),
                (tip - across * 0.4, d * 0.46),
            ],
            z,
            b.mat(),
            "z",
            "blades",
        )
        b.prism(
            [
                (-across, pivot + d * 0.06),
                (across, pivot + d * 0.06),
                (tail + across, -d / 2 + 2 * r),
                (tail - across, -d / 2 + 2 * r),
            ],
            z,
            b.mat(),
            "z",
            "shanks",
        )
        ring = [
            (tail + r * math.cos(k * math.pi / 8), -d / 2 + r + r * math.sin(k * math.pi / 8), h / 2) for k in range(17)
        ]
        b.path(ring, max(r * 0.22, h * 0.4), "plastic_red", "rings")
    b.cyl(0, pivot, (h * 0.85, h), w * 0.07, "metal_dark", "screw")


@recipe("stapler")
def stapler(b: Builder) -> None:
    """A long base with an anvil, and an arm, hinged behind, that stands open over it with its magazine of staples."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.14), b.mat(), "base")
    b.box((-w * 0.3, w * 0.3), (d * 0.3, d * 0.44), (h * 0.14, h * 0.18), "metal_chrome", "anvil")
    b.prism(
        [(-d / 2, h * 0.14), (-d * 0.3, h * 0.14), (-d * 0.3, h * 0.5), (-d / 2, h * 0.56)],
        (-w * 0.4, w * 0.4),
        b.mat(),
        part="hinge",
    )
    b.prism(
        [(-d * 0.46, h * 0.34), (d * 0.46, h * 0.52), (d * 0.46, h * 0.64), (-d * 0.46, h * 0.48)],
        (-w * 0.3, w * 0.3),
        "metal_chrome",
        part="magazine",
    )
    arm = [
        (-d * 0.47, h * 0.46),
        (d * 0.47, h * 0.64),
        (d / 2, h * 0.74),
        (d * 0.4, h),
        (d * 0.1, h * 0.98),
        (-d * 0.4, h * 0.72),
    ]
    b.prism(arm, (-w * 0.42, w * 0.42), "plastic_red", part="arm")


@recipe("tape_dispenser")
def tape_dispenser(b: Builder) -> None:
    """A foot with a roll of clear tape in its hollow, and the end of the tape over a toothed blade in front."""
    w, d, h = b.w, b.d, b.h
    r, y = h * 0.38, -d * 0.12
    z = h - r
    base = [(-d / 2, 0), (d / 2, 0), (d / 2, h * 0.5), (d * 0.36, h * 0.56), (d * 0.26, h * 0.34), (-d * 0.4, h * 0.34)]
    b.prism(base, (-w / 2, w / 2), b.mat(), part="foot")
    b.rod((-w * 0.3, y, z), (w * 0.3, y, z), r, "plastic_e6cf9f", "roll", 28, solid=True)
    for radius, reach, color in (
        (0.62, 0.32, "plastic_white"),
        (0.46, 0.34, "plastic_3a7bc8"),
        (0.16, 0.46, "plastic_black"),
    ):
        b.rod((-w * reach, y, z), (w * reach, y, z), r * radius, color, "core", 20)
    for side in (-1, 1):
        b.prism(
            [
                (y - d * 0.14, h * 0.34),
                (y + d * 0.14, h * 0.34),
                (y + d * 0.05, z + r * 0.2),
                (y - d * 0.05, z + r * 0.2),
            ],
            (side * w * 0.44 - w * 0.04, side * w * 0.44 + w * 0.04),
            b.mat(),
            part="cheeks",
        )
    b.prism(
        [(y + r * 0.3, h * 0.97), (d * 0.44, h * 0.6), (d * 0.44, h * 0.62), (y + r * 0.34, h * 0.99)],
        (-w * 0.28, w * 0.28),
        "plastic_efe0b8",
        part="tape",
    )
    b.box((-w * 0.34, w * 0.34), (d * 0.42, d * 0.46), (h * 0.5, h * 0.63), "metal_chrome", "blade")
