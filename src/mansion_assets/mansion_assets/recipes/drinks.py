"""Drinks told by what holds them: a can of cola, a bottle of beer, a jug of water."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("cola_can")
def cola_can(b: Builder) -> None:
    """A can with a narrow neck and foot of bare metal, COLA up its sides between white waves, and a tab on its lid."""
    w, d, h = b.w, b.d, b.h
    steel = "plastic_d9dcde"
    b.lathe([(0.36, 0.0), (0.42, h * 0.03), (0.46, h * 0.06)], steel, part="foot", n=28, stretch=(w, d))
    b.lathe([(0.46, h * 0.06), (0.5, h * 0.1), (0.5, h * 0.84), (0.44, h * 0.91)], b.mat(), n=28, stretch=(w, d))
    neck = [(0.44, h * 0.91), (0.39, h * 0.955), (0.42, h * 0.97), (0.42, h), (0.38, h), (0.37, h * 0.965)]
    b.lathe(neck, steel, part="neck", n=28, stretch=(w, d))
    lid = DrawnFace.top(b, h * 0.965)
    lid.disc(0.0, d * 0.17, w * 0.13, "plastic_3a3d42", "opening", h * 0.006, 16)
    lid.disc(0.0, -d * 0.12, w * 0.12, "plastic_9ba0a5", "tab", h * 0.022, 16)
    lid.disc(0.0, -d * 0.14, w * 0.06, "plastic_3a3d42", "tab", h * 0.026, 12)
    lid.field((-w * 0.07, w * 0.07), (-d * 0.08, d * 0.1), "plastic_9ba0a5", "tab", h * 0.022)
    for turn in range(4):
        _upright_name(b, math.radians(35 + 90 * turn))


def _upright_name(b: Builder, angle: float) -> None:
    """COLA from the bottom to the top of a can, with a wave before it, where the can faces in the direction `angle`."""
    w, h = b.w, b.h
    out = (math.cos(angle), math.sin(angle), 0.0)
    across = (out[1], -out[0], 0.0)
    chord = w * 0.15
    flat = math.sqrt((w * 0.5) ** 2 - chord**2)
    face = DrawnFace(b, (out[0] * flat, out[1] * flat, 0.0), (0.0, 0.0, 1.0), across)
    face.write("COLA", (h * 0.16, h * 0.8), (-chord, chord), "plastic_white", "letters", w * 0.5 - flat + 0.0006)


@recipe("beer_bottle")
def beer_bottle(b: Builder) -> None:
    """A brown bottle with a long neck, a toothed crown cap, golden foil, and labels that say BEER."""
    w, d, h = b.w, b.d, b.h
    brown = "plastic_5b2f10"
    shape = [
        (0.46, 0.0),
        (0.5, h * 0.02),
        (0.5, h * 0.5),
        (0.46, h * 0.57),
        (0.3, h * 0.66),
        (0.22, h * 0.74),
        (0.19, h * 0.93),
        (0.22, h * 0.94),
        (0.2, h * 0.965),
    ]
    b.lathe(shape, brown, n=24, stretch=(w, d))
    b.lathe([(0.31, h * 0.66), (0.226, h * 0.75), (0.21, h * 0.86)], "paper_d8a93a", part="foil", n=24, stretch=(w, d))
    b.lathe([(0.24, h * 0.955), (0.24, h * 0.985), (0.17, h)], "plastic_f0c030", part="cap", n=24, stretch=(w, d))
    for k in range(14):
        a = k * math.tau / 14
        foot = (math.cos(a) * w * 0.25, math.sin(a) * d * 0.25)
        b.rod((*foot, h * 0.95), (foot[0] * 0.9, foot[1] * 0.9, h * 0.99), w * 0.03, "plastic_f0c030", "cap", 5)
    b.lathe([(0.505, h * 0.12), (0.505, h * 0.46)], "paper_f3ead2", part="label", n=24, stretch=(w, d))
    for edge in (0.13, 0.42):
        b.lathe([(0.51, h * edge), (0.51, h * (edge + 0.03))], "paper_red", part="label", n=24, stretch=(w, d))
    for turn in range(3):
        a = math.radians(55 + 120 * turn)
        out = (math.cos(a), math.sin(a), 0.0)
        face = DrawnFace(b, (out[0] * w * 0.44, out[1] * d * 0.44, 0.0), (-out[1], out[0], 0.0), (0.0, 0.0, 1.0))
        face.write("BEER", (-w * 0.24, w * 0.24), (h * 0.2, h * 0.4), "paper_red", "letters", w * 0.072)


@recipe("water_jug")
def water_jug(b: Builder) -> None:
    """A glass jug with a spout and a handle, water in it, and slices of lemon and ice that float on the water."""
    w, d, h = b.w, b.d, b.h
    r, x = d / 2, w / 2 - d / 2
    level = h * 0.66
    at = (-x * 0.4, 0.0)
    inside = [(0.84 * r, h * 0.03), (0.94 * r, h * 0.2), (0.86 * r, h * 0.5), (0.76 * r, level)]
    b.lathe(inside, "plastic_6db8e6", at, "water", 24)
    outer = [(0.9 * r, 0.0), (r, h * 0.2), (0.9 * r, h * 0.52), (0.72 * r, h * 0.82), (0.86 * r, h * 0.97)]
    wall = [*outer, (0.82 * r, h * 0.97), (0.68 * r, h * 0.82), (0.8 * r, level)]
    b.lathe(wall, "glass_9fd0e8", at, "glass", 24)
    turns = [k * math.tau / 20 for k in range(21)]
    rim = [(at[0] + math.cos(a) * r * 0.85, math.sin(a) * r * 0.85, h * 0.965) for a in turns]
    b.path(rim, w * 0.022, "plastic_b9dcec", "rim")
    spout = [(at[0] - 0.7 * r, -0.4 * r), (at[0] - 0.7 * r, 0.4 * r), (-w / 2, 0.0)]
    b.prism(spout, (h * 0.93, h), "plastic_b9dcec", "z", "spout")
    grip = [
        (at[0] + 0.7 * r, 0.0, h * 0.86),
        (w / 2 - 0.01, 0.0, h * 0.88),
        (w / 2 - 0.009, 0.0, h * 0.7),
        (w / 2 - 0.02, 0.0, h * 0.42),
        (at[0] + 0.86 * r, 0.0, h * 0.32),
    ]
    b.path(grip, w * 0.055, "plastic_b9dcec", "handle")
    for k in range(3):
        a = k * 2.1 + 0.9
        spot = (at[0] + math.cos(a) * r * 0.38, math.sin(a) * r * 0.38)
        b.cyl(*spot, (level - h * 0.01, level + h * 0.015), r * 0.34, "plastic_f6d32d", "lemon", n=14, solid=False)
        b.cyl(*spot, (level, level + h * 0.02), r * 0.24, "plastic_fbf0a0", "lemon", n=14, solid=False)
