"""Machines and small things of wards and laboratories, with the parts by which staff know them."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("ultrasound")
def ultrasound(b: Builder) -> None:
    """A cart with a keyboard and a track ball, probes on their cables, and a monitor that shows a fan of echoes."""
    w, d, h = b.w, b.d, b.h
    b.wheels(0.06, 0.07)
    b.box((-w / 2, w / 2), (-d / 2, d * 0.4), (0.1, 0.16), "plastic_grey", "base")
    b.prism(
        [(-d * 0.4, 0.16), (d * 0.1, 0.16), (d * 0.02, h * 0.48), (-d * 0.4, h * 0.48)],
        (-w * 0.32, w * 0.32),
        b.mat(),
        part="body",
    )
    desk = [(-d * 0.44, h * 0.48), (d / 2, h * 0.46), (d / 2, h * 0.5), (-d * 0.1, h * 0.56), (-d * 0.44, h * 0.56)]
    b.prism(desk, (-w * 0.46, w * 0.46), b.mat(), part="desk")
    keys = DrawnFace.sloped(b, (d / 2, h * 0.5), (-d * 0.1, h * 0.56))
    for k in range(4):
        for j in range(9):
            u, v = w * (-0.38 + 0.086 * j), d * (0.26 + 0.07 * k)
            keys.field(
                (u, u + w * 0.066), (v, v + d * 0.05), "plastic_dark" if (j + k) % 4 else "light_4f9bf0", "keys", 0.008
            )
    keys.disc(0, d * 0.14, d * 0.06, "plastic_4f86c6", "ball", 0.03)
    for u in (-0.3, 0.3):
        keys.disc(w * u, d * 0.14, d * 0.045, "plastic_grey", "dials", 0.02)
    b.rod((0, -d * 0.3, h * 0.54), (0, -d * 0.3, h * 0.72), 0.03, "metal_grey", "arm")
    b.box((-w * 0.48, w * 0.48), (-d * 0.32, -d * 0.24), (h * 0.64, h), "plastic_dark", "monitor")
    face = DrawnFace.front(b, -d * 0.24)
    face.field((-w * 0.45, w * 0.45), (h * 0.66, h * 0.985), "plastic_black", "screen", 0.003)
    fan = [(0.0, h * 0.96)]
    fan += [
        (math.cos(a) * w * 0.36, h * 0.96 + math.sin(a) * h * 0.26)
        for a in (math.radians(-140 + 20 * k) for k in range(6))
    ]
    b.prism(fan, (-d * 0.24 + 0.003, -d * 0.24 + 0.006), "screen_8b9196", "y", "image")
    for u, v, ru, color in (
        (-0.06, 0.8, 0.1, "plastic_black"),
        (0.06, 0.76, 0.05, "screen_e3e6e8"),
        (-0.09, 0.86, 0.03, "screen_e3e6e8"),
    ):
        face.disc(w * u, h * v, w * ru, color, "image", 0.008)
    for k in range(3):
        y = d * (0.02 + 0.13 * k)
        x = w * 0.48
        b.rod((x, y, h * 0.5), (x, y, h * 0.6), 0.016, "plastic_white", "probes", 10)
        b.ball(
            (x, y, h * 0.615),
            (0.032, 0.026, 0.026),
            ("plastic_dark", "plastic_4f86c6", "plastic_dark")[k],
            "probes",
            10,
        )
        b.path(
            [(x, y, h * 0.5), (x + 0.015, y, h * 0.28 - 0.03 * k), (w * 0.34, -d * 0.02, h * (0.2 + 0.08 * k))],
            0.009,
            "rubber_black",
            "cables",
        )


@recipe("anesthesia_machine")
def anesthesia_machine(b: Builder) -> None:
    """A cart with two coloured vaporizers, a bellows in its glass, monitors, blue breathing hoses and a black bag."""
    w, d, h = b.w, b.d, b.h
    b.wheels(0.06, 0.08)
    b.box((-w / 2, w / 2), (-d / 2, d * 0.42), (0.1, 0.16), "plastic_grey", "base")
    b.box((-w * 0.4, w * 0.4), (-d * 0.4, d * 0.2), (0.16, h * 0.5), b.mat(), "body")
    face = DrawnFace.front(b, d * 0.2)
    for k in range(3):
        v = 0.2 + k * h * 0.115
        face.field((-w * 0.36, w * 0.36), (v, v + h * 0.1), "plastic_light", "drawers", 0.012)
        face.field((-w * 0.1, w * 0.1), (v + h * 0.06, v + h * 0.075), "metal_grey", "drawers", 0.024)
    b.box((-w * 0.48, w * 0.48), (-d * 0.42, d * 0.4), (h * 0.5, h * 0.53), b.mat(), "desk")
    b.box((-w * 0.4, w * 0.4), (-d * 0.42, -d * 0.2), (h * 0.53, h * 0.84), b.mat(), "back")
    for u, color in ((0.06, "plastic_yellow"), (0.24, "plastic_purple")):
        x = -w * u
        b.box((x - w * 0.07, x + w * 0.07), (-d * 0.2, -d * 0.02), (h * 0.56, h * 0.7), color, "vaporizers")
        b.cyl(x, -d * 0.11, (h * 0.7, h * 0.745), w * 0.06, "plastic_black", "dials", n=14)
    x = w * 0.24
    b.cyl(x, d * 0.04, (h * 0.53, h * 0.56), w * 0.13, "plastic_dark", "bellows", n=20)
    for k in range(6):
        z = h * (0.56 + 0.028 * k)
        b.lathe(
            [(w * 0.07, z), (w * 0.1, z + h * 0.014), (w * 0.07, z + h * 0.028)],
            "rubber_black",
            (x, d * 0.04),
            "bellows",
            16,
        )
    b.cyl(x, d * 0.04, (h * 0.56, h * 0.76), w * 0.12, "glass_clear", "glass", n=20)
    for k in range(3):
        u = w * (-0.12 + 0.05 * k)
        b.rod(
            (u, -d * 0.19, h * 0.58),
            (u, -d * 0.19, h * 0.8),
            0.012,
            ("light_green", "light_4f9bf0", "light_white")[k],
            "flow",
            8,
        )
    for u, v0 in ((-0.24, 0.76), (0.2, 0.84)):
        b.box(
            (w * (u - 0.22), w * (u + 0.22)),
            (-d * 0.3, -d * 0.2),
            (h * v0, h * (v0 + 0.16)),
            "plastic_dark",
            "monitors",
        )
        screen = DrawnFace.front(b, -d * 0.2)
        screen.field(
            (-w * (u + 0.2), -w * (u - 0.2)), (h * (v0 + 0.015), h * (v0 + 0.145)), "plastic_black", "screens", 0.004
        )
        for k, color in enumerate(("light_green", "light_yellow", "light_4f9bf0")):
            v = h * (v0 + 0.04 + 0.035 * k)
            wave = [(-w * (u + 0.19 - 0.038 * j), v + h * 0.014 * (j % 2) * (1 + j % 3)) for j in range(10)]
            screen.line(wave, 0.006, color, "screens", 0.008)
    for k in range(2):
        hose = [
            (w * 0.4, d * 0.3, h * 0.48),
            (w * 0.47, d * 0.44, h * (0.4 - 0.05 * k)),
            (w * 0.3 - 0.1 * k, d * 0.47, h * 0.26),
            (-w * 0.1, d * 0.46, h * (0.22 + 0.06 * k)),
            (-w * 0.3, d * 0.44, h * 0.46),
        ]
        b.path(hose, 0.022, "plastic_5aa9e6", "hoses")
    b.ball((-w * 0.42, d * 0.42, h * 0.38), (0.06, 0.06, 0.13), "rubber_black", "bag", 12)
    b.rod((-w * 0.42, d * 0.4, h * 0.46), (-w * 0.42, d * 0.4, h * 0.54), 0.02, "metal_chrome", "bag")


@recipe("dialysis_machine")
def dialysis_machine(b: Builder) -> None:
    """A tower with a screen, two blood pumps, red and blue tubes through a filter at its side, a bag on a pole."""
    w, d, h = b.w, b.d, b.h
    b.wheels(0.05, 0.07)
    b.box((-w / 2, w / 2), (-d / 2, d * 0.44), (0.08, 0.16), "plastic_grey", "base")
    front = d * 0.24
    b.box((-w * 0.34, w * 0.34), (-d * 0.4, front), (0.16, h * 0.66), b.mat(), "body")
    b.box((-w * 0.38, w * 0.38), (-d * 0.3, d * 0.1), (h * 0.66, h * 0.86), "plastic_light", "head")
    face = DrawnFace.front(b, d * 0.1)
    face.field((-w * 0.35, w * 0.35), (h * 0.675, h * 0.85), "plastic_black", "screen", 0.004)
    face.field((-w * 0.31, 0.0), (h * 0.69, h * 0.84), "light_4f9bf0", "screen", 0.007)
    for k, color in enumerate(("light_red", "light_green", "light_yellow")):
        face.field((w * 0.05, w * 0.31), (h * (0.7 + 0.05 * k), h * (0.73 + 0.05 * k)), color, "screen", 0.007)
    face = DrawnFace.front(b, front)
    for k, v in enumerate((0.55, 0.39)):
        face.disc(-w * 0.12, h * v, w * 0.17, "plastic_grey", "pumps", 0.03, 24)
        face.disc(-w * 0.12, h * v, w * 0.14, "plastic_dark", "pumps", 0.04, 24)
        face.field((-w * 0.23, -w * 0.01), (h * v - 0.02, h * v + 0.02), "plastic_white", "pumps", 0.055)
        ring = [
            (-w * 0.12 + math.cos(a) * w * 0.155, h * v + math.sin(a) * w * 0.155)
            for a in (0.4 + j * 0.5 for j in range(11))
        ]
        face.line(ring, 0.011, ("paint_red", "plastic_3d6a9e")[k], "tubes", 0.05)
    x = -w * 0.44
    b.rod((x, front, h * 0.32), (x, front, h * 0.6), w * 0.07, "plastic_white", "filter", 16)
    for z in (h * 0.3, h * 0.59):
        b.rod(
            (x, front, z),
            (x, front, z + h * 0.03),
            w * 0.09,
            ("plastic_3d6a9e", "paint_red")[z > h * 0.5],
            "filter",
            16,
        )
    b.path(
        [
            (x, front, h * 0.62),
            (x + 0.02, front + 0.06, h * 0.66),
            (w * 0.0, front + 0.05, h * 0.62),
            (w * 0.04, front + 0.05, h * 0.58),
        ],
        0.011,
        "paint_red",
        "tubes",
    )
    b.path(
        [
            (x, front, h * 0.3),
            (x + 0.02, front + 0.06, h * 0.25),
            (w * 0.0, front + 0.05, h * 0.3),
            (w * 0.04, front + 0.05, h * 0.36),
        ],
        0.011,
        "plastic_3d6a9e",
        "tubes",
    )
    b.path(
        [(w * 0.2, front + 0.05, h * 0.55), (w * 0.26, front + 0.08, h * 0.3), (w * 0.3, d / 2 - 0.02, h * 0.2)],
        0.011,
        "paint_red",
        "tubes",
    )
    b.path(
        [(w * 0.2, front + 0.05, h * 0.39), (w * 0.22, front + 0.08, h * 0.26), (w * 0.24, d / 2 - 0.02, h * 0.17)],
        0.011,
        "plastic_3d6a9e",
        "tubes",
    )
    for x, color in ((-w * 0.2, "paint_red"), (w * 0.12, "plastic_3d6a9e")):
        b.box((x - w * 0.13, x + w * 0.13), (front, d * 0.44), (0.16, 0.34), "plastic_white", "canisters")
        b.cyl(x, (front + d * 0.44) / 2, (0.34, 0.38), w * 0.06, color, "canisters", n=12)
    b.path(
        [(w * 0.4, -d * 0.2, h * 0.5), (w * 0.4, -d * 0.2, h - 0.02), (w * 0.24, -d * 0.2, h - 0.02)],
        0.012,
        "metal_chrome",
        "pole",
    )
    b.cushion((w * 0.16, w * 0.32), (-d * 0.24, -d * 0.16), (h * 0.87, h * 0.975), "glass_d9ecf2", "bag", 0.6)


@recipe("pressure_gauge_stand")
def pressure_gauge_stand(b: Builder) -> None:
    """A stand on castors with a large round gauge, a blue cuff in a basket, a coiled tube and a black bulb."""
    w, d, h = b.w, b.d, b.h
    for k in range(5):
        a = math.pi / 2 + k * math.tau / 5
        x, y = math.cos(a) * w * 0.42, math.sin(a) * d * 0.42
        b.path([(0, 0, 0.1), (x, y, 0.075)], 0.02, "metal_grey", "base")
        b.ball((x, y, 0.035), (0.035, 0.035, 0.035), "rubber_black", "castors", 8)
    b.rod((0, 0, 0.08), (0, 0, h * 0.8), 0.018, "metal_chrome", "pole", solid=True)
    r = w * 0.3
    z = h - r
    b.rod((0, -0.02, z), (0, 0.06, z), r, "plastic_dark", "gauge", 32, solid=True)
    b.rod((0, 0.06, z), (0, 0.066, z), r * 0.9, "plastic_white", "gauge", 32)
    face = DrawnFace.front(b, 0.066)
    for k in range(13):
        a = math.radians(-50 + 280 * k / 12)
        face.line(
            [(math.cos(a) * r * s, z + math.sin(a) * r * s) for s in (0.66, 0.82)], r * 0.03, "plastic_black", "gauge"
        )
    face.line([(0, z), (-r * 0.5, z + r * 0.4)], r * 0.04, "paint_red", "needle", 0.006)
    face.disc(0, z, r * 0.1, "plastic_black", "needle", 0.012)
    face.write("MMHG", (-r * 0.3, r * 0.3), (z - r * 0.6, z - r * 0.36), "plastic_black", "letters", 0.003)
    b.box((-w * 0.26, w * 0.26), (0.02, d * 0.4), (h * 0.42, h * 0.43), "metal_chrome", "basket")
    for v in (0.43, 0.5):
        ring = [(-w * 0.26, 0.02), (w * 0.26, 0.02), (w * 0.26, d * 0.4), (-w * 0.26, d * 0.4), (-w * 0.26, 0.02)]
        b.path([(x, y, h * v) for x, y in ring], 0.008, "metal_chrome", "basket")
    b.cushion((-w * 0.22, w * 0.22), (0.04, d * 0.34), (h * 0.43, h * 0.58), "fabric_2f5fa8", "cuff", 0.7)
    b.box((-w * 0.06, w * 0.06), (d * 0.335, d * 0.35), (h * 0.44, h * 0.57), "plastic_white", "cuff", solid=False)
    coil = [
        (w * 0.12 + 0.03 * math.cos(k * 1.6), 0.09 + 0.03 * math.sin(k * 1.6), h * (0.58 + 0.01 * k)) for k in range(16)
    ]
    b.path(coil, 0.009, "rubber_black", "tube")
    b.path([(-w * 0.2, d * 0.3, h * 0.5), (-w * 0.34, d * 0.36, h * 0.4)], 0.009, "rubber_black", "tube")
    b.ball((-w * 0.36, d * 0.37, h * 0.33), (0.035, 0.035, 0.06), "rubber_black", "bulb", 12)


@recipe("kidney_dish")
def kidney_dish(b: Builder) -> None:
    """A steel dish of the outline of a kidney."""
    w, d, h = b.w, b.d, b.h
    outline = [
        (0.0, 0.08),
        (0.14, 0.14),
        (0.26, 0.34),
        (0.38, 0.42),
        (0.47, 0.3),
        (0.5, 0.06),
        (0.44, -0.2),
        (0.3, -0.4),
        (0.12, -0.49),
    ]
    outline += [(-x, y) for x, y in outline[:0:-1]]
    floor = [(x * w * 0.86, y * d * 0.86) for x, y in outline]
    b.prism(floor, (0, h * 0.08), "metal_light", "z", "floor")
    edge = [(x * w, y * d) for x, y in outline]
    inner = [(x * w * 0.95, y * d * 0.95) for x, y in outline]
    for k in range(len(edge)):
        n = (k + 1) % len(edge)
        b.path([(*edge[k], h * 0.97), (*edge[n], h * 0.97)], h * 0.05, "metal_chrome", "rim")
        b.prism([edge[k], edge[n], inner[n], inner[k]], (0, h), b.mat(), "z", "wall")


@recipe("urine_bottle")
def urine_bottle(b: Builder) -> None:
    """A lying-bed bottle: a flat body half full of yellow, a wide neck that leans forward, a handle and a scale."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.66
    b.cushion((-w / 2, w / 2), (-d / 2, d * 0.4), (0, low * 0.6), "glass_e3b92f", "content", 0.35, 12)
    b.cushion((-w / 2, w / 2), (-d / 2, d * 0.4), (low * 0.6, low), b.mat(), "body", 0.35, 12)
    b.rod((0, -d * 0.06, low * 0.9), (w * 0.3, d * 0.26, h * 0.93), w * 0.24, b.mat(), "neck", 18, solid=True)
    b.rod((w * 0.28, d * 0.24, h * 0.9), (w * 0.33, d * 0.29, h * 0.96), w * 0.29, b.mat(), "neck", 18)
    b.rod((w * 0.33, d * 0.29, h * 0.96), (w * 0.332, d * 0.292, h * 0.963), w * 0.22, "plastic_black", "mouth", 18)
    b.path(
        [(-w * 0.2, -d * 0.1, low * 0.97), (-w * 0.3, -d * 0.12, h * 0.94), (-w * 0.02, d * 0.02, h * 0.97)],
        w * 0.06,
        b.mat(),
        "handle",
    )
    face = DrawnFace.front(b, d * 0.4)
    for k in range(6):
        v = low * (0.14 + 0.12 * k)
        face.field((-w * 0.3, -w * (0.08 if k % 2 else 0.0)), (v, v + h * 0.012), "plastic_2f5fa8", "scale", 0.001)
    face.write("500", (w * 0.04, w * 0.34), (low * 0.62, low * 0.78), "plastic_2f5fa8", "scale", 0.001)


@recipe("glove_box")
def glove_box(b: Builder) -> None:
    """A carton with an oval opening out of which a blue glove stands with its fingers spread."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.52
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, top), "paper_white", "box")
    b.box((-w / 2, w / 2), (-d / 2 - 0.0005, d / 2 + 0.0005), (0, top * 0.22), b.mat(), "box")
    b.lathe([(0.5, top), (0.5, top * 1.02)], "plastic_black", stretch=(w * 0.6, d * 0.6), part="opening", n=24)
    b.cushion((-w * 0.13, w * 0.13), (-d * 0.14, d * 0.14), (top * 0.9, h * 0.82), "rubber_3f7fd0", "glove", 0.7)
    for k, (u, z) in enumerate(((-0.14, 0.98), (-0.06, 1.06), (0.03, 1.08), (0.11, 1.0))):
        b.rod(
            (w * u * 0.7, 0, h * 0.74), (w * u * 1.2, d * 0.05 * (k % 2), h * z), w * 0.034, "rubber_3f7fd0", "glove", 8
        )
    b.rod((w * 0.1, 0, h * 0.66), (w * 0.24, d * 0.04, h * 0.84), w * 0.034, "rubber_3f7fd0", "glove", 8)
    face = DrawnFace.front(b, d / 2)
    face.write("GLOVES", (-w * 0.44, w * 0.44), (top * 0.36, top * 0.82), "plastic_2f5fa8", "letters", 0.001)
    side = DrawnFace.side(b, w / 2)
    side.field((-d * 0.06, d * 0.06), (top * 0.36, top * 0.86), "paint_green", "cross", 0.001)
    side.field((-d * 0.18, d * 0.18), (top * 0.53, top * 0.69), "paint_green", "cross", 0.001)


@recipe("lab_balance")
def lab_balance(b: Builder) -> None:
    """A scale with a round steel pan in a house of glass, and figures lit on its front."""
    w, d, h = b.w, b.d, b.h
    base = h * 0.34
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.06), (0, base), b.mat(), "base")
    b.prism(
        [(d / 2 - 0.06, 0), (d / 2, 0), (d / 2, base * 0.4), (d / 2 - 0.06, base)],
        (-w / 2, w / 2),
        b.mat(),
        part="front",
    )
    slope = DrawnFace.sloped(b, (d / 2, base * 0.4), (d / 2 - 0.06, base))
    slope.field((-w * 0.42, w * 0.42), (0.008, 0.055), "plastic_black", "display", 0.001)
    slope.write("0.00 G".replace(".", ":"), (-w * 0.38, w * 0.38), (0.016, 0.048), "light_green", "display", 0.002)
    pan = (0.0, -d * 0.12)
    b.cyl(*pan, (base, base + h * 0.06), w * 0.08, "metal_steel", "pan", n=14)
    b.cyl(*pan, (base + h * 0.06, base + h * 0.1), w * 0.34, "metal_chrome", "pan", n=28)
    b.cyl(*pan, (base + h * 0.1, base + h * 0.24), w * 0.1, "metal_brass", "weight", n=16)
    b.cyl(*pan, (base + h * 0.24, base + h * 0.32), w * 0.05, "metal_brass", "weight", n=12)
    low, back, front = base, -d / 2, d * 0.18
    for x in (-w * 0.46, w * 0.46):
        for y in (back + 0.008, front):
            b.rod((x, y, low), (x, y, h), 0.004, "metal_steel", "frame", 6)
    ring = [
        (-w * 0.46, back + 0.008),
        (w * 0.46, back + 0.008),
        (w * 0.46, front),
        (-w * 0.46, front),
        (-w * 0.46, back + 0.008),
    ]
    b.path([(x, y, h - 0.004) for x, y in ring], 0.005, "metal_dark", "frame")
    for x in (-w * 0.46, w * 0.455):
        b.box((x, x + 0.002), (back, front), (low, h - 0.006), "glass_clear", "house", solid=False)
    b.box((-w * 0.46, w * 0.46), (front - 0.002, front), (low, h - 0.006), "glass_clear", "house", solid=False)
