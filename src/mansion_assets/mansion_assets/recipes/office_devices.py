"""Devices on and beside desks: what one points, prints, shreds and reads with."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


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


@recipe("shredder_bin")
def shredder_bin(b: Builder) -> None:
    """A bin whose window shows strips of paper, under a head with a slot that a sheet goes into, and a lit switch."""
    w, d, h = b.w, b.d, b.h
    low, high, t = h * 0.66, h * 0.82, 0.012
    b.box((-w * 0.46, w * 0.46), (-d * 0.46, d * 0.46), (0, t), b.mat(), "bin")
    for side in (-1, 1):
        across = sorted((side * w * 0.46, side * (w * 0.46 - t)))
        b.box((across[0], across[1]), (-d * 0.46, d * 0.46), (0, low), b.mat(), "bin")
    b.box((-w * 0.46, w * 0.46), (-d * 0.46, -d * 0.46 + t), (0, low), b.mat(), "bin")
    b.box((-w * 0.46, w * 0.46), (d * 0.46 - t, d * 0.46), (0, low), b.mat(), "bin")
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (low, high), "plastic_dark", "head", 0.3)
    face = DrawnFace.front(b, d * 0.46)
    face.field((-w * 0.34, w * 0.34), (h * 0.08, low * 0.86), "plastic_light", "window", 0.002)
    for k in range(12):
        u = w * (-0.33 + 0.055 * k)
        top = low * (0.5 + 0.08 * ((k * 5) % 4))
        face.line(
            [(u, h * 0.09), (u + w * 0.05 * (-1) ** k, top * 0.5), (u + w * 0.01, top)],
            0.007,
            ("paper_white", "paper_fff3c0")[k % 2],
            "strips",
            0.006,
        )
    b.box((-w * 0.36, w * 0.36), (-0.014, 0.014), (high - 0.004, high + 0.004), "plastic_black", "slot", solid=False)
    b.box((-w * 0.3, w * 0.3), (-0.002, 0.002), (high - 0.03, h), "paper_white", "sheet")
    sheet = DrawnFace.front(b, 0.002)
    for k in range(4):
        v = high + (h - high) * (0.2 + 0.19 * k)
        sheet.field((-w * 0.24, w * (0.22 - 0.06 * (k % 2))), (v, v + h * 0.012), "paper_dark", "sheet", 0.001)
    DrawnFace.front(b, d / 2).disc(w * 0.34, (low + high) / 2, 0.018, "light_green", "switch", 0.004)


@recipe("desktop_printer")
def desktop_printer(b: Builder) -> None:
    """A case with sheets that stand in its feeder behind, a printed sheet on the tray in front."""
    w, d, h = b.w, b.d, b.h
    high, front = h * 0.62, d * 0.24
    b.cushion((-w / 2, w / 2), (-d * 0.44, front), (0, high), b.mat(), "case", 0.25, 12)
    b.prism(
        [(-d * 0.3, high * 0.9), (-d * 0.24, high * 0.9), (-d * 0.44, h), (-d / 2, h)],
        (-w * 0.36, w * 0.36),
        "plastic_grey",
        part="feeder",
    )
    b.prism(
        [(-d * 0.25, high * 0.9), (-d * 0.2, high * 0.9), (-d * 0.38, h * 0.98), (-d * 0.42, h * 0.98)],
        (-w * 0.31, w * 0.31),
        "paper_white",
        part="paper",
    )
    face = DrawnFace.front(b, front)
    face.field((-w * 0.4, w * 0.4), (high * 0.2, high * 0.5), "plastic_black", "mouth", 0.003)
    b.box((-w * 0.36, w * 0.36), (front - 0.02, d / 2), (high * 0.14, high * 0.19), "plastic_grey", "tray")
    b.prism(
        [(front - 0.02, high * 0.3), (d * 0.48, high * 0.2), (d * 0.48, high * 0.22), (front - 0.02, high * 0.33)],
        (-w * 0.3, w * 0.3),
        "paper_white",
        part="sheet",
    )
    sheet = DrawnFace.sloped(b, (d * 0.48, high * 0.22), (front, high * 0.325))
    sheet.field((-w * 0.25, w * 0.04), (d * 0.04, d * 0.2), "picture_meadow", "print", 0.0015)
    for k in range(4):
        sheet.field(
            (w * 0.08, w * 0.26), (d * (0.05 + 0.045 * k), d * (0.07 + 0.045 * k)), "paper_dark", "print", 0.0015
        )
    top = DrawnFace.top(b, high)
    top.field((-w * 0.4, w * 0.1), (-d * 0.2, -d * 0.06), "plastic_dark", "panel", 0.003)
    top.field((-w * 0.36, -w * 0.12), (-d * 0.185, -d * 0.075), "light_4f9bf0", "panel", 0.005)
    for k, color in enumerate(("green", "grey", "red")):
        top.disc(w * (-0.06 + 0.06 * k), -d * 0.13, w * 0.02, f"plastic_{color}", "panel", 0.007)


@recipe("plotter")
def plotter(b: Builder) -> None:
    """A long printer on a stand with a roll of paper, a wide drawing that hangs out in front, a panel at its end."""
    w, d, h = b.w, b.d, b.h
    for side in (-1, 1):
        x = side * (w / 2 - 0.14)
        b.box((x - 0.04, x + 0.04), (-d / 2, d / 2), (0, 0.06), "metal_dark", "feet")
        b.box((x - 0.03, x + 0.03), (-0.08, 0.08), (0.05, h * 0.7), "metal_dark", "legs")
    b.rod((-w / 2 + 0.14, 0, 0.2), (w / 2 - 0.14, 0, 0.2), 0.02, "metal_dark", "legs", 8)
    b.prism(
        [(-d * 0.36, h * 0.7), (d * 0.26, h * 0.7), (d * 0.34, h * 0.8), (d * 0.1, h * 0.94), (-d * 0.36, h * 0.94)],
        (-w / 2, w / 2),
        b.mat(),
        part="case",
    )
    b.rod((-w * 0.4, -d * 0.34, h * 0.93), (w * 0.4, -d * 0.34, h * 0.93), h * 0.065, "paper_white", "roll", 18)
    b.box((w * 0.3, w / 2), (-d * 0.1, d * 0.3), (h * 0.9, h * 0.97), "plastic_dark", "panel")
    DrawnFace.top(b, h * 0.97).field((-w * 0.47, -w * 0.33), (-d * 0.26, d * 0.06), "screen_green", "panel", 0.004)
    sheet = [
        (d * 0.2, h * 0.86),
        (d * 0.42, h * 0.78),
        (d * 0.45, h * 0.3),
        (d * 0.44, h * 0.3),
        (d * 0.41, h * 0.77),
        (d * 0.19, h * 0.85),
    ]
    for part in ((0, 1, 4, 5), (1, 2, 3, 4)):
        b.prism([sheet[k] for k in part], (-w * 0.38, w * 0.28), "paper_white", part="sheet")
    face = DrawnFace.sloped(b, (d * 0.45, h * 0.3), (d * 0.42, h * 0.78))
    tall = h * 0.48
    for u, v in (
        ((-w * 0.22, w * 0.32), (tall * 0.12, tall * 0.14)),
        ((-w * 0.22, w * 0.32), (tall * 0.84, tall * 0.86)),
        ((-w * 0.22, -w * 0.21), (tall * 0.12, tall * 0.86)),
        ((w * 0.31, w * 0.32), (tall * 0.12, tall * 0.86)),
        ((-w * 0.02, -w * 0.01), (tall * 0.12, tall * 0.6)),
        ((-w * 0.22, w * 0.16), (tall * 0.5, tall * 0.52)),
        ((w * 0.1, w * 0.11), (tall * 0.5, tall * 0.86)),
    ):
        face.field(u, v, "paper_2f5fa8", "drawing", 0.003)
    face.field((w * 0.16, w * 0.3), (tall * 0.15, tall * 0.26), "paper_8fc1e9", "drawing", 0.003)
    arc = [
        (-w * 0.01 + math.cos(a) * w * 0.08, tall * 0.13 + math.sin(a) * w * 0.08)
        for a in (k * math.pi / 12 for k in range(7))
    ]
    face.line(arc, 0.004, "paper_red", "drawing", 0.003)


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
