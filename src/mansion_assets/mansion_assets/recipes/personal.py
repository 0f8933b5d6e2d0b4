"""Books, shoes and other personal objects."""

import itertools
import math

from mansion_assets.builder import Box, Builder
from mansion_assets.registry import recipe

__all__: list[str] = []

_COVERS = ("paper_red", "paper_blue", "paper_green", "paper_brown", "paper_beige", "paper_orange")


@recipe("book")
def book(b: Builder) -> None:
    """Book lying flat, a stack, a row standing upright, or one folder."""
    w, d, h = b.w, b.d, b.h
    style = b.p.get("style")
    if style == "row":
        count = max(4, round(w / 0.03))
        for k in range(count):
            x0, high = -w / 2 + k * w / count, h * (1.0, 0.86, 0.93, 0.78, 0.97)[k % 5]
            b.box(
                (x0, x0 + w / count - 0.001),
                (-d / 2, d / 2 - 0.006 * (k % 3)),
                (0, high),
                _COVERS[(k * 5 + k // 3) % 6],
                "books",
                solid=False,
            )
        b.boxes.append(Box((0.0, 0.0, h / 2), (w, d, h)))
        return
    if style == "upright":
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h), b.mat(), "cover")
        b.box((-w * 0.3, w * 0.3), (d / 2 - 0.001, d / 2), (h * 0.4, h * 0.7), "paper_white", "label", solid=False)
        return
    count = int(b.p.get("stack", 1))
    for k in range(count):
        z0, z1 = h * k / count, h * (k + 1) / count
        shrink = 1.0 if count == 1 or k == 0 else 0.84 + 0.04 * (k % 3)
        cover = b.mat() if k == 0 else _COVERS[(k * 2 + 1) % 6]
        t = (z1 - z0) * 0.16
        x, y = (-w / 2 * shrink, w / 2 * shrink), (-d / 2 * shrink, d / 2 * shrink)
        b.box(x, y, (z0, z0 + t), cover, "cover", solid=False)
        b.box(x, y, (z1 - t, z1), cover, "cover", solid=False)
        b.box((x[0], x[0] + 0.004), y, (z0, z1), cover, "cover", solid=False)
        b.box(
            (x[0] + 0.003, x[1] - 0.004),
            (y[0] + 0.004, y[1] - 0.004),
            (z0 + t, z1 - t),
            "paper_light",
            "pages",
            solid=False,
        )
    b.boxes.append(Box((0.0, 0.0, h / 2), (w, d, h)))


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


@recipe("stethoscope")
def stethoscope(b: Builder) -> None:
    """A stethoscope laid down: two curved ear tubes that meet, and a tube in a bend to the chest piece in front."""
    w, d, h = b.w, b.d, b.h
    tube, z, fork = min(h * 0.25, w * 0.03), h * 0.3, (0.0, -d * 0.05)
    for side in (-1, 1):
        bend = [(side * w * 0.3, -d * 0.2), (side * w * 0.42, -d * 0.34), (side * w * 0.28, -d * 0.46)]
        ends = [(x, y, z) for x, y in (fork, *bend)]
        b.path(ends, tube * 0.7, "metal_steel", "ear_tubes")
        b.ball(ends[-1], (tube * 1.5, tube * 1.5, h * 0.3), b.mat(), "ear_tips", 8)
    curve = [
        fork,
        (w * 0.02, d * 0.12),
        (-w * 0.2, d * 0.22),
        (-w * 0.44, d * 0.3),
        (-w * 0.36, d * 0.42),
        (0.0, d * 0.36),
    ]
    b.path([(x, y, z) for x, y in curve], tube, b.mat(), "tube")
    b.cyl(w * 0.2, d * 0.36, (0, h * 0.7), w * 0.2, "metal_steel", "chest_piece", n=20)
    b.cyl(w * 0.2, d * 0.36, (h * 0.7, h), w * 0.17, "plastic_white", "membrane", n=20)
    b.rod((0.0, d * 0.36, z), (w * 0.1, d * 0.36, z), tube, "metal_steel", "stem")


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


@recipe("tape_measure")
def tape_measure(b: Builder) -> None:
    """A rounded case that lies on its side, with the end of a steel tape and its hook out in front."""
    w, d, h = b.w, b.d, b.h
    mouth = d * 0.2
    b.cushion((-w / 2, w / 2), (-d / 2, mouth), (0, h * 0.94), b.mat(), "case", 0.35)
    b.cyl(0, (mouth - d / 2) / 2, (h * 0.9, h), w * 0.24, "plastic_black", "badge")
    b.box((-w * 0.4, -w * 0.34), (mouth - d * 0.1, d / 2), (h * 0.2, h * 0.7), "metal_light", "tape")
    b.box((-w * 0.5, -w * 0.34), (d * 0.46, d / 2), (h * 0.1, h * 0.8), "metal_steel", "hook")


@recipe("wallet")
def wallet(b: Builder) -> None:
    """Two folds of leather that lie on each other, with notes and a card between them."""
    w, d, h = b.w, b.d, b.h
    for z in ((0, h * 0.36), (h * 0.64, h)):
        b.cushion((-w / 2, w / 2), (-d / 2, d * 0.4), z, b.mat(), "folds", 0.3)
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.46), (h * 0.1, h * 0.9), b.mat(), "spine")
    b.box((-w * 0.46, w * 0.46), (-d * 0.44, d * 0.46), (h * 0.36, h * 0.5), "paper_green", "notes")
    b.box((-w * 0.3, w * 0.42), (-d * 0.4, d / 2), (h * 0.5, h * 0.64), "plastic_blue", "card")


@recipe("router")
def router(b: Builder) -> None:
    """A flat case with two antennas behind and a row of lights in front."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.4
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, top), b.mat(), "case", 0.3)
    for x in (-w * 0.36, w * 0.36):
        b.rod((x, -d * 0.4, top * 0.8), (x, -d * 0.4, h), h * 0.05, b.mat(), "antennas", 8)
    for k in range(5):
        x = (k - 2) * w * 0.09
        b.box(
            (x - w * 0.02, x + w * 0.02),
            (d * 0.3, d * 0.36),
            (top - 0.002, top + 0.002),
            "plastic_green",
            "lights",
            solid=False,
        )


@recipe("hair_dryer")
def hair_dryer(b: Builder) -> None:
    """Pistol shape: dryer, cordless drill."""
    w, d, h = b.w, b.d, b.h
    r = min(d / 2, h * 0.22)
    b.rod((-w / 2 + w * 0.15, 0, h - r), (w * 0.2, 0, h - r), r, b.mat(), "body", 16, solid=True)
    b.rod((w * 0.2, 0, h - r), (w / 2, 0, h - r), r * 0.5, "plastic_black", "nozzle", 12)
    b.ball((-w / 2 + w * 0.15, 0, h - r), (w * 0.15, r, r), b.mat(), "back", 10, solid=False)
    b.box((-w * 0.25, -w * 0.02), (-d * 0.3, d * 0.3), (0, h - r), "plastic_black", "grip")


@recipe("coat_rack")
def coat_rack(b: Builder) -> None:
    """Stand with hooks, a coat and a hat."""
    w, d, h = b.w, b.d, b.h
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        b.rod((0, 0, 0.12), (math.cos(a) * w * 0.66, math.sin(a) * d * 0.66, 0.015), 0.016, b.mat(), "feet")
    b.cyl(0, 0, (0.05, h), 0.022, b.mat(), "pole")
    for k in range(6):
        a = k * math.pi / 3
        b.path(
            [
                (0, 0, h - 0.22),
                (math.cos(a) * w * 0.36, math.sin(a) * d * 0.36, h - 0.2),
                (math.cos(a) * w * 0.44, math.sin(a) * d * 0.44, h - 0.06),
            ],
            0.011,
            b.mat(),
            "hooks",
        )
    b.cushion(
        (w * 0.12, w * 0.44), (-d * 0.18, d * 0.18), (h * 0.42, h - 0.2), "fabric_blue", "coat", 0.6, 10, solid=False
    )


@recipe("toy_car")
def toy_car(b: Builder) -> None:
    """Toy car."""
    w, d, h = b.w, b.d, b.h
    r = h * 0.22
    b.cushion((-w * 0.42, w * 0.42), (-d / 2, d / 2), (r * 0.7, h * 0.62), b.mat(), "body", 0.4)
    b.cushion((-w * 0.36, w * 0.36), (-d * 0.25, d * 0.15), (h * 0.55, h), "glass_black", "cabin", 0.4)
    for sx in (-1, 1):
        for sy in (-1, 1):
            b.rod((sx * w * 0.34, sy * d * 0.3, r), (sx * w / 2, sy * d * 0.3, r), r, "rubber_black", "wheels", 12)
