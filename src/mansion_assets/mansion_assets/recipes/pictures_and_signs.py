"""Pictures, mirrors, boards and signs, on walls and on stands."""

import zlib

from mansion_assets.builder import Builder
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
    low = h * (0.38 if h > 1.0 and face != "glass_mirror" else 0.06)
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
