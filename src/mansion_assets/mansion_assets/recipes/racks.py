"""Pallets, racks, crates and glass cases."""

from itertools import product
from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, volume
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@recipe("pallet_rack")
def pallet_rack(b: Builder) -> None:
    """Uprights and beams with loaded pallets."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (w / 2 - 0.05), sy * (d / 2 - 0.05)
            b.box((x - 0.05, x + 0.05), (y - 0.05, y + 0.05), (0, h), b.mat(), "posts")
        b.rod(
            (sx * (w / 2 - 0.05), -d / 2 + 0.05, 0.2),
            (sx * (w / 2 - 0.05), d / 2 - 0.05, h * 0.5),
            0.02,
            b.mat(),
            "braces",
        )
        b.rod(
            (sx * (w / 2 - 0.05), d / 2 - 0.05, h * 0.5),
            (sx * (w / 2 - 0.05), -d / 2 + 0.05, h * 0.95),
            0.02,
            b.mat(),
            "braces",
        )
    levels = (0.12, h * 0.36, h * 0.68)
    for n, z in enumerate(levels):
        for sy in (-1, 1):
            y = sy * (d / 2 - 0.05)
            b.box((-w / 2 + 0.1, w / 2 - 0.1), (y - 0.03, y + 0.03), (z - 0.12, z), "metal_orange", "beams")
        count = 2 if w > 2.0 else 1
        for k in range(count):
            x0 = -w / 2 + 0.12 + k * (w - 0.24) / count
            x1 = x0 + (w - 0.24) / count - 0.06
            b.box((x0, x1), (-d / 2 + 0.02, d / 2 - 0.02), (z, z + 0.1), "wood_birch", "pallets")
            top = z + 0.1 + (h * 0.3 - 0.26) * (1.0, 0.75, 0.9)[(n + k) % 3]
            b.box(
                (x0 + 0.03, x1 - 0.03),
                (-d / 2 + 0.06, d / 2 - 0.06),
                (z + 0.1, top),
                ("paper_brown", "paper_beige", "plastic_blue")[(n * 2 + k) % 3],
                "loads",
            )


@recipe("pallet")
def pallet(b: Builder) -> None:
    """A pallet of cartons, or a stack of empty pallets."""
    w, d, h = b.w, b.d, b.h
    if b.p.get("style") == "stack":
        count = max(2, round(h / 0.15))
        for k in range(count):
            _empty_pallet(b, k * (h / count), h / count, gap=0.01 * (k < count - 1))
        b.boxes.append(b.whole_box())
        return
    high = 0.145
    _empty_pallet(b, 0.0, high, gap=0.0)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, high), "wood_birch", "deck", solid=False)
    _cartons(b, high)
    b.boxes.append(b.whole_box())


def _empty_pallet(b: Builder, z: float, high: float, *, gap: float) -> None:
    """Add blocks and boards from height `z` on, with a `gap` below the next pallet."""
    w, d = b.w, b.d
    board, top = high * 0.15, z + high - gap
    for sy in (-1, 0, 1):
        y = (sy * (d / 2 - 0.06) - 0.06, sy * (d / 2 - 0.06) + 0.06)
        b.box((-w / 2, w / 2), y, (z, z + board), "wood_birch", "boards", solid=False)
        for sx in (-1, 0, 1):
            x = (sx * (w / 2 - 0.07) - 0.07, sx * (w / 2 - 0.07) + 0.07)
            b.box(x, y, (z + board, top - 2 * board), "wood_oak", "blocks", solid=False)
    for sx in (-1, 0, 1):
        x = (sx * (w / 2 - 0.07) - 0.07, sx * (w / 2 - 0.07) + 0.07)
        b.box(x, (-d / 2, d / 2), (top - 2 * board, top - board), "wood_birch", "boards", solid=False)
    for j in range(5):
        y = (-d / 2 + j * (d - 0.12) / 4, -d / 2 + j * (d - 0.12) / 4 + 0.12)
        b.box((-w / 2, w / 2), y, (top - board, top), "wood_birch", "boards", solid=False)


def _cartons(b: Builder, low: float) -> None:
    """Add rows of cartons from height `low` to the top, with joints between them."""
    w, d = b.w, b.d
    rows = max(1, round((b.h - low) / 0.3))
    step = (b.h - low) / rows
    for k, i, j in product(range(rows), range(3), range(2)):
        x0, y0 = -w / 2 + 0.01 + i * (w - 0.02) / 3, -d / 2 + 0.01 + j * (d - 0.02) / 2
        z = low + k * step
        b.box(
            (x0, x0 + (w - 0.02) / 3 - 0.006),
            (y0, y0 + (d - 0.02) / 2 - 0.006),
            (z, z + step - (0.006 if k < rows - 1 else 0)),
            "paper_brown" if (i + j + k) % 3 else "paper_beige",
            "cartons",
            solid=False,
        )


@recipe("crate")
def crate(b: Builder) -> None:
    """Open box of slats or plastic."""
    w, d, h = b.w, b.d, b.h
    t = min(0.025, w * 0.05)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, t), b.mat(), "bottom")
    count = max(2, round(h / 0.15))
    for k in range(count):
        z0, z1 = h * k / count + 0.006 * (k > 0), h * (k + 1) / count - 0.006 * (k < count - 1)
        for sy in (-1, 1):
            lo, hi = sorted((sy * d / 2, sy * (d / 2 - t)))
            b.box((-w / 2, w / 2), (lo, hi), (z0, z1), b.mat(), "slats")
        for sx in (-1, 1):
            lo, hi = sorted((sx * w / 2, sx * (w / 2 - t)))
            b.box((lo, hi), (-d / 2, d / 2), (z0, z1), b.mat(), "slats")


@recipe("rack")
def server_rack(b: Builder) -> None:
    """Server cabinet with a perforated door and lit units."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.03), (0.05, h), b.mat(), "case")
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.05, d / 2 - 0.06), (0, 0.05), "metal_dark", "feet")
    count = int((h - 0.3) / 0.09)
    for k in range(count):
        z = 0.15 + k * 0.09
        b.box(
            (-w / 2 + 0.06, w / 2 - 0.06),
            (d / 2 - 0.03, d / 2 - 0.018),
            (z, z + 0.075),
            "metal_dark" if k % 3 else "metal_grey",
            "units",
            solid=False,
        )
        b.box(
            (w / 2 - 0.12, w / 2 - 0.09),
            (d / 2 - 0.018, d / 2 - 0.014),
            (z + 0.03, z + 0.045),
            "light_green" if k % 4 else "light_blue",
            "leds",
            solid=False,
        )
    for x in (-w / 2 + 0.025, w / 2 - 0.025):
        b.box((x - 0.025, x + 0.025), (d / 2 - 0.03, d / 2), (0.05, h), b.mat(), "door", solid=False)
    b.box((-w / 2, w / 2), (d / 2 - 0.03, d / 2), (h - 0.06, h), b.mat(), "door", solid=False)


@recipe("luggage_rack")
def luggage_rack(b: Builder) -> None:
    """Folding stand with straps."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.02)
        b.rod((x, -d / 2 + 0.02, 0.0), (x, d / 2 - 0.02, h - 0.02), 0.018, b.mat(), "legs", solid=True)
        b.rod((x, d / 2 - 0.02, 0.0), (x, -d / 2 + 0.02, h - 0.02), 0.018, b.mat(), "legs")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.012, h), "fabric_dark", "straps")
    for sy in (-1, 1):
        y = sy * (d / 2 - 0.018)
        b.rod((-w / 2, y, h - 0.02), (w / 2, y, h - 0.02), 0.018, b.mat(), "rails")


@receptacles("vitrine")
def _vitrine_levels(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    base = float(p.get("base", min(0.9, h * 0.55)))
    box = (-w / 2 + 0.04, w / 2 - 0.04, -d / 2 + 0.04, d / 2 - 0.04)
    count = int(p.get("levels", 1))
    step = (h - 0.03 - base) / count
    return [volume("case", box, base + i * step, base + (i + 1) * step - 0.02) for i in range(count)]


@recipe("vitrine")
def vitrine(b: Builder) -> None:
    """Glass case on a base, with exhibits, bread or fish."""
    w, d, h = b.w, b.d, b.h
    base = float(b.p.get("base", min(0.9, h * 0.55)))
    fill, main = b.p.get("fill", "none"), b.mat()
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, base - 0.02), main, "base")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.03, h), main if fill != "exhibit" else "metal_dark", "lid")
    glass = "glass_clear"
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.01)))
        b.box((lo, hi), (-d / 2, d / 2), (base - 0.02, h - 0.03), glass, "glass")
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2, sy * (d / 2 - 0.01)))
        b.box((-w / 2, w / 2), (lo, hi), (base - 0.02, h - 0.03), glass, "glass")
    levels = int(b.p.get("levels", 1))
    step = (h - 0.03 - base) / levels
    for k in range(levels):
        z = base + k * step
        b.box(
            (-w / 2 + 0.012, w / 2 - 0.012),
            (-d / 2 + 0.012, d / 2 - 0.012),
            (z - 0.02, z),
            "fabric_white" if fill == "exhibit" else main,
            "boards",
            solid=False,
        )
        _exhibits(b, str(fill), z, step)


def _exhibits(b: Builder, fill: str, z: float, room: float) -> None:
    w, d = b.w, b.d
    if fill == "water":
        b.box(
            (-w / 2 + 0.012, w / 2 - 0.012),
            (-d / 2 + 0.012, d / 2 - 0.012),
            (z, z + room * 0.85),
            "glass_blue",
            "water",
            solid=False,
        )
        for k in range(6):
            x = -w * 0.35 + k * w * 0.14
            b.ball(
                (x, 0.05 * (-1) ** k, z + room * (0.2 + 0.1 * (k % 4))),
                (0.04, 0.012, 0.02),
                "paint_orange",
                "fish",
                8,
                solid=False,
            )
    elif fill == "bread":
        for k in range(max(2, int(w / 0.22))):
            x = -w / 2 + 0.13 + k * 0.22
            b.ball(
                (x, 0, z + 0.05),
                (0.08, min(0.14, d * 0.3), 0.05),
                ("food_brown", "food_beige")[k % 2],
                "bread",
                8,
                solid=False,
            )
