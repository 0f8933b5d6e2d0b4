"""Machines of plant rooms: emergency power, air, water."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("ups")
def ups(b: Builder) -> None:
    """A cabinet with the sign of a charged battery, a display, a switch, and a perforated door over fans."""
    w, d, h = b.w, b.d, b.h
    front = d / 2 - 0.01
    b.box((-w / 2, w / 2), (-d / 2, front), (0.05, h), b.mat(), "case")
    b.box((-w * 0.45, w * 0.45), (-d * 0.45, d * 0.4), (0, 0.05), "metal_dark", "foot")
    face = DrawnFace.front(b, front)
    face.field((-w * 0.46, w * 0.46), (0.08, h * 0.98), "metal_dark", "door", 0.006)
    face = DrawnFace.front(b, front + 0.006)
    face.write("UPS", (-w * 0.38, w * 0.38), (h * 0.84, h * 0.95), "plastic_white", "letters", 0.004)
    face.field((-w * 0.26, w * 0.24), (h * 0.64, h * 0.78), "plastic_white", "battery")
    face.field((w * 0.24, w * 0.3), (h * 0.68, h * 0.74), "plastic_white", "battery", 0.004)
    for k in range(4):
        u = w * (-0.235 + 0.115 * k)
        face.field((u, u + w * 0.095), (h * 0.65, h * 0.77), "light_green", "battery", 0.006)
    face.field((-w * 0.38, w * 0.06), (h * 0.5, h * 0.6), "screen_green", "display", 0.004)
    face.disc(w * 0.26, h * 0.55, w * 0.07, "plastic_red", "switch", 0.004)
    for k in range(9):
        v = h * (0.08 + 0.043 * k)
        face.field((-w * 0.4, w * 0.4), (v, v + h * 0.016), "plastic_black", "vents", 0.003)
    bolt = ((0.06, 0.78), (-0.12, 0.6), (0.0, 0.6), (-0.06, 0.44), (0.14, 0.64), (0.02, 0.64))
    x = w / 2
    for part in ((0, 1, 2, 5), (2, 3, 4, 5)):
        outline = [(bolt[k][0] * d * 2, h * bolt[k][1]) for k in part]
        b.prism(outline, (x - 0.002, x + 0.003), "paint_yellow", "x", "sign", solid=False)


@recipe("generator")
def generator(b: Builder) -> None:
    """Engine, radiator with its fan and alternator in a row on a tank with a frame, an exhaust and a control box."""
    w, d, h = b.w, b.d, b.h
    base = h * 0.2
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, base), b.mat(), "tank")
    b.box((-w * 0.22, w * 0.22), (-d * 0.26, d * 0.26), (base, h * 0.62), "metal_grey", "engine")
    for k in range(4):
        x = -w * 0.17 + k * w * 0.1
        b.box((x, x + w * 0.06), (-d * 0.16, d * 0.3), (h * 0.6, h * 0.7), "metal_dark", "cylinders")
    b.rod((-w * 0.47, 0, h * 0.42), (-w * 0.22, 0, h * 0.42), h * 0.19, b.mat(), "alternator", 20, solid=True)
    for k in range(6):
        x = -w * (0.45 - 0.035 * k)
        b.rod((x, 0, h * 0.42), (x + w * 0.012, 0, h * 0.42), h * 0.2, "metal_dark", "alternator", 20)
    b.box((w * 0.28, w * 0.44), (-d * 0.38, d * 0.38), (base, h * 0.76), "metal_dark", "radiator")
    side = DrawnFace.side(b, w * 0.44)
    side.disc(0, h * 0.48, d * 0.32, "metal_light", "fan", 0.01, 28)
    side.disc(0, h * 0.48, d * 0.29, "plastic_black", "fan", 0.015, 28)
    for k in range(6):
        a = k * math.pi / 3
        side.line(
            [(0, h * 0.48), (math.cos(a) * d * 0.27, h * 0.48 + math.sin(a) * d * 0.27)], d * 0.04, "metal_light", "fan"
        )
    b.path([(w * 0.1, 0, h * 0.66), (w * 0.1, 0, h * 0.86), (-w * 0.3, 0, h * 0.86)], 0.04, "metal_brown", "exhaust")
    b.rod((-w * 0.34, 0, h * 0.86), (-w * 0.02, 0, h * 0.86), h * 0.075, "metal_steel", "exhaust", 14)
    for x in (-w * 0.48, w * 0.48):
        for y in (-d * 0.46, d * 0.46):
            b.rod((x, y, base), (x, y, h - 0.03), 0.03, b.mat(), "frame")
        b.rod((x, -d * 0.46, h - 0.03), (x, d * 0.46, h - 0.03), 0.03, b.mat(), "frame")
    for y in (-d * 0.46, d * 0.46):
        b.rod((-w * 0.48, y, h - 0.03), (w * 0.48, y, h - 0.03), 0.03, b.mat(), "frame")
    b.box((-w * 0.46, -w * 0.24), (d * 0.3, d * 0.48), (h * 0.44, h * 0.8), "plastic_dark", "controls")
    panel = DrawnFace.front(b, d * 0.48)
    panel.field((w * 0.26, w * 0.44), (h * 0.66, h * 0.76), "screen_green", "controls", 0.004)
    for k, color in enumerate(("red", "yellow", "green")):
        panel.disc(w * (0.29 + 0.06 * k), h * 0.53, w * 0.022, f"plastic_{color}", "controls", 0.01)
    face = DrawnFace.front(b, d / 2)
    face.write("DIESEL", (-w * 0.3, w * 0.2), (h * 0.05, h * 0.15), "plastic_black", "letters", 0.003)


@recipe("air_handler")
def air_handler(b: Builder) -> None:
    """A long case of panels with a fan behind a round grille, a bank of filters, and a flanged duct on top."""
    w, d, h = b.w, b.d, b.h
    high, front = h * 0.7, d / 2 - 0.03
    b.box((-w / 2, w / 2), (-d / 2, front), (h * 0.07, high), b.mat(), "case")
    for x in (-w * 0.46, 0.0, w * 0.46):
        b.box((x - w * 0.03, x + w * 0.03), (-d / 2, front), (0, h * 0.07), "metal_dark", "feet")
    _ducts(b, high)
    face = DrawnFace.front(b, front)
    middle, r = high * 0.56, min(w * 0.2, high * 0.34)
    face.field((-w * 0.48, -w * 0.01), (h * 0.1, high - 0.03), "metal_light", "panels", 0.008)
    face.field((w * 0.01, w * 0.48), (h * 0.1, high - 0.03), "metal_light", "panels", 0.008)
    _fan_grille(b, middle, r, face)
    _filters(b, face, high)
    _flow_arrow(b)


def _ducts(b: Builder, high: float) -> None:
    """A square duct with flanges, and a round one."""
    w, d, h = b.w, b.d, b.h
    b.box((w * 0.06, w * 0.42), (-d * 0.36, d * 0.3), (high, h * 0.96), "metal_light", "duct")
    for z in (high, h * 0.95):
        b.box((w * 0.03, w * 0.45), (-d * 0.4, d * 0.34), (z, z + h * 0.03), "metal_steel", "flanges")
    b.rod(
        (-w * 0.26, -d * 0.03, high),
        (-w * 0.26, -d * 0.03, h * 0.86),
        min(w * 0.16, d * 0.3),
        "metal_light",
        "duct",
        24,
    )
    b.rod(
        (-w * 0.26, -d * 0.03, h * 0.86),
        (-w * 0.26, -d * 0.03, h * 0.88),
        min(w * 0.19, d * 0.34),
        "metal_steel",
        "flanges",
        24,
    )


def _fan_grille(b: Builder, middle: float, r: float, face: DrawnFace) -> None:
    """A fan with five blades behind a round grille."""
    w = b.w
    face.disc(-w * 0.245, middle, r, "metal_dark", "fan", 0.018, 28)
    for k in range(5):
        a = 0.4 + k * math.tau / 5
        tip = (-w * 0.245 + math.cos(a) * r * 0.8, middle + math.sin(a) * r * 0.8)
        face.line([(-w * 0.245, middle), tip], r * 0.16, "plastic_white", "fan", 0.02)
    for share in (0.35, 0.68, 1.0):
        ring = [
            (-w * 0.245 + math.cos(k * math.pi / 10) * r * share, middle + math.sin(k * math.pi / 10) * r * share)
            for k in range(21)
        ]
        face.line(ring, 0.01, "metal_steel", "grille", 0.024)


def _filters(b: Builder, face: DrawnFace, high: float) -> None:
    """Four pleated filters."""
    w = b.w
    for k in range(4):
        u = w * (0.04 + 0.105 * k)
        face.field((u, u + w * 0.09), (high * 0.2, high * 0.88), "paper_beige", "filters", 0.014)
        for j in range(5):
            s = u + w * (0.01 + 0.016 * j)
            face.field((s, s + w * 0.006), (high * 0.22, high * 0.86), "paper_brown", "filters", 0.018)


def _flow_arrow(b: Builder) -> None:
    """A blue arrow along the ducts."""
    w, d, h = b.w, b.d, b.h
    arrow = DrawnFace.front(b, d * 0.3)
    arrow.field((-w * 0.36, -w * 0.22), (h * 0.82, h * 0.86), "paint_blue", "arrow", 0.006)
    b.prism(
        [(w * 0.22, h * 0.79), (w * 0.22, h * 0.89), (w * 0.14, h * 0.84)],
        (d * 0.3, d * 0.3 + 0.006),
        "paint_blue",
        "y",
        "arrow",
    )


@recipe("water_pump")
def water_pump(b: Builder) -> None:
    """A finned motor that drives a snail of iron with two flanged pipes, a valve with a red wheel and a gauge."""
    w, d, h = b.w, b.d, b.h
    base, axis = h * 0.1, h * 0.42
    b.box((-w / 2, w * 0.3), (-d * 0.4, d * 0.4), (0, base), "metal_dark", "base")
    r = min(d * 0.34, h * 0.26)
    b.rod((-w * 0.46, 0, axis), (-w * 0.06, 0, axis), r * 0.88, b.mat(), "motor", 20, solid=True)
    for k in range(16):
        a = k * math.pi / 8
        y, z = math.cos(a) * r * 0.9, axis + math.sin(a) * r * 0.9
        b.rod((-w * 0.4, y, z), (-w * 0.1, y, z), r * 0.1, b.mat(), "fins", 4)
    b.rod((-w / 2, 0, axis), (-w * 0.44, 0, axis), r, "metal_dark", "motor", 20)
    b.box((-w * 0.32, -w * 0.16), (-d * 0.1, d * 0.1), (axis + r * 0.8, axis + r * 1.3), "metal_dark", "terminals")
    for x in (-w * 0.36, -w * 0.14):
        b.box((x - 0.02, x + 0.02), (-r * 0.8, r * 0.8), (base, axis), "metal_dark", "feet")
    b.rod((-w * 0.06, 0, axis), (w * 0.06, 0, axis), r * 0.25, "metal_steel", "shaft", 12)
    b.rod((w * 0.06, 0, axis), (w * 0.24, 0, axis), r * 1.15, "metal_red", "casing", 24, solid=True)
    b.rod((w * 0.24, 0, axis), (w * 0.27, 0, axis), r * 0.8, "metal_dark", "casing", 24)
    b.rod((w * 0.24, 0, axis), (w * 0.5, 0, axis), r * 0.42, "metal_steel", "inlet", 16, solid=True)
    for x in (w * 0.34, w * 0.47):
        b.rod((x, 0, axis), (x + w * 0.03, 0, axis), r * 0.7, "metal_steel", "flanges", 16)
    y = r * 0.5
    b.rod((w * 0.15, y, axis), (w * 0.15, y, h), r * 0.4, "metal_steel", "outlet", 16, solid=True)
    for z in (axis + r * 1.1, h - 0.03):
        b.rod((w * 0.15, y, z), (w * 0.15, y, z + 0.03), r * 0.66, "metal_steel", "flanges", 16)
    z = axis + r * 1.75
    b.rod((w * 0.15, y, z), (w * 0.15, d * 0.44, z), r * 0.1, "metal_brass", "valve", 8)
    wheel = [
        (w * 0.15 + math.cos(k * math.pi / 6) * r * 0.5, d * 0.45, z + math.sin(k * math.pi / 6) * r * 0.5)
        for k in range(13)
    ]
    b.path(wheel, r * 0.08, "paint_red", "wheel")
    for k in range(3):
        b.rod((w * 0.15, d * 0.45, z), wheel[k * 4], r * 0.05, "paint_red", "wheel", 6)


@recipe("storage_tank")
def storage_tank(b: Builder) -> None:
    """A vessel with rings and a cone below, on four legs, with a ladder, a manhole, a level gauge and an outlet tap."""
    w, d, h = b.w, b.d, b.h
    low, high, r = h * 0.28, h * 0.86, 0.44
    b.lathe([(0.1, h * 0.14), (r, low), (r, high), (r * 0.5, h * 0.93)], b.mat(), stretch=(w, d), n=28, part="vessel")
    for z in (low, (low + high) / 2, high - 0.03):
        b.lathe([(r * 1.02, z), (r * 1.02, z + 0.035)], "metal_grey", stretch=(w, d), n=28, part="rings")
    b.lathe(
        [(0.12, h * 0.9), (0.12, h * 0.96), (0.15, h * 0.96), (0.15, h * 0.985)],
        "metal_dark",
        stretch=(w, d),
        part="manhole",
        n=16,
    )
    b.rod((-0.12 * w, 0, h * 0.99), (0.12 * w, 0, h * 0.99), 0.015, "metal_dark", "manhole", 6)
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        x, y = math.cos(a) * w * 0.4, math.sin(a) * d * 0.4
        b.rod((x, y, 0), (x, y, low + h * 0.1), 0.045, "metal_grey", "legs", 10, solid=True)
        b.cyl(x, y, (0, 0.02), 0.09, "metal_grey", "feet", n=12)
    for x in (-w * 0.36, -w * 0.14):
        b.rod((x, d * 0.47, 0.05), (x, d * 0.47, h * 0.95), 0.02, "paint_yellow", "ladder", 8)
    for k in range(9):
        z = h * (0.1 + 0.09 * k)
        b.rod((-w * 0.36, d * 0.47, z), (-w * 0.14, d * 0.47, z), 0.014, "paint_yellow", "ladder", 6)
    b.rod((w * 0.16, d * 0.44, low + 0.05), (w * 0.16, d * 0.44, high - 0.1), 0.03, "glass_blue", "gauge", 10)
    b.rod(
        (w * 0.16, d * 0.43, low + 0.05), (w * 0.16, d * 0.43, (low + high) / 2), 0.025, "plastic_3d6a9e", "gauge", 10
    )
    b.path(
        [(0, 0, h * 0.18), (0, 0, h * 0.09), (0, d * 0.42, h * 0.09), (0, d * 0.42, h * 0.04)],
        0.045,
        "metal_steel",
        "outlet",
    )
    b.rod((0, d * 0.3, h * 0.09), (0, d * 0.3, h * 0.15), 0.015, "metal_dark", "tap", 8)
    b.rod((-0.1, d * 0.3, h * 0.15), (0.1, d * 0.3, h * 0.15), 0.02, "paint_red", "tap", 8)
    face = DrawnFace.front(b, d * 0.45)
    face.write("3000 L", (w * 0.0, w * 0.36), (high - 0.32, high - 0.2), "paint_blue", "letters", 0.006)


@recipe("tank")
def tank(b: Builder) -> None:
    """Upright boiler with pipes."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.42, 0.1), (0.5, 0.12), (0.5, h * 0.88), (0.3, h * 0.96)], b.mat(), stretch=(w, d), n=28)
    for k in range(3):
        a = k * 2.094
        b.cyl(math.cos(a) * w * 0.34, math.sin(a) * d * 0.34, (0, 0.12), 0.03, "metal_dark", "feet", n=8)
    for x, color in ((-0.1, "metal_copper"), (0.1, "metal_copper")):
        b.cyl(x, 0, (h * 0.9, h), 0.02, color, "pipes", n=10, solid=False)
    b.box((-0.1, 0.1), (d * 0.46, d * 0.5), (h * 0.35, h * 0.5), "plastic_grey", "panel", solid=False)


@recipe("pump")
def pump(b: Builder) -> None:
    """Motor and tank on a frame."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.08), "metal_dark", "frame")
    r = min(d * 0.42, h * 0.28)
    b.rod((-w * 0.46, 0, 0.1 + r), (w * 0.46, 0, 0.1 + r), r, b.mat(), "tank", 24, solid=True)
    b.rod((-w * 0.3, 0, h * 0.76), (w * 0.05, 0, h * 0.76), min(0.14, h * 0.18), "metal_grey", "motor", 18, solid=True)
    b.box((w * 0.1, w * 0.35), (-d * 0.2, d * 0.2), (h * 0.55, h * 0.85), b.mat(), "head")
    b.path(
        [(w * 0.22, 0, h * 0.8), (w * 0.22, 0, h - 0.03), (w * 0.45, 0, h - 0.03), (w * 0.45, 0, 0.3)],
        0.03,
        "metal_copper",
        "pipes",
    )
