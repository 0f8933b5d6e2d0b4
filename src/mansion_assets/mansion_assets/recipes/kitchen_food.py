"""Dishes and what food is kept, cooked and served in: butter, cake, cheese, pots, racks, salad bars, fryers."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


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


@recipe("cooking_pot")
def cooking_pot(b: Builder) -> None:
    """A deep, open pot with an outer base, a rolled rim and two loop handles at its sides."""
    w, d, h = b.w, b.d, b.h
    along_x = w >= d
    rx, ry = stretch = (w * 0.84, d) if along_x else (w, d * 0.84)
    wall = [(0.46, 0), (0.47, h * 0.02), (0.48, h * 0.95), (0.5, h * 0.97), (0.5, h), (0.455, h), (0.45, h * 0.08)]
    b.lathe(wall, b.mat(), n=28, stretch=stretch)
    b.lathe([(0.485, h * 0.02), (0.485, h * 0.12)], "metal_copper", n=28, stretch=stretch, part="base", solid=False)
    for side in (-1, 1):
        loop = ((0.46, -0.16), (0.58, -0.13), (0.58, 0.13), (0.46, 0.16))
        line = [(side * rx * u, ry * v) if along_x else (rx * v, side * ry * u) for u, v in loop]
        b.path([(x, y, h * 0.78) for x, y in line], min(w, d) * 0.03, "plastic_black", "handles")


@recipe("dish_rack")
def dish_rack(b: Builder) -> None:
    """A wire rack on a drip tray, with plates that stand in it one behind the other, and a mug."""
    w, d, h = b.w, b.d, b.h
    wire, rail = h * 0.025, h * 0.4
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.06), "plastic_dark", "tray")
    for z in (h * 0.14, rail):
        corners = [(sx * w * 0.48, sy * d * 0.47, z) for sx, sy in ((-1, -1), (1, -1), (1, 1), (-1, 1), (-1, -1))]
        b.path(corners, wire, b.mat(), "wires")
    for k in range(9):
        x = -w * 0.48 + k * w * 0.12
        b.path(
            [(x, -d * 0.47, rail), (x, -d * 0.47, h * 0.1), (x, d * 0.47, h * 0.1), (x, d * 0.47, rail)],
            wire * 0.8,
            b.mat(),
            "wires",
        )
    r = h * 0.42
    for k in range(6):
        x = -w * 0.42 + k * w * 0.1
        b.rod((x, -d * 0.04, h * 0.12 + r), (x + w * 0.02, -d * 0.04, h * 0.14 + r), r, "ceramic_white", "plates", 24)
        b.rod(
            (x + w * 0.016, -d * 0.04, h * 0.14 + r),
            (x + w * 0.026, -d * 0.04, h * 0.145 + r),
            r * 0.66,
            "ceramic_blue",
            "plates",
            20,
        )
    b.cyl(w * 0.3, d * 0.1, (h * 0.13, h * 0.66), w * 0.09, "ceramic_3a7bc8", "mug", w * 0.075)
    b.path(
        [
            (w * 0.3, d * 0.3, h * 0.26),
            (w * 0.3, d * 0.42, h * 0.32),
            (w * 0.3, d * 0.42, h * 0.5),
            (w * 0.3, d * 0.3, h * 0.54),
        ],
        h * 0.04,
        "ceramic_3a7bc8",
        "mug",
    )


@recipe("salad_bar")
def salad_bar(b: Builder) -> None:
    """A counter with steel pans of food, and a sneeze guard of glass on posts over it."""
    w, d, h = b.w, b.d, b.h
    heap = 0.14
    deck = h - float(b.p.get("depth", h * 0.3))
    b.box((-w * 0.48, w * 0.48), (-d * 0.46, d * 0.46), (0.06, deck - 0.05), "wood_oak", "body")
    b.box((-w * 0.46, w * 0.46), (-d * 0.42, d * 0.42), (0, 0.06), "plastic_dark", "plinth")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (deck - 0.05, deck), b.mat(), "deck")
    b.box((-w / 2, w / 2), (d * 0.47, d / 2), (deck - 0.12, deck - 0.09), b.mat(), "tray_rail")
    foods = (
        "leaf_green",
        "food_red",
        "food_yellow",
        "food_orange",
        "leaf_green",
        "food_beige",
        "food_purple",
        "food_green",
    )
    columns = 4
    for k, color in enumerate(foods):
        x0 = -w * 0.46 + (k % columns) * w * 0.92 / columns
        x, y = (x0 + 0.02, x0 + w * 0.92 / columns - 0.02), ((-d * 0.36, -d * 0.01), (d * 0.02, d * 0.37))[k // columns]
        b.box(x, y, (deck, deck + heap * 0.2), "metal_chrome", "pans")
        for j in range(6):
            cx = x[0] + (0.2 + 0.3 * (j % 3)) * (x[1] - x[0])
            cy = y[0] + (0.3 + 0.4 * (j // 3)) * (y[1] - y[0])
            b.ball(
                (cx, cy, deck + heap * 0.25),
                ((x[1] - x[0]) * 0.2, (y[1] - y[0]) * 0.24, heap * (0.3 + 0.12 * (j % 2))),
                color,
                "food",
                6,
                solid=False,
            )
    _sneeze_guard(b, deck, heap)


def _sneeze_guard(b: Builder, deck: float, heap: float) -> None:
    """Panes of glass that slope down by `heap` on both sides of a lamp on two posts."""
    w, d, h = b.w, b.d, b.h
    guard = h - 0.04
    for x in (-w * 0.47, w * 0.47):
        b.rod((x, 0, deck), (x, 0, guard), 0.018, "metal_chrome", "posts")
    for side in (-1, 1):
        b.prism(
            [
                (side * d * 0.04, guard),
                (side * d * 0.4, guard - heap),
                (side * d * 0.41, guard - heap * 0.94),
                (side * d * 0.04, guard + 0.012),
            ],
            (-w / 2, w / 2),
            "glass_blue",
            part="guard",
        )
    b.box((-w / 2, w / 2), (-d * 0.06, d * 0.06), (guard, guard + 0.04), "metal_chrome", "lamp")


@recipe("deep_fryer")
def deep_fryer(b: Builder) -> None:
    """A steel cabinet with two wells of hot oil, a wire basket of fries in each with its handle to the front."""
    w, d, h = b.w, b.d, b.h
    depth = float(b.p.get("depth", h * 0.13))
    deck, t = h - depth, w * 0.05
    b.box((-w / 2, w / 2), (-d / 2, d * 0.42), (h * 0.1, deck - 0.02), b.mat(), "case")
    b.legs((0, h * 0.1), 0.02, "metal_dark")
    for k in range(2):
        x0 = -w / 2 + k * w / 2
        b.box((x0 + 0.012, x0 + w / 2 - 0.012), (d * 0.42, d * 0.44), (h * 0.14, h * 0.62), "metal_light", "doors")
        b.box((x0 + w * 0.14, x0 + w * 0.36), (d * 0.44, d * 0.47), (h * 0.56, h * 0.58), "plastic_black", "doors")
        b.rod(
            (x0 + w * 0.25, d * 0.42, h * 0.72),
            (x0 + w * 0.25, d * 0.46, h * 0.72),
            w * 0.06,
            "plastic_black",
            "knobs",
            14,
        )
    for x in ((-w / 2, -w / 2 + t), (-t / 2, t / 2), (w / 2 - t, w / 2)):
        b.box(x, (-d * 0.38, d * 0.42), (deck - 0.02, deck + depth * 0.3), b.mat(), "rim")
    b.box((-w / 2, w / 2), (d * 0.36, d * 0.42), (deck - 0.02, deck + depth * 0.3), b.mat(), "rim")
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.38), (deck - 0.02, h), b.mat(), "splash_back")
    for side in (-1, 1):
        x0, x1 = sorted((side * t, side * (w / 2 - t * 1.4)))
        _fry_basket(b, (x0, x1), deck, depth)


def _fry_basket(b: Builder, x: tuple[float, float], deck: float, depth: float) -> None:
    """Oil across the span of `x`, and in it a wire basket of fries with its handle to the front."""
    w, d = b.w, b.d
    middle, wide, high = (x[0] + x[1]) / 2, x[1] - x[0], (deck, deck + depth * 0.5)
    b.box((x[0] - 0.01, x[1] + 0.01), (-d * 0.38, d * 0.36), (deck - 0.02, deck - 0.01), "food_c08a1e", "oil")
    for y in (-d * 0.3, d * 0.3):
        b.box(x, (y - 0.006, y + 0.006), high, "metal_dark", "baskets")
    for side in x:
        b.box((side - 0.004, side + 0.004), (-d * 0.3, d * 0.3), high, "metal_dark", "baskets")
    b.rod((middle, d * 0.3, high[1]), (middle, d * 0.46, deck + depth * 0.8), 0.008, "metal_dark", "handles")
    grip = ((middle, d * 0.4, deck + depth * 0.7), (middle, d / 2, deck + depth * 0.95))
    b.rod(*grip, 0.016, "plastic_black", "handles")
    for k in range(16):
        u, y = x[0] + wide * (0.12 + 0.25 * (k % 4)), -d * 0.22 + d * 0.14 * (k // 4)
        end = (u + w * 0.04 * (k % 3 - 1), y + d * 0.05, high[1])
        b.rod((u, y, deck), end, 0.012, "food_f2c54a", "fries", 4)


@recipe("cutting_board")
def cutting_board(b: Builder) -> None:
    """A board with a groove round it and a hole to hang it by; a knife and slices of tomato on it."""
    w, d, h = b.w, b.d, b.h
    board, x = h * 0.5, w * 0.36
    b.box((-w / 2, x), (-d / 2, d / 2), (0, board), b.mat(), "board")
    for side in ((-d / 2, -d * 0.16), (d * 0.16, d / 2)):
        b.box((x, w / 2), side, (0, board), b.mat(), "board")
    b.box((w * 0.45, w / 2), (-d / 2, d / 2), (0, board), b.mat(), "board")
    for y in (-d * 0.44, d * 0.42):
        b.box((-w * 0.46, x), (y, y + d * 0.02), (board, board * 1.02), "wood_walnut", "groove", solid=False)
    b.box((-w * 0.46, -w * 0.45), (-d * 0.44, d * 0.44), (board, board * 1.02), "wood_walnut", "groove", solid=False)
    b.prism(
        [(-w * 0.36, d * 0.1), (0, d * 0.1), (0, d * 0.24), (-w * 0.3, d * 0.22)],
        (board, board * 1.15),
        "metal_chrome",
        "z",
        "knife",
    )
    b.box((0, w * 0.26), (d * 0.14, d * 0.24), (board, board * 1.4), "plastic_black", "knife")
    for k in range(4):
        cx = -w * 0.3 + k * w * 0.1
        b.cyl(cx, -d * 0.2, (board, h * (0.8 + 0.2 * (k == 0))), d * 0.13, "food_red", "tomato", n=16)
        b.cyl(cx, -d * 0.2, (board, h * (0.82 + 0.18 * (k == 0))), d * 0.07, "food_e8836f", "tomato", n=12)


@recipe("dish_sponge")
def dish_sponge(b: Builder) -> None:
    """A yellow sponge with pores and a green scouring layer on top."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.72), "food_f2d24a", "sponge", 0.25)
    b.box((-w * 0.49, w * 0.49), (-d * 0.49, d * 0.49), (h * 0.7, h), "fabric_2f7a3f", "scourer")
    for k in range(12):
        y, z = d * (-0.42 + 0.84 * ((k * 5) % 12) / 11), h * (0.14 + 0.44 * ((k * 7) % 5) / 4)
        r = h * (0.04 + 0.02 * (k % 3))
        for side in (-1, 1):
            b.rod((side * w * 0.48, y, z), (side * w * 0.502, y, z), r, "food_b8932a", "pores", 8)
        x = y * w / d
        b.rod((x, d * 0.48, z), (x, d * 0.502, z), r, "food_b8932a", "pores", 8)


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


@recipe("filled_glass")
def filled_glass(b: Builder) -> None:
    """A tumbler of clear glass with a thick foot and a bright rim, two thirds full."""
    w, d, h = b.w, b.d, b.h
    stretch = (w, d)
    b.lathe([(0.38, 0), (0.5, h), (0.46, h), (0.36, h * 0.08)], b.mat(), n=24, stretch=stretch)
    b.lathe(
        [(0.37, h * 0.08), (0.445, h * 0.66)],
        str(b.p.get("drink", "plastic_8fc6ea")),
        n=24,
        stretch=stretch,
        part="drink",
        solid=False,
    )
    b.lathe([(0.495, h * 0.97), (0.5, h), (0.46, h)], "glass_white", n=24, stretch=stretch, part="rim", solid=False)
    b.lathe([(0.38, 0), (0.39, h * 0.05)], "glass_white", n=24, stretch=stretch, part="foot", solid=False)


@recipe("wine_glass")
def wine_glass(b: Builder) -> None:
    """A round foot, a thin stem and a bowl that narrows to its rim, with red wine in it."""
    w, d, h = b.w, b.d, b.h
    stretch = (w, d)
    b.lathe(
        [(0.42, 0), (0.4, h * 0.02), (0.05, h * 0.05), (0.045, h * 0.44), (0.12, h * 0.48)],
        "glass_white",
        n=24,
        stretch=stretch,
        part="stem",
    )
    b.lathe(
        [(0.12, h * 0.47), (0.44, h * 0.6), (0.5, h * 0.74), (0.4, h), (0.37, h), (0.46, h * 0.74), (0.1, h * 0.5)],
        b.mat(),
        n=24,
        stretch=stretch,
    )
    b.lathe(
        [(0.1, h * 0.49), (0.43, h * 0.61), (0.47, h * 0.74)],
        "plastic_7a1230",
        n=24,
        stretch=stretch,
        part="wine",
        solid=False,
    )
