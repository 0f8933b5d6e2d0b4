"""Large appliances of kitchens and laundries: refrigerators, ovens, washers, dishwashers, hoods."""

import itertools
import math
from typing import Any

from mansion_assets.builder import Builder, Rect
from mansion_assets.catalogue.receptacles import Receptacle, inset, surface, volume
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@receptacles("fridge", "freezer")
def _fridge_shelves(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    count = int(p.get("shelves", max(1, round(h / 0.42))))
    wall, z0 = 0.05, min(0.12, h * 0.1)
    step = (h - z0 - wall) / count
    box = (-w / 2 + wall, w / 2 - wall, -d / 2 + wall, d / 2 - 0.09)
    return [volume("shelf", box, z0 + i * step, z0 + (i + 1) * step - 0.02) for i in range(count)]


@recipe("fridge")
def fridge(b: Builder) -> None:
    """Case with boards inside, two doors with a gap, handles."""
    w, d, h = b.w, b.d, b.h
    main, face = b.mat(), d / 2 - 0.075
    b.hollow((-w / 2, w / 2), (-d / 2, face), (0.02, h), 0.045, main)
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2 + 0.03, face - 0.03), (0, 0.03), "plastic_black", "feet", solid=False)
    for cell in b.cells:
        b.box((cell.x0, cell.x1), (cell.y0, min(cell.y1, face)), (cell.z - 0.012, cell.z), "glass_white", "boards")
    split = (0.03, h) if b.p.get("doors") == 1 else (0.03, h * 0.36, h)
    for z0, z1 in itertools.pairwise(split):
        panel = ((-w / 2, w / 2), (face + 0.006, d / 2 - 0.03), (z0, z1 - 0.008))
        zm = z0 + 0.12 if z0 > 0.1 else z1 - 0.5 * (z1 - z0)
        with b.door(*panel):
            b.box(*panel, main, "door", solid=False)
            b.box(
                (w / 2 - 0.085, w / 2 - 0.05),
                (d / 2 - 0.03, d / 2),
                (zm, zm + min(0.5, (z1 - z0) * 0.45)),
                "metal_light" if "black" in main else "metal_dark",
                "handle",
                solid=False,
            )
            if z0 > 0.1:
                _dispenser(b, (z0, z1))
    b.box((-w / 2, w / 2), (-d / 2, face), (h - 0.004, h), main, "case", solid=False)


def _dispenser(b: Builder, z: tuple[float, float]) -> None:
    """A recess for cold water with its lit panel, and a blue flake, on the upper door of a fridge."""
    w = b.w
    face = DrawnFace.front(b, b.d / 2 - 0.03)
    low, tall = z[0] + (z[1] - z[0]) * 0.3, min(0.34, (z[1] - z[0]) * 0.36)
    face.field((-w * 0.16, w * 0.16), (low, low + tall), "plastic_black", "dispenser", 0.004)
    face.field((-w * 0.12, w * 0.12), (low + tall * 0.06, low + tall * 0.62), "metal_grey", "dispenser", 0.006)
    face.field((-w * 0.02, w * 0.02), (low + tall * 0.42, low + tall * 0.62), "plastic_black", "dispenser", 0.016)
    face.field((-w * 0.12, w * 0.12), (low + tall * 0.7, low + tall * 0.94), "light_4fd0f0", "dispenser", 0.007)
    top = z[1] - (z[1] - z[0]) * 0.16
    for k in range(3):
        a = math.pi / 2 + k * math.pi / 3
        arm = (math.cos(a) * w * 0.07, math.sin(a) * w * 0.07)
        face.line([(-arm[0], top - arm[1]), (arm[0], top + arm[1])], w * 0.01, "plastic_3f8fe0", "flake")


@recipe("freezer")
def freezer(b: Builder) -> None:
    """A fridge whose door shows -18 degrees above icicles, a large snowflake, and frosted drawers behind a pane."""
    fridge(b)
    w, h = b.w, b.h
    face = DrawnFace.front(b, b.d / 2 - 0.03)
    with b.fixed_to("door_1"):
        face.field((-w * 0.46, w * 0.46), (h * 0.89, h * 0.975), "plastic_1c2a3a", "controls", 0.004)
        face.write("-18", (-w * 0.1, w * 0.42), (h * 0.903, h * 0.962), "light_6fd8ff", "controls", 0.007)
        for k in range(12):
            u, tall = w * (-0.46 + 0.92 * k / 12), h * (0.03 + 0.016 * ((k * 5) % 4))
            icicle = [(-u, h * 0.89), (-u - w * 0.077, h * 0.89), (-u - w * 0.038, h * 0.89 - tall)]
            b.prism(icicle, (b.d / 2 - 0.03, b.d / 2 - 0.018), "plastic_a8dcf5", "y", "icicles", solid=False)
        _snowflake(face, (w * 0.04, h * 0.66), w * 0.3)
        face.field((-w * 0.32, w * 0.44), (h * 0.06, h * 0.46), "plastic_1c2a3a", "pane", 0.004)
        for k in range(3):
            low = h * (0.07 + 0.13 * k)
            face.field((-w * 0.3, w * 0.42), (low, low + h * 0.12), "plastic_cfeaf8", "drawers", 0.008)
            face.field((-w * 0.08, w * 0.2), (low + h * 0.075, low + h * 0.095), "plastic_3f8fd0", "grips", 0.014)


def _snowflake(face: DrawnFace, middle: tuple[float, float], r: float) -> None:
    """Six arms, each with two pairs of side arms."""
    u, v = middle
    for k in range(6):
        a = math.pi / 2 + k * math.pi / 3
        face.line([middle, (u + math.cos(a) * r, v + math.sin(a) * r)], r * 0.07, "plastic_1f7fe0", "snowflake")
        for share in (0.45, 0.72):
            root = (u + math.cos(a) * r * share, v + math.sin(a) * r * share)
            tips = [
                (root[0] + math.cos(a + turn) * r * 0.28, root[1] + math.sin(a + turn) * r * 0.28)
                for turn in (-math.pi / 3.6, math.pi / 3.6)
            ]
            face.line([tips[0], root, tips[1]], r * 0.055, "plastic_1f7fe0", "snowflake")


@recipe("display_fridge")
def display_fridge(b: Builder) -> None:
    """Cooler with shelves behind glass doors."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    b.hollow((-w / 2, w / 2), (-d / 2, d / 2 - 0.04), (0, h), 0.05, main)
    for cell in b.cells:
        board = (cell.z - 0.015, cell.z)
        b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, d / 2 - 0.1), board, "metal_steel", "boards")
    doors = max(1, round(w / 0.7))
    for k in range(doors):
        x0 = -w / 2 + k * w / doors
        x1 = x0 + w / doors
        pane = ((x0 + 0.004, x1 - 0.004), (d / 2 - 0.038, d / 2 - 0.02), (0.1, h - 0.16))
        with b.door(*pane):
            b.box(*pane, "glass_clear", "door", solid=False)
            grip = ((x1 - 0.08, x1 - 0.06), (d / 2 - 0.02, d / 2), (h * 0.4, h * 0.6))
            b.box(*grip, "metal_steel", "handle", solid=False)
    b.box((-w / 2, w / 2), (d / 2 - 0.05, d / 2 - 0.03), (h - 0.15, h), "light_white", "sign", solid=False)


@receptacles("oven")
def _oven_cavity(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    wall = min(0.05, w * 0.1)
    box = (-w / 2 + wall, w / 2 - wall * (3 if p.get("panel") == "side" else 1), -d / 2 + wall, d / 2 - wall)
    low = float(p.get("base", 0.25 if h > 0.6 else 0.03))
    out: list[Receptacle] = [volume("cavity", box, low, h - max(0.04, h * 0.22 if h > 0.6 else 0.04))]
    if 0.5 < h <= 1.2:
        out.append(surface("top", inset(size, 0.05), h, 0.8))
    return out


@recipe("oven")
def oven(b: Builder) -> None:
    """Oven, stove with a hob, microwave or dishwasher."""
    w, d = b.w, b.d
    face = d / 2 - min(0.05, d * 0.12)
    side = b.p.get("panel") == "side"
    right = b.cells[0].x1 + 0.01 if side else w / 2
    grip = d / 2 - min(0.03, d * 0.06)
    _oven_case(b, face)
    _oven_door(b, right, (face + 0.004, grip), sideways=side)
    if side:
        _side_panel(b, right, face)
    else:
        _knobs(b, face)
    if b.p.get("hob"):
        _hob(b, face)


def _oven_case(b: Builder, face: float) -> None:
    """Case about the cell, open to the front."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    cell = b.cells[0]
    t = min(0.03, w * 0.06)
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + t), (0, h), main, "case")
    b.box((-w / 2, cell.x0), (-d / 2, face), (0, h), main, "case")
    b.box((cell.x1, w / 2), (-d / 2, face), (0, h), main, "case")
    b.box((-w / 2, w / 2), (-d / 2, face), (0, cell.z), main, "case")
    b.box((-w / 2, w / 2), (-d / 2, face), (cell.top, h), main, "case")


def _oven_door(b: Builder, right: float, front: tuple[float, float], *, sideways: bool) -> None:
    """Door with a window and a handle: it turns at its left edge, or falls at its lower one."""
    w, d, cell = b.w, b.d, b.cells[0]
    t = min(0.03, w * 0.06)
    panel = ((-w / 2 + 0.005, right - 0.005), front, (cell.z - t, cell.top + t * 0.6))
    with b.door(*panel, "left" if sideways else "bottom"):
        b.box(*panel, b.mat(), "door", solid=False)
        b.box(
            (cell.x0 + 0.02, cell.x1 - 0.02),
            (front[1], front[1] + 0.003),
            (cell.z + 0.03, cell.top - 0.04),
            "glass_black",
            "window",
            solid=False,
        )
        if sideways:
            grip = ((right - 0.02, right - 0.01), (front[1], d / 2), (cell.z, cell.top))
        else:
            grip = ((-w * 0.38, w * 0.38), (front[1], d / 2), (cell.top - 0.01, cell.top + 0.008))
        b.box(*grip, "metal_steel", "handle", solid=False)


def _side_panel(b: Builder, right: float, face: float) -> None:
    """Display and buttons beside the door."""
    w, h = b.w, b.h
    b.box((right + 0.01, w / 2 - 0.01), (face, face + 0.01), (h * 0.7, h * 0.85), "screen_green", "panel", solid=False)
    for k in range(4):
        b.box(
            (right + 0.015, w / 2 - 0.015),
            (face, face + 0.012),
            (h * (0.18 + 0.11 * k), h * (0.25 + 0.11 * k)),
            "plastic_dark",
            "buttons",
            solid=False,
        )


def _knobs(b: Builder, face: float) -> None:
    """A row of knobs above the door."""
    w, d, h = b.w, b.d, b.h
    cell = b.cells[0]
    for k in range(4 if h > 0.6 else 2):
        x = -w * 0.3 + k * w * 0.2
        b.rod(
            (x, face, (cell.top + h) / 2),
            (x, d / 2 - 0.005, (cell.top + h) / 2),
            min(0.022, (h - cell.top) * 0.3),
            "plastic_black",
            "knobs",
            12,
        )


def _hob(b: Builder, face: float) -> None:
    """Glass hob with four burners."""
    w, d, h = b.w, b.d, b.h
    b.box(
        (-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.04, face - 0.03), (h - 0.006, h), "glass_black", "hob", solid=False
    )
    for sx in (-1, 1):
        for sy in (-1, 1):
            b.cyl(sx * w * 0.24, sy * d * 0.2 - 0.01, (h - 0.005, h), 0.075, "metal_dark", "burners", n=20, solid=False)


@recipe("hood")
def hood(b: Builder) -> None:
    """Extractor: sloped hood with a duct."""
    w, d, h = b.w, b.d, b.h
    low = min(0.06, h * 0.15)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, low), b.mat(), "rim")
    b.prism(
        [(-d / 2, low), (d / 2, low), (-d / 2 + 0.22, h * 0.45), (-d / 2, h * 0.45)],
        (-w * 0.48, w * 0.48),
        b.mat(),
        part="slope",
    )
    b.box((-0.14, 0.14), (-d / 2, -d / 2 + 0.22), (h * 0.45, h), b.mat(), "duct")
    b.box((-w * 0.3, w * 0.3), (-d * 0.2, d * 0.3), (0, 0.004), "light_warm", "lamp", solid=False)


@receptacles("washer", "clothes_dryer")
def _washer_drum(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, h = size
    high = h / int(p.get("stack", 1))
    box = (-w * 0.3, w * 0.3, -d * 0.35, d * 0.3)
    return [volume("drum", box, high * 0.2, high * 0.72)]


@recipe("washer")
def washer(b: Builder) -> None:
    """Washing machine or dryer with a round door; two of them in a tower."""
    w, d, h = b.w, b.d, b.h
    main, count = b.mat(), int(b.p.get("stack", 1))
    for k in range(count):
        z0, z1 = h * k / count, h * (k + 1) / count
        top = z1 - 0.004 * (k < count - 1)
        b.hollow((-w / 2, w / 2), (-d / 2, d / 2 - 0.06), (z0, top), 0.06, main)
        zm, r = z0 + (z1 - z0) * 0.45, min(w, z1 - z0) * 0.3
        _washer_front(b, (z0, top), zm, 0.68 * r)
        with b.door((-r, r), (d / 2 - 0.049, d / 2 - 0.012), (zm - r, zm + r)):
            b.rod((0, d / 2 - 0.049, zm), (0, d / 2 - 0.012, zm), r, "metal_chrome", "door", 28)
            b.rod((0, d / 2 - 0.03, zm), (0, d / 2, zm), r * 0.78, "glass_black", "door", 28)
        b.box(
            (-w / 2 + 0.01, w / 2 - 0.01),
            (d / 2 - 0.05, d / 2 - 0.04),
            (z1 - (z1 - z0) * 0.16, z1 - 0.02),
            "plastic_dark",
            "panel",
            solid=False,
        )
        b.rod(
            (w * 0.3, d / 2 - 0.05, z1 - (z1 - z0) * 0.09),
            (w * 0.3, d / 2 - 0.02, z1 - (z1 - z0) * 0.09),
            0.03,
            "metal_chrome",
            "dial",
            16,
        )
        b.box(
            (-w / 2 + 0.03, -w / 2 + 0.2),
            (d / 2 - 0.04, d / 2 - 0.035),
            (z1 - (z1 - z0) * 0.13, z1 - (z1 - z0) * 0.05),
            main,
            "drawer",
            solid=False,
        )


def _washer_front(b: Builder, z: tuple[float, float], middle: float, half: float) -> None:
    """Plate around a square hole, which the door covers."""
    w, y = b.w, (b.d / 2 - 0.06, b.d / 2 - 0.05)
    for beside in ((-w / 2, -half), (half, w / 2)):
        b.box(beside, y, z, b.mat(), "front", solid=False)
    for level in ((z[0], middle - half), (middle + half, z[1])):
        b.box((-half, half), y, level, b.mat(), "front", solid=False)


@recipe("clothes_dryer")
def clothes_dryer(b: Builder) -> None:
    """A white drum behind a round dark door that shows laundry, the word DRY beside waves of heat, a flap for lint."""
    w, d, h = b.w, b.d, b.h
    b.hollow((-w / 2, w / 2), (-d / 2, d / 2 - 0.06), (0, h), 0.06, b.mat())
    middle, r = h * 0.45, min(w, h) * 0.3
    _washer_front(b, (0, h), middle, 0.68 * r)
    with b.door((-r, r), (d / 2 - 0.049, d / 2 - 0.012), (middle - r, middle + r)):
        b.rod((0, d / 2 - 0.049, middle), (0, d / 2 - 0.012, middle), r, "plastic_e4e6e8", "door", 28)
        face = DrawnFace.front(b, d / 2 - 0.012)
        face.disc(0, middle, r * 0.74, "glass_black", "door", 0.002, 28)
        face.field((-r * 0.98, -r * 0.84), (middle - r * 0.16, middle + r * 0.16), "plastic_dark", "grip", 0.012)
        _heat_waves(face, 0.0, middle, r * 0.5, "light_ff8a3a")
    panel = DrawnFace.front(b, d / 2 - 0.05)
    panel.field((-w / 2 + 0.01, w / 2 - 0.01), (h * 0.83, h * 0.98), "plastic_dark", "panel", 0.006)
    panel.write("DRYER", (-w * 0.44, w * 0.16), (h * 0.86, h * 0.95), "plastic_white", "letters", 0.01)
    panel.disc(w * 0.33, h * 0.905, h * 0.045, "metal_chrome", "dial", 0.03, 18)
    panel.field((w * 0.325, w * 0.335), (h * 0.91, h * 0.945), "plastic_black", "dial", 0.032)
    panel.field((w * 0.06, w * 0.44), (h * 0.03, h * 0.13), "plastic_c9ccd0", "lint_flap", 0.006)
    for k in range(4):
        level = h * (0.045 + 0.02 * k)
        panel.field((w * 0.08, w * 0.42), (level, level + h * 0.009), "plastic_dark", "lint_flap", 0.009)


def _heat_waves(face: DrawnFace, u: float, v: float, r: float, material: str) -> None:
    """Three waved lines that rise, the sign of warm air."""
    for k in range(3):
        across = u + (k - 1) * r * 0.62
        wave = [(across + r * 0.16 * math.sin(j * math.pi / 3), v + r * (j / 4.5 - 1)) for j in range(10)]
        face.line(wave, r * 0.085, material, "heat", 0.006)


@recipe("dishwasher")
def dishwasher(b: Builder) -> None:
    """A front with a strip of lit buttons and a bar, over a door that bears the signs of plates, a glass and drops."""
    w, d, h = b.w, b.d, b.h
    face, cell = d / 2 - min(0.05, d * 0.12), b.cells[0]
    t = min(0.03, w * 0.06)
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + t), (0, h), b.mat(), "case")
    b.box((-w / 2, cell.x0), (-d / 2, face), (0, h), b.mat(), "case")
    b.box((cell.x1, w / 2), (-d / 2, face), (0, h), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d / 2, face), (0, cell.z), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d / 2, face), (cell.top, h), b.mat(), "case")
    b.box(
        (-w * 0.48, w * 0.48),
        (face - 0.02, face + 0.002),
        (0, min(0.09, h * 0.1)),
        "plastic_black",
        "plinth",
        solid=False,
    )
    front = (face + 0.004, d / 2 - min(0.03, d * 0.06))
    panel = ((-w / 2 + 0.005, w / 2 - 0.005), front, (min(0.1, h * 0.12), cell.top - 0.01))
    with b.door(*panel, "bottom"):
        b.box(*panel, b.mat(), "door", solid=False)
        b.box(
            (-w * 0.4, w * 0.4),
            (front[1], d / 2),
            (cell.top - 0.06, cell.top - 0.045),
            "metal_chrome",
            "handle",
            solid=False,
        )
        sign = DrawnFace.front(b, front[1])
        for k in range(3):
            sign.disc(w * (-0.2 + 0.14 * k), h * 0.45, h * 0.13, "plastic_white", "plates", 0.004 + 0.002 * k, 24)
            sign.disc(w * (-0.2 + 0.14 * k), h * 0.45, h * 0.08, "plastic_8fb6d9", "plates", 0.005 + 0.002 * k, 20)
        for k in range(4):
            u, v = w * (-0.3 + 0.2 * k), h * (0.64 - 0.03 * (k % 2))
            sign.disc(u, v, h * 0.02, "plastic_3f8fe0", "drops", 0.006, 12)
            sign.line([(u, v), (u, v + h * 0.045)], h * 0.008, "plastic_3f8fe0", "drops", 0.004)
        sign.field((-w * 0.34, w * 0.34), (h * 0.28, h * 0.3), "metal_dark", "rack", 0.006)
        for k in range(9):
            u = w * (-0.32 + 0.08 * k)
            sign.line([(u, h * 0.29), (u, h * 0.38)], h * 0.007, "metal_dark", "rack", 0.014)
    _button_strip(b, face, front, cell)


def _button_strip(b: Builder, face: float, front: tuple[float, float], cell: Rect) -> None:
    """A black strip with a lit display and four buttons."""
    w, h = b.w, b.h
    strip = DrawnFace.front(b, face)
    strip.field((-w * 0.48, w * 0.48), (cell.top + 0.005, h * 0.98), "plastic_black", "strip", front[1] - face)
    strip.field((w * 0.1, w * 0.4), (h * 0.885, h * 0.955), "light_4fd0f0", "strip", front[1] - face + 0.004)
    for k in range(4):
        strip.disc(w * (-0.4 + 0.1 * k), h * 0.92, h * 0.018, "metal_chrome", "strip", front[1] - face + 0.006)
