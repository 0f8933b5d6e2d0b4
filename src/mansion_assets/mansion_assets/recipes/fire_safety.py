"""Fire safety: smoke detectors, sprinklers, alarms, extinguishers, hose cabinets."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("smoke_detector")
def smoke_detector(b: Builder) -> None:
    """A white dish with a ring of slits for smoke between two rims, a test button and a red lamp."""
    w, h = b.w, b.h
    r = w / 2
    b.lathe([(r * 0.96, h * 0.62), (r, h * 0.7), (r, h)], b.mat(), part="base", n=28)
    b.lathe([(r * 0.78, h * 0.28), (r * 0.78, h * 0.64)], "plastic_black", part="chamber", n=28)
    for k in range(16):
        a = k * math.pi / 8
        x, y = math.cos(a) * r * 0.82, math.sin(a) * r * 0.82
        b.cyl(x, y, (h * 0.26, h * 0.64), r * 0.05, b.mat(), "ribs", n=6)
    b.lathe([(r * 0.6, 0.06 * h), (r * 0.86, h * 0.14), (r * 0.86, h * 0.3)], b.mat(), part="cap", n=28)
    b.cyl(0, 0, (0, h * 0.1), r * 0.24, "plastic_grey", "button", n=18)
    b.ball((r * 0.5, r * 0.28, h * 0.09), (r * 0.08, r * 0.08, h * 0.06), "light_red", "lamp", 8)


@recipe("sprinkler")
def sprinkler(b: Builder) -> None:
    """A cover plate, a threaded neck, a frame of two arms about a red bulb, and a toothed plate that spreads water."""
    w, h = b.w, b.h
    r = w / 2
    b.lathe([(r * 0.8, h), (r, h * 0.96), (r * 0.9, h * 0.9)][::-1], "plastic_white", part="cover", n=24)
    b.cyl(0, 0, (h * 0.66, h * 0.92), r * 0.3, "metal_brass", "neck", n=12)
    for side in (-1, 1):
        arm = [(side * r * 0.28, 0, h * 0.7), (side * r * 0.5, 0, h * 0.45), (side * r * 0.12, 0, h * 0.12)]
        b.path(arm, r * 0.09, "metal_brass", "frame")
    b.cyl(0, 0, (h * 0.18, h * 0.68), r * 0.12, "light_red", "bulb", n=10)
    b.cyl(0, 0, (h * 0.05, h * 0.13), r * 0.34, "metal_brass", "spreader", n=16)
    for k in range(10):
        a = k * math.pi / 5
        b.rod(
            (math.cos(a) * r * 0.3, math.sin(a) * r * 0.3, h * 0.09),
            (math.cos(a) * r * 0.62, math.sin(a) * r * 0.62, h * 0.03),
            r * 0.07,
            "metal_brass",
            "spreader",
            5,
        )
    b.cyl(0, 0, (0, h * 0.06), r * 0.1, "metal_brass", "screw", n=8)


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


@recipe("extinguisher")
def extinguisher(b: Builder) -> None:
    """Red bottle with valve and hose."""
    w, d, h = b.w, b.d, b.h
    r = min(w, d) * 0.42
    b.lathe([(r * 0.9, 0), (r, 0.02), (r, h * 0.72), (r * 0.4, h * 0.82)], b.mat(), (0, 0), "bottle", 20)
    b.cyl(0, 0, (h * 0.8, h * 0.9), 0.02, "metal_dark", "valve")
    b.box((-0.012, 0.012), (-0.02, d / 2), (h * 0.88, h), "plastic_black", "lever")
    b.path(
        [(0, 0.02, h * 0.86), (w / 2 - 0.012, 0.02, h * 0.7), (w / 2 - 0.012, 0.02, h * 0.2)],
        0.012,
        "rubber_black",
        "hose",
    )
    b.box((-w / 2, w * 0.1), (-d / 2, -r * 0.9), (h * 0.3, h * 0.5), "metal_steel", "bracket")
    b.lathe([(r * 1.004, h * 0.3), (r * 1.004, h * 0.55)], "paper_white", (0, 0), "label", 20, solid=False)


@recipe("hose_cabinet")
def hose_cabinet(b: Builder) -> None:
    """A red case with a door of glass before a reel of red hose with its nozzle, and the word FIRE above it."""
    w, d, h = b.w, b.d, b.h
    front, t = d / 2 - 0.02, 0.02
    b.hollow((-w / 2, w / 2), (-d / 2, front), (0, h), t, b.mat())
    b.rod((0, -d / 2 + t, h * 0.44), (0, -d * 0.3, h * 0.44), h * 0.33, "metal_dark", "reel", 28)
    for k, share in enumerate((0.32, 0.265, 0.21)):
        ring = [
            (math.cos(a) * h * share, -d * 0.12 + 0.01 * k, h * 0.44 + math.sin(a) * h * share)
            for a in (j * math.tau / 22 for j in range(23))
        ]
        b.path(ring, h * 0.03, ("fabric_d8483a", "fabric_e8c9a0", "fabric_d8483a")[k], "hose")
    b.rod((0, -d * 0.3, h * 0.44), (0, d * 0.12, h * 0.44), h * 0.12, "metal_light", "hub", 20)
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        b.rod(
            (0, d * 0.02, h * 0.44),
            (math.cos(a) * h * 0.32, d * 0.02, h * 0.44 + math.sin(a) * h * 0.32),
            0.012,
            "metal_light",
            "reel",
            8,
        )
    b.path(
        [(w * 0.3, -d * 0.1, h * 0.2), (w * 0.36, 0, h * 0.4), (w * 0.36, 0, h * 0.62)], 0.022, "fabric_d8483a", "hose"
    )
    b.rod((w * 0.36, 0, h * 0.6), (w * 0.36, 0, h * 0.76), 0.026, "metal_brass", "nozzle", 12)
    door = (front + 0.001, front + 0.014)
    panel = ((-w / 2, w / 2), door, (0.0, h))
    with b.door(*panel, "left"):
        for across in ((-w / 2, -w * 0.43), (w * 0.43, w / 2)):
            b.box(across, door, (0, h), b.mat(), "door")
        b.box((-w / 2, w / 2), door, (0, h * 0.07), b.mat(), "door")
        b.box((-w / 2, w / 2), door, (h * 0.8, h), b.mat(), "door")
        b.box(
            (-w * 0.43, w * 0.43), (door[0], door[0] + 0.004), (h * 0.07, h * 0.8), "glass_clear", "window", solid=False
        )
        face = DrawnFace.front(b, door[1])
        face.write("FIRE HOSE", (-w * 0.45, w * 0.45), (h * 0.83, h * 0.97), "plastic_white", "letters", 0.004)
        b.box((w * 0.44, w * 0.48), (door[1], d / 2), (h * 0.38, h * 0.5), "metal_chrome", "handle", solid=False)
