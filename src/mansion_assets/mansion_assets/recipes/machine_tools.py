"""Machines of workshops: mills, saws, drills, cutters, welders, robot arms."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
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


@recipe("drill_press")
def drill_press(b: Builder) -> None:
    """Base, column, table and head with a wheel."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.07), b.mat(), "base")
    b.cyl(0, -d * 0.28, (0.07, h * 0.95), 0.05, "metal_steel", "column")
    b.box((-w * 0.4, w * 0.4), (-d * 0.2, d * 0.4), (h * 0.42, h * 0.45), "metal_grey", "table")
    b.box((-w * 0.3, w * 0.3), (-d / 2, d * 0.4), (h * 0.74, h), b.mat(), "head")
    b.cyl(0, d * 0.18, (h * 0.56, h * 0.74), 0.02, "metal_steel", "bit", n=10)
    for k in range(3):
        a = k * 2.094
        b.rod(
            (w * 0.3, d * 0.1, h * 0.82),
            (w * 0.36, d * 0.1 + 0.16 * math.cos(a), h * 0.82 + 0.16 * math.sin(a)),
            0.01,
            "metal_steel",
            "wheel",
        )


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


@recipe("table_saw")
def table_saw(b: Builder) -> None:
    """Table with a blade, fence and cabinet."""
    w, d, h = b.w, b.d, b.h
    z = h - 0.12
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - 0.05, z), b.mat(), "table")
    b.box((-w * 0.3, w * 0.3), (-d * 0.35, d * 0.35), (0.0, z - 0.05), "metal_dark", "cabinet")
    b.rod((-0.002, 0, z), (0.002, 0, z), 0.12, "metal_steel", "blade", 28)
    b.box((w * 0.22, w * 0.27), (-d / 2, d / 2), (z, z + 0.06), "metal_blue", "fence", solid=False)
    b.rod((-w * 0.1, d * 0.35, 0.4), (-w * 0.1, d * 0.42, 0.4), 0.07, "plastic_black", "wheel", 16)


@recipe("laser_cutter")
def laser_cutter(b: Builder) -> None:
    """A cabinet whose glass lid shows a bed of honeycomb, a gantry with its head, and a red beam on a cut board."""
    w, d, h = b.w, b.d, b.h
    bed, rim = h * 0.66, 0.06
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.08, bed), b.mat(), "case")
    b.wheels(h * 0.04, 0.1)
    glass = w * 0.24
    _cutter_walls(b, glass, bed, rim)
    _cutter_bed(b, glass, bed, rim)
    _cutter_lid(b, glass, rim)
    _cutter_panel(b, glass)
    _cutter_front(b)


def _cutter_walls(b: Builder, glass: float, bed: float, rim: float) -> None:
    """Low walls round the bed, and the head beside it."""
    w, d, h = b.w, b.d, b.h
    b.box((glass, w / 2), (-d / 2, d / 2), (bed, h * 0.86), b.mat(), "head")
    for across in ((-w / 2, -w / 2 + rim), (glass - rim, glass)):
        b.box(across, (-d / 2, d / 2), (bed, h * 0.8), b.mat(), "walls")
    for along in ((-d / 2, -d / 2 + rim), (d / 2 - rim, d / 2)):
        b.box((-w / 2, glass), along, (bed, h * 0.8), b.mat(), "walls")


def _cutter_bed(b: Builder, glass: float, bed: float, rim: float) -> None:
    """A bed of honeycomb, a board with a cut triangle, and the gantry with its head and beam."""
    w, d, h = b.w, b.d, b.h
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


def _cutter_lid(b: Builder, glass: float, rim: float) -> None:
    """A lid of glass in a dark frame."""
    w, d, h = b.w, b.d, b.h
    with b.door((-w / 2, glass), (-d / 2, d / 2), (h * 0.8, h * 0.86), "back"):
        b.box((-w / 2 + rim, glass - rim), (-d / 2 + rim, d / 2 - rim), (h * 0.82, h * 0.83), "glass_clear", "lid")
        for across in ((-w / 2, -w / 2 + rim), (glass - rim, glass)):
            b.box(across, (-d / 2, d / 2), (h * 0.8, h * 0.86), "metal_dark", "lid")
        for along in ((-d / 2, -d / 2 + rim), (d / 2 - rim, d / 2)):
            b.box((-w / 2, glass), along, (h * 0.8, h * 0.86), "metal_dark", "lid")


def _cutter_panel(b: Builder, glass: float) -> None:
    """A sloped panel with a screen."""
    w, d, h = b.w, b.d, b.h
    b.prism(
        [(-d * 0.2, h * 0.86), (d * 0.3, h * 0.86), (-d * 0.2, h)],
        (glass + 0.03, w / 2 - 0.03),
        "plastic_dark",
        part="controls",
    )
    slope = DrawnFace.sloped(b, (d * 0.3, h * 0.86), (-d * 0.2, h))
    slope.field((-w * 0.46, -glass - w * 0.04), (d * 0.12, d * 0.44), "screen_blue", "controls", 0.004)


def _cutter_front(b: Builder) -> None:
    """The word LASER, a stop button and a warning sign."""
    w, d, h = b.w, b.d, b.h
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


@recipe("printer_3d")
def printer_3d(b: Builder) -> None:
    """Frame with bed, gantry and a print."""
    w, d, h = b.w, b.d, b.h
    b.legs((0, h), 0.015, b.mat(), 0.0)
    for z in (0.015, h - 0.015):
        b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.03), (z - 0.015, z + 0.015), b.mat(), "frame")
        b.box((-w / 2, w / 2), (d / 2 - 0.03, d / 2), (z - 0.015, z + 0.015), b.mat(), "frame")
    b.box((-w * 0.4, w * 0.4), (-d * 0.4, d * 0.4), (h * 0.1, h * 0.13), "glass_black", "bed")
    b.box((-w / 2, w / 2), (-0.02, 0.02), (h * 0.6, h * 0.65), "metal_steel", "gantry")
    b.box((-0.04, 0.04), (-0.02, 0.06), (h * 0.5, h * 0.68), "plastic_orange", "head", solid=False)
    b.lathe([(0.06, h * 0.13), (0.09, h * 0.3), (0.04, h * 0.42)], "plastic_orange", part="print", n=12, solid=False)


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
