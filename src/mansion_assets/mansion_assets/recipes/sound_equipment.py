"""Sound equipment: headphones, radios, ceiling loudspeakers."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe
from mansion_assets.solids import Vec3

__all__: list[str] = []


@recipe("headphones")
def headphones(b: Builder) -> None:
    """Band with two cups."""
    w, d, h = b.w, b.d, b.h
    r, rz = w / 2 - 0.012, h - w * 0.2
    points = [
        (r * math.cos(a), 0.0, w * 0.18 + (rz - w * 0.02) * math.sin(a)) for a in [k * math.pi / 10 for k in range(11)]
    ]
    b.path(points, 0.008, b.mat(), "band")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.035)))
        b.cushion((lo, hi), (-d / 2, d / 2), (0, h * 0.45), b.mat(), "cups", 0.7)


@recipe("portable_radio")
def portable_radio(b: Builder) -> None:
    """A case with a round, pierced loudspeaker, a dial with a needle, two knobs, a handle and a drawn aerial."""
    w, d, h = b.w, b.d, b.h
    top, front = h * 0.62, d / 2
    b.cushion((-w / 2, w / 2), (-d / 2, front - 0.004), (0, top), b.mat(), "case", 0.2)
    b.box((-w * 0.46, w * 0.46), (front - 0.006, front - 0.003), (top * 0.08, top * 0.92), "plastic_e9dfc8", "face")
    _loudspeaker(b, (-w * 0.22, front, top / 2), top * 0.36)
    b.box(
        (w * 0.08, w * 0.42),
        (front - 0.003, front - 0.001),
        (top * 0.56, top * 0.82),
        "paper_white",
        "dial",
        solid=False,
    )
    for k in range(7):
        u = w * (0.1 + 0.048 * k)
        b.box(
            (u, u + w * 0.008), (front - 0.001, front), (top * 0.66, top * 0.78), "plastic_black", "dial", solid=False
        )
    b.box(
        (w * 0.24, w * 0.255),
        (front - 0.001, front + 0.001),
        (top * 0.57, top * 0.81),
        "paint_red",
        "dial",
        solid=False,
    )
    for u in (0.15, 0.35):
        b.rod(
            (w * u, front - 0.003, top * 0.28), (w * u, front + 0.004, top * 0.28), w * 0.06, "metal_steel", "knobs", 16
        )
    b.path(
        [(-w * 0.4, 0, top), (-w * 0.36, 0, top * 1.25), (w * 0.3, 0, top * 1.25), (w * 0.34, 0, top)],
        h * 0.025,
        "leather_brown",
        "handle",
    )
    b.rod((w * 0.42, -d * 0.3, top * 0.95), (w * 0.2, -d * 0.3, h), 0.003, "metal_chrome", "aerial")


def _loudspeaker(b: Builder, at: Vec3, r: float) -> None:
    """Add a round, pierced front whose middle is `at`, in rings."""
    x, y, z = at
    b.rod((x, y - 0.004, z), (x, y - 0.001, z), r, "metal_dark", "loudspeaker", 24)
    for share, color in ((0.75, "metal_light"), (0.5, "metal_dark"), (0.25, "metal_light")):
        b.rod((x, y - 0.002, z), (x, y + 0.001 - 0.002 * share, z), r * share, color, "loudspeaker", 20)


@recipe("ceiling_speaker")
def ceiling_speaker(b: Builder) -> None:
    """A white ring round the black cone of a loudspeaker, with a dust cap in its middle behind a cross of bars."""
    w, h = b.w, b.h
    r = w / 2
    b.lathe([(r * 0.84, h * 0.3), (r * 0.84, h)], "metal_dark", part="case", n=28)
    b.lathe([(r * 0.8, 0), (r, h * 0.1), (r, h * 0.34), (r * 0.8, h * 0.34)], b.mat(), part="ring", n=32)
    for share, color in ((0.82, "rubber_black"), (0.7, "metal_grey"), (0.64, "rubber_black"), (0.3, "metal_light")):
        b.cyl(0, 0, (-h * 0.004 - h * 0.06 * (1 - share), h * 0.3), r * share, color, "cone", n=28)
    b.ball((0, 0, -h * 0.02), (r * 0.22, r * 0.22, h * 0.14), "metal_light", "cap", 12)
    for k in range(12):
        a = k * math.pi / 6
        b.cyl(
            math.cos(a) * r * 0.76,
            math.sin(a) * r * 0.76,
            (-h * 0.03, h * 0.2),
            r * 0.025,
            "metal_steel",
            "screws",
            n=6,
        )
