"""Cars, lorries, vans, fire engines and rowing boats."""

import numpy as np

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("car")
def car(b: Builder) -> None:
    """Saloon: body, cabin with glass, wheels, lamps."""
    _car_body(b)
    for side in (-1, 1):
        _car_wheels(b, side)
        _car_lamps(b, side)
        _car_pillar(b, side)


def _car_body(b: Builder) -> None:
    """Body on its sill, a cabin of dark glass, the roof."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    side = [
        (-d / 2, h * 0.28),
        (d / 2, h * 0.26),
        (d / 2 - 0.04, h * 0.46),
        (d * 0.3, h * 0.58),
        (-d * 0.46, h * 0.62),
        (-d / 2, h * 0.5),
    ]
    b.prism(side, (-w / 2 + 0.04, w / 2 - 0.04), m, part="body")
    b.prism(
        [(-d / 2 + 0.1, h * 0.16), (d / 2 - 0.1, h * 0.16), (d / 2, h * 0.3), (-d / 2, h * 0.3)],
        (-w / 2 + 0.06, w / 2 - 0.06),
        m,
        part="body",
    )
    b.prism(
        [(-d * 0.42, h * 0.6), (d * 0.22, h * 0.58), (d * 0.06, h - 0.03), (-d * 0.28, h - 0.03)],
        (-w * 0.42, w * 0.42),
        "glass_black",
        part="glass",
    )
    b.prism(
        [(-d * 0.3, h - 0.06), (d * 0.08, h - 0.06), (d * 0.05, h), (-d * 0.27, h)],
        (-w * 0.39, w * 0.39),
        m,
        part="roof",
    )


def _car_wheels(b: Builder, side: int) -> None:
    w, r = b.w, b.h * 0.22
    for y in (-b.d * 0.31, b.d * 0.31):
        inner, outer = (side * (w / 2 - 0.24), y, r), (side * (w / 2 - 0.01), y, r)
        b.rod(inner, outer, r, "rubber_black", "wheels", 24, solid=True)
        rim = (side * (w / 2 - 0.03), y, r)
        b.rod(rim, (side * w / 2, y, r), r * 0.6, "metal_steel", "rims", 16)


def _car_lamps(b: Builder, side: int) -> None:
    """A white lamp at the front, a red one at the back."""
    w, d, h = b.w, b.d, b.h
    x = (side * w * 0.36 - 0.14, side * w * 0.36 + 0.14)
    b.box(x, (d / 2 - 0.06, d / 2), (h * 0.38, h * 0.46), "light_white", "lamps", solid=False)
    b.box(x, (-d / 2, -d / 2 + 0.05), (h * 0.42, h * 0.52), "light_red", "lamps", solid=False)


def _car_pillar(b: Builder, side: int) -> None:
    """The post between the side windows."""
    w, d, h = b.w, b.d, b.h
    low, high = sorted((side * w * 0.41, side * w * 0.425))
    b.prism(
        [(d * 0.02, h * 0.6), (d * 0.035, h * 0.6), (-d * 0.02, h - 0.05), (-d * 0.035, h - 0.05)],
        (low, high),
        b.mat(),
        part="pillars",
        solid=False,
    )


@recipe("fire_engine")
def fire_engine(b: Builder) -> None:
    """Cab with glass in front of a body with lockers, a ladder on the roof, blue lamps."""
    w, d, h = b.w, b.d, b.h
    m, floor, cab = b.mat(), 0.42, d / 2 - 0.24 * d
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2, cab - 0.06), (floor, h - 0.25), m, "body")
    b.prism(
        [(cab, floor), (d / 2, floor), (d / 2, h * 0.52), (d / 2 - 0.22, h - 0.4), (cab, h - 0.4)],
        (-w / 2 + 0.03, w / 2 - 0.03),
        m,
        part="cab",
    )
    b.box((-w * 0.3, w * 0.3), (-d / 2, d / 2 - 0.3), (0.28, floor), "metal_dark", "chassis")
    b.box((-w * 0.44, w * 0.44), (d / 2 - 0.2, d / 2 - 0.1), (h * 0.54, h - 0.5), "glass_black", "glass", solid=False)
    b.box((-w * 0.4, w * 0.4), (cab + 0.2, cab + 0.5), (h - 0.4, h - 0.28), "light_blue", "lamps", solid=False)
    for side in (-1, 1):
        _engine_side(b, side, floor, cab)
    _engine_ladder(b, cab)


def _engine_side(b: Builder, side: int, floor: float, cab: float) -> None:
    """Lockers, door glass, wheels, and lamps at both ends."""
    w, d, h = b.w, b.d, b.h
    low, high = sorted((side * (w / 2 - 0.03), side * (w / 2 - 0.01)))
    length = (cab + d / 2 - 0.3) / 3
    for k in range(3):
        y = -d / 2 + 0.1 + k * (length + 0.04)
        b.box((low, high), (y, y + length), (floor + 0.35, h - 0.4), "metal_steel", "lockers", solid=False)
    b.box((low, high), (cab + 0.25, d / 2 - 0.4), (h * 0.54, h - 0.5), "glass_black", "glass", solid=False)
    for y in (-d * 0.27, d * 0.3):
        b.rod((side * (w / 2 - 0.32), y, 0.5), (side * w / 2, y, 0.5), 0.5, "rubber_black", "wheels", 24, solid=True)
    x = (side * w * 0.38 - 0.12, side * w * 0.38 + 0.12)
    b.box(x, (d / 2 - 0.02, d / 2), (floor + 0.1, floor + 0.3), "light_white", "lamps", solid=False)
    b.box(x, (-d / 2 - 0.0, -d / 2 + 0.02), (floor + 0.1, floor + 0.3), "light_red", "lamps", solid=False)


def _engine_ladder(b: Builder, cab: float) -> None:
    """A ladder along the roof of the body."""
    d, z = b.d, b.h - 0.12
    for x in (-0.3, 0.3):
        b.rod((x, -d / 2 + 0.1, z), (x, cab + 0.3, z), 0.04, "metal_steel", "ladder", 8)
    for k in range(9):
        y = -d / 2 + 0.3 + k * (cab + d / 2) / 9
        b.rod((-0.3, y, z), (0.3, y, z), 0.025, "metal_steel", "ladder", 6)
    for y in (-d * 0.4, cab - 0.4):
        b.rod((0.0, y, b.h - 0.25), (0.0, y, z + 0.12), 0.06, "metal_dark", "ladder", 8)


def _wheels(b: Builder, r: float, axles: tuple[float, ...]) -> None:
    """Add pairs of wheels, in places along the vehicle."""
    for y in axles:
        for side in (-1, 1):
            across = sorted((side * b.w / 2, side * (b.w / 2 - 0.26)))
            b.rod((across[0], y, r), (across[1], y, r), r, "rubber_black", "wheels", 20, solid=True)
            cap = side * b.w / 2
            b.rod((cap - side * 0.02, y, r), (cap + side * 0.004, y, r), r * 0.55, "metal_light", "wheels", 16)


def _lamps(b: Builder, y: float, z: tuple[float, float]) -> None:
    """Add two headlights, indicators, and a number plate."""
    face = DrawnFace.front(b, y)
    for side in (-1, 1):
        u = sorted((side * b.w * 0.44, side * b.w * 0.3))
        face.field((u[0], u[1]), z, "light_fff6df", "lamps", 0.012)
        u = sorted((side * b.w * 0.29, side * b.w * 0.25))
        face.field((u[0], u[1]), z, "light_orange", "lamps", 0.012)
    face.field((-b.w * 0.14, b.w * 0.14), (z[0] - 0.16, z[0] - 0.06), "plastic_white", "plate", 0.012)


@recipe("lorry")
def lorry(b: Builder) -> None:
    """A cab with a steep windscreen, a gap, and a tall white box on a frame with three axles."""
    w, d, h = b.w, b.d, b.h
    r, floor = h * 0.19, h * 0.3
    cab = d / 2 - d * 0.27
    _wheels(b, r, (d * 0.36, -d * 0.22, -d * 0.36))
    b.box((-w * 0.3, w * 0.3), (-d * 0.48, d * 0.44), (r, floor), "metal_dark", "frame")
    front = [(cab, floor * 0.7), (d / 2, floor * 0.7), (d / 2, h * 0.52), (d / 2 - 0.14, h * 0.84), (cab, h * 0.84)]
    b.prism(front, (-w * 0.47, w * 0.47), b.mat(), part="cab")
    b.prism([(cab, h * 0.84), (d / 2 - 0.3, h * 0.84), (cab, h * 0.95)], (-w * 0.44, w * 0.44), b.mat(), part="spoiler")
    b.box((-w * 0.49, w * 0.49), (d / 2 - 0.16, d / 2), (floor * 0.55, floor * 0.95), "metal_light", "bumper")
    glass = DrawnFace.sloped(b, (d / 2, h * 0.52), (d / 2 - 0.14, h * 0.84))
    glass.field((-w * 0.43, w * 0.43), (0.04, h * 0.28), "glass_black", "windscreen", 0.012)
    _lamps(b, d / 2, (floor * 0.64, floor * 0.86))
    grille = DrawnFace.front(b, d / 2)
    for k in range(4):
        v = h * (0.33 + 0.042 * k)
        grille.field((-w * 0.34, w * 0.34), (v, v + h * 0.022), "plastic_black", "grille", 0.012)
    for side in (-1, 1):
        across = sorted((side * w * 0.47, side * (w * 0.47 + 0.012)))
        window = [(cab + 0.16, h * 0.54), (d / 2 - 0.12, h * 0.54), (d / 2 - 0.22, h * 0.8), (cab + 0.16, h * 0.8)]
        b.prism(window, (across[0], across[1]), "glass_black", part="windows")
        b.box(
            (across[0], across[1] + 0.004),
            (cab + 0.05, cab + 0.08),
            (floor, h * 0.82),
            "metal_dark",
            "door",
            solid=False,
        )
        mirror = sorted((side * w * 0.48, side * w * 0.5))
        b.box((mirror[0], mirror[1]), (d / 2 - 0.22, d / 2 - 0.12), (h * 0.6, h * 0.76), "plastic_black", "mirrors")
    b.box((-w / 2, w / 2), (-d / 2, cab - 0.16), (floor, h), "metal_white", "box")
    wall = DrawnFace.side(b, w / 2)
    wall.field((-d * 0.46, d * 0.16), (h * 0.5, h * 0.58), b.mat(), "stripe", 0.006)
    wall.write("CARGO", (-d * 0.36, d * 0.06), (h * 0.64, h * 0.88), b.mat(), "letters", 0.008)
    for k in range(5):
        u = -d * 0.46 + d * 0.155 * k
        wall.field((u, u + 0.02), (floor, h * 0.98), "metal_light", "ribs", 0.006)


@recipe("van")
def van(b: Builder) -> None:
    """A delivery van: a short nose, a raked windscreen, a tall body without windows, the rail of a sliding door."""
    w, d, h = b.w, b.d, b.h
    r, low = h * 0.16, h * 0.12
    _wheels(b, r, (d * 0.32, -d * 0.3))
    outline = [
        (-d / 2, low),
        (d * 0.47, low),
        (d / 2, h * 0.3),
        (d * 0.48, h * 0.46),
        (d * 0.36, h * 0.54),
        (d * 0.22, h * 0.95),
        (d * 0.12, h),
        (-d * 0.47, h),
        (-d / 2, h * 0.94),
    ]
    b.prism(outline, (-w * 0.48, w * 0.48), b.mat(), part="body")
    _van_nose(b, low)
    _van_sides(b, low)
    _van_letters(b)


def _van_nose(b: Builder, low: float) -> None:
    """The windscreen, lamps, the grille and a bumper."""
    w, d, h = b.w, b.d, b.h
    glass = DrawnFace.sloped(b, (d * 0.36, h * 0.54), (d * 0.22, h * 0.95))
    length = ((d * 0.14) ** 2 + (h * 0.41) ** 2) ** 0.5
    glass.field((-w * 0.42, w * 0.42), (length * 0.06, length * 0.94), "glass_black", "windscreen", 0.012)
    _lamps(b, d * 0.485, (h * 0.36, h * 0.44))
    nose = DrawnFace.front(b, d * 0.49)
    for k in range(3):
        nose.field(
            (-w * 0.22, w * 0.22), (h * (0.35 + 0.034 * k), h * (0.368 + 0.034 * k)), "plastic_black", "grille", 0.014
        )
    b.box((-w * 0.49, w * 0.49), (d * 0.42, d / 2), (low * 0.9, h * 0.22), "plastic_dark", "bumper")


def _van_sides(b: Builder, low: float) -> None:
    """A window, doors with the rail that one of them slides on, a mirror and a strip on each side."""
    w, d, h = b.w, b.d, b.h
    for side in (-1, 1):
        across = sorted((side * w * 0.48, side * (w * 0.48 + 0.012)))
        window = [(d * 0.1, h * 0.58), (d * 0.32, h * 0.58), (d * 0.21, h * 0.88), (d * 0.1, h * 0.88)]
        b.prism(window, (across[0], across[1]), "glass_black", part="windows")
        for y in (d * 0.08, -d * 0.14):
            b.box((across[0], across[1]), (y - 0.012, y + 0.012), (low, h * 0.92), "metal_dark", "doors", solid=False)
        b.box(
            (across[0], across[1] + 0.004),
            (-d * 0.44, -d * 0.14),
            (h * 0.52, h * 0.545),
            "metal_dark",
            "rail",
            solid=False,
        )
        b.box(
            (across[0], across[1] + 0.01),
            (-d * 0.1, -d * 0.05),
            (h * 0.5, h * 0.53),
            "plastic_black",
            "handles",
            solid=False,
        )
        mirror = sorted((side * w * 0.48, side * w / 2))
        b.box((mirror[0], mirror[1]), (d * 0.28, d * 0.32), (h * 0.56, h * 0.66), "plastic_black", "mirrors")
        b.box(
            (across[0], across[1]), (-d * 0.47, d * 0.44), (h * 0.24, h * 0.275), "plastic_dark", "strip", solid=False
        )


def _van_letters(b: Builder) -> None:
    """The word EXPRESS on the right side."""
    w, d, h = b.w, b.d, b.h
    side_wall = DrawnFace.side(b, w * 0.48)
    ink = "paint_2f5fc8" if "white" in b.mat() else "plastic_white"
    side_wall.write("EXPRESS", (-d * 0.45, d * 0.04), (h * 0.64, h * 0.82), ink, "letters", 0.008)


@recipe("rowing_boat")
def rowing_boat(b: Builder) -> None:
    """A boat of planks with a pointed bow to the front, a flat stern, two thwarts and a pair of oars."""
    w, d, h = b.w, b.d, b.h
    stations = (
        (-0.5, 0.34, 0.0),
        (-0.3, 0.46, 0.0),
        (0.0, 0.48, 0.0),
        (0.22, 0.4, 0.02),
        (0.4, 0.2, 0.1),
        (0.5, 0.02, 0.24),
    )
    rim = (0.62, 0.58, 0.56, 0.6, 0.72, 0.9)
    for k in range(5):
        (y0, half0, keel0), (y1, half1, keel1) = stations[k], stations[k + 1]
        for strake, color in enumerate((b.mat(), b.mat(), "paint_white")):
            lower, upper = strake / 3, (strake + 1) / 3
            for side in (-1, 1):
                ends = ((y0, half0, keel0, rim[k]), (y1, half1, keel1, rim[k + 1]))
                quad = [
                    (side * w * half * (0.5 + 0.5 * share**0.6), y * d, h * (keel + (top - keel) * share))
                    for y, half, keel, top in ends
                    for share in (lower, upper)
                ]
                _plank(b, quad, side, w * 0.03, color)
        floor = [
            (-w * half0 * 0.52, y0 * d),
            (w * half0 * 0.52, y0 * d),
            (w * half1 * 0.52, y1 * d),
            (-w * half1 * 0.52, y1 * d),
        ]
        b.prism(floor, (h * keel0, h * (keel1 + 0.05)), "wood_walnut", "z", "floor")
    b.box((-w * 0.34, w * 0.34), (-d / 2, -d * 0.485), (0, h * 0.62), "paint_white", "stern")
    for y in (-0.36, -0.06, 0.22):
        half = 0.44 if y < 0.1 else 0.34
        b.box((-w * half, w * half), (d * (y - 0.035), d * (y + 0.035)), (h * 0.4, h * 0.44), "wood_birch", "thwarts")
    for side in (-1, 1):
        b.rod((side * w * 0.26, -d * 0.4, h * 0.5), (side * w * 0.3, d * 0.2, h * 0.62), 0.028, "wood_birch", "oars")
        b.box(
            (side * w * 0.3 - 0.08, side * w * 0.3 + 0.08),
            (d * 0.18, d * 0.3),
            (h * 0.6, h * 0.63),
            "paint_red",
            "oars",
        )


def _plank(b: Builder, quad: list[tuple[float, float, float]], side: int, thick: float, color: str) -> None:
    """Add a plank: four corners of its outer face, lower and upper at one station and at the next."""
    outer = np.array([quad[0], quad[1], quad[3], quad[2]])
    inner = outer - np.array([side * thick, 0.0, 0.0])
    faces = [(0, 1, 2), (0, 2, 3), (4, 6, 5), (4, 7, 6)]
    for k in range(4):
        n = (k + 1) % 4
        faces += [(k, k + 4, n + 4), (k, n + 4, n)]
    table = np.array(faces)
    b.raw(np.concatenate([outer, inner]), table if side > 0 else table[:, ::-1], color, "planks")
