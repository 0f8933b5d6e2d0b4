"""Musical instruments and music stands."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("piano")
def piano(b: Builder) -> None:
    """Upright piano; the keys are at the front."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + d * 0.5), (0, h), m, "case")
    b.box((-w / 2, w / 2), (-d / 2 + d * 0.5, d / 2), (0.58, 0.66), m, "keybed")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.05)))
        b.box((lo, hi), (-d / 2 + d * 0.5, d / 2), (0, 0.74), m, "arms")
    b.box((-w / 2 + 0.06, w / 2 - 0.06), (d * 0.12, d * 0.46), (0.66, 0.69), "plastic_white", "keys", solid=False)
    for k in range(30):
        if k % 7 not in (2, 6):
            x = -w / 2 + 0.1 + k * (w - 0.2) / 30
            b.box((x, x + 0.012), (d * 0.12, d * 0.32), (0.69, 0.702), "plastic_black", "keys", solid=False)
    b.box((-w * 0.3, w * 0.3), (0.0, 0.02), (0.74, 0.96), m, "desk", solid=False)
    for x in (-0.05, 0.05):
        b.box((x - 0.015, x + 0.015), (0.0, 0.12), (0.05, 0.07), "metal_brass", "pedals", solid=False)


@recipe("grand_piano")
def grand_piano(b: Builder) -> None:
    """Grand piano, its lid closed, keys at the front."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    outline = [
        (-w / 2, d / 2),
        (-w / 2, -d * 0.4),
        (-w * 0.4, -d / 2),
        (-w * 0.1, -d / 2),
        (w * 0.12, -d * 0.3),
        (w * 0.4, -d * 0.02),
        (w / 2, d * 0.16),
        (w / 2, d / 2),
    ]
    b.prism([(x, min(y, d * 0.3)) for x, y in outline], (h - 0.32, h - 0.03), m, "z", "case")
    b.prism([(x, min(y, d * 0.3)) for x, y in outline], (h - 0.03, h), m, "z", "lid")
    b.box((-w / 2, w / 2), (d * 0.28, d / 2), (h - 0.32, h - 0.2), m, "keybed")
    b.box((-w / 2 + 0.1, w / 2 - 0.1), (d * 0.31, d * 0.46), (h - 0.2, h - 0.18), "plastic_white", "keys", solid=False)
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.08)))
        b.box((lo, hi), (d * 0.28, d / 2), (h - 0.32, h - 0.12), m, "arms")
    for x, y in ((-w * 0.4, d * 0.34), (w * 0.4, d * 0.34), (-w * 0.2, -d * 0.36)):
        b.cyl(x, y, (0, h - 0.32), 0.06, m, "legs", 0.08, 14)
    b.rod((0, d * 0.2, 0.05), (0, d * 0.2, h - 0.32), 0.03, m, "lyre")


@recipe("drums")
def drums(b: Builder) -> None:
    """Bass drum, toms, snare, cymbals, stool."""
    w, d, h = b.w, b.d, b.h
    b.rod((-0.02, d * 0.1, 0.3), (-0.02, d / 2, 0.3), 0.29, b.mat(), "bass", 28, solid=True)
    b.rod((-0.02, d / 2 - 0.02, 0.3), (-0.02, d / 2 - 0.002, 0.3), 0.26, "plastic_white", "bass", 28)
    for x, y, z, r in (
        (-0.22, 0.18, 0.62, 0.15),
        (0.18, 0.18, 0.62, 0.15),
        (0.46, -0.12, 0.38, 0.2),
        (-0.46, -0.1, 0.5, 0.17),
    ):
        b.cyl(x, y, (z, z + 0.22), r, b.mat(), "toms", n=22)
        b.cyl(x, y, (z + 0.22, z + 0.226), r, "plastic_white", "skins", n=22, solid=False)
        b.cyl(x, y, (0, z), 0.015, "metal_steel", "stands", n=8, solid=False)
    for x, y, r in ((-w / 2 + 0.2, 0.25, 0.2), (w / 2 - 0.22, 0.3, 0.22)):
        b.cyl(x, y, (0, h - 0.02), 0.012, "metal_steel", "stands", n=8)
        b.cyl(x, y, (h - 0.03, h), r, "metal_brass", "cymbals", 0.02, 24)
        for k in range(3):
            a = k * 2.094
            b.rod((x, y, 0.2), (x + 0.18 * math.cos(a), y + 0.18 * math.sin(a), 0.01), 0.008, "metal_steel", "stands")
    b.cyl(0, -d / 2 + 0.17, (0.42, 0.5), 0.17, "leather_black", "stool", n=20)
    b.cyl(0, -d / 2 + 0.17, (0, 0.42), 0.03, "metal_steel", "stool")


@recipe("guitar")
def guitar(b: Builder) -> None:
    """Guitar on a stand, or a violin lying on its back."""
    w, d, h = b.w, b.d, b.h
    if b.p.get("style") == "stand":
        r = w / 2
        b.rod((0, 0.0, r * 0.9 + 0.08), (0, 0.09, r * 0.9 + 0.08), r * 0.98, b.mat(), "body", 24, solid=True)
        b.rod((0, 0.0, r * 1.9 + 0.1), (0, 0.09, r * 1.9 + 0.1), r * 0.74, b.mat(), "body", 24, solid=True)
        b.rod((0, 0.085, r * 1.6 + 0.1), (0, 0.093, r * 1.6 + 0.1), 0.05, "plastic_black", "hole", 16)
        b.box((-0.028, 0.028), (0.04, 0.075), (r * 2.2, h - 0.12), "wood_brown", "neck")
        b.box((-0.04, 0.04), (0.03, 0.06), (h - 0.13, h), "wood_brown", "head")
        for sx in (-1, 1):
            b.rod((sx * 0.1, -d / 2 + 0.02, 0.0), (sx * 0.04, -0.03, h * 0.5), 0.012, "metal_black", "stand")
            b.rod((sx * 0.1, -0.05, 0.08), (sx * 0.12, d / 2 - 0.01, 0.06), 0.012, "metal_black", "stand")
        return
    b.cushion((-w / 2, w / 2), (-d / 2, -d * 0.18), (0, h * 0.6), b.mat(), "body", 0.9, 14)
    b.cushion((-w * 0.42, w * 0.42), (-d * 0.24, d * 0.06), (0, h * 0.6), b.mat(), "body", 0.9, 14)
    b.box((-w * 0.07, w * 0.07), (-d * 0.1, d / 2), (h * 0.55, h * 0.8), "wood_black", "neck")
    b.box((-w * 0.12, w * 0.12), (-d * 0.2, -d * 0.18), (h * 0.5, h), "wood_birch", "bridge")


@recipe("violin")
def violin(b: Builder) -> None:
    """A waisted body with f-holes, bridge, chin rest and strings, a fingerboard to a scroll with pegs; a bow."""
    w, d, h = b.w, b.d, b.h
    top, wood = h * 0.5, "wood_a5521f"
    for y, rx, ry in ((-d * 0.3, 0.42, 0.17), (-d * 0.02, 0.34, 0.13)):
        b.lathe([(1.0, 0), (1.0, top)], wood, (w * 0.06, y), "body", 24, (w * rx, d * ry))
        b.lathe([(0.93, top), (0.86, top * 1.12)], "wood_c8742f", (w * 0.06, y), "belly", 24, (w * rx, d * ry))
    b.box((-w * 0.18, w * 0.3), (-d * 0.26, -d * 0.04), (0, top * 1.02), wood, "body")
    b.box((-w * 0.17, w * 0.29), (-d * 0.26, -d * 0.04), (top * 1.02, top * 1.12), "wood_c8742f", "belly", solid=False)
    face = DrawnFace.top(b, top * 1.12)
    for side in (-1, 1):
        u = -w * 0.06 + side * w * 0.17
        hole = [(u - side * w * 0.03, d * 0.235), (u, d * 0.21), (u, d * 0.13), (u + side * w * 0.03, d * 0.1)]
        face.line(hole, w * 0.016, "plastic_black", "holes")
    x = w * 0.06
    b.box((x - w * 0.13, x + w * 0.13), (-d * 0.185, -d * 0.175), (top * 1.1, h * 0.86), "wood_birch", "bridge")
    b.prism(
        [(x - w * 0.05, -d * 0.4), (x + w * 0.05, -d * 0.4), (x + w * 0.09, -d * 0.26), (x - w * 0.09, -d * 0.26)],
        (top * 1.1, h * 0.78),
        "plastic_black",
        "z",
        "tail",
    )
    b.box((x - w * 0.065, x + w * 0.065), (-d * 0.08, d * 0.34), (h * 0.66, h * 0.78), "plastic_black", "fingerboard")
    b.box((x - w * 0.06, x + w * 0.06), (d * 0.08, d * 0.36), (h * 0.34, h * 0.66), wood, "neck")
    b.box((x - w * 0.05, x + w * 0.05), (d * 0.34, d * 0.46), (h * 0.3, h * 0.62), wood, "scroll")
    b.rod((x - w * 0.08, d * 0.46, h * 0.4), (x + w * 0.08, d * 0.46, h * 0.4), h * 0.24, wood, "scroll", 14)
    for k in range(4):
        y, side = d * (0.36 + 0.025 * k), (-1) ** k
        b.rod((x, y, h * 0.46), (x + side * w * 0.17, y, h * 0.46), w * 0.025, "plastic_black", "pegs", 8)
        u = x + w * (-0.045 + 0.03 * k)
        b.path(
            [(u, -d * 0.3, h * 0.8), (u, -d * 0.18, h * 0.87), (u, d * 0.36, h * 0.8)],
            w * 0.006,
            "metal_chrome",
            "strings",
        )
    b.cushion(
        (x + w * 0.06, x + w * 0.32), (-d * 0.46, -d * 0.34), (top * 1.1, h * 0.84), "plastic_black", "chin_rest", 0.7
    )
    bow = -w * 0.42
    b.rod((bow, -d * 0.46, h * 0.3), (bow, d * 0.46, h * 0.3), w * 0.022, "wood_5a2f16", "bow", 8)
    b.box((bow + w * 0.03, bow + w * 0.07), (-d * 0.42, d * 0.45), (h * 0.02, h * 0.1), "plastic_white", "bow")
    b.box((bow - w * 0.02, bow + w * 0.08), (-d * 0.47, -d * 0.4), (0, h * 0.34), "plastic_black", "bow")
    b.box((bow - w * 0.02, bow + w * 0.08), (d * 0.44, d * 0.48), (0, h * 0.34), "wood_5a2f16", "bow")


@recipe("music_stand")
def music_stand(b: Builder) -> None:
    """Desk on a tripod; the sheet looks to the front."""
    w, d, h = b.w, b.d, b.h
    for k in range(3):
        a = -math.pi / 2 + k * 2 * math.pi / 3
        b.rod((0, 0, 0.18), (math.cos(a) * w * 0.48, math.sin(a) * d * 0.48, 0.01), 0.009, b.mat(), "legs")
    b.cyl(0, 0, (0.05, h * 0.78), 0.012, b.mat(), "pole")
    b.prism(
        [(d * 0.2, h * 0.72), (d * 0.26, h * 0.73), (-d * 0.1, h), (-d * 0.14, h)],
        (-w / 2, w / 2),
        b.mat(),
        part="desk",
    )
    b.prism(
        [(d * 0.25, h * 0.76), (d * 0.26, h * 0.765), (-d * 0.06, h * 0.985), (-d * 0.07, h * 0.98)],
        (-w * 0.4, w * 0.4),
        "paper_white",
        part="sheets",
        solid=False,
    )
    b.box((-w / 2, w / 2), (d * 0.18, d * 0.34), (h * 0.715, h * 0.725), b.mat(), "ledge")
