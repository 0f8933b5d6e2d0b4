"""What hangs on the walls of a bathroom, and a toothbrush."""

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("towel_bar")
def towel_bar(b: Builder) -> None:
    """Bar on two brackets."""
    w, d, h = b.w, b.d, b.h
    r = min(0.014, h * 0.4, d * 0.2)
    y, z = d / 2 - r, h / 2
    b.rod((-w / 2, y, z), (w / 2, y, z), r, b.mat(), "bar", 10, True)
    for sx in (-1, 1):
        x = sx * (w / 2 - min(0.03, w * 0.1))
        b.rod((x, -d / 2, z), (x, y, z), r, b.mat(), "brackets")
        b.box(
            (x - min(0.02, w * 0.08), x + min(0.02, w * 0.08)),
            (-d / 2, -d / 2 + 0.008),
            (0, h),
            b.mat(),
            "plates",
            False,
        )


@recipe("paper_hanger")
def paper_hanger(b: Builder) -> None:
    """Holder with a roll."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + min(0.01, d * 0.3)), (0, h), b.mat(), "plate")
    r = min(h, d) * 0.42
    b.rod((-w * 0.3, d / 2 - r, h / 2), (w * 0.3, d / 2 - r, h / 2), r, "paper_white", "roll", 16)
    b.rod((-w / 2, d / 2 - r, h / 2), (w / 2, d / 2 - r, h / 2), min(0.006, r * 0.3), b.mat(), "pin")


@recipe("shower_head")
def shower_head(b: Builder) -> None:
    """Riser with hose and head."""
    w, d, h = b.w, b.d, b.h
    b.rod((0, -d / 2 + 0.02, 0), (0, -d / 2 + 0.02, h - 0.03), 0.012, b.mat(), "riser", 10, True)
    b.rod((0, -d / 2 + 0.02, h - 0.05), (0, d / 2 - 0.06, h - 0.02), 0.012, b.mat(), "arm")
    b.cyl(0, d / 2 - w * 0.3, (h - 0.07, h), w * 0.3, b.mat(), "head", n=20)
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.05), (0.0, 0.06), b.mat(), "mixer")


@recipe("faucet")
def faucet(b: Builder) -> None:
    """Spout with two handles."""
    w, d, h = b.w, b.d, b.h
    r = max(0.006, min(0.016, w * 0.1, h * 0.08))
    y = -d / 2 + 2 * r
    b.path([(0, y, 0), (0, y, h - r), (0, d / 2 - r, h - r), (0, d / 2 - r, h * 0.6)], r, b.mat(), "spout")
    b.box((-r * 2, r * 2), (-d / 2, -d / 2 + 4 * r), (0, h * 0.2), b.mat(), "foot")
    for sx in (-1, 1):
        x = sx * (w / 2 - r)
        b.rod((x, y, 0), (x, y, h * 0.4), r, b.mat(), "handles", solid=True)


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
        b.box((-w / 2, -w / 2 + 0.01), (-d / 2, d / 2), (h - 0.06, h), "metal_steel", "end", False)


@recipe("toothbrush")
def toothbrush(b: Builder) -> None:
    """Cup with two brushes."""
    w, h = b.w, b.h
    b.lathe([(0.42, 0), (0.5, h * 0.5), (0.44, h * 0.5), (0.38, 0.01)], b.mat(), stretch=(w, b.d), n=14)
    b.rod((-w * 0.1, 0, 0.01), (-w * 0.3, 0, h), 0.005, "plastic_red", "brush")
    b.rod((w * 0.1, 0, 0.01), (w * 0.3, 0.01, h * 0.97), 0.005, "plastic_blue", "brush")
