"""Tills, and the terminals at which people serve themselves."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("register")
def register(b: Builder) -> None:
    """Till: drawer, sloped keyboard, display."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.3), b.mat(), "drawer")
    b.prism(
        [(-d / 2, h * 0.3), (d * 0.4, h * 0.3), (d * 0.4, h * 0.38), (-d * 0.1, h * 0.6), (-d / 2, h * 0.6)],
        (-w * 0.46, w * 0.46),
        "plastic_dark",
        part="body",
    )
    b.box((-w * 0.35, w * 0.35), (-d * 0.4, -d * 0.3), (h * 0.6, h), "plastic_black", "display")
    b.box((-w * 0.32, w * 0.32), (-d * 0.3, -d * 0.29), (h * 0.68, h * 0.96), "screen_green", "display", solid=False)


@recipe("till_belt")
def till_belt(b: Builder) -> None:
    """A checkout: a black belt, a scanner let into its top, a cash desk behind it, and CHECKOUT on its front."""
    w, d, h = b.w, b.d, b.h
    back = -d / 2 + 0.34
    b.box((-w / 2, w / 2), (back, d / 2), (0.06, h - 0.05), b.mat(), "body")
    b.box((-w / 2, w / 2), (back, d / 2), (h - 0.05, h), "metal_steel", "top")
    b.box((-w / 2 + 0.04, w / 2 - 0.04), (back + 0.04, d / 2 - 0.04), (0, 0.06), "metal_dark", "plinth")
    b.box((-0.45, 0.45), (-d / 2, back), (0.05, h * 0.72), b.mat(), "cash")
    top = DrawnFace.top(b, h)
    top.field((-0.3, w / 2 - 0.06), (-d / 2 + 0.08, d / 2 - 0.46), "rubber_black", "belt", 0.003)
    for k in range(6):
        u = -0.26 + k * (w / 2 + 0.16) / 5.4
        top.field((u, u + 0.012), (-d / 2 + 0.08, d / 2 - 0.46), "plastic_dark", "belt", 0.005)
    top.field((-0.62, -0.34), (-d / 2 + 0.12, d / 2 - 0.5), "metal_chrome", "scanner", 0.004)
    top.field((-0.56, -0.4), (-d / 2 + 0.2, -d / 2 + 0.4), "glass_black", "scanner", 0.006)
    face = DrawnFace.front(b, d / 2)
    face.field((-w / 2, w / 2), (h * 0.62, h * 0.7), "paint_red", "stripe", 0.004)
    face.write("CHECKOUT", (-w * 0.3, w * 0.3), (h * 0.28, h * 0.5), "paint_red", "letters", 0.004)


@recipe("card_terminal")
def card_terminal(b: Builder) -> None:
    """A payment terminal: a sloped face with a screen and keys, three of them red, yellow and green, a card."""
    w, d, h = b.w, b.d, b.h
    back, y0, y1 = -d * 0.3, -d * 0.3, d * 0.3
    b.prism(
        [(back - d * 0.16, 0), (y1, 0), (y1, h * 0.34), (y0, h * 0.7), (back - d * 0.16, h * 0.7)],
        (-w / 2, w / 2),
        b.mat(),
        part="case",
    )
    face = DrawnFace.sloped(b, (y1, h * 0.34), (y0, h * 0.7))
    face.field((-w * 0.42, w * 0.42), (d * 0.36, d * 0.58), "screen_green", "screen", h * 0.03)
    for k in range(12):
        u, v = w * (-0.4 + 0.28 * (k % 3)), d * (0.12 + 0.055 * (k // 3))
        face.field((u, u + w * 0.23), (v, v + d * 0.04), "plastic_light", "keys", h * 0.08)
    for k, color in enumerate(("red", "yellow", "green")):
        u = w * (-0.4 + 0.28 * k)
        face.field((u, u + w * 0.23), (d * 0.05, d * 0.1), f"plastic_{color}", "keys", h * 0.1)
    b.box((-w * 0.42, w * 0.42), (d * 0.1, d / 2), (h * 0.08, h * 0.14), "plastic_3d6ac8", "card")
    b.box((-w * 0.3, -w * 0.1), (d * 0.36, d * 0.44), (h * 0.14, h * 0.15), "metal_brass", "card", solid=False)
    paper = [
        (back - d * 0.06, h * 0.68),
        (back - d * 0.04, h * 0.68),
        (back - d * 0.16, h * 1.5),
        (back - d * 0.2, h * 1.48),
    ]
    b.prism(paper, (-w * 0.34, w * 0.34), "paper_white", part="receipt")
    sheet = DrawnFace.sloped(b, (back - d * 0.04, h * 0.68), (back - d * 0.16, h * 1.5))
    for k in range(5):
        v = h * (0.2 + 0.13 * k)
        sheet.field((-w * 0.28, w * (0.0 + 0.1 * (k % 3))), (v, v + h * 0.05), "paper_dark", "receipt", h * 0.01)


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
    _cash_machine_sign(b)
    _cash_machine_panel(b, face, ledge)
    _figure_pad(b, face, ledge)
    _banknotes(b, ledge)


def _cash_machine_sign(b: Builder) -> None:
    """The word ATM on a lit sign in front, and on a side."""
    w, d, h = b.w, b.d, b.h
    sign = DrawnFace.front(b, d / 2)
    sign.field((-w * 0.48, w * 0.48), (h * 0.85, h * 0.99), "light_white", "sign", 0.004)
    sign.write("ATM", (-w * 0.4, w * 0.4), (h * 0.865, h * 0.975), "paint_2f3f8f", "letters", 0.008)
    DrawnFace.side(b, w / 2).write(
        "ATM", (-d * 0.36, d * 0.36), (h * 0.865, h * 0.975), "plastic_white", "letters", 0.004
    )


def _cash_machine_panel(b: Builder, face: float, ledge: float) -> None:
    """A screen between keys, and a card in its slot."""
    w, h = b.w, b.h
    panel = DrawnFace.front(b, face)
    panel.field((-w * 0.3, w * 0.22), (ledge + 0.08, h * 0.81), "screen_2f6fd0", "screen", 0.006)
    for k in range(4):
        v = ledge + 0.11 + (h * 0.8 - ledge - 0.12) * k / 4
        panel.field((-w * 0.26, w * (0.04 - 0.06 * (k % 2))), (v, v + 0.02), "light_white", "screen", 0.009)
        for u in (-0.37, 0.25):
            panel.field((w * u, w * (u + 0.06)), (v - 0.005, v + 0.03), "metal_chrome", "keys", 0.014)
    panel.field((w * 0.34, w * 0.47), (h * 0.7, h * 0.73), "plastic_black", "card", 0.012)
    b.box((-w * 0.45, -w * 0.36), (face, face + 0.08), (h * 0.711, h * 0.719), "plastic_green", "card")


def _figure_pad(b: Builder, face: float, ledge: float) -> None:
    """A pad of twelve keys on the ledge."""
    w, d = b.w, b.d
    slope = DrawnFace.sloped(b, (d / 2, ledge - 0.06), (face, ledge + 0.02))
    for k in range(12):
        u, v = w * (-0.3 + 0.085 * (k % 3)), 0.02 + 0.035 * (k // 3)
        color = "plastic_light" if k % 3 < 2 or k > 8 else ("plastic_red", "plastic_yellow", "plastic_green")[k // 3]
        slope.field((u, u + w * 0.07), (v, v + 0.027), color, "pad", 0.008)


def _banknotes(b: Builder, ledge: float) -> None:
    """Notes in a slot below the ledge."""
    w, d = b.w, b.d
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


@recipe("ticket_machine")
def ticket_machine(b: Builder) -> None:
    """A cabinet under a lit sign TICKETS: a screen, slots for coins, notes and cards, keys."""
    w, d, h = b.w, b.d, b.h
    front = d / 2 - 0.06
    b.box((-w * 0.48, w * 0.48), (-d / 2, front - 0.03), (0, 0.05), "metal_dark", "foot")
    b.box((-w / 2, w / 2), (-d / 2, front), (0.05, h * 0.86), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.86, h), b.mat(), "head")
    sign = DrawnFace.front(b, d / 2)
    sign.field((-w * 0.48, w * 0.48), (h * 0.87, h * 0.99), "light_white", "sign", 0.004)
    sign.write("TICKETS", (-w * 0.45, w * 0.45), (h * 0.89, h * 0.97), "paint_2f3f8f", "letters", 0.007)
    side = DrawnFace.side(b, w / 2)
    side.write("TICKETS", (-d * 0.46, d * 0.34), (h * 0.89, h * 0.97), "plastic_white", "letters", 0.004)
    face = DrawnFace.front(b, front)
    face.field((-w * 0.44, w * 0.44), (h * 0.26, h * 0.84), "metal_light", "panel", 0.006)
    face.field((-w * 0.4, w * 0.12), (h * 0.58, h * 0.82), "plastic_black", "screen", 0.01)
    face.field((-w * 0.38, w * 0.1), (h * 0.59, h * 0.81), "screen_blue", "screen", 0.012)
    face.field((w * 0.18, w * 0.4), (h * 0.72, h * 0.75), "plastic_black", "notes", 0.02)
    face.field((w * 0.18, w * 0.4), (h * 0.755, h * 0.8), "light_green", "notes", 0.01)
    face.field((w * 0.28, w * 0.3), (h * 0.6, h * 0.68), "plastic_black", "coins", 0.02)
    face.disc(w * 0.29, h * 0.64, w * 0.08, "metal_brass", "coins", 0.012)
    for k in range(12):
        u, v = w * (-0.36 + 0.09 * (k % 3)), h * (0.4 + 0.04 * (k // 3))
        face.field((u, u + w * 0.07), (v, v + h * 0.03), "plastic_dark", "keys", 0.014)
    face.field((w * 0.02, w * 0.36), (h * 0.47, h * 0.5), "plastic_black", "card", 0.02)
    b.box((-w * 0.3, -w * 0.08), (front, front + 0.07), (h * 0.482, h * 0.488), "paint_yellow", "card")
    face.field((-w * 0.38, w * 0.38), (h * 0.28, h * 0.37), "plastic_black", "tray", 0.012)
    b.prism(
        [(front + 0.01, h * 0.32), (front + 0.01, h * 0.33), (d / 2 + 0.02, h * 0.29), (d / 2 + 0.02, h * 0.28)],
        (-w * 0.12, w * 0.16),
        "paper_f3c64a",
        part="ticket",
    )
    face.field((-w * 0.34, w * 0.34), (h * 0.1, h * 0.2), "plastic_white", "train", 0.004)
    for k in range(4):
        u = w * (-0.28 + 0.145 * k)
        face.field((u, u + w * 0.11), (h * 0.145, h * 0.185), "plastic_2f3f8f", "train", 0.006)
    for u in (-w * 0.2, w * 0.2):
        face.disc(u, h * 0.1, w * 0.05, "plastic_black", "train", 0.006)


@recipe("vending")
def vending(b: Builder) -> None:
    """Machine with a lit window of goods, keypad and hatch."""
    w, d, h = b.w, b.d, b.h
    f = d / 2
    b.box((-w / 2, w / 2), (-d / 2, f - 0.05), (0.05, h), b.mat(), "case")
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2 + 0.03, f - 0.08), (0, 0.05), "metal_dark", "feet")
    b.box((w * 0.18, w / 2), (f - 0.05, f), (0.05, h), b.mat(), "front")
    b.box((-w / 2, -w * 0.44), (f - 0.05, f), (0.05, h), b.mat(), "front")
    for band in ((0.05, h * 0.3), (h * 0.93, h)):
        b.box((-w * 0.44, w * 0.18), (f - 0.05, f), band, b.mat(), "front")
    b.box((-w * 0.44, w * 0.18), (f - 0.049, f - 0.045), (h * 0.3, h * 0.93), "light_white", "window", solid=False)
    for row in range(5):
        for col in range(5):
            x, z = -w * 0.41 + col * w * 0.115, h * 0.32 + row * h * 0.12
            b.box(
                (x, x + w * 0.08),
                (f - 0.045, f - 0.01),
                (z, z + h * 0.08),
                ("paper_red", "paper_yellow", "paper_blue", "paper_green", "paper_orange")[(row * 2 + col) % 5],
                "goods",
                solid=False,
            )
    b.box((-w * 0.36, w * 0.1), (f - 0.002, f), (h * 0.12, h * 0.22), "plastic_black", "hatch", solid=False)
    b.box((w * 0.25, w * 0.42), (f - 0.002, f), (h * 0.6, h * 0.72), "screen_green", "keypad", solid=False)
