"""Tables and desks."""

import math
from collections.abc import Callable
from typing import Any, Final

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, inset, surface
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__ = ["PRINT", "end_panels", "four_legs", "sled_frames", "table_top", "tee_frames"]

PRINT: Final = 0.002
"""Thickness of what is drawn on a top, metres; it lies within the height of the table, so that objects stand on it."""


def _supports(b: Builder, style: str, z: float, frame: str) -> None:
    """Legs below a top at height `z`."""
    _SUPPORTS.get(style, four_legs)(b, z, frame)


def _pedestal(b: Builder, z: float, frame: str) -> None:
    """A column in the middle on a round foot."""
    w, d = b.w, b.d
    b.lathe(
        [(0.42, 0.0), (0.42, 0.02), (0.06, 0.05), (0.05, z * 0.9), (0.12, z)],
        frame,
        stretch=(min(w, d), min(w, d)),
        part="legs",
        n=20,
    )
    b.boxes.pop()
    b.cyl(0, 0, (0.0, 0.03), min(w, d) * 0.42, frame, "legs", n=20)
    b.cyl(0, 0, (0.03, z), 0.05, frame, "legs")


def end_panels(b: Builder, z: float, frame: str) -> None:
    """A panel at each end and one across the back."""
    w, d = b.w, b.d
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.06)
        b.box((x - 0.02, x + 0.02), (-d / 2 + 0.06, d / 2 - 0.06), (0, z), frame, "legs")
    b.box((-w / 2 + 0.08, w / 2 - 0.08), (-d / 2 + 0.12, -d / 2 + 0.14), (z * 0.35, z), frame, "modesty")


def _end_frame(b: Builder, side: int, z: float, frame: str, posts: tuple[float, ...], low: float = 0.0) -> None:
    """A bar on the floor or at a height above it, posts at the `posts` (y) and a bar below the top, at one end."""
    reach = (-b.d / 2 + 0.03, b.d / 2 - 0.03)
    x = side * (b.w / 2 - 0.08)
    b.box((x - 0.03, x + 0.03), reach, (low, low + 0.03), frame, "legs")
    b.box((x - 0.03, x + 0.03), reach, (z - 0.03, z), frame, "legs")
    for y in posts:
        b.box((x - 0.03, x + 0.03), (y - 0.03, y + 0.03), (low + 0.02, z - 0.02), frame, "legs")


def tee_frames(b: Builder, z: float, frame: str, low: float = 0.0) -> None:
    """A post in the middle of each end, on a bar at the height `low`."""
    for side in (-1, 1):
        _end_frame(b, side, z, frame, (0.0,), low)


def sled_frames(b: Builder, z: float, frame: str) -> None:
    reach = (-b.d / 2 + 0.03, b.d / 2 - 0.03)
    for side in (-1, 1):
        _end_frame(b, side, z, frame, (reach[0] + 0.03, reach[1] - 0.03))


def _cee(b: Builder, z: float, frame: str) -> None:
    """A frame at one end that carries the top alone, as beside a bed."""
    _end_frame(b, -1, z, frame, (0.0,))
    b.box((-b.w / 2 + 0.05, b.w / 2 - 0.05), (-0.04, 0.04), (0, 0.05), frame, "legs")


def _trestles(b: Builder, z: float, frame: str) -> None:
    w, d = b.w, b.d
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.2)
        for sy in (-1, 1):
            foot, head = sy * (d / 2 - 0.05), (x, sy * d * 0.28, z)
            b.rod((x - 0.08, foot, 0), head, 0.022, frame, "legs", solid=True)
            b.rod((x + 0.08, foot, 0), head, 0.022, frame, "legs")
        b.box((x - 0.03, x + 0.03), (-d * 0.3, d * 0.3), (z - 0.06, z), frame, "legs", solid=False)


def _cloth(b: Builder, z: float, frame: str) -> None:
    """A cloth down to the floor."""
    b.lathe([(0.5, 0.0), (0.47, z)], b.mat(), stretch=(b.w, b.d), part="cloth", n=28)


def four_legs(b: Builder, z: float, frame: str) -> None:
    """Four legs joined by an apron."""
    w, d = b.w, b.d
    b.legs((0, z), min(0.035, w * 0.04), frame, 0.02)
    rail = (z - 0.07, z)
    for y in ((-d / 2 + 0.05, -d / 2 + 0.07), (d / 2 - 0.07, d / 2 - 0.05)):
        b.box((-w / 2 + 0.05, w / 2 - 0.05), y, rail, frame, "apron", solid=False)
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.06)
        b.box((x - 0.01, x + 0.01), (-d / 2 + 0.05, d / 2 - 0.05), rail, frame, "apron", solid=False)


_SUPPORTS: dict[str, Callable[[Builder, float, str], None]] = {
    "pedestal": _pedestal,
    "panel": end_panels,
    "tee": tee_frames,
    "sled": sled_frames,
    "cee": _cee,
    "trestle": _trestles,
    "cloth": _cloth,
}


def table_top(b: Builder, z: float, thick: float, *, round_: bool) -> None:
    w, d = b.w, b.d
    if round_:
        b.lathe([(0.485, z - thick), (0.5, z - thick * 0.5), (0.5, z)], b.mat(), stretch=(w, d), part="top", n=32)
    else:
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - thick, z), b.mat(), "top")


@receptacles(
    "table",
    "conference_table",
    "evidence_table",
    "kids_table",
    "coffee_table",
    "dining_table",
    "cafeteria_table",
    "training_table",
    "patio_table",
)
def _table_top(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    return [surface("top", inset(size, 0.02), size[2], 1.2, round_=p.get("shape") == "round")]


@recipe("table")
def table(b: Builder) -> None:
    """Rectangular or round top on legs, a pedestal, panels or frames."""
    h = b.h
    thick = min(0.04, h * 0.1)
    table_top(b, h, thick, round_=b.p.get("shape") == "round")
    style = str(b.p.get("legs", "four"))
    frame = b.mat("frame", b.mat() if style != "cloth" else "metal_grey")
    _supports(b, style, h - thick, frame)
    if b.p.get("shelf") or (h < 0.6 and style == "four" and b.w * 1000 % 2 < 1):
        z = h * 0.3
        b.box((-b.w / 2 + 0.04, b.w / 2 - 0.04), (-b.d / 2 + 0.04, b.d / 2 - 0.04), (z - 0.02, z), frame, "shelf")


@recipe("display_table")
def display_table(b: Builder) -> None:
    """A shop's table: an apron with a red sale sign and price tags, folded clothes in colours on a shelf below."""
    w, d, h = b.w, b.d, b.h
    table_top(b, h, 0.05, round_=False)
    _supports(b, "four", h - 0.05, b.mat())
    apron, shelf = h - 0.17, h * 0.24
    for y in (-d / 2 + 0.02, d / 2 - 0.04):
        b.box((-w / 2 + 0.03, w / 2 - 0.03), (y, y + 0.02), (apron, h - 0.05), b.mat(), "apron")
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2 + 0.03, d / 2 - 0.03), (shelf - 0.03, shelf), b.mat(), "shelf")
    face = DrawnFace.front(b, d / 2 - 0.02)
    low, high = h - 0.34, h - 0.06
    face.field((-w * 0.2, w * 0.2), (low, high), "paint_red", "sign", 0.012)
    DrawnFace.front(b, d / 2 - 0.008).write("SALE", (-w * 0.17, w * 0.17), (low + 0.03, high - 0.03), "plastic_white")
    for u in (-0.4, -0.29, 0.29, 0.4):
        face.field((w * u - 0.03, w * u + 0.03), (h - 0.11, h - 0.06), "paper_white", "tags", 0.008)
    colors = ("fabric_c94f4f", "fabric_2f5fa8", "fabric_e0b84a", "fabric_4f8f6a", "fabric_8a5fa8")
    width = (w - 0.2) / len(colors)
    for k, color in enumerate(colors):
        x = -w / 2 + 0.1 + width * k
        for j in range(4):
            z = shelf + 0.055 * j
            b.cushion((x + 0.015, x + width - 0.015), (-d * 0.1, d / 2 - 0.06), (z, z + 0.05), color, "clothes", 0.4)


def _drawers(b: Builder, x: tuple[float, float], z: float) -> None:
    """Three drawers in a case below a top at height `z`, before the panel across the back."""
    d, main = b.d, b.mat()
    back, face = -d / 2 + 0.142, d / 2 - 0.1
    b.hollow(x, (back, face), (0.1, z - 0.03), 0.012, main, "drawers")
    step = (z - 0.17) / 3
    for k in range(3):
        z0 = 0.12 + k * step
        front = (z0, z0 + step - 0.012)
        with b.drawer((x[0] + 0.014, x[1] - 0.014), (back + 0.014, face), (z0, z0 + 0.7 * step), main):
            b.box((x[0] + 0.01, x[1] - 0.01), (face, face + 0.015), front, main, "fronts", solid=False)
            middle = (x[0] + x[1]) / 2
            grip = ((middle - 0.06, middle + 0.06), (face + 0.015, face + 0.03), (z0 + 0.1, z0 + 0.115))
            b.box(*grip, "metal_steel", "handles", solid=False)


@receptacles("desk", "office_desk", "student_desk")
def _desk_tops(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    if h <= 0.95:
        return [surface("top", inset(size, 0.02), h, 1.2)]
    if p.get("mirror"):
        return [surface("top", (-w / 2 + 0.02, w / 2 - 0.02, -d / 2 + 0.08, d / 2 - 0.02), 0.76, h - 0.76)]
    z, hutch = min(0.76, h * 0.6), min(0.3, d * 0.45)
    top = (-w / 2 + 0.02, w / 2 - 0.02, -d / 2 + hutch + 0.01, d / 2 - 0.02)
    shelf = (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.02, -d / 2 + hutch - 0.02)
    return [surface("top", top, z, h - z), surface("shelf", shelf, h, 0.4)]


def _vanity_mirror(b: Builder, z: float) -> None:
    """An oval mirror with a gleam, lamps round it, at the back of a top at height `z`."""
    y, middle = -b.d / 2 + 0.03, (z + b.h) / 2
    rx, rz = b.w * 0.28, (b.h - z) / 2 - 0.03
    ring = [(math.cos(a) * rx, middle + math.sin(a) * rz) for a in (k * math.tau / 28 for k in range(28))]
    b.prism([(x * 1.06, middle + (v - middle) * 1.05) for x, v in ring], (y - 0.03, y - 0.004), b.mat(), "y", "frame")
    b.prism(ring, (y - 0.004, y), "glass_mirror", "y", "mirror")
    band = [
        (-rx * 0.5, middle - rz * 0.6),
        (-rx * 0.2, middle - rz * 0.7),
        (rx * 0.5, middle + rz * 0.6),
        (rx * 0.2, middle + rz * 0.7),
    ]
    b.prism(band, (y, y + 0.001), "plastic_eef6fa", "y", "gleam", solid=False)
    b.box((-0.05, 0.05), (-b.d / 2, y - 0.004), (z, middle - rz), b.mat(), "frame")
    for k in range(9):
        a = math.radians(-20 + 27.5 * k)
        b.ball(
            (math.cos(a) * rx * 1.1, y, middle + math.sin(a) * rz * 1.04), (0.02, 0.02, 0.02), "light_warm", "lamps", 8
        )


@recipe("desk")
def desk(b: Builder) -> None:
    """Top on legs or panels, drawers under the right side, a hutch on high ones."""
    w, d = b.w, b.d
    z = b.tops[0].z
    style = str(b.p.get("legs", "panel"))
    table_top(b, z, 0.03, round_=False)
    _supports(b, style, z - 0.03, b.mat("frame", b.mat()))
    if style == "panel" and (b.p.get("drawers") or w > 1.0) and d > 0.3:
        width = min(0.42, w * 0.32)
        sides = (-1, 1) if int(b.p.get("drawers", 1)) > 1 else (1,)
        for sx in sides:
            lo, hi = sorted((sx * (w / 2 - 0.08), sx * (w / 2 - 0.08 - width)))
            _drawers(b, (lo, hi), z)
    if b.p.get("mirror"):
        _vanity_mirror(b, z)
    elif b.h > z + 0.02:
        shelf = b.tops[1]
        for x in (-w / 2 + 0.012, w / 2 - 0.012):
            b.box((x - 0.012, x + 0.012), (-d / 2, shelf.y1 + 0.02), (z, b.h), b.mat(), "hutch")
        b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.012), (z, b.h), b.mat(), "hutch")
        for level in (b.h, z + (b.h - z) * 0.55):
            b.box((-w / 2, w / 2), (-d / 2, shelf.y1 + 0.02), (level - 0.022, level), b.mat(), "hutch")


@recipe("banquet_table")
def banquet_table(b: Builder) -> None:
    """A round top under a white cloth that falls to the floor in deep folds, with a golden edge."""
    w, d = b.w, b.d
    z = b.tops[0].z
    b.lathe([(0.5, z - 0.02), (0.5, z)], b.mat(), stretch=(w, d), part="top", n=36)
    b.lathe([(0.47, 0.0), (0.485, z - 0.02)], b.mat(), stretch=(w, d), part="cloth", n=36)
    folds = 20
    for k in range(folds):
        a = k * math.tau / folds
        ux, uy = math.cos(a), math.sin(a)
        b.rod(
            (ux * w * 0.475, uy * d * 0.475, z - 0.03),
            (ux * w * 0.468, uy * d * 0.468, 0.0),
            w * 0.03,
            b.mat(),
            "folds",
            8,
        )
    b.lathe([(0.493, z * 0.8), (0.503, z - 0.015)], "fabric_c9a24a", stretch=(w, d), part="overlay", n=36)
