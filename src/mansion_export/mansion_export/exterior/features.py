"""What tells from the street what kind of building it is: marquees, posters, portals, awnings, banners, a flag."""

from collections.abc import Callable, Iterator
from typing import Final

from shapely.geometry import Point as Place

from mansion_export.exterior.entrances import accent, shown_outside
from mansion_export.exterior.fronts import Front, front_of, front_windows, places_beside
from mansion_export.meshes.materials import named, surface_material
from mansion_export.meshes.model import Node, Part, Surface
from mansion_export.meshes.solids import boxes_surface, polygon_surface
from mansion_msgs_py.scene import FloorScene
from mansion_scene.structure.materials import facade_of

__all__ = ["feature_parts"]

GROUND: Final = -0.1
LIFTED: Final = 0.1
"""From the head of a door to the roof before it, metres."""

COLUMN: Final = 0.17
"""Radius of a portal's columns, metres."""

POST: Final = 0.14
"""Thickness of a porch's posts, metres."""

POSTER: Final = (1.1, 0.7, 2.3)
BANNER: Final = (0.9, 1.0, 3.0)
"""Width of a poster and of a banner, and the heights that they reach from and to, metres."""

AWNING: Final = 0.95
STRIPE: Final = 0.3
"""How far an awning reaches out, and the width of its stripes, metres."""

TOWER: Final = 2.8
"""Side of a church's tower, metres."""

POLE: Final = 7.0
"""Height of a flagpole, metres."""


def feature_parts(scene: FloorScene) -> Iterator[Part]:
    """Yield what a building of its kind shows at its front."""
    front = front_of(scene)
    if front is None:
        return
    for name in shown_outside(scene):
        draw = _FEATURES.get(name)
        surfaces = draw(scene, front) if draw is not None else []
        if surfaces:
            node = f"F{scene.floor}/{name}"
            yield Node(node, node, "site"), surfaces


def _reach(front: Front, aside: float) -> tuple[float, float]:
    """Return from where to where a roof reaches that covers a door and so much beside it, within the side."""
    half = front.door.width / 2 + aside
    return max(-half, front.low), min(half, front.high)


def _marquee(scene: FloorScene, front: Front) -> list[Surface]:
    """Return a deep roof whose lit edge tells what is on."""
    low, high = _reach(front, 2.2)
    base = front.door.height + LIFTED
    edges = [
        front.box((low + 0.1, high - 0.1), (2.2, 2.26), (base - 0.12, base + 0.24)),
        front.box((low - 0.06, low), (0.2, 2.1), (base - 0.12, base + 0.24)),
        front.box((high, high + 0.06), (0.2, 2.1), (base - 0.12, base + 0.24)),
    ]
    lines = [
        front.box(
            (low + 0.5, high - 0.5 - 0.6 * row), (2.26, 2.28), (base + 0.08 - 0.14 * row, base + 0.13 - 0.14 * row)
        )
        for row in (0, 1)
    ]
    slab = front.box((low, high), (0.0, 2.2), (base - 0.18, base + 0.3))
    return [
        boxes_surface([slab], accent(scene)),
        boxes_surface(edges, named("signal_white")),
        boxes_surface(lines, named("painted_steel")),
    ]


def _portal(scene: FloorScene, front: Front) -> list[Surface]:
    """Return columns with a slab over them, on two steps."""
    low, high = _reach(front, 1.5)
    base = front.door.height + LIFTED
    stone = named("sandstone")
    places = [low + 0.3, low + 1.1, high - 1.1, high - 0.3]
    columns = [
        polygon_surface(Place(front.at(place, 1.7)).buffer(COLUMN, quad_segs=4), GROUND, base, stone)
        for place in places
    ]
    slabs = [
        front.box((low, high), (0.0, 2.0), (base, base + 0.3)),
        front.box((low - 0.4, high + 0.4), (0.0, 2.3), (GROUND, GROUND + 0.05)),
        front.box((low - 0.1, high + 0.1), (0.0, 2.05), (GROUND + 0.05, GROUND + 0.09)),
    ]
    return [*columns, boxes_surface(slabs, stone)]


def _porch(scene: FloorScene, front: Front) -> list[Surface]:
    """Return a roof on two posts over a deck."""
    low, high = _reach(front, 1.0)
    base = front.door.height + LIFTED
    posts = [
        front.box((place, place + POST), (1.5, 1.5 + POST), (GROUND, base))
        for place in (low + 0.05, high - 0.05 - POST)
    ]
    roof = front.box((low - 0.15, high + 0.15), (0.0, 1.85), (base, base + 0.14))
    deck = front.box((low, high), (0.0, 1.75), (GROUND, GROUND + 0.09))
    return [boxes_surface([*posts, roof], named("dark_wood")), boxes_surface([deck], named("timber_deck"))]


def _posters(scene: FloorScene, front: Front) -> list[Surface]:
    """Return posters in frames on the bare wall beside the entrance."""
    width, low, high = POSTER
    colours = ("sign_red", "sign_blue", "sign_green", "signal_white")
    surfaces = []
    for number, place in enumerate(places_beside(scene, front, width, 4)):
        sides = (place - width / 2, place + width / 2)
        inner = (sides[0] + 0.07, sides[1] - 0.07)
        surfaces += [
            boxes_surface([front.box(sides, (0.0, 0.05), (low, high))], named("painted_steel")),
            boxes_surface([front.box(inner, (0.05, 0.06), (low + 0.07, high - 0.07))], named(colours[number % 4])),
            boxes_surface([front.box(inner, (0.06, 0.065), (low + 0.2, low + 0.45))], named("signal_white")),
        ]
    return surfaces


def _banners(scene: FloorScene, front: Front) -> list[Surface]:
    """Return tall banners on the bare wall on either side."""
    width, low, high = BANNER
    cloths, marks = [], []
    for place in places_beside(scene, front, width, 4):
        cloths.append(front.box((place - width / 2, place + width / 2), (0.0, 0.04), (low, high)))
        marks.append(front.box((place - 0.2, place + 0.2), (0.04, 0.045), (low + 0.3, high - 0.3)))
    if not cloths:
        return []
    return [boxes_surface(cloths, accent(scene)), boxes_surface(marks, named("signal_white"))]


def _awnings(scene: FloorScene, front: Front) -> list[Surface]:
    """Return a striped awning over each window at the front."""
    stripes: list[list[tuple[float, float, float]]] = [[], []]
    for window, low, high in front_windows(scene, front):
        count = max(3, round((high - low + 0.2) / STRIPE))
        pitch = (high - low + 0.2) / count
        head = window.sill + window.height
        for number in range(count):
            first = low - 0.1 + number * pitch
            stripes[number % 2].append((first, first + pitch, head))
    boxes = [
        [
            box
            for first, last, head in group
            for box in (
                front.box((first, last), (0.0, AWNING / 2), (head + 0.1, head + 0.16)),
                front.box((first, last), (AWNING / 2, AWNING), (head - 0.02, head + 0.04)),
                front.box((first, last), (AWNING, AWNING + 0.03), (head - 0.18, head + 0.04)),
            )
        ]
        for group in stripes
    ]
    if not boxes[0]:
        return []
    return [boxes_surface(boxes[0], accent(scene)), boxes_surface(boxes[1], named("signal_white"))]


def _steeple(scene: FloorScene, front: Front) -> list[Surface]:
    """Return a tower with a cross at the end of the front that is farther from the entrance."""
    near = -front.low > front.high
    low, high = (front.low, front.low + TOWER) if near else (front.high - TOWER, front.high)
    doors = [front.interval(door.segment) for door in scene.doors if None in door.rooms]
    if any(interval and interval[0] < high + 0.5 and interval[1] > low - 0.5 for interval in doors):
        return []
    top = max((wall.height for wall in scene.walls), default=3.0) + 5.5
    middle = (low + high) / 2
    shaft = front.box((low, high), (0.0, TOWER), (GROUND, top))
    roofs = [
        front.box(
            (low - 0.2 + step, high + 0.2 - step),
            (step - 0.2, TOWER + 0.2 - step),
            (top + 1.1 * step, top + 1.1 * step + 0.45),
        )
        for step in (0.0, 0.4, 0.8, 1.2)
    ]
    head = top + 1.8
    cross = [
        front.box((middle - 0.06, middle + 0.06), (TOWER / 2 - 0.06, TOWER / 2 + 0.06), (head, head + 1.3)),
        front.box((middle - 0.4, middle + 0.4), (TOWER / 2 - 0.06, TOWER / 2 + 0.06), (head + 0.75, head + 0.9)),
    ]
    openings = [front.box((middle - 0.45, middle + 0.45), (TOWER, TOWER + 0.03), (top - 2.2, top - 0.6))]
    return [
        boxes_surface([shaft], surface_material(facade_of(scene), "wall")),
        boxes_surface(roofs, named("slate_roof")),
        boxes_surface([*cross, *openings], named("painted_steel")),
    ]


def _flagpole(scene: FloorScene, front: Front) -> list[Surface]:
    """Return a pole with a flag beside the way to the entrance."""
    along = front.door.width / 2 + 5.0
    x, y = front.at(along, 3.6)
    pole = polygon_surface(Place(x, y).buffer(0.06, quad_segs=2), GROUND, POLE, named("signal_white"))
    flag = front.box((along + 0.08, along + 1.7), (3.58, 3.62), (POLE - 1.2, POLE - 0.15))
    stripe = front.box((along + 0.08, along + 1.7), (3.57, 3.63), (POLE - 0.8, POLE - 0.55))
    return [pole, boxes_surface([flag], accent(scene)), boxes_surface([stripe], named("signal_white"))]


_FEATURES: Final[dict[str, Callable[[FloorScene, Front], list[Surface]]]] = {
    "marquee": _marquee,
    "portal": _portal,
    "porch": _porch,
    "posters": _posters,
    "banners": _banners,
    "awnings": _awnings,
    "flagpole": _flagpole,
    "steeple": _steeple,
}
