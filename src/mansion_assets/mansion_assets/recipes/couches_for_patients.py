"""What patients lie on: an examination couch with its roll of paper, an operating table, a dentist's chair."""

import itertools
import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("exam_table")
def exam_table(b: Builder) -> None:
    """A padded couch on a cabinet of drawers, a roll of paper at its head whose end covers it, and a step."""
    w, d = b.w, b.d
    top = b.tops[0]
    z, hip = top.z, top.y0
    pad, main = z - 0.004, b.mat()
    low = pad - 0.11
    b.box((-w / 2 + 0.06, w / 2 - 0.06), (-d / 2 + 0.3, d / 2 - 0.28), (0.04, low), "wood_white", "cabinet")
    b.box((-w / 2 + 0.1, w / 2 - 0.1), (-d / 2 + 0.34, d / 2 - 0.32), (0, 0.04), "plastic_dark", "plinth")
    b.cushion((-w / 2, w / 2), (hip, d / 2 - 0.03), (low, pad), main, "pad", 0.4)
    head = (-d / 2 + 0.1, b.h - 0.12)
    rest = [(hip, low), (hip, pad), (head[0], head[1]), (head[0] - 0.05, head[1] - 0.09)]
    b.prism(rest, (-w / 2, w / 2), main, part="rest")
    half = w * 0.34
    b.box((-half, half), (hip, d / 2 - 0.03), (pad - 0.004, z), "paper_white", "paper", solid=False)
    b.box((-half, half), (d / 2 - 0.031, d / 2 - 0.026), (low - 0.16, z), "paper_white", "paper", solid=False)
    slope = [(hip, pad), (hip, z), (head[0], head[1] + 0.006), (head[0], head[1])]
    b.prism(slope, (-half, half), "paper_white", part="paper", solid=False)
    roll = (-d / 2 + 0.075, b.h - 0.075)
    b.rod((-half, *roll), (half, *roll), 0.075, "paper_white", "roll", 20)
    b.rod((-half - 0.05, *roll), (half + 0.05, *roll), 0.022, "wood_cork", "roll", 12)
    for x in (-half - 0.03, half + 0.03):
        b.rod((x, roll[0], roll[1]), (x, head[0], head[1] - 0.06), 0.012, "metal_chrome", "brackets")
    _couch_drawers(b, low)
    step = (d / 2 - 0.28, d / 2)
    b.box((-w * 0.3, w * 0.3), step, (0.14, 0.18), "rubber_black", "step")
    for x in (-w * 0.26, w * 0.26):
        b.box((x - 0.015, x + 0.015), step, (0, 0.14), "metal_chrome", "step")


def _couch_drawers(b: Builder, high: float) -> None:
    """Three fronts with grips along the side of a couch, and the cross of doctors."""
    w, d = b.w, b.d
    side = DrawnFace.side(b, w / 2 - 0.06)
    start, step = -d / 2 + 0.34, (d - 0.68) / 3
    for k in range(3):
        u = (start + k * step, start + (k + 1) * step - 0.03)
        side.field(u, (0.08, high - 0.03), "wood_e3e6ea", "drawers", 0.012)
        middle = (u[0] + u[1]) / 2
        if k == 2:
            for across, up in ((0.028, 0.09), (0.09, 0.028)):
                mid = high * 0.55
                side.field((middle - across, middle + across), (mid - up, mid + up), "plastic_2f9e5f", "cross", 0.016)
        else:
            side.field((middle - 0.09, middle + 0.09), (high - 0.1, high - 0.075), "metal_steel", "grips", 0.03)


@recipe("operating_table")
def operating_table(b: Builder) -> None:
    """Black pads in sections on a steel column, under a green sheet with an opening, and a lamp of many bulbs above."""
    w, d = b.w, b.d
    top = b.tops[0]
    z, pad = top.z, top.z - 0.006
    b.box((-w * 0.46, w * 0.46), (-d * 0.24, d * 0.2), (0, 0.09), "metal_steel", "base")
    for level in range(3):
        half = 0.15 - 0.02 * level
        step = (z - 0.22) / 3
        b.box(
            (-half, half),
            (-half * 1.3, half),
            (0.09 + step * level, 0.09 + step * (level + 1)),
            "metal_9ba0a5",
            "column",
        )
    b.box((-w * 0.44, w * 0.44), (-d / 2 + 0.1, d / 2), (z - 0.13, z - 0.09), "metal_steel", "deck")
    for x in (-w / 2 + 0.012, w / 2 - 0.012):
        b.rod((x, -d * 0.4, z - 0.1), (x, d / 2 - 0.02, z - 0.1), 0.012, "metal_chrome", "rails")
    parts = (-d / 2 + 0.04, -d * 0.28, d * 0.04, d * 0.28, d / 2)
    for y0, y1 in itertools.pairwise(parts):
        b.cushion((-w * 0.44, w * 0.44), (y0 + 0.008, y1 - 0.008), (z - 0.09, pad), b.mat(), "pads", 0.35)
    _surgical_sheet(b, z)
    b.lathe(
        [(0.08, pad), (0.13, pad + 0.03), (0.08, pad + 0.06), (0.05, pad + 0.03)],
        "plastic_4f9bd9",
        (0, -d * 0.4),
        "head_ring",
        18,
    )
    _surgical_lamp(b, z)


def _surgical_sheet(b: Builder, z: float) -> None:
    """A green sheet over the lower half, down at both sides, with a square opening."""
    w, d = b.w, b.d
    green, start, end = "fabric_1f8f6a", -d * 0.1, d / 2 - 0.06
    face = DrawnFace.top(b, z - 0.006)
    opening = (-d * 0.24, -d * 0.1)
    face.field((-w * 0.47, w * 0.47), (-end, opening[0]), green, "sheet", 0.005)
    face.field((-w * 0.47, w * 0.47), (opening[1], -start), green, "sheet", 0.005)
    for side in (-1, 1):
        across = sorted((side * w * 0.47, side * w * 0.16))
        face.field((across[0], across[1]), opening, green, "sheet", 0.005)
        edge = sorted((side * w * 0.465, side * w * 0.49))
        b.box((edge[0], edge[1]), (start, end), (z - 0.3, z - 0.001), green, "sheet", solid=False)
    face.field((-w * 0.16, w * 0.16), opening, "food_e3b48c", "skin", 0.003)


def _surgical_lamp(b: Builder, z: float) -> None:
    """A disc with seven lit bulbs and a handle on an arm at the head of the table."""
    w, d, h = b.w, b.d, b.h
    foot = (-w / 2 + 0.02, -d / 2 + 0.03)
    b.rod((*foot, z - 0.12), (*foot, h - 0.1), 0.016, "metal_white", "arm")
    r = 0.21
    middle = (0.0, -d * 0.36, h - r * 0.82 - 0.046)
    out = (0.0, 0.82, -0.57)
    b.rod((*foot, h - 0.1), (middle[0], middle[1] - 0.07, middle[2] + 0.05), 0.016, "metal_white", "arm")
    back = (middle[0], middle[1] - out[1] * 0.07, middle[2] - out[2] * 0.07)
    b.rod(back, middle, r, "plastic_e8eaec", "lamp", 24)
    face = DrawnFace(b, middle, (-1.0, 0.0, 0.0), (0.0, 0.57, 0.82))
    face.disc(0.0, 0.0, r * 0.92, "plastic_8fa3b0", "lamp", 0.004, 24)
    for k in range(6):
        a = k * math.pi / 3
        face.disc(math.cos(a) * r * 0.58, math.sin(a) * r * 0.58, r * 0.25, "light_fff6cf", "bulbs", 0.012, 14)
    face.disc(0.0, 0.0, r * 0.25, "light_fff6cf", "bulbs", 0.012, 14)
    b.rod(face.at(0.0, 0.0, 0.012), face.at(0.0, 0.0, 0.1), 0.014, "metal_chrome", "handle", 8)


@recipe("dental_chair")
def dental_chair(b: Builder) -> None:
    """A chair that leans far back, a lamp on an arm, a tray of drills on hoses, a bowl, a tooth on a screen."""
    w, d, h = b.w, b.d, b.h
    seat, half, main = h * 0.36, w * 0.24, b.mat()
    x = w * 0.02
    b.box((x - half, x + half), (-d * 0.2, d * 0.22), (0, 0.05), "metal_light", "base")
    b.box((x - half * 0.5, x + half * 0.5), (-d * 0.12, d * 0.12), (0.05, seat - 0.1), "plastic_e8eaec", "column")
    span = (x - half, x + half)
    b.cushion(span, (-d * 0.14, d * 0.16), (seat - 0.12, seat), main, "seat", 0.4)
    foot = [(d * 0.14, seat - 0.1), (d * 0.14, seat), (d / 2, seat - 0.1), (d / 2, seat - 0.18)]
    b.prism(foot, (x - half * 0.86, x + half * 0.86), main, part="foot")
    back = [(-d * 0.13, seat - 0.1), (-d * 0.1, seat + 0.01), (-d * 0.4, h * 0.66), (-d * 0.43, h * 0.6)]
    b.prism(back, (x - half * 0.9, x + half * 0.9), main, part="back")
    b.cushion((x - half * 0.5, x + half * 0.5), (-d / 2, -d * 0.38), (h * 0.6, h * 0.74), main, "head", 0.6)
    for side in (-1, 1):
        px = x + side * half * 1.08
        b.box((px - 0.03, px + 0.03), (-d * 0.1, d * 0.12), (seat + 0.13, seat + 0.17), "plastic_dark", "arms")
        b.rod((px, -d * 0.08, seat - 0.06), (px, -d * 0.06, seat + 0.13), 0.016, "metal_chrome", "arms")
    _dental_unit(b)
    _drill_tray(b, seat)


def _dental_unit(b: Builder) -> None:
    """The column beside the chair: a bowl with a tap, a screen that shows a tooth, and the arm with the lamp."""
    w, d, h = b.w, b.d, b.h
    x = (-w / 2, -w * 0.29)
    middle, front = (x[0] + x[1]) / 2, d * 0.06
    b.box(x, (-d * 0.08, front), (0, h * 0.46), "plastic_e8eaec", "unit")
    bowl = [(0.05, h * 0.46), (0.1, h * 0.52), (0.085, h * 0.52), (0.03, h * 0.48)]
    b.lathe(bowl, "ceramic_white", (middle, d * 0.01), "bowl", 18)
    b.path(
        [(middle, -d * 0.05, h * 0.46), (middle, -d * 0.05, h * 0.58), (middle, 0.0, h * 0.56)],
        0.01,
        "metal_chrome",
        "tap",
    )
    screen = (-w / 2, -w * 0.2)
    b.box(screen, (-d * 0.035, -d * 0.02), (h * 0.6, h * 0.8), "plastic_26272b", "monitor")
    face = DrawnFace.front(b, -d * 0.02)
    face.field((-screen[1] + 0.012, -screen[0] - 0.012), (h * 0.613, h * 0.787), "screen_16324f", "monitor")
    _tooth(face, -(screen[0] + screen[1]) / 2, h * 0.7, w * 0.085)
    elbow, lamp = (middle, -d * 0.02, h * 0.9), (w * 0.04, d * 0.04, h * 0.93)
    b.rod((middle, -d * 0.06, h * 0.46), elbow, 0.022, "metal_white", "arm")
    b.rod(elbow, lamp, 0.018, "metal_white", "arm")
    b.cushion((-w * 0.14, w * 0.22), (d * 0.0, d * 0.09), (h * 0.84, h), "plastic_e8eaec", "lamp", 0.4)
    face = DrawnFace.front(b, d * 0.09)
    face.field((-w * 0.19, w * 0.11), (h * 0.865, h * 0.975), "light_fff3b8", "lamp", 0.01)
    for u in (-w * 0.24, w * 0.16):
        face.line([(u, h * 0.86), (u, h * 0.98)], 0.014, "plastic_dark", "grips")


def _tooth(face: DrawnFace, u: float, v: float, r: float) -> None:
    """The sign of a tooth: a crown with two humps over two roots."""
    for side in (-1, 1):
        face.disc(u + side * r * 0.45, v + r * 0.4, r * 0.52, "screen_f4f8fc", "tooth", 0.006, 16)
        face.field(
            (u + side * r * 0.5 - r * 0.26, u + side * r * 0.5 + r * 0.26),
            (v - r, v + r * 0.4),
            "screen_f4f8fc",
            "tooth",
            0.006,
        )
    face.field((u - r * 0.7, u + r * 0.7), (v - r * 0.3, v + r * 0.6), "screen_f4f8fc", "tooth", 0.006)


def _drill_tray(b: Builder, seat: float) -> None:
    """A tray on an arm beside the patient, with mirrors and hooks on it, and drills on hoses along its edge."""
    w, d, h = b.w, b.d, b.h
    x, y, z = (w * 0.27, w / 2), (d * 0.04, d * 0.26), h * 0.58
    b.rod((w * 0.3, d * 0.02, seat - 0.1), (w * 0.36, d * 0.08, z), 0.018, "metal_white", "arm")
    b.box(x, y, (z, z + 0.02), "metal_chrome", "tray")
    for k in range(4):
        px = x[0] + (x[1] - x[0]) * (0.2 + 0.2 * k)
        b.rod((px, y[0] + 0.04, z + 0.026), (px, y[1] - 0.08, z + 0.026), 0.006, "metal_9ba0a5", "instruments", 6)
        b.ball((px, y[1] - 0.07, z + 0.028), (0.014, 0.014, 0.008), "metal_9ba0a5", "instruments", 8)
    for k in range(3):
        py = y[0] + (y[1] - y[0]) * (0.2 + 0.3 * k)
        color = ("plastic_1f8fc0", "plastic_38b04a", "plastic_e8382e")[k]
        b.rod((w / 2 - 0.012, py, z + 0.16), (w / 2 - 0.012, py, z - 0.02), 0.012, color, "drills", 8)
        hose = [
            (w / 2 - 0.012, py, z - 0.02),
            (w / 2 - 0.02, py, z - 0.2),
            (w * 0.4, py - 0.04, z - 0.26),
            (w * 0.32, d * 0.04, z - 0.12),
        ]
        b.path(hose, 0.007, "rubber_black", "hoses")


@recipe("massage_table")
def massage_table(b: Builder) -> None:
    """A padded top on folding legs with cables, a horseshoe for the face at its head, a towel and hot stones on it."""
    w, d = b.w, b.d
    top = b.tops[0]
    z, head = top.z - 0.002, top.y0 - 0.1
    low, hinge = z - 0.09, (head + d / 2) / 2
    b.box((-w / 2, w / 2), (head, d / 2), (low - 0.06, low), "wood_c8965a", "frame")
    b.cushion((-w / 2, w / 2), (head, hinge - 0.004), (low, z), b.mat(), "pad", 0.2)
    b.cushion((-w / 2, w / 2), (hinge + 0.004, d / 2), (low, z), b.mat(), "pad", 0.2)
    face = DrawnFace.top(b, z)
    face.field((-w * 0.42, w * 0.42), (-d * 0.44, -d * 0.14), "fabric_3fb0c8", "towel", 0.0012)
    for v in (-0.42, -0.18):
        face.field((-w * 0.42, w * 0.42), (d * v, d * (v + 0.02)), "fabric_white", "towel", 0.0016)
    for k in range(5):
        face.disc(0.0, d * (-0.06 + 0.055 * k), 0.042, "stone_2f3438", "stones", 0.002, 14)
    for y in (head + 0.08, d / 2 - 0.08):
        for side in (-1, 1):
            b.rod(
                (side * (w / 2 - 0.03), y, 0), (side * (w / 2 - 0.08), y, low - 0.05), 0.024, "wood_c8965a", "legs", 8
            )
        b.rod((-w / 2 + 0.05, y, low * 0.4), (w / 2 - 0.05, y, low * 0.4), 0.014, "wood_c8965a", "legs", 8)
    for side in (-1, 1):
        x = side * (w / 2 - 0.05)
        b.rod((x, head + 0.08, 0.06), (x, hinge, low - 0.05), 0.006, "metal_steel", "cables", 6)
        b.rod((x, d / 2 - 0.08, 0.06), (x, hinge, low - 0.05), 0.006, "metal_steel", "cables", 6)
    _face_rest(b, head, low)
    b.rod(
        (-w * 0.36, head + 0.11, z + 0.055),
        (w * 0.36, head + 0.11, z + 0.055),
        0.055,
        "fabric_white",
        "rolled_towel",
        18,
    )
    for x in (-w * 0.37, w * 0.36):
        b.rod(
            (x, head + 0.11, z + 0.055),
            (x + w * 0.012, head + 0.11, z + 0.055),
            0.03,
            "fabric_3fb0c8",
            "rolled_towel",
            14,
        )


def _face_rest(b: Builder, head: float, low: float) -> None:
    """A padded ring, open below, on two rods, tilted up."""
    r, middle = 0.15, (-b.d / 2 + head) / 2 + 0.01
    rise = (b.h - low - 0.16) / 2
    for k in range(15):
        a = math.radians(-50 + 20 * k)
        x, along = math.cos(a) * r, math.sin(a) * r
        b.ball(
            (x, middle - along * 0.86, b.h - 0.055 - rise * (1 - along / r) / 2),
            (0.062, 0.055, 0.055),
            b.mat(),
            "face_rest",
            8,
        )
    for x in (-0.1, 0.1):
        b.rod(
            (x, head + 0.02, low - 0.02), (x, middle + 0.08, b.h - 0.09 - rise * 0.7), 0.014, "metal_chrome", "rods", 8
        )
