"""Devices on walls and in ceilings by which people do something: hand dryers, intercoms, air vents."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("hand_dryer")
def hand_dryer(b: Builder) -> None:
    """A rounded case with a round steel button and a sign of warm air on it, and a spout that points down."""
    w, d, h = b.w, b.d, b.h
    low, front = h * 0.2, d * 0.32
    b.cushion((-w / 2, w / 2), (-d / 2, front), (low, h), b.mat(), "case", 0.4, 14)
    b.rod((0, d * 0.02, h * 0.42), (0, d * 0.16, 0), d * 0.17, "metal_chrome", "spout", 18, solid=True)
    b.rod((0, d * 0.16, 0), (0, d * 0.157, h * 0.012), d * 0.13, "plastic_black", "spout", 18)
    b.rod((0, front - 0.004, h * 0.78), (0, d / 2, h * 0.78), w * 0.15, "metal_chrome", "button", 20)
    b.rod((0, d * 0.48, h * 0.78), (0, d / 2 + 0.001, h * 0.78), w * 0.1, "metal_light", "button", 20)
    for k in range(3):
        x = (k - 1) * w * 0.16
        line = [
            (x, front + 0.001, h * 0.56),
            (x - w * 0.05, front + 0.001, h * 0.5),
            (x + w * 0.05, front + 0.001, h * 0.44),
            (x, front + 0.001, h * 0.36),
        ]
        b.path(line, w * 0.018, "paint_red", "sign")


@recipe("intercom")
def intercom(b: Builder) -> None:
    """A door telephone: a handset on its rest with a curled cord, beside a small screen and call buttons."""
    w, d, h = b.w, b.d, b.h
    back, face = -d / 2, d * 0.05
    b.cushion((-w / 2, w / 2), (back, face), (h * 0.06, h), b.mat(), "case", 0.3)
    b.box((w * 0.0, w * 0.42), (face - 0.002, face + 0.001), (h * 0.56, h * 0.88), "screen_dark", "screen", solid=False)
    for k in range(6):
        z = h * (0.44 - 0.1 * (k // 2))
        x = w * (0.1 + 0.2 * (k % 2))
        b.rod(
            (x, face - 0.002, z),
            (x, face + 0.004, z),
            w * 0.055,
            ("plastic_green", "plastic_red")[k % 2] if k < 2 else "plastic_grey",
            "buttons",
            10,
        )
    x = -w * 0.26
    b.cushion((x - w * 0.09, x + w * 0.09), (d * 0.12, d * 0.34), (h * 0.26, h * 0.86), "plastic_dark", "handset", 0.7)
    for end in ((h * 0.74, h * 0.96), (h * 0.16, h * 0.38)):
        b.cushion((x - w * 0.14, x + w * 0.14), (face - 0.002, d / 2), end, "plastic_dark", "handset", 0.6)
    coil = [
        (x + w * 0.06 * math.sin(k * 1.57), d * 0.2 + d * 0.08 * math.cos(k * 1.57), h * (0.2 - 0.2 * k / 16))
        for k in range(17)
    ]
    b.path(coil, w * 0.016, "plastic_black", "cord")


@recipe("air_vent")
def air_vent(b: Builder) -> None:
    """A square outlet: a frame, and rings of vanes within it, which lean outwards, over a dark duct."""
    w, d, h = b.w, b.d, b.h
    b.box((-w * 0.4, w * 0.4), (-d * 0.4, d * 0.4), (h * 0.4, h * 0.6), "plastic_black", "duct")
    for k in range(4):
        outer = 0.5 - 0.11 * k
        inner = outer - (0.07 if k == 0 else 0.045)
        for side in (-1, 1):
            across = sorted((side * w * outer, side * w * inner))
            along = sorted((side * d * outer, side * d * inner))
            b.box((across[0], across[1]), (-d * outer, d * outer), (0, h), b.mat(), "vanes")
            b.box((-w * outer, w * outer), (along[0], along[1]), (0, h), b.mat(), "vanes")
    b.box((-w * 0.06, w * 0.06), (-d * 0.06, d * 0.06), (0, h), b.mat(), "middle")


@recipe("light_switch")
def light_switch(b: Builder) -> None:
    """A plate with two screws and a rocker that is tilted, a red lamp in its upper end."""
    w, d, h = b.w, b.d, b.h
    plate = -d * 0.1
    b.cushion((-w / 2, w / 2), (-d / 2, plate), (0, h), b.mat(), "plate", 0.3)
    b.box(
        (-w * 0.26, w * 0.26),
        (plate - 0.001, plate + 0.001),
        (h * 0.22, h * 0.78),
        "plastic_dark",
        "recess",
        solid=False,
    )
    rocker = [
        (plate, h * 0.26),
        (d / 2, h * 0.26),
        (plate + d * 0.2, h * 0.5),
        (plate + d * 0.12, h * 0.74),
        (plate, h * 0.74),
    ]
    b.prism(rocker, (-w * 0.22, w * 0.22), "plastic_white", part="rocker")
    b.box(
        (-w * 0.06, w * 0.06),
        (plate + d * 0.12, plate + d * 0.2),
        (h * 0.64, h * 0.68),
        "light_red",
        "lamp",
        solid=False,
    )
    for z in (0.1, 0.9):
        b.rod((0, plate - 0.001, h * z), (0, plate + 0.0015, h * z), w * 0.05, "metal_steel", "screws", 12)


@recipe("wall_socket")
def wall_socket(b: Builder) -> None:
    """A plate with a round well that has two holes and earth clips, and a plug with its cable below it."""
    w, d, h = b.w, b.d, b.h
    plate = d * 0.2
    b.cushion((-w / 2, w / 2), (-d / 2, plate), (0, h), b.mat(), "plate", 0.3)
    r, z = min(w, h) * 0.36, h / 2
    b.rod((0, plate - 0.001, z), (0, d * 0.46, z), r * 1.1, b.mat(), "ring", 24)
    b.rod((0, d * 0.44, z), (0, d * 0.48, z), r * 0.96, "plastic_light", "well", 24)
    for side in (-1, 1):
        b.rod((side * r * 0.45, d * 0.46, z), (side * r * 0.45, d / 2, z), r * 0.17, "plastic_black", "holes", 14)
        clip = sorted((z + side * r * 0.9, z + side * r * 0.66))
        b.box((-r * 0.14, r * 0.14), (d * 0.44, d / 2), (clip[0], clip[1]), "metal_brass", "clips", solid=False)


@recipe("thermostat")
def thermostat(b: Builder) -> None:
    """A round dial on a square plate: a ring of marks from blue to red about a dark face with the figure 21."""
    w, d, h = b.w, b.d, b.h
    plate, r, z = -d * 0.2, min(w, h) * 0.45, h / 2
    b.cushion((-w / 2, w / 2), (-d / 2, plate), (0, h), b.mat(), "plate", 0.3)
    b.rod((0, plate - 0.001, z), (0, d * 0.42, z), r, "metal_chrome", "dial", 32)
    b.rod((0, d * 0.4, z), (0, d * 0.46, z), r * 0.9, "plastic_black", "face", 32)
    for k in range(15):
        a = math.radians(-40 + 260 * k / 14)
        start, end = ((math.cos(a) * r * s, d * 0.46, z + math.sin(a) * r * s) for s in (0.68, 0.84))
        b.rod(start, end, r * 0.035, "light_4f9bf0" if k > 9 else "light_red" if k < 5 else "light_white", "marks", 4)
    y = (d * 0.46, d / 2)
    x, s = r * 0.24, r * 0.2
    for level in (0.0, 1.0, 2.0):
        b.box(
            (x - s * 0.7, x + s * 0.7),
            y,
            (z + (level - 1) * s * 1.4 - s * 0.14, z + (level - 1) * s * 1.4 + s * 0.14),
            "light_white",
            "figure",
            solid=False,
        )
    b.box((x - s * 0.7, x - s * 0.42), y, (z, z + s * 1.4), "light_white", "figure", solid=False)
    b.box((x + s * 0.42, x + s * 0.7), y, (z - s * 1.4, z), "light_white", "figure", solid=False)
    b.box((-x - s * 0.14, -x + s * 0.14), y, (z - s * 1.5, z + s * 1.5), "light_white", "figure", solid=False)


@recipe("fire_alarm")
def fire_alarm(b: Builder) -> None:
    """A red call point: a white pane to press, with a black disc between two arrows, under the sign of a flame."""
    w, d, h = b.w, b.d, b.h
    body = d * 0.3
    b.cushion((-w / 2, w / 2), (-d / 2, body), (0, h), b.mat(), "case", 0.15)
    b.box((-w * 0.36, w * 0.36), (body - 0.001, d * 0.42), (h * 0.14, h * 0.66), "plastic_white", "pane", solid=False)
    z = h * 0.4
    b.rod((0, d * 0.4, z), (0, d / 2, z), w * 0.11, "plastic_black", "disc", 20)
    for side in (-1, 1):
        arrow = [(side * w * 0.15, z), (side * w * 0.28, z + h * 0.09), (side * w * 0.28, z - h * 0.09)]
        b.prism(arrow, (d * 0.41, d * 0.48), "plastic_black", "y", "arrows", solid=False)
    flame = [
        (-w * 0.09, h * 0.74),
        (w * 0.09, h * 0.74),
        (w * 0.11, h * 0.82),
        (w * 0.02, h * 0.95),
        (-w * 0.1, h * 0.84),
    ]
    b.prism(flame, (body - 0.001, body + 0.003), "paint_yellow", "y", "sign", solid=False)


@recipe("paper_towel_dispenser")
def paper_towel_dispenser(b: Builder) -> None:
    """A case with a window on the roll of paper and a lock, a sheet that hangs from its mouth."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.3
    b.cushion((-w / 2, w / 2), (-d / 2, d * 0.46), (low, h), b.mat(), "case", 0.3, 12)
    b.box(
        (-w * 0.32, w * 0.32),
        (d * 0.46 - 0.002, d * 0.47),
        (h * 0.52, h * 0.86),
        "plastic_3d6a9e",
        "window",
        solid=False,
    )
    b.rod(
        (-w * 0.28, d * 0.44, h * 0.68),
        (w * 0.28, d * 0.44, h * 0.68),
        min(d * 0.06, h * 0.12),
        "paper_white",
        "roll",
        16,
    )
    b.box((-w * 0.36, w * 0.36), (0, d * 0.44), (low - h * 0.02, low + h * 0.03), "plastic_black", "mouth")
    b.prism(
        [(d * 0.2, low), (d * 0.22, low), (d * 0.34, 0), (d * 0.3, 0)],
        (-w * 0.32, w * 0.32),
        "paper_white",
        part="sheet",
    )
    b.rod((0, d * 0.46, h * 0.93), (0, d / 2, h * 0.93), w * 0.03, "metal_steel", "lock", 12)


@recipe("wet_floor_sign")
def wet_floor_sign(b: Builder) -> None:
    """A yellow stand of two boards like an A, with a warning triangle, a slipping figure and a hole to carry it by."""
    w, d, h = b.w, b.d, b.h
    for side in (-1, 1):
        board = [(side * d / 2, 0), (side * d * 0.44, 0), (0, h * 0.97), (side * d * 0.06, h)]
        b.prism(board, (-w / 2, w / 2), "plastic_f2c21a", part="boards")
    slope = (d * 0.06 - d / 2) / h

    def at(z: float) -> float:
        return d / 2 + slope * z

    def mark(x0: float, x1: float, z0: float, z1: float, color: str, lift: float) -> None:
        """Lay a rectangle on the front board."""
        face = [(at(h * z0), h * z0), (at(h * z0) + lift, h * z0), (at(h * z1) + lift, h * z1), (at(h * z1), h * z1)]
        b.prism(face, (w * x0, w * x1), color, part="print", solid=False)

    for k in range(6):
        half = 0.4 - 0.065 * k
        mark(-half, half, 0.52 + 0.055 * k, 0.575 + 0.055 * k, "plastic_black", 0.003)
    mark(-0.05, 0.05, 0.62, 0.76, "plastic_f2c21a", 0.006)
    mark(-0.05, 0.05, 0.54, 0.59, "plastic_f2c21a", 0.006)
    for z in (0.4, 0.28):
        mark(-0.36, 0.36, z, z + 0.06, "plastic_black", 0.003)
    mark(-0.3, 0.3, 0.14, 0.19, "paint_red", 0.003)
