"""Shelves, cabinets and trolleys, with the goods in them."""

import math
from typing import Any, Final

from mansion_assets.builder import TRAY, Builder, Rect
from mansion_assets.catalogue.receptacles import BOARD, Receptacle, inset, surface, volume
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_assets.shelf_goods import Goods, hung_bags, lying_bottles, magazines, medicine, potted_plants, toys, trays
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


_BOOKS = ("paper_red", "paper_blue", "paper_green", "paper_brown", "paper_beige", "paper_dark", "paper_orange")


_GOODS = ("paper_red", "paper_yellow", "paper_blue", "paper_green", "paper_orange", "plastic_white", "paper_purple")

_PRODUCTS = (
    ("box", "paper_red"),
    ("can", "metal_steel"),
    ("box", "paper_beige"),
    ("bottle", "glass_green"),
    ("box", "paper_yellow"),
    ("box", "plastic_white"),
    ("can", "paper_green"),
    ("box", "paper_blue"),
    ("bottle", "glass_brown"),
    ("box", "paper_brown"),
    ("can", "paper_orange"),
)
"""Shapes and colours of what a supermarket sells."""

_FACINGS = 4
"""How many of one product stand side by side."""


def goods(b: Builder, fill: str, cell: Rect, depth: float, key: int) -> None:
    """Show goods in a compartment; they are part of the mesh, and the compartment is no receptacle."""
    own = _OWN_GOODS.get(fill)
    if own is not None:
        own(b, cell, depth, key)
        return
    room = cell.top - cell.z
    step, palette = {
        "books": (0.045, _BOOKS),
        "folders": (0.08, ("paper_dark", "paper_blue", "paper_grey")),
        "boxes": (0.36, ("paper_brown", "paper_beige")),
        "bins": (0.2, ("plastic_blue", "plastic_red")),
        "shoes": (0.13, ("leather_brown", "fabric_white", "leather_black")),
        "linen": (0.36, ("fabric_white", "fabric_beige")),
    }.get(fill, (0.2, _GOODS))
    count = max(1, int((cell.x1 - cell.x0) / step))
    step = (cell.x1 - cell.x0) / count
    tall = {"books": 0.78, "folders": 0.85, "shoes": 0.4, "boxes": 0.72}.get(fill, 0.66)
    for k in range(count):
        mark = (k * 7 + key * 13 + k * k * 3) % 11
        height = room * tall * (0.8 + 0.02 * mark)
        x0 = cell.x0 + k * step
        color = palette[(mark + k) % len(palette)]
        back = cell.y0 + 0.01 + 0.002 * mark
        front = min(cell.y1 - 0.01, back + depth * 0.8)
        if fill == "books" and mark == 3:
            continue
        b.box((x0 + 0.002, x0 + step - 0.002), (back, front), (cell.z, cell.z + height), color, "goods", solid=False)


def _groceries(b: Builder, cell: Rect, depth: float, key: int) -> None:
    """Show several of each product side by side, behind a rail with the prices."""
    room = cell.top - cell.z
    count = max(1, int((cell.x1 - cell.x0) / 0.105))
    step = (cell.x1 - cell.x0) / count
    # Of a shelf with two sides the one to the back faces the other way.
    front = cell.y1 if abs(cell.y1) > abs(cell.y0) else cell.y0
    inwards = -1 if front > 0 else 1
    for k in range(count):
        run = k // _FACINGS
        shape, color = _PRODUCTS[(run * 5 + key * 3 + (front > 0)) % len(_PRODUCTS)]
        height = room * (0.5 + 0.07 * ((run * 3 + key) % 5))
        x = cell.x0 + (k + 0.5) * step
        if shape == "box":
            y = sorted((front + inwards * 0.03, front + inwards * min(depth - 0.02, 0.3)))
            half = step * (0.46 if run % 2 else 0.4)
            b.box((x - half, x + half), (y[0], y[1]), (cell.z, cell.z + height), color, "goods", solid=False)
            continue
        for row in (0.08, 0.19) if depth > 0.3 else (0.08,):
            tall = min(height, 0.13) if shape == "can" else height
            b.cyl(x, front + inwards * row, (cell.z, cell.z + tall), step * 0.42, color, "goods", n=6, solid=False)
    rail = sorted((front, front + inwards * 0.012))
    z = (cell.z - 0.03, cell.z + 0.012)
    b.box((cell.x0, cell.x1), (rail[0], rail[1]), z, "plastic_white", "rails", solid=False)


_OWN_GOODS: Final[dict[str, Goods]] = {
    "bags": hung_bags,
    "bottles": lying_bottles,
    "groceries": _groceries,
    "magazines": magazines,
    "medicine": medicine,
    "plants": potted_plants,
    "toys": toys,
    "trays": trays,
}
"""Goods with a shape of their own; the others are boxes."""


@receptacles("shelf")
def _free_boards(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    heights = _board_heights(size, p)
    gap = (h - heights[0]) / len(heights) - BOARD
    sides = [(-d / 2 + 0.02, d / 2 - 0.02)]
    if p.get("sides") == 2:
        sides = [(0.02, d / 2 - 0.02), (-d / 2 + 0.02, -0.02)]
    out: list[Receptacle] = [
        surface("shelf", (-w / 2 + 0.04, w / 2 - 0.04, y0, y1), heights[i], gap)
        for i in _free_levels(len(heights), p)
        for y0, y1 in sides
    ]
    if h <= 1.3 and not p.get("no_top"):
        out.append(surface("top", inset(size, 0.03), h, 0.8))
    return out


def _board_heights(size: Size3, p: dict[str, Any]) -> list[float]:
    """Heights of the upper faces of a shelf's boards, from the lowest to the one below the top."""
    h = size[2]
    count = int(p.get("levels", max(2, round(h / 0.38))))
    base = float(p.get("base", 0.08 if h > 0.5 else 0.03))
    return [base + (h - base) * i / count for i in range(count)]


def _free_levels(count: int, p: dict[str, Any]) -> list[int]:
    """Indices of the boards that stay free of the goods that the mesh shows."""
    free = int(p.get("free", count if p.get("fill", "none") == "none" else min(2, count)))
    middle = sorted(range(count), key=lambda i: (abs(i - (count - 1) / 2), i))
    return sorted(middle[:free])


@recipe("shelf")
def shelf(b: Builder) -> None:
    """Boards between sides or posts; filled where the surface rule says that they are not free."""
    w, d, h = b.w, b.d, b.h
    heights = _board_heights((w, d, h), b.p)
    base = heights[0]
    main, posts, double = b.mat(), b.p.get("frame") == "posts", b.p.get("sides") == 2
    if posts:
        b.legs((0, h), 0.018, main, 0.0)
    else:
        for sx in (-1, 1):
            lo, hi = sorted((sx * w / 2, sx * (w / 2 - BOARD)))
            b.box((lo, hi), (-d / 2, d / 2), (0, h), main, "sides")
    if double:
        b.box((-w / 2, w / 2), (-0.012, 0.012), (0.02, h), main, "back")
    elif not posts:
        b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.01), (0.02, h), main, "back")
    for z in (*heights, h):
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - BOARD, z), main, "boards")
    if base > 0.05 and not posts:
        b.box((-w / 2, w / 2), (-d / 2 + 0.01, d / 2 - 0.02), (0, base - BOARD), main, "plinth", solid=False)
    free = {round(t.z, 2) for t in b.tops}
    fill = str(b.p.get("fill", "none"))
    if fill == "none":
        return
    gap = (h - base) / len(heights) - BOARD
    sides = [(0.014, d / 2 - 0.01), (-d / 2 + 0.01, -0.014)] if double else [(-d / 2 + 0.012, d / 2 - 0.01)]
    for level, z in enumerate(heights):
        if round(z, 2) in free:
            continue
        for y0, y1 in sides:
            goods(b, fill, Rect(-w / 2 + 0.03, w / 2 - 0.03, y0, y1, z, z + gap), y1 - y0, level)


@receptacles("cabinet")
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


@receptacles("trolley")
def _trolley_shelves(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    h = size[2]
    count = int(p.get("levels", 2))
    rail = float(p.get("rail", 0.08 if h > 0.5 else 0.0))
    top = h - rail
    heights = [top - (top - 0.2) * i / max(1, count - 1) for i in range(count)] if count > 1 else [top]
    gap = (top - 0.2) / max(1, count - 1) - 0.03
    box = inset(size, 0.05)
    return [surface("shelf", box, z, 0.8 if i == 0 else gap) for i, z in enumerate(heights)]


@recipe("trolley")
def trolley(b: Builder) -> None:
    """Trays between posts on castors, with a push bar."""
    w, d = b.w, b.d
    for t in b.tops:
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (t.z - 0.025, t.z), b.mat(), "trays")
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (w / 2 - 0.02), sy * (d / 2 - 0.02)
            b.rod((x, y, 0.09), (x, y, b.h - 0.012), 0.012, "metal_steel", "posts", solid=True)
    for sx in (-1, 1):
        b.rod(
            (sx * (w / 2 - 0.02), -d / 2 + 0.02, b.h - 0.012),
            (sx * (w / 2 - 0.02), d / 2 - 0.02, b.h - 0.012),
            0.012,
            "metal_steel",
            "rail",
        )
    b.wheels(0.05)
    fill = str(b.p.get("fill", "none"))
    if fill != "none":
        t = b.tops[-1]
        goods(b, fill, Rect(t.x0, t.x1, t.y0, t.y1, 0.12, t.z - 0.05), d * 0.8, 1)
