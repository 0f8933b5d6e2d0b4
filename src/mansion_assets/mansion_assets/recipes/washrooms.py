"""Fittings of washrooms and baths that one knows by their basin, their spout or their sign."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("urinal")
def urinal(b: Builder) -> None:
    """A porcelain shield with raised sides round a hollow, its lip below in front, a drain."""
    w, d, h = b.w, b.d, b.h
    low, high = h * 0.3, h * 0.86
    back, front = -d / 2, d / 2
    b.box((-w * 0.46, w * 0.46), (back, back + d * 0.2), (low + 0.06, high), b.mat(), "back")
    for side in (-1, 1):
        across = sorted((side * w / 2, side * w * 0.34))
        wall = [
            (back, low),
            (d * 0.16, low),
            (front, low + 0.14),
            (d * 0.34, low + 0.3),
            (back + d * 0.4, high),
            (back, high),
        ]
        b.prism(wall, (across[0], across[1]), b.mat(), part="sides")
    b.prism(
        [
            (back, low),
            (d * 0.16, low),
            (front, low + 0.14),
            (front, low + 0.2),
            (d * 0.34, low + 0.2),
            (d * 0.1, low + 0.06),
            (back, low + 0.06),
        ],
        (-w * 0.34, w * 0.34),
        b.mat(),
        part="bowl",
    )
    b.prism(
        [(back, high), (back + d * 0.4, high), (back + d * 0.3, high + 0.05), (back, high + 0.05)],
        (-w / 2, w / 2),
        b.mat(),
        part="head",
    )
    b.box(
        (-w * 0.34, w * 0.34),
        (back + d * 0.2, back + d * 0.22),
        (low + 0.1, high),
        "ceramic_dfe6ea",
        "hollow",
        solid=False,
    )
    b.cyl(0, d * 0.1, (low + 0.06, low + 0.075), 0.045, "metal_chrome", "drain", n=16)
    b.cyl(0, d * 0.1, (low + 0.075, low + 0.1), 0.03, "plastic_4f9bd9", "tablet", n=14)
    b.path(
        [(0, back + 0.07, high + 0.04), (0, back + 0.07, h - 0.03), (0, back + 0.02, h - 0.03)],
        0.016,
        "metal_chrome",
        "valve",
    )
    b.rod((0, back + 0.07, h - 0.08), (0, back + 0.13, h - 0.08), 0.035, "metal_chrome", "valve", 16)
    b.box((-0.05, 0.05), (back, back + 0.07), (0.0, low + 0.02), "metal_chrome", "trap")
    b.rod((0, back + 0.09, low - 0.1), (0, back + 0.09, low + 0.02), 0.04, "metal_chrome", "trap", 14)


@recipe("liquid_soap")
def liquid_soap(b: Builder) -> None:
    """A case with a window on pink soap, a wide lever to press, a nozzle, and a drop that falls from it."""
    w, d, h = b.w, b.d, b.h
    low, front = h * 0.3, d * 0.28
    b.cushion((-w / 2, w / 2), (-d / 2, front), (low, h), b.mat(), "case", 0.3, 14)
    face = DrawnFace.front(b, front)
    face.field((-w * 0.24, w * 0.24), (h * 0.56, h * 0.9), "plastic_dark", "window", d * 0.02)
    face.field((-w * 0.2, w * 0.2), (h * 0.58, h * 0.78), "plastic_f08fb0", "soap", d * 0.035)
    face.field((-w * 0.2, w * 0.2), (h * 0.78, h * 0.88), "plastic_dff0f5", "soap", d * 0.03)
    b.prism(
        [
            (front - d * 0.1, low),
            (front, low),
            (d / 2, low + h * 0.05),
            (front + d * 0.04, h * 0.5),
            (front - d * 0.1, h * 0.5),
        ],
        (-w * 0.4, w * 0.4),
        "metal_chrome",
        part="lever",
    )
    DrawnFace.front(b, d * 0.42).write(
        "SOAP", (-w * 0.32, w * 0.32), (h * 0.35, h * 0.46), "plastic_black", "letters", d * 0.04
    )
    b.cyl(0, d * 0.06, (h * 0.2, low + 0.005), w * 0.09, "plastic_black", "nozzle", n=12)
    b.lathe(
        [(w * 0.02, h * 0.15), (w * 0.09, h * 0.06), (w * 0.05, 0.0)][::-1], "plastic_f08fb0", (0, d * 0.06), "drop", 12
    )


@recipe("soap_bar")
def soap_bar(b: Builder) -> None:
    """A rounded bar with SOAP pressed into it, on a ribbed dish, with foam about it."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.3), "ceramic_4f9bd9", "dish", 0.6, 14)
    b.cushion((-w * 0.44, w * 0.44), (-d * 0.42, d * 0.42), (h * 0.24, h * 0.92), "plastic_f5e3c8", "bar", 0.6, 16)
    long = w > d
    face = DrawnFace.top(b, h * 0.92) if long else DrawnFace(b, (0.0, 0.0, h * 0.92), (0.0, 1.0, 0.0), (-1.0, 0.0, 0.0))
    a, c = (w, d) if long else (d, w)
    face.write("SOAP", (-a * 0.28, a * 0.28), (-c * 0.16, c * 0.16), "plastic_b98d5c", "letters", h * 0.03)
    for k in range(9):
        u, v = w * (-0.4 + 0.1 * k), d * (0.36 - 0.12 * ((k * 5) % 3))
        r = min(w, d) * (0.06 + 0.03 * (k % 3))
        b.ball((u, v, h * 0.8 if k % 2 else h * 0.44), (r, r, r), "plastic_white", "foam", 8)


@recipe("hot_tub")
def hot_tub(b: Builder) -> None:
    """A tub with a wooden skirt, blue water that bubbles, head rests at its rim, a row of buttons."""
    w, d, h = b.w, b.d, b.h
    front, rim = d / 2 - 0.3, 0.24
    middle, depth = (front - d / 2) / 2, front + d / 2
    b.box((-w / 2 + 0.04, w / 2 - 0.04), (-d / 2 + 0.04, front - 0.04), (0, h * 0.6), "wood_walnut", "skirt")
    for k in range(11):
        x = -w / 2 + 0.06 + (w - 0.12) * k / 10
        b.box((x - 0.012, x + 0.012), (front - 0.04, front - 0.03), (0.02, h * 0.8), "wood_brown", "slats", solid=False)
        y = -d / 2 + 0.06 + (depth - 0.12) * k / 10
        b.box((w / 2 - 0.04, w / 2 - 0.03), (y - 0.012, y + 0.012), (0.02, h * 0.8), "wood_brown", "slats", solid=False)
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - rim)))
        along = sorted((middle + side * depth / 2, middle + side * (depth / 2 - rim)))
        b.cushion((across[0], across[1]), (-d / 2, front), (h * 0.6, h), b.mat(), "rim", 0.5)
        b.cushion((-w / 2, w / 2), (along[0], along[1]), (h * 0.6, h), b.mat(), "rim", 0.5)
        b.cushion(
            (side * w * 0.22 - 0.16, side * w * 0.22 + 0.16),
            (-d / 2 + 0.02, -d / 2 + 0.2),
            (h * 0.96, h * 1.06),
            "leather_dark",
            "rests",
            0.8,
        )
    b.box((-w / 2 + rim, w / 2 - rim), (-d / 2 + rim, front - rim), (h * 0.6, h * 0.9), "plastic_4fb3e0", "water")
    for k in range(26):
        x, y = (
            (w - 2 * rim - 0.2) * (((k * 0.618) % 1.0) - 0.5),
            middle + (depth - 2 * rim - 0.2) * (((k * 0.382 + 0.1 * (k % 3)) % 1.0) - 0.5),
        )
        r = 0.045 + 0.02 * (k % 3)
        b.ball((x, y, h * 0.9), (r, r, r * 0.8), ("plastic_white", "plastic_dff2fb")[k % 2], "bubbles", 8)
    for k in range(4):
        b.cyl(
            w / 2 - rim / 2,
            middle - 0.15 + 0.1 * k,
            (h * 0.985, h * 1.01),
            0.03,
            ("plastic_red", "plastic_blue", "metal_chrome", "metal_chrome")[k],
            "buttons",
            n=12,
        )
    for k in range(2):
        b.box((-0.45, 0.45), (front - 0.05, d / 2 - 0.15 * k), (0, h * (0.26 + 0.26 * k)), "wood_walnut", "steps")


@recipe("person_scale")
def person_scale(b: Builder) -> None:
    """A flat plate with two marks for feet and a lit figure of kilograms."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.3, h * 0.94), b.mat(), "plate", 0.4, 12)
    for side in (-1, 1):
        for end in (-1, 1):
            b.cyl(side * w * 0.38, end * d * 0.38, (0, h * 0.4), w * 0.06, "rubber_black", "feet", n=12)
    face = DrawnFace.top(b, h * 0.94)
    dark = "glass" in b.mat()
    ink = "plastic_light" if dark else "plastic_dark"
    for side in (-1, 1):
        u = side * w * 0.2
        face.disc(u, -d * 0.1, w * 0.1, ink, "feet_marks", h * 0.03)
        face.disc(u, d * 0.06, w * 0.12, ink, "feet_marks", h * 0.03)
        face.disc(u, -d * 0.28, w * 0.085, ink, "feet_marks", h * 0.03)
        for k in range(5):
            face.disc(
                u + w * (-0.1 + 0.05 * k),
                d * (0.2 + 0.015 * (2 - abs(k - 2))),
                w * 0.024,
                ink,
                "feet_marks",
                h * 0.03,
                8,
            )
    face.field((-w * 0.2, w * 0.2), (d * 0.28, d * 0.46), "plastic_101820", "display", h * 0.04)
    face.write("72:5", (-w * 0.17, w * 0.17), (d * 0.31, d * 0.43), "light_4fd0f0", "figures", h * 0.06)


@recipe("changing_shelf")
def changing_shelf(b: Builder) -> None:
    """A shelf folded down from the wall with a hollow bed, a strap, a baby on it, and the sign of one behind it."""
    w, d, h = b.w, b.d, b.h
    back = -d / 2
    b.cushion((-w / 2, w / 2), (back, back + 0.1), (0, h), b.mat(), "back", 0.3)
    b.box((-w * 0.47, w * 0.47), (back + 0.1, d / 2), (0, 0.05), b.mat(), "bed")
    for x in ((-w * 0.47, -w * 0.41), (w * 0.41, w * 0.47)):
        b.box(x, (back + 0.1, d / 2), (0.05, 0.1), b.mat(), "rims")
    b.box((-w * 0.47, w * 0.47), (d / 2 - 0.05, d / 2), (0.05, 0.09), b.mat(), "rims")
    b.box((-w * 0.41, w * 0.41), (back + 0.1, d / 2 - 0.05), (0.05, 0.062), "fabric_8fc1d9", "pad", solid=False)
    y, z = d * 0.12, 0.062
    b.ball((w * 0.26, y, z + 0.055), (0.065, 0.06, 0.055), "fabric_f0cfae", "baby", 12)
    b.cushion((-w * 0.08, w * 0.19), (y - 0.07, y + 0.07), (z, z + 0.1), "fabric_f2e08f", "baby", 0.9)
    for side in (-1, 1):
        b.rod(
            (-w * 0.06, y + side * 0.04, z + 0.04),
            (-w * 0.2, y + side * 0.09, z + 0.04),
            0.028,
            "fabric_f0cfae",
            "baby",
            8,
        )
        b.rod(
            (w * 0.14, y + side * 0.06, z + 0.05),
            (w * 0.18, y + side * 0.14, z + 0.05),
            0.02,
            "fabric_f0cfae",
            "baby",
            8,
        )
    b.box((w * 0.02, w * 0.08), (back + 0.1, d / 2 - 0.05), (z + 0.085, z + 0.108), "fabric_dark", "strap", solid=False)
    face = DrawnFace.front(b, back + 0.1)
    face.disc(-w * 0.24, h * 0.74, h * 0.09, "plastic_2f5fa8", "sign", 0.006)
    face.field((-w * 0.13, w * 0.14), (h * 0.66, h * 0.8), "plastic_2f5fa8", "sign", 0.006)
    face.line([(w * 0.14, h * 0.72), (w * 0.26, h * 0.84)], 0.02, "plastic_2f5fa8", "sign")
    face.line([(w * 0.14, h * 0.7), (w * 0.28, h * 0.7)], 0.02, "plastic_2f5fa8", "sign")


@recipe("hair_wash_chair")
def hair_wash_chair(b: Builder) -> None:
    """A chair that leans back, and behind it a white basin with a neck rest, a tap and a hand shower on a pillar."""
    w, d, h = b.w, b.d, b.h
    seat, main = 0.44, b.mat()
    b.cushion((-w * 0.4, w * 0.4), (-d * 0.02, d * 0.36), (seat - 0.14, seat), main, "seat", 0.4)
    b.prism(
        [(-d * 0.02, seat - 0.1), (d * 0.06, seat), (-d * 0.14, h * 0.82), (-d * 0.2, h * 0.8)],
        (-w * 0.38, w * 0.38),
        main,
        part="back",
    )
    b.prism(
        [(d * 0.34, seat - 0.12), (d * 0.36, seat), (d / 2, seat * 0.42), (d * 0.46, seat * 0.36)],
        (-w * 0.34, w * 0.34),
        main,
        part="leg_rest",
    )
    b.box((-w * 0.34, w * 0.34), (-d * 0.02, d * 0.3), (0, seat - 0.12), "plastic_dark", "base")
    for side in (-1, 1):
        across = sorted((side * w / 2, side * w * 0.38))
        b.cushion((across[0], across[1]), (-d * 0.06, d * 0.28), (seat + 0.1, seat + 0.17), main, "arms", 0.5)
        b.box(
            (side * w * 0.44 - 0.02, side * w * 0.44 + 0.02),
            (d * 0.0, d * 0.2),
            (seat - 0.1, seat + 0.1),
            "metal_chrome",
            "arms",
        )
    y = -d * 0.32
    b.box((-w * 0.2, w * 0.2), (-d * 0.44, y + 0.06), (0, h * 0.62), "ceramic_white", "pillar")
    rim = h * 0.92
    b.lathe(
        [(0.14, h * 0.6), (0.3, h * 0.76), (0.32, rim), (0.28, rim), (0.22, h * 0.74), (0.05, h * 0.68)],
        "ceramic_white",
        (0, y),
        "basin",
        24,
        (w * 1.3, d * 0.54),
    )
    b.cyl(0, y, (h * 0.7, h * 0.72), 0.04, "metal_dark", "drain", n=12)
    b.cushion((-0.13, 0.13), (-d * 0.2, -d * 0.12), (rim - 0.07, rim + 0.02), "rubber_black", "neck_rest", 0.8)
    b.path([(0, -d * 0.47, h * 0.86), (0, -d * 0.47, h), (0, -d * 0.38, h)], 0.02, "metal_chrome", "tap")
    b.path(
        [(w * 0.16, -d * 0.46, h * 0.88), (w * 0.2, -d * 0.46, h * 0.99), (w * 0.12, -d * 0.34, h * 0.99)],
        0.016,
        "metal_chrome",
        "shower",
    )
    b.rod((w * 0.12, -d * 0.34, h * 0.99), (w * 0.12, -d * 0.32, h * 0.94), 0.04, "metal_chrome", "shower", 14)
