"""Machines in a case on the floor: copiers, lathes, and cabinets with doors or vents."""

from mansion_assets.builder import Builder
from mansion_assets.registry import Recipe, recipe

__all__: list[str] = []


@recipe("machine")
def machine(b: Builder) -> None:
    """A copier, a lathe, or a case with doors or vents."""
    _MACHINES.get(str(b.p.get("style", "vent")), _cabinet)(b)


def _cabinet(b: Builder) -> None:
    """Case on a foot, with doors or with vents."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    foot = min(0.06, h * 0.08)
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.02), (foot, h), m, "case")
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2 + 0.03, d / 2 - 0.05), (0, foot), "metal_dark", "feet")
    if b.p.get("style") == "doors":
        _doors(b, foot)
    else:
        _vents(b, foot)


def _doors(b: Builder, foot: float) -> None:
    """Two doors with a handle and a warning sign, above the foot."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    for k in range(2):
        x0 = -w / 2 + k * w / 2
        b.box(
            (x0 + 0.01, x0 + w / 2 - 0.01),
            (d / 2 - 0.02, d / 2 - 0.006),
            (foot + 0.02, h - 0.02),
            m,
            "door",
            solid=False,
        )
    b.box((-0.05, -0.03), (d / 2 - 0.006, d / 2), (h * 0.5, h * 0.58), "metal_dark", "handle", solid=False)
    b.prism(
        [(w * 0.2, h * 0.7), (w * 0.3, h * 0.7), (w * 0.25, h * 0.8)],
        (d / 2 - 0.006, d / 2 - 0.003),
        "paint_yellow",
        "y",
        "warning",
        solid=False,
    )


def _vents(b: Builder, foot: float) -> None:
    """Vents, a screen and a cap, above the foot."""
    w, d, h = b.w, b.d, b.h
    for k in range(6):
        z = foot + (h - foot) * (0.08 + 0.05 * k)
        b.box(
            (-w * 0.38, w * 0.38),
            (d / 2 - 0.02, d / 2),
            (z, z + (h - foot) * 0.025),
            "plastic_dark",
            "vents",
            solid=False,
        )
    b.box(
        (-w * 0.3, w * 0.05), (d / 2 - 0.02, d / 2 - 0.012), (h * 0.68, h * 0.86), "screen_green", "panel", solid=False
    )
    b.cyl(w * 0.25, 0, (h - 0.001, h), min(w, d) * 0.1, "plastic_dark", "cap", solid=False)


def _lathe(b: Builder) -> None:
    """Lathe: base, bed, head, chuck, work, tail and slide."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    b.box((-w / 2, -w * 0.2), (-d * 0.4, d * 0.4), (0, h * 0.5), m, "base")
    b.box((w * 0.25, w / 2), (-d * 0.4, d * 0.4), (0, h * 0.5), m, "base")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.5, h * 0.6), m, "bed")
    b.box((-w / 2, -w * 0.22), (-d * 0.4, d * 0.35), (h * 0.6, h), m, "head")
    b.rod((-w * 0.22, 0, h * 0.78), (-w * 0.14, 0, h * 0.78), h * 0.1, "metal_steel", "chuck", 20, solid=True)
    b.rod((-w * 0.14, 0, h * 0.78), (w * 0.3, 0, h * 0.78), 0.03, "metal_steel", "work")
    b.box((w * 0.3, w * 0.46), (-d * 0.2, d * 0.2), (h * 0.6, h * 0.86), m, "tail")
    b.box((0.0, w * 0.16), (-d * 0.3, d / 2), (h * 0.6, h * 0.7), "metal_steel", "slide")


def _copier(b: Builder) -> None:
    """Copier on the floor: trays below, scanner and panel on top."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.04), (0.04, h * 0.78), m, "case")
    b.box((-w / 2 + 0.04, w / 2 - 0.04), (-d / 2 + 0.04, d / 2 - 0.1), (0, 0.04), "plastic_dark", "feet")
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.08), (h * 0.86, h), m, "scanner")
    b.box((-w * 0.3, w / 2), (-d / 2, d / 2 - 0.2), (h * 0.78, h * 0.86), "plastic_dark", "gap")
    for k in range(3):
        z = 0.1 + k * h * 0.19
        b.box(
            (-w * 0.46, w * 0.46),
            (d / 2 - 0.04, d / 2 - 0.02),
            (z, z + h * 0.16),
            "plastic_light",
            "trays",
            solid=False,
        )
        b.box(
            (-0.08, 0.08),
            (d / 2 - 0.02, d / 2 - 0.01),
            (z + h * 0.1, z + h * 0.12),
            "plastic_dark",
            "trays",
            solid=False,
        )
    b.prism(
        [(d / 2 - 0.12, h * 0.86), (d / 2, h * 0.84), (d / 2, h * 0.87), (d / 2 - 0.1, h * 0.93)],
        (w * 0.05, w / 2),
        "screen_blue",
        part="panel",
    )


_MACHINES: dict[str, Recipe] = {"copier": _copier, "lathe": _lathe}
"""Styles with a shape of their own; the others are cabinets."""
