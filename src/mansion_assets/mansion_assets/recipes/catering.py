"""What kitchens, bars and shops of food serve from, and how it is packed."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("popcorn_machine")
def popcorn_machine(b: Builder) -> None:
    """A red cart with a case of glass, full of popcorn below a kettle, under a roof that bears its name."""
    w, d, h = b.w, b.d, b.h
    low, high = h * 0.46, h * 0.84
    b.box((-w * 0.46, w * 0.46), (-d * 0.46, d * 0.46), (0.1, low - 0.04), b.mat(), "cart")
    b.wheels(0.06, 0.08)
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (low - 0.04, low), "metal_brass", "counter")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (high, h * 0.95), b.mat(), "roof")
    b.prism([(-d / 2, h * 0.95), (d / 2, h * 0.95), (d * 0.2, h), (-d * 0.2, h)], (-w / 2, w / 2), b.mat(), part="roof")
    for x in (-w * 0.47, w * 0.47):
        for y in (-d * 0.47, d * 0.47):
            b.box((x - 0.02, x + 0.02), (y - 0.02, y + 0.02), (low, high), "metal_brass", "posts")
    face = DrawnFace.front(b, d / 2)
    face.write("POPCORN", (-w * 0.46, w * 0.46), (high + 0.02, h * 0.94), "paint_yellow", "letters", 0.006)
    side = DrawnFace.side(b, w / 2)
    side.write("POPCORN", (-d * 0.46, d * 0.46), (high + 0.02, h * 0.94), "paint_yellow", "letters", 0.006)
    for plate, half, out in (
        (DrawnFace.front(b, d * 0.46), w * 0.46, 0.006),
        (DrawnFace.side(b, w * 0.46), d * 0.46, 0.006),
    ):
        for k in range(4):
            u = -half + 2 * half * (2 * k + 0.5) / 8
            plate.field((u, u + half / 4), (0.12, low - 0.06), "plastic_white", "stripes", out)
    for i in range(6):
        for j in range(5):
            x, y = w * (-0.38 + 0.152 * i), d * (-0.36 + 0.18 * j)
            rise = 0.2 + 0.06 * math.cos(x / w * 4) * math.cos(y / d * 4) + 0.02 * ((i * 3 + j * 5) % 3)
            color = ("food_f4e3a1", "food_fdf6e3", "food_f0cf6a")[(i + 2 * j) % 3]
            b.cushion((x - 0.07, x + 0.07), (y - 0.07, y + 0.07), (low, low + rise), color, "popcorn", 0.9, 8)
    b.lathe([(0.09, high - 0.24), (0.12, high - 0.18), (0.12, high - 0.1)], "metal_chrome", part="kettle", n=18)
    b.cyl(0, 0, (high - 0.1, high), 0.02, "metal_dark", "kettle", n=8)
    for x in (-w * 0.48, w * 0.475):
        b.box((x, x + 0.004), (-d * 0.46, d * 0.46), (low, high), "glass_clear", "glass", solid=False)
    b.box((-w * 0.46, w * 0.46), (d * 0.475, d * 0.48), (low, high), "glass_clear", "glass", solid=False)


@recipe("ice_machine")
def ice_machine(b: Builder) -> None:
    """A steel head above an open bin full of cubes of ice, with a scoop in them and the word ICE in blue."""
    w, d, h = b.w, b.d, b.h
    bin_top, front = h * 0.56, d / 2 - 0.02
    b.box((-w / 2, w / 2), (-d / 2, d * 0.1), (0.06, h), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d / 2, front), (bin_top + h * 0.06, h), b.mat(), "head")
    b.box((-w / 2, w / 2), (d * 0.1, front), (0.06, h * 0.36), b.mat(), "bin")
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - 0.03)))
        b.prism(
            [(d * 0.1, h * 0.36), (front, h * 0.36), (front, h * 0.4), (d * 0.1, bin_top + h * 0.06)],
            (across[0], across[1]),
            b.mat(),
            part="bin",
        )
    b.legs((0, 0.06), 0.02, "metal_dark", 0.03)
    for i in range(6):
        for j in range(4):
            x, y = w * (-0.38 + 0.15 * i), d * (0.14 + 0.085 * j)
            z = h * (0.34 + 0.03 * ((i * 5 + j * 3) % 3)) + (front - y) * 0.3
            s = 0.036
            b.box(
                (x - s, x + s),
                (y - s * 0.8, y + s * 0.8),
                (z, z + 2 * s),
                ("plastic_dff2fb", "plastic_bfe3f5")[(i + j) % 2],
                "ice",
                solid=False,
            )
    b.rod((w * 0.1, d * 0.3, h * 0.5), (w * 0.3, d * 0.42, h * 0.6), 0.016, "metal_chrome", "scoop", 8)
    b.ball((w * 0.06, d * 0.28, h * 0.49), (0.06, 0.05, 0.035), "metal_chrome", "scoop", 10)
    face = DrawnFace.front(b, front)
    face.write("ICE", (-w * 0.4, w * 0.2), (h * 0.7, h * 0.92), "plastic_2f7fd0", "letters", 0.008)
    for k in range(3):
        a = k * math.pi / 3
        arm = (math.cos(a) * w * 0.1, math.sin(a) * w * 0.1)
        face.line(
            [(w * 0.34 - arm[0], h * 0.81 - arm[1]), (w * 0.34 + arm[0], h * 0.81 + arm[1])],
            0.01,
            "plastic_2f7fd0",
            "flake",
            0.006,
        )
    face.field((-w * 0.4, w * 0.4), (h * 0.64, h * 0.66), "metal_dark", "vent", 0.004)
    for k in range(4):
        face.field((-w * 0.34, w * 0.34), (h * (0.12 + 0.05 * k), h * (0.14 + 0.05 * k)), "metal_dark", "vent", 0.004)


@recipe("menu_screen")
def menu_screen(b: Builder) -> None:
    """A screen above a counter that shows a burger, a cup and chips with their prices under the word MENU."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.006), (0, h), b.mat(), "case")
    face = DrawnFace.front(b, d / 2 - 0.006)
    face.field((-w * 0.48, w * 0.48), (h * 0.05, h * 0.95), "screen_3a1f14", "screen", 0.002)
    face.write("MENU", (-w * 0.24, w * 0.24), (h * 0.73, h * 0.92), "light_yellow", "letters", 0.004)
    left, middle, right, low = -w * 0.31, 0.0, w * 0.31, h * 0.32
    for v, color, thick in (
        (0.0, "light_d9a05a", 0.08),
        (0.09, "light_7a3f1d", 0.06),
        (0.16, "light_6fbf4a", 0.03),
        (0.2, "light_red", 0.04),
    ):
        face.field((left - w * 0.1, left + w * 0.1), (low + h * v, low + h * (v + thick)), color, "burger", 0.004)
    for k in range(3):
        face.field(
            (left - w * (0.1 - 0.02 * k), left + w * (0.1 - 0.02 * k)),
            (low + h * (0.25 + 0.03 * k), low + h * (0.28 + 0.03 * k)),
            "light_d9a05a",
            "burger",
            0.004,
        )
    cup = [
        (middle - w * 0.05, low),
        (middle + w * 0.05, low),
        (middle + w * 0.08, low + h * 0.26),
        (middle - w * 0.08, low + h * 0.26),
    ]
    b.prism([(-u, v) for u, v in cup], (d / 2 - 0.004, d / 2 - 0.001), "light_red", "y", "cup")
    face.field((middle - w * 0.09, middle + w * 0.09), (low + h * 0.26, low + h * 0.3), "light_white", "cup", 0.004)
    face.field((middle + w * 0.01, middle + w * 0.025), (low + h * 0.3, low + h * 0.38), "light_white", "cup", 0.004)
    face.field((right - w * 0.07, right + w * 0.07), (low, low + h * 0.2), "light_red", "chips", 0.005)
    for k in range(5):
        u = right - w * 0.065 + w * 0.027 * k
        face.field(
            (u, u + w * 0.02), (low + h * 0.1, low + h * (0.28 + 0.04 * (k % 2))), "light_f5d04a", "chips", 0.004
        )
    for u, price in ((left, "5:90"), (middle, "2:50"), (right, "3:20")):
        face.write(price, (u - w * 0.12, u + w * 0.12), (h * 0.1, h * 0.24), "light_white", "prices", 0.004)


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


@recipe("tea_box")
def tea_box(b: Builder) -> None:
    """An open box of tea bags in their sleeves, one of which hangs over its front on a string with its tag."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.6
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, low), b.mat(), "box")
    b.prism([(-d / 2, low), (-d / 2 + 0.002, low), (-d * 0.5, h), (-d * 0.54, h)], (-w / 2, w / 2), b.mat(), part="lid")
    for k in range(9):
        x = -w * 0.44 + w * 0.1 * k
        b.box(
            (x, x + w * 0.07),
            (-d * 0.4, d * 0.36),
            (low - 0.002, low + h * (0.16 + 0.03 * (k % 3))),
            ("paper_beige", "paper_yellow")[k % 2],
            "bags",
            solid=False,
        )
    face = DrawnFace.front(b, d / 2)
    face.write("TEA", (-w * 0.46, w * 0.06), (h * 0.12, h * 0.5), "paper_white", "letters", 0.001)
    face.line([(w * 0.28, low), (w * 0.3, h * 0.4), (w * 0.28, h * 0.3)], 0.0012, "paper_white", "string", 0.001)
    face.field((w * 0.18, w * 0.4), (h * 0.06, h * 0.3), "paper_yellow", "tag", 0.002)
    lid = DrawnFace.front(b, -d * 0.5 + 0.002)
    lid.disc(-w * 0.05, (low + h) / 2 + h * 0.06, h * 0.08, "leaf_green", "leaf", 0.002)
    lid.disc(w * 0.08, (low + h) / 2 + h * 0.08, h * 0.06, "leaf_green", "leaf", 0.002)


@recipe("coffee_bag")
def coffee_bag(b: Builder) -> None:
    """A foil bag that is folded at its top, with a label, beans on it and a valve; beans lie at its foot."""
    w, d, h = b.w, b.d, b.h
    front = d * 0.36
    b.prism(
        [
            (-d * 0.4, 0),
            (front, 0),
            (front, h * 0.74),
            (0.004, h * 0.92),
            (0.004, h),
            (-0.004, h),
            (-0.004, h * 0.92),
            (-d * 0.4, h * 0.74),
        ],
        (-w / 2, w / 2),
        b.mat(),
        part="bag",
    )
    b.box((-w * 0.52, w * 0.52), (-0.006, 0.008), (h * 0.93, h), "metal_brass", "clip", solid=False)
    face = DrawnFace.front(b, front)
    face.field((-w * 0.42, w * 0.42), (h * 0.14, h * 0.66), "paper_beige", "label", 0.001)
    face.write("COFFEE", (-w * 0.4, w * 0.4), (h * 0.46, h * 0.62), "paper_5a2f16", "letters", 0.002)
    for u, v, tilt in ((-0.18, 0.32, 0.5), (0.14, 0.3, -0.5), (-0.02, 0.21, 0.2)):
        x, z = -w * u, h * v
        b.ball((x, front + 0.002, z), (w * 0.15, 0.004, w * 0.1), "food_4a2c17", "beans", 10)
        face.line(
            [(w * u - w * 0.12, z - tilt * w * 0.05), (w * u + w * 0.12, z + tilt * w * 0.05)],
            w * 0.014,
            "food_2a170b",
            "beans",
            0.006,
        )
    for k in range(5):
        x = w * (-0.4 + 0.2 * k)
        b.ball(
            (x, d * (0.43 + 0.03 * (k % 2)), h * 0.02), (w * 0.09, w * 0.06, h * 0.02), "food_4a2c17", "loose_beans", 8
        )


@recipe("cereal_box")
def cereal_box(b: Builder) -> None:
    """A tall flat box with a bowl of flakes and milk on its front, a spoon, and the word CEREAL."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.985), b.mat(), "box")
    b.box((-w * 0.5, w * 0.5), (-0.002, d * 0.3), (h * 0.985, h), b.mat(), "flap")
    face = DrawnFace.front(b, d / 2)
    face.field((-w * 0.47, w * 0.47), (h * 0.74, h * 0.95), "paper_red", "band", 0.001)
    face.write("CEREAL", (-w * 0.44, w * 0.44), (h * 0.77, h * 0.92), "paper_white", "letters", 0.002)
    bowl = [
        (math.cos(a) * w * 0.36, h * 0.34 + math.sin(a) * w * 0.32)
        for a in (math.pi + k * math.pi / 10 for k in range(11))
    ]
    b.prism(bowl, (d / 2, d / 2 + 0.003), "paper_2f6fc0", "y", "bowl")
    face.field((-w * 0.37, w * 0.37), (h * 0.33, h * 0.4), "paper_white", "milk", 0.003)
    for k in range(11):
        u, v = w * (-0.32 + 0.064 * k), h * (0.42 + 0.035 * ((k * 3) % 4))
        face.disc(
            u, v, w * 0.055, ("food_e0a02f", "food_f0c04a", "food_c8791f")[k % 3], "flakes", 0.004 + 0.001 * (k % 2), 10
        )
    face.line([(w * 0.2, h * 0.42), (w * 0.42, h * 0.68)], w * 0.03, "metal_chrome", "spoon", 0.003)
    side = DrawnFace.side(b, w / 2)
    side.field((-d * 0.36, d * 0.36), (h * 0.1, h * 0.7), "paper_white", "facts", 0.001)
    for k in range(8):
        side.field((-d * 0.3, d * 0.3), (h * (0.14 + 0.065 * k), h * (0.16 + 0.065 * k)), "paper_dark", "facts", 0.002)


@recipe("canned_food")
def canned_food(b: Builder) -> None:
    """A tin with ribs and rims, a ring to open it by, and a label with tomatoes."""
    w, d, h = b.w, b.d, b.h
    for z0, z1, share, color in (
        (0.0, 0.04, 0.5, b.mat()),
        (0.04, 0.16, 0.47, b.mat()),
        (0.16, 0.84, 0.48, "paper_red"),
        (0.84, 0.95, 0.47, b.mat()),
        (0.95, 0.985, 0.5, b.mat()),
    ):
        b.lathe([(share, z0 * h), (share, z1 * h)], color, stretch=(w, d), part="tin", n=28)
    b.lathe([(0.44, h * 0.985), (0.44, h * 0.988)], "metal_light", stretch=(w, d), part="lid", n=28)
    b.lathe([(0.482, h * 0.62), (0.482, h * 0.8)], "paper_beige", stretch=(w, d), part="label", n=28)
    ring = [
        (math.cos(k * math.pi / 5) * w * 0.13, d * 0.16 + math.sin(k * math.pi / 5) * d * 0.16, h * 0.995)
        for k in range(11)
    ]
    b.path(ring, w * 0.02, "metal_chrome", "ring")
    b.box((-w * 0.03, w * 0.03), (-d * 0.06, d * 0.02), (h * 0.985, h), "metal_chrome", "ring")
    for x, y in ((0.0, 0.48), (0.34, 0.34), (-0.34, 0.34), (0.48, 0.0)):
        b.ball((w * x, d * y, h * 0.4), (w * 0.12, d * 0.12, h * 0.13), "food_e8442c", "tomatoes", 10)
        b.ball((w * x * 1.04, d * y * 1.04, h * 0.53), (w * 0.06, d * 0.06, h * 0.025), "leaf_green", "tomatoes", 6)


@recipe("ladle")
def ladle(b: Builder) -> None:
    """A deep round bowl, hollow, at the end of a long handle that ends in a hook."""
    w, d, h = b.w, b.d, b.h
    r = w / 2
    y = d / 2 - r
    deep = h * 0.8
    b.lathe(
        [
            (r * 0.4, 0),
            (r * 0.8, deep * 0.3),
            (r, deep),
            (r * 0.92, deep),
            (r * 0.7, deep * 0.36),
            (r * 0.3, deep * 0.1),
        ],
        b.mat(),
        (0, y),
        "bowl",
        20,
    )
    b.lathe([(r * 0.86, deep * 0.62), (r * 0.86, deep * 0.66)], "food_c8641f", (0, y), "soup", 20)
    b.path(
        [
            (0, y - r * 0.95, deep * 0.9),
            (0, y - r * 1.4, h * 0.95),
            (0, -d * 0.42, h * 0.55),
            (0, -d / 2 + 0.006, h * 0.5),
        ],
        w * 0.07,
        b.mat(),
        "handle",
    )
    b.path(
        [(0, -d / 2 + 0.006, h * 0.5), (0, -d / 2 + 0.006, h * 0.3), (0, -d * 0.46, h * 0.26)],
        w * 0.06,
        b.mat(),
        "hook",
    )


@recipe("loaf")
def loaf(b: Builder) -> None:
    """A loaf with a golden crust and cuts on its top; two slices that are cut off it show the pale crumb."""
    w, d, h = b.w, b.d, b.h
    arch = [(-0.44, 0.0), (0.44, 0.0), (0.47, 0.3), (0.44, 0.46), (0.5, 0.62), (0.46, 0.82), (0.3, 0.96), (0.0, 1.0)]
    arch += [(-x, z) for x, z in arch[6:1:-1]]
    outline = [(x * w, z * h) for x, z in arch]
    crumb = [(x * w * 0.88, h * 0.05 + z * h * 0.88) for x, z in arch]

    def piece(back: float, front: float) -> None:
        """Bake a piece of the loaf between two places along it."""
        b.prism(outline, (back, front), "food_b9742c", "y", "crust")
        b.prism(crumb, (front, front + d * 0.006), "food_f3dfb4", "y", "crumb")

    piece(-d / 2, d * 0.2)
    piece(d * 0.25, d * 0.32)
    piece(d * 0.38, d * 0.46)
    for k in range(4):
        y = -d * (0.42 - 0.14 * k)
        b.rod((-w * 0.22, y, h * 0.975), (w * 0.22, y + d * 0.05, h * 0.975), h * 0.035, "food_e8c68a", "cuts", 6)


@recipe("foil_roll")
def foil_roll(b: Builder) -> None:
    """A long carton with the word FOIL on it, and a sheet of silver foil drawn out of it over its front."""
    w, d, h = b.w, b.d, b.h
    back = d * 0.08
    b.box((-w / 2, w / 2), (-d / 2, back), (0, h * 0.9), "paper_2f5fa8", "carton")
    b.prism(
        [(-d / 2, h * 0.9), (-d * 0.42, h * 0.9), (-d * 0.42, h), (-d * 0.46, h)],
        (-w / 2, w / 2),
        "paper_2f5fa8",
        part="lid",
    )
    sheet = [
        (back - d * 0.3, h * 0.9),
        (back + d * 0.02, h * 0.95),
        (d * 0.3, h * 0.16),
        (d / 2, 0.0),
        (d / 2, h * 0.03),
        (d * 0.31, h * 0.22),
        (back + d * 0.03, h),
        (back - d * 0.3, h * 0.95),
    ]
    for part in ((0, 1, 6, 7), (1, 2, 5, 6), (2, 3, 4, 5)):
        b.prism([sheet[k] for k in part], (-w * 0.46, w * 0.46), "metal_chrome", part="sheet")
    top = DrawnFace.top(b, h * 0.95)
    top.write("FOIL", (-w * 0.3, w * 0.3), (d * 0.24, d * 0.4), "paper_white", "letters", 0.001)
    slope = DrawnFace.sloped(b, (d * 0.31, h * 0.22), (back + d * 0.03, h))
    for k in range(7):
        u = w * (-0.4 + 0.12 * k)
        slope.field(
            (u, u + w * 0.05), (d * 0.02 * (k % 3), d * 0.2), ("metal_white", "metal_grey")[k % 2], "creases", 0.0006
        )


@recipe("lunch_box")
def lunch_box(b: Builder) -> None:
    """An open box of compartments with a sandwich, grapes and carrots in it, its lid up behind."""
    w, d, h = b.w, b.d, b.h
    low, t = h * 0.62, 0.006
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, t), b.mat(), "floor")
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * (w / 2 - t))), sorted((side * d / 2, side * (d / 2 - t)))
        b.box((across[0], across[1]), (-d / 2, d / 2), (0, low), b.mat(), "walls")
        b.box((-w / 2, w / 2), (along[0], along[1]), (0, low), b.mat(), "walls")
    b.box((-0.003, 0.003), (-d / 2, d / 2), (0, low * 0.9), b.mat(), "walls")
    b.box((-w / 2, 0), (-0.003, 0.003), (0, low * 0.9), b.mat(), "walls")
    b.prism(
        [(-d / 2, low), (-d / 2 + t, low), (-d * 0.56, h * 1.5), (-d * 0.6, h * 1.5)],
        (-w / 2, w / 2),
        b.mat(),
        part="lid",
    )
    for k, color in enumerate(("food_e8c68a", "food_6fbf4a", "food_d9443a", "food_f0c04a", "food_e8c68a")):
        z = low * (0.35 + 0.17 * k)
        b.prism(
            [(w * 0.04, -d * 0.4), (w * 0.45, -d * 0.4), (w * 0.04, d * 0.42)],
            (z, z + low * 0.17),
            color,
            "z",
            "sandwich",
        )
    for i in range(4):
        for j in range(3):
            b.ball(
                (-w * (0.08 + 0.11 * i), -d * (0.12 + 0.13 * j), low * (0.7 + 0.2 * ((i + j) % 2))),
                (w * 0.055, w * 0.055, w * 0.055),
                "food_6a3f8f",
                "grapes",
                8,
            )
    for k in range(5):
        x = -w * (0.07 + 0.09 * k)
        b.rod((x, d * 0.06, low * 0.85), (x, d * 0.44, low * 0.85), w * 0.04, "food_e8792f", "carrots", 8)
