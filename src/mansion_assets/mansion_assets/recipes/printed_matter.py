"""Printed matter, told apart by what is on its covers and sheets."""

from mansion_assets.builder import Box, Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


_COVERS = ("paper_red", "paper_blue", "paper_green", "paper_brown", "paper_beige", "paper_orange")


@recipe("book")
def book(b: Builder) -> None:
    """Book lying flat, a stack, a row standing upright, or one folder."""
    w, d, h = b.w, b.d, b.h
    style = b.p.get("style")
    if style == "row":
        count = max(4, round(w / 0.03))
        for k in range(count):
            x0, high = -w / 2 + k * w / count, h * (1.0, 0.86, 0.93, 0.78, 0.97)[k % 5]
            b.box(
                (x0, x0 + w / count - 0.001),
                (-d / 2, d / 2 - 0.006 * (k % 3)),
                (0, high),
                _COVERS[(k * 5 + k // 3) % 6],
                "books",
                solid=False,
            )
        b.boxes.append(Box((0.0, 0.0, h / 2), (w, d, h)))
        return
    if style == "upright":
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h), b.mat(), "cover")
        b.box((-w * 0.3, w * 0.3), (d / 2 - 0.001, d / 2), (h * 0.4, h * 0.7), "paper_white", "label", solid=False)
        return
    count = int(b.p.get("stack", 1))
    for k in range(count):
        z0, z1 = h * k / count, h * (k + 1) / count
        shrink = 1.0 if count == 1 or k == 0 else 0.84 + 0.04 * (k % 3)
        cover = b.mat() if k == 0 else _COVERS[(k * 2 + 1) % 6]
        t = (z1 - z0) * 0.16
        x, y = (-w / 2 * shrink, w / 2 * shrink), (-d / 2 * shrink, d / 2 * shrink)
        b.box(x, y, (z0, z0 + t), cover, "cover", solid=False)
        b.box(x, y, (z1 - t, z1), cover, "cover", solid=False)
        b.box((x[0], x[0] + 0.004), y, (z0, z1), cover, "cover", solid=False)
        b.box(
            (x[0] + 0.003, x[1] - 0.004),
            (y[0] + 0.004, y[1] - 0.004),
            (z0 + t, z1 - t),
            "paper_light",
            "pages",
            solid=False,
        )
    b.boxes.append(Box((0.0, 0.0, h / 2), (w, d, h)))


def _columns(face: DrawnFace, u: tuple[float, float], v: tuple[float, float], rows: int) -> None:
    """Print lines of text into a rectangle."""
    step = (v[1] - v[0]) / rows
    for k in range(rows):
        low = v[0] + k * step
        face.field((u[0], u[1] - (u[1] - u[0]) * (0.35 if k == 0 else 0.0)), (low, low + step * 0.5), "paper_grey")


@recipe("newspaper")
def newspaper(b: Builder) -> None:
    """Folded sheets with a large heading, a picture and columns of text on the first page."""
    w, d, h = b.w, b.d, b.h
    for k, shift in enumerate((0.0, 0.012, 0.004)):
        b.box(
            (-w / 2 + shift * w, w / 2),
            (-d / 2, d / 2 - shift * d),
            (h * k / 3, h * (k + 0.8) / 3),
            "paper_d9d6cc",
            "sheets",
        )
    b.rod(
        (-w / 2 + 0.02 * w, -d / 2 + h * 0.4, h * 0.45),
        (w / 2, -d / 2 + h * 0.4, h * 0.45),
        h * 0.42,
        "paper_d9d6cc",
        "fold",
    )
    face = DrawnFace.top(b, h * 0.94)
    face.write("NEWS", (-w * 0.42, w * 0.42), (d * 0.2, d * 0.42), "paper_dark", "heading", h * 0.06)
    face.field((-w * 0.45, w * 0.45), (d * 0.15, d * 0.165), "paper_dark")
    face.field((-w * 0.45, w * 0.06), (-d * 0.22, d * 0.12), "picture_city", "picture")
    _columns(face, (w * 0.1, w * 0.45), (-d * 0.44, d * 0.11), 10)
    _columns(face, (-w * 0.45, -w * 0.22), (-d * 0.44, -d * 0.26), 4)
    _columns(face, (-w * 0.18, w * 0.06), (-d * 0.44, -d * 0.26), 4)


@recipe("magazine")
def magazine(b: Builder) -> None:
    """A thin glossy booklet: a picture fills its cover, with the title across it and a column of headlines."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.3), b.mat(), "cover")
    b.box((-w * 0.49, w / 2), (-d * 0.49, d * 0.49), (h * 0.3, h * 0.7), "paper_white", "pages")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.7, h * 0.9), b.mat(), "cover")
    face = DrawnFace.top(b, h * 0.9)
    face.field((-w * 0.49, w * 0.49), (-d * 0.49, d * 0.28), "picture_dusk", "picture", h * 0.03)
    face.write("STYLE", (-w * 0.45, w * 0.45), (d * 0.3, d * 0.47), "paper_white", "title", h * 0.1)
    for k in range(3):
        v = -d * 0.1 - 0.1 * d * k
        face.field((-w * 0.44, -w * 0.1 - w * 0.05 * k), (v, v + d * 0.035), "paper_yellow", "print", h * 0.1)
    face.field((w * 0.2, w * 0.44), (-d * 0.46, -d * 0.36), "paper_white", "code", h * 0.06)
    for k in range(5):
        u = w * (0.22 + 0.042 * k)
        face.field((u, u + w * 0.018), (-d * 0.445, -d * 0.375), "paper_black", "code", h * 0.1)


@recipe("hymn_book")
def hymn_book(b: Builder) -> None:
    """A bound book with a golden cross on its cover and a ribbon that hangs out of its pages."""
    w, d, h = b.w, b.d, b.h
    low = d * 0.46
    b.box((-w / 2, w / 2), (-d / 2, low), (0, h * 0.12), b.mat(), "cover")
    b.box(
        (-w / 2 + w * 0.03, w / 2 - w * 0.04),
        (-d / 2 + d * 0.02, low - d * 0.02),
        (h * 0.12, h * 0.84),
        "paper_brass",
        "pages",
    )
    b.box((w / 2 - w * 0.05, w / 2), (-d / 2, low), (h * 0.1, h * 0.86), b.mat(), "spine")
    b.box((-w / 2, w / 2), (-d / 2, low), (h * 0.84, h * 0.96), b.mat(), "cover")
    face = DrawnFace.top(b, h * 0.96)
    face.field((-w * 0.06, w * 0.06), (-d * 0.36, d * 0.38), "metal_brass", "cross", h * 0.04)
    face.field((-w * 0.26, w * 0.26), (d * 0.1, d * 0.19), "metal_brass", "cross", h * 0.04)
    b.box((w * 0.08, w * 0.15), (d * 0.3, d / 2), (h * 0.4, h * 0.46), "fabric_red", "ribbon", solid=False)


@recipe("notebook")
def notebook(b: Builder) -> None:
    """A pad between covers on a wire spiral, with a label and a pencil across it."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.55
    x = (-w / 2, w * 0.44)
    b.box(x, (-d / 2, d / 2), (0, top * 0.15), b.mat(), "cover")
    b.box((-w * 0.49, w * 0.44), (-d * 0.49, d * 0.49), (top * 0.15, top * 0.85), "paper_white", "pages")
    b.box(x, (-d / 2, d / 2), (top * 0.85, top), b.mat(), "cover")
    for k in range(15):
        y = -d * 0.45 + d * 0.9 * k / 14
        ring = [(w * 0.4, top), (w * 0.43, h * 0.9), (w * 0.48, top * 0.6), (w * 0.43, top * 0.05)]
        b.path([(u, y, v) for u, v in ring], w * 0.012, "metal_steel", "spiral")
    face = DrawnFace.top(b, top)
    face.field((-w * 0.24, w * 0.34), (d * 0.1, d * 0.34), "paper_white", "label", h * 0.03)
    for k in range(3):
        face.field(
            (-w * 0.18, w * 0.28), (d * (0.14 + 0.06 * k), d * (0.155 + 0.06 * k)), "paper_blue", "label", h * 0.05
        )
    b.rod(
        (w * 0.2, d * 0.16, top + w * 0.03),
        (-w * 0.36, d * 0.3, top + w * 0.03),
        w * 0.028,
        "paint_yellow",
        "pencil",
        6,
    )
    b.rod(
        (-w * 0.36, d * 0.3, top + w * 0.03),
        (-w * 0.43, d * 0.318, top + w * 0.03),
        w * 0.018,
        "wood_birch",
        "pencil",
        6,
    )


@recipe("sheet_music")
def sheet_music(b: Builder) -> None:
    """Open sheets with staves of five lines, and notes on them."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.35), "paper_white", "sheets")
    b.box((-w / 2, w * 0.47), (-d / 2, d * 0.49), (h * 0.35, h * 0.7), b.mat(), "sheets")
    face = DrawnFace.top(b, h * 0.7)
    step = d * 0.026
    for row in range(3):
        low = d * (0.2 - 0.3 * row)
        for k in range(5):
            face.field(
                (-w * 0.44, w * 0.44), (low + k * step, low + k * step + d * 0.005), "paper_black", "staves", h * 0.1
            )
        face.line(
            [(-w * 0.39, low - step), (-w * 0.37, low + 4.5 * step), (-w * 0.41, low + 3 * step)],
            w * 0.012,
            "paper_black",
            "clefs",
            h * 0.1,
        )
        face.disc(-w * 0.38, low + 1.4 * step, step * 1.2, "paper_black", "clefs", h * 0.2, 12)
        for k in range(7):
            u, v = w * (-0.28 + 0.11 * k), low + step * ((k * 3 + row * 2) % 5)
            face.disc(u, v, step * 0.95, "paper_black", "notes", h * 0.25, 10)
            face.field((u + step * 0.6, u + step * 0.95), (v, v + 3.6 * step), "paper_black", "notes", h * 0.25)
            if k % 2 and k < 6:
                face.field(
                    (u + step * 0.6, u + w * 0.11 + step * 0.95),
                    (v + 3.1 * step, v + 3.8 * step),
                    "paper_black",
                    "notes",
                    h * 0.3,
                )


@recipe("menu_card")
def menu_card(b: Builder) -> None:
    """A folded card that stands like a tent, with the word MENU, dishes and prices on it."""
    w, d, h = b.w, b.d, b.h
    t = d * 0.06
    for side in (-1, 1):
        board = [
            (side * d / 2, 0),
            (side * (d / 2 - t), 0),
            (side * 0.001, h - t),
            (side * 0.001, h),
            (side * t * 0.5, h),
        ]
        b.prism(board if side > 0 else board[::-1], (-w / 2, w / 2), b.mat(), part="card")
    face = DrawnFace.sloped(b, (d / 2, 0.0), (t * 0.5, h))
    ink = "paper_red" if "white" in b.mat() else "paper_white"
    dark = "paper_dark" if "white" in b.mat() else "paper_beige"
    face.write("MENU", (-w * 0.42, w * 0.42), (h * 0.68, h * 0.92), ink, "title", 0.001)
    face.field((-w * 0.42, w * 0.42), (h * 0.62, h * 0.64), ink)
    for k in range(5):
        v = h * (0.1 + 0.1 * k)
        face.field((-w * 0.4, w * (0.1 - 0.06 * (k % 2))), (v, v + h * 0.035), dark, "dishes", 0.001)
        face.field((w * 0.26, w * 0.4), (v, v + h * 0.035), ink, "prices", 0.001)
