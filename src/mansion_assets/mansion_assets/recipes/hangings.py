"""Hooks, bars, boards with tools, and rugs."""

import math

from mansion_assets.builder import Box, Builder
from mansion_assets.recipes.mats import exercise_mat, prayer_rug, welcome_mat
from mansion_assets.registry import Recipe, recipe

__all__: list[str] = []


@recipe("radiator")
def radiator(b: Builder) -> None:
    """Ribbed radiator with a valve."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2 - 0.06), (-d * 0.3, d * 0.3), (0.04, h - 0.04), b.mat(), "core")
    count = round(w / 0.06)
    for k in range(count - 1):
        x = -w / 2 + k * w / count
        b.box((x + 0.008, x + 0.05), (-d / 2, d / 2), (0, h), b.mat(), "ribs", solid=False)
    b.cyl(w / 2 - 0.025, 0, (0.06, 0.14), 0.025, "plastic_white", "valve", solid=False)


@recipe("hooks")
def hooks(b: Builder) -> None:
    """Rail with hooks and a coat."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.02), (h * 0.45, h), b.mat(), "rail")
    for k in range(max(3, round(w / 0.2))):
        x = -w / 2 + (k + 0.5) * w / max(3, round(w / 0.2))
        b.path(
            [(x, -d / 2 + 0.02, h * 0.7), (x, d / 2 - 0.01, h * 0.45), (x, d / 2 - 0.01, h * 0.85)],
            0.008,
            "metal_steel",
            "hooks",
        )
        b.path([(x, -d / 2 + 0.02, h * 0.5), (x, d * 0.1, h * 0.05)], 0.007, "metal_steel", "hooks")


@recipe("extinguisher")
def extinguisher(b: Builder) -> None:
    """Red bottle with valve and hose."""
    w, d, h = b.w, b.d, b.h
    r = min(w, d) * 0.42
    b.lathe([(r * 0.9, 0), (r, 0.02), (r, h * 0.72), (r * 0.4, h * 0.82)], b.mat(), (0, 0), "bottle", 20)
    b.cyl(0, 0, (h * 0.8, h * 0.9), 0.02, "metal_dark", "valve")
    b.box((-0.012, 0.012), (-0.02, d / 2), (h * 0.88, h), "plastic_black", "lever")
    b.path(
        [(0, 0.02, h * 0.86), (w / 2 - 0.012, 0.02, h * 0.7), (w / 2 - 0.012, 0.02, h * 0.2)],
        0.012,
        "rubber_black",
        "hose",
    )
    b.box((-w / 2, w * 0.1), (-d / 2, -r * 0.9), (h * 0.3, h * 0.5), "metal_steel", "bracket")
    b.lathe([(r * 1.004, h * 0.3), (r * 1.004, h * 0.55)], "paper_white", (0, 0), "label", 20, solid=False)


@recipe("hoop")
def hoop(b: Builder) -> None:
    """Backboard with ring and net."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.05), (0.1, h), b.mat(), "board")
    b.box((-w * 0.2, w * 0.2), (-d / 2 + 0.05, -d / 2 + 0.055), (h * 0.3, h * 0.62), "paint_red", "square", solid=False)
    r = min(0.23, d * 0.3)
    y = d / 2 - r
    points = [(r * math.cos(a), y + r * math.sin(a), h * 0.22) for a in [k * math.pi / 8 for k in range(17)]]
    b.path(points, 0.01, "paint_orange", "ring")
    b.box((-0.04, 0.04), (-d / 2 + 0.05, y - r), (h * 0.2, h * 0.24), "paint_orange", "arm")
    for x, yy, z in points[:-1:2]:
        b.rod((x, yy, z), (x * 0.6, y + (yy - y) * 0.6, 0.0), 0.004, "fabric_white", "net", 5)


@recipe("wall_bars")
def wall_bars(b: Builder) -> None:
    """Rungs between two posts."""
    w, d, h = b.w, b.d, b.h
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - 0.04)))
        b.box((lo, hi), (-d / 2, d / 2), (0, h), b.mat(), "posts")
    for k in range(13):
        z = 0.15 + k * (h - 0.25) / 12
        b.rod((-w / 2 + 0.02, d * 0.2, z), (w / 2 - 0.02, d * 0.2, z), 0.018, b.mat(), "rungs")


@recipe("tool_board")
def tool_board(b: Builder) -> None:
    """Board with hanging tools."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.02), (0, h), b.mat(), "board")
    for k in range(9):
        x, z = -w * 0.42 + (k % 5) * w * 0.21, h * (0.55 if k < 5 else 0.12)
        b.rod(
            (x, -d / 2 + 0.035, z),
            (x, -d / 2 + 0.035, z + h * 0.2),
            0.012,
            ("wood_oak", "plastic_red", "plastic_blue")[k % 3],
            "tools",
        )
        b.box(
            (x - 0.05, x + 0.05) if k % 2 else (x - 0.02, x + 0.02),
            (-d / 2 + 0.02, d / 2),
            (z + h * 0.2, z + h * 0.28),
            "metal_steel",
            "tools",
            solid=False,
        )


@recipe("rug")
def rug(b: Builder) -> None:
    """Rug with a border, round or rectangular; mats of tiles, or with a picture or a word on them."""
    drawn = _DRAWN.get(str(b.p.get("style", "")))
    if drawn is not None:
        drawn(b)
        return
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    other = "fabric_light" if main != "fabric_white" else "fabric_grey"
    if b.p.get("shape") == "round":
        b.lathe([(0.5, 0), (0.5, h * 0.8)], main, stretch=(w, d), n=36)
        b.lathe([(0.42, h * 0.7), (0.42, h * 0.9)], other, stretch=(w, d), part="border", n=36, solid=False)
        b.lathe([(0.38, h * 0.7), (0.38, h)], main, stretch=(w, d), part="field", n=36, solid=False)
    elif b.p.get("style") == "tiles":
        cols, rows = max(2, round(w / 0.5)), max(2, round(d / 0.5))
        for i in range(cols):
            for j in range(rows):
                x, y = -w / 2 + i * w / cols, -d / 2 + j * d / rows
                color = (
                    main
                    if main.startswith("rubber") and (i + j) % 2
                    else ("fabric_yellow", "fabric_red", main)[(i + 2 * j) % 3]
                    if not main.startswith("rubber")
                    else "rubber_red"
                )
                b.box((x, x + w / cols), (y, y + d / rows), (0, h), color, "tiles", solid=False)
        b.boxes.append(Box((0.0, 0.0, h / 2), (w, d, h)))
    else:
        e = min(w, d) * 0.07
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (0, h * 0.8), main, "base")
        b.box((-w / 2 + e, w / 2 - e), (-d / 2 + e, d / 2 - e), (h * 0.7, h * 0.9), other, "border", solid=False)
        b.box(
            (-w / 2 + 1.6 * e, w / 2 - 1.6 * e),
            (-d / 2 + 1.6 * e, d / 2 - 1.6 * e),
            (h * 0.7, h),
            main,
            "field",
            solid=False,
        )


_DRAWN: dict[str, Recipe] = {"exercise": exercise_mat, "prayer": prayer_rug, "welcome": welcome_mat}
"""Styles of rugs with something drawn on them."""
