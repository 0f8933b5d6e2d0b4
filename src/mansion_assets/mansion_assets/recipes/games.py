"""Games: tables, boards, arcade cabinets and consoles."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("pingpong")
def pingpong(b: Builder) -> None:
    """Table tennis: the net lies across."""
    w, d, h = b.w, b.d, b.h
    z = h - 0.15
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - 0.025, z), b.mat(), "top")
    b.box((-0.01, 0.01), (-d / 2, d / 2), (z, z + 0.001), "plastic_white", "lines", solid=False)
    for sx in (-1, 1):
        for sy in (-1, 1):
            b.box(
                (sx * w * 0.36 - 0.025, sx * w * 0.36 + 0.025),
                (sy * d * 0.3 - 0.025, sy * d * 0.3 + 0.025),
                (0, z),
                "metal_black",
                "legs",
            )
            lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.02)))
            b.box((lo, hi), (-d / 2, d / 2), (z, z + 0.001), "plastic_white", "lines", solid=False)
    b.box((-w / 2, w / 2), (-0.004, 0.004), (z, h), "fabric_dark", "net")


@recipe("pool_table")
def pool_table(b: Builder) -> None:
    """Cloth, rails, pockets and balls; air hockey has a white top and no balls."""
    w, d, h = b.w, b.d, b.h
    rail = 0.13
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, d / 2 - 0.05), (h - 0.3, h - 0.05), "wood_walnut", "body")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - rail)))
        b.box((lo, hi), (-d / 2, d / 2), (h - 0.12, h), "wood_walnut", "rails")
        for sy in (-1, 1):
            b.lathe(
                [(0.09, 0), (0.06, h * 0.2), (0.1, h - 0.3)],
                "wood_walnut",
                (sx * (w / 2 - 0.2), sy * (d / 2 - 0.25)),
                "legs",
                14,
            )
            b.cyl(
                sx * (w / 2 - rail),
                sy * (d / 2 - rail),
                (h - 0.02, h + 0.0),
                0.06,
                "leather_black",
                "pockets",
                n=14,
                solid=False,
            )
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2, sy * (d / 2 - rail)))
        b.box((-w / 2, w / 2), (lo, hi), (h - 0.12, h), "wood_walnut", "rails")
    b.box((-w / 2 + rail, w / 2 - rail), (-d / 2 + rail, d / 2 - rail), (h - 0.06, h - 0.035), b.mat(), "cloth")
    if b.mat().startswith("fabric"):
        for k in range(10):
            row = int((math.sqrt(8 * k + 1) - 1) / 2)
            x = (k - row * (row + 1) / 2 - row / 2) * 0.06
            b.ball(
                (x, -d * 0.2 - row * 0.052, h - 0.007),
                (0.028, 0.028, 0.028),
                ("paint_red", "paint_yellow", "paint_blue", "paint_green")[k % 4],
                "balls",
                8,
                solid=False,
            )
        b.ball((0, d * 0.25, h - 0.007), (0.028, 0.028, 0.028), "plastic_white", "balls", 8, solid=False)


@recipe("air_hockey")
def air_hockey(b: Builder) -> None:
    """A white top in a blue rim, with red and blue lines, goals, a puck and two mallets."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.9
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (top - 0.2, top - 0.04), "plastic_2f5fa8", "case")
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * (w / 2 - 0.07))), sorted((side * d / 2, side * (d / 2 - 0.07)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (top - 0.04, top + 0.03), "plastic_2f5fa8", "rails")
        b.box((-w / 2, w / 2), (along[0], along[1]), (top - 0.04, top + 0.03), "plastic_2f5fa8", "rails")
        b.box(
            (-w * 0.3, w * 0.3),
            (side * d * 0.36 - 0.12, side * d * 0.36 + 0.12),
            (0, top - 0.2),
            "plastic_dark",
            "legs",
        )
        goal = sorted((side * (d / 2 - 0.08), side * (d / 2 + 0.002)))
        b.box((-w * 0.2, w * 0.2), (goal[0], goal[1]), (top - 0.04, top + 0.012), "plastic_black", "goals", solid=False)
    b.box((-w / 2 + 0.07, w / 2 - 0.07), (-d / 2 + 0.07, d / 2 - 0.07), (top - 0.04, top), b.mat(), "field")
    field = DrawnFace.top(b, top)
    field.field((-w / 2 + 0.07, w / 2 - 0.07), (-0.012, 0.012), "paint_red", "lines")
    for v in (-d * 0.2, d * 0.2):
        field.field((-w / 2 + 0.07, w / 2 - 0.07), (v - 0.008, v + 0.008), "paint_blue", "lines")
    for v, r, color in ((0.0, 0.2, "paint_red"), (d * 0.46, 0.24, "paint_blue"), (-d * 0.46, 0.24, "paint_blue")):
        ring = [
            (math.cos(a) * w * r, v - math.copysign(abs(math.sin(a)), v) * w * r if v else math.sin(a) * w * r)
            for a in (k * math.tau / 24 for k in range(25))
        ]
        half = ring if not v else ring[:13]
        field.line(half, 0.009, color, "lines")
    for x, y, color in ((w * 0.14, d * 0.3, "plastic_red"), (-w * 0.1, -d * 0.3, "plastic_green")):
        b.lathe(
            [(0.1, top), (0.1, top + 0.035), (0.045, top + 0.05), (0.04, top + 0.1), (0.02, top + 0.115)],
            color,
            (x, y),
            "mallets",
            18,
        )
    b.cyl(-w * 0.16, d * 0.06, (top, top + 0.015), 0.07, "plastic_red", "puck", n=18)


@recipe("foosball")
def foosball(b: Builder) -> None:
    """Table football."""
    w, d, h = b.w, b.d, b.h
    bw = w - 0.3 if w > 1.3 else w * 0.8
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2, sy * (d / 2 - 0.04)))
        b.box((-bw / 2, bw / 2), (lo, hi), (h - 0.28, h), b.mat(), "box")
    for sx in (-1, 1):
        lo, hi = sorted((sx * bw / 2, sx * (bw / 2 - 0.04)))
        b.box((lo, hi), (-d / 2, d / 2), (h - 0.28, h), b.mat(), "box")
        for sy in (-1, 1):
            x, y = sx * (bw / 2 - 0.06), sy * (d / 2 - 0.06)
            b.box((x - 0.05, x + 0.05), (y - 0.05, y + 0.05), (0, h - 0.2), b.mat(), "legs")
    b.box((-bw / 2, bw / 2), (-d / 2, d / 2), (h - 0.2, h - 0.18), "plastic_green", "field")
    for k in range(6):
        x = -bw * 0.4 + k * bw * 0.16
        b.rod((x, -d / 2, h - 0.06), (x, d / 2, h - 0.06), 0.009, "metal_steel", "rods")
        for j in range(3):
            b.box(
                (x - 0.012, x + 0.012),
                (-d * 0.3 + j * d * 0.3 - 0.015, -d * 0.3 + j * d * 0.3 + 0.015),
                (h - 0.16, h - 0.03),
                ("plastic_red", "plastic_blue")[k % 2],
                "men",
                solid=False,
            )
    b.rod((-w / 2, 0, h - 0.1), (w / 2, 0, h - 0.1), 0.012, "plastic_black", "grips")


@recipe("board_game")
def board_game(b: Builder) -> None:
    """A board of fields round its edge, with pieces of four colours, two dice and a stack of cards."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.22
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, top), b.mat(), "board")
    face = DrawnFace.top(b, top)
    face.field((-w * 0.36, w * 0.36), (-d * 0.36, d * 0.36), "paper_beige", "middle", 0.001)
    colors = ("paper_yellow", "paper_white", "paper_blue", "paper_green", "paper_orange")
    for k in range(9):
        s = -0.49 + 0.1089 * k
        for side in (-1, 1):
            edge = sorted((side * 0.49, side * 0.375))
            color = colors[(k * 2 + side) % 5]
            face.field((w * s, w * (s + 0.1)), (d * edge[0], d * edge[1]), color, "fields", 0.001)
            if 0 < k < 8:
                face.field((w * edge[0], w * edge[1]), (d * s, d * (s + 0.1)), color, "fields", 0.001)
    for k, color in enumerate(("red", "blue", "green", "yellow")):
        x, y = w * (0.43 - 0.26 * k), d * (0.42 if k % 2 else 0.2)
        b.lathe([(w * 0.045, top), (w * 0.018, top + h * 0.45)], f"plastic_{color}", (x, y), "pieces", 12)
        b.ball((x, y, top + h * 0.5), (w * 0.028, w * 0.028, h * 0.14), f"plastic_{color}", "pieces", 8)
    for x, y in ((w * 0.08, d * 0.12), (-w * 0.06, d * 0.2)):
        b.box(
            (x - w * 0.04, x + w * 0.04), (y - w * 0.04, y + w * 0.04), (top, top + w * 0.08), "plastic_white", "dice"
        )
        DrawnFace.top(b, top + w * 0.08).disc(-x, -y, w * 0.016, "plastic_black", "dice", 0.001, 8)
        DrawnFace.front(b, y + w * 0.04).disc(-x, top + w * 0.04, w * 0.014, "plastic_black", "dice", 0.001, 8)
    b.box((-w * 0.24, -w * 0.06), (-d * 0.26, -d * 0.02), (top, h * 0.5), "paper_red", "cards")
    b.box((w * 0.04, w * 0.22), (-d * 0.26, -d * 0.02), (top, h * 0.4), "paper_blue", "cards")


@recipe("chess")
def chess(b: Builder) -> None:
    """Board with men."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.2
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, low), "wood_walnut", "board")
    s = w * 0.9 / 8
    for i in range(8):
        for j in range(8):
            x, y = -w * 0.45 + i * s, -d * 0.45 + j * s
            if (i + j) % 2:
                b.box((x, x + s), (y, y + s), (low, low + 0.001), "wood_birch", "squares", solid=False)
            if j in (0, 1, 6, 7):
                high = h - low if (i, j) in ((4, 0), (4, 7)) else (h - low) * (0.75 if j in (0, 7) else 0.5)
                b.lathe(
                    [(0.36, low), (0.16, low + high * 0.4), (0.26, low + high * 0.8), (0.05, low + high)],
                    "wood_birch" if j < 4 else "wood_black",
                    (x + s / 2, y + s / 2),
                    "men",
                    8,
                    (s, s),
                    solid=False,
                )


@recipe("arcade")
def arcade(b: Builder) -> None:
    """Video game cabinet."""
    w, d, h = b.w, b.d, b.h
    side = [
        (-d / 2, 0),
        (d * 0.3, 0),
        (d * 0.3, h * 0.46),
        (d / 2, h * 0.54),
        (d * 0.42, h * 0.6),
        (0.0, h * 0.84),
        (d * 0.2, h * 0.88),
        (d * 0.16, h),
        (-d / 2, h),
    ]
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.03)))
        for k in range(1, len(side) - 1):
            b.prism([side[0], side[k], side[k + 1]], (lo, hi), b.mat(), part="sides", solid=False)
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2, d * 0.28), (0, h * 0.46), "plastic_black", "body")
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2, -0.02), (h * 0.46, h), "plastic_black", "body")
    b.prism(
        [(d * 0.1, h * 0.46), (d * 0.48, h * 0.54), (d * 0.42, h * 0.58), (0.0, h * 0.6)],
        (-w / 2 + 0.03, w / 2 - 0.03),
        "plastic_dark",
        part="panel",
    )
    b.prism(
        [(d * 0.16, h * 0.6), (d * 0.18, h * 0.61), (0.02, h * 0.83), (0.0, h * 0.82)],
        (-w * 0.4, w * 0.4),
        "screen_blue",
        part="screen",
        solid=False,
    )
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (0.0, d * 0.17), (h * 0.88, h * 0.99), "light_warm", "marquee", solid=False)
    for k, color in enumerate(("plastic_red", "plastic_yellow", "plastic_blue")):
        b.ball((-w * 0.1 + k * w * 0.14, d * 0.36, h * 0.56), (0.02, 0.02, 0.02), color, "buttons", 8, solid=False)


@recipe("game_console")
def game_console(b: Builder) -> None:
    """A flat case with a slot and a light; on it a controller with two sticks, a cross and four coloured buttons."""
    w, d, h = b.w, b.d, b.h
    case = h * 0.42
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, case), b.mat(), "case")
    b.box((-w * 0.4, w * 0.1), (d / 2, d / 2 + 0.001), (case * 0.5, case * 0.64), "plastic_grey", "slot", solid=False)
    b.box((w * 0.3, w * 0.36), (d / 2, d / 2 + 0.001), (case * 0.4, case * 0.7), "light_blue", "lamp", solid=False)
    z, face = (case, h * 0.84), h * 0.84
    b.cushion((-w * 0.34, w * 0.34), (-d * 0.26, d * 0.12), z, "plastic_white", "controller", 0.6)
    for side in (-1, 1):
        lo, hi = sorted((side * w * 0.4, side * w * 0.18))
        b.cushion((lo, hi), (-d * 0.3, d * 0.36), z, "plastic_white", "controller", 0.8)
        b.cyl(side * w * 0.12, d * 0.06, (face - 0.004, h), w * 0.055, "plastic_black", "sticks", n=14)
    x, y = -w * 0.27, -d * 0.1
    b.box(
        (x - w * 0.06, x + w * 0.06), (y - d * 0.025, y + d * 0.025), (face - 0.004, h * 0.93), "plastic_black", "cross"
    )
    b.box(
        (x - w * 0.02, x + w * 0.02), (y - d * 0.075, y + d * 0.075), (face - 0.004, h * 0.93), "plastic_black", "cross"
    )
    spots = ((0.05, 0.0, "red"), (-0.05, 0.0, "blue"), (0.0, 0.065, "yellow"), (0.0, -0.065, "green"))
    for u, v, color in spots:
        b.cyl(w * (0.27 + u), y + d * v, (face - 0.004, h * 0.93), w * 0.026, f"plastic_{color}", "buttons", n=12)
