"""Office machines: printers, plotters, shredders."""

import math
from typing import Final

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


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


@recipe("calculator")
def calculator(b: Builder) -> None:
    """A pocket calculator: a number in a pale display below a solar cell, and rows of keys with figures and signs."""
    w, d, h = b.w, b.d, b.h
    lid = h * 0.7
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, lid), b.mat(), "case", 0.3)
    face = DrawnFace.top(b, lid)
    face.field((-w * 0.46, w * 0.46), (-d * 0.47, d * 0.47), "plastic_3b4048", "plate", h * 0.04)
    face.field((-w * 0.05, w * 0.4), (d * 0.38, d * 0.44), "plastic_4a2f2a", "solar_cell", h * 0.08)
    face.field((-w * 0.42, w * 0.42), (d * 0.17, d * 0.35), "plastic_white", "bezel", h * 0.08)
    face.field((-w * 0.39, w * 0.39), (d * 0.19, d * 0.33), "plastic_c5d6a8", "display", h * 0.12)
    face.write("12345", (-w * 0.3, w * 0.37), (d * 0.2, d * 0.32), "plastic_black", "digits", h * 0.15)
    across, up = w * 0.215, d * 0.145
    for row, signs in enumerate(_CALCULATOR_KEYS):
        for column, sign in enumerate(signs):
            u, v = (column - 1.5) * across, d * 0.075 - row * up
            color, ink = _calculator_key(sign)
            face.field(
                (u - across * 0.42, u + across * 0.42), (v - up * 0.4, v + up * 0.4), color, "keys", h - lid - 0.0005
            )
            mark = ((u - across * 0.3, u + across * 0.3), (v - up * 0.26, v + up * 0.26))
            if sign == "=":
                for low in (-0.2, 0.08):
                    face.field(mark[0], (v + up * low, v + up * (low + 0.12)), ink, "signs", h - lid)
            else:
                face.write(sign, *mark, ink, "signs", h - lid)


_CALCULATOR_KEYS: Final = ("C%:X", "789-", "456+", "123=")
"""Keys of a calculator, row by row from above."""


def _calculator_key(sign: str) -> tuple[str, str]:
    """Return the colours of a key and of the sign on it."""
    if sign.isdigit():
        return "plastic_white", "plastic_black"
    return {"C": "plastic_red", "=": "plastic_green"}.get(sign, "plastic_orange"), "plastic_white"
