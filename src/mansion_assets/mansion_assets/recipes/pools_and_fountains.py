"""Pools, hot tubs and fountains."""

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("pool")
def pool(b: Builder) -> None:
    """Raised basin: hot tub with water, or a pit of balls."""
    w, d, h = b.w, b.d, b.h
    t = min(0.18, w * 0.12)
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - t)))
        b.cushion((lo, hi), (-d / 2, d / 2), (0, h), b.mat(), "rim", 0.3)
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2, sy * (d / 2 - t)))
        b.cushion((-w / 2, w / 2), (lo, hi), (0, h), b.mat(), "rim", 0.3)
    if b.p.get("fill") == "balls":
        n = 8
        for i in range(n):
            for j in range(n):
                x, y = (-w / 2 + t + (i + 0.5) * (w - 2 * t) / n, -d / 2 + t + (j + 0.5) * (d - 2 * t) / n)
                b.ball(
                    (x, y, h * 0.6 + 0.02 * ((i + j) % 3)),
                    (0.07, 0.07, 0.07),
                    ("plastic_red", "plastic_yellow", "plastic_blue", "plastic_green")[(i * 3 + j) % 4],
                    "balls",
                    8,
                    solid=False,
                )
        b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, d / 2 - t), (0, h * 0.55), "plastic_blue", "floor")
    else:
        b.box(
            (-w / 2 + t * 0.8, w / 2 - t * 0.8),
            (-d / 2 + t * 0.8, d / 2 - t * 0.8),
            (0, h * 0.86),
            "glass_blue",
            "water",
        )


@recipe("lane_pool")
def lane_pool(b: Builder) -> None:
    """A basin of blue water with lanes parted by floats, a ladder of steel, and starting blocks at its end."""
    w, d, h = b.w, b.d, b.h
    t = min(0.3, w * 0.08, d * 0.08)
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * (w / 2 - t))), sorted((side * d / 2, side * (d / 2 - t)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (0, h * 0.8), b.mat(), "rim")
        b.box((-w / 2, w / 2), (along[0], along[1]), (0, h * 0.8), b.mat(), "rim")
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, d / 2 - t), (0, h * 0.66), "plastic_4fb3e0", "water")
    lengthwise = w >= d
    long, short = (w, d) if lengthwise else (d, w)
    lanes = 4
    _lane_floats(b, lanes, t, short, long, lengthwise=lengthwise)
    _starting_blocks(b, lanes, t, short, long, lengthwise=lengthwise)
    _pool_ladder(b, t, short)


def _lane_floats(b: Builder, lanes: int, t: float, short: float, long: float, *, lengthwise: bool) -> None:
    """Lines of red and white floats between the lanes."""
    h = b.h
    for k in range(1, lanes):
        c = -short / 2 + t + (short - 2 * t) * k / lanes
        floats = 14
        for j in range(floats):
            a = -long / 2 + t + (long - 2 * t) * j / floats
            e = a + (long - 2 * t) / floats * 0.86
            start, end = ((a, c, h * 0.68), (e, c, h * 0.68)) if lengthwise else ((c, a, h * 0.68), (c, e, h * 0.68))
            b.rod(start, end, h * 0.07, ("plastic_red", "plastic_white")[j % 2], "floats", 6)


def _starting_blocks(b: Builder, lanes: int, t: float, short: float, long: float, *, lengthwise: bool) -> None:
    """A starting block at the end of each lane, and the line on its floor."""
    h = b.h
    for k in range(lanes):
        c = -short / 2 + t + (short - 2 * t) * (k + 0.5) / lanes
        half = short / lanes * 0.22
        far = (-long / 2, -long / 2 + t)
        b.box(
            *((far, (c - half, c + half)) if lengthwise else ((c - half, c + half), far)),
            (h * 0.8, h * 0.97),
            "plastic_2f5fc8",
            "blocks",
        )
        line = (-long / 2 + t * 2, long / 2 - t * 2)
        stripe = (c - half * 0.2, c + half * 0.2)
        b.box(
            *((line, stripe) if lengthwise else (stripe, line)),
            (h * 0.655, h * 0.664),
            "plastic_1f3f7f",
            "lines",
            solid=False,
        )


def _pool_ladder(b: Builder, t: float, short: float) -> None:
    """A ladder of steel tubes at the front edge."""
    w, d, h = b.w, b.d, b.h
    for u in (-0.06, 0.06):
        x, y = w * 0.3 + short * u, d / 2 - t
        b.path(
            [(x, d / 2 - t * 0.3, h * 0.8), (x, d / 2 - t * 0.4, h), (x, y - t * 0.2, h), (x, y - t * 0.3, h * 0.6)],
            h * 0.05,
            "metal_chrome",
            "ladder",
        )


@recipe("hot_tub")
def hot_tub(b: Builder) -> None:
    """A tub with a wooden skirt, blue water that bubbles, head rests at its rim, a row of buttons."""
    w, d, h = b.w, b.d, b.h
    front, rim = d / 2 - 0.3, 0.24
    middle, depth = (front - d / 2) / 2, front + d / 2
    b.box((-w / 2 + 0.04, w / 2 - 0.04), (-d / 2 + 0.04, front - 0.04), (0, h * 0.6), "wood_walnut", "skirt")
    for k in range(11):
        x = -w / 2 + 0.06 + (w - 0.12) * k / 10
        b.box((x - 0.012, x + 0.012), (front - 0.04, front - 0.03), (0.02, h * 0.8), "wood_brown", "slats", solid=False)
        y = -d / 2 + 0.06 + (depth - 0.12) * k / 10
        b.box((w / 2 - 0.04, w / 2 - 0.03), (y - 0.012, y + 0.012), (0.02, h * 0.8), "wood_brown", "slats", solid=False)
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - rim)))
        along = sorted((middle + side * depth / 2, middle + side * (depth / 2 - rim)))
        b.cushion((across[0], across[1]), (-d / 2, front), (h * 0.6, h), b.mat(), "rim", 0.5)
        b.cushion((-w / 2, w / 2), (along[0], along[1]), (h * 0.6, h), b.mat(), "rim", 0.5)
        b.cushion(
            (side * w * 0.22 - 0.16, side * w * 0.22 + 0.16),
            (-d / 2 + 0.02, -d / 2 + 0.2),
            (h * 0.96, h * 1.06),
            "leather_dark",
            "rests",
            0.8,
        )
    b.box((-w / 2 + rim, w / 2 - rim), (-d / 2 + rim, front - rim), (h * 0.6, h * 0.9), "plastic_4fb3e0", "water")
    for k in range(26):
        x, y = (
            (w - 2 * rim - 0.2) * (((k * 0.618) % 1.0) - 0.5),
            middle + (depth - 2 * rim - 0.2) * (((k * 0.382 + 0.1 * (k % 3)) % 1.0) - 0.5),
        )
        r = 0.045 + 0.02 * (k % 3)
        b.ball((x, y, h * 0.9), (r, r, r * 0.8), ("plastic_white", "plastic_dff2fb")[k % 2], "bubbles", 8)
    for k in range(4):
        b.cyl(
            w / 2 - rim / 2,
            middle - 0.15 + 0.1 * k,
            (h * 0.985, h * 1.01),
            0.03,
            ("plastic_red", "plastic_blue", "metal_chrome", "metal_chrome")[k],
            "buttons",
            n=12,
        )
    for k in range(2):
        b.box((-0.45, 0.45), (front - 0.05, d / 2 - 0.15 * k), (0, h * (0.26 + 0.26 * k)), "wood_walnut", "steps")


@recipe("fountain")
def fountain(b: Builder) -> None:
    """Two bowls and a spout."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.5, 0), (0.5, h * 0.3), (0.45, h * 0.3), (0.44, h * 0.22)], b.mat(), stretch=(w, d), n=32)
    b.cyl(0, 0, (h * 0.22, h * 0.25), w * 0.44, "glass_blue", "water", n=32, solid=False)
    b.lathe(
        [(0.08, h * 0.2), (0.05, h * 0.55), (0.24, h * 0.68), (0.22, h * 0.68), (0.04, h * 0.6)],
        b.mat(),
        stretch=(w, d),
        n=24,
        part="bowl",
    )
    b.cyl(0, 0, (h * 0.6, h), w * 0.03, b.mat(), "spout", w * 0.01)
