"""Cabinets, booths and cases of wards and shops, told apart by what stands on or in them and by their signs."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.recipes.storage import cabinet
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("crash_cart")
def crash_cart(b: Builder) -> None:
    """A cabinet of drawers on castors with a heartbeat on its front, coloured labels, and a white cross at its side."""
    cabinet(b)
    w, d, h = b.w, b.d, b.h
    face = DrawnFace.front(b, d / 2 - 0.006)
    z, rise = 0.1 + (h - 0.12) * 0.9 + h * 0.02, h * 0.05
    beat = [
        (-w * 0.42, z),
        (-w * 0.1, z),
        (-w * 0.05, z + rise * 0.5),
        (0.0, z - rise),
        (w * 0.05, z + rise),
        (w * 0.1, z),
        (w * 0.42, z),
    ]
    rows = int(b.p["rows"])
    with b.fixed_to(f"drawer_{rows}"):
        face.line(beat, 0.008, "plastic_white", "sign", 0.006)
    for k, color in enumerate(("plastic_white", "paint_yellow", "plastic_4f9bd9", "plastic_green")):
        v = 0.1 + (h - 0.12) * (k + 0.5) / rows
        with b.fixed_to(f"drawer_{k + 1}"):
            face.field((w * 0.24, w * 0.42), (v - h * 0.025, v + h * 0.025), color, "labels", 0.004)
    side = DrawnFace.side(b, w / 2)
    side.field((-d * 0.08, d * 0.08), (h * 0.46, h * 0.9), "plastic_white", "cross", 0.004)
    side.field((-d * 0.24, d * 0.24), (h * 0.6, h * 0.76), "plastic_white", "cross", 0.004)


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


@recipe("book_drop")
def book_drop(b: Builder) -> None:
    """A cabinet with a chute that a book goes into, an open book as its sign, and the words BOOK RETURN."""
    w, d, h = b.w, b.d, b.h
    face = d / 2 - 0.022
    cabinet(b)
    with b.fixed_to("door_1"):
        front = DrawnFace.front(b, face + 0.016)
        front.write("BOOK", (-w * 0.38, w * 0.38), (h * 0.5, h * 0.62), "plastic_white", "letters", 0.004)
        front.write("RETURN", (-w * 0.4, w * 0.4), (h * 0.36, h * 0.47), "plastic_white", "letters", 0.004)
        for side in (-1, 1):
            page = [(0.0, h * 0.14), (side * w * 0.28, h * 0.17), (side * w * 0.28, h * 0.31), (0.0, h * 0.28)]
            b.prism(page, (face + 0.016, face + 0.02), "plastic_white", "y", "sign")
    slot = h - 0.24
    with b.fixed_to("door_1"):
        b.box((-w * 0.2, w * 0.16), (face, d / 2 + 0.12), (slot - 0.004, slot + 0.05), "paper_white", "book")
        for z in (slot - 0.01, slot + 0.05):
            b.box((-w * 0.21, w * 0.17), (face, d / 2 + 0.125), (z, z + 0.01), "paper_red", "book")


@recipe("jewel_case")
def jewel_case(b: Builder) -> None:
    """A case of glass on a dark base, lit from above: necklaces on busts, rings on a cushion."""
    w, d, h = b.w, b.d, b.h
    base = float(b.p.get("base", h * 0.55))
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, base - 0.02), b.mat(), "base")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (base - 0.02, base), "fabric_1f2a5f", "velvet")
    for x in (-w / 2 + 0.006, w / 2 - 0.006):
        for y in (-d / 2 + 0.006, d / 2 - 0.006):
            b.box((x - 0.006, x + 0.006), (y - 0.006, y + 0.006), (base, h), "metal_brass", "frame")
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * (w / 2 - 0.006))), sorted((side * d / 2, side * (d / 2 - 0.006)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (base, h - 0.012), "glass_clear", "glass")
        b.box((-w / 2, w / 2), (along[0], along[1]), (base, h - 0.012), "glass_clear", "glass")
        b.box((-w / 2, w / 2), (along[0], along[1]), (h - 0.012, h), "metal_brass", "frame", solid=False)
        b.box((across[0], across[1]), (-d / 2, d / 2), (h - 0.012, h), "metal_brass", "frame", solid=False)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.008, h - 0.002), "glass_clear", "glass", solid=False)
    tall = h - base
    for k in range(3):
        x = w * (-0.3 + 0.3 * k)
        b.prism(
            [
                (x - 0.09, base),
                (x + 0.09, base),
                (x + 0.07, base + tall * 0.5),
                (x + 0.03, base + tall * 0.8),
                (x - 0.03, base + tall * 0.8),
                (x - 0.07, base + tall * 0.5),
            ],
            (-d * 0.26, -d * 0.16),
            "fabric_f2eee6",
            "y",
            "busts",
        )
        face = DrawnFace.front(b, -d * 0.16)
        face.line(
            [
                (-x - 0.035, base + tall * 0.76),
                (-x - 0.045, base + tall * 0.5),
                (-x, base + tall * 0.3),
                (-x + 0.045, base + tall * 0.5),
                (-x + 0.035, base + tall * 0.76),
            ],
            0.007,
            "metal_brass",
            "necklaces",
            0.004,
        )
        face.disc(-x, base + tall * 0.26, 0.02, ("light_red", "light_4f9bf0", "light_green")[k], "stones", 0.014, 8)
    for k in range(7):
        x = w * (-0.39 + 0.13 * k)
        b.cushion(
            (x - 0.045, x + 0.045), (d * 0.08, d * 0.3), (base, base + tall * 0.16), "fabric_f2eee6", "cushions", 0.7
        )
        ring = [
            (x + math.cos(a) * 0.026, d * 0.18, base + tall * 0.24 + math.sin(a) * 0.026)
            for a in (j * math.tau / 10 for j in range(11))
        ]
        b.path(ring, 0.006, "metal_brass", "rings")
        b.ball(
            (x, d * 0.18, base + tall * 0.24 + 0.034),
            (0.014, 0.014, 0.014),
            ("light_white", "light_red", "light_4f9bf0")[k % 3],
            "stones",
            6,
        )


@recipe("bread_case")
def bread_case(b: Builder) -> None:
    """A counter with a slanted front of glass: loaves above, and croissants, buns and cakes below."""
    w, d, h = b.w, b.d, b.h
    base, levels = float(b.p.get("base", h * 0.55)), 2
    step = (h - 0.03 - base) / levels
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, base - 0.02), b.mat(), "base")
    b.box((-w / 2, w / 2), (-d / 2, d * 0.3), (h - 0.03, h), b.mat(), "roof")
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - 0.01)))
        b.prism(
            [(-d / 2, base - 0.02), (d / 2, base - 0.02), (d / 2, base + 0.1), (d * 0.3, h - 0.03), (-d / 2, h - 0.03)],
            (across[0], across[1]),
            "glass_clear",
            part="glass",
        )
    b.prism(
        [(d / 2 - 0.01, base - 0.02), (d / 2, base - 0.02), (d / 2, base + 0.1), (d / 2 - 0.01, base + 0.1)],
        (-w / 2, w / 2),
        "glass_clear",
        part="glass",
    )
    b.prism(
        [(d / 2 - 0.01, base + 0.1), (d / 2, base + 0.1), (d * 0.3, h - 0.03), (d * 0.3 - 0.01, h - 0.03)],
        (-w / 2, w / 2),
        "glass_clear",
        part="glass",
    )
    for k in range(levels):
        z, depth = base + k * step, d * (0.46 if k == 0 else 0.32)
        b.box(
            (-w / 2 + 0.012, w / 2 - 0.012),
            (-d / 2 + 0.012, depth),
            (z - 0.02, z),
            "metal_steel",
            "boards",
            solid=False,
        )
    count = max(4, round(w / 0.2))
    for k in range(count):
        x = -w / 2 + w * (k + 0.5) / count
        b.ball(
            (x, 0.0, base + step + 0.06), (0.085, d * 0.24, 0.075), ("food_b9742c", "food_8a5a2a")[k % 2], "loaves", 10
        )
        for j in range(3):
            y = -d * 0.12 + j * d * 0.12
            b.rod(
                (x - 0.04, y, base + step + 0.125),
                (x + 0.04, y + 0.02, base + step + 0.125),
                0.01,
                "food_f3dfb4",
                "loaves",
                5,
            )
        for j, y in enumerate((d * 0.34, d * 0.12)):
            kind = (k + j) % 3
            if kind == 0:
                for part in range(5):
                    a = math.radians(200 + 35 * part)
                    b.ball(
                        (x + math.cos(a) * 0.05, y + math.sin(a) * 0.04 + 0.03, base + 0.03),
                        (0.032, 0.03, 0.022 + 0.01 * (2 - abs(part - 2))),
                        "food_d9923a",
                        "croissants",
                        6,
                    )
            elif kind == 1:
                b.ball((x, y, base + 0.04), (0.055, 0.05, 0.04), "food_c8842f", "buns", 10)
            else:
                b.cyl(x, y, (base, base + 0.06), 0.05, "food_f0a0b8", "cakes", n=14)
                b.ball((x, y, base + 0.07), (0.018, 0.018, 0.018), "food_d8281e", "cakes", 6)
    face = DrawnFace.front(b, d / 2)
    face.write("BAKERY", (-w * 0.4, w * 0.4), (base * 0.42, base * 0.76), "plastic_white", "letters", 0.006)


@recipe("gas_rail")
def gas_rail(b: Builder) -> None:
    """A rail over a bed: gas outlets marked O2, AIR and VAC, sockets, a flow meter with its bottle, a lamp."""
    w, d, h = b.w, b.d, b.h
    front = d * 0.1
    b.cushion((-w / 2, w / 2), (-d / 2, front), (h * 0.2, h), b.mat(), "rail", 0.3)
    face = DrawnFace.front(b, front)
    face.field((-w * 0.49, w * 0.49), (h * 0.84, h * 0.95), "light_fff6df", "lamp", 0.004)
    for u, text, color in (
        (-0.4, "O2", "plastic_white"),
        (-0.24, "AIR", "plastic_dark"),
        (-0.08, "VAC", "plastic_yellow"),
    ):
        face.disc(w * u, h * 0.46, h * 0.16, color, "outlets", 0.016)
        face.disc(w * u, h * 0.46, h * 0.07, "metal_brass", "outlets", 0.024)
        face.write(text, (w * u - w * 0.05, w * u + w * 0.05), (h * 0.66, h * 0.8), "plastic_2f3f8f", "letters", 0.003)
    for k in range(4):
        u = w * (0.06 + 0.08 * k)
        face.field(
            (u, u + w * 0.065), (h * 0.34, h * 0.62), "plastic_white" if k < 2 else "paint_red", "sockets", 0.006
        )
        for hole in (0.3, 0.7):
            face.disc(u + w * 0.065 * hole, h * 0.48, h * 0.025, "plastic_black", "sockets", 0.009, 8)
    face.disc(w * 0.44, h * 0.5, h * 0.14, "paint_red", "call", 0.008)
    face.disc(w * 0.44, h * 0.5, h * 0.07, "plastic_white", "call", 0.012)
    x = w * 0.4
    b.rod((x, front, h * 0.46), (x, d * 0.36, h * 0.46), 0.014, "metal_chrome", "meter", 10)
    b.cyl(x, d * 0.36, (h * 0.4, h * 0.9), 0.024, "glass_clear", "meter", n=12)
    b.ball((x, d * 0.36, h * 0.6), (0.016, 0.016, 0.016), "paint_red", "meter", 8)
    b.cyl(x, d * 0.36, (0, h * 0.36), 0.034, "glass_5aa9e6", "bottle", n=14)
    b.cyl(x, d * 0.36, (h * 0.34, h * 0.42), 0.036, "plastic_green", "bottle", n=14)


@recipe("warm_incubator")
def warm_incubator(b: Builder) -> None:
    """A laboratory incubator: a door of glass before racks of petri dishes with cultures, and 37.0 C lit above it."""
    w, d, h = b.w, b.d, b.h
    face, t = d / 2 - 0.05, 0.04
    high = b.cells[0].top if b.cells else h * 0.78
    low = b.cells[0].z if b.cells else 0.25
    b.hollow((-w / 2, w / 2), (-d / 2, face), (low - t, high + t), t, b.mat())
    b.box((-w / 2, w / 2), (-d / 2, face), (0.04, low - t), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d / 2, face), (high + t, h), b.mat(), "case")
    b.box((-w * 0.44, w * 0.44), (-d * 0.44, face - 0.04), (0, 0.04), "plastic_dark", "feet")
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, -d / 2 + t + 0.006), (low, high), "light_f2b880", "glow", solid=False)
    rows = 3
    for k in range(rows):
        z = low + (high - low) * (0.04 + 0.32 * k)
        b.box((-w / 2 + t, w / 2 - t), (face - 0.1, face - 0.004), (z - 0.008, z), "metal_chrome", "racks", solid=False)
        for j in range(4):
            x = w * (-0.3 + 0.2 * j)
            for s in range(2 + (j + k) % 2):
                b.cyl(
                    x,
                    face - 0.06,
                    (z + 0.026 * s, z + 0.026 * s + 0.012),
                    0.048,
                    ("food_e8604f", "food_f2c94c", "food_8fbf6a")[(j + k + s) % 3],
                    "dishes",
                    n=14,
                    solid=False,
                )
                b.cyl(
                    x,
                    face - 0.06,
                    (z + 0.026 * s + 0.012, z + 0.026 * s + 0.022),
                    0.052,
                    "plastic_eef4f6",
                    "dishes",
                    n=14,
                    solid=False,
                )
    door = (face + 0.002, face + 0.026)
    panel = ((-w / 2 + 0.005, w / 2 - 0.005), door, (low - t, high + t * 0.8))
    with b.door(*panel, "left"):
        for across in ((panel[0][0], panel[0][0] + 0.05), (panel[0][1] - 0.05, panel[0][1])):
            b.box(across, door, panel[2], b.mat(), "door")
        for up in ((panel[2][0], panel[2][0] + 0.045), (panel[2][1] - 0.045, panel[2][1])):
            b.box(panel[0], door, up, b.mat(), "door")
        b.box(panel[0], (door[0] + 0.008, door[0] + 0.012), panel[2], "glass_clear", "window", solid=False)
        b.box((w * 0.42, w * 0.45), (door[1], d / 2), (low + 0.1, high - 0.1), "metal_dark", "handle", solid=False)
    front = DrawnFace.front(b, face)
    front.field((-w * 0.36, w * 0.36), (high + t + 0.02, h - 0.02), "plastic_black", "panel", 0.006)
    front.write("37 C", (-w * 0.3, w * 0.14), (high + t + 0.035, h - 0.035), "light_red", "figures", 0.009)
    front.disc(w * 0.26, (high + t + h) / 2, 0.024, "plastic_green", "panel", 0.014)


@recipe("lens_goggles")
def lens_goggles(b: Builder) -> None:
    """Safety spectacles: a frame with two clear lenses parted by a bridge, shields at the sides, and arms."""
    w, d, h = b.w, b.d, b.h
    y = d * 0.4
    b.box((-w / 2, w / 2), (y - d * 0.08, y), (h * 0.86, h), b.mat(), "frame")
    for side in (-1, 1):
        lens = [
            (side * w * 0.06, h * 0.2),
            (side * w * 0.12, 0.0),
            (side * w * 0.42, 0.0),
            (side * w * 0.49, h * 0.26),
            (side * w * 0.49, h * 0.9),
            (side * w * 0.05, h * 0.9),
        ]
        b.prism(lens, (y - d * 0.06, y - d * 0.03), "plastic_bfe3f0", "y", "lenses")
        face = DrawnFace.front(b, y)
        rim = [(-u, v) for u, v in [*lens, lens[0]]]
        face.line(rim, h * 0.05, b.mat(), "frame", -d * 0.04)
        face.line(
            [(-side * w * 0.18 - w * 0.06, h * 0.3), (-side * w * 0.18 + w * 0.1, h * 0.74)],
            h * 0.035,
            "plastic_white",
            "gleam",
            -d * 0.02,
        )
        across = sorted((side * w / 2, side * w * 0.475))
        b.prism(
            [(y, h * 0.3), (y, h * 0.96), (d * 0.1, h * 0.86), (d * 0.1, h * 0.5)],
            (across[0], across[1]),
            "plastic_bfe3f0",
            part="shields",
        )
        b.path(
            [
                (side * w * 0.49, y, h * 0.92),
                (side * w * 0.49, -d * 0.3, h * 0.86),
                (side * w * 0.46, -d / 2, h * 0.07),
            ],
            h * 0.07,
            b.mat(),
            "arms",
        )
    b.path(
        [(-w * 0.06, y - d * 0.03, h * 0.5), (0, y, h * 0.6), (w * 0.06, y - d * 0.03, h * 0.5)],
        h * 0.06,
        b.mat(),
        "bridge",
    )
