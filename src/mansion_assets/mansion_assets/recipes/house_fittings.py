"""Fittings and small ornaments of a home: dishwashers, blinds, teapots, jars, tooth brushes, ornaments."""

import itertools
import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.recipes.storage import cabinet
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("dishwasher")
def dishwasher(b: Builder) -> None:
    """A front with a strip of lit buttons and a bar, over a door that bears the signs of plates, a glass and drops."""
    w, d, h = b.w, b.d, b.h
    face, cell = d / 2 - min(0.05, d * 0.12), b.cells[0]
    t = min(0.03, w * 0.06)
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + t), (0, h), b.mat(), "case")
    b.box((-w / 2, cell.x0), (-d / 2, face), (0, h), b.mat(), "case")
    b.box((cell.x1, w / 2), (-d / 2, face), (0, h), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d / 2, face), (0, cell.z), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d / 2, face), (cell.top, h), b.mat(), "case")
    b.box(
        (-w * 0.48, w * 0.48),
        (face - 0.02, face + 0.002),
        (0, min(0.09, h * 0.1)),
        "plastic_black",
        "plinth",
        solid=False,
    )
    front = (face + 0.004, d / 2 - min(0.03, d * 0.06))
    panel = ((-w / 2 + 0.005, w / 2 - 0.005), front, (min(0.1, h * 0.12), cell.top - 0.01))
    with b.door(*panel, "bottom"):
        b.box(*panel, b.mat(), "door", solid=False)
        b.box(
            (-w * 0.4, w * 0.4),
            (front[1], d / 2),
            (cell.top - 0.06, cell.top - 0.045),
            "metal_chrome",
            "handle",
            solid=False,
        )
        sign = DrawnFace.front(b, front[1])
        for k in range(3):
            sign.disc(w * (-0.2 + 0.14 * k), h * 0.45, h * 0.13, "plastic_white", "plates", 0.004 + 0.002 * k, 24)
            sign.disc(w * (-0.2 + 0.14 * k), h * 0.45, h * 0.08, "plastic_8fb6d9", "plates", 0.005 + 0.002 * k, 20)
        for k in range(4):
            u, v = w * (-0.3 + 0.2 * k), h * (0.64 - 0.03 * (k % 2))
            sign.disc(u, v, h * 0.02, "plastic_3f8fe0", "drops", 0.006, 12)
            sign.line([(u, v), (u, v + h * 0.045)], h * 0.008, "plastic_3f8fe0", "drops", 0.004)
        sign.field((-w * 0.34, w * 0.34), (h * 0.28, h * 0.3), "metal_dark", "rack", 0.006)
        for k in range(9):
            u = w * (-0.32 + 0.08 * k)
            sign.line([(u, h * 0.29), (u, h * 0.38)], h * 0.007, "metal_dark", "rack", 0.014)
    strip = DrawnFace.front(b, face)
    strip.field((-w * 0.48, w * 0.48), (cell.top + 0.005, h * 0.98), "plastic_black", "strip", front[1] - face)
    strip.field((w * 0.1, w * 0.4), (h * 0.885, h * 0.955), "light_4fd0f0", "strip", front[1] - face + 0.004)
    for k in range(4):
        strip.disc(w * (-0.4 + 0.1 * k), h * 0.92, h * 0.018, "metal_chrome", "strip", front[1] - face + 0.006)


@recipe("slatted_blind")
def slatted_blind(b: Builder) -> None:
    """Tilted slats below a head box, on ladders of cord, with a wand and a pull cord."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.84, h), "plastic_light", "box")
    count = 7
    for k in range(count):
        z = h * 0.78 * (k + 0.3) / count
        slat = [(-d * 0.4, z + h * 0.1), (-d * 0.34, z + h * 0.112), (d * 0.44, z + h * 0.012), (d * 0.38, z)]
        b.prism(slat, (-w * 0.48, w * 0.48), b.mat(), part="slats")
    for x in (-w * 0.36, 0.0, w * 0.36):
        b.rod((x, d * 0.42, 0), (x, d * 0.42, h * 0.86), 0.003, "fabric_grey", "cords", 5)
    b.rod((-w * 0.43, d * 0.46, h * 0.0), (-w * 0.43, d * 0.46, h * 0.88), 0.005, "plastic_grey", "wand", 6)
    b.ball((w * 0.44, d * 0.46, h * 0.08), (0.009, 0.009, h * 0.07), "plastic_grey", "pull", 8)
    b.rod((w * 0.44, d * 0.46, h * 0.12), (w * 0.44, d * 0.46, h * 0.86), 0.003, "fabric_grey", "pull", 5)


@recipe("teapot")
def teapot(b: Builder) -> None:
    """A round pot with a lid and its knob, a bent spout at one side, an ear at the other, and blue flowers."""
    w, d, h = b.w, b.d, b.h
    r = min(w * 0.3, d * 0.48)
    high = h * 0.74
    b.ball((0, 0, high * 0.52), (r, min(r, d / 2), high * 0.5), b.mat(), "pot", 22)
    b.lathe([(r * 0.6, 0), (r * 0.56, high * 0.1)], b.mat(), part="foot", n=22)
    b.lathe([(r * 0.56, high * 0.94), (r * 0.4, high * 1.08), (r * 0.14, high * 1.14)], b.mat(), part="lid", n=22)
    b.lathe([(r * 0.6, high * 0.92), (r * 0.6, high * 0.97)], "metal_brass", part="lid", n=22)
    b.ball((0, 0, h * 0.93), (r * 0.14, r * 0.14, h * 0.07), "metal_brass", "lid", 10)
    points = [
        (-r * 0.8, high * 0.34),
        (-r * 1.25, high * 0.5),
        (-r * 1.36, high * 0.8),
        (-w / 2 + r * 0.1, high * 0.98),
    ]
    for k, ((x0, z0), (x1, z1)) in enumerate(itertools.pairwise(points)):
        b.rod((x0, 0, z0), (x1, 0, z1), r * (0.2 - 0.05 * k), b.mat(), "spout", 12)
        b.ball((x1, 0, z1), (r * (0.19 - 0.05 * k), r * (0.19 - 0.05 * k), r * (0.19 - 0.05 * k)), b.mat(), "spout", 10)
    ear = [
        (r * 0.86 + math.sin(a) * (w / 2 - r * 0.95), 0.0, high * (0.55 + 0.32 * math.cos(a)))
        for a in (k * math.pi / 8 for k in range(9))
    ]
    b.path(ear, r * 0.1, b.mat(), "ear")
    color = "paint_3d6ac8" if "blue" not in b.mat() else "plastic_white"
    for k in range(5):
        a = math.radians(50 + 20 * k)
        at = (math.cos(a) * r * 0.98, math.sin(a) * min(r, d / 2) * 0.98, high * (0.5 + 0.1 * (k % 2)))
        for j in range(5):
            t = j * math.tau / 5
            b.ball(
                (at[0] + math.cos(t) * r * 0.09 * abs(math.sin(a)), at[1], at[2] + math.sin(t) * r * 0.09),
                (r * 0.055, r * 0.04, r * 0.055),
                color,
                "flowers",
                6,
            )
        b.ball(at, (r * 0.04, r * 0.05, r * 0.04), "paint_yellow", "flowers", 6)


@recipe("labelled_jar")
def labelled_jar(b: Builder) -> None:
    """A jar of glass with a lid and a label: SUGAR in white cubes, or JAM, red."""
    w, d, h = b.w, b.d, b.h
    jam = b.p.get("content") == "jam"
    body = h * 0.78
    b.lathe(
        [(0.42, 0.0), (0.46, h * 0.04), (0.46, body * 0.86), (0.36, body)],
        "food_c8203a" if jam else "food_f7f3ea",
        stretch=(w, d),
        part="content",
        n=22,
    )
    b.lathe(
        [(0.46, 0.0), (0.5, h * 0.04), (0.5, body * 0.88), (0.4, body)],
        "glass_clear",
        stretch=(w, d),
        part="glass",
        n=22,
    )
    if jam:
        b.lathe(
            [(0.54, body * 0.94), (0.46, h * 0.86), (0.44, h * 0.97), (0.3, h)],
            "fabric_red",
            stretch=(w, d),
            part="cloth",
            n=18,
        )
        for k in range(9):
            a = k * math.tau / 9
            b.rod(
                (math.cos(a) * w * 0.5, math.sin(a) * d * 0.5, body * 0.97),
                (math.cos(a) * w * 0.36, math.sin(a) * d * 0.36, h * 0.985),
                w * 0.025,
                "fabric_white",
                "checks",
                5,
            )
        b.lathe([(0.475, h * 0.84), (0.475, h * 0.87)], "fabric_beige", stretch=(w, d), part="string", n=18)
    else:
        b.lathe(
            [(0.44, body), (0.46, h * 0.82), (0.46, h * 0.9), (0.12, h * 0.92), (0.14, h), (0.1, h)],
            "wood_oak",
            stretch=(w, d),
            part="lid",
            n=20,
        )
    word = "JAM" if jam else "SUGAR"
    for face, half in ((DrawnFace.front(b, d * 0.49), w * 0.34), (DrawnFace.side(b, w * 0.49), d * 0.34)):
        face.field((-half, half), (body * 0.2, body * 0.78), "paper_f7f0dc", "label", w * 0.02)
        face.write(
            word,
            (-half * 0.9, half * 0.9),
            (body * (0.5 if jam else 0.36), body * (0.74 if jam else 0.6)),
            "paper_red" if jam else "paper_2f5fa8",
            "letters",
            w * 0.03,
        )
        if jam:
            face.disc(0, body * 0.35, half * 0.26, "paper_d8281e", "fruit", w * 0.03, 12)
            face.field((-half * 0.2, half * 0.2), (body * 0.42, body * 0.46), "paper_green", "fruit", w * 0.034)
    if not jam:
        for k in range(7):
            a, z = k * 0.9, body * (0.84 + 0.03 * (k % 2))
            s = w * 0.07
            x, y = math.cos(a) * w * 0.26, math.sin(a) * d * 0.26
            b.box((x - s, x + s), (y - s, y + s), (z - s, z + s), "plastic_white", "cubes", solid=False)


@recipe("toothbrush_cup")
def toothbrush_cup(b: Builder) -> None:
    """A cup with two brushes whose heads bear white bristles, and a tube of paste."""
    w, d, h = b.w, b.d, b.h
    rim = h * 0.5
    b.lathe([(0.4, 0), (0.48, rim), (0.42, rim), (0.36, 0.01)], b.mat(), stretch=(w, d), part="cup", n=20)
    for foot, head, color in (
        ((-0.1, 0.1), (-0.42, 0.2), "plastic_d83a4f"),
        ((0.12, 0.0), (0.1, 0.3), "plastic_2f7fe0"),
    ):
        x0, y0, x1, y1 = w * foot[0], d * foot[1], w * head[0], d * head[1]
        b.path(
            [(x0, y0, h * 0.04), (x0 + (x1 - x0) * 0.76, y0 + (y1 - y0) * 0.76, h * 0.76), (x1, y1, h)],
            w * 0.055,
            color,
            "brushes",
        )
        for k in range(4):
            z, s = h * (0.82 + 0.055 * k), 0.82 + 0.055 * k
            x, y = x0 + (x1 - x0) * s, y0 + (y1 - y0) * s
            b.box(
                (x - w * 0.06, x + w * 0.06),
                (y, y + d * 0.22),
                (z - h * 0.018, z + h * 0.018),
                ("plastic_white", "plastic_8fd0f0")[k % 2],
                "bristles",
                solid=False,
            )
    tube = [(w * 0.08, h * 0.2), (w * 0.3, h * 0.2), (w * 0.5, h * 0.84), (w * 0.24, h * 0.9)]
    b.prism(tube, (-d * 0.22, -d * 0.1), "plastic_white", "y", "tube")
    b.prism(
        [(w * 0.14, h * 0.46), (w * 0.37, h * 0.42), (w * 0.44, h * 0.64), (w * 0.19, h * 0.68)],
        (-d * 0.105, -d * 0.09),
        "paint_red",
        "y",
        "tube",
    )


@recipe("table_ornament")
def table_ornament(b: Builder) -> None:
    """A wooden tray with a candle in a glass, a small vase with twigs, and polished balls."""
    w, d, h = b.w, b.d, b.h
    base = h * 0.12
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, base), b.mat(), "tray", 0.5, 16)
    for side in (-1, 1):
        across, along = sorted((side * w * 0.48, side * w * 0.44)), sorted((side * d * 0.48, side * d * 0.43))
        b.box((across[0], across[1]), (-d * 0.44, d * 0.44), (base * 0.6, base * 1.6), b.mat(), "tray")
        b.box((-w * 0.44, w * 0.44), (along[0], along[1]), (base * 0.6, base * 1.6), b.mat(), "tray")
    b.cyl(w * 0.22, d * 0.04, (base, h * 0.6), w * 0.08, "food_f3ead6", "candle", n=18)
    b.cyl(w * 0.22, d * 0.04, (base, h * 0.8), w * 0.11, "glass_clear", "glass", n=18)
    b.lathe(
        [(w * 0.004, h * 0.6), (w * 0.025, h * 0.72), (w * 0.003, h * 0.92)],
        "light_ffb02f",
        (w * 0.22, d * 0.04),
        "flame",
        10,
    )
    b.lathe(
        [(w * 0.05, base), (w * 0.1, base + h * 0.2), (w * 0.035, h * 0.52), (w * 0.05, h * 0.58)],
        "ceramic_4f7f9f",
        (-w * 0.2, -d * 0.12),
        "vase",
        18,
    )
    for k in range(5):
        a = k * 1.3
        tip = (-w * 0.2 + math.cos(a) * w * 0.1, -d * 0.12 + math.sin(a) * d * 0.12, h * (0.88 + 0.03 * k))
        b.rod((-w * 0.2, -d * 0.12, h * 0.5), tip, w * 0.008, "wood_brown", "twigs", 5)
        b.ball(tip, (w * 0.022, w * 0.022, w * 0.022), "fabric_white", "twigs", 8)
    for x, y, color in ((-0.04, 0.22, "metal_brass"), (-0.24, 0.2, "stone_white"), (0.02, -0.04, "wood_walnut")):
        r = min(w, d) * 0.09
        b.ball((w * x, d * y, base + r), (r, r, r), color, "balls", 14)


@recipe("hazard_cabinet")
def hazard_cabinet(b: Builder) -> None:
    """A cabinet with a flame in a diamond and DANGER on its doors, and a triangle of warning at its side."""
    cabinet(b)
    w, d, h = b.w, b.d, b.h
    rows = int(b.p["rows"])
    plinth = min(0.08, h * 0.1)
    tall = (h - plinth) / rows
    y, z = d / 2 - 0.006, plinth + (rows - 1.5) * tall
    r = min(w * 0.3, tall * 0.42)
    with b.fixed_to(f"door_{rows - 1}"):
        b.prism([(-r, z), (0, z - r), (r, z), (0, z + r)], (y, y + 0.004), "plastic_white", "y", "sign")
        b.prism(
            [(-r * 0.9, z), (0, z - r * 0.9), (r * 0.9, z), (0, z + r * 0.9)], (y, y + 0.006), "paint_red", "y", "sign"
        )
        flame = [
            (-r * 0.3, z - r * 0.34),
            (r * 0.3, z - r * 0.34),
            (r * 0.36, z - r * 0.04),
            (r * 0.06, z + r * 0.5),
            (-r * 0.34, z),
        ]
        b.prism(flame, (y, y + 0.009), "plastic_black", "y", "sign")
    low = plinth + (rows - 3) * tall
    with b.fixed_to(f"door_{rows - 2}"):
        face = DrawnFace.front(b, y)
        face.field((-w * 0.4, w * 0.4), (low + tall * 0.3, low + tall * 0.74), "plastic_black", "band", 0.004)
        face.write(
            "DANGER", (-w * 0.37, w * 0.37), (low + tall * 0.36, low + tall * 0.68), "paint_yellow", "letters", 0.006
        )
    side = DrawnFace.side(b, w / 2)
    b.prism(
        [(-d * 0.24, h * 0.56), (d * 0.24, h * 0.56), (0, h * 0.56 + d * 0.42)],
        (w / 2, w / 2 + 0.004),
        "plastic_black",
        part="warning",
    )
    side.field((-d * 0.02, d * 0.02), (h * 0.56 + d * 0.13, h * 0.56 + d * 0.28), "paint_yellow", "warning", 0.008)
    side.field((-d * 0.02, d * 0.02), (h * 0.56 + d * 0.05, h * 0.56 + d * 0.09), "paint_yellow", "warning", 0.008)


@recipe("basket_stack")
def basket_stack(b: Builder) -> None:
    """Shopping baskets within each other: rims one above the other, pierced walls, and two handles over the topmost."""
    w, d, h = b.w, b.d, b.h
    count = max(4, round(h / 0.11))
    rim = h * 0.86
    step = (rim - 0.2) / count
    for k in range(count):
        z = 0.2 + step * (k + 1)
        b.box((-w * 0.44, w * 0.44), (-d * 0.42, d * 0.42), (z - step if k else 0.0, z - step * 0.3), b.mat(), "walls")
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - step * 0.42, z - step * 0.12), b.mat(), "rims")
    b.box(
        (-w * 0.42, w * 0.42),
        (-d * 0.4, d * 0.4),
        (rim - step * 0.12, rim - step * 0.1),
        "plastic_black",
        "inside",
        solid=False,
    )
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * w * 0.43)), sorted((side * d / 2, side * d * 0.42))
        b.box((across[0], across[1]), (-d / 2, d / 2), (rim - step * 0.5, rim), b.mat(), "rims")
        b.box((-w / 2, w / 2), (along[0], along[1]), (rim - step * 0.5, rim), b.mat(), "rims")
    face, wall = DrawnFace.front(b, d * 0.42), DrawnFace.side(b, w * 0.44)
    for row in range(3):
        v = 0.03 + 0.055 * row
        for k in range(7):
            u = -w * 0.39 + w * 0.115 * k
            face.field((u, u + w * 0.07), (v, v + 0.03), "plastic_black", "holes", 0.003)
            u = -d * 0.37 + d * 0.11 * k
            wall.field((u, u + d * 0.065), (v, v + 0.03), "plastic_black", "holes", 0.003)
    for y in (-d * 0.2, d * 0.2):
        b.path(
            [(-w * 0.45, y, rim), (-w * 0.38, y * 0.4, h - 0.012), (w * 0.38, y * 0.4, h - 0.012), (w * 0.45, y, rim)],
            0.012,
            "plastic_black",
            "handles",
        )
