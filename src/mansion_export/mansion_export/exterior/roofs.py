"""Roofs: pitched ones over homes, flat ones with a parapet elsewhere and over what storeys above leave free."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

import msgspec
import numpy as np
import shapely
from shapely.geometry import Polygon, box
from shapely.geometry.base import BaseGeometry

from mansion_assets.texture_coordinates import slope_coordinates
from mansion_export.exterior.roof_plant import roof_plant
from mansion_export.meshes.materials import named, surface_material
from mansion_export.meshes.model import Material, Node, Part, Surface
from mansion_export.meshes.solids import polygon_surface
from mansion_geometry.randomness import item_generator
from mansion_knowledge import default_knowledge, is_class
from mansion_msgs_py.outside import Outside
from mansion_msgs_py.scene import FloorScene
from mansion_scene.structure.materials import facade_of

__all__ = ["Bounds", "covering_rectangles", "roof_parts"]

Bounds = tuple[float, float, float, float]
"""Least x, least y, greatest x, greatest y, metres."""

SLAB: Final = 0.25
"""Thickness of the slab over the highest storey, metres."""

PARAPET: Final = 0.35
COPING: Final = (0.06, 0.05)
"""Thickness of the metal on a parapet, and how far it stands out; metres."""

EAVES: Final = 0.45
"""How far a pitched roof reaches beyond the outer walls, metres."""

COVERING: Final = 0.14
"""Thickness of rafters and tiles together, metres."""

PITCH: Final = 35.0
"""Degrees."""

HIGHEST: Final = 4.5
"""Greatest height of a ridge over the eaves, metres: wide roofs are flatter."""

WIDEST: Final = 18.0
"""Span up to which roofs are pitched where the brief does not ask for one, metres."""

_HALF_WALL: Final = 0.06
"""From a room's polygon to the outer face of the wall towards a terrace, metres."""

LEAST_TERRACE: Final = 1.0
"""Square metres below which floor that no storey covers gets no roof of its own."""


def roof_parts(scene: FloorScene, slab: Polygon, above: BaseGeometry | None) -> Iterator[Part]:
    """Yield the roof over a floor, or over the part of it that the floor above leaves free.

    Parameters
    ----------
    slab : Polygon
        Ground plan of the slab over the floor, outer walls included.
    above : geometry, optional
        Ground plan of the storey above, outer walls included; none over the highest.
    """
    top = max((wall.height for wall in scene.walls), default=2.8)
    terraces = _open_terraces(scene)
    open_air = (slab if above is None else slab.difference(above)).difference(terraces)
    if open_air.area < LEAST_TERRACE:
        return
    name = f"F{scene.floor}/roof"
    form = _form(scene) if above is None else "flat"
    roofed = slab.difference(terraces).buffer(-0.05, join_style="mitre").buffer(0.05, join_style="mitre")
    rectangles = covering_rectangles(roofed) if form != "flat" else []
    widest = max((min(x1 - x0, y1 - y0) for x0, y0, x1, y1 in rectangles), default=0.0)
    if not rectangles or (widest > WIDEST and not _wanted(scene).roof):
        yield Node(name, name, "ceiling"), _flat(open_air, top, scene)
        return
    covering = named(_covering(scene))
    surfaces = _prisms(roofed, top, top + SLAB, named("polished_concrete"))
    for rectangle in rectangles:
        surfaces += _pitched(rectangle, top + SLAB, form, covering, surface_material(facade_of(scene), "wall"))
    yield Node(name, name, "ceiling"), surfaces


def _open_terraces(scene: FloorScene) -> BaseGeometry:
    """Return the ground plan of the rooms that lie open to the sky, up to the outer faces of their parapets."""
    rooms = [Polygon(room.polygon, room.holes) for room in scene.rooms if is_class(room.room_type, "outdoor")]
    if not rooms:
        return Polygon()
    indoors = [Polygon(room.polygon) for room in scene.rooms if not is_class(room.room_type, "outdoor")]
    indoors += [Polygon(core.polygon) for core in scene.cores]
    outer = max((wall.thickness for wall in scene.walls if wall.exterior), default=0.0)
    reach = shapely.union_all(rooms).buffer(outer + 0.01, join_style="mitre")
    return reach.difference(shapely.union_all(indoors).buffer(_HALF_WALL, join_style="mitre"))


def _wanted(scene: FloorScene) -> Outside:
    return Outside() if isinstance(scene.outside, msgspec.UnsetType) else scene.outside


def _form(scene: FloorScene) -> str:
    """Return ``gable``, ``hip`` or ``flat``, as the brief has it, else as its type and style do."""
    wanted = _wanted(scene).roof
    if wanted:
        return wanted
    forms = default_knowledge().groups.roofs_of(scene.building_type, scene.style)
    return forms[int(item_generator(scene.seed, "roof").integers(len(forms)))]


def _covering(scene: FloorScene) -> str:
    """Return the material of a pitched roof: that of the brief, else by chance."""
    if _wanted(scene).covering:
        return _wanted(scene).covering
    choices = ("clay_roof_tiles", "brown_roof_tiles", "slate_roof")
    return choices[int(item_generator(scene.seed, "roof covering").integers(len(choices)))]


def _flat(shape: BaseGeometry, top: float, scene: FloorScene) -> list[Surface]:
    """Return a flat roof: gravel, or what the brief covers it with, within a parapet of metal, and the plant on it."""
    ring = shape.difference(shape.buffer(-0.2, join_style="mitre"))
    proud = shape.buffer(COPING[1], join_style="mitre")
    coping = proud.difference(shape.buffer(-0.2 - COPING[1], join_style="mitre"))
    edge = top + SLAB + PARAPET
    return [
        *_prisms(shape, top, top + SLAB - 0.03, named("polished_concrete")),
        *_prisms(shape, top + SLAB - 0.03, top + SLAB, named(_wanted(scene).covering or "roof_gravel")),
        *_prisms(ring, top + SLAB, edge, surface_material(facade_of(scene), "wall")),
        *_prisms(coping, edge, edge + COPING[0], named("metal_panels")),
        *roof_plant(shape, top + SLAB, scene),
    ]


def _prisms(shape: BaseGeometry, bottom: float, top: float, material: Material) -> list[Surface]:
    polygons = [shape] if isinstance(shape, Polygon) else list(getattr(shape, "geoms", []))
    return [
        polygon_surface(polygon, bottom, top, material)
        for polygon in polygons
        if isinstance(polygon, Polygon) and polygon.area > 1e-4
    ]


@dataclass(frozen=True)
class _Frame:
    """A rectangle whose ridge runs along its first axis: takes (along, across, up) to plan coordinates."""

    bounds: Bounds

    @property
    def turned(self) -> bool:
        x0, y0, x1, y1 = self.bounds
        return y1 - y0 > x1 - x0

    @property
    def size(self) -> tuple[float, float]:
        x0, y0, x1, y1 = self.bounds
        return (y1 - y0, x1 - x0) if self.turned else (x1 - x0, y1 - y0)

    def place(self, points: list[tuple[float, float, float]]) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
        x0, y0, x1, _ = self.bounds
        if self.turned:
            return np.array([(x1 - across, y0 + along, up) for along, across, up in points])
        return np.array([(x0 + along, y0 + across, up) for along, across, up in points])


def _pitched(rectangle: Bounds, base: float, form: str, covering: Material, wall: Material) -> list[Surface]:
    """Return a roof over a rectangle, its eaves beyond the walls; gables are walls up to the ridge."""
    x0, y0, x1, y1 = rectangle
    frame = _Frame((x0 - EAVES, y0 - EAVES, x1 + EAVES, y1 + EAVES))
    length, width = frame.size
    rise = min(math.tan(math.radians(PITCH)) * width / 2, HIGHEST)
    # The underside meets the outer face of the wall, so the eaves hang lower by what the slope falls beyond it.
    low = base - rise * EAVES / (width / 2)
    inset = min(width / 2, length / 2) if form == "hip" else 0.0
    ridge = [(inset, width / 2, low + rise), (length - inset, width / 2, low + rise)]
    eaves = [(0.0, 0.0, low), (length, 0.0, low), (length, width, low), (0.0, width, low)]
    under = frame.place([*eaves, *ridge])
    upper = under + np.array([0.0, 0.0, COVERING])
    slopes = [(0, 1, 5), (0, 5, 4), (2, 3, 4), (2, 4, 5), (1, 2, 5), (3, 0, 4)]
    closing = [(0, 1), (1, 2), (2, 3), (3, 0)]
    surfaces = []
    if form == "gable":
        slopes, closing = slopes[:4], [(0, 1), (2, 3), (1, 5), (5, 2), (3, 4), (4, 0)]
        surfaces.append(_gables(frame, base, rise, low, wall))
    faces = [*slopes, *((a + 6, c + 6, b + 6) for a, b, c in slopes)]
    for a, b in closing:
        faces += [(a + 6, b + 6, b), (a + 6, b, a)]
    vertices, triangles = np.concatenate([upper, under]), np.array(faces, dtype=np.int64)
    surfaces.append(Surface(covering, vertices, triangles, slope_coordinates(vertices, triangles)))
    return surfaces


def _gables(frame: _Frame, base: float, rise: float, low: float, wall: Material) -> Surface:
    """Return the two triangles of wall below the ends of a ridge."""
    length, width = frame.size
    peak = low + rise
    points: list[tuple[float, float, float]] = []
    for along in (EAVES, EAVES + 0.2, length - EAVES - 0.2, length - EAVES):
        points += [(along, EAVES, base), (along, width - EAVES, base), (along, width / 2, peak)]
    faces = [(0, 2, 1), (3, 4, 5), (6, 8, 7), (9, 10, 11)]
    return Surface(wall, frame.place(points), np.array(faces, dtype=np.int64))


def covering_rectangles(shape: BaseGeometry) -> list[Bounds]:
    """Return rectangles that cover a ground plan of right angles without holes, largest first; else none.

    Each is as large as the plan allows, so that they overlap where wings meet and their roofs run into each other.

    Examples
    --------
    >>> from shapely.geometry import Polygon
    >>> covering_rectangles(Polygon([(0, 0), (8, 0), (8, 4), (3, 4), (3, 9), (0, 9)]))
    [(0.0, 0.0, 8.0, 4.0), (0.0, 0.0, 3.0, 9.0)]
    """
    if not isinstance(shape, Polygon) or shape.interiors:
        return []
    points = [(round(x, 3), round(y, 3)) for x, y in shape.exterior.coords]
    if any(abs(ax - bx) > 2e-3 and abs(ay - by) > 2e-3 for (ax, ay), (bx, by) in pairwise(points)):
        return []
    xs, ys = sorted({x for x, _ in points}), sorted({y for _, y in points})
    if len(xs) * len(ys) > 400:
        return []
    grown = shape.buffer(1e-3, join_style="mitre")
    found = [
        (x0, y0, x1, y1)
        for i, x0 in enumerate(xs)
        for x1 in xs[i + 1 :]
        for j, y0 in enumerate(ys)
        for y1 in ys[j + 1 :]
        if grown.covers(box(x0, y0, x1, y1))
    ]
    found.sort(key=lambda r: (-(r[2] - r[0]) * (r[3] - r[1]), r))
    chosen: list[Bounds] = []
    left: BaseGeometry = shape
    for rectangle in found:
        if left.area < 0.01:
            break
        if left.intersection(box(*rectangle)).area > 0.01:
            chosen.append(rectangle)
            left = left.difference(box(*rectangle).buffer(1e-3, join_style="mitre"))
    return chosen
