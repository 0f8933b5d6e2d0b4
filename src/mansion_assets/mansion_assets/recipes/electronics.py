"""Screens, computers, phones, clocks, kiosks and tills."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe
from mansion_assets.solids import Vec3

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


@recipe("dock")
def dock(b: Builder) -> None:
    """Charging station: a panel with a lightning bolt on it, a ramp, and a round robot that stands at its contacts."""
    w, d, h = b.w, b.d, b.h
    face = -d / 2 + 0.06
    b.box((-w * 0.4, w * 0.4), (-d / 2, face), (0, h), b.mat(), "panel")
    b.prism([(-d / 2, 0), (d / 2, 0), (d / 2, 0.006), (face, 0.02)], (-w / 2, w / 2), "plastic_dark", part="ramp")
    for side in (-1, 1):
        b.box((side * 0.06 - 0.015, side * 0.06 + 0.015), (face, face + 0.012), (0.05, 0.08), "metal_brass", "contacts")
    middle, r = h * 0.68, h * 0.24
    bolt = ((0.1, 1.0), (-0.55, -0.15), (0.0, -0.1), (-0.15, -1.0), (0.55, 0.2), (0.0, 0.15))
    for part in ((0, 1, 2, 5), (2, 3, 4, 5)):
        outline = [(bolt[k][0] * r, middle + bolt[k][1] * r) for k in part]
        b.prism(outline, (face, face + 0.006), "light_e5b920", "y", "sign", solid=False)
    reach = min(w * 0.42, (d / 2 - face) * 0.5)
    y = d / 2 - reach
    b.lathe([(reach, 0.02), (reach, h * 0.2), (reach * 0.94, h * 0.24)], "plastic_dark", (0, y), "robot", 28)
    b.cyl(0, y, (h * 0.24, h * 0.27), reach * 0.3, "metal_light", "robot", n=20)
    b.box(
        (-reach * 0.12, reach * 0.12),
        (y + reach * 0.5, y + reach * 0.7),
        (h * 0.24, h * 0.25),
        "light_green",
        "robot",
        solid=False,
    )


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


@recipe("game_console")
def game_console(b: Builder) -> None:
    """A flat case with a slot and a light; on it a controller with two sticks, a cross and four coloured buttons."""
    w, d, h = b.w, b.d, b.h
    case = h * 0.42
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, case), b.mat(), "case")
    b.box((-w * 0.4, w * 0.1), (d / 2, d / 2 + 0.001), (case * 0.5, case * 0.64), "plastic_grey", "slot", solid=False)
    b.box((w * 0.3, w * 0.36), (d / 2, d / 2 + 0.001), (case * 0.4, case * 0.7), "light_blue", "lamp", solid=False)
    z, face = (case, h * 0.84), h * 0.84
    b.cushion((-w * 0.34, w * 0.34), (-d * 0.26, d * 0.12), z, "plastic_white", "controller", 0.6)
    for side in (-1, 1):
        lo, hi = sorted((side * w * 0.4, side * w * 0.18))
        b.cushion((lo, hi), (-d * 0.3, d * 0.36), z, "plastic_white", "controller", 0.8)
        b.cyl(side * w * 0.12, d * 0.06, (face - 0.004, h), w * 0.055, "plastic_black", "sticks", n=14)
    x, y = -w * 0.27, -d * 0.1
    b.box(
        (x - w * 0.06, x + w * 0.06), (y - d * 0.025, y + d * 0.025), (face - 0.004, h * 0.93), "plastic_black", "cross"
    )
    b.box(
        (x - w * 0.02, x + w * 0.02), (y - d * 0.075, y + d * 0.075), (face - 0.004, h * 0.93), "plastic_black", "cross"
    )
    spots = ((0.05, 0.0, "red"), (-0.05, 0.0, "blue"), (0.0, 0.065, "yellow"), (0.0, -0.065, "green"))
    for u, v, color in spots:
        b.cyl(w * (0.27 + u), y + d * v, (face - 0.004, h * 0.93), w * 0.026, f"plastic_{color}", "buttons", n=12)


@recipe("portable_radio")
def portable_radio(b: Builder) -> None:
    """A case with a round, pierced loudspeaker, a dial with a needle, two knobs, a handle and a drawn aerial."""
    w, d, h = b.w, b.d, b.h
    top, front = h * 0.62, d / 2
    b.cushion((-w / 2, w / 2), (-d / 2, front - 0.004), (0, top), b.mat(), "case", 0.2)
    b.box((-w * 0.46, w * 0.46), (front - 0.006, front - 0.003), (top * 0.08, top * 0.92), "plastic_e9dfc8", "face")
    _loudspeaker(b, (-w * 0.22, front, top / 2), top * 0.36)
    b.box(
        (w * 0.08, w * 0.42),
        (front - 0.003, front - 0.001),
        (top * 0.56, top * 0.82),
        "paper_white",
        "dial",
        solid=False,
    )
    for k in range(7):
        u = w * (0.1 + 0.048 * k)
        b.box(
            (u, u + w * 0.008), (front - 0.001, front), (top * 0.66, top * 0.78), "plastic_black", "dial", solid=False
        )
    b.box(
        (w * 0.24, w * 0.255),
        (front - 0.001, front + 0.001),
        (top * 0.57, top * 0.81),
        "paint_red",
        "dial",
        solid=False,
    )
    for u in (0.15, 0.35):
        b.rod(
            (w * u, front - 0.003, top * 0.28), (w * u, front + 0.004, top * 0.28), w * 0.06, "metal_steel", "knobs", 16
        )
    b.path(
        [(-w * 0.4, 0, top), (-w * 0.36, 0, top * 1.25), (w * 0.3, 0, top * 1.25), (w * 0.34, 0, top)],
        h * 0.025,
        "leather_brown",
        "handle",
    )
    b.rod((w * 0.42, -d * 0.3, top * 0.95), (w * 0.2, -d * 0.3, h), 0.003, "metal_chrome", "aerial")


def _loudspeaker(b: Builder, at: Vec3, r: float) -> None:
    """Add a round, pierced front whose middle is `at`, in rings."""
    x, y, z = at
    b.rod((x, y - 0.004, z), (x, y - 0.001, z), r, "metal_dark", "loudspeaker", 24)
    for share, color in ((0.75, "metal_light"), (0.5, "metal_dark"), (0.25, "metal_light")):
        b.rod((x, y - 0.002, z), (x, y + 0.001 - 0.002 * share, z), r * share, color, "loudspeaker", 20)


@recipe("battery")
def battery(b: Builder) -> None:
    """A dry cell: a black case with a copper end, a plus on its side, and a button at its pole."""
    w, d, h = b.w, b.d, b.h
    for profile, color in (
        (((0.5, 0), (0.5, 0.62)), b.mat()),
        (((0.5, 0.62), (0.5, 0.9), (0.47, 0.92)), "metal_copper"),
        (((0.4, 0.9), (0.4, 0.93)), "metal_light"),
        (((0.18, 0.92), (0.18, 1.0)), "metal_chrome"),
    ):
        b.lathe([(r, z * h) for r, z in profile], color, n=24, stretch=(w, d), part="cell")
    for half in ((w * 0.13, h * 0.03), (w * 0.045, h * 0.09)):
        b.box(
            (-half[0], half[0]),
            (d * 0.44, d * 0.505),
            (h * 0.76 - half[1], h * 0.76 + half[1]),
            "plastic_black",
            "sign",
            solid=False,
        )
        b.box(
            (w * 0.44, w * 0.505),
            (-half[0], half[0]),
            (h * 0.76 - half[1], h * 0.76 + half[1]),
            "plastic_black",
            "sign",
            solid=False,
        )
    bolt = [
        (w * 0.02, h * 0.56),
        (-w * 0.12, h * 0.32),
        (w * 0.02, h * 0.34),
        (-w * 0.02, h * 0.1),
        (w * 0.14, h * 0.38),
        (0.0, h * 0.36),
    ]
    b.prism([bolt[0], bolt[1], bolt[2], bolt[5]], (d * 0.44, d * 0.505), "paint_yellow", "y", "sign", solid=False)
    b.prism([bolt[2], bolt[3], bolt[4], bolt[5]], (d * 0.44, d * 0.505), "paint_yellow", "y", "sign", solid=False)
