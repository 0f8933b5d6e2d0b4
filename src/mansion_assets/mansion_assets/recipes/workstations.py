"""Benches, cubicles and consoles that people work at."""

from typing import Any

from mansion_assets.builder import Builder
from mansion_assets.catalogue.receptacles import Receptacle, surface
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@recipe("workbench")
def workbench(b: Builder) -> None:
    """Thick top, stout legs, lower shelf, vise at the front."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.06), (h - 0.07, h), b.mat(), "top")
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (w / 2 - 0.1), sy * (d / 2 - 0.12)
            b.box((x - 0.045, x + 0.045), (y - 0.045, y + 0.045), (0, h - 0.07), "metal_blue", "legs")
    b.box((-w / 2 + 0.06, w / 2 - 0.06), (-d / 2 + 0.08, d / 2 - 0.14), (0.16, 0.19), b.mat(), "shelf")
    b.box((-w / 2 + 0.1, -w / 2 + 0.3), (d / 2 - 0.06, d / 2), (h - 0.16, h - 0.02), "metal_dark", "vise")
    b.rod((-w / 2 + 0.1, d / 2 - 0.01, h - 0.1), (-w / 2 + 0.3, d / 2 - 0.01, h - 0.1), 0.01, "metal_steel", "vise")
    for k, color in enumerate(("plastic_red", "plastic_blue", "metal_grey")):
        x = -w / 2 + 0.35 + k * 0.3
        if x + 0.12 < w / 2:
            b.box((x, x + 0.24), (-d / 2 + 0.12, 0.1), (0.19, 0.36), color, "boxes", solid=False)


@recipe("packing_table")
def packing_table(b: Builder) -> None:
    """A bench with a roll of brown paper on a bar below its top, flat cartons on its shelf, and a tape on a hook."""
    w, d = b.w, b.d
    z = b.tops[0].z
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - 0.04, z), b.mat(), "top")
    b.legs((0, z - 0.04), 0.035, b.mat("frame", "metal_grey"), 0.02)
    shelf = b.tops[1].z if len(b.tops) > 1 else 0.2
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, d / 2 - 0.05), (shelf - 0.025, shelf), "metal_grey", "shelf")
    r = 0.15
    for x in (-w * 0.34, w * 0.16):
        b.box((x - 0.012, x + 0.012), (d / 2 - 0.16, d / 2 - 0.08), (z - 0.3, z - 0.04), "metal_dark", "brackets")
    y, axis = d / 2 - r - 0.02, z - 0.22
    b.rod((-w * 0.32, y, axis), (w * 0.14, y, axis), r, "paper_b98d5c", "paper", 24)
    b.rod((-w * 0.36, y, axis), (w * 0.18, y, axis), 0.025, "metal_steel", "paper", 10)
    b.prism(
        [(y + r - 0.006, axis), (y + r, axis), (y + r + 0.01, axis - 0.24), (y + r + 0.004, axis - 0.24)],
        (-w * 0.32, w * 0.14),
        "paper_b98d5c",
        part="paper",
    )
    b.rod((w * 0.3, d / 2 - 0.02, z - 0.16), (w * 0.3, d / 2 + 0.01, z - 0.16), 0.07, "plastic_d9a441", "tape", 20)
    b.rod((w * 0.3, d / 2 - 0.022, z - 0.16), (w * 0.3, d / 2 + 0.014, z - 0.16), 0.04, "paper_white", "tape", 16)
    DrawnFace.front(b, d / 2 - 0.035).write(
        "PACKING", (-w * 0.48, -w * 0.3), (z - 0.034, z - 0.006), "plastic_black", "letters", 0.036
    )


@receptacles("cubicle")
def _cubicle_top(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, _ = size
    box = (-w / 2 + 0.07, w / 2 - 0.07, -d / 2 + 0.07, -d / 2 + min(0.75, d * 0.8) - 0.03)
    return [surface("top", box, 0.74, 1.0)]


@recipe("cubicle")
def cubicle(b: Builder) -> None:
    """Desk within three screens."""
    w, d, h = b.w, b.d, b.h
    t = 0.05
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + t), (0, h), b.mat(), "screen")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - t)))
        b.box((lo, hi), (-d / 2 + t, d / 2), (0, h), b.mat(), "screen")
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, -d / 2 + min(0.75, d * 0.8)), (0.71, 0.74), "wood_white", "top")
    b.box(
        (-w / 2 + t, -w / 2 + t + 0.35), (-d / 2 + t, -d / 2 + min(0.6, d * 0.7)), (0.05, 0.6), "metal_grey", "drawers"
    )


@receptacles("control_desk")
def _control_desk_top(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    w, d, _ = size
    return [surface("top", (-w / 2 + 0.04, w / 2 - 0.04, 0.2, d / 2 - 0.02), 0.75, 1.0)]


@recipe("control_desk")
def control_desk(b: Builder) -> None:
    """Operator's console: desk with a row of screens."""
    w, d, h = b.w, b.d, b.h
    z = 0.75
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - 0.04, z), b.mat(), "top")
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.04)
        b.box((x - 0.04, x + 0.04), (-d / 2 + 0.02, d / 2 - 0.1), (0, z - 0.04), b.mat(), "legs")
    b.box((-w / 2 + 0.08, w / 2 - 0.08), (-d / 2 + 0.05, -d / 2 + 0.1), (0.1, z - 0.04), b.mat(), "back")
    count = max(2, round(w / 0.62))
    for k in range(count):
        x = -w / 2 + (k + 0.5) * w / count
        half = w / count / 2 - 0.02
        b.box((x - half, x + half), (-d / 2 + 0.1, -d / 2 + 0.13), (z + 0.12, h), "plastic_black", "screens")
        b.box(
            (x - half + 0.012, x + half - 0.012),
            (-d / 2 + 0.13, -d / 2 + 0.133),
            (z + 0.135, h - 0.015),
            "screen_blue",
            "screens",
            solid=False,
        )
        b.box(
            (x - 0.03, x + 0.03), (-d / 2 + 0.09, -d / 2 + 0.12), (z, z + 0.14), "plastic_black", "stands", solid=False
        )
        b.box((x - 0.2, x + 0.2), (0.05, 0.19), (z, z + 0.02), "plastic_dark", "keyboards", solid=False)


@recipe("mixing_desk")
def mixing_desk(b: Builder) -> None:
    """Sloped console with faders on a stand."""
    w, d, h = b.w, b.d, b.h
    b.prism(
        [(-d / 2, h * 0.72), (d / 2, h * 0.72), (d / 2, h * 0.8), (-d / 2, h)], (-w / 2, w / 2), b.mat(), part="console"
    )
    for sx in (-1, 1):
        x = sx * w * 0.4
        b.box((x - 0.03, x + 0.03), (-d * 0.4, d * 0.4), (0, 0.05), "metal_dark", "feet")
        b.box((x - 0.03, x + 0.03), (-0.05, 0.05), (0.05, h * 0.72), "metal_dark", "legs")
    for k in range(16):
        x = -w * 0.44 + k * w * 0.0587
        y = d * (0.2 + 0.1 * ((k * 3) % 4) / 3)
        z = h * 0.8 + (h * 0.2) * (0.5 - y / d)
        b.box((x - 0.008, x + 0.008), (y - 0.02, y + 0.02), (z, z + 0.02), "plastic_white", "faders", solid=False)
        for j in range(3):
            yy = -d * 0.35 + j * d * 0.14
            zz = h * 0.8 + h * 0.2 * (0.5 - yy / d)
            b.cyl(
                x,
                yy,
                (zz - 0.005, zz + 0.018),
                0.012,
                ("plastic_red", "plastic_blue", "plastic_grey")[j],
                "knobs",
                n=8,
                solid=False,
            )
    b.box((-w * 0.2, w * 0.2), (-d / 2, -d / 2 + 0.02), (h * 0.8, h), "screen_dark", "meters", solid=False)
