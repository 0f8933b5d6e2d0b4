"""What shops show food in that they weigh or chill: a case of milk, yoghurt and cheese, a stand of fruit."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []

_HEADER = 0.34
"""Height of the lit board above the shelves of a case, metres."""


@recipe("dairy_case")
def dairy_case(b: Builder) -> None:
    """An open case below a lit board that says DAIRY: bottles of milk, cartons, yoghurt and cheese behind prices."""
    w, d, h = b.w, b.d, b.h
    main, base = b.mat(), 0.3
    b.hollow((-w / 2, w / 2), (-d / 2, d / 2 - 0.04), (0, h), 0.05, main)
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, -d / 2 + 0.06), (base, h - 0.05), "light_cfe9ff", "light")
    b.box((-w / 2, w / 2), (d / 2 - 0.2, d / 2 - 0.008), (0.0, base), main, "front")
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, d / 2 - 0.2), (base - 0.02, base), "metal_steel", "boards")
    b.box((-w / 2, w / 2), (d / 2 - 0.12, d / 2 - 0.008), (h - _HEADER, h), "light_1f6fd0", "board")
    face = DrawnFace.front(b, d / 2 - 0.008)
    high = (h - _HEADER + 0.06, h - 0.06)
    face.write("DAIRY", (-w * 0.44, w * 0.44), high, "light_ffffff", "letters", 0.008)
    face.field((-w / 2, w / 2), (base * 0.2, base * 0.8), "plastic_1f6fd0", "stripe", 0.004)
    face.write(
        "MILK YOGHURT CHEESE", (-w * 0.46, w * 0.46), (base * 0.3, base * 0.7), "plastic_white", "letters", 0.007
    )
    step = (h - _HEADER - base) / 3
    for level, show in enumerate((_bottles_of_milk, _cartons_of_milk, _yoghurt_and_cheese)):
        z, front = base + level * step, d / 2 - (0.14, 0.2, 0.26)[level]
        b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, front), (z - 0.02, z), "metal_steel", "boards")
        show(b, z, front - 0.09, step)
        _prices(DrawnFace.front(b, front), w, z)


def _prices(face: DrawnFace, w: float, z: float) -> None:
    """A rail with yellow tags along the edge of a board."""
    face.field((-w / 2 + 0.05, w / 2 - 0.05), (z - 0.035, z + 0.015), "plastic_white", "rails", 0.006)
    for k in range(5):
        u = w * (-0.38 + 0.19 * k)
        face.field((u - 0.06, u + 0.06), (z - 0.035, z + 0.02), "paint_f5c518", "prices", 0.01)


def _row(b: Builder, step: float) -> list[float]:
    """Return the middles of at most eleven things, `step` apart or more, between the sides."""
    count = min(11, int((b.w - 0.12) / step))
    return [-b.w / 2 + 0.06 + (k + 0.5) * (b.w - 0.12) / count for k in range(count)]


def _bottles_of_milk(b: Builder, z: float, y: float, room: float) -> None:
    tall, r = room * 0.82, 0.07
    for k, x in enumerate(_row(b, 0.17)):
        neck = [(r, z), (r, z + tall * 0.55), (r * 0.45, z + tall * 0.8), (r * 0.45, z + tall * 0.9)]
        b.lathe(neck, "plastic_white", (x, y), "milk", 8, solid=False)
        cap = ("plastic_2f6fe0", "plastic_2f6fe0", "plastic_d8382e", "plastic_38b04a")[k % 4]
        b.cyl(x, y, (z + tall * 0.9, z + tall), r * 0.5, cap, "caps", n=8, solid=False)
        label = DrawnFace.front(b, y + r)
        label.field((-x - r * 0.8, -x + r * 0.8), (z + tall * 0.12, z + tall * 0.44), cap, "labels", 0.006)


def _cartons_of_milk(b: Builder, z: float, y: float, room: float) -> None:
    """Cartons with a gable, half of them blue, and a field of it on the front of each."""
    tall, half = room * 0.5, 0.085
    for k, x in enumerate(_row(b, 0.2)):
        b.box((x - half, x + half), (y - half, y + half), (z, z + tall), "paper_white", "milk", solid=False)
        gable = [(y - half, z + tall), (y + half, z + tall), (y, z + tall * 1.35)]
        ink = ("plastic_2f6fe0", "plastic_38a04a")[k % 2]
        b.prism(gable, (x - half, x + half), ink, part="gables", solid=False)
        b.box((x - half, x + half), (y - 0.006, y + 0.006), (z + tall * 1.3, z + tall * 1.5), ink, "gables")
        face = DrawnFace.front(b, y + half)
        face.field((-x - half, -x + half), (z, z + tall * 0.3), ink, "labels", 0.003)
        face.field((-x - half * 0.5, -x + half * 0.5), (z + tall * 0.45, z + tall * 0.85), ink, "labels", 0.003)


def _yoghurt_and_cheese(b: Builder, z: float, y: float, room: float) -> None:
    """Pots of yoghurt with shining lids on one half, wedges of cheese with holes on the other."""
    places = _row(b, 0.15)
    for k, x in enumerate(places):
        if k < len(places) * 0.5:
            tall, half = room * 0.5, 0.07
            wedge = [(x - half, y - 0.08), (x + half, y + 0.08), (x - half, y + 0.08)]
            b.prism(wedge, (z, z + tall), "food_f5c229", "z", "cheese", solid=False)
            face = DrawnFace.front(b, y + 0.08)
            for u, v, r in ((0.03, 0.3, 0.016), (-0.02, 0.6, 0.014), (0.04, 0.75, 0.01)):
                face.disc(-x + u, z + tall * v, r, "food_a86f10", "holes", 0.002, 8)
            continue
        color = ("plastic_e85f9a", "plastic_7a4fc0", "plastic_f58a2a")[k % 3]
        tall, r = room * 0.3, 0.05
        for low in (z, z + tall * 1.12):
            b.lathe([(r * 0.8, low), (r, low + tall)], color, (x, y), "yoghurt", 8, solid=False)
            b.cyl(x, y, (low + tall, low + tall * 1.1), r * 1.12, "metal_chrome", "lids", n=8, solid=False)


@recipe("fruit_stand")
def fruit_stand(b: Builder) -> None:
    """A stall with FRUIT on its green front: apples, bananas, oranges, lettuces in boxes, each with a price."""
    w, d, h = b.w, b.d, b.h
    tray = b.cells[0]
    low, t, main = tray.z, 0.04, b.mat()
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.02, d / 2 - 0.02), (0.06, low), main, "base")
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, d / 2 - 0.05), (0, 0.06), "plastic_dark", "plinth")
    rim = low + (h - low) * 0.4
    for side in (-1, 1):
        across, deep = (sorted((side * long / 2, side * (long / 2 - t))) for long in (w, d))
        b.box((across[0], across[1]), (-d / 2, d / 2), (low - 0.1, rim), main, "rim")
        b.box((-w / 2, w / 2), (deep[0], deep[1]), (low - 0.1, rim), main, "rim")
    b.box((-w / 2, w / 2), (-t / 2, t / 2), (low, rim), main, "rim", solid=False)
    b.box((-t / 2, t / 2), (-d / 2, d / 2), (low, rim), main, "rim", solid=False)
    face = DrawnFace.front(b, d / 2 - 0.02)
    face.field((-w * 0.46, w * 0.46), (h * 0.1, low - 0.11), "paint_2f9e4f", "sign", 0.008)
    face.write("FRUIT", (-w * 0.4, w * 0.4), (h * 0.16, low - 0.15), "paint_ffffff", "letters", 0.014)
    half = (w / 4, d / 4)
    for k, heap in enumerate((_apples, _bananas, _oranges, _lettuces)):
        x, y = half[0] * (1 if k % 2 == 0 else -1), half[1] * (1 if k < 2 else -1)
        heap(b, (x, y, low), (half[0] - t, half[1] - t), (h - low) * 0.62)
        _price(b, (x, y + half[1] - t, low), h, ("1", "2", "3", "4")[k])


def _price(b: Builder, at: tuple[float, float, float], high: float, figure: str) -> None:
    """A yellow card on a stick behind the front of a box."""
    x, y, z = at
    b.rod((x, y, z), (x, y, high - 0.1), 0.008, "metal_steel", "signs", 6)
    b.box((x - 0.09, x + 0.09), (y - 0.006, y + 0.002), (high - 0.13, high), "paint_f5d020", "signs", solid=False)
    face = DrawnFace.front(b, y + 0.002)
    face.write(figure, (-x - 0.06, -x + 0.06), (high - 0.12, high - 0.01), "paint_c8201e", "prices", 0.004)


def _heap(b: Builder, at: tuple[float, float, float], half: tuple[float, float], r: float) -> list[tuple[float, ...]]:
    """Return the places of round fruit of radius `r` in a box."""
    x, y, z = at
    columns, rows = max(2, int(half[0] / r)), max(2, int(half[1] / r))
    return [
        (x - half[0] + (i + 0.5) * 2 * half[0] / columns, y - half[1] + (j + 0.5) * 2 * half[1] / rows, z)
        for i in range(columns)
        for j in range(rows)
    ]


def _apples(b: Builder, at: tuple[float, float, float], half: tuple[float, float], room: float) -> None:
    for k, (x, y, z) in enumerate(_heap(b, at, half, 0.075)):
        color = ("food_d8281e", "food_d8281e", "food_b81a1a")[k % 3]
        b.ball((x, y, z + room * 0.62), (0.075, 0.075, room * 0.38), color, "apples", 9, solid=False)
        b.rod((x, y, z + room * 0.94), (x + 0.01, y, z + room * 1.1), 0.008, "wood_walnut", "stalks", 5)
        b.ball((x - 0.025, y + 0.01, z + room * 1.04), (0.03, 0.016, 0.008), "leaf_58b83a", "leaves", 5, solid=False)


def _oranges(b: Builder, at: tuple[float, float, float], half: tuple[float, float], room: float) -> None:
    for x, y, z in _heap(b, at, half, 0.08):
        b.ball((x, y, z + room * 0.62), (0.08, 0.08, room * 0.4), "food_f58a1e", "oranges", 9, solid=False)


def _lettuces(b: Builder, at: tuple[float, float, float], half: tuple[float, float], room: float) -> None:
    for x, y, z in _heap(b, at, half, 0.11):
        b.ball((x, y, z + room * 0.5), (0.11, 0.11, room * 0.42), "leaf_4fa83a", "lettuces", 9, solid=False)
        b.ball((x, y, z + room * 0.74), (0.07, 0.07, room * 0.34), "leaf_a8e06a", "lettuces", 8, solid=False)


def _bananas(b: Builder, at: tuple[float, float, float], half: tuple[float, float], room: float) -> None:
    """Hands of bananas, bent upwards, with dark tips."""
    x, y, z = at
    count = max(4, int(half[0] / 0.035))
    for k in range(count):
        u = x - half[0] + (k + 0.5) * 2 * half[0] / count
        line = [(-0.9, 0.5), (-0.5, 0.95), (0.1, 1.1), (0.6, 0.9), (0.9, 0.5)]
        points = [(u, y + half[1] * v, z + room * up * 0.95) for v, up in line]
        b.path(points, 0.034, "food_f7d21e", "bananas")
        b.rod(points[-1], (u, points[-1][1] + 0.012, points[-1][2] - 0.02), 0.016, "wood_5a3a1a", "tips", 6)
        b.rod(points[0], (u, points[0][1] - 0.012, points[0][2] - 0.02), 0.02, "wood_5a3a1a", "tips", 6)
