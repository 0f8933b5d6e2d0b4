"""What stands in gardens and is used there."""

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("mower")
def mower(b: Builder) -> None:
    """Lawn mower with grass box and handle."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2 + 0.04, w / 2 - 0.04), (0.0, d / 2), (0.06, 0.3), b.mat(), "deck", 0.5)
    b.cyl(0, d * 0.25, (0.28, 0.45), 0.14, "plastic_black", "motor")
    b.cushion((-w * 0.4, w * 0.4), (-d * 0.36, 0.0), (0.08, 0.45), "fabric_dark", "box", 0.4)
    for sx in (-1, 1):
        b.path([(sx * w * 0.4, 0.0, 0.25), (sx * w * 0.4, -d / 2 + 0.02, h - 0.02)], 0.015, "metal_steel", "handle")
        for y in (0.12, d * 0.42):
            b.rod((sx * (w / 2 - 0.05), y, 0.1), (sx * w / 2, y, 0.1), 0.1, "rubber_black", "wheels", 16)
    b.rod((-w * 0.4, -d / 2 + 0.02, h - 0.02), (w * 0.4, -d / 2 + 0.02, h - 0.02), 0.016, "rubber_black", "handle")


@recipe("grill")
def grill(b: Builder) -> None:
    """Gas barbecue with side tables."""
    w, d, h = b.w, b.d, b.h
    bw = w * 0.5
    b.box((-bw / 2, bw / 2), (-d / 2, d / 2 - 0.04), (0.1, h * 0.62), b.mat(), "cabinet")
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.04), (h * 0.74, h * 0.77), "metal_steel", "tables")
    b.box((-bw / 2, bw / 2), (-d / 2, d / 2 - 0.02), (h * 0.62, h * 0.76), "metal_steel", "panel")
    b.cushion((-bw / 2, bw / 2), (-d / 2, d / 2 - 0.05), (h * 0.74, h), b.mat(), "lid", 0.6, 14)
    b.rod((-bw * 0.35, d / 2 - 0.02, h * 0.86), (bw * 0.35, d / 2 - 0.02, h * 0.86), 0.015, "metal_steel", "handle")
    for k in range(4):
        b.rod(
            (-bw * 0.35 + k * bw * 0.23, d / 2 - 0.03, h * 0.69),
            (-bw * 0.35 + k * bw * 0.23, d / 2, h * 0.69),
            0.025,
            "plastic_black",
            "knobs",
            12,
        )
    b.legs((0, 0.12), 0.03, "plastic_black", w * 0.25)


@recipe("sprinkling_can")
def sprinkling_can(b: Builder) -> None:
    """A can with a wide top, a long spout that rises to a pierced rose."""
    w, d, h = b.w, b.d, b.h
    y, r = -d * 0.16, min(w / 2, d * 0.28)
    high = h * 0.66
    b.lathe([(r, 0), (r * 0.92, high), (r * 0.84, high), (r * 0.84, high * 0.8)], b.mat(), (0, y), "can", 22)
    b.lathe([(r * 0.86, high * 0.8), (r * 0.86, high * 0.82)], "glass_blue", (0, y), "water", 22)
    for z in (0.0, high * 0.5, high * 0.95):
        b.lathe([(r * 1.03, z), (r * 1.03, z + h * 0.03)], b.mat(), (0, y), "bands", 22)
    b.rod((0, y + r * 0.8, h * 0.14), (0, d * 0.4, h * 0.82), w * 0.075, b.mat(), "spout", 12, solid=True)
    b.rod((0, y + r * 0.9, high * 0.86), (0, d * 0.26, h * 0.62), w * 0.025, b.mat(), "stay", 8)
    b.rod((0, d * 0.38, h * 0.79), (0, d * 0.45, h * 0.91), w * 0.09, b.mat(), "rose", 14)
    b.rod((0, d * 0.44, h * 0.9), (0, d * 0.47, h * 0.95), w * 0.2, "metal_brass", "rose", 18)
    bow = [
        (0, y - r * 0.9, high * 0.3),
        (0, y - r * 1.5, high * 0.7),
        (0, y - r * 1.1, h * 0.97),
        (0, y, h * 0.97),
        (0, y + r * 0.7, high),
    ]
    b.path(bow, w * 0.05, b.mat(), "handle")


@recipe("parasol")
def parasol(b: Builder) -> None:
    """Sunshade on a pole."""
    w, d, h = b.w, b.d, b.h
    b.cyl(0, 0, (0, 0.08), 0.28, "stone_grey", "foot", n=24)
    b.cyl(0, 0, (0.05, h - 0.02), 0.022, "wood_oak", "pole")
    b.lathe(
        [(0.5, h * 0.78), (0.02, h), (0.01, h), (0.48, h * 0.78)],
        b.mat(),
        stretch=(w, d),
        part="cover",
        n=8,
        solid=False,
    )
