"""Terminals that people serve themselves at: a checkout, a charging tower, a place for information, a cash machine."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


def _tilted_screen(
    b: Builder, low: tuple[float, float], high: tuple[float, float], half: float, material: str
) -> DrawnFace:
    """Add a screen between two level lines (y, z), and return its face."""
    (y0, z0), (y1, z1) = low, high
    b.prism(
        [(y0, z0), (y0, z0 + 0.02), (y1 + 0.01, z1), (y1 - 0.05, z1), (y0 - 0.06, z0)],
        (-half, half),
        b.mat(),
        part="head",
    )
    face = DrawnFace.sloped(b, (y0, z0 + 0.02), (y1 + 0.01, z1))
    tall = math.dist((y0, z0 + 0.02), (y1 + 0.01, z1))
    face.field((-half * 0.92, half * 0.92), (tall * 0.05, tall * 0.95), material, "screen", 0.003)
    return face


@recipe("self_checkout")
def self_checkout(b: Builder) -> None:
    """A scanner under a screen, a card reader with its slip, a lamp on a pole, and a stand with a bag of food."""
    w, d, h = b.w, b.d, b.h
    desk = h * 0.56
    b.box((0.0, w / 2), (-d * 0.4, d * 0.3), (0, desk), b.mat(), "cabinet")
    b.box((-0.02, w / 2), (-d * 0.44, d * 0.4), (desk, desk + 0.04), "metal_steel", "desk")
    top = DrawnFace.top(b, desk + 0.04)
    top.field((-w * 0.42, -w * 0.08), (-d * 0.3, d * 0.0), "glass_black", "scanner", 0.004)
    top.line([(-w * 0.38, -d * 0.15), (-w * 0.12, -d * 0.15)], 0.008, "light_red", "scanner")
    _tilted_screen(b, (d * 0.0, desk + 0.14), (-d * 0.24, h * 0.94), w * 0.24, "screen_2f7f4f")
    b.box((w * 0.22, w * 0.28), (-d * 0.3, -d * 0.2), (desk, h * 0.8), "metal_dark", "pole")
    b.rod((w * 0.44, -d * 0.3, desk), (w * 0.44, -d * 0.3, h * 0.96), 0.014, "metal_chrome", "lamp", 8)
    b.cyl(w * 0.44, -d * 0.3, (h * 0.94, h), 0.035, "light_green", "lamp", n=14)
    panel = DrawnFace.front(b, d * 0.3)
    panel.field((-w * 0.42, -w * 0.08), (desk * 0.62, desk * 0.9), "plastic_dark", "payment", 0.02)
    panel.field((-w * 0.36, -w * 0.22), (desk * 0.68, desk * 0.72), "plastic_black", "payment", 0.026)
    panel.field((-w * 0.36, -w * 0.14), (desk * 0.78, desk * 0.86), "light_4f9bf0", "payment", 0.024)
    b.prism(
        [(d * 0.3, desk * 0.55), (d * 0.3, desk * 0.56), (d * 0.4, desk * 0.44), (d * 0.4, desk * 0.43)],
        (w * 0.16, w * 0.28),
        "paper_white",
        part="slip",
    )
    b.box((-w / 2, -0.04), (-d * 0.4, d * 0.4), (0, 0.06), "metal_dark", "stand")
    b.box((-w * 0.28, -w * 0.22), (-d * 0.36, -d * 0.28), (0.06, h * 0.86), "metal_dark", "stand")
    b.box((-w / 2, -0.04), (-d * 0.36, d * 0.4), (h * 0.36, h * 0.38), "metal_steel", "stand")
    b.prism(
        [(-w * 0.44, h * 0.38), (-w * 0.1, h * 0.38), (-w * 0.06, h * 0.62), (-w * 0.48, h * 0.62)],
        (-d * 0.2, d * 0.26),
        "paper_c9a06a",
        "y",
        "bag",
    )
    for x, z, color in ((-0.36, 0.66, "plastic_green"), (-0.24, 0.68, "plastic_red"), (-0.14, 0.66, "plastic_yellow")):
        b.cyl(w * x, d * 0.04, (h * 0.6, h * z), 0.045, color, "goods", n=10)
    b.rod((-w * 0.2, -d * 0.1, h * 0.58), (-w * 0.16, -d * 0.1, h * 0.76), 0.03, "food_c8842f", "goods", 10)


@recipe("charging_tower")
def charging_tower(b: Builder) -> None:
    """A column with a bolt of lightning in a lit sign, and shelves round it where telephones lie on their cables."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.05), "metal_dark", "foot")
    b.box((-w * 0.2, w * 0.2), (-d * 0.2, d * 0.2), (0.05, h * 0.66), b.mat(), "column")
    b.box((-w * 0.36, w * 0.36), (-d * 0.1, d * 0.1), (h * 0.66, h), b.mat(), "head")
    bolt = ((0.1, 1.0), (-0.55, -0.15), (0.0, -0.1), (-0.15, -1.0), (0.55, 0.2), (0.0, 0.15))
    face = DrawnFace.front(b, d * 0.1)
    face.field((-w * 0.33, w * 0.33), (h * 0.68, h * 0.98), "light_4f9bf0", "sign", 0.006)
    middle, r = h * 0.83, h * 0.13
    for part in ((0, 1, 2, 5), (2, 3, 4, 5)):
        outline = [(bolt[k][0] * r, middle + bolt[k][1] * r) for k in part]
        b.prism(outline, (d * 0.1 + 0.006, d * 0.1 + 0.012), "light_yellow", "y", "sign")
    for level in range(2):
        z = h * (0.34 + 0.24 * level)
        b.box((-w * 0.44, w * 0.44), (-d * 0.44, d * 0.44), (z - 0.02, z), "plastic_white", "shelves")
        for k in range(3):
            x = w * (-0.28 + 0.28 * k)
            b.prism(
                [(d * 0.22, z), (d * 0.26, z), (d * 0.2, z + 0.13), (d * 0.18, z + 0.13)],
                (x - 0.035, x + 0.035),
                "plastic_black",
                part="telephones",
            )
            screen = DrawnFace.sloped(b, (d * 0.26, z), (d * 0.2, z + 0.13))
            screen.field(
                (-x - 0.03, -x + 0.03),
                (0.01, 0.12),
                ("light_green", "screen_3f8fd0", "light_orange")[(k + level) % 3],
                "telephones",
                0.002,
            )
            b.path(
                [
                    (x, d * 0.24, z + 0.004),
                    (x + 0.03, d * 0.38, z + 0.006),
                    (x, d * 0.43, z - 0.05),
                    (x * 0.4, d * 0.2, z - 0.1),
                ],
                0.006,
                "plastic_white",
                "cables",
            )
            side = d * (-0.24 + 0.24 * k)
            b.prism(
                [(w * 0.24, z), (w * 0.28, z), (w * 0.22, z + 0.13), (w * 0.2, z + 0.13)],
                (side - 0.035, side + 0.035),
                "plastic_black",
                "y",
                "telephones",
            )


@recipe("info_kiosk")
def info_kiosk(b: Builder) -> None:
    """A tilted touch screen on a column, with a plan on it, under a round blue sign with a white i."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.04), "metal_dark", "foot")
    b.box((-w * 0.18, w * 0.18), (-d * 0.3, d * 0.1), (0.04, h * 0.6), b.mat(), "column")
    face = _tilted_screen(b, (d * 0.44, h * 0.54), (-d * 0.2, h * 0.82), w / 2, "screen_e9f0f4")
    tall = math.hypot(d * 0.64, h * 0.28)
    face.field((-w * 0.4, w * 0.4), (tall * 0.8, tall * 0.9), "light_4f9bf0", "plan", 0.005)
    for k, color in enumerate(("red", "green", "yellow", "blue")):
        u, v = w * (-0.38 + 0.4 * (k % 2)), tall * (0.14 + 0.32 * (k // 2))
        face.field((u, u + w * 0.34), (v, v + tall * 0.26), f"plastic_{color}", "plan", 0.005)
    b.box((-0.02, 0.02), (-d * 0.26, -d * 0.18), (h * 0.7, h * 0.88), b.mat(), "post")
    r, z = h * 0.085, h - h * 0.085
    b.rod((0, -d * 0.26, z), (0, -d * 0.14, z), r, "paint_2f6fd0", "sign", 28)
    sign = DrawnFace.front(b, -d * 0.14)
    sign.field((-r * 0.16, r * 0.16), (z - r * 0.6, z + r * 0.2), "plastic_white", "sign", 0.006)
    sign.disc(0, z + r * 0.5, r * 0.18, "plastic_white", "sign", 0.006)


@recipe("cash_machine")
def cash_machine(b: Builder) -> None:
    """A cabinet under a lit sign ATM: a screen between keys, a pad of figures, a card in its slot, and notes."""
    w, d, h = b.w, b.d, b.h
    face, ledge = d / 2 - 0.16, h * 0.52
    b.box((-w / 2, w / 2), (-d / 2, face), (0.04, h * 0.84), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0.04, ledge - 0.06), b.mat(), "case")
    b.prism(
        [(face, ledge - 0.06), (d / 2, ledge - 0.06), (face, ledge + 0.02)],
        (-w / 2, w / 2),
        "metal_light",
        part="ledge",
    )
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.84, h), b.mat(), "head")
    b.box((-w * 0.46, w * 0.46), (-d * 0.46, d * 0.44), (0, 0.04), "metal_dark", "foot")
    sign = DrawnFace.front(b, d / 2)
    sign.field((-w * 0.48, w * 0.48), (h * 0.85, h * 0.99), "light_white", "sign", 0.004)
    sign.write("ATM", (-w * 0.4, w * 0.4), (h * 0.865, h * 0.975), "paint_2f3f8f", "letters", 0.008)
    DrawnFace.side(b, w / 2).write(
        "ATM", (-d * 0.36, d * 0.36), (h * 0.865, h * 0.975), "plastic_white", "letters", 0.004
    )
    panel = DrawnFace.front(b, face)
    panel.field((-w * 0.3, w * 0.22), (ledge + 0.08, h * 0.81), "screen_2f6fd0", "screen", 0.006)
    for k in range(4):
        v = ledge + 0.11 + (h * 0.8 - ledge - 0.12) * k / 4
        panel.field((-w * 0.26, w * (0.04 - 0.06 * (k % 2))), (v, v + 0.02), "light_white", "screen", 0.009)
        for u in (-0.37, 0.25):
            panel.field((w * u, w * (u + 0.06)), (v - 0.005, v + 0.03), "metal_chrome", "keys", 0.014)
    panel.field((w * 0.34, w * 0.47), (h * 0.7, h * 0.73), "plastic_black", "card", 0.012)
    b.box((-w * 0.45, -w * 0.36), (face, face + 0.08), (h * 0.711, h * 0.719), "plastic_green", "card")
    slope = DrawnFace.sloped(b, (d / 2, ledge - 0.06), (face, ledge + 0.02))
    for k in range(12):
        u, v = w * (-0.3 + 0.085 * (k % 3)), 0.02 + 0.035 * (k // 3)
        color = "plastic_light" if k % 3 < 2 or k > 8 else ("plastic_red", "plastic_yellow", "plastic_green")[k // 3]
        slope.field((u, u + w * 0.07), (v, v + 0.027), color, "pad", 0.008)
    front = DrawnFace.front(b, d / 2)
    front.field((-w * 0.36, w * 0.36), (ledge - 0.2, ledge - 0.13), "plastic_black", "notes", 0.006)
    b.prism(
        [
            (d / 2 - 0.02, ledge - 0.17),
            (d / 2 - 0.02, ledge - 0.15),
            (d / 2 + 0.09, ledge - 0.17),
            (d / 2 + 0.09, ledge - 0.19),
        ],
        (-w * 0.24, w * 0.24),
        "paper_7fae7a",
        part="notes",
    )
