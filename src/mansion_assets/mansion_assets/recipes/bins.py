"""Bins, baskets, sacks, and stands open at the top."""

import math
from typing import Any

from mansion_assets.builder import Box, Builder
from mansion_assets.catalogue.receptacles import Receptacle, inset, volume
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@receptacles("bin", "bowl", "laundry_hamper")
def _bin_inside(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    wall = min(0.03, 0.12 * min(w, d))
    shrink = 0.72 if p.get("shape", "round") == "round" else 0.9
    box = (-w / 2 * shrink + wall, w / 2 * shrink - wall, -d / 2 * shrink + wall, d / 2 * shrink - wall)
    return [volume("inside", box, min(0.02, h * 0.15), h * 0.92)]


@recipe("bin")
def bin_(b: Builder) -> None:
    """Open bin, round or rectangular, its wall thick enough to see into; lids where it has one."""
    w, d, h = b.w, b.d, b.h
    lid = b.p.get("lid")
    high = h - (0.06 if lid else 0.0)
    t = min(0.02, w * 0.06)
    if b.p.get("shape", "round") == "round":
        b.lathe([(0.4, 0), (0.5, high), (0.47, high), (0.37, 0.015)], b.mat(), stretch=(w, d), n=24, solid=False)
        _hollow(b, high, t, 0.92)
    else:
        _tapered_walls(b, high, t)
        _hollow(b, high, t, 1.0)
    if lid:
        _lid(b, high)
    if b.p.get("sign") == "compost":
        face = DrawnFace.front(b, d / 2)
        face.write("COMPOST", (-w * 0.42, w * 0.42), (h * 0.2, h * 0.36), "plastic_white", "letters", 0.004)
        leaf = [
            (0.0, h * 0.44),
            (w * 0.2, h * 0.56),
            (w * 0.16, h * 0.74),
            (0.0, h * 0.84),
            (-w * 0.16, h * 0.74),
            (-w * 0.2, h * 0.56),
        ]
        b.prism(leaf, (d / 2, d / 2 + 0.005), "leaf_8fd05a", "y", "sign")
        face.line([(0.0, h * 0.4), (0.0, h * 0.8)], w * 0.014, "leaf_3f7f3a", "sign", 0.005)
    if b.p.get("wheels"):
        _barrow(b, high)


def _barrow(b: Builder, high: float) -> None:
    """Two wheels and a handle behind, by which a bin is pulled, and the sign of what goes round on its front."""
    w, d = b.w, b.d
    for side in (-1, 1):
        b.rod((side * w * 0.38, -d * 0.4, 0.1), (side * w / 2, -d * 0.4, 0.1), 0.1, "rubber_black", "wheels", 18)
        b.rod((side * w / 2, -d * 0.4, 0.1), (side * (w / 2 + 0.004), -d * 0.4, 0.1), 0.05, "metal_light", "wheels", 14)
        b.rod(
            (side * w * 0.36, -d * 0.46, high - 0.06),
            (side * w * 0.36, -d / 2 - 0.05, high),
            0.02,
            b.mat(),
            "handle",
            8,
        )
    b.rod((-w * 0.36, -d / 2 - 0.05, high), (w * 0.36, -d / 2 - 0.05, high), 0.022, "rubber_black", "handle", 10)
    face = DrawnFace.front(b, d / 2)
    for k in range(3):
        a = math.radians(90 + 120 * k)
        arc = [(math.cos(a + t) * w * 0.2, high * 0.55 + math.sin(a + t) * w * 0.2) for t in (0.35, 0.9, 1.4, 1.75)]
        face.line(arc, w * 0.03, "plastic_white", "sign")
        tip = math.cos(a + 2.0) * w * 0.2, high * 0.55 + math.sin(a + 2.0) * w * 0.2
        face.line([arc[-1], tip], w * 0.05, "plastic_white", "sign")


def _lid(b: Builder, low: float) -> None:
    """A lid on a hinge at the back, ribbed, with a lip in front to lift it by."""
    w, d = b.w, b.d
    panel = ((-w / 2, w / 2), (-d / 2, d / 2), (low, b.h))
    with b.door(*panel, "back"):
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (low, low + 0.03), b.mat(), "lid", solid=False)
        slope = [(-d / 2, low + 0.03), (d * 0.4, low + 0.03), (d * 0.3, b.h), (-d * 0.42, b.h)]
        b.prism(slope, (-w * 0.42, w * 0.42), b.mat(), part="lid", solid=False)
        b.box(
            (-w * 0.2, w * 0.2), (d / 2 - 0.004, d / 2 + 0.02), (low, low + 0.024), "plastic_dark", "lid", solid=False
        )


def _tapered_walls(b: Builder, high: float, t: float) -> None:
    """Four walls `t` thick, narrower at the floor than at the rim."""
    w, d, main = b.w, b.d, b.mat()
    b.prism(
        [(-w * 0.45, 0), (w * 0.45, 0), (w / 2, high), (w / 2 - t, high), (-w / 2 + t, high), (-w / 2, high)],
        (-d / 2, -d / 2 + t),
        main,
        "y",
        solid=False,
    )
    b.prism([(-w * 0.45, 0), (w * 0.45, 0), (w / 2, high), (-w / 2, high)], (d / 2 - t, d / 2), main, "y", solid=False)
    for sx in (-1, 1):
        b.prism(
            [(sx * w * 0.45, 0), (sx * w / 2, high), (sx * (w / 2 - t), high), (sx * (w * 0.45 - t), 0)],
            (-d / 2, d / 2),
            main,
            "y",
            solid=False,
        )
    b.box((-w * 0.45, w * 0.45), (-d * 0.47, d * 0.47), (0, t), main, "floor", solid=False)


def _hollow(b: Builder, high: float, t: float, shrink: float) -> None:
    """Collision boxes of four walls and a floor, so that the inside stays free."""
    w, d = b.w, b.d
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2 * shrink, sx * (w / 2 * shrink - t)))
        b.boxes.append(_box((lo, hi), (-d / 2 * shrink, d / 2 * shrink), (0, high)))
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2 * shrink, sy * (d / 2 * shrink - t)))
        b.boxes.append(_box((-w / 2 * shrink, w / 2 * shrink), (lo, hi), (0, high)))
    b.boxes.append(_box((-w * 0.4, w * 0.4), (-d * 0.4, d * 0.4), (0, 0.015)))


def _box(x: tuple[float, float], y: tuple[float, float], z: tuple[float, float]) -> Box:
    center = ((x[0] + x[1]) / 2, (y[0] + y[1]) / 2, (z[0] + z[1]) / 2)
    return Box(center, (x[1] - x[0], y[1] - y[0], z[1] - z[0]))


@recipe("laundry_hamper")
def laundry_hamper(b: Builder) -> None:
    """A tall basket of coiled rope with a shirt and a sock that hang over its rim, and LAUNDRY on a band of cloth."""
    w, d, h = b.w, b.d, b.h
    main, t = b.mat(), min(0.012, w * 0.03)
    wide = h * 0.036
    x, y, high = w / 2 - wide, d / 2 - wide, h - 0.012
    dark = "fabric_c2aa7c" if main == "fabric_beige" else "plastic_d0d4d8"
    for side in (-1, 1):
        for wall, across in (((side * x, side * (x - t)), True), ((side * y, side * (y - t)), False)):
            low, far = sorted(wall)
            spans = ((low, far), (-y, y)) if across else ((-x + t, x - t), (low, far))
            b.box(spans[0], spans[1], (0, high), main, "walls", solid=False)
    b.box((-x + t, x - t), (-y + t, y - t), (0, 0.012), main, "floor", solid=False)
    _hollow(b, high, t, 0.96)
    for face, half in ((DrawnFace.front(b, y), x), (DrawnFace.side(b, x), y)):
        face.field((-half, half), (h * 0.2, h * 0.4), "fabric_f4f0e4", "band", high * 0.5 / 13)
        face.write(
            "LAUNDRY", (-half * 0.92, half * 0.92), (h * 0.23, h * 0.37), "plastic_1f4f9e", "letters", high * 0.55 / 13
        )
    rows = 13
    for row in range(rows + 1):
        z = high * (row + 0.5) / (rows + 0.5)
        coil = [(-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z), (-x, -y, z)]
        b.path(coil, high * 0.44 / rows if row < rows else 0.012, (main, dark)[row % 2], "coils")
    _hung_shirt(b, y, high)
    _hung_sock(b, x, high)


def _hung_shirt(b: Builder, y: float, high: float) -> None:
    """A striped shirt over the front, with its sleeve."""
    w, h, color = b.w, b.h, "fabric_3f8fd8"
    face = DrawnFace.front(b, y + h * 0.033)
    body = (-w * 0.36, w * 0.1)
    b.box((-body[1], -body[0]), (y - 0.03, y + h * 0.036), (high - 0.006, h), color, "shirt", solid=False)
    face.field(body, (h * 0.52, high), color, "shirt", 0.003)
    for k in range(3):
        level = h * (0.58 + 0.12 * k)
        face.field(body, (level, level + h * 0.045), "fabric_white", "shirt", 0.0035)
    sleeve = [(w * 0.06, high), (w * 0.26, h * 0.78), (w * 0.2, h * 0.62), (w * 0.04, h * 0.72)]
    outline = [(-u, v) for u, v in sleeve]
    b.prism(outline, (y + h * 0.03, y + h * 0.036), color, "y", "shirt", solid=False)


def _hung_sock(b: Builder, x: float, high: float) -> None:
    """A red sock with a white heel and toe over the side."""
    d, h = b.d, b.h
    face = DrawnFace.side(b, x + h * 0.033)
    leg = (-d * 0.18, d * 0.04)
    b.box((x - 0.03, x + h * 0.036), leg, (high - 0.006, h), "fabric_d8382e", "sock", solid=False)
    face.field(leg, (h * 0.62, high), "fabric_d8382e", "sock", 0.004)
    face.field((-d * 0.18, d * 0.2), (h * 0.56, h * 0.68), "fabric_d8382e", "sock", 0.004)
    face.field((d * 0.12, d * 0.22), (h * 0.56, h * 0.68), "fabric_white", "sock", 0.0045)
    face.field((-d * 0.19, -d * 0.1), (h * 0.56, h * 0.66), "fabric_white", "sock", 0.0045)
    face.field(leg, (h * 0.84, h * 0.88), "fabric_white", "sock", 0.0045)


@recipe("basket")
def basket(b: Builder) -> None:
    """A basket of woven willow with a rim of cane, an arched handle from end to end, a checked cloth over its edge."""
    w, d, h = b.w, b.d, b.h
    high, t, x, y = h * 0.58, 0.012, w / 2 - 0.012, d / 2 - 0.012
    for side in (-1, 1):
        across, deep = sorted((side * x, side * (x - t))), sorted((side * y, side * (y - t)))
        b.box((across[0], across[1]), (-y, y), (0, high), "wood_8a5a2a", "walls", solid=False)
        b.box((-x, x), (deep[0], deep[1]), (0, high), "wood_8a5a2a", "walls", solid=False)
    b.box((-x, x), (-y, y), (0, 0.01), "wood_8a5a2a", "floor", solid=False)
    _hollow(b, high, t, 0.94)
    for face, half in ((DrawnFace.front(b, y), x), (DrawnFace.side(b, x), y)):
        _willow(face, half, high)
    for z in (0.01, high):
        corners = [(-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z), (-x, -y, z)]
        b.path(corners, 0.011, "wood_d8a860", "rim")
    arch = [(math.cos(k * math.pi / 14), math.sin(k * math.pi / 14) ** 0.6) for k in range(15)]
    for y0 in (-0.008, 0.008):
        b.path([(u * x, y0, high + v * (h - 0.011 - high)) for u, v in arch], 0.011, "wood_d8a860", "handle")
    cloth = DrawnFace.front(b, y + 0.006)
    u = (-w * 0.3, w * 0.12)
    b.box((-u[1], -u[0]), (y - 0.05, y + 0.01), (high, high + 0.013), "fabric_white", "cloth", solid=False)
    cloth.field(u, (high * 0.3, high + 0.012), "fabric_white", "cloth", 0.004)
    for k in range(4):
        left, low = u[0] + (u[1] - u[0]) * k / 4, high * (0.36 + 0.17 * k)
        cloth.field((left, left + w * 0.05), (high * 0.3, high + 0.013), "fabric_d8281e", "checks", 0.0045)
        cloth.field(u, (low, low + high * 0.08), "fabric_d8281e", "checks", 0.005)


def _willow(face: DrawnFace, half: float, high: float) -> None:
    """Rods that pass before and behind the uprights in turn."""
    rows, columns = 6, 9
    for row in range(rows):
        v, shift = high * (row + 0.5) / rows, 0.5 * (row % 2)
        for column in range(columns + row % 2):
            u = [half * (2 * (column - shift + share) / columns - 1) for share in (0.12, 0.88)]
            if u[1] > -half and u[0] < half:
                ends = (max(u[0], -half), v), (min(u[1], half), v)
                face.line(list(ends), high / rows * 0.4, ("wood_c8964e", "wood_dcb070")[row % 2], "weave")


@receptacles("open_top", "fruit_stand")
def _open_tray(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    """A tray of goods: stands, chest freezers, cradles."""
    h = size[2]
    depth = float(p.get("depth", h * 0.3))
    return [volume("tray", inset(size, 0.05), h - depth, h)]


@recipe("rubbish_sack")
def rubbish_sack(b: Builder) -> None:
    """A full black sack with bulges and creases, tied below two floppy ears with a yellow ribbon."""
    w, d, h = b.w, b.d, b.h
    skin = "plastic_2f3136" if b.mat() == "plastic_black" else b.mat()
    b.ball((0, 0, h * 0.34), (w * 0.46, d * 0.46, h * 0.34), skin, "sack", 18)
    for k in range(9):
        a, z = k * 2.4, h * (0.16 + 0.05 * (k % 5))
        b.ball((math.cos(a) * w * 0.28, math.sin(a) * d * 0.28, z), (w * 0.21, d * 0.21, h * 0.16), skin, "bulges", 10)
    b.lathe([(0.3, h * 0.55), (0.08, h * 0.76), (0.06, h * 0.8)], skin, stretch=(w, d), part="neck", n=12)
    for k in range(10):
        a = k * math.tau / 10
        b.rod(
            (math.cos(a) * w * 0.36, math.sin(a) * d * 0.36, h * 0.5),
            (math.cos(a) * w * 0.06, math.sin(a) * d * 0.06, h * 0.78),
            w * 0.014,
            "plastic_dark",
            "creases",
            5,
        )
    b.lathe([(0.075, h * 0.77), (0.075, h * 0.81)], "paint_yellow", stretch=(w, d), part="ribbon", n=12)
    b.path(
        [(w * 0.06, d * 0.04, h * 0.79), (w * 0.16, d * 0.14, h * 0.7), (w * 0.14, d * 0.2, h * 0.6)],
        w * 0.016,
        "paint_yellow",
        "ribbon",
    )
    for side in (-1, 1):
        ear = [
            (side * w * 0.01, h * 0.8),
            (side * w * 0.06, h * 0.8),
            (side * w * 0.26, h * 0.96),
            (side * w * 0.18, h),
            (side * w * 0.08, h * 0.96),
        ]
        b.prism(ear, (-d * 0.04, d * 0.04), skin, "y", "ears")
