"""Screens, score boards and projectors."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("screen")
def screen(b: Builder) -> None:
    """Monitor or wall display."""
    w, d, h = b.w, b.d, b.h
    if b.p.get("style") == "wall":
        low, y0, y1 = 0.0, -d / 2, d / 2
    else:
        low = h * (0.14 if h > 0.55 else 0.2)
        thick = min(0.05, d * 0.3)
        y0, y1 = -thick / 2, thick / 2
        b.box((-w * 0.26, w * 0.26), (-d / 2, d / 2), (0, 0.015), "plastic_black", "foot")
        b.box((-0.03, 0.03), (y0 - 0.012, y0 + 0.01), (0.01, low + h * 0.3), "plastic_black", "stand", solid=False)
    b.box((-w / 2, w / 2), (y0, y1 - 0.006), (low, h), b.mat(), "case")
    edge = min(0.016, w * 0.03)
    b.box((-w / 2, w / 2), (y1 - 0.006, y1), (low, low + edge), b.mat(), "frame", solid=False)
    b.box(
        (-w / 2 + edge, w / 2 - edge),
        (y1 - 0.006, y1 - 0.002),
        (low + edge, h - edge),
        "screen_dark",
        "screen",
        solid=False,
    )
    b.box(
        (-w * 0.42, w * 0.1),
        (y1 - 0.002, y1 - 0.0012),
        (low + (h - low) * 0.45, h - (h - low) * 0.14),
        "screen_blue",
        "screen",
        solid=False,
    )
    b.box(
        (w * 0.16, w * 0.42),
        (y1 - 0.002, y1 - 0.0012),
        (low + (h - low) * 0.2, h - (h - low) * 0.14),
        "screen_light",
        "screen",
        solid=False,
    )


@recipe("television")
def television(b: Builder) -> None:
    """A thin set on two splayed feet, on which a newsreader speaks above a red bar that says NEWS."""
    w, d, h = b.w, b.d, b.h
    low, thick = h * 0.1, min(0.04, d * 0.3)
    face, edge = thick / 2, min(0.012, w * 0.02)
    for x in (-w * 0.34, w * 0.34):
        for y in (-d / 2 + 0.006, d / 2 - 0.006):
            b.rod((x, 0, low + 0.01), (x, y, 0.006), 0.006, b.mat(), "feet")
    b.box((-w / 2, w / 2), (-face, face), (low, h), b.mat(), "case")
    b.box((-w * 0.34, w * 0.34), (-face - min(0.03, d * 0.15), -face), (low, low + (h - low) * 0.5), b.mat(), "back")
    inside, up = (-w / 2 + edge, w / 2 - edge), (low + edge * 1.6, h - edge)
    b.box(inside, (face - 0.001, face + 0.0008), up, "picture_map", "screen", solid=False)
    _newsreader(DrawnFace.front(b, face), inside[1], up)


def _newsreader(face: DrawnFace, half: float, up: tuple[float, float]) -> None:
    """Head and shoulders of somebody in a suit, and the bars of a news programme below."""
    low, tall = up[0], up[1] - up[0]
    u, r = half * 0.3, tall * 0.15
    for k in range(6):
        wide = tall * (0.17 + 0.03 * (5 - k) ** 0.7)
        face.field((u - wide, u + wide), (low + tall * 0.07 * k, low + tall * 0.07 * (k + 1)), "screen_1f2f4f", "suit")
    face.field((u - r * 0.4, u + r * 0.4), (low + tall * 0.3, low + tall * 0.48), "screen_f4f4f4", "suit", 0.003)
    face.field((u - r * 0.14, u + r * 0.14), (low + tall * 0.2, low + tall * 0.44), "screen_c8201e", "suit", 0.004)
    face.disc(u, low + tall * 0.7, r * 1.1, "screen_4a2a16", "head", 0.003, 20)
    face.disc(u, low + tall * 0.64, r, "screen_e8b48c", "head", 0.004, 20)
    for side in (-1, 1):
        face.disc(u + side * r * 0.4, low + tall * 0.67, r * 0.12, "screen_2a1a10", "head", 0.005, 8)
    face.field((u - r * 0.36, u + r * 0.36), (low + tall * 0.56, low + tall * 0.58), "screen_a03030", "head", 0.005)
    face.field((-half, half), (low, low + tall * 0.1), "screen_f4f4f4", "bars", 0.005)
    face.field((-half, half), (low + tall * 0.1, low + tall * 0.34), "screen_c8201e", "bars", 0.005)
    face.write(
        "NEWS", (-half * 0.92, half * 0.1), (low + tall * 0.13, low + tall * 0.31), "screen_ffffff", "letters", 0.007
    )
    face.field((-half * 0.9, half * 0.7), (low + tall * 0.035, low + tall * 0.065), "screen_5a6470", "bars", 0.006)


@recipe("menu_screen")
def menu_screen(b: Builder) -> None:
    """A screen above a counter that shows a burger, a cup and chips with their prices under the word MENU."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.006), (0, h), b.mat(), "case")
    face = DrawnFace.front(b, d / 2 - 0.006)
    face.field((-w * 0.48, w * 0.48), (h * 0.05, h * 0.95), "screen_3a1f14", "screen", 0.002)
    face.write("MENU", (-w * 0.24, w * 0.24), (h * 0.73, h * 0.92), "light_yellow", "letters", 0.004)
    left, middle, right, low = -w * 0.31, 0.0, w * 0.31, h * 0.32
    for v, color, thick in (
        (0.0, "light_d9a05a", 0.08),
        (0.09, "light_7a3f1d", 0.06),
        (0.16, "light_6fbf4a", 0.03),
        (0.2, "light_red", 0.04),
    ):
        face.field((left - w * 0.1, left + w * 0.1), (low + h * v, low + h * (v + thick)), color, "burger", 0.004)
    for k in range(3):
        face.field(
            (left - w * (0.1 - 0.02 * k), left + w * (0.1 - 0.02 * k)),
            (low + h * (0.25 + 0.03 * k), low + h * (0.28 + 0.03 * k)),
            "light_d9a05a",
            "burger",
            0.004,
        )
    cup = [
        (middle - w * 0.05, low),
        (middle + w * 0.05, low),
        (middle + w * 0.08, low + h * 0.26),
        (middle - w * 0.08, low + h * 0.26),
    ]
    b.prism([(-u, v) for u, v in cup], (d / 2 - 0.004, d / 2 - 0.001), "light_red", "y", "cup")
    face.field((middle - w * 0.09, middle + w * 0.09), (low + h * 0.26, low + h * 0.3), "light_white", "cup", 0.004)
    face.field((middle + w * 0.01, middle + w * 0.025), (low + h * 0.3, low + h * 0.38), "light_white", "cup", 0.004)
    face.field((right - w * 0.07, right + w * 0.07), (low, low + h * 0.2), "light_red", "chips", 0.005)
    for k in range(5):
        u = right - w * 0.065 + w * 0.027 * k
        face.field(
            (u, u + w * 0.02), (low + h * 0.1, low + h * (0.28 + 0.04 * (k % 2))), "light_f5d04a", "chips", 0.004
        )
    for u, price in ((left, "5:90"), (middle, "2:50"), (right, "3:20")):
        face.write(price, (u - w * 0.12, u + w * 0.12), (h * 0.1, h * 0.24), "light_white", "prices", 0.004)


@recipe("score_board")
def score_board(b: Builder) -> None:
    """A black board with HOME and GUEST over red figures in lamps, and the time between them."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.012), (0, h), b.mat(), "case")
    face = DrawnFace.front(b, d / 2 - 0.012)
    for edge in ((h * 0.02, h * 0.035), (h * 0.965, h * 0.98)):
        face.field((-w * 0.49, w * 0.49), edge, "plastic_white", "frame", 0.004)
    face.write("HOME", (-w * 0.47, -w * 0.14), (h * 0.78, h * 0.93), "plastic_white", "letters", 0.006)
    face.write("GUEST", (w * 0.12, w * 0.47), (h * 0.78, h * 0.93), "plastic_white", "letters", 0.006)
    for u, figure in ((-w * 0.305, "3"), (w * 0.295, "1")):
        face.field((u - w * 0.14, u + w * 0.14), (h * 0.26, h * 0.74), "plastic_200808", "panels", 0.003)
        face.write(figure, (u - w * 0.12, u + w * 0.12), (h * 0.3, h * 0.7), "light_ff3a20", "figures", 0.01)
    face.write(":", (-w * 0.03, w * 0.03), (h * 0.36, h * 0.62), "light_ff3a20", "figures", 0.01)
    face.write("45:00", (-w * 0.2, w * 0.2), (h * 0.06, h * 0.22), "light_yellow", "figures", 0.01)


@recipe("departures_board")
def departures_board(b: Builder) -> None:
    """A wide black board: DEPARTURES in yellow, below it rows of a time, a place and a track."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.012), (0, h), b.mat(), "case")
    face = DrawnFace.front(b, d / 2 - 0.012)
    face.write("DEPARTURES", (-w * 0.46, w * 0.1), (h * 0.82, h * 0.94), "light_yellow", "letters", 0.006)
    face.field((-w * 0.47, w * 0.47), (h * 0.76, h * 0.775), "plastic_white", "frame", 0.004)
    rows = (("09:15", "PARIS", "3"), ("09:42", "ROME", "1"), ("10:05", "BERLIN", "7"), ("10:30", "OSLO", "2"))
    for number, (time, place, track) in enumerate(rows):
        up = (h * (0.62 - 0.18 * number), h * (0.73 - 0.18 * number))
        face.write(time, (-w * 0.46, -w * 0.24), up, "plastic_white", "letters", 0.006)
        face.write(place, (-w * 0.18, -w * 0.18 + 0.07 * w * len(place)), up, "plastic_white", "letters", 0.006)
        face.write(track, (w * 0.4, w * 0.45), up, "light_yellow", "figures", 0.006)


@recipe("ceiling_projector")
def ceiling_projector(b: Builder) -> None:
    """A white box under a pole: a large blue lens in a ring that shines, vents beside it, sockets behind, a lit dot."""
    w, d, h = b.w, b.d, b.h
    high, front = h * 0.48, d / 2 - 0.03
    b.cushion((-w / 2, w / 2), (-d / 2, front), (0, high), b.mat(), "case", 0.25, 12)
    z, x, r = high * 0.5, w * 0.22, high * 0.4
    b.rod((x, front - 0.02, z), (x, d / 2, z), r, "plastic_dark", "lens", 24, solid=True)
    b.rod((x, d / 2 - 0.006, z), (x, d / 2 + 0.001, z), r * 0.82, "plastic_4f8fd9", "lens", 24)
    b.rod((x, d / 2 - 0.004, z), (x, d / 2 + 0.002, z), r * 0.5, "light_dff0ff", "lens", 20)
    face = DrawnFace.front(b, front)
    for k in range(6):
        face.field(
            (w * 0.02, w * 0.42), (high * (0.2 + 0.11 * k), high * (0.25 + 0.11 * k)), "plastic_black", "vents", 0.003
        )
    below = DrawnFace(b, (0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, -1.0, 0.0))
    for k in range(3):
        below.disc(
            (-w * 0.36, w * 0.36, 0.0)[k], (d * 0.3, d * 0.3, -d * 0.3)[k], w * 0.04, "rubber_black", "feet", 0.004
        )
    b.cyl(0, -d * 0.05, (high, h), 0.022, "metal_white", "mount", n=12)
    b.cyl(0, -d * 0.05, (h - 0.02, h), 0.08, "metal_white", "mount", n=20)
    for k in range(3):
        a = k * math.tau / 3
        b.rod(
            (0, -d * 0.05, high * 1.12),
            (math.cos(a) * w * 0.34, -d * 0.05 + math.sin(a) * d * 0.3, high),
            0.012,
            "metal_white",
            "mount",
            8,
        )
    face.disc(-w * 0.42, high * 0.84, 0.008, "light_green", "lamp", 0.004)


@recipe("cinema_screen")
def cinema_screen(b: Builder) -> None:
    """A screen in a black frame between red curtains below a pelmet, with the numbered leader of a film on it."""
    w, d, h = b.w, b.d, b.h
    back, pelmet = -d / 2, h * 0.86
    b.box((-w / 2, w / 2), (back, back + 0.02), (0, h), "plastic_17181b", "frame")
    face = DrawnFace.front(b, back + 0.02)
    half, v = w * 0.35, (h * 0.07, pelmet)
    face.field((-half, half), v, "screen_d8d4c8", "screen", 0.006)
    middle = (h * 0.07 + pelmet) / 2
    face.line([(-half, middle), (half, middle)], h * 0.006, "plastic_3a3a3a", "leader", 0.006)
    face.line([(0.0, v[0]), (0.0, v[1])], h * 0.006, "plastic_3a3a3a", "leader", 0.006)
    for r, color in ((0.37, "3a3a3a"), (0.35, "d8d4c8"), (0.31, "3a3a3a"), (0.29, "d8d4c8")):
        face.disc(0.0, middle, h * r, f"screen_{color}", "leader", 0.008 + 0.02 * (0.4 - r), 36)
    face.write("3", (-h * 0.2, h * 0.2), (middle - h * 0.2, middle + h * 0.2), "plastic_17181b", "number", 0.016)
    for side in (-1, 1):
        for k in range(6):
            x = side * (w / 2 - w * 0.026 * (k + 0.5))
            b.cyl(x, d * 0.06, (0, pelmet), w * 0.017, ("fabric_b0141e", "fabric_8a0f18")[k % 2], "curtains", n=10)
        tie = sorted((side * w / 2, side * w * 0.345))
        b.box((tie[0], tie[1]), (0, d / 2), (h * 0.36, h * 0.4), "metal_brass", "ties", solid=False)
    swags = 7
    for k in range(swags):
        x = -w / 2 + w * (k + 0.5) / swags
        swag = [
            (x - w / swags / 2, h),
            (x - w / swags / 2, h * 0.9),
            (x, h * 0.8),
            (x + w / swags / 2, h * 0.9),
            (x + w / swags / 2, h),
        ]
        b.prism(swag, (d * 0.3, d * 0.5), ("fabric_c01822", "fabric_a0121c")[k % 2], "y", "pelmet", solid=False)
    b.box((-w / 2, w / 2), (back, d / 2), (h * 0.975, h), "metal_brass", "rail")
