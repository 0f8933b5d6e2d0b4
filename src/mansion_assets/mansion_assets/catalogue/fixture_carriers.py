"""What holds things in appliances, basins, bins, show cases and dishes."""

from typing import Any

from mansion_assets.catalogue.carriers import Carrier, Rule, inset, rect, volume
from mansion_msgs_py.shapes import Size3

__all__ = ["FIXTURES"]


def _fridge(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    count = int(p.get("shelves", max(1, round(h / 0.42))))
    wall, z0 = 0.05, min(0.12, h * 0.1)
    step = (h - z0 - wall) / count
    box = (-w / 2 + wall, w / 2 - wall, -d / 2 + wall, d / 2 - 0.09)
    return [volume("shelf", box, z0 + i * step, z0 + (i + 1) * step - 0.02) for i in range(count)]


def _oven(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    wall = min(0.05, w * 0.1)
    box = (-w / 2 + wall, w / 2 - wall * (3 if p.get("panel") == "side" else 1), -d / 2 + wall, d / 2 - wall)
    low = float(p.get("base", 0.25 if h > 0.6 else 0.03))
    out: list[Carrier] = [volume("cavity", box, low, h - max(0.04, h * 0.22 if h > 0.6 else 0.04))]
    if 0.5 < h <= 1.2:
        out.append(rect("top", inset(size, 0.05), h, 0.8))
    return out


def _washer(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    high = h / int(p.get("stack", 1))
    box = (-w * 0.3, w * 0.3, -d * 0.35, d * 0.3)
    return [volume("drum", box, high * 0.2, high * 0.72)]


def _sink(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    rim = h - float(p.get("splash", 0.0))
    basin = _basin(size)
    out: list[Carrier] = [volume("basin", basin, rim - min(0.14, rim * 0.6), rim)]
    if basin[0] + w / 2 > 0.22:
        box = (-w / 2 + 0.02, basin[0] - 0.03, -d / 2 + 0.05, d / 2 - 0.03)
        out += [rect("top", box, rim, 0.5)]
    if p.get("cabinet") and rim > 0.5:
        body = (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.03, d / 2 - 0.05)
        out.append(volume("cell", body, 0.12, rim - 0.2))
    return out


def _basin(size: Size3) -> tuple[float, float, float, float]:
    w, d, _ = size
    half = min(w * 0.42, 0.26)
    shift = max(0.0, min(w / 2 - half - 0.05, 0.12)) if w > 0.9 else 0.0
    return (shift - half, shift + half, -d * 0.22, d * 0.4)


def _bathtub(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    h = size[2]
    return [volume("basin", inset(size, 0.1), h * 0.25, h)]


def _toilet(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    return [rect("tank", (-w * 0.38, w * 0.38, -d / 2 + 0.02, -d / 2 + min(0.17, d * 0.24)), h, 0.5)]


def _bin(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    wall = min(0.03, 0.12 * min(w, d))
    shrink = 0.72 if p.get("shape", "round") == "round" else 0.9
    box = (-w / 2 * shrink + wall, w / 2 * shrink - wall, -d / 2 * shrink + wall, d / 2 * shrink - wall)
    return [volume("inside", box, min(0.02, h * 0.15), h * 0.92)]


def _vitrine(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    base = float(p.get("base", min(0.9, h * 0.55)))
    box = (-w / 2 + 0.04, w / 2 - 0.04, -d / 2 + 0.04, d / 2 - 0.04)
    count = int(p.get("levels", 1))
    step = (h - 0.03 - base) / count
    return [volume("case", box, base + i * step, base + (i + 1) * step - 0.02) for i in range(count)]


def _open_top(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    """A tray of goods: stands, chest freezers, cradles."""
    h = size[2]
    depth = float(p.get("depth", h * 0.3))
    return [volume("tray", inset(size, 0.05), h - depth, h)]


def _plate(size: Size3, p: dict[str, Any]) -> list[Carrier]:
    w, d, h = size
    return [rect("top", (-w * 0.3, w * 0.3, -d * 0.3, d * 0.3), h * 0.4, 0.3, True)]


FIXTURES: dict[str, Rule] = {
    "bathtub": _bathtub,
    "bin": _bin,
    "bowl": _bin,
    "fridge": _fridge,
    "open_top": _open_top,
    "oven": _oven,
    "plate": _plate,
    "sink": _sink,
    "toilet": _toilet,
    "vitrine": _vitrine,
    "washer": _washer,
}
"""From a recipe of an appliance, a basin, a bin, a show case or a dish to its rule."""
