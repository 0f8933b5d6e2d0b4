"""Cars, bicycles, chairs on wheels."""

import math

from mansion_assets.builder import Box, Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("car")
def car(b: Builder) -> None:
    """Saloon: body, cabin with glass, wheels, lamps."""
    _car_body(b)
    for side in (-1, 1):
        _car_wheels(b, side)
        _car_lamps(b, side)
        _car_pillar(b, side)


def _car_body(b: Builder) -> None:
    """Body on its sill, a cabin of dark glass, the roof."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    side = [
        (-d / 2, h * 0.28),
        (d / 2, h * 0.26),
        (d / 2 - 0.04, h * 0.46),
        (d * 0.3, h * 0.58),
        (-d * 0.46, h * 0.62),
        (-d / 2, h * 0.5),
    ]
    b.prism(side, (-w / 2 + 0.04, w / 2 - 0.04), m, part="body")
    b.prism(
        [(-d / 2 + 0.1, h * 0.16), (d / 2 - 0.1, h * 0.16), (d / 2, h * 0.3), (-d / 2, h * 0.3)],
        (-w / 2 + 0.06, w / 2 - 0.06),
        m,
        part="body",
    )
    b.prism(
        [(-d * 0.42, h * 0.6), (d * 0.22, h * 0.58), (d * 0.06, h - 0.03), (-d * 0.28, h - 0.03)],
        (-w * 0.42, w * 0.42),
        "glass_black",
        part="glass",
    )
    b.prism(
        [(-d * 0.3, h - 0.06), (d * 0.08, h - 0.06), (d * 0.05, h), (-d * 0.27, h)],
        (-w * 0.39, w * 0.39),
        m,
        part="roof",
    )


def _car_wheels(b: Builder, side: int) -> None:
    w, r = b.w, b.h * 0.22
    for y in (-b.d * 0.31, b.d * 0.31):
        inner, outer = (side * (w / 2 - 0.24), y, r), (side * (w / 2 - 0.01), y, r)
        b.rod(inner, outer, r, "rubber_black", "wheels", 24, solid=True)
        rim = (side * (w / 2 - 0.03), y, r)
        b.rod(rim, (side * w / 2, y, r), r * 0.6, "metal_steel", "rims", 16)


def _car_lamps(b: Builder, side: int) -> None:
    """A white lamp at the front, a red one at the back."""
    w, d, h = b.w, b.d, b.h
    x = (side * w * 0.36 - 0.14, side * w * 0.36 + 0.14)
    b.box(x, (d / 2 - 0.06, d / 2), (h * 0.38, h * 0.46), "light_white", "lamps", solid=False)
    b.box(x, (-d / 2, -d / 2 + 0.05), (h * 0.42, h * 0.52), "light_red", "lamps", solid=False)


def _car_pillar(b: Builder, side: int) -> None:
    """The post between the side windows."""
    w, d, h = b.w, b.d, b.h
    low, high = sorted((side * w * 0.41, side * w * 0.425))
    b.prism(
        [(d * 0.02, h * 0.6), (d * 0.035, h * 0.6), (-d * 0.02, h - 0.05), (-d * 0.035, h - 0.05)],
        (low, high),
        b.mat(),
        part="pillars",
        solid=False,
    )


@recipe("fire_engine")
def fire_engine(b: Builder) -> None:
    """Cab with glass in front of a body with lockers, a ladder on the roof, blue lamps."""
    w, d, h = b.w, b.d, b.h
    m, floor, cab = b.mat(), 0.42, d / 2 - 0.24 * d
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2, cab - 0.06), (floor, h - 0.25), m, "body")
    b.prism(
        [(cab, floor), (d / 2, floor), (d / 2, h * 0.52), (d / 2 - 0.22, h - 0.4), (cab, h - 0.4)],
        (-w / 2 + 0.03, w / 2 - 0.03),
        m,
        part="cab",
    )
    b.box((-w * 0.3, w * 0.3), (-d / 2, d / 2 - 0.3), (0.28, floor), "metal_dark", "chassis")
    b.box((-w * 0.44, w * 0.44), (d / 2 - 0.2, d / 2 - 0.1), (h * 0.54, h - 0.5), "glass_black", "glass", solid=False)
    b.box((-w * 0.4, w * 0.4), (cab + 0.2, cab + 0.5), (h - 0.4, h - 0.28), "light_blue", "lamps", solid=False)
    for side in (-1, 1):
        _engine_side(b, side, floor, cab)
    _engine_ladder(b, cab)


def _engine_side(b: Builder, side: int, floor: float, cab: float) -> None:
    """Lockers, door glass, wheels, and lamps at both ends."""
    w, d, h = b.w, b.d, b.h
    low, high = sorted((side * (w / 2 - 0.03), side * (w / 2 - 0.01)))
    length = (cab + d / 2 - 0.3) / 3
    for k in range(3):
        y = -d / 2 + 0.1 + k * (length + 0.04)
        b.box((low, high), (y, y + length), (floor + 0.35, h - 0.4), "metal_steel", "lockers", solid=False)
    b.box((low, high), (cab + 0.25, d / 2 - 0.4), (h * 0.54, h - 0.5), "glass_black", "glass", solid=False)
    for y in (-d * 0.27, d * 0.3):
        b.rod((side * (w / 2 - 0.32), y, 0.5), (side * w / 2, y, 0.5), 0.5, "rubber_black", "wheels", 24, solid=True)
    x = (side * w * 0.38 - 0.12, side * w * 0.38 + 0.12)
    b.box(x, (d / 2 - 0.02, d / 2), (floor + 0.1, floor + 0.3), "light_white", "lamps", solid=False)
    b.box(x, (-d / 2 - 0.0, -d / 2 + 0.02), (floor + 0.1, floor + 0.3), "light_red", "lamps", solid=False)


def _engine_ladder(b: Builder, cab: float) -> None:
    """A ladder along the roof of the body."""
    d, z = b.d, b.h - 0.12
    for x in (-0.3, 0.3):
        b.rod((x, -d / 2 + 0.1, z), (x, cab + 0.3, z), 0.04, "metal_steel", "ladder", 8)
    for k in range(9):
        y = -d / 2 + 0.3 + k * (cab + d / 2) / 9
        b.rod((-0.3, y, z), (0.3, y, z), 0.025, "metal_steel", "ladder", 6)
    for y in (-d * 0.4, cab - 0.4):
        b.rod((0.0, y, b.h - 0.25), (0.0, y, z + 0.12), 0.06, "metal_dark", "ladder", 8)


def _wheel(b: Builder, x: float, y: float, r: float, tyre: float = 0.02) -> None:
    points = [(x, y + r * math.cos(a), r + tyre + r * math.sin(a)) for a in [k * math.pi / 12 for k in range(25)]]
    b.path(points, tyre, "rubber_black", "wheels")
    for k in range(6):
        a = k * math.pi / 6
        b.rod(
            (x, y - r * math.cos(a), r + tyre - r * math.sin(a)),
            (x, y + r * math.cos(a), r + tyre + r * math.sin(a)),
            0.003,
            "metal_steel",
            "spokes",
            5,
        )


@recipe("bicycle")
def bicycle(b: Builder) -> None:
    """Bicycle or motorcycle, facing the front."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    motor = b.p.get("style") == "motor"
    r, tyre = (0.27, 0.05) if motor else (d * 0.18, 0.018)
    rear, front = -d / 2 + r + tyre, d / 2 - r - tyre
    _wheel(b, 0, rear, r, tyre)
    _wheel(b, 0, front, r, tyre)
    hub, crank = r + tyre, (0.0, -d * 0.04, r * 0.95)
    seat, head = (0.0, -d * 0.12, h * 0.8), (0.0, d * 0.24, h * 0.78)
    if motor:
        b.cushion((-0.16, 0.16), (-d * 0.18, d * 0.14), (0.22, h * 0.62), "metal_dark", "engine", 0.3)
        b.cushion((-0.17, 0.17), (-d * 0.02, d * 0.22), (h * 0.55, h * 0.85), m, "tank", 0.6)
        b.cushion((-0.14, 0.14), (-d * 0.4, 0.0), (h * 0.6, h * 0.72), "leather_black", "seat", 0.6)
    else:
        for p, q in ((crank, seat), (seat, head), (crank, head), (crank, (0.0, rear, hub)), (seat, (0.0, rear, hub))):
            b.rod(p, q, 0.016, m, "frame")
        b.cushion((-0.07, 0.07), (seat[1] - 0.13, seat[1] + 0.12), (h * 0.86, h * 0.92), "leather_black", "saddle", 0.7)
        b.rod(seat, (0.0, seat[1], h * 0.88), 0.012, "metal_steel", "post")
        b.rod((-0.12, crank[1], crank[2]), (0.12, crank[1], crank[2]), 0.02, "metal_dark", "pedals")
    b.rod(head, (0.0, front, hub), 0.018, m, "fork")
    b.rod(head, (0.0, d * 0.2, h - 0.02), 0.014, "metal_steel", "stem")
    b.rod((-w / 2, d * 0.16, h - 0.018), (w / 2, d * 0.16, h - 0.018), 0.016, "rubber_black", "bar")
    b.boxes.append(Box((0.0, 0.0, h * 0.45), (min(w, 0.3), d, h * 0.9)))


@recipe("bike_rack")
def bike_rack(b: Builder) -> None:
    """Row of hoops."""
    w, d, h = b.w, b.d, b.h
    for sy in (-1, 1):
        b.box((-w / 2, w / 2), (sy * (d / 2 - 0.03) - 0.03, sy * (d / 2 - 0.03) + 0.03), (0, 0.03), b.mat(), "rails")
    count = max(3, round(w / 0.35))
    for k in range(count):
        x = -w / 2 + 0.03 + k * (w - 0.06) / (count - 1)
        b.path(
            [(x, -d / 2 + 0.04, 0.02), (x, -d * 0.3, h - 0.022), (x, d * 0.3, h - 0.022), (x, d / 2 - 0.04, 0.02)],
            0.02,
            b.mat(),
            "hoops",
        )
    b.boxes.append(Box((0.0, 0.0, h / 2), (w, d, h)))


@recipe("wheelchair")
def wheelchair(b: Builder) -> None:
    """Seat and back of cloth between large wheels."""
    w, d, h = b.w, b.d, b.h
    r = 0.29
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.02)
        _wheel(b, x, -d * 0.14, r, 0.016)
        b.rod(
            (sx * (w / 2 - 0.1), d * 0.24, 0.08),
            (sx * (w / 2 - 0.07), d * 0.24, 0.08),
            0.08,
            "rubber_black",
            "casters",
            16,
        )
        xi = sx * (w / 2 - 0.09)
        b.path(
            [
                (xi, -d / 2 + 0.02, h - 0.02),
                (xi, -d * 0.3, h - 0.03),
                (xi, -d * 0.28, 0.48),
                (xi, d * 0.24, 0.48),
                (xi, d * 0.26, 0.2),
            ],
            0.014,
            "metal_steel",
            "frame",
        )
        b.box((xi - 0.02, xi + 0.02), (-d * 0.25, d * 0.15), (0.68, 0.71), "plastic_black", "arms")
        b.rod((xi, d * 0.12, 0.48), (xi, d * 0.12, 0.7), 0.012, "metal_steel", "frame")
        b.box((xi * 0.5 - 0.07, xi * 0.5 + 0.07), (d * 0.36, d / 2), (0.1, 0.12), "plastic_black", "footrests")
        b.rod((xi, d * 0.24, 0.46), (xi * 0.5, d * 0.4, 0.12), 0.012, "metal_steel", "frame")
    b.box((-w / 2 + 0.09, w / 2 - 0.09), (-d * 0.28, d * 0.2), (0.46, 0.5), b.mat(), "seat")
    b.box((-w / 2 + 0.09, w / 2 - 0.09), (-d * 0.31, -d * 0.28), (0.5, h - 0.05), b.mat(), "back")


@recipe("walker")
def walker(b: Builder) -> None:
    """Walking frame."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.016)
        b.path(
            [(x, -d / 2 + 0.016, 0.0), (x, -d * 0.3, h - 0.016), (x, d * 0.2, h - 0.016), (x, d / 2 - 0.016, 0.06)],
            0.015,
            b.mat(),
            "frame",
        )
        b.rod((x - 0.012, d / 2 - 0.06, 0.06), (x + 0.012, d / 2 - 0.06, 0.06), 0.06, "rubber_black", "wheels", 14)
    for z in (0.35, 0.65):
        b.rod((-w / 2 + 0.016, d * 0.35, z), (w / 2 - 0.016, d * 0.35, z), 0.014, b.mat(), "frame")
    b.boxes.append(Box((0.0, d * 0.3, h / 2), (w, d * 0.3, h)))


@recipe("stroller")
def stroller(b: Builder) -> None:
    """Pram with hood and handle."""
    w, d, h = b.w, b.d, b.h
    b.wheels(0.11, 0.06)
    b.cushion((-w * 0.4, w * 0.4), (-d * 0.3, d * 0.4), (0.42, 0.72), b.mat(), "seat", 0.6, 12)
    b.ball((0, -d * 0.12, 0.78), (w * 0.4, d * 0.24, 0.2), b.mat(), "hood", 12)
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.03)
        b.path([(x, d * 0.42, 0.12), (x, -d * 0.3, 0.7), (x, -d / 2 + 0.02, h - 0.02)], 0.013, "metal_dark", "frame")
        b.rod((x, -d * 0.42, 0.12), (x, d * 0.1, 0.5), 0.013, "metal_dark", "frame")
    b.rod((-w / 2, -d / 2 + 0.02, h - 0.02), (w / 2, -d / 2 + 0.02, h - 0.02), 0.016, "rubber_black", "handle")
    b.box((-w * 0.35, w * 0.35), (-d * 0.3, d * 0.3), (0.18, 0.28), "fabric_dark", "basket")
