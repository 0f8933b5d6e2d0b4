"""What finishes outer walls: a plinth, surrounds and railings of windows, and a coat over the edges of slabs."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import shapely
from shapely.geometry import LineString, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

from mansion_export.exterior.entrances import outer_doors
from mansion_export.meshes.materials import named, surface_material
from mansion_export.meshes.model import Material, Node, Part, Surface
from mansion_export.meshes.solids import Box, boxes_surface, polygon_surface
from mansion_knowledge import default_knowledge
from mansion_msgs_py.scene import FloorScene, Window
from mansion_msgs_py.shapes import Point
from mansion_scene.structure.materials import GLASS_FACADE, facade_of

__all__ = ["trim_parts"]

PROUD: Final = 0.025
"""How far plinths and surrounds stand out of a wall, metres."""

PLINTH: Final = 0.42
GROUND: Final = -0.1
"""Heights of a plinth's top and of the ground above and below the ground floor, metres."""

SURROUND: Final = 0.11
"""Width of the surround of a window, metres."""

LOW: Final = 0.5
"""Sill below which one could fall out of a window upstairs, metres."""

RAILING: Final = 1.0
RAIL: Final = 0.09
"""Height of a railing, and from the wall to it, metres."""

COATED: Final = 3
"""Most storeys of homes whose slabs the coat of the walls covers: on taller ones they show as bands."""

COAT: Final = 0.008
"""Thickness of the coat over the edge of a slab, metres."""


def trim_parts(scene: FloorScene, slab: Polygon) -> Iterator[Part]:
    """Yield the trims of one floor above ground.

    Parameters
    ----------
    slab : Polygon
        Ground plan of the floor, outer walls included, without the openings of cores.
    """
    facade = facade_of(scene)
    trims = default_knowledge().groups.trims.get(facade)
    surfaces: list[Surface] = []
    if default_knowledge().is_dwelling(scene.building_type) and scene.floor > 1 and scene.floors <= COATED:
        surfaces += _coat(scene, slab, surface_material(facade, "wall"))
    if trims is not None:
        plinth, surround = trims
        if plinth and scene.floor == 1:
            surfaces += _plinth(scene, slab, named(plinth))
        boxes = [box for window in scene.windows for box in _surround(window, slab)] if surround else []
        if boxes:
            surfaces.append(boxes_surface(boxes, named(surround)))
    bars = [bar for window in scene.windows for bar in _railing(scene, window, slab)]
    if bars:
        surfaces.append(boxes_surface(bars, named("painted_steel")))
    if surfaces:
        name = f"F{scene.floor}/trims"
        yield Node(name, name, "site"), surfaces


def _coat(scene: FloorScene, slab: Polygon, material: Material) -> list[Surface]:
    """Return the wall's own material over the edge of the slab below a floor."""
    deep = max(scene.height - max((wall.height for wall in scene.walls), default=2.8), 0.1)
    return _ring(slab.buffer(COAT, join_style="mitre").difference(slab.buffer(-0.02)), -deep, 0.0, material)


def _plinth(scene: FloorScene, slab: Polygon, material: Material) -> list[Surface]:
    """Return the plinth of the ground floor, open at doors and at windows that reach down into it."""
    low = [window.segment for window in scene.windows if window.sill < PLINTH + 0.05]
    openings = [LineString(door.segment).buffer(0.45, cap_style="square") for door in outer_doors(scene)]
    openings += [LineString(segment).buffer(0.4, cap_style="flat") for segment in low]
    ring = slab.buffer(PROUD, join_style="mitre").difference(slab.buffer(-0.02))
    return _ring(ring.difference(shapely.union_all(openings)) if openings else ring, GROUND, PLINTH, material)


def _ring(shape: BaseGeometry, bottom: float, top: float, material: Material) -> list[Surface]:
    return [
        polygon_surface(orient(part), bottom, top, material)
        for part in shapely.get_parts(shape)
        if isinstance(part, Polygon) and part.area > 1e-4
    ]


@dataclass(frozen=True)
class _Face:
    """The outer face of a wall at a window, in whose terms boxes are placed."""

    middle: Point
    along: Point
    out: Point
    away: float

    def box(self, at: float, before: float, up: float, size: tuple[float, float, float]) -> Box:
        """Return a box by its middle and its size along the wall, before it and upwards, metres."""
        reach = self.away + before
        x = self.middle[0] + at * self.along[0] + reach * self.out[0]
        y = self.middle[1] + at * self.along[1] + reach * self.out[1]
        return Box((x, y, up), size, math.degrees(math.atan2(self.along[1], self.along[0])))


def _face(window: Window, slab: Polygon) -> _Face | None:
    """Return the outer face at a window; None where neither side of its wall is outside."""
    (ax, ay), (bx, by) = window.segment
    length = math.dist(*window.segment)
    along, middle = ((bx - ax) / length, (by - ay) / length), ((ax + bx) / 2, (ay + by) / 2)
    for out in ((-along[1], along[0]), (along[1], -along[0])):
        if not slab.contains(shapely.Point(middle[0] + 0.5 * out[0], middle[1] + 0.5 * out[1])):
            return _Face(middle, along, out, float(slab.exterior.distance(shapely.Point(middle))))
    return None


def _surround(window: Window, slab: Polygon) -> Iterator[Box]:
    """Yield the frame over a window and on either side."""
    face, length = _face(window, slab), math.dist(*window.segment)
    if face is None:
        return
    head, tall = window.sill + window.height, window.height + SURROUND
    yield face.box(0.0, PROUD / 2, head + SURROUND / 2, (length, PROUD, SURROUND))
    for sign in (-1, 1):
        side = (SURROUND, PROUD, tall)
        yield face.box(sign * (length + SURROUND) / 2, PROUD / 2, window.sill + tall / 2, side)


def _railing(scene: FloorScene, window: Window, slab: Polygon) -> Iterator[Box]:
    """Yield a railing before a window upstairs that reaches down to the floor."""
    face, length = _face(window, slab), math.dist(*window.segment) + 0.2
    if face is None or scene.floor < 2 or window.sill > LOW or facade_of(scene) == GLASS_FACADE:
        return
    for up in (window.sill, RAILING):
        yield face.box(0.0, RAIL, up, (length, 0.04, 0.05))
    count = max(2, round(length / 0.13))
    high = RAILING - window.sill
    for k in range(count + 1):
        yield face.box(length * (k / count - 0.5), RAIL, window.sill + high / 2, (0.018, 0.018, high))
