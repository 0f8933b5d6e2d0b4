"""Rugs, and mats for prayer, naps, exercise and entrances."""

from mansion_assets.builder import Box, Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import Recipe, recipe

__all__: list[str] = []


def prayer_rug(b: Builder) -> None:
    """A rug with a pointed arch between columns, a lamp that hangs in it, a border of two colours, and fringed ends."""
    w, d, h = b.w, b.d, b.h
    gold, dark = "fabric_d9b85a", "fabric_2a2f4f"
    b.box((-w / 2, w / 2), (-d * 0.46, d * 0.46), (0, h * 0.5), b.mat(), "rug")
    for side in (-1, 1):
        for k in range(18):
            x = -w / 2 + w * (k + 0.5) / 18
            along = sorted((side * d * 0.46, side * d / 2))
            b.box(
                (x - w * 0.012, x + w * 0.012),
                (along[0], along[1]),
                (0, h * 0.3),
                "fabric_white",
                "fringe",
                solid=False,
            )
    face = DrawnFace.top(b, h * 0.5)
    for inset, color, level in ((0.04, gold, 0.1), (0.06, dark, 0.16), (0.12, gold, 0.22), (0.14, b.mat(), 0.28)):
        face.field(
            (-w * (0.5 - inset), w * (0.5 - inset)),
            (-d * (0.46 - inset * 0.7), d * (0.46 - inset * 0.7)),
            color,
            "border",
            h * level,
        )
    top = DrawnFace.top(b, h * 0.78)
    for side in (-1, 1):
        u = sorted((side * w * 0.3, side * w * 0.24))
        top.field((u[0], u[1]), (-d * 0.34, d * 0.1), gold, "arch", h * 0.1)
    arch = [(0.3, 0.1), (0.3, 0.16), (0.2, 0.26), (0.0, 0.36), (-0.2, 0.26), (-0.3, 0.16), (-0.3, 0.1)]
    b.prism([(-u * w, -v * d) for u, v in arch], (h * 0.78, h * 0.88), gold, "z", "arch")
    inner = [(0.24, 0.1), (0.24, 0.15), (0.16, 0.23), (0.0, 0.31), (-0.16, 0.23), (-0.24, 0.15), (-0.24, 0.1)]
    b.prism([(-u * w, -v * d) for u, v in inner], (h * 0.8, h * 0.92), dark, "z", "arch")
    top.field((-w * 0.24, w * 0.24), (-d * 0.34, d * 0.1), dark, "arch", h * 0.14)
    top.field((-w * 0.008, w * 0.008), (d * 0.12, d * 0.3), gold, "lamp", h * 0.2)
    top.disc(0, d * 0.08, w * 0.07, gold, "lamp", h * 0.2)
    top.field((-w * 0.05, w * 0.05), (-d * 0.02, d * 0.02), gold, "lamp", h * 0.2)


def exercise_mat(b: Builder) -> None:
    """A long plain mat with the figure of somebody who sits with crossed legs, and a line along its middle."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.7), b.mat(), "mat")
    face, ink = DrawnFace.top(b, h * 0.7), "plastic_eef2f5"
    s, z = w * 0.4, (h * 0.7, h * 0.9)
    face.disc(0, s * 0.95, s * 0.2, ink, "figure", h * 0.2, 18)
    b.prism(
        [(-s * 0.22, -s * 0.66), (s * 0.22, -s * 0.66), (s * 0.14, s * 0.3), (-s * 0.14, s * 0.3)],
        z,
        ink,
        "z",
        "figure",
    )
    for side in (-1, 1):
        for bone in (
            [(0.1, -0.66), (0.3, -0.62), (0.68, 0.0), (0.56, 0.04)],
            [(0.56, 0.04), (0.68, 0.0), (0.86, 0.22), (0.78, 0.3)],
            [(0.0, 0.26), (0.1, 0.26), (0.95, 0.5), (0.86, 0.6), (0.0, 0.44)],
            [(0.86, 0.46), (0.9, 0.62), (-0.16, 0.8), (-0.2, 0.66)],
        ):
            b.prism([(side * u * s, v * s) for u, v in bone], z, ink, "z", "figure", solid=False)
    for v in ((-d * 0.46, -d * 0.28), (d * 0.28, d * 0.46)):
        face.field((-w * 0.012, w * 0.012), v, ink, "line", h * 0.2)
        face.field((-w * 0.3, w * 0.3), (v[0], v[0] + d * 0.006), ink, "line", h * 0.2)


def welcome_mat(b: Builder) -> None:
    """A mat of bristle with WELCOME in dark letters within a border."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.7), "fabric_a87b4a" if "brown" in b.mat() else b.mat(), "mat")
    ink = "fabric_2f2a26" if "dark" not in b.mat() and "black" not in b.mat() else "fabric_beige"
    face = DrawnFace.top(b, h * 0.7)
    e = min(w, d) * 0.06
    for u, v in (
        ((-w / 2 + e, w / 2 - e), (-d / 2 + e, -d / 2 + 1.6 * e)),
        ((-w / 2 + e, w / 2 - e), (d / 2 - 1.6 * e, d / 2 - e)),
        ((-w / 2 + e, -w / 2 + 1.6 * e), (-d / 2 + e, d / 2 - e)),
        ((w / 2 - 1.6 * e, w / 2 - e), (-d / 2 + e, d / 2 - e)),
    ):
        face.field(u, v, ink, "border", h * 0.2)
    face.write("WELCOME", (-w * 0.38, w * 0.38), (-d * 0.22, d * 0.22), ink, "letters", h * 0.3)


@recipe("rug")
def rug(b: Builder) -> None:
    """Rug with a border, round or rectangular; mats of tiles, or with a picture or a word on them."""
    drawn = _DRAWN.get(str(b.p.get("style", "")))
    if drawn is not None:
        drawn(b)
        return
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    other = "fabric_light" if main != "fabric_white" else "fabric_grey"
    if b.p.get("shape") == "round":
        b.lathe([(0.5, 0), (0.5, h * 0.8)], main, stretch=(w, d), n=36)
        b.lathe([(0.42, h * 0.7), (0.42, h * 0.9)], other, stretch=(w, d), part="border", n=36, solid=False)
        b.lathe([(0.38, h * 0.7), (0.38, h)], main, stretch=(w, d), part="field", n=36, solid=False)
    elif b.p.get("style") == "tiles":
        cols, rows = max(2, round(w / 0.5)), max(2, round(d / 0.5))
        for i in range(cols):
            for j in range(rows):
                x, y = -w / 2 + i * w / cols, -d / 2 + j * d / rows
                color = (
                    main
                    if main.startswith("rubber") and (i + j) % 2
                    else ("fabric_yellow", "fabric_red", main)[(i + 2 * j) % 3]
                    if not main.startswith("rubber")
                    else "rubber_red"
                )
                b.box((x, x + w / cols), (y, y + d / rows), (0, h), color, "tiles", solid=False)
        b.boxes.append(Box((0.0, 0.0, h / 2), (w, d, h)))
    else:
        e = min(w, d) * 0.07
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.8), main, "base")
        b.box((-w / 2 + e, w / 2 - e), (-d / 2 + e, d / 2 - e), (h * 0.7, h * 0.9), other, "border", solid=False)
        b.box(
            (-w / 2 + 1.6 * e, w / 2 - 1.6 * e),
            (-d / 2 + 1.6 * e, d / 2 - 1.6 * e),
            (h * 0.7, h),
            main,
            "field",
            solid=False,
        )


_DRAWN: dict[str, Recipe] = {"exercise": exercise_mat, "prayer": prayer_rug, "welcome": welcome_mat}
"""Styles of rugs with something drawn on them."""


@recipe("nap_mat")
def nap_mat(b: Builder) -> None:
    """A thin mat in four padded sections of two colours, with a small pillow."""
    w, d, h = b.w, b.d, b.h
    face = b.tops[0].z
    for k in range(4):
        y0 = -d / 2 + k * d / 4
        b.cushion((-w / 2, w / 2), (y0, y0 + d / 4), (0, face), (b.mat(), "fabric_red")[k % 2], "sections", 0.5)
    b.cushion((-w * 0.36, w * 0.36), (-d * 0.48, -d * 0.29), (face * 0.9, h), "fabric_white", "pillow", 0.7, 12)
