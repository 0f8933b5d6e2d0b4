"""Toys and playground equipment."""

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("teddy")
def teddy(b: Builder) -> None:
    """Sitting bear or doll."""
    w, d, h = b.w, b.d, b.h
    b.ball((0, -d * 0.1, h * 0.32), (w * 0.3, d * 0.36, h * 0.32), b.mat(), "body", 12)
    b.ball(
        (0, -d * 0.05, h * 0.74),
        (w * 0.24, d * 0.3, h * 0.2),
        "fabric_skin" if b.mat() != "fabric_brown" else b.mat(),
        "head",
        12,
    )
    for sx in (-1, 1):
        b.ball((sx * w * 0.2, -d * 0.1, h * 0.93), (w * 0.08, d * 0.1, h * 0.07), b.mat(), "ears", 8, solid=False)
        b.ball((sx * w * 0.36, 0, h * 0.42), (w * 0.14, d * 0.18, h * 0.12), b.mat(), "arms", 8, solid=False)
        b.ball((sx * w * 0.24, d * 0.28, h * 0.12), (w * 0.13, d * 0.22, h * 0.12), b.mat(), "legs", 8, solid=False)
        b.ball(
            (sx * w * 0.08, d * 0.2, h * 0.78),
            (w * 0.025, d * 0.04, h * 0.025),
            "plastic_black",
            "eyes",
            6,
            solid=False,
        )
    b.ball((0, d * 0.22, h * 0.7), (w * 0.07, d * 0.08, h * 0.05), "fabric_beige", "snout", 8, solid=False)


@recipe("toy_blocks")
def toy_blocks(b: Builder) -> None:
    """Coloured bricks, some in a small tower."""
    w, d, h = b.w, b.d, b.h
    s = h / 3
    spots = (
        (-0.4, -0.3, 0),
        (0.0, -0.2, 0),
        (0.0, -0.2, 1),
        (0.0, -0.2, 2),
        (0.35, 0.25, 0),
        (-0.25, 0.3, 0),
        (0.36, -0.3, 0),
    )
    for k, (u, v, level) in enumerate(spots):
        x = max(-w / 2 + s / 2, min(w / 2 - s / 2, u * w))
        y = max(-d / 2 + s / 2, min(d / 2 - s / 2, v * d))
        b.box(
            (x - s / 2, x + s / 2),
            (y - s / 2, y + s / 2),
            (level * s, (level + 1) * s - 0.001 * (level < 2)),
            ("paint_red", "paint_blue", "paint_yellow", "paint_green")[k % 4],
            "bricks",
        )
    b.box((-w / 2, -w / 2 + s), (d / 2 - s, d / 2), (0, s), "paint_green", "bricks")
    b.box((w / 2 - s, w / 2), (-d / 2, -d / 2 + s), (0, s), "paint_red", "bricks")


@recipe("rocking_horse")
def rocking_horse(b: Builder) -> None:
    """Horse on rockers."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.02)
        points = [(x, -d / 2 + k * d / 8, 0.02 + 0.12 * ((k - 4) / 4) ** 2) for k in range(9)]
        b.path(points, 0.02, b.mat(), "rockers")
        for y in (-d * 0.22, d * 0.2):
            b.rod((x, y, 0.05), (x * 0.5, y * 0.8, h * 0.5), 0.02, b.mat(), "legs")
    b.cushion((-w * 0.28, w * 0.28), (-d * 0.3, d * 0.26), (h * 0.42, h * 0.66), b.mat(), "body", 0.7)
    b.rod((0, d * 0.2, h * 0.55), (0, d * 0.36, h * 0.88), 0.06, b.mat(), "neck", solid=True)
    b.cushion((-0.05, 0.05), (d * 0.28, d * 0.5), (h * 0.8, h), b.mat(), "head", 0.6)
    b.box((-w * 0.24, w * 0.24), (-d * 0.12, d * 0.1), (h * 0.64, h * 0.68), "fabric_red", "saddle", solid=False)


@recipe("slide")
def slide(b: Builder) -> None:
    """Ladder behind, chute to the front."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.72
    y = -d * 0.22
    b.prism(
        [
            (d / 2, 0.05),
            (d / 2, 0.09),
            (d * 0.3, 0.1),
            (y, top + 0.02),
            (-d * 0.36, top + 0.02),
            (-d * 0.36, top - 0.03),
            (y, top - 0.03),
        ],
        (-w * 0.42, w * 0.42),
        "plastic_yellow",
        part="chute",
    )
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * w * 0.42))
        b.prism([(d / 2, 0.0), (d / 2, 0.14), (y, top + 0.14), (y, top - 0.06)], (lo, hi), b.mat(), part="sides")
        b.rod(
            (sx * (w / 2 - 0.02), -d / 2 + 0.02, 0),
            (sx * (w / 2 - 0.02), -d * 0.34, h - 0.02),
            0.02,
            b.mat(),
            "posts",
            solid=True,
        )
        b.rod((sx * (w / 2 - 0.02), -d * 0.34, h - 0.02), (sx * (w / 2 - 0.02), y, top + 0.1), 0.02, b.mat(), "rails")
    for k in range(4):
        z = 0.15 + k * top / 4.4
        b.box(
            (-w / 2, w / 2),
            (-d / 2 + 0.01 + k * 0.03, -d / 2 + 0.07 + k * 0.03),
            (z, z + 0.03),
            "plastic_blue",
            "steps",
        )
    b.box((-w / 2, w / 2), (-d * 0.36, -d * 0.34), (h - 0.03, h), b.mat(), "rails", solid=False)


@recipe("cat_tree")
def cat_tree(b: Builder) -> None:
    """Post with platforms and a box."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.04), b.mat(), "base")
    b.cyl(-w * 0.2, -d * 0.2, (0.04, h - 0.04), 0.05, "fabric_beige", "post")
    b.cyl(w * 0.25, d * 0.2, (0.04, h * 0.5), 0.05, "fabric_beige", "post")
    b.box((0.0, w / 2), (0.0, d / 2), (h * 0.5, h * 0.53), b.mat(), "boards")
    b.box((-w / 2, w * 0.1), (-d / 2, d * 0.1), (h - 0.04, h), b.mat(), "boards")
    b.box((-w / 2, w * 0.08), (-d / 2, d * 0.3), (0.04, h * 0.3), b.mat(), "box")


@recipe("chess")
def chess(b: Builder) -> None:
    """Board with men."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.2
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, low), "wood_walnut", "board")
    s = w * 0.9 / 8
    for i in range(8):
        for j in range(8):
            x, y = -w * 0.45 + i * s, -d * 0.45 + j * s
            if (i + j) % 2:
                b.box((x, x + s), (y, y + s), (low, low + 0.001), "wood_birch", "squares", solid=False)
            if j in (0, 1, 6, 7):
                high = h - low if (i, j) in ((4, 0), (4, 7)) else (h - low) * (0.75 if j in (0, 7) else 0.5)
                b.lathe(
                    [(0.36, low), (0.16, low + high * 0.4), (0.26, low + high * 0.8), (0.05, low + high)],
                    "wood_birch" if j < 4 else "wood_black",
                    (x + s / 2, y + s / 2),
                    "men",
                    8,
                    (s, s),
                    solid=False,
                )
