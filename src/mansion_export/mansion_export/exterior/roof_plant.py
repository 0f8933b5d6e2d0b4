"""Plant on the flat roof of a building that is not a home: air handling units and rooflights."""

from typing import Final

from shapely.geometry import Polygon, box
from shapely.geometry.base import BaseGeometry

from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Surface
from mansion_export.meshes.solids import Box, boxes_surface
from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.scene import FloorScene

__all__ = ["roof_plant"]

UNIT: Final = (2.2, 1.3, 1.0)
"""Size of an air handling unit, metres."""

ROOFLIGHT: Final = (1.4, 1.4, 0.35)

EACH: Final = 110.0
"""Square metres of roof for each unit."""

MOST: Final = 6
EDGE: Final = 1.8
"""From the plant to the edges of the roof, metres."""


def roof_plant(shape: BaseGeometry, level: float, scene: FloorScene) -> list[Surface]:
    """Return the plant on a flat roof; none on homes and on small roofs."""
    home = not scene.building_type or default_knowledge().groups.is_dwelling(scene.building_type)
    if home or shape.area < EACH / 2:
        return []
    generator = item_generator(scene.seed, "roof plant")
    free = shape.buffer(-EDGE, join_style="mitre")
    placed: list[Polygon] = []
    units: list[Box] = []
    lights: list[Box] = []
    count = min(MOST, 1 + int(shape.area / EACH))
    for number in range(2 * count):
        size = UNIT if number < count else ROOFLIGHT
        for _ in range(12):
            x0, y0, x1, y1 = free.bounds if not free.is_empty else (0.0, 0.0, 0.0, 0.0)
            x, y = float(generator.uniform(x0, x1)), float(generator.uniform(y0, y1))
            plan = box(x - size[0] / 2, y - size[1] / 2, x + size[0] / 2, y + size[1] / 2)
            if free.covers(plan) and all(plan.distance(other) > 1.0 for other in placed):
                placed.append(plan)
                (units if size is UNIT else lights).append(Box((x, y, level + size[2] / 2), size))
                break
    return [*_units(units), *_rooflights(lights)]


def _units(cases: list[Box]) -> list[Surface]:
    """Return units: a case on feet, with two dark grilles of fans on top and one at the side."""
    grilles = []
    for case in cases:
        (x, y, z), (w, d, h) = case.center, case.size
        grilles += [Box((x + side * w / 4, y, z + h / 2), (0.36 * w, 0.62 * d, 0.04)) for side in (-1, 1)]
        grilles += [Box((x, y + side * d / 2, z + 0.06), (0.7 * w, 0.03, 0.6 * h)) for side in (-1, 1)]
    if not cases:
        return []
    return [boxes_surface(cases, named("metal_panels")), boxes_surface(grilles, named("painted_steel"))]


def _rooflights(cases: list[Box]) -> list[Surface]:
    if not cases:
        return []
    panes = [
        Box(
            (case.center[0], case.center[1], case.center[2] + case.size[2] / 2),
            (case.size[0] - 0.2, case.size[1] - 0.2, 0.03),
        )
        for case in cases
    ]
    return [boxes_surface(cases, named("painted_wood")), boxes_surface(panes, named("glass"))]
