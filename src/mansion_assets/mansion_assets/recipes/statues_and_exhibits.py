"""Statues, exhibits, mannequins, skeletons."""

import itertools
import math

from mansion_assets.builder import Box, Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


def _figure(b: Builder, x: float, z: float, height: float, wide: float, deep: float, main: str) -> None:
    """A standing human figure."""
    h = height
    b.ball((x, 0, z + h * 0.93), (wide * 0.16, deep * 0.26, h * 0.07), main, "head", 12)
    b.cyl(x, 0, (z + h * 0.82, z + h * 0.9), wide * 0.08, main, "neck", n=10, solid=False)
    b.cushion(
        (x - wide * 0.3, x + wide * 0.3),
        (-deep * 0.4, deep * 0.4),
        (z + h * 0.48, z + h * 0.84),
        main,
        "torso",
        0.7,
        12,
    )
    for sx in (-1, 1):
        b.path(
            [
                (x + sx * wide * 0.34, 0, z + h * 0.8),
                (x + sx * wide * 0.42, 0, z + h * 0.6),
                (x + sx * wide * 0.4, deep * 0.2, z + h * 0.44),
            ],
            wide * 0.08,
            main,
            "arms",
        )
        b.rod(
            (x + sx * wide * 0.15, 0, z),
            (x + sx * wide * 0.14, 0, z + h * 0.52),
            wide * 0.12,
            main,
            "legs",
            10,
            solid=True,
        )
        b.box(
            (x + sx * wide * 0.15 - wide * 0.08, x + sx * wide * 0.15 + wide * 0.08),
            (-deep * 0.25, deep * 0.45),
            (z, z + h * 0.03),
            main,
            "feet",
            solid=False,
        )


@recipe("statue")
def statue(b: Builder) -> None:
    """Figure, vase, modern sculpture, or an exhibit on a plinth."""
    style = b.p.get("style")
    if style == "vase":
        _vase(b)
    elif style == "abstract":
        _sculpture(b)
    elif style == "plinth":
        _exhibit(b)
    else:
        w, d, base = b.w, b.d, b.h * 0.12
        wood = "wood_walnut" if b.mat() != "wood_oak" else "wood_black"
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, base), wood, "base")
        _figure(b, 0.0, base, b.h - base, w, d, b.mat())


def _vase(b: Builder) -> None:
    """Floor vase with twigs."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    b.lathe([(0.3, 0), (0.5, h * 0.3), (0.4, h * 0.6), (0.2, h * 0.75), (0.26, h * 0.8)], main, stretch=(w, d), n=20)
    for k in range(5):
        a = k * 1.257
        b.rod(
            (0, 0, h * 0.7),
            (math.cos(a) * w * 0.4, math.sin(a) * d * 0.4, h * (1.0 - 0.03 * k)),
            0.008,
            "wood_brown",
            "twigs",
            6,
        )


def _sculpture(b: Builder) -> None:
    """Rising coil about a core."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    b.box((-w * 0.4, w * 0.4), (-d * 0.4, d * 0.4), (0, 0.12), "stone_dark", "base")
    points = [
        (w * 0.42 * math.cos(t * 5), d * 0.42 * math.sin(t * 5), 0.12 + (h - 0.25) * t)
        for t in [k / 16 for k in range(17)]
    ]
    for p, q in itertools.pairwise(points):
        b.rod(p, q, 0.07, main, "coil", 10, solid=True)
    b.ball((0, 0, h * 0.55), (w * 0.2, d * 0.2, h * 0.16), main, "core", 16)
    b.ball((points[-1][0] * 0.9, points[-1][1] * 0.9, h - 0.1), (0.1, 0.1, 0.1), "metal_brass", "tip", 12)


def _exhibit(b: Builder) -> None:
    """Plinth with a label; on it a bust or an urn."""
    w, d, h = b.w, b.d, b.h
    base = h * 0.55
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, base), "stone_white", "base")
    b.box(
        (-w * 0.2, w * 0.2), (d / 2 - 0.002, d / 2 + 0.0), (base * 0.6, base * 0.7), "metal_brass", "label", solid=False
    )
    if round(w * 1000) % 2:
        _bust(b, base)
    else:
        _urn(b, base)


def _bust(b: Builder, base: float) -> None:
    """Shoulders, neck and head."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w * 0.3, w * 0.3), (-d * 0.2, d * 0.2), (base, base + (h - base) * 0.5), "stone_light", "bust", 0.7, 12)
    b.cyl(0, 0, (base + (h - base) * 0.4, base + (h - base) * 0.65), w * 0.09, "stone_light", "bust", n=12, solid=False)
    b.ball((0, 0, h - (h - base) * 0.24), (w * 0.16, d * 0.2, (h - base) * 0.24), "stone_light", "bust", 14)


def _urn(b: Builder, base: float) -> None:
    """Blue vase."""
    w, d, h = b.w, b.d, b.h
    b.lathe(
        [(0.14, base), (0.3, base + (h - base) * 0.4), (0.12, base + (h - base) * 0.8), (0.18, h)],
        "ceramic_blue",
        stretch=(w, d),
        part="vase",
        n=20,
    )


@recipe("statuette")
def statuette(b: Builder) -> None:
    """A carving all of one stone or metal, on a plinth with a title: a dog that sits, a bust where it is upright."""
    w, d, h = b.w, b.d, b.h
    base = h * 0.16
    plinth = "stone_dark" if b.mat() != "stone_grey" else "stone_white"
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, base * 0.5), plinth, "plinth")
    b.box((-w * 0.44, w * 0.44), (-d * 0.44, d * 0.44), (base * 0.5, base), plinth, "plinth")
    DrawnFace.front(b, d / 2).field((-w * 0.2, w * 0.2), (base * 0.1, base * 0.4), "metal_brass", "title", d * 0.006)
    if h > 1.2 * max(w, d):
        _carved_bust(b, base)
    else:
        _sitting_dog(b, base)


def _sitting_dog(b: Builder, z: float) -> None:
    """Haunches, a chest on straight fore legs, a head with hanging ears, a tail round the side."""
    w, d, s, main = b.w, b.d, b.h - z, b.mat()
    r = min(w * 0.5, d)
    b.ball((-w * 0.14, 0, z + s * 0.24), (w * 0.2, d * 0.36, s * 0.26), main, "body", 14)
    b.taper((-w * 0.14, 0, z + s * 0.3), (w * 0.1, 0, z + s * 0.66), (r * 0.3, r * 0.2), main, "body", 14)
    b.ball((w * 0.08, 0, z + s * 0.52), (w * 0.12, d * 0.25, s * 0.18), main, "body", 12)
    for side in (-1, 1):
        b.taper(
            (w * 0.12, side * d * 0.15, z + s * 0.5),
            (w * 0.18, side * d * 0.16, z),
            (r * 0.1, r * 0.08),
            main,
            "legs",
            10,
        )
        b.ball((w * 0.22, side * d * 0.16, z + s * 0.04), (w * 0.07, d * 0.1, s * 0.05), main, "paws", 8)
        b.ball((-w * 0.06, side * d * 0.3, z + s * 0.18), (w * 0.15, d * 0.12, s * 0.18), main, "legs", 10)
        b.ball((w * 0.06, side * d * 0.32, z + s * 0.04), (w * 0.1, d * 0.1, s * 0.05), main, "paws", 8)
        b.ball((w * 0.06, side * d * 0.24, z + s * 0.78), (w * 0.045, d * 0.08, s * 0.16), main, "ears", 8, solid=False)
    b.ball((w * 0.13, 0, z + s * 0.84), (w * 0.11, d * 0.24, s * 0.16), main, "head", 14)
    b.ball((w * 0.26, 0, z + s * 0.79), (w * 0.1, d * 0.13, s * 0.085), main, "muzzle", 12)
    tail = [
        (-w * 0.3, 0, z + s * 0.1),
        (-w * 0.36, d * 0.2, z + s * 0.06),
        (-w * 0.24, d * 0.38, z + s * 0.05),
        (-w * 0.06, d * 0.42, z + s * 0.05),
    ]
    b.path(tail, r * 0.05, main, "tail")


def _carved_bust(b: Builder, z: float) -> None:
    """Shoulders cut off below the chest on a round foot, a neck, and a head with a nose, ears and curls."""
    w, d, s, main = b.w, b.d, b.h - z, b.mat()
    foot = [(0.26, z), (0.22, z + s * 0.04), (0.12, z + s * 0.1), (0.2, z + s * 0.2)]
    b.lathe(foot, main, stretch=(w, d), part="foot", n=20)
    b.ball((0, 0, z + s * 0.3), (w * 0.46, d * 0.32, s * 0.16), main, "shoulders", 16)
    b.taper((0, -d * 0.02, z + s * 0.34), (0, 0, z + s * 0.6), (min(w, d) * 0.17, min(w, d) * 0.13), main, "neck", 14)
    b.ball((0, d * 0.02, z + s * 0.76), (w * 0.21, d * 0.25, s * 0.19), main, "head", 18)
    b.prism(
        [(d * 0.24, z + s * 0.8), (d * 0.36, z + s * 0.71), (d * 0.22, z + s * 0.7)],
        (-w * 0.035, w * 0.035),
        main,
        part="nose",
    )
    b.ball((0, d * 0.2, z + s * 0.64), (w * 0.07, d * 0.07, s * 0.03), main, "chin", 8)
    for side in (-1, 1):
        b.ball((side * w * 0.21, 0, z + s * 0.75), (w * 0.03, d * 0.05, s * 0.045), main, "ears", 8)
        b.ball((side * w * 0.08, d * 0.215, z + s * 0.785), (w * 0.045, d * 0.04, s * 0.016), main, "brows", 8)
    for k in range(16):
        a, ring = k * math.tau / 8 + 0.4 * (k // 8), k // 8
        out = (0.2, 0.12)[ring]
        spot = (math.cos(a) * w * out, -d * 0.03 + math.sin(a) * d * out, z + s * (0.87 + 0.06 * ring))
        if spot[1] < d * 0.14 or ring:
            b.ball(spot, (w * 0.075, d * 0.075, s * 0.06), main, "curls", 8, solid=False)


@recipe("mannequin")
def mannequin(b: Builder) -> None:
    """Dressed figure on a round foot."""
    b.cyl(0, 0, (0, 0.02), min(b.w, b.d) * 0.48, "metal_steel", "foot", n=24)
    _figure(b, 0.0, 0.02, b.h - 0.02, b.w, b.d, b.mat())
    b.cushion(
        (-b.w * 0.32, b.w * 0.32),
        (-b.d * 0.43, b.d * 0.43),
        (b.h * 0.46, b.h * 0.83),
        "fabric_blue",
        "shirt",
        0.7,
        12,
        solid=False,
    )
    b.cushion(
        (-b.w * 0.3, b.w * 0.3),
        (-b.d * 0.38, b.d * 0.38),
        (b.h * 0.26, b.h * 0.5),
        "fabric_dark",
        "skirt",
        0.6,
        12,
        solid=False,
    )


@recipe("skeleton")
def skeleton(b: Builder) -> None:
    """Dinosaur skeleton on a base: spine, ribs, skull, legs, tail."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.15), "wood_black", "base")
    _spine(b)
    _skull(b)
    for side in (-1, 1):
        _limbs(b, side)
    b.boxes.append(Box((0.0, 0.0, h * 0.5), (w * 0.5, d * 0.9, h * 0.6)))


def _spine(b: Builder) -> None:
    """Tail, back and neck in one line, and nine pairs of ribs."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    spine = [
        (0.0, -d * 0.48, h * 0.42),
        (0.0, -d * 0.3, h * 0.52),
        (0.0, -d * 0.1, h * 0.62),
        (0.0, d * 0.12, h * 0.66),
        (0.0, d * 0.26, h * 0.8),
        (0.0, d * 0.34, h * 0.92),
    ]
    b.path(spine, 0.045, m, "spine")
    for k in range(9):
        y = -d * 0.14 + k * d * 0.035
        for sx in (-1, 1):
            b.path(
                [(0, y, h * 0.64), (sx * w * 0.24, y + 0.03, h * 0.52), (sx * w * 0.1, y + 0.05, h * 0.38)],
                0.018,
                m,
                "ribs",
            )


def _skull(b: Builder) -> None:
    """Head with its lower jaw open."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    b.prism(
        [(d * 0.3, h * 0.86), (d * 0.48, h * 0.84), (d * 0.5, h * 0.9), (d * 0.36, h)],
        (-w * 0.1, w * 0.1),
        m,
        part="skull",
    )
    b.prism(
        [(d * 0.32, h * 0.83), (d * 0.47, h * 0.78), (d * 0.47, h * 0.81), (d * 0.32, h * 0.86)],
        (-w * 0.08, w * 0.08),
        m,
        part="jaw",
    )


def _limbs(b: Builder, side: int) -> None:
    """Hind leg and short arm of one side."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    b.path(
        [
            (side * 0.08, -d * 0.12, h * 0.6),
            (side * w * 0.28, -d * 0.02, h * 0.36),
            (side * w * 0.26, -d * 0.12, 0.2),
            (side * w * 0.26, 0.05, 0.16),
        ],
        0.045,
        m,
        "legs",
    )
    b.path(
        [(side * 0.08, d * 0.14, h * 0.58), (side * w * 0.18, d * 0.2, h * 0.44), (side * w * 0.14, d * 0.27, h * 0.4)],
        0.025,
        m,
        "arms",
    )
