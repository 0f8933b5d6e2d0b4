"""Bottles for the bath, the laundry and the way, each with the cap and the grip by which people know it."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("shampoo")
def shampoo(b: Builder) -> None:
    """A flat, rounded bottle with a label and drawn bubbles, and a wide flip cap."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d * 0.36, d * 0.36), (0, h * 0.84), b.mat(), "body", 0.7, 14)
    b.lathe([(0.36, h * 0.78), (0.36, h * 0.97), (0.32, h)], "plastic_white", n=20, stretch=(w, d * 0.8), part="cap")
    b.box((-w * 0.1, w * 0.1), (d * 0.2, d * 0.32), (h * 0.94, h * 0.97), "plastic_grey", "cap", solid=False)
    b.box((-w * 0.3, w * 0.3), (d * 0.34, d * 0.375), (h * 0.16, h * 0.6), "paper_white", "label", solid=False)
    for x, z, r in ((-0.12, 0.26, 0.1), (0.12, 0.32, 0.07), (-0.02, 0.42, 0.085), (0.14, 0.48, 0.05)):
        b.rod((w * x, d * 0.37, h * z), (w * x, d * 0.385, h * z), w * r, "plastic_8fc6ea", "bubbles", 14)
    b.box((-w * 0.22, w * 0.22), (d * 0.37, d * 0.385), (h * 0.54, h * 0.57), b.mat(), "label", solid=False)


@recipe("detergent")
def detergent(b: Builder) -> None:
    """A broad canister with a hollow handle at one side, a slanting shoulder, a bright measuring cap and a label."""
    w, d, h = b.w, b.d, b.h
    z = (-d / 2, d / 2)
    b.prism(
        [(-w / 2, 0), (w / 2, 0), (w / 2, h * 0.42), (-w * 0.16, h * 0.42), (-w * 0.16, h * 0.78), (-w / 2, h * 0.7)],
        z,
        b.mat(),
        "y",
        "body",
    )
    b.box((-w * 0.16, w * 0.16), z, (h * 0.4, h * 0.78), b.mat(), "body")
    b.prism(
        [(w * 0.36, h * 0.4), (w / 2, h * 0.4), (w / 2, h * 0.62), (w * 0.36, h * 0.62)],
        (-d * 0.36, d * 0.36),
        b.mat(),
        "y",
        "handle",
    )
    b.prism(
        [(w * 0.12, h * 0.66), (w * 0.36, h * 0.6), (w / 2, h * 0.6), (w * 0.14, h * 0.78)],
        (-d * 0.36, d * 0.36),
        b.mat(),
        "y",
        "handle",
    )
    b.cyl(-w * 0.2, 0, (h * 0.74, h), d * 0.36, "plastic_orange", "cap", d * 0.32)
    b.box((-w * 0.42, w * 0.1), (d / 2, d / 2 + 0.001), (h * 0.12, h * 0.62), "paper_white", "label", solid=False)
    for r, color in ((0.17, "paint_yellow"), (0.11, "paint_red")):
        b.rod((-w * 0.16, d / 2, h * 0.38), (-w * 0.16, d / 2 + 0.003 - 0.01 * r, h * 0.38), w * r, color, "label", 16)


@recipe("sports_bottle")
def sports_bottle(b: Builder) -> None:
    """A clear bottle with a waist, water in it, and a screw cap with a mouthpiece and a carrying loop."""
    w, d, h = b.w, b.d, b.h
    body = [
        (0.44, 0),
        (0.48, h * 0.03),
        (0.48, h * 0.3),
        (0.4, h * 0.36),
        (0.4, h * 0.46),
        (0.48, h * 0.52),
        (0.48, h * 0.68),
        (0.24, h * 0.8),
    ]
    b.lathe(body, "plastic_9fd0f0", n=24, stretch=(w, d))
    for z in (0.12, 0.2, 0.56, 0.62):
        b.lathe(
            [(0.485, h * z), (0.5, h * (z + 0.012)), (0.485, h * (z + 0.024))],
            "plastic_6fb4e2",
            n=24,
            stretch=(w, d),
            part="ribs",
            solid=False,
        )
    b.lathe([(0.42, h * 0.34), (0.42, h * 0.48)], "paper_white", n=24, stretch=(w, d), part="label", solid=False)
    b.lathe([(0.425, h * 0.38), (0.425, h * 0.44)], b.mat(), n=24, stretch=(w, d), part="label", solid=False)
    b.lathe(
        [(0.28, h * 0.78), (0.28, h * 0.9), (0.12, h * 0.92), (0.12, h * 0.96), (0.16, h * 0.97), (0.14, h)],
        b.mat(),
        n=20,
        stretch=(w, d),
        part="cap",
    )
    loop = [
        (w * 0.26 + w * 0.1 * math.sin(a), 0.0, h * 0.84 + h * 0.05 * math.cos(a))
        for a in (k * math.pi / 6 for k in range(7))
    ]
    b.path(loop, w * 0.03, b.mat(), "loop")
