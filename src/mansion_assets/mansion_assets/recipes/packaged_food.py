"""Food and drink in its packing."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("tea_box")
def tea_box(b: Builder) -> None:
    """An open box of tea bags in their sleeves, one of which hangs over its front on a string with its tag."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.6
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, low), b.mat(), "box")
    b.prism([(-d / 2, low), (-d / 2 + 0.002, low), (-d * 0.5, h), (-d * 0.54, h)], (-w / 2, w / 2), b.mat(), part="lid")
    for k in range(9):
        x = -w * 0.44 + w * 0.1 * k
        b.box(
            (x, x + w * 0.07),
            (-d * 0.4, d * 0.36),
            (low - 0.002, low + h * (0.16 + 0.03 * (k % 3))),
            ("paper_beige", "paper_yellow")[k % 2],
            "bags",
            solid=False,
        )
    face = DrawnFace.front(b, d / 2)
    face.write("TEA", (-w * 0.46, w * 0.06), (h * 0.12, h * 0.5), "paper_white", "letters", 0.001)
    face.line([(w * 0.28, low), (w * 0.3, h * 0.4), (w * 0.28, h * 0.3)], 0.0012, "paper_white", "string", 0.001)
    face.field((w * 0.18, w * 0.4), (h * 0.06, h * 0.3), "paper_yellow", "tag", 0.002)
    lid = DrawnFace.front(b, -d * 0.5 + 0.002)
    lid.disc(-w * 0.05, (low + h) / 2 + h * 0.06, h * 0.08, "leaf_green", "leaf", 0.002)
    lid.disc(w * 0.08, (low + h) / 2 + h * 0.08, h * 0.06, "leaf_green", "leaf", 0.002)


@recipe("coffee_bag")
def coffee_bag(b: Builder) -> None:
    """A foil bag that is folded at its top, with a label, beans on it and a valve; beans lie at its foot."""
    w, d, h = b.w, b.d, b.h
    front = d * 0.36
    b.prism(
        [
            (-d * 0.4, 0),
            (front, 0),
            (front, h * 0.74),
            (0.004, h * 0.92),
            (0.004, h),
            (-0.004, h),
            (-0.004, h * 0.92),
            (-d * 0.4, h * 0.74),
        ],
        (-w / 2, w / 2),
        b.mat(),
        part="bag",
    )
    b.box((-w * 0.52, w * 0.52), (-0.006, 0.008), (h * 0.93, h), "metal_brass", "clip", solid=False)
    face = DrawnFace.front(b, front)
    face.field((-w * 0.42, w * 0.42), (h * 0.14, h * 0.66), "paper_beige", "label", 0.001)
    face.write("COFFEE", (-w * 0.4, w * 0.4), (h * 0.46, h * 0.62), "paper_5a2f16", "letters", 0.002)
    for u, v, tilt in ((-0.18, 0.32, 0.5), (0.14, 0.3, -0.5), (-0.02, 0.21, 0.2)):
        x, z = -w * u, h * v
        b.ball((x, front + 0.002, z), (w * 0.15, 0.004, w * 0.1), "food_4a2c17", "beans", 10)
        face.line(
            [(w * u - w * 0.12, z - tilt * w * 0.05), (w * u + w * 0.12, z + tilt * w * 0.05)],
            w * 0.014,
            "food_2a170b",
            "beans",
            0.006,
        )
    for k in range(5):
        x = w * (-0.4 + 0.2 * k)
        b.ball(
            (x, d * (0.43 + 0.03 * (k % 2)), h * 0.02), (w * 0.09, w * 0.06, h * 0.02), "food_4a2c17", "loose_beans", 8
        )


@recipe("cereal_box")
def cereal_box(b: Builder) -> None:
    """A tall flat box with a bowl of flakes and milk on its front, a spoon, and the word CEREAL."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.985), b.mat(), "box")
    b.box((-w * 0.5, w * 0.5), (-0.002, d * 0.3), (h * 0.985, h), b.mat(), "flap")
    face = DrawnFace.front(b, d / 2)
    face.field((-w * 0.47, w * 0.47), (h * 0.74, h * 0.95), "paper_red", "band", 0.001)
    face.write("CEREAL", (-w * 0.44, w * 0.44), (h * 0.77, h * 0.92), "paper_white", "letters", 0.002)
    bowl = [
        (math.cos(a) * w * 0.36, h * 0.34 + math.sin(a) * w * 0.32)
        for a in (math.pi + k * math.pi / 10 for k in range(11))
    ]
    b.prism(bowl, (d / 2, d / 2 + 0.003), "paper_2f6fc0", "y", "bowl")
    face.field((-w * 0.37, w * 0.37), (h * 0.33, h * 0.4), "paper_white", "milk", 0.003)
    for k in range(11):
        u, v = w * (-0.32 + 0.064 * k), h * (0.42 + 0.035 * ((k * 3) % 4))
        face.disc(
            u, v, w * 0.055, ("food_e0a02f", "food_f0c04a", "food_c8791f")[k % 3], "flakes", 0.004 + 0.001 * (k % 2), 10
        )
    face.line([(w * 0.2, h * 0.42), (w * 0.42, h * 0.68)], w * 0.03, "metal_chrome", "spoon", 0.003)
    side = DrawnFace.side(b, w / 2)
    side.field((-d * 0.36, d * 0.36), (h * 0.1, h * 0.7), "paper_white", "facts", 0.001)
    for k in range(8):
        side.field((-d * 0.3, d * 0.3), (h * (0.14 + 0.065 * k), h * (0.16 + 0.065 * k)), "paper_dark", "facts", 0.002)


@recipe("canned_food")
def canned_food(b: Builder) -> None:
    """A tin with ribs and rims, a ring to open it by, and a label with tomatoes."""
    w, d, h = b.w, b.d, b.h
    for z0, z1, share, color in (
        (0.0, 0.04, 0.5, b.mat()),
        (0.04, 0.16, 0.47, b.mat()),
        (0.16, 0.84, 0.48, "paper_red"),
        (0.84, 0.95, 0.47, b.mat()),
        (0.95, 0.985, 0.5, b.mat()),
    ):
        b.lathe([(share, z0 * h), (share, z1 * h)], color, stretch=(w, d), part="tin", n=28)
    b.lathe([(0.44, h * 0.985), (0.44, h * 0.988)], "metal_light", stretch=(w, d), part="lid", n=28)
    b.lathe([(0.482, h * 0.62), (0.482, h * 0.8)], "paper_beige", stretch=(w, d), part="label", n=28)
    ring = [
        (math.cos(k * math.pi / 5) * w * 0.13, d * 0.16 + math.sin(k * math.pi / 5) * d * 0.16, h * 0.995)
        for k in range(11)
    ]
    b.path(ring, w * 0.02, "metal_chrome", "ring")
    b.box((-w * 0.03, w * 0.03), (-d * 0.06, d * 0.02), (h * 0.985, h), "metal_chrome", "ring")
    for x, y in ((0.0, 0.48), (0.34, 0.34), (-0.34, 0.34), (0.48, 0.0)):
        b.ball((w * x, d * y, h * 0.4), (w * 0.12, d * 0.12, h * 0.13), "food_e8442c", "tomatoes", 10)
        b.ball((w * x * 1.04, d * y * 1.04, h * 0.53), (w * 0.06, d * 0.06, h * 0.025), "leaf_green", "tomatoes", 6)


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


@recipe("yogurt")
def yogurt(b: Builder) -> None:
    """A tapered pot with a band of fruit on it; its foil lid is turned up, and a spoon stands in it."""
    w, d, h = b.w, b.d, b.h
    pot = h * 0.7
    b.lathe([(0.34, 0), (0.44, pot * 0.96), (0.5, pot), (0.44, pot), (0.4, pot * 0.7)], b.mat(), n=24, stretch=(w, d))
    b.lathe([(0.375, pot * 0.25), (0.425, pot * 0.7)], "food_d8477a", n=24, stretch=(w, d), part="label", solid=False)
    b.lathe([(0.43, pot * 0.8), (0.43, pot * 0.92)], "food_f9d9e4", n=24, stretch=(w, d), part="yogurt", solid=False)
    for a in (0.9, 1.5, 0.2):
        b.ball(
            (0.41 * w * math.cos(a), 0.41 * d * math.sin(a), pot * 0.45),
            (w * 0.07, d * 0.07, h * 0.08),
            "food_red",
            "fruit",
            8,
            solid=False,
        )
    b.prism(
        [(-d * 0.44, pot), (-d * 0.3, h * 0.98), (-d * 0.28, h * 0.98), (-d * 0.4, pot)],
        (-w * 0.4, w * 0.4),
        "metal_light",
        part="lid",
    )
    b.rod((0, 0, pot * 0.8), (w * 0.24, d * 0.06, h), w * 0.035, "metal_chrome", "spoon")


@recipe("popcorn_bucket")
def popcorn_bucket(b: Builder) -> None:
    """A cup in red and white stripes, wider at the top, heaped with popcorn."""
    w, d, h = b.w, b.d, b.h
    top, foot, rim = h * 0.76, 0.36, 0.49
    b.lathe([(foot, 0), (rim, top), (rim * 0.92, top), (foot * 0.9, top * 0.5)], b.mat(), n=24, stretch=(w, d))
    for k in range(8):
        a = k * math.pi / 4
        x, y = w * math.cos(a), d * math.sin(a)
        b.rod(
            (x * (foot - 0.04), y * (foot - 0.04), 0),
            (x * (rim - 0.04), y * (rim - 0.04), top),
            w * 0.072,
            "paper_white",
            "stripes",
        )
    for k in range(30):
        ring = 0.0 if k == 0 else 0.18 if k < 7 else 0.33 if k < 17 else 0.42
        a, r = k * 2.4, w * (0.08 + 0.012 * (k % 3))
        z = h - r - (h - top) * (ring / 0.42) ** 1.5
        color = ("food_f4e7b8", "food_f9f3dc", "food_edd58a")[k % 3]
        b.ball((ring * w * math.cos(a), ring * d * math.sin(a), z), (r, r, r), color, "popcorn", 6, solid=False)


@recipe("lunch_box")
def lunch_box(b: Builder) -> None:
    """An open box of compartments with a sandwich, grapes and carrots in it, its lid up behind."""
    w, d, h = b.w, b.d, b.h
    low, t = h * 0.62, 0.006
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, t), b.mat(), "floor")
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * (w / 2 - t))), sorted((side * d / 2, side * (d / 2 - t)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (0, low), b.mat(), "walls")
        b.box((-w / 2, w / 2), (along[0], along[1]), (0, low), b.mat(), "walls")
    b.box((-0.003, 0.003), (-d / 2, d / 2), (0, low * 0.9), b.mat(), "walls")
    b.box((-w / 2, 0), (-0.003, 0.003), (0, low * 0.9), b.mat(), "walls")
    b.prism(
        [(-d / 2, low), (-d / 2 + t, low), (-d * 0.56, h * 1.5), (-d * 0.6, h * 1.5)],
        (-w / 2, w / 2),
        b.mat(),
        part="lid",
    )
    for k, color in enumerate(("food_e8c68a", "food_6fbf4a", "food_d9443a", "food_f0c04a", "food_e8c68a")):
        z = low * (0.35 + 0.17 * k)
        b.prism(
            [(w * 0.04, -d * 0.4), (w * 0.45, -d * 0.4), (w * 0.04, d * 0.42)],
            (z, z + low * 0.17),
            color,
            "z",
            "sandwich",
        )
    for i in range(4):
        for j in range(3):
            b.ball(
                (-w * (0.08 + 0.11 * i), -d * (0.12 + 0.13 * j), low * (0.7 + 0.2 * ((i + j) % 2))),
                (w * 0.055, w * 0.055, w * 0.055),
                "food_6a3f8f",
                "grapes",
                8,
            )
    for k in range(5):
        x = -w * (0.07 + 0.09 * k)
        b.rod((x, d * 0.06, low * 0.85), (x, d * 0.44, low * 0.85), w * 0.04, "food_e8792f", "carrots", 8)
