"""Furniture at which people are served: packing tables, checkouts, altars, changing tables, lecture chairs, cases."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("packing_table")
def packing_table(b: Builder) -> None:
    """A bench with a roll of brown paper on a bar below its top, flat cartons on its shelf, and a tape on a hook."""
    w, d = b.w, b.d
    z = b.tops[0].z
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - 0.04, z), b.mat(), "top")
    b.legs((0, z - 0.04), 0.035, b.mat("frame", "metal_grey"), 0.02)
    shelf = b.tops[1].z if len(b.tops) > 1 else 0.2
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, d / 2 - 0.05), (shelf - 0.025, shelf), "metal_grey", "shelf")
    r = 0.15
    for x in (-w * 0.34, w * 0.16):
        b.box((x - 0.012, x + 0.012), (d / 2 - 0.16, d / 2 - 0.08), (z - 0.3, z - 0.04), "metal_dark", "brackets")
    y, axis = d / 2 - r - 0.02, z - 0.22
    b.rod((-w * 0.32, y, axis), (w * 0.14, y, axis), r, "paper_b98d5c", "paper", 24)
    b.rod((-w * 0.36, y, axis), (w * 0.18, y, axis), 0.025, "metal_steel", "paper", 10)
    b.prism(
        [(y + r - 0.006, axis), (y + r, axis), (y + r + 0.01, axis - 0.24), (y + r + 0.004, axis - 0.24)],
        (-w * 0.32, w * 0.14),
        "paper_b98d5c",
        part="paper",
    )
    b.rod((w * 0.3, d / 2 - 0.02, z - 0.16), (w * 0.3, d / 2 + 0.01, z - 0.16), 0.07, "plastic_d9a441", "tape", 20)
    b.rod((w * 0.3, d / 2 - 0.022, z - 0.16), (w * 0.3, d / 2 + 0.014, z - 0.16), 0.04, "paper_white", "tape", 16)
    DrawnFace.front(b, d / 2 - 0.035).write(
        "PACKING", (-w * 0.48, -w * 0.3), (z - 0.034, z - 0.006), "plastic_black", "letters", 0.036
    )


@recipe("till_belt")
def till_belt(b: Builder) -> None:
    """A checkout: a black belt, a scanner let into its top, a cash desk behind it, and CHECKOUT on its front."""
    w, d, h = b.w, b.d, b.h
    back = -d / 2 + 0.34
    b.box((-w / 2, w / 2), (back, d / 2), (0.06, h - 0.05), b.mat(), "body")
    b.box((-w / 2, w / 2), (back, d / 2), (h - 0.05, h), "metal_steel", "top")
    b.box((-w / 2 + 0.04, w / 2 - 0.04), (back + 0.04, d / 2 - 0.04), (0, 0.06), "metal_dark", "plinth")
    b.box((-0.45, 0.45), (-d / 2, back), (0.05, h * 0.72), b.mat(), "cash")
    top = DrawnFace.top(b, h)
    top.field((-0.3, w / 2 - 0.06), (-d / 2 + 0.08, d / 2 - 0.46), "rubber_black", "belt", 0.003)
    for k in range(6):
        u = -0.26 + k * (w / 2 + 0.16) / 5.4
        top.field((u, u + 0.012), (-d / 2 + 0.08, d / 2 - 0.46), "plastic_dark", "belt", 0.005)
    top.field((-0.62, -0.34), (-d / 2 + 0.12, d / 2 - 0.5), "metal_chrome", "scanner", 0.004)
    top.field((-0.56, -0.4), (-d / 2 + 0.2, -d / 2 + 0.4), "glass_black", "scanner", 0.006)
    face = DrawnFace.front(b, d / 2)
    face.field((-w / 2, w / 2), (h * 0.62, h * 0.7), "paint_red", "stripe", 0.004)
    face.write("CHECKOUT", (-w * 0.3, w * 0.3), (h * 0.28, h * 0.5), "paint_red", "letters", 0.004)


@recipe("altar")
def altar(b: Builder) -> None:
    """A block of stone with a white cloth whose ends hang down, edged with gold, and a golden cross on its front."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.08), "stone_grey", "step")
    b.box((-w * 0.42, w * 0.42), (-d * 0.4, d * 0.4), (h * 0.08, h * 0.9), b.mat(), "body")
    b.box((-w / 2 + 0.01, w / 2 - 0.01), (-d / 2 + 0.01, d / 2 - 0.01), (h * 0.9, h * 0.985), b.mat(), "slab")
    cloth = (-d / 2 + 0.05, d / 2 - 0.05)
    b.box((-w / 2, w / 2), cloth, (h * 0.985, h), "fabric_fdfdfb", "cloth")
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - 0.012)))
        b.box((across[0], across[1]), cloth, (h * 0.4, h), "fabric_fdfdfb", "cloth")
        b.box((across[0] - 0.002, across[1] + 0.002), cloth, (h * 0.4, h * 0.44), "metal_brass", "fringe")
    face = DrawnFace.front(b, d / 2 - 0.01)
    face.field((-w * 0.3, w * 0.3), (h * 0.5, h * 0.98), "fabric_fdfdfb", "front_cloth", 0.008)
    face.field((-w * 0.3, w * 0.3), (h * 0.5, h * 0.54), "metal_brass", "fringe", 0.012)
    plate = DrawnFace.front(b, d * 0.4)
    face.field((-w * 0.03, w * 0.03), (h * 0.6, h * 0.94), "metal_brass", "cross", 0.014)
    face.field((-w * 0.1, w * 0.1), (h * 0.78, h * 0.84), "metal_brass", "cross", 0.014)
    for side in (-1, 1):
        u = side * w * 0.3
        plate.field((u - w * 0.05, u + w * 0.05), (h * 0.14, h * 0.46), "stone_white", "panels", 0.012)
        plate.field((u - w * 0.012, u + w * 0.012), (h * 0.2, h * 0.42), "metal_brass", "panels", 0.02)
        plate.field((u - w * 0.035, u + w * 0.035), (h * 0.33, h * 0.36), "metal_brass", "panels", 0.02)


@recipe("tablet_chair")
def tablet_chair(b: Builder) -> None:
    """A lecture chair: a shell on steel legs, and an arm with a small writing top, paper and a pencil."""
    w, d, h = b.w, b.d, b.h
    seat = b.tops[0].z
    x1 = w / 2 - 0.12
    middle = (x1 - w / 2) / 2
    b.cushion((-w / 2 + 0.02, x1), (-d / 2 + 0.1, d * 0.3), (seat - 0.04, seat), b.mat(), "seat", 0.5)
    b.prism(
        [(-d / 2 + 0.08, seat + 0.1), (-d / 2 + 0.12, seat + 0.1), (-d / 2 + 0.05, h), (-d / 2 + 0.01, h)],
        (-w / 2 + 0.02, x1),
        b.mat(),
        part="back",
    )
    for x in (-w / 2 + 0.04, x1 - 0.02):
        b.path(
            [(x, d * 0.28, 0.012), (x, d * 0.24, seat - 0.03), (x, -d * 0.34, seat - 0.03), (x, -d * 0.44, 0.012)],
            0.012,
            "metal_chrome",
            "legs",
        )
        b.path(
            [(x, -d * 0.34, seat - 0.03), (x, -d / 2 + 0.06, seat + 0.12), (x, -d / 2 + 0.03, h - 0.06)],
            0.011,
            "metal_chrome",
            "legs",
        )
    b.rod((-w / 2 + 0.04, d * 0.1, 0.12), (x1 - 0.02, d * 0.1, 0.12), 0.008, "metal_chrome", "rack", 8)
    z = seat + 0.24
    b.path(
        [(x1, -d * 0.2, seat - 0.03), (w / 2 - 0.05, -d * 0.2, z - 0.02), (w / 2 - 0.05, d * 0.3, z - 0.02)],
        0.016,
        "metal_chrome",
        "arm",
    )
    top = [
        (w / 2, -d * 0.2),
        (w / 2, d * 0.44),
        (w / 2 - 0.06, d / 2),
        (middle - 0.1, d / 2),
        (middle - 0.12, d * 0.24),
        (w / 2 - 0.16, d * 0.16),
        (w / 2 - 0.14, -d * 0.2),
    ]
    b.prism([top[k] for k in (0, 1, 5, 6)], (z, z + 0.022), "wood_birch", "z", "tablet")
    b.prism([top[k] for k in (1, 2, 3, 4, 5)], (z, z + 0.022), "wood_birch", "z", "tablet")
    b.box(
        (middle + 0.0, middle + 0.17), (d * 0.26, d * 0.46), (z + 0.022, z + 0.03), "paper_white", "paper", solid=False
    )
    b.rod((middle + 0.2, d * 0.26, z + 0.028), (middle + 0.24, d * 0.42, z + 0.028), 0.006, "paint_yellow", "pencil", 6)


@recipe("changing_table")
def changing_table(b: Builder) -> None:
    """Drawers with bear-brown knobs below a hollow pad between raised sides, with a strap and the sign of a baby."""
    w, d, h = b.w, b.d, b.h
    high, face = h * 0.84, d / 2 - 0.02
    b.hollow((-w / 2, w / 2), (-d / 2, face), (0.05, high), 0.02, b.mat())
    for x in (-w * 0.45, w * 0.45):
        b.box((x - 0.03, x + 0.03), (-d * 0.46, d * 0.4), (0, 0.05), "wood_birch", "feet")
    rows = 3
    step = (high - 0.09) / rows
    for k in range(rows):
        z = (0.072 + k * step, 0.072 + (k + 1) * step - 0.012)
        color = ("plastic_f2b8c6", "plastic_f2e08f", "plastic_a8d5e8")[k]
        with b.drawer((-w / 2 + 0.024, w / 2 - 0.024), (-d / 2 + 0.03, face), (z[0], z[0] + step * 0.6), b.mat()):
            b.box((-w / 2 + 0.01, w / 2 - 0.01), (face + 0.001, face + 0.016), z, color, "drawers", solid=False)
            for u in (-w * 0.2, w * 0.2):
                b.rod((u, face + 0.015, sum(z) / 2), (u, d / 2 + 0.01, sum(z) / 2), 0.018, "wood_brown", "knobs", 12)
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - 0.025)))
        wall = [(-d / 2, high), (face, high), (face, h * 0.94), (d * 0.1, h), (-d / 2, h)]
        b.prism(wall, (across[0], across[1]), b.mat(), part="sides")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.025), (high, h), b.mat(), "sides")
    b.box((-w / 2, w / 2), (face - 0.02, face), (high, h * 0.89), b.mat(), "sides")
    for y in ((-d / 2 + 0.03, -d * 0.22), (d * 0.18, face - 0.025)):
        b.cushion((-w * 0.46, w * 0.46), y, (high, h * 0.95), "fabric_a8d5e8", "pad", 0.8)
    b.cushion((-w * 0.46, w * 0.46), (-d * 0.24, d * 0.2), (high, h * 0.9), "fabric_a8d5e8", "pad", 0.6)
    b.ball((w * 0.22, -d * 0.02, h * 0.93), (0.065, 0.06, 0.06), "fabric_f0cfae", "baby", 12)
    b.cushion(
        (-w * 0.1, w * 0.15), (-d * 0.02 - 0.08, -d * 0.02 + 0.08), (h * 0.88, h * 0.98), "fabric_f2e08f", "baby", 0.9
    )
    for side in (-1, 1):
        b.rod(
            (-w * 0.08, -d * 0.02 + side * 0.04, h * 0.92),
            (-w * 0.24, -d * 0.02 + side * 0.08, h * 0.92),
            0.03,
            "fabric_f0cfae",
            "baby",
            8,
        )
        b.rod(
            (w * 0.1, -d * 0.02 + side * 0.07, h * 0.93),
            (w * 0.16, -d * 0.02 + side * 0.16, h * 0.93),
            0.022,
            "fabric_f0cfae",
            "baby",
            8,
        )


@recipe("centrifuge")
def centrifuge(b: Builder) -> None:
    """A floor centrifuge: a cabinet whose lid stands open over the rotor with its tubes, and a panel with figures."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.72
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0.05, top - 0.02), b.mat(), "case")
    b.legs((0, 0.05), 0.025, "metal_dark", 0.03)
    r = min(w * 0.42, d * 0.36)
    y = -d * 0.08
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (top - 0.02, top), "plastic_light", "case")
    b.cyl(0, y, (top, top + 0.006), r, "metal_dark", "bowl", n=28)
    b.lathe(
        [(r, top), (r * 1.06, top + 0.03), (r * 0.98, top + 0.03), (r * 0.96, top)], "metal_chrome", (0, y), "bowl", 28
    )
    b.cyl(0, y, (top, top + 0.03), r * 0.5, "metal_blue", "rotor", r * 0.3, n=18)
    b.cyl(0, y, (top + 0.03, top + 0.05), r * 0.12, "metal_steel", "rotor", n=12)
    for k in range(8):
        a = k * math.pi / 4
        inner = (math.cos(a) * r * 0.5, y + math.sin(a) * r * 0.5, top + 0.045)
        outer = (math.cos(a) * r * 0.86, y + math.sin(a) * r * 0.86, top + 0.015)
        b.rod(inner, outer, r * 0.11, "glass_white", "tubes", 8)
        b.rod(
            inner,
            (inner[0] * 0.86, y + (inner[1] - y) * 0.86, top + 0.055),
            r * 0.12,
            ("plastic_red", "plastic_purple")[k % 2],
            "tubes",
            8,
        )
    b.prism(
        [(-d / 2, top), (-d / 2 + 0.05, top), (-d / 2 + 0.02, h), (-d / 2 - 0.03, h)],
        (-w * 0.46, w * 0.46),
        b.mat(),
        part="lid",
    )
    lid = DrawnFace.sloped(b, (-d / 2 + 0.05, top), (-d / 2 + 0.02, h))
    lid.disc(0, (h - top) / 2, min(w * 0.3, (h - top) * 0.4), "plastic_dark", "lid", 0.012, 24)
    face = DrawnFace.front(b, d / 2)
    face.field((-w * 0.42, w * 0.42), (top * 0.7, top * 0.94), "plastic_dark", "panel", 0.006)
    face.write("4000", (-w * 0.36, w * 0.04), (top * 0.75, top * 0.9), "light_red", "figures", 0.009)
    face.write("RPM", (w * 0.08, w * 0.36), (top * 0.82, top * 0.9), "plastic_white", "figures", 0.009)
    for k, color in enumerate(("green", "red")):
        face.disc(w * (0.14 + 0.14 * k), top * 0.76, w * 0.035, f"plastic_{color}", "buttons", 0.014)


@recipe("banquet_table")
def banquet_table(b: Builder) -> None:
    """A round top under a white cloth that falls to the floor in deep folds, with a golden edge."""
    w, d = b.w, b.d
    z = b.tops[0].z
    b.lathe([(0.5, z - 0.02), (0.5, z)], b.mat(), stretch=(w, d), part="top", n=36)
    b.lathe([(0.47, 0.0), (0.485, z - 0.02)], b.mat(), stretch=(w, d), part="cloth", n=36)
    folds = 20
    for k in range(folds):
        a = k * math.tau / folds
        ux, uy = math.cos(a), math.sin(a)
        b.rod(
            (ux * w * 0.475, uy * d * 0.475, z - 0.03),
            (ux * w * 0.468, uy * d * 0.468, 0.0),
            w * 0.03,
            b.mat(),
            "folds",
            8,
        )
    b.lathe([(0.493, z * 0.8), (0.503, z - 0.015)], "fabric_c9a24a", stretch=(w, d), part="overlay", n=36)


@recipe("folded_blanket")
def folded_blanket(b: Builder) -> None:
    """A thick blanket in checks, folded twice so that its edges are round, with a fringe at its ends."""
    w, d, h = b.w, b.d, b.h
    checks = "fabric_e8e2d2" if b.mat() != "fabric_grey" else "fabric_red"
    for k in range(3):
        z = (h * k / 3, h * (k + 1) / 3)
        b.cushion((-w * 0.46, w * 0.46), (-d / 2, d / 2), z, b.mat(), "folds", 0.9, 14)
        for j in range(4):
            y = d * (-0.36 + 0.24 * j)
            b.rod((-w * 0.45, y, z[0] + h * 0.16), (w * 0.45, y, z[0] + h * 0.16), h * 0.02, checks, "checks", 4)
    face = DrawnFace.top(b, h * 0.985)
    for k in range(4):
        u, v = w * (-0.34 + 0.21 * k), d * (-0.34 + 0.21 * k)
        face.field((u, u + w * 0.06), (-d * 0.42, d * 0.42), checks, "checks", h * 0.02)
        face.field((-w * 0.42, w * 0.42), (v, v + d * 0.06), checks, "checks", h * 0.024)
    front = DrawnFace.front(b, d / 2 - h * 0.01)
    for k in range(4):
        u = w * (-0.34 + 0.21 * k)
        for j in range(3):
            front.field((u, u + w * 0.06), (h * (j / 3 + 0.08), h * (j / 3 + 0.25)), checks, "checks", h * 0.03)
    for side in (-1, 1):
        for k in range(16):
            y = d * (-0.44 + 0.0587 * k)
            b.rod((side * w * 0.44, y, h * 0.3), (side * w / 2, y, h * 0.12), h * 0.025, checks, "fringe", 5)
