"""Cameras, their tripods, and telescopes."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("photo_camera")
def photo_camera(b: Builder) -> None:
    """A black body with a silver top, a ringed lens with blue glass, a finder above it, a red release, and a strap."""
    w, d, h = b.w, b.d, b.h
    front, top = d * 0.04, h * 0.66
    b.cushion((-w * 0.48, w * 0.48), (-d * 0.34, front), (0, top), "leather_black", "body", 0.3, 12)
    b.box((-w * 0.47, w * 0.47), (-d * 0.32, front - 0.002), (top - h * 0.04, top + h * 0.1), "metal_light", "top")
    b.prism(
        [(-w * 0.2, top + h * 0.1), (w * 0.2, top + h * 0.1), (w * 0.12, h), (-w * 0.12, h)],
        (-d * 0.3, front),
        "metal_light",
        "y",
        "finder",
    )
    b.cushion((-w * 0.48, -w * 0.3), (-d * 0.1, d * 0.18), (h * 0.04, top * 0.96), "leather_black", "grip", 0.6)
    z = h * 0.36
    for y0, y1, r, color in (
        (0.0, 0.2, 0.34, "metal_dark"),
        (0.2, 0.26, 0.35, "metal_light"),
        (0.26, 0.44, 0.33, "plastic_black"),
        (0.44, 0.5, 0.3, "metal_dark"),
    ):
        b.rod((w * 0.04, front + d * (y0 - 0.06), z), (w * 0.04, d * y1, z), h * r, color, "lens", 24, solid=True)
    b.rod((w * 0.04, d * 0.48, z), (w * 0.04, d * 0.505, z), h * 0.23, "glass_2f4f9f", "glass", 22)
    b.ball((w * 0.04 - h * 0.07, d * 0.505, z + h * 0.08), (h * 0.05, h * 0.02, h * 0.05), "light_white", "glass", 8)
    b.cyl(-w * 0.36, -d * 0.12, (top + h * 0.1, top + h * 0.19), w * 0.05, "paint_red", "release", n=12)
    b.cyl(w * 0.34, -d * 0.14, (top + h * 0.1, top + h * 0.22), w * 0.09, "metal_dark", "dial", n=16)
    b.box(
        (-w * 0.07, w * 0.07), (front, front + 0.002), (top + h * 0.16, h * 0.94), "glass_2f4f9f", "finder", solid=False
    )
    b.path(
        [
            (w * 0.48, -d * 0.16, top),
            (w * 0.56, -d * 0.3, h * 0.4),
            (w * 0.5, -d * 0.46, h * 0.1),
            (w * 0.1, -d * 0.5, h * 0.04),
        ],
        w * 0.03,
        "leather_brown",
        "strap",
    )


@recipe("cctv_camera")
def cctv_camera(b: Builder) -> None:
    """A white barrel with a sunshade on a jointed arm at the wall, a dark lens in a ring of lamps, and a red light."""
    w, d, h = b.w, b.d, b.h
    back = -d / 2
    b.rod((0, back, h * 0.72), (0, back + d * 0.06, h * 0.72), h * 0.27, "plastic_light", "plate", 20)
    b.path(
        [(0, back + d * 0.05, h * 0.72), (0, back + d * 0.22, h * 0.66), (0, -d * 0.1, h * 0.86)],
        w * 0.08,
        "plastic_light",
        "arm",
    )
    b.ball((0, back + d * 0.22, h * 0.67), (w * 0.12, w * 0.12, w * 0.12), "plastic_grey", "arm", 10)
    start, end = (0.0, -d * 0.24, h * 0.62), (0.0, d * 0.4, h * 0.3)
    b.rod(start, end, w * 0.26, b.mat(), "barrel", 20, solid=True)
    shade = [(-d * 0.3, h * 0.9), (d * 0.26, h * 0.63), (d * 0.26, h * 0.71), (-d * 0.3, h * 0.98)]
    b.prism(shade, (-w * 0.34, w * 0.34), b.mat(), part="sunshade")
    for side in (-1, 1):
        across = sorted((side * w * 0.34, side * w * 0.29))
        flap = [(-d * 0.28, h * 0.68), (d * 0.22, h * 0.5), (d * 0.26, h * 0.66), (-d * 0.3, h * 0.92)]
        b.prism(flap, (across[0], across[1]), b.mat(), part="sunshade")
    b.rod(end, (0, d * 0.41, h * 0.295), w * 0.24, "plastic_black", "lens", 20)
    b.rod((0, d * 0.41, h * 0.295), (0, d * 0.44, h * 0.28), w * 0.12, "glass_3d6a9e", "lens", 16)
    for k in range(8):
        a = k * math.pi / 4
        b.ball(
            (math.cos(a) * w * 0.18, d * 0.412 + 0.0, h * 0.29 + math.sin(a) * w * 0.18),
            (w * 0.03, w * 0.02, w * 0.03),
            "metal_light",
            "lamps",
            6,
        )
    b.ball((-w * 0.0, d * 0.42, h * 0.29 + w * 0.22), (w * 0.04, w * 0.03, w * 0.04), "light_red", "light", 8)


@recipe("webcam")
def webcam(b: Builder) -> None:
    """A ball with a large lens and a lit dot, on a clip that holds the edge of a screen, with a cable to a plug."""
    w, d, h = b.w, b.d, b.h
    z, r = h * 0.66, h * 0.32
    b.cushion((-w / 2, w / 2), (-d * 0.2, d * 0.3), (z - r, h), b.mat(), "case", 0.8, 14)
    b.rod((0, d * 0.24, z), (0, d * 0.42, z), r * 0.86, "plastic_grey", "lens", 22)
    b.rod((0, d * 0.4, z), (0, d * 0.46, z), r * 0.7, "plastic_black", "lens", 22)
    b.rod((0, d * 0.44, z), (0, d / 2, z), r * 0.42, "glass_2f4f9f", "lens", 18)
    b.ball((-r * 0.1, d * 0.5, z + r * 0.14), (r * 0.12, r * 0.05, r * 0.12), "light_white", "lens", 8)
    b.ball((w * 0.4, d * 0.24, z), (w * 0.04, d * 0.06, w * 0.04), "light_green", "lamp", 8)
    b.box((-w * 0.24, w * 0.24), (-d * 0.1, d * 0.34), (h * 0.28, h * 0.36), "plastic_dark", "clip")
    b.prism(
        [(d * 0.26, h * 0.36), (d * 0.34, h * 0.36), (d * 0.34, 0.0), (d * 0.26, 0.0)],
        (-w * 0.2, w * 0.2),
        "plastic_dark",
        part="clip",
    )
    b.prism(
        [(-d * 0.1, h * 0.36), (-d * 0.02, h * 0.36), (-d * 0.38, 0.0), (-d * 0.46, 0.0)],
        (-w * 0.2, w * 0.2),
        "plastic_dark",
        part="clip",
    )
    b.path(
        [(0, -d * 0.18, z), (0, -d * 0.4, h * 0.5), (w * 0.3, -d * 0.46, h * 0.2), (w * 0.44, -d * 0.3, h * 0.04)],
        h * 0.03,
        "rubber_black",
        "cable",
    )


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


@recipe("tripod")
def tripod(b: Builder) -> None:
    """Film camera on a tripod."""
    h = b.h
    _tripod(b, h * 0.82)
    b.box((-0.08, 0.08), (-0.16, 0.12), (h - 0.2, h - 0.03), "plastic_black", "camera")
    b.rod((0, 0.1, h - 0.11), (0, 0.26, h - 0.11), 0.055, "plastic_black", "lens", 16, solid=True)
    b.box((-0.03, 0.03), (-0.1, 0.08), (h - 0.03, h), "plastic_dark", "grip", solid=False)


@recipe("telescope")
def telescope(b: Builder) -> None:
    """Tube on a tripod, looking up to the front."""
    _w, d, h = b.w, b.d, b.h
    _tripod(b, h * 0.62)
    b.rod((0, -d * 0.4, h * 0.5), (0, d * 0.42, h * 0.94), 0.09, b.mat(), "tube", 20, solid=True)
    b.rod((0, d * 0.4, h * 0.93), (0, d * 0.43, h * 0.945), 0.085, "glass_black", "lens", 20)
    b.rod((0, -d * 0.4, h * 0.5), (0, -d * 0.45, h * 0.55), 0.03, "plastic_black", "eyepiece")
    b.cyl(0, 0, (h * 0.58, h * 0.72), 0.06, "metal_dark", "mount")
