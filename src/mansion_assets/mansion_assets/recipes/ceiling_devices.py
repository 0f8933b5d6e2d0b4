"""Devices that hang from ceilings, drawn as who stands below them sees them."""

import math

import numpy as np

from mansion_assets.builder import Builder
from mansion_assets.convex import revolved_bodies
from mansion_assets.registry import recipe
from mansion_assets.solids import revolved

__all__: list[str] = []

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


@recipe("sprinkler")
def sprinkler(b: Builder) -> None:
    """A cover plate, a threaded neck, a frame of two arms about a red bulb, and a toothed plate that spreads water."""
    w, h = b.w, b.h
    r = w / 2
    b.lathe([(r * 0.8, h), (r, h * 0.96), (r * 0.9, h * 0.9)][::-1], "plastic_white", part="cover", n=24)
    b.cyl(0, 0, (h * 0.66, h * 0.92), r * 0.3, "metal_brass", "neck", n=12)
    for side in (-1, 1):
        arm = [(side * r * 0.28, 0, h * 0.7), (side * r * 0.5, 0, h * 0.45), (side * r * 0.12, 0, h * 0.12)]
        b.path(arm, r * 0.09, "metal_brass", "frame")
    b.cyl(0, 0, (h * 0.18, h * 0.68), r * 0.12, "light_red", "bulb", n=10)
    b.cyl(0, 0, (h * 0.05, h * 0.13), r * 0.34, "metal_brass", "spreader", n=16)
    for k in range(10):
        a = k * math.pi / 5
        b.rod(
            (math.cos(a) * r * 0.3, math.sin(a) * r * 0.3, h * 0.09),
            (math.cos(a) * r * 0.62, math.sin(a) * r * 0.62, h * 0.03),
            r * 0.07,
            "metal_brass",
            "spreader",
            5,
        )
    b.cyl(0, 0, (0, h * 0.06), r * 0.1, "metal_brass", "screw", n=8)


@recipe("smoke_detector")
def smoke_detector(b: Builder) -> None:
    """A white dish with a ring of slits for smoke between two rims, a test button and a red lamp."""
    w, h = b.w, b.h
    r = w / 2
    b.lathe([(r * 0.96, h * 0.62), (r, h * 0.7), (r, h)], b.mat(), part="base", n=28)
    b.lathe([(r * 0.78, h * 0.28), (r * 0.78, h * 0.64)], "plastic_black", part="chamber", n=28)
    for k in range(16):
        a = k * math.pi / 8
        x, y = math.cos(a) * r * 0.82, math.sin(a) * r * 0.82
        b.cyl(x, y, (h * 0.26, h * 0.64), r * 0.05, b.mat(), "ribs", n=6)
    b.lathe([(r * 0.6, 0.06 * h), (r * 0.86, h * 0.14), (r * 0.86, h * 0.3)], b.mat(), part="cap", n=28)
    b.cyl(0, 0, (0, h * 0.1), r * 0.24, "plastic_grey", "button", n=18)
    b.ball((r * 0.5, r * 0.28, h * 0.09), (r * 0.08, r * 0.08, h * 0.06), "light_red", "lamp", 8)


@recipe("ceiling_speaker")
def ceiling_speaker(b: Builder) -> None:
    """A white ring round the black cone of a loudspeaker, with a dust cap in its middle behind a cross of bars."""
    w, h = b.w, b.h
    r = w / 2
    b.lathe([(r * 0.84, h * 0.3), (r * 0.84, h)], "metal_dark", part="case", n=28)
    b.lathe([(r * 0.8, 0), (r, h * 0.1), (r, h * 0.34), (r * 0.8, h * 0.34)], b.mat(), part="ring", n=32)
    for share, color in ((0.82, "rubber_black"), (0.7, "metal_grey"), (0.64, "rubber_black"), (0.3, "metal_light")):
        b.cyl(0, 0, (-h * 0.004 - h * 0.06 * (1 - share), h * 0.3), r * share, color, "cone", n=28)
    b.ball((0, 0, -h * 0.02), (r * 0.22, r * 0.22, h * 0.14), "metal_light", "cap", 12)
    for k in range(12):
        a = k * math.pi / 6
        b.cyl(
            math.cos(a) * r * 0.76,
            math.sin(a) * r * 0.76,
            (-h * 0.03, h * 0.2),
            r * 0.025,
            "metal_steel",
            "screws",
            n=6,
        )


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
