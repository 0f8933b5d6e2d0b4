"""Hospital devices."""

import math

from mansion_assets.builder import Box, Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


def _star(b: Builder, r: float) -> None:
    """Five feet on castors."""
    for k in range(5):
        a = math.pi / 2 + k * 2 * math.pi / 5
        x, y = math.cos(a) * (b.w / 2 - 0.03), math.sin(a) * (b.d / 2 - 0.03)
        b.rod((0, 0, 0.1), (x, y, 0.07), r, "metal_steel", "feet")
        b.ball((x, y, 0.03), (0.03, 0.03, 0.03), "rubber_black", "wheels", 8, solid=False)
    b.boxes.append(Box((0.0, 0.0, 0.05), (b.w * 0.8, b.d * 0.8, 0.1)))


@recipe("iv_stand")
def iv_stand(b: Builder) -> None:
    """Pole with hooks, a bag and a pump."""
    h = b.h
    _star(b, 0.013)
    b.cyl(0, 0, (0.05, h - 0.03), 0.013, b.mat(), "pole", n=10)
    b.path([(-0.14, 0, h), (-0.14, 0, h - 0.05), (0.14, 0, h - 0.05), (0.14, 0, h)], 0.007, b.mat(), "hooks")
    b.cushion((-0.19, -0.09), (-0.02, 0.02), (h - 0.34, h - 0.06), "glass_clear", "bag", 0.8, 8, solid=False)
    b.box((-0.07, 0.07), (0.01, 0.13), (h * 0.52, h * 0.64), "plastic_white", "pump")
    b.box((-0.05, 0.05), (0.13, 0.132), (h * 0.56, h * 0.62), "screen_green", "pump", solid=False)
    b.path([(-0.14, 0.02, h - 0.34), (-0.1, 0.06, h * 0.7), (-0.03, 0.08, h * 0.64)], 0.004, "glass_clear", "tube")


@recipe("patient_monitor")
def patient_monitor(b: Builder) -> None:
    """Monitor on a rolling stand with a basket."""
    w, _d, h = b.w, b.d, b.h
    _star(b, 0.018)
    b.cyl(0, 0, (0.05, h - 0.3), 0.02, "metal_steel", "pole", n=12)
    b.box((-w * 0.38, w * 0.38), (-0.08, 0.06), (h - 0.3, h), b.mat(), "monitor")
    b.box((-w * 0.33, w * 0.33), (0.06, 0.064), (h - 0.26, h - 0.04), "screen_dark", "monitor", solid=False)
    for k, color in enumerate(("light_green", "light_blue", "light_red")):
        z = h - 0.1 - k * 0.06
        b.path(
            [(-w * 0.3 + t * w * 0.08, 0.066, z + (0.02 if t % 3 == 1 else 0.0)) for t in range(7)],
            0.003,
            color,
            "curves",
        )
    b.box((-w * 0.25, w * 0.25), (0.0, 0.16), (h * 0.55, h * 0.63), "metal_steel", "basket")


@recipe("scanner")
def scanner(b: Builder) -> None:
    """Tomograph: ring with a bore, table to the front."""
    w, d, h = b.w, b.d, b.h
    deep = (-d / 2, -d / 2 + d * 0.42)
    r, cz, n = 0.38, h * 0.52, 24
    ring = [(r * math.cos(2 * math.pi * k / n), cz + r * math.sin(2 * math.pi * k / n)) for k in range(n)]
    for k in range(n):
        q = (k + 1) % n
        outer = [_to_box(ring[i], (0.0, cz), w / 2, 0.0, h) for i in (k, q)]
        b.prism([ring[k], outer[0], outer[1], ring[q]], deep, b.mat(), "y", "ring", solid=False)
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * 0.4))
        b.box((lo, hi), deep, (0, h), b.mat(), "case")
    b.box((-0.4, 0.4), deep, (0, cz - 0.4), b.mat(), "case")
    b.box((-0.4, 0.4), deep, (cz + 0.4, h), b.mat(), "case")
    b.box((-0.26, 0.26), (deep[1] + 0.2, d / 2 - 0.1), (0, cz - 0.26), "plastic_light", "table")
    b.box((-0.24, 0.24), (deep[0] + 0.3, d / 2), (cz - 0.26, cz - 0.2), "leather_blue", "table")
    b.cushion(
        (-0.16, 0.16), (deep[1] + 0.1, deep[1] + 0.4), (cz - 0.2, cz - 0.12), "fabric_white", "pillow", solid=False
    )
    b.box((w * 0.3, w * 0.42), (deep[1], deep[1] + 0.01), (h * 0.6, h * 0.72), "screen_blue", "panel", solid=False)


def _to_box(
    p: tuple[float, float], center: tuple[float, float], half: float, low: float, high: float
) -> tuple[float, float]:
    """Extend the ray from `center` through `p` to the case's outline."""
    dx, dz = p[0] - center[0], p[1] - center[1]
    limits = [half / abs(dx)] if abs(dx) > 1e-9 else []
    if abs(dz) > 1e-9:
        limits.append(((high if dz > 0 else low) - center[1]) / dz)
    t = min(limits)
    return center[0] + dx * t, center[1] + dz * t


@recipe("xray")
def xray(b: Builder) -> None:
    """Table with a tube on a column."""
    w, d, h = b.w, b.d, b.h
    b.box((-0.3, 0.3), (-d * 0.3, d * 0.3), (0.05, 0.7), b.mat(), "base")
    b.box((-w * 0.36, w * 0.36), (-d / 2, d / 2), (0.7, 0.78), "leather_black", "table")
    b.box((-w / 2, -w / 2 + 0.18), (-0.1, 0.1), (0, h), b.mat(), "column")
    b.box((-w / 2 + 0.1, 0.15), (-0.06, 0.06), (h - 0.35, h - 0.23), b.mat(), "arm")
    b.box((-0.15, 0.15), (-0.18, 0.18), (h - 0.5, h - 0.2), "metal_grey", "tube")
    b.prism(
        [(-0.12, h - 0.62), (0.12, h - 0.62), (0.08, h - 0.5), (-0.08, h - 0.5)],
        (-0.1, 0.1),
        "metal_dark",
        part="collimator",
    )
    b.box((w / 2 - 0.12, w / 2), (-0.3, 0.3), (0.0, 0.03), "metal_grey", "rail")


@recipe("height_scale")
def height_scale(b: Builder) -> None:
    """Scale with a measuring column."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.07), b.mat(), "platform")
    b.box((-w * 0.4, w * 0.4), (-d * 0.2, d * 0.45), (0.07, 0.075), "rubber_black", "mat", solid=False)
    b.box((-0.03, 0.03), (-d / 2, -d / 2 + 0.06), (0.07, h), b.mat(), "column")
    b.box((-0.12, 0.12), (-d / 2 + 0.04, -d / 2 + 0.1), (h * 0.6, h * 0.68), "plastic_white", "display")
    b.box((-0.1, 0.1), (-d / 2 + 0.1, -d / 2 + 0.103), (h * 0.61, h * 0.67), "screen_green", "display", solid=False)
    b.box((-0.05, 0.05), (-d / 2 + 0.05, 0.05), (h - 0.06, h - 0.04), "metal_steel", "slide", solid=False)
