"""Furniture of plain shape that its marks tell apart: nail bars, waiters' stations, trunks, curtains, pools."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.recipes.storage import cabinet
from mansion_assets.recipes.tables import desk
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("nail_table")
def nail_table(b: Builder) -> None:
    """A table with NAILS and a varnished hand on its side."""
    desk(b)
    w, d, h = b.w, b.d, b.h
    side = DrawnFace.side(b, w / 2 - 0.04)
    side.write("NAILS", (-d * 0.34, d * 0.34), (h * 0.66, h * 0.88), "paint_d6287f", "letters", 0.004)
    side.field((-d * 0.12, d * 0.14), (h * 0.14, h * 0.36), "plastic_f0cfae", "hand", 0.004)
    for k in range(4):
        u, top = d * (-0.09 + 0.07 * k), h * (0.54 + 0.03 * (k in (1, 2)))
        side.line([(u, h * 0.34), (u, top)], d * 0.03, "plastic_f0cfae", "hand", 0.0)
        side.disc(u, top, d * 0.032, "paint_d6287f", "hand", 0.03, 12)
    side.line([(d * 0.12, h * 0.2), (d * 0.24, h * 0.36)], d * 0.034, "plastic_f0cfae", "hand", 0.0)
    side.disc(d * 0.24, h * 0.37, d * 0.035, "paint_d6287f", "hand", 0.03, 12)


@recipe("waiter_station")
def waiter_station(b: Builder) -> None:
    """A sideboard with a plate between knife and fork on its doors, and a cup that steams on its side."""
    cabinet(b)
    w, d, h = b.w, b.d, b.h
    face = DrawnFace.front(b, d / 2 - 0.006)
    for door, u in (("door_1", w * 0.25), ("door_2", -w * 0.25)):
        with b.fixed_to(door):
            r = w * 0.11
            face.disc(u, h * 0.5, r, "ceramic_white", "plates", 0.004, 26)
            face.disc(u, h * 0.5, r * 0.66, "ceramic_dfe6ea", "plates", 0.006, 24)
            face.field((u + r * 1.2, u + r * 1.34), (h * 0.36, h * 0.5), "metal_chrome", "knives", 0.006)
            face.field((u + r * 1.16, u + r * 1.44), (h * 0.5, h * 0.64), "metal_chrome", "knives", 0.006)
            face.field((u - r * 1.36, u - r * 1.24), (h * 0.36, h * 0.54), "metal_chrome", "forks", 0.006)
            for k in range(3):
                v = u - r * (1.5 - 0.15 * k)
                face.field((v, v + r * 0.08), (h * 0.53, h * 0.64), "metal_chrome", "forks", 0.006)
            face.field((u - r * 1.5, u - r * 1.12), (h * 0.52, h * 0.55), "metal_chrome", "forks", 0.006)
    side = DrawnFace.side(b, w / 2)
    side.field((-d * 0.2, d * 0.16), (h * 0.4, h * 0.58), "ceramic_white", "cup", 0.004)
    side.field((-d * 0.3, d * 0.26), (h * 0.36, h * 0.39), "ceramic_white", "cup", 0.004)
    side.line(
        [(d * 0.16, h * 0.55), (d * 0.27, h * 0.53), (d * 0.25, h * 0.46), (d * 0.16, h * 0.44)],
        d * 0.025,
        "ceramic_white",
        "cup",
    )
    for k in range(3):
        u = d * (-0.12 + 0.1 * k)
        side.line(
            [(u, h * 0.61), (u + d * 0.03, h * 0.66), (u - d * 0.02, h * 0.71), (u + d * 0.02, h * 0.76)],
            d * 0.012,
            "plastic_white",
            "steam",
        )


@recipe("trunk")
def trunk(b: Builder) -> None:
    """A chest with leather straps and brass corners, a hasp in the middle of its lid, and rope handles at its ends."""
    cabinet(b)
    w, d, h = b.w, b.d, b.h
    face, top = DrawnFace.front(b, d / 2 - 0.006), h * 0.94
    for u in (-w * 0.32, w * 0.32):
        face.field((u - w * 0.035, u + w * 0.035), (h * 0.1, top), "leather_5a3a22", "straps", 0.004)
        face.field((u - w * 0.045, u + w * 0.045), (h * 0.6, h * 0.7), "metal_brass", "buckles", 0.006)
    face.field((-w * 0.06, w * 0.06), (h * 0.6, top), "metal_brass", "hasp", 0.004)
    face.disc(0, h * 0.68, w * 0.02, "plastic_black", "hasp", 0.006, 12)
    for end in ((-w / 2 + 0.004, -w * 0.43), (w * 0.43, w / 2 - 0.004)):
        for level in ((h * 0.1, h * 0.24), (h * 0.8, top)):
            face.field(end, level, "metal_brass", "corners", 0.005)
    side = DrawnFace.side(b, w / 2)
    side.line(
        [(-d * 0.18, h * 0.62), (-d * 0.14, h * 0.46), (d * 0.14, h * 0.46), (d * 0.18, h * 0.62)],
        0.012,
        "fabric_d9c08a",
        "handles",
    )
    with b.fixed_to("lid_1"):
        lid = DrawnFace.top(b, h)
        for u in (-w * 0.32, w * 0.32):
            lid.field((u - w * 0.035, u + w * 0.035), (-d / 2 + 0.03, d / 2), "leather_5a3a22", "straps", 0.001)


@recipe("ward_curtain")
def ward_curtain(b: Builder) -> None:
    """A rail round a bed below the ceiling, with a curtain of deep folds in it whose upper edge is of net."""
    w, d, h = b.w, b.d, b.h
    rail, front = h * 0.9, d / 2 - 0.04
    corners = [(-w / 2 + 0.03, -d / 2), (-w / 2 + 0.03, front), (w / 2 - 0.03, front), (w / 2 - 0.03, -d / 2)]
    b.path([(x, y, rail) for x, y in corners], 0.015, "metal_steel", "rail")
    for x, y in corners[1:3]:
        b.rod((x, y, rail), (x, y, h), 0.012, "metal_steel", "rods", 8)
    folds = max(14, round(w / 0.11))
    for k in range(folds):
        x = -w / 2 + 0.06 + (w - 0.12) * (k + 0.5) / folds
        y = front + 0.022 * (-1) ** k
        b.cyl(x, y, (h * 0.66, rail - 0.03), w / folds * 0.5, "fabric_white", "net", n=8)
        b.cyl(x, y, (0, h * 0.66), w / folds * 0.52, b.mat(), "cloth", n=8)
    for k in range(4):
        y = front - (k + 0.6) * 0.1
        b.cyl(w / 2 - 0.03 - 0.02 * (-1) ** k, y, (0, rail - 0.03), 0.055, b.mat(), "cloth", n=8)


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
    for k in range(1, lanes):
        c = -short / 2 + t + (short - 2 * t) * k / lanes
        floats = 14
        for j in range(floats):
            a = -long / 2 + t + (long - 2 * t) * j / floats
            e = a + (long - 2 * t) / floats * 0.86
            start, end = ((a, c, h * 0.68), (e, c, h * 0.68)) if lengthwise else ((c, a, h * 0.68), (c, e, h * 0.68))
            b.rod(start, end, h * 0.07, ("plastic_red", "plastic_white")[j % 2], "floats", 6)
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
    for u in (-0.06, 0.06):
        x, y = w * 0.3 + short * u, d / 2 - t
        b.path(
            [(x, d / 2 - t * 0.3, h * 0.8), (x, d / 2 - t * 0.4, h), (x, y - t * 0.2, h), (x, y - t * 0.3, h * 0.6)],
            h * 0.05,
            "metal_chrome",
            "ladder",
        )
