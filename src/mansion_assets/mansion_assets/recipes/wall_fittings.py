"""Switches, sockets and boxes on walls."""

from mansion_assets.builder import Builder
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
