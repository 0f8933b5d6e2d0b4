"""What carries and holds things on furniture: tops, seats, mattresses, shelves, drawers."""

from typing import Any

from mansion_assets.catalogue.carriers import BOARD, Carrier, Rule, inset, rect, volume
from mansion_msgs_py.shapes import Size3

__all__ = ["FURNITURE"]


def _table(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    return [rect("top", inset(size, 0.02), size[2], 1.2, p.get("shape") == "round")]


def _desk(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    if h <= 0.95:
        return [rect("top", inset(size, 0.02), h, 1.2)]
    z, hutch = min(0.76, h * 0.6), min(0.3, d * 0.45)
    top = (-w / 2 + 0.02, w / 2 - 0.02, -d / 2 + hutch + 0.01, d / 2 - 0.02)
    shelf = (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.02, -d / 2 + hutch - 0.02)
    return [rect("top", top, z, h - z), rect("shelf", shelf, h, 0.4)]


def _counter(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    ledge = float(p.get("ledge", 0.0))
    if ledge <= 0.0:
        return [rect("top", inset(size, 0.03), h, 1.0)]
    work = (-w / 2 + 0.05, w / 2 - 0.05, -d / 2 + 0.03, d / 2 - 0.32)
    raised = (-w / 2 + 0.02, w / 2 - 0.02, d / 2 - 0.28, d / 2 - 0.02)
    return [rect("top", work, h - ledge, 1.0), rect("ledge", raised, h, 1.0)]


def _chair(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    z = float(p.get("seat", min(0.46, h * 0.54)))
    return [rect("seat", (-w * 0.38, w * 0.38, -d * 0.26, d * 0.42), z, 0.6)]


def _swivel_chair(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    z = min(0.5, h * 0.5)
    return [rect("seat", (-w * 0.3, w * 0.3, -d * 0.22, d * 0.3), z, 0.6)]


def _stool(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    round_ = p.get("shape", "round") == "round"
    return [rect("seat", inset(size, 0.03), size[2], 0.6, round_)]


def _sofa(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    arm = 0.0 if p.get("arms") is False else min(0.2, w * 0.13)
    back = min(0.28, d * 0.3)
    z = min(0.44, h * 0.52)
    box = (-w / 2 + arm + 0.02, w / 2 - arm - 0.02, -d / 2 + back + 0.02, d / 2 - 0.05)
    return [rect("seat", box, z, 0.6)]


def _bench(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    z = min(0.46, h * 0.52) if p.get("back") else h
    return [rect("seat", (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.08, d / 2 - 0.03), z, 0.6)]


def _bed(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    tiers = int(p.get("tiers", 2 if h > 1.5 else 1))
    low = min(0.52, h * 0.62) if h > 0.5 else h - min(0.1, h / 2)
    head, side = min(0.45, d * 0.22), 0.06
    box = (-w / 2 + side, w / 2 - side, -d / 2 + head + 0.06, d / 2 - 0.08)
    heights = [low] if tiers == 1 else [low, min(h - 0.3, low + 1.0)]
    return [rect("mattress", box, z, 0.6) for z in heights]


def _levels(size: Size3, p: dict[str, Any]) -> list[float]:
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


def _shelf(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    heights = _levels(size, p)
    gap = (h - heights[0]) / len(heights) - BOARD
    sides = [(-d / 2 + 0.02, d / 2 - 0.02)]
    if p.get("sides") == 2:
        sides = [(0.02, d / 2 - 0.02), (-d / 2 + 0.02, -0.02)]
    out: list[Carrier] = [
        rect("shelf", (-w / 2 + 0.04, w / 2 - 0.04, y0, y1), heights[i], gap)
        for i in _free_levels(len(heights), p)
        for y0, y1 in sides
    ]
    if h <= 1.3 and not p.get("no_top"):
        out.append(rect("top", inset(size, 0.03), h, 0.8))
    return out


def _wall_shelf(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    return [rect("shelf", inset(size, 0.015), size[2], 0.45)]


def _cabinet(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    cols, rows = int(p.get("cols", 2)), int(p.get("rows", 1))
    plinth = float(p.get("plinth", min(0.08, h * 0.1)))
    width, height = (w - BOARD) / cols, (h - plinth - BOARD) / rows
    out: list[Carrier] = []
    if h <= 1.45 and not p.get("no_top"):
        out.append(rect("top", inset(size, 0.02), h, 1.0))
    for row in range(rows):
        for col in range(cols):
            x0 = -w / 2 + BOARD + col * width
            z0 = plinth + BOARD + row * height
            box = (x0 + 0.005, x0 + width - BOARD - 0.005, -d / 2 + BOARD, d / 2 - BOARD - 0.01)
            out.append(volume("drawer" if rows > cols else "cell", box, z0, z0 + height - BOARD))
    return out


def _trolley(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    h = size[2]
    count = int(p.get("levels", 2))
    rail = float(p.get("rail", 0.08 if h > 0.5 else 0.0))
    top = h - rail
    heights = [top - (top - 0.2) * i / max(1, count - 1) for i in range(count)] if count > 1 else [top]
    gap = (top - 0.2) / max(1, count - 1) - 0.03
    box = inset(size, 0.05)
    return [rect("shelf", box, z, 0.8 if i == 0 else gap) for i, z in enumerate(heights)]


def _cubicle(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, _ = size
    box = (-w / 2 + 0.07, w / 2 - 0.07, -d / 2 + 0.07, -d / 2 + min(0.75, d * 0.8) - 0.03)
    return [rect("top", box, 0.74, 1.0)]


def _control_desk(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, _ = size
    return [rect("top", (-w / 2 + 0.04, w / 2 - 0.04, 0.2, d / 2 - 0.02), 0.75, 1.0)]


def _salon_station(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, _ = size
    return [rect("shelf", (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.07, d / 2 - 0.02), 0.82, 0.8)]


FURNITURE: dict[str, Rule] = {
    "bed": _bed,
    "bench": _bench,
    "cabinet": _cabinet,
    "chair": _chair,
    "control_desk": _control_desk,
    "counter": _counter,
    "cubicle": _cubicle,
    "desk": _desk,
    "salon_station": _salon_station,
    "shelf": _shelf,
    "sofa": _sofa,
    "stool": _stool,
    "swivel_chair": _swivel_chair,
    "table": _table,
    "trolley": _trolley,
    "wall_shelf": _wall_shelf,
}
"""From a recipe of furniture to its rule."""
