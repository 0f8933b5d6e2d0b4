"""Counters of shops, receptions, canteens and bars."""

from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, inset, surface
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@receptacles("counter", "bar_counter", "sales_counter")
def _counter_tops(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    ledge = float(p.get("ledge", 0.0))
    if ledge <= 0.0:
        return [surface("top", inset(size, 0.03), h, 1.0)]
    work = (-w / 2 + 0.05, w / 2 - 0.05, -d / 2 + 0.03, d / 2 - 0.32)
    raised = (-w / 2 + 0.02, w / 2 - 0.02, d / 2 - 0.28, d / 2 - 0.02)
    return [surface("top", work, h - ledge, 1.0), surface("ledge", raised, h, 1.0)]


@recipe("counter")
def counter(b: Builder) -> None:
    """Closed front with a worktop; reception desks with a raised ledge towards the visitor."""
    if b.p.get("style") == "buffet":
        _buffet(b)
        return
    tops = b.tops
    work = tops[0].z if tops else b.h
    _closed_front(b, work, 0.3 if len(tops) > 1 else 0.05)
    if len(tops) > 1:
        _reception(b, work)
    else:
        _worktop(b)


def _buffet(b: Builder) -> None:
    """Steel buffet with food under a glass guard and a tray rail."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    b.box((-w / 2, w / 2), (-d / 2 + 0.05, d / 2 - 0.2), (0.08, 0.88), main, "body")
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.15), (0.88, 0.92), "metal_steel", "top")
    for z in (0.84, 0.88):
        b.rod(
            (-w / 2, d / 2 - 0.03 - (z - 0.84), z), (w / 2, d / 2 - 0.03 - (z - 0.84), z), 0.012, "metal_steel", "rail"
        )
    b.rod((-w / 2, d / 2 - 0.012, 0.86), (w / 2, d / 2 - 0.012, 0.86), 0.012, "metal_steel", "rail")
    count = max(2, round(w / 0.6))
    for k in range(count):
        x = -w / 2 + (k + 0.5) * w / count
        b.box(
            (x - 0.22, x + 0.22),
            (-d / 2 + 0.1, d / 2 - 0.28),
            (0.92, 0.935),
            ("food_brown", "food_green", "food_orange")[k % 3],
            "food",
            solid=False,
        )
    for x in (-w / 2 + 0.05, w / 2 - 0.05):
        b.box((x - 0.02, x + 0.02), (-0.12, -0.08), (0.92, h), "metal_steel", "posts", solid=False)
    b.prism(
        [(-0.2, h), (-0.2, h - 0.02), (d / 2 - 0.18, h - 0.18), (d / 2 - 0.18, h - 0.16)],
        (-w / 2, w / 2),
        "glass_clear",
        part="guard",
        solid=False,
    )


def _closed_front(b: Builder, work: float, back: float) -> None:
    """Body on a plinth, up to the worktop and `back` from the rear."""
    w, d = b.w, b.d
    main = b.mat()
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2 + back, d / 2 - 0.04), (0, work - 0.04), main, "body")
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (d / 2 - 0.05, d / 2 - 0.03), (0, 0.06), "metal_dark", "plinth", solid=False)


def _reception(b: Builder, work: float) -> None:
    """Sides, worktop and a lit front under a ledge."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    for x in (-w / 2 + 0.02, w / 2 - 0.02):
        b.box((x - 0.02, x + 0.02), (-d / 2, d / 2 - 0.03), (0, h - 0.04), main, "sides")
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.27), (work - 0.03, work), "wood_white", "top")
    b.box((-w / 2, w / 2), (d / 2 - 0.07, d / 2 - 0.03), (0, h - 0.04), main, "front")
    b.box((-w / 2, w / 2), (d / 2 - 0.3, d / 2), (h - 0.04, h), b.mat("top", "stone_white"), "ledge")
    b.box(
        (-w / 2 + 0.02, w / 2 - 0.02),
        (d / 2 - 0.03, d / 2 - 0.02),
        (h * 0.45, h * 0.5),
        "light_white",
        "strip",
        solid=False,
    )


def _worktop(b: Builder) -> None:
    """Worktop over a row of panels."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    style = b.p.get("style")
    b.box(
        (-w / 2, w / 2),
        (-d / 2, d / 2),
        (h - 0.045, h),
        b.mat("top", "stone_grey" if style != "altar" else "stone_white"),
        "top",
    )
    count = max(2, round(w / 0.6))
    for k in range(count):
        x0 = -w / 2 + 0.05 + k * (w - 0.1) / count
        b.box(
            (x0 + 0.02, x0 + (w - 0.1) / count - 0.02),
            (d / 2 - 0.04, d / 2 - 0.025),
            (0.12, h - 0.12),
            main,
            "panels",
            solid=False,
        )


@recipe("bar_counter")
def bar_counter(b: Builder) -> None:
    """A panelled front under an overhanging top with a brass rail for the feet, the word BAR, and signs of drinks."""
    w, d, h = b.w, b.d, b.h
    front = d / 2 - 0.2
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.04, front), (0, h - 0.06), b.mat(), "body")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.06, h), b.mat("top", "wood_c98a4a"), "top")
    b.rod(
        (-w / 2 + 0.002, d / 2 - 0.03, h - 0.06),
        (w / 2 - 0.002, d / 2 - 0.03, h - 0.06),
        0.03,
        "wood_c98a4a",
        "top",
        12,
    )
    b.rod((-w / 2 + 0.03, d / 2 - 0.05, 0.2), (w / 2 - 0.03, d / 2 - 0.05, 0.2), 0.028, "metal_brass", "foot_rail", 12)
    posts = max(2, round(w / 0.8)) + 1
    for k in range(posts):
        x = -w / 2 + 0.1 + k * (w - 0.2) / (posts - 1)
        b.path([(x, front, 0.28), (x, d / 2 - 0.05, 0.2), (x, d / 2 - 0.05, 0.0)], 0.014, "metal_brass", "foot_rail")
    face = DrawnFace.front(b, front)
    face.field((-w / 2 + 0.02, w / 2 - 0.02), (0.0, 0.1), "metal_dark", "plinth", 0.01)
    third = (w - 0.1) / 3
    for k in range(3):
        u = (k - 1) * third
        face.field((u - third * 0.47, u + third * 0.47), (0.3, h - 0.14), "wood_3a2416", "panels", 0.01)
    sign = (0.36, h - 0.2)
    face.write("BAR", (-third * 0.42, third * 0.42), sign, "light_ffd27a", "letters", 0.03)
    _beer_mug(face, -third, sign)
    _cocktail(face, third, sign)


def _beer_mug(face: DrawnFace, u: float, v: tuple[float, float]) -> None:
    """The sign of a mug of beer with its handle and a head of foam."""
    tall = v[1] - v[0]
    r = tall * 0.3
    face.field((u - r, u + r), (v[0], v[0] + tall * 0.74), "plastic_f0a818", "beer", 0.03)
    for k in (-0.6, 0.0, 0.6):
        face.field(
            (u + r * (k - 0.08), u + r * (k + 0.08)),
            (v[0] + tall * 0.1, v[0] + tall * 0.6),
            "plastic_fbd774",
            "beer",
            0.034,
        )
    for k in (-0.8, -0.3, 0.3, 0.8):
        face.disc(u + r * k, v[0] + tall * 0.78, r * 0.42, "plastic_white", "foam", 0.036, 14)
    grip = [
        (u + r, v[0] + tall * 0.6),
        (u + r * 1.6, v[0] + tall * 0.54),
        (u + r * 1.6, v[0] + tall * 0.2),
        (u + r, v[0] + tall * 0.14),
    ]
    face.line(grip, r * 0.13, "plastic_fbd774", "handle", 0.014)


def _cocktail(face: DrawnFace, u: float, v: tuple[float, float]) -> None:
    """The sign of a cocktail glass with an olive on a stick."""
    tall = v[1] - v[0]
    r, bowl = tall * 0.42, v[0] + tall * 0.42
    rim = v[0] + tall * 0.86
    for k in range(8):
        low, high = bowl + (rim - bowl) * k / 8, bowl + (rim - bowl) * (k + 1) / 8
        half = r * (k + 1) / 8
        face.field((u - half, u + half), (low, high), "plastic_f2f6fa" if k == 7 else "plastic_e8486a", "glass", 0.03)
    face.field((u - r * 0.06, u + r * 0.06), (v[0], bowl), "plastic_f2f6fa", "glass", 0.03)
    face.field((u - r * 0.55, u + r * 0.55), (v[0], v[0] + tall * 0.06), "plastic_f2f6fa", "glass", 0.03)
    face.line([(u, bowl + tall * 0.2), (u + r * 0.9, v[1])], r * 0.04, "metal_brass", "stick", 0.034)
    face.disc(u + r * 0.3, bowl + tall * 0.32, r * 0.16, "plastic_6fae3a", "olive", 0.04, 12)


@recipe("sales_counter")
def sales_counter(b: Builder) -> None:
    """A counter of a shop whose front says PAY HERE, with a full shopping bag and the signs of cards on it."""
    w, d, h = b.w, b.d, b.h
    _closed_front(b, h, 0.05)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h - 0.045, h - 0.002), b.mat("top", "stone_grey"), "top")
    top = DrawnFace.top(b, h - 0.002)
    top.field((-w * 0.06, w * 0.4), (-d * 0.36, d * 0.36), "rubber_26272b", "belt", 0.001)
    for k in range(3):
        u = w * (0.04 + 0.14 * k)
        top.field((u - 0.01, u + 0.01), (-d * 0.36, d * 0.36), "rubber_4a4c52", "belt", 0.0014)
    top.field((-w * 0.42, -w * 0.18), (-d * 0.34, d * 0.34), "plastic_26272b", "till", 0.001)
    top.field((-w * 0.4, -w * 0.2), (d * 0.08, d * 0.3), "light_58d0f0", "till", 0.0016)
    for k in range(12):
        u, v = w * (-0.38 + 0.055 * (k % 4)), d * (-0.26 + 0.1 * (k // 4))
        top.field((u - w * 0.02, u + w * 0.02), (v, v + d * 0.07), "plastic_e8ecf0", "till", 0.002)
    face = DrawnFace.front(b, d / 2 - 0.04)
    face.field((-w * 0.46, w * 0.46), (h * 0.18, h - 0.1), "plastic_d8281e", "sign", 0.01)
    face.write("PAY", (-w * 0.2, w * 0.42), (h * 0.56, h - 0.14), "plastic_white", "letters", 0.016)
    face.write("HERE", (-w * 0.2, w * 0.42), (h * 0.22, h * 0.5), "plastic_white", "letters", 0.016)
    _shopping_bag(face, -w * 0.33, h * 0.24, (w * 0.1, h * 0.36))


def _shopping_bag(face: DrawnFace, u: float, v: float, size: tuple[float, float]) -> None:
    """A yellow bag with two handles."""
    half, tall = size
    face.field((u - half, u + half), (v, v + tall), "plastic_f5d020", "bag", 0.016)
    grip = [
        (u - half * 0.45, v + tall),
        (u - half * 0.3, v + tall * 1.35),
        (u + half * 0.3, v + tall * 1.35),
        (u + half * 0.45, v + tall),
    ]
    face.line(grip, half * 0.09, "plastic_f5d020", "bag", 0.008)
    smile = [
        (u - half * 0.5, v + tall * 0.5),
        (u - half * 0.25, v + tall * 0.3),
        (u + half * 0.25, v + tall * 0.3),
        (u + half * 0.5, v + tall * 0.5),
    ]
    face.line(smile, half * 0.08, "plastic_d8281e", "bag", 0.016)
