"""Food, cutlery, and tools with a handle."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("ball")
def ball(b: Builder) -> None:
    """Round things: apples, lettuce, potatoes, half shells."""
    w, d, h = b.w, b.d, b.h
    style = b.p.get("style", "plain")
    if style == "dome":
        b.lathe(
            [(0.5, 0), (0.5, h * 0.12), (0.42, h * 0.16), (0.36, h * 0.6), (0.18, h * 0.95), (0.02, h)],
            b.mat(),
            stretch=(w, d),
            n=20,
        )
        return
    top = h * (0.93 if style == "apple" else 1.0)
    b.ball((0, 0, top / 2), (w / 2, d / 2, top / 2), b.mat(), "body", 16)
    if style == "apple":
        b.rod((0, 0, top * 0.95), (0, 0, h), max(0.002, w * 0.03), "wood_brown", "stalk", 6)
    elif style == "leafy":
        for k in range(4):
            x, y = ((0.2, 0), (-0.2, 0.1), (0, 0.22), (0.05, -0.2))[k]
            b.ball((x * w, y * d, h * 0.55), (w * 0.28, d * 0.28, h * 0.42), "leaf_green", "leaves", 8, solid=False)


@recipe("banana")
def banana(b: Builder) -> None:
    """A bent fruit."""
    w, d, h = b.w, b.d, b.h
    points = [
        (-w * 0.46, d * 0.3, h * 0.5),
        (-w * 0.3, -d * 0.1, h * 0.5),
        (0, -d * 0.3, h * 0.5),
        (w * 0.3, -d * 0.1, h * 0.5),
        (w * 0.46, d * 0.3, h * 0.5),
    ]
    b.path(points, h * 0.4, b.mat(), "fruit")
    b.boxes.append(b.whole_box())
    b.rod(points[-1], (w / 2, d / 2, h * 0.5), h * 0.15, "food_brown", "tip")


@recipe("utensil")
def utensil(b: Builder) -> None:
    """Long things with the working end to the front: cutlery, pens, tools, rackets."""
    style = str(b.p.get("style", "pen"))
    if b.h > 2 * b.d and b.h > b.w:
        _upright(b, style)
    elif style == "wrench":
        _spanner(b)
    elif style == "knife":
        _bladed(b)
    elif style in ("fork", "spoon", "spatula", "racket"):
        _headed(b, style)
    else:
        _straight(b, style)


def _bladed(b: Builder) -> None:
    """A flat handle and a blade that tapers to the front."""
    w, d, h = b.w, b.d, b.h
    main, grip = b.mat(), -d * 0.1
    b.box((-w / 2, w / 2), (-d / 2, grip), (0, h), "plastic_black", "handle")
    left, right = -w * 0.2, w * 0.2
    b.prism([(left, grip), (right, grip), (w * 0.2, d * 0.45), (0, d / 2)], (h * 0.1, h * 0.9), main, "z", "blade")


def _headed(b: Builder, style: str) -> None:
    """A round handle and a bowl, tines, a strung frame or a blade at its end."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    b.rod(
        (0, -d / 2, h * 0.4),
        (0, d * 0.2 if style != "racket" else -d * 0.02, h * 0.4),
        min(w * 0.16, h * 0.3),
        main,
        "handle",
        8,
        solid=True,
    )
    if style == "spoon":
        b.ball((0, d / 2 - d * 0.16, h / 2), (w / 2, d * 0.16, h / 2), main, "bowl", 10)
    elif style == "fork":
        b.box((-w / 2, w / 2), (d * 0.2, d * 0.3), (0, h * 0.5), main, "neck")
        for k in range(4):
            x = -w / 2 + (k + 0.5) * w / 4
            b.box((x - w * 0.07, x + w * 0.07), (d * 0.3, d / 2), (h * 0.1, h), main, "tines")
    elif style == "racket":
        _strung(b)
    else:
        b.box((-w / 2, w / 2), (d * 0.15, d / 2), (0, h), main, "blade")


def _strung(b: Builder) -> None:
    """The head of a racket, an oval with strings, and the grip at the other end."""
    w, d, h = b.w, b.d, b.h
    r, z, middle = min(h * 0.4, w * 0.06), h / 2, d * 0.24
    rx, ry = w / 2 - r, d * 0.26 - r
    turns = [k * math.pi / 12 for k in range(25)]
    b.path([(rx * math.cos(a), middle + ry * math.sin(a), z) for a in turns], r, b.mat(), "frame")
    for share in (k / 5 for k in range(-4, 5)):
        half = math.sqrt(1 - share**2)
        lines = (
            ((rx * share, middle - ry * half, z), (rx * share, middle + ry * half, z)),
            ((-rx * half, middle + ry * share, z), (rx * half, middle + ry * share, z)),
        )
        for start, end in lines:
            b.rod(start, end, r * 0.22, "plastic_white", "strings", 4)
    b.rod((0, -d / 2, z), (0, -d * 0.22, z), min(h * 0.5, w * 0.09), "leather_black", "grip", 10)


def _spanner(b: Builder) -> None:
    """A flat handle with an open jaw at the front and a ring at the back."""
    w, d, h = b.w, b.d, b.h
    main, jaw = b.mat(), d / 2 - w * 0.55
    b.box((-w * 0.16, w * 0.16), (-d / 2 + w * 0.7, jaw), (h * 0.2, h * 0.8), main, "handle")
    b.box((-w / 2, w / 2), (jaw - w * 0.3, jaw), (0, h), main, "head")
    for side in (-1, 1):
        inner, outer = sorted((side * w * 0.2, side * w / 2))
        b.box((inner, outer), (jaw, d / 2), (0, h), main, "jaws")
    r, middle = min(h / 2, w * 0.14), -d / 2 + w * 0.42
    turns = [k * math.pi / 6 for k in range(13)]
    b.path([(w * 0.28 * math.cos(a), middle + w * 0.28 * math.sin(a), h / 2) for a in turns], r, main, "ring")


def _straight(b: Builder, style: str) -> None:
    """Bars one behind the other: pen, hammer, screwdriver, or a plain bar."""
    w, d, h = b.w, b.d, b.h
    main, r, z = b.mat(), min(w, h) / 2, h / 2
    if style == "pen":
        b.rod((0, -d / 2, z), (0, d * 0.4, z), r, main, "barrel", 8, solid=True)
        b.rod((0, d * 0.4, z), (0, d / 2, z), r * 0.4, "plastic_black", "tip", 8)
    elif style == "hammer":
        b.rod((0, -d / 2, z), (0, d * 0.4, z), h * 0.35, main, "handle", 8, solid=True)
        b.box((-w / 2, w / 2), (d * 0.36, d / 2), (0, h), "metal_steel", "head")
    elif style == "screwdriver":
        b.rod((0, -d / 2, z), (0, -d * 0.02, z), r, main, "handle", 8, solid=True)
        b.rod((0, -d * 0.02, z), (0, d / 2, z), r * 0.3, "metal_steel", "shaft", 8, solid=True)
    else:
        b.rod((0, -d / 2, z), (0, d / 2, z), r, main, "body", 10, solid=True)


def _upright(b: Builder, style: str) -> None:
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    if style == "umbrella":
        b.lathe([(0.05, 0), (0.3, h * 0.2), (0.5, h * 0.7), (0.1, h * 0.74), (0.06, h * 0.9)], main, stretch=(w, d))
        b.path(
            [(0, 0, h * 0.88), (0, 0, h - 0.02), (w * 0.35, 0, h - 0.012), (w * 0.4, 0, h * 0.93)],
            0.01,
            "wood_brown",
            "handle",
        )
    elif style == "mic":
        b.lathe([(0.3, 0), (0.34, h * 0.7), (0.3, h * 0.72)], main, stretch=(w, d))
        b.ball((0, 0, h * 0.84), (w / 2, d / 2, h * 0.16), "metal_steel", "head", 10)
    elif style == "bat":
        b.lathe(
            [(0.3, 0), (0.3, h * 0.02), (0.2, h * 0.05), (0.22, h * 0.4), (0.5, h * 0.85), (0.3, h)],
            main,
            stretch=(w, d),
        )
    else:
        b.lathe([(0.45, 0), (0.5, h * 0.1), (0.5, h * 0.9), (0.2, h)], main, stretch=(w, d), n=10)
