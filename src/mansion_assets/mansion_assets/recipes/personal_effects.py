"""What people carry in pockets and wear."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("keys")
def keys(b: Builder) -> None:
    """Ring with keys."""
    w, d, h = b.w, b.d, b.h
    r = min(w, d) * 0.3
    points = [(-w / 2 + r + r * math.cos(a), r * math.sin(a), h / 2) for a in [k * math.pi / 6 for k in range(13)]]
    b.path(points, h * 0.3, b.mat(), "ring")
    for y, color in ((-d * 0.3, "metal_steel"), (d * 0.3, "metal_brass")):
        b.box((-w * 0.1, w / 2), (y - d * 0.1, y + d * 0.1), (0, h), color, "keys")
        b.cyl(-w * 0.05, y, (0, h), d * 0.2, color, "keys", n=10)


@recipe("wallet")
def wallet(b: Builder) -> None:
    """Two folds of leather that lie on each other, with notes and a card between them."""
    w, d, h = b.w, b.d, b.h
    for z in ((0, h * 0.36), (h * 0.64, h)):
        b.cushion((-w / 2, w / 2), (-d / 2, d * 0.4), z, b.mat(), "folds", 0.3)
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.46), (h * 0.1, h * 0.9), b.mat(), "spine")
    b.box((-w * 0.46, w * 0.46), (-d * 0.44, d * 0.46), (h * 0.36, h * 0.5), "paper_green", "notes")
    b.box((-w * 0.3, w * 0.42), (-d * 0.4, d / 2), (h * 0.5, h * 0.64), "plastic_blue", "card")


@recipe("credit_card")
def credit_card(b: Builder) -> None:
    """A card with a gold chip, a number in four groups, and two circles that overlap."""
    w, d, h = b.w, b.d, b.h
    z = (h, h * 1.04)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h), b.mat(), "card")
    b.box((-w * 0.4, -w * 0.22), (-d * 0.02, d * 0.22), z, "metal_brass", "chip", solid=False)
    b.box((-w * 0.4, -w * 0.22), (d * 0.09, d * 0.11), (h, h * 1.05), "metal_dark", "chip", solid=False)
    for group in range(4):
        for k in range(4):
            x = -w * 0.4 + group * w * 0.2 + k * w * 0.04
            b.box((x, x + w * 0.024), (-d * 0.2, -d * 0.1), z, "plastic_white", "number", solid=False)
    b.box((-w * 0.4, w * 0.05), (-d * 0.38, -d * 0.32), z, "plastic_white", "name", solid=False)
    b.cyl(w * 0.28, -d * 0.32, (h, h * 1.03), d * 0.12, "paint_red", "mark", n=20, solid=False)
    b.cyl(w * 0.38, -d * 0.32, (h, h * 1.05), d * 0.12, "paint_yellow", "mark", n=20, solid=False)


@recipe("badge")
def badge(b: Builder) -> None:
    """An identity card with a photograph, a coloured head and lines of print, and a clip on a strap."""
    w, d, h = b.w, b.d, b.h
    z, end = (h * 0.7, h * 0.76), d * 0.3
    b.box((-w / 2, w / 2), (-d / 2, end), (0, h * 0.7), b.mat(), "card")
    b.box((-w / 2, w / 2), (end - d * 0.14, end), z, "paint_3a7bc8", "head", solid=False)
    b.box((-w * 0.38, w * 0.02), (-d * 0.2, d * 0.12), z, "plastic_light", "photograph", solid=False)
    b.cyl(-w * 0.18, d * 0.02, (h * 0.76, h * 0.82), w * 0.11, "fabric_skin", "photograph", solid=False)
    b.box((-w * 0.34, -w * 0.02), (-d * 0.2, -d * 0.08), (h * 0.76, h * 0.8), "paint_dark", "photograph", solid=False)
    for k, wide in enumerate((0.34, 0.28, 0.34)):
        y = d * (0.06 - 0.09 * k)
        b.box((w * 0.1, w * (0.1 + wide)), (y, y + d * 0.03), z, "plastic_black", "print", solid=False)
    b.box((-w * 0.38, w * 0.4), (-d * 0.42, -d * 0.3), z, "plastic_black", "print", solid=False)
    b.box((-w * 0.14, w * 0.14), (end - d * 0.02, d * 0.42), (h * 0.2, h * 0.5), "plastic_light", "strap")
    b.box((-w * 0.2, w * 0.2), (d * 0.4, d / 2), (0, h), "metal_steel", "clip")


@recipe("shoes")
def shoes(b: Builder) -> None:
    """A pair of shoes or boots, toes to the front."""
    w, d, h = b.w, b.d, b.h
    low = b.p.get("style") == "low"
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * w * 0.04))
        b.box((lo, hi), (-d / 2, d / 2), (0, h * (0.12 if low else 0.05)), "rubber_black", "soles")
        b.cushion((lo, hi), (-d / 2, d / 2), (0, h * (0.7 if low else 0.25)), b.mat(), "uppers", 0.8)
        b.cushion((lo + 0.004, hi - 0.004), (-d / 2, -d * 0.02), (0, h), b.mat(), "shafts", 0.6)
