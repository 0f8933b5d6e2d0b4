"""Cabinets, lockers, chests and safes, with doors, drawers or a lid."""

import math
from typing import Any

from mansion_assets.builder import TRAY, Builder
from mansion_assets.catalogue.receptacles import BOARD, Receptacle, inset, surface, volume
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@receptacles("cabinet", "kitchen_cabinet", "bathroom_cabinet", "media_console", "medicine_cabinet", "bedside_locker")
def _cabinet_receptacles(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    cols, rows = int(p.get("cols", 2)), int(p.get("rows", 1))
    plinth = float(p.get("plinth", min(0.08, h * 0.1)))
    width, height = (w - BOARD) / cols, (h - plinth - BOARD) / rows
    out: list[Receptacle] = []
    if h <= 1.45 and not p.get("no_top"):
        out.append(surface("top", inset(size, 0.02), h, 1.0))
    for row in range(rows):
        for col in range(cols):
            x0 = -w / 2 + BOARD + col * width
            z0 = plinth + BOARD + row * height
            box = (x0 + 0.005, x0 + width - BOARD - 0.005, -d / 2 + BOARD, d / 2 - BOARD - 0.01)
            out.append(volume("drawer" if rows > cols else "cell", box, z0, z0 + height - BOARD))
    return out


@recipe("cabinet")
def cabinet(b: Builder) -> None:
    """Carcass with doors or drawers, plinth or castors, handles, a worktop where it has one."""
    w, d, h = b.w, b.d, b.h
    cols, rows = int(b.p.get("cols", 2)), int(b.p.get("rows", 1))
    plinth = float(b.p.get("plinth", min(0.08, h * 0.1)))
    front, main = str(b.p.get("front", "drawers")), b.mat()
    z1 = h
    if b.p.get("top"):
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - BOARD, h), str(b.p["top"]), "top")
        z1 = h - BOARD
    elif front == "lid":
        z1 = h - BOARD - 0.001
    face = d / 2 - 0.022
    if front == "wheels":
        b.wheels(0.045)
    elif plinth > 0.01:
        b.box((-w / 2 + 0.015, w / 2 - 0.015), (-d / 2 + 0.01, face - 0.03), (0, plinth), "plastic_dark", "plinth")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - BOARD)))
        b.box((lo, hi), (-d / 2, face), (plinth, z1), main, "sides")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.015), (plinth, z1), main, "back")
    width, height = (w - BOARD) / cols, (h - plinth - BOARD) / rows
    tray = 0.01 if front in _DRAWN else 0.0
    for row in range(rows + 1):
        z = plinth + row * height
        if front == "lid" and row == rows:
            with b.door((-w / 2, w / 2), (-d / 2, face), (z, z + BOARD), "back"):
                b.box((-w / 2, w / 2), (-d / 2, face), (z, z + BOARD), main, "boards")
        elif row < rows or not b.p.get("top"):
            b.box((-w / 2, w / 2), (-d / 2, face), (z, z + BOARD - tray * (row < rows)), main, "boards")
    for col in range(1, cols):
        x = -w / 2 + col * width
        b.box((x, x + BOARD), (-d / 2, face), (plinth, z1), main, "sides")
    for row in range(rows):
        for col in range(cols):
            x0, z0 = -w / 2 + BOARD / 2 + col * width, plinth + BOARD / 2 + row * height
            panel = (z0 + 0.002, min(z0 + height, z1) - 0.002)
            _front(b, front, (x0 + 0.002, x0 + width - 0.002), panel, face, (row, col))


Span = tuple[float, float]


_DRAWN = ("drawers", "wheels")
"""Fronts that are those of drawers."""


def _front(b: Builder, style: str, x: Span, z: Span, face: float, place: tuple[int, int]) -> None:
    """One door or drawer with its handle, slightly apart from its neighbours; a chest with a lid has a fixed front."""
    y = (face + 0.001, face + 0.016)
    if style in _DRAWN:
        # The tray's bottom is what the board of the carcass has less of, so that what is in it lies where it would.
        inner = (z[0] + BOARD / 2 - 0.002 - TRAY, z[0] + 0.6 * (z[1] - z[0]))
        sides = (x[0] + BOARD / 2 - 0.001, x[1] - BOARD / 2 + 0.001)
        with b.drawer(sides, (-b.d / 2 + 0.017, face), inner, b.mat()):
            _panel(b, style, x, z, y, place)
    elif style == "lid":
        _panel(b, style, x, z, y, place)
    else:
        with b.door(x, y, z, "right" if _grips_left(b, place[1]) else "left"):
            _panel(b, style, x, z, y, place)


def _grips_left(b: Builder, column: int) -> bool:
    return column % 2 == 1 or b.p.get("cols", 2) == 1


def _panel(b: Builder, style: str, x: Span, z: Span, y: Span, place: tuple[int, int]) -> None:
    """The panel of a front, with what is on it."""
    main = b.mat()
    grip = (y[1], b.d / 2)
    if style == "glass":
        b.box(x, y, z, "glass_clear", "doors", solid=False)
        for z0, z1 in ((z[0], z[0] + 0.04), (z[1] - 0.04, z[1])):
            b.box(x, y, (z0, z1), main, "doors", solid=False)
    else:
        b.box(x, y, z, main, "doors" if style != "drawers" else "drawers", solid=False)
    if style in ("recycle", "slot"):
        _slots(b, style, x, z[1], grip, place[1])
        return
    if style == "locker":
        _vents(b, x, z[1], grip[0])
    _grip(b, style, x, z, grip, place[1])


def _slots(b: Builder, style: str, x: Span, top: float, y: Span, column: int) -> None:
    """A letter slot; or a label in the colour of what is collected, and the slot below it."""
    if style == "slot":
        slot = (x[0] + 0.1, x[1] - 0.1)
        b.box(slot, y, (top - 0.25, top - 0.18), "plastic_black", "slots", solid=False)
        return
    color = ("plastic_blue", "plastic_yellow", "plastic_green", "plastic_grey")[column % 4]
    b.box((x[0] + 0.03, x[1] - 0.03), y, (top - 0.22, top - 0.06), color, "labels", solid=False)
    middle = (x[0] + x[1]) / 2
    b.box(
        (middle - 0.07, middle + 0.07),
        (y[0], y[1] - 0.001),
        (top - 0.36, top - 0.27),
        "plastic_black",
        "slots",
        solid=False,
    )


def _vents(b: Builder, x: Span, top: float, face: float) -> None:
    """Three slits for air."""
    middle = (x[0] + x[1]) / 2
    for k in range(3):
        b.box(
            (middle - 0.06, middle + 0.06),
            (face, face + 0.003),
            (top - 0.1 - k * 0.02, top - 0.09 - k * 0.02),
            "plastic_dark",
            "vents",
            solid=False,
        )


def _grip(b: Builder, style: str, x: Span, z: Span, y: Span, column: int) -> None:
    """The dial of a safe, an upright handle on the free side of a door, or a level one."""
    xm, zm = (x[0] + x[1]) / 2, (z[0] + z[1]) / 2
    if style == "safe":
        _combination_lock(b, (xm, zm), y)
        return
    if style in ("doors", "glass", "locker"):
        hx = x[0] + 0.04 if _grips_left(b, column) else x[1] - 0.04
        across, up = (hx - 0.006, hx + 0.006), (zm - 0.07, zm + 0.07)
    else:
        half = min(0.07, (x[1] - x[0]) * 0.3)
        level = zm if style != "lid" else z[1] - 0.05
        across, up = (xm - half, xm + half), (level - 0.006, level + 0.006)
    b.box(across, y, up, "metal_steel", "handles", solid=False)


def _combination_lock(b: Builder, at: tuple[float, float], y: Span) -> None:
    """A black dial with white marks, above a wheel of three spokes."""
    x, z = at
    r = min(b.w, b.h) * 0.15
    face = DrawnFace.front(b, y[0])
    face.disc(-x, z + r * 1.2, r, "metal_steel", "dial", (y[1] - y[0]) * 0.5, 24)
    face.disc(-x, z + r * 1.2, r * 0.86, "plastic_black", "dial", (y[1] - y[0]) * 0.7, 24)
    for k in range(12):
        a = k * math.pi / 6
        marks = [(-x + math.cos(a) * r * s, z + r * 1.2 + math.sin(a) * r * s) for s in (0.62, 0.8)]
        face.line(marks, r * 0.04, "plastic_white", "dial", (y[1] - y[0]) * 0.7)
    face.disc(-x, z + r * 1.2, r * 0.34, "metal_chrome", "dial", y[1] - y[0], 16)
    for k in range(3):
        a = math.pi / 2 + k * math.tau / 3
        tip = (-x + math.cos(a) * r * 1.1, z - r * 1.3 + math.sin(a) * r * 1.1)
        face.line([(-x, z - r * 1.3), tip], r * 0.13, "metal_chrome", "wheel", (y[1] - y[0]) * 0.4)
        face.disc(*tip, r * 0.2, "metal_chrome", "wheel", y[1] - y[0], 12)
    face.disc(-x, z - r * 1.3, r * 0.28, "metal_steel", "wheel", y[1] - y[0], 16)


@recipe("hazard_cabinet")
def hazard_cabinet(b: Builder) -> None:
    """A cabinet with a flame in a diamond and DANGER on its doors, and a triangle of warning at its side."""
    cabinet(b)
    w, d, h = b.w, b.d, b.h
    rows = int(b.p["rows"])
    plinth = min(0.08, h * 0.1)
    tall = (h - plinth) / rows
    y, z = d / 2 - 0.006, plinth + (rows - 1.5) * tall
    r = min(w * 0.3, tall * 0.42)
    with b.fixed_to(f"door_{rows - 1}"):
        b.prism([(-r, z), (0, z - r), (r, z), (0, z + r)], (y, y + 0.004), "plastic_white", "y", "sign")
        b.prism(
            [(-r * 0.9, z), (0, z - r * 0.9), (r * 0.9, z), (0, z + r * 0.9)], (y, y + 0.006), "paint_red", "y", "sign"
        )
        flame = [
            (-r * 0.3, z - r * 0.34),
            (r * 0.3, z - r * 0.34),
            (r * 0.36, z - r * 0.04),
            (r * 0.06, z + r * 0.5),
            (-r * 0.34, z),
        ]
        b.prism(flame, (y, y + 0.009), "plastic_black", "y", "sign")
    low = plinth + (rows - 3) * tall
    with b.fixed_to(f"door_{rows - 2}"):
        face = DrawnFace.front(b, y)
        face.field((-w * 0.4, w * 0.4), (low + tall * 0.3, low + tall * 0.74), "plastic_black", "band", 0.004)
        face.write(
            "DANGER", (-w * 0.37, w * 0.37), (low + tall * 0.36, low + tall * 0.68), "paint_yellow", "letters", 0.006
        )
    side = DrawnFace.side(b, w / 2)
    b.prism(
        [(-d * 0.24, h * 0.56), (d * 0.24, h * 0.56), (0, h * 0.56 + d * 0.42)],
        (w / 2, w / 2 + 0.004),
        "plastic_black",
        part="warning",
    )
    side.field((-d * 0.02, d * 0.02), (h * 0.56 + d * 0.13, h * 0.56 + d * 0.28), "paint_yellow", "warning", 0.008)
    side.field((-d * 0.02, d * 0.02), (h * 0.56 + d * 0.05, h * 0.56 + d * 0.09), "paint_yellow", "warning", 0.008)


@recipe("key_cabinet")
def key_cabinet(b: Builder) -> None:
    """A shallow steel case with a locked door of glass, behind which keys with coloured tags hang in rows."""
    w, d, h = b.w, b.d, b.h
    front, t = d / 2 - 0.014, 0.008
    b.hollow((-w / 2, w / 2), (-d / 2, front), (0, h), t, b.mat())
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, -d / 2 + t + 0.003), (t, h - t), "paper_white", "board", solid=False)
    y = -d * 0.1
    for k in range(12):
        x, z = w * (-0.33 + 0.22 * (k % 4)), h * (0.82 - 0.28 * (k // 4))
        b.rod((x, -d / 2 + t, z), (x, y + 0.004, z), 0.003, "metal_dark", "hooks", 6)
        if k in (6, 9):
            continue
        color = ("plastic_red", "plastic_4f9bd9", "plastic_yellow", "plastic_green")[(k * 3) % 4]
        b.box((x - w * 0.05, x + w * 0.05), (y, y + 0.004), (z - h * 0.09, z - h * 0.005), color, "tags")
        b.rod((x, y, z - h * 0.11), (x, y + 0.004, z - h * 0.11), w * 0.036, "metal_brass", "keys", 12)
        b.box((x - w * 0.011, x + w * 0.011), (y, y + 0.004), (z - h * 0.22, z - h * 0.12), "metal_brass", "keys")
        for tooth in (0.2, 0.17):
            b.box((x, x + w * 0.04), (y, y + 0.004), (z - h * (tooth + 0.014), z - h * tooth), "metal_brass", "keys")
    door = (front + 0.001, front + 0.01)
    with b.door((-w / 2, w / 2), door, (0.0, h), "left"):
        for across in ((-w / 2, -w * 0.45), (w * 0.45, w / 2)):
            b.box(across, door, (0, h), b.mat(), "door")
        for up in ((0.0, h * 0.05), (h * 0.95, h)):
            b.box((-w / 2, w / 2), door, up, b.mat(), "door")
        b.box(
            (-w * 0.45, w * 0.45),
            (door[0], door[0] + 0.003),
            (h * 0.05, h * 0.95),
            "glass_clear",
            "window",
            solid=False,
        )
        b.rod((w * 0.475, door[1], h * 0.5), (w * 0.475, d / 2, h * 0.5), w * 0.024, "metal_brass", "lock", 12)


@recipe("book_drop")
def book_drop(b: Builder) -> None:
    """A cabinet with a chute that a book goes into, an open book as its sign, and the words BOOK RETURN."""
    w, d, h = b.w, b.d, b.h
    face = d / 2 - 0.022
    cabinet(b)
    with b.fixed_to("door_1"):
        front = DrawnFace.front(b, face + 0.016)
        front.write("BOOK", (-w * 0.38, w * 0.38), (h * 0.5, h * 0.62), "plastic_white", "letters", 0.004)
        front.write("RETURN", (-w * 0.4, w * 0.4), (h * 0.36, h * 0.47), "plastic_white", "letters", 0.004)
        for side in (-1, 1):
            page = [(0.0, h * 0.14), (side * w * 0.28, h * 0.17), (side * w * 0.28, h * 0.31), (0.0, h * 0.28)]
            b.prism(page, (face + 0.016, face + 0.02), "plastic_white", "y", "sign")
    slot = h - 0.24
    with b.fixed_to("door_1"):
        b.box((-w * 0.2, w * 0.16), (face, d / 2 + 0.12), (slot - 0.004, slot + 0.05), "paper_white", "book")
        for z in (slot - 0.01, slot + 0.05):
            b.box((-w * 0.21, w * 0.17), (face, d / 2 + 0.125), (z, z + 0.01), "paper_red", "book")


@recipe("trunk")
def trunk(b: Builder) -> None:
    """A chest with leather straps and brass corners, a hasp in the middle of its lid, and rope handles at its ends."""
    cabinet(b)
    w, d, h = b.w, b.d, b.h
    face, top = DrawnFace.front(b, d / 2 - 0.006), h * 0.94
    for u in (-w * 0.32, w * 0.32):
        face.field((u - w * 0.035, u + w * 0.035), (h * 0.1, top), "leather_5a3a22", "straps", 0.004)
        face.field((u - w * 0.045, u + w * 0.045), (h * 0.6, h * 0.7), "metal_brass", "buckles", 0.006)
    face.field((-w * 0.06, w * 0.06), (h * 0.6, top), "metal_brass", "hasp", 0.004)
    face.disc(0, h * 0.68, w * 0.02, "plastic_black", "hasp", 0.006, 12)
    for end in ((-w / 2 + 0.004, -w * 0.43), (w * 0.43, w / 2 - 0.004)):
        for level in ((h * 0.1, h * 0.24), (h * 0.8, top)):
            face.field(end, level, "metal_brass", "corners", 0.005)
    side = DrawnFace.side(b, w / 2)
    side.line(
        [(-d * 0.18, h * 0.62), (-d * 0.14, h * 0.46), (d * 0.14, h * 0.46), (d * 0.18, h * 0.62)],
        0.012,
        "fabric_d9c08a",
        "handles",
    )
    with b.fixed_to("lid_1"):
        lid = DrawnFace.top(b, h)
        for u in (-w * 0.32, w * 0.32):
            lid.field((u - w * 0.035, u + w * 0.035), (-d / 2 + 0.03, d / 2), "leather_5a3a22", "straps", 0.001)
