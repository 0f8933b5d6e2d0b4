"""Small things of desks and pockets: paper, envelopes, cards, staplers, tape, memory sticks, telephones."""

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


@recipe("credit_card")
def credit_card(b: Builder) -> None:
    """A card with a gold chip, a number in four groups, and two circles that overlap."""
    w, d, h = b.w, b.d, b.h
    z = (h, h * 1.04)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h), b.mat(), "card")
    b.box((-w * 0.4, -w * 0.22), (-d * 0.02, d * 0.22), z, "metal_brass", "chip", solid=False)
    b.box((-w * 0.4, -w * 0.22), (d * 0.09, d * 0.11), (h, h * 1.05), "metal_dark", "chip", solid=False)
    for group in range(4):
        for k in range(4):
            x = -w * 0.4 + group * w * 0.2 + k * w * 0.04
            b.box((x, x + w * 0.024), (-d * 0.2, -d * 0.1), z, "plastic_white", "number", solid=False)
    b.box((-w * 0.4, w * 0.05), (-d * 0.38, -d * 0.32), z, "plastic_white", "name", solid=False)
    b.cyl(w * 0.28, -d * 0.32, (h, h * 1.03), d * 0.12, "paint_red", "mark", n=20, solid=False)
    b.cyl(w * 0.38, -d * 0.32, (h, h * 1.05), d * 0.12, "paint_yellow", "mark", n=20, solid=False)


@recipe("badge")
def badge(b: Builder) -> None:
    """An identity card with a photograph, a coloured head and lines of print, and a clip on a strap."""
    w, d, h = b.w, b.d, b.h
    z, end = (h * 0.7, h * 0.76), d * 0.3
    b.box((-w / 2, w / 2), (-d / 2, end), (0, h * 0.7), b.mat(), "card")
    b.box((-w / 2, w / 2), (end - d * 0.14, end), z, "paint_3a7bc8", "head", solid=False)
    b.box((-w * 0.38, w * 0.02), (-d * 0.2, d * 0.12), z, "plastic_light", "photograph", solid=False)
    b.cyl(-w * 0.18, d * 0.02, (h * 0.76, h * 0.82), w * 0.11, "fabric_skin", "photograph", solid=False)
    b.box((-w * 0.34, -w * 0.02), (-d * 0.2, -d * 0.08), (h * 0.76, h * 0.8), "paint_dark", "photograph", solid=False)
    for k, wide in enumerate((0.34, 0.28, 0.34)):
        y = d * (0.06 - 0.09 * k)
        b.box((w * 0.1, w * (0.1 + wide)), (y, y + d * 0.03), z, "plastic_black", "print", solid=False)
    b.box((-w * 0.38, w * 0.4), (-d * 0.42, -d * 0.3), z, "plastic_black", "print", solid=False)
    b.box((-w * 0.14, w * 0.14), (end - d * 0.02, d * 0.42), (h * 0.2, h * 0.5), "plastic_light", "strap")
    b.box((-w * 0.2, w * 0.2), (d * 0.4, d / 2), (0, h), "metal_steel", "clip")


@recipe("usb_stick")
def usb_stick(b: Builder) -> None:
    """A rounded case with a light, and a metal plug with two square holes in front."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d * 0.18), (0, h), b.mat(), "case", 0.4)
    b.box((-w * 0.38, w * 0.38), (d * 0.16, d / 2), (h * 0.2, h * 0.8), "metal_chrome", "plug")
    for side in (-1, 1):
        x = side * w * 0.16
        b.box(
            (x - w * 0.08, x + w * 0.08),
            (d * 0.3, d * 0.36),
            (h * 0.78, h * 0.815),
            "plastic_black",
            "holes",
            solid=False,
        )
    b.box((-w * 0.3, w * 0.3), (-d * 0.3, d * 0.02), (h, h * 1.03), "paint_3a7bc8", "label", solid=False)
    b.cyl(0, -d * 0.4, (h * 0.97, h * 1.03), w * 0.09, "light_green", "light", solid=False)


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


@recipe("mobile_phone")
def mobile_phone(b: Builder) -> None:
    """A telephone with a bright screen of coloured icons in rows, a dock, a speaker slot, and a camera on top."""
    w, d, h = b.w, b.d, b.h
    lit = (h, h * 1.03)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h), "plastic_black", "case")
    b.box((-w * 0.45, w * 0.45), (-d * 0.46, d * 0.46), lit, "plastic_9cc4ea", "screen", solid=False)
    colors = (
        "paint_red",
        "paint_2f9a4a",
        "paint_orange",
        "paint_1d5fd0",
        "plastic_white",
        "paint_yellow",
        "paint_purple",
    )
    for k in range(20):
        row, column = divmod(k, 4)
        x, y = w * (0.32 - 0.213 * column), d * (-0.3 + 0.125 * row)
        if row == 4:
            y = d * 0.38
        side = w * 0.075
        b.box(
            (x - side, x + side),
            (y - side, y + side),
            (h * 1.03, h * 1.06),
            colors[(k * 3 + row) % 7],
            "icons",
            solid=False,
        )
    b.box((-w * 0.14, w * 0.14), (-d * 0.445, -d * 0.42), (h * 1.03, h * 1.06), "plastic_black", "speaker", solid=False)


@recipe("compact_disc")
def compact_disc(b: Builder) -> None:
    """A silver disc with a hole, a clear hub and sectors that shine in the colours of the rainbow."""
    w, d, h = b.w, b.d, b.h
    n = 48
    turns = [k * 2 * math.pi / n for k in range(n + 1)]
    glow = {
        4: "plastic_e79ac0",
        5: "plastic_8fd3c8",
        6: "plastic_e8e08a",
        28: "plastic_8fd3c8",
        29: "plastic_a9b7ee",
        30: "plastic_e79ac0",
    }
    for k in range(n):
        sector = [
            (r * math.cos(a), r * math.sin(a))
            for r, a in ((0.17, turns[k]), (0.5, turns[k]), (0.5, turns[k + 1]), (0.17, turns[k + 1]))
        ]
        b.prism([(x * w, y * d) for x, y in sector], (0, h), glow.get(k, "metal_light"), "z", "disc")
        hub = [
            (r * math.cos(a), r * math.sin(a))
            for r, a in ((0.07, turns[k]), (0.17, turns[k]), (0.17, turns[k + 1]), (0.07, turns[k + 1]))
        ]
        b.prism([(x * w, y * d) for x, y in hub], (h * 0.2, h * 0.8), "plastic_dark", "z", "hub")
