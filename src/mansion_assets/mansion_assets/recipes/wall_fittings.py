"""Switches, sockets and boxes on walls."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("light_switch")
def light_switch(b: Builder) -> None:
    """A plate with two screws and a rocker that is tilted, a red lamp in its upper end."""
    w, d, h = b.w, b.d, b.h
    plate = -d * 0.1
    b.cushion((-w / 2, w / 2), (-d / 2, plate), (0, h), b.mat(), "plate", 0.3)
    b.box(
        (-w * 0.26, w * 0.26),
        (plate - 0.001, plate + 0.001),
        (h * 0.22, h * 0.78),
        "plastic_dark",
        "recess",
        solid=False,
    )
    rocker = [
        (plate, h * 0.26),
        (d / 2, h * 0.26),
        (plate + d * 0.2, h * 0.5),
        (plate + d * 0.12, h * 0.74),
        (plate, h * 0.74),
    ]
    b.prism(rocker, (-w * 0.22, w * 0.22), "plastic_white", part="rocker")
    b.box(
        (-w * 0.06, w * 0.06),
        (plate + d * 0.12, plate + d * 0.2),
        (h * 0.64, h * 0.68),
        "light_red",
        "lamp",
        solid=False,
    )
    for z in (0.1, 0.9):
        b.rod((0, plate - 0.001, h * z), (0, plate + 0.0015, h * z), w * 0.05, "metal_steel", "screws", 12)


@recipe("wall_socket")
def wall_socket(b: Builder) -> None:
    """A plate with a round well that has two holes and earth clips, and a plug with its cable below it."""
    w, d, h = b.w, b.d, b.h
    plate = d * 0.2
    b.cushion((-w / 2, w / 2), (-d / 2, plate), (0, h), b.mat(), "plate", 0.3)
    r, z = min(w, h) * 0.36, h / 2
    b.rod((0, plate - 0.001, z), (0, d * 0.46, z), r * 1.1, b.mat(), "ring", 24)
    b.rod((0, d * 0.44, z), (0, d * 0.48, z), r * 0.96, "plastic_light", "well", 24)
    for side in (-1, 1):
        b.rod((side * r * 0.45, d * 0.46, z), (side * r * 0.45, d / 2, z), r * 0.17, "plastic_black", "holes", 14)
        clip = sorted((z + side * r * 0.9, z + side * r * 0.66))
        b.box((-r * 0.14, r * 0.14), (d * 0.44, d / 2), (clip[0], clip[1]), "metal_brass", "clips", solid=False)


@recipe("wall_box")
def wall_box(b: Builder) -> None:
    """Boxes on walls: first aid, air conditioners."""
    style = str(b.p.get("style", "plain"))
    front = _FRONTS.get(style)
    body = b.d * (0.9 if front is not None else 1.0)
    b.box((-b.w / 2, b.w / 2), (-b.d / 2, -b.d / 2 + body), (0, b.h), b.mat(), "case")
    if front is not None:
        front(b, (-b.d / 2 + body, b.d / 2))
    elif style == "vent":
        _slats(b)


def _cross(b: Builder, y: tuple[float, float]) -> None:
    """Cross of first aid."""
    w, h = b.w, b.h
    main = b.mat()
    other = "plastic_white" if main != "plastic_white" else "plastic_green"
    b.box((-w * 0.3, w * 0.3), y, (h * 0.42, h * 0.58), other, "cross", solid=False)
    b.box((-w * 0.09, w * 0.09), y, (h * 0.24, h * 0.76), other, "cross", solid=False)


def _slats(b: Builder) -> None:
    """Slats of an air outlet, and a lamp."""
    w, d, h = b.w, b.d, b.h
    for k in range(4):
        z = h * (0.08 + 0.07 * k)
        b.box((-w * 0.42, w * 0.42), (d / 2 - 0.003, d / 2), (z, z + h * 0.03), "plastic_dark", "slats", solid=False)
    b.box((w * 0.3, w * 0.4), (d / 2 - 0.003, d / 2), (h * 0.75, h * 0.82), "light_green", "led", solid=False)


_FRONTS = {"cross": _cross}
"""What stands out on the front of a box, from the case to the asset's front at `y`."""


@recipe("defibrillator")
def defibrillator(b: Builder) -> None:
    """A cabinet with the sign of defibrillators, a white heart with a flash on green, the letters AED and a handle."""
    w, d, h = b.w, b.d, b.h
    front = d * 0.36
    b.box((-w / 2, w / 2), (-d / 2, front), (0, h), b.mat(), "case")
    face = DrawnFace.front(b, front)
    green = "plastic_118a45"
    face.field((-w * 0.46, w * 0.46), (h * 0.36, h * 0.97), green, "sign", 0.004)
    _heart_with_flash(b, (0.0, h * 0.66), w * 0.36, front + 0.004, green)
    for wide, tall in ((0.03, 0.09), (0.09, 0.03)):
        middle = (w * 0.37, h * 0.9)
        face.field(
            (middle[0] - w * wide * 0.7, middle[0] + w * wide * 0.7),
            (middle[1] - w * tall * 0.7, middle[1] + w * tall * 0.7),
            "plastic_white",
            "cross",
            0.006,
        )
    face.write("AED", (-w * 0.44, w * 0.44), (h * 0.1, h * 0.32), "plastic_c81e28", "letters", 0.006)
    b.path(
        [
            (-w * 0.18, front, h * 0.05),
            (-w * 0.18, d / 2 - 0.008, h * 0.05),
            (w * 0.18, d / 2 - 0.008, h * 0.05),
            (w * 0.18, front, h * 0.05),
        ],
        0.008,
        "plastic_black",
        "handle",
    )


def _heart_with_flash(b: Builder, middle: tuple[float, float], r: float, y: float, ground: str) -> None:
    """A white heart as wide as twice `r` around (x, z), and a flash through it in the colour of the ground."""
    x, z = middle
    lobe, layer = r * 0.54, (y, y + 0.005)
    for side in (-1, 1):
        at = (x + side * r * 0.46, z + r * 0.32)
        b.rod((at[0], layer[0], at[1]), (at[0], layer[1], at[1]), lobe, "plastic_white", "heart", 22)
    point = [(-0.86, -0.04), (0.0, -0.92), (0.86, -0.04), (0.46, 0.5), (-0.46, 0.5)]
    b.prism([(x + u * r, z + v * r) for u, v in point], layer, "plastic_white", "y", "heart", solid=False)
    flash = (
        [(-0.02, 0.56), (-0.38, -0.06), (0.04, -0.06), (0.22, 0.56)],
        [(0.0, 0.12), (0.36, 0.12), (0.06, -0.62), (-0.12, -0.08)],
    )
    for bolt in flash:
        b.prism(
            [(x - u * r, z + v * r) for u, v in bolt], (layer[1], layer[1] + 0.003), ground, "y", "flash", solid=False
        )
