"""Food, cutlery, tools with a handle, and boxes of all kinds."""

from mansion_scene.assets.builder import Box, Builder
from mansion_scene.assets.registry import recipe

__all__: list[str] = []


@recipe("ball")
def ball(b: Builder) -> None:
    """Round things: fruit, bread, balls, half shells."""
    w, d, h = b.w, b.d, b.h
    style = b.p.get("style", "plain")
    if style == "dome":
        b.lathe(
            [
                (0.5, 0),
                (0.5, h * 0.12),
                (0.42, h * 0.16),
                (0.36, h * 0.6),
                (0.18, h * 0.95),
                (0.02, h),
            ],
            b.mat(),
            stretch=(w, d),
            n=20,
        )
        return
    if style == "loaf":
        b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, h), b.mat(), "loaf", 0.8, 14)
        for k in range(3):
            y = -d * 0.25 + k * d * 0.25
            b.box(
                (-w * 0.25, w * 0.25),
                (y - 0.006, y + 0.006),
                (h * 0.97, h),
                "food_beige",
                "cuts",
                False,
            )
        return
    top = h * (0.93 if style == "apple" else 1.0)
    b.ball((0, 0, top / 2), (w / 2, d / 2, top / 2), b.mat(), "body", 16)
    if style == "apple":
        b.rod((0, 0, top * 0.95), (0, 0, h), max(0.002, w * 0.03), "wood_brown", "stalk", 6)
    elif style == "leafy":
        for k in range(4):
            x, y = ((0.2, 0), (-0.2, 0.1), (0, 0.22), (0.05, -0.2))[k]
            b.ball(
                (x * w, y * d, h * 0.55),
                (w * 0.28, d * 0.28, h * 0.42),
                "leaf_green",
                "leaves",
                8,
                False,
            )
    elif style == "seams":
        for r in ((w * 0.502, 0.008, h * 0.5), (0.008, d * 0.502, h * 0.502)):
            b.ball(
                (0, 0, h / 2),
                (max(r[0], 0.004), max(r[1], 0.004), r[2]),
                "rubber_black",
                "seams",
                16,
                False,
            )


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
    b.boxes.append(_flat(b))
    b.rod(points[-1], (w / 2, d / 2, h * 0.5), h * 0.15, "food_brown", "tip")


def _flat(b: Builder) -> Box:
    return Box((0.0, 0.0, b.h / 2), (b.w, b.d, b.h))


@recipe("utensil")
def utensil(b: Builder) -> None:
    """Long things with the working end to the front: cutlery, pens, tools, rackets."""
    w, d, h = b.w, b.d, b.h
    style, main = str(b.p.get("style", "pen")), b.mat()
    long = "z" if h > 2 * d and h > w else "y"
    if long == "z":
        _upright(b, style)
        return
    grip = -d * 0.1
    r = min(w, h) / 2
    if style == "pen":
        b.rod((0, -d / 2, h / 2), (0, d * 0.4, h / 2), r, main, "barrel", 8, True)
        b.rod((0, d * 0.4, h / 2), (0, d / 2, h / 2), r * 0.4, "plastic_black", "tip", 8)
    elif style in ("knife", "wrench", "scissors"):
        b.box(
            (-w / 2, w / 2),
            (-d / 2, grip),
            (0, h),
            "plastic_black" if style != "wrench" else main,
            "handle",
        )
        b.prism(
            [
                (-w / 2 if style != "knife" else -w * 0.2, grip),
                (w / 2 if style != "knife" else w * 0.2, grip),
                (w * 0.2, d * 0.45),
                (0, d / 2),
            ],
            (h * 0.1, h * 0.9),
            main,
            "z",
            "blade",
        )
        if style == "scissors":
            b.prism(
                [(-w / 2, -d * 0.2), (-w * 0.2, -d * 0.2), (w / 2, d / 2 - 0.01)],
                (0, h * 0.6),
                main,
                "z",
                "blade",
            )
    elif style in ("fork", "spoon", "spatula", "brush", "racket"):
        b.rod(
            (0, -d / 2, h * 0.4),
            (0, d * 0.2, h * 0.4),
            min(w * 0.16, h * 0.3),
            main if style != "brush" else "wood_oak",
            "handle",
            8,
            True,
        )
        if style == "spoon":
            b.ball((0, d / 2 - d * 0.16, h / 2), (w / 2, d * 0.16, h / 2), main, "bowl", 10)
        elif style == "fork":
            b.box((-w / 2, w / 2), (d * 0.2, d * 0.3), (0, h * 0.5), main, "neck")
            for k in range(4):
                x = -w / 2 + (k + 0.5) * w / 4
                b.box((x - w * 0.07, x + w * 0.07), (d * 0.3, d / 2), (h * 0.1, h), main, "tines")
        elif style == "racket":
            b.lathe(
                [(0.5, 0), (0.5, h), (0.44, h), (0.44, h * 0.1)],
                main,
                (0, d * 0.26),
                "frame",
                24,
                (w, d * 0.48),
            )
            b.cyl(0, -d * 0.36, (0, h), min(w * 0.08, 0.02), "leather_black", "grip")
        else:
            b.box((-w / 2, w / 2), (d * 0.15, d / 2), (0, h), main, "blade")
    elif style == "hammer":
        b.rod((0, -d / 2, h / 2), (0, d * 0.4, h / 2), h * 0.35, main, "handle", 8, True)
        b.box((-w / 2, w / 2), (d * 0.36, d / 2), (0, h), "metal_steel", "head")
    elif style == "screwdriver":
        b.rod((0, -d / 2, h / 2), (0, -d * 0.02, h / 2), r, main, "handle", 8, True)
        b.rod((0, -d * 0.02, h / 2), (0, d / 2, h / 2), r * 0.3, "metal_steel", "shaft", 8, True)
    else:
        b.rod((0, -d / 2, h / 2), (0, d / 2, h / 2), r, main, "body", 10, True)


def _upright(b: Builder, style: str) -> None:
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    if style == "umbrella":
        b.lathe(
            [(0.05, 0), (0.3, h * 0.2), (0.5, h * 0.7), (0.1, h * 0.74), (0.06, h * 0.9)],
            main,
            stretch=(w, d),
        )
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
            [
                (0.3, 0),
                (0.3, h * 0.02),
                (0.2, h * 0.05),
                (0.22, h * 0.4),
                (0.5, h * 0.85),
                (0.3, h),
            ],
            main,
            stretch=(w, d),
        )
    else:
        b.lathe([(0.45, 0), (0.5, h * 0.1), (0.5, h * 0.9), (0.2, h)], main, stretch=(w, d), n=10)


@recipe("block")
def block(b: Builder) -> None:
    """Box-shaped things, told apart by what is on them."""
    w, d, h = b.w, b.d, b.h
    style, main = str(b.p.get("style", "plain")), b.mat()
    x, y = (-w / 2, w / 2), (-d / 2, d / 2)
    maker = _BLOCKS.get(style)
    if maker is not None:
        maker(b)
    elif style == "carton":
        high = h * (0.86 if h > 1.3 * w else 1.0)
        b.box(x, y, (0, high), main, "body")
        if high < h:
            b.prism(
                [
                    (-d / 2, high),
                    (d / 2, high),
                    (0.004, h * 0.97),
                    (0.004, h),
                    (-0.004, h),
                    (-0.004, h * 0.97),
                ],
                x,
                "paper_white",
                part="gable",
            )
        b.box(
            (-w * 0.32, w * 0.32),
            (d / 2 - 0.001, d / 2),
            (high * 0.3, high * 0.7),
            "paper_white",
            "label",
            False,
        )
        b.box(
            (-w * 0.36, w * 0.36),
            (d / 2 - 0.001, d / 2),
            (high * 0.74, high * 0.84),
            "paper_yellow",
            "label",
            False,
        )
    elif style == "speaker":
        b.box(x, (-d / 2, d / 2 - 0.012), (0, h), main, "case")
        for z, r in ((0.32, 0.36), (0.74, 0.22)):
            b.rod((0, d / 2 - 0.014, z * h), (0, d / 2, z * h), r * w, "plastic_dark", "cones", 20)
            b.rod(
                (0, d / 2 - 0.013, z * h),
                (0, d / 2 - 0.001, z * h),
                r * w * 0.4,
                "metal_grey",
                "cones",
                12,
            )
    elif style == "screen":
        b.box(x, y, (0, h), main, "case")
        b.box(
            (-w * 0.3, w * 0.3),
            (d / 2 - 0.001, d / 2),
            (h * 0.3, h * 0.7),
            "screen_blue",
            "panel",
            False,
        )
        b.box(
            (-w * 0.35, w * 0.35),
            (-d * 0.2, d * 0.25),
            (h - 0.001, h),
            "plastic_light",
            "plate",
            False,
        )
    elif style in ("flatbox", "gift"):
        b.box(x, y, (0, h * 0.95), main, "body")
        b.box((-w * 0.06, w * 0.06), y, (0, h * 0.96), "paper_white", "band", False)
        b.box(x, (-d * 0.06, d * 0.06), (0, h * 0.96), "paper_white", "band", False)
        b.ball((0, 0, h * 0.96), (w * 0.12, d * 0.12, h * 0.04), "paper_white", "bow", 8, False)
    elif style == "papers":
        count = 4
        for k in range(count):
            shift = 0.004 * (k % 3) - 0.004
            b.box(
                (x[0] + max(0, shift), x[1] + min(0, shift)),
                (y[0] + max(0, -shift), y[1]),
                (h * k / count, h * (k + 1) / count),
                "paper_white" if k % 2 else "paper_light",
                "sheets",
            )
    elif style == "layers":
        for k, color in enumerate(("food_beige", "food_green", "food_red", "food_beige")):
            b.box(x, y, (h * k / 4, h * (k + 1) / 4), color, "layers")
    elif style in ("wedge", "tent"):
        tip = 0.004 if style == "tent" else d * 0.25
        b.prism(
            [(-d / 2, 0), (d / 2, 0), (tip if style == "tent" else d / 2, h), (-tip, h)], x, main
        )
    else:
        b.box(x, y, (0, h), main, "body")


def _carton_open(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    t, low = 0.008, b.h * 0.92
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.02, d / 2 - 0.02), (0, t), b.mat(), "floor")
    for sx in (-1, 1):
        lo, hi = sorted((sx * (w / 2 - 0.02), sx * (w / 2 - 0.02 - t)))
        b.box((lo, hi), (-d / 2 + 0.02, d / 2 - 0.02), (0, low), b.mat(), "sides")
        b.prism(
            [
                (sx * (w / 2 - 0.02), low),
                (sx * w / 2, h),
                (sx * (w / 2 - 0.005), h),
                (sx * (w / 2 - 0.03), low),
            ],
            (-d / 2 + 0.02, d / 2 - 0.02),
            b.mat(),
            "y",
            "flaps",
            False,
        )
    for sy in (-1, 1):
        lo, hi = sorted((sy * (d / 2 - 0.02), sy * (d / 2 - 0.02 - t)))
        b.box((-w / 2 + 0.02, w / 2 - 0.02), (lo, hi), (0, low), b.mat(), "sides")
        b.prism(
            [
                (sy * (d / 2 - 0.02), low),
                (sy * d / 2, h),
                (sy * (d / 2 - 0.005), h),
                (sy * (d / 2 - 0.03), low),
            ],
            (-w / 2 + 0.02, w / 2 - 0.02),
            b.mat(),
            part="flaps",
            solid=False,
        )
    b.box((-0.03, 0.03), (d / 2 - 0.021, d / 2 - 0.018), (0, low), "paper_beige", "tape", False)


def _bag(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    low = h * 0.74
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, low), b.mat(), "body", 0.35, 12)
    for sy in (-1, 1):
        y = sy * d * 0.25
        b.path(
            [
                (-w * 0.22, y, low * 0.95),
                (-w * 0.18, y, h - 0.008),
                (w * 0.18, y, h - 0.008),
                (w * 0.22, y, low * 0.95),
            ],
            0.008,
            "leather_dark",
            "handles",
        )
    b.box(
        (-w * 0.25, w * 0.25),
        (d / 2 - 0.003, d / 2),
        (low * 0.2, low * 0.5),
        "fabric_dark",
        "pocket",
        False,
    )


def _suitcase(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0.05, h - 0.08), b.mat(), "shell", 0.3, 12)
    for k in range(4):
        x = -w * 0.36 + k * w * 0.24
        b.box(
            (x - 0.008, x + 0.008),
            (d / 2 - 0.003, d / 2),
            (h * 0.16, h * 0.8),
            "plastic_dark",
            "ribs",
            False,
        )
    b.wheels(0.025, 0.06)
    b.path(
        [
            (-w * 0.2, -d * 0.3, h - 0.1),
            (-w * 0.2, -d * 0.3, h - 0.01),
            (w * 0.2, -d * 0.3, h - 0.01),
            (w * 0.2, -d * 0.3, h - 0.1),
        ],
        0.01,
        "metal_steel",
        "handle",
    )


def _tray(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    t = min(0.012, w * 0.05)
    floor = min(0.006, h * 0.3)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, floor), b.mat(), "floor")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - t)))
        b.box((lo, hi), (-d / 2, d / 2), (0, h), b.mat(), "rim")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + t), (0, h), b.mat(), "rim")
    b.box((-w / 2, w / 2), (d / 2 - t, d / 2), (0, h if h < 0.06 else h * 0.3), b.mat(), "rim")
    if h > 0.06:
        b.box(
            (-w * 0.42, w * 0.42),
            (-d * 0.4, d * 0.42),
            (floor, h * 0.3),
            "paper_white",
            "papers",
            False,
        )


def _lidbox(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    low = h * 0.78
    b.box(
        (-w / 2 + 0.004, w / 2 - 0.004), (-d / 2 + 0.004, d / 2 - 0.012), (0, low), b.mat(), "body"
    )
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.008), (low, h * 0.86), b.mat(), "lid")
    b.path(
        [
            (-w * 0.22, 0, h * 0.85),
            (-w * 0.2, 0, h - 0.008),
            (w * 0.2, 0, h - 0.008),
            (w * 0.22, 0, h * 0.85),
        ],
        0.008,
        "plastic_black",
        "handle",
    )
    b.box(
        (-0.02, 0.02),
        (d / 2 - 0.012, d / 2),
        (low * 0.85, low * 1.05),
        "metal_steel",
        "latch",
        False,
    )


def _tissue(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.75), b.mat(), "box")
    b.cushion(
        (-w * 0.18, w * 0.18),
        (-d * 0.12, d * 0.12),
        (h * 0.7, h),
        "paper_white",
        "tissue",
        0.9,
        8,
        False,
    )


def _knives(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.prism(
        [(-d / 2, 0), (d / 2, 0), (d * 0.2, h * 0.72), (-d / 2, h * 0.6)], (-w / 2, w / 2), b.mat()
    )
    for k in range(4):
        x = -w * 0.3 + k * w * 0.2
        b.rod((x, -d * 0.1, h * 0.6), (x, -d * 0.3, h - 0.01), 0.009, "plastic_black", "handles", 6)


def _clipboard(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.35), b.mat(), "board")
    b.box(
        (-w * 0.44, w * 0.44),
        (-d * 0.46, d * 0.36),
        (h * 0.35, h * 0.45),
        "paper_white",
        "sheet",
        False,
    )
    b.box((-w * 0.18, w * 0.18), (d * 0.36, d * 0.48), (h * 0.35, h), "metal_steel", "clip")


def _tube(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.prism(
        [(-w / 2, h * 0.4), (w * 0.25, 0), (w * 0.25, h), (-w / 2, h * 0.6)],
        (-d / 2, d / 2),
        b.mat(),
        "y",
    )
    b.box((w * 0.25, w / 2), (-d * 0.3, d * 0.3), (h * 0.15, h * 0.85), "plastic_red", "cap")


def _napkins(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2, sy * (d / 2 - 0.006)))
        b.box((-w / 2, w / 2), (lo, hi), (0, h * 0.75), b.mat(), "holder")
    b.box((-w * 0.45, w * 0.45), (-d * 0.3, d * 0.3), (0.0, h), "paper_white", "napkins")


def _pad(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d * 0.1, d / 2), (0, h * 0.75), b.mat(), "body", 0.9)
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * w * 0.2))
        b.cushion((lo, hi), (-d / 2, d * 0.2), (0, h * 0.7), b.mat(), "grips", 0.9)
        b.cyl(
            sx * w * 0.15, 0.0, (h * 0.7, h), w * 0.06, "plastic_dark", "sticks", n=10, solid=False
        )


_BLOCKS = {
    "bag": _bag, "carton_open": _carton_open, "clipboard": _clipboard, "knives": _knives, "lidbox": _lidbox, "napkins": _napkins,
    "pad": _pad, "suitcase": _suitcase, "tissue": _tissue, "tray": _tray, "tube": _tube,
}  # fmt: skip
