"""Games, sports, stages, dolls and fiddles."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("air_hockey")
def air_hockey(b: Builder) -> None:
    """A white top in a blue rim, with red and blue lines, goals, a puck and two mallets."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.9
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (top - 0.2, top - 0.04), "plastic_2f5fa8", "case")
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * (w / 2 - 0.07))), sorted((side * d / 2, side * (d / 2 - 0.07)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (top - 0.04, top + 0.03), "plastic_2f5fa8", "rails")
        b.box((-w / 2, w / 2), (along[0], along[1]), (top - 0.04, top + 0.03), "plastic_2f5fa8", "rails")
        b.box(
            (-w * 0.3, w * 0.3),
            (side * d * 0.36 - 0.12, side * d * 0.36 + 0.12),
            (0, top - 0.2),
            "plastic_dark",
            "legs",
        )
        goal = sorted((side * (d / 2 - 0.08), side * (d / 2 + 0.002)))
        b.box((-w * 0.2, w * 0.2), (goal[0], goal[1]), (top - 0.04, top + 0.012), "plastic_black", "goals", solid=False)
    b.box((-w / 2 + 0.07, w / 2 - 0.07), (-d / 2 + 0.07, d / 2 - 0.07), (top - 0.04, top), b.mat(), "field")
    field = DrawnFace.top(b, top)
    field.field((-w / 2 + 0.07, w / 2 - 0.07), (-0.012, 0.012), "paint_red", "lines")
    for v in (-d * 0.2, d * 0.2):
        field.field((-w / 2 + 0.07, w / 2 - 0.07), (v - 0.008, v + 0.008), "paint_blue", "lines")
    for v, r, color in ((0.0, 0.2, "paint_red"), (d * 0.46, 0.24, "paint_blue"), (-d * 0.46, 0.24, "paint_blue")):
        ring = [
            (math.cos(a) * w * r, v - math.copysign(abs(math.sin(a)), v) * w * r if v else math.sin(a) * w * r)
            for a in (k * math.tau / 24 for k in range(25))
        ]
        half = ring if not v else ring[:13]
        field.line(half, 0.009, color, "lines")
    for x, y, color in ((w * 0.14, d * 0.3, "plastic_red"), (-w * 0.1, -d * 0.3, "plastic_green")):
        b.lathe(
            [(0.1, top), (0.1, top + 0.035), (0.045, top + 0.05), (0.04, top + 0.1), (0.02, top + 0.115)],
            color,
            (x, y),
            "mallets",
            18,
        )
    b.cyl(-w * 0.16, d * 0.06, (top, top + 0.015), 0.07, "plastic_red", "puck", n=18)


@recipe("boxing_ring")
def boxing_ring(b: Builder) -> None:
    """A raised canvas between four posts with padded corners, red, blue and white, and three ropes round it; steps."""
    w, d, h = b.w, b.d, b.h
    deck, inset = h * 0.3, 0.3
    b.box((-w / 2 + 0.1, w / 2 - 0.1), (-d / 2 + 0.1, d / 2 - 0.1), (0, deck - 0.04), "fabric_dark", "skirt")
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2 + 0.05, d / 2 - 0.05), (deck - 0.05, deck), b.mat(), "apron")
    b.box(
        (-w / 2 + inset, w / 2 - inset),
        (-d / 2 + inset, d / 2 - inset),
        (deck, deck + 0.012),
        "fabric_dfe3e6",
        "canvas",
    )
    corners = ((-1, -1, "fabric_red"), (1, -1, "plastic_white"), (1, 1, "fabric_2f5fc8"), (-1, 1, "plastic_white"))
    x, y = w / 2 - inset, d / 2 - inset
    for sx, sy, color in corners:
        b.cyl(sx * x, sy * y, (0, h), 0.06, "metal_dark", "posts", n=12)
        b.cushion(
            (sx * x - 0.13, sx * x + 0.13), (sy * y - 0.13, sy * y + 0.13), (deck + 0.08, h * 0.98), color, "pads", 0.4
        )
    for k, color in enumerate(("paint_red", "plastic_white", "paint_2f5fc8")):
        z = deck + (h - deck) * (0.3 + 0.28 * k)
        ring = [(-x, -y, z), (x, -y, z), (x, y, z), (-x, y, z), (-x, -y, z)]
        b.path(ring, 0.03, color, "ropes")
    for k in range(2):
        b.box((-0.5, 0.5), (d / 2 - 0.1, d / 2 + 0.25 - 0.25 * k), (0, deck * (0.4 + 0.3 * k)), "metal_dark", "steps")
    DrawnFace.top(b, deck + 0.012).write(
        "BOX", (-w * 0.22, w * 0.22), (-d * 0.12, d * 0.12), "fabric_red", "letters", 0.002
    )


@recipe("stage")
def stage(b: Builder) -> None:
    """A deck of boards with footlights along its edge, a pleated skirt, steps."""
    w, d, h = b.w, b.d, b.h
    front, deck = d / 2 - 0.3, h * 0.86
    boards = max(6, round(w / 0.25))
    b.box((-w / 2, w / 2), (-d / 2, front), (0, deck * 0.9), "fabric_2a1a1e", "skirt")
    for k in range(boards):
        x = -w / 2 + w * k / boards
        b.box((x + 0.004, x + w / boards - 0.004), (-d / 2, front + 0.03), (deck * 0.9, deck), b.mat(), "deck")
    pleats = max(10, round(w / 0.12))
    for k in range(pleats):
        x = -w / 2 + w * (k + 0.5) / pleats
        if abs(x) > 0.5:
            b.cyl(x, front, (0.01, deck * 0.9), w / pleats * 0.42, "fabric_red", "skirt", n=8)
    for k in range(round(w / 0.5)):
        x = -w / 2 + 0.25 + 0.5 * k
        b.rod((x, front - 0.1, deck + 0.01), (x, front - 0.02, deck + 0.02), 0.05, "metal_black", "footlights", 12)
        b.ball((x, front - 0.11, h * 0.93), (0.06, 0.05, h * 0.07), "light_yellow", "footlights", 10)
    for k in range(2):
        b.box((-0.45, 0.45), (front, d / 2 - 0.14 * k), (0, deck * (0.34 + 0.33 * k)), "wood_walnut", "steps")
        b.box(
            (-0.45, 0.45),
            (d / 2 - 0.14 * k - 0.03, d / 2 - 0.14 * k),
            (deck * (0.34 + 0.33 * k), deck * (0.34 + 0.33 * k) + 0.003),
            "paint_yellow",
            "steps",
            solid=False,
        )
    face = DrawnFace.top(b, deck)
    for u, v in ((0.0, 0.0), (-w * 0.28, d * 0.1), (w * 0.28, d * 0.1)):
        face.line([(u - 0.09, v - 0.09), (u + 0.09, v + 0.09)], 0.014, "plastic_white", "marks")
        face.line([(u - 0.09, v + 0.09), (u + 0.09, v - 0.09)], 0.014, "plastic_white", "marks")
    face.write("STAGE", (-w * 0.3, w * 0.3), (-d * 0.3, -d * 0.1), "plastic_white", "letters", 0.003)


@recipe("hanging_bag")
def hanging_bag(b: Builder) -> None:
    """A heavy bag with white bands that hangs by four chains from the arm of a stand, and gloves at its foot."""
    w, d, h = b.w, b.d, b.h
    back = -d / 2 + 0.04
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.1), (0, 0.05), "metal_black", "stand")
    b.box((-0.05, 0.05), (-d / 2, d * 0.48), (0, 0.05), "metal_black", "stand")
    b.box((-0.04, 0.04), (back - 0.04, back + 0.04), (0, h), "metal_black", "stand")
    b.box((-0.03, 0.03), (back, d * 0.14), (h - 0.06, h), "metal_black", "stand")
    b.rod((0, back, h * 0.8), (0, 0.0, h - 0.03), 0.02, "metal_black", "stand")
    y, r, low, high = d * 0.1, min(w, d) * 0.3, h * 0.16, h * 0.78
    color = b.mat() if b.mat() != "leather_black" else "leather_red"
    b.lathe([(r * 0.8, low), (r, low + 0.05), (r, high - 0.05), (r * 0.8, high)], color, (0, y), "bag", 22)
    for z in (low + 0.12, (low + high) / 2 - 0.04, high - 0.2):
        b.lathe([(r * 1.015, z), (r * 1.015, z + 0.08)], "plastic_white", (0, y), "bands", 22)
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        b.rod(
            (math.cos(a) * r * 0.8, y + math.sin(a) * r * 0.8, high - 0.01),
            (0, y, h * 0.91),
            0.012,
            "metal_chrome",
            "chains",
            6,
        )
    b.rod((0, y, h * 0.9), (0, y, h - 0.05), 0.02, "metal_chrome", "chains", 6)
    DrawnFace.front(b, y + r).write("BOX", (-r * 0.62, r * 0.62), (h * 0.5, h * 0.62), "plastic_white", "letters", 0.01)
    for side in (-1, 1):
        x = side * 0.15
        b.cushion((x - 0.075, x + 0.075), (d * 0.3, d / 2), (0.0, 0.15), "leather_2f5fc8", "gloves", 0.8)


@recipe("exercise_ball")
def exercise_ball(b: Builder) -> None:
    """A large ball with raised rings round it and a valve."""
    w, h = b.w, b.h
    r = w / 2
    b.ball((0, 0, h / 2), (r, r, h / 2), b.mat(), "ball", 24)
    for k in range(9):
        a = math.radians(-60 + 15 * k)
        z, ring = h / 2 + math.sin(a) * h * 0.498, math.cos(a) * r * 0.995
        b.lathe(
            [(ring * 0.98, z - h * 0.012), (ring + r * 0.012, z), (ring * 0.98, z + h * 0.012)],
            "plastic_8fb6e9",
            part="rings",
            n=28,
        )
    face = DrawnFace.front(b, r * 0.99)
    face.disc(0, h * 0.5, r * 0.06, "plastic_white", "valve", 0.01)


@recipe("basketball")
def basketball(b: Builder) -> None:
    """An orange ball with black seams: two great circles and two arcs beside them."""
    w, h = b.w, b.h
    r = w / 2
    b.ball((0, 0, h / 2), (r, r, h / 2), "rubber_d8702a", "ball", 24)

    def seam(x: float, y: float, z: float) -> tuple[float, float, float]:
        """Bring a direction onto the ball."""
        share = 0.985 / math.sqrt(x * x + y * y + z * z)
        return x * share * r, y * share * r, h / 2 + z * share * h / 2

    steps = [k * math.tau / 24 for k in range(25)]
    b.path([seam(math.cos(a), math.sin(a), 0.3 * math.cos(a)) for a in steps], r * 0.03, "rubber_black", "seams")
    b.path([seam(0.4 * math.cos(a), math.cos(a), math.sin(a)) for a in steps], r * 0.03, "rubber_black", "seams")
    for side in (-1, 1):
        arc = [seam(side * 0.75 + 0.25 * math.cos(2 * a), math.cos(a), math.sin(a)) for a in steps]
        b.path(arc, r * 0.03, "rubber_black", "seams")


@recipe("doll")
def doll(b: Builder) -> None:
    """A girl of cloth: a round face with eyes, a smile and pink cheeks, yellow plaits, a flared dress, and shoes."""
    w, d, h = b.w, b.d, b.h
    r = w * 0.3
    z = h * 0.78
    b.ball((0, 0, z), (r, d * 0.36, h * 0.15), "fabric_f0cfae", "head", 16)
    b.ball((0, -d * 0.08, z + h * 0.035), (r * 1.12, d * 0.36, h * 0.16), "fabric_f2c94c", "hair", 14)
    b.box((-r * 0.86, r * 0.86), (d * 0.16, d * 0.34), (z + h * 0.07, z + h * 0.12), "fabric_f2c94c", "hair")
    for side in (-1, 1):
        for k in range(4):
            b.ball(
                (side * r * (1.08 + 0.08 * k), d * 0.02, z - h * (0.03 + 0.06 * k)),
                (w * 0.075, d * 0.11, h * 0.036),
                "fabric_f2c94c",
                "plaits",
                8,
            )
        b.ball((side * r * 1.32, d * 0.03, z - h * 0.24), (w * 0.08, d * 0.12, h * 0.03), b.mat(), "bows", 8)
        b.ball((side * r * 0.4, d * 0.33, z + h * 0.005), (w * 0.04, d * 0.04, h * 0.022), "plastic_black", "eyes", 8)
        b.ball(
            (side * r * 0.62, d * 0.28, z - h * 0.045), (w * 0.05, d * 0.04, h * 0.018), "fabric_e88f8f", "cheeks", 8
        )
        b.rod((side * w * 0.1, 0, h * 0.54), (side * w * 0.42, d * 0.1, h * 0.42), w * 0.06, "fabric_f0cfae", "arms", 8)
        b.rod((side * w * 0.13, 0, h * 0.04), (side * w * 0.13, 0, h * 0.3), w * 0.075, "fabric_white", "legs", 10)
        b.cushion(
            (side * w * 0.13 - w * 0.1, side * w * 0.13 + w * 0.1),
            (-d * 0.2, d * 0.36),
            (0, h * 0.08),
            "leather_black",
            "shoes",
            0.8,
        )
    b.path(
        [(-r * 0.3, d * 0.345, z - h * 0.05), (0, d * 0.36, z - h * 0.07), (r * 0.3, d * 0.345, z - h * 0.05)],
        w * 0.014,
        "fabric_red",
        "smile",
    )
    b.lathe(
        [(0.48, h * 0.22), (0.46, h * 0.25), (0.22, h * 0.5), (0.2, h * 0.6), (0.1, h * 0.64)],
        b.mat(),
        stretch=(w, d),
        part="dress",
        n=18,
    )
    b.lathe([(0.49, h * 0.215), (0.49, h * 0.25)], "fabric_white", stretch=(w, d), part="hem", n=18)
    b.box((-w * 0.14, w * 0.14), (d * 0.2, d * 0.4), (h * 0.28, h * 0.46), "fabric_white", "apron", solid=False)


@recipe("violin")
def violin(b: Builder) -> None:
    """A waisted body with f-holes, bridge, chin rest and strings, a fingerboard to a scroll with pegs; a bow."""
    w, d, h = b.w, b.d, b.h
    top, wood = h * 0.5, "wood_a5521f"
    for y, rx, ry in ((-d * 0.3, 0.42, 0.17), (-d * 0.02, 0.34, 0.13)):
        b.lathe([(1.0, 0), (1.0, top)], wood, (w * 0.06, y), "body", 24, (w * rx, d * ry))
        b.lathe([(0.93, top), (0.86, top * 1.12)], "wood_c8742f", (w * 0.06, y), "belly", 24, (w * rx, d * ry))
    b.box((-w * 0.18, w * 0.3), (-d * 0.26, -d * 0.04), (0, top * 1.02), wood, "body")
    b.box((-w * 0.17, w * 0.29), (-d * 0.26, -d * 0.04), (top * 1.02, top * 1.12), "wood_c8742f", "belly", solid=False)
    face = DrawnFace.top(b, top * 1.12)
    for side in (-1, 1):
        u = -w * 0.06 + side * w * 0.17
        hole = [(u - side * w * 0.03, d * 0.235), (u, d * 0.21), (u, d * 0.13), (u + side * w * 0.03, d * 0.1)]
        face.line(hole, w * 0.016, "plastic_black", "holes")
    x = w * 0.06
    b.box((x - w * 0.13, x + w * 0.13), (-d * 0.185, -d * 0.175), (top * 1.1, h * 0.86), "wood_birch", "bridge")
    b.prism(
        [(x - w * 0.05, -d * 0.4), (x + w * 0.05, -d * 0.4), (x + w * 0.09, -d * 0.26), (x - w * 0.09, -d * 0.26)],
        (top * 1.1, h * 0.78),
        "plastic_black",
        "z",
        "tail",
    )
    b.box((x - w * 0.065, x + w * 0.065), (-d * 0.08, d * 0.34), (h * 0.66, h * 0.78), "plastic_black", "fingerboard")
    b.box((x - w * 0.06, x + w * 0.06), (d * 0.08, d * 0.36), (h * 0.34, h * 0.66), wood, "neck")
    b.box((x - w * 0.05, x + w * 0.05), (d * 0.34, d * 0.46), (h * 0.3, h * 0.62), wood, "scroll")
    b.rod((x - w * 0.08, d * 0.46, h * 0.4), (x + w * 0.08, d * 0.46, h * 0.4), h * 0.24, wood, "scroll", 14)
    for k in range(4):
        y, side = d * (0.36 + 0.025 * k), (-1) ** k
        b.rod((x, y, h * 0.46), (x + side * w * 0.17, y, h * 0.46), w * 0.025, "plastic_black", "pegs", 8)
        u = x + w * (-0.045 + 0.03 * k)
        b.path(
            [(u, -d * 0.3, h * 0.8), (u, -d * 0.18, h * 0.87), (u, d * 0.36, h * 0.8)],
            w * 0.006,
            "metal_chrome",
            "strings",
        )
    b.cushion(
        (x + w * 0.06, x + w * 0.32), (-d * 0.46, -d * 0.34), (top * 1.1, h * 0.84), "plastic_black", "chin_rest", 0.7
    )
    bow = -w * 0.42
    b.rod((bow, -d * 0.46, h * 0.3), (bow, d * 0.46, h * 0.3), w * 0.022, "wood_5a2f16", "bow", 8)
    b.box((bow + w * 0.03, bow + w * 0.07), (-d * 0.42, d * 0.45), (h * 0.02, h * 0.1), "plastic_white", "bow")
    b.box((bow - w * 0.02, bow + w * 0.08), (-d * 0.47, -d * 0.4), (0, h * 0.34), "plastic_black", "bow")
    b.box((bow - w * 0.02, bow + w * 0.08), (d * 0.44, d * 0.48), (0, h * 0.34), "wood_5a2f16", "bow")
