"""One placed room as a picture: the system's boxes as furniture, in low walls, from above."""

import itertools
import math
from typing import TYPE_CHECKING

import numpy as np
from shapely.geometry import Polygon
from shapely.geometry.polygon import orient

from mansion_assets.catalogue import Asset, Catalogue, load_catalogue
from mansion_export.meshes.building_model import object_parts
from mansion_export.meshes.materials import named
from mansion_export.meshes.model import Node, Part, assemble
from mansion_export.meshes.solids import Box, boxes_surface, polygon_surface
from mansion_export.pictures.projecting import bounds_along
from mansion_export.pictures.renderer import Triangles, View, flatten, render
from mansion_geometry.compiled import Floats
from mansion_msgs_py.late_imports import importing
from mansion_msgs_py.placement import PlacementResult, PlacementRoom
from mansion_msgs_py.scene import FloorScene, SceneObject

if TYPE_CHECKING:
    from PIL.Image import Image

__all__ = ["room_picture"]


WALL, THICKNESS, SILL = 1.1, 0.12, 0.9
"""Height at which walls are cut, their thickness, and the height below windows; metres."""

_OPENING_REACH = 0.3
"""How far from a wall's inner face an opening's segment may lie, metres."""

_FLOOR = "light_hardwood"


def room_picture(
    room: PlacementRoom,
    result: PlacementResult,
    size: tuple[int, int],
    *,
    catalogue: Catalogue | None = None,
    azimuth: float = -68.0,
) -> "Image":
    """Draw a room with what a system placed in it.

    Every object becomes the asset of its category that is nearest to its size, scaled to it, so that pictures of
    several systems differ by their placements alone.

    Parameters
    ----------
    room : PlacementRoom
    result : PlacementResult
    size : (width, height)
        Size of the picture, pixels; the room is centred in it.
    catalogue : Catalogue, optional
    azimuth : float
        Where the eye stands, degrees; see `View`.
    """
    from PIL import Image

    known = catalogue or load_catalogue()
    net = orient(Polygon(room.polygon, room.holes))
    parts: list[Part] = [
        (Node("floor", "floor", "structure"), [polygon_surface(net, -0.05, 0.0, named(_FLOOR))]),
        (Node("walls", "walls", "structure"), [boxes_surface(_walls(room, net), named("white_drywall"))]),
        *object_parts(_scene(room, result, known), known),
    ]
    triangles = flatten(assemble(room.room_id, 1, 0.0, parts))
    picture = Image.new("RGB", size, "#ffffff")
    drawn = _drawn(triangles, size, azimuth)
    picture.paste(drawn, ((size[0] - drawn.width) // 2, (size[1] - drawn.height) // 2))
    return picture


def _drawn(triangles: Triangles, size: tuple[int, int], azimuth: float) -> "Image":
    from PIL import Image

    view = View(azimuth, 56.0)
    low, high = bounds_along(triangles.corners, view.axes())
    fit = min(size[0] / (high[0] - low[0]), size[1] / (high[1] - low[1]))
    scale = 0.95 * float(fit)
    return Image.fromarray(render(triangles, View(view.azimuth, view.elevation, scale)))


def _scene(room: PlacementRoom, result: PlacementResult, catalogue: Catalogue) -> FloorScene:
    categories = {item.name: item.category or item.name for item in room.objects}
    objects = []
    for item in result.placements:
        category = categories.get(item.name, item.name)
        asset = _nearest_asset(catalogue, category, item.size)
        objects.append(
            SceneObject(
                id=item.id,
                room=room.room_id,
                category=category,
                asset=asset.key if asset else "",
                position=(item.center[0], item.center[1], item.size[2] / 2),
                rotation=item.rotation,
                size=item.size,
                color=asset.color if asset else "#b9b2a6",
            )
        )
    return FloorScene(
        building_id=room.room_id,
        floor=1,
        floors=1,
        label="1",
        elevation=0.0,
        height=3.0,
        outline=room.polygon,
        rooms=[],
        walls=[],
        doors=[],
        objects=objects,
    )


def _nearest_asset(catalogue: Catalogue, category: str, size: tuple[float, float, float]) -> Asset | None:
    """Return the asset of a category that needs least scaling; the most similar category's where there is none."""
    with importing:
        from mansion_assets.catalogue.search import search_assets

    assets = list(catalogue.by_category(category))
    if not assets:
        found = search_assets(catalogue, category.replace("_", " "), 1)
        assets = [found[0].asset] if found else []
    return min(assets, key=lambda a: (sum(abs(math.log(x / y)) for x, y in zip(a.size, size)), a.key), default=None)


def _walls(room: PlacementRoom, net: Polygon) -> list[Box]:
    """Return the low walls around a room, open at doors and down to the sill at windows."""
    boxes = []
    for ring in (net.exterior, *net.interiors):
        points = np.asarray(ring.coords)[:, :2]
        for start, end in itertools.pairwise(points):
            length = float(np.hypot(*(end - start)))
            if length > 1e-6:
                boxes += _wall(room, start, (end - start) / length, length)
    return boxes


def _wall(room: PlacementRoom, start: Floats, along: Floats, length: float) -> list[Box]:
    outward = np.array([along[1], -along[0]])
    heading = float(np.degrees(np.arctan2(along[1], along[0])))
    tops = {(-THICKNESS, length + THICKNESS): WALL}
    for openings, top in ((room.windows, SILL), (room.doors, 0.0)):
        for opening in openings:
            ends = np.array(opening.segment) - start
            away, places = np.abs(ends @ outward).max(), np.sort(ends @ along)
            if away < _OPENING_REACH and places[1] > 0.0 and places[0] < length:
                tops = _cut(tops, float(places[0]), float(places[1]), top)
    boxes = []
    for (low, high), top in tops.items():
        if top > 0.0 and high - low > 1e-3:
            x, y = start + along * (low + high) / 2 + outward * THICKNESS / 2
            size = (high - low, THICKNESS, top + 0.05)
            boxes.append(Box((float(x), float(y), top / 2 - 0.025), size, heading))
    return boxes


def _cut(
    tops: dict[tuple[float, float], float], low: float, high: float, top: float
) -> dict[tuple[float, float], float]:
    """Lower the wall between two places along it."""
    parts: dict[tuple[float, float], float] = {}
    for (a, b), height in tops.items():
        inner = (max(a, low), min(b, high))
        if inner[1] <= inner[0]:
            parts[(a, b)] = height
            continue
        if inner[0] > a:
            parts[(a, inner[0])] = height
        parts[inner] = min(height, top)
        if b > inner[1]:
            parts[(inner[1], b)] = height
    return parts
