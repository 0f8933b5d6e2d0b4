"""Clocks and watches."""

import itertools
import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


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


@recipe("long_case_clock")
def long_case_clock(b: Builder) -> None:
    """A tall case: a plinth, a waist with a glass door on a brass pendulum and weights, and a hood with the dial."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.2), main, "plinth")
    x, t = w * 0.36, 0.02
    b.box((-x, x), (-d / 2, -d * 0.4), (h * 0.2, h * 0.7), main, "waist")
    for side in (-1, 1):
        ends = sorted((side * x, side * (x - t * 2)))
        b.box((ends[0], ends[1]), (-d / 2, d * 0.4), (h * 0.2, h * 0.7), main, "waist")
    b.box((-x, x), (-d * 0.39, -d * 0.37), (h * 0.2, h * 0.7), "wood_black", "waist", solid=False)
    b.rod((0, 0, h * 0.36), (0, 0, h * 0.7), 0.01, "metal_brass", "pendulum")
    b.rod((0, -0.01, h * 0.34), (0, 0.02, h * 0.34), w * 0.16, "metal_brass", "pendulum", 24)
    for side, z in ((-1, 0.44), (1, 0.5)):
        b.cyl(side * w * 0.2, 0, (h * z, h * (z + 0.09)), 0.028, "metal_brass", "weights", n=14)
    b.box((-w * 0.47, w * 0.47), (-d / 2, d * 0.46), (h * 0.7, h * 0.94), main, "hood")
    b.prism(
        [(-w / 2, h * 0.94), (w / 2, h * 0.94), (w * 0.3, h * 0.97), (0, h), (-w * 0.3, h * 0.97)],
        (-d / 2, d / 2),
        main,
        "y",
        "hood",
    )
    z, r = h * 0.82, w * 0.36
    b.rod((0, d * 0.45, z), (0, d * 0.48, z), r, "metal_brass", "dial", 28)
    b.rod((0, d * 0.47, z), (0, d * 0.49, z), r * 0.9, "paper_white", "dial", 28)
    for k in range(12):
        a = k * math.pi / 6
        start, end = ((math.sin(a) * r * s, d * 0.49, z + math.cos(a) * r * s) for s in (0.68, 0.82))
        b.rod(start, end, 0.006, "plastic_black", "dial", 4)
    for a, reach in ((5.2, 0.45), (0.9, 0.66)):
        b.rod(
            (0, d * 0.49, z),
            (math.sin(a) * r * reach, d * 0.49, z + math.cos(a) * r * reach),
            0.007,
            "plastic_black",
            "hands",
            4,
        )


@recipe("watch")
def watch(b: Builder) -> None:
    """A wristwatch that lies on its side, closed: a strap with its dial to the front."""
    w, d, h = b.w, b.d, b.h
    case, thick = d * 0.22, 0.85
    rx, ry, middle = w / 2, (d - case) / 2, -case / 2
    ends = [(math.cos(a), math.sin(a)) for a in (k * math.pi / 8 for k in range(17))]
    for (c0, s0), (c1, s1) in itertools.pairwise(ends):
        outline = [
            (rx * c0, middle + ry * s0),
            (rx * c1, middle + ry * s1),
            (rx * c1 * thick, middle + ry * s1 * thick),
            (rx * c0 * thick, middle + ry * s0 * thick),
        ]
        b.prism(outline, (h * 0.18, h * 0.82), "leather_black", "z", "strap")
    front, radius = d / 2, min(h / 2, w * 0.45)
    b.rod((0, front - case, h / 2), (0, front - case * 0.2, h / 2), radius, b.mat(), "case", 20, solid=True)
    b.rod((0, front - case * 0.3, h / 2), (0, front, h / 2), radius * 0.84, "plastic_white", "dial", 20)
    for end in ((0.0, radius * 0.6), (radius * 0.42, 0.0)):
        b.rod((0, front, h / 2), (end[0], front, h / 2 + end[1]), radius * 0.06, "plastic_black", "hands", 4)
