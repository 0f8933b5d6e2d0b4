"""Batteries, charging docks and charging towers."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("battery")
def battery(b: Builder) -> None:
    """A dry cell: a black case with a copper end, a plus on its side, and a button at its pole."""
    w, d, h = b.w, b.d, b.h
    for profile, color in (
        (((0.5, 0), (0.5, 0.62)), b.mat()),
        (((0.5, 0.62), (0.5, 0.9), (0.47, 0.92)), "metal_copper"),
        (((0.4, 0.9), (0.4, 0.93)), "metal_light"),
        (((0.18, 0.92), (0.18, 1.0)), "metal_chrome"),
    ):
        b.lathe([(r, z * h) for r, z in profile], color, n=24, stretch=(w, d), part="cell")
    for half in ((w * 0.13, h * 0.03), (w * 0.045, h * 0.09)):
        b.box(
            (-half[0], half[0]),
            (d * 0.44, d * 0.505),
            (h * 0.76 - half[1], h * 0.76 + half[1]),
            "plastic_black",
            "sign",
            solid=False,
        )
        b.box(
            (w * 0.44, w * 0.505),
            (-half[0], half[0]),
            (h * 0.76 - half[1], h * 0.76 + half[1]),
            "plastic_black",
            "sign",
            solid=False,
        )
    bolt = [
        (w * 0.02, h * 0.56),
        (-w * 0.12, h * 0.32),
        (w * 0.02, h * 0.34),
        (-w * 0.02, h * 0.1),
        (w * 0.14, h * 0.38),
        (0.0, h * 0.36),
    ]
    b.prism([bolt[0], bolt[1], bolt[2], bolt[5]], (d * 0.44, d * 0.505), "paint_yellow", "y", "sign", solid=False)
    b.prism([bolt[2], bolt[3], bolt[4], bolt[5]], (d * 0.44, d * 0.505), "paint_yellow", "y", "sign", solid=False)


@recipe("dock")
def dock(b: Builder) -> None:
    """Charging station: a panel with a lightning bolt on it, a ramp, and a round robot that stands at its contacts."""
    w, d, h = b.w, b.d, b.h
    face = -d / 2 + 0.06
    b.box((-w * 0.4, w * 0.4), (-d / 2, face), (0, h), b.mat(), "panel")
    b.prism([(-d / 2, 0), (d / 2, 0), (d / 2, 0.006), (face, 0.02)], (-w / 2, w / 2), "plastic_dark", part="ramp")
    for side in (-1, 1):
        b.box((side * 0.06 - 0.015, side * 0.06 + 0.015), (face, face + 0.012), (0.05, 0.08), "metal_brass", "contacts")
    middle, r = h * 0.68, h * 0.24
    bolt = ((0.1, 1.0), (-0.55, -0.15), (0.0, -0.1), (-0.15, -1.0), (0.55, 0.2), (0.0, 0.15))
    for part in ((0, 1, 2, 5), (2, 3, 4, 5)):
        outline = [(bolt[k][0] * r, middle + bolt[k][1] * r) for k in part]
        b.prism(outline, (face, face + 0.006), "light_e5b920", "y", "sign", solid=False)
    reach = min(w * 0.42, (d / 2 - face) * 0.5)
    y = d / 2 - reach
    b.lathe([(reach, 0.02), (reach, h * 0.2), (reach * 0.94, h * 0.24)], "plastic_dark", (0, y), "robot", 28)
    b.cyl(0, y, (h * 0.24, h * 0.27), reach * 0.3, "metal_light", "robot", n=20)
    b.box(
        (-reach * 0.12, reach * 0.12),
        (y + reach * 0.5, y + reach * 0.7),
        (h * 0.24, h * 0.25),
        "light_green",
        "robot",
        solid=False,
    )


@recipe("charging_tower")
def charging_tower(b: Builder) -> None:
    """A column with a bolt of lightning in a lit sign, and shelves round it where telephones lie on their cables."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.05), "metal_dark", "foot")
    b.box((-w * 0.2, w * 0.2), (-d * 0.2, d * 0.2), (0.05, h * 0.66), b.mat(), "column")
    b.box((-w * 0.36, w * 0.36), (-d * 0.1, d * 0.1), (h * 0.66, h), b.mat(), "head")
    _lightning_sign(b)
    for level in range(2):
        z = h * (0.34 + 0.24 * level)
        b.box((-w * 0.44, w * 0.44), (-d * 0.44, d * 0.44), (z - 0.02, z), "plastic_white", "shelves")
        for k in range(3):
            _charging_telephone(
                b, w * (-0.28 + 0.28 * k), z, ("light_green", "screen_3f8fd0", "light_orange")[(k + level) % 3]
            )
            side = d * (-0.24 + 0.24 * k)
            b.prism(
                [(w * 0.24, z), (w * 0.28, z), (w * 0.22, z + 0.13), (w * 0.2, z + 0.13)],
                (side - 0.035, side + 0.035),
                "plastic_black",
                "y",
                "telephones",
            )


def _charging_telephone(b: Builder, x: float, z: float, screen: str) -> None:
    """A telephone that leans on the shelf at height `z`, with its cable."""
    d = b.d
    b.prism(
        [(d * 0.22, z), (d * 0.26, z), (d * 0.2, z + 0.13), (d * 0.18, z + 0.13)],
        (x - 0.035, x + 0.035),
        "plastic_black",
        part="telephones",
    )
    face = DrawnFace.sloped(b, (d * 0.26, z), (d * 0.2, z + 0.13))
    face.field((-x - 0.03, -x + 0.03), (0.01, 0.12), screen, "telephones", 0.002)
    cable = [
        (x, d * 0.24, z + 0.004),
        (x + 0.03, d * 0.38, z + 0.006),
        (x, d * 0.43, z - 0.05),
        (x * 0.4, d * 0.2, z - 0.1),
    ]
    b.path(cable, 0.006, "plastic_white", "cables")


def _lightning_sign(b: Builder) -> None:
    """A lit sign with a bolt of lightning."""
    w, d, h = b.w, b.d, b.h
    bolt = ((0.1, 1.0), (-0.55, -0.15), (0.0, -0.1), (-0.15, -1.0), (0.55, 0.2), (0.0, 0.15))
    face = DrawnFace.front(b, d * 0.1)
    face.field((-w * 0.33, w * 0.33), (h * 0.68, h * 0.98), "light_4f9bf0", "sign", 0.006)
    middle, r = h * 0.83, h * 0.13
    for part in ((0, 1, 2, 5), (2, 3, 4, 5)):
        outline = [(bolt[k][0] * r, middle + bolt[k][1] * r) for k in part]
        b.prism(outline, (d * 0.1 + 0.006, d * 0.1 + 0.012), "light_yellow", "y", "sign")
