"""Brushes, cloths and gloves for cleaning, and mats to lie on."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("scrub_brush")
def scrub_brush(b: Builder) -> None:
    """A brush that stands on its bristles: tufts under a broad block, and a long, upright handle."""
    w, d, h = b.w, b.d, b.h
    tuft, block = h * 0.16, h * 0.24
    for i in range(6):
        for j in range(3):
            x, y = w * (-0.42 + 0.168 * i), d * (-0.3 + 0.3 * j)
            b.lathe(
                [(0.09, 0), (0.06, tuft)],
                ("plastic_3a7bc8", "plastic_white")[(i + j) % 2],
                (x, y),
                "bristles",
                7,
                (w, d),
            )
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2), (tuft, block), "wood_oak", "block", 0.5)
    b.rod((0, 0, block * 0.95), (0, 0, h), w * 0.08, "wood_oak", "handle", 12, solid=True)
    b.cyl(0, 0, (block, block + h * 0.07), w * 0.14, b.mat(), "socket")
    b.cyl(0, 0, (h * 0.93, h), w * 0.11, b.mat(), "grip")


@recipe("dish_cloth")
def dish_cloth(b: Builder) -> None:
    """A checked cloth that lies crumpled: ridges across, a hem, and one corner turned over."""
    w, d, h = b.w, b.d, b.h
    count = 10
    heights = [h * (0.3 + 0.34 * math.sin(k * 1.9) * math.sin(k * 0.7 + 0.4)) for k in range(count + 1)]
    thick = h * 0.16
    for i in range(count):
        y0, y1 = -d / 2 + i * d / count, -d / 2 + (i + 1) * d / count
        profile = [
            (y0, max(0.0, heights[i] - thick)),
            (y1, max(0.0, heights[i + 1] - thick)),
            (y1, heights[i + 1]),
            (y0, heights[i]),
        ]
        for j in range(count):
            x0, x1 = -w / 2 + j * w / count, -w / 2 + (j + 1) * w / count
            striped = (i % 4 == 1) + (j % 4 == 1)
            color = (b.mat(), "fabric_7aa0d6", "fabric_1d4f9e")[striped]
            b.prism(profile, (x0, x1), color, part="cloth", solid=False)
    fold = [(w * 0.08, -d / 2), (w / 2, -d / 2), (w / 2, -d * 0.06)]
    b.prism(fold, (heights[0] * 0.9, h), "fabric_7aa0d6", "z", "fold", solid=False)


@recipe("nap_mat")
def nap_mat(b: Builder) -> None:
    """A thin mat in four padded sections of two colours, with a small pillow."""
    w, d, h = b.w, b.d, b.h
    face = b.tops[0].z
    for k in range(4):
        y0 = -d / 2 + k * d / 4
        b.cushion((-w / 2, w / 2), (y0, y0 + d / 4), (0, face), (b.mat(), "fabric_red")[k % 2], "sections", 0.5)
    b.cushion((-w * 0.36, w * 0.36), (-d * 0.48, -d * 0.29), (face * 0.9, h), "fabric_white", "pillow", 0.7, 12)
