"""Tables told by the objects on and below them: for meetings, evidence, children, coffee and office work."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.recipes.tables import PRINT, end_panels, four_legs, sled_frames, table_top
from mansion_assets.registry import recipe
from mansion_assets.solids import Vec3

__all__: list[str] = []


def _flush_top(b: Builder, z: float, thick: float, material: str) -> DrawnFace:
    """Add a top that ends 2 mm below `z`, and return its face: what is drawn on it, 2 mm thick, ends at `z`."""
    b.box((-b.w / 2, b.w / 2), (-b.d / 2, b.d / 2), (z - thick, z - PRINT), material, "top")
    return DrawnFace.top(b, z - PRINT)


@recipe("conference_table")
def conference_table(b: Builder) -> None:
    """A long top with a writing pad, paper and a name at each seat, sockets in the middle, on two broad pedestals."""
    w, d, h = b.w, b.d, b.h
    face = _flush_top(b, h, 0.045, b.mat())
    for side in (-1, 1):
        x = side * w * 0.3
        b.box((x - w * 0.07, x + w * 0.07), (-d * 0.2, d * 0.2), (0.04, h - 0.045), b.mat(), "legs")
        b.box((x - w * 0.09, x + w * 0.09), (-d * 0.32, d * 0.32), (0, 0.04), "metal_dark", "feet")
    b.box((-w * 0.24, w * 0.24), (-0.02, 0.02), (h * 0.3, h - 0.045), b.mat(), "modesty")
    seats = max(2, round(w / 0.72))
    for k in range(seats):
        u = -w / 2 + (k + 0.5) * w / seats
        for side in (-1, 1):
            _place_to_sit(face, u, side * (d / 2 - 0.06), -side, w / seats * 0.36)
    face.field((-w * 0.36, w * 0.36), (-d * 0.06, d * 0.06), "plastic_black", "cable_well", PRINT * 0.6)
    for k in range(seats):
        u = -w * 0.3 + k * w * 0.6 / max(1, seats - 1)
        face.field((u - 0.07, u + 0.07), (-0.03, 0.03), "metal_9ba0a5", "sockets", PRINT * 0.8)
        for hole in (-0.035, 0.035):
            face.disc(u + hole, 0.0, 0.016, "plastic_black", "sockets", PRINT, 10)


def _place_to_sit(face: DrawnFace, u: float, v: float, inwards: int, half: float) -> None:
    """A leather pad with a sheet of paper and a pencil, and a name card before it."""
    near, far = v, v + inwards * 0.3
    face.field((u - half, u + half), _ordered(near, far), "leather_26302a", "pads", PRINT * 0.5)
    sheet = _ordered(near + inwards * 0.03, far - inwards * 0.03)
    face.field((u - half * 0.62, u + half * 0.5), sheet, "paper_white", "sheets", PRINT * 0.8)
    face.field((u + half * 0.66, u + half * 0.78), sheet, "paint_f2b90f", "pencils", PRINT)
    card = _ordered(far + inwards * 0.02, far + inwards * 0.07)
    face.field((u - half * 0.6, u + half * 0.6), card, "paper_4f9bd9", "names", PRINT)


def _ordered(one: float, other: float) -> tuple[float, float]:
    return (min(one, other), max(one, other))


@recipe("evidence_table")
def evidence_table(b: Builder) -> None:
    """A steel table under paper with a scale, numbered yellow markers beside outlines, and a tape: EVIDENCE."""
    w, d, h = b.w, b.d, b.h
    face = _flush_top(b, h, 0.04, b.mat())
    end_panels(b, h - 0.04, b.mat())
    face.field((-w * 0.47, w * 0.47), (-d * 0.46, d * 0.46), "paper_white", "paper", PRINT * 0.4)
    for k in range(24):
        u = -w * 0.46 + k * w * 0.92 / 24
        color = ("plastic_black", "plastic_white")[k % 2]
        face.field((u, u + w * 0.92 / 24), (-d * 0.44, -d * 0.39), color, "scale", PRINT * 0.7)
    for k in range(3):
        u = (k - 1) * w * 0.31
        face.field((u - w * 0.09, u + w * 0.09), (-d * 0.02, d * 0.38), "paint_f2c20f", "markers", PRINT * 0.7)
        face.write(str(k + 1), (u - w * 0.08, u + w * 0.08), (d * 0.01, d * 0.35), "plastic_black", "numbers", PRINT)
    _knife(face, -w * 0.31, -d * 0.2, w * 0.11)
    _shoe_print(face, 0.0, -d * 0.2, w * 0.1)
    face.field((w * 0.23, w * 0.39), (-d * 0.33, -d * 0.07), "plastic_bcd6e6", "bag", PRINT * 0.7)
    face.field((w * 0.23, w * 0.39), (-d * 0.13, -d * 0.07), "paint_red", "bag", PRINT)
    face.disc(w * 0.31, -d * 0.24, w * 0.03, "metal_brass", "bag", PRINT, 14)
    front = DrawnFace.front(b, d / 2 - 0.06)
    front.field((-w * 0.46, w * 0.46), (h * 0.62, h * 0.86), "paint_f2c20f", "tape", 0.05)
    front.write("EVIDENCE", (-w * 0.42, w * 0.42), (h * 0.645, h * 0.835), "plastic_black", "letters", 0.056)


def _knife(face: DrawnFace, u: float, v: float, half: float) -> None:
    face.field((u - half * 0.2, u + half), (v - half * 0.14, v + half * 0.14), "metal_9ba0a5", "knife", PRINT)
    face.field((u - half, u - half * 0.2), (v - half * 0.18, v + half * 0.18), "plastic_black", "knife", PRINT)


def _shoe_print(face: DrawnFace, u: float, v: float, half: float) -> None:
    face.disc(u + half * 0.4, v, half * 0.42, "plastic_5a3a2a", "print", PRINT, 16)
    face.field((u - half * 0.1, u + half * 0.5), (v - half * 0.28, v + half * 0.28), "plastic_5a3a2a", "print", PRINT)
    face.disc(u - half * 0.62, v, half * 0.3, "plastic_5a3a2a", "print", PRINT, 14)


@recipe("kids_table")
def kids_table(b: Builder) -> None:
    """A low table on four thick crayons, with a coloured rim, letters and figures to learn, a sun and a flower."""
    w, d, h = b.w, b.d, b.h
    colors = ("plastic_e8382e", "plastic_2f8fe0", "plastic_38b04a", "plastic_f5c518")
    thick, r = 0.035, 0.045
    face = _flush_top(b, h, thick, b.mat())
    for k, (sx, sy) in enumerate(((-1, -1), (1, -1), (1, 1), (-1, 1))):
        x, y = sx * (w / 2 - 0.09), sy * (d / 2 - 0.09)
        b.cyl(x, y, (h * 0.2, h - thick), r, colors[k], "legs", n=14)
        b.taper((x, y, h * 0.2), (x, y, h * 0.06), (r, r * 0.45), "wood_birch", "legs", 14)
        b.taper((x, y, h * 0.06), (x, y, 0.0), (r * 0.45, r * 0.3), colors[k], "legs", 14)
        b.cyl(x, y, (h * 0.74, h * 0.8), r * 1.06, "plastic_white", "legs", n=14)
    for k, (u, v) in enumerate(
        (
            ((-0.5, 0.5), (-0.5, -0.45)),
            ((-0.5, 0.5), (0.45, 0.5)),
            ((-0.5, -0.46), (-0.45, 0.45)),
            ((0.46, 0.5), (-0.45, 0.45)),
        )
    ):
        face.field((w * u[0], w * u[1]), (d * v[0], d * v[1]), colors[k], "rim", PRINT)
    front = DrawnFace.front(b, d / 2)
    front.field((-w / 2, w / 2), (h - thick, h - 0.003), colors[0], "rim")
    DrawnFace.side(b, w / 2).field((-d / 2, d / 2), (h - thick, h - 0.003), colors[1], "rim")
    for k, letter in enumerate("ABC123"):
        column, row = k % 3 - 1, 1 - k // 3
        across, up = column * w * 0.2, d * (-0.2 + 0.34 * row)
        face.write(
            letter,
            (across - w * 0.085, across + w * 0.085),
            (up - d * 0.13, up + d * 0.13),
            colors[(k * 3 + 1) % 4],
            "letters",
            PRINT,
        )
    face.disc(w * 0.38, d * 0.26, min(w, d) * 0.1, "plastic_f58f18", "sun", PRINT)
    face.disc(-w * 0.38, -d * 0.24, min(w, d) * 0.1, "plastic_f06fa0", "flower", PRINT)
    face.disc(-w * 0.38, -d * 0.24, min(w, d) * 0.045, "plastic_f5c518", "flower", PRINT * 1.001)


@recipe("coffee_table")
def coffee_table(b: Builder) -> None:
    """A low table with magazines and a pot of coffee with two cups on the shelf below its top."""
    w, d, h = b.w, b.d, b.h
    thick = min(0.04, h * 0.14)
    table_top(b, h, thick, round_=False)
    four_legs(b, h - thick, b.mat())
    if h < 0.3:
        return
    shelf = h * 0.24
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2 + 0.03, d / 2 - 0.03), (shelf - 0.02, shelf), b.mat(), "shelf")
    room = h - thick - 0.07 - shelf
    s = min(w * 0.52, d * 0.6, room * 1.7)
    _magazines(b, (w * 0.22, d * 0.14, shelf), s * 0.8)
    _coffee(b, (-w * 0.19, d * 0.16, shelf), min(s, room * 1.9))


def _magazines(b: Builder, at: Vec3, size: float) -> None:
    """A pile of magazines, turned against each other, the uppermost with a title above a picture."""
    x, y, z = at
    for k, color in enumerate(("paper_4f9bd9", "paper_f2c12e", "paper_e8604f", "paper_white")):
        low, shift = z + 0.012 * k, size * 0.05 * (-1) ** k
        across, deep = (x - size * 0.34 + shift, x + size * 0.34 + shift), (y - size * 0.45, y + size * 0.45 + shift)
        b.box(across, deep, (low, low + 0.012), color, "magazines", solid=False)
    face = DrawnFace.top(b, z + 0.048)
    u, v = -x + size * 0.05, -y
    face.field((u - size * 0.3, u + size * 0.3), (v - size * 0.4, v + size * 0.2), "picture_meadow", "covers")
    face.field((u - size * 0.3, u + size * 0.3), (v + size * 0.25, v + size * 0.4), "paper_red", "covers")


def _coffee(b: Builder, at: Vec3, size: float) -> None:
    """A tray with a coffee pot, which has a spout, a handle and a lid with a knob, and two cups on saucers."""
    x, y, z = at
    tray = z + 0.012
    b.box(
        (x - size * 0.5, x + size * 0.5),
        (y - size * 0.4, y + size * 0.4),
        (z, tray),
        "wood_walnut",
        "tray",
        solid=False,
    )
    r, px, py = size * 0.17, x + size * 0.05, y - size * 0.16
    pot = [
        (r * 0.9, tray),
        (r, tray + r * 0.5),
        (r * 0.6, tray + r * 2.1),
        (r * 0.68, tray + r * 2.3),
        (r * 0.3, tray + r * 2.6),
    ]
    b.lathe(pot, "ceramic_white", (px, py), "pot", 18)
    b.ball((px, py, tray + r * 2.75), (r * 0.2, r * 0.2, r * 0.2), "ceramic_white", "pot", 8)
    b.taper(
        (px - r * 0.7, py, tray + r * 0.9),
        (px - r * 1.5, py, tray + r * 2.1),
        (r * 0.28, r * 0.14),
        "ceramic_white",
        "spout",
        10,
    )
    grip = [(px + r * 0.7, py, tray + r * 1.9), (px + r * 1.5, py, tray + r * 1.7), (px + r * 0.9, py, tray + r * 0.6)]
    b.path(grip, r * 0.12, "ceramic_white", "handle")
    for k in (-1, 1):
        cx, cy, c = x + k * size * 0.26, y + size * 0.2, size * 0.11
        b.lathe([(c * 1.5, tray), (c * 1.6, tray + c * 0.2)], "ceramic_white", (cx, cy), "cups", 16)
        cup = [(c * 0.6, tray + c * 0.2), (c, tray + c * 1.5), (c * 0.86, tray + c * 1.5), (c * 0.8, tray + c * 1.3)]
        b.lathe(cup, "ceramic_white", (cx, cy), "cups", 16)
        b.cyl(cx, cy, (tray + c * 1.29, tray + c * 1.34), c * 0.8, "food_4a2a16", "coffee", n=14, solid=False)
        ring = [(cx + c * 0.9, cy, tray + c * 1.2), (cx + c * 1.5, cy, tray + c), (cx + c * 0.8, cy, tray + c * 0.5)]
        b.path(ring, c * 0.13, "ceramic_white", "cups")


@recipe("office_desk")
def office_desk(b: Builder) -> None:
    """A desk on frames with a case of drawers, a computer below it, cables through a hole, and a mat for the mouse."""
    w, d = b.w, b.d
    z = b.tops[0].z
    face = _flush_top(b, z, 0.03, b.mat())
    sled_frames(b, z - 0.03, b.mat("frame", b.mat()))
    b.box((-w / 2 + 0.1, w / 2 - 0.1), (-d / 2 + 0.06, -d / 2 + 0.08), (z * 0.45, z - 0.03), b.mat(), "modesty")
    _rolling_drawers(b, (w / 2 - 0.56, w / 2 - 0.14), z - 0.07)
    _computer_below(b, -w / 2 + 0.24, z)
    face.disc(0.0, d * 0.38, 0.035, "plastic_black", "grommet", PRINT, 18)
    face.field((-w * 0.2, w * 0.2), (-d * 0.42, d * 0.02), "leather_26302a", "mat", PRINT)
    face.field((w * 0.24, w * 0.24 + 0.2), (-d * 0.38, -d * 0.06), "fabric_4f86c6", "mat", PRINT)


def _rolling_drawers(b: Builder, x: tuple[float, float], high: float) -> None:
    """A case on castors with three fronts, each with a grip, and a lock in the uppermost."""
    d = b.d
    back, front, low = -d / 2 + 0.12, d / 2 - 0.06, 0.07
    b.box(x, (back, front), (low, high), "metal_light", "case")
    for px in (x[0] + 0.05, x[1] - 0.05):
        for py in (back + 0.06, front - 0.06):
            b.rod((px - 0.012, py, 0.03), (px + 0.012, py, 0.03), 0.03, "rubber_black", "castors", 12)
            b.cyl(px, py, (0.04, low), 0.014, "metal_dark", "castors", n=8, solid=False)
    face, step = DrawnFace.front(b, front), (high - low) / 3
    for k in range(3):
        level = low + k * step
        face.field(
            (-x[1] + 0.006, -x[0] - 0.006), (level + 0.006, level + step - 0.006), "metal_9ba0a5", "fronts", 0.012
        )
        middle = -(x[0] + x[1]) / 2
        grip = (level + step * 0.66, level + step * 0.8)
        face.field((middle - 0.09, middle + 0.09), grip, "plastic_dark", "grips", 0.022)
    face.disc(-x[0] - 0.05, high - 0.04, 0.012, "metal_brass", "lock", 0.016, 12)


def _computer_below(b: Builder, x: float, z: float) -> None:
    """The case of a computer with a lit button and slots, and its cables up to the top."""
    d = b.d
    front, high = d * 0.3, z * 0.66
    b.box((x - 0.09, x + 0.09), (-d * 0.3, front), (0.02, high), "plastic_26272b", "computer")
    face = DrawnFace.front(b, front)
    face.disc(-x, high * 0.9, 0.018, "light_4fd0f0", "button", 0.006, 14)
    for k in range(3):
        level = high * (0.72 - 0.08 * k)
        face.field((-x - 0.07, -x + 0.07), (level, level + 0.014), "plastic_9ba0a5", "slots", 0.004)
    for k in range(5):
        level = high * (0.12 + 0.06 * k)
        face.field((-x - 0.06, -x + 0.06), (level, level + 0.01), "plastic_5a6470", "vents", 0.004)
    cable = [
        (x, -d * 0.3, high * 0.8),
        (x * 0.8, -d * 0.36, high * 0.5),
        (x * 0.3, -d * 0.36, z * 0.5),
        (0.0, -d * 0.36, z - 0.03),
    ]
    b.path(cable, 0.01, "rubber_black", "cables")
