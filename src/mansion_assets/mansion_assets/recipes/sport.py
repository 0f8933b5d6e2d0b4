"""Training machines, punching bag, trampoline."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("treadmill")
def treadmill(b: Builder) -> None:
    """Belt, uprights, console; the runner faces the back (-y)."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0.04, 0.14), b.mat(), "deck")
    b.box((-w * 0.32, w * 0.32), (-d * 0.3, d * 0.49), (0.14, 0.15), "rubber_black", "belt")
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.3), (0, 0.24), "plastic_dark", "hood")
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.04)
        b.rod((x, -d * 0.38, 0.15), (x, -d * 0.3, h * 0.85), 0.03, b.mat(), "posts", solid=True)
        b.rod((x, -d * 0.3, h * 0.72), (x, 0.0, h * 0.7), 0.022, "rubber_black", "bars")
        b.box((x - 0.03, x + 0.03), (d * 0.3, d / 2), (0, 0.05), "plastic_dark", "feet")
    b.prism(
        [(-d * 0.36, h * 0.78), (-d * 0.24, h * 0.8), (-d * 0.3, h), (-d * 0.34, h)],
        (-w * 0.46, w * 0.46),
        "plastic_black",
        part="console",
    )
    b.prism(
        [(-d * 0.24, h * 0.82), (-d * 0.235, h * 0.82), (-d * 0.295, h * 0.98), (-d * 0.3, h * 0.98)],
        (-w * 0.28, w * 0.28),
        "screen_blue",
        part="screen",
        solid=False,
    )


@recipe("exercise_bike")
def exercise_bike(b: Builder) -> None:
    """Stationary bicycle."""
    w, d, h = b.w, b.d, b.h
    for y in (-d / 2 + 0.04, d / 2 - 0.04):
        b.rod((-w / 2, y, 0.04), (w / 2, y, 0.04), 0.04, b.mat(), "feet", 12, True)
    b.rod((0, -d / 2 + 0.04, 0.06), (0, d / 2 - 0.04, 0.1), 0.04, b.mat(), "beam", 10, True)
    b.rod((-0.05, d * 0.22, 0.36), (0.05, d * 0.22, 0.36), 0.25, "metal_steel", "wheel", 24, True)
    b.rod((0, -d * 0.1, 0.15), (0, -d * 0.24, h * 0.72), 0.03, b.mat(), "post", solid=True)
    b.cushion((-0.12, 0.12), (-d * 0.38, -d * 0.14), (h * 0.72, h * 0.78), "leather_black", "saddle", 0.7)
    b.rod((0, d * 0.16, 0.3), (0, d * 0.3, h * 0.85), 0.03, b.mat(), "post", solid=True)
    b.path(
        [(-0.2, d * 0.14, h * 0.88), (-0.2, d * 0.3, h * 0.84), (0.2, d * 0.3, h * 0.84), (0.2, d * 0.14, h * 0.88)],
        0.018,
        "rubber_black",
        "bar",
    )
    b.box((-0.14, 0.14), (d * 0.3, d * 0.34), (h * 0.84, h), "plastic_black", "console")
    b.rod((-0.18, 0.0, 0.3), (0.18, 0.0, 0.38), 0.02, "metal_dark", "pedals")


@recipe("elliptical")
def elliptical(b: Builder) -> None:
    """Cross trainer: wheel, long pedals, moving bars."""
    w, d, h = b.w, b.d, b.h
    b.box((-w * 0.4, w * 0.4), (d * 0.4, d / 2), (0, 0.08), b.mat(), "feet")
    b.box((-w * 0.4, w * 0.4), (-d / 2, -d * 0.42), (0, 0.08), b.mat(), "feet")
    b.box((-0.05, 0.05), (-d * 0.45, d * 0.45), (0.04, 0.12), b.mat(), "beam")
    b.rod((-0.08, -d * 0.32, 0.36), (0.08, -d * 0.32, 0.36), 0.3, "plastic_dark", "wheel", 24, True)
    b.rod((0, d * 0.3, 0.1), (0, d * 0.24, h * 0.85), 0.04, b.mat(), "post", solid=True)
    for sx in (-1, 1):
        x = sx * w * 0.3
        b.rod((x, -d * 0.34, 0.34 + 0.1 * sx), (x, d * 0.3, 0.22), 0.025, b.mat(), "levers")
        b.box((x - 0.08, x + 0.08), (-d * 0.05, d * 0.12), (0.28, 0.33), "rubber_black", "pedals")
        b.path(
            [(x, d * 0.3, 0.25), (sx * w * 0.44, d * 0.22, h * 0.6), (sx * w * 0.48, d * 0.1, h - 0.02)],
            0.02,
            b.mat(),
            "bars",
        )
    b.box((-0.17, 0.17), (d * 0.2, d * 0.25), (h * 0.78, h * 0.94), "plastic_black", "console")


@recipe("rower")
def rower(b: Builder) -> None:
    """Rail, sliding seat, flywheel, handle."""
    w, d, h = b.w, b.d, b.h
    b.box((-0.05, 0.05), (-d * 0.2, d / 2), (0.28, 0.36), b.mat(), "rail")
    b.box((-0.15, 0.15), (d * 0.1, d * 0.24), (0.36, 0.43), "leather_black", "seat")
    b.rod((-0.1, -d * 0.36, 0.38), (0.1, -d * 0.36, 0.38), 0.28, "plastic_dark", "wheel", 24, True)
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.46), (0, 0.06), b.mat(), "feet")
    b.box((-w * 0.3, w * 0.3), (d * 0.44, d / 2), (0, 0.06), b.mat(), "feet")
    b.box((-0.03, 0.03), (d * 0.44, d * 0.48), (0.05, 0.3), b.mat(), "feet")
    for sx in (-1, 1):
        b.box((sx * 0.16 - 0.06, sx * 0.16 + 0.06), (-d * 0.22, -d * 0.12), (0.18, 0.42), "plastic_black", "footrests")
    b.rod((0, -d * 0.36, 0.5), (0, -d * 0.28, h - 0.05), 0.02, b.mat(), "arm")
    b.box((-0.12, 0.12), (-d * 0.3, -d * 0.27), (h - 0.2, h), "plastic_black", "monitor")
    b.rod((-0.25, -d * 0.18, 0.55), (0.25, -d * 0.18, 0.55), 0.016, "rubber_black", "handle")


@recipe("punching_bag")
def punching_bag(b: Builder) -> None:
    """Standing bag on a weighted foot."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.5, 0), (0.5, 0.1), (0.35, 0.35), (0.12, 0.45)], "plastic_black", stretch=(w, d), part="foot", n=24)
    b.lathe([(0.2, h * 0.3), (0.3, h * 0.34), (0.3, h * 0.96), (0.22, h)], b.mat(), stretch=(w, d), part="bag", n=24)


@recipe("trampoline")
def trampoline(b: Builder) -> None:
    """Round mat in a padded ring on legs."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.42, h - 0.03), (0.5, h - 0.05), (0.5, h), (0.42, h)], "plastic_blue", stretch=(w, d), part="ring", n=32)
    b.lathe([(0.42, h - 0.035), (0.42, h - 0.02)], b.mat(), stretch=(w, d), part="mat", n=32)
    for k in range(6):
        a = k * math.pi / 3
        b.cyl(math.cos(a) * w * 0.46, math.sin(a) * d * 0.46, (0, h - 0.05), 0.016, "metal_steel", "legs", n=8)
