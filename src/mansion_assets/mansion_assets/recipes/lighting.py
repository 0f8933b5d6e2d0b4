"""Lamps: floor, table, desk, wall and ceiling."""

import math

import numpy as np

from mansion_assets.builder import Builder
from mansion_assets.convex import revolved_bodies
from mansion_assets.registry import recipe
from mansion_assets.solids import revolved

__all__: list[str] = []


@recipe("lamp")
def lamp(b: Builder) -> None:
    """Foot, stem and shade; desk lamps with a bent arm."""
    w, d, h = b.w, b.d, b.h
    style = b.p.get("style", "floor")
    r = min(w, d) / 2
    metal = "metal_black" if b.mat() != "metal_black" else "metal_steel"
    if style == "desk":
        b.lathe([(0.34, 0), (0.34, 0.015), (0.1, 0.03)], b.mat(), (0, -d * 0.2), "foot", 20, (w, w))
        b.path([(0, -d * 0.2, 0.02), (0, -d * 0.42, h * 0.55), (0, d * 0.1, h - 0.03)], 0.009, b.mat(), "arm")
        b.lathe(
            [(0.5, h * 0.72), (0.2, h - 0.01), (0.12, h), (0.1, h)],
            b.mat(),
            (0, d / 2 - min(w, d) / 2),
            "shade",
            20,
            (min(w, d), min(w, d)),
        )
        b.ball((0, d / 2 - min(w, d) / 2, h * 0.75), (r * 0.4, r * 0.4, h * 0.05), "light_warm", "bulb", 8, solid=False)
        return
    shade = h * (0.82 if style == "floor" else 0.55)
    b.lathe([(0.6, 0), (0.6, 0.02), (0.1, 0.035)], metal, part="foot", n=20, stretch=(r, r))
    if style == "table":
        b.lathe(
            [(0.35, 0.02), (0.55, h * 0.2), (0.2, h * 0.45), (0.1, h * 0.55)],
            "ceramic_white",
            part="body",
            n=18,
            stretch=(r, r),
        )
    b.cyl(0, 0, (0.02, shade + 0.05), 0.012, metal, "stem", n=10)
    b.lathe([(0.5, shade), (0.36, h), (0.34, h), (0.48, shade + 0.004)], b.mat(), part="shade", n=24, stretch=(w, d))
    b.ball((0, 0, shade + (h - shade) * 0.4), (0.04, 0.04, 0.05), "light_warm", "bulb", 8, solid=False)


@recipe("dome")
def dome(b: Builder) -> None:
    """Flat ceiling lamp: a lit dome in a rim."""
    w, d, h = b.w, b.d, b.h
    b.lathe(
        [(0.1, 0), (0.35, h * 0.15), (0.46, h * 0.55), (0.48, h * 0.8)],
        "light_warm",
        stretch=(w, d),
        part="glass",
        n=28,
    )
    b.lathe([(0.5, h * 0.75), (0.5, h)], "metal_steel", stretch=(w, d), part="rim", n=28)


@recipe("pendant")
def pendant(b: Builder) -> None:
    """Shade on a cable; chandeliers with arms."""
    w, d, h = b.w, b.d, b.h
    b.cyl(0, 0, (h - 0.03, h), min(0.06, w * 0.2), "metal_black", "rose", n=16, solid=False)
    b.cyl(0, 0, (h * 0.4, h - 0.02), 0.006, "plastic_black", "cable", n=6, solid=False)
    if b.p.get("style") == "arms":
        b.lathe(
            [(0.02, 0.0), (0.08, h * 0.08), (0.03, h * 0.2), (0.05, h * 0.4), (0.01, h * 0.45)],
            b.mat(),
            part="stem",
            n=14,
            stretch=(w, d),
        )
        for k in range(8):
            a = k * math.pi / 4
            x, y = math.cos(a) * (w / 2 - 0.035), math.sin(a) * (d / 2 - 0.035)
            b.path([(0, 0, h * 0.12), (x * 0.6, y * 0.6, h * 0.06), (x, y, h * 0.16)], 0.009, b.mat(), "arms")
            b.cyl(x, y, (h * 0.15, h * 0.17), 0.035, b.mat(), "cups", n=10, solid=False)
            b.ball((x, y, h * 0.22), (0.018, 0.018, 0.04), "light_warm", "bulbs", 8, solid=False)
        return
    top = min(0.3, h * 0.5)
    b.lathe(
        [(0.5, 0), (0.42, top * 0.4), (0.12, top), (0.1, top), (0.4, top * 0.38), (0.47, 0.004)],
        b.mat(),
        part="shade",
        n=24,
        stretch=(w, d),
    )
    b.ball((0, 0, top * 0.3), (0.05, 0.05, 0.06), "light_warm", "bulb", 10, solid=False)


@recipe("track")
def track(b: Builder) -> None:
    """Rail with spots."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d * 0.15, d * 0.15), (h - 0.03, h), b.mat(), "rail")
    for k in range(3):
        x = -w * 0.35 + k * w * 0.35
        b.rod((x, 0, h - 0.03), (x, 0, h * 0.55), 0.008, b.mat(), "arms")
        b.rod(
            (x, -d / 2 + 0.03, h * 0.62),
            (x, d / 2 - 0.02, h * 0.2),
            min(0.035, h * 0.2),
            b.mat(),
            "spots",
            14,
            solid=True,
        )
        b.rod((x, d / 2 - 0.02, h * 0.2), (x, d / 2 - 0.012, h * 0.17), min(0.03, h * 0.17), "light_warm", "lens", 14)


@recipe("bright_panel")
def bright_panel(b: Builder) -> None:
    """A lamp in the plane of a ceiling: a white frame round a lit diffuser that bars part."""
    w, d, h = b.w, b.d, b.h
    rim = min(w, d) * 0.08
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.3, h), b.mat(), "case")
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * (w / 2 - rim))), sorted((side * d / 2, side * (d / 2 - rim)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (0, h * 0.4), b.mat(), "frame")
        b.box((-w / 2, w / 2), (along[0], along[1]), (0, h * 0.4), b.mat(), "frame")
    b.box((-w / 2 + rim, w / 2 - rim), (-d / 2 + rim, d / 2 - rim), (h * 0.12, h * 0.4), "light_white", "diffuser")
    for k in range(1, max(2, round(w / 0.15))):
        x = -w / 2 + k * w / max(2, round(w / 0.15))
        b.box(
            (x - h * 0.08, x + h * 0.08),
            (-d / 2 + rim, d / 2 - rim),
            (0, h * 0.2),
            "metal_chrome",
            "louvres",
            solid=False,
        )


@recipe("bracket_lamp")
def bracket_lamp(b: Builder) -> None:
    """A round plate on the wall, an arm that curves up from it, and a lit shade of cloth; a switch hangs down."""
    w, d, h = b.w, b.d, b.h
    back, y = -d / 2, d * 0.1
    arm = b.mat() if not b.mat().startswith("fabric") else "metal_brass"
    b.rod((0, back, h * 0.26), (0, back + d * 0.08, h * 0.26), w * 0.32, arm, "plate", 20, solid=True)
    b.rod((0, back + d * 0.06, h * 0.26), (0, back + d * 0.12, h * 0.26), w * 0.14, arm, "plate", 16)
    b.path(
        [(0, back + d * 0.1, h * 0.26), (0, -d * 0.1, h * 0.2), (0, y, h * 0.26), (0, y, h * 0.5)], w * 0.05, arm, "arm"
    )
    b.cyl(0, y, (h * 0.36, h * 0.4), w * 0.14, arm, "socket", n=14)
    r = min(w / 2, d * 0.4)
    b.lathe([(r, h * 0.44), (r * 0.6, h), (r * 0.56, h), (r * 0.96, h * 0.445)], "light_fff1d0", (0, y), "shade", 22)
    for z, share in ((h * 0.44, 1.02), (h * 0.98, 0.64)):
        b.lathe([(r * share, z), (r * share, z + h * 0.02)], arm, (0, y), "rims", 22)
    b.ball((0, y, h * 0.44), (r * 0.3, r * 0.3, h * 0.08), "light_white", "bulb", 10)
    b.rod((w * 0.1, y, h * 0.02), (w * 0.1, y, h * 0.4), w * 0.014, arm, "switch", 6)
    b.ball((w * 0.1, y, h * 0.02), (w * 0.04, w * 0.04, h * 0.02), arm, "switch", 8)


@recipe("surgical_light")
def surgical_light(b: Builder) -> None:
    """Lamp head on a jointed ceiling arm."""
    w, d, h = b.w, b.d, b.h
    b.cyl(0, -d * 0.3, (h - 0.05, h), 0.12, b.mat(), "rose", n=20)
    b.rod((0, -d * 0.3, h), (0, -d * 0.3, h * 0.5), 0.035, b.mat(), "arm")
    b.rod((0, -d * 0.3, h * 0.5), (0, 0.1, h * 0.42), 0.03, b.mat(), "arm")
    b.lathe([(0.46, 0.0), (0.5, 0.06), (0.36, 0.14), (0.1, 0.2)], b.mat(), (0, 0), "head", 32, (w, d))
    b.lathe([(0.07, -0.1), (0.05, 0.0)], "plastic_4f9bd9", (0, 0), "grip", 16, (w * 0.6, d * 0.6))
    for k in range(7):
        a = k * 2 * math.pi / 6
        r = 0.28 if k < 6 else 0.0
        b.cyl(
            math.cos(a) * r * w, math.sin(a) * r * d, (-0.012, 0.004), 0.085, "light_fff6df", "lamps", n=16, solid=False
        )


@recipe("studio_light")
def studio_light(b: Builder) -> None:
    """Soft box on a tripod."""
    w, d, h = b.w, b.d, b.h
    for k in range(3):
        a = math.pi / 2 + k * 2 * math.pi / 3
        b.rod((0, 0, 0.25), (math.cos(a) * w * 0.48, math.sin(a) * d * 0.48, 0.015), 0.012, "metal_black", "legs")
    b.cyl(0, 0, (0.02, h - 0.2), 0.016, "metal_black", "pole")
    b.prism(
        [(-d * 0.2, h - 0.16), (-d * 0.2, h - 0.3), (d / 2, h - 0.6), (d / 2, h)],
        (-w * 0.4, w * 0.4),
        b.mat(),
        part="box",
    )
    b.box((-w / 2, w / 2), (d / 2 - 0.02, d / 2), (h - 0.6, h), "light_white", "front", solid=False)


_FACETS = ("metal_white", "metal_grey", "metal_light", "metal_dark", "metal_chrome", "plastic_8fb6d9", "metal_light")
"""What the mirrors of a disco ball reflect."""


@recipe("disco_ball")
def disco_ball(b: Builder) -> None:
    """A ball of small mirrors, each of which reflects something else, on a chain below a motor."""
    w, h = b.w, b.h
    r, sides, bands = w / 2, 22, 13
    rise = h * 0.42
    profile = [
        (math.cos(a) * r, rise + math.sin(a) * h * 0.42) for a in np.linspace(-math.pi / 2, math.pi / 2, bands + 1)
    ]
    vertices, faces = revolved(profile, (0.0, 0.0), sides, (1.0, 1.0))
    bodies = revolved_bodies(profile, (0.0, 0.0), sides, (1.0, 1.0))
    numbers = np.arange(len(faces))
    band, side = numbers // (2 * sides), numbers % sides
    marks = (band * 5 + side * 3 + (band * side) % 4) % len(_FACETS)
    for mark, color in enumerate(_FACETS):
        b.raw(vertices, faces[marks == mark], color, f"mirrors_{mark}", bodies=bodies)
    for mark, color in enumerate(("light_pink", "light_yellow", "light_white", "light_4f9bf0")):
        a, tilt = 0.3 + 0.45 * mark, 0.5 - 0.35 * mark
        spot = (math.cos(a) * math.cos(tilt) * r, math.sin(a) * math.cos(tilt) * r, rise + math.sin(tilt) * h * 0.42)
        b.ball(spot, (r * 0.06, r * 0.06, r * 0.06), color, "glints", 8)
    b.cyl(0, 0, (h * 0.83, h * 0.94), r * 0.04, "metal_dark", "chain", n=8)
    b.cyl(0, 0, (h * 0.92, h), r * 0.3, "plastic_black", "motor", n=16)
