"""Boxes and box-shaped objects: cartons, parcels, cases, loudspeakers, pads."""

from mansion_assets.builder import Builder
from mansion_assets.registry import Recipe, recipe

__all__: list[str] = []


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
            solid=False,
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
    b.box((-0.03, 0.03), (d / 2 - 0.021, d / 2 - 0.018), (0, low), "paper_beige", "tape", solid=False)


def _suitcase(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (0.05, h - 0.08), b.mat(), "shell", 0.3, 12)
    for k in range(4):
        x = -w * 0.36 + k * w * 0.24
        b.box((x - 0.008, x + 0.008), (d / 2 - 0.003, d / 2), (h * 0.16, h * 0.8), "plastic_dark", "ribs", solid=False)
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
        b.box((-w * 0.42, w * 0.42), (-d * 0.4, d * 0.42), (floor, h * 0.3), "paper_white", "papers", solid=False)


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
    b.box((-0.02, 0.02), (d / 2 - 0.012, d / 2), (low * 0.85, low * 1.05), "metal_steel", "latch", solid=False)


def _tissue(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.75), b.mat(), "box")
    b.cushion((-w * 0.18, w * 0.18), (-d * 0.12, d * 0.12), (h * 0.7, h), "paper_white", "tissue", 0.9, 8, solid=False)


@recipe("block")
def block(b: Builder) -> None:
    """Box-shaped things, told apart by what is on them."""
    _BLOCKS.get(str(b.p.get("style", "plain")), _plain)(b)


def _plain(b: Builder) -> None:
    """Plain box."""
    w, d, h = b.w, b.d, b.h
    x, y = (-w / 2, w / 2), (-d / 2, d / 2)
    main = b.mat()
    b.box(x, y, (0, h), main, "body")


def _speaker(b: Builder) -> None:
    """Case with two cones."""
    w, d, h = b.w, b.d, b.h
    x = (-w / 2, w / 2)
    main = b.mat()
    b.box(x, (-d / 2, d / 2 - 0.012), (0, h), main, "case")
    wide = min(w, 0.8 * h)
    for z, r in ((0.32, 0.36), (0.74, 0.22)):
        b.rod((0, d / 2 - 0.014, z * h), (0, d / 2, z * h), r * wide, "plastic_dark", "cones", 20)
        b.rod((0, d / 2 - 0.013, z * h), (0, d / 2 - 0.001, z * h), r * wide * 0.4, "metal_grey", "cones", 12)


def _wrapped(b: Builder) -> None:
    """Box with a band and a bow."""
    w, d, h = b.w, b.d, b.h
    x, y = (-w / 2, w / 2), (-d / 2, d / 2)
    main = b.mat()
    b.box(x, y, (0, h * 0.95), main, "body")
    b.box((-w * 0.06, w * 0.06), y, (0, h * 0.96), "paper_white", "band", solid=False)
    b.box(x, (-d * 0.06, d * 0.06), (0, h * 0.96), "paper_white", "band", solid=False)
    b.ball((0, 0, h * 0.96), (w * 0.12, d * 0.12, h * 0.04), "paper_white", "bow", 8, solid=False)


def _knives(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.prism([(-d / 2, 0), (d / 2, 0), (d * 0.2, h * 0.72), (-d / 2, h * 0.6)], (-w / 2, w / 2), b.mat())
    for k in range(4):
        x = -w * 0.3 + k * w * 0.2
        b.rod((x, -d * 0.1, h * 0.6), (x, -d * 0.3, h - 0.01), 0.009, "plastic_black", "handles", 6)


def _clipboard(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.35), b.mat(), "board")
    b.box((-w * 0.44, w * 0.44), (-d * 0.46, d * 0.36), (h * 0.35, h * 0.45), "paper_white", "sheet", solid=False)
    b.box((-w * 0.18, w * 0.18), (d * 0.36, d * 0.48), (h * 0.35, h), "metal_steel", "clip")


def _pad(b: Builder) -> None:
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d * 0.1, d / 2), (0, h * 0.75), b.mat(), "body", 0.9)
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * w * 0.2))
        b.cushion((lo, hi), (-d / 2, d * 0.2), (0, h * 0.7), b.mat(), "grips", 0.9)
        b.cyl(sx * w * 0.15, 0.0, (h * 0.7, h), w * 0.06, "plastic_dark", "sticks", n=10, solid=False)


_BLOCKS: dict[str, Recipe] = {
    "carton_open": _carton_open,
    "lidbox": _lidbox,
    "suitcase": _suitcase,
    "tissue": _tissue,
    "tray": _tray,
    "clipboard": _clipboard,
    "gift": _wrapped,
    "knives": _knives,
    "pad": _pad,
    "speaker": _speaker,
}


@recipe("package")
def package(b: Builder) -> None:
    """A carton closed with tape over its top and front, with an address label and a bar code on it."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h), "paper_c39a62", "carton")
    b.box((-w / 2, w / 2), (-d * 0.008, d * 0.008), (h, h + 0.0006), "paper_brown", "seam", solid=False)
    b.box((-w / 2, w / 2), (-d * 0.09, d * 0.09), (h, h + 0.0004), "plastic_e6cf9f", "tape", solid=False)
    for side in (-1, 1):
        ends = sorted((side * w / 2, side * (w / 2 + 0.0006)))
        b.box((ends[0], ends[1]), (-d * 0.09, d * 0.09), (h * 0.6, h), "plastic_e6cf9f", "tape", solid=False)
    b.box((-w * 0.38, w * 0.1), (d / 2, d / 2 + 0.0006), (h * 0.28, h * 0.84), "paper_white", "label", solid=False)
    for k, high in enumerate((0.74, 0.66, 0.58)):
        b.box(
            (-w * 0.34, -w * 0.04 * (k + 1)),
            (d / 2, d / 2 + 0.001),
            (h * high, h * (high + 0.03)),
            "plastic_black",
            "address",
            solid=False,
        )
    for k in range(9):
        x = -w * 0.34 + k * w * 0.044
        b.box(
            (x, x + w * (0.01 + 0.012 * (k % 2))),
            (d / 2, d / 2 + 0.001),
            (h * 0.33, h * 0.5),
            "plastic_black",
            "bar_code",
            solid=False,
        )
