"""Places to work at: benches, cubicles, lecterns, dressing tables, consoles."""

import math
from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, surface
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@recipe("counter_bench")
def lab_bench(b: Builder) -> None:
    """Laboratory bench: cabinets, resistant top, service rail."""
    w, d, h = b.w, b.d, b.h
    b.box(
        (-w / 2, w / 2),
        (-d / 2, d / 2),
        (h - 0.03, h),
        "stone_black" if b.mat() == "plastic_white" else "plastic_light",
        "top",
    )
    count = max(2, round(w / 0.6))
    for k in range(count):
        x0 = -w / 2 + 0.03 + k * (w - 0.06) / count
        x1 = x0 + (w - 0.06) / count
        if k == count // 2:
            continue
        b.box((x0, x1 - 0.01), (-d / 2 + 0.05, d / 2 - 0.06), (0.08, h - 0.03), b.mat(), "cabinets")
        for z0, z1 in ((0.1, h * 0.6), (h * 0.62, h - 0.05)):
            b.box((x0 + 0.01, x1 - 0.02), (d / 2 - 0.06, d / 2 - 0.045), (z0, z1), b.mat(), "fronts", solid=False)
            b.box(
                ((x0 + x1) / 2 - 0.06, (x0 + x1) / 2 + 0.06),
                (d / 2 - 0.045, d / 2 - 0.03),
                (z1 - 0.05, z1 - 0.035),
                "metal_steel",
                "handles",
                solid=False,
            )
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.02)
        b.box((x - 0.02, x + 0.02), (-d / 2 + 0.02, d / 2 - 0.05), (0, h - 0.03), "metal_grey", "frame")


@recipe("workbench")
def workbench(b: Builder) -> None:
    """Thick top, stout legs, lower shelf, vise at the front."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.06), (h - 0.07, h), b.mat(), "top")
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (w / 2 - 0.1), sy * (d / 2 - 0.12)
            b.box((x - 0.045, x + 0.045), (y - 0.045, y + 0.045), (0, h - 0.07), "metal_blue", "legs")
    b.box((-w / 2 + 0.06, w / 2 - 0.06), (-d / 2 + 0.08, d / 2 - 0.14), (0.16, 0.19), b.mat(), "shelf")
    b.box((-w / 2 + 0.1, -w / 2 + 0.3), (d / 2 - 0.06, d / 2), (h - 0.16, h - 0.02), "metal_dark", "vise")
    b.rod((-w / 2 + 0.1, d / 2 - 0.01, h - 0.1), (-w / 2 + 0.3, d / 2 - 0.01, h - 0.1), 0.01, "metal_steel", "vise")
    for k, color in enumerate(("plastic_red", "plastic_blue", "metal_grey")):
        x = -w / 2 + 0.35 + k * 0.3
        if x + 0.12 < w / 2:
            b.box((x, x + 0.24), (-d / 2 + 0.12, 0.1), (0.19, 0.36), color, "boxes", solid=False)


@receptacles("cubicle")
def _cubicle_top(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, _ = size
    box = (-w / 2 + 0.07, w / 2 - 0.07, -d / 2 + 0.07, -d / 2 + min(0.75, d * 0.8) - 0.03)
    return [surface("top", box, 0.74, 1.0)]


@recipe("cubicle")
def cubicle(b: Builder) -> None:
    """Desk within three screens."""
    w, d, h = b.w, b.d, b.h
    t = 0.05
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + t), (0, h), b.mat(), "screen")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - t)))
        b.box((lo, hi), (-d / 2 + t, d / 2), (0, h), b.mat(), "screen")
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, -d / 2 + min(0.75, d * 0.8)), (0.71, 0.74), "wood_white", "top")
    b.box(
        (-w / 2 + t, -w / 2 + t + 0.35), (-d / 2 + t, -d / 2 + min(0.6, d * 0.7)), (0.05, 0.6), "metal_grey", "drawers"
    )


@recipe("lectern")
def lectern(b: Builder) -> None:
    """Standing desk for a speaker, its sloped top towards the back."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2 + 0.04, w / 2 - 0.04), (-d / 2 + 0.03, d / 2 - 0.03), (0, 0.05), b.mat(), "foot")
    b.box((-w / 2 + 0.07, w / 2 - 0.07), (-d * 0.15, d / 2 - 0.04), (0.04, h - 0.16), b.mat(), "body")
    b.prism(
        [(-d / 2, h - 0.18), (-d / 2, h - 0.13), (d / 2, h), (d / 2, h - 0.05)], (-w / 2, w / 2), b.mat(), part="top"
    )
    b.box((-0.1, 0.1), (d / 2 - 0.045, d / 2 - 0.035), (h * 0.5, h * 0.7), "metal_steel", "plate", solid=False)


@receptacles("salon_station")
def _salon_shelf(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, _ = size
    return [surface("shelf", (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.07, d / 2 - 0.02), 0.82, 0.8)]


@recipe("salon_station")
def salon_station(b: Builder) -> None:
    """Mirror with lights above a shelf and drawers, a hair dryer, scissors on the wall, and the word SALON."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.04), (0, h), b.mat(), "panel")
    b.box((-w / 2, w / 2), (-d / 2 + 0.04, d / 2), (0.78, 0.82), b.mat(), "shelf")
    b.box((-w / 2 + 0.03, -w / 2 + 0.4), (-d / 2 + 0.04, d / 2 - 0.05), (0.35, 0.78), b.mat(), "drawers")
    b.box(
        (-w / 2 + 0.12, w / 2 - 0.12),
        (-d / 2 + 0.04, -d / 2 + 0.055),
        (0.95, h - 0.1),
        "glass_mirror",
        "mirror",
        solid=False,
    )
    for sx in (-1, 1):
        for k in range(4):
            z = 1.0 + k * (h - 1.2) / 3
            b.ball((sx * (w / 2 - 0.06), -d / 2 + 0.06, z), (0.03, 0.03, 0.03), "light_warm", "bulbs", 8, solid=False)
    face = DrawnFace.front(b, -d / 2 + 0.055)
    face.write("SALON", (-w * 0.3, w * 0.3), (h - 0.3, h - 0.16), "plastic_black", "letters", 0.004)
    x, y = -w * 0.3, d * 0.1
    b.rod((x, y, 0.72), (x, y, 0.56), 0.022, "plastic_black", "dryer", 10)
    b.rod((x + 0.09, y, 0.73), (x - 0.12, y, 0.73), 0.04, "paint_red", "dryer", 14)
    b.rod((x - 0.12, y, 0.73), (x - 0.18, y, 0.73), 0.026, "plastic_black", "dryer", 12)
    for side in (-1, 1):
        face.line([(-side * 0.06, 1.06), (side * 0.05, 1.34)], 0.01, "metal_dark", "scissors", 0.004)
        ring = [
            (-side * 0.075 + math.cos(a) * 0.035, 1.03 + math.sin(a) * 0.035)
            for a in (k * math.tau / 10 for k in range(11))
        ]
        face.line(ring, 0.009, "plastic_black", "scissors", 0.004)


@receptacles("control_desk")
def _control_desk_top(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, _ = size
    return [surface("top", (-w / 2 + 0.04, w / 2 - 0.04, 0.2, d / 2 - 0.02), 0.75, 1.0)]


@recipe("control_desk")
def control_desk(b: Builder) -> None:
    """Operator's console: desk with a row of screens."""
    w, d, h = b.w, b.d, b.h
    z = 0.75
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - 0.04, z), b.mat(), "top")
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.04)
        b.box((x - 0.04, x + 0.04), (-d / 2 + 0.02, d / 2 - 0.1), (0, z - 0.04), b.mat(), "legs")
    b.box((-w / 2 + 0.08, w / 2 - 0.08), (-d / 2 + 0.05, -d / 2 + 0.1), (0.1, z - 0.04), b.mat(), "back")
    count = max(2, round(w / 0.62))
    for k in range(count):
        x = -w / 2 + (k + 0.5) * w / count
        half = w / count / 2 - 0.02
        b.box((x - half, x + half), (-d / 2 + 0.1, -d / 2 + 0.13), (z + 0.12, h), "plastic_black", "screens")
        b.box(
            (x - half + 0.012, x + half - 0.012),
            (-d / 2 + 0.13, -d / 2 + 0.133),
            (z + 0.135, h - 0.015),
            "screen_blue",
            "screens",
            solid=False,
        )
        b.box(
            (x - 0.03, x + 0.03), (-d / 2 + 0.09, -d / 2 + 0.12), (z, z + 0.14), "plastic_black", "stands", solid=False
        )
        b.box((x - 0.2, x + 0.2), (0.05, 0.19), (z, z + 0.02), "plastic_dark", "keyboards", solid=False)
