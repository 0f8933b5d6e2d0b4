"""Curtains of rooms, baths and hospital beds, and blinds."""

from mansion_assets.builder import Builder
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
    """Tilted slats below a head box, on ladders of cord, with a wand and a pull cord."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (h * 0.84, h), "plastic_light", "box")
    count = 7
    for k in range(count):
        z = h * 0.78 * (k + 0.3) / count
        slat = [(-d * 0.4, z + h * 0.1), (-d * 0.34, z + h * 0.112), (d * 0.44, z + h * 0.012), (d * 0.38, z)]
        b.prism(slat, (-w * 0.48, w * 0.48), b.mat(), part="slats")
    for x in (-w * 0.36, 0.0, w * 0.36):
        b.rod((x, d * 0.42, 0), (x, d * 0.42, h * 0.86), 0.003, "fabric_grey", "cords", 5)
    b.rod((-w * 0.43, d * 0.46, h * 0.0), (-w * 0.43, d * 0.46, h * 0.88), 0.005, "plastic_grey", "wand", 6)
    b.ball((w * 0.44, d * 0.46, h * 0.08), (0.009, 0.009, h * 0.07), "plastic_grey", "pull", 8)
    b.rod((w * 0.44, d * 0.46, h * 0.12), (w * 0.44, d * 0.46, h * 0.86), 0.003, "fabric_grey", "pull", 5)
