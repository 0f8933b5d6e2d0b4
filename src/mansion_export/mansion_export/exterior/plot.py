"""The plot that a building stands on: lawn or paving, a path to the street, trees, a hedge, places to park."""

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from typing import Final

import msgspec
import shapely
from shapely.geometry import LineString, Polygon, box
from shapely.geometry.base import BaseGeometry

from mansion_export.exterior.entrances import outer_doors, outward, shown_outside
from mansion_export.exterior.fronts import front_of
from mansion_export.exterior.ground_areas import driveways, laid_areas, laid_parts, taken_ground
from mansion_export.exterior.grounds import Patch, fence_parts, patch_of, patch_parts
from mansion_export.exterior.parking import bay_lines, bays, parked_cars
from mansion_export.exterior.plants import along_walls, shrubs, tree, tree_places
from mansion_export.exterior.railway import platform_part, track_bed
from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Material, Node, Part, Surface
from mansion_export.meshes.solids import polygon_surface
from mansion_knowledge import default_knowledge
from mansion_msgs_py.outside import GroundArea, Outside
from mansion_msgs_py.scene import FloorScene
from mansion_scene.structure.grounds import BAY

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


@dataclass(frozen=True)
class _Plot:
    """A plot divided into its surfaces, which do not overlap.

    Attributes
    ----------
    slab : Polygon
        The building.
    edge : Polygon
        Outline of the plot.
    areas : list of GroundArea
        What the brief asks for; `laid` is their ground.
    shown : list of str
        What its kind of building shows outside beside these.
    paths, parking, apron, tracks, green : geometry
        `apron` is asphalt that vehicles drive on to garages and car parks, `green` the lawn with the gardens.
    """

    scene: FloorScene
    slab: Polygon
    edge: Polygon
    areas: list[GroundArea]
    laid: BaseGeometry
    shown: list[str]
    paths: BaseGeometry
    parking: BaseGeometry
    apron: BaseGeometry
    tracks: BaseGeometry
    green: BaseGeometry

    @property
    def home(self) -> bool:
        """Whether people live there."""
        return _is_home(self.scene)

    @property
    def prefix(self) -> str:
        """What the names of all its parts begin with."""
        return f"F{self.scene.floor}/plot"


def plot_parts(scene: FloorScene, slab: Polygon) -> Iterator[Part]:
    """Yield the ground around a building and what grows and stands there.

    Parameters
    ----------
    scene : FloorScene
        The ground floor.
    slab : Polygon
        Its ground plan, outer walls included.
    """
    plot = _divided(scene, slab)
    patches = _patches(plot)
    for patch in patches:
        yield from patch_parts(patch, GROUND, plot.prefix)
    front = front_of(scene)
    if front is not None and not plot.tracks.is_empty:
        yield platform_part(front, slab, GROUND, f"F{scene.floor}/platform")
    yield from laid_parts(scene, plot.areas, GROUND, plot.prefix)
    bounding = _boundary(scene)
    if "fence" in (*plot.shown, *bounding):
        ways = plot.paths.union(plot.parking)
        ways = ways.union(plot.apron) if plot.areas else ways
        yield from fence_parts(plot.edge, ways.buffer(0.3), GROUND, plot.prefix)
    yield from _surfaced(plot)
    if "hedge" in bounding or (plot.home and "fence" not in bounding):
        yield _hedge(plot)
    yield from _planted(plot, patches)


def _is_home(scene: FloorScene) -> bool:
    return default_knowledge().is_dwelling(scene.building_type)


def _divided(scene: FloorScene, slab: Polygon) -> _Plot:
    """Return the plot of a building and what its surfaces are."""
    home = _is_home(scene)
    areas = laid_areas(scene)
    laid, wanted = taken_ground(areas), {area.use for area in areas}
    edge = _edge(slab, laid, MARGIN[home])
    around = edge.difference(Polygon(slab.exterior))
    paths = _clear_of(laid, _paths(scene, edge, PATH[home]).intersection(around))
    own = Polygon() if home or "parking" in wanted else _parking(scene, edge, slab)
    parking = _clear_of(laid, own.difference(paths.buffer(0.5)))
    shown = [name for name in shown_outside(scene) if name not in wanted]
    front = front_of(scene)
    apron = _paths(scene, edge, 0.0, APRON).intersection(around) if "apron" in shown else Polygon()
    if areas:
        apron = shapely.union(apron, driveways(areas, front, edge).intersection(around)).difference(laid)
    tracks = track_bed(front, slab) if front is not None and "platform" in shown else Polygon()
    parking = parking.difference(apron.buffer(0.5)).difference(tracks.buffer(0.5))
    hard = taken_ground([area for area in areas if area.use != "garden"])
    green = _clear_of(hard, around.difference(paths).difference(parking).difference(apron))
    return _Plot(scene, slab, edge, areas, laid, shown, paths, parking, apron, tracks, green)


def _edge(slab: Polygon, laid: BaseGeometry, margin: float) -> Polygon:
    """Return the rectangle around a building and all that is laid beside it."""
    x0, y0, x1, y1 = slab.bounds
    if not laid.is_empty:
        a0, b0, a1, b1 = laid.bounds
        x0, y0 = min(x0, a0 + margin - 1.0), min(y0, b0 + margin - 1.0)
        x1, y1 = max(x1, a1 - margin + 1.0), max(y1, b1 - margin + 1.0)
    return box(x0 - margin, y0 - margin, x1 + margin, y1 + margin)


def _clear_of(taken: BaseGeometry, shape: BaseGeometry) -> BaseGeometry:
    return shape if taken.is_empty else shape.difference(taken)


def _surfaced(plot: _Plot) -> Iterator[Part]:
    """Yield lawn, paths and asphalt, with lines between the places to park and cars on some of them."""
    for name, shape, material, top in (
        ("lawn", plot.green, "lawn", GROUND),
        ("path", plot.paths.difference(plot.apron), "stone_paving", GROUND + 0.02),
        ("parking", plot.parking, "asphalt", GROUND + 0.02),
        ("apron", plot.apron, "asphalt", GROUND + 0.02),
    ):
        surfaces = _ground(shape, top, named(material))
        if surfaces:
            yield Node(f"{plot.prefix}/{name}", f"{plot.prefix}/{name}", "site"), surfaces
    if not plot.parking.is_empty and bays(plot.parking):
        yield Node(f"{plot.prefix}/bays", f"{plot.prefix}/bays", "site"), [bay_lines(plot.parking, GROUND)]
        yield from parked_cars(plot.parking, plot.scene.seed, GROUND + 0.02, plot.prefix)


def _hedge(plot: _Plot) -> Part:
    """Return the hedge along the edge, open at paths and driveways."""
    ways = plot.paths.union(plot.apron) if plot.areas else plot.paths
    hedge = plot.edge.exterior.buffer(HEDGE[0] / 2).intersection(plot.edge).difference(ways.buffer(0.3))
    name = f"{plot.prefix}/hedge"
    return Node(name, name, "site"), _ground(hedge, GROUND + HEDGE[1], named("hedge"), bottom=GROUND)


def _planted(plot: _Plot, patches: Sequence[Patch]) -> Iterator[Part]:
    """Yield shrubs along the walls, and trees where they hide no front."""
    scene, slab = plot.scene, plot.slab
    around = plot.edge.difference(Polygon(slab.exterior))
    keep_off = around.difference(plot.green).union(plot.tracks).buffer(0.3)
    row = shrubs(along_walls(slab, SHRUBS), keep_off, scene.seed, GROUND)
    if row:
        yield Node(f"{plot.prefix}/shrubs", f"{plot.prefix}/shrubs", "site"), row
    # Crowns may overhang the edge of the plot, but neither walls nor ways.
    margin = MARGIN[plot.home]
    free = plot.green.difference(slab.buffer(TREE_CLEAR)).difference(plot.paths.buffer(TREE_CLEAR)).buffer(-1.0)
    free = free.difference(_before_windows(slab, margin)).difference(_before_front(scene, margin))
    free = _clear_of(plot.laid.buffer(TREE_CLEAR), free.difference(plot.tracks.buffer(TREE_CLEAR)))
    for door in outer_doors(scene):
        free = free.difference(shapely.Point(door.segment[0]).buffer(DOORSTEP))
    for patch in patches:
        free = free.difference(patch.shape.buffer(TREE_CLEAR))
    for number, (x, y, height) in enumerate(tree_places(free, scene.seed, most=5 if plot.home else 6), 1):
        name = f"{plot.prefix}/tree_{number}"
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


def _boundary(scene: FloorScene) -> set[str]:
    """Return what the brief has around the plot: a hedge, a fence."""
    outside = Outside() if isinstance(scene.outside, msgspec.UnsetType) else scene.outside
    return {str(wish.use) for wish in outside.grounds} & {"hedge", "fence"}


def _ground(shape: BaseGeometry, top: float, material: Material, *, bottom: float = GROUND - 0.1) -> list[Surface]:
    return [
        polygon_surface(shapely.geometry.polygon.orient(part), bottom, top, material)
        for part in shapely.get_parts(shape)
        if isinstance(part, Polygon) and part.area > 0.05
    ]


def _patches(plot: _Plot) -> list[Patch]:
    """Return the playground or terrace of a building whose kind has one, where it finds a place."""
    free = plot.green.difference(plot.slab.buffer(PATCH_OFF)).difference(plot.tracks)
    free = _clear_of(plot.laid, free).buffer(-0.3)
    found = (patch_of(plot.scene, use, free) for use in ("playground", "terrace") if use in plot.shown)
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
