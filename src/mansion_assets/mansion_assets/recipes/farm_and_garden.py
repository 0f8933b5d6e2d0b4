"""Cages and troughs of animals, stands of flowers, and chests of frozen food: open tops and wires."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


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


@recipe("flower_stand")
def flower_stand(b: Builder) -> None:
    """Steps of pots on a stand, each full of blossoms above leaves: red, yellow, pink, white and purple."""
    w, d, h = b.w, b.d, b.h
    for step, (y0, y1, z) in enumerate(((-d / 2, -d * 0.06, h * 0.5), (-d * 0.06, d / 2, h * 0.24))):
        b.box((-w / 2, w / 2), (y0, y1), (z - 0.03, z), b.mat(), "steps")
        for x in (-w * 0.46, w * 0.46):
            b.box((x - 0.025, x + 0.025), (y0 + 0.01, y1 - 0.01), (0, z - 0.03), b.mat(), "sides")
        for k in range(4):
            x, y = w * (-0.36 + 0.24 * k), (y0 + y1) / 2
            pot = h * 0.17
            b.lathe(
                [(0.055, z), (0.08, z + pot), (0.07, z + pot), (0.05, z + 0.02)],
                ("metal_light", "food_b5623a")[(k + step) % 2],
                (x, y),
                "pots",
                12,
            )
            color = ("red", "yellow", "pink", "white", "purple", "orange")[(k * 2 + step * 3) % 6]
            for j in range(6):
                a = j * math.tau / 5
                reach = 0.0 if j == 5 else 0.065
                top = z + pot + h * (0.19 if j == 5 else 0.12 + 0.03 * (j % 2))
                tip = (x + math.cos(a) * reach, y + math.sin(a) * reach, top)
                b.rod((x, y, z + pot * 0.8), tip, 0.007, "leaf_green", "stems", 4)
                b.ball(tip, (0.034, 0.034, 0.03), f"leaf_{color}", "blossoms", 8)
                b.ball(
                    (tip[0] * 0.5 + x * 0.5, tip[1] * 0.5 + y * 0.5 + 0.01, z + pot + 0.02),
                    (0.03, 0.03, 0.02),
                    "leaf_3f7f3a",
                    "leaves",
                    6,
                )


@recipe("frozen_chest")
def frozen_chest(b: Builder) -> None:
    """A white chest with sliding panes of glass over boxes of food, snowflakes and the word FROZEN on its front."""
    w, d, h = b.w, b.d, b.h
    low, t = h * 0.7, 0.05
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.02, d / 2 - 0.02), (0.06, low), b.mat(), "base")
    b.box((-w * 0.47, w * 0.47), (-d * 0.45, d * 0.45), (0, 0.06), "plastic_dark", "plinth")
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * (w / 2 - t))), sorted((side * d / 2, side * (d / 2 - t)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (low - 0.1, h - 0.012), "plastic_4f9bd9", "rim")
        b.box((-w / 2, w / 2), (along[0], along[1]), (low - 0.1, h - 0.012), "plastic_4f9bd9", "rim")
    cols, rows = max(3, round(w / 0.26)), 3
    for i in range(cols):
        for j in range(rows):
            x0, y0 = -w / 2 + t + i * (w - 2 * t) / cols, -d / 2 + t + j * (d - 2 * t) / rows
            place = (x0 + 0.01, x0 + (w - 2 * t) / cols - 0.01), (y0 + 0.01, y0 + (d - 2 * t) / rows - 0.01)
            color = ("paper_red", "plastic_dff2fb", "paper_blue", "paper_green", "paper_yellow")[(i * 2 + j) % 5]
            b.box(*place, (low, low + (h - low) * (0.4 + 0.12 * ((i + j) % 3))), color, "goods", solid=False)
    for k, z in enumerate((h - 0.012, h - 0.006)):
        pane = (-w / 2 + 0.01, w * 0.02) if k == 0 else (-w * 0.02, w / 2 - 0.01)
        b.box(pane, (-d / 2 + 0.01, d / 2 - 0.01), (z, z + 0.004), "glass_clear", "panes", solid=False)
        edge = pane[1] if k == 0 else pane[0]
        b.box(
            (edge - 0.02, edge + 0.02),
            (-d / 2 + 0.01, d / 2 - 0.01),
            (z, z + 0.006),
            "metal_light",
            "panes",
            solid=False,
        )
    face = DrawnFace.front(b, d / 2 - 0.02)
    face.write("FROZEN", (-w * 0.22, w * 0.22), (h * 0.26, h * 0.5), "plastic_2f7fd0", "letters", 0.006)
    for u in (-w * 0.36, w * 0.36):
        for k in range(3):
            a = math.pi / 2 + k * math.pi / 3
            arm = (math.cos(a) * h * 0.13, math.sin(a) * h * 0.13)
            face.line(
                [(u - arm[0], h * 0.38 - arm[1]), (u + arm[0], h * 0.38 + arm[1])], 0.014, "plastic_2f7fd0", "flakes"
            )
            for side in (-1, 1):
                tip = (u + side * arm[0] * 0.7, h * 0.38 + side * arm[1] * 0.7)
                for turn in (a + 0.9, a - 0.9):
                    twig = (tip[0] + side * math.cos(turn) * h * 0.05, tip[1] + side * math.sin(turn) * h * 0.05)
                    face.line([tip, twig], 0.01, "plastic_2f7fd0", "flakes")
