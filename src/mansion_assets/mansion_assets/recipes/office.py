"""Partitions, booths, gates, stages and clothes rails."""

from mansion_assets.builder import Box, Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("partition")
def partition(b: Builder) -> None:
    """Folding screen or acoustic panel on feet."""
    w, d, h = b.w, b.d, b.h
    if b.p.get("style") == "fold":
        for k in range(3):
            x0, x1 = -w / 2 + k * w / 3, -w / 2 + (k + 1) * w / 3
            y0, y1 = (-d / 2, d / 2 - 0.03) if k % 2 == 0 else (d / 2 - 0.03, -d / 2)
            b.prism([(x0, y0), (x1, y1), (x1, y1 + 0.03), (x0, y0 + 0.03)], (0.06, h), b.mat(), "z", "panels")
            b.cyl(x0 + 0.02, y0 + 0.015, (0, h), 0.014, "metal_steel", "posts", n=8, solid=False)
        return
    t = min(0.05, d * 0.9)
    b.cushion((-w / 2, w / 2), (-t / 2, t / 2), (0.06, h), b.mat(), "panel", 0.5, 12)
    for sx in (-1, 1):
        x = sx * w * 0.36
        b.box((x - 0.03, x + 0.03), (-d / 2, d / 2), (0, 0.06), "metal_dark", "feet")


@recipe("barrier")
def barrier(b: Builder) -> None:
    """Two posts and a hanging rope."""
    w, d, h = b.w, b.d, b.h
    r = min(d / 2, 0.16)
    for sx in (-1, 1):
        x = sx * (w / 2 - r)
        b.lathe(
            [(r, 0), (r, 0.02), (0.03, 0.04), (0.025, h - 0.05), (0.04, h - 0.03), (0.01, h)],
            b.mat(),
            (x, 0),
            "posts",
            18,
        )
    points = [
        ((t - 0.5) * (w - 2 * r), 0.0, h - 0.12 - 0.25 * (1 - (2 * t - 1) ** 2)) for t in [k / 8 for k in range(9)]
    ]
    b.path(points, 0.018, "fabric_red", "rope")


@recipe("arch")
def arch(b: Builder) -> None:
    """Walk-through detector."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.1)))
        b.box((lo, hi), (-d / 2, d / 2), (0, h), b.mat(), "posts")
        b.box((lo + 0.04, hi - 0.04), (d / 2 - 0.002, d / 2), (h * 0.3, h * 0.8), "light_green", "lights", solid=False)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.22, h), b.mat(), "head")
    b.box((-0.12, 0.12), (d / 2 - 0.002, d / 2), (h - 0.16, h - 0.06), "screen_blue", "display", solid=False)


_GARMENTS = ("fabric_blue", "fabric_red", "fabric_dark", "fabric_beige", "fabric_green", "fabric_white")


@recipe("rail")
def rail(b: Builder) -> None:
    """Clothes rail with garments, or a drying rack."""
    if b.p.get("style") == "airer":
        _airer(b)
        return
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.03)
        b.box((x - 0.03, x + 0.03), (-d / 2, d / 2), (0.04, 0.07), b.mat(), "feet")
        b.cyl(x, 0, (0.05, h), 0.016, b.mat(), "posts", n=10)
    b.wheels(0.03, 0.05)
    bar = h - 0.014
    b.rod((-w / 2 + 0.03, 0, bar), (w / 2 - 0.03, 0, bar), 0.014, b.mat(), "bar", solid=True)
    count = max(6, round(w / 0.09))
    for k in range(count):
        _garment(b, k, -w / 2 + 0.1 + k * (w - 0.2) / (count - 1))


def _garment(b: Builder, k: int, x: float) -> None:
    """One piece on its hanger, sloping from the shoulders."""
    d, h = b.d, b.h
    deep = d * (0.42, 0.36, 0.4)[k % 3]
    low = h * (0.35, 0.28, 0.42, 0.31)[k % 4]
    b.prism(
        [
            (-deep, low),
            (deep, low),
            (deep * 0.95, h - 0.2),
            (0.02, h - 0.06),
            (-0.02, h - 0.06),
            (-deep * 0.95, h - 0.2),
        ],
        (x - 0.018, x + 0.018),
        _GARMENTS[(k * 5 + k // 2) % 6],
        part="clothes",
        solid=k % 3 == 0,
    )


def _airer(b: Builder) -> None:
    """Drying rack on crossed legs, with three cloths."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.012)
        b.rod((x, -d / 2 + 0.01, 0), (x, d / 2 - 0.01, h - 0.012), 0.011, b.mat(), "legs")
        b.rod((x, d / 2 - 0.01, 0), (x, -d / 2 + 0.01, h - 0.012), 0.011, b.mat(), "legs")
    for k in range(7):
        y = -d / 2 + 0.012 + k * (d - 0.024) / 6
        b.rod((-w / 2, y, h - 0.012), (w / 2, y, h - 0.012), 0.006, b.mat(), "bars")
    for k, color in enumerate(("fabric_white", "fabric_blue", "fabric_beige")):
        x = -w * 0.4 + k * w * 0.28
        b.box(
            (x, x + w * 0.22),
            (-d * 0.1 + k * 0.05, -d * 0.1 + k * 0.05 + 0.01),
            (h * 0.5, h - 0.01),
            color,
            "laundry",
            solid=False,
        )
    b.boxes.append(Box((0.0, 0.0, h / 2), (w, d, h)))
