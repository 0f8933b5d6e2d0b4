"""Computers, and what belongs to them: keyboards, mice, servers, routers, disks."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("laptop")
def laptop(b: Builder) -> None:
    """Open notebook computer; its screen stands at the back and looks to the front."""
    w, d, h = b.w, b.d, b.h
    base = min(0.022, h * 0.1)
    hinge = -d * 0.28 if h > 0.5 * d else -d / 2 + 0.01
    b.box((-w / 2, w / 2), (hinge, d / 2), (0, base), b.mat(), "base")
    b.box(
        (-w * 0.44, w * 0.44),
        (hinge + 0.02, hinge + d * 0.4),
        (base, base + 0.002),
        "plastic_black",
        "keys",
        solid=False,
    )
    b.box((-w * 0.14, w * 0.14), (d * 0.26, d * 0.46), (base, base + 0.0015), "metal_grey", "pad", solid=False)
    b.prism(
        [(hinge, base), (hinge + 0.012, base), (-d / 2 + 0.012, h), (-d / 2, h)], (-w / 2, w / 2), b.mat(), part="lid"
    )
    b.prism(
        [
            (hinge + 0.013, base + 0.012),
            (hinge + 0.0145, base + 0.012),
            (-d / 2 + 0.0145, h - 0.01),
            (-d / 2 + 0.013, h - 0.01),
        ],
        (-w * 0.47, w * 0.47),
        "screen_blue",
        part="screen",
        solid=False,
    )


@recipe("keyboard")
def keyboard(b: Builder) -> None:
    """Single keys in rows on a plate, a space bar, arrows and a block of figures."""
    w, d, h = b.w, b.d, b.h
    dark = b.mat() == "plastic_black"
    keys, special = ("plastic_light", "plastic_grey") if dark else ("plastic_white", "plastic_grey")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.6), b.mat(), "case")
    for row in range(6):
        y = d * 0.44 - row * d * 0.145 - (d * 0.03 if row == 5 else 0.0)
        spans = (
            [(x, 1) for x in range(15)]
            if row
            else [(0, 1), (1, 1), (2, 1), (3, 6), (9, 1), (10, 1), (11, 1), (12, 1), (13, 1), (14, 1)]
        )
        for first, count in (*spans, (16, 1), (17, 1), (18, 1)):
            x = w * 0.48 - first * w * 0.0505
            color = special if count == 1 and (first in (0, 13, 14) or row in (0, 5)) else keys
            key = ((x - w * (0.0505 * count - 0.008), x), (y - d * 0.12, y), (h * 0.6, h))
            b.box(*key, color, "keys", solid=False)


@recipe("computer_mouse")
def computer_mouse(b: Builder) -> None:
    """A palm-shaped back in two greys, two buttons parted by a ribbed wheel that is lit, and a thin cable in front."""
    w, d, h = b.w, b.d, b.h
    shell = "plastic_6a6e75" if b.mat() == "plastic_black" else b.mat()
    middle, reach = -d * 0.1, d * 0.4

    def on(x: float, y: float) -> tuple[float, float, float]:
        """Bring a place onto the back."""
        share = max(0.0, 1.0 - (x / (w / 2)) ** 2 - ((y - middle) / reach) ** 2)
        return x, y, h * (0.1 + 0.86 * math.sqrt(share))

    b.lathe([(0.47, 0), (0.5, h * 0.12)], "plastic_dark", (0, middle), "base", 24, (w, 2 * reach))
    b.ball((0, middle, h * 0.1), (w / 2, reach, h * 0.86), shell, "back", 24)
    line = [on(0.0, middle + reach * s) for s in (0.0, 0.2, 0.4, 0.6, 0.75, 0.88, 0.97)]
    b.path(line, w * 0.022, "plastic_black", "seam")
    b.path(
        [on(w * s, middle + reach * 0.02) for s in (-0.48, -0.4, -0.25, 0.0, 0.25, 0.4, 0.48)],
        w * 0.018,
        "plastic_black",
        "seam",
    )
    _, y, z = on(0.0, middle + reach * 0.48)
    b.rod((-w * 0.07, y, z), (w * 0.07, y, z), h * 0.2, "rubber_black", "wheel", 16)
    b.rod((-w * 0.03, y, z), (w * 0.03, y, z), h * 0.215, "light_4f9bf0", "wheel", 16)
    b.path(
        [(0, middle + reach * 0.94, h * 0.2), (0, d * 0.42, h * 0.14), (0, d / 2, h * 0.1)],
        h * 0.08,
        "rubber_black",
        "cable",
    )


@recipe("tablet_computer")
def tablet_computer(b: Builder) -> None:
    """A flat screen in a dark rim with rows of coloured signs on a blue ground, a lens and a round button."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.9), b.mat(), "case", 0.3)
    face = DrawnFace.top(b, h * 0.9)
    face.field((-w * 0.44, w * 0.44), (-d * 0.42, d * 0.44), "screen_3f8fd0", "screen", h * 0.04)
    colors = ("red", "yellow", "green", "orange", "white", "purple", "pink")
    for k in range(15):
        u, v = w * (-0.36 + 0.26 * (k % 3)) + w * 0.02, d * (0.28 - 0.145 * (k // 3))
        face.field((u, u + w * 0.16), (v, v + d * 0.1), f"light_{colors[(k * 3) % 7]}", "signs", h * 0.1)
    face.disc(0, -d * 0.46, w * 0.03, "metal_light", "button", h * 0.06)
    face.disc(0, d * 0.47, w * 0.012, "metal_light", "lens", h * 0.06)


@recipe("computer_case")
def computer_case(b: Builder) -> None:
    """A tower with a side of glass before a lit board, cards and fans; a drive, sockets and a blue switch in front."""
    w, d, h = b.w, b.d, b.h
    front, side = d / 2 - 0.012, w / 2 - 0.008
    b.box((-w / 2, side - 0.02), (-d / 2, front), (0.012, h), b.mat(), "case")
    for up in ((0.012, 0.06), (h - 0.04, h)):
        b.box((side - 0.02, side), (-d / 2, front), up, b.mat(), "case")
    for along in ((-d / 2, -d * 0.44), (front - d * 0.1, front)):
        b.box((side - 0.02, side), along, (0.012, h), b.mat(), "case")
    for x in (-w * 0.36, w * 0.36):
        for y in (-d * 0.4, d * 0.36):
            b.box((x - 0.015, x + 0.015), (y - 0.02, y + 0.02), (0, 0.012), "rubber_black", "feet")
    board = DrawnFace.side(b, side - 0.02)
    board.field((-d * 0.42, d * 0.34), (0.07, h - 0.05), "plastic_1f5f3a", "board", 0.003)
    for u, v, color in (
        (-d * 0.18, h * 0.7, "light_4f9bf0"),
        (d * 0.2, h * 0.72, "light_d94fd0"),
        (d * 0.2, h * 0.4, "light_4f9bf0"),
    ):
        ring = [(u + math.cos(k * math.pi / 9) * d * 0.12, v + math.sin(k * math.pi / 9) * d * 0.12) for k in range(19)]
        board.line(ring, 0.006, color, "fans", 0.008)
        board.disc(u, v, d * 0.1, "plastic_black", "fans", 0.006, 20)
        for k in range(5):
            a = k * math.tau / 5
            board.line(
                [(u, v), (u + math.cos(a) * d * 0.09, v + math.sin(a) * d * 0.09)], 0.007, "plastic_grey", "fans", 0.009
            )
    board.field((-d * 0.4, d * 0.04), (h * 0.4, h * 0.46), "metal_dark", "cards", 0.016)
    board.field((-d * 0.4, d * 0.0), (h * 0.28, h * 0.31), "paint_red", "cards", 0.014)
    b.box((side - 0.002, w / 2), (-d * 0.44, front - d * 0.1), (0.06, h - 0.04), "glass_clear", "window", solid=False)
    face = DrawnFace.front(b, front)
    face.field((-w * 0.42, w * 0.42), (h * 0.86, h * 0.94), "metal_grey", "drive", 0.006)
    face.field((-w * 0.38, w * 0.3), (h * 0.895, h * 0.905), "plastic_black", "drive", 0.008)
    face.disc(0, h * 0.76, w * 0.1, "light_4f9bf0", "switch", 0.008)
    face.disc(0, h * 0.76, w * 0.07, "plastic_black", "switch", 0.01)
    for u in (-0.24, -0.08, 0.08):
        face.field((w * u, w * (u + 0.1)), (h * 0.655, h * 0.675), "plastic_4f9bd9", "sockets", 0.006)
    for k in range(10):
        face.field((-w * 0.4, w * 0.4), (h * (0.1 + 0.05 * k), h * (0.125 + 0.05 * k)), "plastic_dark", "grille", 0.006)


@recipe("rack")
def server_rack(b: Builder) -> None:
    """Server cabinet with a perforated door and lit units."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.03), (0.05, h), b.mat(), "case")
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.05, d / 2 - 0.06), (0, 0.05), "metal_dark", "feet")
    count = int((h - 0.3) / 0.09)
    for k in range(count):
        z = 0.15 + k * 0.09
        b.box(
            (-w / 2 + 0.06, w / 2 - 0.06),
            (d / 2 - 0.03, d / 2 - 0.018),
            (z, z + 0.075),
            "metal_dark" if k % 3 else "metal_grey",
            "units",
            solid=False,
        )
        b.box(
            (w / 2 - 0.12, w / 2 - 0.09),
            (d / 2 - 0.018, d / 2 - 0.014),
            (z + 0.03, z + 0.045),
            "light_green" if k % 4 else "light_blue",
            "leds",
            solid=False,
        )
    for x in (-w / 2 + 0.025, w / 2 - 0.025):
        b.box((x - 0.025, x + 0.025), (d / 2 - 0.03, d / 2), (0.05, h), b.mat(), "door", solid=False)
    b.box((-w / 2, w / 2), (d / 2 - 0.03, d / 2), (h - 0.06, h), b.mat(), "door", solid=False)


@recipe("router")
def router(b: Builder) -> None:
    """A flat case with two antennas behind and a row of lights in front."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.4
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, top), b.mat(), "case", 0.3)
    for x in (-w * 0.36, w * 0.36):
        b.rod((x, -d * 0.4, top * 0.8), (x, -d * 0.4, h), h * 0.05, b.mat(), "antennas", 8)
    for k in range(5):
        x = (k - 2) * w * 0.09
        b.box(
            (x - w * 0.02, x + w * 0.02),
            (d * 0.3, d * 0.36),
            (top - 0.002, top + 0.002),
            "plastic_green",
            "lights",
            solid=False,
        )


@recipe("usb_stick")
def usb_stick(b: Builder) -> None:
    """A rounded case with a light, and a metal plug with two square holes in front."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d * 0.18), (0, h), b.mat(), "case", 0.4)
    b.box((-w * 0.38, w * 0.38), (d * 0.16, d / 2), (h * 0.2, h * 0.8), "metal_chrome", "plug")
    for side in (-1, 1):
        x = side * w * 0.16
        b.box(
            (x - w * 0.08, x + w * 0.08),
            (d * 0.3, d * 0.36),
            (h * 0.78, h * 0.815),
            "plastic_black",
            "holes",
            solid=False,
        )
    b.box((-w * 0.3, w * 0.3), (-d * 0.3, d * 0.02), (h, h * 1.03), "paint_3a7bc8", "label", solid=False)
    b.cyl(0, -d * 0.4, (h * 0.97, h * 1.03), w * 0.09, "light_green", "light", solid=False)


@recipe("compact_disc")
def compact_disc(b: Builder) -> None:
    """A silver disc with a hole, a clear hub and sectors that shine in the colours of the rainbow."""
    w, d, h = b.w, b.d, b.h
    n = 48
    turns = [k * 2 * math.pi / n for k in range(n + 1)]
    glow = {
        4: "plastic_e79ac0",
        5: "plastic_8fd3c8",
        6: "plastic_e8e08a",
        28: "plastic_8fd3c8",
        29: "plastic_a9b7ee",
        30: "plastic_e79ac0",
    }
    for k in range(n):
        sector = [
            (r * math.cos(a), r * math.sin(a))
            for r, a in ((0.17, turns[k]), (0.5, turns[k]), (0.5, turns[k + 1]), (0.17, turns[k + 1]))
        ]
        b.prism([(x * w, y * d) for x, y in sector], (0, h), glow.get(k, "metal_light"), "z", "disc")
        hub = [
            (r * math.cos(a), r * math.sin(a))
            for r, a in ((0.07, turns[k]), (0.17, turns[k]), (0.17, turns[k + 1]), (0.07, turns[k + 1]))
        ]
        b.prism([(x * w, y * d) for x, y in hub], (h * 0.2, h * 0.8), "plastic_dark", "z", "hub")
