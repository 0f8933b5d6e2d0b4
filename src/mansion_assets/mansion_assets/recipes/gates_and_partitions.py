"""Gates and partitions: turnstiles, barriers, detector gates, screens, booths."""

import itertools
import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("turnstile")
def turnstile(b: Builder) -> None:
    """A narrow steel cabinet with a head of three bars at its side, a card reader and a lit green arrow."""
    w, d, h = b.w, b.d, b.h
    x = (-w / 2, w * 0.1)
    b.box(x, (-d * 0.46, d * 0.46), (0, h * 0.8), b.mat(), "cabinet")
    b.prism(
        [(-d / 2, h * 0.8), (d / 2, h * 0.8), (d / 2, h * 0.86), (d * 0.4, h), (-d * 0.4, h), (-d / 2, h * 0.86)],
        x,
        "metal_dark",
        part="top",
    )
    b.box((x[0], x[1]), (-d * 0.48, d * 0.48), (0, h * 0.06), "metal_dark", "foot")
    hub = (w * 0.12, 0.0, h * 0.74)
    b.rod((x[1], 0, hub[2]), (w * 0.18, 0, hub[2] - 0.02), h * 0.1, "metal_chrome", "head", 16)
    for k in range(3):
        a = math.pi / 2 + k * math.tau / 3
        tip = (w / 2 - 0.03, math.cos(a) * d * 0.3, hub[2] + math.sin(a) * h * 0.3 - h * 0.06)
        b.rod(
            (w * 0.16, math.cos(a) * 0.03, hub[2] + math.sin(a) * 0.03),
            tip,
            0.025,
            "metal_chrome",
            "arms",
            10,
            solid=True,
        )
        b.ball(tip, (0.03, 0.03, 0.03), "metal_chrome", "arms", 8)
    slope = DrawnFace.sloped(b, (d / 2, h * 0.86), (d * 0.4, h))
    middle = -(x[0] + x[1]) / 2
    slope.field((middle - w * 0.2, middle + w * 0.2), (0.03, h * 0.14), "plastic_black", "reader", 0.006)
    slope.field((middle - w * 0.12, middle + w * 0.12), (0.05, h * 0.1), "light_4f9bf0", "reader", 0.01)
    face = DrawnFace.front(b, d * 0.46)
    face.disc(middle, h * 0.66, w * 0.24, "plastic_black", "sign", 0.008)
    face.field((middle - w * 0.04, middle + w * 0.04), (h * 0.6, h * 0.68), "light_green", "sign", 0.014)
    y = (d * 0.46, d * 0.46 + 0.014)
    b.prism(
        [(-middle - w * 0.13, h * 0.67), (-middle + w * 0.13, h * 0.67), (-middle, h * 0.73)],
        y,
        "light_green",
        "y",
        "sign",
    )


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


@recipe("medical_screen")
def medical_screen(b: Builder) -> None:
    """Three frames of steel tube that fold on castors, with gathered cloth between their bars, and a red cross."""
    w, d, h = b.w, b.d, b.h
    reach = d / 2 - 0.05
    ends = [(-w / 2 + 0.03 + (w - 0.06) * k / 3, reach * (-1) ** (k + 1)) for k in range(4)]
    low, high, t = 0.16, h - 0.05, 0.016
    for number, ((x0, y0), (x1, y1)) in enumerate(itertools.pairwise(ends)):
        for x, y in ((x0 + 0.012, y0), (x1 - 0.012, y1)):
            b.rod((x, y, 0.07), (x, y, h - t), t, "metal_chrome", "frame", 10, solid=True)
            b.rod((x - 0.012, y, 0.04), (x + 0.012, y, 0.04), 0.04, "rubber_black", "castors", 14)
        for z in (low - 0.03, h - t):
            b.rod((x0 + 0.012, y0, z), (x1 - 0.012, y1, z), t, "metal_chrome", "frame", 10)
        folds = 16
        pleats = []
        for k in range(folds + 1):
            share = 0.06 + 0.88 * k / folds
            pleats.append((x0 + (x1 - x0) * share, y0 + (y1 - y0) * share + 0.016 * (-1) ** k))
        for (ax, ay), (bx, by) in itertools.pairwise(pleats):
            cloth = [(ax, ay - 0.004), (bx, by - 0.004), (bx, by + 0.004), (ax, ay + 0.004)]
            b.prism(cloth, (low, high), b.mat(), "z", "cloth", solid=False)
        if number != 1:
            continue
        middle = ((x0 + x1) / 2, (y0 + y1) / 2)
        along = math.hypot(x1 - x0, y1 - y0)
        right = ((x0 - x1) / along, (y0 - y1) / along, 0.0)
        out = (-right[1], right[0])
        if out[1] < 0:
            right, out = (-right[0], -right[1], 0.0), (-out[0], -out[1])
        sign = DrawnFace(b, (middle[0] + out[0] * 0.022, middle[1] + out[1] * 0.022, 0.0), right, (0.0, 0.0, 1.0))
        for across, up in ((0.045, 0.14), (0.14, 0.045)):
            sign.field((-across, across), (h * 0.62 - up, h * 0.62 + up), "fabric_d8281e", "cross", 0.01)


@recipe("office_booth")
def office_booth(b: Builder) -> None:
    """A padded booth with a door of glass, the sign of a telephone lit above it, a shelf with a telephone."""
    w, d, h = b.w, b.d, b.h
    t, head = 0.08, h * 0.86
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - t)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (0, h), b.mat(), "sides")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + t), (0, h), "fabric_4f7f9f", "back")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - t, h), b.mat(), "roof")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.05), "fabric_dark", "floor")
    b.box((-w / 2 + t, w / 2 - t), (d / 2 - 0.05, d / 2 - 0.01), (head, h - t), "metal_dark", "lintel")
    sign = DrawnFace.front(b, d / 2 - 0.01)
    sign.write("PHONE", (-w * 0.38, w * 0.38), (head + 0.04, h - t - 0.04), "light_white", "sign", 0.01)
    wall = DrawnFace.side(b, w / 2)
    wall.line(
        [
            (-d * 0.14, h * 0.56),
            (-d * 0.2, h * 0.62),
            (-d * 0.14, h * 0.7),
            (d * 0.14, h * 0.7),
            (d * 0.2, h * 0.62),
            (d * 0.14, h * 0.56),
        ],
        0.045,
        "plastic_white",
        "sign",
    )
    pane = ((-w / 2 + t, w / 2 - t), (d / 2 - 0.03, d / 2 - 0.01), (0.052, head - 0.002))
    with b.door(*pane):
        b.box(*pane, "glass_clear", "door", solid=False)
        b.box((w * 0.3, w * 0.33), (d / 2 - 0.012, d / 2), (0.9, 1.2), "metal_steel", "handle", solid=False)
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, -d / 2 + t + 0.3), (1.0, 1.03), "wood_oak", "shelf")
    y = -d / 2 + t + 0.1
    b.box((-0.12, 0.12), (-d / 2 + t, y), (1.1, 1.42), "plastic_dark", "telephone")
    b.rod((-0.14, y + 0.03, 1.36), (0.14, y + 0.03, 1.36), 0.035, "paint_red", "telephone", 10)
    for x in (-0.13, 0.13):
        b.ball((x, y + 0.04, 1.35), (0.05, 0.05, 0.05), "paint_red", "telephone", 8)
    b.cyl(0, d * 0.06, (0.05, 0.6), 0.03, "metal_chrome", "stool")
    b.cyl(0, d * 0.06, (0.6, 0.66), 0.17, "fabric_orange", "stool", n=20)
