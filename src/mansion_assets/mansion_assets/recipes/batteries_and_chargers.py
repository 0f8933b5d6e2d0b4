"""Batteries, charging docks and charging towers."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe
from mansion_assets.solids import Vec3

__all__: list[str] = []


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


@recipe("charging_tower")
def charging_tower(b: Builder) -> None:
    """A column whose lit sign says CHARGE below a battery with lightning, and large telephones on cables round it."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.05), "metal_dark", "foot")
    b.box((-w * 0.22, w * 0.22), (-d * 0.22, d * 0.22), (0.05, h * 0.58), b.mat(), "column")
    b.box((-w / 2, w / 2), (-d * 0.14, d * 0.14), (h * 0.58, h), b.mat(), "head")
    _battery_sign(b)
    shelf = h * 0.3
    b.box((-w * 0.48, w * 0.48), (-d * 0.48, d * 0.48), (shelf - 0.025, shelf), "plastic_white", "shelves")
    for k in range(2):
        _charging_telephone(b, w * (0.24 - 0.48 * k), shelf, ("screen_3f8fd0", "screen_e85fa8")[k])
        _charging_telephone(b, w * (0.24 - 0.48 * k), shelf, ("screen_58c838", "screen_f5a018")[k], aside=True)


def _charging_telephone(b: Builder, along: float, z: float, screen: str, *, aside: bool = False) -> None:
    """A telephone that leans on the shelf at height `z`, before the column or beside it, its battery on its screen."""
    low, high, half = b.d * 0.4, (b.d * 0.27, z + 0.22), 0.055
    if aside:
        face = DrawnFace(b, (low, 0.0, z), (0.0, 1.0, 0.0), _leaning(low - high[0], high[1] - z, aside=True))
    else:
        face = DrawnFace(b, (0.0, low, z), (-1.0, 0.0, 0.0), _leaning(low - high[0], high[1] - z))
    u, tall = along, math.hypot(low - high[0], high[1] - z)
    face.field((u - half, u + half), (0.0, tall), "plastic_17181b", "telephones", 0.014)
    face.field((u - half * 0.88, u + half * 0.88), (tall * 0.06, tall * 0.92), screen, "telephones", 0.016)
    face.field((u - half * 0.5, u + half * 0.5), (tall * 0.34, tall * 0.6), "screen_f4f8fc", "charge", 0.018)
    face.field((u - half * 0.2, u + half * 0.2), (tall * 0.6, tall * 0.66), "screen_f4f8fc", "charge", 0.018)
    face.line([(u, 0.006), (u, -0.05)], 0.007, "plastic_white", "cables", 0.01)


def _leaning(back: float, rise: float, *, aside: bool = False) -> Vec3:
    """Return the direction up something that leans back, against the column."""
    long = math.hypot(back, rise)
    return (-back / long, 0.0, rise / long) if aside else (0.0, -back / long, rise / long)


def _battery_sign(b: Builder) -> None:
    """A lit battery with a bolt of lightning, and the word CHARGE, on the front of the head."""
    w, d, h = b.w, b.d, b.h
    face, front = DrawnFace.front(b, d * 0.14), d * 0.14
    face.field((-w * 0.47, w * 0.47), (h * 0.6, h * 0.985), "light_2f8fe0", "sign", 0.004)
    face.write("CHARGE", (-w * 0.43, w * 0.43), (h * 0.615, h * 0.685), "light_ffffff", "letters", 0.008)
    low, high, half = h * 0.705, h * 0.935, w * 0.22
    face.field((-half, half), (low, high), "light_ffffff", "battery", 0.006)
    face.field((-half * 0.4, half * 0.4), (high, h * 0.965), "light_ffffff", "battery", 0.006)
    face.field((-half * 0.86, half * 0.86), (low + half * 0.14, high - half * 0.14), "light_38b04a", "battery", 0.008)
    bolt = ((0.1, 1.0), (-0.55, -0.15), (0.0, -0.1), (-0.15, -1.0), (0.55, 0.2), (0.0, 0.15))
    middle, r = (low + high) / 2, (high - low) * 0.38
    for part in ((0, 1, 2, 5), (2, 3, 4, 5)):
        outline = [(bolt[k][0] * r, middle + bolt[k][1] * r) for k in part]
        b.prism(outline, (front + 0.008, front + 0.014), "light_yellow", "y", "bolt")
