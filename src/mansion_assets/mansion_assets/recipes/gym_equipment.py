"""Training machines, weights, punching bags, exercise balls."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("treadmill")
def treadmill(b: Builder) -> None:
    """Belt, uprights, console; the runner faces the back (-y)."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0.04, 0.14), b.mat(), "deck")
    b.box((-w * 0.32, w * 0.32), (-d * 0.3, d * 0.49), (0.14, 0.15), "rubber_black", "belt")
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.3), (0, 0.24), "plastic_dark", "hood")
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.04)
        b.rod((x, -d * 0.38, 0.15), (x, -d * 0.3, h * 0.85), 0.03, b.mat(), "posts", solid=True)
        b.rod((x, -d * 0.3, h * 0.72), (x, 0.0, h * 0.7), 0.022, "rubber_black", "bars")
        b.box((x - 0.03, x + 0.03), (d * 0.3, d / 2), (0, 0.05), "plastic_dark", "feet")
    b.prism(
        [(-d * 0.36, h * 0.78), (-d * 0.24, h * 0.8), (-d * 0.3, h), (-d * 0.34, h)],
        (-w * 0.46, w * 0.46),
        "plastic_black",
        part="console",
    )
    b.prism(
        [(-d * 0.24, h * 0.82), (-d * 0.235, h * 0.82), (-d * 0.295, h * 0.98), (-d * 0.3, h * 0.98)],
        (-w * 0.28, w * 0.28),
        "screen_blue",
        part="screen",
        solid=False,
    )


@recipe("exercise_bike")
def exercise_bike(b: Builder) -> None:
    """Stationary bicycle."""
    w, d, h = b.w, b.d, b.h
    for y in (-d / 2 + 0.04, d / 2 - 0.04):
        b.rod((-w / 2, y, 0.04), (w / 2, y, 0.04), 0.04, b.mat(), "feet", 12, solid=True)
    b.rod((0, -d / 2 + 0.04, 0.06), (0, d / 2 - 0.04, 0.1), 0.04, b.mat(), "beam", 10, solid=True)
    b.rod((-0.05, d * 0.22, 0.36), (0.05, d * 0.22, 0.36), 0.25, "metal_steel", "wheel", 24, solid=True)
    b.rod((0, -d * 0.1, 0.15), (0, -d * 0.24, h * 0.72), 0.03, b.mat(), "post", solid=True)
    b.cushion((-0.12, 0.12), (-d * 0.38, -d * 0.14), (h * 0.72, h * 0.78), "leather_black", "saddle", 0.7)
    b.rod((0, d * 0.16, 0.3), (0, d * 0.3, h * 0.85), 0.03, b.mat(), "post", solid=True)
    b.path(
        [(-0.2, d * 0.14, h * 0.88), (-0.2, d * 0.3, h * 0.84), (0.2, d * 0.3, h * 0.84), (0.2, d * 0.14, h * 0.88)],
        0.018,
        "rubber_black",
        "bar",
    )
    b.box((-0.14, 0.14), (d * 0.3, d * 0.34), (h * 0.84, h), "plastic_black", "console")
    b.rod((-0.18, 0.0, 0.3), (0.18, 0.0, 0.38), 0.02, "metal_dark", "pedals")


@recipe("elliptical")
def elliptical(b: Builder) -> None:
    """Cross trainer: wheel, long pedals, moving bars."""
    w, d, h = b.w, b.d, b.h
    b.box((-w * 0.4, w * 0.4), (d * 0.4, d / 2), (0, 0.08), b.mat(), "feet")
    b.box((-w * 0.4, w * 0.4), (-d / 2, -d * 0.42), (0, 0.08), b.mat(), "feet")
    b.box((-0.05, 0.05), (-d * 0.45, d * 0.45), (0.04, 0.12), b.mat(), "beam")
    b.rod((-0.08, -d * 0.32, 0.36), (0.08, -d * 0.32, 0.36), 0.3, "plastic_dark", "wheel", 24, solid=True)
    b.rod((0, d * 0.3, 0.1), (0, d * 0.24, h * 0.85), 0.04, b.mat(), "post", solid=True)
    for sx in (-1, 1):
        x = sx * w * 0.3
        b.rod((x, -d * 0.34, 0.34 + 0.1 * sx), (x, d * 0.3, 0.22), 0.025, b.mat(), "levers")
        b.box((x - 0.08, x + 0.08), (-d * 0.05, d * 0.12), (0.28, 0.33), "rubber_black", "pedals")
        b.path(
            [(x, d * 0.3, 0.25), (sx * w * 0.44, d * 0.22, h * 0.6), (sx * w * 0.48, d * 0.1, h - 0.02)],
            0.02,
            b.mat(),
            "bars",
        )
    b.box((-0.17, 0.17), (d * 0.2, d * 0.25), (h * 0.78, h * 0.94), "plastic_black", "console")


@recipe("rower")
def rower(b: Builder) -> None:
    """Rail, sliding seat, flywheel, handle."""
    w, d, h = b.w, b.d, b.h
    b.box((-0.05, 0.05), (-d * 0.2, d / 2), (0.28, 0.36), b.mat(), "rail")
    b.box((-0.15, 0.15), (d * 0.1, d * 0.24), (0.36, 0.43), "leather_black", "seat")
    b.rod((-0.1, -d * 0.36, 0.38), (0.1, -d * 0.36, 0.38), 0.28, "plastic_dark", "wheel", 24, solid=True)
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.46), (0, 0.06), b.mat(), "feet")
    b.box((-w * 0.3, w * 0.3), (d * 0.44, d / 2), (0, 0.06), b.mat(), "feet")
    b.box((-0.03, 0.03), (d * 0.44, d * 0.48), (0.05, 0.3), b.mat(), "feet")
    for sx in (-1, 1):
        b.box((sx * 0.16 - 0.06, sx * 0.16 + 0.06), (-d * 0.22, -d * 0.12), (0.18, 0.42), "plastic_black", "footrests")
    b.rod((0, -d * 0.36, 0.5), (0, -d * 0.28, h - 0.05), 0.02, b.mat(), "arm")
    b.box((-0.12, 0.12), (-d * 0.3, -d * 0.27), (h - 0.2, h), "plastic_black", "monitor")
    b.rod((-0.25, -d * 0.18, 0.55), (0.25, -d * 0.18, 0.55), 0.016, "rubber_black", "handle")


@recipe("weight_bench")
def weight_bench(b: Builder) -> None:
    """Padded bench."""
    w, d, h = b.w, b.d, b.h
    for y in (-d * 0.4, d * 0.4):
        b.box((-w / 2, w / 2), (y - 0.03, y + 0.03), (0, 0.05), "metal_black", "feet")
        b.box((-0.03, 0.03), (y - 0.03, y + 0.03), (0.05, h - 0.1), "metal_black", "posts")
    b.box((-0.03, 0.03), (-d * 0.4, d * 0.4), (h - 0.14, h - 0.08), "metal_black", "beam")
    b.cushion((-0.15, 0.15), (-d / 2, d / 2), (h - 0.08, h), b.mat(), "pad", 0.4)


def _barbell(b: Builder, y: float, z: float) -> None:
    half = b.w / 2
    b.rod((-half, y, z), (half, y, z), 0.014, "metal_chrome", "bar", solid=True)
    for sx in (-1, 1):
        for k, r in enumerate((0.21, 0.17)):
            x = sx * (half - 0.2 + 0.05 * k)
            b.rod((x - 0.018, y, z), (x + 0.018, y, z), r, "rubber_black", "plates", 24, solid=True)


@recipe("bench_press")
def bench_press(b: Builder) -> None:
    """Bench below a barbell on its rack."""
    _w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * 0.5
        b.box((x - 0.03, x + 0.03), (-d / 2, -d * 0.1), (0, 0.05), b.mat(), "feet")
        b.box((x - 0.03, x + 0.03), (-d * 0.36, -d * 0.32), (0.04, h - 0.1), b.mat(), "posts")
    b.box((-0.5, 0.5), (-d * 0.36, -d * 0.32), (0.2, 0.26), b.mat(), "beam")
    b.cushion((-0.15, 0.15), (-d * 0.4, d * 0.46), (0.4, 0.48), "leather_black", "pad", 0.4)
    b.box((-0.03, 0.03), (-d * 0.3, d * 0.4), (0.3, 0.4), b.mat(), "beam")
    b.box((-0.25, 0.25), (d / 2 - 0.06, d / 2), (0, 0.05), b.mat(), "feet")
    b.box((-0.03, 0.03), (d / 2 - 0.06, d / 2), (0.04, 0.36), b.mat(), "posts")
    _barbell(b, -d * 0.3, h - 0.21)


@recipe("dumbbell")
def dumbbell(b: Builder) -> None:
    """One weight lying on the floor, its bar along y."""
    w, d, h = b.w, b.d, b.h
    r = min(w, h) / 2
    b.rod((0, -d * 0.3, r), (0, d * 0.3, r), r * 0.28, "metal_chrome", "bar", 10)
    for sy in (-1, 1):
        b.rod((0, sy * d * 0.24, r), (0, sy * d / 2, r), r, b.mat(), "weights", 16, solid=True)


@recipe("dumbbell_rack")
def dumbbell_rack(b: Builder) -> None:
    """Sloped tiers of dumbbells or kettlebells."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.03)
        b.box((x - 0.03, x + 0.03), (-d / 2, d / 2), (0, 0.05), b.mat(), "frame")
        b.prism(
            [(d * 0.3, 0.04), (d * 0.4, 0.04), (-d * 0.3, h), (-d * 0.4, h)],
            (x - 0.03, x + 0.03),
            b.mat(),
            part="frame",
        )
    tiers = 3 if h > 0.9 else 2
    for k in range(tiers):
        z = 0.22 + k * (h - 0.36) / max(1, tiers - 1)
        y = d * 0.26 - k * d * 0.48 / max(1, tiers - 1)
        b.box((-w / 2 + 0.03, w / 2 - 0.03), (y - 0.11, y + 0.11), (z - 0.03, z), b.mat(), "tiers")
        count = int((w - 0.2) / 0.17)
        for j in range(count):
            x = -w / 2 + 0.13 + j * (w - 0.26) / (count - 1)
            if b.p.get("style") == "kettle":
                b.ball(
                    (x, y, z + 0.08),
                    (0.07, 0.07, 0.08),
                    ("rubber_black", "paint_red", "paint_blue")[j % 3],
                    "weights",
                    10,
                    solid=False,
                )
                b.path(
                    [(x - 0.04, y, z + 0.13), (x - 0.03, y, z + 0.2), (x + 0.03, y, z + 0.2), (x + 0.04, y, z + 0.13)],
                    0.012,
                    "metal_dark",
                    "weights",
                )
            else:
                for sy in (-1, 1):
                    b.rod(
                        (x, y + sy * 0.05, z + 0.065),
                        (x, y + sy * 0.13, z + 0.065),
                        0.06,
                        "rubber_black",
                        "weights",
                        12,
                    )
                b.rod((x, y - 0.06, z + 0.065), (x, y + 0.06, z + 0.065), 0.016, "metal_chrome", "weights")


@recipe("gym_frame")
def gym_frame(b: Builder) -> None:
    """Weight machines: cable tower, leg press, power rack."""
    style = b.p.get("style", "cable")
    if style == "rack":
        _power_rack(b)
    elif style == "seat":
        _leg_press(b)
    else:
        _cable_tower(b)


def _power_rack(b: Builder) -> None:
    """Frame of four posts with a barbell."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    b.legs((0, h), 0.035, m, 0.05)
    for z in (0.03, h - 0.03):
        for sx in (-1, 1):
            x = sx * (w / 2 - 0.085)
            b.box((x - 0.03, x + 0.03), (-d / 2, d / 2), (z - 0.03, z + 0.03), m, "frame")
        b.box((-w / 2, w / 2), (-d / 2 + 0.05, -d / 2 + 0.11), (z - 0.03, z + 0.03), m, "frame")
    _barbell(b, d / 2 - 0.14, h * 0.6)


def _leg_press(b: Builder) -> None:
    """Sloped rails with a sled of plates, facing a reclined seat."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    b.box((-w * 0.4, w * 0.4), (-d / 2, d / 2), (0, 0.06), m, "base")
    for sx in (-1, 1):
        x, plate = sx * w * 0.3, (-d * 0.22, h * 0.62)
        b.rod((x, d * 0.2, 0.05), (x, -d / 2 + 0.05, h - 0.04), 0.035, m, "rails", 10, solid=True)
        b.rod((sx * w * 0.34, *plate), (sx * w / 2, *plate), 0.2, "rubber_black", "plates", 24)
    b.prism(
        [(-d * 0.3, h * 0.5), (-d * 0.24, h * 0.46), (-d * 0.12, h * 0.78), (-d * 0.2, h * 0.82)],
        (-w * 0.3, w * 0.3),
        "metal_dark",
        part="sled",
    )
    b.cushion((-0.24, 0.24), (d * 0.12, d * 0.36), (0.2, 0.32), "leather_black", "seat")
    b.prism(
        [(d * 0.34, 0.28), (d * 0.4, 0.26), (d * 0.5, 0.85), (d * 0.42, 0.88)],
        (-0.24, 0.24),
        "leather_black",
        part="back",
    )


def _cable_tower(b: Builder) -> None:
    """Stack of weights between posts, a grip on a cable, a seat before it."""
    w, d, h = b.w, b.d, b.h
    m, posts = b.mat(), (-d / 2 + 0.08, -d / 2 + 0.16)
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.3), (0, 0.06), m, "base")
    b.box((-0.05, 0.05), (-d / 2 + 0.1, d / 2), (0, 0.06), m, "base")
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.04)
        b.box((x - 0.03, x + 0.03), posts, (0.05, h), m, "posts")
    b.box((-w / 2, w / 2), posts, (h - 0.07, h), m, "head")
    b.box((-0.04, 0.04), (-d / 2 + 0.1, 0.1), (h - 0.06, h), m, "head")
    for k in range(11):
        z = 0.12 + k * 0.06
        y = (-d / 2 + 0.04, -d / 2 + 0.22)
        b.box((-0.16, 0.16), y, (z, z + 0.05), "metal_dark", "stack", solid=k in (0, 10))
    b.rod((0, 0.08, h - 0.06), (0, 0.12, h * 0.78), 0.005, "plastic_black", "cable")
    b.rod((-0.4, 0.12, h * 0.77), (0.4, 0.12, h * 0.77), 0.014, "metal_chrome", "grip")
    b.cushion((-0.17, 0.17), (0.08, d / 2 - 0.02), (0.42, 0.5), "leather_black", "seat")
    b.box((-0.03, 0.03), (d * 0.2, d * 0.26), (0.05, 0.44), m, "posts")


@recipe("hanging_bag")
def hanging_bag(b: Builder) -> None:
    """A heavy bag with white bands that hangs by four chains from the arm of a stand, and gloves at its foot."""
    w, d, h = b.w, b.d, b.h
    back = -d / 2 + 0.04
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.1), (0, 0.05), "metal_black", "stand")
    b.box((-0.05, 0.05), (-d / 2, d * 0.48), (0, 0.05), "metal_black", "stand")
    b.box((-0.04, 0.04), (back - 0.04, back + 0.04), (0, h), "metal_black", "stand")
    b.box((-0.03, 0.03), (back, d * 0.14), (h - 0.06, h), "metal_black", "stand")
    b.rod((0, back, h * 0.8), (0, 0.0, h - 0.03), 0.02, "metal_black", "stand")
    y, r, low, high = d * 0.1, min(w, d) * 0.3, h * 0.16, h * 0.78
    color = b.mat() if b.mat() != "leather_black" else "leather_red"
    b.lathe([(r * 0.8, low), (r, low + 0.05), (r, high - 0.05), (r * 0.8, high)], color, (0, y), "bag", 22)
    for z in (low + 0.12, (low + high) / 2 - 0.04, high - 0.2):
        b.lathe([(r * 1.015, z), (r * 1.015, z + 0.08)], "plastic_white", (0, y), "bands", 22)
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        b.rod(
            (math.cos(a) * r * 0.8, y + math.sin(a) * r * 0.8, high - 0.01),
            (0, y, h * 0.91),
            0.012,
            "metal_chrome",
            "chains",
            6,
        )
    b.rod((0, y, h * 0.9), (0, y, h - 0.05), 0.02, "metal_chrome", "chains", 6)
    DrawnFace.front(b, y + r).write("BOX", (-r * 0.62, r * 0.62), (h * 0.5, h * 0.62), "plastic_white", "letters", 0.01)
    for side in (-1, 1):
        x = side * 0.15
        b.cushion((x - 0.075, x + 0.075), (d * 0.3, d / 2), (0.0, 0.15), "leather_2f5fc8", "gloves", 0.8)


@recipe("exercise_ball")
def exercise_ball(b: Builder) -> None:
    """A large ball with raised rings round it and a valve."""
    w, h = b.w, b.h
    r = w / 2
    b.ball((0, 0, h / 2), (r, r, h / 2), b.mat(), "ball", 24)
    for k in range(9):
        a = math.radians(-60 + 15 * k)
        z, ring = h / 2 + math.sin(a) * h * 0.498, math.cos(a) * r * 0.995
        b.lathe(
            [(ring * 0.98, z - h * 0.012), (ring + r * 0.012, z), (ring * 0.98, z + h * 0.012)],
            "plastic_8fb6e9",
            part="rings",
            n=28,
        )
    face = DrawnFace.front(b, r * 0.99)
    face.disc(0, h * 0.5, r * 0.06, "plastic_white", "valve", 0.01)
