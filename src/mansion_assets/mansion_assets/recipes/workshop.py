"""Machines and gear of workshops and studios: mill, band saw, robot arm, loom, potter's wheel."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("milling_machine")
def milling_machine(b: Builder) -> None:
    """A column with a motor head over a long, slotted table that stands on a knee; hand wheels on both."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    b.box((-w * 0.3, w * 0.3), (-d / 2, d * 0.3), (0, h * 0.06), main, "foot")
    b.box((-w * 0.18, w * 0.18), (-d / 2, -d * 0.12), (h * 0.06, h * 0.72), main, "column")
    b.box((-w * 0.14, w * 0.14), (-d * 0.12, d * 0.24), (h * 0.26, h * 0.4), main, "knee")
    b.cyl(0, d * 0.1, (h * 0.06, h * 0.26), w * 0.05, "metal_steel", "screw")
    b.box((-w / 2, w / 2), (-d * 0.06, d * 0.28), (h * 0.4, h * 0.46), "metal_light", "table")
    for y in (0.0, 0.1, 0.2):
        b.box(
            (-w / 2, w / 2),
            (d * y, d * (y + 0.025)),
            (h * 0.46 - 0.001, h * 0.46 + 0.002),
            "metal_dark",
            "slots",
            solid=False,
        )
    b.box((-w * 0.13, w * 0.13), (-d * 0.48, d * 0.24), (h * 0.72, h * 0.82), main, "ram")
    b.box((-w * 0.14, w * 0.14), (d * 0.02, d * 0.28), (h * 0.66, h * 0.86), main, "head")
    b.cyl(0, d * 0.15, (h * 0.86, h), w * 0.11, "plastic_dark", "motor")
    b.cyl(0, d * 0.15, (h * 0.54, h * 0.66), w * 0.06, "metal_steel", "quill", w * 0.07)
    b.cyl(0, d * 0.15, (h * 0.475, h * 0.54), w * 0.025, "metal_dark", "cutter")
    b.box((-w * 0.12, w * 0.12), (d * 0.04, d * 0.22), (h * 0.46, h * 0.475), "metal_copper", "work")
    for x in (-w / 2, w / 2):
        b.rod((x * 0.94, d * 0.11, h * 0.43), (x, d * 0.11, h * 0.43), w * 0.09, "metal_chrome", "wheels", 16)
    b.rod((0, d * 0.24, h * 0.33), (0, d * 0.36, h * 0.33), w * 0.02, "metal_steel", "shaft")
    b.rod((0, d * 0.36, h * 0.33), (0, d / 2, h * 0.33), w * 0.1, "metal_chrome", "wheels", 16)


@recipe("band_saw")
def band_saw(b: Builder) -> None:
    """A frame like a C with two round wheel covers, a narrow blade between them, and a table in the gap."""
    w, d, h = b.w, b.d, b.h
    main, x, r = b.mat(), w * 0.06, w * 0.42
    b.box((-w / 2, w * 0.4), (-d * 0.4, d * 0.4), (0, h * 0.08), "metal_dark", "foot")
    b.box((-w / 2, -w * 0.28), (-d * 0.2, d * 0.16), (h * 0.06, h * 0.95), main, "column")
    for z in (h * 0.08 + r, h - r):
        b.rod((x, -d * 0.2, z), (x, d * 0.2, z), r, main, "covers", 24, solid=True)
        b.rod((x, d * 0.2, z), (x, d * 0.21, z), r * 0.84, "metal_light", "covers", 24)
        b.rod((x, d * 0.21, z), (x, d * 0.24, z), r * 0.18, "plastic_black", "hubs", 12)
    blade, table = x + r * 0.5, h * 0.56
    b.box(
        (blade - w * 0.012, blade + w * 0.012), (-d * 0.02, d * 0.06), (table - h * 0.1, h - r), "metal_chrome", "blade"
    )
    b.box((-w * 0.2, w / 2), (-d / 2, d / 2), (table, table + h * 0.03), "metal_steel", "table")
    b.box((-w * 0.1, w * 0.3), (-d * 0.15, d * 0.15), (h * 0.46, table), main, "trunnion")
    b.box((-w * 0.12, -w * 0.06), (-d / 2, d / 2), (table + h * 0.03, table + h * 0.07), "metal_blue", "fence")
    b.box((blade - w * 0.05, blade + w * 0.05), (-d * 0.06, d * 0.12), (h * 0.66, h * 0.72), "paint_yellow", "guard")
    b.cyl(-w * 0.38, d * 0.18, (h * 0.5, h * 0.53), w * 0.05, "paint_red", "switch")


@recipe("robot_arm")
def robot_arm(b: Builder) -> None:
    """An industrial arm: a turning base, a shoulder, two links with round joints, a wrist, and a gripper in front."""
    w, d, h = b.w, b.d, b.h
    main, r = b.mat(), min(w, d) * 0.15
    b.lathe(
        [(0.42, 0), (0.42, h * 0.04), (0.3, h * 0.06), (0.3, h * 0.16), (0.24, h * 0.2)],
        "metal_dark",
        (0, -d * 0.14),
        "base",
        24,
        (w * 0.85, d * 0.85),
    )
    shoulder, elbow = (-d * 0.14, h * 0.3), (-d * 0.3, h * 0.84)
    wrist = (d * 0.3, h * 0.8)
    b.box((-w * 0.2, w * 0.2), (-d * 0.3, d * 0.02), (h * 0.18, h * 0.3), main, "turret")
    for (y, z), size in ((shoulder, 1.15), (elbow, 1.0), (wrist, 0.7)):
        b.rod((-w * 0.22, y, z), (w * 0.22, y, z), r * size, main, "joints", 20, solid=True)
        for side in (-1, 1):
            b.rod((side * w * 0.22, y, z), (side * w * 0.27, y, z), r * size * 0.6, "plastic_dark", "motors", 16)
    b.rod((0, *shoulder), (0, *elbow), r * 0.8, main, "upper_arm", 12, solid=True)
    b.rod((0, *elbow), (0, *wrist), r * 0.66, main, "forearm", 12, solid=True)
    b.rod((0, *wrist), (0, wrist[0] + d * 0.06, h * 0.66), r * 0.42, "plastic_dark", "hand", 12)
    b.box((-w * 0.14, w * 0.14), (wrist[0], wrist[0] + d * 0.14), (h * 0.62, h * 0.66), "metal_steel", "gripper")
    for side in (-1, 1):
        x = side * w * 0.11
        b.box(
            (x - w * 0.025, x + w * 0.025),
            (wrist[0] + d * 0.02, wrist[0] + d * 0.12),
            (h * 0.5, h * 0.62),
            "metal_steel",
            "gripper",
        )
    b.path(
        [(w * 0.16, -d * 0.2, h * 0.24), (w * 0.3, -d * 0.42, h * 0.5), (w * 0.16, -d * 0.34, h * 0.9)],
        r * 0.14,
        "rubber_black",
        "cable",
    )


@recipe("loom")
def loom(b: Builder) -> None:
    """A weaver's floor loom: a timber frame, threads from the beam behind through two heddles, and cloth in front."""
    w, d, h = b.w, b.d, b.h
    main, t, level = b.mat(), w * 0.035, h * 0.55
    for x in (-w / 2 + t, w / 2 - t):
        for y, high in ((-d / 2 + t, level * 1.08), (d / 2 - t, level), (0.0, h)):
            b.box((x - t, x + t), (y - t, y + t), (0, high), main, "posts")
        for z in (h * 0.16, level * 0.92):
            b.box((x - t * 0.8, x + t * 0.8), (-d / 2, d / 2), (z, z + t * 2), main, "rails")
    b.box((-w / 2, w / 2), (-t * 1.2, t * 1.2), (h - t * 3, h), main, "castle")
    for y in (-d / 2 + t, d / 2 - t):
        b.rod((-w / 2, y, level), (w / 2, y, level), t * 1.4, main, "beams", 14, solid=True)
    b.rod(
        (-w * 0.44, d / 2 - t, h * 0.3),
        (w * 0.44, d / 2 - t, h * 0.3),
        t * 2.4,
        "fabric_red",
        "cloth_roll",
        16,
        solid=True,
    )
    _weave(b, level, t)


def _weave(b: Builder, level: float, t: float) -> None:
    """Heddles, warp, cloth and treadles of a loom whose beams are at `level`, its timbers `t` thick."""
    w, d, h = b.w, b.d, b.h
    for y in (-d * 0.1, d * 0.02):
        for z in (level * 0.74, level * 1.32):
            b.box((-w * 0.4, w * 0.4), (y - t * 0.3, y + t * 0.3), (z, z + t), "wood_birch", "heddles")
        for k in range(15):
            x = -w * 0.38 + k * w * 0.76 / 14
            b.rod((x, y, level * 0.74), (x, y, level * 1.34), t * 0.1, "plastic_white", "heddles", 4)
        for side in (-1, 1):
            b.rod((side * w * 0.3, y, level * 1.34), (side * w * 0.3, 0, h - t), t * 0.14, "fabric_white", "cords", 4)
    for k in range(25):
        x = -w * 0.38 + k * w * 0.76 / 24
        b.rod((x, -d / 2 + t, level + t), (x, d * 0.2, level + t), t * 0.13, "fabric_beige", "warp", 4)
    for k, color in enumerate(("fabric_red", "fabric_white", "fabric_blue", "fabric_white", "fabric_red")):
        y0 = d * 0.2 + k * (d * 0.28) / 5
        b.box(
            (-w * 0.39, w * 0.39),
            (y0, y0 + d * 0.28 / 5),
            (level + t * 0.6, level + t * 1.5),
            color,
            "cloth",
            solid=False,
        )
    b.box((-w * 0.42, w * 0.42), (d * 0.14, d * 0.18), (level * 0.9, level * 1.2), "wood_walnut", "reed", solid=False)
    for k in range(4):
        x = (k - 1.5) * w * 0.14
        b.prism(
            [(-d * 0.2, h * 0.03), (d * 0.36, h * 0.1), (d * 0.36, h * 0.13), (-d * 0.2, h * 0.06)],
            (x - t, x + t),
            "wood_walnut",
            part="treadles",
        )


@recipe("pottery_wheel")
def pottery_wheel(b: Builder) -> None:
    """A round wheel head with a bowl of clay in a wide splash pan, on a stand with a pedal."""
    w, d, h = b.w, b.d, b.h
    y, pan = -d * 0.06, h * 0.62
    for sx in (-1, 1):
        for sy in (-1, 1):
            b.rod(
                (sx * w * 0.4, y + sy * d * 0.32, 0),
                (sx * w * 0.32, y + sy * d * 0.26, pan * 0.9),
                w * 0.03,
                b.mat(),
                "legs",
                8,
                solid=True,
            )
    b.box((-w * 0.36, w * 0.36), (y - d * 0.28, y + d * 0.28), (pan * 0.5, pan * 0.9), b.mat(), "motor_box")
    b.lathe(
        [(0.44, pan * 0.88), (0.5, pan * 0.94), (0.5, h * 0.76), (0.47, h * 0.76), (0.46, pan)],
        "plastic_3d6a9e",
        (0, y),
        "splash_pan",
        28,
        (w, d * 0.84),
    )
    _clay(b, y, pan)


def _clay(b: Builder, y: float, pan: float) -> None:
    """The wheel head with a bowl on it, a pedal, a sponge, and tools on the rim of the pan."""
    w, d, h = b.w, b.d, b.h
    b.cyl(0, y, (pan, h * 0.7), w * 0.3, "metal_light", "wheel_head", n=28)
    b.lathe(
        [
            (0.13, h * 0.7),
            (0.15, h * 0.72),
            (0.24, h * 0.86),
            (0.2, h * 0.95),
            (0.22, h),
            (0.18, h),
            (0.16, h * 0.92),
            (0.18, h * 0.84),
        ],
        "food_a9683f",
        (0, y),
        "clay",
        24,
        (w, w),
    )
    b.prism(
        [(d * 0.3, 0), (d / 2, 0), (d / 2, h * 0.06), (d * 0.3, h * 0.14)],
        (w * 0.2, w * 0.42),
        "rubber_black",
        part="pedal",
    )
    b.ball((-w * 0.36, y + d * 0.26, h * 0.78), (w * 0.07, w * 0.06, h * 0.04), "food_e8d67a", "sponge", 8, solid=False)
    for k in range(3):
        a = 0.6 + k * 0.1
        b.rod(
            (-w * a / 1.5, y - d * 0.16, h * 0.74),
            (-w * a / 1.8, y + d * 0.04, h * 0.77),
            w * 0.012,
            "wood_oak",
            "tools",
            6,
        )


@recipe("starting_block")
def starting_block(b: Builder) -> None:
    """A swimmer's block: a sloping, rough top with a foot wedge on a white stand with a step, a number and a grip."""
    w, d, h = b.w, b.d, b.h
    b.box((-w * 0.3, w * 0.3), (-d * 0.3, d * 0.34), (0, h * 0.72), b.mat(), "stand")
    b.box((-w * 0.34, w * 0.34), (-d / 2, -d * 0.2), (h * 0.3, h * 0.36), b.mat(), "step")
    b.box((-w * 0.3, w * 0.3), (-d * 0.48, -d * 0.3), (0, h * 0.3), b.mat(), "step")
    top = [(-d * 0.4, h * 0.82), (d / 2, h * 0.7), (d / 2, h * 0.76), (-d * 0.4, h * 0.88)]
    b.prism(top, (-w / 2, w / 2), "paint_3a7bc8", part="top")
    b.prism(
        [(-d * 0.4, h * 0.88), (-d * 0.18, h * 0.851), (-d * 0.4, h)], (-w * 0.4, w * 0.4), "rubber_black", part="wedge"
    )
    for side in (-1, 1):
        x = side * w * 0.36
        b.path(
            [(x, d * 0.34, h * 0.5), (x, d * 0.48, h * 0.5), (x, d * 0.48, h * 0.7)], w * 0.03, "metal_chrome", "grips"
        )
    b.rod((-w * 0.36, d * 0.48, h * 0.5), (w * 0.36, d * 0.48, h * 0.5), w * 0.03, "metal_chrome", "grips")
    for span, level in (
        ((-0.1, 0.1), (0.4, 0.43)),
        ((-0.1, 0.1), (0.24, 0.27)),
        ((-0.1, 0.1), (0.08, 0.11)),
        ((-0.1, -0.07), (0.08, 0.43)),
    ):
        b.box(
            (w * span[0], w * span[1]),
            (d * 0.34, d * 0.345),
            (h * level[0], h * level[1]),
            "plastic_black",
            "number",
            solid=False,
        )
        sides = (d * span[0], d * span[1])
        b.box(
            (w * 0.3, w * 0.305),
            (-sides[1], -sides[0]),
            (h * level[0], h * level[1]),
            "plastic_black",
            "number",
            solid=False,
        )


@recipe("kiln")
def kiln(b: Builder) -> None:
    """A potter's kiln: eight-sided, of pale brick in steel hoops, with a raised lid, a control box and peep holes."""
    w, d, h = b.w, b.d, b.h
    legs, top = h * 0.16, h * 0.84
    octagon = [
        (0.5 * math.cos(math.pi / 8 + k * math.pi / 4), 0.5 * math.sin(math.pi / 8 + k * math.pi / 4)) for k in range(8)
    ]
    for x, y in octagon[::2]:
        b.cyl(x * w * 0.84, y * d * 0.84, (0, legs), 0.025, "metal_dark", "legs", n=8)
    for z0, z1, share, color in (
        (legs, top, 0.96, "stone_d9c39a"),
        (legs, legs + h * 0.05, 1.0, b.mat()),
        (h * 0.48, h * 0.53, 1.0, b.mat()),
        (top - h * 0.05, top, 1.0, b.mat()),
        (h * 0.9, h * 0.98, 1.0, b.mat()),
    ):
        b.prism([(x * w * share, y * d * share) for x, y in octagon], (z0, z1), color, "z", "shell")
    b.prism([(x * w * 0.94, y * d * 0.94) for x, y in octagon], (top, h * 0.9), "light_f0702a", "z", "glow")
    b.rod((0, d * 0.4, h * 0.94), (0, d / 2, h * 0.94), 0.02, "wood_oak", "grip")
    b.box((w * 0.4, w / 2), (-d * 0.16, d * 0.16), (h * 0.24, h * 0.74), "metal_dark", "control")
    b.box(
        (w * 0.5 - 0.002, w * 0.5 + 0.002),
        (-d * 0.1, d * 0.1),
        (h * 0.58, h * 0.68),
        "screen_green",
        "control",
        solid=False,
    )
    for z in (0.36, 0.66):
        b.rod((0, d * 0.43, h * z), (0, d * 0.47, h * z), 0.03, "light_f0702a", "peep_holes", 12)
    b.rod((0, -d * 0.4, h * 0.97), (0, -d * 0.4, h), 0.03, "metal_dark", "hinge")


@recipe("dough_mixer")
def dough_mixer(b: Builder) -> None:
    """A column behind with a head over a round steel bowl of dough, a hook that reaches into it, and a switch."""
    w, d, h = b.w, b.d, b.h
    y, rim = d * 0.14, h * 0.58
    b.box((-w * 0.42, w * 0.42), (-d / 2, d * 0.44), (0, h * 0.1), "paint_white", "foot")
    b.cushion((-w * 0.36, w * 0.36), (-d / 2, -d * 0.22), (h * 0.06, h), "paint_white", "column", 0.25)
    b.cushion((-w * 0.34, w * 0.34), (-d / 2, d * 0.36), (h * 0.78, h), "paint_white", "head", 0.4)
    bowl = [
        (0.2, h * 0.14),
        (0.38, h * 0.24),
        (0.48, rim),
        (0.5, rim),
        (0.5, rim + 0.02),
        (0.46, rim + 0.02),
        (0.4, h * 0.34),
    ]
    b.lathe(bowl, b.mat(), (0, y), "bowl", 28, (w, d * 0.72))
    b.ball((0, y, rim - h * 0.06), (w * 0.4, d * 0.28, h * 0.1), "food_f0ddb0", "dough", 14)
    b.cyl(0, y, (h * 0.1, h * 0.16), w * 0.24, "metal_dark", "drive")
    b.path(
        [(0, y, h * 0.8), (0, y, h * 0.7), (w * 0.12, y, h * 0.64), (0, y + d * 0.06, h * 0.54)],
        w * 0.04,
        "metal_chrome",
        "hook",
    )
    b.box((w * 0.32, w * 0.35), (-d * 0.44, -d * 0.28), (h * 0.5, h * 0.66), "plastic_dark", "switch", solid=False)
    b.rod((w * 0.34, -d * 0.36, h * 0.6), (w * 0.37, -d * 0.36, h * 0.6), 0.025, "paint_red", "switch", 10)


@recipe("tyre_changer")
def tyre_changer(b: Builder) -> None:
    """A cabinet with a turntable on which a wheel lies, and a column behind with an arm and a tool down to its rim."""
    w, d, h = b.w, b.d, b.h
    deck = h * 0.5
    b.box((-w * 0.4, w * 0.4), (-d * 0.4, d * 0.4), (h * 0.06, deck - 0.03), b.mat(), "case")
    b.box((-w * 0.42, w * 0.42), (-d * 0.42, d * 0.42), (0, h * 0.06), "metal_dark", "foot")
    b.cyl(0, d * 0.06, (deck - 0.03, deck), w * 0.26, "metal_steel", "turntable", n=24)
    r = min(w, d) * 0.42
    tyre = [
        (r * 0.62, deck),
        (r * 0.94, deck + 0.01),
        (r, deck + 0.05),
        (r, deck + 0.14),
        (r * 0.94, deck + 0.18),
        (r * 0.6, deck + 0.19),
        (r * 0.58, deck + 0.12),
    ]
    b.lathe(tyre, "rubber_black", (0, d * 0.06), "tyre", 28)
    b.cyl(0, d * 0.06, (deck + 0.02, deck + 0.15), r * 0.58, "metal_light", "rim", n=24)
    for k in range(5):
        a = k * 2 * math.pi / 5
        b.cyl(
            r * 0.34 * math.cos(a),
            d * 0.06 + r * 0.34 * math.sin(a),
            (deck + 0.14, deck + 0.152),
            r * 0.12,
            "plastic_dark",
            "rim",
            n=10,
        )
    b.box((-w * 0.07, w * 0.07), (-d / 2, -d * 0.36), (h * 0.06, h), b.mat(), "column")
    b.box((-w * 0.05, w * 0.05), (-d * 0.4, d * 0.12), (h * 0.9, h * 0.97), b.mat(), "arm")
    b.rod((0, d * 0.1, h * 0.92), (0, d * 0.1, deck + 0.2), 0.022, "metal_chrome", "tool")
    b.box((-0.04, 0.04), (d * 0.06, d * 0.16), (deck + 0.17, deck + 0.22), "metal_dark", "tool")
    for k in range(3):
        x = (k - 1) * w * 0.2
        b.box((x - 0.04, x + 0.04), (d * 0.4, d / 2), (h * 0.06, h * 0.09), "metal_dark", "pedals")
    b.box((-w / 2, -w * 0.4), (-d * 0.3, d * 0.3), (h * 0.14, h * 0.2), "paint_yellow", "bead_breaker")
    b.box((w * 0.4, w / 2), (-d * 0.16, d * 0.16), (h * 0.14, h * 0.4), "paint_yellow", "bead_breaker")


@recipe("sandbox")
def sandbox(b: Builder) -> None:
    """A square of boards with seats in its corners, full of sand, with a castle, a bucket and a spade."""
    w, d, h = b.w, b.d, b.h
    t, sand = 0.05, h * 0.45
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, d / 2 - t), (0, sand), "food_e2c98a", "sand")
    for side in (-1, 1):
        x, y = sorted((side * w / 2, side * (w / 2 - t))), sorted((side * d / 2, side * (d / 2 - t)))
        b.box((x[0], x[1]), (-d / 2, d / 2), (0, h * 0.65), b.mat(), "boards")
        b.box((-w / 2, w / 2), (y[0], y[1]), (0, h * 0.65), b.mat(), "boards")
        for other in (-1, 1):
            corner = [(side * w / 2, other * d / 2), (side * w * 0.28, other * d / 2), (side * w / 2, other * d * 0.28)]
            b.prism(corner, (h * 0.62, h * 0.7), b.mat(), "z", "seats")
    for k, (u, v) in enumerate(((-0.16, -0.1), (0.04, -0.1), (-0.16, 0.1), (0.04, 0.1), (-0.06, 0.0))):
        high = h if k == 4 else h * 0.85
        b.cyl(w * u, d * v, (sand, high), w * 0.055, "food_d3b36a", "castle", w * 0.04, n=12)
    b.box((-w * 0.16, w * 0.04), (-d * 0.1, d * 0.1), (sand, h * 0.66), "food_d3b36a", "castle")
    b.lathe(
        [(0.06, sand), (0.09, sand + h * 0.4), (0.08, sand + h * 0.4), (0.05, sand + h * 0.1)],
        "plastic_red",
        (w * 0.24, d * 0.1),
        "bucket",
        16,
        (w, w),
    )
    b.rod((w * 0.1, d * 0.3, sand + 0.015), (w * 0.26, d * 0.26, sand + 0.015), 0.014, "wood_oak", "spade")
    b.box((w * 0.02, w * 0.11), (d * 0.26, d * 0.34), (sand, sand + 0.015), "plastic_3a7bc8", "spade")
