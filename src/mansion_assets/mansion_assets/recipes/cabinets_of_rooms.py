"""Cabinets of particular rooms: below a kitchen's worktop, in a bathroom, below a television."""

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import BOARD
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.recipes.cabinets import cabinet
from mansion_assets.registry import recipe

__all__: list[str] = []

Span = tuple[float, float]


def _fronts(b: Builder) -> list[tuple[str, Span, Span]]:
    """Return the doors of a cabinet by rows and columns: the part that moves, and its front across (u) and up."""
    cols, rows = int(b.p.get("cols", 2)), int(b.p.get("rows", 1))
    plinth = float(b.p.get("plinth", min(0.08, b.h * 0.1)))
    width, height = (b.w - BOARD) / cols, (b.h - plinth - BOARD) / rows
    kind = "drawer" if b.p.get("front", "drawers") == "drawers" else "door"
    found = []
    for place in range(rows * cols):
        row, col = divmod(place, cols)
        x0, z0 = -b.w / 2 + BOARD / 2 + col * width, plinth + BOARD / 2 + row * height
        top = min(z0 + height, b.h - (BOARD if b.p.get("top") else 0.0))
        found.append((f"{kind}_{place + 1}", (-x0 - width + 0.002, -x0 - 0.002), (z0 + 0.002, top - 0.002)))
    return found


@recipe("kitchen_cabinet")
def kitchen_cabinet(b: Builder) -> None:
    """Framed fronts below drawers with cup handles; ladle, slice and whisk hang from a rail, and tea towels."""
    cabinet(b)
    face = DrawnFace.front(b, b.d / 2 - 0.006)
    for number, (part, u, v) in enumerate(_fronts(b)):
        with b.fixed_to(part):
            columns = max(1, round((u[1] - u[0]) / 0.55))
            step = (u[1] - u[0]) / columns
            for k in range(columns):
                _framed_front(b, face, (u[0] + k * step, u[0] + (k + 1) * step), v)
            right = (u[1] - step, u[1])
            if number == 0:
                _hung_tools(face, right, v)
            else:
                _tea_towel(face, right, v)


def _framed_front(b: Builder, face: DrawnFace, u: Span, v: Span) -> None:
    """A drawer with a cup handle above a door with a raised frame."""
    line, shade = v[1] - (v[1] - v[0]) * 0.24, "plastic_5a6470"
    face.field((u[0], u[1]), (line - 0.004, line + 0.004), shade, "joints", 0.001)
    for edge in u:
        face.field((edge - 0.003, edge + 0.003), v, shade, "joints", 0.001)
    for low, high in ((v[0], line), (line, v[1])):
        rim = 0.05 if high == line else 0.025
        inner_u, inner_v = (u[0] + rim, u[1] - rim), (low + rim, high - rim)
        for side in inner_u:
            face.field((side - 0.004, side + 0.004), inner_v, shade, "frames", 0.002)
        for level in inner_v:
            face.field(inner_u, (level - 0.004, level + 0.004), shade, "frames", 0.002)
    middle, level = (u[0] + u[1]) / 2, (line + v[1]) / 2
    face.field((middle - 0.06, middle + 0.06), (level - 0.02, level + 0.016), "metal_brass", "cup_handles", 0.006)
    face.disc(u[1] - 0.035, line - 0.1, 0.016, "metal_brass", "knobs", 0.006, 12)


def _hung_tools(face: DrawnFace, u: Span, v: Span) -> None:
    """A rail with a whisk, a ladle and a slotted slice on hooks."""
    tall, wide = (v[1] - v[0]) * 0.7, (u[1] - u[0]) * 0.8
    top, left, dark = v[0] + tall, (u[0] + u[1]) / 2 - (u[1] - u[0]) * 0.4, "plastic_2a2d32"
    face.field((left, left + wide), (top - 0.012, top), "metal_9ba0a5", "rail", 0.006)
    places = [left + wide * share for share in (0.2, 0.5, 0.8)]
    r = min(wide * 0.12, tall * 0.14)
    for u0 in places:
        face.field((u0 - r * 0.16, u0 + r * 0.16), (top - tall * 0.56, top), dark, "tools", 0.005)
    low = top - tall * 0.62
    face.disc(places[0], low, r, dark, "tools", 0.005, 18)
    face.field((places[1] - r, places[1] + r), (low - r * 1.4, low + r), dark, "tools", 0.005)
    for k in (-1, 0, 1):
        slot = places[1] + k * r * 0.56
        face.field((slot - r * 0.12, slot + r * 0.12), (low - r * 1.1, low + r * 0.5), "plastic_white", "slots", 0.006)
    for k in range(5):
        bend = (k - 2) * r * 0.42
        wire = [
            (places[2], low + r * 1.2),
            (places[2] + bend, low + r * 0.2),
            (places[2] + bend, low - r * 0.6),
            (places[2], low - r * 1.5),
        ]
        face.line(wire, r * 0.08, "metal_9ba0a5", "whisk", 0.002)


def _tea_towel(face: DrawnFace, u: Span, v: Span) -> None:
    """A checked towel over a rail."""
    tall, middle = (v[1] - v[0]) * 0.7, (u[0] + u[1]) / 2
    half, top = min(0.13, (u[1] - u[0]) * 0.3), v[0] + tall
    low = top - min(0.44, tall * 0.84)
    face.field((middle - half * 1.3, middle + half * 1.3), (top - 0.012, top), "metal_9ba0a5", "rail", 0.006)
    face.field((middle - half, middle + half), (low, top), "fabric_f4f4f0", "towel", 0.003)
    count = 3
    for k in range(count):
        at = middle - half + 2 * half * (k + 0.5) / count
        face.field((at - half / 6, at + half / 6), (low, top), "fabric_d8483e", "checks", 0.004)
    for k in range(4):
        level = low + (top - low) * (k + 0.5) / 4
        face.field(
            (middle - half, middle + half), (level - half / 6, level + half / 6), "fabric_d8483e", "checks", 0.005
        )


@recipe("bathroom_cabinet")
def bathroom_cabinet(b: Builder) -> None:
    """A mirror on the upper door, a striped towel on a bar on the lower one, and drops of water."""
    cabinet(b)
    face = DrawnFace.front(b, b.d / 2 - 0.006)
    (lower, u, low), (upper, _, high) = _fronts(b)
    with b.fixed_to(upper):
        face.field((u[0] + 0.02, u[1] - 0.05), (high[0] + 0.03, high[1] - 0.03), "metal_chrome", "mirror", 0.003)
        face.field((u[0] + 0.03, u[1] - 0.06), (high[0] + 0.04, high[1] - 0.04), "glass_mirror", "mirror", 0.004)
        tall = high[1] - high[0]
        for start, thick in ((0.2, 0.014), (0.32, 0.006)):
            gleam = [(u[0] + 0.06, high[0] + tall * start), (u[1] - 0.09, high[0] + tall * (start + 0.34))]
            face.line(gleam, thick, "plastic_f6fcff", "gleam", -thick + 0.006)
    with b.fixed_to(lower):
        tall = low[1] - low[0]
        middle, top = (u[0] + u[1]) / 2, low[0] + tall * 0.86
        half = (u[1] - u[0]) * 0.3
        face.field((middle - half * 1.25, middle + half * 1.25), (top - 0.014, top), "metal_chrome", "bar", 0.006)
        face.field((middle - half, middle + half), (low[0] + tall * 0.3, top + 0.004), "fabric_3f9fd0", "towel", 0.004)
        for share in (0.36, 0.42):
            level = low[0] + tall * share
            face.field((middle - half, middle + half), (level, level + tall * 0.025), "fabric_white", "towel", 0.005)
        for k in range(3):
            spot = (middle + (k - 1) * half * 0.9, low[0] + tall * (0.12 + 0.05 * (k % 2)))
            r = tall * 0.035
            face.disc(*spot, r, "plastic_2f8fe0", "drops", 0.004, 14)
            for j in range(4):
                wide = r * (0.86 - 0.22 * j)
                rise = (spot[1] + r * (0.4 + 0.4 * j), spot[1] + r * (0.8 + 0.4 * j))
                face.field((spot[0] - wide, spot[0] + wide), rise, "plastic_2f8fe0", "drops", 0.004)


@recipe("media_console")
def media_console(b: Builder) -> None:
    """Drawers, in whose upper half a dark niche shows films, a player and a console for games."""
    cabinet(b)
    face = DrawnFace.front(b, b.d / 2 - 0.006)
    for number, (part, u, v) in enumerate(_fronts(b)):
        tall, wide = v[1] - v[0], u[1] - u[0]
        niche = (v[0] + tall * 0.46, v[1] - 0.014)
        with b.fixed_to(part):
            face.field((u[0] + 0.006, u[1] - 0.006), niche, "plastic_17181b", "niches", 0.002)
            (_films, _player, _console)[number % 3](face, (u[0] + wide * 0.08, u[1] - wide * 0.08), niche)


def _films(face: DrawnFace, u: Span, v: Span) -> None:
    """A row of films on end."""
    count = 12
    step, tall = (u[1] - u[0]) / count, v[1] - v[0]
    for k in range(count):
        color = ("paper_red", "paper_4f9bd9", "paper_f2c12e", "paper_white", "paper_green")[(k * 7) % 5]
        u0 = u[0] + k * step
        top = v[0] + tall * (0.72 + 0.05 * (k * 3 % 4))
        face.field((u0, u0 + step * 0.84), (v[0] + tall * 0.03, top), color, "films", 0.004)
        face.field((u0, u0 + step * 0.84), (top - tall * 0.2, top - tall * 0.14), "plastic_26272b", "films", 0.005)


def _player(face: DrawnFace, u: Span, v: Span) -> None:
    """A player with a slot for discs, a lit clock and the sign to play, over an amplifier with two dials."""
    wide, tall, middle = u[1] - u[0], v[1] - v[0], (u[0] + u[1]) / 2
    face.field(u, (v[0] + tall * 0.56, v[0] + tall * 0.9), "metal_9ba0a5", "player", 0.004)
    face.field((u[0] + wide * 0.06, middle), (v[0] + tall * 0.76, v[0] + tall * 0.82), "plastic_black", "slot", 0.005)
    face.field(
        (middle + wide * 0.06, u[1] - wide * 0.06),
        (v[0] + tall * 0.62, v[0] + tall * 0.84),
        "screen_06202a",
        "clock",
        0.005,
    )
    face.write(
        "20:15",
        (middle + wide * 0.08, u[1] - wide * 0.08),
        (v[0] + tall * 0.64, v[0] + tall * 0.82),
        "light_4fd0f0",
        "clock",
        0.006,
    )
    face.field(u, (v[0] + tall * 0.04, v[0] + tall * 0.48), "plastic_4a4e55", "amplifier", 0.004)
    for share in (0.2, 0.8):
        face.disc(u[0] + wide * share, v[0] + tall * 0.26, tall * 0.15, "metal_chrome", "dials", 0.006, 18)
    face.field(
        (u[0] + wide * 0.36, u[1] - wide * 0.36),
        (v[0] + tall * 0.16, v[0] + tall * 0.36),
        "light_ff8a3a",
        "amplifier",
        0.005,
    )


def _console(face: DrawnFace, u: Span, v: Span) -> None:
    """A console for games, and before it a controller with a cross, buttons and a cable."""
    wide, tall = u[1] - u[0], v[1] - v[0]
    face.field((u[0], u[0] + wide * 0.3), (v[0] + tall * 0.03, v[0] + tall * 0.9), "plastic_white", "console", 0.004)
    face.field(
        (u[0] + wide * 0.13, u[0] + wide * 0.17),
        (v[0] + tall * 0.1, v[0] + tall * 0.8),
        "light_4f9bf0",
        "console",
        0.005,
    )
    r, level = wide * 0.13, v[0] + tall * 0.3
    left, right = u[0] + wide * 0.5, u[0] + wide * 0.86
    face.field((left, right), (level - r * 0.6, level + r * 0.7), "plastic_c9ccd0", "controller", 0.004)
    for side in (left, right):
        face.disc(side, level, r, "plastic_c9ccd0", "controller", 0.004, 16)
    face.field(
        (left - r * 0.5, left + r * 0.5), (level - r * 0.14, level + r * 0.14), "plastic_26272b", "controller", 0.006
    )
    face.field(
        (left - r * 0.14, left + r * 0.14), (level - r * 0.5, level + r * 0.5), "plastic_26272b", "controller", 0.006
    )
    for k, color in enumerate(("paint_red", "paint_green")):
        face.disc(right + (k - 0.5) * r * 0.8, level + (k - 0.5) * r * 0.5, r * 0.26, color, "controller", 0.006, 10)
    cable = [
        ((left + right) / 2, level + r * 0.7),
        ((left + right) / 2, level + r * 1.8),
        (u[0] + wide * 0.3, level + r * 2.2),
    ]
    face.line(cable, r * 0.09, "plastic_c9ccd0", "cables", 0.003)


@recipe("medicine_cabinet")
def medicine_cabinet(b: Builder) -> None:
    """A green cross on each upper door; bottles and boxes of medicine on shelves behind the lower ones."""
    cabinet(b)
    face = DrawnFace.front(b, b.d / 2 - 0.006)
    for number, (part, u, v) in enumerate(_fronts(b)):
        with b.fixed_to(part):
            inner, high = (u[0] + 0.03, u[1] - 0.03), (v[0] + 0.03, v[1] - 0.03)
            face.field(inner, high, "plastic_f8fbfc" if number > 1 else "plastic_cfe0e8", "fronts", 0.001)
            if number > 1:
                _cross(face, (u[0] + u[1]) / 2, (v[0] + v[1]) / 2, (u[1] - u[0]) * 0.38)
            else:
                _medicines(face, inner, high)


def _cross(face: DrawnFace, u: float, v: float, r: float) -> None:
    for across, up in ((r, r / 3), (r / 3, r)):
        face.field((u - across, u + across), (v - up, v + up), "paint_18a048", "cross", 0.003)


def _medicines(face: DrawnFace, u: Span, v: Span) -> None:
    """Three shelves: brown bottles with white caps, white boxes with a cross, and tubs of pills."""
    step, wide = (v[1] - v[0]) / 3, (u[1] - u[0]) / 3
    for row in range(3):
        low = v[0] + row * step
        face.field(u, (low, low + 0.014), "metal_9ba0a5", "shelves", 0.003)
        for k in range(3):
            left, middle = u[0] + wide * (k + 0.1), u[0] + wide * (k + 0.5)
            right, base = left + wide * 0.8, low + 0.014
            if (row + k) % 2:
                color = ("plastic_d8382e", "plastic_2f6fd0")[row % 2]
                face.field((left, right), (base, base + step * 0.6), "paper_ffffff", "boxes", 0.003)
                face.field((left, right), (base, base + step * 0.16), color, "boxes", 0.004)
                face.field(
                    (middle - wide * 0.08, middle + wide * 0.08),
                    (base + step * 0.22, base + step * 0.54),
                    color,
                    "boxes",
                    0.004,
                )
                face.field(
                    (middle - wide * 0.24, middle + wide * 0.24),
                    (base + step * 0.33, base + step * 0.43),
                    color,
                    "boxes",
                    0.004,
                )
            else:
                face.field((left, right), (base, base + step * 0.56), "plastic_c8701e", "bottles", 0.003)
                face.field((left, right), (base + step * 0.14, base + step * 0.4), "paper_ffffff", "labels", 0.004)
                face.field((left, right), (base + step * 0.56, base + step * 0.76), "plastic_white", "caps", 0.004)


@recipe("bedside_locker")
def bedside_locker(b: Builder) -> None:
    """A locker on castors beside a bed: its number on the drawer above, a red cross and a patient in bed below."""
    cabinet(b)
    face = DrawnFace.front(b, b.d / 2 - 0.006)
    (lower, u, low), (upper, _, high) = _fronts(b)
    middle, half, tall = (u[0] + u[1]) / 2, (u[1] - u[0]) / 2, low[1] - low[0]
    with b.fixed_to(upper):
        face.field(
            (u[0] + 0.03, u[1] - 0.03), (high[0] + tall * 0.12, high[0] + tall * 0.62), "plastic_1f6fb8", "name", 0.003
        )
        face.write(
            "BED 4",
            (u[0] + 0.05, u[1] - 0.05),
            (high[0] + tall * 0.16, high[0] + tall * 0.58),
            "paper_ffffff",
            "letters",
            0.005,
        )
    with b.fixed_to(lower):
        face.field((u[0] + 0.03, u[1] - 0.03), (low[0] + 0.03, low[0] + tall * 0.78), "plastic_f8fbfc", "panel", 0.002)
        for across, up in ((half * 0.34, half * 0.11), (half * 0.11, half * 0.34)):
            v = low[0] + tall * 0.56
            face.field((middle - across, middle + across), (v - up, v + up), "paint_d8201e", "cross", 0.005)
        base = low[0] + tall * 0.08
        face.field(
            (middle - half * 0.7, middle + half * 0.7),
            (base + tall * 0.1, base + tall * 0.15),
            "plastic_26272b",
            "bed",
            0.004,
        )
        for side in (-0.7, 0.64):
            face.field(
                (middle + half * side, middle + half * (side + 0.08)),
                (base, base + tall * 0.26),
                "plastic_26272b",
                "bed",
                0.004,
            )
        face.field(
            (middle - half * 0.3, middle + half * 0.62),
            (base + tall * 0.15, base + tall * 0.22),
            "plastic_2f6fd0",
            "bed",
            0.004,
        )
        face.disc(middle - half * 0.45, base + tall * 0.2, tall * 0.05, "plastic_26272b", "bed", 0.004, 14)
