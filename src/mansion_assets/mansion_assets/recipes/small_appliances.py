"""Small appliances for kitchen and house."""

from mansion_assets.builder import Builder
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
    b.box((-w * 0.4, w * 0.4), (-d * 0.05, d * 0.45), (h * 0.14, h * 0.15), "metal_steel", "grid", False)
    b.box((-w * 0.3, w * 0.3), (-d * 0.45, 0), (h * 0.95, h), "glass_amber", "hopper", False)
    b.box((-w * 0.25, w * 0.25), (d * 0.3, d * 0.31), (h * 0.76, h * 0.88), "screen_blue", "panel", False)


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
            False,
        )
    b.box((-w * 0.1, w * 0.1), (d / 2 - 0.04, d / 2), (h * 0.55, h * 0.65), "plastic_black", "lever", False)


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
    b.ball((0, 0, h * 0.94), (r * 0.14, r * 0.14, h * 0.06), "plastic_black", "knob", 8, False)
    b.rod((0, r * 0.7, h * 0.4), (0, d / 2 - 0.01, h * 0.75), min(w, d) * 0.08, b.mat(), "spout")
    b.path(
        [(0, -r * 0.7, h * 0.25), (0, -d / 2 + 0.012, h * 0.35), (0, -d / 2 + 0.012, h * 0.7), (0, -r * 0.5, h * 0.8)],
        0.012,
        "plastic_black",
        "handle",
    )


@recipe("vacuum")
def vacuum(b: Builder) -> None:
    """Upright cleaner."""
    w, d, h = b.w, b.d, b.h
    b.cushion((-w / 2, w / 2), (0, d / 2), (0, 0.12), "plastic_dark", "head", 0.5)
    b.rod((0, 0.05, 0.1), (0, -d / 2 + 0.1, h * 0.6), min(w, d) * 0.28, b.mat(), "body", 16, True)
    b.rod((0, -d / 2 + 0.12, h * 0.55), (0, -d / 2 + 0.02, h - 0.02), 0.018, "metal_steel", "handle")
    b.cushion((-0.05, 0.05), (-d / 2, -d / 2 + 0.08), (h - 0.1, h), "plastic_black", "grip")


@recipe("ironing_board")
def ironing_board(b: Builder) -> None:
    """Board on crossed legs."""
    w, d, h = b.w, b.d, b.h
    b.prism(
        [(-w / 2, -d / 2), (w * 0.3, -d / 2), (w / 2, -d * 0.12), (w / 2, d * 0.12), (w * 0.3, d / 2), (-w / 2, d / 2)],
        (h - 0.04, h),
        b.mat(),
        "z",
        "board",
    )
    for sy in (-1, 1):
        y = sy * (d / 2 - 0.05)
        b.rod((-w * 0.35, y, 0), (w * 0.25, y * 0.5, h - 0.04), 0.013, "metal_white", "legs")
        b.rod((w * 0.35, y, 0), (-w * 0.25, y * 0.5, h - 0.04), 0.013, "metal_white", "legs")


@recipe("dispenser")
def dispenser(b: Builder) -> None:
    """Water cooler with a bottle on top."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.03), (0, h * 0.72), b.mat(), "case")
    b.box((-w * 0.35, w * 0.35), (d / 2 - 0.035, d / 2 - 0.028), (h * 0.42, h * 0.64), "plastic_dark", "niche", False)
    for x, color in ((-0.05, "plastic_red"), (0.05, "plastic_blue")):
        b.box((x - 0.012, x + 0.012), (d / 2 - 0.03, d / 2), (h * 0.56, h * 0.6), color, "taps", False)
    b.box((-w * 0.35, w * 0.35), (d / 2 - 0.03, d / 2), (h * 0.4, h * 0.42), "metal_steel", "tray", False)
    r = min(w, d) * 0.42
    b.lathe([(r * 0.4, h * 0.72), (r, h * 0.77), (r, h * 0.97), (r * 0.85, h)], "glass_blue", (0, -0.01), "bottle")
