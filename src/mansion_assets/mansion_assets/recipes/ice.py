"""Ice to skate on."""

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []

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
