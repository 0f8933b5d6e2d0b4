"""Food that is ready to eat: bread, cake, cheese, sandwiches."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("loaf")
def loaf(b: Builder) -> None:
    """A loaf with a golden crust and cuts on its top; two slices that are cut off it show the pale crumb."""
    w, d, h = b.w, b.d, b.h
    arch = [(-0.44, 0.0), (0.44, 0.0), (0.47, 0.3), (0.44, 0.46), (0.5, 0.62), (0.46, 0.82), (0.3, 0.96), (0.0, 1.0)]
    arch += [(-x, z) for x, z in arch[6:1:-1]]
    outline = [(x * w, z * h) for x, z in arch]
    crumb = [(x * w * 0.88, h * 0.05 + z * h * 0.88) for x, z in arch]

    def piece(back: float, front: float) -> None:
        """Bake a piece of the loaf between two places along it."""
        b.prism(outline, (back, front), "food_b9742c", "y", "crust")
        b.prism(crumb, (front, front + d * 0.006), "food_f3dfb4", "y", "crumb")

    piece(-d / 2, d * 0.2)
    piece(d * 0.25, d * 0.32)
    piece(d * 0.38, d * 0.46)
    for k in range(4):
        y = -d * (0.42 - 0.14 * k)
        b.rod((-w * 0.22, y, h * 0.975), (w * 0.22, y + d * 0.05, h * 0.975), h * 0.035, "food_e8c68a", "cuts", 6)


@recipe("butter")
def butter(b: Builder) -> None:
    """A pat of butter on a white dish, a slice cut off in front of it, and the paper still about its other end."""
    w, d, h = b.w, b.d, b.h
    plate = h * 0.16
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, plate), "ceramic_white", "dish", 0.5)
    b.box((-w * 0.36, w * 0.22), (-d * 0.26, d * 0.26), (plate, h * 0.98), "food_f2d96b", "butter")
    b.box((-w * 0.38, -w * 0.06), (-d * 0.28, d * 0.28), (plate, h), "metal_light", "foil")
    b.box((-w * 0.385, -w * 0.18), (-d * 0.285, d * 0.285), (plate, h * 1.005), "paper_3a7bc8", "paper")
    b.prism(
        [(w * 0.24, plate), (w * 0.31, plate), (w * 0.4, h * 0.62), (w * 0.34, h * 0.66)],
        (-d * 0.26, d * 0.26),
        "food_f2d96b",
        "y",
        "slice",
    )
    b.box((w * 0.06, w * 0.065), (d * 0.26, d * 0.262), (plate, h * 0.98), "food_c9a93a", "cuts", solid=False)


@recipe("cheese")
def cheese(b: Builder) -> None:
    """A wedge of yellow cheese with holes in its cut faces and an orange rind behind."""
    w, d, h = b.w, b.d, b.h
    tip, rind = (w * 0.44, d / 2), -w * 0.44
    wedge = [(-w * 0.44, -d / 2), (tip[0], d * 0.46), tip, (-w * 0.44, d / 2)]
    b.prism(wedge, (0, h), "food_f0c94a", "z", "cheese")
    b.prism([(-w / 2, -d * 0.5), (rind, -d / 2), (rind, d / 2), (-w / 2, d * 0.5)], (0, h), "food_d9782d", "z", "rind")
    for u, z, r in (
        (-0.3, 0.3, 0.16),
        (-0.12, 0.66, 0.2),
        (0.1, 0.3, 0.13),
        (-0.36, 0.8, 0.09),
        (0.02, 0.84, 0.07),
        (0.24, 0.6, 0.12),
    ):
        b.rod((w * u, d * 0.48, h * z), (w * u, d * 0.503, h * z), h * r, "food_c4952a", "holes", 14)
    for x, y, r in (
        (-0.28, 0.1, 0.1),
        (-0.06, 0.34, 0.08),
        (-0.34, -0.22, 0.07),
        (-0.3, 0.4, 0.05),
        (0.14, 0.42, 0.05),
    ):
        b.cyl(w * x, d * y, (h * 0.97, h * 1.004), w * r, "food_c4952a", "holes", solid=False)


@recipe("sandwich")
def sandwich(b: Builder) -> None:
    """A triangle of two slices of white bread with crusts; ham, cheese, tomato and lettuce stand out between them."""
    w, d, h = b.w, b.d, b.h
    outline = [(-w / 2, -d / 2), (w / 2, -d / 2), (w / 2, d / 2)]
    layers = (
        (0.0, 0.34, "food_f3e3bf", 0.94),
        (0.34, 0.42, "leaf_5fae3f", 1.0),
        (0.42, 0.5, "food_f0c94a", 0.97),
        (0.5, 0.58, "food_red", 0.92),
        (0.58, 0.66, "food_pink", 0.98),
        (0.66, 1.0, "food_f3e3bf", 0.94),
    )
    middle = (w / 6, -d / 6)
    for z0, z1, color, share in layers:
        corners = [(middle[0] + (x - middle[0]) * share, middle[1] + (y - middle[1]) * share) for x, y in outline]
        b.prism(corners, (h * z0, h * z1), color, "z", "layers")
        if share == 0.94:
            b.prism(
                [
                    corners[0],
                    corners[1],
                    (corners[1][0], corners[1][1] - d * 0.02),
                    (corners[0][0], corners[0][1] - d * 0.02),
                ],
                (h * z0, h * z1),
                "food_a9683f",
                "z",
                "crust",
            )
            b.prism(
                [
                    corners[1],
                    corners[2],
                    (corners[2][0] + w * 0.02, corners[2][1]),
                    (corners[1][0] + w * 0.02, corners[1][1]),
                ],
                (h * z0, h * z1),
                "food_a9683f",
                "z",
                "crust",
            )


@recipe("cake")
def cake(b: Builder) -> None:
    """A layer cake with icing that runs over its edge, cherries round the top, and candles that burn."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.62
    b.lathe([(0.5, 0), (0.5, h * 0.04)], "ceramic_white", n=28, stretch=(w, d), part="plate")
    for z0, z1, color in ((0.04, 0.24, b.mat()), (0.24, 0.3, "food_f7efe0"), (0.3, 0.5, b.mat())):
        b.lathe([(0.44, h * z0), (0.44, h * z1)], color, n=28, stretch=(w, d), part="layers")
    b.lathe([(0.455, h * 0.46), (0.46, top * 0.96), (0.42, top)], "food_f3b6c4", n=28, stretch=(w, d), part="icing")
    for k in range(14):
        a = k * math.pi / 7
        x, y = 0.44 * w * math.cos(a), 0.44 * d * math.sin(a)
        b.ball(
            (x, y, h * (0.44 - 0.04 * (k % 2))), (w * 0.04, d * 0.04, h * 0.12), "food_f3b6c4", "icing", 6, solid=False
        )
        b.ball(
            (x * 0.8, y * 0.8, top + h * 0.04), (w * 0.04, d * 0.04, h * 0.08), "food_red", "cherries", 8, solid=False
        )
    for k in range(5):
        a = 0.3 + k * 2 * math.pi / 5
        x, y = 0.18 * w * math.cos(a), 0.18 * d * math.sin(a)
        b.cyl(x, y, (top, h * 0.9), w * 0.014, ("plastic_3a7bc8", "plastic_white")[k % 2], "candles", n=8, solid=False)
        b.ball((x, y, h * 0.95), (w * 0.016, d * 0.016, h * 0.05), "light_ffb52e", "flames", 6, solid=False)


@recipe("donut_box")
def donut_box(b: Builder) -> None:
    """A flat, open box with six iced rings in two rows."""
    w, d, h = b.w, b.d, b.h
    t = h * 0.1
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, t), b.mat(), "box")
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * (w / 2 - t))), sorted((side * d / 2, side * (d / 2 - t)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (0, h * 0.7), b.mat(), "box")
        b.box((-w / 2, w / 2), (along[0], along[1]), (0, h * 0.7), b.mat(), "box")
    r = min(w / 6, d / 4) * 0.88
    icing = ("food_f08fb4", "food_5a3420", "food_f7efe0", "food_5a3420", "food_f7efe0", "food_f08fb4")
    for k, color in enumerate(icing):
        x, y = (k % 3 - 1) * w * 0.31, (k // 3 - 0.5) * d * 0.46
        for z0, z1, hue in ((t, h * 0.7, "food_c98a4a"), (h * 0.7, h, color)):
            low, high = (0.36, 1.0) if hue == "food_c98a4a" else (0.4, 0.94)
            b.lathe(
                [
                    (r * low, z0),
                    (r * high, z0 + (z1 - z0) * 0.3),
                    (r * high * 0.94, z1 * 0.96),
                    (r * 0.66, z1),
                    (r * 0.36, z1 * 0.97),
                ],
                hue,
                (x, y),
                "rings",
                18,
            )
        b.cyl(x, y, (h * 0.9, h * 0.985), r * 0.34, "food_5a3a24", "holes", n=14, solid=False)
