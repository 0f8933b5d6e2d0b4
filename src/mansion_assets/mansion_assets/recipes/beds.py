"""Beds: at home, bunks, cots, loungers, in hospitals, tables for massage, stretchers."""

import math
from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, surface
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


def _mattress(b: Builder, z: float, low: float, pillows: int, sheet: str, inset: float) -> None:
    """Mattress with its top at `z`, a cover from the chest down, and pillows at the head (-y)."""
    w, d = b.w, b.d
    x = (-w / 2 + inset, w / 2 - inset)
    b.cushion(x, (-d / 2 + 0.05, d / 2 - 0.03), (low, z - 0.004), "fabric_white", "mattress", 0.35, 12)
    b.box(
        (x[0] - 0.006, x[1] + 0.006),
        (-d / 2 + min(0.6, d * 0.3), d / 2 - 0.02),
        (z - 0.05, z),
        sheet,
        "cover",
        solid=False,
    )
    for k in range(pillows):
        width = (x[1] - x[0]) / pillows
        x0 = x[0] + k * width
        b.cushion(
            (x0 + 0.03, x0 + width - 0.03),
            (-d / 2 + 0.06, -d / 2 + min(0.45, d * 0.24)),
            (z - 0.02, z + 0.1),
            "fabric_white",
            "pillows",
            0.6,
            10,
        )


@receptacles("bed", "stretcher", "exam_table", "operating_table", "massage_table", "lounger")
def _mattresses(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    tiers = int(p.get("tiers", 2 if h > 1.5 else 1))
    low = min(0.52, h * 0.62) if h > 0.5 else h - min(0.1, h / 2)
    head, side = min(0.45, d * 0.22), 0.06
    box = (-w / 2 + side, w / 2 - side, -d / 2 + head + 0.06, d / 2 - 0.08)
    heights = [low] if tiers == 1 else [low, min(h - 0.3, low + 1.0)]
    return [surface("mattress", box, z, 0.6) for z in heights]


@recipe("bed")
def bed(b: Builder) -> None:
    """Frame, headboard, mattress, pillows; two tiers for bunks."""
    style = b.p.get("style")
    if style == "hospital":
        _hospital_bed(b)
        return
    if style == "crib":
        _crib(b)
        return
    w, d, h = b.w, b.d, b.h
    frame, z = b.mat("frame"), b.tops[0].z
    pillows = int(b.p.get("pillows", 2 if w > 1.25 else 1))
    if len(b.tops) > 1:
        b.legs((0, h), 0.03, frame, 0.0)
        for top in b.tops:
            b.box((-w / 2, w / 2), (-d / 2, d / 2), (top.z - 0.2, top.z - 0.14), frame, "frame")
            _mattress(b, top.z, top.z - 0.15, pillows, b.mat(), 0.05)
        high = b.tops[1].z
        b.box((w / 2 - 0.03, w / 2), (-d / 2, d / 2 - 0.5), (high + 0.1, high + 0.16), frame, "rail")
        for k in range(5):
            zk = 0.25 + k * (high - 0.3) / 4
            b.rod((w / 2 - 0.02, d / 2 - 0.4, zk), (w / 2 - 0.02, d / 2 - 0.06, zk), 0.015, frame, "steps")
        return
    b.legs((0, 0.12), 0.03, frame, 0.02)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0.1, max(0.16, z - 0.22)), frame, "frame")
    b.box((-w / 2, w / 2), (d / 2 - 0.04, d / 2), (0.1, min(z - 0.08, h)), frame, "foot")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.05), (0.0, h), frame, "head")
    _mattress(b, z, max(0.14, z - 0.25), pillows, b.mat(), 0.03)


def _hospital_bed(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    z, frame = b.tops[0].z, b.mat("frame", "metal_white")
    b.wheels(0.07, 0.1)
    b.box((-w / 2 + 0.1, w / 2 - 0.1), (-d / 2 + 0.15, d / 2 - 0.15), (0.14, 0.2), frame, "base")
    for y in (-d * 0.25, d * 0.25):
        b.box((-0.08, 0.08), (y - 0.06, y + 0.06), (0.18, z - 0.2), "metal_grey", "lift")
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.03, d / 2 - 0.03), (z - 0.22, z - 0.15), frame, "deck")
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2, -d / 2 + 0.035), (0.3, h), "wood_birch", "head")
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (d / 2 - 0.035, d / 2), (0.3, h - 0.12), "wood_birch", "foot")
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.012)
        for zr in (z + 0.08, z + 0.22):
            b.rod((x, -d * 0.32, zr), (x, d * 0.2, zr), 0.012, "metal_chrome", "rails")
        for y in (-d * 0.32, -d * 0.06, d * 0.2):
            b.rod((x, y, z - 0.1), (x, y, z + 0.22), 0.01, "metal_chrome", "rails")
    _mattress(b, z, z - 0.16, 1, b.mat(), 0.05)


def _crib(b: Builder) -> None:
    """Child's bed: mattress on a deck between barred sides."""
    w, d, h = b.w, b.d, b.h
    frame, z = b.mat("frame", "wood_white"), b.tops[0].z
    low = z - 0.12
    b.legs((0, h), 0.022, frame, 0.0)
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.02, d / 2 - 0.02), (low - 0.02, low), frame, "deck")
    b.cushion((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, d / 2 - 0.05), (low, z), "fabric_white", "mattress", 0.35)
    _crib_sides(b, low, frame)
    b.cushion((-w * 0.3, w * 0.3), (-d / 2 + 0.08, -d / 2 + 0.28), (z, z + 0.06), b.mat(), "pillows", 0.6)


def _crib_sides(b: Builder, low: float, frame: str) -> None:
    """Rails around the deck and around the rim, with bars between them."""
    w, d, h = b.w, b.d, b.h
    for z in (low, h - 0.03):
        for sx in (-1, 1):
            x = sx * (w / 2 - 0.015)
            b.box((x - 0.015, x + 0.015), (-d / 2, d / 2), (z, z + 0.03), frame, "rails")
        for sy in (-1, 1):
            y = sy * (d / 2 - 0.015)
            b.box((-w / 2, w / 2), (y - 0.015, y + 0.015), (z, z + 0.03), frame, "rails")
    for k in range(1, 10):
        y = -d / 2 + k * d / 10
        for sx in (-1, 1):
            x = sx * (w / 2 - 0.015)
            b.rod((x, y, low), (x, y, h - 0.02), 0.007, frame, "bars", 6)
    for k in range(1, 6):
        x = -w / 2 + k * w / 6
        for sy in (-1, 1):
            y = sy * (d / 2 - 0.015)
            b.rod((x, y, low), (x, y, h - 0.02), 0.007, frame, "bars", 6)


@recipe("stretcher")
def stretcher(b: Builder) -> None:
    """An ambulance's stretcher: a thin mattress with straps and a raised back rest on crossed legs with castors."""
    w, d = b.w, b.d
    z, yellow = b.tops[0].z, "paint_f2b90f"
    hip, side = b.tops[0].y0, w / 2 - 0.05
    for sx in (-1, 1):
        x = sx * side
        b.rod((x, -d / 2 + 0.02, z - 0.1), (x, d / 2 - 0.02, z - 0.1), 0.022, yellow, "frame")
        b.rod((x, -d * 0.4, 0.19), (x, d * 0.4, 0.19), 0.018, yellow, "frame")
        for start, end in ((-0.34, 0.34), (0.34, -0.34)):
            b.rod((x, d * start, 0.19), (x, d * end, z - 0.1), 0.02, b.mat("frame"), "legs")
        for y in (-d * 0.4, d * 0.4):
            b.rod((x, y, 0.19), (x, y, 0.09), 0.014, b.mat("frame"), "forks")
            b.rod((x - 0.02, y, 0.09), (x + 0.02, y, 0.09), 0.09, "rubber_black", "wheels", 16)
            b.rod((x - 0.022, y, 0.09), (x + 0.022, y, 0.09), 0.045, "metal_light", "wheels", 12)
    for y in (-d / 2 + 0.02, 0.0, d / 2 - 0.02):
        b.rod((-side, y, z - 0.1), (side, y, z - 0.1), 0.02, yellow, "frame")
    b.box((-w * 0.42, w * 0.42), (hip, d / 2 - 0.06), (z - 0.08, z), b.mat(), "mattress")
    _back_rest(b, hip, z)
    for y in (hip + 0.2, d * 0.08, d * 0.32):
        b.box(
            (-w * 0.44, w * 0.44), (y - 0.03, y + 0.03), (z - 0.09, z + 0.006), "fabric_e8501e", "straps", solid=False
        )
        b.box((-0.05, 0.05), (y - 0.04, y + 0.04), (z + 0.004, z + 0.014), "metal_chrome", "buckles", solid=False)
    _drop_rails(b, hip, z)


def _back_rest(b: Builder, hip: float, z: float) -> None:
    """The part of the mattress that is raised from the hip to the head, with a pillow and a strap."""
    w, d, h = b.w, b.d, b.h
    low, high = (hip, z), (-d / 2 + 0.09, h)
    long = math.dist(low, high)
    back, up = (
        (-(high[1] - low[1]) / long, (high[0] - low[0]) / long),
        ((high[0] - low[0]) / long, (high[1] - low[1]) / long),
    )

    def slab(v: tuple[float, float], out: tuple[float, float]) -> list[tuple[float, float]]:
        corners = ((v[0], out[0]), (v[1], out[0]), (v[1], out[1]), (v[0], out[1]))
        return [(low[0] + s * up[0] + t * back[0], low[1] + s * up[1] + t * back[1]) for s, t in corners]

    b.prism(slab((0.0, long * 0.985), (0.0, 0.08)), (-w * 0.42, w * 0.42), b.mat(), part="mattress")
    b.prism(slab((long * 0.6, long * 0.95), (-0.05, 0.0)), (-w * 0.3, w * 0.3), "fabric_white", part="pillow")
    b.prism(slab((long * 0.3, long * 0.42), (-0.008, 0.09)), (-w * 0.44, w * 0.44), "fabric_e8501e", part="straps")


def _drop_rails(b: Builder, hip: float, z: float) -> None:
    """Rails along the middle of both sides that fold down, and a bar to push at the foot."""
    w, d = b.w, b.d
    for sx in (-1, 1):
        x, ends = sx * (w / 2 - 0.012), (hip + 0.1, d * 0.24)
        hoop = [
            (x, ends[0], z - 0.1),
            (x, ends[0] + 0.08, z + 0.17),
            (x, ends[1] - 0.08, z + 0.17),
            (x, ends[1], z - 0.1),
        ]
        b.path(hoop, 0.012, "metal_chrome", "rails")
        b.rod((x, ends[0] + 0.04, z + 0.04), (x, ends[1] - 0.04, z + 0.04), 0.009, "metal_chrome", "rails")
        for k in (1, 2):
            y = ends[0] + k * (ends[1] - ends[0]) / 3
            b.rod((x, y, z - 0.1), (x, y, z + 0.17), 0.009, "metal_chrome", "rails")
    foot = d / 2 - 0.014
    bar = [
        (-w * 0.36, foot - 0.02, z - 0.1),
        (-w * 0.36, foot, z + 0.06),
        (w * 0.36, foot, z + 0.06),
        (w * 0.36, foot - 0.02, z - 0.1),
    ]
    b.path(bar, 0.014, "rubber_black", "push_bar")


@recipe("lounger")
def lounger(b: Builder) -> None:
    """A slatted bed for the garden with a raised back, two wheels at its head, and a striped cushion along it."""
    w, d, h = b.w, b.d, b.h
    top, frame = b.tops[0], b.mat("frame")
    z, hip = top.z, top.y0
    deck = z - 0.055
    for side in (-1, 1):
        rail = sorted((side * w / 2, side * (w / 2 - 0.045)))
        b.box((rail[0], rail[1]), (-d / 2 + 0.06, d / 2), (deck - 0.07, deck), frame, "frame")
        b.box((rail[0], rail[1]), (d / 2 - 0.3, d / 2 - 0.24), (0, deck - 0.07), frame, "legs")
        b.box((rail[0], rail[1]), (-d / 2 + 0.2, -d / 2 + 0.26), (0.06, deck - 0.07), frame, "legs")
        wheel = (side * (w / 2 - 0.004), side * (w / 2 - 0.05))
        b.rod((wheel[1], -d / 2 + 0.13, 0.13), (wheel[0], -d / 2 + 0.13, 0.13), 0.13, "rubber_black", "wheels", 24)
        b.rod((wheel[1], -d / 2 + 0.13, 0.13), (side * w / 2, -d / 2 + 0.13, 0.13), 0.07, "wood_birch", "wheels", 18)
    for k in range(12):
        y = hip + (d / 2 - hip) * (k + 0.5) / 12
        b.box((-w / 2 + 0.02, w / 2 - 0.02), (y - 0.035, y + 0.035), (deck, deck + 0.016), frame, "slats")
    head = (-d / 2, h - 0.05)
    board = [(hip, deck), (hip, deck + 0.016), (head[0], head[1]), (head[0], head[1] - 0.016)]
    b.prism(board, (-w / 2 + 0.02, w / 2 - 0.02), frame, part="back")
    b.rod((0, -d / 2 + 0.2, deck), (0, -d / 2 + 0.1, h - 0.09), 0.02, frame, "prop")
    stripes = 9
    for k in range(stripes):
        x0, x1 = (w * 0.88 * (j / stripes - 0.5) for j in (k, k + 1))
        color = (b.mat(), "fabric_1f6fc0" if b.mat() == "fabric_white" else "fabric_white")[k % 2]
        b.box((x0, x1), (hip, d / 2 - 0.03), (deck + 0.016, z), color, "cushion", solid=False)
        slope = [(hip, deck + 0.016), (hip, z), (head[0] + 0.02, h), (head[0] + 0.01, h - 0.05)]
        b.prism(slope, (x0, x1), color, part="cushion", solid=False)
