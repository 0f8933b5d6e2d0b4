"""Shelves, standing and on walls."""

from typing import Any

from mansion_assets.builder import Builder, Rect
from mansion_assets.catalogue.receptacles import BOARD, Receptacle, inset, surface
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_assets.shelf_goods import goods
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@receptacles("shelf", "mail_shelf")
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


@recipe("mail_shelf")
def mail_shelf(b: Builder) -> None:
    """Pigeonholes with letters between blue sides, each with MAIL along it and a sealed envelope."""
    shelf(b)
    h, half = b.h, b.d * 0.4
    side = DrawnFace.side(b, b.w / 2)
    side.field((-b.d * 0.47, b.d * 0.47), (h * 0.03, h * 0.97), "plastic_1f5fb8", "sides", 0.001)
    low, high = h * 0.72, h * 0.72 + half * 1.3
    side.field((-half, half), (low, high), "paper_white", "envelope", 0.002)
    side.line([(-half, high), (0.0, low + half * 0.5), (half, high)], 0.009, "plastic_1f5fb8", "envelope", -0.006)
    side.disc(0.0, low + half * 0.5, half * 0.2, "paint_d8281e", "envelope", 0.003, 14)
    upwards = DrawnFace(b, (b.w / 2, 0.0, 0.0), (0.0, 0.0, 1.0), (0.0, -1.0, 0.0))
    upwards.write("MAIL", (h * 0.06, h * 0.68), (-half, half), "paper_white", "title", 0.002)


@receptacles("wall_shelf")
def _wall_shelf_top(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    return [surface("shelf", inset(size, 0.015), size[2], 0.45)]


@recipe("wall_shelf")
def wall_shelf(b: Builder) -> None:
    """Board on two brackets, its upper face at the top."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.025, h), b.mat(), "board")
    for sx in (-1, 1):
        x = sx * w * 0.36
        b.box((x - 0.01, x + 0.01), (-d / 2, -d / 2 + 0.012), (0, h - 0.025), "metal_black", "brackets")
        b.rod((x, -d / 2 + 0.01, 0.01), (x, d / 2 - 0.03, h - 0.03), 0.007, "metal_black", "brackets")
