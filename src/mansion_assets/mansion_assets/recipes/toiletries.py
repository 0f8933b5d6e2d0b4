"""Toiletries: soap, shampoo, toothpaste, perfume, brushes."""

import itertools
import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


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


@recipe("shampoo")
def shampoo(b: Builder) -> None:
    """A flat, rounded bottle with a label and drawn bubbles, and a wide flip cap."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d * 0.36, d * 0.36), (0, h * 0.84), b.mat(), "body", 0.7, 14)
    b.lathe([(0.36, h * 0.78), (0.36, h * 0.97), (0.32, h)], "plastic_white", n=20, stretch=(w, d * 0.8), part="cap")
    b.box((-w * 0.1, w * 0.1), (d * 0.2, d * 0.32), (h * 0.94, h * 0.97), "plastic_grey", "cap", solid=False)
    b.box((-w * 0.3, w * 0.3), (d * 0.34, d * 0.375), (h * 0.16, h * 0.6), "paper_white", "label", solid=False)
    for x, z, r in ((-0.12, 0.26, 0.1), (0.12, 0.32, 0.07), (-0.02, 0.42, 0.085), (0.14, 0.48, 0.05)):
        b.rod((w * x, d * 0.37, h * z), (w * x, d * 0.385, h * z), w * r, "plastic_8fc6ea", "bubbles", 14)
    b.box((-w * 0.22, w * 0.22), (d * 0.37, d * 0.385), (h * 0.54, h * 0.57), b.mat(), "label", solid=False)


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


@recipe("toothpaste")
def toothpaste(b: Builder) -> None:
    """A tube, flat and crimped at one end, with TOOTHPASTE between bands of red and blue, and a ribbed cap."""
    w, d, h = b.w, b.d, b.h
    z, shoulder, end = h / 2, w * 0.3, -w * 0.44
    outline = [(end, z - h * 0.06), (shoulder, z - h * 0.46), (shoulder, z + h * 0.46), (end, z + h * 0.06)]
    b.prism(outline, (-d / 2, d / 2), "plastic_white", "y", "tube")
    long = math.hypot(shoulder - end, h * 0.4)
    along = (-(shoulder - end) / long, 0.0, -h * 0.4 / long)
    face = DrawnFace(b, (shoulder, 0.0, z + h * 0.46), along, (0.0, -1.0, 0.0))
    face.field((0.0, long), (-d * 0.5, -d * 0.3), "plastic_d8281e", "bands", h * 0.02)
    face.field((0.0, long), (d * 0.3, d * 0.5), "plastic_2f6fd0", "bands", h * 0.02)
    face.write("TOOTHPASTE", (long * 0.02, long * 0.98), (-d * 0.26, d * 0.26), "plastic_1f3f9e", "letters", h * 0.03)
    side = DrawnFace.front(b, d / 2 - d * 0.01)
    side.field((-shoulder, -shoulder + w * 0.04), (z - h * 0.44, z + h * 0.44), "plastic_2f6fd0", "bands", d * 0.012)
    b.box((-w / 2, end + w * 0.01), (-d / 2, d / 2), (z - h * 0.07, z + h * 0.07), "plastic_b8bec4", "crimp")
    for k in range(7):
        y = d * (-0.42 + 0.14 * k)
        b.box((-w / 2, end), (y - d * 0.02, y + d * 0.02), (z, z + h * 0.09), "plastic_8a9096", "crimp", solid=False)
    b.rod((shoulder, 0, z), (w * 0.36, 0, z), h * 0.3, "plastic_white", "shoulder", 16)
    b.rod((w * 0.36, 0, z), (w / 2, 0, z), h / 2, "plastic_2f6fd0", "cap", 16, solid=True)
    for k in range(10):
        a = k * math.pi / 5
        y, up = h * 0.49 * math.cos(a), z + h * 0.49 * math.sin(a)
        b.rod((w * 0.37, y, up), (w * 0.49, y, up), h * 0.04, "plastic_white", "ribs", 4)


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


@recipe("perfume")
def perfume(b: Builder) -> None:
    """A square flacon of thick glass, half full, with a gold collar and a ball for a stopper."""
    w, d, h = b.w, b.d, b.h
    body = h * 0.6
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, body), "glass_clear", "glass")
    b.box(
        (-w * 0.42, w * 0.42), (-d * 0.42, d * 0.42), (body * 0.1, body * 0.85), "plastic_e0a8b8", "scent", solid=False
    )
    b.box(
        (-w * 0.24, w * 0.24), (d / 2, d / 2 + 0.0005), (body * 0.3, body * 0.65), "metal_brass", "label", solid=False
    )
    b.cyl(0, 0, (body, h * 0.7), w * 0.2, "metal_brass", "collar")
    b.ball((0, 0, h * 0.85), (w * 0.26, d * 0.26, h * 0.15), "metal_brass", "stopper", 16)


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


@recipe("hair_brush")
def hair_brush(b: Builder) -> None:
    """An oval head with a pad of bristles that look up, and a handle that narrows towards the head."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.45
    b.ball((0, d * 0.2, low * 0.5), (w / 2, d * 0.3, low * 0.5), b.mat(), "head", 16)
    b.rod(
        (0, -d * 0.06, low * 0.5),
        (0, -d * 0.46, low * 0.5),
        min(w * 0.16, low * 0.5),
        b.mat(),
        "handle",
        12,
        solid=True,
    )
    b.ball((0, -d * 0.44, low * 0.5), (w * 0.19, d * 0.06, low * 0.5), b.mat(), "handle", 10)
    b.ball((0, d * 0.2, low * 0.66), (w * 0.4, d * 0.25, low * 0.5), "rubber_red", "pad", 16)
    for i in range(5):
        for j in range(8):
            x, y = (i - 2) / 2.6, (j - 3.5) / 4.2
            if x * x + y * y < 0.95:
                b.cyl(
                    x * w * 0.36,
                    d * 0.2 + y * d * 0.23,
                    (low * 0.9, h),
                    w * 0.02,
                    "plastic_black",
                    "bristles",
                    n=4,
                    solid=False,
                )


@recipe("hair_dryer")
def hair_dryer(b: Builder) -> None:
    """A barrel with a grille behind and a flat nozzle, a slanted grip with switches, and a cord with its plug."""
    w, d, h = b.w, b.d, b.h
    main, dark = b.mat(), "plastic_3a3d42"
    r = d * 0.46
    z = h - r
    barrel = [(-w * 0.36, r * 0.9), (-w * 0.3, r), (-w * 0.04, r), (w * 0.2, r * 0.62)]
    for (x0, r0), (x1, r1) in itertools.pairwise(barrel):
        b.taper((x0, 0, z), (x1, 0, z), (r0, r1), main, "body", 20)
    b.rod((w * 0.17, 0, z), (w * 0.23, 0, z), r * 0.66, "plastic_d9a441", "ring", 20)
    for k in range(4):
        x = -w * (0.37 + 0.012 * k)
        b.rod((x, 0, z), (x - w * 0.006, 0, z), r * (0.86 - 0.2 * k), ("plastic_9ba0a5", dark)[k % 2], "grille", 18)
    mouth = [(w * 0.23, -r * 0.5), (w * 0.23, r * 0.5), (w / 2, d / 2), (w / 2, -d / 2)]
    b.prism(mouth, (z - r * 0.3, z + r * 0.3), "plastic_9ba0a5", "z", "nozzle")
    b.box((w / 2 - 0.001, w / 2), (-d * 0.44, d * 0.44), (z - r * 0.16, z + r * 0.16), "plastic_black", "nozzle")
    grip = [(-w * 0.2, z - r * 0.6), (w * 0.0, z - r * 0.6), (-w * 0.1, h * 0.06), (-w * 0.26, h * 0.06)]
    b.prism(grip, (-d * 0.2, d * 0.2), main, "y", "grip")
    for level, color in ((0.44, "plastic_red"), (0.34, "plastic_4f9bd9")):
        across = (-w * (0.17 + 0.1 * (0.44 - level)), -w * (0.08 + 0.1 * (0.44 - level)))
        b.box(across, (d * 0.2, d * 0.25), (h * (level - 0.03), h * (level + 0.03)), color, "switches")
    _cord(b)


def _cord(b: Builder) -> None:
    """A cord from the foot of the grip, in a bow on the table, and its plug."""
    w, d, h = b.w, b.d, b.h
    r = h * 0.018
    bow = [
        (-w * 0.18, 0, h * 0.06),
        (-w * 0.2, 0, r),
        (-w * 0.1, d * 0.36, r),
        (w * 0.1, d * 0.4, r),
        (w * 0.22, d * 0.1, r),
        (w * 0.28, -d * 0.2, r),
        (w * 0.36, -d * 0.06, r),
    ]
    b.path(bow, r, "rubber_black", "cord")
    b.box((w * 0.34, w * 0.43), (-d * 0.16, d * 0.06), (0, h * 0.07), "plastic_white", "plug")
    for y in (-d * 0.11, d * 0.01):
        b.rod((w * 0.43, y, h * 0.035), (w * 0.48, y, h * 0.035), h * 0.01, "metal_brass", "plug", 8)
