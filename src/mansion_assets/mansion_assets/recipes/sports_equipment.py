"""Balls, hoops, rings, rinks and starting blocks."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("football")
def football(b: Builder) -> None:
    """A white ball with twelve black pentagons, at the corners of an icosahedron."""
    w, d, h = b.w, b.d, b.h
    b.ball((0, 0, h / 2), (w / 2, d / 2, h / 2), b.mat(), "ball", 24)
    golden = (1 + math.sqrt(5)) / 2
    corners = [p for s in (-1, 1) for t in (-golden, golden) for p in ((0, s, t), (s, t, 0), (t, 0, s))]
    length = math.hypot(1, golden)
    for corner in corners:
        x, y, z = (v / length for v in corner)
        reach = [(x * w * k, y * d * k, h / 2 + z * h * k) for k in (0.44, 0.503)]
        b.rod(reach[0], reach[1], w * 0.15, "plastic_black", "pentagons", 5)


@recipe("basketball")
def basketball(b: Builder) -> None:
    """An orange ball with black seams: two great circles and two arcs beside them."""
    w, h = b.w, b.h
    r = w / 2
    b.ball((0, 0, h / 2), (r, r, h / 2), "rubber_d8702a", "ball", 24)

    def seam(x: float, y: float, z: float) -> tuple[float, float, float]:
        """Bring a direction onto the ball."""
        share = 0.985 / math.sqrt(x * x + y * y + z * z)
        return x * share * r, y * share * r, h / 2 + z * share * h / 2

    steps = [k * math.tau / 24 for k in range(25)]
    b.path([seam(math.cos(a), math.sin(a), 0.3 * math.cos(a)) for a in steps], r * 0.03, "rubber_black", "seams")
    b.path([seam(0.4 * math.cos(a), math.cos(a), math.sin(a)) for a in steps], r * 0.03, "rubber_black", "seams")
    for side in (-1, 1):
        arc = [seam(side * 0.75 + 0.25 * math.cos(2 * a), math.cos(a), math.sin(a)) for a in steps]
        b.path(arc, r * 0.03, "rubber_black", "seams")


@recipe("hoop")
def hoop(b: Builder) -> None:
    """Backboard with ring and net."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.05), (0.1, h), b.mat(), "board")
    b.box((-w * 0.2, w * 0.2), (-d / 2 + 0.05, -d / 2 + 0.055), (h * 0.3, h * 0.62), "paint_red", "square", solid=False)
    r = min(0.23, d * 0.3)
    y = d / 2 - r
    points = [(r * math.cos(a), y + r * math.sin(a), h * 0.22) for a in [k * math.pi / 8 for k in range(17)]]
    b.path(points, 0.01, "paint_orange", "ring")
    b.box((-0.04, 0.04), (-d / 2 + 0.05, y - r), (h * 0.2, h * 0.24), "paint_orange", "arm")
    for x, yy, z in points[:-1:2]:
        b.rod((x, yy, z), (x * 0.6, y + (yy - y) * 0.6, 0.0), 0.004, "fabric_white", "net", 5)


@recipe("wall_bars")
def wall_bars(b: Builder) -> None:
    """Rungs between two posts."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.04)))
        b.box((lo, hi), (-d / 2, d / 2), (0, h), b.mat(), "posts")
    for k in range(13):
        z = 0.15 + k * (h - 0.25) / 12
        b.rod((-w / 2 + 0.02, d * 0.2, z), (w / 2 - 0.02, d * 0.2, z), 0.018, b.mat(), "rungs")


@recipe("boxing_ring")
def boxing_ring(b: Builder) -> None:
    """A raised canvas between four posts with padded corners, red, blue and white, and three ropes round it; steps."""
    w, d, h = b.w, b.d, b.h
    deck, inset = h * 0.3, 0.3
    b.box((-w / 2 + 0.1, w / 2 - 0.1), (-d / 2 + 0.1, d / 2 - 0.1), (0, deck - 0.04), "fabric_dark", "skirt")
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, d / 2 - 0.05), (deck - 0.05, deck), b.mat(), "apron")
    b.box(
        (-w / 2 + inset, w / 2 - inset),
        (-d / 2 + inset, d / 2 - inset),
        (deck, deck + 0.012),
        "fabric_dfe3e6",
        "canvas",
    )
    corners = ((-1, -1, "fabric_red"), (1, -1, "plastic_white"), (1, 1, "fabric_2f5fc8"), (-1, 1, "plastic_white"))
    x, y = w / 2 - inset, d / 2 - inset
    for sx, sy, color in corners:
        b.cyl(sx * x, sy * y, (0, h), 0.06, "metal_dark", "posts", n=12)
        b.cushion(
            (sx * x - 0.13, sx * x + 0.13), (sy * y - 0.13, sy * y + 0.13), (deck + 0.08, h * 0.98), color, "pads", 0.4
        )
    for k, color in enumerate(("paint_red", "plastic_white", "paint_2f5fc8")):
        z = deck + (h - deck) * (0.3 + 0.28 * k)
        ring = [(-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z), (-x, -y, z)]
        b.path(ring, 0.03, color, "ropes")
    for k in range(2):
        b.box((-0.5, 0.5), (d / 2 - 0.1, d / 2 + 0.25 - 0.25 * k), (0, deck * (0.4 + 0.3 * k)), "metal_dark", "steps")
    DrawnFace.top(b, deck + 0.012).write(
        "BOX", (-w * 0.22, w * 0.22), (-d * 0.12, d * 0.12), "fabric_red", "letters", 0.002
    )


@recipe("starting_block")
def starting_block(b: Builder) -> None:
    """A swimmer's block: a sloping, rough top with a foot wedge on a white stand with a step, a number and a grip."""
    w, d, h = b.w, b.d, b.h
    b.box((-w * 0.3, w * 0.3), (-d * 0.3, d * 0.34), (0, h * 0.72), b.mat(), "stand")
    b.box((-w * 0.34, w * 0.34), (-d / 2, -d * 0.2), (h * 0.3, h * 0.36), b.mat(), "step")
    b.box((-w * 0.3, w * 0.3), (-d * 0.48, -d * 0.3), (0, h * 0.3), b.mat(), "step")
    top = [(-d * 0.4, h * 0.82), (d / 2, h * 0.7), (d / 2, h * 0.76), (-d * 0.4, h * 0.88)]
    b.prism(top, (-w / 2, w / 2), "paint_3a7bc8", part="top")
    b.prism(
        [(-d * 0.4, h * 0.88), (-d * 0.18, h * 0.851), (-d * 0.4, h)], (-w * 0.4, w * 0.4), "rubber_black", part="wedge"
    )
    for side in (-1, 1):
        x = side * w * 0.36
        b.path(
            [(x, d * 0.34, h * 0.5), (x, d * 0.48, h * 0.5), (x, d * 0.48, h * 0.7)], w * 0.03, "metal_chrome", "grips"
        )
    b.rod((-w * 0.36, d * 0.48, h * 0.5), (w * 0.36, d * 0.48, h * 0.5), w * 0.03, "metal_chrome", "grips")
    for span, level in (
        ((-0.1, 0.1), (0.4, 0.43)),
        ((-0.1, 0.1), (0.24, 0.27)),
        ((-0.1, 0.1), (0.08, 0.11)),
        ((-0.1, -0.07), (0.08, 0.43)),
    ):
        b.box(
            (w * span[0], w * span[1]),
            (d * 0.34, d * 0.345),
            (h * level[0], h * level[1]),
            "plastic_black",
            "number",
            solid=False,
        )
        sides = (d * span[0], d * span[1])
        b.box(
            (w * 0.3, w * 0.305),
            (-sides[1], -sides[0]),
            (h * level[0], h * level[1]),
            "plastic_black",
            "number",
            solid=False,
        )


_BOARD = 0.1


_GATE = 0.7
"""Half of the width of the way onto the ice, metres."""


@recipe("ice_rink")
def ice_rink(b: Builder) -> None:
    """White ice with the lines of a hockey field and two goals, in boards with a gate in each long side."""
    w, d = b.w, b.d
    b.box((-w / 2 + _BOARD, w / 2 - _BOARD), (-d / 2 + _BOARD, d / 2 - _BOARD), (0, 0.05), "plastic_e9f5fc", "ice")
    for side in (-1, 1):
        ends = sorted((side * w / 2, side * (w / 2 - _BOARD)))
        long = sorted((side * d / 2, side * (d / 2 - _BOARD)))
        _board(b, (ends[0], ends[1]), (-d / 2, d / 2))
        for half in (-1, 1):
            x = sorted((half * w / 2, half * _GATE))
            _board(b, (x[0], x[1]), (long[0], long[1]))
    _lines(b)
    for side in (-1, 1):
        _goal(b, side)


def _board(b: Builder, x: tuple[float, float], y: tuple[float, float]) -> None:
    h = b.h
    b.box(x, y, (0, h * 0.2), "plastic_yellow", "boards")
    b.box(x, y, (h * 0.2, h * 0.94), "plastic_white", "boards")
    b.box(x, y, (h * 0.94, h), "plastic_2f5fc8", "boards")


def _lines(b: Builder) -> None:
    """Paint the lines: one of red across the middle with its circle, two of blue, and those of the goals."""
    w, d = b.w, b.d
    top = (0.05, 0.056)
    across = (-d / 2 + _BOARD, d / 2 - _BOARD)
    for x, wide, color in (
        (0.0, 0.15, "plastic_red"),
        (-w * 0.16, 0.15, "plastic_2f5fc8"),
        (w * 0.16, 0.15, "plastic_2f5fc8"),
        (-w * 0.41, 0.05, "plastic_red"),
        (w * 0.41, 0.05, "plastic_red"),
    ):
        b.box((x - wide, x + wide), across, top, color, "lines", solid=False)
    radius = d * 0.17
    b.cyl(0.0, 0.0, (0.05, 0.058), radius, "plastic_2f5fc8", "lines", n=32, solid=False)
    b.cyl(0.0, 0.0, (0.05, 0.06), radius - 0.08, "plastic_e9f5fc", "lines", n=32, solid=False)
    b.cyl(0.0, 0.0, (0.05, 0.062), 0.12, "plastic_red", "lines", n=12, solid=False)


def _goal(b: Builder, side: int) -> None:
    """Put a goal of red bars with a net on its line."""
    front, back = side * b.w * 0.41, side * (b.w * 0.41 + 0.5)
    half, high = min(0.9, b.d * 0.12), min(1.2, b.h * 0.95)
    for y in (-half, half):
        b.rod((front, y, 0.05), (front, y, high), 0.04, "plastic_red", "goals", 8)
        b.rod((front, y, high), (back, y, 0.09), 0.03, "plastic_red", "goals", 8)
    b.rod((front, -half, high), (front, half, high), 0.04, "plastic_red", "goals", 8)
    b.rod((back, -half, 0.09), (back, half, 0.09), 0.03, "plastic_red", "goals", 8)
    for k in range(1, 8):
        y = -half + 2 * half * k / 8
        b.rod((front, y, high), (back, y, 0.09), 0.008, "plastic_white", "goals", 5)
