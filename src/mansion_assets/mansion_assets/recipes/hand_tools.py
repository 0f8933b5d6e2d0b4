"""Tools and instruments for one hand: torch, brushes, pipette, scissors, pencil, gloves."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("torch")
def torch(b: Builder) -> None:
    """A barrel with grooves and a switch, which widens to a head with a bright lens in front."""
    w, d, h = b.w, b.d, b.h
    r, z = w / 2, h / 2
    b.rod((0, -d / 2, z), (0, d * 0.2, z), r * 0.6, b.mat(), "barrel", 14, solid=True)
    for k in range(6):
        y = -d * 0.36 + k * d * 0.06
        b.rod((0, y, z), (0, y + d * 0.03, z), r * 0.68, "plastic_dark", "grip", 14)
    for k in range(4):
        y = d * (0.2 + 0.05 * k)
        b.rod((0, y, z), (0, y + d * 0.06, z), r * (0.66 + 0.1 * k), b.mat(), "head", 16)
    b.rod((0, d * 0.4, z), (0, d * 0.49, z), r, "metal_light", "head", 20, solid=True)
    b.rod((0, d * 0.48, z), (0, d / 2, z), r * 0.84, "light_ffe58a", "lens", 20)
    b.box((-r * 0.25, r * 0.25), (d * 0.06, d * 0.16), (z + r * 0.5, z + r * 0.75), "paint_red", "switch", solid=False)


@recipe("paint_brush")
def paint_brush(b: Builder) -> None:
    """A wooden handle, a steel ferrule and a tuft of bristles with wet paint on their ends."""
    w, d, h = b.w, b.d, b.h
    z = h / 2
    b.rod((0, -d / 2, z), (0, -d * 0.3, z), w * 0.16, b.mat(), "handle", 10, solid=True)
    b.rod((0, -d * 0.3, z), (0, d * 0.02, z), w * 0.26, b.mat(), "handle", 10, solid=True)
    b.box((-w * 0.44, w * 0.44), (0, d * 0.18), (z - h * 0.34, z + h * 0.34), "metal_chrome", "ferrule")
    b.prism(
        [(-w * 0.42, d * 0.18), (w * 0.42, d * 0.18), (w / 2, d * 0.32), (-w / 2, d * 0.32)],
        (z - h * 0.3, z + h * 0.3),
        "food_e8d9b0",
        "z",
        "bristles",
    )
    b.prism(
        [(-w / 2, d * 0.32), (w / 2, d * 0.32), (w * 0.4, d * 0.46), (0, d / 2), (-w * 0.4, d * 0.46)],
        (0, h),
        "paint_red",
        "z",
        "paint",
    )


@recipe("pipette")
def pipette(b: Builder) -> None:
    """A micropipette: a blue handle with a plunger button, a finger hook and a window, and a long, thin white tip."""
    w, d, h = b.w, b.d, b.h
    z = h / 2
    b.rod((0, -d / 2, z), (0, -d * 0.46, z), w * 0.3, "plastic_red", "button", 14)
    b.rod((0, -d * 0.46, z), (0, -d * 0.36, z), w * 0.1, "metal_chrome", "plunger")
    b.cushion((-w * 0.36, w * 0.36), (-d * 0.38, d * 0.02), (0, h), b.mat(), "handle", 0.5)
    b.box((w * 0.2, w / 2), (-d * 0.36, -d * 0.31), (z - h * 0.2, z + h * 0.2), b.mat(), "hook")
    b.box((-w * 0.16, w * 0.16), (-d * 0.2, -d * 0.06), (h * 0.98, h * 1.02), "plastic_white", "window", solid=False)
    for k, r in enumerate((0.22, 0.17, 0.12)):
        b.rod((0, d * (0.02 + 0.09 * k), z), (0, d * (0.11 + 0.09 * k), z), w * r, "plastic_light", "shaft", 12)
    b.rod((0, d * 0.28, z), (0, d * 0.4, z), w * 0.1, "plastic_e5b920", "tip", 10)
    b.rod((0, d * 0.4, z), (0, d / 2, z), w * 0.045, "plastic_e5b920", "tip", 8)


@recipe("scissors")
def scissors(b: Builder) -> None:
    """Two blades that cross at a screw, opened to the front, each with a ring for the fingers behind."""
    w, d, h = b.w, b.d, b.h
    pivot, r = -d * 0.02, min(w * 0.24, d * 0.17)
    for side, z in ((-1, (h * 0.1, h * 0.5)), (1, (h * 0.5, h * 0.9))):
        tip, tail = side * w * 0.3, -side * w * 0.24
        across = w * 0.09
        b.prism(
            [
                (-across, pivot - d * 0.05),
                (across, pivot - d * 0.05),
                (tip + across * 0.2, d / 2),
                (tip - across * 0.4, d * 0.46),
            ],
            z,
            b.mat(),
            "z",
            "blades",
        )
        b.prism(
            [
                (-across, pivot + d * 0.06),
                (across, pivot + d * 0.06),
                (tail + across, -d / 2 + 2 * r),
                (tail - across, -d / 2 + 2 * r),
            ],
            z,
            b.mat(),
            "z",
            "shanks",
        )
        ring = [
            (tail + r * math.cos(k * math.pi / 8), -d / 2 + r + r * math.sin(k * math.pi / 8), h / 2) for k in range(17)
        ]
        b.path(ring, max(r * 0.22, h * 0.4), "plastic_red", "rings")
    b.cyl(0, pivot, (h * 0.85, h), w * 0.07, "metal_dark", "screw")


@recipe("pencil")
def pencil(b: Builder) -> None:
    """A six-sided shaft with a pink rubber in a metal band behind and a sharpened point in front."""
    w, d, h = b.w, b.d, b.h
    r, z = min(w, h) / 2, h / 2
    b.rod((0, -d / 2, z), (0, -d * 0.44, z), r * 0.9, "rubber_pink", "rubber", 10)
    b.rod((0, -d * 0.44, z), (0, -d * 0.36, z), r * 0.95, "metal_light", "band", 10)
    b.rod((0, -d * 0.36, z), (0, d * 0.34, z), r, b.mat(), "shaft", 6, solid=True)
    for k in range(4):
        share = 0.86 - 0.2 * k
        b.rod((0, d * (0.34 + 0.03 * k), z), (0, d * (0.37 + 0.03 * k), z), r * share, "wood_birch", "point", 8)
    b.rod((0, d * 0.46, z), (0, d / 2, z), r * 0.16, "plastic_black", "lead", 6)


@recipe("hair_brush")
def hair_brush(b: Builder) -> None:
    """An oval head with a pad of bristles that look up, and a handle that narrows towards the head."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.45
    b.ball((0, d * 0.2, low * 0.5), (w / 2, d * 0.3, low * 0.5), b.mat(), "head", 16)
    b.rod(
        (0, -d * 0.06, low * 0.5),
        (0, -d * 0.46, low * 0.5),
        min(w * 0.16, low * 0.5),
        b.mat(),
        "handle",
        12,
        solid=True,
    )
    b.ball((0, -d * 0.44, low * 0.5), (w * 0.19, d * 0.06, low * 0.5), b.mat(), "handle", 10)
    b.ball((0, d * 0.2, low * 0.66), (w * 0.4, d * 0.25, low * 0.5), "rubber_red", "pad", 16)
    for i in range(5):
        for j in range(8):
            x, y = (i - 2) / 2.6, (j - 3.5) / 4.2
            if x * x + y * y < 0.95:
                b.cyl(
                    x * w * 0.36,
                    d * 0.2 + y * d * 0.23,
                    (low * 0.9, h),
                    w * 0.02,
                    "plastic_black",
                    "bristles",
                    n=4,
                    solid=False,
                )


@recipe("work_gloves")
def work_gloves(b: Builder) -> None:
    """A pair of gloves side by side, palms down: four fingers, a thumb, a rubber palm and a knitted cuff each."""
    w, d, h = b.w, b.d, b.h
    for side in (-1, 1):
        x, half = side * w * 0.26, w * 0.19
        b.cushion((x - half, x + half), (-d * 0.24, d * 0.14), (0, h), b.mat(), "hands", 0.6)
        b.cushion((x - half * 0.9, x + half * 0.9), (-d / 2, -d * 0.2), (0, h * 0.9), "fabric_red", "cuffs", 0.5)
        for k in range(4):
            middle = x + half * (-0.75 + 0.5 * k)
            reach = d * (0.42, 0.5, 0.48, 0.38)[k if side > 0 else 3 - k]
            b.cushion(
                (middle - half * 0.24, middle + half * 0.24),
                (d * 0.06, reach),
                (h * 0.1, h * 0.85),
                b.mat(),
                "fingers",
                0.9,
                8,
            )
        thumb = x - side * half * 1.0
        b.rod((thumb, -d * 0.12, h * 0.45), (thumb - side * w * 0.05, d * 0.1, h * 0.45), h * 0.3, b.mat(), "thumbs", 8)
