"""Tableware: mugs, plates, glasses, teapots, flasks, napkins."""

import itertools
import math
from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, surface
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


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


@recipe("drinking_cup")
def drinking_cup(b: Builder) -> None:
    """A cup that widens to its rim, with coloured bands and an ear to hold it by."""
    h, r = b.h, b.d / 2
    x, wide = b.w / 2 - b.w * 0.39, b.w * 0.78
    profile = [(0.36, 0), (0.38, h * 0.04), (0.5, h), (0.46, h), (0.34, h * 0.06)]
    b.lathe(profile, b.mat(), (x, 0), n=24, stretch=(wide, b.d * 0.99))
    turns = [(math.cos(k * math.tau / 18), math.sin(k * math.tau / 18)) for k in range(19)]
    steps = 6
    for k in range(steps):
        low, high = h * (0.02 + 0.158 * k), h * (0.178 + 0.158 * k)
        inner, outer = (size * (0.38 + 0.12 * high / h) for size in (0.99, 1.03))
        color = ("ceramic_f58a1e", "ceramic_2f6fd0")[0 < k < steps - 1]
        for start, end in itertools.pairwise(turns):
            corners = ((start, outer), (end, outer), (end, inner), (start, inner))
            panel = [(x + u * size * wide, v * size * b.d * 0.99) for (u, v), size in corners]
            b.prism(panel, (low, high), color, "z", "bands", solid=False)
    ear = [(-0.1, 0.76), (0.5, 0.82), (0.93, 0.7), (0.93, 0.46), (0.6, 0.3), (-0.1, 0.26)]
    side, reach = x - wide * 0.43, b.w / 2 + x - wide * 0.43
    b.path([(side - reach * u, 0, h * v) for u, v in ear], r * 0.13, "ceramic_2f6fd0", "handle")


@receptacles("plate")
def _plate_face(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    return [surface("top", (-w * 0.3, w * 0.3, -d * 0.3, d * 0.3), h * 0.4, 0.3, round_=True)]


@recipe("plate")
def plate(b: Builder) -> None:
    """Flat dish with a rim."""
    h = b.h
    b.lathe([(0.28, 0), (0.3, h * 0.2), (0.5, h * 0.92), (0.49, h), (0.32, h * 0.4)], b.mat(), n=28, stretch=(b.w, b.d))


@recipe("filled_glass")
def filled_glass(b: Builder) -> None:
    """A tumbler of clear glass with a thick foot and a bright rim, two thirds full."""
    w, d, h = b.w, b.d, b.h
    stretch = (w, d)
    b.lathe([(0.38, 0), (0.5, h), (0.46, h), (0.36, h * 0.08)], b.mat(), n=24, stretch=stretch)
    b.lathe(
        [(0.37, h * 0.08), (0.445, h * 0.66)],
        str(b.p.get("drink", "plastic_8fc6ea")),
        n=24,
        stretch=stretch,
        part="drink",
        solid=False,
    )
    b.lathe([(0.495, h * 0.97), (0.5, h), (0.46, h)], "glass_white", n=24, stretch=stretch, part="rim", solid=False)
    b.lathe([(0.38, 0), (0.39, h * 0.05)], "glass_white", n=24, stretch=stretch, part="foot", solid=False)


@recipe("wine_glass")
def wine_glass(b: Builder) -> None:
    """A round foot, a thin stem and a bowl that narrows to its rim, with red wine in it."""
    w, d, h = b.w, b.d, b.h
    stretch = (w, d)
    b.lathe(
        [(0.42, 0), (0.4, h * 0.02), (0.05, h * 0.05), (0.045, h * 0.44), (0.12, h * 0.48)],
        "glass_white",
        n=24,
        stretch=stretch,
        part="stem",
    )
    b.lathe(
        [(0.12, h * 0.47), (0.44, h * 0.6), (0.5, h * 0.74), (0.4, h), (0.37, h), (0.46, h * 0.74), (0.1, h * 0.5)],
        b.mat(),
        n=24,
        stretch=stretch,
    )
    b.lathe(
        [(0.1, h * 0.49), (0.43, h * 0.61), (0.47, h * 0.74)],
        "plastic_7a1230",
        n=24,
        stretch=stretch,
        part="wine",
        solid=False,
    )


@recipe("teapot")
def teapot(b: Builder) -> None:
    """A round pot with a lid and its knob, a bent spout at one side, an ear at the other, and blue flowers."""
    w, d, h = b.w, b.d, b.h
    r = min(w * 0.3, d * 0.48)
    high = h * 0.74
    b.ball((0, 0, high * 0.52), (r, min(r, d / 2), high * 0.5), b.mat(), "pot", 22)
    b.lathe([(r * 0.6, 0), (r * 0.56, high * 0.1)], b.mat(), part="foot", n=22)
    b.lathe([(r * 0.56, high * 0.94), (r * 0.4, high * 1.08), (r * 0.14, high * 1.14)], b.mat(), part="lid", n=22)
    b.lathe([(r * 0.6, high * 0.92), (r * 0.6, high * 0.97)], "metal_brass", part="lid", n=22)
    b.ball((0, 0, h * 0.93), (r * 0.14, r * 0.14, h * 0.07), "metal_brass", "lid", 10)
    points = [
        (-r * 0.8, high * 0.34),
        (-r * 1.25, high * 0.5),
        (-r * 1.36, high * 0.8),
        (-w / 2 + r * 0.1, high * 0.98),
    ]
    for k, ((x0, z0), (x1, z1)) in enumerate(itertools.pairwise(points)):
        b.rod((x0, 0, z0), (x1, 0, z1), r * (0.2 - 0.05 * k), b.mat(), "spout", 12)
        b.ball((x1, 0, z1), (r * (0.19 - 0.05 * k), r * (0.19 - 0.05 * k), r * (0.19 - 0.05 * k)), b.mat(), "spout", 10)
    ear = [
        (r * 0.86 + math.sin(a) * (w / 2 - r * 0.95), 0.0, high * (0.55 + 0.32 * math.cos(a)))
        for a in (k * math.pi / 8 for k in range(9))
    ]
    b.path(ear, r * 0.1, b.mat(), "ear")
    color = "paint_3d6ac8" if "blue" not in b.mat() else "plastic_white"
    for k in range(5):
        a = math.radians(50 + 20 * k)
        at = (math.cos(a) * r * 0.98, math.sin(a) * min(r, d / 2) * 0.98, high * (0.5 + 0.1 * (k % 2)))
        for j in range(5):
            t = j * math.tau / 5
            b.ball(
                (at[0] + math.cos(t) * r * 0.09 * abs(math.sin(a)), at[1], at[2] + math.sin(t) * r * 0.09),
                (r * 0.055, r * 0.04, r * 0.055),
                color,
                "flowers",
                6,
            )
        b.ball(at, (r * 0.04, r * 0.05, r * 0.04), "paint_yellow", "flowers", 6)


@recipe("thermos")
def thermos(b: Builder) -> None:
    """A steel flask with a handle at its side, a neck ring, and a black cup over its stopper."""
    w, d, h = b.w, b.d, b.h
    x, r = -w * 0.1, 0.4
    b.lathe([(r * 0.95, 0), (r, h * 0.03), (r, h * 0.64), (r * 0.82, h * 0.72)], b.mat(), (x, 0), n=24, stretch=(w, d))
    for z0, z1 in ((0.0, 0.06), (0.6, 0.63)):
        b.lathe([(r * 1.02, h * z0), (r * 1.02, h * z1)], "plastic_black", (x, 0), "rings", 24, (w, d), solid=False)
    b.lathe(
        [(r * 0.78, h * 0.72), (r * 0.88, h * 0.74), (r * 0.8, h * 0.98), (r * 0.7, h)],
        "plastic_black",
        (x, 0),
        "cup",
        24,
        (w, d),
    )
    grip = [
        (x + r * w * 0.8, 0, h * 0.62),
        (w * 0.46, 0, h * 0.58),
        (w * 0.46, 0, h * 0.26),
        (x + r * w * 0.9, 0, h * 0.2),
    ]
    b.path(grip, w * 0.06, "plastic_black", "handle")


@recipe("sports_bottle")
def sports_bottle(b: Builder) -> None:
    """A clear bottle with a waist, water in it, and a screw cap with a mouthpiece and a carrying loop."""
    w, d, h = b.w, b.d, b.h
    body = [
        (0.44, 0),
        (0.48, h * 0.03),
        (0.48, h * 0.3),
        (0.4, h * 0.36),
        (0.4, h * 0.46),
        (0.48, h * 0.52),
        (0.48, h * 0.68),
        (0.24, h * 0.8),
    ]
    b.lathe(body, "plastic_9fd0f0", n=24, stretch=(w, d))
    for z in (0.12, 0.2, 0.56, 0.62):
        b.lathe(
            [(0.485, h * z), (0.5, h * (z + 0.012)), (0.485, h * (z + 0.024))],
            "plastic_6fb4e2",
            n=24,
            stretch=(w, d),
            part="ribs",
            solid=False,
        )
    b.lathe([(0.42, h * 0.34), (0.42, h * 0.48)], "paper_white", n=24, stretch=(w, d), part="label", solid=False)
    b.lathe([(0.425, h * 0.38), (0.425, h * 0.44)], b.mat(), n=24, stretch=(w, d), part="label", solid=False)
    b.lathe(
        [(0.28, h * 0.78), (0.28, h * 0.9), (0.12, h * 0.92), (0.12, h * 0.96), (0.16, h * 0.97), (0.14, h)],
        b.mat(),
        n=20,
        stretch=(w, d),
        part="cap",
    )
    loop = [
        (w * 0.26 + w * 0.1 * math.sin(a), 0.0, h * 0.84 + h * 0.05 * math.cos(a))
        for a in (k * math.pi / 6 for k in range(7))
    ]
    b.path(loop, w * 0.03, b.mat(), "loop")


@recipe("napkin_holder")
def napkin_holder(b: Builder) -> None:
    """Two looped sides of wire on a foot, and between them a pack of white napkins folded to triangles."""
    w, d, h = b.w, b.d, b.h
    b.box((-w * 0.4, w * 0.4), (-d / 2, d / 2), (0, h * 0.06), b.mat(), "foot")
    for side in (-1, 1):
        y = side * (d / 2 - 0.004)
        loop = [
            (math.cos(a) * w * 0.38, y, h * 0.06 + max(0.0, math.sin(a)) * h * 0.62)
            for a in (k * math.pi / 12 for k in range(13))
        ]
        b.path(loop, h * 0.03, b.mat(), "sides")
        inner = [
            (math.cos(a) * w * 0.2, y, h * 0.06 + math.sin(a) * h * 0.36) for a in (k * math.pi / 8 for k in range(9))
        ]
        b.path(inner, h * 0.022, b.mat(), "sides")
    count = 9
    for k in range(count):
        y = -d * 0.38 + d * 0.76 * k / count
        lean = w * 0.02 * ((k * 2) % 3 - 1)
        b.prism(
            [(-w / 2, h * 0.06), (w / 2, h * 0.06), (lean, h)],
            (y, y + d * 0.06),
            ("paper_white", "paper_f2ece0")[k % 2],
            "y",
            "napkins",
        )
