"""Machines that examine patients and keep them alive: scanners, ventilators, dialysis, anaesthesia, incubators."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("scanner")
def scanner(b: Builder) -> None:
    """Tomograph: ring with a bore, table to the front."""
    w, d, h = b.w, b.d, b.h
    deep = (-d / 2, -d / 2 + d * 0.42)
    r, cz, n = 0.38, h * 0.52, 24
    ring = [(r * math.cos(2 * math.pi * k / n), cz + r * math.sin(2 * math.pi * k / n)) for k in range(n)]
    for k in range(n):
        q = (k + 1) % n
        outer = [_to_box(ring[i], (0.0, cz), w / 2, 0.0, h) for i in (k, q)]
        b.prism([ring[k], outer[0], outer[1], ring[q]], deep, b.mat(), "y", "ring", solid=False)
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * 0.4))
        b.box((lo, hi), deep, (0, h), b.mat(), "case")
    b.box((-0.4, 0.4), deep, (0, cz - 0.4), b.mat(), "case")
    b.box((-0.4, 0.4), deep, (cz + 0.4, h), b.mat(), "case")
    b.box((-0.26, 0.26), (deep[1] + 0.2, d / 2 - 0.1), (0, cz - 0.26), "plastic_light", "table")
    b.box((-0.24, 0.24), (deep[0] + 0.3, d / 2), (cz - 0.26, cz - 0.2), "leather_blue", "table")
    b.cushion(
        (-0.16, 0.16), (deep[1] + 0.1, deep[1] + 0.4), (cz - 0.2, cz - 0.12), "fabric_white", "pillow", solid=False
    )
    b.box((w * 0.3, w * 0.42), (deep[1], deep[1] + 0.01), (h * 0.6, h * 0.72), "screen_blue", "panel", solid=False)


@recipe("mri_scanner")
def mri_scanner(b: Builder) -> None:
    """A long rounded magnet with a narrow lit tunnel, MRI on its front and side, and a table that runs in."""
    w, d, h = b.w, b.d, b.h
    front, middle, r, n = d * 0.14, h * 0.5, 0.36, 22
    turns = [math.tau * (k + 0.5) / n for k in range(n)]
    ring = [(r * math.cos(a), middle + r * math.sin(a)) for a in turns]
    shell = [
        (math.copysign(abs(math.cos(a)) ** 0.45, math.cos(a)), math.copysign(abs(math.sin(a)) ** 0.45, math.sin(a)))
        for a in turns
    ]
    outer = [(u * w / 2, middle + v * h / 2) for u, v in shell]
    lip = [(u * 1.22, middle + (v - middle) * 1.22) for u, v in ring]
    for k in range(n):
        q = (k + 1) % n
        b.prism([ring[k], outer[k], outer[q], ring[q]], (-d / 2, front), b.mat(), "y", "magnet")
        b.prism([ring[k], lip[k], lip[q], ring[q]], (front, front + 0.05), "plastic_4f8fd0", "y", "lip", solid=False)
        inner = [(u * 0.94, middle + (v - middle) * 0.94) for u, v in (ring[k], ring[q])]
        glow = [inner[0], ring[k], ring[q], inner[1]]
        for deep in (-0.28, -0.1):
            b.prism(glow, (d * deep, d * deep + 0.06), "light_bfe6ff", "y", "lamps", solid=False)
    top = middle - 0.2
    b.box((-0.26, 0.26), (front + 0.12, d / 2 - 0.12), (0, top - 0.08), "plastic_light", "table")
    b.box((-0.24, 0.24), (-d * 0.3, d / 2), (top - 0.08, top), "leather_blue", "table")
    b.cushion((-0.16, 0.16), (front + 0.06, front + 0.34), (top, top + 0.09), "fabric_white", "pillow", solid=False)
    DrawnFace.front(b, front).write(
        "MRI", (-w * 0.26, w * 0.26), (middle + 0.5, h * 0.95), "plastic_1f4f9e", "letters", 0.02
    )
    DrawnFace.side(b, w / 2 - 0.02).write(
        "MRI", (-d * 0.44, front - 0.1), (h * 0.34, h * 0.68), "plastic_1f4f9e", "letters", 0.02
    )


def _to_box(
    p: tuple[float, float], center: tuple[float, float], half: float, low: float, high: float
) -> tuple[float, float]:
    """Extend the ray from `center` through `p` to the case's outline."""
    dx, dz = p[0] - center[0], p[1] - center[1]
    limits = [half / abs(dx)] if abs(dx) > 1e-9 else []
    if abs(dz) > 1e-9:
        limits.append(((high if dz > 0 else low) - center[1]) / dz)
    t = min(limits)
    return center[0] + dx * t, center[1] + dz * t


@recipe("xray")
def xray(b: Builder) -> None:
    """Table with a tube on a column."""
    w, d, h = b.w, b.d, b.h
    b.box((-0.3, 0.3), (-d * 0.3, d * 0.3), (0.05, 0.7), b.mat(), "base")
    b.box((-w * 0.36, w * 0.36), (-d / 2, d / 2), (0.7, 0.78), "leather_black", "table")
    b.box((-w / 2, -w / 2 + 0.18), (-0.1, 0.1), (0, h), b.mat(), "column")
    b.box((-w / 2 + 0.1, 0.15), (-0.06, 0.06), (h - 0.35, h - 0.23), b.mat(), "arm")
    b.box((-0.15, 0.15), (-0.18, 0.18), (h - 0.5, h - 0.2), "metal_grey", "tube")
    b.prism(
        [(-0.12, h - 0.62), (0.12, h - 0.62), (0.08, h - 0.5), (-0.08, h - 0.5)],
        (-0.1, 0.1),
        "metal_dark",
        part="collimator",
    )
    b.box((w / 2 - 0.12, w / 2), (-0.3, 0.3), (0.0, 0.03), "metal_grey", "rail")


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
    _ultrasound_desk(b)
    _echo_monitor(b)
    _probes(b)


def _ultrasound_desk(b: Builder) -> None:
    """A sloping desk with keys, a track ball and two dials."""
    w, d, h = b.w, b.d, b.h
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


def _echo_monitor(b: Builder) -> None:
    """A monitor on an arm, with a fan of echoes on its screen."""
    w, d, h = b.w, b.d, b.h
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


def _probes(b: Builder) -> None:
    """Three probes in their rests at the side, with cables."""
    w, d, h = b.w, b.d, b.h
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
    _drawer_fronts(b)
    b.box((-w * 0.48, w * 0.48), (-d * 0.42, d * 0.4), (h * 0.5, h * 0.53), b.mat(), "desk")
    b.box((-w * 0.4, w * 0.4), (-d * 0.42, -d * 0.2), (h * 0.53, h * 0.84), b.mat(), "back")
    _vaporizers(b)
    _bellows(b)
    _flow_tubes(b)
    _monitors(b)
    _breathing_hoses(b)


def _drawer_fronts(b: Builder) -> None:
    """Three fronts of drawers with their grips."""
    w, d, h = b.w, b.d, b.h
    face = DrawnFace.front(b, d * 0.2)
    for k in range(3):
        v = 0.2 + k * h * 0.115
        face.field((-w * 0.36, w * 0.36), (v, v + h * 0.1), "plastic_light", "drawers", 0.012)
        face.field((-w * 0.1, w * 0.1), (v + h * 0.06, v + h * 0.075), "metal_grey", "drawers", 0.024)


def _vaporizers(b: Builder) -> None:
    """Two vaporizers in the colours of what they hold, with dials on them."""
    w, d, h = b.w, b.d, b.h
    for u, color in ((0.06, "plastic_yellow"), (0.24, "plastic_purple")):
        x = -w * u
        b.box((x - w * 0.07, x + w * 0.07), (-d * 0.2, -d * 0.02), (h * 0.56, h * 0.7), color, "vaporizers")
        b.cyl(x, -d * 0.11, (h * 0.7, h * 0.745), w * 0.06, "plastic_black", "dials", n=14)


def _bellows(b: Builder) -> None:
    """Folded bellows in a cylinder of glass."""
    w, d, h = b.w, b.d, b.h
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


def _flow_tubes(b: Builder) -> None:
    """Three lit tubes that show the flow of gases."""
    w, d, h = b.w, b.d, b.h
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


def _monitors(b: Builder) -> None:
    """Two monitors, each with three waves."""
    w, d, h = b.w, b.d, b.h
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


def _breathing_hoses(b: Builder) -> None:
    """Two blue hoses before the cart, and the black bag."""
    w, d, h = b.w, b.d, b.h
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
    _dialysis_screen(b)
    _blood_pumps(b, front)
    _blood_tubes(b, front)
    _canisters(b, front)
    _hung_bag(b)


def _dialysis_screen(b: Builder) -> None:
    """A black screen with a blue field and three coloured bars."""
    w, d, h = b.w, b.d, b.h
    face = DrawnFace.front(b, d * 0.1)
    face.field((-w * 0.35, w * 0.35), (h * 0.675, h * 0.85), "plastic_black", "screen", 0.004)
    face.field((-w * 0.31, 0.0), (h * 0.69, h * 0.84), "light_4f9bf0", "screen", 0.007)
    for k, color in enumerate(("light_red", "light_green", "light_yellow")):
        face.field((w * 0.05, w * 0.31), (h * (0.7 + 0.05 * k), h * (0.73 + 0.05 * k)), color, "screen", 0.007)


def _blood_pumps(b: Builder, front: float) -> None:
    """Two round pumps, one above the other, each with a tube in its track."""
    w, h = b.w, b.h
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


def _blood_tubes(b: Builder, front: float) -> None:
    """The filter at the side, and red and blue tubes from it through the pumps."""
    w, d, h = b.w, b.d, b.h
    x = -w * 0.44
    _blood_filter(b, x, front)
    red, blue, before = "paint_red", "plastic_3d6a9e", front + 0.05
    tubes = (
        (
            red,
            [
                (x, front, h * 0.62),
                (x + 0.02, front + 0.06, h * 0.66),
                (0.0, before, h * 0.62),
                (w * 0.04, before, h * 0.58),
            ],
        ),
        (
            blue,
            [
                (x, front, h * 0.3),
                (x + 0.02, front + 0.06, h * 0.25),
                (0.0, before, h * 0.3),
                (w * 0.04, before, h * 0.36),
            ],
        ),
        (red, [(w * 0.2, before, h * 0.55), (w * 0.26, front + 0.08, h * 0.3), (w * 0.3, d / 2 - 0.02, h * 0.2)]),
        (blue, [(w * 0.2, before, h * 0.39), (w * 0.22, front + 0.08, h * 0.26), (w * 0.24, d / 2 - 0.02, h * 0.17)]),
    )
    for color, points in tubes:
        b.path(points, 0.011, color, "tubes")


def _blood_filter(b: Builder, x: float, front: float) -> None:
    """A white tube at the side, with a blue and a red end."""
    w, h = b.w, b.h
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


def _canisters(b: Builder, front: float) -> None:
    """Two canisters before the body, with a red and a blue cap."""
    w, d = b.w, b.d
    for x, color in ((-w * 0.2, "paint_red"), (w * 0.12, "plastic_3d6a9e")):
        b.box((x - w * 0.13, x + w * 0.13), (front, d * 0.44), (0.16, 0.34), "plastic_white", "canisters")
        b.cyl(x, (front + d * 0.44) / 2, (0.34, 0.38), w * 0.06, color, "canisters", n=12)


def _hung_bag(b: Builder) -> None:
    """A bag of fluid on a bent pole."""
    w, d, h = b.w, b.d, b.h
    b.path(
        [(w * 0.4, -d * 0.2, h * 0.5), (w * 0.4, -d * 0.2, h - 0.02), (w * 0.24, -d * 0.2, h - 0.02)],
        0.012,
        "metal_chrome",
        "pole",
    )
    b.cushion((w * 0.16, w * 0.32), (-d * 0.24, -d * 0.16), (h * 0.87, h * 0.975), "glass_d9ecf2", "bag", 0.6)


@recipe("ventilator")
def ventilator(b: Builder) -> None:
    """A screen with curves of breath on a case with valves, on a trolley; two ribbed hoses meet in a mask in front."""
    w, d, h = b.w, b.d, b.h
    b.wheels(0.05, 0.07)
    b.box((-w * 0.46, w * 0.46), (-d * 0.46, d * 0.4), (0.08, 0.14), "plastic_grey", "base")
    b.box((-w * 0.1, w * 0.1), (-d * 0.3, -d * 0.1), (0.14, h * 0.52), "metal_light", "column")
    b.cushion((-w * 0.42, w * 0.42), (-d * 0.42, d * 0.2), (h * 0.5, h * 0.72), b.mat(), "case", 0.25)
    b.box((-w * 0.38, w * 0.38), (d * 0.2 - 0.003, d * 0.2 + 0.003), (h * 0.52, h * 0.56), "plastic_3a7bc8", "case")
    b.box((-w * 0.46, w * 0.46), (-d * 0.16, -d * 0.06), (h * 0.73, h), "plastic_dark", "screen")
    b.box(
        (-w * 0.42, w * 0.42), (-d * 0.06, -d * 0.055), (h * 0.745, h * 0.985), "plastic_black", "screen", solid=False
    )
    for k, color in enumerate(("light_e5b920", "light_green", "light_4f9bf0")):
        z = h * (0.93 - 0.07 * k)
        wave = (0.0, 0.035, 0.035, 0.006, 0.0)
        line = [(w * (-0.38 + 0.76 * j / 15), -d * 0.05, z + h * wave[j % 5]) for j in range(16)]
        b.path(line, w * 0.012, color, "curves")
    mask = (0.0, d * 0.4, h * 0.36)
    for side in (-1, 1):
        hose = [
            (side * w * 0.2, d * 0.2, h * 0.6),
            (side * w * 0.36, d * 0.38, h * 0.58),
            (side * w * 0.4, d * 0.46, h * 0.46),
            (side * w * 0.12, d * 0.46, h * 0.38),
            mask,
        ]
        b.path(hose, w * 0.045, ("plastic_4f9bf0", "plastic_white")[side > 0], "hoses")
        b.rod(hose[0], (hose[0][0], d * 0.26, h * 0.6), w * 0.07, "plastic_grey", "valves", 14)
    b.ball(mask, (w * 0.14, d * 0.08, h * 0.06), "plastic_4f9bf0", "mask", 12)
    b.ball((0, d * 0.45, h * 0.36), (w * 0.11, d * 0.05, h * 0.045), "plastic_white", "mask", 12)


@recipe("infant_incubator")
def infant_incubator(b: Builder) -> None:
    """A trolley with a clear, rounded hood over a baby on its mattress; round ports to reach in by, and a screen."""
    w, d, h = b.w, b.d, b.h
    base = float(b.p.get("base", h * 0.63))
    b.wheels(0.05, 0.1)
    b.box((-w * 0.44, w * 0.44), (-d * 0.4, d * 0.4), (0.1, 0.15), "plastic_grey", "base")
    b.box((-w * 0.12, w * 0.12), (-d * 0.2, d * 0.2), (0.15, base - 0.2), b.mat(), "column")
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (base - 0.22, base - 0.03), b.mat(), "case", 0.3)
    b.box(
        (-w * 0.2, w * 0.3),
        (d / 2 - 0.004, d / 2 + 0.002),
        (base - 0.18, base - 0.08),
        "screen_green",
        "screen",
        solid=False,
    )
    b.box((-w * 0.48, w * 0.48), (-d * 0.48, d * 0.48), (base - 0.03, base), "plastic_3a7bc8", "tray")
    b.box((-w * 0.4, w * 0.4), (-d * 0.38, d * 0.38), (base, base + 0.03), "fabric_white", "mattress")
    _baby(b, base + 0.03, w, d)
    _clear_hood(b, base)


def _clear_hood(b: Builder, base: float) -> None:
    """Clear panes with light edges over the tray at `base`, and two round ports in front."""
    w, d, h = b.w, b.d, b.h
    hood = [
        (-d * 0.47, base),
        (d * 0.47, base),
        (d * 0.47, h * 0.84),
        (d * 0.3, h),
        (-d * 0.3, h),
        (-d * 0.47, h * 0.84),
    ]
    for x in (-w * 0.47, w * 0.46):
        b.prism(hood, (x, x + w * 0.01), "glass_clear", part="hood")
    for (y0, z0), (y1, z1) in zip(hood[1:], [*hood[2:], hood[0]], strict=True):
        b.prism(
            [(y0, z0), (y1, z1), (y1 * 0.98, z1 - 0.004), (y0 * 0.98, z0)],
            (-w * 0.47, w * 0.47),
            "glass_clear",
            part="hood",
        )
        for x in (-w * 0.47, w * 0.47):
            b.rod((x, y0, z0), (x, y1, z1), 0.008, "plastic_light", "edges", 6)
    for x in (-w * 0.22, w * 0.22):
        turns = [
            (
                x + 0.085 * math.cos(k * math.pi / 8),
                d * 0.48,
                base + (h * 0.84 - base) * 0.5 + 0.085 * math.sin(k * math.pi / 8),
            )
            for k in range(17)
        ]
        b.path(turns, 0.012, "plastic_3a7bc8", "ports")


def _baby(b: Builder, z: float, w: float, d: float) -> None:
    b.cushion((-w * 0.12, w * 0.24), (-d * 0.13, d * 0.13), (z, z + 0.11), "fabric_pink", "blanket", 0.8)
    b.ball((-w * 0.22, 0, z + 0.06), (w * 0.085, d * 0.12, 0.065), "fabric_skin", "baby", 12)
    for side in (-1, 1):
        b.rod(
            (-w * 0.1, side * d * 0.1, z + 0.07),
            (-w * 0.18, side * d * 0.24, z + 0.04),
            0.022,
            "fabric_skin",
            "baby",
            8,
        )
