"""Plants in pots and vases, and garden equipment: mowers, barbecues, watering cans, parasols."""

import math

import numpy as np

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


def _leaf(
    b: Builder, base: tuple[float, float, float], tip: tuple[float, float, float], width: float, color: str
) -> None:
    """A flat leaf between two points, seen from both sides."""
    p, q = np.array(base), np.array(tip)
    side = np.cross(q - p, (0.0, 0.0, 1.0))
    norm = float(np.linalg.norm(side))
    side = side / norm * width if norm > 1e-6 else np.array((width, 0.0, 0.0))
    middle = p + 0.55 * (q - p) + np.array((0.0, 0.0, 0.15 * abs(float(q[2] - p[2])) + 0.1 * width))
    vertices = np.array([p, middle + side, q, middle - side])
    faces = np.array([(0, 1, 2), (0, 2, 3), (0, 2, 1), (0, 3, 2)])
    b.raw(vertices, faces, color, "leaves")


def _crown(b: Builder, z: float, spread: tuple[float, float], count: int, low: float, width: float) -> None:
    for k in range(count):
        a = k * 2.399963
        level = (k + 0.5) / count
        reach = math.sqrt(1.0 - 0.55 * level)
        x, y = math.cos(a) * spread[0] * reach, math.sin(a) * spread[1] * reach
        tip = low + (b.h - low) * (0.25 + 0.75 * level)
        _leaf(b, (x * 0.12, y * 0.12, z), (x, y, tip), width, "leaf_green")


@recipe("plant")
def plant(b: Builder) -> None:
    """Pot with leaves, a small tree, cut flowers, a fir, or a planted box."""
    w, d, h = b.w, b.d, b.h
    r = min(w, d) / 2
    style = b.p.get("style", "bush")
    if style == "box":
        _planter(b)
    elif style == "cone":
        _fir(b)
    elif style == "tree":
        _pot(b, h * 0.24, r * 0.55)
        _tree(b, h * 0.24)
    elif style == "flowers":
        _pot(b, h * 0.5, r * 0.42)
        _flowers(b, h * 0.5)
    else:
        low = h * 0.36
        _pot(b, low, r * 0.7)
        _crown(b, low * 0.85, (w / 2, d / 2), 34, low * 0.9, r * 0.17)
        _crown(b, low * 0.85, (w * 0.3, d * 0.3), 14, low * 1.3, r * 0.13)


def _planter(b: Builder) -> None:
    """Box of soil with a row of bushes."""
    w, d, h = b.w, b.d, b.h
    pot = b.mat()
    low = h * 0.42
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, low), pot, "box")
    b.box(
        (-w / 2 + 0.03, w / 2 - 0.03),
        (-d / 2 + 0.03, d / 2 - 0.03),
        (low - 0.01, low + 0.004),
        "leaf_soil",
        "soil",
        solid=False,
    )
    count = max(2, round(w / 0.28))
    for k in range(count):
        x = -w / 2 + (k + 0.5) * w / count
        b.ball(
            (x, 0, low + (h - low) * 0.5),
            (w / count * 0.55, d * 0.45, (h - low) * (0.5 - 0.05 * (k % 2))),
            "leaf_green",
            "leaves",
            10,
            solid=False,
        )


def _fir(b: Builder) -> None:
    """Fir of four tiers, with balls."""
    w, d, h = b.w, b.d, b.h
    pot = b.mat()
    b.cyl(0, 0, (0, h * 0.16), 0.05, pot, "trunk")
    for k in range(4):
        z = h * (0.12 + 0.2 * k)
        b.lathe(
            [(0.5 * (1 - 0.22 * k), z), (0.06, z + h * 0.3 if k < 3 else h)],
            "leaf_green",
            stretch=(w, d),
            part="tiers",
            n=18,
            solid=k == 0,
        )
    for k in range(12):
        a = k * 2.4
        level = k / 12
        rr = 0.42 * (1 - level * 0.8)
        b.ball(
            (math.cos(a) * rr * w, math.sin(a) * rr * d, h * (0.2 + 0.65 * level)),
            (0.035, 0.035, 0.035),
            ("paint_red", "metal_brass")[k % 2],
            "balls",
            8,
            solid=False,
        )


def _pot(b: Builder, low: float, rim: float) -> None:
    """Pot with soil, up to the height `low`."""
    pot = b.mat()
    b.lathe([(rim * 0.72, 0), (rim, low), (rim * 0.9, low), (rim * 0.85, low * 0.88)], pot, n=20, part="pot")
    b.cyl(0, 0, (low * 0.8, low * 0.9), rim * 0.86, "leaf_soil", "soil", solid=False)


def _tree(b: Builder, low: float) -> None:
    """Trunk and crown above a pot as high as `low`."""
    w, d, h = b.w, b.d, b.h
    r = min(w, d) / 2
    b.cyl(0, 0, (low * 0.85, h * 0.62), r * 0.06, "wood_brown", "trunk", r * 0.045, solid=True)
    _crown(b, h * 0.5, (w / 2, d / 2), 44, h * 0.42, r * 0.16)
    _crown(b, h * 0.6, (w * 0.4, d * 0.4), 26, h * 0.55, r * 0.15)


def _flowers(b: Builder, low: float) -> None:
    """Cut flowers above a pot as high as `low`."""
    w, d, h = b.w, b.d, b.h
    for k in range(9):
        a = k * 2.4
        x, y = (math.cos(a) * w * 0.36 * math.sqrt((k + 1) / 9), math.sin(a) * d * 0.36 * math.sqrt((k + 1) / 9))
        z = h * (0.96 - 0.02 * k)
        b.rod((x * 0.2, y * 0.2, low * 0.5), (x, y, z), 0.004, "leaf_green", "stems", 5)
        b.ball(
            (x, y, z - h * 0.02),
            (w * 0.13, d * 0.13, h * 0.06),
            ("leaf_red", "leaf_yellow", "leaf_pink", "leaf_white")[k % 4],
            "blossoms",
            8,
            solid=False,
        )
    _crown(b, low, (w * 0.5, d * 0.5), 8, low, w * 0.07)


@recipe("mower")
def mower(b: Builder) -> None:
    """Lawn mower with grass box and handle."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2 + 0.04, w / 2 - 0.04), (0.0, d / 2), (0.06, 0.3), b.mat(), "deck", 0.5)
    b.cyl(0, d * 0.25, (0.28, 0.45), 0.14, "plastic_black", "motor")
    b.cushion((-w * 0.4, w * 0.4), (-d * 0.36, 0.0), (0.08, 0.45), "fabric_dark", "box", 0.4)
    for sx in (-1, 1):
        b.path([(sx * w * 0.4, 0.0, 0.25), (sx * w * 0.4, -d / 2 + 0.02, h - 0.02)], 0.015, "metal_steel", "handle")
        for y in (0.12, d * 0.42):
            b.rod((sx * (w / 2 - 0.05), y, 0.1), (sx * w / 2, y, 0.1), 0.1, "rubber_black", "wheels", 16)
    b.rod((-w * 0.4, -d / 2 + 0.02, h - 0.02), (w * 0.4, -d / 2 + 0.02, h - 0.02), 0.016, "rubber_black", "handle")


@recipe("grill")
def grill(b: Builder) -> None:
    """Gas barbecue with side tables."""
    w, d, h = b.w, b.d, b.h
    bw = w * 0.5
    b.box((-bw / 2, bw / 2), (-d / 2, d / 2 - 0.04), (0.1, h * 0.62), b.mat(), "cabinet")
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.04), (h * 0.74, h * 0.77), "metal_steel", "tables")
    b.box((-bw / 2, bw / 2), (-d / 2, d / 2 - 0.02), (h * 0.62, h * 0.76), "metal_steel", "panel")
    b.cushion((-bw / 2, bw / 2), (-d / 2, d / 2 - 0.05), (h * 0.74, h), b.mat(), "lid", 0.6, 14)
    b.rod((-bw * 0.35, d / 2 - 0.02, h * 0.86), (bw * 0.35, d / 2 - 0.02, h * 0.86), 0.015, "metal_steel", "handle")
    for k in range(4):
        b.rod(
            (-bw * 0.35 + k * bw * 0.23, d / 2 - 0.03, h * 0.69),
            (-bw * 0.35 + k * bw * 0.23, d / 2, h * 0.69),
            0.025,
            "plastic_black",
            "knobs",
            12,
        )
    b.legs((0, 0.12), 0.03, "plastic_black", w * 0.25)


@recipe("sprinkling_can")
def sprinkling_can(b: Builder) -> None:
    """A can with a wide top, a long spout that rises to a pierced rose."""
    w, d, h = b.w, b.d, b.h
    y, r = -d * 0.16, min(w / 2, d * 0.28)
    high = h * 0.66
    b.lathe([(r, 0), (r * 0.92, high), (r * 0.84, high), (r * 0.84, high * 0.8)], b.mat(), (0, y), "can", 22)
    b.lathe([(r * 0.86, high * 0.8), (r * 0.86, high * 0.82)], "glass_blue", (0, y), "water", 22)
    for z in (0.0, high * 0.5, high * 0.95):
        b.lathe([(r * 1.03, z), (r * 1.03, z + h * 0.03)], b.mat(), (0, y), "bands", 22)
    b.rod((0, y + r * 0.8, h * 0.14), (0, d * 0.4, h * 0.82), w * 0.075, b.mat(), "spout", 12, solid=True)
    b.rod((0, y + r * 0.9, high * 0.86), (0, d * 0.26, h * 0.62), w * 0.025, b.mat(), "stay", 8)
    b.rod((0, d * 0.38, h * 0.79), (0, d * 0.45, h * 0.91), w * 0.09, b.mat(), "rose", 14)
    b.rod((0, d * 0.44, h * 0.9), (0, d * 0.47, h * 0.95), w * 0.2, "metal_brass", "rose", 18)
    bow = [
        (0, y - r * 0.9, high * 0.3),
        (0, y - r * 1.5, high * 0.7),
        (0, y - r * 1.1, h * 0.97),
        (0, y, h * 0.97),
        (0, y + r * 0.7, high),
    ]
    b.path(bow, w * 0.05, b.mat(), "handle")


@recipe("parasol")
def parasol(b: Builder) -> None:
    """Sunshade on a pole."""
    w, d, h = b.w, b.d, b.h
    b.cyl(0, 0, (0, 0.08), 0.28, "stone_grey", "foot", n=24)
    b.cyl(0, 0, (0.05, h - 0.02), 0.022, "wood_oak", "pole")
    b.lathe(
        [(0.5, h * 0.78), (0.02, h), (0.01, h), (0.48, h * 0.78)],
        b.mat(),
        stretch=(w, d),
        part="cover",
        n=8,
        solid=False,
    )
