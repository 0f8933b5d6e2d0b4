"""Furniture for babies and small children: changing tables, high chairs, prams."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("changing_table")
def changing_table(b: Builder) -> None:
    """Drawers with bear-brown knobs below a hollow pad between raised sides, with a strap and the sign of a baby."""
    w, d, h = b.w, b.d, b.h
    high, face = h * 0.84, d / 2 - 0.02
    b.hollow((-w / 2, w / 2), (-d / 2, face), (0.05, high), 0.02, b.mat())
    for x in (-w * 0.45, w * 0.45):
        b.box((x - 0.03, x + 0.03), (-d * 0.46, d * 0.4), (0, 0.05), "wood_birch", "feet")
    rows = 3
    step = (high - 0.09) / rows
    for k in range(rows):
        z = (0.072 + k * step, 0.072 + (k + 1) * step - 0.012)
        color = ("plastic_f2b8c6", "plastic_f2e08f", "plastic_a8d5e8")[k]
        with b.drawer((-w / 2 + 0.024, w / 2 - 0.024), (-d / 2 + 0.03, face), (z[0], z[0] + step * 0.6), b.mat()):
            b.box((-w / 2 + 0.01, w / 2 - 0.01), (face + 0.001, face + 0.016), z, color, "drawers", solid=False)
            for u in (-w * 0.2, w * 0.2):
                b.rod((u, face + 0.015, sum(z) / 2), (u, d / 2 + 0.01, sum(z) / 2), 0.018, "wood_brown", "knobs", 12)
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - 0.025)))
        wall = [(-d / 2, high), (face, high), (face, h * 0.94), (d * 0.1, h), (-d / 2, h)]
        b.prism(wall, (across[0], across[1]), b.mat(), part="sides")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.025), (high, h), b.mat(), "sides")
    b.box((-w / 2, w / 2), (face - 0.02, face), (high, h * 0.89), b.mat(), "sides")
    for y in ((-d / 2 + 0.03, -d * 0.22), (d * 0.18, face - 0.025)):
        b.cushion((-w * 0.46, w * 0.46), y, (high, h * 0.95), "fabric_a8d5e8", "pad", 0.8)
    b.cushion((-w * 0.46, w * 0.46), (-d * 0.24, d * 0.2), (high, h * 0.9), "fabric_a8d5e8", "pad", 0.6)
    b.ball((w * 0.22, -d * 0.02, h * 0.93), (0.065, 0.06, 0.06), "fabric_f0cfae", "baby", 12)
    b.cushion(
        (-w * 0.1, w * 0.15), (-d * 0.02 - 0.08, -d * 0.02 + 0.08), (h * 0.88, h * 0.98), "fabric_f2e08f", "baby", 0.9
    )
    for side in (-1, 1):
        b.rod(
            (-w * 0.08, -d * 0.02 + side * 0.04, h * 0.92),
            (-w * 0.24, -d * 0.02 + side * 0.08, h * 0.92),
            0.03,
            "fabric_f0cfae",
            "baby",
            8,
        )
        b.rod(
            (w * 0.1, -d * 0.02 + side * 0.07, h * 0.93),
            (w * 0.16, -d * 0.02 + side * 0.16, h * 0.93),
            0.022,
            "fabric_f0cfae",
            "baby",
            8,
        )


@recipe("changing_shelf")
def changing_shelf(b: Builder) -> None:
    """A shelf folded down from the wall with a hollow bed, a strap, a baby on it, and the sign of one behind it."""
    w, d, h = b.w, b.d, b.h
    back = -d / 2
    b.cushion((-w / 2, w / 2), (back, back + 0.1), (0, h), b.mat(), "back", 0.3)
    b.box((-w * 0.47, w * 0.47), (back + 0.1, d / 2), (0, 0.05), b.mat(), "bed")
    for x in ((-w * 0.47, -w * 0.41), (w * 0.41, w * 0.47)):
        b.box(x, (back + 0.1, d / 2), (0.05, 0.1), b.mat(), "rims")
    b.box((-w * 0.47, w * 0.47), (d / 2 - 0.05, d / 2), (0.05, 0.09), b.mat(), "rims")
    b.box((-w * 0.41, w * 0.41), (back + 0.1, d / 2 - 0.05), (0.05, 0.062), "fabric_8fc1d9", "pad", solid=False)
    y, z = d * 0.12, 0.062
    b.ball((w * 0.26, y, z + 0.055), (0.065, 0.06, 0.055), "fabric_f0cfae", "baby", 12)
    b.cushion((-w * 0.08, w * 0.19), (y - 0.07, y + 0.07), (z, z + 0.1), "fabric_f2e08f", "baby", 0.9)
    for side in (-1, 1):
        b.rod(
            (-w * 0.06, y + side * 0.04, z + 0.04),
            (-w * 0.2, y + side * 0.09, z + 0.04),
            0.028,
            "fabric_f0cfae",
            "baby",
            8,
        )
        b.rod(
            (w * 0.14, y + side * 0.06, z + 0.05),
            (w * 0.18, y + side * 0.14, z + 0.05),
            0.02,
            "fabric_f0cfae",
            "baby",
            8,
        )
    b.box((w * 0.02, w * 0.08), (back + 0.1, d / 2 - 0.05), (z + 0.085, z + 0.108), "fabric_dark", "strap", solid=False)
    face = DrawnFace.front(b, back + 0.1)
    face.disc(-w * 0.24, h * 0.74, h * 0.09, "plastic_2f5fa8", "sign", 0.006)
    face.field((-w * 0.13, w * 0.14), (h * 0.66, h * 0.8), "plastic_2f5fa8", "sign", 0.006)
    face.line([(w * 0.14, h * 0.72), (w * 0.26, h * 0.84)], 0.02, "plastic_2f5fa8", "sign")
    face.line([(w * 0.14, h * 0.7), (w * 0.28, h * 0.7)], 0.02, "plastic_2f5fa8", "sign")


@recipe("high_chair")
def high_chair(b: Builder) -> None:
    """A child's chair on four tall legs that splay, with a tray before it, a step for feet, arms and red straps."""
    w, d, h = b.w, b.d, b.h
    seat = float(b.p.get("seat", h * 0.58))
    _high_chair_frame(b, seat)
    b.box((-w * 0.38, w * 0.38), (-d * 0.32, d * 0.28), (seat - 0.03, seat), b.mat(), "seat")
    _high_chair_back(b, seat)
    _high_chair_tray(b, seat)
    b.box((-w * 0.34, w * 0.34), (d * 0.3, d * 0.46), (seat * 0.42, seat * 0.46), b.mat(), "step")


def _high_chair_frame(b: Builder, seat: float) -> None:
    """Four legs that splay, rails between them, and arms."""
    w, d = b.w, b.d
    for sx in (-1, 1):
        for sy in (-1, 1):
            b.rod(
                (sx * w * 0.46, sy * d * 0.46, 0),
                (sx * w * 0.34, sy * d * 0.28, seat),
                0.02,
                b.mat(),
                "legs",
                10,
                solid=True,
            )
        b.rod(
            (sx * w * 0.43, -d * 0.41, seat * 0.28), (sx * w * 0.43, d * 0.41, seat * 0.28), 0.013, b.mat(), "rails", 8
        )
        b.box(
            (sx * w * 0.38 - 0.015, sx * w * 0.38 + 0.015),
            (-d * 0.28, d * 0.24),
            (seat + 0.17, seat + 0.2),
            b.mat(),
            "arms",
        )
        b.box((sx * w * 0.38 - 0.012, sx * w * 0.38 + 0.012), (d * 0.16, d * 0.2), (seat, seat + 0.17), b.mat(), "arms")


def _high_chair_back(b: Builder, seat: float) -> None:
    """A padded back with two red straps."""
    w, d, h = b.w, b.d, b.h
    b.prism(
        [(-d * 0.34, seat), (-d * 0.28, seat), (-d * 0.34, h), (-d * 0.4, h)],
        (-w * 0.36, w * 0.36),
        b.mat(),
        part="back",
    )
    b.cushion((-w * 0.3, w * 0.3), (-d * 0.28, -d * 0.2), (seat + 0.04, h - 0.06), "fabric_8fc1d9", "pad", 0.4)
    for side in (-1, 1):
        b.rod(
            (side * w * 0.14, -d * 0.19, h - 0.12),
            (side * w * 0.06, -d * 0.1, seat + 0.01),
            0.012,
            "fabric_red",
            "straps",
            6,
        )


def _high_chair_tray(b: Builder, seat: float) -> None:
    """A tray with a rim, and a bowl on it."""
    w, d = b.w, b.d
    tray = (seat + 0.2, seat + 0.225)
    b.cushion((-w / 2, w / 2), (d * 0.02, d / 2), tray, "plastic_white", "tray", 0.5)
    for x, y in (
        ((-w / 2, w / 2), (d * 0.47, d / 2)),
        ((-w / 2, -w * 0.46), (d * 0.04, d / 2)),
        ((w * 0.46, w / 2), (d * 0.04, d / 2)),
    ):
        b.box(x, y, (tray[0], tray[1] + 0.02), "plastic_white", "tray")
    b.lathe(
        [(0.05, tray[1]), (0.07, tray[1] + 0.04), (0.062, tray[1] + 0.04), (0.045, tray[1] + 0.01)],
        "plastic_orange",
        (w * 0.12, d * 0.26),
        "bowl",
        16,
    )


@recipe("stroller")
def stroller(b: Builder) -> None:
    """Pram with hood and handle."""
    w, d, h = b.w, b.d, b.h
    b.wheels(0.11, 0.06)
    b.cushion((-w * 0.4, w * 0.4), (-d * 0.3, d * 0.4), (0.42, 0.72), b.mat(), "seat", 0.6, 12)
    b.ball((0, -d * 0.12, 0.78), (w * 0.4, d * 0.24, 0.2), b.mat(), "hood", 12)
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.03)
        b.path([(x, d * 0.42, 0.12), (x, -d * 0.3, 0.7), (x, -d / 2 + 0.02, h - 0.02)], 0.013, "metal_dark", "frame")
        b.rod((x, -d * 0.42, 0.12), (x, d * 0.1, 0.5), 0.013, "metal_dark", "frame")
    b.rod((-w / 2, -d / 2 + 0.02, h - 0.02), (w / 2, -d / 2 + 0.02, h - 0.02), 0.016, "rubber_black", "handle")
    b.box((-w * 0.35, w * 0.35), (-d * 0.3, d * 0.3), (0.18, 0.28), "fabric_dark", "basket")
