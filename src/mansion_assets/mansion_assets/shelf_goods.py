"""Goods in the compartments of shelves and trolleys: books, groceries, bottles, plants, toys, medicine, letters."""

import math
from collections.abc import Callable
from typing import Final, TypeAlias

from mansion_assets.builder import Builder, Rect
from mansion_assets.drawn_faces import DrawnFace

__all__ = ["Goods", "goods"]

Goods: TypeAlias = Callable[[Builder, Rect, float, int], None]
"""Fills a compartment of a shelf of some depth; the last argument tells compartments apart."""


_BOOKS = ("paper_red", "paper_blue", "paper_green", "paper_brown", "paper_beige", "paper_dark", "paper_orange")

_GOODS = ("paper_red", "paper_yellow", "paper_blue", "paper_green", "paper_orange", "plastic_white", "paper_purple")

_PRODUCTS = (
    ("box", "paper_red"),
    ("can", "metal_steel"),
    ("box", "paper_beige"),
    ("bottle", "glass_green"),
    ("box", "paper_yellow"),
    ("box", "plastic_white"),
    ("can", "paper_green"),
    ("box", "paper_blue"),
    ("bottle", "glass_brown"),
    ("box", "paper_brown"),
    ("can", "paper_orange"),
)
"""Shapes and colours of what a supermarket sells."""

_FACINGS = 4
"""How many of one product stand side by side."""


def goods(b: Builder, fill: str, cell: Rect, depth: float, key: int) -> None:
    """Show goods in a compartment; they are part of the mesh, and the compartment is not a receptacle."""
    own = _OWN_GOODS.get(fill)
    if own is not None:
        own(b, cell, depth, key)
        return
    room = cell.top - cell.z
    step, palette = {
        "books": (0.045, _BOOKS),
        "folders": (0.08, ("paper_dark", "paper_blue", "paper_grey")),
        "boxes": (0.36, ("paper_brown", "paper_beige")),
        "bins": (0.2, ("plastic_blue", "plastic_red")),
        "linen": (0.36, ("fabric_white", "fabric_beige")),
    }.get(fill, (0.2, _GOODS))
    count = max(1, int((cell.x1 - cell.x0) / step))
    step = (cell.x1 - cell.x0) / count
    tall = {"books": 0.78, "folders": 0.85, "boxes": 0.72}.get(fill, 0.66)
    for k in range(count):
        mark = (k * 7 + key * 13 + k * k * 3) % 11
        height = room * tall * (0.8 + 0.02 * mark)
        x0 = cell.x0 + k * step
        color = palette[(mark + k) % len(palette)]
        back = cell.y0 + 0.01 + 0.002 * mark
        front = min(cell.y1 - 0.01, back + depth * 0.8)
        if fill == "books" and mark == 3:
            continue
        b.box((x0 + 0.002, x0 + step - 0.002), (back, front), (cell.z, cell.z + height), color, "goods", solid=False)


def _places(cell: Rect, step: float) -> list[float]:
    """Return the middles of columns about `step` wide."""
    count = max(1, int((cell.x1 - cell.x0) / step))
    return [cell.x0 + (k + 0.5) * (cell.x1 - cell.x0) / count for k in range(count)]


def _lying_bottles(b: Builder, cell: Rect, depth: float, key: int) -> None:
    """Bottles of wine that lie in a lattice of slanted boards, their necks to the front."""
    room = cell.top - cell.z
    columns = max(2, round((cell.x1 - cell.x0) / room))
    step = (cell.x1 - cell.x0) / columns
    back, front = cell.y0 + 0.01, cell.y1 - 0.02
    r = min(0.042, room * 0.16)
    for k in range(columns):
        x, z = cell.x0 + (k + 0.5) * step, cell.z + room / 2
        for side in (-1, 1):
            start, end = (x - step / 2, z - side * room / 2), (x + step / 2, z + side * room / 2)
            across = (-(end[1] - start[1]) * 0.02, (end[0] - start[0]) * 0.02)
            board = [
                (start[0] - across[0], start[1] - across[1]),
                (end[0] - across[0], end[1] - across[1]),
                (end[0] + across[0], end[1] + across[1]),
                (start[0] + across[0], start[1] + across[1]),
            ]
            b.prism(board, (back, front), b.mat(), "y", "lattice", solid=False)
        places = ((0.0, 0.3), (0.0, -0.3), (-0.3, 0.0), (0.3, 0.0))
        for number, (u, v) in enumerate(places):
            if (number + k + key) % 5 == 0:
                continue
            at = (x + u * step, z + v * room)
            color = ("plastic_1f3f2a", "plastic_4a1a22", "plastic_2a2f22")[(number + k + key) % 3]
            b.rod((at[0], back, at[1]), (at[0], front - depth * 0.3, at[1]), r, color, "bottles", 8)
            b.rod((at[0], front - depth * 0.3, at[1]), (at[0], front - 0.01, at[1]), r * 0.42, color, "bottles", 6)
            foil = ("paint_red", "metal_brass", "plastic_black")[(number + key) % 3]
            b.rod((at[0], front - 0.04, at[1]), (at[0], front, at[1]), r * 0.5, foil, "bottles", 6)


def _potted_plants(b: Builder, cell: Rect, depth: float, key: int) -> None:
    """Seedlings in clay pots: a stem and pairs of leaves."""
    room = cell.top - cell.z
    y = (cell.y0 + cell.y1) / 2
    for k, x in enumerate(_places(cell, 0.19)):
        pot, r = room * 0.28, min(0.055, room * 0.2)
        b.lathe([(r * 0.7, cell.z), (r, cell.z + pot)], "food_b5623a", (x, y), "pots", 10)
        b.cyl(x, y, (cell.z + pot, cell.z + pot + 0.004), r * 0.9, "leaf_soil", "pots", n=10, solid=False)
        top = cell.z + room * (0.7 + 0.06 * ((k + key) % 3))
        b.rod((x, y, cell.z + pot), (x, y, top), r * 0.1, "leaf_3f7f3a", "stems", 5)
        for j in range(6):
            a, z = j * 2.4 + k, cell.z + pot + (top - cell.z - pot) * (0.3 + 0.14 * j)
            tip = (x + math.cos(a) * r * 0.9, y + math.sin(a) * r * 0.9, z + r * 0.3)
            b.ball(tip, (r * 0.7, r * 0.7, r * 0.3), ("leaf_4f9f3f", "leaf_3f8f3a")[j % 2], "leaves", 6)
        if (k + key) % 3 == 0:
            b.ball(
                (x, y, top),
                (r * 0.5, r * 0.5, r * 0.4),
                ("leaf_red", "leaf_yellow", "leaf_pink")[(k + key) % 3],
                "blossoms",
                8,
            )


def _toys(b: Builder, cell: Rect, depth: float, key: int) -> None:
    """Bears, balls, towers of blocks and cars in turn."""
    room = cell.top - cell.z
    y, size = (cell.y0 + cell.y1) / 2 + 0.03, min((cell.top - cell.z) * 0.8, 0.2)
    for k, x in enumerate(_places(cell, max(0.16, size * 1.05))):
        (_bear, _ball, _blocks, _car)[(k + key) % 4](b, (x, y, cell.z), min(size, room * 0.85))


def _bear(b: Builder, at: tuple[float, float, float], size: float) -> None:
    x, y, z = at
    b.ball((x, y, z + size * 0.3), (size * 0.26, size * 0.22, size * 0.3), "fabric_8a5a34", "toys", 8)
    b.ball((x, y, z + size * 0.74), (size * 0.24, size * 0.22, size * 0.22), "fabric_8a5a34", "toys", 8)
    b.ball((x, y + size * 0.2, z + size * 0.7), (size * 0.1, size * 0.08, size * 0.08), "fabric_e3c3a3", "toys", 6)
    for side in (-1, 1):
        b.ball(
            (x + side * size * 0.18, y, z + size * 0.93),
            (size * 0.08, size * 0.06, size * 0.08),
            "fabric_8a5a34",
            "toys",
            6,
        )
        b.ball(
            (x + side * size * 0.18, y + size * 0.2, z + size * 0.1),
            (size * 0.1, size * 0.14, size * 0.1),
            "fabric_8a5a34",
            "toys",
            6,
        )


def _ball(b: Builder, at: tuple[float, float, float], size: float) -> None:
    x, y, z = at
    r = size * 0.42
    b.ball((x, y, z + r), (r, r, r), "plastic_red", "toys", 12)
    b.lathe([(r * 0.99, z + r * 0.8), (r * 1.02, z + r), (r * 0.99, z + r * 1.2)], "plastic_white", (x, y), "toys", 12)


def _blocks(b: Builder, at: tuple[float, float, float], size: float) -> None:
    x, y, z = at
    s = size * 0.34
    for u, level, color in ((-0.55, 0, "blue"), (0.55, 0, "yellow"), (0.0, 1, "green")):
        low = z + level * s
        b.box(
            (x + u * s - s * 0.48, x + u * s + s * 0.48),
            (y - s / 2, y + s / 2),
            (low, low + s),
            f"plastic_{color}",
            "toys",
            solid=False,
        )
    b.prism(
        [(x - s * 0.5, z + 2 * s), (x + s * 0.5, z + 2 * s), (x, z + 2.7 * s)],
        (y - s / 2, y + s / 2),
        "plastic_red",
        "y",
        "toys",
        solid=False,
    )


def _car(b: Builder, at: tuple[float, float, float], size: float) -> None:
    x, y, z = at
    s = size
    b.box(
        (x - s * 0.48, x + s * 0.48),
        (y - s * 0.2, y + s * 0.2),
        (z + s * 0.1, z + s * 0.32),
        "plastic_orange",
        "toys",
        solid=False,
    )
    b.box(
        (x - s * 0.24, x + s * 0.26),
        (y - s * 0.18, y + s * 0.18),
        (z + s * 0.32, z + s * 0.52),
        "plastic_4f9bd9",
        "toys",
        solid=False,
    )
    for u in (-0.28, 0.28):
        b.rod(
            (x + u * s, y + s * 0.18, z + s * 0.12),
            (x + u * s, y + s * 0.25, z + s * 0.12),
            s * 0.12,
            "rubber_black",
            "toys",
            10,
        )


def _hung_bags(b: Builder, cell: Rect, depth: float, key: int) -> None:
    """A child's satchel in each place between upright boards, with its pocket, straps and a name."""
    room, y = cell.top - cell.z, (cell.y0 + cell.y1) / 2
    places = _places(cell, 0.3)
    step = (cell.x1 - cell.x0) / len(places)
    for k, x in enumerate(places):
        if k:
            b.box(
                (x - step / 2 - 0.008, x - step / 2 + 0.008), (cell.y0, cell.y1), (cell.z, cell.top), b.mat(), "boards"
            )
        color = ("red", "4f9bd9", "yellow", "green", "purple")[(k * 2 + key) % 5]
        half, tall = step * 0.3, room * 0.78
        b.cushion(
            (x - half, x + half),
            (y - depth * 0.24, y + depth * 0.2),
            (cell.z, cell.z + tall),
            f"fabric_{color}",
            "goods",
            0.6,
        )
        front = y + depth * 0.2
        b.cushion(
            (x - half * 0.8, x + half * 0.8),
            (front - 0.02, front + 0.05),
            (cell.z + tall * 0.08, cell.z + tall * 0.5),
            "fabric_dark",
            "goods",
            0.6,
        )
        b.path(
            [
                (x - half * 0.3, y, cell.z + tall * 0.94),
                (x, y, cell.z + tall * 1.12),
                (x + half * 0.3, y, cell.z + tall * 0.94),
            ],
            0.012,
            "fabric_dark",
            "goods",
        )
        DrawnFace.front(b, cell.y1).field(
            (-x - 0.06, -x + 0.06), (cell.top + 0.002, cell.top + 0.02), f"paper_{color}", "names", 0.012
        )


def _medicine(b: Builder, cell: Rect, depth: float, key: int) -> None:
    """White cartons with coloured bands and crosses, and brown bottles with white caps, in turn."""
    room, front = cell.top - cell.z, cell.y1 - 0.03
    for k, x in enumerate(_places(cell, 0.105)):
        mark = (k * 5 + key * 3) % 7
        if mark in (2, 5):
            tall = min(room * 0.7, 0.15)
            b.cyl(x, front - 0.04, (cell.z, cell.z + tall), 0.035, "plastic_b5642a", "goods", n=8, solid=False)
            b.cyl(
                x, front - 0.04, (cell.z + tall, cell.z + tall * 1.2), 0.03, "plastic_white", "goods", n=8, solid=False
            )
            continue
        tall, color = room * (0.5 + 0.06 * (mark % 4)), ("paint_green", "paint_3d6ac8", "paint_red")[mark % 3]
        b.box(
            (x - 0.045, x + 0.045),
            (front - depth * 0.6, front),
            (cell.z, cell.z + tall),
            "paper_white",
            "goods",
            solid=False,
        )
        face = DrawnFace.front(b, front)
        face.field((-x - 0.045, -x + 0.045), (cell.z, cell.z + tall * 0.24), color, "bands", 0.002)
        face.field((-x - 0.008, -x + 0.008), (cell.z + tall * 0.4, cell.z + tall * 0.86), color, "crosses", 0.002)
        face.field((-x - 0.024, -x + 0.024), (cell.z + tall * 0.56, cell.z + tall * 0.7), color, "crosses", 0.002)


def _magazines(b: Builder, cell: Rect, depth: float, key: int) -> None:
    """Magazines that lean back with their covers to the front: a title across a picture or a colour."""
    room = cell.top - cell.z
    pictures = (
        "picture_dusk",
        "paper_4f9bd9",
        "picture_meadow",
        "paper_f2c12e",
        "picture_city",
        "paper_e8604f",
        "picture_botanical",
    )
    low, high = (cell.y1 - 0.03, cell.z + 0.005), (cell.y1 - 0.03 - min(depth * 0.6, room * 0.3), cell.z + room * 0.92)
    for k, x in enumerate(_places(cell, 0.2)):
        half = 0.085
        board = [(low[0] - 0.012, low[1]), low, high, (high[0] - 0.012, high[1])]
        b.prism(board, (x - half, x + half), "paper_white", part="goods", solid=False)
        face = DrawnFace.sloped(b, low, high)
        tall = math.dist(low, high)
        face.field((-x - half, -x + half), (0.0, tall), pictures[(k * 3 + key * 2) % len(pictures)], "covers", 0.002)
        ink = ("paper_white", "paper_red", "paper_yellow")[(k + key) % 3]
        face.field((-x - half * 0.85, -x + half * 0.85), (tall * 0.78, tall * 0.94), ink, "titles", 0.004)
    b.box(
        (cell.x0, cell.x1),
        (cell.y1 - 0.02, cell.y1 - 0.008),
        (cell.z, cell.z + room * 0.2),
        b.mat(),
        "rails",
        solid=False,
    )


def _pairs_of_shoes(b: Builder, cell: Rect, depth: float, key: int) -> None:
    """Trainers, leather shoes and pumps in pairs, their toes to the front."""
    room = cell.top - cell.z
    for k, x in enumerate(_places(cell, 0.2)):
        kind = (k * 2 + key) % 3
        upper = ("fabric_f4f4f0", "leather_6a3a1e", "leather_c8203a")[kind]
        sole = ("rubber_2f6fc0", "rubber_black", "rubber_black")[kind]
        for side in (-1, 1):
            at = (x + side * 0.042, cell.y1 - 0.012, cell.z)
            _shoe(b, at, (0.036, min(depth - 0.03, 0.25), min(room * 0.72, 0.1)), upper, sole)
            if kind == 0:
                face = DrawnFace.side(b, at[0] + 0.034)
                face.line([(at[1] - 0.16, at[2] + 0.03), (at[1] - 0.1, at[2] + 0.05)], 0.006, "paint_red", "goods")


def _shoe(b: Builder, at: tuple[float, float, float], size: tuple[float, float, float], upper: str, sole: str) -> None:
    """A shoe of half a width, a length and a height, with its toe at a place: sole, toe cap, instep, an opening."""
    x, toe, z = at
    half, long, tall = size
    heel = toe - long
    b.box((x - half, x + half), (heel, toe - half * 0.5), (z, z + tall * 0.16), sole, "goods", solid=False)
    b.cushion(
        (x - half, x + half), (toe - half * 2.6, toe), (z + tall * 0.06, z + tall * 0.56), upper, "goods", 1.0, 10
    )
    profile = [
        (heel, z + tall * 0.16),
        (toe - half * 1.2, z + tall * 0.16),
        (toe - half * 1.6, z + tall * 0.54),
        (heel + long * 0.5, z + tall),
        (heel + long * 0.02, z + tall * 0.94),
    ]
    b.prism(profile, (x - half * 0.9, x + half * 0.9), upper, part="goods", solid=False)
    slope = [
        (heel + long * 0.08, z + tall * 0.94),
        (heel + long * 0.46, z + tall),
        (heel + long * 0.46, z + tall * 1.02),
    ]
    b.prism(
        [*slope, (heel + long * 0.08, z + tall * 0.97)],
        (x - half * 0.62, x + half * 0.62),
        "plastic_1c1c1f",
        part="goods",
        solid=False,
    )
    for k in range(3):
        y = toe - half * (1.9 + 0.7 * k)
        level = z + tall * (0.6 + 0.13 * k)
        b.rod((x - half * 0.5, y, level), (x + half * 0.5, y, level), tall * 0.03, "fabric_white", "goods", 5)


def _trays(b: Builder, cell: Rect, depth: float, key: int) -> None:
    """A used tray: a plate with left-overs, a cup, a fork, and a crumpled napkin."""
    x0, x1 = cell.x0 + 0.01, cell.x1 - 0.01
    y0, y1, z = cell.y0 + 0.02, cell.y1 + 0.02, cell.z
    b.box(
        (x0, x1),
        (y0, y1),
        (z, z + 0.012),
        ("plastic_c8693a", "plastic_4f7f9f", "plastic_7a9f4f")[key % 3],
        "trays",
        solid=False,
    )
    middle = (x0 + x1) / 2
    y = (y0 + y1) / 2 + 0.06
    b.lathe(
        [(0.07, z + 0.012), (0.11, z + 0.03), (0.1, z + 0.03), (0.06, z + 0.018)],
        "ceramic_white",
        (middle - 0.08, y),
        "plates",
        18,
    )
    b.ball((middle - 0.1, y, z + 0.03), (0.05, 0.04, 0.016), "food_c8791f", "plates", 8)
    b.ball((middle - 0.05, y + 0.02, z + 0.028), (0.03, 0.03, 0.014), "food_4f9f3f", "plates", 8)
    b.lathe(
        [(0.028, z + 0.012), (0.038, z + 0.1), (0.032, z + 0.1), (0.026, z + 0.02)],
        "plastic_f2f2ee",
        (middle + 0.14, y),
        "cups",
        14,
    )
    b.rod(
        (middle + 0.05, y - 0.08, z + 0.016), (middle + 0.07, y + 0.1, z + 0.016), 0.006, "metal_chrome", "cutlery", 6
    )
    b.ball((middle + 0.16, y - 0.14, z + 0.03), (0.05, 0.04, 0.02), "paper_white", "napkins", 6)


def _groceries(b: Builder, cell: Rect, depth: float, key: int) -> None:
    """Show several of each product side by side, behind a rail with the prices."""
    room = cell.top - cell.z
    count = max(1, int((cell.x1 - cell.x0) / 0.105))
    step = (cell.x1 - cell.x0) / count
    # On a shelf with two sides, the back one faces the other way.
    front = cell.y1 if abs(cell.y1) > abs(cell.y0) else cell.y0
    inwards = -1 if front > 0 else 1
    for k in range(count):
        run = k // _FACINGS
        shape, color = _PRODUCTS[(run * 5 + key * 3 + (front > 0)) % len(_PRODUCTS)]
        height = room * (0.5 + 0.07 * ((run * 3 + key) % 5))
        x = cell.x0 + (k + 0.5) * step
        if shape == "box":
            y = sorted((front + inwards * 0.03, front + inwards * min(depth - 0.02, 0.3)))
            half = step * (0.46 if run % 2 else 0.4)
            b.box((x - half, x + half), (y[0], y[1]), (cell.z, cell.z + height), color, "goods", solid=False)
            continue
        for row in (0.08, 0.19) if depth > 0.3 else (0.08,):
            tall = min(height, 0.13) if shape == "can" else height
            b.cyl(x, front + inwards * row, (cell.z, cell.z + tall), step * 0.42, color, "goods", n=6, solid=False)
    rail = sorted((front, front + inwards * 0.012))
    z = (cell.z - 0.03, cell.z + 0.012)
    b.box((cell.x0, cell.x1), (rail[0], rail[1]), z, "plastic_white", "rails", solid=False)


def _letters(b: Builder, cell: Rect, depth: float, key: int) -> None:
    """Two rows of pigeonholes with envelopes, stamped or with their flap to the front, and a name below each."""
    places, room = _places(cell, 0.22), (cell.top - cell.z) / 2
    half = (cell.x1 - cell.x0) / len(places) / 2
    b.box((cell.x0, cell.x1), (cell.y0, cell.y0 + 0.004), (cell.z, cell.top), "wood_5a4632", "backs", solid=False)
    for x in [cell.x0 + 2 * half * k for k in range(1, len(places))]:
        b.box((x - 0.006, x + 0.006), (cell.y0, cell.y1), (cell.z, cell.top), b.mat(), "partitions")
    b.box((cell.x0, cell.x1), (cell.y0, cell.y1), (cell.z + room - 0.012, cell.z + room), b.mat(), "boards")
    front = DrawnFace.front(b, cell.y1)
    for row in range(2):
        low = cell.z + row * room
        for k, x in enumerate(places):
            front.field((-x - half * 0.6, -x + half * 0.6), (low - 0.018, low + 0.01), "paper_white", "names", 0.008)
            front.field((-x - half * 0.4, -x + half * 0.4), (low - 0.008, low), "plastic_black", "names", 0.0095)
            mark = (k * 5 + row * 3 + key * 2) % 7
            if mark != 2:
                at = (x, cell.y1 - 0.05 - 0.01 * (mark % 3), low)
                _envelope(b, at, (half * 0.74, room * (0.66 + 0.03 * (mark % 3))), mark)


def _envelope(b: Builder, at: tuple[float, float, float], size: tuple[float, float], mark: int) -> None:
    """An envelope of half a width and a height on its long edge, before others that lie flat."""
    x, y, z = at
    half, tall = size
    paper = ("paper_white", "paper_d9b98a", "paper_white", "paper_cfe0f2")[mark % 4]
    for k in range(mark % 3):
        b.box(
            (x - half, x + half), (y - 0.2, y + 0.04), (z + k * 0.008, z + k * 0.008 + 0.006), "paper_f4f1e8", "letters"
        )
    low = z + 0.008 * (mark % 3)
    b.box((x - half, x + half), (y - 0.006, y), (low, low + tall), paper, "letters", solid=False)
    face = DrawnFace.front(b, y)
    if mark % 2:
        flap = [(-x - half, low + tall), (-x, low + tall * 0.4), (-x + half, low + tall)]
        face.line(flap, 0.004, "plastic_5a6470", "flaps", 0.001)
        face.disc(-x, low + tall * 0.42, tall * 0.12, "paint_red", "seals", 0.004, 10)
        return
    face.field((-x + half * 0.5, -x + half * 0.9), (low + tall * 0.5, low + tall * 0.92), "paint_red", "stamps", 0.002)
    for v in (0.2, 0.4):
        face.field(
            (-x - half * 0.5, -x + half * 0.3),
            (low + tall * v, low + tall * (v + 0.09)),
            "plastic_3a4f8a",
            "addresses",
            0.002,
        )


_OWN_GOODS: Final[dict[str, Goods]] = {
    "bags": _hung_bags,
    "bottles": _lying_bottles,
    "groceries": _groceries,
    "letters": _letters,
    "magazines": _magazines,
    "medicine": _medicine,
    "plants": _potted_plants,
    "shoes": _pairs_of_shoes,
    "toys": _toys,
    "trays": _trays,
}
"""Goods with a shape of their own; the others are boxes."""
