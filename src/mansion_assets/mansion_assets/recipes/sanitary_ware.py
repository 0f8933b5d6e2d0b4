"""Toilets, basins, baths and showers, their taps and cubicles."""

import math
from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, inset, surface, volume
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__ = ["shallow_bowl", "sink"]


@receptacles("toilet")
def _cistern_top(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    return [surface("tank", (-w * 0.38, w * 0.38, -d / 2 + 0.02, -d / 2 + min(0.17, d * 0.24)), h, 0.5)]


@recipe("toilet")
def toilet(b: Builder) -> None:
    """Bowl with seat and lid, cistern behind."""
    w, d, h = b.w, b.d, b.h
    tank = min(0.2, d * 0.28)
    rim = min(0.42, h * 0.52)
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + tank), (rim * 0.9, h - 0.03), b.mat(), "tank")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + tank), (h - 0.03, h), b.mat(), "lid")
    b.cyl(0, -d / 2 + tank / 2, (h - 0.004, h), 0.025, "metal_chrome", "button", solid=False)
    cy = -d / 2 + tank + (d - tank) / 2
    ry = (d - tank) / 2
    b.lathe([(0.55, 0), (0.5, rim * 0.3), (0.95, rim * 0.95), (1.0, rim)], b.mat(), (0, cy), "bowl", 24, (w * 0.46, ry))
    b.lathe(
        [(1.0, rim), (1.02, rim + 0.015), (0.98, rim + 0.03)],
        "plastic_white",
        (0, cy),
        "seat",
        24,
        (w * 0.46, ry * 0.98),
        solid=False,
    )
    b.box((-w * 0.25, w * 0.25), (-d / 2, -d / 2 + tank + 0.1), (0, rim), b.mat(), "foot")


@recipe("urinal")
def urinal(b: Builder) -> None:
    """A porcelain shield with raised sides round a hollow, its lip below in front, a drain."""
    d, h = b.d, b.h
    low, high = h * 0.3, h * 0.86
    back, front = -d / 2, d / 2
    _urinal_shield(b, back, high, low, front)
    b.cyl(0, d * 0.1, (low + 0.06, low + 0.075), 0.045, "metal_chrome", "drain", n=16)
    b.cyl(0, d * 0.1, (low + 0.075, low + 0.1), 0.03, "plastic_4f9bd9", "tablet", n=14)
    _urinal_pipes(b, back, high, low)


def _urinal_shield(b: Builder, back: float, high: float, low: float, front: float) -> None:
    """A back with raised sides, a lip in front and a head."""
    w, d = b.w, b.d
    b.box((-w * 0.46, w * 0.46), (back, back + d * 0.2), (low + 0.06, high), b.mat(), "back")
    for side in (-1, 1):
        across = sorted((side * w / 2, side * w * 0.34))
        wall = [
            (back, low),
            (d * 0.16, low),
            (front, low + 0.14),
            (d * 0.34, low + 0.3),
            (back + d * 0.4, high),
            (back, high),
        ]
        b.prism(wall, (across[0], across[1]), b.mat(), part="sides")
    b.prism(
        [
            (back, low),
            (d * 0.16, low),
            (front, low + 0.14),
            (front, low + 0.2),
            (d * 0.34, low + 0.2),
            (d * 0.1, low + 0.06),
            (back, low + 0.06),
        ],
        (-w * 0.34, w * 0.34),
        b.mat(),
        part="bowl",
    )
    b.prism(
        [(back, high), (back + d * 0.4, high), (back + d * 0.3, high + 0.05), (back, high + 0.05)],
        (-w / 2, w / 2),
        b.mat(),
        part="head",
    )
    b.box(
        (-w * 0.34, w * 0.34),
        (back + d * 0.2, back + d * 0.22),
        (low + 0.1, high),
        "ceramic_dfe6ea",
        "hollow",
        solid=False,
    )


def _urinal_pipes(b: Builder, back: float, high: float, low: float) -> None:
    """The valve above and the trap below."""
    h = b.h
    b.path(
        [(0, back + 0.07, high + 0.04), (0, back + 0.07, h - 0.03), (0, back + 0.02, h - 0.03)],
        0.016,
        "metal_chrome",
        "valve",
    )
    b.rod((0, back + 0.07, h - 0.08), (0, back + 0.13, h - 0.08), 0.035, "metal_chrome", "valve", 16)
    b.box((-0.05, 0.05), (back, back + 0.07), (0.0, low + 0.02), "metal_chrome", "trap")
    b.rod((0, back + 0.09, low - 0.1), (0, back + 0.09, low + 0.02), 0.04, "metal_chrome", "trap", 14)


@recipe("bidet")
def bidet(b: Builder) -> None:
    """Bowl with a tap."""
    w, d, h = b.w, b.d, b.h
    b.lathe(
        [(0.7, 0), (0.6, h * 0.3), (1.0, h * 0.85), (0.85, h * 0.85), (0.4, h * 0.55)],
        b.mat(),
        (0, 0),
        "bowl",
        24,
        (w / 2, d / 2),
    )
    b.rod((0, -d * 0.36, h * 0.8), (0, -d * 0.36, h), 0.014, "metal_chrome", "tap")


def _tap(b: Builder, x: float, z: float, y: float, high: float) -> None:
    b.path(
        [(x, y, z), (x, y, z + high - 0.012), (x, y + 0.12, z + high - 0.012), (x, y + 0.12, z + high * 0.6)],
        0.012,
        "metal_chrome",
        "tap",
    )


@receptacles("sink", "sink_row", "scrub_sink", "dishwashing_station")
def _sink_receptacles(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    rim = h - float(p.get("splash", 0.0))
    basin = _basin(size)
    out: list[Receptacle] = [volume("basin", basin, rim - min(0.14, rim * 0.6), rim)]
    if basin[0] + w / 2 > 0.22:
        box = (-w / 2 + 0.02, basin[0] - 0.03, -d / 2 + 0.05, d / 2 - 0.03)
        out += [surface("top", box, rim, 0.5)]
    if p.get("cabinet") and rim > 0.5:
        body = (-w / 2 + 0.03, w / 2 - 0.03, -d / 2 + 0.03, d / 2 - 0.05)
        out.append(volume("cell", body, 0.12, rim - 0.2))
    return out


def _basin(size: Size3) -> tuple[float, float, float, float]:
    w, d, _ = size
    half = min(w * 0.42, 0.26)
    shift = max(0.0, min(w / 2 - half - 0.05, 0.12)) if w > 0.9 else 0.0
    return (shift - half, shift + half, -d * 0.22, d * 0.4)


@recipe("sink")
def sink(b: Builder) -> None:
    """Basin in a top, on a cabinet, a pedestal or a steel frame; drop-in basins too."""
    w, d, h = b.w, b.d, b.h
    splash, main = float(b.p.get("splash", 0.0)), b.mat()
    rim = h - splash
    bowl, steel = b.cells[0], main.startswith("metal")
    top = main if steel or main.startswith(("ceramic", "stone")) else "ceramic_white"
    thick = min(0.05, rim * 0.3)
    for span_x, span_y in (
        ((-w / 2, bowl.x0), (-d / 2, d / 2)),
        ((bowl.x1, w / 2), (-d / 2, d / 2)),
        ((bowl.x0, bowl.x1), (-d / 2, bowl.y0)),
        ((bowl.x0, bowl.x1), (bowl.y1, d / 2)),
    ):
        b.box(span_x, span_y, (rim - thick, rim), top, "top")
    deep = bowl.z
    b.box(
        (bowl.x0 - 0.008, bowl.x1 + 0.008),
        (bowl.y0 - 0.008, bowl.y1 + 0.008),
        (max(0.0, deep - 0.012), deep),
        top,
        "basin",
    )
    for x in (bowl.x0, bowl.x1):
        b.box((x - 0.008, x + 0.008), (bowl.y0, bowl.y1), (deep - 0.01, rim - 0.004), top, "basin")
    for y in (bowl.y0, bowl.y1):
        b.box((bowl.x0, bowl.x1), (y - 0.008, y + 0.008), (deep - 0.01, rim - 0.004), top, "basin")
    if rim > 0.5:
        _below(b, rim - thick, deep, top)
    if splash > 0.05:
        xs = (bowl.x0 + bowl.x1) / 2
        _tap(b, xs, rim, -d / 2 + 0.06, splash)
    elif rim <= 0.5:
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.004), top, "rim", solid=False)


def _below(b: Builder, high: float, deep: float, top: str) -> None:
    w, d, main = b.w, b.d, b.mat()
    if b.p.get("cabinet"):
        b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.02), (0.1, high), main, "cabinet")
        for sx in (-1, 1):
            lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.02)))
            b.box((lo, hi), (-d / 2, d / 2 - 0.03), (0.1, high), main, "cabinet")
        b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.03), (0.1, 0.12), main, "cabinet")
        b.box(
            (-w / 2 + 0.04, w / 2 - 0.04),
            (-d / 2 + 0.03, d / 2 - 0.07),
            (0, 0.1),
            "plastic_dark",
            "plinth",
            solid=False,
        )
        count = 2 if w > 0.5 else 1
        for k in range(count):
            x0, x1 = -w / 2 + k * w / count, -w / 2 + (k + 1) * w / count
            panel = ((x0 + 0.003, x1 - 0.003), (d / 2 - 0.03, d / 2 - 0.012), (0.11, high - 0.01))
            hx = x1 - 0.04 if k == 0 else x0 + 0.04
            with b.door(*panel, "left" if k == 0 else "right"):
                b.box(*panel, main, "doors", solid=False)
                b.box(
                    (hx - 0.006, hx + 0.006),
                    (d / 2 - 0.012, d / 2),
                    (high - 0.2, high - 0.08),
                    "metal_steel",
                    "handles",
                    solid=False,
                )
    elif top.startswith("metal") and not b.p.get("pedestal"):
        b.legs((0, high), 0.02, "metal_steel", 0.01)
        b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2 + 0.03, d / 2 - 0.03), (0.2, 0.22), "metal_steel", "shelf")
    else:
        b.lathe(
            [(0.3, 0), (0.2, high * 0.3), (0.2, deep * 0.85), (0.6, deep)],
            "ceramic_white",
            (0, 0),
            "pedestal",
            16,
            (min(w, 0.5) / 2, min(d, 0.5) / 2),
        )


@recipe("sink_row")
def sink_row(b: Builder) -> None:
    """Two white bowls with taps in a top, below a long mirror, soap beside each, towels on the doors below."""
    sink(b)
    w, d, h = b.w, b.d, b.h
    splash, bowl = float(b.p["splash"]), b.cells[0]
    rim, back = h - splash, -d / 2 + 0.018
    b.box((-w / 2, w / 2), (-d / 2, back), (rim, h), "ceramic_white", "splash")
    wall = DrawnFace.front(b, back)
    wall.field((-w * 0.48, w * 0.48), (rim + splash * 0.2, h - 0.012), "glass_mirror", "mirror", 0.004)
    for u in (-w * 0.3, -w * 0.24, w * 0.2):
        wall.line([(u, rim + splash * 0.25), (u + splash * 0.5, h - 0.016)], 0.007, "plastic_f6fcff", "gleam", -0.001)
    _white_lining(b, rim)
    second = -w * 0.3
    shallow_bowl(b, second, rim)
    y = back + 0.021
    for soap in (bowl.x0, bowl.x1 - 0.07):
        b.cyl(soap, y, (rim, rim + splash * 0.5), 0.02, "plastic_f08fb0", "soap", n=12, solid=False)
        b.cyl(soap, y, (rim + splash * 0.5, rim + splash * 0.7), 0.007, "plastic_white", "soap", n=8, solid=False)
        b.box(
            (soap - 0.01, soap + 0.01),
            (y, y + 0.008),
            (rim + splash * 0.7, rim + splash * 0.78),
            "plastic_white",
            "soap",
            solid=False,
        )
    spout = [
        (second, back, rim + splash * 0.55),
        (second, back + 0.017, rim + splash * 0.55),
        (second, back + 0.017, rim + splash * 0.4),
    ]
    b.path(spout, 0.012, "metal_chrome", "tap")
    for u in (-0.06, 0.06):
        wall.disc(-second + u, rim + splash * 0.55, 0.022, "metal_chrome", "tap", 0.02, 14)
    for number, u in ((1, w * 0.25), (2, -w * 0.25)):
        with b.fixed_to(f"door_{number}"):
            _washroom_door(b, u, rim)


def _white_lining(b: Builder, rim: float) -> None:
    """Glaze on the walls and the floor of the basin, and round its edge."""
    bowl, thick, edge = b.cells[0], 0.0095, 0.03
    for low, high, t, out in ((bowl.z, rim, thick, 0.0), (rim - 0.001, rim + 0.002, thick, edge)):
        for x0, x1 in ((bowl.x0 - out, bowl.x0 + t), (bowl.x1 - t, bowl.x1 + out)):
            b.box((x0, x1), (bowl.y0 - out, bowl.y1 + out), (low, high), "ceramic_white", "basin", solid=False)
        for y0, y1 in ((bowl.y0 - out, bowl.y0 + t), (bowl.y1 - t, bowl.y1 + out)):
            b.box((bowl.x0 + t, bowl.x1 - t), (y0, y1), (low, high), "ceramic_white", "basin", solid=False)
    b.box((bowl.x0, bowl.x1), (bowl.y0, bowl.y1), (bowl.z, bowl.z + 0.003), "ceramic_white", "basin", solid=False)


def shallow_bowl(b: Builder, x: float, rim: float) -> None:
    """The second bowl, so flat that things stand on it: a white edge about a shaded floor with a drain."""
    face, bowl = DrawnFace.top(b, rim), b.cells[0]
    y, deep = (bowl.y0 + bowl.y1) / 2, (bowl.y1 - bowl.y0) / 2 + 0.03
    across = min((bowl.x1 - bowl.x0) / 2 + 0.03, (bowl.x0 - 0.06 + b.w / 2) / 2)
    for share, color, thick in (
        (1.0, "ceramic_white", 0.001),
        (0.86, "plastic_b4bec6", 0.0014),
        (0.74, "plastic_d3dadf", 0.0018),
    ):
        u, v = (-x - across * share, -x + across * share), (-y - deep * share, -y + deep * share)
        face.field(u, v, color, "bowl", thick)
    face.disc(-x, -y, 0.026, "metal_dark", "bowl", 0.002, 14)


def _washroom_door(b: Builder, u: float, rim: float) -> None:
    """A white front with a towel on a bar and a drop of water."""
    face = DrawnFace.front(b, b.d / 2 - 0.012)
    half = b.w / 4 - 0.02
    face.field((u - half, u + half), (0.13, rim - 0.07), "wood_white", "fronts", 0.003)
    top = rim - 0.18
    face.field((u - 0.16, u + 0.16), (top - 0.014, top), "metal_chrome", "bar", 0.012)
    face.field((u - 0.12, u + 0.12), (top - 0.34, top + 0.004), "fabric_3f9fd0", "towel", 0.008)
    for low in (0.3, 0.26):
        face.field((u - 0.12, u + 0.12), (top - low, top - low + 0.018), "fabric_white", "towel", 0.01)


@recipe("basin_tap")
def basin_tap(b: Builder) -> None:
    """A mixer: a base plate, a stem, a spout that bends down with a drop of water, and levers marked red and blue."""
    w, d, h = b.w, b.d, b.h
    back, r = -d * 0.34, min(0.026, w * 0.34, h * 0.12)
    b.cyl(0, back, (0, h * 0.06), r * 1.5, b.mat(), "base", n=18)
    b.box((-w * 0.5, w * 0.5), (back - r * 2, d * 0.3), (0, h * 0.03), b.mat(), "plate")
    b.cyl(0, back, (0, h * 0.62), r, b.mat(), "stem", n=16)
    bend = [
        (0, back + (d * 0.72) * (1 - math.cos(a)) / 2, h * 0.6 + h * 0.32 * math.sin(a))
        for a in (k * math.pi / 8 for k in range(9))
    ]
    b.path([*bend, (0, d * 0.38, h * 0.5)], r * 0.74, b.mat(), "spout")
    b.cyl(0, d * 0.38, (h * 0.44, h * 0.5), r * 0.95, "metal_dark", "spout", n=14)
    b.ball((0, d * 0.38, h * 0.34), (r * 0.4, r * 0.4, h * 0.06), "plastic_5aa9e6", "drop", 10)
    for side, color in ((-1, "paint_3d6ac8"), (1, "paint_red")):
        reach = side * min(w * 0.45, r * 3.4)
        b.rod((0, back, h * 0.24), (reach, back, h * 0.24), r * 0.55, b.mat(), "levers", 12)
        b.rod((reach, back, h * 0.2), (reach, back, h * 0.4), r * 0.8, b.mat(), "levers", 14)
        b.rod((reach, back, h * 0.4), (reach, back, h * 0.43), r * 0.7, color, "levers", 14)


@receptacles("bathtub")
def _tub_inside(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    h = size[2]
    return [volume("basin", inset(size, 0.1), h * 0.25, h)]


@recipe("bathtub")
def bathtub(b: Builder) -> None:
    """A white tub with round ends and a rolled rim on golden feet, water in it, a mixer at one end, a towel over it."""
    w, d, h = b.w, b.d, b.h
    rim, low, floor, main = h * 0.82, h * 0.17, b.cells[0].z, b.mat()
    outer, inner = _round_ends(w / 2 - 0.01, d / 2 - 0.01, 0.21), _round_ends(w / 2 - 0.055, d / 2 - 0.055, 0.165)
    lip = _round_ends(w / 2, d / 2, 0.22)
    b.prism(_round_ends(w / 2 - 0.012, d / 2 - 0.012, 0.208), (low, floor), main, "z", "floor")
    for k in range(len(outer)):
        following = (k + 1) % len(outer)
        for edge, z in ((outer, (low, rim - 0.03)), (lip, (rim - 0.03, rim))):
            corners = [edge[k], edge[following], inner[following], inner[k]]
            b.prism(corners, z, main, "z", "sides", solid=edge is outer and k % 6 == 5)
    b.prism(inner, (floor, floor + 0.003), "plastic_7fd0f0", "z", "water", solid=False)
    for x, y in ((-0.4, -0.42), (0.4, -0.42), (-0.4, 0.42), (0.4, 0.42)):
        b.ball((x * w, y * d, low * 0.4), (0.055, 0.055, low * 0.4), "metal_f2c94a", "feet", 10)
        b.taper((x * w, y * d, low * 0.5), (x * w, y * d, low * 1.1), (0.035, 0.07), "metal_f2c94a", "feet")
    _bath_mixer(b, rim)
    side = DrawnFace.front(b, d / 2)
    b.box(
        (-w * 0.02, w * 0.2), (d / 2 - 0.06, d / 2 + 0.002), (rim, rim + 0.006), "fabric_3f8fd8", "towel", solid=False
    )
    side.field((-w * 0.2, w * 0.02), (h * 0.4, rim + 0.004), "fabric_3f8fd8", "towel", 0.004)
    for v in (0.46, 0.54):
        side.field((-w * 0.2, w * 0.02), (h * v, h * (v + 0.04)), "fabric_white", "towel", 0.005)


def _round_ends(x: float, y: float, r: float) -> list[tuple[float, float]]:
    """Return an outline whose corners are rounded by `r`."""
    points = []
    for k, (sx, sy) in enumerate(((1, 1), (-1, 1), (-1, -1), (1, -1))):
        for step in range(6):
            a = (k + step / 5) * math.pi / 2
            points.append((sx * (x - r) + math.cos(a) * r, sy * (y - r) + math.sin(a) * r))
    return points


def _bath_mixer(b: Builder, rim: float) -> None:
    """A spout over the far end, taps marked red and blue, and a chain with its plug on the overflow below."""
    x, floor = -b.w / 2 + 0.03, b.cells[0].z
    b.path(
        [(x, 0, rim), (x, 0, b.h - 0.02), (x + 0.13, 0, b.h - 0.02), (x + 0.13, 0, rim - 0.03)],
        0.02,
        "metal_chrome",
        "tap",
    )
    for side, color in ((-1, "plastic_d8281e"), (1, "plastic_2f6fe0")):
        b.cyl(x, side * 0.11, (rim, b.h - 0.02), 0.022, "metal_chrome", "taps", n=12, solid=False)
        b.cyl(x, side * 0.11, (b.h - 0.02, b.h), 0.04, color, "taps", n=14, solid=False)
    wall = DrawnFace.side(b, -b.w / 2 + 0.055)
    wall.disc(0.0, rim - 0.1, 0.035, "metal_chrome", "overflow", 0.006, 16)
    wall.line([(0.0, rim - 0.12), (0.04, floor + 0.06)], 0.005, "metal_steel", "chain", 0.01)
    b.cyl(-b.w / 2 + 0.25, 0, (floor, floor + 0.008), 0.04, "plastic_26272b", "drain", n=16, solid=False)


@recipe("shower")
def shower(b: Builder) -> None:
    """Tray, glass walls on two sides, head and mixer at the back."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.06), "ceramic_white", "tray")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.012), (0.06, h), "ceramic_light", "back")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.01)))
        b.box((lo, hi), (-d / 2, d / 2), (0.06, h), "glass_clear", "glass")
    b.box((-w / 2, -0.02), (d / 2 - 0.01, d / 2), (0.06, h), "glass_clear", "glass")
    pane = ((0.0, w / 2 - 0.012), (d / 2 - 0.01, d / 2), (0.064, h - 0.034))
    with b.door(*pane, "right"):
        b.box(*pane, "glass_clear", "door", solid=False)
    b.box((-w / 2, w / 2), (d / 2 - 0.02, d / 2), (h - 0.03, h), "metal_chrome", "rail", solid=False)
    b.path(
        [(0, -d / 2 + 0.04, 1.0), (0, -d / 2 + 0.04, h - 0.08), (0, -d * 0.15, h - 0.08)], 0.012, "metal_chrome", "pipe"
    )
    b.cyl(0, -d * 0.15, (h - 0.12, h - 0.09), 0.09, "metal_chrome", "head", solid=False)
    b.box((-0.1, 0.1), (-d / 2 + 0.01, -d / 2 + 0.06), (1.0, 1.05), "metal_chrome", "mixer", solid=False)


@recipe("shower_head")
def shower_head(b: Builder) -> None:
    """A wide rose on a bent arm, from which water falls, a hand shower with its hose, a mixer with two taps."""
    w, d, h = b.w, b.d, b.h
    back, main = -d / 2, b.mat()
    r = min(w / 2, d * 0.44)
    bar = back + d * 0.14
    rose = (0.0, d / 2 - r)
    b.rod((0, bar, h * 0.16), (0, bar, h * 0.99), h * 0.008, main, "riser", 10, solid=True)
    b.path([(0, bar, h * 0.985), (0, rose[1], h * 0.985), (*rose, h * 0.955)], h * 0.008, main, "arm")
    b.lathe([(r * 0.96, h * 0.93), (r, h * 0.945), (r * 0.3, h * 0.957)], main, rose, "rose", 28)
    for ring, count in ((0.3, 5), (0.7, 10)):
        for k in range(count):
            a = k * math.tau / count + ring
            x, y = rose[0] + math.cos(a) * r * ring, rose[1] + math.sin(a) * r * ring
            end = h * (0.66 + 0.05 * (k % 3))
            b.rod((x, y, h * 0.93), (x, y, end), r * 0.035, "plastic_6fb8f0", "water", 5)
            b.ball((x, y, end - h * 0.03), (r * 0.06, r * 0.06, h * 0.012), "plastic_6fb8f0", "water", 6, solid=False)
    for z in (h * 0.2, h * 0.6):
        b.rod((0, back, z), (0, bar, z), h * 0.007, main, "brackets", 8)
    _hand_shower(b, bar)
    half = min(w * 0.46, 0.15)
    b.rod((-half * 0.7, bar, h * 0.16), (half * 0.7, bar, h * 0.16), min(0.028, d * 0.12), main, "mixer", 16)
    for side, color in ((-1, "paint_2f6fe0"), (1, "paint_e8382e")):
        b.rod((side * half * 0.7, bar, h * 0.16), (side * half, bar, h * 0.16), min(0.038, d * 0.14), main, "taps", 14)
        b.rod(
            (side * half * 0.66, bar, h * 0.16),
            (side * half * 0.74, bar, h * 0.16),
            min(0.04, d * 0.15),
            color,
            "taps",
            14,
        )


def _hand_shower(b: Builder, bar: float) -> None:
    """A hand shower in its holder, and a hose that hangs in a bow from it to the mixer."""
    w, d, h = b.w, b.d, b.h
    front = bar + d * 0.16
    x = min(w * 0.2, 0.08)
    b.rod((0, bar, h * 0.52), (x, front, h * 0.52), h * 0.009, "metal_9ba0a5", "holder", 8)
    b.taper(
        (x, front, h * 0.46),
        (x, front + d * 0.08, h * 0.6),
        (h * 0.009, h * 0.013),
        "plastic_e8eaec",
        "hand_shower",
        10,
    )
    middle, out = (x, front + d * 0.1, h * 0.61), (0.0, d * 0.1, -h * 0.012)
    face = (middle[0], middle[1] + out[1], middle[2] + out[2])
    b.rod(middle, face, h * 0.032, "plastic_e8eaec", "hand_shower", 18)
    b.rod(face, (face[0], face[1] + d * 0.01, face[2]), h * 0.026, "plastic_5a6470", "hand_shower", 18)
    bow = [
        (
            x + (w * 0.44 - x) * math.sin(math.pi * k / 10) * 0.8 - x * k / 10,
            front - (front - bar) * k / 10,
            h * (0.46 - 0.3 * k / 10) - h * 0.36 * math.sin(math.pi * k / 10),
        )
        for k in range(11)
    ]
    b.path([(px, py, max(h * 0.01, pz)) for px, py, pz in bow], h * 0.0065, "metal_9ba0a5", "hose")


@recipe("stall")
def stall(b: Builder) -> None:
    """Cubicle: partitions and a door, with a toilet or, for trying on, a curtain and a stool."""
    w, d, h = b.w, b.d, b.h
    t, foot = 0.03, 0.15
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - t)))
        b.box((lo, hi), (-d / 2, d / 2), (foot, h), b.mat(), "sides")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.02), (0, h), "plastic_light", "back")
    if b.p.get("style") == "curtain":
        b.rod((-w / 2, d / 2 - 0.03, h - 0.03), (w / 2, d / 2 - 0.03, h - 0.03), 0.015, "metal_chrome", "rail")
        for k in range(6):
            x = -w / 2 + 0.05 + k * 0.07
            b.cushion(
                (x, x + 0.07), (d / 2 - 0.08, d / 2), (0.1, h - 0.04), "fabric_red", "curtain", 0.9, 8, solid=False
            )
        b.box((-w * 0.3, w * 0.3), (-d / 2 + 0.02, -d / 2 + 0.35), (0.4, 0.45), "wood_oak", "seat")
        b.box(
            (-w * 0.3, w * 0.3), (-d / 2 + 0.02, -d / 2 + 0.03), (0.6, h - 0.2), "glass_mirror", "mirror", solid=False
        )
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (0.0, 0.02), "wood_walnut", "floor")
        return
    for x0, x1 in ((-w / 2, -w * 0.32), (w * 0.32, w / 2)):
        b.box((x0, x1), (d / 2 - t, d / 2), (0, h), b.mat(), "front")
    panel = ((-w * 0.31, w * 0.31), (d / 2 - t, d / 2 - 0.006), (foot, h - 0.05))
    with b.door(*panel):
        b.box(*panel, b.mat(), "door")
        b.box((w * 0.24, w * 0.27), (d / 2 - 0.006, d / 2), (1.0, 1.1), "metal_steel", "lock", solid=False)
        face = DrawnFace.front(b, d / 2 - 0.006)
        face.write("WC", (-w * 0.22, w * 0.22), (h * 0.66, h * 0.86), "plastic_white", "sign", 0.004)
        face.field((-w * 0.27, -w * 0.17), (1.12, 1.16), "plastic_green", "lock", 0.004)
    b.lathe(
        [(0.55, 0), (0.5, 0.12), (0.95, 0.38), (1.0, 0.41)],
        "ceramic_white",
        (0, -d / 2 + 0.42),
        "bowl",
        18,
        (0.18, 0.26),
    )
    b.box((-0.2, 0.2), (-d / 2 + 0.02, -d / 2 + 0.18), (0.4, 0.8), "ceramic_white", "tank")
