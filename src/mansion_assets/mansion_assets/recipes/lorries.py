"""Vehicles that carry loads: lorries and vans."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


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
    side_wall = DrawnFace.side(b, w * 0.48)
    ink = "paint_2f5fc8" if "white" in b.mat() else "plastic_white"
    side_wall.write("EXPRESS", (-d * 0.45, d * 0.04), (h * 0.64, h * 0.82), ink, "letters", 0.008)
