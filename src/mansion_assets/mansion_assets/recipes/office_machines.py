"""Copiers, printers and plotters."""

from mansion_assets.builder import Builder
from mansion_assets.registry import Recipe

__all__ = ["OFFICE_MACHINES"]


def _copier(b: Builder) -> None:
    """Copier on the floor: trays below, scanner and panel on top."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.04), (0.04, h * 0.78), m, "case")
    b.box((-w / 2 + 0.04, w / 2 - 0.04), (-d / 2 + 0.04, d / 2 - 0.1), (0, 0.04), "plastic_dark", "feet")
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.08), (h * 0.86, h), m, "scanner")
    b.box((-w * 0.3, w / 2), (-d / 2, d / 2 - 0.2), (h * 0.78, h * 0.86), "plastic_dark", "gap")
    for k in range(3):
        z = 0.1 + k * h * 0.19
        b.box((-w * 0.46, w * 0.46), (d / 2 - 0.04, d / 2 - 0.02), (z, z + h * 0.16), "plastic_light", "trays", False)
        b.box((-0.08, 0.08), (d / 2 - 0.02, d / 2 - 0.01), (z + h * 0.1, z + h * 0.12), "plastic_dark", "trays", False)
    b.prism(
        [(d / 2 - 0.12, h * 0.86), (d / 2, h * 0.84), (d / 2, h * 0.87), (d / 2 - 0.1, h * 0.93)],
        (w * 0.05, w / 2),
        "screen_blue",
        part="panel",
    )


def _printer(b: Builder) -> None:
    """Printer with a sheet in its mouth."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2 - 0.05), (0, h), m, "case", 0.25, 12)
    b.box((-w * 0.34, w * 0.34), (d / 2 - 0.12, d / 2), (h * 0.25, h * 0.3), "paper_white", "paper")
    b.box((-w * 0.36, w * 0.36), (d / 2 - 0.07, d / 2 - 0.045), (h * 0.3, h * 0.5), "plastic_dark", "slot", False)
    b.box((w * 0.15, w * 0.4), (d / 2 - 0.06, d / 2 - 0.045), (h * 0.68, h * 0.84), "screen_blue", "panel", False)


def _plotter(b: Builder) -> None:
    """Plotter on two legs with a hanging sheet."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.1)
        b.box((x - 0.04, x + 0.04), (-d / 2, d / 2), (0, 0.06), "metal_dark", "feet")
        b.box((x - 0.04, x + 0.04), (-0.06, 0.06), (0.05, h * 0.7), "metal_dark", "legs")
    b.cushion((-w / 2, w / 2), (-d * 0.4, d * 0.4), (h * 0.68, h), m, "case", 0.35, 12)
    b.prism(
        [(d * 0.36, h * 0.74), (d * 0.38, h * 0.75), (d * 0.3, h * 0.25), (d * 0.28, h * 0.25)],
        (-w * 0.4, w * 0.4),
        "paper_white",
        part="sheet",
        solid=False,
    )


OFFICE_MACHINES: dict[str, Recipe] = {"copier": _copier, "plotter": _plotter, "printer": _printer}
"""From a style of the recipe ``machine`` to its shape."""
