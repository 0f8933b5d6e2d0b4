"""Personal effects that people carry and wear: bags, keys, wallets, cards, shoes."""

import math

import numpy as np

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe
from mansion_assets.solids import Vec3

__all__: list[str] = []


@recipe("backpack")
def backpack(b: Builder) -> None:
    """A rounded bag with a lid, a front pocket with a zip, side pockets, a loop on top and two straps behind."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w * 0.42, w * 0.42), (-d * 0.34, d * 0.3), (0, h * 0.94), b.mat(), "body", 0.6, 14)
    b.cushion((-w * 0.36, w * 0.36), (d * 0.2, d / 2), (h * 0.04, h * 0.5), b.mat(), "pocket", 0.6, 12)
    b.box((-w * 0.28, w * 0.28), (d * 0.47, d * 0.505), (h * 0.36, h * 0.385), "plastic_black", "zips", solid=False)
    b.box((w * 0.2, w * 0.24), (d * 0.48, d * 0.51), (h * 0.3, h * 0.38), "metal_steel", "zips", solid=False)
    arc = [
        (math.cos(a) * w * 0.34, d * 0.3, h * 0.56 + math.sin(a) * h * 0.26)
        for a in (k * math.pi / 10 for k in range(11))
    ]
    b.path(arc, w * 0.018, "plastic_black", "zips")
    for side in (-1, 1):
        b.cushion(
            (side * w * 0.42 - w * 0.08, side * w * 0.42 + w * 0.08),
            (-d * 0.2, d * 0.2),
            (h * 0.04, h * 0.34),
            "fabric_dark",
            "side_pockets",
            0.5,
        )
        strap = [
            (side * w * 0.2, -d * 0.3, h * 0.88),
            (side * w * 0.28, -d / 2, h * 0.7),
            (side * w * 0.3, -d / 2, h * 0.3),
            (side * w * 0.34, -d * 0.3, h * 0.08),
        ]
        b.path(strap, w * 0.05, "fabric_dark", "straps")
    b.path(
        [
            (-w * 0.1, -d * 0.2, h * 0.92),
            (-w * 0.08, -d * 0.2, h * 0.98),
            (w * 0.08, -d * 0.2, h * 0.98),
            (w * 0.1, -d * 0.2, h * 0.92),
        ],
        w * 0.025,
        "fabric_dark",
        "loop",
    )


@recipe("handbag")
def handbag(b: Builder) -> None:
    """A lady's bag, narrow above, with a flap, a golden clasp, an arched handle on rings, and a silk scarf."""
    w, d, h = b.w, b.d, b.h
    main, high = b.mat(), h * 0.58
    trim = "leather_4a4a52" if main == "leather_black" else "leather_3a1a12"
    body = [(-w * 0.5, h * 0.03), (w * 0.5, h * 0.03), (w * 0.38, high), (-w * 0.38, high)]
    b.prism(body, (-d * 0.42, d * 0.42), main, "y", "body")
    base = [(-w * 0.5, 0), (w * 0.5, 0), (w * 0.49, h * 0.07), (-w * 0.49, h * 0.07)]
    b.prism(base, (-d * 0.44, d * 0.44), trim, "y", "base")
    edge = [
        (w * u, h * v) for u, v in ((-0.4, 0.58), (-0.36, 0.36), (-0.12, 0.24), (0.12, 0.24), (0.36, 0.36), (0.4, 0.58))
    ]
    b.prism(edge, (d * 0.42, d * 0.47), trim, "y", "flap")
    b.box((-w * 0.4, w * 0.4), (-d * 0.42, d * 0.47), (high, high + h * 0.025), trim, "flap")
    face = DrawnFace.front(b, d * 0.47)
    face.line(edge, w * 0.008, "metal_brass", "seams", 0.0)
    face.field((-w * 0.09, w * 0.09), (h * 0.22, h * 0.36), "metal_f2c94a", "clasp", d * 0.015)
    face.disc(0.0, h * 0.29, w * 0.04, "metal_brass", "clasp", d * 0.03, 16)
    turns = [k * math.pi / 12 for k in range(13)]
    arch = [(math.cos(a) * w * 0.25, 0.0, high + math.sin(a) * (h * 0.975 - high)) for a in turns]
    b.path(arch, h * 0.025, trim, "handle")
    for x in (-w * 0.25, w * 0.25):
        z = high + h * 0.03
        b.rod((x, -d * 0.1, z), (x, d * 0.1, z), h * 0.045, "metal_f2c94a", "rings", 16)
    _scarf(b, (w * 0.2, d * 0.1, h * 0.74))


def _scarf(b: Builder, knot: Vec3) -> None:
    """A knot of silk at the handle, and its two ends before the bag."""
    w, d, h = b.w, b.d, b.h
    b.ball(knot, (w * 0.05, d * 0.1, h * 0.05), "fabric_e8386a", "scarf", 10)
    for x, z in ((0.4, 0.46), (0.22, 0.4)):
        upper = [(knot[0] - w * 0.02, knot[2]), (knot[0] + w * 0.03, knot[2])]
        lower = [(w * (x + 0.06), h * z), (w * (x - 0.06), h * (z - 0.02))]
        b.prism(upper + lower, (d * 0.474, d * 0.5), "fabric_e8386a", "y", "scarf", solid=False)


@recipe("paper_bag")
def paper_bag(b: Builder) -> None:
    """An open paper bag with a fold at its side and two cord handles; bread, greens and a bottle look out of it."""
    w, d, h = b.w, b.d, b.h
    top, t = h * 0.66, w * 0.015
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, t), b.mat(), "floor")
    for side in (-1, 1):
        y = sorted((side * d / 2, side * (d / 2 - t)))
        b.box((-w / 2, w / 2), (y[0], y[1]), (0, top), b.mat(), "sides")
        x = side * w / 2
        fold = [
            (x, -d / 2),
            (x - side * w * 0.08, 0.0),
            (x, d / 2),
            (x - side * t, d / 2),
            (x - side * (w * 0.08 + t), 0.0),
            (x - side * t, -d / 2),
        ]
        for part in ((0, 1, 4, 5), (1, 2, 3, 4)):
            b.prism([fold[k] for k in part], (0, top), b.mat(), "z", "sides")
        arc = [
            (math.cos(a) * w * 0.2, side * d * 0.47, top * 0.96 + math.sin(a) * h * 0.16)
            for a in (k * math.pi / 8 for k in range(9))
        ]
        b.path(arc, w * 0.016, "paper_white", "handles")
    b.box((-w * 0.18, w * 0.18), (d / 2, d / 2 + 0.001), (top * 0.3, top * 0.66), "paint_2f9a4a", "print", solid=False)
    b.rod((-w * 0.26, 0, top * 0.4), (-w * 0.3, d * 0.05, h * 0.97), d * 0.14, "food_c98a4a", "bread", 12)
    b.ball((w * 0.02, 0, top), (w * 0.16, d * 0.3, h * 0.13), "leaf_5fae3f", "greens", 10)
    b.cyl(w * 0.3, 0, (top * 0.3, top * 1.1), w * 0.1, "plastic_white", "bottle", n=14)
    b.cyl(w * 0.3, 0, (top * 1.1, h * 0.85), w * 0.05, "plastic_3a7bc8", "bottle", n=12)


@recipe("keys")
def keys(b: Builder) -> None:
    """Ring with keys."""
    w, d, h = b.w, b.d, b.h
    r = min(w, d) * 0.3
    points = [(-w / 2 + r + r * math.cos(a), r * math.sin(a), h / 2) for a in [k * math.pi / 6 for k in range(13)]]
    b.path(points, h * 0.3, b.mat(), "ring")
    for y, color in ((-d * 0.3, "metal_steel"), (d * 0.3, "metal_brass")):
        b.box((-w * 0.1, w / 2), (y - d * 0.1, y + d * 0.1), (0, h), color, "keys")
        b.cyl(-w * 0.05, y, (0, h), d * 0.2, color, "keys", n=10)


@recipe("wallet")
def wallet(b: Builder) -> None:
    """A wallet that lies open: cards in stepped slots on one side, a window on the other, notes that look out above."""
    w, d, h = b.w, b.d, b.h
    low, t = h * 0.3, h * 0.1
    for side in (-1, 1):
        leaf = sorted((side * w * 0.49, side * w * 0.015))
        b.cushion((leaf[0], leaf[1]), (-d * 0.4, d / 2), (0, low), b.mat(), "leaves", 0.5)
        seam = [
            (side * w * 0.47, d * 0.46),
            (side * w * 0.47, -d * 0.36),
            (side * w * 0.03, -d * 0.36),
            (side * w * 0.03, d * 0.46),
        ]
        b.path([(x, y, low) for x, y in seam], h * 0.025, "fabric_e8c98a", "seams")
    b.box((-w * 0.03, w * 0.03), (-d * 0.38, d * 0.48), (0, low * 0.7), b.mat(), "spine")
    for k, color in enumerate(("paper_6fae5a", "paper_8fc070")):
        shift = d * 0.03 * k
        b.box(
            (-w * 0.46 + w * 0.02 * k, w * 0.46),
            (-d / 2 + shift, -d * 0.3),
            (t * (k + 1), t * (k + 1.9)),
            color,
            "notes",
            solid=False,
        )
    face = DrawnFace.top(b, t * 2.9)
    for u in (-w * 0.26, w * 0.26):
        face.write("50", (u - w * 0.1, u + w * 0.1), (d * 0.385, d * 0.465), "paper_1f4f2a", "notes", h * 0.02)
    _cards_in_slots(b, low)
    window = DrawnFace.top(b, low)
    window.field((w * 0.06, w * 0.44), (-d * 0.4, d * 0.24), "leather_3a2416", "window", h * 0.12)
    window.field((w * 0.1, w * 0.4), (-d * 0.34, d * 0.18), "plastic_dbe8f0", "window", h * 0.16)
    window.disc(w * 0.18, -d * 0.02, w * 0.05, "plastic_e8b48c", "photo", h * 0.2, 14)
    window.field((w * 0.12, w * 0.24), (-d * 0.26, -d * 0.1), "plastic_2f5f9e", "photo", h * 0.2)
    for k in range(3):
        window.field(
            (w * 0.28, w * 0.38), (d * (0.06 - 0.12 * k), d * (0.1 - 0.12 * k)), "plastic_5a6470", "photo", h * 0.2
        )


def _cards_in_slots(b: Builder, low: float) -> None:
    """Three cards one behind the other, each in a slot of leather."""
    w, d, h = b.w, b.d, b.h
    for k, color in enumerate(("plastic_2f6fc0", "plastic_d8382e", "plastic_f2c12e")):
        back = -d * 0.34 + d * 0.22 * k
        z = low + (h - low) * (0.2 + 0.22 * k)
        b.box((w * 0.06, w * 0.45), (back, back + d * 0.22), (low - h * 0.02, z), color, "cards", solid=False)
        face = DrawnFace.top(b, z)
        face.field((-w * 0.42, -w * 0.34), (-back - d * 0.1, -back - d * 0.04), "metal_f2d98a", "chips", h * 0.03)
        b.box(
            (w * 0.045, w * 0.465),
            (back + d * 0.15, d * 0.48),
            (low - h * 0.02, z + h * 0.04),
            b.mat(),
            "slots",
            solid=False,
        )


@recipe("credit_card")
def credit_card(b: Builder) -> None:
    """A card with a gold chip, a number in four groups, and two circles that overlap."""
    w, d, h = b.w, b.d, b.h
    z = (h, h * 1.04)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h), b.mat(), "card")
    b.box((-w * 0.4, -w * 0.22), (-d * 0.02, d * 0.22), z, "metal_brass", "chip", solid=False)
    b.box((-w * 0.4, -w * 0.22), (d * 0.09, d * 0.11), (h, h * 1.05), "metal_dark", "chip", solid=False)
    for group in range(4):
        for k in range(4):
            x = -w * 0.4 + group * w * 0.2 + k * w * 0.04
            b.box((x, x + w * 0.024), (-d * 0.2, -d * 0.1), z, "plastic_white", "number", solid=False)
    b.box((-w * 0.4, w * 0.05), (-d * 0.38, -d * 0.32), z, "plastic_white", "name", solid=False)
    b.cyl(w * 0.28, -d * 0.32, (h, h * 1.03), d * 0.12, "paint_red", "mark", n=20, solid=False)
    b.cyl(w * 0.38, -d * 0.32, (h, h * 1.05), d * 0.12, "paint_yellow", "mark", n=20, solid=False)


@recipe("badge")
def badge(b: Builder) -> None:
    """An identity card with a photograph, a coloured head and lines of print, and a clip on a strap."""
    w, d, h = b.w, b.d, b.h
    z, end = (h * 0.7, h * 0.76), d * 0.3
    b.box((-w / 2, w / 2), (-d / 2, end), (0, h * 0.7), b.mat(), "card")
    b.box((-w / 2, w / 2), (end - d * 0.14, end), z, "paint_3a7bc8", "head", solid=False)
    b.box((-w * 0.38, w * 0.02), (-d * 0.2, d * 0.12), z, "plastic_light", "photograph", solid=False)
    b.cyl(-w * 0.18, d * 0.02, (h * 0.76, h * 0.82), w * 0.11, "fabric_skin", "photograph", solid=False)
    b.box((-w * 0.34, -w * 0.02), (-d * 0.2, -d * 0.08), (h * 0.76, h * 0.8), "paint_dark", "photograph", solid=False)
    for k, wide in enumerate((0.34, 0.28, 0.34)):
        y = d * (0.06 - 0.09 * k)
        b.box((w * 0.1, w * (0.1 + wide)), (y, y + d * 0.03), z, "plastic_black", "print", solid=False)
    b.box((-w * 0.38, w * 0.4), (-d * 0.42, -d * 0.3), z, "plastic_black", "print", solid=False)
    b.box((-w * 0.14, w * 0.14), (end - d * 0.02, d * 0.42), (h * 0.2, h * 0.5), "plastic_light", "strap")
    b.box((-w * 0.2, w * 0.2), (d * 0.4, d / 2), (0, h), "metal_steel", "clip")


@recipe("shoes")
def shoes(b: Builder) -> None:
    """A pair of shoes or boots, toes to the front."""
    w, d, h = b.w, b.d, b.h
    low = b.p.get("style") == "low"
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * w * 0.04))
        b.box((lo, hi), (-d / 2, d / 2), (0, h * (0.12 if low else 0.05)), "rubber_black", "soles")
        b.cushion((lo, hi), (-d / 2, d / 2), (0, h * (0.7 if low else 0.25)), b.mat(), "uppers", 0.8)
        b.cushion((lo + 0.004, hi - 0.004), (-d / 2, -d * 0.02), (0, h), b.mat(), "shafts", 0.6)


@recipe("slippers")
def slippers(b: Builder) -> None:
    """A pair of mules to step into: an upper over the toes, open behind, a furry collar and a furry footbed."""
    w, d, h = b.w, b.d, b.h
    fur = "fabric_f6ecd6"
    half, mouth = w * 0.225, -d * 0.02
    for side in (-1, 1):
        x = side * (w / 2 - half)
        b.prism(_sole(x, half, d / 2), (0, h * 0.14), "rubber_7a4f2e", "z", "soles")
        b.prism(_sole(x, half * 0.9, d * 0.475), (h * 0.14, h * 0.26), fur, "z", "footbeds")
        _upper(b, x, (half * 0.98, h * 0.66), (mouth, -d / 2 + 0.004))
        arch = [(math.cos(k * math.pi / 16), math.sin(k * math.pi / 16)) for k in range(17)]
        hole = [(x + u * half * 0.8, h * 0.24 + v * h * 0.5) for u, v in arch]
        b.prism(hole, (mouth, mouth + 0.001), "fabric_3a2f2a", "y", "openings", solid=False)
        r = h * 0.13
        for u, v in arch:
            at = (x + u * (half - r), mouth, h * 0.2 + v * (h * 0.8 - r))
            b.ball(at, (r, r, r), fur, "collars", 8, solid=False)


def _sole(x: float, half: float, reach: float) -> list[tuple[float, float]]:
    """Return the outline of a sole around `x`: an oval with broad ends, narrower at the heel in front."""
    outline = []
    for k in range(24):
        across, along = math.cos(k * math.tau / 24), math.sin(k * math.tau / 24)
        wide = half * (0.88 if along > 0 else 1.0) ** abs(along)
        outline.append((x + math.copysign(abs(across) ** 0.6, across) * wide, along * reach))
    return outline


def _upper(b: Builder, x: float, mouth: tuple[float, float], y: tuple[float, float]) -> None:
    """A vault of half a width and a height at its mouth, that runs out in the toes."""
    rings, n = 7, 13
    low = b.h * 0.13
    points = []
    for k in range(rings):
        share = k / (rings - 1)
        size = math.sqrt(1.0 - 0.97 * share**2.4)
        for j in range(n):
            a = j * math.pi / (n - 1)
            points.append(
                (x + math.cos(a) * mouth[0] * size, y[0] + share * (y[1] - y[0]), low + math.sin(a) * mouth[1] * size)
            )
    faces = []
    for k in range(rings - 1):
        for j in range(n - 1):
            p, q = k * n + j, (k + 1) * n + j
            faces += [(p, p + 1, q + 1), (p, q + 1, q)]
        left, ahead = k * n, (k + 1) * n
        faces += [(left, ahead, ahead + n - 1), (left, ahead + n - 1, left + n - 1)]
    toes = (rings - 1) * n
    for j in range(1, n - 1):
        faces += [(0, j + 1, j), (toes, toes + j, toes + j + 1)]
    b.raw(np.array(points), np.array(faces), b.mat(), "uppers", solid=True)
