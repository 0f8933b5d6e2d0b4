"""Furniture outlines with their fronts, as an architect draws them."""

from collections.abc import Callable, Mapping
from functools import cache

from mansion_export.plan.palette import INK
from mansion_export.plan.shapes import Area, Canvas, Frame, Line, Shape, circle, rectangle
from mansion_msgs_py.scene import FloorScene, SceneObject

__all__ = ["draw_furniture"]

Symbol = Callable[[Frame, float, float], list[Shape]]
"""Details of a symbol from its frame, half width and half depth."""

SMALL = 0.12
"""Objects on surfaces that are smaller than this in both directions are left out."""


def draw_furniture(scene: FloorScene) -> list[Canvas]:
    """Draw what stands on floors and hangs on walls; rugs first, then what can be seen on top of furniture."""
    order = {"floor": 1, "wall": 2, "surface": 3}
    tops = {item.id: item.top for item in scene.objects}
    drawn = [
        item
        for item in scene.objects
        if item.mount in order and not (item.mount == "surface" and _is_hidden(item, tops))
    ]
    drawn.sort(key=lambda item: 0 if _is_flat(item) else order[item.mount])
    return [_object(item) for item in drawn]


def _is_hidden(item: SceneObject, tops: Mapping[str, float]) -> bool:
    """Tell whether an object is tiny, or stands on a lower shelf."""
    if max(item.size[:2]) < SMALL:
        return True
    bottom = item.bottom
    return item.parent is not None and bottom < tops.get(item.parent, bottom) - 0.3


def _is_flat(item: SceneObject) -> bool:
    return item.mount == "floor" and item.size[2] <= 0.05


def _object(item: SceneObject) -> Canvas:
    frame = Frame(item.position[0], item.position[1], item.rotation)
    a, b = item.size[0] / 2, item.size[1] / 2
    title = item.id if item.name in ("", item.category) else f"{item.id}: {item.name}"
    if _is_flat(item):
        shapes: list[Shape] = [Area(frame.place(rectangle(-a, -b, a, b)), INK["rug"], INK["furniture_detail"], 0.012)]
        return Canvas("furniture", tuple(shapes), item.id, title)
    if item.mount == "surface":
        body = Area(frame.place(rectangle(-a, -b, a, b)), "#eef0f2", INK["furniture_detail"], 0.008)
        return Canvas("furniture", (body,), item.id, title)
    symbol = _symbol(item.category)
    round_body = symbol in (_round, _plant)
    outline = circle((0.0, 0.0), a, b) if round_body else rectangle(-a, -b, a, b)
    fill = INK["green_fill"] if symbol is _plant else INK["furniture"]
    line = INK["green"] if symbol is _plant else INK["furniture_line"]
    shapes = [Area(frame.place(outline), fill, line, 0.015), *symbol(frame, a, b)]
    return Canvas("furniture", tuple(shapes), item.id, title)


def _detail(frame: Frame, points: list[tuple[float, float]], width: float = 0.012) -> Line:
    return Line(frame.place(points), INK["furniture_detail"], width)


def _plain(frame: Frame, a: float, b: float) -> list[Shape]:
    """A line along the front edge."""
    inset = min(0.06, b * 0.35)
    return [_detail(frame, [(-a, b - inset), (a, b - inset)])]


def _bed(frame: Frame, a: float, b: float) -> list[Shape]:
    count = 2 if a > 0.6 else 1
    width = 2 * a / count
    pillows: list[Shape] = []
    for i in range(count):
        x = -a + i * width
        corners = rectangle(x + 0.1 * width, -b + 0.08, x + 0.9 * width, -b + 0.42)
        pillows.append(Area(frame.place(corners), "#ffffff", INK["furniture_detail"], 0.012))
    return [*pillows, _detail(frame, [(-a, -b + 0.6), (a, -b + 0.6)])]


def _seat(frame: Frame, a: float, b: float) -> list[Shape]:
    """A back rest, and arms where it is wide enough."""
    back = min(0.18, b * 0.5)
    shapes: list[Shape] = [Area(frame.place(rectangle(-a, -b, a, -b + back)), "#e3e6ea", INK["furniture_line"], 0.012)]
    if a > 0.34:
        arm = min(0.14, a * 0.25)
        for x0, x1 in ((-a, -a + arm), (a - arm, a)):
            shapes.append(_detail(frame, rectangle(x0, -b + back, x1, b)))
        seats = max(1, round(2 * a / 0.75))
        step = (2 * a - 2 * arm) / seats
        shapes += [
            _detail(frame, [(-a + arm + i * step, -b + back), (-a + arm + i * step, b)]) for i in range(1, seats)
        ]
    return shapes


def _table(frame: Frame, a: float, b: float) -> list[Shape]:
    return []


def _shelf(frame: Frame, a: float, b: float) -> list[Shape]:
    return [_detail(frame, [(-a, -b), (a, b)]), *_plain(frame, a, b)]


def _basin(frame: Frame, a: float, b: float) -> list[Shape]:
    bowl = circle((0.0, 0.1 * b), a * 0.72, b * 0.66)
    return [
        Area(frame.place(bowl), "#e7f1f6", INK["furniture_line"], 0.012),
        _detail(frame, [(0.0, -b), (0.0, -0.35 * b)], 0.025),
    ]


def _toilet(frame: Frame, a: float, b: float) -> list[Shape]:
    tank = -b + min(0.2, 0.6 * b)
    return [
        Area(frame.place(rectangle(-a, -b, a, tank)), "#ffffff", INK["furniture_line"], 0.012),
        Area(
            frame.place(circle((0.0, (tank + b) / 2), a * 0.78, (b - tank) / 2)),
            "#e7f1f6",
            INK["furniture_line"],
            0.012,
        ),
    ]


def _stall(frame: Frame, a: float, b: float) -> list[Shape]:
    """A cubicle: partitions, a door in the front that stands ajar, a toilet at the back."""
    bowl_width, bowl_depth = min(0.2, 0.4 * a), min(0.34, 0.5 * b)
    bowl = Frame(*frame.place([(0.0, -b + bowl_depth)])[0], frame.rotation)
    leaf = min(1.1 * a, 1.2 * b)
    hinge = (-leaf / 2, b)
    return [
        *_toilet(bowl, bowl_width, bowl_depth),
        Line(frame.place([(-a, b), (-a, -b), (a, -b), (a, b)]), INK["furniture_line"], 0.035),
        Line(frame.place([(-a, b), hinge]), INK["furniture_line"], 0.035),
        Line(frame.place([(leaf / 2, b), (a, b)]), INK["furniture_line"], 0.035),
        _detail(frame, [hinge, (hinge[0] + 0.82 * leaf, b - 0.57 * leaf)], 0.02),
    ]


def _car(frame: Frame, a: float, b: float) -> list[Shape]:
    """Bonnet, windscreens and roof, the front ahead."""
    cabin = [(-0.78 * a, 0.3 * b), (0.78 * a, 0.3 * b), (0.68 * a, 0.02 * b), (-0.68 * a, 0.02 * b)]
    rear = [(-0.7 * a, -0.6 * b), (0.7 * a, -0.6 * b), (0.8 * a, -0.8 * b), (-0.8 * a, -0.8 * b)]
    glass = "#e7f1f6"
    return [
        Area(frame.place(cabin), glass, INK["furniture_line"], 0.012),
        Area(frame.place(rear), glass, INK["furniture_line"], 0.012),
        _detail(frame, [(-0.68 * a, 0.02 * b), (-0.7 * a, -0.6 * b)]),
        _detail(frame, [(0.68 * a, 0.02 * b), (0.7 * a, -0.6 * b)]),
    ]


def _tub(frame: Frame, a: float, b: float) -> list[Shape]:
    inner = rectangle(-a * 0.86, -b * 0.8, a * 0.86, b * 0.8)
    return [Area(frame.place(inner), "#e7f1f6", INK["furniture_line"], 0.012)]


def _stove(frame: Frame, a: float, b: float) -> list[Shape]:
    return [
        Area(frame.place(circle((x * a * 0.45, y * b * 0.45), min(a, b) * 0.28)), None, INK["furniture_line"], 0.012)
        for x in (-1, 1)
        for y in (-1, 1)
    ]


def _round(frame: Frame, a: float, b: float) -> list[Shape]:
    return []


def _plant(frame: Frame, a: float, b: float) -> list[Shape]:
    return [
        Line(frame.place([(0.0, 0.0), point]), INK["green"], 0.012)
        for point in circle((0.0, 0.0), 0.85 * a, 0.85 * b, steps=7)
    ]


SYMBOLS: tuple[tuple[tuple[str, ...], Symbol], ...] = (
    (("bedside", "nightstand", "bed_table", "overbed"), _plain),
    (("plant", "tree", "palm", "flower"), _plant),
    (("toilet_paper", "toilet_brush", "paper_towel"), _plain),
    (("toilet_stall", "toilet_cubicle"), _stall),
    (("toilet", "urinal", "bidet"), _toilet),
    (("garage_car", "car_lift", "pickup", "van", "ambulance"), _car),
    (("bathtub", "tub", "shower"), _tub),
    (("sink", "basin", "washbasin", "wash", "dryer"), _basin),
    (("stove", "cooker", "range", "hob"), _stove),
    (("round", "stool", "pouf", "ottoman", "bin", "lamp", "column", "trash", "garbage"), _round),
    (("chair", "armchair", "sofa", "couch", "bench", "seat", "recliner", "loveseat"), _seat),
    (("bed", "crib", "cot", "gurney", "stretcher", "bunk"), _bed),
    (("desk", "table", "counter", "workbench", "island"), _table),
    (("shelf", "shelv", "bookcase", "bookshel", "rack", "wardrobe", "cabinet", "locker"), _shelf),
    (("closet", "dresser", "cupboard", "gondola", "stack"), _shelf),
)
"""Beginnings of words of a category, and the symbol for it; the first that fits is taken."""


@cache
def _symbol(category: str) -> Symbol:
    words = f"_{category.lower()}"
    for beginnings, symbol in SYMBOLS:
        if any(f"_{word}" in words for word in beginnings):
            return symbol
    return _plain
