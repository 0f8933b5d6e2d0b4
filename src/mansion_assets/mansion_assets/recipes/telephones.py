"""Telephones, other flat handheld devices, and door intercoms."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("phone")
def phone(b: Builder) -> None:
    """Flat device: smartphone, tablet, remote control, card reader."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.85), b.mat(), "case")
    if b.mat().startswith("glass"):
        b.box((-w * 0.44, w * 0.44), (-d * 0.46, d * 0.46), (h * 0.85, h), "screen_dark", "screen", solid=False)
        return
    b.box(
        (-w * 0.4, w * 0.4),
        (d * 0.2 if b.p.get("style") != "remote" else d * 0.36, d * 0.44),
        (h * 0.85, h),
        "screen_green",
        "display",
        solid=False,
    )
    for i in range(3):
        for j in range(4):
            x, y = -w * 0.28 + i * w * 0.28, -d * 0.38 + j * d * 0.14
            b.box(
                (x - w * 0.1, x + w * 0.1),
                (y - d * 0.045, y + d * 0.045),
                (h * 0.85, h),
                "plastic_light",
                "keys",
                solid=False,
            )


@recipe("telephone")
def telephone(b: Builder) -> None:
    """Office telephone."""
    w, d, h = b.w, b.d, b.h
    b.prism([(-d / 2, 0), (d / 2, 0), (d / 2, h * 0.3), (-d / 2, h * 0.75)], (-w / 2, w / 2), b.mat())
    b.cushion((-w / 2, -w * 0.25), (-d / 2, d * 0.45), (h * 0.5, h), "plastic_dark", "receiver", 0.8)
    b.box((-w * 0.15, w * 0.4), (-d * 0.35, -d * 0.1), (h * 0.62, h * 0.72), "screen_green", "display", solid=False)


@recipe("mobile_phone")
def mobile_phone(b: Builder) -> None:
    """A telephone with a bright screen of coloured icons in rows, a dock, a speaker slot, and a camera on top."""
    w, d, h = b.w, b.d, b.h
    lit = (h, h * 1.03)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h), "plastic_black", "case")
    b.box((-w * 0.45, w * 0.45), (-d * 0.46, d * 0.46), lit, "plastic_9cc4ea", "screen", solid=False)
    colors = (
        "paint_red",
        "paint_2f9a4a",
        "paint_orange",
        "paint_1d5fd0",
        "plastic_white",
        "paint_yellow",
        "paint_purple",
    )
    for k in range(20):
        row, column = divmod(k, 4)
        x, y = w * (0.32 - 0.213 * column), d * (-0.3 + 0.125 * row)
        if row == 4:
            y = d * 0.38
        side = w * 0.075
        b.box(
            (x - side, x + side),
            (y - side, y + side),
            (h * 1.03, h * 1.06),
            colors[(k * 3 + row) % 7],
            "icons",
            solid=False,
        )
    b.box((-w * 0.14, w * 0.14), (-d * 0.445, -d * 0.42), (h * 1.03, h * 1.06), "plastic_black", "speaker", solid=False)


@recipe("intercom")
def intercom(b: Builder) -> None:
    """A door telephone: a handset on its rest with a curled cord, beside a small screen and call buttons."""
    w, d, h = b.w, b.d, b.h
    back, face = -d / 2, d * 0.05
    b.cushion((-w / 2, w / 2), (back, face), (h * 0.06, h), b.mat(), "case", 0.3)
    b.box((w * 0.0, w * 0.42), (face - 0.002, face + 0.001), (h * 0.56, h * 0.88), "screen_dark", "screen", solid=False)
    for k in range(6):
        z = h * (0.44 - 0.1 * (k // 2))
        x = w * (0.1 + 0.2 * (k % 2))
        b.rod(
            (x, face - 0.002, z),
            (x, face + 0.004, z),
            w * 0.055,
            ("plastic_green", "plastic_red")[k % 2] if k < 2 else "plastic_grey",
            "buttons",
            10,
        )
    x = -w * 0.26
    b.cushion((x - w * 0.09, x + w * 0.09), (d * 0.12, d * 0.34), (h * 0.26, h * 0.86), "plastic_dark", "handset", 0.7)
    for end in ((h * 0.74, h * 0.96), (h * 0.16, h * 0.38)):
        b.cushion((x - w * 0.14, x + w * 0.14), (face - 0.002, d / 2), end, "plastic_dark", "handset", 0.6)
    coil = [
        (x + w * 0.06 * math.sin(k * 1.57), d * 0.2 + d * 0.08 * math.cos(k * 1.57), h * (0.2 - 0.2 * k / 16))
        for k in range(17)
    ]
    b.path(coil, w * 0.016, "plastic_black", "cord")
