"""Stations of waiters: cupboards that show cutlery, glasses, plates, napkins and menus."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.recipes.cabinets import cabinet
from mansion_assets.registry import recipe

__all__: list[str] = []

Span = tuple[float, float]


@recipe("waiter_station")
def waiter_station(b: Builder) -> None:
    """A sideboard with bins of cutlery, glasses, plates and napkins at its doors, and menus in a holder at its side."""
    cabinet(b)
    w, d, h = b.w, b.d, b.h
    face = DrawnFace.front(b, d / 2 - 0.006)
    upper, lower = (h * 0.56, h * 0.93), (h * 0.14, h * 0.51)
    # Who looks at the front has the second door at the left.
    with b.fixed_to("door_2"):
        bays = (-w * 0.46, -w * 0.06)
        _bay(face, bays, upper)
        for k, kind in enumerate(("fork", "knife", "spoon")):
            _cutlery_bin(face, (bays[0] + (k + 0.5) * w * 0.4 / 3, w * 0.058), upper, kind)
        _bay(face, bays, lower)
        for u in (-w * 0.36, -w * 0.16):
            _plates(face, u, w * 0.085, lower)
    with b.fixed_to("door_1"):
        bays = (w * 0.06, w * 0.46)
        _bay(face, bays, upper)
        for u in (w * 0.13, w * 0.26, w * 0.39):
            _wine_glass(face, u, w * 0.05, upper)
        _bay(face, bays, lower)
        _napkins(face, bays, lower)
    _menus(DrawnFace.side(b, w / 2), d, h)


def _bay(face: DrawnFace, u: Span, v: Span) -> None:
    face.field(u, v, "wood_2a1c14", "bays", 0.001)


def _cutlery_bin(face: DrawnFace, place: Span, v: Span, kind: str) -> None:
    """A bin around `place` (middle, half a width), out of which the upper half of a fork, a knife or a spoon stands."""
    u, half = place
    tall = v[1] - v[0]
    rim, end = v[0] + tall * 0.3, v[0] + tall * 0.94
    face.field((u - half * 0.9, u + half * 0.9), (v[0], rim), "metal_brass", "bins", 0.007)
    r, neck = half * 0.13, rim + (end - rim) * 0.45
    face.field((u - r, u + r), (rim, neck + r), "ceramic_white", "cutlery", 0.004)
    if kind == "spoon":
        for k, wide in enumerate((0.3, 0.46, 0.5, 0.5, 0.42, 0.26)):
            step = (end - neck) / 6
            span = (neck + k * step, neck + (k + 1) * step)
            face.field((u - half * wide, u + half * wide), span, "ceramic_white", "cutlery", 0.005)
    elif kind == "knife":
        face.field((u - r, u + half * 0.3), (neck, end), "ceramic_white", "cutlery", 0.004)
    else:
        face.field((u - half * 0.55, u + half * 0.55), (neck, neck + tall * 0.08), "ceramic_white", "cutlery", 0.004)
        for tine in (-0.55, -0.1, 0.35):
            face.field((u + tine * half, u + (tine + 0.2) * half), (neck, end), "ceramic_white", "cutlery", 0.004)


def _plates(face: DrawnFace, u: float, half: float, v: Span) -> None:
    """A pile of plates seen from the side."""
    tall = v[1] - v[0]
    for k in range(9):
        low = v[0] + tall * (0.02 + 0.09 * k)
        face.field((u - half * 0.6, u + half * 0.6), (low, low + tall * 0.03), "ceramic_c9ced2", "plates", 0.004)
        face.field((u - half, u + half), (low + tall * 0.03, low + tall * 0.07), "ceramic_white", "plates", 0.007)


def _wine_glass(face: DrawnFace, u: float, r: float, v: Span) -> None:
    """A glass on its foot."""
    tall = v[1] - v[0]
    middle = v[0] + tall * 0.66
    face.disc(u, middle, r, "plastic_e6f1f6", "glasses", 0.004, 18)
    face.field((u - r, u + r), (middle, v[0] + tall * 0.9), "plastic_e6f1f6", "glasses", 0.004)
    face.disc(u, middle, r * 0.8, "plastic_8a1c34", "wine", 0.006, 16)
    face.field((u - r * 0.12, u + r * 0.12), (v[0] + tall * 0.06, middle - r * 0.9), "plastic_e6f1f6", "glasses", 0.004)
    face.field((u - r * 0.8, u + r * 0.8), (v[0] + tall * 0.02, v[0] + tall * 0.07), "plastic_e6f1f6", "glasses", 0.004)


def _napkins(face: DrawnFace, u: Span, v: Span) -> None:
    """Two piles of folded napkins, white and red."""
    tall, middle = v[1] - v[0], (u[0] + u[1]) / 2
    for pile, color in (
        ((u[0] + 0.02, middle - 0.01), "fabric_white"),
        ((middle + 0.01, u[1] - 0.02), "fabric_c8283a"),
    ):
        for k in range(6):
            low = v[0] + tall * (0.02 + 0.12 * k)
            face.field(pile, (low, low + tall * 0.1), color, "napkins", 0.007 if k % 2 else 0.005)


def _menus(face: DrawnFace, d: float, h: float) -> None:
    """Menus in a holder, the first with its name across it."""
    for k, color in enumerate(("paper_7a1f2a", "paper_f4ecd8")):
        shift = d * 0.06 * (1 - k)
        face.field(
            (-d * 0.36 + shift, d * 0.28 + shift),
            (h * 0.4 + shift, h * 0.86 + shift),
            color,
            "menus",
            0.004 + 0.003 * k,
        )
    face.write("MENU", (-d * 0.33, d * 0.25), (h * 0.68, h * 0.8), "paper_7a1f2a", "menus", 0.009)
    for k in range(3):
        level = h * (0.61 - 0.06 * k)
        face.field((-d * 0.24, d * 0.16), (level, level + h * 0.018), "plastic_5a4a3a", "menus", 0.009)
    face.field((-d * 0.4, d * 0.38), (h * 0.36, h * 0.46), "metal_brass", "holder", 0.012)
