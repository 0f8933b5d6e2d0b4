"""Sanitary ware, showers, stalls, and the fittings of bathrooms."""

from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, inset, surface, volume
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


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


@receptacles("sink")
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
        if b.p.get("bowls") == 2:
            b.rod(
                (-w * 0.3, -d / 2 + 0.06, rim),
                (-w * 0.3, -d / 2 + 0.06, rim + splash * 0.7),
                0.012,
                "metal_chrome",
                "tap",
            )
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


@receptacles("bathtub")
def _tub_inside(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    h = size[2]
    return [volume("basin", inset(size, 0.1), h * 0.25, h)]


@recipe("bathtub")
def bathtub(b: Builder) -> None:
    """Tub with a rim, open at the top, and a tap at its end."""
    w, d, h = b.w, b.d, b.h
    t, floor, main = 0.08, h * 0.25, b.mat()
    z1 = h - 0.0
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - t)))
        b.box((lo, hi), (-d / 2, d / 2), (0, z1), main, "sides")
    for sy in (-1, 1):
        lo, hi = sorted((sy * d / 2, sy * (d / 2 - t)))
        b.box((-w / 2 + t, w / 2 - t), (lo, hi), (0, z1), main, "sides")
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, d / 2 - t), (0, floor), main, "floor")
    b.rod((w / 2 - 0.14, 0, z1 - 0.06), (w / 2 - 0.08, 0, z1 - 0.06), 0.02, "metal_chrome", "tap")
    b.cyl(w / 2 - 0.3, 0, (floor, floor + 0.005), 0.03, "metal_chrome", "drain", solid=False)


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


@recipe("towel_bar")
def towel_bar(b: Builder) -> None:
    """Bar on two brackets."""
    w, d, h = b.w, b.d, b.h
    r = min(0.014, h * 0.4, d * 0.2)
    y, z = d / 2 - r, h / 2
    b.rod((-w / 2, y, z), (w / 2, y, z), r, b.mat(), "bar", 10, solid=True)
    for sx in (-1, 1):
        x = sx * (w / 2 - min(0.03, w * 0.1))
        b.rod((x, -d / 2, z), (x, y, z), r, b.mat(), "brackets")
        b.box(
            (x - min(0.02, w * 0.08), x + min(0.02, w * 0.08)),
            (-d / 2, -d / 2 + 0.008),
            (0, h),
            b.mat(),
            "plates",
            solid=False,
        )


@recipe("paper_hanger")
def paper_hanger(b: Builder) -> None:
    """Holder with a roll."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + min(0.01, d * 0.3)), (0, h), b.mat(), "plate")
    r = min(h, d) * 0.42
    b.rod((-w * 0.3, d / 2 - r, h / 2), (w * 0.3, d / 2 - r, h / 2), r, "paper_white", "roll", 16)
    b.rod((-w / 2, d / 2 - r, h / 2), (w / 2, d / 2 - r, h / 2), min(0.006, r * 0.3), b.mat(), "pin")


@recipe("shower_head")
def shower_head(b: Builder) -> None:
    """Riser with hose and head."""
    w, d, h = b.w, b.d, b.h
    b.rod((0, -d / 2 + 0.02, 0), (0, -d / 2 + 0.02, h - 0.03), 0.012, b.mat(), "riser", 10, solid=True)
    b.rod((0, -d / 2 + 0.02, h - 0.05), (0, d / 2 - 0.06, h - 0.02), 0.012, b.mat(), "arm")
    b.cyl(0, d / 2 - w * 0.3, (h - 0.07, h), w * 0.3, b.mat(), "head", n=20)
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.05), (0.0, 0.06), b.mat(), "mixer")


@recipe("curtain")
def curtain(b: Builder) -> None:
    """Folds on a rail, gathered at both sides; blinds; a curtain rail on the ceiling."""
    w, d, h = b.w, b.d, b.h
    main, style = b.mat(), b.p.get("style")
    if style == "blinds":
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.75, h), "plastic_white", "box")
        for k in range(4):
            b.box((-w / 2, w / 2), (-d * 0.4, d * 0.4), (h * k * 0.18, h * k * 0.18 + h * 0.1), main, "slats")
        return
    r = min(0.014, d * 0.12)
    y = 0.0 if style != "rail" else d / 2 - r
    b.rod((-w / 2, y, h - r), (w / 2, y, h - r), r, "metal_steel", "rail", solid=True)
    if style == "rail":
        for x in (-w / 2 + r, w / 2 - r):
            b.rod((x, -d / 2, h - r), (x, d / 2, h - r), r, "metal_steel", "rail")
    count = 4
    fold = min(0.07, w * 0.06)
    for side in (-1, 1):
        for k in range(count):
            x = side * (w / 2 - fold * (k + 0.5))
            depth = min(d / 2, 0.05)
            b.cushion(
                (x - fold / 2, x + fold / 2), (y - depth, min(d / 2, y + depth)), (0, h - r), main, "folds", 0.95, 8
            )
    if style != "rail":
        b.box((-w / 2, -w / 2 + 0.01), (-d / 2, d / 2), (h - 0.06, h), "metal_steel", "end", solid=False)
