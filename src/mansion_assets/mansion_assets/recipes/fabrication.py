"""Machines by which workshops and print rooms make things, lift and press them."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("printing_press")
def printing_press(b: Builder) -> None:
    """Rollers with the four inks between two cheeks, a printed sheet that leaves them, and piles of paper."""
    w, d, h = b.w, b.d, b.h
    for side in (-1, 1):
        along = sorted((side * d / 2, side * d * 0.4))
        cheek = [
            (-w * 0.24, 0),
            (w * 0.24, 0),
            (w * 0.24, h * 0.75),
            (w * 0.14, h),
            (-w * 0.14, h),
            (-w * 0.24, h * 0.75),
        ]
        b.prism(cheek, (along[0], along[1]) if side < 0 else (d * 0.4, d * 0.42), b.mat(), "y", "cheeks")
    reach = (-d * 0.4, d * 0.47)
    inks = ("plastic_22a6d6", "plastic_d6258c", "plastic_yellow", "plastic_black")
    for k, color in enumerate(inks):
        a = math.pi * (0.12 + 0.25 * k)
        x, z = math.cos(a) * w * 0.16, h * 0.56 + math.sin(a) * h * 0.26
        b.rod((x, reach[0], z), (x, reach[1], z), h * 0.085, color, "inks", 18, solid=True)
        b.rod((x, reach[1], z), (x, d / 2, z), h * 0.03, "metal_steel", "axles", 10)
    for x, z, r in ((0.0, h * 0.52, h * 0.17), (0.0, h * 0.2, h * 0.14)):
        b.rod((x, reach[0], z), (x, reach[1], z), r, "metal_chrome", "cylinders", 24, solid=True)
        b.rod((x, reach[1], z), (x, d / 2, z), h * 0.04, "metal_dark", "axles", 12)
    for side in (-1, 1):
        across = sorted((side * w / 2, side * w * 0.27))
        b.box((across[0], across[1]), (-d * 0.4, d * 0.42), (0, h * 0.12), "metal_dark", "feeders")
        b.box((across[0] + 0.03, across[1] - 0.03), (-d * 0.34, d * 0.36), (h * 0.12, h * 0.34), "paper_white", "piles")
        b.box((across[0], across[1]), (-d * 0.42, -d * 0.4), (0, h * 0.5), b.mat(), "feeders")
    top = DrawnFace.top(b, h * 0.34)
    for k, color in enumerate(inks):
        u = w * (-0.45 + 0.035 * k)
        top.field((u, u + w * 0.03), (-d * 0.3, d * 0.26), color, "print", 0.004)
    sheet = [(w * 0.08, h * 0.36), (w * 0.3, h * 0.46), (w * 0.3, h * 0.465), (w * 0.08, h * 0.365)]
    b.prism(sheet, (-d * 0.34, d * 0.36), "paper_white", "y", "sheet")
    for k, color in enumerate(inks):
        x = w * (0.11 + 0.045 * k)
        z = h * (0.367 + (x / w - 0.08) / 0.22 * 0.1)
        line = [(x, z), (x + w * 0.03, z + h * 0.0136), (x + w * 0.03, z + h * 0.018), (x, z + h * 0.0044)]
        b.prism(line, (-d * 0.28, d * 0.3), color, "y", "print")
    b.box((-w * 0.23, -w * 0.1), (d * 0.42, d / 2), (h * 0.6, h * 0.78), "plastic_dark", "controls")
    DrawnFace.front(b, d / 2).field((w * 0.115, w * 0.215), (h * 0.66, h * 0.76), "screen_green", "controls", 0.003)


@recipe("welding_machine")
def welding_machine(b: Builder) -> None:
    """A wheeled power source with dials, a gas cylinder behind it, a torch on its hose and a helmet on top."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.56
    b.box((-w * 0.42, w * 0.42), (-d * 0.2, d * 0.44), (0.1, top), b.mat(), "case")
    b.box((-w * 0.46, w * 0.46), (-d / 2, d * 0.46), (0.08, 0.12), "metal_dark", "frame")
    for side in (-1, 1):
        b.rod((side * w * 0.42, -d * 0.36, 0.11), (side * w / 2, -d * 0.36, 0.11), 0.11, "rubber_black", "wheels", 18)
        b.rod(
            (side * w * 0.3, d * 0.38, 0.045), (side * w * 0.38, d * 0.38, 0.045), 0.045, "rubber_black", "wheels", 12
        )
    r = min(w * 0.18, d * 0.12)
    b.lathe(
        [(r, 0.12), (r, h * 0.8), (r * 0.4, h * 0.9), (r * 0.4, h)],
        "paint_green",
        (-w * 0.05, -d * 0.36),
        "cylinder",
        16,
    )
    face = DrawnFace.front(b, d * 0.44)
    face.field((-w * 0.38, w * 0.38), (top * 0.56, top * 0.95), "plastic_black", "panel", 0.006)
    face.field((-w * 0.3, w * 0.06), (top * 0.76, top * 0.9), "screen_green", "panel", 0.01)
    for u in (-0.2, 0.02):
        face.disc(w * u, top * 0.65, w * 0.06, "metal_light", "dials", 0.03)
    face.disc(w * 0.24, top * 0.75, w * 0.08, "plastic_red", "switch", 0.02)
    for u, color in ((-0.2, "metal_brass"), (0.2, "metal_brass")):
        face.disc(w * u, top * 0.38, w * 0.07, "plastic_black", "plugs", 0.02)
        face.disc(w * u, top * 0.38, w * 0.04, color, "plugs", 0.05)
    hose = [(w * 0.2, d * 0.46, top * 0.38), (w * 0.34, d * 0.48, top * 0.12), (w * 0.46, d * 0.4, top * 0.2)]
    b.path([*hose, (w * 0.46, d * 0.2, top * 0.75), (w * 0.44, d * 0.1, top * 0.95)], 0.016, "rubber_black", "hose")
    b.path([(w * 0.44, d * 0.12, top * 0.9), (w * 0.44, d * 0.3, top * 1.06)], 0.026, "plastic_yellow", "torch")
    b.path([(w * 0.44, d * 0.3, top * 1.06), (w * 0.44, d * 0.42, top * 0.98)], 0.016, "metal_copper", "torch")
    _helmet(b, top)


def _helmet(b: Builder, z: float) -> None:
    """A dark welder's helmet with a green window, that stands at height `z`."""
    w, d, h = b.w, b.d, b.h
    tall = h * 0.3
    b.cushion((-w * 0.3, w * 0.3), (-d * 0.14, d * 0.24), (z, z + tall), "plastic_dark", "helmet", 0.7, 16)
    y = d * 0.24
    b.box((-w * 0.19, w * 0.19), (y - 0.05, y + 0.006), (z + tall * 0.5, z + tall * 0.82), "plastic_black", "helmet")
    face = DrawnFace.front(b, y + 0.006)
    face.field((-w * 0.15, w * 0.15), (z + tall * 0.57, z + tall * 0.76), "light_2e8f4f", "window", 0.003)


@recipe("laser_cutter")
def laser_cutter(b: Builder) -> None:
    """A cabinet whose glass lid shows a bed of honeycomb, a gantry with its head, and a red beam on a cut board."""
    w, d, h = b.w, b.d, b.h
    bed, rim = h * 0.66, 0.06
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.08, bed), b.mat(), "case")
    b.wheels(h * 0.04, 0.1)
    glass = w * 0.24
    b.box((glass, w / 2), (-d / 2, d / 2), (bed, h * 0.86), b.mat(), "head")
    for across in ((-w / 2, -w / 2 + rim), (glass - rim, glass)):
        b.box(across, (-d / 2, d / 2), (bed, h * 0.8), b.mat(), "walls")
    for along in ((-d / 2, -d / 2 + rim), (d / 2 - rim, d / 2)):
        b.box((-w / 2, glass), along, (bed, h * 0.8), b.mat(), "walls")
    middle = (glass - w / 2) / 2
    b.box((-w / 2 + rim, glass - rim), (-d / 2 + rim, d / 2 - rim), (bed, bed + 0.01), "plastic_black", "bed")
    for k in range(14):
        x = -w / 2 + rim + (glass + w / 2 - 2 * rim) * (k + 0.5) / 14
        b.box(
            (x - 0.004, x + 0.004),
            (-d / 2 + rim, d / 2 - rim),
            (bed + 0.01, bed + 0.016),
            "metal_grey",
            "bed",
            solid=False,
        )
    b.box((middle - w * 0.22, middle + w * 0.2), (-d * 0.3, d * 0.28), (bed + 0.016, bed + 0.03), "wood_birch", "board")
    board = DrawnFace.top(b, bed + 0.03)
    board.line(
        [
            (-middle - w * 0.12, -d * 0.1),
            (-middle, d * 0.18),
            (-middle + w * 0.12, -d * 0.1),
            (-middle - w * 0.12, -d * 0.1),
        ],
        0.008,
        "plastic_black",
        "cut",
        0.004,
    )
    b.box((-w / 2 + rim, glass - rim), (-0.04, 0.04), (bed + 0.1, h * 0.78), "metal_chrome", "gantry")
    b.box((middle - 0.06, middle + 0.06), (-0.05, 0.1), (bed + 0.06, h * 0.82), "plastic_red", "laser")
    b.rod((middle, 0.08, bed + 0.03), (middle, 0.08, bed + 0.1), 0.008, "light_red", "beam", 6)
    with b.door((-w / 2, glass), (-d / 2, d / 2), (h * 0.8, h * 0.86), "back"):
        b.box((-w / 2 + rim, glass - rim), (-d / 2 + rim, d / 2 - rim), (h * 0.82, h * 0.83), "glass_clear", "lid")
        for across in ((-w / 2, -w / 2 + rim), (glass - rim, glass)):
            b.box(across, (-d / 2, d / 2), (h * 0.8, h * 0.86), "metal_dark", "lid")
        for along in ((-d / 2, -d / 2 + rim), (d / 2 - rim, d / 2)):
            b.box((-w / 2, glass), along, (h * 0.8, h * 0.86), "metal_dark", "lid")
    b.prism(
        [(-d * 0.2, h * 0.86), (d * 0.3, h * 0.86), (-d * 0.2, h)],
        (glass + 0.03, w / 2 - 0.03),
        "plastic_dark",
        part="controls",
    )
    slope = DrawnFace.sloped(b, (d * 0.3, h * 0.86), (-d * 0.2, h))
    slope.field((-w * 0.46, -glass - w * 0.04), (d * 0.12, d * 0.44), "screen_blue", "controls", 0.004)
    face = DrawnFace.front(b, d / 2)
    face.write("LASER", (-w * 0.2, w * 0.4), (h * 0.28, h * 0.52), "plastic_white", "letters", 0.004)
    face.disc(-w * 0.37, h * 0.74, 0.05, "plastic_yellow", "stop", 0.01)
    face.disc(-w * 0.37, h * 0.74, 0.035, "paint_red", "stop", 0.04)
    b.prism(
        [(-w * 0.42, h * 0.26), (-w * 0.28, h * 0.26), (-w * 0.35, h * 0.26 + w * 0.12)],
        (d / 2, d / 2 + 0.004),
        "paint_yellow",
        "y",
        "warning",
    )
    face.field((w * 0.345, w * 0.355), (h * 0.26 + w * 0.03, h * 0.26 + w * 0.085), "plastic_black", "warning", 0.007)


@recipe("ironing_press")
def ironing_press(b: Builder) -> None:
    """A padded buck like an ironing board on a cabinet, a heated head lifted over it, pedals."""
    w, d, h = b.w, b.d, b.h
    b.box((-w * 0.26, w * 0.2), (-d * 0.36, d * 0.2), (0.04, h * 0.5), "metal_light", "cabinet")
    b.box((-w * 0.3, w * 0.24), (-d * 0.4, d * 0.46), (0, 0.04), "metal_dark", "base")
    for k in range(2):
        x = -w * 0.14 + k * w * 0.16
        b.box((x, x + w * 0.1), (d * 0.24, d * 0.46), (0.04, 0.08), "rubber_black", "pedals")
    buck = [
        (w / 2, 0.0),
        (w * 0.42, d * 0.16),
        (w * 0.1, d * 0.34),
        (-w * 0.44, d * 0.34),
        (-w / 2, d * 0.2),
        (-w / 2, -d * 0.14),
        (-w * 0.44, -d * 0.22),
        (w * 0.1, -d * 0.22),
        (w * 0.42, -d * 0.12),
    ]
    b.prism(buck, (h * 0.5, h * 0.54), "metal_dark", "z", "buck")
    b.prism([(x * 0.98, y * 0.96) for x, y in buck], (h * 0.54, h * 0.6), "fabric_e8e2d2", "z", "pad")
    b.prism(
        [(-w * 0.3, d * 0.3), (-w * 0.3, -d * 0.18), (w * 0.2, -d * 0.14), (w * 0.24, d * 0.22)][::-1],
        (h * 0.6, h * 0.612),
        "fabric_4f86c6",
        "z",
        "shirt",
    )
    b.box((-w * 0.28, -w * 0.1), (d * 0.05, d * 0.2), (h * 0.61, h * 0.625), "fabric_white", "shirt", solid=False)
    for x in (-w * 0.18, w * 0.12):
        b.path([(x, -d * 0.3, h * 0.5), (x, -d * 0.44, h * 0.7), (x, -d * 0.3, h * 0.92)], 0.03, "metal_dark", "arms")
    rise = 0.34
    head = [
        (-d * 0.34, h * 0.76),
        (d * 0.26, h * (0.76 + rise * 0.42)),
        (d * 0.22, h * (0.86 + rise * 0.4)),
        (-d * 0.38, h * 0.86),
    ]
    b.prism(head, (-w * 0.44, w * 0.4), "metal_steel", part="head")
    b.path(
        [
            (-w * 0.3, d * 0.26, h * 0.93),
            (-w * 0.3, d * 0.42, h * 0.93),
            (w * 0.26, d * 0.42, h * 0.93),
            (w * 0.26, d * 0.26, h * 0.93),
        ],
        0.018,
        "plastic_black",
        "handle",
    )
    for k in range(5):
        x = w * (-0.3 + 0.13 * k)
        b.ball((x, d * 0.02, h * (0.7 + 0.02 * (k % 2))), (w * 0.04, d * 0.08, h * 0.028), "glass_white", "steam", 8)
    face = DrawnFace.front(b, d * 0.2)
    face.disc(w * 0.14, h * 0.38, w * 0.05, "plastic_white", "gauge", 0.02)
    face.line([(w * 0.14, h * 0.38), (w * 0.16, h * 0.41)], 0.005, "paint_red", "gauge", 0.022)
    face.write("STEAM", (-w * 0.16, w * 0.08), (h * 0.32, h * 0.44), "paint_red", "letters", 0.004)


@recipe("gantry_crane")
def gantry_crane(b: Builder) -> None:
    """Two A-shaped legs on wheels, a girder with flanges, and a hoist on it whose chain holds a hook."""
    w, d, h = b.w, b.d, b.h
    girder = h * 0.88
    for side in (-1, 1):
        x = side * w * 0.44
        for foot in (-1, 1):
            b.rod((x, foot * d * 0.44, 0.16), (x, foot * 0.06, girder), 0.06, b.mat(), "legs", 10, solid=True)
            b.rod(
                (x - 0.05, foot * d * 0.44, 0.08), (x + 0.05, foot * d * 0.44, 0.08), 0.08, "rubber_black", "wheels", 14
            )
        b.rod((x, -d * 0.46, 0.18), (x, d * 0.46, 0.18), 0.05, b.mat(), "legs", 10, solid=True)
        b.rod((x, -d * 0.2, h * 0.5), (x, d * 0.2, h * 0.5), 0.04, b.mat(), "legs", 8)
    for up in ((girder, girder + 0.03), (h - 0.03, h)):
        b.box((-w / 2, w / 2), (-0.12, 0.12), up, b.mat(), "girder")
    b.box((-w / 2, w / 2), (-0.03, 0.03), (girder, h), b.mat(), "girder")
    face = DrawnFace.front(b, 0.03)
    face.write("2000 KG", (-w * 0.16, w * 0.16), (girder + 0.05, h - 0.05), "plastic_black", "letters", 0.006)
    b.box((-0.26, 0.26), (-0.16, 0.16), (girder - 0.1, girder), "metal_dark", "trolley")
    b.rod((-0.28, 0, girder - 0.24), (0.28, 0, girder - 0.24), 0.17, "paint_red", "hoist", 18, solid=True)
    for x in (-0.05, 0.05):
        b.rod((x, 0, h * 0.42), (x, 0, girder - 0.3), 0.022, "metal_steel", "chain", 6)
    b.box((-0.12, 0.12), (-0.08, 0.08), (h * 0.36, h * 0.43), "paint_red", "block")
    hook = [(math.sin(a) * 0.14, 0.0, h * 0.24 + math.cos(a) * 0.14) for a in (-0.2 + k * 0.5 for k in range(10))]
    b.path([(0.0, 0.0, h * 0.36), (-0.02, 0.0, h * 0.31), *hook], 0.04, "metal_dark", "hook")
    b.path([(0.2, 0.12, girder - 0.3), (0.34, 0.2, h * 0.5)], 0.012, "rubber_black", "pendant")
    b.box((0.29, 0.39), (0.16, 0.24), (h * 0.38, h * 0.52), "plastic_yellow", "pendant")


@recipe("car_lift")
def car_lift(b: Builder) -> None:
    """Two posts on foot plates with a beam overhead; four arms with pads reach from their carriages, at half height."""
    w, d, h = b.w, b.d, b.h
    level = h * 0.4
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - 0.26)))
        b.box((across[0], across[1]), (-0.16, 0.16), (0, h - 0.1), b.mat(), "posts")
        b.box((across[0] - 0.02, across[1] + 0.02), (-d * 0.46, d * 0.46), (0, 0.03), "metal_dark", "plates")
        inner = side * (w / 2 - 0.26)
        b.box(
            (min(inner, inner - side * 0.1), max(inner, inner - side * 0.1)),
            (-0.2, 0.2),
            (level - 0.1, level + 0.6),
            "metal_dark",
            "carriages",
        )
        for end in (-1, 1):
            tip = (inner - side * w * 0.26, end * d * 0.42, level)
            b.rod((inner - side * 0.05, end * 0.14, level), tip, 0.07, "paint_yellow", "arms", 6, solid=True)
            b.cyl(tip[0], tip[1], (level, level + 0.14), 0.1, "rubber_black", "pads", n=14)
    b.box((-w / 2, w / 2), (-0.1, 0.1), (h - 0.12, h), b.mat(), "beam")
    x = w / 2 - 0.13
    b.box((x - 0.15, x + 0.11), (0.16, 0.34), (h * 0.5, h * 0.66), "plastic_light", "controls")
    face = DrawnFace.front(b, 0.34)
    face.disc(-x + 0.06, h * 0.58, 0.05, "paint_red", "controls", 0.02)
    face.disc(-x - 0.07, h * 0.58, 0.05, "plastic_green", "controls", 0.02)
    for side in (-1, 1):
        u = side * (w / 2 - 0.13)
        DrawnFace.front(b, 0.16).write(
            "LIFT", (u - 0.11, u + 0.11), (h * 0.78, h * 0.84), "plastic_white", "letters", 0.005
        )


@recipe("repair_stand")
def repair_stand(b: Builder) -> None:
    """A tripod whose clamp holds up a bicycle's frame: the diamond of tubes, saddle, fork, cranks, chain wheel."""
    w, d, h = b.w, b.d, b.h
    for k in range(3):
        a = math.pi / 2 + k * math.tau / 3
        b.rod(
            (0, 0, 0.24), (math.cos(a) * w * 0.44, math.sin(a) * d * 0.48, 0.02), 0.022, b.mat(), "legs", 8, solid=True
        )
    b.rod((0, 0, 0.1), (0, 0, h * 0.7), 0.028, b.mat(), "post", 10, solid=True)
    b.box((-0.04, 0.04), (-0.04, 0.1), (h * 0.66, h * 0.74), "plastic_black", "clamp")
    y, s = 0.07, w
    seat, bottom, head, rear = (0.12 * s, h * 0.86), (0.06 * s, h * 0.5), (-0.24 * s, h * 0.82), (0.4 * s, h * 0.52)
    for start, end in ((seat, bottom), (seat, head), (bottom, head), (bottom, rear), (seat, rear)):
        b.rod((start[0], y, start[1]), (end[0], y, end[1]), 0.022, "paint_red", "bicycle", 8)
    b.path(
        [(head[0], y, head[1] + 0.06), (-0.3 * s, y, h * 0.62), (-0.38 * s, y, h * 0.5)], 0.02, "metal_black", "fork"
    )
    b.path([(head[0], y, head[1]), (-0.2 * s, y, h * 0.96), (-0.34 * s, y, h * 0.98)], 0.018, "metal_black", "bar")
    b.rod((-0.34 * s, y - 0.16, h * 0.98), (-0.34 * s, y + 0.18, h * 0.98), 0.02, "rubber_black", "bar", 8)
    b.rod((seat[0], y, seat[1]), (seat[0] + 0.02, y, h * 0.95), 0.014, "metal_steel", "saddle", 8)
    b.cushion((seat[0] - 0.1, seat[0] + 0.16), (y - 0.07, y + 0.07), (h * 0.94, h), "leather_black", "saddle", 0.8)
    b.rod((bottom[0], y, bottom[1]), (bottom[0], y + 0.03, bottom[1]), 0.09, "metal_steel", "chain_wheel", 18)
    b.path(
        [(bottom[0], y + 0.05, bottom[1]), (bottom[0] - 0.1, y + 0.05, bottom[1] - 0.12)], 0.014, "metal_black", "crank"
    )
    b.box(
        (bottom[0] - 0.16, bottom[0] - 0.06),
        (y + 0.04, y + 0.14),
        (bottom[1] - 0.15, bottom[1] - 0.11),
        "plastic_black",
        "pedal",
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
