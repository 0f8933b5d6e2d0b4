"""Appliances that stand on worktops, and water coolers."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("coffee_machine")
def coffee_machine(b: Builder) -> None:
    """Housing with spout, drip tray, cup and hopper."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.14), b.mat(), "base")
    b.box((-w / 2, w / 2), (-d / 2, -d * 0.08), (h * 0.14, h * 0.95), b.mat(), "body")
    b.box((-w / 2, w / 2), (-d / 2, d * 0.3), (h * 0.68, h * 0.95), b.mat(), "head")
    b.cyl(0, d * 0.14, (h * 0.58, h * 0.68), w * 0.07, "metal_steel", "spout", solid=False)
    b.cyl(0, d * 0.14, (h * 0.15, h * 0.36), w * 0.12, "ceramic_white", "cup", w * 0.14, solid=False)
    b.box((-w * 0.4, w * 0.4), (-d * 0.05, d * 0.45), (h * 0.14, h * 0.15), "metal_steel", "grid", solid=False)
    b.box((-w * 0.3, w * 0.3), (-d * 0.45, 0), (h * 0.95, h), "glass_amber", "hopper", solid=False)
    b.box((-w * 0.25, w * 0.25), (d * 0.3, d * 0.31), (h * 0.76, h * 0.88), "screen_blue", "panel", solid=False)


@recipe("toaster")
def toaster(b: Builder) -> None:
    """Rounded housing with two slots and a lever."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (-d / 2, d / 2 - 0.02), (0.01, h), b.mat(), "body", 0.4, 12)
    b.box((-w * 0.42, w * 0.42), (-d * 0.45, d * 0.42), (0, 0.02), "plastic_black", "feet")
    for sx in (-1, 1):
        b.box(
            (sx * w * 0.18 - w * 0.08, sx * w * 0.18 + w * 0.08),
            (-d * 0.36, d * 0.32),
            (h - 0.002, h),
            "plastic_black",
            "slots",
            solid=False,
        )
    b.box((-w * 0.1, w * 0.1), (d / 2 - 0.04, d / 2), (h * 0.55, h * 0.65), "plastic_black", "lever", solid=False)


@recipe("kettle")
def kettle(b: Builder) -> None:
    """Pot with lid, spout to the front and handle behind; also tea pots and watering cans."""
    w, d, h = b.w, b.d, b.h
    r = w * 0.5
    b.lathe(
        [
            (r * 0.85, 0),
            (r, h * 0.08),
            (r * 0.98, h * 0.35),
            (r * 0.6, h * 0.75),
            (r * 0.5, h * 0.82),
            (r * 0.1, h * 0.9),
        ],
        b.mat(),
        (0, 0),
        n=20,
    )
    b.ball((0, 0, h * 0.94), (r * 0.14, r * 0.14, h * 0.06), "plastic_black", "knob", 8, solid=False)
    b.rod((0, r * 0.7, h * 0.4), (0, d / 2 - 0.01, h * 0.75), min(w, d) * 0.08, b.mat(), "spout")
    b.path(
        [(0, -r * 0.7, h * 0.25), (0, -d / 2 + 0.012, h * 0.35), (0, -d / 2 + 0.012, h * 0.7), (0, -r * 0.5, h * 0.8)],
        0.012,
        "plastic_black",
        "handle",
    )


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


@recipe("blender")
def blender(b: Builder) -> None:
    """A motor base with a dial, and a glass jug on it with a handle, full of red fruit above its knives."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.3
    b.lathe([(0.5, 0), (0.5, h * 0.06), (0.36, low)], b.mat(), stretch=(w, d), part="base", n=20)
    face = DrawnFace.front(b, d * 0.42)
    face.disc(0, h * 0.12, w * 0.13, "metal_chrome", "dial", d * 0.08)
    face.field((-w * 0.01, w * 0.02), (h * 0.12, h * 0.16), "paint_red", "dial", d * 0.09)
    b.cyl(0, 0, (low, low + h * 0.04), w * 0.3, "metal_steel", "collar", n=20)
    b.lathe([(0.26, low + h * 0.04), (0.36, h * 0.72)], "food_d23b4f", stretch=(w, d), part="smoothie", n=20)
    b.lathe([(0.3, low + h * 0.04), (0.44, h * 0.92)], "glass_clear", stretch=(w, d), part="jug", n=20)
    b.lathe(
        [(0.46, h * 0.91), (0.46, h * 0.95), (0.2, h * 0.955), (0.2, h)],
        "plastic_black",
        stretch=(w, d),
        part="lid",
        n=20,
    )
    b.path(
        [(-w * 0.42, 0, h * 0.86), (-w * 0.62, 0, h * 0.82), (-w * 0.58, 0, h * 0.5), (-w * 0.32, 0, h * 0.46)],
        w * 0.055,
        "plastic_black",
        "handle",
    )
    for k in range(4):
        z = h * (0.44 + 0.1 * k)
        face.field((-w * 0.12, w * 0.0), (z, z + h * 0.012), "plastic_white", "scale", d * 0.02)


@recipe("dispenser")
def dispenser(b: Builder) -> None:
    """Water cooler with a bottle on top."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.03), (0, h * 0.72), b.mat(), "case")
    b.box(
        (-w * 0.35, w * 0.35),
        (d / 2 - 0.035, d / 2 - 0.028),
        (h * 0.42, h * 0.64),
        "plastic_dark",
        "niche",
        solid=False,
    )
    for x, color in ((-0.05, "plastic_red"), (0.05, "plastic_blue")):
        b.box((x - 0.012, x + 0.012), (d / 2 - 0.03, d / 2), (h * 0.56, h * 0.6), color, "taps", solid=False)
    b.box((-w * 0.35, w * 0.35), (d / 2 - 0.03, d / 2), (h * 0.4, h * 0.42), "metal_steel", "tray", solid=False)
    r = min(w, d) * 0.42
    b.lathe([(r * 0.4, h * 0.72), (r, h * 0.77), (r, h * 0.97), (r * 0.85, h)], "glass_blue", (0, -0.01), "bottle")
