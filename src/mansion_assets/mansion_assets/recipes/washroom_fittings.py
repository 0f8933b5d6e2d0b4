"""Fittings of bathrooms and washrooms: bars and hangers, dryers, dispensers, scales."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("towel_bar")
def towel_bar(b: Builder) -> None:
    """Bar on two brackets."""
    w, d, h = b.w, b.d, b.h
    r = min(0.014, h * 0.4, d * 0.2)
    y, z = d / 2 - r, h / 2
    b.rod((-w / 2, y, z), (w / 2, y, z), r, b.mat(), "bar", 10, solid=True)
    for sx in (-1, 1):
        x = sx * (w / 2 - min(0.03, w * 0.1))
        b.rod((x, -d / 2, z), (x, y, z), r, b.mat(), "brackets")
        b.box(
            (x - min(0.02, w * 0.08), x + min(0.02, w * 0.08)),
            (-d / 2, -d / 2 + 0.008),
            (0, h),
            b.mat(),
            "plates",
            solid=False,
        )


@recipe("grab_bar")
def grab_bar(b: Builder) -> None:
    """A thick bar with bent ends on round plates with screws, ribbed in red where the hand holds it."""
    w, d, h = b.w, b.d, b.h
    r, z, plate = min(0.017, h * 0.36), h / 2, h / 2
    y = d / 2 - r
    x = w / 2 - plate
    bend = min(0.05, w * 0.1)
    turns = [k * math.pi / 10 for k in range(6)]
    for side in (-1, 1):
        arc = [(side * (x - bend * (1 - math.cos(a))), y - bend * (1 - math.sin(a)), z) for a in turns]
        b.path([(side * x, -d / 2, z), *arc], r, b.mat(), "bar")
        b.rod((side * x, -d / 2, z), (side * x, -d / 2 + 0.01, z), plate, b.mat(), "plates", 24)
        for k in range(3):
            a = math.pi / 2 + k * math.tau / 3
            spot = (side * x + math.cos(a) * plate * 0.84, z + math.sin(a) * plate * 0.84)
            b.rod(
                (spot[0], -d / 2 + 0.01, spot[1]), (spot[0], -d / 2 + 0.013, spot[1]), 0.0025, "metal_dark", "screws", 8
            )
    b.rod((-x + bend, y, z), (x - bend, y, z), r, b.mat(), "bar", 14, solid=True)
    half = (x - bend) * 0.62
    b.rod((-half, y, z), (half, y, z), r * 1.12, "rubber_d8281e", "grip", 16)
    for k in range(14):
        rib = -half + 2 * half * (k + 0.5) / 14
        b.rod((rib - half * 0.02, y, z), (rib + half * 0.02, y, z), r * 1.24, "rubber_8a1812", "ribs", 16)


@recipe("paper_hanger")
def paper_hanger(b: Builder) -> None:
    """A roll of paper on an arm that is open at one end, its core in sight, and a dotted sheet that hangs down."""
    w, d, h = b.w, b.d, b.h
    wide = h > d * 0.9
    r = min(d * 0.46, h * (0.36 if wide else 0.42))
    y, z = d / 2 - r, h - r
    roll = (-w * 0.3, min(w * 0.3, w / 2 - r * 0.12))
    b.box((-w * 0.46, w * 0.46), (-d / 2, -d / 2 + min(0.008, d * 0.12)), (h * 0.3, h), b.mat(), "plate")
    b.rod((roll[0], y, z), (roll[1], y, z), r, "paper_white", "roll", 28)
    for k, color in enumerate(("paper_d9dcde", "paper_white", "paper_d9dcde", "paper_b98d5c", "plastic_26272b")):
        share = (0.86, 0.78, 0.56, 0.46, 0.32)[k]
        b.rod((roll[1], y, z), (roll[1] + w * 0.002 * (k + 1), y, z), r * share, color, "core", 20)
    arm = max(0.004, r * 0.14)
    b.rod((-w / 2 + arm, y, z), (w / 2, y, z), arm, b.mat(), "pin", 10)
    b.rod((-w / 2 + arm, -d / 2, z), (-w / 2 + arm, y, z), arm, b.mat(), "arm", 10)
    b.box((roll[0], roll[1]), (d / 2 - r * 0.04 - 0.001, d / 2), (0, z), "paper_white", "sheet", solid=False)
    face = DrawnFace.front(b, d / 2)
    line = z * 0.42
    for k in range(11):
        u = -roll[1] + (roll[1] - roll[0]) * (k + 0.25) / 11
        dash = (roll[1] - roll[0]) * 0.5 / 11
        face.field((u, u + dash), (line - h * 0.008, line + h * 0.008), "plastic_8d959c", "dots", 0.0008)


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


@recipe("liquid_soap")
def liquid_soap(b: Builder) -> None:
    """A case with a window on pink soap, a wide lever to press, a nozzle, and a drop that falls from it."""
    w, d, h = b.w, b.d, b.h
    low, front = h * 0.3, d * 0.28
    b.cushion((-w / 2, w / 2), (-d / 2, front), (low, h), b.mat(), "case", 0.3, 14)
    face = DrawnFace.front(b, front)
    face.field((-w * 0.24, w * 0.24), (h * 0.56, h * 0.9), "plastic_dark", "window", d * 0.02)
    face.field((-w * 0.2, w * 0.2), (h * 0.58, h * 0.78), "plastic_f08fb0", "soap", d * 0.035)
    face.field((-w * 0.2, w * 0.2), (h * 0.78, h * 0.88), "plastic_dff0f5", "soap", d * 0.03)
    b.prism(
        [
            (front - d * 0.1, low),
            (front, low),
            (d / 2, low + h * 0.05),
            (front + d * 0.04, h * 0.5),
            (front - d * 0.1, h * 0.5),
        ],
        (-w * 0.4, w * 0.4),
        "metal_chrome",
        part="lever",
    )
    DrawnFace.front(b, d * 0.42).write(
        "SOAP", (-w * 0.32, w * 0.32), (h * 0.35, h * 0.46), "plastic_black", "letters", d * 0.04
    )
    b.cyl(0, d * 0.06, (h * 0.2, low + 0.005), w * 0.09, "plastic_black", "nozzle", n=12)
    b.lathe(
        [(w * 0.02, h * 0.15), (w * 0.09, h * 0.06), (w * 0.05, 0.0)][::-1], "plastic_f08fb0", (0, d * 0.06), "drop", 12
    )


@recipe("person_scale")
def person_scale(b: Builder) -> None:
    """A flat plate with two marks for feet and a lit figure of kilograms."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.3, h * 0.94), b.mat(), "plate", 0.4, 12)
    for side in (-1, 1):
        for end in (-1, 1):
            b.cyl(side * w * 0.38, end * d * 0.38, (0, h * 0.4), w * 0.06, "rubber_black", "feet", n=12)
    face = DrawnFace.top(b, h * 0.94)
    dark = "glass" in b.mat()
    ink = "plastic_light" if dark else "plastic_dark"
    for side in (-1, 1):
        u = side * w * 0.2
        face.disc(u, -d * 0.1, w * 0.1, ink, "feet_marks", h * 0.03)
        face.disc(u, d * 0.06, w * 0.12, ink, "feet_marks", h * 0.03)
        face.disc(u, -d * 0.28, w * 0.085, ink, "feet_marks", h * 0.03)
        for k in range(5):
            face.disc(
                u + w * (-0.1 + 0.05 * k),
                d * (0.2 + 0.015 * (2 - abs(k - 2))),
                w * 0.024,
                ink,
                "feet_marks",
                h * 0.03,
                8,
            )
    face.field((-w * 0.2, w * 0.2), (d * 0.28, d * 0.46), "plastic_101820", "display", h * 0.04)
    face.write("72:5", (-w * 0.17, w * 0.17), (d * 0.31, d * 0.43), "light_4fd0f0", "figures", h * 0.06)
