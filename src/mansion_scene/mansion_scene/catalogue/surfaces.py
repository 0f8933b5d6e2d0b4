"""What carries and what holds things, from an asset's recipe, size and parameters.

Mesh recipes build to these rectangles and boxes, so that what is packed on them rests on the mesh. Rules work in a
frame with its origin on the floor below the centre of the asset; `surfaces_of` moves the result to the box centre.
"""

from collections.abc import Callable
from typing import Any

from mansion_msgs_py.shapes import Size3
from mansion_scene.catalogue.asset import Surface, Volume

__all__ = ["BOARD", "surfaces_of"]

Carrier = Surface | Volume
Rule = Callable[[Size3, dict[str, Any]], list[Carrier]]

BOARD = 0.022
"""Thickness of a furniture board, metres."""


def _rect(
    kind: str,
    box: tuple[float, float, float, float],
    z: float,
    clearance: float = 1.0,
    round_: bool = False,
) -> Surface:
    x0, x1, y0, y1 = box
    return Surface(
        kind=kind,
        x=(x0 + x1) / 2,
        y=(y0 + y1) / 2,
        z=z,
        w=x1 - x0,
        d=y1 - y0,
        clearance=clearance,
        round=round_,
    )


def _volume(kind: str, box: tuple[float, float, float, float], z0: float, z1: float) -> Volume:
    x0, x1, y0, y1 = box
    return Volume(
        kind=kind,
        x=(x0 + x1) / 2,
        y=(y0 + y1) / 2,
        z=(z0 + z1) / 2,
        w=x1 - x0,
        d=y1 - y0,
        h=z1 - z0,
    )


def _inset(size: Size3, margin: float) -> tuple[float, float, float, float]:
    w, d, _ = size
    margin = min(margin, w / 8, d / 8)
    return (-w / 2 + margin, w / 2 - margin, -d / 2 + margin, d / 2 - margin)


def _table(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    return [_rect("top", _inset(size, 0.02), size[2], 1.2, p.get("shape") == "round")]


def _desk(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    if h <= 0.95:
        return [_rect("top", _inset(size, 0.02), h, 1.2)]
    z, hutch = min(0.76, h * 0.6), min(0.3, d * 0.45)
    top = (-w / 2 + 0.02, w / 2 - 0.02, -d / 2 + hutch + 0.01, d / 2 - 0.02)
    shelf = (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.02, -d / 2 + hutch - 0.02)
    return [_rect("top", top, z, h - z), _rect("shelf", shelf, h, 0.4)]


def _counter(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    ledge = float(p.get("ledge", 0.0))
    if ledge <= 0.0:
        return [_rect("top", _inset(size, 0.03), h, 1.0)]
    work = (-w / 2 + 0.05, w / 2 - 0.05, -d / 2 + 0.03, d / 2 - 0.32)
    raised = (-w / 2 + 0.02, w / 2 - 0.02, d / 2 - 0.28, d / 2 - 0.02)
    return [_rect("top", work, h - ledge, 1.0), _rect("ledge", raised, h, 1.0)]


def _chair(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    z = float(p.get("seat", min(0.46, h * 0.54)))
    return [_rect("seat", (-w * 0.38, w * 0.38, -d * 0.26, d * 0.42), z, 0.6)]


def _swivel_chair(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    z = min(0.5, h * 0.5)
    return [_rect("seat", (-w * 0.3, w * 0.3, -d * 0.22, d * 0.3), z, 0.6)]


def _stool(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    round_ = p.get("shape", "round") == "round"
    return [_rect("seat", _inset(size, 0.03), size[2], 0.6, round_)]


def _sofa(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    arm = 0.0 if p.get("arms") is False else min(0.2, w * 0.13)
    back = min(0.28, d * 0.3)
    z = min(0.44, h * 0.52)
    box = (-w / 2 + arm + 0.02, w / 2 - arm - 0.02, -d / 2 + back + 0.02, d / 2 - 0.05)
    return [_rect("seat", box, z, 0.6)]


def _bed(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    tiers = int(p.get("tiers", 2 if h > 1.5 else 1))
    low = min(0.52, h * 0.62) if h > 0.5 else h - min(0.1, h / 2)
    head, side = min(0.45, d * 0.22), 0.06
    box = (-w / 2 + side, w / 2 - side, -d / 2 + head + 0.06, d / 2 - 0.08)
    heights = [low] if tiers == 1 else [low, min(h - 0.3, low + 1.0)]
    return [_rect("mattress", box, z, 0.6) for z in heights]


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
        _rect("shelf", (-w / 2 + 0.04, w / 2 - 0.04, y0, y1), heights[i], gap)
        for i in _free_levels(len(heights), p)
        for y0, y1 in sides
    ]
    if h <= 1.3 and not p.get("no_top"):
        out.append(_rect("top", _inset(size, 0.03), h, 0.8))
    return out


def _cabinet(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    cols, rows = int(p.get("cols", 2)), int(p.get("rows", 1))
    plinth = float(p.get("plinth", min(0.08, h * 0.1)))
    width, height = (w - BOARD) / cols, (h - plinth - BOARD) / rows
    out: list[Carrier] = []
    if h <= 1.45 and not p.get("no_top"):
        out.append(_rect("top", _inset(size, 0.02), h, 1.0))
    for row in range(rows):
        for col in range(cols):
            x0 = -w / 2 + BOARD + col * width
            z0 = plinth + BOARD + row * height
            box = (x0 + 0.005, x0 + width - BOARD - 0.005, -d / 2 + BOARD, d / 2 - BOARD - 0.01)
            out.append(_volume("drawer" if rows > cols else "cell", box, z0, z0 + height - BOARD))
    return out


def _fridge(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    count = int(p.get("shelves", max(1, round(h / 0.42))))
    wall, z0 = 0.05, min(0.12, h * 0.1)
    step = (h - z0 - wall) / count
    box = (-w / 2 + wall, w / 2 - wall, -d / 2 + wall, d / 2 - 0.09)
    return [_volume("shelf", box, z0 + i * step, z0 + (i + 1) * step - 0.02) for i in range(count)]


def _oven(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    wall = min(0.05, w * 0.1)
    box = (
        -w / 2 + wall,
        w / 2 - wall * (3 if p.get("panel") == "side" else 1),
        -d / 2 + wall,
        d / 2 - wall,
    )
    low = float(p.get("base", 0.25 if h > 0.6 else 0.03))
    out: list[Carrier] = [_volume("cavity", box, low, h - max(0.04, h * 0.22 if h > 0.6 else 0.04))]
    if 0.5 < h <= 1.2:
        out.append(_rect("top", _inset(size, 0.05), h, 0.8))
    return out


def _bin(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    wall = min(0.03, 0.12 * min(w, d))
    shrink = 0.72 if p.get("shape", "round") == "round" else 0.9
    box = (
        -w / 2 * shrink + wall,
        w / 2 * shrink - wall,
        -d / 2 * shrink + wall,
        d / 2 * shrink - wall,
    )
    return [_volume("inside", box, min(0.02, h * 0.15), h * 0.92)]


def _trolley(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    h = size[2]
    count = int(p.get("levels", 2))
    rail = float(p.get("rail", 0.08 if h > 0.5 else 0.0))
    top = h - rail
    heights = (
        [top - (top - 0.2) * i / max(1, count - 1) for i in range(count)] if count > 1 else [top]
    )
    gap = (top - 0.2) / max(1, count - 1) - 0.03
    box = _inset(size, 0.05)
    return [_rect("shelf", box, z, 0.8 if i == 0 else gap) for i, z in enumerate(heights)]


def _sink(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    rim = h - float(p.get("splash", 0.0))
    basin = _basin(size)
    out: list[Carrier] = [_volume("basin", basin, rim - min(0.14, rim * 0.6), rim)]
    if basin[0] + w / 2 > 0.22:
        box = (-w / 2 + 0.02, basin[0] - 0.03, -d / 2 + 0.05, d / 2 - 0.03)
        out += [_rect("top", box, rim, 0.5)]
    if p.get("cabinet") and rim > 0.5:
        body = (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.03, d / 2 - 0.05)
        out.append(_volume("cell", body, 0.12, rim - 0.2))
    return out


def _basin(size: Size3) -> tuple[float, float, float, float]:
    w, d, _ = size
    half = min(w * 0.42, 0.26)
    shift = max(0.0, min(w / 2 - half - 0.05, 0.12)) if w > 0.9 else 0.0
    return (shift - half, shift + half, -d * 0.22, d * 0.4)


def _bathtub(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    h = size[2]
    return [_volume("basin", _inset(size, 0.1), h * 0.25, h)]


def _toilet(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    return [
        _rect("tank", (-w * 0.38, w * 0.38, -d / 2 + 0.02, -d / 2 + min(0.17, d * 0.24)), h, 0.5)
    ]


def _vitrine(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    base = float(p.get("base", min(0.9, h * 0.55)))
    box = (-w / 2 + 0.04, w / 2 - 0.04, -d / 2 + 0.04, d / 2 - 0.04)
    count = int(p.get("levels", 1))
    step = (h - 0.03 - base) / count
    return [
        _volume("case", box, base + i * step, base + (i + 1) * step - 0.02) for i in range(count)
    ]


def _open_top(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    """A tray of goods: stands, chest freezers, cradles."""
    h = size[2]
    depth = float(p.get("depth", h * 0.3))
    return [_volume("tray", _inset(size, 0.05), h - depth, h)]


def _bench(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    z = min(0.46, h * 0.52) if p.get("back") else h
    return [_rect("seat", (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.08, d / 2 - 0.03), z, 0.6)]


def _cubicle(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, _ = size
    box = (-w / 2 + 0.07, w / 2 - 0.07, -d / 2 + 0.07, -d / 2 + min(0.75, d * 0.8) - 0.03)
    return [_rect("top", box, 0.74, 1.0)]


def _control_desk(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, _ = size
    return [_rect("top", (-w / 2 + 0.04, w / 2 - 0.04, 0.2, d / 2 - 0.02), 0.75, 1.0)]


def _salon_station(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, _ = size
    return [_rect("shelf", (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.07, d / 2 - 0.02), 0.82, 0.8)]


def _washer(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    high = h / int(p.get("stack", 1))
    box = (-w * 0.3, w * 0.3, -d * 0.35, d * 0.3)
    return [_volume("drum", box, high * 0.2, high * 0.72)]


def _wall_shelf(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    return [_rect("shelf", _inset(size, 0.015), size[2], 0.45)]


def _plate(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    return [_rect("top", (-w * 0.3, w * 0.3, -d * 0.3, d * 0.3), h * 0.4, 0.3, True)]


_RULES: dict[str, Rule] = {
    "bathtub": _bathtub,
    "bed": _bed,
    "bench": _bench,
    "bin": _bin,
    "bowl": _bin,
    "cabinet": _cabinet,
    "chair": _chair,
    "control_desk": _control_desk,
    "counter": _counter,
    "cubicle": _cubicle,
    "desk": _desk,
    "fridge": _fridge,
    "open_top": _open_top,
    "oven": _oven,
    "plate": _plate,
    "salon_station": _salon_station,
    "shelf": _shelf,
    "sink": _sink,
    "sofa": _sofa,
    "stool": _stool,
    "swivel_chair": _swivel_chair,
    "table": _table,
    "toilet": _toilet,
    "trolley": _trolley,
    "vitrine": _vitrine,
    "wall_shelf": _wall_shelf,
    "washer": _washer,
}


def surfaces_of(
    recipe: str, size: Size3, parameters: dict[str, Any]
) -> tuple[tuple[Surface, ...], tuple[Volume, ...]]:
    """Return the surfaces and inner volumes of an asset in its own frame.

    Parameters
    ----------
    recipe : str
        Name of the mesh recipe; ``carrier`` in `parameters` names another rule, or ``none``.
    size : (float, float, float)
        Width, depth, height in metres.

    Examples
    --------
    >>> surfaces_of("table", (1.2, 0.8, 0.75), {})[0][0].z
    0.375
    """
    rule = _RULES.get(str(parameters.get("carrier", recipe)))
    if rule is None:
        return (), ()
    surfaces: list[Surface] = []
    volumes: list[Volume] = []
    half = size[2] / 2
    for carrier in rule(size, parameters):
        low = min(carrier.w, carrier.d)
        if isinstance(carrier, Surface) and low > 0.04:
            surfaces.append(_lowered(carrier, half))
        elif isinstance(carrier, Volume) and low > 0.03 and carrier.h > 0.03:
            volumes.append(_sunk(carrier, half))
    return tuple(surfaces), tuple(volumes)


def _lowered(s: Surface, dz: float) -> Surface:
    return Surface(
        kind=s.kind,
        x=_mm(s.x),
        y=_mm(s.y),
        z=_mm(s.z - dz),
        w=_mm(s.w),
        d=_mm(s.d),
        clearance=_mm(s.clearance),
        round=s.round,
    )


def _sunk(v: Volume, dz: float) -> Volume:
    return Volume(
        kind=v.kind, x=_mm(v.x), y=_mm(v.y), z=_mm(v.z - dz), w=_mm(v.w), d=_mm(v.d), h=_mm(v.h)
    )


def _mm(value: float) -> float:
    return round(value, 4)
