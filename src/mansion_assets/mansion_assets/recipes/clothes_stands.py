"""Stands for clothes, umbrellas and luggage: clothes rails, drying racks, coat stands, hooks."""

import math

from mansion_assets.builder import Box, Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


_GARMENTS = ("fabric_blue", "fabric_red", "fabric_dark", "fabric_beige", "fabric_green", "fabric_white")


@recipe("rail")
def rail(b: Builder) -> None:
    """Clothes rail with garments, or a drying rack."""
    if b.p.get("style") == "airer":
        _airer(b)
        return
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.03)
        b.box((x - 0.03, x + 0.03), (-d / 2, d / 2), (0.04, 0.07), b.mat(), "feet")
        b.cyl(x, 0, (0.05, h), 0.016, b.mat(), "posts", n=10)
    b.wheels(0.03, 0.05)
    bar = h - 0.014
    b.rod((-w / 2 + 0.03, 0, bar), (w / 2 - 0.03, 0, bar), 0.014, b.mat(), "bar", solid=True)
    count = max(6, round(w / 0.09))
    for k in range(count):
        _garment(b, k, -w / 2 + 0.1 + k * (w - 0.2) / (count - 1))


def _garment(b: Builder, k: int, x: float) -> None:
    """One piece on its hanger, sloping from the shoulders."""
    d, h = b.d, b.h
    deep = d * (0.42, 0.36, 0.4)[k % 3]
    low = h * (0.35, 0.28, 0.42, 0.31)[k % 4]
    b.prism(
        [
            (-deep, low),
            (deep, low),
            (deep * 0.95, h - 0.2),
            (0.02, h - 0.06),
            (-0.02, h - 0.06),
            (-deep * 0.95, h - 0.2),
        ],
        (x - 0.018, x + 0.018),
        _GARMENTS[(k * 5 + k // 2) % 6],
        part="clothes",
        solid=k % 3 == 0,
    )


def _airer(b: Builder) -> None:
    """Drying rack on crossed legs, with three cloths."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.012)
        b.rod((x, -d / 2 + 0.01, 0), (x, d / 2 - 0.01, h - 0.012), 0.011, b.mat(), "legs")
        b.rod((x, d / 2 - 0.01, 0), (x, -d / 2 + 0.01, h - 0.012), 0.011, b.mat(), "legs")
    for k in range(7):
        y = -d / 2 + 0.012 + k * (d - 0.024) / 6
        b.rod((-w / 2, y, h - 0.012), (w / 2, y, h - 0.012), 0.006, b.mat(), "bars")
    for k, color in enumerate(("fabric_white", "fabric_blue", "fabric_beige")):
        x = -w * 0.4 + k * w * 0.28
        b.box(
            (x, x + w * 0.22),
            (-d * 0.1 + k * 0.05, -d * 0.1 + k * 0.05 + 0.01),
            (h * 0.5, h - 0.01),
            color,
            "laundry",
            solid=False,
        )
    b.boxes.append(Box((0.0, 0.0, h / 2), (w, d, h)))


@recipe("coat_rack")
def coat_rack(b: Builder) -> None:
    """Stand with hooks, a coat and a hat."""
    w, d, h = b.w, b.d, b.h
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        b.rod((0, 0, 0.12), (math.cos(a) * w * 0.66, math.sin(a) * d * 0.66, 0.015), 0.016, b.mat(), "feet")
    b.cyl(0, 0, (0.05, h), 0.022, b.mat(), "pole")
    for k in range(6):
        a = k * math.pi / 3
        b.path(
            [
                (0, 0, h - 0.22),
                (math.cos(a) * w * 0.36, math.sin(a) * d * 0.36, h - 0.2),
                (math.cos(a) * w * 0.44, math.sin(a) * d * 0.44, h - 0.06),
            ],
            0.011,
            b.mat(),
            "hooks",
        )
    b.cushion(
        (w * 0.12, w * 0.44), (-d * 0.18, d * 0.18), (h * 0.42, h - 0.2), "fabric_blue", "coat", 0.6, 10, solid=False
    )


@recipe("hooks")
def hooks(b: Builder) -> None:
    """Rail with hooks and a coat."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.02), (h * 0.45, h), b.mat(), "rail")
    for k in range(max(3, round(w / 0.2))):
        x = -w / 2 + (k + 0.5) * w / max(3, round(w / 0.2))
        b.path(
            [(x, -d / 2 + 0.02, h * 0.7), (x, d / 2 - 0.01, h * 0.45), (x, d / 2 - 0.01, h * 0.85)],
            0.008,
            "metal_steel",
            "hooks",
        )
        b.path([(x, -d / 2 + 0.02, h * 0.5), (x, d * 0.1, h * 0.05)], 0.007, "metal_steel", "hooks")


@recipe("umbrella_stand")
def umbrella_stand(b: Builder) -> None:
    """An open cylinder of bars with three furled umbrellas, their crooks over its rim."""
    w, d, h = b.w, b.d, b.h
    rim = h * 0.62
    b.lathe([(0.48, 0), (0.48, h * 0.04)], b.mat(), n=24, stretch=(w, d), part="tray")
    for k in range(14):
        a = k * math.pi / 7
        x, y = 0.46 * w * math.cos(a), 0.46 * d * math.sin(a)
        b.rod((x, y, h * 0.03), (x, y, rim), w * 0.016, b.mat(), "bars", 6)
    for z in (h * 0.34, rim):
        ring = [(0.46 * w * math.cos(k * math.pi / 10), 0.46 * d * math.sin(k * math.pi / 10), z) for k in range(21)]
        b.path(ring, w * 0.03, b.mat(), "hoops")
    for k, color in enumerate(("fabric_red", "fabric_blue", "fabric_3f8f4f")):
        a = 0.6 + k * 2 * math.pi / 3
        x, y = w * 0.18 * math.cos(a), d * 0.18 * math.sin(a)
        foot, neck = (x * 0.6, y * 0.6, h * 0.05), (x * 1.3, y * 1.3, h * 0.74)
        middle = ((foot[0] + neck[0]) / 2, (foot[1] + neck[1]) / 2, h * 0.5)
        b.rod(foot, middle, w * 0.045, color, "umbrellas", 8)
        b.rod(middle, neck, w * 0.08, color, "umbrellas", 8)
        top = (x * 1.5, y * 1.5, h * 0.92)
        hook = [
            (top[0] + w * 0.06 * (1 - math.cos(t)), top[1], top[2] + h * 0.06 * math.sin(t))
            for t in (j * math.pi / 5 for j in range(1, 6))
        ]
        b.path([neck, top, *hook], w * 0.022, "wood_walnut", "crooks")


@recipe("luggage_rack")
def luggage_rack(b: Builder) -> None:
    """A folding stand: legs that cross like an X in front and behind, and studded straps from one rail to the other."""
    w, d, h = b.w, b.d, b.h
    r, rail = 0.02, h - 0.028
    for y in (-d / 2 + 0.05, d / 2 - 0.05):
        for side in (-1, 1):
            shift = y + side * 0.022
            b.rod(
                (side * (w / 2 - r), shift, r), (-side * (w / 2 - r), shift, rail), r, b.mat(), "legs", 10, solid=True
            )
        b.rod((0, y - 0.042, rail / 2), (0, y + 0.042, rail / 2), r * 0.7, "metal_brass", "pivots", 12)
    for side in (-1, 1):
        x = side * (w / 2 - r)
        b.rod((x, -d / 2, rail), (x, d / 2, rail), r, b.mat(), "rails", 12)
        b.rod((x, -d / 2 + 0.05, r), (x, d / 2 - 0.05, r), r * 0.8, b.mat(), "rails", 10)
    for k in range(4):
        _strap(b, -d / 2 + d * (k + 0.5) / 4, rail)
    _suitcase_plate(DrawnFace.front(b, d / 2 - 0.008), rail / 2, 0.1)


def _strap(b: Builder, y: float, rail: float) -> None:
    """A strap of leather over both rails, with seams and studs."""
    w, d, h = b.w, b.d, b.h
    half, leather = d * 0.085, "leather_8a4a1f"
    b.box((-w / 2 + 0.002, w / 2 - 0.002), (y - half, y + half), (h - 0.01, h - 0.002), leather, "straps")
    for side in (-1, 1):
        down = sorted((side * w / 2, side * (w / 2 - 0.006)))
        b.box((down[0], down[1]), (y - half, y + half), (rail - 0.06, h - 0.002), leather, "straps", solid=False)
    face = DrawnFace.top(b, h - 0.002)
    for edge in (-0.8, 0.8):
        v = -y + half * edge
        face.field((-w / 2 + 0.004, w / 2 - 0.004), (v - 0.003, v + 0.003), "fabric_e8c98a", "seams", 0.0015)
    for u in (-w * 0.45, w * 0.45):
        face.disc(u, -y, 0.013, "metal_brass", "studs", 0.002, 12)


def _suitcase_plate(face: DrawnFace, v: float, r: float) -> None:
    """A round plate where the legs cross, with the sign of a suitcase."""
    face.disc(0.0, v, r, "plastic_1f4f86", "plate", 0.004, 28)
    face.field((-r * 0.62, r * 0.62), (v - r * 0.5, v + r * 0.3), "plastic_f4f4f4", "suitcase", 0.006)
    for u in (-r * 0.36, r * 0.36):
        face.field((u - r * 0.05, u + r * 0.05), (v - r * 0.5, v + r * 0.3), "plastic_1f4f86", "suitcase", 0.008)
    grip = [(-r * 0.24, v + r * 0.3), (-r * 0.24, v + r * 0.52), (r * 0.24, v + r * 0.52), (r * 0.24, v + r * 0.3)]
    face.line(grip, r * 0.06, "plastic_f4f4f4", "suitcase", 0.003)
