"""Tools and cutlery that are held in the hand."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


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


@recipe("paint_brush")
def paint_brush(b: Builder) -> None:
    """A wooden handle, a steel ferrule and a tuft of bristles with wet paint on their ends."""
    w, d, h = b.w, b.d, b.h
    z = h / 2
    b.rod((0, -d / 2, z), (0, -d * 0.3, z), w * 0.16, b.mat(), "handle", 10, solid=True)
    b.rod((0, -d * 0.3, z), (0, d * 0.02, z), w * 0.26, b.mat(), "handle", 10, solid=True)
    b.box((-w * 0.44, w * 0.44), (0, d * 0.18), (z - h * 0.34, z + h * 0.34), "metal_chrome", "ferrule")
    b.prism(
        [(-w * 0.42, d * 0.18), (w * 0.42, d * 0.18), (w / 2, d * 0.32), (-w / 2, d * 0.32)],
        (z - h * 0.3, z + h * 0.3),
        "food_e8d9b0",
        "z",
        "bristles",
    )
    b.prism(
        [(-w / 2, d * 0.32), (w / 2, d * 0.32), (w * 0.4, d * 0.46), (0, d / 2), (-w * 0.4, d * 0.46)],
        (0, h),
        "paint_red",
        "z",
        "paint",
    )


@recipe("power_drill")
def power_drill(b: Builder) -> None:
    """A pistol of a motor with air slits, a chuck with a spiral bit, a trigger."""
    w, d, h = b.w, b.d, b.h
    axis, r = h * 0.8, min(d * 0.48, h * 0.2)
    b.rod((-w * 0.5, 0, axis), (w * 0.08, 0, axis), r, b.mat(), "motor", 16, solid=True)
    b.rod((-w * 0.5, 0, axis), (-w * 0.44, 0, axis), r * 1.03, "plastic_black", "motor", 16)
    for k in range(3):
        x = -w * (0.4 - 0.06 * k)
        b.box(
            (x, x + w * 0.025),
            (r * 0.8, r * 1.02),
            (axis - r * 0.4, axis + r * 0.4),
            "plastic_black",
            "slits",
            solid=False,
        )
    for x0, x1, share, color in (
        (0.08, 0.14, 0.85, "plastic_black"),
        (0.14, 0.24, 0.62, "metal_dark"),
        (0.24, 0.28, 0.42, "metal_steel"),
    ):
        b.rod((w * x0, 0, axis), (w * x1, 0, axis), r * share, color, "chuck", 14)
    bit = [(w * (0.28 + 0.022 * k), (r * 0.07) * (-1) ** k, axis + (r * 0.07) * (-1) ** (k // 2)) for k in range(11)]
    b.path(bit, r * 0.13, "metal_steel", "bit")
    grip = [(-w * 0.2, h * 0.68), (w * 0.0, h * 0.68), (-w * 0.1, h * 0.2), (-w * 0.32, h * 0.2)]
    b.prism(grip, (-d * 0.34, d * 0.34), "plastic_black", "y", "grip")
    b.box((-w * 0.02, w * 0.05), (-d * 0.2, d * 0.2), (h * 0.5, h * 0.64), "plastic_red", "trigger")
    b.box((-w * 0.42, w * 0.04), (-d / 2, d / 2), (0, h * 0.2), b.mat(), "battery")
    b.box((-w * 0.42, w * 0.04), (-d / 2, d / 2), (h * 0.2, h * 0.24), "plastic_black", "battery")
    DrawnFace.front(b, d / 2).write(
        "18V", (w * 0.02, w * 0.36), (h * 0.04, h * 0.17), "plastic_black", "letters", 0.001
    )


@recipe("tape_measure")
def tape_measure(b: Builder) -> None:
    """A rounded case that lies on its side, with the end of a steel tape and its hook out in front."""
    w, d, h = b.w, b.d, b.h
    mouth = d * 0.2
    b.cushion((-w / 2, w / 2), (-d / 2, mouth), (0, h * 0.94), b.mat(), "case", 0.35)
    b.cyl(0, (mouth - d / 2) / 2, (h * 0.9, h), w * 0.24, "plastic_black", "badge")
    b.box((-w * 0.4, -w * 0.34), (mouth - d * 0.1, d / 2), (h * 0.2, h * 0.7), "metal_light", "tape")
    b.box((-w * 0.5, -w * 0.34), (d * 0.46, d / 2), (h * 0.1, h * 0.8), "metal_steel", "hook")


@recipe("torch")
def torch(b: Builder) -> None:
    """A barrel with grooves and a switch, which widens to a head with a bright lens in front."""
    w, d, h = b.w, b.d, b.h
    r, z = w / 2, h / 2
    b.rod((0, -d / 2, z), (0, d * 0.2, z), r * 0.6, b.mat(), "barrel", 14, solid=True)
    for k in range(6):
        y = -d * 0.36 + k * d * 0.06
        b.rod((0, y, z), (0, y + d * 0.03, z), r * 0.68, "plastic_dark", "grip", 14)
    for k in range(4):
        y = d * (0.2 + 0.05 * k)
        b.rod((0, y, z), (0, y + d * 0.06, z), r * (0.66 + 0.1 * k), b.mat(), "head", 16)
    b.rod((0, d * 0.4, z), (0, d * 0.49, z), r, "metal_light", "head", 20, solid=True)
    b.rod((0, d * 0.48, z), (0, d / 2, z), r * 0.84, "light_ffe58a", "lens", 20)
    b.box((-r * 0.25, r * 0.25), (d * 0.06, d * 0.16), (z + r * 0.5, z + r * 0.75), "paint_red", "switch", solid=False)


@recipe("work_gloves")
def work_gloves(b: Builder) -> None:
    """A pair of gloves side by side, palms down: four fingers, a thumb, a rubber palm and a knitted cuff each."""
    w, d, h = b.w, b.d, b.h
    for side in (-1, 1):
        x, half = side * w * 0.26, w * 0.19
        b.cushion((x - half, x + half), (-d * 0.24, d * 0.14), (0, h), b.mat(), "hands", 0.6)
        b.cushion((x - half * 0.9, x + half * 0.9), (-d / 2, -d * 0.2), (0, h * 0.9), "fabric_red", "cuffs", 0.5)
        for k in range(4):
            middle = x + half * (-0.75 + 0.5 * k)
            reach = d * (0.42, 0.5, 0.48, 0.38)[k if side > 0 else 3 - k]
            b.cushion(
                (middle - half * 0.24, middle + half * 0.24),
                (d * 0.06, reach),
                (h * 0.1, h * 0.85),
                b.mat(),
                "fingers",
                0.9,
                8,
            )
        thumb = x - side * half * 1.0
        b.rod((thumb, -d * 0.12, h * 0.45), (thumb - side * w * 0.05, d * 0.1, h * 0.45), h * 0.3, b.mat(), "thumbs", 8)


@recipe("tool_board")
def tool_board(b: Builder) -> None:
    """Board with hanging tools."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.02), (0, h), b.mat(), "board")
    for k in range(9):
        x, z = -w * 0.42 + (k % 5) * w * 0.21, h * (0.55 if k < 5 else 0.12)
        b.rod(
            (x, -d / 2 + 0.035, z),
            (x, -d / 2 + 0.035, z + h * 0.2),
            0.012,
            ("wood_oak", "plastic_red", "plastic_blue")[k % 3],
            "tools",
        )
        b.box(
            (x - 0.05, x + 0.05) if k % 2 else (x - 0.02, x + 0.02),
            (-d / 2 + 0.02, d / 2),
            (z + h * 0.2, z + h * 0.28),
            "metal_steel",
            "tools",
            solid=False,
        )
