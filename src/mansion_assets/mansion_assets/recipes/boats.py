"""What has the outline of a hull or of a coffin: bodies that taper to their ends."""

import numpy as np

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("rowing_boat")
def rowing_boat(b: Builder) -> None:
    """A boat of planks with a pointed bow to the front, a flat stern, two thwarts and a pair of oars."""
    w, d, h = b.w, b.d, b.h
    stations = (
        (-0.5, 0.34, 0.0),
        (-0.3, 0.46, 0.0),
        (0.0, 0.48, 0.0),
        (0.22, 0.4, 0.02),
        (0.4, 0.2, 0.1),
        (0.5, 0.02, 0.24),
    )
    rim = (0.62, 0.58, 0.56, 0.6, 0.72, 0.9)
    for k in range(5):
        (y0, half0, keel0), (y1, half1, keel1) = stations[k], stations[k + 1]
        for strake, color in enumerate((b.mat(), b.mat(), "paint_white")):
            lower, upper = strake / 3, (strake + 1) / 3
            for side in (-1, 1):
                ends = ((y0, half0, keel0, rim[k]), (y1, half1, keel1, rim[k + 1]))
                quad = [
                    (side * w * half * (0.5 + 0.5 * share**0.6), y * d, h * (keel + (top - keel) * share))
                    for y, half, keel, top in ends
                    for share in (lower, upper)
                ]
                _plank(b, quad, side, w * 0.03, color)
        floor = [
            (-w * half0 * 0.52, y0 * d),
            (w * half0 * 0.52, y0 * d),
            (w * half1 * 0.52, y1 * d),
            (-w * half1 * 0.52, y1 * d),
        ]
        b.prism(floor, (h * keel0, h * (keel1 + 0.05)), "wood_walnut", "z", "floor")
    b.box((-w * 0.34, w * 0.34), (-d / 2, -d * 0.485), (0, h * 0.62), "paint_white", "stern")
    for y in (-0.36, -0.06, 0.22):
        half = 0.44 if y < 0.1 else 0.34
        b.box((-w * half, w * half), (d * (y - 0.035), d * (y + 0.035)), (h * 0.4, h * 0.44), "wood_birch", "thwarts")
    for side in (-1, 1):
        b.rod((side * w * 0.26, -d * 0.4, h * 0.5), (side * w * 0.3, d * 0.2, h * 0.62), 0.028, "wood_birch", "oars")
        b.box(
            (side * w * 0.3 - 0.08, side * w * 0.3 + 0.08),
            (d * 0.18, d * 0.3),
            (h * 0.6, h * 0.63),
            "paint_red",
            "oars",
        )


def _plank(b: Builder, quad: list[tuple[float, float, float]], side: int, thick: float, color: str) -> None:
    """Add a plank: four corners of its outer face, lower and upper at one station and at the next."""
    outer = np.array([quad[0], quad[1], quad[3], quad[2]])
    inner = outer - np.array([side * thick, 0.0, 0.0])
    faces = [(0, 1, 2), (0, 2, 3), (4, 6, 5), (4, 7, 6)]
    for k in range(4):
        n = (k + 1) % 4
        faces += [(k, k + 4, n + 4), (k, n + 4, n)]
    table = np.array(faces)
    b.raw(np.concatenate([outer, inner]), table if side > 0 else table[:, ::-1], color, "planks")


@recipe("coffin")
def coffin(b: Builder) -> None:
    """A chest that is widest at the shoulders, with a bevelled lid that bears a cross, and handles along its sides."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.7
    outline = ((-0.28, -0.5), (0.28, -0.5), (0.47, -0.2), (0.3, 0.5), (-0.3, 0.5), (-0.47, -0.2))
    levels = (
        (0.0, low, 0.94, b.mat()),
        (0.0, h * 0.06, 1.0, "wood_black"),
        (low, h * 0.78, 1.0, "wood_black"),
        (h * 0.78, h * 0.9, 0.9, b.mat()),
        (h * 0.9, h * 0.96, 0.7, b.mat()),
    )
    for z0, z1, share, color in levels:
        b.prism([(x * w * share, y * d * (0.5 + share / 2)) for x, y in outline], (z0, z1), color, "z", "chest")
    b.box((-w * 0.035, w * 0.035), (-d * 0.36, d * 0.34), (h * 0.95, h), "metal_brass", "cross")
    b.box((-w * 0.2, w * 0.2), (-d * 0.2, -d * 0.16), (h * 0.95, h), "metal_brass", "cross")
    for side in (-1, 1):
        for share in (-0.02, 0.16, 0.34):
            y = d * share
            x = side * w * (0.46 - 0.25 * (share + 0.2)) * 0.98
            b.path(
                [
                    (x * 0.94, y - d * 0.05, low * 0.6),
                    (x * 1.06, y - d * 0.05, low * 0.55),
                    (x * 1.06, y + d * 0.05, low * 0.55),
                    (x * 0.94, y + d * 0.05, low * 0.6),
                ],
                0.014,
                "metal_brass",
                "handles",
            )
    for x in (-w * 0.16, w * 0.16):
        b.rod((x, d * 0.48, low * 0.55), (x, d / 2, low * 0.55), 0.03, "metal_brass", "handles", 12)
