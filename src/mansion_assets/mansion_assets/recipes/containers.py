"""Round containers by the name of their profile: bottles, cups, jars; bowls of fruit."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


Profile = tuple[tuple[float, float], ...]


_PROFILES: dict[str, Profile] = {
    "bottle": ((0.48, 0), (0.5, 0.03), (0.5, 0.58), (0.2, 0.76), (0.17, 0.92), (0.2, 0.93), (0.2, 1)),
    "bowl": ((0.25, 0), (0.28, 0.06), (0.44, 0.55), (0.5, 1), (0.46, 1), (0.36, 0.4), (0.2, 0.14)),
    "vase": (
        (0.3, 0),
        (0.34, 0.05),
        (0.5, 0.4),
        (0.38, 0.7),
        (0.24, 0.85),
        (0.32, 1),
        (0.28, 1),
        (0.2, 0.85),
        (0.2, 0.5),
    ),
    "pump": (
        (0.48, 0),
        (0.5, 0.05),
        (0.5, 0.6),
        (0.25, 0.72),
        (0.22, 0.8),
        (0.08, 0.81),
        (0.08, 0.93),
        (0.3, 0.94),
        (0.3, 1),
    ),
    "shaker": ((0.46, 0), (0.5, 0.08), (0.36, 0.7), (0.4, 0.74), (0.38, 0.92), (0.2, 1)),
    "roll": ((0.5, 0), (0.5, 1), (0.18, 1), (0.18, 0.9)),
    "brush": ((0.46, 0), (0.5, 0.04), (0.42, 0.32), (0.12, 0.34), (0.1, 0.95), (0.14, 0.97), (0.1, 1)),
    "plunger": ((0.5, 0), (0.46, 0.1), (0.3, 0.2), (0.1, 0.25), (0.07, 0.3), (0.07, 0.97), (0.05, 1)),
    "flask": ((0.5, 0), (0.5, 0.04), (0.2, 0.68), (0.17, 0.95), (0.2, 1), (0.16, 1), (0.13, 0.7)),
    "barrel": (
        (0.44, 0),
        (0.45, 0.02),
        (0.49, 0.3),
        (0.5, 0.33),
        (0.48, 0.36),
        (0.48, 0.64),
        (0.5, 0.67),
        (0.49, 0.7),
        (0.45, 0.98),
        (0.42, 1),
        (0.42, 0.97),
    ),
    "cone": ((0.5, 0), (0.5, 0.05), (0.36, 0.06), (0.08, 0.97), (0.05, 1)),
    "tires": (
        (0.42, 0),
        (0.5, 0.05),
        (0.5, 0.28),
        (0.42, 0.33),
        (0.5, 0.38),
        (0.5, 0.61),
        (0.42, 0.66),
        (0.5, 0.71),
        (0.5, 0.95),
        (0.42, 1),
        (0.26, 0.98),
        (0.26, 0.7),
    ),
    "bucket": ((0.36, 0), (0.48, 0.97), (0.5, 1), (0.46, 1), (0.34, 0.04)),
    "reel": ((0.5, 0), (0.5, 0.1), (0.3, 0.12), (0.3, 0.88), (0.5, 0.9), (0.5, 1), (0.12, 1), (0.12, 0.9)),
    "trophy": ((0.4, 0), (0.4, 0.12), (0.1, 0.16), (0.08, 0.4), (0.4, 0.6), (0.5, 1), (0.45, 1), (0.3, 0.6)),
}


_BANDS = {
    "bottle": ("paper_white", 0.2, 0.48, 0.504),
    "cone": ("plastic_white", 0.4, 0.55, 0.29),
    "pump": ("paper_white", 0.2, 0.5, 0.505),
}


@recipe("lathe")
def lathe(b: Builder) -> None:
    """A body of revolution by the name of its profile."""
    name = str(b.p["profile"])
    profile = [(r, z * b.h) for r, z in _PROFILES[name]]
    n = 28 if max(b.w, b.d) > 0.25 else 16
    b.lathe(profile, b.mat(), n=n, stretch=(b.w, b.d))
    if name in _BANDS:
        color, z0, z1, r = _BANDS[name]
        b.lathe(
            [(r, z0 * b.h), (r * (0.8 if name == "cone" else 1.0), z1 * b.h)],
            color,
            n=n,
            stretch=(b.w * 0.99, b.d * 0.99),
            part="label",
            solid=False,
        )


@recipe("fruit_bowl")
def fruit_bowl(b: Builder) -> None:
    """Bowl heaped with fruit."""
    low = b.h * 0.6
    b.lathe([(r, z * low) for r, z in _PROFILES["bowl"]], b.mat(), n=24, stretch=(b.w, b.d))
    r = b.w * 0.14
    for k, (x, y, color) in enumerate(
        (
            (-0.2, -0.1, "red"),
            (0.15, -0.18, "orange"),
            (0.02, 0.2, "green"),
            (0.22, 0.1, "red"),
            (-0.18, 0.16, "orange"),
        )
    ):
        b.ball((x * b.w, y * b.d, low * 0.85 + 0.004 * k), (r, r, r), f"food_{color}", "fruit", 10, solid=False)
    b.ball((0, 0, b.h - r), (r, r, r), "food_yellow", "fruit", 10, solid=False)


@recipe("labelled_jar")
def labelled_jar(b: Builder) -> None:
    """A jar of glass with a lid and a label: SUGAR in white cubes, or JAM, red."""
    w, d, h = b.w, b.d, b.h
    jam = b.p.get("content") == "jam"
    body = h * 0.78
    b.lathe(
        [(0.42, 0.0), (0.46, h * 0.04), (0.46, body * 0.86), (0.36, body)],
        "food_c8203a" if jam else "food_f7f3ea",
        stretch=(w, d),
        part="content",
        n=22,
    )
    b.lathe(
        [(0.46, 0.0), (0.5, h * 0.04), (0.5, body * 0.88), (0.4, body)],
        "glass_clear",
        stretch=(w, d),
        part="glass",
        n=22,
    )
    if jam:
        _jar_cloth(b, body)
    else:
        b.lathe(
            [(0.44, body), (0.46, h * 0.82), (0.46, h * 0.9), (0.12, h * 0.92), (0.14, h), (0.1, h)],
            "wood_oak",
            stretch=(w, d),
            part="lid",
            n=20,
        )
    _jar_label(b, body, jam=jam)
    if not jam:
        _sugar_cubes(b, body)


def _jar_cloth(b: Builder, body: float) -> None:
    """A checked cloth over the lid, tied with a string."""
    w, d, h = b.w, b.d, b.h
    b.lathe(
        [(0.54, body * 0.94), (0.46, h * 0.86), (0.44, h * 0.97), (0.3, h)],
        "fabric_red",
        stretch=(w, d),
        part="cloth",
        n=18,
    )
    for k in range(9):
        a = k * math.tau / 9
        b.rod(
            (math.cos(a) * w * 0.5, math.sin(a) * d * 0.5, body * 0.97),
            (math.cos(a) * w * 0.36, math.sin(a) * d * 0.36, h * 0.985),
            w * 0.025,
            "fabric_white",
            "checks",
            5,
        )
    b.lathe([(0.475, h * 0.84), (0.475, h * 0.87)], "fabric_beige", stretch=(w, d), part="string", n=18)


def _sugar_cubes(b: Builder, body: float) -> None:
    """Seven cubes of sugar on top of the others."""
    w, d = b.w, b.d
    for k in range(7):
        a, z = k * 0.9, body * (0.84 + 0.03 * (k % 2))
        s = w * 0.07
        x, y = math.cos(a) * w * 0.26, math.sin(a) * d * 0.26
        b.box((x - s, x + s), (y - s, y + s), (z - s, z + s), "plastic_white", "cubes", solid=False)


def _jar_label(b: Builder, body: float, *, jam: bool) -> None:
    """A label on the front and on a side: SUGAR, or JAM with a strawberry."""
    w, d = b.w, b.d
    word = "JAM" if jam else "SUGAR"
    for face, half in ((DrawnFace.front(b, d * 0.49), w * 0.34), (DrawnFace.side(b, w * 0.49), d * 0.34)):
        face.field((-half, half), (body * 0.2, body * 0.78), "paper_f7f0dc", "label", w * 0.02)
        face.write(
            word,
            (-half * 0.9, half * 0.9),
            (body * (0.5 if jam else 0.36), body * (0.74 if jam else 0.6)),
            "paper_red" if jam else "paper_2f5fa8",
            "letters",
            w * 0.03,
        )
        if jam:
            face.disc(0, body * 0.35, half * 0.26, "paper_d8281e", "fruit", w * 0.03, 12)
            face.field((-half * 0.2, half * 0.2), (body * 0.42, body * 0.46), "paper_green", "fruit", w * 0.034)
