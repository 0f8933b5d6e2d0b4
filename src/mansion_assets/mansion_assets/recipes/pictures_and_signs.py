"""Pictures, mirrors, boards and signs, on walls and on stands."""

import math
import zlib

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.materials.sets import art
from mansion_assets.registry import recipe

__all__: list[str] = []


def _shown(b: Builder, face: str) -> str:
    """Return the material of a face: a picture that depends on the asset's look, or the material that it names."""
    if face == "map":
        return "picture_map"
    if face != "art":
        return face
    look = f"{b.mat()} {b.w:.3f} {b.h:.3f}"
    return art()[zlib.crc32(look.encode()) % len(art())]


def _face(b: Builder, face: str, x: tuple[float, float], z: tuple[float, float], y: float) -> None:
    """What a panel shows, flat on its front at `y`."""
    b.box(x, (y - 0.0015, y), z, _shown(b, face), "face", solid=False)
    if face == "glass_mirror":
        _gleam(b, x, z, y)


def _gleam(b: Builder, x: tuple[float, float], z: tuple[float, float], y: float) -> None:
    """Two slanted bands of light on a mirror."""
    w, h = x[1] - x[0], z[1] - z[0]
    slant = min(w * 0.4, h * 0.4)
    for low, wide in ((0.34, 0.14), (0.56, 0.05)):
        u = x[0] + (w - slant) * low
        band = [
            (u, z[0] + h * 0.12),
            (u + w * wide, z[0] + h * 0.12),
            (u + w * wide + slant, z[1] - h * 0.12),
            (u + slant, z[1] - h * 0.12),
        ]
        b.prism(band, (y - 0.0008, y + 0.0006), "plastic_eef6fa", "y", "gleam", solid=False)


@recipe("panel")
def panel(b: Builder) -> None:
    """Framed face: picture, mirror, board; on an easel, a rolling stand or a post; a roller screen."""
    style = b.p.get("style")
    if style in ("easel", "aframe"):
        _easel(b)
    elif style == "roll":
        _roller_screen(b)
    elif style == "stand":
        _rolling_stand(b)
        _framed(b, (-0.02, 0.02), b.h * 0.42)
    elif style == "post":
        _post(b)
        _framed(b, (-0.02, 0.015), b.h * 0.6)
    else:
        _framed(b, (-b.d / 2, b.d / 2), 0.0)


def _rim(b: Builder) -> float:
    """Return the width of the frame."""
    return min(float(b.p.get("rim", 0.03)), b.w * 0.1)


def _rolling_stand(b: Builder) -> None:
    """Two posts on feet with castors."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.06)
        b.box((x - 0.02, x + 0.02), (-d / 2, d / 2), (0.05, 0.08), b.mat(), "feet")
        b.box((x - 0.02, x + 0.02), (-0.04, 0.0), (0.06, h), b.mat(), "posts")
    b.wheels(0.03, 0.06)


def _easel(b: Builder) -> None:
    """Leaning frame with a leg behind it; an A-frame leans whole."""
    w, d, h = b.w, b.d, b.h
    style = b.p.get("style")
    thick = 0.02 if h > 0.4 else 0.008
    lean = d * 0.5
    b.prism(
        [(d / 2, 0), (d / 2 - thick, 0), (d / 2 - lean - thick, h), (d / 2 - lean, h)],
        (-w / 2, w / 2) if style == "aframe" or h < 0.4 else (-w / 2, -w / 2 + 0.04),
        b.mat(),
        part="frame",
    )
    if style == "easel" and h >= 0.4:
        b.prism(
            [(d / 2, 0), (d / 2 - thick, 0), (d / 2 - lean - thick, h), (d / 2 - lean, h)],
            (w / 2 - 0.04, w / 2),
            b.mat(),
            part="frame",
        )
    b.rod((0, -d / 2 + 0.01, 0.0), (0, d / 2 - lean, h * 0.92), 0.012 if h > 0.4 else 0.005, b.mat(), "leg", solid=True)
    _leaning_face(b, lean)


def _leaning_face(b: Builder, lean: float) -> None:
    """What an easel carries, with paint on a canvas."""
    w, d, h = b.w, b.d, b.h
    face = str(b.p.get("face", "paper_white"))
    rim = _rim(b)
    low = h * (0.38 if h > 1.0 else 0.06)
    s0, s1 = d / 2 - lean * low / h, d / 2 - lean * 0.97
    b.prism(
        [(s0, low), (s0 + 0.006, low), (s1 + 0.006, h * 0.97), (s1, h * 0.97)],
        (-w / 2 + rim, w / 2 - rim),
        _shown(b, face),
        part="face",
    )


def _post(b: Builder) -> None:
    """Round foot and post."""
    w, d, h = b.w, b.d, b.h
    b.cyl(0, 0, (0, 0.02), min(w, d) / 2, b.mat(), "foot", n=20)
    b.cyl(0, -0.02, (0.01, h * 0.7), 0.018, b.mat(), "post")


def _roller_screen(b: Builder) -> None:
    """Screen hanging from its case."""
    w, d, h = b.w, b.d, b.h
    face = str(b.p.get("face", "paper_white"))
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.1, h), b.mat(), "case")
    b.box((-w / 2 + 0.04, w / 2 - 0.04), (-0.004, 0.004), (0, h - 0.1), face, "screen")
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-0.012, 0.012), (0, 0.025), "plastic_black", "bar", solid=False)


def _framed(b: Builder, y: tuple[float, float], from_z: float) -> None:
    """Back, frame and face between two depths, from a height up to the top; a tray and notes on it."""
    w, d = b.w, b.d
    face = str(b.p.get("face", "paper_white"))
    rim = _rim(b)
    (y0, y1), z0, z1 = y, from_z, b.h
    b.box((-w / 2, w / 2), (y0, y1 - 0.008 if d > 0.02 else y1 - 0.004), (z0, z1), b.mat(), "back")
    for side in ((-w / 2, -w / 2 + rim), (w / 2 - rim, w / 2)):
        b.box(side, (y0, y1), (z0, z1), b.mat(), "frame", solid=False)
    for level in ((z0, z0 + rim), (z1 - rim, z1)):
        b.box((-w / 2, w / 2), (y0, y1), level, b.mat(), "frame", solid=False)
    _face(b, face, (-w / 2 + rim, w / 2 - rim), (z0 + rim, z1 - rim), y1 - (0.004 if d > 0.02 else 0.001))
    if b.p.get("tray"):
        b.box((-w * 0.3, w * 0.3), (y1 - 0.03, y1), (0, 0.015), "metal_steel", "tray", solid=False)
    if b.p.get("notes"):
        _notes(b, y1)


def _notes(b: Builder, y1: float) -> None:
    """Eight notes on the face."""
    w, h = b.w, b.h
    for k in range(8):
        x, z = -w * 0.4 + (k % 4) * w * 0.22, h * (0.2 if k < 4 else 0.58)
        b.box(
            (x, x + w * 0.14),
            (y1 - 0.004, y1 - 0.002),
            (z, z + h * 0.24),
            ("paper_white", "paper_yellow", "paper_blue", "paper_pink")[k % 4],
            "notes",
            solid=False,
        )


@recipe("floor_mirror")
def floor_mirror(b: Builder) -> None:
    """A tall oval mirror that swings between two posts with knobs, on broad feet, with slanted light on the glass."""
    w, d, h = b.w, b.d, b.h
    post, middle, rx, rz = w / 2 - 0.025, h * 0.54, w * 0.38, h * 0.46
    ring = [(math.cos(k * math.tau / 32), math.sin(k * math.tau / 32)) for k in range(32)]
    for share, y, color, part in (
        (1.0, (-0.03, 0.012), b.mat(), "frame"),
        (0.86, (0.012, 0.016), "plastic_b4d8ee", "mirror"),
    ):
        thick = rx * (1 - share)
        b.prism([(u * (rx - thick), middle + v * (rz - thick)) for u, v in ring], y, color, "y", part)
    for low, wide in ((-0.46, 0.2), (-0.1, 0.08)):
        u = rx * low
        band = [(u, middle - rz * 0.5), (u + rx * wide, middle - rz * 0.5)]
        band += [(u + rx * (wide + 0.5), middle + rz * 0.5), (u + rx * 0.5, middle + rz * 0.5)]
        b.prism([(-x, z) for x, z in reversed(band)], (0.016, 0.018), "plastic_f8fdff", "y", "gleam", solid=False)
    for side in (-1, 1):
        x = side * post
        b.rod((x, 0, 0.06), (x, 0, h * 0.78), 0.022, b.mat(), "posts", 12, solid=True)
        b.ball((x, 0, h * 0.8), (0.025, 0.025, 0.035), b.mat(), "knobs", 10)
        b.rod((side * rx * 0.95, -0.01, middle), (side * w / 2, -0.01, middle), 0.018, "metal_brass", "pivots", 12)
        for end in (-1, 1):
            b.rod((x, 0, 0.14), (x, end * (d / 2 - 0.025), 0.025), 0.025, b.mat(), "feet", 10)
    b.rod((-post, 0, 0.12), (post, 0, 0.12), 0.018, b.mat(), "rail", 10)


@recipe("sign")
def sign(b: Builder) -> None:
    """Plate with a symbol; exit signs with an arrow and a running figure of bars."""
    w, d, h = b.w, b.d, b.h
    z1 = h * 0.62 if b.p.get("style") == "hanging" else h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.002), (0, z1), b.mat(), "plate")
    if z1 < h:
        for sx in (-1, 1):
            b.rod((sx * w * 0.35, 0, z1), (sx * w * 0.35, 0, h), 0.006, "metal_steel", "rods")
    light = "light_white" if b.mat() == "plastic_green" else "plastic_dark"
    b.prism(
        [(w * 0.08, z1 * 0.5), (w * 0.25, z1 * 0.25), (w * 0.25, z1 * 0.75)],
        (d / 2 - 0.002, d / 2),
        light,
        "y",
        "arrow",
        solid=False,
    )
    b.box((w * 0.25, w * 0.42), (d / 2 - 0.002, d / 2), (z1 * 0.42, z1 * 0.58), light, "arrow", solid=False)
    b.box((-w * 0.4, -w * 0.1), (d / 2 - 0.002, d / 2), (z1 * 0.2, z1 * 0.8), light, "symbol", solid=False)


@recipe("wet_floor_sign")
def wet_floor_sign(b: Builder) -> None:
    """A yellow stand of two boards like an A, with a warning triangle, a slipping figure and a hole to carry it by."""
    w, d, h = b.w, b.d, b.h
    for side in (-1, 1):
        board = [(side * d / 2, 0), (side * d * 0.44, 0), (0, h * 0.97), (side * d * 0.06, h)]
        b.prism(board, (-w / 2, w / 2), "plastic_f2c21a", part="boards")
    slope = (d * 0.06 - d / 2) / h

    def at(z: float) -> float:
        return d / 2 + slope * z

    def mark(x0: float, x1: float, z0: float, z1: float, color: str, lift: float) -> None:
        """Lay a rectangle on the front board."""
        face = [(at(h * z0), h * z0), (at(h * z0) + lift, h * z0), (at(h * z1) + lift, h * z1), (at(h * z1), h * z1)]
        b.prism(face, (w * x0, w * x1), color, part="print", solid=False)

    for k in range(6):
        half = 0.4 - 0.065 * k
        mark(-half, half, 0.52 + 0.055 * k, 0.575 + 0.055 * k, "plastic_black", 0.003)
    mark(-0.05, 0.05, 0.62, 0.76, "plastic_f2c21a", 0.006)
    mark(-0.05, 0.05, 0.54, 0.59, "plastic_f2c21a", 0.006)
    for z in (0.4, 0.28):
        mark(-0.36, 0.36, z, z + 0.06, "plastic_black", 0.003)
    mark(-0.3, 0.3, 0.14, 0.19, "paint_red", 0.003)


@recipe("painting")
def painting(b: Builder) -> None:
    """A picture on a cream mount in a deep frame with golden edges, and a brass plate with its title."""
    w, d, h = b.w, b.d, b.h
    rim = min(w, h) * 0.09
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.2), (0, h), b.mat(), "back")
    _border(b, (0.0, rim), (-d * 0.3, d * 0.5), b.mat(), "frame")
    _border(b, (rim * 0.2, rim * 0.42), (d * 0.4, d * 0.5 + 0.0004), "metal_d9b45a", "frame")
    _border(b, (rim, rim * 1.35), (-d * 0.3, d * 0.2), "metal_d9b45a", "fillet")
    _border(b, (rim * 1.35, rim * 2.3), (-d * 0.3, -d * 0.02), "paper_f4eedd", "mount")
    inner = rim * 2.3
    x, z = (-w / 2 + inner, w / 2 - inner), (inner, h - inner)
    b.box(x, (-d * 0.2, -d * 0.05), z, _shown(b, str(b.p.get("face", "art"))), "face", solid=False)
    plate = DrawnFace.front(b, d / 2 - 0.001)
    plate.field((-w * 0.1, w * 0.1), (rim * 0.25, rim * 0.8), "metal_brass", "title", 0.0016)


def _border(b: Builder, rim: tuple[float, float], y: tuple[float, float], material: str, part: str) -> None:
    """Four bars from one distance to another within the outline of a picture."""
    w, h = b.w, b.h
    for side in (-1, 1):
        across = sorted((side * (w / 2 - rim[0]), side * (w / 2 - rim[1])))
        b.box((across[0], across[1]), y, (rim[0], h - rim[0]), material, part, solid=False)
    for low, high in (rim, (h - rim[1], h - rim[0])):
        b.box((-w / 2 + rim[1], w / 2 - rim[1]), y, (low, high), material, part, solid=False)


@recipe("tapestry")
def tapestry(b: Builder) -> None:
    """A woven cloth with borders, zigzags and diamonds, which hangs from a rod with knobs and ends in a fringe."""
    w, d, h = b.w, b.d, b.h
    r, cloth = d * 0.42, (h * 0.11, h * 0.965)
    rod = h - r - 0.002
    b.rod((-w / 2 + r, 0, rod), (w / 2 - r, 0, rod), r, "wood_walnut", "rod", 12)
    for x in (-w / 2 + r, w / 2 - r):
        b.ball((x, 0, rod), (r, d / 2, r * 1.2), "metal_brass", "knobs", 10)
    half = w * 0.45
    b.box((-half, half), (-0.004, 0.002), cloth, b.mat(), "cloth")
    for k in range(7):
        x = -half + (k + 0.5) * half / 3.5
        b.box((x - half * 0.05, x + half * 0.05), (-r, r), (cloth[1] - 0.01, h), b.mat(), "loops", solid=False)
    face = DrawnFace.front(b, 0.002)
    for low, high, color in (
        (0.0, 0.05, "fabric_2a3f6a"),
        (0.06, 0.075, "fabric_e8d9b0"),
        (0.925, 0.94, "fabric_e8d9b0"),
        (0.95, 1.0, "fabric_2a3f6a"),
    ):
        span = (cloth[0] + (cloth[1] - cloth[0]) * low, cloth[0] + (cloth[1] - cloth[0]) * high)
        face.field((-half, half), span, color, "bands")
    _woven_figures(face, half, cloth)
    for k in range(36):
        x = -half + (k + 0.5) * half / 18
        b.rod((x, 0, cloth[0] + 0.004), (x, 0, 0.0), w * 0.006, ("fabric_e8d9b0", "fabric_c9a24a")[k % 2], "fringe", 5)


def _woven_figures(face: DrawnFace, half: float, cloth: tuple[float, float]) -> None:
    """Stepped diamonds in three rows, as they are woven, and zigzags between them."""
    tall = cloth[1] - cloth[0]
    step = tall * 0.014
    for row, level in enumerate((0.22, 0.5, 0.78)):
        middle = cloth[0] + tall * level
        for column in range(3 if row != 1 else 2):
            u = half * (0.64 * (column - 1) if row != 1 else 0.64 * (column - 0.5))
            for size, color in ((7, "fabric_e8d9b0"), (5, "fabric_2a3f6a"), (3, "fabric_d9902d"), (1, "fabric_e8d9b0")):
                for k in range(-size + 1, size):
                    wide = (size - abs(k)) * step * 1.1
                    face.field(
                        (u - wide, u + wide),
                        (middle + (k - 0.5) * step, middle + (k + 0.5) * step),
                        color,
                        "diamonds",
                        0.001 + 0.0006 * (8 - size),
                    )
    for level in (0.36, 0.64):
        points = [(half * (k / 8 - 1), cloth[0] + tall * (level + (0.025 if k % 2 else -0.025))) for k in range(17)]
        face.line(points, tall * 0.009, "fabric_d9902d", "zigzags")


@recipe("door_sign")
def door_sign(b: Builder) -> None:
    """A plate beside a door with the number of its room, large, under the word ROOM, and two screws."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.003), (0, h), b.mat(), "plate")
    face = DrawnFace.front(b, d / 2 - 0.003)
    face.field((-w / 2 + 0.004, w / 2 - 0.004), (h * 0.7, h * 0.96), "plastic_1f3f6a", "band", 0.001)
    face.write("ROOM", (-w * 0.3, w * 0.3), (h * 0.745, h * 0.915), "plastic_white", "letters", 0.0022)
    face.write("204", (-w * 0.38, w * 0.38), (h * 0.12, h * 0.62), "plastic_1f3f6a", "number", 0.003)
    for u in (-w * 0.455, w * 0.455):
        face.disc(u, h * 0.36, w * 0.022, "metal_9ba0a5", "screws", 0.0025, 12)
