"""The plot that a building stands on: lawn or paving, a path to the street, trees, a hedge, places to park."""

import math
from collections.abc import Iterator, Sequence
from typing import Final

import numpy as np
import shapely
from shapely.geometry import LineString, Polygon, box
from shapely.geometry.base import BaseGeometry

from mansion_export.exterior.entrances import outer_doors, outward
from mansion_export.materials import named
from mansion_export.model import Material, Node, Part, Surface
from mansion_export.solids import Box, boxes_surface, polygon_surface
from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge
from mansion_msgs_py.scene import FloorScene

__all__ = ["plot_parts"]

GROUND: Final = -0.1
"""Height of the ground around a building below its ground floor, metres."""

MARGIN: Final = {True: 3.8, False: 6.2}
"""From the building to the edge of the plot, of homes and of others, metres."""

PATH: Final = {True: 1.4, False: 3.0}
HEDGE: Final = (0.5, 0.9)
"""Width and height of a hedge, metres."""

BAY: Final = (2.5, 5.0)
"""Width and length of a place to park, metres."""

TREE_CLEAR: Final = 1.7
"""From a tree's trunk to walls, paths and other trees, metres."""


def plot_parts(scene: FloorScene, slab: Polygon) -> Iterator[Part]:
    """Yield the ground around a building and what grows and stands there.

    Parameters
    ----------
    scene : FloorScene
        The ground floor.
    slab : Polygon
        Its ground plan, outer walls included.
    """
    home = default_knowledge().is_dwelling(scene.building_type)
    x0, y0, x1, y1 = slab.bounds
    margin = MARGIN[home]
    edge = box(x0 - margin, y0 - margin, x1 + margin, y1 + margin)
    around = edge.difference(Polygon(slab.exterior))
    paths = _paths(scene, edge, PATH[home]).intersection(around)
    parking = Polygon() if home else _parking(scene, edge, slab).difference(paths.buffer(0.5))
    green = around.difference(paths).difference(parking)
    prefix = f"F{scene.floor}/plot"
    for name, shape, material, top in (
        ("lawn", green, "lawn", GROUND),
        ("path", paths, "stone_paving", GROUND + 0.02),
        ("parking", parking, "asphalt", GROUND + 0.02),
    ):
        surfaces = _ground(shape, top, named(material))
        if surfaces:
            yield Node(f"{prefix}/{name}", f"{prefix}/{name}", "site"), surfaces
    if not parking.is_empty:
        yield Node(f"{prefix}/bays", f"{prefix}/bays", "site"), [_bay_lines(parking)]
    if home:
        hedge = edge.exterior.buffer(HEDGE[0] / 2).intersection(edge).difference(paths.buffer(0.3))
        surfaces = _ground(hedge, GROUND + HEDGE[1], named("hedge"), bottom=GROUND)
        yield Node(f"{prefix}/hedge", f"{prefix}/hedge", "site"), surfaces
    # Crowns may overhang the edge of the plot, but neither walls nor ways.
    free = green.difference(slab.buffer(TREE_CLEAR)).difference(paths.buffer(TREE_CLEAR)).buffer(-1.0)
    for number, (x, y, height) in enumerate(_trees(free, scene.seed, most=6 if home else 10), 1):
        name = f"{prefix}/tree_{number}"
        yield Node(name, name, "site"), _tree(x, y, height)


def _ground(shape: BaseGeometry, top: float, material: Material, *, bottom: float = GROUND - 0.1) -> list[Surface]:
    return [
        polygon_surface(shapely.geometry.polygon.orient(part), bottom, top, material)
        for part in shapely.get_parts(shape)
        if isinstance(part, Polygon) and part.area > 0.05
    ]


def _paths(scene: FloorScene, edge: Polygon, width: float) -> BaseGeometry:
    """Return the ways from the outer doors straight to the edge of the plot; a garage's is as wide as its door."""
    outline = Polygon(scene.outline, scene.holes)
    ways = []
    for door in outer_doors(scene):
        out = outward(door, outline)
        (ax, ay), (bx, by) = door.segment
        middle = ((ax + bx) / 2, (ay + by) / 2)
        far = max(edge.bounds[2] - edge.bounds[0], edge.bounds[3] - edge.bounds[1])
        line = LineString([middle, (middle[0] + far * out[0], middle[1] + far * out[1])])
        wide = door.width + 0.6 if door.kind == "garage" else width
        ways.append(line.buffer(wide / 2, cap_style="flat"))
    return shapely.union_all(ways) if ways else Polygon()


def _parking(scene: FloorScene, edge: Polygon, slab: Polygon) -> Polygon:
    """Return a strip of places to park along the side of the plot that has the fewest doors."""
    x0, y0, x1, y1 = edge.bounds
    depth = BAY[1]
    strips = [
        box(x0, y0, x0 + depth, y1),
        box(x1 - depth, y0, x1, y1),
        box(x0, y0, x1, y0 + depth),
        box(x0, y1 - depth, x1, y1),
    ]
    paths = _paths(scene, edge, PATH[False])
    return min(strips, key=lambda strip: (round(strip.intersection(paths).area, 3), -strip.area))


def _bay_lines(parking: BaseGeometry) -> Surface:
    """Return white lines between places to park."""
    boxes = []
    for part in shapely.get_parts(parking):
        x0, y0, x1, y1 = part.bounds
        upright = y1 - y0 > x1 - x0
        low, high = (y0, y1) if upright else (x0, x1)
        for k in range(int((high - low) / BAY[0]) + 1):
            at = low + k * BAY[0]
            center = ((x0 + x1) / 2, at) if upright else (at, (y0 + y1) / 2)
            size = (x1 - x0, 0.1) if upright else (0.1, y1 - y0)
            boxes.append(Box((*center, GROUND + 0.025), (*size, 0.01)))
    return boxes_surface(boxes, named("signal_white"))


def _trees(free: BaseGeometry, seed: int, *, most: int) -> Iterator[tuple[float, float, float]]:
    """Yield places and heights of trees in an area, apart from each other."""
    if free.is_empty:
        return
    generator = item_generator(seed, "trees")
    x0, y0, x1, y1 = free.bounds
    planted: list[tuple[float, float]] = []
    for _ in range(40 * most):
        x, y = float(generator.uniform(x0, x1)), float(generator.uniform(y0, y1))
        height = float(generator.uniform(3.5, 6.0))
        apart = all(math.dist((x, y), other) > 2 * TREE_CLEAR for other in planted)
        if apart and free.contains(shapely.Point(x, y)):
            planted.append((x, y))
            yield x, y, height
        if len(planted) == most:
            return


def _tree(x: float, y: float, height: float) -> list[Surface]:
    """Return a trunk and a rounded crown."""
    trunk = Box((x, y, GROUND + 0.25 * height), (0.22, 0.22, 0.5 * height))
    crown = _blob((x, y, GROUND + 0.68 * height), (0.27 * height, 0.27 * height, 0.32 * height), rings=5, around=9)
    return [boxes_surface([trunk], named("bark")), Surface(named("hedge"), *crown)]


def _blob(
    center: Sequence[float], radii: Sequence[float], *, rings: int, around: int
) -> tuple[np.ndarray[tuple[int, int], np.dtype[np.float64]], np.ndarray[tuple[int, int], np.dtype[np.int64]]]:
    """Return vertices and faces of an ellipsoid: two poles, and rings of latitude between them."""
    latitudes = np.linspace(-np.pi / 2, np.pi / 2, rings + 2)[1:-1]
    angles = np.linspace(0.0, 2 * np.pi, around, endpoint=False)
    points = [(0.0, 0.0, -1.0)]
    points += [(math.cos(v) * math.cos(a), math.cos(v) * math.sin(a), math.sin(v)) for v in latitudes for a in angles]
    points.append((0.0, 0.0, 1.0))
    faces = []
    top = len(points) - 1
    for k in range(around):
        following = (k + 1) % around
        faces.append((0, 1 + following, 1 + k))
        for ring in range(rings - 1):
            a, b = 1 + ring * around + k, 1 + ring * around + following
            faces += [(a, b, b + around), (a, b + around, a + around)]
        last = 1 + (rings - 1) * around
        faces.append((last + k, last + following, top))
    return np.array(points) * np.array(radii) + np.array(center), np.array(faces, dtype=np.int64)
