"""Small things of laboratories and wards: dishes, burners, beakers, syringes, pills and bandages."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("petri_dish")
def petri_dish(b: Builder) -> None:
    """A shallow dish of agar with colonies, its lid aside and leaning on the rim."""
    h = b.h
    b.lathe([(0.46, 0), (0.5, h * 0.1), (0.5, h), (0.46, h), (0.46, h * 0.3)], "glass_white", n=32, stretch=(b.w, b.d))
    b.lathe([(0.46, h * 0.2), (0.46, h * 0.6)], "food_c8605a", n=32, stretch=(b.w, b.d), part="agar", solid=False)
    colonies = ((-0.2, 0.1, 0.07), (0.1, 0.22, 0.05), (0.24, -0.06, 0.08), (-0.06, -0.22, 0.06), (0.02, 0.02, 0.04))
    for x, y, r in (*colonies, (-0.3, -0.14, 0.04), (0.14, -0.3, 0.03), (-0.12, 0.32, 0.04), (0.34, 0.14, 0.03)):
        b.cyl(x * b.w, y * b.d, (h * 0.6, h * 0.75), r * b.w, "food_f1e6b0", "colonies", solid=False)


@recipe("bunsen_burner")
def bunsen_burner(b: Builder) -> None:
    """A tube with a collar on a round foot, a gas hose behind, and a blue flame."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.5, 0), (0.5, h * 0.05), (0.16, h * 0.12)], "metal_dark", n=24, stretch=(w, d), part="foot")
    b.cyl(0, 0, (h * 0.1, h * 0.62), w * 0.085, b.mat(), "tube")
    b.cyl(0, 0, (h * 0.18, h * 0.28), w * 0.13, "metal_steel", "collar")
    b.rod((0, 0, h * 0.13), (-w * 0.26, 0, h * 0.13), w * 0.04, b.mat(), "inlet")
    b.path(
        [(-w * 0.24, 0, h * 0.13), (-w * 0.36, 0, h * 0.12), (-w * 0.46, 0, h * 0.03)], w * 0.055, "rubber_red", "hose"
    )
    b.lathe(
        [(0.05, h * 0.62), (0.12, h * 0.72), (0.08, h * 0.86), (0.0, h)],
        "light_4f9bf0",
        n=12,
        stretch=(w, d),
        part="flame",
    )
    b.lathe([(0.02, h * 0.62), (0.13, h * 0.7), (0.03, h * 0.78)], "light_1d5fd0", n=12, stretch=(w, d), part="flame")


@recipe("beaker")
def beaker(b: Builder) -> None:
    """A straight glass with a rim and a scale, half full."""
    w, d, h = b.w, b.d, b.h
    b.lathe(
        [(0.44, 0), (0.46, h * 0.03), (0.46, h * 0.94), (0.5, h), (0.46, h), (0.43, h * 0.05)],
        b.mat(),
        n=24,
        stretch=(w, d),
    )
    b.lathe([(0.43, h * 0.03), (0.43, h * 0.5)], "plastic_3f9fd0", n=24, stretch=(w, d), part="liquid", solid=False)
    for side in (-1, 1):
        for k in range(5):
            z, wide = h * (0.2 + 0.14 * k), w * (0.12 if k % 2 else 0.2)
            b.box(
                (-wide, wide),
                (side * d * 0.47 - 0.001, side * d * 0.47 + 0.001),
                (z, z + h * 0.02),
                "plastic_white",
                "scale",
                solid=False,
            )
    b.lathe([(0.46, h * 0.95), (0.5, h), (0.46, h)], "glass_white", n=24, stretch=(w, d), part="rim", solid=False)


@recipe("syringe")
def syringe(b: Builder) -> None:
    """A barrel with a coloured liquid, a plunger that is drawn out behind, finger flanges, and a needle in front."""
    w, d, h = b.w, b.d, b.h
    z, r = h / 2, w * 0.3
    b.rod((0, -d * 0.2, z), (0, d * 0.24, z), r, b.mat(), "barrel", 12, solid=True)
    b.rod((0, -d * 0.04, z), (0, d * 0.18, z), r * 1.05, "plastic_3f9fd0", "liquid", 12)
    b.box((-w / 2, w / 2), (-d * 0.22, -d * 0.19), (z - r, z + r), b.mat(), "flange")
    b.rod((0, -d * 0.48, z), (0, -d * 0.2, z), r * 0.4, "plastic_grey", "plunger")
    b.rod((0, -d / 2, z), (0, -d * 0.47, z), h / 2, "plastic_grey", "thumb", 14)
    b.rod((0, d * 0.24, z), (0, d * 0.3, z), r * 0.5, "plastic_orange", "hub")
    b.rod((0, d * 0.3, z), (0, d / 2, z), r * 0.14, "metal_steel", "needle", 6)


@recipe("clinical_thermometer")
def clinical_thermometer(b: Builder) -> None:
    """A flat white rod with a scale, a red column and a red bulb."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d * 0.38), (0, h), b.mat(), "rod", 0.6)
    b.ball((0, d * 0.41, h / 2), (w * 0.34, d * 0.09, h * 0.46), "plastic_red", "bulb")
    b.box((-w * 0.09, w * 0.09), (-d * 0.2, d * 0.36), (h - 0.0005, h + 0.0004), "plastic_red", "column", solid=False)
    for k in range(9):
        y = -d * 0.4 + k * d * 0.08
        b.box((w * 0.14, w * 0.4), (y, y + d * 0.012), (h - 0.0005, h + 0.0003), "plastic_black", "scale", solid=False)


@recipe("pill_bottle")
def pill_bottle(b: Builder) -> None:
    """An orange bottle with a white, ribbed cap and a printed label."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.42, 0), (0.44, h * 0.03), (0.44, h * 0.68), (0.4, h * 0.74)], b.mat(), n=24, stretch=(w, d))
    b.lathe([(0.452, h * 0.16), (0.452, h * 0.58)], "paper_white", n=24, stretch=(w, d), part="label", solid=False)
    for z0, z1, color in (
        (0.5, 0.55, "paper_blue"),
        (0.4, 0.43, "paper_dark"),
        (0.32, 0.35, "paper_dark"),
        (0.24, 0.27, "paper_dark"),
    ):
        b.lathe([(0.456, h * z0), (0.456, h * z1)], color, n=24, stretch=(w, d), part="print", solid=False)
    b.lathe([(0.48, h * 0.74), (0.48, h * 0.97), (0.44, h)], "plastic_white", n=24, stretch=(w, d), part="cap")
    for k in range(24):
        a = k * math.pi / 12
        b.cyl(
            0.48 * w * math.cos(a),
            0.48 * d * math.sin(a),
            (h * 0.75, h * 0.96),
            w * 0.02,
            "plastic_light",
            "ribs",
            n=4,
            solid=False,
        )


@recipe("medicine_box")
def medicine_box(b: Builder) -> None:
    """A folding box with a green cross, and a blister of red tablets that leans against it."""
    w, d, h = b.w, b.d, b.h
    front = d * 0.2
    b.box((-w / 2, w / 2), (-d / 2, front), (0, h), b.mat(), "box")
    b.box((-w / 2, w / 2), (front - 0.001, front + 0.0005), (h * 0.84, h), "paper_green", "stripe", solid=False)
    x, z, arm = w * 0.3, h * 0.46, h * 0.24
    for half in ((arm, arm / 3), (arm / 3, arm)):
        b.box(
            (x - half[0], x + half[0]),
            (front, front + 0.0008),
            (z - half[1], z + half[1]),
            "paint_2f9a4a",
            "cross",
            solid=False,
        )
    for half in ((arm * 0.8, arm * 0.26), (arm * 0.26, arm * 0.8)):
        b.box(
            (-half[0], half[0]),
            (-d * 0.15 - half[1] * 0.5, -d * 0.15 + half[1] * 0.5),
            (h, h + 0.0006),
            "paint_2f9a4a",
            "cross",
            solid=False,
        )
    left, right, lean = -w * 0.46, w * 0.08, d * 0.14
    sheet = [(d / 2 - lean * 0.2, 0), (d / 2, 0), (front + lean * 0.4, h * 0.8), (front + lean * 0.2, h * 0.8)]
    b.prism(sheet, (left, right), "metal_light", part="blister")
    for row in range(2):
        for column in range(4):
            share = 0.28 + 0.46 * row
            y = d / 2 + (front + lean * 0.4 - d / 2) * share
            b.ball(
                (left + (column + 0.5) * (right - left) / 4, y, h * 0.8 * share),
                (w * 0.045, d * 0.06, h * 0.1),
                "plastic_red",
                "tablets",
                8,
                solid=False,
            )


@recipe("bandage")
def bandage(b: Builder) -> None:
    """A roll of gauze that lies on its side, with its end unrolled to the front and two clips."""
    w, d, h = b.w, b.d, b.h
    r, x = h / 2, (-w * 0.34, w * 0.34)
    y = -d / 2 + r
    b.rod((x[0], y, r), (x[1], y, r), r, b.mat(), "roll", 24, solid=True)
    for share, color in (
        (0.78, "fabric_light"),
        (0.66, b.mat()),
        (0.54, "fabric_light"),
        (0.42, b.mat()),
        (0.3, "fabric_grey"),
    ):
        b.rod((x[0] - (1 - share) * 0.003, y, r), (x[1] + (1 - share) * 0.003, y, r), r * share, color, "turns", 20)
    b.box(x, (y, d / 2), (0, h * 0.05), b.mat(), "end")
    for side in (-1, 1):
        b.box(
            (side * w * 0.18 - w * 0.05, side * w * 0.18 + w * 0.05),
            (d * 0.32, d * 0.46),
            (h * 0.05, h * 0.09),
            "metal_steel",
            "clips",
            solid=False,
        )
    for half in ((w * 0.2, r * 0.22), (w * 0.07, r * 0.62)):
        b.box((-half[0], half[0]), (y - half[1], y + half[1]), (h * 0.97, h), "fabric_red", "cross", solid=False)
