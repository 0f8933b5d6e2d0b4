"""What hangs on walls, and rugs."""

from mansion_scene.assets.builder import Builder
from mansion_scene.assets.registry import recipe

__all__: list[str] = []


_ART = (
    ("paper_beige", "paper_blue", "paper_orange", "paper_dark"),
    ("paper_white", "paper_red", "paper_yellow", "paper_green"),
    ("paper_light", "paper_green", "paper_blue", "paper_brown"),
)


def _face(b: Builder, face: str, x: tuple[float, float], z: tuple[float, float], y: float) -> None:
    """What a panel shows, flat on its front at `y`."""
    w, h = x[1] - x[0], z[1] - z[0]
    thin = 0.0015
    if face not in ("art", "map"):
        b.box(x, (y - thin, y), z, face, "face", False)
        return
    key = sum(ord(c) for c in b.mat()) + round(1000 * (b.w + b.h))
    colors = (
        _ART[key % 3]
        if face == "art"
        else ("paper_blue", "paper_green", "paper_beige", "paper_green")
    )
    b.box(x, (y - 2 * thin, y - thin), z, colors[0], "face", False)
    for k in range(5):
        u, v = ((key * (k + 3)) % 17) / 17 * 0.6, ((key * (k + 5)) % 13) / 13 * 0.6
        bw, bh = (0.15 + 0.25 * ((key + k) % 3) / 2), (0.12 + 0.2 * ((key + 2 * k) % 3) / 2)
        patch = (
            (x[0] + u * w, x[0] + min(0.96, u + bw) * w),
            (z[0] + v * h, z[0] + min(0.96, v + bh) * h),
        )
        b.box(
            patch[0],
            (y - thin, y - thin * 0.5 + 0.0001 * k),
            patch[1],
            colors[1 + k % 3],
            "face",
            False,
        )


@recipe("panel")
def panel(b: Builder) -> None:
    """Framed face: picture, mirror, board; on an easel, a rolling stand or a post; a roller screen."""
    w, d, h = b.w, b.d, b.h
    style, face = b.p.get("style"), str(b.p.get("face", "paper_white"))
    rim = min(float(b.p.get("rim", 0.03)), w * 0.1)
    y0, y1, z0, z1 = -d / 2, d / 2, 0.0, h
    if style == "stand":
        for sx in (-1, 1):
            x = sx * (w / 2 - 0.06)
            b.box((x - 0.02, x + 0.02), (-d / 2, d / 2), (0.05, 0.08), b.mat(), "feet")
            b.box((x - 0.02, x + 0.02), (-0.04, 0.0), (0.06, h), b.mat(), "posts")
        b.wheels(0.03, 0.06)
        y0, y1, z0 = -0.02, 0.02, h * 0.42
    elif style in ("easel", "aframe"):
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
        b.rod(
            (0, -d / 2 + 0.01, 0.0),
            (0, d / 2 - lean, h * 0.92),
            0.012 if h > 0.4 else 0.005,
            b.mat(),
            "leg",
            solid=True,
        )
        low = h * (0.38 if h > 1.0 and face != "glass_mirror" else 0.06)
        s0, s1 = d / 2 - lean * low / h, d / 2 - lean * 0.97
        b.prism(
            [(s0, low), (s0 + 0.006, low), (s1 + 0.006, h * 0.97), (s1, h * 0.97)],
            (-w / 2 + rim, w / 2 - rim),
            face if face not in ("art", "map") else "paper_white",
            part="face",
        )
        if face == "art":
            b.prism(
                [
                    (s0 + 0.004, low + 0.1),
                    (s0 + 0.0085, low + 0.1),
                    ((s0 + s1) / 2 + 0.0085, (low + h) / 2),
                    ((s0 + s1) / 2 + 0.004, (low + h) / 2),
                ],
                (-w * 0.25, w * 0.2),
                "paper_blue",
                part="paint",
                solid=False,
            )
        return
    elif style == "post":
        b.cyl(0, 0, (0, 0.02), min(w, d) / 2, b.mat(), "foot", n=20)
        b.cyl(0, -0.02, (0.01, h * 0.7), 0.018, b.mat(), "post")
        y0, y1, z0 = -0.02, 0.015, h * 0.6
    elif style == "roll":
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.1, h), b.mat(), "case")
        b.box((-w / 2 + 0.04, w / 2 - 0.04), (-0.004, 0.004), (0, h - 0.1), face, "screen")
        b.box(
            (-w / 2 + 0.03, w / 2 - 0.03),
            (-0.012, 0.012),
            (0, 0.025),
            "plastic_black",
            "bar",
            False,
        )
        return
    b.box((-w / 2, w / 2), (y0, y1 - 0.008 if d > 0.02 else y1 - 0.004), (z0, z1), b.mat(), "back")
    for side in ((-w / 2, -w / 2 + rim), (w / 2 - rim, w / 2)):
        b.box(side, (y0, y1), (z0, z1), b.mat(), "frame", False)
    for level in ((z0, z0 + rim), (z1 - rim, z1)):
        b.box((-w / 2, w / 2), (y0, y1), level, b.mat(), "frame", False)
    _face(
        b,
        face,
        (-w / 2 + rim, w / 2 - rim),
        (z0 + rim, z1 - rim),
        y1 - (0.004 if d > 0.02 else 0.001),
    )
    if b.p.get("tray"):
        b.box((-w * 0.3, w * 0.3), (y1 - 0.03, y1), (0, 0.015), "metal_steel", "tray", False)
    if b.p.get("notes"):
        for k in range(8):
            x, z = -w * 0.4 + (k % 4) * w * 0.22, h * (0.2 if k < 4 else 0.58)
            b.box(
                (x, x + w * 0.14),
                (y1 - 0.004, y1 - 0.002),
                (z, z + h * 0.24),
                ("paper_white", "paper_yellow", "paper_blue", "paper_pink")[k % 4],
                "notes",
                False,
            )


@recipe("wall_box")
def wall_box(b: Builder) -> None:
    """Boxes on walls: switches, dispensers, dryers, cabinets, air conditioners."""
    w, d, h = b.w, b.d, b.h
    style, main = b.p.get("style", "plain"), b.mat()
    body = d * (0.9 if style in ("button", "socket", "cross", "door", "slot", "sockets") else 1.0)
    if style == "nozzle":
        b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.015), (h * 0.15, h), main, "case")
        b.box((-w * 0.15, w * 0.15), (-0.02, d / 2), (0, h * 0.2), "plastic_grey", "nozzle")
        b.box(
            (-w * 0.4, w * 0.4),
            (d / 2 - 0.016, d / 2 - 0.01),
            (h * 0.45, h * 0.85),
            "plastic_grey",
            "window",
            False,
        )
        return
    if style == "fold":
        b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.1), (0, h), main, "back")
        b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.1, d / 2), (0, 0.06), main, "table")
        b.box(
            (-w / 2 + 0.1, w / 2 - 0.1),
            (-d / 2 + 0.1, d / 2 - 0.05),
            (0.06, 0.075),
            "rubber_grey",
            "pad",
            False,
        )
        return
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + body), (0, h), main, "case")
    y = (-d / 2 + body, d / 2)
    if style == "button":
        b.box(
            (-w * 0.28, w * 0.28),
            y,
            (h * 0.28, h * 0.72),
            "plastic_light" if main != "plastic_white" else "plastic_grey",
            "button",
            False,
        )
    elif style == "socket":
        b.rod((0, y[0], h / 2), (0, y[1], h / 2), w * 0.34, "plastic_grey", "socket", 20)
    elif style == "sockets":
        for k in range(6):
            x = -w * 0.42 + k * w * 0.168
            b.box(
                (x - 0.04, x + 0.04),
                y,
                (h * 0.3, h * 0.7),
                (
                    "plastic_blue",
                    "plastic_green",
                    "plastic_grey",
                    "light_white",
                    "plastic_grey",
                    "plastic_red",
                )[k],
                "sockets",
                False,
            )
    elif style == "cross":
        other = "plastic_white" if main != "plastic_white" else "plastic_green"
        b.box((-w * 0.3, w * 0.3), y, (h * 0.42, h * 0.58), other, "cross", False)
        b.box((-w * 0.09, w * 0.09), y, (h * 0.24, h * 0.76), other, "cross", False)
    elif style == "door":
        b.box(
            (-w * 0.44, w * 0.44),
            (y[0], y[0] + 0.4 * (y[1] - y[0])),
            (h * 0.05, h * 0.95),
            main,
            "door",
            False,
        )
        b.box((w * 0.32, w * 0.36), y, (h * 0.4, h * 0.6), "metal_steel", "handle", False)
        b.box(
            (-w * 0.2, w * 0.1),
            (y[0], y[0] + 0.5 * (y[1] - y[0])),
            (h * 0.6, h * 0.8),
            "paper_white",
            "label",
            False,
        )
    elif style == "slot":
        b.box((-w * 0.35, w * 0.35), y, (h * 0.05, h * 0.12), "plastic_black", "slot", False)
    elif style == "vent":
        for k in range(4):
            z = h * (0.08 + 0.07 * k)
            b.box(
                (-w * 0.42, w * 0.42),
                (d / 2 - 0.003, d / 2),
                (z, z + h * 0.03),
                "plastic_dark",
                "slats",
                False,
            )
        b.box(
            (w * 0.3, w * 0.4),
            (d / 2 - 0.003, d / 2),
            (h * 0.75, h * 0.82),
            "light_green",
            "led",
            False,
        )


@recipe("wall_shelf")
def wall_shelf(b: Builder) -> None:
    """Board on two brackets, its upper face at the top."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.025, h), b.mat(), "board")
    for sx in (-1, 1):
        x = sx * w * 0.36
        b.box(
            (x - 0.01, x + 0.01),
            (-d / 2, -d / 2 + 0.012),
            (0, h - 0.025),
            "metal_black",
            "brackets",
        )
        b.rod(
            (x, -d / 2 + 0.01, 0.01), (x, d / 2 - 0.03, h - 0.03), 0.007, "metal_black", "brackets"
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
        False,
    )
    b.box(
        (w * 0.25, w * 0.42), (d / 2 - 0.002, d / 2), (z1 * 0.42, z1 * 0.58), light, "arrow", False
    )
    b.box(
        (-w * 0.4, -w * 0.1), (d / 2 - 0.002, d / 2), (z1 * 0.2, z1 * 0.8), light, "symbol", False
    )
