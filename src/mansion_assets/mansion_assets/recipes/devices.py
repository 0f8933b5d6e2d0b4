"""Laboratory devices, consoles and automats."""

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("vending")
def vending(b: Builder) -> None:
    """Machine with a lit window of goods, keypad and hatch."""
    w, d, h = b.w, b.d, b.h
    f = d / 2
    b.box((-w / 2, w / 2), (-d / 2, f - 0.05), (0.05, h), b.mat(), "case")
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2 + 0.03, f - 0.08), (0, 0.05), "metal_dark", "feet")
    b.box((w * 0.18, w / 2), (f - 0.05, f), (0.05, h), b.mat(), "front")
    b.box((-w / 2, -w * 0.44), (f - 0.05, f), (0.05, h), b.mat(), "front")
    for band in ((0.05, h * 0.3), (h * 0.93, h)):
        b.box((-w * 0.44, w * 0.18), (f - 0.05, f), band, b.mat(), "front")
    b.box((-w * 0.44, w * 0.18), (f - 0.049, f - 0.045), (h * 0.3, h * 0.93), "light_white", "window", solid=False)
    for row in range(5):
        for col in range(5):
            x, z = -w * 0.41 + col * w * 0.115, h * 0.32 + row * h * 0.12
            b.box(
                (x, x + w * 0.08),
                (f - 0.045, f - 0.01),
                (z, z + h * 0.08),
                ("paper_red", "paper_yellow", "paper_blue", "paper_green", "paper_orange")[(row * 2 + col) % 5],
                "goods",
                solid=False,
            )
    b.box((-w * 0.36, w * 0.1), (f - 0.002, f), (h * 0.12, h * 0.22), "plastic_black", "hatch", solid=False)
    b.box((w * 0.25, w * 0.42), (f - 0.002, f), (h * 0.6, h * 0.72), "screen_green", "keypad", solid=False)


@recipe("arcade")
def arcade(b: Builder) -> None:
    """Video game cabinet."""
    w, d, h = b.w, b.d, b.h
    side = [
        (-d / 2, 0),
        (d * 0.3, 0),
        (d * 0.3, h * 0.46),
        (d / 2, h * 0.54),
        (d * 0.42, h * 0.6),
        (0.0, h * 0.84),
        (d * 0.2, h * 0.88),
        (d * 0.16, h),
        (-d / 2, h),
    ]
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.03)))
        for k in range(1, len(side) - 1):
            b.prism([side[0], side[k], side[k + 1]], (lo, hi), b.mat(), part="sides", solid=False)
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2, d * 0.28), (0, h * 0.46), "plastic_black", "body")
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (-d / 2, -0.02), (h * 0.46, h), "plastic_black", "body")
    b.prism(
        [(d * 0.1, h * 0.46), (d * 0.48, h * 0.54), (d * 0.42, h * 0.58), (0.0, h * 0.6)],
        (-w / 2 + 0.03, w / 2 - 0.03),
        "plastic_dark",
        part="panel",
    )
    b.prism(
        [(d * 0.16, h * 0.6), (d * 0.18, h * 0.61), (0.02, h * 0.83), (0.0, h * 0.82)],
        (-w * 0.4, w * 0.4),
        "screen_blue",
        part="screen",
        solid=False,
    )
    b.box((-w / 2 + 0.03, w / 2 - 0.03), (0.0, d * 0.17), (h * 0.88, h * 0.99), "light_warm", "marquee", solid=False)
    for k, color in enumerate(("plastic_red", "plastic_yellow", "plastic_blue")):
        b.ball((-w * 0.1 + k * w * 0.14, d * 0.36, h * 0.56), (0.02, 0.02, 0.02), color, "buttons", 8, solid=False)


@recipe("printer_3d")
def printer_3d(b: Builder) -> None:
    """Frame with bed, gantry and a print."""
    w, d, h = b.w, b.d, b.h
    b.legs((0, h), 0.015, b.mat(), 0.0)
    for z in (0.015, h - 0.015):
        b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.03), (z - 0.015, z + 0.015), b.mat(), "frame")
        b.box((-w / 2, w / 2), (d / 2 - 0.03, d / 2), (z - 0.015, z + 0.015), b.mat(), "frame")
    b.box((-w * 0.4, w * 0.4), (-d * 0.4, d * 0.4), (h * 0.1, h * 0.13), "glass_black", "bed")
    b.box((-w / 2, w / 2), (-0.02, 0.02), (h * 0.6, h * 0.65), "metal_steel", "gantry")
    b.box((-0.04, 0.04), (-0.02, 0.06), (h * 0.5, h * 0.68), "plastic_orange", "head", solid=False)
    b.lathe([(0.06, h * 0.13), (0.09, h * 0.3), (0.04, h * 0.42)], "plastic_orange", part="print", n=12, solid=False)


@recipe("fume_hood")
def fume_hood(b: Builder) -> None:
    """Cupboard, work chamber with a sash, duct."""
    w, d, h = b.w, b.d, b.h
    f = d / 2
    b.hollow((-w / 2, w / 2), (-d / 2, f - 0.06), (0.06, 0.84), 0.02, b.mat(), "cupboard")
    for k in range(2):
        x0 = -w / 2 + k * w / 2
        panel = ((x0 + 0.01, x0 + w / 2 - 0.01), (f - 0.059, f - 0.045), (0.1, 0.8))
        with b.door(*panel, "left" if k == 0 else "right"):
            b.box(*panel, b.mat(), "doors", solid=False)
    b.box((-w / 2, w / 2), (-d / 2, f), (0.84, 0.9), "stone_black", "top")
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.06), (0.9, h), b.mat(), "back")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.1)))
        b.box((lo, hi), (-d / 2, f - 0.02), (0.9, h), b.mat(), "sides")
    b.box((-w / 2, w / 2), (-d / 2, f - 0.02), (h - 0.35, h), b.mat(), "head")
    b.box((-w / 2 + 0.1, w / 2 - 0.1), (f - 0.06, f - 0.05), (1.25, h - 0.3), "glass_clear", "sash", solid=False)
    b.box((-w / 2 + 0.1, w / 2 - 0.1), (f - 0.07, f - 0.03), (1.22, 1.26), "metal_steel", "sash", solid=False)
    b.box((-w * 0.3, -w * 0.1), (f - 0.021, f - 0.015), (h - 0.25, h - 0.12), "screen_green", "panel", solid=False)
    for k, color in enumerate(("glass_blue", "glass_green")):
        b.lathe(
            [(0.07, 0.9), (0.07, 0.92), (0.025, 1.03), (0.03, 1.08)],
            color,
            (-0.2 + 0.3 * k, -0.1),
            "flasks",
            12,
            solid=False,
        )


@recipe("mixing_desk")
def mixing_desk(b: Builder) -> None:
    """Sloped console with faders on a stand."""
    w, d, h = b.w, b.d, b.h
    b.prism(
        [(-d / 2, h * 0.72), (d / 2, h * 0.72), (d / 2, h * 0.8), (-d / 2, h)], (-w / 2, w / 2), b.mat(), part="console"
    )
    for sx in (-1, 1):
        x = sx * w * 0.4
        b.box((x - 0.03, x + 0.03), (-d * 0.4, d * 0.4), (0, 0.05), "metal_dark", "feet")
        b.box((x - 0.03, x + 0.03), (-0.05, 0.05), (0.05, h * 0.72), "metal_dark", "legs")
    for k in range(16):
        x = -w * 0.44 + k * w * 0.0587
        y = d * (0.2 + 0.1 * ((k * 3) % 4) / 3)
        z = h * 0.8 + (h * 0.2) * (0.5 - y / d)
        b.box((x - 0.008, x + 0.008), (y - 0.02, y + 0.02), (z, z + 0.02), "plastic_white", "faders", solid=False)
        for j in range(3):
            yy = -d * 0.35 + j * d * 0.14
            zz = h * 0.8 + h * 0.2 * (0.5 - yy / d)
            b.cyl(
                x,
                yy,
                (zz - 0.005, zz + 0.018),
                0.012,
                ("plastic_red", "plastic_blue", "plastic_grey")[j],
                "knobs",
                n=8,
                solid=False,
            )
    b.box((-w * 0.2, w * 0.2), (-d / 2, -d / 2 + 0.02), (h * 0.8, h), "screen_dark", "meters", solid=False)
