"""Small supplies of wards: syringes, dishes, gloves, bandages, medicine."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("syringe")
def syringe(b: Builder) -> None:
    """A barrel with a coloured liquid, a plunger that is drawn out behind, finger flanges, and a needle in front."""
    w, d, h = b.w, b.d, b.h
    z, r = h / 2, w * 0.3
    b.rod((0, -d * 0.2, z), (0, d * 0.24, z), r, b.mat(), "barrel", 12, solid=True)
    b.rod((0, -d * 0.04, z), (0, d * 0.18, z), r * 1.05, "plastic_3f9fd0", "liquid", 12)
    b.box((-w / 2, w / 2), (-d * 0.22, -d * 0.19), (z - r, z + r), b.mat(), "flange")
    b.rod((0, -d * 0.48, z), (0, -d * 0.2, z), r * 0.4, "plastic_grey", "plunger")
    b.rod((0, -d / 2, z), (0, -d * 0.47, z), h / 2, "plastic_grey", "thumb", 14)
    b.rod((0, d * 0.24, z), (0, d * 0.3, z), r * 0.5, "plastic_orange", "hub")
    b.rod((0, d * 0.3, z), (0, d / 2, z), r * 0.14, "metal_steel", "needle", 6)


@recipe("clinical_thermometer")
def clinical_thermometer(b: Builder) -> None:
    """A flat white rod with a scale, a red column and a red bulb."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d * 0.38), (0, h), b.mat(), "rod", 0.6)
    b.ball((0, d * 0.41, h / 2), (w * 0.34, d * 0.09, h * 0.46), "plastic_red", "bulb")
    b.box((-w * 0.09, w * 0.09), (-d * 0.2, d * 0.36), (h - 0.0005, h + 0.0004), "plastic_red", "column", solid=False)
    for k in range(9):
        y = -d * 0.4 + k * d * 0.08
        b.box((w * 0.14, w * 0.4), (y, y + d * 0.012), (h - 0.0005, h + 0.0003), "plastic_black", "scale", solid=False)


@recipe("stethoscope")
def stethoscope(b: Builder) -> None:
    """A stethoscope laid down: two curved ear tubes that meet, and a tube in a bend to the chest piece in front."""
    w, d, h = b.w, b.d, b.h
    tube, z, fork = min(h * 0.25, w * 0.03), h * 0.3, (0.0, -d * 0.05)
    for side in (-1, 1):
        bend = [(side * w * 0.3, -d * 0.2), (side * w * 0.42, -d * 0.34), (side * w * 0.28, -d * 0.46)]
        ends = [(x, y, z) for x, y in (fork, *bend)]
        b.path(ends, tube * 0.7, "metal_steel", "ear_tubes")
        b.ball(ends[-1], (tube * 1.5, tube * 1.5, h * 0.3), b.mat(), "ear_tips", 8)
    curve = [
        fork,
        (w * 0.02, d * 0.12),
        (-w * 0.2, d * 0.22),
        (-w * 0.44, d * 0.3),
        (-w * 0.36, d * 0.42),
        (0.0, d * 0.36),
    ]
    b.path([(x, y, z) for x, y in curve], tube, b.mat(), "tube")
    b.cyl(w * 0.2, d * 0.36, (0, h * 0.7), w * 0.2, "metal_steel", "chest_piece", n=20)
    b.cyl(w * 0.2, d * 0.36, (h * 0.7, h), w * 0.17, "plastic_white", "membrane", n=20)
    b.rod((0.0, d * 0.36, z), (w * 0.1, d * 0.36, z), tube, "metal_steel", "stem")


@recipe("kidney_dish")
def kidney_dish(b: Builder) -> None:
    """A steel dish of the outline of a kidney."""
    w, d, h = b.w, b.d, b.h
    outline = [
        (0.0, 0.08),
        (0.14, 0.14),
        (0.26, 0.34),
        (0.38, 0.42),
        (0.47, 0.3),
        (0.5, 0.06),
        (0.44, -0.2),
        (0.3, -0.4),
        (0.12, -0.49),
    ]
    outline += [(-x, y) for x, y in outline[:0:-1]]
    floor = [(x * w * 0.86, y * d * 0.86) for x, y in outline]
    b.prism(floor, (0, h * 0.08), "metal_light", "z", "floor")
    edge = [(x * w, y * d) for x, y in outline]
    inner = [(x * w * 0.95, y * d * 0.95) for x, y in outline]
    for k in range(len(edge)):
        n = (k + 1) % len(edge)
        b.path([(*edge[k], h * 0.97), (*edge[n], h * 0.97)], h * 0.05, "metal_chrome", "rim")
        b.prism([edge[k], edge[n], inner[n], inner[k]], (0, h), b.mat(), "z", "wall")


@recipe("urine_bottle")
def urine_bottle(b: Builder) -> None:
    """A lying-bed bottle: a flat body half full of yellow, a wide neck that leans forward, a handle and a scale."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.66
    b.cushion((-w / 2, w / 2), (-d / 2, d * 0.4), (0, low * 0.6), "glass_e3b92f", "content", 0.35, 12)
    b.cushion((-w / 2, w / 2), (-d / 2, d * 0.4), (low * 0.6, low), b.mat(), "body", 0.35, 12)
    b.rod((0, -d * 0.06, low * 0.9), (w * 0.3, d * 0.26, h * 0.93), w * 0.24, b.mat(), "neck", 18, solid=True)
    b.rod((w * 0.28, d * 0.24, h * 0.9), (w * 0.33, d * 0.29, h * 0.96), w * 0.29, b.mat(), "neck", 18)
    b.rod((w * 0.33, d * 0.29, h * 0.96), (w * 0.332, d * 0.292, h * 0.963), w * 0.22, "plastic_black", "mouth", 18)
    b.path(
        [(-w * 0.2, -d * 0.1, low * 0.97), (-w * 0.3, -d * 0.12, h * 0.94), (-w * 0.02, d * 0.02, h * 0.97)],
        w * 0.06,
        b.mat(),
        "handle",
    )
    face = DrawnFace.front(b, d * 0.4)
    for k in range(6):
        v = low * (0.14 + 0.12 * k)
        face.field((-w * 0.3, -w * (0.08 if k % 2 else 0.0)), (v, v + h * 0.012), "plastic_2f5fa8", "scale", 0.001)
    face.write("500", (w * 0.04, w * 0.34), (low * 0.62, low * 0.78), "plastic_2f5fa8", "scale", 0.001)


@recipe("glove_box")
def glove_box(b: Builder) -> None:
    """A carton with an oval opening out of which a blue glove stands with its fingers spread."""
    w, d, h = b.w, b.d, b.h
    top = h * 0.52
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, top), "paper_white", "box")
    b.box((-w / 2, w / 2), (-d / 2 - 0.0005, d / 2 + 0.0005), (0, top * 0.22), b.mat(), "box")
    b.lathe([(0.5, top), (0.5, top * 1.02)], "plastic_black", stretch=(w * 0.6, d * 0.6), part="opening", n=24)
    b.cushion((-w * 0.13, w * 0.13), (-d * 0.14, d * 0.14), (top * 0.9, h * 0.82), "rubber_3f7fd0", "glove", 0.7)
    for k, (u, z) in enumerate(((-0.14, 0.98), (-0.06, 1.06), (0.03, 1.08), (0.11, 1.0))):
        b.rod(
            (w * u * 0.7, 0, h * 0.74), (w * u * 1.2, d * 0.05 * (k % 2), h * z), w * 0.034, "rubber_3f7fd0", "glove", 8
        )
    b.rod((w * 0.1, 0, h * 0.66), (w * 0.24, d * 0.04, h * 0.84), w * 0.034, "rubber_3f7fd0", "glove", 8)
    face = DrawnFace.front(b, d / 2)
    face.write("GLOVES", (-w * 0.44, w * 0.44), (top * 0.36, top * 0.82), "plastic_2f5fa8", "letters", 0.001)
    side = DrawnFace.side(b, w / 2)
    side.field((-d * 0.06, d * 0.06), (top * 0.36, top * 0.86), "paint_green", "cross", 0.001)
    side.field((-d * 0.18, d * 0.18), (top * 0.53, top * 0.69), "paint_green", "cross", 0.001)


@recipe("bandage")
def bandage(b: Builder) -> None:
    """A roll of gauze that lies on its side, with its end unrolled to the front and two clips."""
    w, d, h = b.w, b.d, b.h
    r, x = h / 2, (-w * 0.34, w * 0.34)
    y = -d / 2 + r
    b.rod((x[0], y, r), (x[1], y, r), r, b.mat(), "roll", 24, solid=True)
    for share, color in (
        (0.78, "fabric_light"),
        (0.66, b.mat()),
        (0.54, "fabric_light"),
        (0.42, b.mat()),
        (0.3, "fabric_grey"),
    ):
        b.rod((x[0] - (1 - share) * 0.003, y, r), (x[1] + (1 - share) * 0.003, y, r), r * share, color, "turns", 20)
    b.box(x, (y, d / 2), (0, h * 0.05), b.mat(), "end")
    for side in (-1, 1):
        b.box(
            (side * w * 0.18 - w * 0.05, side * w * 0.18 + w * 0.05),
            (d * 0.32, d * 0.46),
            (h * 0.05, h * 0.09),
            "metal_steel",
            "clips",
            solid=False,
        )
    for half in ((w * 0.2, r * 0.22), (w * 0.07, r * 0.62)):
        b.box((-half[0], half[0]), (y - half[1], y + half[1]), (h * 0.97, h), "fabric_red", "cross", solid=False)


@recipe("pill_bottle")
def pill_bottle(b: Builder) -> None:
    """An orange bottle with a white, ribbed cap and a printed label."""
    w, d, h = b.w, b.d, b.h
    b.lathe([(0.42, 0), (0.44, h * 0.03), (0.44, h * 0.68), (0.4, h * 0.74)], b.mat(), n=24, stretch=(w, d))
    b.lathe([(0.452, h * 0.16), (0.452, h * 0.58)], "paper_white", n=24, stretch=(w, d), part="label", solid=False)
    for z0, z1, color in (
        (0.5, 0.55, "paper_blue"),
        (0.4, 0.43, "paper_dark"),
        (0.32, 0.35, "paper_dark"),
        (0.24, 0.27, "paper_dark"),
    ):
        b.lathe([(0.456, h * z0), (0.456, h * z1)], color, n=24, stretch=(w, d), part="print", solid=False)
    b.lathe([(0.48, h * 0.74), (0.48, h * 0.97), (0.44, h)], "plastic_white", n=24, stretch=(w, d), part="cap")
    for k in range(24):
        a = k * math.pi / 12
        b.cyl(
            0.48 * w * math.cos(a),
            0.48 * d * math.sin(a),
            (h * 0.75, h * 0.96),
            w * 0.02,
            "plastic_light",
            "ribs",
            n=4,
            solid=False,
        )


@recipe("medicine_box")
def medicine_box(b: Builder) -> None:
    """A folding box with a green cross, and a blister of red tablets that leans against it."""
    w, d, h = b.w, b.d, b.h
    front = d * 0.2
    b.box((-w / 2, w / 2), (-d / 2, front), (0, h), b.mat(), "box")
    b.box((-w / 2, w / 2), (front - 0.001, front + 0.0005), (h * 0.84, h), "paper_green", "stripe", solid=False)
    x, z, arm = w * 0.3, h * 0.46, h * 0.24
    for half in ((arm, arm / 3), (arm / 3, arm)):
        b.box(
            (x - half[0], x + half[0]),
            (front, front + 0.0008),
            (z - half[1], z + half[1]),
            "paint_2f9a4a",
            "cross",
            solid=False,
        )
    for half in ((arm * 0.8, arm * 0.26), (arm * 0.26, arm * 0.8)):
        b.box(
            (-half[0], half[0]),
            (-d * 0.15 - half[1] * 0.5, -d * 0.15 + half[1] * 0.5),
            (h, h + 0.0006),
            "paint_2f9a4a",
            "cross",
            solid=False,
        )
    left, right, lean = -w * 0.46, w * 0.08, d * 0.14
    sheet = [(d / 2 - lean * 0.2, 0), (d / 2, 0), (front + lean * 0.4, h * 0.8), (front + lean * 0.2, h * 0.8)]
    b.prism(sheet, (left, right), "metal_light", part="blister")
    for row in range(2):
        for column in range(4):
            share = 0.28 + 0.46 * row
            y = d / 2 + (front + lean * 0.4 - d / 2) * share
            b.ball(
                (left + (column + 0.5) * (right - left) / 4, y, h * 0.8 * share),
                (w * 0.045, d * 0.06, h * 0.1),
                "plastic_red",
                "tablets",
                8,
                solid=False,
            )
