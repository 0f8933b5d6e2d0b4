"""Kiosks, charging stations and tills."""

from mansion_assets.builder import Builder
from mansion_assets.registry import recipe

__all__: list[str] = []


@recipe("kiosk")
def kiosk(b: Builder) -> None:
    """Terminal with a tilted screen on a column, or a closed machine."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, 0.04), "metal_dark", "foot")
    if b.p.get("style") == "block":
        b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.1), (0.04, h), b.mat(), "case")
        b.box((-w / 2, w / 2), (d / 2 - 0.1, d / 2), (0.04, 0.85), b.mat(), "case")
        b.box(
            (-w * 0.35, w * 0.35),
            (d / 2 - 0.1, d / 2 - 0.095),
            (1.0, min(1.4, h - 0.12)),
            "screen_blue",
            "screen",
            False,
        )
        b.box((-w * 0.2, w * 0.2), (d / 2 - 0.06, d / 2 - 0.02), (0.85, 0.87), "plastic_dark", "keys", False)
        b.box((-w * 0.4, w * 0.4), (d / 2 - 0.1, d / 2 - 0.09), (h - 0.1, h - 0.02), "light_white", "sign", False)
        return
    b.box((-w * 0.18, w * 0.18), (-d * 0.3, d * 0.1), (0.04, h * 0.62), b.mat(), "column")
    b.prism(
        [(-d * 0.2, h * 0.58), (d / 2, h * 0.6), (d / 2 - 0.05, h * 0.63), (-d * 0.42, h), (-d / 2, h)],
        (-w / 2, w / 2),
        b.mat(),
        part="head",
    )
    b.prism(
        [(d / 2 - 0.055, h * 0.645), (d / 2 - 0.05, h * 0.65), (-d * 0.38, h * 0.98), (-d * 0.4, h * 0.975)],
        (-w * 0.44, w * 0.44),
        "screen_blue",
        part="screen",
        solid=False,
    )


@recipe("dock")
def dock(b: Builder) -> None:
    """Charging station: back panel, ramp, contacts, a light."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.1), (0, h), b.mat(), "panel")
    b.prism(
        [(-d / 2, 0), (d / 2, 0), (d / 2, 0.006), (-d / 2 + 0.1, 0.03)], (-w / 2, w / 2), "plastic_dark", part="ramp"
    )
    for sx in (-1, 1):
        b.box(
            (sx * 0.06 - 0.015, sx * 0.06 + 0.015),
            (-d / 2 + 0.1, -d / 2 + 0.112),
            (0.08, 0.13),
            "metal_brass",
            "contacts",
            False,
        )
    b.box((-w * 0.2, w * 0.2), (-d / 2 + 0.1, -d / 2 + 0.103), (h * 0.8, h * 0.84), "light_green", "light", False)


@recipe("register")
def register(b: Builder) -> None:
    """Till: drawer, sloped keyboard, display."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.3), b.mat(), "drawer")
    b.prism(
        [(-d / 2, h * 0.3), (d * 0.4, h * 0.3), (d * 0.4, h * 0.38), (-d * 0.1, h * 0.6), (-d / 2, h * 0.6)],
        (-w * 0.46, w * 0.46),
        "plastic_dark",
        part="body",
    )
    b.box((-w * 0.35, w * 0.35), (-d * 0.4, -d * 0.3), (h * 0.6, h), "plastic_black", "display")
    b.box((-w * 0.32, w * 0.32), (-d * 0.3, -d * 0.29), (h * 0.68, h * 0.96), "screen_green", "display", False)
