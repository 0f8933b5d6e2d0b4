"""Single pieces with a face of their own: long-case clock, umbrella stand, rice cooker, football, crayons."""

import math

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("long_case_clock")
def long_case_clock(b: Builder) -> None:
    """A tall case: a plinth, a waist with a glass door on a brass pendulum and weights, and a hood with the dial."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.2), main, "plinth")
    x, t = w * 0.36, 0.02
    b.box((-x, x), (-d / 2, -d * 0.4), (h * 0.2, h * 0.7), main, "waist")
    for side in (-1, 1):
        ends = sorted((side * x, side * (x - t * 2)))
        b.box((ends[0], ends[1]), (-d / 2, d * 0.4), (h * 0.2, h * 0.7), main, "waist")
    b.box((-x, x), (-d * 0.39, -d * 0.37), (h * 0.2, h * 0.7), "wood_black", "waist", solid=False)
    b.rod((0, 0, h * 0.36), (0, 0, h * 0.7), 0.01, "metal_brass", "pendulum")
    b.rod((0, -0.01, h * 0.34), (0, 0.02, h * 0.34), w * 0.16, "metal_brass", "pendulum", 24)
    for side, z in ((-1, 0.44), (1, 0.5)):
        b.cyl(side * w * 0.2, 0, (h * z, h * (z + 0.09)), 0.028, "metal_brass", "weights", n=14)
    b.box((-w * 0.47, w * 0.47), (-d / 2, d * 0.46), (h * 0.7, h * 0.94), main, "hood")
    b.prism(
        [(-w / 2, h * 0.94), (w / 2, h * 0.94), (w * 0.3, h * 0.97), (0, h), (-w * 0.3, h * 0.97)],
        (-d / 2, d / 2),
        main,
        "y",
        "hood",
    )
    z, r = h * 0.82, w * 0.36
    b.rod((0, d * 0.45, z), (0, d * 0.48, z), r, "metal_brass", "dial", 28)
    b.rod((0, d * 0.47, z), (0, d * 0.49, z), r * 0.9, "paper_white", "dial", 28)
    for k in range(12):
        a = k * math.pi / 6
        start, end = ((math.sin(a) * r * s, d * 0.49, z + math.cos(a) * r * s) for s in (0.68, 0.82))
        b.rod(start, end, 0.006, "plastic_black", "dial", 4)
    for a, reach in ((5.2, 0.45), (0.9, 0.66)):
        b.rod(
            (0, d * 0.49, z),
            (math.sin(a) * r * reach, d * 0.49, z + math.cos(a) * r * reach),
            0.007,
            "plastic_black",
            "hands",
            4,
        )


@recipe("umbrella_stand")
def umbrella_stand(b: Builder) -> None:
    """An open cylinder of bars with three furled umbrellas, their crooks over its rim."""
    w, d, h = b.w, b.d, b.h
    rim = h * 0.62
    b.lathe([(0.48, 0), (0.48, h * 0.04)], b.mat(), n=24, stretch=(w, d), part="tray")
    for k in range(14):
        a = k * math.pi / 7
        x, y = 0.46 * w * math.cos(a), 0.46 * d * math.sin(a)
        b.rod((x, y, h * 0.03), (x, y, rim), w * 0.016, b.mat(), "bars", 6)
    for z in (h * 0.34, rim):
        ring = [(0.46 * w * math.cos(k * math.pi / 10), 0.46 * d * math.sin(k * math.pi / 10), z) for k in range(21)]
        b.path(ring, w * 0.03, b.mat(), "hoops")
    for k, color in enumerate(("fabric_red", "fabric_blue", "fabric_3f8f4f")):
        a = 0.6 + k * 2 * math.pi / 3
        x, y = w * 0.18 * math.cos(a), d * 0.18 * math.sin(a)
        foot, neck = (x * 0.6, y * 0.6, h * 0.05), (x * 1.3, y * 1.3, h * 0.74)
        middle = ((foot[0] + neck[0]) / 2, (foot[1] + neck[1]) / 2, h * 0.5)
        b.rod(foot, middle, w * 0.045, color, "umbrellas", 8)
        b.rod(middle, neck, w * 0.08, color, "umbrellas", 8)
        top = (x * 1.5, y * 1.5, h * 0.92)
        hook = [
            (top[0] + w * 0.06 * (1 - math.cos(t)), top[1], top[2] + h * 0.06 * math.sin(t))
            for t in (j * math.pi / 5 for j in range(1, 6))
        ]
        b.path([neck, top, *hook], w * 0.022, "wood_walnut", "crooks")


@recipe("rice_cooker")
def rice_cooker(b: Builder) -> None:
    """A round pot with a domed lid, a knob and a steam vent, two ears, and a switch with lamps in front."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.42, 0), (0.48, h * 0.06), (0.5, h * 0.5), (0.48, h * 0.62)], b.mat(), n=28, stretch=(w, d))
    b.lathe(
        [(0.5, h * 0.6), (0.5, h * 0.65), (0.42, h * 0.76), (0.2, h * 0.86), (0.0, h * 0.88)],
        "metal_light",
        n=28,
        stretch=(w, d),
        part="lid",
    )
    b.lathe(
        [(0.06, h * 0.84), (0.06, h * 0.93), (0.1, h * 0.94), (0.1, h)],
        "plastic_black",
        n=16,
        stretch=(w, d),
        part="knob",
    )
    b.cyl(-w * 0.2, -d * 0.12, (h * 0.78, h * 0.88), w * 0.03, "plastic_black", "vent", n=10)
    b.prism(
        [(-w * 0.18, h * 0.1), (w * 0.18, h * 0.1), (w * 0.18, h * 0.46), (-w * 0.18, h * 0.46)],
        (d * 0.4, d * 0.52),
        "plastic_black",
        "y",
        "panel",
    )
    b.box((-w * 0.05, w * 0.05), (d * 0.52, d * 0.55), (h * 0.14, h * 0.26), "plastic_white", "switch")
    for x, color in ((-0.09, "light_red"), (0.09, "light_green")):
        b.rod((w * x, d * 0.51, h * 0.38), (w * x, d * 0.53, h * 0.38), w * 0.03, color, "lamps", 10)
    for side in (-1, 1):
        b.cushion(
            (side * w * 0.53 - w * 0.07, side * w * 0.53 + w * 0.07),
            (-d * 0.14, d * 0.14),
            (h * 0.46, h * 0.58),
            "plastic_black",
            "ears",
            0.6,
        )


@recipe("football")
def football(b: Builder) -> None:
    """A white ball with twelve black pentagons, at the corners of an icosahedron."""
    w, d, h = b.w, b.d, b.h
    b.ball((0, 0, h / 2), (w / 2, d / 2, h / 2), b.mat(), "ball", 24)
    golden = (1 + math.sqrt(5)) / 2
    corners = [p for s in (-1, 1) for t in (-golden, golden) for p in ((0, s, t), (s, t, 0), (t, 0, s))]
    length = math.hypot(1, golden)
    for corner in corners:
        x, y, z = (v / length for v in corner)
        reach = [(x * w * k, y * d * k, h / 2 + z * h * k) for k in (0.44, 0.503)]
        b.rod(reach[0], reach[1], w * 0.15, "plastic_black", "pentagons", 5)


@recipe("crayons")
def crayons(b: Builder) -> None:
    """An open carton of crayons that lie side by side, their points out in front, each of another colour."""
    w, d, h = b.w, b.d, b.h
    mouth = d * 0.1
    b.box((-w / 2, w / 2), (-d / 2, mouth), (0, h), b.mat(), "box")
    b.box((-w * 0.4, w * 0.4), (-d * 0.36, mouth - d * 0.08), (h, h * 1.02), "paint_2f9a4a", "label", solid=False)
    b.box((-w * 0.3, w * 0.3), (-d * 0.28, mouth - d * 0.2), (h, h * 1.04), "paper_yellow", "label", solid=False)
    colors = ("red", "orange", "yellow", "green", "blue", "purple", "pink", "brown")
    r = w / len(colors) / 2
    for k, color in enumerate(colors):
        x = -w / 2 + (2 * k + 1) * r
        reach = d * (0.36 if k % 2 else 0.32)
        b.rod((x, mouth - 0.004, h * 0.5), (x, reach, h * 0.5), r * 0.86, f"plastic_{color}", "crayons", 10)
        b.rod((x, reach - d * 0.06, h * 0.5), (x, reach - d * 0.03, h * 0.5), r * 0.9, "plastic_black", "crayons", 10)
        for j in range(3):
            b.rod(
                (x, reach + d * 0.045 * j, h * 0.5),
                (x, reach + d * 0.045 * (j + 1), h * 0.5),
                r * (0.66 - 0.2 * j),
                f"plastic_{color}",
                "points",
                8,
            )


@recipe("film_viewer")
def film_viewer(b: Builder) -> None:
    """A lit box with clips along its top and two X-ray films of a chest: spine and ribs, white on black."""
    w, d, h = b.w, b.d, b.h
    face = d * 0.3
    b.box((-w / 2, w / 2), (-d / 2, face), (0, h), "metal_grey", "case")
    b.box(
        (-w * 0.47, w * 0.47), (face - 0.001, face + 0.003), (h * 0.05, h * 0.93), "light_white", "glass", solid=False
    )
    for x in (-w * 0.235, w * 0.235):
        half = w * 0.19
        film = (face + 0.003, face + 0.006)
        b.box((x - half, x + half), film, (h * 0.1, h * 0.9), "plastic_1a1f2c", "films", solid=False)
        y = face + 0.008
        b.rod((x, y, h * 0.14), (x, y, h * 0.86), half * 0.09, "light_d5dde8", "bones", 6)
        for k in range(6):
            z = h * (0.74 - 0.09 * k)
            for side in (-1, 1):
                rib = [
                    (x, y, z),
                    (x + side * half * 0.5, y, z + h * 0.03),
                    (x + side * half * 0.8, y, z - h * 0.03),
                    (x + side * half * 0.72, y, z - h * 0.09),
                ]
                b.path(rib, half * 0.05, "light_d5dde8", "bones")
        b.box((x - half * 0.3, x + half * 0.3), (face, d / 2), (h * 0.9, h * 0.96), "metal_steel", "clips", solid=False)
