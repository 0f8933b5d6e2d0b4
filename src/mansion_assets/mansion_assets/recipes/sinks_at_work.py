"""Sinks of operating theatres and of kitchens that wash up for many."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.recipes.sanitary_ware import shallow_bowl, sink
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("scrub_sink")
def scrub_sink(b: Builder) -> None:
    """Two bowls below a wall that says SCRUB, with tall bent taps, soap, brushes, and boards to push with the knee."""
    sink(b)
    w, d, h = b.w, b.d, b.h
    rim, bowl = h - float(b.p["splash"]), b.cells[0]
    back = -d / 2 + 0.03
    b.box((-w / 2, w / 2), (-d / 2, back), (rim, h), "metal_steel", "splash")
    wall = DrawnFace.front(b, back)
    wall.field((-w * 0.48, w * 0.48), (h - 0.17, h - 0.015), "plastic_18808a", "sign", 0.006)
    wall.write("SURGICAL SCRUB", (-w * 0.46, w * 0.46), (h - 0.155, h - 0.03), "plastic_white", "letters", 0.01)
    second = -w * 0.3
    shallow_bowl(b, second, rim)
    for x in ((bowl.x0 + bowl.x1) / 2, second):
        bend = [
            (x + math.cos(a) * 0.0, back + 0.1 - math.cos(a) * 0.08, h - 0.2 + math.sin(a) * 0.07)
            for a in (0, 0.8, 1.57, 2.4, 3.14)
        ]
        b.path([(x, back + 0.02, rim), *bend, (x, back + 0.18, h - 0.26)], 0.018, "metal_chrome", "tap")
        soap, y = x + 0.2, back + 0.045
        b.cyl(soap, y, (rim, rim + 0.15), 0.045, "plastic_f08fb0", "soap", n=14, solid=False)
        b.cyl(soap, y, (rim + 0.15, rim + 0.2), 0.014, "plastic_white", "soap", n=8, solid=False)
        b.box(
            (soap - 0.014, soap + 0.014), (y, y + 0.06), (rim + 0.19, rim + 0.21), "plastic_white", "soap", solid=False
        )
        knee = DrawnFace.front(b, d / 2 - 0.06)
        knee.field((-x - 0.13, -x + 0.13), (rim - 0.36, rim - 0.14), "plastic_26272b", "knee_boards", 0.058)
        knee.write("KNEE", (-x - 0.1, -x + 0.1), (rim - 0.32, rim - 0.18), "plastic_white", "letters", 0.06)
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (d / 2 - 0.1, d / 2 - 0.06), (rim - 0.4, rim - 0.05), "metal_steel", "apron")


@recipe("dishwashing_station")
def dishwashing_station(b: Builder) -> None:
    """A sink with a spray on a spring above it, a rack of plates beside, more plates and glasses on the shelf below."""
    sink(b)
    w, d, h = b.w, b.d, b.h
    rim, bowl = h - float(b.p["splash"]), b.cells[0]
    back = -d / 2 + 0.02
    b.box((-w / 2, w / 2), (-d / 2, back), (rim, h), "metal_steel", "splash")
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (d / 2 - 0.05, d / 2 - 0.02), (rim - 0.25, rim - 0.04), "metal_steel", "apron")
    front = DrawnFace.front(b, d / 2 - 0.02)
    front.field((-w * 0.46, w * 0.46), (rim - 0.24, rim - 0.05), "plastic_1f6fd0", "sign", 0.008)
    front.write("WASH DISHES", (-w * 0.44, w * 0.44), (rim - 0.22, rim - 0.07), "plastic_white", "letters", 0.012)
    b.box((bowl.x0, bowl.x1), (bowl.y0, bowl.y1), (bowl.z, bowl.z + 0.003), "plastic_7fd0f0", "water", solid=False)
    _spray(b, bowl.x0 + 0.06, rim)
    _rack(b, (bowl.x1 + 0.04, w / 2 - 0.03), rim)
    count = int((w - 0.3) / 0.3)
    for k in range(count):
        x = -w / 2 + 0.15 + (k + 0.5) * (w - 0.3) / count
        for level in range(6):
            z = 0.22 + 0.03 * level
            b.lathe(
                [(0.06, z), (0.12, z + 0.024)],
                ("ceramic_ffffff", "ceramic_a8c4e0")[level % 2],
                (x, 0.06),
                "plates",
                16,
                solid=False,
            )


def _spray(b: Builder, x: float, rim: float) -> None:
    """A riser, a hose in a spring that bends over, and a trigger head."""
    y, h = -b.d / 2 + 0.06, b.h
    b.rod((x, y, rim), (x, y, h - 0.05), 0.014, "metal_chrome", "spray", 8)
    bend = [
        (x, y + 0.13 - math.cos(a) * 0.13, h - 0.07 + math.sin(a) * 0.05) for a in (0, 0.6, 1.2, 1.57, 2.0, 2.6, 3.14)
    ]
    b.path(bend, 0.02, "plastic_26272b", "spray")
    for k in range(6):
        z = rim + 0.03 + 0.025 * k
        b.cyl(x, y, (z, z + 0.012), 0.026, "metal_chrome", "spring", n=12, solid=False)
    head = bend[-1]
    b.taper((x, head[1], head[2] + 0.01), (x, head[1], rim + 0.04), (0.022, 0.05), "plastic_d8281e", "spray_head", 14)


def _rack(b: Builder, x: tuple[float, float], rim: float) -> None:
    """A blue rack in which plates stand one behind the other."""
    d, tall = b.d, b.h - rim - 0.02
    y = (-d * 0.34, d * 0.4)
    b.box(x, y, (rim, rim + 0.02), "plastic_2f7fd0", "rack", solid=False)
    for z in (rim + 0.05, rim + 0.09):
        corners = [(x[0], y[0], z), (x[1], y[0], z), (x[1], y[1], z), (x[0], y[1], z), (x[0], y[0], z)]
        b.path(corners, 0.01, "plastic_2f7fd0", "rack")
    middle, r = (x[0] + x[1]) / 2, min((x[1] - x[0]) / 2 - 0.02, tall / 2)
    count = 6
    for k in range(count):
        at = y[0] + (y[1] - y[0]) * (k + 0.5) / count
        for share, color, thick in (
            (1.0, "ceramic_ffffff", 0.01),
            (0.75, "ceramic_2f6fd0", 0.012),
            (0.68, "ceramic_ffffff", 0.014),
        ):
            b.rod((middle, at, rim + 0.02 + r), (middle, at + thick, rim + 0.02 + r), r * share, color, "plates", 20)
