"""Trolleys, and carts for shopping, linen and luggage."""

from typing import Any

from mansion_assets.builder import Box, Builder, Rect
from mansion_assets.catalogue.receptacles import Receptacle, inset, surface
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import receptacles, recipe
from mansion_assets.shelf_goods import goods
from mansion_msgs_py.shapes import Size3

__all__: list[str] = []


@receptacles("trolley", "linen_cart")
def _trolley_shelves(size: Size3, p: dict[str, Any]) -> list[Receptacle]:
    h = size[2]
    count = int(p.get("levels", 2))
    rail = float(p.get("rail", 0.08 if h > 0.5 else 0.0))
    top = h - rail
    heights = [top - (top - 0.2) * i / max(1, count - 1) for i in range(count)] if count > 1 else [top]
    gap = (top - 0.2) / max(1, count - 1) - 0.03
    box = inset(size, 0.05)
    return [surface("shelf", box, z, 0.8 if i == 0 else gap) for i, z in enumerate(heights)]


@recipe("trolley")
def trolley(b: Builder) -> None:
    """Trays between posts on castors, with a push bar."""
    w, d = b.w, b.d
    for t in b.tops:
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (t.z - 0.025, t.z), b.mat(), "trays")
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (w / 2 - 0.02), sy * (d / 2 - 0.02)
            b.rod((x, y, 0.09), (x, y, b.h - 0.012), 0.012, "metal_steel", "posts", solid=True)
    for sx in (-1, 1):
        b.rod(
            (sx * (w / 2 - 0.02), -d / 2 + 0.02, b.h - 0.012),
            (sx * (w / 2 - 0.02), d / 2 - 0.02, b.h - 0.012),
            0.012,
            "metal_steel",
            "rail",
        )
    b.wheels(0.05)
    fill = str(b.p.get("fill", "none"))
    if fill != "none":
        t = b.tops[-1]
        goods(b, fill, Rect(t.x0, t.x1, t.y0, t.y1, 0.12, t.z - 0.05), d * 0.8, 1)


@recipe("linen_cart")
def linen_cart(b: Builder) -> None:
    """Trays with folded towels along their back, a bag for the used ones at either end, one with the word LINEN."""
    trolley(b)
    w, d, h = b.w, b.d, b.h
    back = (-d / 2 + 0.002, -d / 2 + 0.048)
    b.box((-w / 2 + 0.05, w / 2 - 0.05), (-d / 2, back[0]), (0.2, h - 0.03), "metal_light", "back", solid=False)
    for number, shelf in enumerate(sorted(b.tops)):
        room = min(shelf.top, h - 0.01) - shelf.z
        for k in range(3):
            x0 = -w * 0.42 + k * w * 0.285
            layers = max(1, int(room * (0.9 - 0.16 * ((k + number) % 3)) / 0.055))
            for layer in range(min(layers, 5)):
                z = shelf.z + layer * 0.055
                color = ("fabric_white", "fabric_8fc3e8", "fabric_white", "fabric_f0d9a8")[(k + layer + number) % 4]
                b.cushion((x0, x0 + w * 0.265), back, (z, z + 0.053), color, "towels", 0.6, 8, solid=False)
        _draped_towels(b, shelf.z, number)
    for side in (-1, 1):
        _used_linen_bag(b, side)
    bag = DrawnFace.side(b, w / 2 - 0.004)
    bag.write("LINEN", (-d * 0.4, d * 0.4), (h * 0.25, h * 0.48), "plastic_white", "letters", 0.005)


def _draped_towels(b: Builder, z: float, number: int) -> None:
    """Three striped towels that hang over the front edge of a tray."""
    w, d = b.w, b.d
    face = DrawnFace.front(b, d / 2)
    for k in range(3):
        u = (k - 1) * w * 0.27
        color = ("fabric_f4f4f0", "fabric_8fc3e8", "fabric_f0d9a8")[(k + number) % 3]
        stripe = ("fabric_2f6fb0", "fabric_f4f4f0", "fabric_c8602f")[(k + number) % 3]
        low = z - 0.15 - 0.02 * ((k + number) % 2)
        b.box(
            (-u - w * 0.12, -u + w * 0.12), (d / 2 - 0.04, d / 2 + 0.004), (z, z + 0.008), color, "towels", solid=False
        )
        face.field((u - w * 0.12, u + w * 0.12), (low, z + 0.006), color, "towels", 0.004)
        for level in (0.02, 0.05):
            face.field((u - w * 0.12, u + w * 0.12), (low + level, low + level + 0.015), stripe, "towels", 0.005)


def _used_linen_bag(b: Builder, side: int) -> None:
    """A blue bag that hangs flat from the rail at one end, with a rim, hooks and a towel that looks out."""
    w, d, h = b.w, b.d, b.h
    across = sorted((side * (w / 2 - 0.046), side * (w / 2 - 0.004)))
    x = (across[0], across[1])
    b.cushion(x, (-d * 0.44, d * 0.44), (h * 0.2, h * 0.9), "fabric_2f6fb0", "bags", 0.5, 10, solid=False)
    b.box(x, (-d * 0.42, d * 0.42), (h * 0.86, h * 0.9), "fabric_1f4f86", "bags", solid=False)
    for y in (-d * 0.3, d * 0.3):
        b.rod((sum(x) / 2, y, h * 0.9), (sum(x) / 2, y, h - 0.02), 0.006, "metal_chrome", "hooks", 6)
    b.cushion(x, (-d * 0.2, d * 0.24), (h * 0.86, h * 0.94), "fabric_white", "towels", 0.8, 8, solid=False)


@recipe("shopping_cart")
def shopping_cart(b: Builder) -> None:
    """Wire basket on wheels, the handle behind."""
    w, d, h = b.w, b.d, b.h
    m = b.mat()
    low, high = h * 0.45, h * 0.88
    for k in range(5):
        z = low + (high - low) * k / 4
        g = 0.82 + 0.18 * k / 4
        x, y0, y1 = w / 2 * g, -d * 0.4, d / 2 * g
        b.path([(-x, y0, z), (x, y0, z), (x, y1, z), (-x, y1, z), (-x, y0, z)], 0.006, m, "basket")
    for k in range(9):
        x = -w * 0.41 + k * w * 0.1025
        b.path([(x, y0, high), (x, y0, low), (x, d * 0.41, low), (x * 1.2, d / 2, high)], 0.004, m, "basket")
    for k in range(7):
        y = y0 + k * (d * 0.8) / 6.5
        for sx in (-1, 1):
            b.rod((sx * w * 0.41, y, low), (sx * w / 2, y * 1.05, high), 0.004, m, "basket", 5)
    for sx in (-1, 1):
        b.path(
            [(sx * w * 0.4, d * 0.42, 0.12), (sx * w * 0.42, -d * 0.4, 0.14), (sx * w * 0.44, -d * 0.46, h - 0.02)],
            0.012,
            m,
            "frame",
        )
    b.rod((-w / 2, -d / 2 + 0.02, h - 0.02), (w / 2, -d / 2 + 0.02, h - 0.02), 0.018, "plastic_red", "handle")
    b.wheels(0.06, 0.08)
    b.boxes.append(Box((0.0, 0.02, (low + high) / 2), (w, d * 0.9, high - low)))


@recipe("basket_stack")
def basket_stack(b: Builder) -> None:
    """Shopping baskets within each other: rims one above the other, pierced walls, and two handles over the topmost."""
    w, d, h = b.w, b.d, b.h
    count = max(4, round(h / 0.11))
    rim = h * 0.86
    step = (rim - 0.2) / count
    for k in range(count):
        z = 0.2 + step * (k + 1)
        b.box((-w * 0.44, w * 0.44), (-d * 0.42, d * 0.42), (z - step if k else 0.0, z - step * 0.3), b.mat(), "walls")
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - step * 0.42, z - step * 0.12), b.mat(), "rims")
    b.box(
        (-w * 0.42, w * 0.42),
        (-d * 0.4, d * 0.4),
        (rim - step * 0.12, rim - step * 0.1),
        "plastic_black",
        "inside",
        solid=False,
    )
    for side in (-1, 1):
        across, along = sorted((side * w / 2, side * w * 0.43)), sorted((side * d / 2, side * d * 0.42))
        b.box((across[0], across[1]), (-d / 2, d / 2), (rim - step * 0.5, rim), b.mat(), "rims")
        b.box((-w / 2, w / 2), (along[0], along[1]), (rim - step * 0.5, rim), b.mat(), "rims")
    face, wall = DrawnFace.front(b, d * 0.42), DrawnFace.side(b, w * 0.44)
    for row in range(3):
        v = 0.03 + 0.055 * row
        for k in range(7):
            u = -w * 0.39 + w * 0.115 * k
            face.field((u, u + w * 0.07), (v, v + 0.03), "plastic_black", "holes", 0.003)
            u = -d * 0.37 + d * 0.11 * k
            wall.field((u, u + d * 0.065), (v, v + 0.03), "plastic_black", "holes", 0.003)
    for y in (-d * 0.2, d * 0.2):
        b.path(
            [(-w * 0.45, y, rim), (-w * 0.38, y * 0.4, h - 0.012), (w * 0.38, y * 0.4, h - 0.012), (w * 0.45, y, rim)],
            0.012,
            "plastic_black",
            "handles",
        )


@recipe("luggage_cart")
def luggage_cart(b: Builder) -> None:
    """Hotel cart with a birdcage frame."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0.2, 0.25), "fabric_red", "deck")
    b.wheels(0.1, 0.1)
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (w / 2 - 0.03), sy * (d / 2 - 0.03)
            b.path(
                [(x, y, 0.2), (x, y, h * 0.75), (x * 0.6, y * 0.5, h * 0.95), (0, 0, h - 0.03)], 0.022, b.mat(), "frame"
            )
    b.rod((-w / 2 + 0.2, 0, h * 0.9), (w / 2 - 0.2, 0, h * 0.9), 0.015, b.mat(), "bar")
    b.ball((0, 0, h - 0.02), (0.03, 0.03, 0.02), b.mat(), "knob", 8, solid=False)
    b.box((-w * 0.35, 0.0), (-d * 0.3, d * 0.3), (0.25, 0.6), "leather_brown", "cases")
    b.box((0.03, w * 0.35), (-d * 0.3, d * 0.2), (0.25, 0.5), "plastic_blue", "cases")
