"""Turned bodies: bottles, cups, jars, pans, racks of tubes."""

from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, surface
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


Profile = tuple[tuple[float, float], ...]


_PROFILES: dict[str, Profile] = {
    "cup": ((0.38, 0), (0.5, 1), (0.46, 1), (0.35, 0.06)),
    "bottle": ((0.48, 0), (0.5, 0.03), (0.5, 0.58), (0.2, 0.76), (0.17, 0.92), (0.2, 0.93), (0.2, 1)),
    "can": ((0.46, 0), (0.5, 0.04), (0.5, 0.95), (0.45, 1)),
    "bowl": ((0.25, 0), (0.28, 0.06), (0.44, 0.55), (0.5, 1), (0.46, 1), (0.36, 0.4), (0.2, 0.14)),
    "vase": (
        (0.3, 0),
        (0.34, 0.05),
        (0.5, 0.4),
        (0.38, 0.7),
        (0.24, 0.85),
        (0.32, 1),
        (0.28, 1),
        (0.2, 0.85),
        (0.2, 0.5),
    ),
    "pump": (
        (0.48, 0),
        (0.5, 0.05),
        (0.5, 0.6),
        (0.25, 0.72),
        (0.22, 0.8),
        (0.08, 0.81),
        (0.08, 0.93),
        (0.3, 0.94),
        (0.3, 1),
    ),
    "jug": ((0.46, 0), (0.5, 0.06), (0.5, 0.6), (0.3, 0.8), (0.24, 0.86), (0.26, 1)),
    "shaker": ((0.46, 0), (0.5, 0.08), (0.36, 0.7), (0.4, 0.74), (0.38, 0.92), (0.2, 1)),
    "roll": ((0.5, 0), (0.5, 1), (0.18, 1), (0.18, 0.9)),
    "brush": ((0.46, 0), (0.5, 0.04), (0.42, 0.32), (0.12, 0.34), (0.1, 0.95), (0.14, 0.97), (0.1, 1)),
    "plunger": ((0.5, 0), (0.46, 0.1), (0.3, 0.2), (0.1, 0.25), (0.07, 0.3), (0.07, 0.97), (0.05, 1)),
    "flask": ((0.5, 0), (0.5, 0.04), (0.2, 0.68), (0.17, 0.95), (0.2, 1), (0.16, 1), (0.13, 0.7)),
    "barrel": (
        (0.44, 0),
        (0.45, 0.02),
        (0.49, 0.3),
        (0.5, 0.33),
        (0.48, 0.36),
        (0.48, 0.64),
        (0.5, 0.67),
        (0.49, 0.7),
        (0.45, 0.98),
        (0.42, 1),
        (0.42, 0.97),
    ),
    "cone": ((0.5, 0), (0.5, 0.05), (0.36, 0.06), (0.08, 0.97), (0.05, 1)),
    "tires": (
        (0.42, 0),
        (0.5, 0.05),
        (0.5, 0.28),
        (0.42, 0.33),
        (0.5, 0.38),
        (0.5, 0.61),
        (0.42, 0.66),
        (0.5, 0.71),
        (0.5, 0.95),
        (0.42, 1),
        (0.26, 0.98),
        (0.26, 0.7),
    ),
    "bucket": ((0.36, 0), (0.48, 0.97), (0.5, 1), (0.46, 1), (0.34, 0.04)),
    "reel": ((0.5, 0), (0.5, 0.1), (0.3, 0.12), (0.3, 0.88), (0.5, 0.9), (0.5, 1), (0.12, 1), (0.12, 0.9)),
    "trophy": ((0.4, 0), (0.4, 0.12), (0.1, 0.16), (0.08, 0.4), (0.4, 0.6), (0.5, 1), (0.45, 1), (0.3, 0.6)),
}


_BANDS = {
    "bottle": ("paper_white", 0.2, 0.48, 0.504),
    "can": ("metal_steel", 0.93, 1.0, 0.47),
    "cone": ("plastic_white", 0.4, 0.55, 0.29),
    "pump": ("paper_white", 0.2, 0.5, 0.505),
    "jug": ("paper_white", 0.2, 0.5, 0.505),
}


@recipe("lathe")
def lathe(b: Builder) -> None:
    """A body of revolution by the name of its profile."""
    name = str(b.p.get("profile", "cup"))
    profile = [(r, z * b.h) for r, z in _PROFILES[name]]
    n = 28 if max(b.w, b.d) > 0.25 else 16
    b.lathe(profile, b.mat(), n=n, stretch=(b.w, b.d))
    if name in _BANDS:
        color, z0, z1, r = _BANDS[name]
        if name == "can":
            b.lathe([(r, z0 * b.h), (r, z1 * b.h)], color, n=n, stretch=(b.w, b.d), part="lid", solid=False)
        else:
            b.lathe(
                [(r, z0 * b.h), (r * (0.8 if name == "cone" else 1.0), z1 * b.h)],
                color,
                n=n,
                stretch=(b.w * 0.99, b.d * 0.99),
                part="label",
                solid=False,
            )


@recipe("mug")
def mug(b: Builder) -> None:
    """Cup with a handle on its right."""
    r = b.d / 2
    x = -b.w / 2 + r
    b.lathe([(r * 0.9, 0), (r, 0.01), (r, b.h), (r * 0.88, b.h), (r * 0.85, 0.012)], b.mat(), (x, 0))
    edge, out = x + r * 0.95, b.w / 2 - 0.006
    b.path(
        [(edge, 0, b.h * 0.22), (out, 0, b.h * 0.3), (out, 0, b.h * 0.7), (edge, 0, b.h * 0.8)],
        0.006,
        b.mat(),
        "handle",
    )


@receptacles("plate")
def _plate_face(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    return [surface("top", (-w * 0.3, w * 0.3, -d * 0.3, d * 0.3), h * 0.4, 0.3, round_=True)]


@recipe("plate")
def plate(b: Builder) -> None:
    """Flat dish with a rim."""
    h = b.h
    b.lathe([(0.28, 0), (0.3, h * 0.2), (0.5, h * 0.92), (0.49, h), (0.32, h * 0.4)], b.mat(), n=28, stretch=(b.w, b.d))


@recipe("pan")
def pan(b: Builder) -> None:
    """Frying pan, its handle to the back."""
    r = min(b.w / 2, b.d * 0.34)
    y = b.d / 2 - r
    sx = b.w / 2 / r
    b.lathe(
        [(r * 0.8, 0), (r, b.h * 0.85), (r * 0.96, b.h * 0.85), (r * 0.78, b.h * 0.12)],
        b.mat(),
        (0, y),
        n=24,
        stretch=(sx, 1.0),
    )
    b.box((-0.012, 0.012), (-b.d / 2, y - r * 0.95), (b.h * 0.6, b.h), "plastic_black", "handle")


@recipe("fruit_bowl")
def fruit_bowl(b: Builder) -> None:
    """Bowl heaped with fruit."""
    low = b.h * 0.6
    b.lathe([(r, z * low) for r, z in _PROFILES["bowl"]], b.mat(), n=24, stretch=(b.w, b.d))
    r = b.w * 0.14
    for k, (x, y, color) in enumerate(
        (
            (-0.2, -0.1, "red"),
            (0.15, -0.18, "orange"),
            (0.02, 0.2, "green"),
            (0.22, 0.1, "red"),
            (-0.18, 0.16, "orange"),
        )
    ):
        b.ball((x * b.w, y * b.d, low * 0.85 + 0.004 * k), (r, r, r), f"food_{color}", "fruit", 10, solid=False)
    b.ball((0, 0, b.h - r), (r, r, r), "food_yellow", "fruit", 10, solid=False)


@recipe("pen_cup")
def pen_cup(b: Builder) -> None:
    """Cup with pens."""
    low = b.h * 0.55
    b.lathe([(0.48, 0), (0.5, low), (0.45, low), (0.42, 0.01)], b.mat(), n=14, stretch=(b.w, b.d))
    for k, color in enumerate(("plastic_red", "plastic_blue", "plastic_black", "wood_yellow")):
        x, y = (0.16, -0.16)[k % 2] * b.w, (0.15, -0.1)[k // 2] * b.d
        b.rod((x * 0.5, y * 0.5, 0.01), (x, y, b.h - 0.012 * k), 0.005, color, "pens", 6)


@recipe("tube_rack")
def tube_rack(b: Builder) -> None:
    """Stand with test tubes."""
    w, d, h = b.w, b.d, b.h
    for z in (0.0, h * 0.55):
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (z, z + h * 0.08), b.mat(), "rack")
    for sx in (-1, 1):
        b.box(
            (sx * w / 2 - (0.01 if sx > 0 else 0), sx * w / 2 + (0.01 if sx < 0 else 0)),
            (-d / 2, d / 2),
            (0, h * 0.6),
            b.mat(),
            "rack",
        )
    for k in range(6):
        x = -w * 0.38 + k * w * 0.152
        b.cyl(x, 0, (h * 0.1, h), w * 0.04, "glass_clear", "tubes", n=8, solid=False)
        b.cyl(
            x,
            0,
            (h * 0.1, h * (0.4 + 0.05 * (k % 3))),
            w * 0.034,
            ("glass_red", "glass_blue", "glass_green")[k % 3],
            "fluid",
            n=8,
            solid=False,
        )
