"""Cameras, projectors, telescopes and microscopes."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("microscope")
def microscope(b: Builder) -> None:
    """Foot, arm, stage, tube."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.08), b.mat(), "foot")
    b.box((-w * 0.16, w * 0.16), (-d / 2, -d * 0.25), (h * 0.08, h * 0.75), b.mat(), "arm")
    b.box((-w * 0.36, w * 0.36), (-d * 0.25, d * 0.3), (h * 0.36, h * 0.4), "plastic_black", "stage")
    b.box((-w * 0.16, w * 0.16), (-d / 2, d * 0.15), (h * 0.66, h * 0.78), b.mat(), "head")
    b.cyl(0, d * 0.05, (h * 0.44, h * 0.66), w * 0.09, "metal_steel", "objective", n=12)
    b.rod((0, -d * 0.05, h * 0.75), (0, d * 0.3, h - w * 0.05), w * 0.08, "plastic_black", "tube", 12, solid=True)
    b.rod((-w * 0.3, -d * 0.38, h * 0.25), (w * 0.3, -d * 0.38, h * 0.25), h * 0.06, "plastic_black", "knobs", 14)


def _tripod(b: Builder, top: float) -> None:
    for k in range(3):
        a = math.pi / 2 + k * 2 * math.pi / 3
        b.rod(
            (0, 0, top),
            (math.cos(a) * b.w * 0.48, math.sin(a) * b.d * 0.48, 0.012),
            0.016,
            "metal_black",
            "legs",
            8,
            solid=True,
        )


@recipe("telescope")
def telescope(b: Builder) -> None:
    """Tube on a tripod, looking up to the front."""
    _w, d, h = b.w, b.d, b.h
    _tripod(b, h * 0.62)
    b.rod((0, -d * 0.4, h * 0.5), (0, d * 0.42, h * 0.94), 0.09, b.mat(), "tube", 20, solid=True)
    b.rod((0, d * 0.4, h * 0.93), (0, d * 0.43, h * 0.945), 0.085, "glass_black", "lens", 20)
    b.rod((0, -d * 0.4, h * 0.5), (0, -d * 0.45, h * 0.55), 0.03, "plastic_black", "eyepiece")
    b.cyl(0, 0, (h * 0.58, h * 0.72), 0.06, "metal_dark", "mount")


@recipe("tripod")
def tripod(b: Builder) -> None:
    """Film camera on a tripod."""
    h = b.h
    _tripod(b, h * 0.82)
    b.box((-0.08, 0.08), (-0.16, 0.12), (h - 0.2, h - 0.03), "plastic_black", "camera")
    b.rod((0, 0.1, h - 0.11), (0, 0.26, h - 0.11), 0.055, "plastic_black", "lens", 16, solid=True)
    b.box((-0.03, 0.03), (-0.1, 0.08), (h - 0.03, h), "plastic_dark", "grip", solid=False)
