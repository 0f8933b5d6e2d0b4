"""Furniture of halls and chapels: stages, lecterns, altars, coffins."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


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


@recipe("lectern")
def lectern(b: Builder) -> None:
    """Standing desk for a speaker, its sloped top towards the back."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2 + 0.04, w / 2 - 0.04), (-d / 2 + 0.03, d / 2 - 0.03), (0, 0.05), b.mat(), "foot")
    b.box((-w / 2 + 0.07, w / 2 - 0.07), (-d * 0.15, d / 2 - 0.04), (0.04, h - 0.16), b.mat(), "body")
    b.prism(
        [(-d / 2, h - 0.18), (-d / 2, h - 0.13), (d / 2, h), (d / 2, h - 0.05)], (-w / 2, w / 2), b.mat(), part="top"
    )
    b.box((-0.1, 0.1), (d / 2 - 0.045, d / 2 - 0.035), (h * 0.5, h * 0.7), "metal_steel", "plate", solid=False)


@recipe("host_stand")
def host_stand(b: Builder) -> None:
    """A stand whose sign asks to wait to be seated, an open book of reservations and a brass lamp on its top."""
    w, d, h = b.w, b.d, b.h
    top, front = h * 0.83, d / 2 - 0.04
    b.box((-w / 2 + 0.02, w / 2 - 0.02), (-d / 2 + 0.02, d / 2 - 0.02), (0, 0.05), b.mat(), "foot")
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d * 0.3, front), (0.05, top - 0.04), b.mat(), "body")
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (top - 0.04, top), b.mat(), "top")
    face = DrawnFace.front(b, front)
    face.field((-w * 0.43, w * 0.43), (h * 0.1, top - 0.07), "metal_brass", "sign", 0.006)
    face.field((-w * 0.4, w * 0.4), (h * 0.12, top - 0.09), "plastic_f8f2e0", "sign", 0.01)
    lines, tall = ("PLEASE", "WAIT", "TO BE", "SEATED"), (top - 0.11 - h * 0.14) / 4
    for k, line in enumerate(lines):
        low = h * 0.14 + (3 - k) * tall
        face.write(
            line, (-w * 0.37, w * 0.37), (low + tall * 0.1, low + tall * 0.88), "plastic_26201a", "letters", 0.014
        )
    _reservations(b, top)
    x, y = -w * 0.34, -d * 0.1
    b.cyl(x, y, (top, top + 0.014), 0.06, "metal_brass", "lamp", n=18, solid=False)
    b.rod((x, y, top), (x, y, h - 0.06), 0.012, "metal_brass", "lamp", 10)
    b.lathe([(0.085, h - 0.09), (0.04, h)], "light_2f9e5f", (x, y), "shade", 18)


def _reservations(b: Builder, top: float) -> None:
    """An open book with lines of names, a ribbon and a pen."""
    w, d = b.w, b.d
    b.box((-w * 0.2, w * 0.45), (-d * 0.4, d * 0.4), (top, top + 0.014), "leather_8a1f1f", "book", solid=False)
    face = DrawnFace.top(b, top + 0.014)
    for low, high in ((-w * 0.43, -w * 0.135), (-w * 0.115, w * 0.18)):
        face.field((low, high), (-d * 0.37, d * 0.37), "paper_white", "pages", 0.014)
        for k in range(6):
            v = d * (-0.3 + 0.11 * k)
            face.field((low + 0.02, high - 0.03), (v, v + 0.012), "plastic_3a4f8a", "names", 0.016)
    face.field((-w * 0.135, -w * 0.115), (-d * 0.46, d * 0.37), "fabric_red", "ribbon", 0.016)


@recipe("altar")
def altar(b: Builder) -> None:
    """A block of stone with a white cloth whose ends hang down, edged with gold, and a golden cross on its front."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.08), "stone_grey", "step")
    b.box((-w * 0.42, w * 0.42), (-d * 0.4, d * 0.4), (h * 0.08, h * 0.9), b.mat(), "body")
    b.box((-w / 2 + 0.01, w / 2 - 0.01), (-d / 2 + 0.01, d / 2 - 0.01), (h * 0.9, h * 0.985), b.mat(), "slab")
    cloth = (-d / 2 + 0.05, d / 2 - 0.05)
    b.box((-w / 2, w / 2), cloth, (h * 0.985, h), "fabric_fdfdfb", "cloth")
    for side in (-1, 1):
        across = sorted((side * w / 2, side * (w / 2 - 0.012)))
        b.box((across[0], across[1]), cloth, (h * 0.4, h), "fabric_fdfdfb", "cloth")
        b.box((across[0] - 0.002, across[1] + 0.002), cloth, (h * 0.4, h * 0.44), "metal_brass", "fringe")
    face = DrawnFace.front(b, d / 2 - 0.01)
    face.field((-w * 0.3, w * 0.3), (h * 0.5, h * 0.98), "fabric_fdfdfb", "front_cloth", 0.008)
    face.field((-w * 0.3, w * 0.3), (h * 0.5, h * 0.54), "metal_brass", "fringe", 0.012)
    plate = DrawnFace.front(b, d * 0.4)
    face.field((-w * 0.03, w * 0.03), (h * 0.6, h * 0.94), "metal_brass", "cross", 0.014)
    face.field((-w * 0.1, w * 0.1), (h * 0.78, h * 0.84), "metal_brass", "cross", 0.014)
    for side in (-1, 1):
        u = side * w * 0.3
        plate.field((u - w * 0.05, u + w * 0.05), (h * 0.14, h * 0.46), "stone_white", "panels", 0.012)
        plate.field((u - w * 0.012, u + w * 0.012), (h * 0.2, h * 0.42), "metal_brass", "panels", 0.02)
        plate.field((u - w * 0.035, u + w * 0.035), (h * 0.33, h * 0.36), "metal_brass", "panels", 0.02)


@recipe("coffin")
def coffin(b: Builder) -> None:
    """A chest that is widest at the shoulders, with a bevelled lid that bears a cross, and handles along its sides."""
    w, d, h = b.w, b.d, b.h
    low = h * 0.7
    outline = ((-0.28, -0.5), (0.28, -0.5), (0.47, -0.2), (0.3, 0.5), (-0.3, 0.5), (-0.47, -0.2))
    levels = (
        (0.0, low, 0.94, b.mat()),
        (0.0, h * 0.06, 1.0, "wood_black"),
        (low, h * 0.78, 1.0, "wood_black"),
        (h * 0.78, h * 0.9, 0.9, b.mat()),
        (h * 0.9, h * 0.96, 0.7, b.mat()),
    )
    for z0, z1, share, color in levels:
        b.prism([(x * w * share, y * d * (0.5 + share / 2)) for x, y in outline], (z0, z1), color, "z", "chest")
    b.box((-w * 0.035, w * 0.035), (-d * 0.36, d * 0.34), (h * 0.95, h), "metal_brass", "cross")
    b.box((-w * 0.2, w * 0.2), (-d * 0.2, -d * 0.16), (h * 0.95, h), "metal_brass", "cross")
    for side in (-1, 1):
        for share in (-0.02, 0.16, 0.34):
            y = d * share
            x = side * w * (0.46 - 0.25 * (share + 0.2)) * 0.98
            b.path(
                [
                    (x * 0.94, y - d * 0.05, low * 0.6),
                    (x * 1.06, y - d * 0.05, low * 0.55),
                    (x * 1.06, y + d * 0.05, low * 0.55),
                    (x * 0.94, y + d * 0.05, low * 0.6),
                ],
                0.014,
                "metal_brass",
                "handles",
            )
    for x in (-w * 0.16, w * 0.16):
        b.rod((x, d * 0.48, low * 0.55), (x, d / 2, low * 0.55), 0.03, "metal_brass", "handles", 12)
