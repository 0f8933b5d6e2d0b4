"""Cases and stands that display goods: glass cases, bakery and jewellery counters, salad bars, freezers, flowers."""

import math
from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, volume
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@receptacles("vitrine", "museum_case")
def _vitrine_levels(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    base = float(p.get("base", min(0.9, h * 0.55)))
    box = (-w / 2 + 0.04, w / 2 - 0.04, -d / 2 + 0.04, d / 2 - 0.04)
    count = int(p.get("levels", 1))
    step = (h - 0.03 - base) / count
    return [volume("case", box, base + i * step, base + (i + 1) * step - 0.02) for i in range(count)]


@recipe("vitrine")
def vitrine(b: Builder) -> None:
    """Glass case on a base; an aquarium where it is filled with water."""
    w, d, h = b.w, b.d, b.h
    base = float(b.p.get("base", min(0.9, h * 0.55)))
    fill, main = b.p.get("fill", "none"), b.mat()
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, base - 0.02), main, "base")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.03, h), main, "lid")
    glass = "glass_clear"
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.01)))
        b.box((lo, hi), (-d / 2, d / 2), (base - 0.02, h - 0.03), glass, "glass")
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2, sy * (d / 2 - 0.01)))
        b.box((-w / 2, w / 2), (lo, hi), (base - 0.02, h - 0.03), glass, "glass")
    levels = int(b.p.get("levels", 1))
    step = (h - 0.03 - base) / levels
    for k in range(levels):
        z = base + k * step
        b.box(
            (-w / 2 + 0.012, w / 2 - 0.012), (-d / 2 + 0.012, d / 2 - 0.012), (z - 0.02, z), main, "boards", solid=False
        )
        _contents(b, str(fill), z, step)


def _contents(b: Builder, fill: str, z: float, room: float) -> None:
    """Water with fish."""
    w, d = b.w, b.d
    if fill == "water":
        b.box(
            (-w / 2 + 0.012, w / 2 - 0.012),
            (-d / 2 + 0.012, d / 2 - 0.012),
            (z, z + room * 0.85),
            "glass_blue",
            "water",
            solid=False,
        )
        for k in range(6):
            x = -w * 0.35 + k * w * 0.14
            b.ball(
                (x, 0.05 * (-1) ** k, z + room * (0.2 + 0.1 * (k % 4))),
                (0.04, 0.012, 0.02),
                "paint_orange",
                "fish",
                8,
                solid=False,
            )


@recipe("museum_case")
def museum_case(b: Builder) -> None:
    """A case of glass in which a golden mask hangs before dark velvet, with a label of the exhibit on its base."""
    w, d, h = b.w, b.d, b.h
    base = min(0.9, h * 0.55)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, base - 0.02), b.mat(), "base")
    b.box(
        (-w / 2 + 0.012, w / 2 - 0.012), (-d / 2 + 0.012, d / 2 - 0.012), (base - 0.02, base), "fabric_5a1f2a", "floor"
    )
    for sx in (-1, 1):
        across = sorted((sx * w / 2, sx * (w / 2 - 0.01)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (base - 0.02, h - 0.008), "glass_clear", "glass")
        for sy in (-1, 1):
            x, y = sx * (w / 2 - 0.008), sy * (d / 2 - 0.008)
            b.box((x - 0.008, x + 0.008), (y - 0.008, y + 0.008), (base, h), "metal_brass", "edges", solid=False)
    b.box((-w / 2, w / 2), (d / 2 - 0.01, d / 2), (base - 0.02, h - 0.008), "glass_clear", "glass")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.016, h - 0.004), "glass_clear", "lid")
    for side in (-1, 1):
        rim = (h - 0.018, h)
        along = sorted((side * d / 2, side * (d / 2 - 0.016)))
        b.box((-w / 2, w / 2), (along[0], along[1]), rim, "metal_brass", "edges", solid=False)
        across = sorted((side * w / 2, side * (w / 2 - 0.016)))
        b.box((across[0], across[1]), (-d / 2, d / 2), rim, "metal_brass", "edges", solid=False)
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.012), (base - 0.02, h - 0.008), "fabric_5a1f2a", "velvet")
    wall = DrawnFace.front(b, -d / 2 + 0.012)
    room = h - base
    _golden_mask(wall, base + room * 0.48, min(room * 0.42, w * 0.36))
    label = DrawnFace.front(b, d / 2)
    label.field((-w * 0.3, w * 0.3), (base * 0.56, base * 0.86), "metal_brass", "label", 0.004)
    label.field((-w * 0.28, w * 0.28), (base * 0.575, base * 0.845), "paper_f7f0dc", "label", 0.005)
    label.write("MUSEUM", (-w * 0.25, w * 0.25), (base * 0.7, base * 0.82), "plastic_26272b", "letters", 0.007)
    for k in range(3):
        level = base * (0.6 + 0.03 * k)
        label.field((-w * 0.22, w * (0.22 - 0.06 * k)), (level, level + base * 0.012), "plastic_5a6470", "label", 0.006)


def _golden_mask(face: DrawnFace, v: float, r: float) -> None:
    """The mask of a pharaoh: a face between the striped wings of a head cloth, with a beard."""
    gold, blue = "metal_f2c12e", "plastic_1f4f9e"
    for k in range(9):
        low, high = v - r + 2 * r * k / 9, v - r + 2 * r * (k + 1) / 9
        half = r * (0.95, 1.0, 0.98, 0.95, 0.9, 0.85, 0.78, 0.68, 0.5)[k]
        face.field((-half, half), (low, high), (gold, blue)[k % 2], "cloth", 0.008)
    for k in range(7):
        low, high = v - r * 0.62 + r * 1.2 * k / 7, v - r * 0.62 + r * 1.2 * (k + 1) / 7
        half = r * (0.24, 0.38, 0.46, 0.5, 0.5, 0.48, 0.42)[k]
        face.field((-half, half), (low, high), gold, "mask", 0.016)
    face.field((-r * 0.5, r * 0.5), (v + r * 0.56, v + r * 0.66), blue, "mask", 0.018)
    for side in (-1, 1):
        inner, outer = sorted((side * r * 0.1, side * r * 0.38))
        face.field((inner, outer), (v + r * 0.1, v + r * 0.24), "plastic_26272b", "eyes", 0.019)
        face.disc(side * r * 0.24, v + r * 0.17, r * 0.06, "plastic_white", "eyes", 0.021, 10)
    face.field((-r * 0.05, r * 0.05), (v - r * 0.16, v + r * 0.14), "metal_c9922a", "nose", 0.024)
    face.field((-r * 0.16, r * 0.16), (v - r * 0.36, v - r * 0.28), "plastic_8a4a1a", "mouth", 0.019)
    face.field((-r * 0.1, r * 0.1), (v - r * 1.0, v - r * 0.6), blue, "beard", 0.02)


@recipe("jewel_case")
def jewel_case(b: Builder) -> None:
    """A case of glass on a dark base, lit from above: necklaces on busts, rings on a cushion."""
    h = b.h
    base = float(b.p.get("base", h * 0.55))
    _brass_and_glass(b, base)
    tall = h - base
    _necklaces(b, base, tall)
    _rings(b, base, tall)


def _brass_and_glass(b: Builder, base: float) -> None:
    """A base under velvet, and glass in a frame of brass."""
    w, d, h = b.w, b.d, b.h
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


def _necklaces(b: Builder, base: float, tall: float) -> None:
    """Three busts, each with a necklace and its stone."""
    w, d = b.w, b.d
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


def _rings(b: Builder, base: float, tall: float) -> None:
    """Seven cushions, each with a ring and its stone."""
    w, d = b.w, b.d
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
    _slanted_glass(b, base, levels, step)
    count = max(4, round(w / 0.2))
    for k in range(count):
        x = -w / 2 + w * (k + 0.5) / count
        _loaf(b, x, base + step, ("food_b9742c", "food_8a5a2a")[k % 2])
        for j, y in enumerate((d * 0.34, d * 0.12)):
            (_croissant, _bun, _small_cake)[(k + j) % 3](b, x, y, base)
    face = DrawnFace.front(b, d / 2)
    face.write("BAKERY", (-w * 0.4, w * 0.4), (base * 0.42, base * 0.76), "plastic_white", "letters", 0.006)


def _loaf(b: Builder, x: float, z: float, crust: str) -> None:
    """A loaf with three cuts across its top."""
    d = b.d
    b.ball((x, 0.0, z + 0.06), (0.085, d * 0.24, 0.075), crust, "loaves", 10)
    for j in range(3):
        y = -d * 0.12 + j * d * 0.12
        b.rod((x - 0.04, y, z + 0.125), (x + 0.04, y + 0.02, z + 0.125), 0.01, "food_f3dfb4", "loaves", 5)


def _croissant(b: Builder, x: float, y: float, z: float) -> None:
    for part in range(5):
        a = math.radians(200 + 35 * part)
        b.ball(
            (x + math.cos(a) * 0.05, y + math.sin(a) * 0.04 + 0.03, z + 0.03),
            (0.032, 0.03, 0.022 + 0.01 * (2 - abs(part - 2))),
            "food_d9923a",
            "croissants",
            6,
        )


def _bun(b: Builder, x: float, y: float, z: float) -> None:
    b.ball((x, y, z + 0.04), (0.055, 0.05, 0.04), "food_c8842f", "buns", 10)


def _small_cake(b: Builder, x: float, y: float, z: float) -> None:
    """A round cake with a cherry."""
    b.cyl(x, y, (z, z + 0.06), 0.05, "food_f0a0b8", "cakes", n=14)
    b.ball((x, y, z + 0.07), (0.018, 0.018, 0.018), "food_d8281e", "cakes", 6)


def _slanted_glass(b: Builder, base: float, levels: int, step: float) -> None:
    """A base, a roof and boards within glass that slants back."""
    w, d, h = b.w, b.d, b.h
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


@recipe("salad_bar")
def salad_bar(b: Builder) -> None:
    """A counter with steel pans of food, and a sneeze guard of glass on posts over it."""
    w, d, h = b.w, b.d, b.h
    heap = 0.14
    deck = h - float(b.p.get("depth", h * 0.3))
    b.box((-w * 0.48, w * 0.48), (-d * 0.46, d * 0.46), (0.06, deck - 0.05), "wood_oak", "body")
    b.box((-w * 0.46, w * 0.46), (-d * 0.42, d * 0.42), (0, 0.06), "plastic_dark", "plinth")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (deck - 0.05, deck), b.mat(), "deck")
    b.box((-w / 2, w / 2), (d * 0.47, d / 2), (deck - 0.12, deck - 0.09), b.mat(), "tray_rail")
    foods = (
        "leaf_green",
        "food_red",
        "food_yellow",
        "food_orange",
        "leaf_green",
        "food_beige",
        "food_purple",
        "food_green",
    )
    columns = 4
    for k, color in enumerate(foods):
        x0 = -w * 0.46 + (k % columns) * w * 0.92 / columns
        x, y = (x0 + 0.02, x0 + w * 0.92 / columns - 0.02), ((-d * 0.36, -d * 0.01), (d * 0.02, d * 0.37))[k // columns]
        b.box(x, y, (deck, deck + heap * 0.2), "metal_chrome", "pans")
        for j in range(6):
            cx = x[0] + (0.2 + 0.3 * (j % 3)) * (x[1] - x[0])
            cy = y[0] + (0.3 + 0.4 * (j // 3)) * (y[1] - y[0])
            b.ball(
                (cx, cy, deck + heap * 0.25),
                ((x[1] - x[0]) * 0.2, (y[1] - y[0]) * 0.24, heap * (0.3 + 0.12 * (j % 2))),
                color,
                "food",
                6,
                solid=False,
            )
    _sneeze_guard(b, deck, heap)


def _sneeze_guard(b: Builder, deck: float, heap: float) -> None:
    """Panes of glass that slope down by `heap` on both sides of a lamp on two posts."""
    w, d, h = b.w, b.d, b.h
    guard = h - 0.04
    for x in (-w * 0.47, w * 0.47):
        b.rod((x, 0, deck), (x, 0, guard), 0.018, "metal_chrome", "posts")
    for side in (-1, 1):
        b.prism(
            [
                (side * d * 0.04, guard),
                (side * d * 0.4, guard - heap),
                (side * d * 0.41, guard - heap * 0.94),
                (side * d * 0.04, guard + 0.012),
            ],
            (-w / 2, w / 2),
            "glass_blue",
            part="guard",
        )
    b.box((-w / 2, w / 2), (-d * 0.06, d * 0.06), (guard, guard + 0.04), "metal_chrome", "lamp")


@recipe("frozen_chest")
def frozen_chest(b: Builder) -> None:
    """A white chest with sliding panes of glass over boxes of food, snowflakes and the word FROZEN on its front."""
    w, d, h = b.w, b.d, b.h
    low, t = h * 0.7, 0.05
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.02, d / 2 - 0.02), (0.06, low), b.mat(), "base")
    b.box((-w * 0.47, w * 0.47), (-d * 0.45, d * 0.45), (0, 0.06), "plastic_dark", "plinth")
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * (w / 2 - t))), sorted((side * d / 2, side * (d / 2 - t)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (low - 0.1, h - 0.012), "plastic_4f9bd9", "rim")
        b.box((-w / 2, w / 2), (along[0], along[1]), (low - 0.1, h - 0.012), "plastic_4f9bd9", "rim")
    cols, rows = max(3, round(w / 0.26)), 3
    for i in range(cols):
        for j in range(rows):
            x0, y0 = -w / 2 + t + i * (w - 2 * t) / cols, -d / 2 + t + j * (d - 2 * t) / rows
            place = (x0 + 0.01, x0 + (w - 2 * t) / cols - 0.01), (y0 + 0.01, y0 + (d - 2 * t) / rows - 0.01)
            color = ("paper_red", "plastic_dff2fb", "paper_blue", "paper_green", "paper_yellow")[(i * 2 + j) % 5]
            b.box(*place, (low, low + (h - low) * (0.4 + 0.12 * ((i + j) % 3))), color, "goods", solid=False)
    for k, z in enumerate((h - 0.012, h - 0.006)):
        pane = (-w / 2 + 0.01, w * 0.02) if k == 0 else (-w * 0.02, w / 2 - 0.01)
        b.box(pane, (-d / 2 + 0.01, d / 2 - 0.01), (z, z + 0.004), "glass_clear", "panes", solid=False)
        edge = pane[1] if k == 0 else pane[0]
        b.box(
            (edge - 0.02, edge + 0.02),
            (-d / 2 + 0.01, d / 2 - 0.01),
            (z, z + 0.006),
            "metal_light",
            "panes",
            solid=False,
        )
    face = DrawnFace.front(b, d / 2 - 0.02)
    face.write("FROZEN", (-w * 0.22, w * 0.22), (h * 0.26, h * 0.5), "plastic_2f7fd0", "letters", 0.006)
    for u in (-w * 0.36, w * 0.36):
        for k in range(3):
            a = math.pi / 2 + k * math.pi / 3
            arm = (math.cos(a) * h * 0.13, math.sin(a) * h * 0.13)
            face.line(
                [(u - arm[0], h * 0.38 - arm[1]), (u + arm[0], h * 0.38 + arm[1])], 0.014, "plastic_2f7fd0", "flakes"
            )
            for side in (-1, 1):
                tip = (u + side * arm[0] * 0.7, h * 0.38 + side * arm[1] * 0.7)
                for turn in (a + 0.9, a - 0.9):
                    twig = (tip[0] + side * math.cos(turn) * h * 0.05, tip[1] + side * math.sin(turn) * h * 0.05)
                    face.line([tip, twig], 0.01, "plastic_2f7fd0", "flakes")


@recipe("flower_stand")
def flower_stand(b: Builder) -> None:
    """Steps of pots on a stand, each full of blossoms above leaves: red, yellow, pink, white and purple."""
    w, d, h = b.w, b.d, b.h
    for step, (y0, y1, z) in enumerate(((-d / 2, -d * 0.06, h * 0.5), (-d * 0.06, d / 2, h * 0.24))):
        b.box((-w / 2, w / 2), (y0, y1), (z - 0.03, z), b.mat(), "steps")
        for x in (-w * 0.46, w * 0.46):
            b.box((x - 0.025, x + 0.025), (y0 + 0.01, y1 - 0.01), (0, z - 0.03), b.mat(), "sides")
        for k in range(4):
            x, y = w * (-0.36 + 0.24 * k), (y0 + y1) / 2
            pot = h * 0.17
            b.lathe(
                [(0.055, z), (0.08, z + pot), (0.07, z + pot), (0.05, z + 0.02)],
                ("metal_light", "food_b5623a")[(k + step) % 2],
                (x, y),
                "pots",
                12,
            )
            color = ("red", "yellow", "pink", "white", "purple", "orange")[(k * 2 + step * 3) % 6]
            for j in range(6):
                a = j * math.tau / 5
                reach = 0.0 if j == 5 else 0.065
                top = z + pot + h * (0.19 if j == 5 else 0.12 + 0.03 * (j % 2))
                tip = (x + math.cos(a) * reach, y + math.sin(a) * reach, top)
                b.rod((x, y, z + pot * 0.8), tip, 0.007, "leaf_green", "stems", 4)
                b.ball(tip, (0.034, 0.034, 0.03), f"leaf_{color}", "blossoms", 8)
                b.ball(
                    (tip[0] * 0.5 + x * 0.5, tip[1] * 0.5 + y * 0.5 + 0.01, z + pot + 0.02),
                    (0.03, 0.03, 0.02),
                    "leaf_3f7f3a",
                    "leaves",
                    6,
                )
