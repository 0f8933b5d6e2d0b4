"""Boxes that hold something: cartons, bags, suitcases, trays and lidded boxes."""

from mansion_assets.builder import Builder
from mansion_assets.registry import Recipe

__all__ = ["CASES"]


def _carton(b: Builder) -> None:
    """Carton with labels; a tall one has a gable."""
    w, d, h = b.w, b.d, b.h
    x, y = (-w / 2, w / 2), (-d / 2, d / 2)
    main = b.mat()
    high = h * (0.86 if h > 1.3 * w else 1.0)
    b.box(x, y, (0, high), main, "body")
    if high < h:
        b.prism(
            [(-d / 2, high), (d / 2, high), (0.004, h * 0.97), (0.004, h), (-0.004, h), (-0.004, h * 0.97)],
            x,
            "paper_white",
            part="gable",
        )
    b.box((-w * 0.32, w * 0.32), (d / 2 - 0.001, d / 2), (high * 0.3, high * 0.7), "paper_white", "label", False)
    b.box((-w * 0.36, w * 0.36), (d / 2 - 0.001, d / 2), (high * 0.74, high * 0.84), "paper_yellow", "label", False)


def _carton_open(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    t, low = 0.008, b.h * 0.92
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.02, d / 2 - 0.02), (0, t), b.mat(), "floor")
    for sx in (-1, 1):
        lo, hi = sorted((sx * (w / 2 - 0.02), sx * (w / 2 - 0.02 - t)))
        b.box((lo, hi), (-d / 2 + 0.02, d / 2 - 0.02), (0, low), b.mat(), "sides")
        b.prism(
            [(sx * (w / 2 - 0.02), low), (sx * w / 2, h), (sx * (w / 2 - 0.005), h), (sx * (w / 2 - 0.03), low)],
            (-d / 2 + 0.02, d / 2 - 0.02),
            b.mat(),
            "y",
            "flaps",
            False,
        )
    for sy in (-1, 1):
        lo, hi = sorted((sy * (d / 2 - 0.02), sy * (d / 2 - 0.02 - t)))
        b.box((-w / 2 + 0.02, w / 2 - 0.02), (lo, hi), (0, low), b.mat(), "sides")
        b.prism(
            [(sy * (d / 2 - 0.02), low), (sy * d / 2, h), (sy * (d / 2 - 0.005), h), (sy * (d / 2 - 0.03), low)],
            (-w / 2 + 0.02, w / 2 - 0.02),
            b.mat(),
            part="flaps",
            solid=False,
        )
    b.box((-0.03, 0.03), (d / 2 - 0.021, d / 2 - 0.018), (0, low), "paper_beige", "tape", False)


def _bag(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    low = h * 0.74
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0, low), b.mat(), "body", 0.35, 12)
    for sy in (-1, 1):
        y = sy * d * 0.25
        b.path(
            [
                (-w * 0.22, y, low * 0.95),
                (-w * 0.18, y, h - 0.008),
                (w * 0.18, y, h - 0.008),
                (w * 0.22, y, low * 0.95),
            ],
            0.008,
            "leather_dark",
            "handles",
        )
    b.box((-w * 0.25, w * 0.25), (d / 2 - 0.003, d / 2), (low * 0.2, low * 0.5), "fabric_dark", "pocket", False)


def _suitcase(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0.05, h - 0.08), b.mat(), "shell", 0.3, 12)
    for k in range(4):
        x = -w * 0.36 + k * w * 0.24
        b.box((x - 0.008, x + 0.008), (d / 2 - 0.003, d / 2), (h * 0.16, h * 0.8), "plastic_dark", "ribs", False)
    b.wheels(0.025, 0.06)
    b.path(
        [
            (-w * 0.2, -d * 0.3, h - 0.1),
            (-w * 0.2, -d * 0.3, h - 0.01),
            (w * 0.2, -d * 0.3, h - 0.01),
            (w * 0.2, -d * 0.3, h - 0.1),
        ],
        0.01,
        "metal_steel",
        "handle",
    )


def _tray(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    t = min(0.012, w * 0.05)
    floor = min(0.006, h * 0.3)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, floor), b.mat(), "floor")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - t)))
        b.box((lo, hi), (-d / 2, d / 2), (0, h), b.mat(), "rim")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + t), (0, h), b.mat(), "rim")
    b.box((-w / 2, w / 2), (d / 2 - t, d / 2), (0, h if h < 0.06 else h * 0.3), b.mat(), "rim")
    if h > 0.06:
        b.box((-w * 0.42, w * 0.42), (-d * 0.4, d * 0.42), (floor, h * 0.3), "paper_white", "papers", False)


def _lidbox(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    low = h * 0.78
    b.box((-w / 2 + 0.004, w / 2 - 0.004), (-d / 2 + 0.004, d / 2 - 0.012), (0, low), b.mat(), "body")
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.008), (low, h * 0.86), b.mat(), "lid")
    b.path(
        [(-w * 0.22, 0, h * 0.85), (-w * 0.2, 0, h - 0.008), (w * 0.2, 0, h - 0.008), (w * 0.22, 0, h * 0.85)],
        0.008,
        "plastic_black",
        "handle",
    )
    b.box((-0.02, 0.02), (d / 2 - 0.012, d / 2), (low * 0.85, low * 1.05), "metal_steel", "latch", False)


def _tissue(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.75), b.mat(), "box")
    b.cushion((-w * 0.18, w * 0.18), (-d * 0.12, d * 0.12), (h * 0.7, h), "paper_white", "tissue", 0.9, 8, False)


CASES: dict[str, Recipe] = {
    "bag": _bag,
    "carton": _carton,
    "carton_open": _carton_open,
    "lidbox": _lidbox,
    "suitcase": _suitcase,
    "tissue": _tissue,
    "tray": _tray,
}
"""From a style of the recipe ``block`` to its shape."""
