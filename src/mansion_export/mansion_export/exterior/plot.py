"""The plot that a building stands on: lawn or paving, a path to the street, trees, a hedge, places to park."""

from collections.abc import Iterator, Sequence
from typing import Final

import shapely
from shapely.geometry import LineString, Polygon, box
from shapely.geometry.base import BaseGeometry

from mansion_export.exterior.entrances import outer_doors, outward, shown_outside
from mansion_export.exterior.fronts import front_of
from mansion_export.exterior.grounds import Patch, fence_parts, patch_of, patch_parts
from mansion_export.exterior.parking import BAY, bays, parked_cars
from mansion_export.exterior.plants import along_walls, shrubs, tree, tree_places
from mansion_export.exterior.railway import platform_part, track_bed
from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Material, Node, Part, Surface
from mansion_export.meshes.solids import Box, boxes_surface, polygon_surface
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

SHRUBS: Final = 0.75
"""From the walls to the middle of the shrubs along them, metres."""

ENDS: Final = 0.22
"""Share of a side of the building at either end before which trees stand."""

BESIDE: Final = 3.0
"""How far behind the line of the front no trees stand beside it, metres."""

APRON: Final = 4.0
"""Asphalt beside the way to a door for vehicles, both sides together, metres."""

PATCH_OFF: Final = 0.9
"""From the walls to a terrace or a playground, metres."""

DOORSTEP: Final = 6.0
"""From a tree's trunk to doors and the sign above them, metres."""

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
    shown = shown_outside(scene)
    apron = _paths(scene, edge, 0.0, APRON).intersection(around) if "apron" in shown else Polygon()
    front = front_of(scene)
    tracks = track_bed(front, slab) if front is not None and "platform" in shown else Polygon()
    parking = parking.difference(apron.buffer(0.5)).difference(tracks.buffer(0.5))
    green = around.difference(paths).difference(parking).difference(apron)
    prefix = f"F{scene.floor}/plot"
    patches = _patches(scene, shown, green.difference(slab.buffer(PATCH_OFF)).difference(tracks).buffer(-0.3))
    for patch in patches:
        yield from patch_parts(patch, GROUND, prefix)
    if front is not None and not tracks.is_empty:
        yield platform_part(front, slab, GROUND, f"F{scene.floor}/platform")
    if "fence" in shown:
        yield from fence_parts(edge, shapely.union(paths, parking).buffer(0.3), GROUND, prefix)
    for name, shape, material, top in (
        ("lawn", green, "lawn", GROUND),
        ("path", paths.difference(apron), "stone_paving", GROUND + 0.02),
        ("parking", parking, "asphalt", GROUND + 0.02),
        ("apron", apron, "asphalt", GROUND + 0.02),
    ):
        surfaces = _ground(shape, top, named(material))
        if surfaces:
            yield Node(f"{prefix}/{name}", f"{prefix}/{name}", "site"), surfaces
    if not parking.is_empty and bays(parking):
        yield Node(f"{prefix}/bays", f"{prefix}/bays", "site"), [_bay_lines(parking)]
        yield from parked_cars(parking, scene.seed, GROUND + 0.02, prefix)
    if home:
        hedge = edge.exterior.buffer(HEDGE[0] / 2).intersection(edge).difference(paths.buffer(0.3))
        surfaces = _ground(hedge, GROUND + HEDGE[1], named("hedge"), bottom=GROUND)
        yield Node(f"{prefix}/hedge", f"{prefix}/hedge", "site"), surfaces
    row = shrubs(along_walls(slab, SHRUBS), around.difference(green).union(tracks).buffer(0.3), scene.seed, GROUND)
    if row:
        yield Node(f"{prefix}/shrubs", f"{prefix}/shrubs", "site"), row
    # Crowns may overhang the edge of the plot, but neither walls nor ways, and they hide no front.
    free = green.difference(slab.buffer(TREE_CLEAR)).difference(paths.buffer(TREE_CLEAR)).buffer(-1.0)
    free = free.difference(_before_windows(slab, margin)).difference(_before_front(scene, margin))
    free = free.difference(tracks.buffer(TREE_CLEAR))
    for door in outer_doors(scene):
        free = free.difference(shapely.Point(door.segment[0]).buffer(DOORSTEP))
    for patch in patches:
        free = free.difference(patch.shape.buffer(TREE_CLEAR))
    for number, (x, y, height) in enumerate(tree_places(free, scene.seed, most=5 if home else 6), 1):
        name = f"{prefix}/tree_{number}"
        yield Node(name, name, "site"), tree(x, y, height, GROUND)


def _before_windows(slab: Polygon, margin: float) -> BaseGeometry:
    """Return the ground before the middles of a building's sides, where trees would hide it."""
    x0, y0, x1, y1 = slab.bounds
    across, along = ENDS * (x1 - x0), ENDS * (y1 - y0)
    far = 2 * margin
    return shapely.union(
        box(x0 + across, y0 - far, x1 - across, y1 + far), box(x0 - far, y0 + along, x1 + far, y1 - along)
    )


def _before_front(scene: FloorScene, margin: float) -> BaseGeometry:
    """Return the ground before a building's front and around its corners: from the street one sees it, and its sign."""
    front = front_of(scene)
    if front is None:
        return Polygon()
    low, high, far = front.low - 2 * margin, front.high + 2 * margin, 2 * margin
    return Polygon([front.at(low, -BESIDE), front.at(high, -BESIDE), front.at(high, far), front.at(low, far)])


def _ground(shape: BaseGeometry, top: float, material: Material, *, bottom: float = GROUND - 0.1) -> list[Surface]:
    return [
        polygon_surface(shapely.geometry.polygon.orient(part), bottom, top, material)
        for part in shapely.get_parts(shape)
        if isinstance(part, Polygon) and part.area > 0.05
    ]


def _patches(scene: FloorScene, shown: Sequence[str], free: BaseGeometry) -> list[Patch]:
    """Return the playground or terrace of a building whose kind has one, where it finds a place."""
    found = (patch_of(scene, use, free) for use in ("playground", "terrace") if use in shown)
    return [patch for patch in found if patch is not None]


def _paths(scene: FloorScene, edge: Polygon, width: float, beside_garages: float | None = None) -> BaseGeometry:
    """Return the ways from the outer doors straight to the edge of the plot; a garage's is as wide as its door.

    Parameters
    ----------
    width : float
        Of the ways to doors that people come in by.
    beside_garages : float, optional
        Ground beside the ways to garages; then there are no others.
    """
    outline = Polygon(scene.outline, scene.holes)
    ways = []
    for door in outer_doors(scene):
        out = outward(door, outline)
        (ax, ay), (bx, by) = door.segment
        middle = ((ax + bx) / 2, (ay + by) / 2)
        far = max(edge.bounds[2] - edge.bounds[0], edge.bounds[3] - edge.bounds[1])
        line = LineString([middle, (middle[0] + far * out[0], middle[1] + far * out[1])])
        wide = door.width + 0.6 if door.kind == "garage" else width
        if beside_garages is not None:
            wide = wide + beside_garages if door.kind == "garage" else 0.0
        if wide <= 0.0:
            continue
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
    for bay in bays(parking):
        for side in (-1, 1):
            x, y = bay.beside(side * BAY[0] / 2)
            boxes.append(Box((x, y, GROUND + 0.025), (0.1, BAY[1], 0.01), bay.heading))
    return boxes_surface(boxes, named("signal_white"))
