"""Small things in the hand: sacks, napkins, spatulas, pouches, cartons, jars and bottles with their labels."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("rubbish_sack")
def rubbish_sack(b: Builder) -> None:
    """A full black sack with bulges and creases, tied below two floppy ears with a yellow ribbon."""
    w, d, h = b.w, b.d, b.h
    skin = "plastic_2f3136" if b.mat() == "plastic_black" else b.mat()
    b.ball((0, 0, h * 0.34), (w * 0.46, d * 0.46, h * 0.34), skin, "sack", 18)
    for k in range(9):
        a, z = k * 2.4, h * (0.16 + 0.05 * (k % 5))
        b.ball((math.cos(a) * w * 0.28, math.sin(a) * d * 0.28, z), (w * 0.21, d * 0.21, h * 0.16), skin, "bulges", 10)
    b.lathe([(0.3, h * 0.55), (0.08, h * 0.76), (0.06, h * 0.8)], skin, stretch=(w, d), part="neck", n=12)
    for k in range(10):
        a = k * math.tau / 10
        b.rod(
            (math.cos(a) * w * 0.36, math.sin(a) * d * 0.36, h * 0.5),
            (math.cos(a) * w * 0.06, math.sin(a) * d * 0.06, h * 0.78),
            w * 0.014,
            "plastic_dark",
            "creases",
            5,
        )
    b.lathe([(0.075, h * 0.77), (0.075, h * 0.81)], "paint_yellow", stretch=(w, d), part="ribbon", n=12)
    b.path(
        [(w * 0.06, d * 0.04, h * 0.79), (w * 0.16, d * 0.14, h * 0.7), (w * 0.14, d * 0.2, h * 0.6)],
        w * 0.016,
        "paint_yellow",
        "ribbon",
    )
    for side in (-1, 1):
        ear = [
            (side * w * 0.01, h * 0.8),
            (side * w * 0.06, h * 0.8),
            (side * w * 0.26, h * 0.96),
            (side * w * 0.18, h),
            (side * w * 0.08, h * 0.96),
        ]
        b.prism(ear, (-d * 0.04, d * 0.04), skin, "y", "ears")


@recipe("napkin_holder")
def napkin_holder(b: Builder) -> None:
    """Two looped sides of wire on a foot, and between them a pack of white napkins folded to triangles."""
    w, d, h = b.w, b.d, b.h
    b.box((-w * 0.4, w * 0.4), (-d / 2, d / 2), (0, h * 0.06), b.mat(), "foot")
    for side in (-1, 1):
        y = side * (d / 2 - 0.004)
        loop = [
            (math.cos(a) * w * 0.38, y, h * 0.06 + max(0.0, math.sin(a)) * h * 0.62)
            for a in (k * math.pi / 12 for k in range(13))
        ]
        b.path(loop, h * 0.03, b.mat(), "sides")
        inner = [
            (math.cos(a) * w * 0.2, y, h * 0.06 + math.sin(a) * h * 0.36) for a in (k * math.pi / 8 for k in range(9))
        ]
        b.path(inner, h * 0.022, b.mat(), "sides")
    count = 9
    for k in range(count):
        y = -d * 0.38 + d * 0.76 * k / count
        lean = w * 0.02 * ((k * 2) % 3 - 1)
        b.prism(
            [(-w / 2, h * 0.06), (w / 2, h * 0.06), (lean, h)],
            (y, y + d * 0.06),
            ("paper_white", "paper_f2ece0")[k % 2],
            "y",
            "napkins",
        )


@recipe("spatula")
def spatula(b: Builder) -> None:
    """A turner: a flat blade with three slots, bent up to a long handle with a hole at its end."""
    w, d, h = b.w, b.d, b.h
    start, t = d * 0.16, h * 0.2
    for k in range(4):
        x = -w / 2 + w * k / 3.45
        b.box((x, x + w * 0.13), (start + d * 0.03, d * 0.44), (0, t), b.mat(), "blade")
    b.box((-w / 2, w / 2), (d * 0.42, d / 2), (0, t), b.mat(), "blade")
    b.prism(
        [
            (-w / 2, start + d * 0.04),
            (w / 2, start + d * 0.04),
            (w * 0.2, start - d * 0.03),
            (-w * 0.2, start - d * 0.03),
        ],
        (0, t * 1.2),
        b.mat(),
        "z",
        "blade",
    )
    b.path(
        [(0, start, t * 0.6), (0, start - d * 0.1, h * 0.8), (0, -d * 0.1, h * 0.86)], w * 0.07, "metal_steel", "neck"
    )
    b.cushion(
        (-w * 0.14, w * 0.14),
        (-d * 0.46, -d * 0.08),
        (h * 0.6, h),
        "plastic_red" if "black" in b.mat() else "plastic_black",
        "handle",
        0.8,
        12,
    )
    b.path(
        [
            (0, -d * 0.45, h * 0.8),
            (w * 0.1, -d * 0.48, h * 0.8),
            (0, -d / 2, h * 0.8),
            (-w * 0.1, -d * 0.48, h * 0.8),
            (0, -d * 0.45, h * 0.8),
        ],
        w * 0.03,
        "metal_steel",
        "ring",
    )


@recipe("make_up_pouch")
def make_up_pouch(b: Builder) -> None:
    """An open pouch with a zip, out of which a lipstick, a brush and a mascara stand; a compact before it."""
    w, d, h = b.w, b.d, b.h
    low, front = h * 0.56, d * 0.16
    b.prism([(-d * 0.36, 0), (front, 0), (d * 0.1, low), (-d * 0.3, low)], (-w / 2, w / 2), b.mat(), part="pouch")
    b.box(
        (-w * 0.46, w * 0.46),
        (-d * 0.2, d * 0.02),
        (low - 0.001, low + h * 0.01),
        "plastic_black",
        "opening",
        solid=False,
    )
    for y in (-d * 0.28, d * 0.08):
        b.box((-w / 2, w / 2), (y - d * 0.02, y + d * 0.02), (low, low + h * 0.03), "metal_brass", "zip", solid=False)
    b.box((w * 0.46, w * 0.56), (d * 0.04, d * 0.12), (low - h * 0.06, low), "metal_brass", "zip", solid=False)
    y = -d * 0.1
    b.cyl(-w * 0.3, y, (low * 0.6, h * 0.78), w * 0.05, "metal_brass", "lipstick", n=14)
    b.lathe(
        [(w * 0.038, h * 0.78), (w * 0.038, h * 0.9), (w * 0.01, h * 0.97)],
        "paint_d6284f",
        (-w * 0.3, y),
        "lipstick",
        14,
    )
    b.rod((0, y, low * 0.6), (-w * 0.02, y, h * 0.82), w * 0.022, "wood_walnut", "brush", 8)
    b.rod((-w * 0.02, y, h * 0.8), (-w * 0.022, y, h * 0.87), w * 0.03, "metal_brass", "brush", 10)
    b.lathe([(w * 0.028, h * 0.86), (w * 0.06, h * 0.94), (w * 0.03, h)], "fabric_e8b8a0", (-w * 0.022, y), "brush", 12)
    b.cyl(w * 0.16, y, (low * 0.6, h * 0.9), w * 0.03, "plastic_black", "mascara", n=12)
    b.cyl(w * 0.16, y, (h * 0.74, h * 0.77), w * 0.032, "metal_brass", "mascara", n=12)
    b.cyl(w * 0.3, y, (low * 0.6, h * 0.76), w * 0.05, "plastic_pink", "polish", n=12)
    b.cyl(w * 0.3, y, (h * 0.76, h * 0.92), w * 0.025, "plastic_black", "polish", n=10)
    b.cyl(w * 0.14, d * 0.36, (0, h * 0.1), w * 0.11, "plastic_black", "compact", n=20)
    b.cyl(w * 0.14, d * 0.36, (h * 0.1, h * 0.11), w * 0.09, "food_e8b8a0", "compact", n=20)
    face = DrawnFace.sloped(b, (front, 0.0), (d * 0.1, low))
    for k in range(5):
        face.disc(
            w * (-0.36 + 0.18 * k),
            low * (0.3 + 0.34 * (k % 2)),
            w * 0.04,
            "fabric_f5d6dc" if "red" in b.mat() else "fabric_d6758f",
            "dots",
            0.0015,
            14,
        )


@recipe("hand_gel")
def hand_gel(b: Builder) -> None:
    """A clear bottle of blue gel under a pump, with a green cross and GEL on its label."""
    w, d, h = b.w, b.d, b.h
    body = h * 0.66
    b.lathe(
        [(0.46, 0), (0.5, h * 0.04), (0.5, body * 0.88), (0.2, body)],
        "plastic_8fd0ea",
        stretch=(w, d),
        part="gel",
        n=22,
    )
    b.cyl(0, 0, (body, h * 0.76), w * 0.24, "plastic_white", "collar", n=18)
    b.cyl(0, 0, (h * 0.76, h * 0.92), w * 0.07, "plastic_white", "stem", n=10)
    b.box((-w * 0.16, w * 0.16), (-d * 0.18, d * 0.2), (h * 0.91, h), "plastic_white", "pump")
    b.path(
        [(0, d * 0.16, h * 0.95), (0, d * 0.46, h * 0.94), (0, d * 0.5, h * 0.9)], w * 0.06, "plastic_white", "spout"
    )
    for face, half in ((DrawnFace.front(b, d * 0.48), w * 0.3), (DrawnFace.side(b, w * 0.48), d * 0.3)):
        face.field((-half, half), (body * 0.12, body * 0.8), "paper_white", "label", w * 0.03)
        face.field((-half * 0.22, half * 0.22), (body * 0.42, body * 0.76), "paint_green", "cross", w * 0.04)
        face.field((-half * 0.6, half * 0.6), (body * 0.53, body * 0.65), "paint_green", "cross", w * 0.04)
        face.write("GEL", (-half * 0.8, half * 0.8), (body * 0.16, body * 0.36), "paint_2f5fa8", "letters", w * 0.04)


@recipe("drink_carton")
def drink_carton(b: Builder) -> None:
    """A carton with a folded gable and a screw cap: MILK with a splash and a cow's spots."""
    w, d, h = b.w, b.d, b.h
    high, juice = h * 0.78, b.p.get("content") == "juice"
    ground, band = ("paper_f28c28", "paper_green") if juice else ("paper_white", b.mat())
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, high), ground, "body")
    gable = [(-d / 2, high), (d / 2, high), (0.003, h * 0.94), (0.003, h), (-0.003, h), (-0.003, h * 0.94)]
    b.prism(gable, (-w / 2, w / 2), band, part="gable")
    y, z = d * 0.26, high + (h * 0.94 - high) * 0.5
    b.rod((0, y, z), (0, y + d * 0.12, z + h * 0.05), w * 0.14, "plastic_white" if juice else "plastic_red", "cap", 16)
    word = "JUICE" if juice else "MILK"
    for face, half in ((DrawnFace.front(b, d / 2), w / 2), (DrawnFace.side(b, w / 2), d / 2)):
        face.field((-half, half), (0.0, high * 0.16), band, "band", 0.0006)
        face.write(
            word,
            (-half * 0.86, half * 0.86),
            (high * 0.66, high * 0.92),
            "paper_white" if juice else "paper_2f5fa8",
            "letters",
            0.001,
        )
        if juice:
            face.disc(0, high * 0.4, half * 0.62, "paper_f2a93b", "fruit", 0.001, 20)
            face.disc(0, high * 0.4, half * 0.54, "paper_fbe7c6", "fruit", 0.0014, 20)
            for k in range(6):
                a = k * math.pi / 3
                face.disc(
                    math.cos(a) * half * 0.3,
                    high * 0.4 + math.sin(a) * half * 0.3,
                    half * 0.15,
                    "paper_f59a35",
                    "fruit",
                    0.0018,
                    10,
                )
        else:
            for u, v, r in ((-0.4, 0.44, 0.34), (0.36, 0.3, 0.28), (0.5, 0.54, 0.2), (-0.1, 0.26, 0.16)):
                face.disc(half * u, high * v, half * r, "paper_black", "spots", 0.001, 12)
