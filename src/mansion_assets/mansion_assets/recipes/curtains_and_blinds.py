"""Curtains of rooms, baths and hospital beds, and blinds."""

from mansion_assets.builder import Builder
from mansion_assets.drawn_faces import DrawnFace
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("curtain")
def curtain(b: Builder) -> None:
    """Folds on a rail, gathered at both sides; blinds; a curtain rail on the ceiling."""
    w, d, h = b.w, b.d, b.h
    main, style = b.mat(), b.p.get("style")
    if style == "blinds":
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.75, h), "plastic_white", "box")
        for k in range(4):
            b.box((-w / 2, w / 2), (-d * 0.4, d * 0.4), (h * k * 0.18, h * k * 0.18 + h * 0.1), main, "slats")
        return
    r = min(0.014, d * 0.12)
    y = 0.0 if style != "rail" else d / 2 - r
    b.rod((-w / 2, y, h - r), (w / 2, y, h - r), r, "metal_steel", "rail", solid=True)
    if style == "rail":
        for x in (-w / 2 + r, w / 2 - r):
            b.rod((x, -d / 2, h - r), (x, d / 2, h - r), r, "metal_steel", "rail")
    count = 4
    fold = min(0.07, w * 0.06)
    for side in (-1, 1):
        for k in range(count):
            x = side * (w / 2 - fold * (k + 0.5))
            depth = min(d / 2, 0.05)
            b.cushion(
                (x - fold / 2, x + fold / 2), (y - depth, min(d / 2, y + depth)), (0, h - r), main, "folds", 0.95, 8
            )
    if style != "rail":
        b.box((-w / 2, -w / 2 + 0.01), (-d / 2, d / 2), (h - 0.06, h), "metal_steel", "end", solid=False)


@recipe("bath_curtain")
def bath_curtain(b: Builder) -> None:
    """A waved curtain with blue spots on rings along a rod, with a hem that is wet at its foot."""
    w, d, h = b.w, b.d, b.h
    rod = h - 0.03
    b.rod((-w / 2, 0, rod), (w / 2, 0, rod), min(0.014, d * 0.1), "metal_chrome", "rod", 10, solid=True)
    for side in (-1, 1):
        b.rod((side * w * 0.46, 0, rod), (side * w / 2, 0, rod), 0.028, "metal_chrome", "rod", 12)
    folds = 8
    for k in range(folds):
        x = -w * 0.46 + w * 0.92 * (k + 0.5) / folds
        y = d * 0.2 * (-1) ** k
        b.lathe(
            [(w * 0.075, 0.0), (w * 0.06, rod - 0.07)],
            ("fabric_white", "fabric_dfe9ee")[k % 2],
            (x, y),
            "cloth",
            10,
            (1.0, d * 0.3 / (w * 0.075)),
        )
        b.path([(x, 0, rod + 0.02), (x, y * 0.3, rod - 0.07)], 0.005, "metal_chrome", "rings")
        for j in range(5):
            z = h * (0.1 + 0.17 * j + 0.08 * (k % 2))
            if z < rod - 0.15:
                front = y + d * 0.3
                b.rod((x, front - d * 0.08, z), (x, front + 0.003, z), w * 0.034, "fabric_4f9bd9", "spots", 10)


@recipe("ward_curtain")
def ward_curtain(b: Builder) -> None:
    """A rail round a bed below the ceiling, with a curtain of deep folds in it whose upper edge is of net."""
    w, d, h = b.w, b.d, b.h
    rail, front = h * 0.9, d / 2 - 0.04
    corners = [(-w / 2 + 0.03, -d / 2), (-w / 2 + 0.03, front), (w / 2 - 0.03, front), (w / 2 - 0.03, -d / 2)]
    b.path([(x, y, rail) for x, y in corners], 0.015, "metal_steel", "rail")
    for x, y in corners[1:3]:
        b.rod((x, y, rail), (x, y, h), 0.012, "metal_steel", "rods", 8)
    folds = max(14, round(w / 0.11))
    for k in range(folds):
        x = -w / 2 + 0.06 + (w - 0.12) * (k + 0.5) / folds
        y = front + 0.022 * (-1) ** k
        b.cyl(x, y, (h * 0.66, rail - 0.03), w / folds * 0.5, "fabric_white", "net", n=8)
        b.cyl(x, y, (0, h * 0.66), w / folds * 0.52, b.mat(), "cloth", n=8)
    for k in range(4):
        y = front - (k + 0.6) * 0.1
        b.cyl(w / 2 - 0.03 - 0.02 * (-1) ** k, y, (0, rail - 0.03), 0.055, b.mat(), "cloth", n=8)


@recipe("slatted_blind")
def slatted_blind(b: Builder) -> None:
    """A blind half let down before a window: slats on broad tapes below a head box, sky below, a cord with tassels."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.86, h), "plastic_white", "box")
    b.box((-w / 2, w / 2), (-d / 2, d * 0.5), (0, h * 0.07), "wood_white", "sill")
    for x in ((-w / 2, -w * 0.475), (w * 0.475, w / 2), (-w * 0.0125, w * 0.0125)):
        b.box(x, (-d / 2, -d * 0.3), (0, h * 0.86), "wood_white", "window")
    b.box((-w * 0.48, w * 0.48), (-d / 2, -d * 0.42), (0, h * 0.86), "screen_5fb4ee", "sky", solid=False)
    pane = DrawnFace.front(b, -d * 0.42)
    for u in (-w * 0.3, -w * 0.05, w * 0.22):
        for k in range(3):
            at = (u + (k - 1) * h * 0.16, h * (0.2 + 0.03 * (k % 2)))
            pane.disc(*at, h * (0.07 + 0.03 * (k % 2)), "screen_ffffff", "clouds", d * 0.03, 14)
    count, low = 3, h * 0.28
    b.box((-w * 0.47, w * 0.47), (-d * 0.34, -d * 0.28), (low, h * 0.86), "plastic_3a4654", "shade", solid=False)
    for k in range(count):
        z, step = low + (h * 0.86 - low) * k / count, (h * 0.86 - low) / count
        low_edge, high_edge = (d * 0.3, z + step * 0.3), (-d * 0.26, z + step * 0.76)
        slat = [
            high_edge,
            low_edge,
            (low_edge[0], low_edge[1] + step * 0.12),
            (high_edge[0], high_edge[1] + step * 0.12),
        ]
        b.prism(slat, (-w * 0.47, w * 0.47), "plastic_f4efe2", part="slats")
    b.box((-w * 0.47, w * 0.47), (-d * 0.3, d * 0.3), (low - h * 0.05, low + h * 0.02), "plastic_f4efe2", "bottom_rail")
    face = DrawnFace.front(b, d * 0.32)
    for u in (-w * 0.3, w * 0.3):
        face.field((u - w * 0.006, u + w * 0.006), (low - h * 0.04, h * 0.86), "fabric_c9bfa4", "tapes", d * 0.04)
    for cord in (-w * 0.42, -w * 0.45):
        b.rod((cord, d * 0.44, h * 0.2), (cord, d * 0.44, h * 0.88), h * 0.012, "fabric_5a6470", "cords", 5)
        b.taper(
            (cord, d * 0.44, h * 0.24), (cord, d * 0.44, h * 0.09), (h * 0.02, h * 0.05), "paint_b5563f", "pull", 10
        )
