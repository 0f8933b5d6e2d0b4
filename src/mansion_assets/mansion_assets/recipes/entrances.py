"""What people pass, pay and are watched by, and what puts out fires and keeps keys, on their way through a building."""

import math

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("turnstile")
def turnstile(b: Builder) -> None:
    """A narrow steel cabinet with a head of three bars at its side, a card reader and a lit green arrow."""
    w, d, h = b.w, b.d, b.h
    x = (-w / 2, w * 0.1)
    b.box(x, (-d * 0.46, d * 0.46), (0, h * 0.8), b.mat(), "cabinet")
    b.prism(
        [(-d / 2, h * 0.8), (d / 2, h * 0.8), (d / 2, h * 0.86), (d * 0.4, h), (-d * 0.4, h), (-d / 2, h * 0.86)],
        x,
        "metal_dark",
        part="top",
    )
    b.box((x[0], x[1]), (-d * 0.48, d * 0.48), (0, h * 0.06), "metal_dark", "foot")
    hub = (w * 0.12, 0.0, h * 0.74)
    b.rod((x[1], 0, hub[2]), (w * 0.18, 0, hub[2] - 0.02), h * 0.1, "metal_chrome", "head", 16)
    for k in range(3):
        a = math.pi / 2 + k * math.tau / 3
        tip = (w / 2 - 0.03, math.cos(a) * d * 0.3, hub[2] + math.sin(a) * h * 0.3 - h * 0.06)
        b.rod(
            (w * 0.16, math.cos(a) * 0.03, hub[2] + math.sin(a) * 0.03),
            tip,
            0.025,
            "metal_chrome",
            "arms",
            10,
            solid=True,
        )
        b.ball(tip, (0.03, 0.03, 0.03), "metal_chrome", "arms", 8)
    slope = DrawnFace.sloped(b, (d / 2, h * 0.86), (d * 0.4, h))
    middle = -(x[0] + x[1]) / 2
    slope.field((middle - w * 0.2, middle + w * 0.2), (0.03, h * 0.14), "plastic_black", "reader", 0.006)
    slope.field((middle - w * 0.12, middle + w * 0.12), (0.05, h * 0.1), "light_4f9bf0", "reader", 0.01)
    face = DrawnFace.front(b, d * 0.46)
    face.disc(middle, h * 0.66, w * 0.24, "plastic_black", "sign", 0.008)
    face.field((middle - w * 0.04, middle + w * 0.04), (h * 0.6, h * 0.68), "light_green", "sign", 0.014)
    y = (d * 0.46, d * 0.46 + 0.014)
    b.prism(
        [(-middle - w * 0.13, h * 0.67), (-middle + w * 0.13, h * 0.67), (-middle, h * 0.73)],
        y,
        "light_green",
        "y",
        "sign",
    )


@recipe("ticket_machine")
def ticket_machine(b: Builder) -> None:
    """A cabinet under a lit sign TICKETS: a screen, slots for coins, notes and cards, keys."""
    w, d, h = b.w, b.d, b.h
    front = d / 2 - 0.06
    b.box((-w * 0.48, w * 0.48), (-d / 2, front - 0.03), (0, 0.05), "metal_dark", "foot")
    b.box((-w / 2, w / 2), (-d / 2, front), (0.05, h * 0.86), b.mat(), "case")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.86, h), b.mat(), "head")
    sign = DrawnFace.front(b, d / 2)
    sign.field((-w * 0.48, w * 0.48), (h * 0.87, h * 0.99), "light_white", "sign", 0.004)
    sign.write("TICKETS", (-w * 0.45, w * 0.45), (h * 0.89, h * 0.97), "paint_2f3f8f", "letters", 0.007)
    side = DrawnFace.side(b, w / 2)
    side.write("TICKETS", (-d * 0.46, d * 0.34), (h * 0.89, h * 0.97), "plastic_white", "letters", 0.004)
    face = DrawnFace.front(b, front)
    face.field((-w * 0.44, w * 0.44), (h * 0.26, h * 0.84), "metal_light", "panel", 0.006)
    face.field((-w * 0.4, w * 0.12), (h * 0.58, h * 0.82), "plastic_black", "screen", 0.01)
    face.field((-w * 0.38, w * 0.1), (h * 0.59, h * 0.81), "screen_blue", "screen", 0.012)
    face.field((w * 0.18, w * 0.4), (h * 0.72, h * 0.75), "plastic_black", "notes", 0.02)
    face.field((w * 0.18, w * 0.4), (h * 0.755, h * 0.8), "light_green", "notes", 0.01)
    face.field((w * 0.28, w * 0.3), (h * 0.6, h * 0.68), "plastic_black", "coins", 0.02)
    face.disc(w * 0.29, h * 0.64, w * 0.08, "metal_brass", "coins", 0.012)
    for k in range(12):
        u, v = w * (-0.36 + 0.09 * (k % 3)), h * (0.4 + 0.04 * (k // 3))
        face.field((u, u + w * 0.07), (v, v + h * 0.03), "plastic_dark", "keys", 0.014)
    face.field((w * 0.02, w * 0.36), (h * 0.47, h * 0.5), "plastic_black", "card", 0.02)
    b.box((-w * 0.3, -w * 0.08), (front, front + 0.07), (h * 0.482, h * 0.488), "paint_yellow", "card")
    face.field((-w * 0.38, w * 0.38), (h * 0.28, h * 0.37), "plastic_black", "tray", 0.012)
    b.prism(
        [(front + 0.01, h * 0.32), (front + 0.01, h * 0.33), (d / 2 + 0.02, h * 0.29), (d / 2 + 0.02, h * 0.28)],
        (-w * 0.12, w * 0.16),
        "paper_f3c64a",
        part="ticket",
    )
    face.field((-w * 0.34, w * 0.34), (h * 0.1, h * 0.2), "plastic_white", "train", 0.004)
    for k in range(4):
        u = w * (-0.28 + 0.145 * k)
        face.field((u, u + w * 0.11), (h * 0.145, h * 0.185), "plastic_2f3f8f", "train", 0.006)
    for u in (-w * 0.2, w * 0.2):
        face.disc(u, h * 0.1, w * 0.05, "plastic_black", "train", 0.006)


@recipe("hose_cabinet")
def hose_cabinet(b: Builder) -> None:
    """A red case with a door of glass before a reel of red hose with its nozzle, and the word FIRE above it."""
    w, d, h = b.w, b.d, b.h
    front, t = d / 2 - 0.02, 0.02
    b.hollow((-w / 2, w / 2), (-d / 2, front), (0, h), t, b.mat())
    b.rod((0, -d / 2 + t, h * 0.44), (0, -d * 0.3, h * 0.44), h * 0.33, "metal_dark", "reel", 28)
    for k, share in enumerate((0.32, 0.265, 0.21)):
        ring = [
            (math.cos(a) * h * share, -d * 0.12 + 0.01 * k, h * 0.44 + math.sin(a) * h * share)
            for a in (j * math.tau / 22 for j in range(23))
        ]
        b.path(ring, h * 0.03, ("fabric_d8483a", "fabric_e8c9a0", "fabric_d8483a")[k], "hose")
    b.rod((0, -d * 0.3, h * 0.44), (0, d * 0.12, h * 0.44), h * 0.12, "metal_light", "hub", 20)
    for k in range(4):
        a = math.pi / 4 + k * math.pi / 2
        b.rod(
            (0, d * 0.02, h * 0.44),
            (math.cos(a) * h * 0.32, d * 0.02, h * 0.44 + math.sin(a) * h * 0.32),
            0.012,
            "metal_light",
            "reel",
            8,
        )
    b.path(
        [(w * 0.3, -d * 0.1, h * 0.2), (w * 0.36, 0, h * 0.4), (w * 0.36, 0, h * 0.62)], 0.022, "fabric_d8483a", "hose"
    )
    b.rod((w * 0.36, 0, h * 0.6), (w * 0.36, 0, h * 0.76), 0.026, "metal_brass", "nozzle", 12)
    door = (front + 0.001, front + 0.014)
    panel = ((-w / 2, w / 2), door, (0.0, h))
    with b.door(*panel, "left"):
        for across in ((-w / 2, -w * 0.43), (w * 0.43, w / 2)):
            b.box(across, door, (0, h), b.mat(), "door")
        b.box((-w / 2, w / 2), door, (0, h * 0.07), b.mat(), "door")
        b.box((-w / 2, w / 2), door, (h * 0.8, h), b.mat(), "door")
        b.box(
            (-w * 0.43, w * 0.43), (door[0], door[0] + 0.004), (h * 0.07, h * 0.8), "glass_clear", "window", solid=False
        )
        face = DrawnFace.front(b, door[1])
        face.write("FIRE HOSE", (-w * 0.45, w * 0.45), (h * 0.83, h * 0.97), "plastic_white", "letters", 0.004)
        b.box((w * 0.44, w * 0.48), (door[1], d / 2), (h * 0.38, h * 0.5), "metal_chrome", "handle", solid=False)


@recipe("key_cabinet")
def key_cabinet(b: Builder) -> None:
    """A shallow steel case with a locked door of glass, behind which keys with coloured tags hang in rows."""
    w, d, h = b.w, b.d, b.h
    front, t = d / 2 - 0.014, 0.008
    b.hollow((-w / 2, w / 2), (-d / 2, front), (0, h), t, b.mat())
    b.box((-w / 2 + t, w / 2 - t), (-d / 2 + t, -d / 2 + t + 0.003), (t, h - t), "paper_white", "board", solid=False)
    y = -d * 0.1
    for k in range(12):
        x, z = w * (-0.33 + 0.22 * (k % 4)), h * (0.82 - 0.28 * (k // 4))
        b.rod((x, -d / 2 + t, z), (x, y + 0.004, z), 0.003, "metal_dark", "hooks", 6)
        if k in (6, 9):
            continue
        color = ("plastic_red", "plastic_4f9bd9", "plastic_yellow", "plastic_green")[(k * 3) % 4]
        b.box((x - w * 0.05, x + w * 0.05), (y, y + 0.004), (z - h * 0.09, z - h * 0.005), color, "tags")
        b.rod((x, y, z - h * 0.11), (x, y + 0.004, z - h * 0.11), w * 0.036, "metal_brass", "keys", 12)
        b.box((x - w * 0.011, x + w * 0.011), (y, y + 0.004), (z - h * 0.22, z - h * 0.12), "metal_brass", "keys")
        for tooth in (0.2, 0.17):
            b.box((x, x + w * 0.04), (y, y + 0.004), (z - h * (tooth + 0.014), z - h * tooth), "metal_brass", "keys")
    door = (front + 0.001, front + 0.01)
    with b.door((-w / 2, w / 2), door, (0.0, h), "left"):
        for across in ((-w / 2, -w * 0.45), (w * 0.45, w / 2)):
            b.box(across, door, (0, h), b.mat(), "door")
        for up in ((0.0, h * 0.05), (h * 0.95, h)):
            b.box((-w / 2, w / 2), door, up, b.mat(), "door")
        b.box(
            (-w * 0.45, w * 0.45),
            (door[0], door[0] + 0.003),
            (h * 0.05, h * 0.95),
            "glass_clear",
            "window",
            solid=False,
        )
        b.rod((w * 0.475, door[1], h * 0.5), (w * 0.475, d / 2, h * 0.5), w * 0.024, "metal_brass", "lock", 12)


@recipe("cctv_camera")
def cctv_camera(b: Builder) -> None:
    """A white barrel with a sunshade on a jointed arm at the wall, a dark lens in a ring of lamps, and a red light."""
    w, d, h = b.w, b.d, b.h
    back = -d / 2
    b.rod((0, back, h * 0.72), (0, back + d * 0.06, h * 0.72), h * 0.27, "plastic_light", "plate", 20)
    b.path(
        [(0, back + d * 0.05, h * 0.72), (0, back + d * 0.22, h * 0.66), (0, -d * 0.1, h * 0.86)],
        w * 0.08,
        "plastic_light",
        "arm",
    )
    b.ball((0, back + d * 0.22, h * 0.67), (w * 0.12, w * 0.12, w * 0.12), "plastic_grey", "arm", 10)
    start, end = (0.0, -d * 0.24, h * 0.62), (0.0, d * 0.4, h * 0.3)
    b.rod(start, end, w * 0.26, b.mat(), "barrel", 20, solid=True)
    shade = [(-d * 0.3, h * 0.9), (d * 0.26, h * 0.63), (d * 0.26, h * 0.71), (-d * 0.3, h * 0.98)]
    b.prism(shade, (-w * 0.34, w * 0.34), b.mat(), part="sunshade")
    for side in (-1, 1):
        across = sorted((side * w * 0.34, side * w * 0.29))
        flap = [(-d * 0.28, h * 0.68), (d * 0.22, h * 0.5), (d * 0.26, h * 0.66), (-d * 0.3, h * 0.92)]
        b.prism(flap, (across[0], across[1]), b.mat(), part="sunshade")
    b.rod(end, (0, d * 0.41, h * 0.295), w * 0.24, "plastic_black", "lens", 20)
    b.rod((0, d * 0.41, h * 0.295), (0, d * 0.44, h * 0.28), w * 0.12, "glass_3d6a9e", "lens", 16)
    for k in range(8):
        a = k * math.pi / 4
        b.ball(
            (math.cos(a) * w * 0.18, d * 0.412 + 0.0, h * 0.29 + math.sin(a) * w * 0.18),
            (w * 0.03, w * 0.02, w * 0.03),
            "metal_light",
            "lamps",
            6,
        )
    b.ball((-w * 0.0, d * 0.42, h * 0.29 + w * 0.22), (w * 0.04, w * 0.03, w * 0.04), "light_red", "light", 8)


@recipe("webcam")
def webcam(b: Builder) -> None:
    """A ball with a large lens and a lit dot, on a clip that holds the edge of a screen, with a cable to a plug."""
    w, d, h = b.w, b.d, b.h
    z, r = h * 0.66, h * 0.32
    b.cushion((-w / 2, w / 2), (-d * 0.2, d * 0.3), (z - r, h), b.mat(), "case", 0.8, 14)
    b.rod((0, d * 0.24, z), (0, d * 0.42, z), r * 0.86, "plastic_grey", "lens", 22)
    b.rod((0, d * 0.4, z), (0, d * 0.46, z), r * 0.7, "plastic_black", "lens", 22)
    b.rod((0, d * 0.44, z), (0, d / 2, z), r * 0.42, "glass_2f4f9f", "lens", 18)
    b.ball((-r * 0.1, d * 0.5, z + r * 0.14), (r * 0.12, r * 0.05, r * 0.12), "light_white", "lens", 8)
    b.ball((w * 0.4, d * 0.24, z), (w * 0.04, d * 0.06, w * 0.04), "light_green", "lamp", 8)
    b.box((-w * 0.24, w * 0.24), (-d * 0.1, d * 0.34), (h * 0.28, h * 0.36), "plastic_dark", "clip")
    b.prism(
        [(d * 0.26, h * 0.36), (d * 0.34, h * 0.36), (d * 0.34, 0.0), (d * 0.26, 0.0)],
        (-w * 0.2, w * 0.2),
        "plastic_dark",
        part="clip",
    )
    b.prism(
        [(-d * 0.1, h * 0.36), (-d * 0.02, h * 0.36), (-d * 0.38, 0.0), (-d * 0.46, 0.0)],
        (-w * 0.2, w * 0.2),
        "plastic_dark",
        part="clip",
    )
    b.path(
        [(0, -d * 0.18, z), (0, -d * 0.4, h * 0.5), (w * 0.3, -d * 0.46, h * 0.2), (w * 0.44, -d * 0.3, h * 0.04)],
        h * 0.03,
        "rubber_black",
        "cable",
    )


@recipe("photo_camera")
def photo_camera(b: Builder) -> None:
    """A black body with a silver top, a ringed lens with blue glass, a finder above it, a red release, and a strap."""
    w, d, h = b.w, b.d, b.h
    front, top = d * 0.04, h * 0.66
    b.cushion((-w * 0.48, w * 0.48), (-d * 0.34, front), (0, top), "leather_black", "body", 0.3, 12)
    b.box((-w * 0.47, w * 0.47), (-d * 0.32, front - 0.002), (top - h * 0.04, top + h * 0.1), "metal_light", "top")
    b.prism(
        [(-w * 0.2, top + h * 0.1), (w * 0.2, top + h * 0.1), (w * 0.12, h), (-w * 0.12, h)],
        (-d * 0.3, front),
        "metal_light",
        "y",
        "finder",
    )
    b.cushion((-w * 0.48, -w * 0.3), (-d * 0.1, d * 0.18), (h * 0.04, top * 0.96), "leather_black", "grip", 0.6)
    z = h * 0.36
    for y0, y1, r, color in (
        (0.0, 0.2, 0.34, "metal_dark"),
        (0.2, 0.26, 0.35, "metal_light"),
        (0.26, 0.44, 0.33, "plastic_black"),
        (0.44, 0.5, 0.3, "metal_dark"),
    ):
        b.rod((w * 0.04, front + d * (y0 - 0.06), z), (w * 0.04, d * y1, z), h * r, color, "lens", 24, solid=True)
    b.rod((w * 0.04, d * 0.48, z), (w * 0.04, d * 0.505, z), h * 0.23, "glass_2f4f9f", "glass", 22)
    b.ball((w * 0.04 - h * 0.07, d * 0.505, z + h * 0.08), (h * 0.05, h * 0.02, h * 0.05), "light_white", "glass", 8)
    b.cyl(-w * 0.36, -d * 0.12, (top + h * 0.1, top + h * 0.19), w * 0.05, "paint_red", "release", n=12)
    b.cyl(w * 0.34, -d * 0.14, (top + h * 0.1, top + h * 0.22), w * 0.09, "metal_dark", "dial", n=16)
    b.box(
        (-w * 0.07, w * 0.07), (front, front + 0.002), (top + h * 0.16, h * 0.94), "glass_2f4f9f", "finder", solid=False
    )
    b.path(
        [
            (w * 0.48, -d * 0.16, top),
            (w * 0.56, -d * 0.3, h * 0.4),
            (w * 0.5, -d * 0.46, h * 0.1),
            (w * 0.1, -d * 0.5, h * 0.04),
        ],
        w * 0.03,
        "leather_brown",
        "strap",
    )


@recipe("card_terminal")
def card_terminal(b: Builder) -> None:
    """A payment terminal: a sloped face with a screen and keys, three of them red, yellow and green, a card."""
    w, d, h = b.w, b.d, b.h
    back, y0, y1 = -d * 0.3, -d * 0.3, d * 0.3
    b.prism(
        [(back - d * 0.16, 0), (y1, 0), (y1, h * 0.34), (y0, h * 0.7), (back - d * 0.16, h * 0.7)],
        (-w / 2, w / 2),
        b.mat(),
        part="case",
    )
    face = DrawnFace.sloped(b, (y1, h * 0.34), (y0, h * 0.7))
    face.field((-w * 0.42, w * 0.42), (d * 0.36, d * 0.58), "screen_green", "screen", h * 0.03)
    for k in range(12):
        u, v = w * (-0.4 + 0.28 * (k % 3)), d * (0.12 + 0.055 * (k // 3))
        face.field((u, u + w * 0.23), (v, v + d * 0.04), "plastic_light", "keys", h * 0.08)
    for k, color in enumerate(("red", "yellow", "green")):
        u = w * (-0.4 + 0.28 * k)
        face.field((u, u + w * 0.23), (d * 0.05, d * 0.1), f"plastic_{color}", "keys", h * 0.1)
    b.box((-w * 0.42, w * 0.42), (d * 0.1, d / 2), (h * 0.08, h * 0.14), "plastic_3d6ac8", "card")
    b.box((-w * 0.3, -w * 0.1), (d * 0.36, d * 0.44), (h * 0.14, h * 0.15), "metal_brass", "card", solid=False)
    paper = [
        (back - d * 0.06, h * 0.68),
        (back - d * 0.04, h * 0.68),
        (back - d * 0.16, h * 1.5),
        (back - d * 0.2, h * 1.48),
    ]
    b.prism(paper, (-w * 0.34, w * 0.34), "paper_white", part="receipt")
    sheet = DrawnFace.sloped(b, (back - d * 0.04, h * 0.68), (back - d * 0.16, h * 1.5))
    for k in range(5):
        v = h * (0.2 + 0.13 * k)
        sheet.field((-w * 0.28, w * (0.0 + 0.1 * (k % 3))), (v, v + h * 0.05), "paper_dark", "receipt", h * 0.01)


@recipe("computer_case")
def computer_case(b: Builder) -> None:
    """A tower with a side of glass before a lit board, cards and fans; a drive, sockets and a blue switch in front."""
    w, d, h = b.w, b.d, b.h
    front, side = d / 2 - 0.012, w / 2 - 0.008
    b.box((-w / 2, side - 0.02), (-d / 2, front), (0.012, h), b.mat(), "case")
    for up in ((0.012, 0.06), (h - 0.04, h)):
        b.box((side - 0.02, side), (-d / 2, front), up, b.mat(), "case")
    for along in ((-d / 2, -d * 0.44), (front - d * 0.1, front)):
        b.box((side - 0.02, side), along, (0.012, h), b.mat(), "case")
    for x in (-w * 0.36, w * 0.36):
        for y in (-d * 0.4, d * 0.36):
            b.box((x - 0.015, x + 0.015), (y - 0.02, y + 0.02), (0, 0.012), "rubber_black", "feet")
    board = DrawnFace.side(b, side - 0.02)
    board.field((-d * 0.42, d * 0.34), (0.07, h - 0.05), "plastic_1f5f3a", "board", 0.003)
    for u, v, color in (
        (-d * 0.18, h * 0.7, "light_4f9bf0"),
        (d * 0.2, h * 0.72, "light_d94fd0"),
        (d * 0.2, h * 0.4, "light_4f9bf0"),
    ):
        ring = [(u + math.cos(k * math.pi / 9) * d * 0.12, v + math.sin(k * math.pi / 9) * d * 0.12) for k in range(19)]
        board.line(ring, 0.006, color, "fans", 0.008)
        board.disc(u, v, d * 0.1, "plastic_black", "fans", 0.006, 20)
        for k in range(5):
            a = k * math.tau / 5
            board.line(
                [(u, v), (u + math.cos(a) * d * 0.09, v + math.sin(a) * d * 0.09)], 0.007, "plastic_grey", "fans", 0.009
            )
    board.field((-d * 0.4, d * 0.04), (h * 0.4, h * 0.46), "metal_dark", "cards", 0.016)
    board.field((-d * 0.4, d * 0.0), (h * 0.28, h * 0.31), "paint_red", "cards", 0.014)
    b.box((side - 0.002, w / 2), (-d * 0.44, front - d * 0.1), (0.06, h - 0.04), "glass_clear", "window", solid=False)
    face = DrawnFace.front(b, front)
    face.field((-w * 0.42, w * 0.42), (h * 0.86, h * 0.94), "metal_grey", "drive", 0.006)
    face.field((-w * 0.38, w * 0.3), (h * 0.895, h * 0.905), "plastic_black", "drive", 0.008)
    face.disc(0, h * 0.76, w * 0.1, "light_4f9bf0", "switch", 0.008)
    face.disc(0, h * 0.76, w * 0.07, "plastic_black", "switch", 0.01)
    for u in (-0.24, -0.08, 0.08):
        face.field((w * u, w * (u + 0.1)), (h * 0.655, h * 0.675), "plastic_4f9bd9", "sockets", 0.006)
    for k in range(10):
        face.field((-w * 0.4, w * 0.4), (h * (0.1 + 0.05 * k), h * (0.125 + 0.05 * k)), "plastic_dark", "grille", 0.006)


@recipe("score_board")
def score_board(b: Builder) -> None:
    """A black board with HOME and GUEST over red figures in lamps, and the time between them."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.012), (0, h), b.mat(), "case")
    face = DrawnFace.front(b, d / 2 - 0.012)
    for edge in ((h * 0.02, h * 0.035), (h * 0.965, h * 0.98)):
        face.field((-w * 0.49, w * 0.49), edge, "plastic_white", "frame", 0.004)
    face.write("HOME", (-w * 0.47, -w * 0.14), (h * 0.78, h * 0.93), "plastic_white", "letters", 0.006)
    face.write("GUEST", (w * 0.12, w * 0.47), (h * 0.78, h * 0.93), "plastic_white", "letters", 0.006)
    for u, figure in ((-w * 0.305, "3"), (w * 0.295, "1")):
        face.field((u - w * 0.14, u + w * 0.14), (h * 0.26, h * 0.74), "plastic_200808", "panels", 0.003)
        face.write(figure, (u - w * 0.12, u + w * 0.12), (h * 0.3, h * 0.7), "light_ff3a20", "figures", 0.01)
    face.write(":", (-w * 0.03, w * 0.03), (h * 0.36, h * 0.62), "light_ff3a20", "figures", 0.01)
    face.write("45:00", (-w * 0.2, w * 0.2), (h * 0.06, h * 0.22), "light_yellow", "figures", 0.01)
