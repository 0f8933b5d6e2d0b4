"""Tables, desks, counters, workbenches."""

from mansion_scene.assets.builder import Builder
from mansion_scene.assets.registry import recipe

__all__: list[str] = []


def _supports(b: Builder, style: str, z: float, frame: str) -> None:
    """Legs below a top at height `z`."""
    w, d = b.w, b.d
    if style == "pedestal":
        b.lathe(
            [(0.42, 0.0), (0.42, 0.02), (0.06, 0.05), (0.05, z * 0.9), (0.12, z)],
            frame,
            stretch=(min(w, d), min(w, d)),
            part="legs",
            n=20,
        )
        b.boxes.pop()
        b.cyl(0, 0, (0.0, 0.03), min(w, d) * 0.42, frame, "legs", n=20)
        b.cyl(0, 0, (0.03, z), 0.05, frame, "legs")
    elif style == "panel":
        for sx in (-1, 1):
            x = sx * (w / 2 - 0.06)
            b.box((x - 0.02, x + 0.02), (-d / 2 + 0.06, d / 2 - 0.06), (0, z), frame, "legs")
        b.box(
            (-w / 2 + 0.08, w / 2 - 0.08),
            (-d / 2 + 0.12, -d / 2 + 0.14),
            (z * 0.35, z),
            frame,
            "modesty",
        )
    elif style in ("tee", "sled", "cee"):
        reach = (-d / 2 + 0.03, d / 2 - 0.03)
        for sx in (-1, 1) if style != "cee" else (-1,):
            x = sx * (w / 2 - 0.08)
            b.box((x - 0.03, x + 0.03), reach, (0, 0.03), frame, "legs")
            b.box((x - 0.03, x + 0.03), reach, (z - 0.03, z), frame, "legs")
            posts = (reach[0] + 0.03, reach[1] - 0.03) if style == "sled" else (0.0,)
            for y in posts:
                b.box((x - 0.03, x + 0.03), (y - 0.03, y + 0.03), (0.02, z - 0.02), frame, "legs")
        if style == "cee":
            b.box((-w / 2 + 0.05, w / 2 - 0.05), (-0.04, 0.04), (0, 0.05), frame, "legs")
    elif style == "trestle":
        for sx in (-1, 1):
            x = sx * (w / 2 - 0.2)
            for sy in (-1, 1):
                b.rod(
                    (x - 0.08, sy * (d / 2 - 0.05), 0),
                    (x, sy * d * 0.28, z),
                    0.022,
                    frame,
                    "legs",
                    solid=True,
                )
                b.rod(
                    (x + 0.08, sy * (d / 2 - 0.05), 0), (x, sy * d * 0.28, z), 0.022, frame, "legs"
                )
            b.box((x - 0.03, x + 0.03), (-d * 0.3, d * 0.3), (z - 0.06, z), frame, "legs", False)
    elif style == "cloth":
        b.lathe([(0.5, 0.0), (0.47, z)], b.mat(), stretch=(w, d), part="cloth", n=28)
    else:
        r = min(0.035, w * 0.04)
        b.legs((0, z), r, frame, 0.02)
        b.box(
            (-w / 2 + 0.05, w / 2 - 0.05),
            (-d / 2 + 0.05, -d / 2 + 0.07),
            (z - 0.07, z),
            frame,
            "apron",
            False,
        )
        b.box(
            (-w / 2 + 0.05, w / 2 - 0.05),
            (d / 2 - 0.07, d / 2 - 0.05),
            (z - 0.07, z),
            frame,
            "apron",
            False,
        )
        for sx in (-1, 1):
            x = sx * (w / 2 - 0.06)
            b.box(
                (x - 0.01, x + 0.01),
                (-d / 2 + 0.05, d / 2 - 0.05),
                (z - 0.07, z),
                frame,
                "apron",
                False,
            )


def _top(b: Builder, z: float, thick: float, round_: bool) -> None:
    w, d = b.w, b.d
    if round_:
        b.lathe(
            [(0.485, z - thick), (0.5, z - thick * 0.5), (0.5, z)],
            b.mat(),
            stretch=(w, d),
            part="top",
            n=32,
        )
    else:
        b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - thick, z), b.mat(), "top")


@recipe("table")
def table(b: Builder) -> None:
    """Rectangular or round top on legs, a pedestal, panels or frames."""
    h = b.h
    thick = min(0.04, h * 0.1)
    _top(b, h, thick, b.p.get("shape") == "round")
    style = str(b.p.get("legs", "four"))
    frame = b.mat("frame", b.mat() if style != "cloth" else "metal_grey")
    _supports(b, style, h - thick, frame)
    if b.p.get("shelf") or (h < 0.6 and style == "four" and b.w * 1000 % 2 < 1):
        z = h * 0.3
        b.box(
            (-b.w / 2 + 0.04, b.w / 2 - 0.04),
            (-b.d / 2 + 0.04, b.d / 2 - 0.04),
            (z - 0.02, z),
            frame,
            "shelf",
        )


@recipe("desk")
def desk(b: Builder) -> None:
    """Top on legs or panels, drawers under the right side, a hutch on high ones."""
    w, d = b.w, b.d
    z = b.tops[0].z
    style = str(b.p.get("legs", "panel"))
    _top(b, z, 0.03, False)
    _supports(b, style, z - 0.03, b.mat("frame", b.mat()))
    if style == "panel" and (b.p.get("drawers") or w > 1.0) and d > 0.3:
        width = min(0.42, w * 0.32)
        sides = (-1, 1) if int(b.p.get("drawers", 1)) > 1 else (1,)
        for sx in sides:
            lo, hi = sorted((sx * (w / 2 - 0.08), sx * (w / 2 - 0.08 - width)))
            b.box((lo, hi), (-d / 2 + 0.1, d / 2 - 0.1), (0.1, z - 0.03), b.mat(), "drawers")
            for k in range(3):
                z0 = 0.12 + k * (z - 0.17) / 3
                b.box(
                    (lo + 0.01, hi - 0.01),
                    (d / 2 - 0.1, d / 2 - 0.085),
                    (z0, z0 + (z - 0.17) / 3 - 0.012),
                    b.mat(),
                    "fronts",
                    False,
                )
                b.box(
                    ((lo + hi) / 2 - 0.06, (lo + hi) / 2 + 0.06),
                    (d / 2 - 0.085, d / 2 - 0.07),
                    (z0 + 0.1, z0 + 0.115),
                    "metal_steel",
                    "handles",
                    False,
                )
    if b.h > z + 0.02:
        shelf = b.tops[1]
        for x in (-w / 2 + 0.012, w / 2 - 0.012):
            b.box((x - 0.012, x + 0.012), (-d / 2, shelf.y1 + 0.02), (z, b.h), b.mat(), "hutch")
        b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.012), (z, b.h), b.mat(), "hutch")
        for level in (b.h, z + (b.h - z) * 0.55):
            b.box(
                (-w / 2, w / 2), (-d / 2, shelf.y1 + 0.02), (level - 0.022, level), b.mat(), "hutch"
            )


@recipe("counter")
def counter(b: Builder) -> None:
    """Closed front with a worktop; reception desks with a raised ledge towards the visitor."""
    w, d, h = b.w, b.d, b.h
    main = b.mat()
    style = b.p.get("style")
    if style == "buffet":
        b.box((-w / 2, w / 2), (-d / 2 + 0.05, d / 2 - 0.2), (0.08, 0.88), main, "body")
        b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.15), (0.88, 0.92), "metal_steel", "top")
        for z in (0.84, 0.88):
            b.rod(
                (-w / 2, d / 2 - 0.03 - (z - 0.84), z),
                (w / 2, d / 2 - 0.03 - (z - 0.84), z),
                0.012,
                "metal_steel",
                "rail",
            )
        b.rod(
            (-w / 2, d / 2 - 0.012, 0.86),
            (w / 2, d / 2 - 0.012, 0.86),
            0.012,
            "metal_steel",
            "rail",
        )
        count = max(2, round(w / 0.6))
        for k in range(count):
            x = -w / 2 + (k + 0.5) * w / count
            b.box(
                (x - 0.22, x + 0.22),
                (-d / 2 + 0.1, d / 2 - 0.28),
                (0.92, 0.935),
                ("food_brown", "food_green", "food_orange")[k % 3],
                "food",
                False,
            )
        for x in (-w / 2 + 0.05, w / 2 - 0.05):
            b.box((x - 0.02, x + 0.02), (-0.12, -0.08), (0.92, h), "metal_steel", "posts", False)
        b.prism(
            [(-0.2, h), (-0.2, h - 0.02), (d / 2 - 0.18, h - 0.18), (d / 2 - 0.18, h - 0.16)],
            (-w / 2, w / 2),
            "glass_clear",
            part="guard",
            solid=False,
        )
        return
    tops = b.tops
    work = tops[0].z if tops else h
    base = 0.06
    b.box(
        (-w / 2 + 0.03, w / 2 - 0.03),
        (-d / 2 + (0.3 if len(tops) > 1 else 0.05), d / 2 - 0.04),
        (0, work - 0.04),
        main,
        "body",
    )
    b.box(
        (-w / 2 + 0.05, w / 2 - 0.05),
        (d / 2 - 0.05, d / 2 - 0.03),
        (0, base),
        "metal_dark",
        "plinth",
        False,
    )
    if len(tops) > 1:
        for x in (-w / 2 + 0.02, w / 2 - 0.02):
            b.box((x - 0.02, x + 0.02), (-d / 2, d / 2 - 0.03), (0, h - 0.04), main, "sides")
        b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.27), (work - 0.03, work), "wood_white", "top")
        b.box((-w / 2, w / 2), (d / 2 - 0.07, d / 2 - 0.03), (0, h - 0.04), main, "front")
        b.box(
            (-w / 2, w / 2),
            (d / 2 - 0.3, d / 2),
            (h - 0.04, h),
            b.mat("top", "stone_white"),
            "ledge",
        )
        b.box(
            (-w / 2 + 0.02, w / 2 - 0.02),
            (d / 2 - 0.03, d / 2 - 0.02),
            (h * 0.45, h * 0.5),
            "light_white",
            "strip",
            False,
        )
    else:
        b.box(
            (-w / 2, w / 2),
            (-d / 2, d / 2),
            (h - 0.045, h),
            b.mat("top", "stone_grey" if style != "altar" else "stone_white"),
            "top",
        )
        count = max(2, round(w / 0.6))
        for k in range(count):
            x0 = -w / 2 + 0.05 + k * (w - 0.1) / count
            b.box(
                (x0 + 0.02, x0 + (w - 0.1) / count - 0.02),
                (d / 2 - 0.04, d / 2 - 0.025),
                (0.12, h - 0.12),
                main,
                "panels",
                False,
            )


@recipe("counter_bench")
def lab_bench(b: Builder) -> None:
    """Laboratory bench: cabinets, resistant top, service rail."""
    w, d, h = b.w, b.d, b.h
    b.box(
        (-w / 2, w / 2),
        (-d / 2, d / 2),
        (h - 0.03, h),
        "stone_black" if b.mat() == "plastic_white" else "plastic_light",
        "top",
    )
    count = max(2, round(w / 0.6))
    for k in range(count):
        x0 = -w / 2 + 0.03 + k * (w - 0.06) / count
        x1 = x0 + (w - 0.06) / count
        if k == count // 2:
            continue
        b.box((x0, x1 - 0.01), (-d / 2 + 0.05, d / 2 - 0.06), (0.08, h - 0.03), b.mat(), "cabinets")
        for z0, z1 in ((0.1, h * 0.6), (h * 0.62, h - 0.05)):
            b.box(
                (x0 + 0.01, x1 - 0.02),
                (d / 2 - 0.06, d / 2 - 0.045),
                (z0, z1),
                b.mat(),
                "fronts",
                False,
            )
            b.box(
                ((x0 + x1) / 2 - 0.06, (x0 + x1) / 2 + 0.06),
                (d / 2 - 0.045, d / 2 - 0.03),
                (z1 - 0.05, z1 - 0.035),
                "metal_steel",
                "handles",
                False,
            )
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.02)
        b.box(
            (x - 0.02, x + 0.02),
            (-d / 2 + 0.02, d / 2 - 0.05),
            (0, h - 0.03),
            "metal_grey",
            "frame",
        )


@recipe("workbench")
def workbench(b: Builder) -> None:
    """Thick top, stout legs, lower shelf, vise at the front."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, d / 2 - 0.06), (h - 0.07, h), b.mat(), "top")
    for sx in (-1, 1):
        for sy in (-1, 1):
            x, y = sx * (w / 2 - 0.1), sy * (d / 2 - 0.12)
            b.box(
                (x - 0.045, x + 0.045), (y - 0.045, y + 0.045), (0, h - 0.07), "metal_blue", "legs"
            )
    b.box(
        (-w / 2 + 0.06, w / 2 - 0.06), (-d / 2 + 0.08, d / 2 - 0.14), (0.16, 0.19), b.mat(), "shelf"
    )
    b.box(
        (-w / 2 + 0.1, -w / 2 + 0.3),
        (d / 2 - 0.06, d / 2),
        (h - 0.16, h - 0.02),
        "metal_dark",
        "vise",
    )
    b.rod(
        (-w / 2 + 0.1, d / 2 - 0.01, h - 0.1),
        (-w / 2 + 0.3, d / 2 - 0.01, h - 0.1),
        0.01,
        "metal_steel",
        "vise",
    )
    for k, color in enumerate(("plastic_red", "plastic_blue", "metal_grey")):
        x = -w / 2 + 0.35 + k * 0.3
        if x + 0.12 < w / 2:
            b.box((x, x + 0.24), (-d / 2 + 0.12, 0.1), (0.19, 0.36), color, "boxes", False)


@recipe("checkout")
def checkout(b: Builder) -> None:
    """Cashier's desk: belt, scanner, bagging end."""
    w, d, h = b.w, b.d, b.h
    z = h
    b.box((-w / 2, w / 2), (-d / 2 + 0.35, d / 2), (0.05, z - 0.05), b.mat(), "body")
    b.box((-w / 2, w / 2), (-d / 2 + 0.33, d / 2), (z - 0.06, z), "metal_steel", "top")
    b.box(
        (-w / 2 + 0.05, 0.2),
        (-d / 2 + 0.45, d / 2 - 0.08),
        (z - 0.004, z),
        "rubber_black",
        "belt",
        False,
    )
    b.box((-0.45, 0.45), (-d / 2, -d / 2 + 0.36), (0.05, z * 0.72), b.mat(), "cash")
    b.box((-w / 2, w / 2), (-d / 2 + 0.34, d / 2), (0, 0.06), "metal_dark", "plinth")


@recipe("cubicle")
def cubicle(b: Builder) -> None:
    """Desk within three screens."""
    w, d, h = b.w, b.d, b.h
    t = 0.05
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + t), (0, h), b.mat(), "screen")
    for sx in (-1, 1):
        lo, hi = sorted((sx * w / 2, sx * (w / 2 - t)))
        b.box((lo, hi), (-d / 2 + t, d / 2), (0, h), b.mat(), "screen")
    b.box(
        (-w / 2 + t, w / 2 - t),
        (-d / 2 + t, -d / 2 + min(0.75, d * 0.8)),
        (0.71, 0.74),
        "wood_white",
        "top",
    )
    b.box(
        (-w / 2 + t, -w / 2 + t + 0.35),
        (-d / 2 + t, -d / 2 + min(0.6, d * 0.7)),
        (0.05, 0.6),
        "metal_grey",
        "drawers",
    )


@recipe("lectern")
def lectern(b: Builder) -> None:
    """Standing desk for a speaker, its sloped top towards the back."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2 + 0.04, w / 2 - 0.04), (-d / 2 + 0.03, d / 2 - 0.03), (0, 0.05), b.mat(), "foot")
    b.box(
        (-w / 2 + 0.07, w / 2 - 0.07), (-d * 0.15, d / 2 - 0.04), (0.04, h - 0.16), b.mat(), "body"
    )
    b.prism(
        [(-d / 2, h - 0.18), (-d / 2, h - 0.13), (d / 2, h), (d / 2, h - 0.05)],
        (-w / 2, w / 2),
        b.mat(),
        part="top",
    )
    b.box(
        (-0.1, 0.1),
        (d / 2 - 0.045, d / 2 - 0.035),
        (h * 0.5, h * 0.7),
        "metal_steel",
        "plate",
        False,
    )


@recipe("salon_station")
def salon_station(b: Builder) -> None:
    """Mirror with lights above a shelf and drawers."""
    w, d, h = b.w, b.d, b.h
    b.box((-w / 2, w / 2), (-d / 2, -d / 2 + 0.04), (0, h), b.mat(), "panel")
    b.box((-w / 2, w / 2), (-d / 2 + 0.04, d / 2), (0.78, 0.82), b.mat(), "shelf")
    b.box(
        (-w / 2 + 0.03, -w / 2 + 0.4),
        (-d / 2 + 0.04, d / 2 - 0.05),
        (0.35, 0.78),
        b.mat(),
        "drawers",
    )
    b.box(
        (-w / 2 + 0.12, w / 2 - 0.12),
        (-d / 2 + 0.04, -d / 2 + 0.055),
        (0.95, h - 0.1),
        "glass_mirror",
        "mirror",
        False,
    )
    for sx in (-1, 1):
        for k in range(4):
            z = 1.0 + k * (h - 1.2) / 3
            b.ball(
                (sx * (w / 2 - 0.06), -d / 2 + 0.06, z),
                (0.03, 0.03, 0.03),
                "light_warm",
                "bulbs",
                8,
                False,
            )


@recipe("control_desk")
def control_desk(b: Builder) -> None:
    """Operator's console: desk with a row of screens."""
    w, d, h = b.w, b.d, b.h
    z = 0.75
    b.box((-w / 2, w / 2), (-d / 2, d / 2), (z - 0.04, z), b.mat(), "top")
    for sx in (-1, 1):
        x = sx * (w / 2 - 0.04)
        b.box((x - 0.04, x + 0.04), (-d / 2 + 0.02, d / 2 - 0.1), (0, z - 0.04), b.mat(), "legs")
    b.box(
        (-w / 2 + 0.08, w / 2 - 0.08),
        (-d / 2 + 0.05, -d / 2 + 0.1),
        (0.1, z - 0.04),
        b.mat(),
        "back",
    )
    count = max(2, round(w / 0.62))
    for k in range(count):
        x = -w / 2 + (k + 0.5) * w / count
        half = w / count / 2 - 0.02
        b.box(
            (x - half, x + half),
            (-d / 2 + 0.1, -d / 2 + 0.13),
            (z + 0.12, h),
            "plastic_black",
            "screens",
        )
        b.box(
            (x - half + 0.012, x + half - 0.012),
            (-d / 2 + 0.13, -d / 2 + 0.133),
            (z + 0.135, h - 0.015),
            "screen_blue",
            "screens",
            False,
        )
        b.box(
            (x - 0.03, x + 0.03),
            (-d / 2 + 0.09, -d / 2 + 0.12),
            (z, z + 0.14),
            "plastic_black",
            "stands",
            False,
        )
        b.box((x - 0.2, x + 0.2), (0.05, 0.19), (z, z + 0.02), "plastic_dark", "keyboards", False)
