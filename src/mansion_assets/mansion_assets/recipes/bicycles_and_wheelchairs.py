"""Bicycles with their racks and stands, wheelchairs and walking frames."""

import math

from mansion_assets.builder import Box, Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


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


@recipe("repair_stand")
def repair_stand(b: Builder) -> None:
    """A tripod whose clamp holds up a bicycle's frame: the diamond of tubes, saddle, fork, cranks, chain wheel."""
    w, d, h = b.w, b.d, b.h
    for k in range(3):
        a = math.pi / 2 + k * math.tau / 3
        b.rod(
            (0, 0, 0.24), (math.cos(a) * w * 0.44, math.sin(a) * d * 0.48, 0.02), 0.022, b.mat(), "legs", 8, solid=True
        )
    b.rod((0, 0, 0.1), (0, 0, h * 0.7), 0.028, b.mat(), "post", 10, solid=True)
    b.box((-0.04, 0.04), (-0.04, 0.1), (h * 0.66, h * 0.74), "plastic_black", "clamp")
    y, s = 0.07, w
    seat, bottom, head, rear = (0.12 * s, h * 0.86), (0.06 * s, h * 0.5), (-0.24 * s, h * 0.82), (0.4 * s, h * 0.52)
    for start, end in ((seat, bottom), (seat, head), (bottom, head), (bottom, rear), (seat, rear)):
        b.rod((start[0], y, start[1]), (end[0], y, end[1]), 0.022, "paint_red", "bicycle", 8)
    b.path(
        [(head[0], y, head[1] + 0.06), (-0.3 * s, y, h * 0.62), (-0.38 * s, y, h * 0.5)], 0.02, "metal_black", "fork"
    )
    b.path([(head[0], y, head[1]), (-0.2 * s, y, h * 0.96), (-0.34 * s, y, h * 0.98)], 0.018, "metal_black", "bar")
    b.rod((-0.34 * s, y - 0.16, h * 0.98), (-0.34 * s, y + 0.18, h * 0.98), 0.02, "rubber_black", "bar", 8)
    b.rod((seat[0], y, seat[1]), (seat[0] + 0.02, y, h * 0.95), 0.014, "metal_steel", "saddle", 8)
    b.cushion((seat[0] - 0.1, seat[0] + 0.16), (y - 0.07, y + 0.07), (h * 0.94, h), "leather_black", "saddle", 0.8)
    b.rod((bottom[0], y, bottom[1]), (bottom[0], y + 0.03, bottom[1]), 0.09, "metal_steel", "chain_wheel", 18)
    b.path(
        [(bottom[0], y + 0.05, bottom[1]), (bottom[0] - 0.1, y + 0.05, bottom[1] - 0.12)], 0.014, "metal_black", "crank"
    )
    b.box(
        (bottom[0] - 0.16, bottom[0] - 0.06),
        (y + 0.04, y + 0.14),
        (bottom[1] - 0.15, bottom[1] - 0.11),
        "plastic_black",
        "pedal",
    )


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
