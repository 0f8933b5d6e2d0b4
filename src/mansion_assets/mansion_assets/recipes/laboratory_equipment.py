"""Benches, machines and glassware of laboratories."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("counter_bench")
def lab_bench(b: Builder) -> None:
    """A dark top over cabinets, flasks and bottles of reagents in an open bay between them, gas taps below its edge."""
    w, d, h = b.w, b.d, b.h
    top = "stone_black" if b.mat() == "plastic_white" else "plastic_light"
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.03, h), top, "top")
    count = max(2, round(w / 0.6))
    front, step = d / 2 - 0.06, (w - 0.06) / count
    for k in range(count):
        x = (-w / 2 + 0.03 + k * step, -w / 2 + 0.02 + (k + 1) * step)
        if k == count // 2:
            _reagent_bay(b, x, front)
        else:
            _bench_cabinet(b, x, front)
        _gas_tap(b, (x[0] + x[1]) / 2 + 0.1, front, ("plastic_f5c518", "plastic_2f8fe0", "plastic_e8382e")[k % 3])
    for sx in (-1, 1):
        x0 = sx * (w / 2 - 0.02)
        b.box((x0 - 0.02, x0 + 0.02), (-d / 2 + 0.02, d / 2 - 0.05), (0, h - 0.03), "metal_grey", "frame")
    _flask_sign(DrawnFace.side(b, w / 2), h * 0.5, min(d * 0.3, h * 0.26))


def _bench_cabinet(b: Builder, x: tuple[float, float], front: float) -> None:
    """A door and a drawer with their handles."""
    d, h = b.d, b.h
    b.box(x, (-d / 2 + 0.05, front), (0.08, h - 0.03), b.mat(), "cabinets")
    face = DrawnFace.front(b, front)
    middle = -(x[0] + x[1]) / 2
    for z0, z1 in ((0.1, h * 0.6), (h * 0.62, h - 0.1)):
        face.field((-x[1] + 0.01, -x[0] - 0.01), (z0, z1), b.mat(), "fronts", 0.015)
        face.field((middle - 0.06, middle + 0.06), (z1 - 0.05, z1 - 0.035), "metal_steel", "handles", 0.03)


def _reagent_bay(b: Builder, x: tuple[float, float], front: float) -> None:
    """Two shelves with conical flasks of coloured liquids, labelled bottles, and test tubes in a rack."""
    h = b.h
    back, shelf = front - 0.3, h * 0.5
    b.box(x, (back - 0.02, back), (0.08, h - 0.03), "plastic_e4eef4", "bay")
    for z in (0.1, shelf):
        b.box(x, (back, front - 0.01), (z - 0.02, z), "plastic_e4eef4", "bay")
    wide, y = x[1] - x[0], front - 0.13
    colors = ("plastic_2fb8e0", "plastic_e85fa8", "plastic_58c838", "plastic_f5a018")
    for k in range(3):
        px, r = x[0] + wide * (0.18 + 0.32 * k), min(wide * 0.14, 0.1)
        _conical_flask(b, (px, y, shelf), r, shelf * 0.62, colors[k])
    for k in range(2):
        px, r = x[0] + wide * (0.15 + 0.24 * k), wide * 0.09
        b.lathe(
            [(r, 0.1), (r, 0.1 + shelf * 0.42), (r * 0.4, 0.1 + shelf * 0.54)], "plastic_8a4a1a", (px, y), "bottles", 14
        )
        b.cyl(px, y, (0.1 + shelf * 0.54, 0.1 + shelf * 0.64), r * 0.5, "plastic_26272b", "bottles", n=12, solid=False)
        label = DrawnFace.front(b, y + r * 0.9)
        label.field(
            (-px - r * 0.7, -px + r * 0.7), (0.1 + shelf * 0.1, 0.1 + shelf * 0.32), "paper_white", "labels", r * 0.14
        )
    rack = (x[0] + wide * 0.52, x[1] - wide * 0.06)
    b.box(rack, (y - 0.03, y + 0.03), (0.1 + shelf * 0.34, 0.1 + shelf * 0.38), "wood_birch", "rack", solid=False)
    b.box(rack, (y - 0.03, y + 0.03), (0.1, 0.12), "wood_birch", "rack", solid=False)
    for k in range(4):
        px = rack[0] + (rack[1] - rack[0]) * (k + 0.5) / 4
        b.cyl(px, y, (0.12, 0.1 + shelf * 0.3), wide * 0.032, colors[k], "tubes", n=8, solid=False)
        b.cyl(px, y, (0.1 + shelf * 0.3, 0.1 + shelf * 0.5), wide * 0.032, "plastic_dff0f5", "tubes", n=8, solid=False)


def _conical_flask(b: Builder, at: tuple[float, float, float], r: float, tall: float, liquid: str) -> None:
    x, y, z = at
    b.lathe([(r, z), (r, z + tall * 0.06), (r * 0.52, z + tall * 0.5)], liquid, (x, y), "flasks", 16)
    neck = [(r * 0.52, z + tall * 0.5), (r * 0.3, z + tall * 0.72), (r * 0.3, z + tall * 0.96), (r * 0.4, z + tall)]
    b.lathe(neck, "plastic_dff0f5", (x, y), "flasks", 16)


def _gas_tap(b: Builder, x: float, front: float, color: str) -> None:
    """A tap with a wing handle below the edge of the top."""
    z = b.h - 0.065
    b.rod((x, front, z), (x, front + 0.04, z), 0.014, "metal_chrome", "taps", 10)
    b.box((x - 0.035, x + 0.035), (front + 0.03, front + 0.052), (z - 0.014, z + 0.014), color, "taps", solid=False)


def _flask_sign(face: DrawnFace, v: float, r: float) -> None:
    """The sign of a laboratory: a flask half full of something green that bubbles."""
    for k in range(12):
        low, high = v - r + r * 1.5 * k / 12, v - r + r * 1.5 * (k + 1) / 12
        half = r * (0.9 - 0.72 * k / 11)
        face.field((-half, half), (low, high), "plastic_26323f", "sign", 0.003)
        if k:
            inner = half - r * 0.1
            face.field((-inner, inner), (low, high), "plastic_58c838" if k < 6 else "plastic_eef6fa", "sign", 0.004)
    face.field((-r * 0.2, r * 0.2), (v + r * 0.5, v + r), "plastic_26323f", "sign", 0.003)
    face.field((-r * 0.1, r * 0.1), (v + r * 0.4, v + r), "plastic_eef6fa", "sign", 0.004)
    face.field((-r * 0.3, r * 0.3), (v + r * 0.95, v + r * 1.06), "plastic_26323f", "sign", 0.004)
    for u, up in ((-0.3, -0.6), (0.2, -0.35), (0.0, -0.75)):
        face.disc(r * u, v + r * up, r * 0.1, "plastic_eef6fa", "sign", 0.005, 10)


@recipe("fume_hood")
def fume_hood(b: Builder) -> None:
    """Cupboard, work chamber with a sash, duct."""
    w, d, h = b.w, b.d, b.h
    f = d / 2
    b.hollow((-w / 2, w / 2), (-d / 2, f - 0.06), (0.06, 0.84), 0.02, b.mat(), "cupboard")
    for k in range(2):
        x0 = -w / 2 + k * w / 2
        panel = ((x0 + 0.01, x0 + w / 2 - 0.01), (f - 0.059, f - 0.045), (0.1, 0.8))
        with b.door(*panel, "left" if k == 0 else "right"):
            b.box(*panel, b.mat(), "doors", solid=False)
    b.box((-w / 2, w / 2), (-d / 2, f), (0.84, 0.9), "stone_black", "top")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.06), (0.9, h), b.mat(), "back")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.1)))
        b.box((lo, hi), (-d / 2, f - 0.02), (0.9, h), b.mat(), "sides")
    b.box((-w / 2, w / 2), (-d / 2, f - 0.02), (h - 0.35, h), b.mat(), "head")
    b.box((-w / 2 + 0.1, w / 2 - 0.1), (f - 0.06, f - 0.05), (1.25, h - 0.3), "glass_clear", "sash", solid=False)
    b.box((-w / 2 + 0.1, w / 2 - 0.1), (f - 0.07, f - 0.03), (1.22, 1.26), "metal_steel", "sash", solid=False)
    b.box((-w * 0.3, -w * 0.1), (f - 0.021, f - 0.015), (h - 0.25, h - 0.12), "screen_green", "panel", solid=False)
    for k, color in enumerate(("glass_blue", "glass_green")):
        b.lathe(
            [(0.07, 0.9), (0.07, 0.92), (0.025, 1.03), (0.03, 1.08)],
            color,
            (-0.2 + 0.3 * k, -0.1),
            "flasks",
            12,
            solid=False,
        )


@recipe("centrifuge")
def centrifuge(b: Builder) -> None:
    """A floor centrifuge: a cabinet whose lid stands open over the rotor with its tubes, and a panel with figures."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.72
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0.05, top - 0.02), b.mat(), "case")
    b.legs((0, 0.05), 0.025, "metal_dark", 0.03)
    r = min(w * 0.42, d * 0.36)
    y = -d * 0.08
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (top - 0.02, top), "plastic_light", "case")
    b.cyl(0, y, (top, top + 0.006), r, "metal_dark", "bowl", n=28)
    b.lathe(
        [(r, top), (r * 1.06, top + 0.03), (r * 0.98, top + 0.03), (r * 0.96, top)], "metal_chrome", (0, y), "bowl", 28
    )
    b.cyl(0, y, (top, top + 0.03), r * 0.5, "metal_blue", "rotor", r * 0.3, n=18)
    b.cyl(0, y, (top + 0.03, top + 0.05), r * 0.12, "metal_steel", "rotor", n=12)
    for k in range(8):
        a = k * math.pi / 4
        inner = (math.cos(a) * r * 0.5, y + math.sin(a) * r * 0.5, top + 0.045)
        outer = (math.cos(a) * r * 0.86, y + math.sin(a) * r * 0.86, top + 0.015)
        b.rod(inner, outer, r * 0.11, "glass_white", "tubes", 8)
        b.rod(
            inner,
            (inner[0] * 0.86, y + (inner[1] - y) * 0.86, top + 0.055),
            r * 0.12,
            ("plastic_red", "plastic_purple")[k % 2],
            "tubes",
            8,
        )
    b.prism(
        [(-d / 2, top), (-d / 2 + 0.05, top), (-d / 2 + 0.02, h), (-d / 2 - 0.03, h)],
        (-w * 0.46, w * 0.46),
        b.mat(),
        part="lid",
    )
    lid = DrawnFace.sloped(b, (-d / 2 + 0.05, top), (-d / 2 + 0.02, h))
    lid.disc(0, (h - top) / 2, min(w * 0.3, (h - top) * 0.4), "plastic_dark", "lid", 0.012, 24)
    face = DrawnFace.front(b, d / 2)
    face.field((-w * 0.42, w * 0.42), (top * 0.7, top * 0.94), "plastic_dark", "panel", 0.006)
    face.write("4000", (-w * 0.36, w * 0.04), (top * 0.75, top * 0.9), "light_red", "figures", 0.009)
    face.write("RPM", (w * 0.08, w * 0.36), (top * 0.82, top * 0.9), "plastic_white", "figures", 0.009)
    for k, color in enumerate(("green", "red")):
        face.disc(w * (0.14 + 0.14 * k), top * 0.76, w * 0.035, f"plastic_{color}", "buttons", 0.014)


@recipe("warm_incubator")
def warm_incubator(b: Builder) -> None:
    """A laboratory incubator: a door of glass before racks of petri dishes with cultures, and 37.0 C lit above it."""
    w, d, h = b.w, b.d, b.h
    face, t = d / 2 - 0.05, 0.04
    high = b.cells[0].top if b.cells else h * 0.78
    low = b.cells[0].z if b.cells else 0.25
    b.hollow((-w / 2, w / 2), (-d / 2, face), (low - t, high + t), t, b.mat())
    b.box((-w / 2, w / 2), (-d / 2, face), (0.04, low - t), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d / 2, face), (high + t, h), b.mat(), "case")
    b.box((-w * 0.44, w * 0.44), (-d * 0.44, face - 0.04), (0, 0.04), "plastic_dark", "feet")
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, -d / 2 + t + 0.006), (low, high), "light_f2b880", "glow", solid=False)
    _culture_racks(b, low, high, t, face)
    _incubator_door(b, face, low, t, high)
    _incubator_panel(b, face, high, t)


def _culture_racks(b: Builder, low: float, high: float, t: float, face: float) -> None:
    """Three racks with stacks of petri dishes."""
    w = b.w
    rows = 3
    for k in range(rows):
        z = low + (high - low) * (0.04 + 0.32 * k)
        b.box((-w / 2 + t, w / 2 - t), (face - 0.1, face - 0.004), (z - 0.008, z), "metal_chrome", "racks", solid=False)
        for j in range(4):
            x = w * (-0.3 + 0.2 * j)
            for s in range(2 + (j + k) % 2):
                b.cyl(
                    x,
                    face - 0.06,
                    (z + 0.026 * s, z + 0.026 * s + 0.012),
                    0.048,
                    ("food_e8604f", "food_f2c94c", "food_8fbf6a")[(j + k + s) % 3],
                    "dishes",
                    n=14,
                    solid=False,
                )
                b.cyl(
                    x,
                    face - 0.06,
                    (z + 0.026 * s + 0.012, z + 0.026 * s + 0.022),
                    0.052,
                    "plastic_eef4f6",
                    "dishes",
                    n=14,
                    solid=False,
                )


def _incubator_door(b: Builder, face: float, low: float, t: float, high: float) -> None:
    """A door of glass in a frame, with a handle."""
    w, d = b.w, b.d
    door = (face + 0.002, face + 0.026)
    panel = ((-w / 2 + 0.005, w / 2 - 0.005), door, (low - t, high + t * 0.8))
    with b.door(*panel, "left"):
        for across in ((panel[0][0], panel[0][0] + 0.05), (panel[0][1] - 0.05, panel[0][1])):
            b.box(across, door, panel[2], b.mat(), "door")
        for up in ((panel[2][0], panel[2][0] + 0.045), (panel[2][1] - 0.045, panel[2][1])):
            b.box(panel[0], door, up, b.mat(), "door")
        b.box(panel[0], (door[0] + 0.008, door[0] + 0.012), panel[2], "glass_clear", "window", solid=False)
        b.box((w * 0.42, w * 0.45), (door[1], d / 2), (low + 0.1, high - 0.1), "metal_dark", "handle", solid=False)


def _incubator_panel(b: Builder, face: float, high: float, t: float) -> None:
    """A black panel with the temperature in lit figures, and a green lamp."""
    w, h = b.w, b.h
    front = DrawnFace.front(b, face)
    front.field((-w * 0.36, w * 0.36), (high + t + 0.02, h - 0.02), "plastic_black", "panel", 0.006)
    front.write("37 C", (-w * 0.3, w * 0.14), (high + t + 0.035, h - 0.035), "light_red", "figures", 0.009)
    front.disc(w * 0.26, (high + t + h) / 2, 0.024, "plastic_green", "panel", 0.014)


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


@recipe("microscope")
def microscope(b: Builder) -> None:
    """Foot, arm, stage, tube."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.08), b.mat(), "foot")
    b.box((-w * 0.16, w * 0.16), (-d / 2, -d * 0.25), (h * 0.08, h * 0.75), b.mat(), "arm")
    b.box((-w * 0.36, w * 0.36), (-d * 0.25, d * 0.3), (h * 0.36, h * 0.4), "plastic_black", "stage")
    b.box((-w * 0.16, w * 0.16), (-d / 2, d * 0.15), (h * 0.66, h * 0.78), b.mat(), "head")
    b.cyl(0, d * 0.05, (h * 0.44, h * 0.66), w * 0.09, "metal_steel", "objective", n=12)
    b.rod((0, -d * 0.05, h * 0.75), (0, d * 0.3, h - w * 0.05), w * 0.08, "plastic_black", "tube", 12, solid=True)
    b.rod((-w * 0.3, -d * 0.38, h * 0.25), (w * 0.3, -d * 0.38, h * 0.25), h * 0.06, "plastic_black", "knobs", 14)


@recipe("bunsen_burner")
def bunsen_burner(b: Builder) -> None:
    """A tube with a collar on a round foot, a gas hose behind, and a blue flame."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.5, 0), (0.5, h * 0.05), (0.16, h * 0.12)], "metal_dark", n=24, stretch=(w, d), part="foot")
    b.cyl(0, 0, (h * 0.1, h * 0.62), w * 0.085, b.mat(), "tube")
    b.cyl(0, 0, (h * 0.18, h * 0.28), w * 0.13, "metal_steel", "collar")
    b.rod((0, 0, h * 0.13), (-w * 0.26, 0, h * 0.13), w * 0.04, b.mat(), "inlet")
    b.path(
        [(-w * 0.24, 0, h * 0.13), (-w * 0.36, 0, h * 0.12), (-w * 0.46, 0, h * 0.03)], w * 0.055, "rubber_red", "hose"
    )
    b.lathe(
        [(0.05, h * 0.62), (0.12, h * 0.72), (0.08, h * 0.86), (0.0, h)],
        "light_4f9bf0",
        n=12,
        stretch=(w, d),
        part="flame",
    )
    b.lathe([(0.02, h * 0.62), (0.13, h * 0.7), (0.03, h * 0.78)], "light_1d5fd0", n=12, stretch=(w, d), part="flame")


@recipe("beaker")
def beaker(b: Builder) -> None:
    """A straight glass with a rim and a scale, half full."""
    w, d, h = b.w, b.d, b.h
    b.lathe(
        [(0.44, 0), (0.46, h * 0.03), (0.46, h * 0.94), (0.5, h), (0.46, h), (0.43, h * 0.05)],
        b.mat(),
        n=24,
        stretch=(w, d),
    )
    b.lathe([(0.43, h * 0.03), (0.43, h * 0.5)], "plastic_3f9fd0", n=24, stretch=(w, d), part="liquid", solid=False)
    for side in (-1, 1):
        for k in range(5):
            z, wide = h * (0.2 + 0.14 * k), w * (0.12 if k % 2 else 0.2)
            b.box(
                (-wide, wide),
                (side * d * 0.47 - 0.001, side * d * 0.47 + 0.001),
                (z, z + h * 0.02),
                "plastic_white",
                "scale",
                solid=False,
            )
    b.lathe([(0.46, h * 0.95), (0.5, h), (0.46, h)], "glass_white", n=24, stretch=(w, d), part="rim", solid=False)


@recipe("petri_dish")
def petri_dish(b: Builder) -> None:
    """A shallow dish of agar with colonies, its lid aside and leaning on the rim."""
    h = b.h
    b.lathe([(0.46, 0), (0.5, h * 0.1), (0.5, h), (0.46, h), (0.46, h * 0.3)], "glass_white", n=32, stretch=(b.w, b.d))
    b.lathe([(0.46, h * 0.2), (0.46, h * 0.6)], "food_c8605a", n=32, stretch=(b.w, b.d), part="agar", solid=False)
    colonies = ((-0.2, 0.1, 0.07), (0.1, 0.22, 0.05), (0.24, -0.06, 0.08), (-0.06, -0.22, 0.06), (0.02, 0.02, 0.04))
    for x, y, r in (*colonies, (-0.3, -0.14, 0.04), (0.14, -0.3, 0.03), (-0.12, 0.32, 0.04), (0.34, 0.14, 0.03)):
        b.cyl(x * b.w, y * b.d, (h * 0.6, h * 0.75), r * b.w, "food_f1e6b0", "colonies", solid=False)


@recipe("tube_rack")
def tube_rack(b: Builder) -> None:
    """Stand with test tubes."""
    w, d, h = b.w, b.d, b.h
    for z in (0.0, h * 0.55):
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (z, z + h * 0.08), b.mat(), "rack")
    for sx in (-1, 1):
        b.box(
            (sx * w / 2 - (0.01 if sx > 0 else 0), sx * w / 2 + (0.01 if sx < 0 else 0)),
            (-d / 2, d / 2),
            (0, h * 0.6),
            b.mat(),
            "rack",
        )
    for k in range(6):
        x = -w * 0.38 + k * w * 0.152
        b.cyl(x, 0, (h * 0.1, h), w * 0.04, "glass_clear", "tubes", n=8, solid=False)
        b.cyl(
            x,
            0,
            (h * 0.1, h * (0.4 + 0.05 * (k % 3))),
            w * 0.034,
            ("glass_red", "glass_blue", "glass_green")[k % 3],
            "fluid",
            n=8,
            solid=False,
        )


@recipe("pipette")
def pipette(b: Builder) -> None:
    """A micropipette: a blue handle with a plunger button, a finger hook and a window, and a long, thin white tip."""
    w, d, h = b.w, b.d, b.h
    z = h / 2
    b.rod((0, -d / 2, z), (0, -d * 0.46, z), w * 0.3, "plastic_red", "button", 14)
    b.rod((0, -d * 0.46, z), (0, -d * 0.36, z), w * 0.1, "metal_chrome", "plunger")
    b.cushion((-w * 0.36, w * 0.36), (-d * 0.38, d * 0.02), (0, h), b.mat(), "handle", 0.5)
    b.box((w * 0.2, w / 2), (-d * 0.36, -d * 0.31), (z - h * 0.2, z + h * 0.2), b.mat(), "hook")
    b.box((-w * 0.16, w * 0.16), (-d * 0.2, -d * 0.06), (h * 0.98, h * 1.02), "plastic_white", "window", solid=False)
    for k, r in enumerate((0.22, 0.17, 0.12)):
        b.rod((0, d * (0.02 + 0.09 * k), z), (0, d * (0.11 + 0.09 * k), z), w * r, "plastic_light", "shaft", 12)
    b.rod((0, d * 0.28, z), (0, d * 0.4, z), w * 0.1, "plastic_e5b920", "tip", 10)
    b.rod((0, d * 0.4, z), (0, d / 2, z), w * 0.045, "plastic_e5b920", "tip", 8)


@recipe("lens_goggles")
def lens_goggles(b: Builder) -> None:
    """Safety spectacles: a frame with two clear lenses parted by a bridge, shields at the sides, and arms."""
    w, d, h = b.w, b.d, b.h
    y = d * 0.4
    b.box((-w / 2, w / 2), (y - d * 0.08, y), (h * 0.86, h), b.mat(), "frame")
    for side in (-1, 1):
        lens = [
            (side * w * 0.06, h * 0.2),
            (side * w * 0.12, 0.0),
            (side * w * 0.42, 0.0),
            (side * w * 0.49, h * 0.26),
            (side * w * 0.49, h * 0.9),
            (side * w * 0.05, h * 0.9),
        ]
        b.prism(lens, (y - d * 0.06, y - d * 0.03), "plastic_bfe3f0", "y", "lenses")
        face, rim = DrawnFace.front(b, y), [(-u, v) for u, v in [*lens, lens[0]]]
        face.line(rim, h * 0.05, b.mat(), "frame", -d * 0.04)
        face.line(
            [(-side * w * 0.18 - w * 0.06, h * 0.3), (-side * w * 0.18 + w * 0.1, h * 0.74)],
            h * 0.035,
            "plastic_white",
            "gleam",
            -d * 0.02,
        )
        across = sorted((side * w / 2, side * w * 0.475))
        b.prism(
            [(y, h * 0.3), (y, h * 0.96), (d * 0.1, h * 0.86), (d * 0.1, h * 0.5)],
            (across[0], across[1]),
            "plastic_bfe3f0",
            part="shields",
        )
        arm = [
            (side * w * 0.49, y, h * 0.92),
            (side * w * 0.49, -d * 0.3, h * 0.86),
            (side * w * 0.46, -d / 2, h * 0.07),
        ]
        b.path(arm, h * 0.07, b.mat(), "arms")
    b.path(
        [(-w * 0.06, y - d * 0.03, h * 0.5), (0, y, h * 0.6), (w * 0.06, y - d * 0.03, h * 0.5)],
        h * 0.06,
        b.mat(),
        "bridge",
    )
