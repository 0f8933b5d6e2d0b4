"""What goods come in: parcels, cans of paint, tubes, flasks, bottles with their own caps, buckets of popcorn."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("package")
def package(b: Builder) -> None:
    """A carton closed with tape over its top and front, with an address label and a bar code on it."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h), "paper_c39a62", "carton")
    b.box((-w / 2, w / 2), (-d * 0.008, d * 0.008), (h, h + 0.0006), "paper_brown", "seam", solid=False)
    b.box((-w / 2, w / 2), (-d * 0.09, d * 0.09), (h, h + 0.0004), "plastic_e6cf9f", "tape", solid=False)
    for side in (-1, 1):
        ends = sorted((side * w / 2, side * (w / 2 + 0.0006)))
        b.box((ends[0], ends[1]), (-d * 0.09, d * 0.09), (h * 0.6, h), "plastic_e6cf9f", "tape", solid=False)
    b.box((-w * 0.38, w * 0.1), (d / 2, d / 2 + 0.0006), (h * 0.28, h * 0.84), "paper_white", "label", solid=False)
    for k, high in enumerate((0.74, 0.66, 0.58)):
        b.box(
            (-w * 0.34, -w * 0.04 * (k + 1)),
            (d / 2, d / 2 + 0.001),
            (h * high, h * (high + 0.03)),
            "plastic_black",
            "address",
            solid=False,
        )
    for k in range(9):
        x = -w * 0.34 + k * w * 0.044
        b.box(
            (x, x + w * (0.01 + 0.012 * (k % 2))),
            (d / 2, d / 2 + 0.001),
            (h * 0.33, h * 0.5),
            "plastic_black",
            "bar_code",
            solid=False,
        )


@recipe("paint_can")
def paint_can(b: Builder) -> None:
    """An open tin of paint with a wire handle, paint that runs down its side, and a label."""
    w, d, h = b.w, b.d, b.h
    can, color = h * 0.8, "paint_3a7bc8"
    b.lathe([(0.46, 0), (0.46, can * 0.96), (0.48, can), (0.42, can), (0.4, can * 0.9)], b.mat(), n=28, stretch=(w, d))
    b.lathe([(0.41, can * 0.8), (0.41, can * 0.96)], color, n=28, stretch=(w, d), part="paint", solid=False)
    b.lathe([(0.468, can * 0.15), (0.468, can * 0.72)], "paper_white", n=28, stretch=(w, d), part="label", solid=False)
    b.lathe([(0.472, can * 0.3), (0.472, can * 0.5)], color, n=28, stretch=(w, d), part="label", solid=False)
    for a, low in ((1.2, 0.5), (1.5, 0.2), (1.75, 0.62), (0.95, 0.72)):
        x, y = 0.47 * w * math.cos(a), 0.47 * d * math.sin(a)
        b.rod((x, y, can * low), (x, y, can * 0.99), w * 0.035, color, "drips")
    turns = [
        (-math.cos(k * math.pi / 10) * w * 0.48, 0.0, can * 0.84 + math.sin(k * math.pi / 10) * (h - can * 0.84))
        for k in range(11)
    ]
    b.path(turns, w * 0.018, "metal_dark", "handle")


@recipe("bail_bucket")
def bail_bucket(b: Builder) -> None:
    """A tapered bucket with ribs under its rim and a wire handle with a grip, which hangs down in front."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.34, 0), (0.45, h * 0.96), (0.48, h), (0.43, h), (0.32, 0.012)], b.mat(), n=28, stretch=(w, d))
    for z in (0.86, 0.78):
        b.lathe(
            [(0.44, h * z), (0.47, h * (z + 0.02)), (0.44, h * (z + 0.04))],
            b.mat(),
            n=28,
            stretch=(w, d),
            part="ribs",
            solid=False,
        )
    turns = [k * math.pi / 12 for k in range(13)]
    arc = [(w * 0.5 * math.cos(a), d * 0.52 * math.sin(a), h * (0.9 - 0.45 * math.sin(a))) for a in turns]
    b.path(arc, w * 0.014, "metal_steel", "handle")
    b.path(arc[5:8], w * 0.04, "plastic_white", "grip")
    for side in (-1, 1):
        b.rod((side * w * 0.42, 0, h * 0.9), (side * w * 0.5, 0, h * 0.9), w * 0.04, "metal_steel", "ears", 10)


@recipe("toothpaste")
def toothpaste(b: Builder) -> None:
    """A tube: flat and crimped at one end, round at the shoulder, with a striped front and a ribbed cap."""
    w, d, h = b.w, b.d, b.h
    z, shoulder = h / 2, w * 0.26
    steps = 6
    for k in range(steps):
        x0 = -w * 0.44 + k * (shoulder + w * 0.44) / steps
        x1 = x0 + (shoulder + w * 0.44) / steps
        thick0, thick1 = (h * (0.06 + 0.4 * (j / steps) ** 0.6) for j in (k, k + 1))
        color = ("plastic_white", "plastic_white", "plastic_red", "plastic_white", "plastic_3a7bc8", "plastic_3a7bc8")[
            k
        ]
        outline = [(x0, z - thick0), (x1, z - thick1), (x1, z + thick1), (x0, z + thick0)]
        b.prism(outline, (-d / 2 + d * 0.02 * k, d / 2 - d * 0.02 * k), color, "y", "tube")
    b.box((-w / 2, -w * 0.43), (-d / 2, d / 2), (z - h * 0.07, z + h * 0.07), "plastic_light", "crimp")
    b.rod((shoulder, 0, z), (w * 0.33, 0, z), h * 0.3, "plastic_white", "shoulder", 16)
    b.rod((w * 0.33, 0, z), (w / 2, 0, z), h / 2, "plastic_white", "cap", 16, solid=True)
    for k in range(10):
        a = k * math.pi / 5
        y, up = h * 0.49 * math.cos(a), z + h * 0.49 * math.sin(a)
        b.rod((w * 0.35, y, up), (w * 0.49, y, up), h * 0.04, "plastic_grey", "ribs", 4)


@recipe("thermos")
def thermos(b: Builder) -> None:
    """A steel flask with a handle at its side, a neck ring, and a black cup over its stopper."""
    w, d, h = b.w, b.d, b.h
    x, r = -w * 0.1, 0.4
    b.lathe([(r * 0.95, 0), (r, h * 0.03), (r, h * 0.64), (r * 0.82, h * 0.72)], b.mat(), (x, 0), n=24, stretch=(w, d))
    for z0, z1 in ((0.0, 0.06), (0.6, 0.63)):
        b.lathe([(r * 1.02, h * z0), (r * 1.02, h * z1)], "plastic_black", (x, 0), "rings", 24, (w, d), solid=False)
    b.lathe(
        [(r * 0.78, h * 0.72), (r * 0.88, h * 0.74), (r * 0.8, h * 0.98), (r * 0.7, h)],
        "plastic_black",
        (x, 0),
        "cup",
        24,
        (w, d),
    )
    grip = [
        (x + r * w * 0.8, 0, h * 0.62),
        (w * 0.46, 0, h * 0.58),
        (w * 0.46, 0, h * 0.26),
        (x + r * w * 0.9, 0, h * 0.2),
    ]
    b.path(grip, w * 0.06, "plastic_black", "handle")


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


@recipe("trigger_bottle")
def trigger_bottle(b: Builder) -> None:
    """A bottle with a sloped shoulder and, on its neck, a spray head with a nozzle and a trigger to the front."""
    w, d, h = b.w, b.d, b.h
    body, neck, y = h * 0.6, h * 0.74, -d * 0.08
    deep = d * 0.42
    b.cushion((-w / 2, w / 2), (y - deep, y + deep), (0, body), b.mat(), "body", 0.25, 12)
    b.box(
        (-w * 0.36, w * 0.36),
        (y + deep - 0.001, y + deep + 0.0008),
        (body * 0.2, body * 0.75),
        "paper_white",
        "label",
        solid=False,
    )
    b.lathe([(0.4, body * 0.96), (0.16, neck)], b.mat(), (0, y), "shoulder", 16, (w, d))
    b.cyl(0, y, (neck, h * 0.8), w * 0.24, "plastic_white", "collar")
    b.prism(
        [
            (y - d * 0.24, h * 0.9),
            (y - d * 0.16, h * 0.8),
            (y + d * 0.2, h * 0.8),
            (d * 0.4, h * 0.9),
            (d * 0.4, h),
            (y - d * 0.18, h),
        ],
        (-w * 0.22, w * 0.22),
        "plastic_red",
        part="head",
    )
    b.rod((0, d * 0.4, h * 0.95), (0, d / 2, h * 0.95), w * 0.14, "plastic_white", "nozzle", 10)
    b.path([(0, d * 0.28, h * 0.88), (0, d * 0.34, h * 0.8), (0, d * 0.24, h * 0.7)], w * 0.1, "plastic_red", "trigger")


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


@recipe("gas_cylinder")
def gas_cylinder(b: Builder) -> None:
    """A tall steel bottle with round shoulders, a valve with a hand wheel and a guard, and a hazard label."""
    w, d, h = b.w, b.d, b.h
    b.lathe(
        [(0.48, 0), (0.5, h * 0.01), (0.5, h * 0.8), (0.44, h * 0.855), (0.3, h * 0.89), (0.14, h * 0.91)],
        b.mat(),
        n=24,
        stretch=(w, d),
    )
    b.lathe(
        [(0.502, h * 0.74), (0.502, h * 0.8), (0.45, h * 0.85)],
        "paint_white",
        n=24,
        stretch=(w, d),
        part="band",
        solid=False,
    )
    b.cyl(0, 0, (h * 0.9, h * 0.96), w * 0.1, "metal_brass", "valve")
    b.rod((0, 0, h * 0.94), (0, d * 0.26, h * 0.94), w * 0.07, "metal_brass", "outlet")
    b.cyl(0, 0, (h * 0.97, h), w * 0.26, "paint_red", "wheel", n=12)
    b.prism(
        [(0, h * 0.5), (w * 0.2, h * 0.54), (0, h * 0.58), (-w * 0.2, h * 0.54)],
        (d * 0.47, d * 0.505),
        "paint_yellow",
        "y",
        "hazard",
        solid=False,
    )
