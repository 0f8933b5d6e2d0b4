"""Seats for several people: benches, sofas, rows of seats, picnic tables."""

from typing import Any

from mansion_assets.builder import Box, Builder
from mansion_assets.catalogue.receptacles import Receptacle, surface
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@receptacles("bench")
def _bench_seat(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    z = min(0.46, h * 0.52) if p.get("back") else h
    return [surface("seat", (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.08, d / 2 - 0.03), z, 0.6)]


@recipe("bench")
def bench(b: Builder) -> None:
    """Slatted or upholstered bench, with or without a back; tiers for a sauna."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    if b.p.get("style") == "tiered":
        _slats(b, (-w / 2, w / 2), (0, d / 2), h * 0.45, main)
        _slats(b, (-w / 2, w / 2), (-d / 2, 0), h, main)
        return
    seat = h if not b.p.get("back") else min(0.46, h * 0.52)
    r = 0.03
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.1)
        b.box((x - r, x + r), (-d / 2 + 0.02, d / 2 - 0.02), (0, 0.04), "metal_dark", "legs")
        b.box((x - r, x + r), (-r, r), (0.03, seat - 0.04), "metal_dark", "legs")
    if b.p.get("style") == "cushion" or main.startswith("leather"):
        b.box(
            (-w / 2 + 0.02, w / 2 - 0.02),
            (-d / 2 + 0.02, d / 2 - 0.02),
            (seat - 0.12, seat - 0.06),
            "wood_walnut",
            "frame",
        )
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (seat - 0.07, seat), main, "seat")
    else:
        count = max(3, round(d / 0.12))
        step = d / count
        for k in range(count):
            y = -d / 2 + k * step
            b.box(
                (-w / 2, w / 2),
                (y + 0.004, y + step - 0.004),
                (seat - 0.04, seat),
                main,
                "seat",
                solid=k in (0, count - 1),
            )
        b.boxes.append(_seat_box(b, seat))
    if b.p.get("back"):
        if b.p.get("panel"):
            b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.04), (0, h), main, "back")
        else:
            for z in (seat + 0.14, seat + 0.28, h - 0.07):
                b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.03), (z, z + 0.07), main, "back")
            for sx in (-1, 1):
                x = sx * (w / 2 - 0.1)
                b.box((x - r, x + r), (-d / 2 + 0.03, -d / 2 + 0.06), (seat - 0.04, h - 0.02), "metal_dark", "back")


def _seat_box(b: Builder, seat: float) -> Box:
    return Box((0.0, 0.0, seat - 0.02), (b.w, b.d, 0.04))


def _slats(b: Builder, x: tuple[float, float], y: tuple[float, float], z: float, main: str) -> None:
    count = max(3, round((y[1] - y[0]) / 0.1))
    step = (y[1] - y[0]) / count
    for k in range(count):
        b.box(x, (y[0] + k * step, y[0] + (k + 1) * step - 0.015), (z - 0.03, z), main, "slats")
    b.box((x[0], x[1]), (y[1] - 0.03, y[1] - 0.015), (0, z - 0.03), main, "front")


@receptacles("sofa")
def _sofa_seat(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    arm = 0.0 if p.get("arms") is False else min(0.2, w * 0.13)
    back = min(0.28, d * 0.3)
    z = min(0.44, h * 0.52)
    box = (-w / 2 + arm + 0.02, w / 2 - arm - 0.02, -d / 2 + back + 0.02, d / 2 - 0.05)
    return [surface("seat", box, z, 0.6)]


@recipe("sofa")
def sofa(b: Builder) -> None:
    """Armchair or sofa: base, seat cushions, back cushions, arms, short legs."""
    w, d, h = b.w, b.d, b.h
    seat = b.tops[0]
    main = b.mat()
    arms = b.p.get("arms") is not False
    arm = (w / 2 - seat.x1 - 0.02) if arms else 0.0
    back = seat.y0 - 0.02 + d / 2
    sharp = 0.22 if b.p.get("style") == "block" else 0.45
    foot = min(0.1, seat.z * 0.25)
    b.legs((0, foot), 0.022, "wood_walnut", 0.03)
    b.box((-w / 2 + 0.01, w / 2 - 0.01), (-d / 2 + 0.02, d / 2 - 0.03), (foot, seat.z * 0.62), main, "base")
    inner = w - 2 * arm
    count = max(1, round(inner / 0.72))
    for k in range(count):
        x0 = -inner / 2 + k * inner / count
        x1 = x0 + inner / count
        b.cushion((x0 + 0.004, x1 - 0.004), (-d / 2 + back, d / 2), (seat.z * 0.6, seat.z), main, "seat", sharp, 12)
        b.cushion(
            (x0 + 0.004, x1 - 0.004),
            (-d / 2 + back * 0.35, -d / 2 + back * 1.05),
            (seat.z - 0.02, h - 0.02),
            main,
            "back",
            sharp,
            12,
        )
    b.cushion((-w / 2, w / 2), (-d / 2, -d / 2 + back * 0.55), (foot, h), main, "back", 0.3, 12)
    if arms:
        top = seat.z + min(0.2, (h - seat.z) * 0.5)
        for sx in (-1, 1):
            lo, hi = sorted((sx * w / 2, sx * (w / 2 - arm)))
            b.cushion((lo, hi), (-d / 2 + 0.04, d / 2 - 0.01), (foot, top), main, "arms", 0.4, 12)


@recipe("seat_row")
def seat_row(b: Builder) -> None:
    """Seats on one beam, or a row of upholstered theatre seats."""
    count, z = int(b.p.get("seats", 3)), b.tops[0].z
    plush = b.p.get("style") == "plush"
    if not plush:
        _seat_beam(b, z)
    step = b.w / count
    for k in range(count):
        _padded_seat(b, (-b.w / 2 + k * step, -b.w / 2 + k * step + step), z, plush=plush)
    for k in range(count + 1):
        x = min(max(-b.w / 2 + k * step, -b.w / 2 + 0.03), b.w / 2 - 0.03)
        _seat_arm(b, x, z, plush=plush)


def _seat_beam(b: Builder, z: float) -> None:
    """Beam below seats at height `z`, on two legs."""
    w, d, black = b.w, b.d, "metal_black"
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-0.04, 0.04), (z - 0.14, z - 0.08), black, "beam")
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.3)
        b.box((x - 0.03, x + 0.03), (-d / 2 + 0.02, d / 2 - 0.02), (0, 0.04), black, "legs")
        b.box((x - 0.03, x + 0.03), (-0.04, 0.04), (0.03, z - 0.1), black, "legs")


def _padded_seat(b: Builder, x: tuple[float, float], z: float, *, plush: bool) -> None:
    b.cushion(
        (x[0] + 0.04, x[1] - 0.04), (-b.d / 2 + 0.14, b.d / 2), (z - (0.16 if plush else 0.06), z), b.mat(), "seat", 0.4
    )
    b.cushion(
        (x[0] + 0.03, x[1] - 0.03),
        (-b.d / 2, -b.d / 2 + 0.15),
        (z - 0.04 if plush else z + 0.06, b.h),
        b.mat(),
        "back",
        0.4,
    )


def _seat_arm(b: Builder, x: float, z: float, *, plush: bool) -> None:
    d = b.d
    if plush:
        y = (-d / 2 + 0.05, d / 2 - 0.12)
        b.box((x - 0.03, x + 0.03), y, (0, z + 0.16), "wood_black", "arms")
    else:
        y, level = (-d * 0.2, d * 0.3), (z + 0.15, z + 0.18)
        b.box((x - 0.02, x + 0.02), y, level, "metal_black", "arms", solid=False)


@recipe("picnic")
def picnic(b: Builder) -> None:
    """Table with two benches in one frame."""
    w, d, h = b.w, b.d, b.h
    for k in range(5):
        y = -0.36 + k * 0.146
        b.box((-w / 2, w / 2), (y, y + 0.135), (h - 0.04, h), b.mat(), "top")
    for sy in (-1, 1):
        y = sy * (d / 2 - 0.13)
        b.box((-w / 2, w / 2), (y - 0.13, y + 0.13), (0.41, 0.45), b.mat(), "benches")
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.25)
        b.rod((x, -d / 2 + 0.1, 0), (x, 0.1 - 0.3, h - 0.04), 0.03, b.mat(), "legs")
        b.rod((x, d / 2 - 0.1, 0), (x, 0.2, h - 0.04), 0.03, b.mat(), "legs")
        b.box((x - 0.03, x + 0.03), (-d / 2 + 0.04, d / 2 - 0.04), (0.36, 0.41), b.mat(), "legs")
