"""Equipment of wards and examination rooms: drips, monitors, gas rails, crash carts, scales."""

import math

from mansion_assets.builder import Box, Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.recipes.cabinets import cabinet
from mansion_assets.registry import recipe

__all__: list[str] = []


def _star(b: Builder, r: float) -> None:
    """Five feet on castors."""
    for k in range(5):
        a = math.pi / 2 + k * 2 * math.pi / 5
        x, y = math.cos(a) * (b.w / 2 - 0.03), math.sin(a) * (b.d / 2 - 0.03)
        b.rod((0, 0, 0.1), (x, y, 0.07), r, "metal_steel", "feet")
        b.ball((x, y, 0.03), (0.03, 0.03, 0.03), "rubber_black", "wheels", 8, solid=False)
    b.boxes.append(Box((0.0, 0.0, 0.05), (b.w * 0.8, b.d * 0.8, 0.1)))


@recipe("iv_stand")
def iv_stand(b: Builder) -> None:
    """Pole with hooks, a bag and a pump."""
    h = b.h
    _star(b, 0.013)
    b.cyl(0, 0, (0.05, h - 0.03), 0.013, b.mat(), "pole", n=10)
    b.path([(-0.14, 0, h), (-0.14, 0, h - 0.05), (0.14, 0, h - 0.05), (0.14, 0, h)], 0.007, b.mat(), "hooks")
    b.cushion((-0.19, -0.09), (-0.02, 0.02), (h - 0.34, h - 0.06), "glass_clear", "bag", 0.8, 8, solid=False)
    b.box((-0.07, 0.07), (0.01, 0.13), (h * 0.52, h * 0.64), "plastic_white", "pump")
    b.box((-0.05, 0.05), (0.13, 0.132), (h * 0.56, h * 0.62), "screen_green", "pump", solid=False)
    b.path([(-0.14, 0.02, h - 0.34), (-0.1, 0.06, h * 0.7), (-0.03, 0.08, h * 0.64)], 0.004, "glass_clear", "tube")


@recipe("patient_monitor")
def patient_monitor(b: Builder) -> None:
    """Monitor on a rolling stand with a basket."""
    w, _d, h = b.w, b.d, b.h
    _star(b, 0.018)
    b.cyl(0, 0, (0.05, h - 0.3), 0.02, "metal_steel", "pole", n=12)
    b.box((-w * 0.38, w * 0.38), (-0.08, 0.06), (h - 0.3, h), b.mat(), "monitor")
    b.box((-w * 0.33, w * 0.33), (0.06, 0.064), (h - 0.26, h - 0.04), "screen_dark", "monitor", solid=False)
    for k, color in enumerate(("light_green", "light_blue", "light_red")):
        z = h - 0.1 - k * 0.06
        b.path(
            [(-w * 0.3 + t * w * 0.08, 0.066, z + (0.02 if t % 3 == 1 else 0.0)) for t in range(7)],
            0.003,
            color,
            "curves",
        )
    b.box((-w * 0.25, w * 0.25), (0.0, 0.16), (h * 0.55, h * 0.63), "metal_steel", "basket")


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


@recipe("medicine_cart")
def medicine_cart(b: Builder) -> None:
    """A cabinet of drawers on castors: a capsule, the word MEDS and labels on its front, a green cross at its side."""
    cabinet(b)
    w, d, h = b.w, b.d, b.h
    rows = int(b.p["rows"])
    face = DrawnFace.front(b, d / 2 - 0.006)
    step = (h - 0.12) / rows
    for k in range(rows):
        v = 0.1 + step * (k + 0.5)
        with b.fixed_to(f"drawer_{k + 1}"):
            if k == rows - 1:
                _capsule(face, -w * 0.24, v - step * 0.05, step * 0.24)
            elif k == rows - 2:
                face.write("MEDS", (-w * 0.46, -w * 0.1), (v - step * 0.3, v + step * 0.3), "plastic_2f6fd0")
            else:
                face.field((-w * 0.4, -w * 0.18), (v - step * 0.16, v + step * 0.16), "plastic_2f6fd0", "labels", 0.004)
    side = DrawnFace.side(b, w / 2)
    side.field((-d * 0.09, d * 0.09), (h * 0.46, h * 0.9), "plastic_green", "cross", 0.004)
    side.field((-d * 0.26, d * 0.26), (h * 0.6, h * 0.76), "plastic_green", "cross", 0.004)


def _capsule(face: DrawnFace, u: float, v: float, r: float) -> None:
    """A capsule, half red and half yellow, four radii long."""
    for side, material in ((-1, "paint_red"), (1, "paint_yellow")):
        near, far = sorted((u, u + side * r * 1.4))
        face.field((near, far), (v - r, v + r), material, "capsule", 0.004)
        face.disc(u + side * r * 1.4, v, r, material, "capsule", 0.004)


@recipe("crash_cart")
def crash_cart(b: Builder) -> None:
    """A cabinet of drawers on castors with a heartbeat on its front, coloured labels, and a white cross at its side."""
    cabinet(b)
    w, d, h = b.w, b.d, b.h
    face = DrawnFace.front(b, d / 2 - 0.006)
    z, rise = 0.1 + (h - 0.12) * 0.9 + h * 0.02, h * 0.05
    beat = [
        (-w * 0.42, z),
        (-w * 0.1, z),
        (-w * 0.05, z + rise * 0.5),
        (0.0, z - rise),
        (w * 0.05, z + rise),
        (w * 0.1, z),
        (w * 0.42, z),
    ]
    rows = int(b.p["rows"])
    with b.fixed_to(f"drawer_{rows}"):
        face.line(beat, 0.008, "plastic_white", "sign", 0.006)
    for k, color in enumerate(("plastic_white", "paint_yellow", "plastic_4f9bd9", "plastic_green")):
        v = 0.1 + (h - 0.12) * (k + 0.5) / rows
        with b.fixed_to(f"drawer_{k + 1}"):
            face.field((w * 0.24, w * 0.42), (v - h * 0.025, v + h * 0.025), color, "labels", 0.004)
    side = DrawnFace.side(b, w / 2)
    side.field((-d * 0.08, d * 0.08), (h * 0.46, h * 0.9), "plastic_white", "cross", 0.004)
    side.field((-d * 0.24, d * 0.24), (h * 0.6, h * 0.76), "plastic_white", "cross", 0.004)


@recipe("gas_rail")
def gas_rail(b: Builder) -> None:
    """A rail over a bed: gas outlets marked O2, AIR and VAC, sockets, a flow meter with its bottle, a lamp."""
    w, d, h = b.w, b.d, b.h
    front = d * 0.1
    b.cushion((-w / 2, w / 2), (-d / 2, front), (h * 0.2, h), b.mat(), "rail", 0.3)
    face = DrawnFace.front(b, front)
    face.field((-w * 0.49, w * 0.49), (h * 0.84, h * 0.95), "light_fff6df", "lamp", 0.004)
    for u, text, color in (
        (-0.4, "O2", "plastic_white"),
        (-0.24, "AIR", "plastic_dark"),
        (-0.08, "VAC", "plastic_yellow"),
    ):
        face.disc(w * u, h * 0.46, h * 0.16, color, "outlets", 0.016)
        face.disc(w * u, h * 0.46, h * 0.07, "metal_brass", "outlets", 0.024)
        face.write(text, (w * u - w * 0.05, w * u + w * 0.05), (h * 0.66, h * 0.8), "plastic_2f3f8f", "letters", 0.003)
    for k in range(4):
        u = w * (0.06 + 0.08 * k)
        face.field(
            (u, u + w * 0.065), (h * 0.34, h * 0.62), "plastic_white" if k < 2 else "paint_red", "sockets", 0.006
        )
        for hole in (0.3, 0.7):
            face.disc(u + w * 0.065 * hole, h * 0.48, h * 0.025, "plastic_black", "sockets", 0.009, 8)
    face.disc(w * 0.44, h * 0.5, h * 0.14, "paint_red", "call", 0.008)
    face.disc(w * 0.44, h * 0.5, h * 0.07, "plastic_white", "call", 0.012)
    x = w * 0.4
    b.rod((x, front, h * 0.46), (x, d * 0.36, h * 0.46), 0.014, "metal_chrome", "meter", 10)
    b.cyl(x, d * 0.36, (h * 0.4, h * 0.9), 0.024, "glass_clear", "meter", n=12)
    b.ball((x, d * 0.36, h * 0.6), (0.016, 0.016, 0.016), "paint_red", "meter", 8)
    b.cyl(x, d * 0.36, (0, h * 0.36), 0.034, "glass_5aa9e6", "bottle", n=14)
    b.cyl(x, d * 0.36, (h * 0.34, h * 0.42), 0.036, "plastic_green", "bottle", n=14)


@recipe("film_viewer")
def film_viewer(b: Builder) -> None:
    """A lit box with clips along its top and two X-ray films of a chest: spine and ribs, white on black."""
    w, d, h = b.w, b.d, b.h
    face = d * 0.3
    b.box((-w / 2, w / 2), (-d / 2, face), (0, h), "metal_grey", "case")
    b.box(
        (-w * 0.47, w * 0.47), (face - 0.001, face + 0.003), (h * 0.05, h * 0.93), "light_white", "glass", solid=False
    )
    for x in (-w * 0.235, w * 0.235):
        half = w * 0.19
        film = (face + 0.003, face + 0.006)
        b.box((x - half, x + half), film, (h * 0.1, h * 0.9), "plastic_1a1f2c", "films", solid=False)
        y = face + 0.008
        b.rod((x, y, h * 0.14), (x, y, h * 0.86), half * 0.09, "light_d5dde8", "bones", 6)
        for k in range(6):
            z = h * (0.74 - 0.09 * k)
            for side in (-1, 1):
                rib = [
                    (x, y, z),
                    (x + side * half * 0.5, y, z + h * 0.03),
                    (x + side * half * 0.8, y, z - h * 0.03),
                    (x + side * half * 0.72, y, z - h * 0.09),
                ]
                b.path(rib, half * 0.05, "light_d5dde8", "bones")
        b.box((x - half * 0.3, x + half * 0.3), (face, d / 2), (h * 0.9, h * 0.96), "metal_steel", "clips", solid=False)


@recipe("height_scale")
def height_scale(b: Builder) -> None:
    """Scale with a measuring column."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.07), b.mat(), "platform")
    b.box((-w * 0.4, w * 0.4), (-d * 0.2, d * 0.45), (0.07, 0.075), "rubber_black", "mat", solid=False)
    b.box((-0.03, 0.03), (-d / 2, -d / 2 + 0.06), (0.07, h), b.mat(), "column")
    b.box((-0.12, 0.12), (-d / 2 + 0.04, -d / 2 + 0.1), (h * 0.6, h * 0.68), "plastic_white", "display")
    b.box((-0.1, 0.1), (-d / 2 + 0.1, -d / 2 + 0.103), (h * 0.61, h * 0.67), "screen_green", "display", solid=False)
    b.box((-0.05, 0.05), (-d / 2 + 0.05, 0.05), (h - 0.06, h - 0.04), "metal_steel", "slide", solid=False)
