"""Cookware: pots, pans, boards, ladles, foil, and racks for drying dishes."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("cooking_pot")
def cooking_pot(b: Builder) -> None:
    """A deep pot with a copper base, a rolled rim, two loop handles, SOUP on its outside and some of it inside."""
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
    for k, letter in enumerate("SOUP"):
        _letter_round(b, letter, math.radians(45 + 17 * (k - 1.5)), (rx * 0.475, ry * 0.475))
    b.lathe([(0.45, h * 0.08), (0.45, h * 0.1)], "food_d8621e", n=28, stretch=stretch, part="soup", solid=False)
    for k in range(9):
        u, v = rx * 0.3 * math.cos(2.4 * k) * (0.4 + 0.07 * k), ry * 0.3 * math.sin(2.4 * k) * (0.4 + 0.07 * k)
        b.cyl(
            u, v, (h * 0.1, h * 0.115), 0.014, ("food_f5a81e", "food_4fb03a", "food_f4ead0")[k % 3], "vegetables", n=10
        )


def _letter_round(b: Builder, letter: str, a: float, radii: tuple[float, float]) -> None:
    """A letter at an angle on an outside that is an ellipse of two radii."""
    x, y = radii[0] * math.cos(a), radii[1] * math.sin(a)
    out = (math.cos(a) * radii[1], math.sin(a) * radii[0])
    long = math.hypot(*out)
    face = DrawnFace(b, (x, y, 0.0), (-out[1] / long, out[0] / long, 0.0), (0.0, 0.0, 1.0))
    half = min(radii) * 0.125
    face.write(letter, (-half, half), (b.h * 0.2, b.h * 0.75), "plastic_b8201e", "letters", half * 0.2)


@recipe("pan")
def pan(b: Builder) -> None:
    """Frying pan, its handle to the back."""
    r = min(b.w / 2, b.d * 0.34)
    y = b.d / 2 - r
    sx = b.w / 2 / r
    b.lathe(
        [(r * 0.8, 0), (r, b.h * 0.85), (r * 0.96, b.h * 0.85), (r * 0.78, b.h * 0.12)],
        b.mat(),
        (0, y),
        n=24,
        stretch=(sx, 1.0),
    )
    b.box((-0.012, 0.012), (-b.d / 2, y - r * 0.95), (b.h * 0.6, b.h), "plastic_black", "handle")


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


@recipe("ladle")
def ladle(b: Builder) -> None:
    """A deep round bowl, hollow, at the end of a long handle that ends in a hook."""
    w, d, h = b.w, b.d, b.h
    r = w / 2
    y = d / 2 - r
    deep = h * 0.8
    b.lathe(
        [
            (r * 0.4, 0),
            (r * 0.8, deep * 0.3),
            (r, deep),
            (r * 0.92, deep),
            (r * 0.7, deep * 0.36),
            (r * 0.3, deep * 0.1),
        ],
        b.mat(),
        (0, y),
        "bowl",
        20,
    )
    b.lathe([(r * 0.86, deep * 0.62), (r * 0.86, deep * 0.66)], "food_c8641f", (0, y), "soup", 20)
    b.path(
        [
            (0, y - r * 0.95, deep * 0.9),
            (0, y - r * 1.4, h * 0.95),
            (0, -d * 0.42, h * 0.55),
            (0, -d / 2 + 0.006, h * 0.5),
        ],
        w * 0.07,
        b.mat(),
        "handle",
    )
    b.path(
        [(0, -d / 2 + 0.006, h * 0.5), (0, -d / 2 + 0.006, h * 0.3), (0, -d * 0.46, h * 0.26)],
        w * 0.06,
        b.mat(),
        "hook",
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


@recipe("foil_roll")
def foil_roll(b: Builder) -> None:
    """A long carton with the word FOIL on it, and a sheet of silver foil drawn out of it over its front."""
    w, d, h = b.w, b.d, b.h
    back = d * 0.08
    b.box((-w / 2, w / 2), (-d / 2, back), (0, h * 0.9), "paper_2f5fa8", "carton")
    b.prism(
        [(-d / 2, h * 0.9), (-d * 0.42, h * 0.9), (-d * 0.42, h), (-d * 0.46, h)],
        (-w / 2, w / 2),
        "paper_2f5fa8",
        part="lid",
    )
    sheet = [
        (back - d * 0.3, h * 0.9),
        (back + d * 0.02, h * 0.95),
        (d * 0.3, h * 0.16),
        (d / 2, 0.0),
        (d / 2, h * 0.03),
        (d * 0.31, h * 0.22),
        (back + d * 0.03, h),
        (back - d * 0.3, h * 0.95),
    ]
    for part in ((0, 1, 6, 7), (1, 2, 5, 6), (2, 3, 4, 5)):
        b.prism([sheet[k] for k in part], (-w * 0.46, w * 0.46), "metal_chrome", part="sheet")
    top = DrawnFace.top(b, h * 0.95)
    top.write("FOIL", (-w * 0.3, w * 0.3), (d * 0.24, d * 0.4), "paper_white", "letters", 0.001)
    slope = DrawnFace.sloped(b, (d * 0.31, h * 0.22), (back + d * 0.03, h))
    for k in range(7):
        u = w * (-0.4 + 0.12 * k)
        slope.field(
            (u, u + w * 0.05), (d * 0.02 * (k % 3), d * 0.2), ("metal_white", "metal_grey")[k % 2], "creases", 0.0006
        )


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
