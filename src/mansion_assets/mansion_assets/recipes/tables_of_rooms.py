"""Tables of particular rooms, told by what is drawn on their tops: for meals, lessons and the garden."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.recipes.tables import PRINT, four_legs, sled_frames, tee_frames
from mansion_assets.registry import recipe

__all__: list[str] = []

Place = tuple[float, float]


def _flush_top(b: Builder, thick: float) -> DrawnFace:
    """Add a top, round or square, that ends 2 mm below the table's height, and return its face."""
    z = b.h - PRINT
    if b.p.get("shape") == "round":
        b.lathe([(0.485, b.h - thick), (0.5, z - 0.01), (0.5, z)], b.mat(), stretch=(b.w, b.d), part="top", n=32)
    else:
        b.box((-b.w / 2, b.w / 2), (-b.d / 2, b.d / 2), (b.h - thick, z), b.mat(), "top")
    return DrawnFace.top(b, z)


@recipe("dining_table")
def dining_table(b: Builder) -> None:
    """A table laid for a meal: a mat, a plate, a fork and a knife at each side, a bowl of flowers in the middle."""
    thick = min(0.04, b.h * 0.1)
    face = _flush_top(b, thick)
    four_legs(b, b.h - thick, b.mat("frame", b.mat()))
    r = min(b.w, b.d) * 0.13
    along_x = b.w > b.d * 1.3
    seats = [(u, v) for u in (-b.w * 0.25, b.w * 0.25) for v in (-b.d * 0.29, b.d * 0.29)]
    if not along_x:
        seats = [(0.0, -b.d * 0.32), (0.0, b.d * 0.32), (-b.w * 0.32, 0.0), (b.w * 0.32, 0.0)]
    for u, v in seats:
        turned = not along_x and abs(u) > abs(v)
        _place_setting(face, (u, v), r, turned=turned)
    face.disc(0.0, 0.0, r * 0.5, "leaf_58a83a", "flowers", PRINT * 0.6, 14)
    for k in range(5):
        a = k * math.tau / 5
        face.disc(math.cos(a) * r * 0.34, math.sin(a) * r * 0.34, r * 0.2, "fabric_e8386a", "flowers", PRINT, 10)


def _place_setting(face: DrawnFace, at: Place, r: float, *, turned: bool) -> None:
    """A mat with a plate on it, a fork on its left and a knife on its right."""

    def field(u: Place, v: Place, color: str, part: str, share: float) -> None:
        across, up = (v, u) if turned else (u, v)
        face.field((at[0] + across[0], at[0] + across[1]), (at[1] + up[0], at[1] + up[1]), color, part, PRINT * share)

    field((-r * 1.35, r * 1.35), (-r * 0.98, r * 0.98), "fabric_2f5f9e", "mats", 0.3)
    for size, color, share in (
        (0.85, "ceramic_ffffff", 0.5),
        (0.62, "ceramic_c8d4dc", 0.7),
        (0.55, "ceramic_ffffff", 0.9),
    ):
        face.disc(at[0], at[1], r * size, color, "plates", PRINT * share, 24)
    field((-r * 1.18, -r * 1.08), (-r * 0.8, r * 0.4), "metal_e8ecf0", "forks", 0.7)
    for k in range(3):
        field((-r * (1.28 - 0.11 * k), -r * (1.23 - 0.11 * k)), (r * 0.3, r * 0.8), "metal_e8ecf0", "forks", 0.8)
    field((r * 1.04, r * 1.2), (-r * 0.05, r * 0.8), "metal_e8ecf0", "knives", 0.7)
    field((r * 1.07, r * 1.17), (-r * 0.8, 0.0), "plastic_26272b", "knives", 0.7)


@recipe("cafeteria_table")
def cafeteria_table(b: Builder) -> None:
    """A long table of a canteen with trays on both sides, each with a plate of food, a cup, fruit, fork and knife."""
    face = _flush_top(b, 0.04)
    tee_frames(b, b.h - 0.04, b.mat("frame"))
    face.field((-b.w / 2, b.w / 2), (-b.d / 2, -b.d / 2 + 0.02), "plastic_d8381e", "edges", PRINT * 0.5)
    face.field((-b.w / 2, b.w / 2), (b.d / 2 - 0.02, b.d / 2), "plastic_d8381e", "edges", PRINT * 0.5)
    seats = max(2, round(b.w / 0.6))
    for k in range(seats):
        for side in (-1, 1):
            u, v = -b.w / 2 + (k + 0.5) * b.w / seats, side * b.d * 0.25
            color = ("plastic_d8381e", "plastic_2f7fd0", "plastic_38a04a", "plastic_f5a81e")[(k * 2 + (side > 0)) % 4]
            _tray(face, (u, v), (b.w / seats * 0.43, b.d * 0.2), color)


def _tray(face: DrawnFace, at: Place, half: Place, color: str) -> None:
    u, v = at
    face.field((u - half[0], u + half[0]), (v - half[1], v + half[1]), color, "trays", PRINT * 0.3)
    r = half[1] * 0.74
    left = u - half[0] * 0.22
    face.disc(left, v, r, "ceramic_ffffff", "plates", PRINT * 0.6, 20)
    face.disc(left - r * 0.28, v + r * 0.1, r * 0.4, "food_8a4a1e", "food", PRINT * 0.9, 12)
    face.disc(left + r * 0.36, v + r * 0.3, r * 0.3, "food_4fb03a", "food", PRINT * 0.9, 12)
    face.disc(left + r * 0.2, v - r * 0.4, r * 0.32, "food_f5c83a", "food", PRINT * 0.9, 12)
    face.disc(u + half[0] * 0.68, v + half[1] * 0.45, half[1] * 0.32, "ceramic_ffffff", "cups", PRINT * 0.6, 14)
    face.disc(u + half[0] * 0.68, v + half[1] * 0.45, half[1] * 0.24, "food_f58a1e", "cups", PRINT * 0.9, 14)
    face.disc(u + half[0] * 0.7, v - half[1] * 0.45, half[1] * 0.26, "food_d8281e", "fruit", PRINT * 0.9, 12)
    face.field((u - half[0] * 0.92, u - half[0] * 0.84), (v - r, v + r), "metal_f4f6f8", "forks", PRINT * 0.8)
    face.field((u + half[0] * 0.36, u + half[0] * 0.44), (v - r, v + r), "metal_f4f6f8", "knives", PRINT * 0.8)


@recipe("training_table")
def training_table(b: Builder) -> None:
    """A table on castors, hinged in its middle, with a pierced panel below and the folders of a course on it."""
    w, d, h = b.w, b.d, b.h
    face = _flush_top(b, 0.03)
    tee_frames(b, h - 0.03, b.mat("frame"), 0.06)
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (w / 2 - 0.08), sy * (d / 2 - 0.06)
            b.rod((x - 0.02, y, 0.035), (x + 0.02, y, 0.035), 0.035, "rubber_black", "castors", 14)
    panel = (h * 0.45, h - 0.05)
    b.box((-w / 2 + 0.12, w / 2 - 0.12), (-0.012, 0.0), panel, "metal_2f7fd0", "modesty")
    holes = DrawnFace.front(b, 0.0)
    for row in range(3):
        for k in range(12):
            along, up = -w * 0.38 + k * w * 0.76 / 11, panel[0] + (panel[1] - panel[0]) * (0.25 + 0.25 * row)
            holes.disc(along, up, 0.018, "plastic_1c2a3a", "holes", 0.002, 8)
    face.field((-0.006, 0.006), (-d / 2, d / 2), "plastic_26272b", "joint", PRINT * 0.5)
    for v in (-d * 0.3, d * 0.3):
        face.field((-0.07, 0.07), (v - 0.03, v + 0.03), "metal_8a9096", "hinges", PRINT)
    for u in (-w * 0.25, w * 0.25):
        face.field((u - w * 0.15, u + w * 0.15), (-d * 0.34, d * 0.3), "plastic_2f7fd0", "folders", PRINT * 0.4)
        face.field((u - w * 0.14, u + w * 0.14), (-d * 0.31, d * 0.27), "paper_ffffff", "folders", PRINT * 0.6)
        face.write("TRAINING", (u - w * 0.13, u + w * 0.13), (d * 0.05, d * 0.24), "plastic_d8281e", "letters", PRINT)
        for k in range(4):
            v = -d * (0.02 + 0.07 * k)
            face.field((u - w * 0.12, u + w * 0.12), (v - 0.008, v + 0.008), "plastic_5a6470", "lines", PRINT)


@recipe("patio_table")
def patio_table(b: Builder) -> None:
    """A table of slats with a ringed hole for a parasol in its middle and its foot below, on splayed legs."""
    w, d, h = b.w, b.d, b.h
    thick, count, hole = 0.035, max(7, round(w / 0.1)), 0.055
    dark = b.mat() == "metal_black"
    for k in range(count):
        x = (-w / 2 + w * (k + 0.06) / count, -w / 2 + w * (k + 0.94) / count)
        middle = abs(x[0] + x[1]) / 2 < w / count * 0.6
        for span in ((-d / 2, -hole), (hole, d / 2)) if middle else ((-d / 2, d / 2),):
            b.box(x, span, (h - thick, h), "wood_b8763a" if dark else b.mat(), "slats")
    for y in (-d * 0.36, d * 0.36):
        b.box(
            (-w / 2 + 0.02, w / 2 - 0.02), (y - 0.03, y + 0.03), (h - thick - 0.03, h - thick), "metal_26302a", "rails"
        )
    b.lathe(
        [(hole * 2.0, h - thick), (hole * 2.0, h - 0.001), (hole, h - 0.001), (hole, h - thick)],
        "metal_e8ecf0",
        part="ring",
        n=24,
    )
    b.cyl(0, 0, (0.1, h - 0.03), hole * 0.9, "metal_26302a", "parasol_tube", n=14)
    b.lathe([(0.24, 0.0), (0.24, 0.05), (0.08, 0.1)], "stone_grey", part="parasol_foot", n=24)
    for sx in (-1, 1):
        for sy in (-1, 1):
            foot, head = (sx * (w / 2 - 0.03), sy * (d / 2 - 0.03), 0.0), (sx * w * 0.36, sy * d * 0.36, h - thick)
            b.rod(foot, head, 0.024, "metal_26302a", "legs", 8, solid=True)


@recipe("student_desk")
def student_desk(b: Builder) -> None:
    """A shelf full of books below a top that has a groove with a pencil and an exercise book that says ABC."""
    w, d, h = b.w, b.d, b.h
    face = _flush_top(b, 0.03)
    sled_frames(b, h - 0.03, b.mat("frame"))
    places = max(1, round(w / 0.65))
    low = h - 0.2
    half = w / 2 - 0.12
    b.box((-half, half), (-d / 2 + 0.06, d / 2 - 0.06), (low, low + 0.015), b.mat(), "shelf")
    b.box((-half, half), (-d / 2 + 0.06, -d / 2 + 0.075), (low, h - 0.03), b.mat(), "shelf")
    for side in (-1, 1):
        wall = sorted((side * half, side * (half - 0.012)))
        b.box((wall[0], wall[1]), (-d / 2 + 0.06, d / 2 - 0.06), (low, h - 0.03), b.mat(), "shelf")
    count = int(half * 2 / 0.13)
    for k in range(count):
        x = -half + 0.02 + k * (2 * half - 0.04) / count
        color = ("paper_d8381e", "paper_2f7fd0", "paper_f5c518", "paper_38a04a", "paper_7a4fc0")[k % 5]
        for level in range(3):
            z = low + 0.016 + level * 0.036
            ink = color if level != 1 else "paper_white"
            b.box((x, x + 0.11), (-d * 0.2, d / 2 - 0.07), (z, z + 0.032), ink, "books", solid=False)
    for k in range(places):
        _exercise_book(face, -w / 2 + (k + 0.5) * w / places, w / places, d)


def _exercise_book(face: DrawnFace, u: float, wide: float, d: float) -> None:
    """A blue exercise book with a white label, a pencil in a groove above it, and a ruler at its side."""
    face.field((u - wide * 0.42, u + wide * 0.42), (d * 0.33, d * 0.42), "wood_5a4632", "groove", PRINT * 0.3)
    face.field((u - wide * 0.3, u + wide * 0.2), (d * 0.35, d * 0.4), "paint_f5c518", "pencil", PRINT * 0.7)
    face.field((u + wide * 0.2, u + wide * 0.27), (d * 0.36, d * 0.39), "wood_e8c89a", "pencil", PRINT * 0.7)
    face.field((u - wide * 0.35, u - wide * 0.3), (d * 0.35, d * 0.4), "plastic_e85f9a", "pencil", PRINT * 0.7)
    face.field((u - wide * 0.3, u + wide * 0.26), (-d * 0.42, d * 0.26), "paper_2f6fd0", "exercise_book", PRINT * 0.4)
    face.field((u - wide * 0.24, u + wide * 0.2), (-d * 0.2, d * 0.2), "paper_ffffff", "label", PRINT * 0.7)
    face.write("ABC", (u - wide * 0.22, u + wide * 0.18), (-d * 0.14, d * 0.16), "plastic_d8281e", "letters", PRINT)
    face.field((u + wide * 0.32, u + wide * 0.39), (-d * 0.4, d * 0.26), "wood_f0d890", "ruler", PRINT * 0.5)
    for k in range(8):
        v = d * (-0.36 + 0.08 * k)
        face.field((u + wide * 0.32, u + wide * 0.355), (v, v + d * 0.014), "plastic_26272b", "ruler", PRINT)
