"""Warehouse equipment: racks, pallets and crates; forklifts, pallet jacks, hand trucks, ladders."""

from itertools import product

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

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


@recipe("forklift")
def forklift(b: Builder) -> None:
    """Truck with mast and forks to the front."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    rear, mast = -d / 2, d * 0.08
    b.cushion((-w / 2, w / 2), (rear, mast - 0.3), (0.15, h * 0.5), m, "body", 0.2, 12)
    b.box((-w * 0.3, w * 0.3), (rear + 0.3, mast - 0.5), (h * 0.5, h * 0.56), "leather_black", "seat")
    b.box((-w * 0.3, w * 0.3), (rear + 0.28, rear + 0.4), (h * 0.54, h * 0.76), "leather_black", "seat")
    b.box((-w * 0.46, w * 0.46), (mast - 0.35, mast - 0.1), (0.2, h * 0.48), m, "front")
    for sx in (-1, 1):
        b.rod((sx * w * 0.42, rear + 0.25, h * 0.45), (sx * w * 0.4, rear + 0.35, h - 0.03), 0.03, "metal_dark", "cage")
        b.rod((sx * w * 0.42, mast - 0.2, h * 0.45), (sx * w * 0.4, mast - 0.35, h - 0.03), 0.03, "metal_dark", "cage")
        b.box((sx * w * 0.28 - 0.05, sx * w * 0.28 + 0.05), (mast, mast + 0.1), (0.05, h), "metal_dark", "mast")
        b.box((sx * w * 0.25 - 0.07, sx * w * 0.25 + 0.07), (mast + 0.1, d / 2), (0.03, 0.08), "metal_dark", "forks")
        for y, r in ((rear + 0.45, 0.22), (mast - 0.18, 0.28)):
            b.rod((sx * w * 0.36, y, r), (sx * w * 0.5, y, r), r, "rubber_black", "wheels", 20)
    b.box((-w * 0.42, w * 0.42), (rear + 0.3, mast - 0.3), (h - 0.06, h - 0.02), "metal_dark", "cage", solid=False)
    b.box((-w * 0.4, w * 0.4), (mast + 0.1, mast + 0.15), (0.06, h * 0.35), "metal_dark", "carriage")


@recipe("pallet_jack")
def pallet_jack(b: Builder) -> None:
    """Two forks and a drawbar."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        b.box((sx * w * 0.35 - 0.08, sx * w * 0.35 + 0.08), (-d * 0.25, d / 2), (0.06, 0.12), b.mat(), "forks")
        b.rod(
            (sx * w * 0.35 - 0.05, d * 0.42, 0.04),
            (sx * w * 0.35 + 0.05, d * 0.42, 0.04),
            0.04,
            "rubber_black",
            "wheels",
            12,
        )
    b.box((-w / 2, w / 2), (-d * 0.34, -d * 0.22), (0.06, 0.4), b.mat(), "body")
    b.rod((-0.08, -d * 0.3, 0.09), (0.08, -d * 0.3, 0.09), 0.09, "rubber_black", "wheels", 16)
    b.rod((0, -d * 0.32, 0.35), (0, -d * 0.46, h - 0.1), 0.025, b.mat(), "drawbar", solid=True)
    b.path(
        [
            (-0.14, -d / 2 + 0.02, h - 0.12),
            (-0.14, -d / 2 + 0.02, h - 0.02),
            (0.14, -d / 2 + 0.02, h - 0.02),
            (0.14, -d / 2 + 0.02, h - 0.12),
            (-0.14, -d / 2 + 0.02, h - 0.12),
        ],
        0.018,
        "plastic_black",
        "handle",
    )


@recipe("hand_truck")
def hand_truck(b: Builder) -> None:
    """Frame with a plate and two wheels."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.06)
        b.path(
            [(x, d * 0.1, 0.02), (x, -d * 0.2, h * 0.75), (x * 0.8, -d / 2 + 0.02, h - 0.02)], 0.018, b.mat(), "frame"
        )
        b.rod((sx * (w / 2 - 0.05), -d * 0.1, 0.13), (sx * w / 2, -d * 0.1, 0.13), 0.13, "rubber_black", "wheels", 18)
    for z in (0.3, 0.6, 0.9):
        y = d * 0.1 - 0.3 * d * z / (h * 0.75)
        b.box((-w / 2 + 0.06, w / 2 - 0.06), (y - 0.01, y + 0.01), (z, z + 0.03), b.mat(), "bars")
    b.box((-w * 0.4, w * 0.4), (0.02, d / 2), (0, 0.02), b.mat(), "plate")
    b.rod((-w * 0.3, -d / 2 + 0.02, h - 0.02), (w * 0.3, -d / 2 + 0.02, h - 0.02), 0.018, "plastic_black", "grip")


@recipe("ladder")
def ladder(b: Builder) -> None:
    """Step ladder."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.02)
        b.prism(
            [(d / 2, 0), (d / 2 - 0.05, 0), (-0.04, h - 0.03), (0.02, h - 0.03)],
            (x - 0.02, x + 0.02),
            b.mat(),
            part="rails",
        )
        b.rod((x, -d / 2 + 0.015, 0), (x, -0.02, h - 0.05), 0.014, b.mat(), "rails")
    count = max(4, round(h / 0.28))
    for k in range(1, count):
        z = k * h / count
        y = d / 2 - 0.03 - (d / 2) * z / h
        b.box((-w / 2 + 0.02, w / 2 - 0.02), (y - 0.04, y + 0.04), (z, z + 0.025), b.mat(), "steps")
    b.box((-w / 2, w / 2), (-0.1, 0.1), (h - 0.03, h), "plastic_red", "top")
