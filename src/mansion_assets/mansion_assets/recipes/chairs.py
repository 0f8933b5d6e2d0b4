"""Chairs and stools: dining, office and lecture chairs, dentists' and barbers' recliners."""

import math
from typing import Any

from mansion_assets.builder import Box, Builder
from mansion_assets.catalogue.receptacles import Receptacle, inset, surface
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@receptacles("chair")
def _chair_seat(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    z = float(p.get("seat", min(0.46, h * 0.54)))
    return [surface("seat", (-w * 0.38, w * 0.38, -d * 0.26, d * 0.42), z, 0.6)]


@recipe("chair")
def chair(b: Builder) -> None:
    """Seat on four legs or a cantilever, with a back."""
    w, d, h = b.w, b.d, b.h
    seat = b.tops[0].z
    frame = b.mat("frame", b.mat())
    soft = b.mat().startswith(("fabric", "leather"))
    r = 0.011 if b.p.get("frame") else 0.019
    low = seat - (0.07 if soft else 0.035)
    style = b.p.get("frame", "legs")
    for sx in (-1, 1):
        x = sx * (w / 2 - r)
        back, front = -d / 2 + 0.05, d / 2 - 0.03
        if style == "cantilever":
            b.path([(x, back, r), (x, front, r), (x, front, seat * 0.95), (x, back, low)], r, frame)
        else:
            for y in (back, front):
                b.box((x - r, x + r), (y - r, y + r), (0, low), frame, "legs")
        b.box((x - r, x + r), (-d / 2, -d / 2 + 2 * r), (seat - 0.05, h - 0.03), frame, "frame")
    if soft:
        b.cushion((-w / 2 + 0.015, w / 2 - 0.015), (-d / 2 + 0.05, d / 2), (low, seat), b.mat(), "seat")
        b.cushion((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2, -d / 2 + 0.07), (seat + 0.1, h), b.mat(), "back")
    else:
        b.box((-w / 2, w / 2), (-d / 2 + 0.04, d / 2), (low, seat), b.mat(), "seat")
        b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2, -d / 2 + 0.025), (h - (h - seat) * 0.55, h), b.mat(), "back")
    if b.p.get("tablet"):
        b.box((w / 2 - 0.28, w / 2), (0.0, d / 2), (seat + 0.22, seat + 0.24), "wood_birch", "tablet", solid=False)


@receptacles("swivel_chair")
def _swivel_chair_seat(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    z = min(0.5, h * 0.5)
    return [surface("seat", (-w * 0.3, w * 0.3, -d * 0.22, d * 0.3), z, 0.6)]


@recipe("swivel_chair")
def swivel_chair(b: Builder) -> None:
    """Five-armed base, gas spring, upholstered seat and back, arm rests."""
    w, d, h = b.w, b.d, b.h
    seat = b.tops[0].z
    dark = "plastic_black"
    for k in range(5):
        angle = math.pi / 2 + k * 2 * math.pi / 5
        x, y = math.cos(angle) * (w / 2 - 0.035), math.sin(angle) * (d / 2 - 0.035)
        b.rod((0, 0, 0.1), (x, y, 0.065), 0.02, "metal_chrome", "base")
        b.rod((x - 0.012, y, 0.03), (x + 0.012, y, 0.03), 0.03, dark, "wheels", n=10)
    b.cyl(0, 0, (0.07, seat - 0.09), 0.03, "metal_chrome", "column")
    b.boxes.append(Box((0.0, 0.0, 0.05), (w * 0.8, d * 0.8, 0.09)))
    b.cushion((-w * 0.42, w * 0.42), (-d * 0.32, d * 0.44), (seat - 0.09, seat), b.mat(), "seat", n=12)
    b.box((-0.04, 0.04), (-d * 0.4, -d * 0.34), (seat - 0.06, seat + 0.16), dark, "bracket", solid=False)
    b.cushion((-w * 0.38, w * 0.38), (-d / 2, -d * 0.36), (seat + 0.1, h), b.mat(), "back", n=12)
    for sx in (-1, 1):
        x = sx * w * 0.47
        b.box((x - 0.03, x + 0.03), (-d * 0.22, d * 0.22), (seat + 0.19, seat + 0.22), dark, "arms")
        b.box((x - 0.015, x + 0.015), (-0.03, 0.03), (seat - 0.06, seat + 0.2), dark, "arms", solid=False)


@receptacles("stool", "footstool")
def _stool_seat(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    round_ = p.get("shape", "round") == "round"
    return [surface("seat", inset(size, 0.03), size[2], 0.6, round_=round_)]


@recipe("stool")
def stool(b: Builder) -> None:
    """Round, square or cushioned seat without a back."""
    w, d, h = b.w, b.d, b.h
    style, main = b.p.get("style", "legs"), b.mat()
    frame = b.mat("frame", "metal_black" if style in ("bar", "swivel") else main)
    thick = min(0.05, h * 0.15)
    if style == "drum":
        b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, h), main, "seat", 0.35, 20)
    elif b.p.get("shape") == "cushion":
        b.legs((0, h * 0.25), 0.025, "wood_walnut")
        b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.22, h), main, "seat", 0.3, 12)
    elif style in ("bar", "swivel"):
        b.cyl(0, 0, (0, 0.025), w * 0.45, frame, "base", n=24)
        b.cyl(0, 0, (0.02, h - thick), 0.028, "metal_chrome", "column")
        if style == "bar":
            b.lathe(
                [(w * 0.3, h * 0.3), (w * 0.32, h * 0.31), (w * 0.3, h * 0.325)],
                "metal_chrome",
                part="ring",
                solid=False,
            )
        b.cyl(0, 0, (h - thick - 0.02, h), w / 2, main, "seat", n=24)
    else:
        r = 0.02
        for sx in (-1, 1):
            for sy in (-1, 1):
                foot = (sx * (w / 2 - r), sy * (d / 2 - r), 0.0)
                b.rod(foot, (sx * w * 0.33, sy * d * 0.33, h - thick), r, frame, "legs")
        b.boxes.append(_leg_box(b, h - thick))
        if b.p.get("shape") == "rect":
            b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - thick, h), main, "seat")
        else:
            b.lathe([(0.48, h - thick), (0.5, h - thick / 2), (0.49, h)], main, stretch=(w, d), part="seat", n=24)


@recipe("footstool")
def footstool(b: Builder) -> None:
    """A low seat to step on or rest the feet on: two printed feet on a mat, on slanted legs with a rung."""
    w, d, h = b.w, b.d, b.h
    main, thick, mat = b.mat(), min(0.05, h * 0.2), 0.004
    frame = main if main.startswith("wood") else "wood_oak"
    r = min(w, d) * 0.07
    for sx in (-1, 1):
        for sy in (-1, 1):
            foot = (sx * (w / 2 - r), sy * (d / 2 - r), 0.0)
            b.rod(foot, (sx * w * 0.36, sy * d * 0.36, h - thick), r, frame, "legs", 10)
    rung = h * 0.3
    for sy in (-1, 1):
        b.rod((-w * 0.43, sy * d * 0.42, rung), (w * 0.43, sy * d * 0.42, rung), r * 0.7, frame, "rungs", 8)
    for sx in (-1, 1):
        b.rod((sx * w * 0.43, -d * 0.42, rung), (sx * w * 0.43, d * 0.42, rung), r * 0.7, frame, "rungs", 8)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - thick, h - mat), main, "seat")
    face = DrawnFace.top(b, h - mat)
    face.field((-w * 0.45, w * 0.45), (-d * 0.45, d * 0.45), "rubber_2f3f5f", "mat", mat * 0.6)
    for side in (-1, 1):
        _printed_foot(face, side * w * 0.21, side, min(w * 0.12, d * 0.11), mat)
    b.boxes.append(_leg_box(b, h - thick))


def _printed_foot(face: DrawnFace, u: float, side: int, r: float, thick: float) -> None:
    """The print of a bare foot: a heel, a sole and five toes, the largest on the inside."""
    color = "plastic_f5c518"
    face.disc(u, -r * 2.2, r * 0.95, color, "feet", thick, 16)
    face.field((u - r * 0.6, u + r * 0.6), (-r * 2.2, r * 0.6), color, "feet", thick)
    face.disc(u, r * 0.7, r * 1.15, color, "feet", thick, 18)
    for k in range(5):
        toe = (u - side * r * (1.0 - 0.52 * k), r * (2.75 - 0.16 * k * k * 0.6))
        face.disc(*toe, r * (0.42 - 0.05 * k), color, "feet", thick, 10)


def _leg_box(b: Builder, high: float) -> Box:
    return Box((0.0, 0.0, high / 2), (b.w * 0.9, b.d * 0.9, high))


@recipe("recliner")
def recliner(b: Builder) -> None:
    """A wide stuffed armchair that leans back, its foot rest swung out in front, with a lever at its side."""
    w, d, h = b.w, b.d, b.h
    main, seat, arm = b.mat(), h * 0.42, w * 0.2
    front = d * 0.17
    b.box((-w / 2 + arm, w / 2 - arm), (-d * 0.3, front), (0.06, seat - 0.12), main, "base")
    b.cushion((-w / 2 + arm, w / 2 - arm), (-d * 0.26, front + 0.02), (seat - 0.16, seat), main, "seat", 0.5)
    for side in (-1, 1):
        span = sorted((side * w / 2, side * (w / 2 - arm)))
        b.cushion((span[0], span[1]), (-d * 0.32, front), (0.05, seat + 0.1), main, "arms", 0.3)
        b.cushion((span[0], span[1]), (-d * 0.3, front + 0.03), (seat + 0.05, seat + 0.19), main, "arms", 0.8)
        for y in (-d * 0.26, front - 0.06):
            b.cyl(side * (w / 2 - arm / 2), y, (0, 0.07), 0.035, "wood_walnut", "feet", n=10)
    low, high = (-d * 0.2, seat - 0.06), (-d / 2 + 0.13, h - 0.08)
    half, rolls = w / 2 - arm * 0.8, 3
    b.prism([low, (low[0] + 0.1, seat), high, (high[0] - 0.12, high[1] - 0.04)], (-half, half), main, part="back")
    for k in range(rolls):
        share = (k + 0.55) / rolls
        y, z = low[0] + 0.08 + (high[0] - low[0] - 0.08) * share, seat + (high[1] - seat) * share
        tall = (h - seat) / rolls * 0.56
        top = min(h, z + tall)
        b.cushion((-half, half), (max(-d / 2, y - 0.13), y + 0.1), (z - tall, top), main, "back", 0.75, 10)
    rest = [(front, seat - 0.14), (front, seat - 0.04), (d / 2, seat - 0.0), (d / 2, seat - 0.12)]
    b.prism(rest, (-w / 2 + arm, w / 2 - arm), main, part="foot_rest")
    b.cushion((-w / 2 + arm, w / 2 - arm), (front + 0.06, d / 2), (seat - 0.12, seat + 0.05), main, "foot_rest", 0.6)
    for side in (-1, 1):
        x = side * (w / 2 - arm - 0.05)
        b.path(
            [(x, front - 0.05, 0.16), (x, d * 0.32, seat - 0.24), (x, d * 0.4, seat - 0.1)],
            0.016,
            "metal_dark",
            "links",
        )
    b.path([(w / 2 - 0.012, 0.0, seat - 0.1), (w / 2 - 0.012, d * 0.1, seat + 0.02)], 0.014, "metal_chrome", "lever")
    b.ball((w / 2 - 0.014, d * 0.1, seat + 0.02), (0.014, 0.03, 0.03), "plastic_26272b", "lever", 8)


@recipe("tablet_chair")
def tablet_chair(b: Builder) -> None:
    """A lecture chair: a shell on steel legs, and an arm with a small writing top, paper and a pencil."""
    w, d, h = b.w, b.d, b.h
    seat = b.tops[0].z
    x1 = w / 2 - 0.12
    middle = (x1 - w / 2) / 2
    b.cushion((-w / 2 + 0.02, x1), (-d / 2 + 0.1, d * 0.3), (seat - 0.04, seat), b.mat(), "seat", 0.5)
    b.prism(
        [(-d / 2 + 0.08, seat + 0.1), (-d / 2 + 0.12, seat + 0.1), (-d / 2 + 0.05, h), (-d / 2 + 0.01, h)],
        (-w / 2 + 0.02, x1),
        b.mat(),
        part="back",
    )
    _steel_legs(b, x1, seat)
    _writing_tablet(b, seat, x1, middle)


def _steel_legs(b: Builder, x1: float, seat: float) -> None:
    """Two frames of bent tube, and a rack below the seat."""
    w, d, h = b.w, b.d, b.h
    for x in (-w / 2 + 0.04, x1 - 0.02):
        b.path(
            [(x, d * 0.28, 0.012), (x, d * 0.24, seat - 0.03), (x, -d * 0.34, seat - 0.03), (x, -d * 0.44, 0.012)],
            0.012,
            "metal_chrome",
            "legs",
        )
        b.path(
            [(x, -d * 0.34, seat - 0.03), (x, -d / 2 + 0.06, seat + 0.12), (x, -d / 2 + 0.03, h - 0.06)],
            0.011,
            "metal_chrome",
            "legs",
        )
    b.rod((-w / 2 + 0.04, d * 0.1, 0.12), (x1 - 0.02, d * 0.1, 0.12), 0.008, "metal_chrome", "rack", 8)


def _writing_tablet(b: Builder, seat: float, x1: float, middle: float) -> None:
    """An arm with a small top, a sheet of paper and a pencil."""
    w, d = b.w, b.d
    z = seat + 0.24
    b.path(
        [(x1, -d * 0.2, seat - 0.03), (w / 2 - 0.05, -d * 0.2, z - 0.02), (w / 2 - 0.05, d * 0.3, z - 0.02)],
        0.016,
        "metal_chrome",
        "arm",
    )
    top = [
        (w / 2, -d * 0.2),
        (w / 2, d * 0.44),
        (w / 2 - 0.06, d / 2),
        (middle - 0.1, d / 2),
        (middle - 0.12, d * 0.24),
        (w / 2 - 0.16, d * 0.16),
        (w / 2 - 0.14, -d * 0.2),
    ]
    b.prism([top[k] for k in (0, 1, 5, 6)], (z, z + 0.022), "wood_birch", "z", "tablet")
    b.prism([top[k] for k in (1, 2, 3, 4, 5)], (z, z + 0.022), "wood_birch", "z", "tablet")
    b.box(
        (middle + 0.0, middle + 0.17), (d * 0.26, d * 0.46), (z + 0.022, z + 0.03), "paper_white", "paper", solid=False
    )
    b.rod((middle + 0.2, d * 0.26, z + 0.028), (middle + 0.24, d * 0.42, z + 0.028), 0.006, "paint_yellow", "pencil", 6)
