"""The parts of a plot that a brief asks for, as the scene places them: gardens, pools, car parks, playgrounds."""

import math
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import msgspec
import shapely
from shapely.geometry import LineString, Polygon
from shapely.geometry.base import BaseGeometry
from shapely.geometry.polygon import orient

from mansion_assets.catalogue import load_catalogue
from mansion_export.exterior.fronts import Front
from mansion_export.exterior.grounds import Patch, patch_parts
from mansion_export.exterior.parking import bay_lines, bays, parked_cars
from mansion_export.exterior.plants import shrubs, tree, tree_places
from mansion_export.meshes.asset_surfaces import asset_surfaces
from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Node, Part
from mansion_export.meshes.solids import polygon_surface
from mansion_msgs_py.outside import GroundArea
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Point
from mansion_scene.structure.grounds import AISLE, BAY, DECK

__all__ = ["driveways", "laid_areas", "laid_parts", "taken_ground"]

BED: Final = 0.9
"""Width of a flower bed, metres."""

WATER: Final = 0.04
"""From the paving down to the water of a pool, metres."""

LOUNGERS: Final = 2.2
"""Between the middles of two loungers, metres."""


def laid_areas(scene: FloorScene) -> list[GroundArea]:
    """Return the parts of the plot that the brief asks for."""
    return [] if isinstance(scene.grounds, msgspec.UnsetType) else list(scene.grounds)


def taken_ground(areas: Sequence[GroundArea]) -> BaseGeometry:
    """Return the ground on which nothing else grows or stands: all areas with what is paved around pools."""
    shapes = [Polygon(area.polygon).buffer(DECK if area.use == "pool" else 0.0, join_style="mitre") for area in areas]
    return shapely.union_all(shapes) if shapes else Polygon()


def driveways(areas: Sequence[GroundArea], front: Front | None, edge: Polygon) -> BaseGeometry:
    """Return the ways from car parks to the street at the edge of the plot."""
    if front is None:
        return Polygon()
    ways = []
    for area in areas:
        if area.use == "parking":
            shape = Polygon(area.polygon)
            x, y = shape.centroid.x, shape.centroid.y
            far = (x + 400.0 * front.out[0], y + 400.0 * front.out[1])
            way = LineString([(x, y), far]).buffer(AISLE / 2, cap_style="flat")
            ways.append(way.intersection(edge).difference(shape))
    return shapely.union_all(ways) if ways else Polygon()


def laid_parts(scene: FloorScene, areas: Sequence[GroundArea], ground: float, prefix: str) -> Iterator[Part]:
    """Yield what lies and stands on the parts of the plot, at a height of the ground in metres."""
    for number, area in enumerate(areas, 1):
        shape, name = Polygon(area.polygon), f"{prefix}/{area.use}_{number}"
        if area.use == "garden":
            pools = taken_ground([other for other in areas if other.use == "pool"])
            yield from _garden(shape, pools, _Site(scene.seed + number, ground, name))
        elif area.use == "pool":
            yield from _pool(shape, _Site(scene.seed, ground, name))
        elif area.use == "parking":
            yield from _car_park(shape, area.count, _Site(scene.seed + number, ground, name))
        elif area.use == "playground":
            x0, y0, x1, y1 = shape.bounds
            middle = ((x0 + x1) / 2, (y0 + y1) / 2)
            yield from patch_parts(Patch("playground", middle, turned=y1 - y0 > x1 - x0), ground, name)


@dataclass(frozen=True)
class _Site:
    """What all things on a part of the plot have in common: chance, height of the ground in metres, names."""

    seed: int
    ground: float
    name: str


def _garden(shape: Polygon, pools: BaseGeometry, site: _Site) -> Iterator[Part]:
    """Yield beds with shrubs along two sides, a bench and trees."""
    x0, y0, x1, y1 = shape.bounds
    lines: list[tuple[Point, Point]] = [
        ((x0 + BED / 2, y0 + 0.6), (x0 + BED / 2, y1 - 0.6)),
        ((x1 - BED / 2, y0 + 0.6), (x1 - BED / 2, y1 - 0.6)),
    ]
    beds = shapely.union_all([LineString(line).buffer(BED / 2, cap_style="flat") for line in lines])
    yield _covered(beds.difference(pools), "soil_bed", site.ground + 0.03, f"{site.name}_beds", site.ground)
    plants = shrubs(lines, pools, site.seed, site.ground)
    if plants:
        yield Node(f"{site.name}_plants", f"{site.name}_plants", "site"), plants
    open_ground = shape.buffer(-BED - 0.7).difference(pools.buffer(1.5))
    for number, (x, y, height) in enumerate(tree_places(open_ground, site.seed, most=2), 1):
        yield Node(f"{site.name}_tree_{number}", f"{site.name}_tree_{number}", "site"), tree(x, y, height, site.ground)


def _pool(shape: Polygon, site: _Site) -> Iterator[Part]:
    """Yield the water, the paving around it, and loungers along one long side."""
    around = shape.buffer(DECK, join_style="mitre").difference(shape)
    yield _covered(around, "stone_paving", site.ground + 0.06, f"{site.name}_deck", site.ground)
    yield _covered(shape, "pool_water", site.ground + 0.06 - WATER, f"{site.name}_water", site.ground)
    x0, y0, x1, y1 = shape.bounds
    upright = y1 - y0 > x1 - x0
    length = max(x1 - x0, y1 - y0)
    known = load_catalogue()
    asset = min(known.by_category("lounger"), key=lambda one: (one.footprint, one.key))
    for number in range(int(length / LOUNGERS)):
        along = (number + 0.5) * LOUNGERS
        x, y = (x1 + DECK / 2, y0 + along) if upright else (x0 + along, y1 + DECK / 2)
        place = (x, y, site.ground + 0.06 + asset.size[2] / 2)
        node = Node(f"{site.name}_lounger_{number + 1}", f"outdoor:{asset.key}", "site", place, 90.0 * upright)
        yield node, asset_surfaces(asset.key, known)


def _car_park(shape: Polygon, count: int, site: _Site) -> Iterator[Part]:
    """Yield asphalt, lines between as many places as are asked for, and cars on some of them."""
    yield _covered(shape, "asphalt", site.ground + 0.02, f"{site.name}_surface", site.ground)
    rows = _rows(shape, count)
    if bays(rows):
        yield Node(f"{site.name}_bays", f"{site.name}_bays", "site"), [bay_lines(rows, site.ground)]
        yield from parked_cars(rows, site.seed, site.ground + 0.02, site.name)


def _rows(shape: Polygon, count: int) -> BaseGeometry:
    """Return the strips of places on either side of the way through a car park, the last one of an odd number left."""
    x0, y0, x1, _ = shape.bounds
    wide = 2 * BAY[1] + AISLE
    upright = math.isclose(x1 - x0, wide, abs_tol=0.01)
    strips = []
    for side, places in ((0, math.ceil(count / 2)), (1, count // 2)):
        low, length = side * (wide - BAY[1]), places * BAY[0]
        if upright:
            strips.append(shapely.box(x0 + low, y0, x0 + low + BAY[1], y0 + length))
        else:
            strips.append(shapely.box(x0, y0 + low, x0 + length, y0 + low + BAY[1]))
    return shapely.union_all(strips)


def _covered(shape: BaseGeometry, material: str, top: float, name: str, ground: float) -> Part:
    surfaces = [
        polygon_surface(orient(part), ground - 0.08, top, named(material))
        for part in shapely.get_parts(shape)
        if isinstance(part, Polygon) and part.area > 0.05
    ]
    return Node(name, name, "site"), surfaces
