"""Screens, computers, phones, clocks, kiosks and tills."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("screen")
def screen(b: Builder) -> None:
    """Television, monitor or wall display."""
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
    """Rows of keys on a plate."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.6), b.mat(), "case")
    for row in range(5):
        y = -d * 0.42 + row * d * 0.175
        b.box(
            (-w * 0.48, w * 0.3),
            (y, y + d * 0.14),
            (h * 0.6, h),
            "plastic_dark" if b.mat() == "plastic_black" else "plastic_light",
            "keys",
            solid=False,
        )
        b.box((w * 0.33, w * 0.48), (y, y + d * 0.14), (h * 0.6, h), "plastic_dark", "keys", solid=False)


@recipe("phone")
def phone(b: Builder) -> None:
    """Flat device: smartphone, tablet, remote control, card reader, calculator."""
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


@recipe("headphones")
def headphones(b: Builder) -> None:
    """Band with two cups."""
    w, d, h = b.w, b.d, b.h
    r, rz = w / 2 - 0.012, h - w * 0.2
    points = [
        (r * math.cos(a), 0.0, w * 0.18 + (rz - w * 0.02) * math.sin(a)) for a in [k * math.pi / 10 for k in range(11)]
    ]
    b.path(points, 0.008, b.mat(), "band")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.035)))
        b.cushion((lo, hi), (-d / 2, d / 2), (0, h * 0.45), b.mat(), "cups", 0.7)


@recipe("clock")
def clock(b: Builder) -> None:
    """Wall clock, alarm clock or dart board, its face to the front."""
    w, d, h = b.w, b.d, b.h
    style = b.p.get("style", "wall")
    r = min(w, h) / 2
    cz = h / 2
    b.rod((0, -d / 2, cz), (0, d / 2 - 0.006, cz), r, b.mat(), "rim", 28, solid=True)
    if style == "dart":
        for k, (share, color) in enumerate(
            ((0.9, "fabric_beige"), (0.62, "fabric_green"), (0.55, "fabric_black"), (0.12, "fabric_red"))
        ):
            b.rod((0, d / 2 - 0.008, cz), (0, d / 2 - 0.006 + 0.0015 * (k + 1), cz), r * share, color, "face", 28)
        return
    b.rod((0, d / 2 - 0.008, cz), (0, d / 2 - 0.003, cz), r * 0.9, "paper_white", "face", 28)
    b.rod((0, d / 2 - 0.002, cz), (0, d / 2 - 0.002, cz + r * 0.7), r * 0.03, "plastic_black", "hands", 6)
    b.rod((0, d / 2 - 0.002, cz), (r * 0.42, d / 2 - 0.002, cz + r * 0.2), r * 0.04, "plastic_black", "hands", 6)
    if style == "desk":
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.08), b.mat(), "foot")
        b.box((-w * 0.2, w * 0.2), (-d * 0.2, d * 0.2), (h * 0.94, h), "metal_steel", "bell", solid=False)


@recipe("kiosk")
def kiosk(b: Builder) -> None:
    """Terminal with a tilted screen on a column, or a closed machine."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.04), "metal_dark", "foot")
    if b.p.get("style") == "block":
        b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.1), (0.04, h), b.mat(), "case")
        b.box((-w / 2, w / 2), (d / 2 - 0.1, d / 2), (0.04, 0.85), b.mat(), "case")
        b.box(
            (-w * 0.35, w * 0.35),
            (d / 2 - 0.1, d / 2 - 0.095),
            (1.0, min(1.4, h - 0.12)),
            "screen_blue",
            "screen",
            solid=False,
        )
        b.box((-w * 0.2, w * 0.2), (d / 2 - 0.06, d / 2 - 0.02), (0.85, 0.87), "plastic_dark", "keys", solid=False)
        b.box((-w * 0.4, w * 0.4), (d / 2 - 0.1, d / 2 - 0.09), (h - 0.1, h - 0.02), "light_white", "sign", solid=False)
        return
    b.box((-w * 0.18, w * 0.18), (-d * 0.3, d * 0.1), (0.04, h * 0.62), b.mat(), "column")
    b.prism(
        [(-d * 0.2, h * 0.58), (d / 2, h * 0.6), (d / 2 - 0.05, h * 0.63), (-d * 0.42, h), (-d / 2, h)],
        (-w / 2, w / 2),
        b.mat(),
        part="head",
    )
    b.prism(
        [(d / 2 - 0.055, h * 0.645), (d / 2 - 0.05, h * 0.65), (-d * 0.38, h * 0.98), (-d * 0.4, h * 0.975)],
        (-w * 0.44, w * 0.44),
        "screen_blue",
        part="screen",
        solid=False,
    )


@recipe("dock")
def dock(b: Builder) -> None:
    """Charging station: back panel, ramp, contacts, a light."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.1), (0, h), b.mat(), "panel")
    b.prism(
        [(-d / 2, 0), (d / 2, 0), (d / 2, 0.006), (-d / 2 + 0.1, 0.03)], (-w / 2, w / 2), "plastic_dark", part="ramp"
    )
    for sx in (-1, 1):
        b.box(
            (sx * 0.06 - 0.015, sx * 0.06 + 0.015),
            (-d / 2 + 0.1, -d / 2 + 0.112),
            (0.08, 0.13),
            "metal_brass",
            "contacts",
            solid=False,
        )
    b.box((-w * 0.2, w * 0.2), (-d / 2 + 0.1, -d / 2 + 0.103), (h * 0.8, h * 0.84), "light_green", "light", solid=False)


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
