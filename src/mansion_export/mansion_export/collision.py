"""Boxes that collide: floors, steps, furniture and door leaves, with cavities for loose objects."""

import itertools
from collections.abc import Sequence
from dataclasses import dataclass
from typing import TypeAlias

import numpy as np
from shapely.geometry import Polygon
from shapely.geometry import box as shapely_box

from mansion_assets.catalogue import Catalogue, load_catalogue
from mansion_assets.meshes import collision_boxes
from mansion_export.model import Mesh, Node
from mansion_export.solids import Box, box_between, boxes_of
from mansion_geometry.robot_body import FLAT
from mansion_msgs_py.scene import FloorScene, SceneObject, StairDetails
from mansion_msgs_py.shapes import Size3

__all__ = ["Colliders", "ground_boxes", "is_loose", "loose_colliders"]

FLOOR_DEPTH = 0.2
"""Thickness of the ground below the finished floor, metres."""

Bounds: TypeAlias = tuple[float, float, float, float, float, float]
"""Lowest x, y, z and highest x, y, z."""

PLAY = 0.002
"""Metres between an object and the walls of its cavity."""

DEEP = 0.001
"""Boxes that share less than this, metres, only touch."""

SHELF = 0.01
"""Thickness of the board that is put below what an asset's boxes do not carry, metres."""

LEVEL = 0.004
"""Difference of heights below which an object rests on a face, metres."""


def ground_boxes(scene: FloorScene) -> list[tuple[str, Box]]:
    """Return the ground of rooms, landings and lift cabins, and the steps of stairs, as upright boxes by name."""
    boxes = []
    for room in scene.rooms:
        if room.kind == "stair":
            continue
        for i, solid in enumerate(_strips(Polygon(room.polygon, room.holes))):
            boxes.append((f"{room.id}/ground/{i}", solid))
    for core in scene.cores:
        details = core.details
        if details is None:
            continue
        if isinstance(details, StairDetails):
            solids = [*details.treads, *details.landings]
            for i, (low, high) in enumerate(solids):
                boxes.append((f"{core.id}/step/{i}", box_between(low, high)))
            if len(details.floor_landing) >= 3:
                for i, solid in enumerate(_strips(Polygon(details.floor_landing))):
                    boxes.append((f"{core.id}/ground/{i}", solid))
        else:
            (x0, y0, _), (x1, y1, _) = details.cabin
            boxes.append((f"{core.id}/ground", box_between((x0, y0, -FLOOR_DEPTH), (x1, y1, 0.0))))
    return boxes


def _strips(polygon: Polygon) -> list[Box]:
    """Cut a polygon into upright strips at its corners; exact where its sides are upright or level."""
    rings = [polygon.exterior, *polygon.interiors]
    xs = sorted({round(float(x), 6) for ring in rings for x, _ in ring.coords})
    _, low_y, _, high_y = polygon.bounds
    boxes = []
    for x0, x1 in itertools.pairwise(xs):
        cut = polygon.intersection(shapely_box(x0, low_y - 1.0, x1, high_y + 1.0))
        parts = [cut] if cut.geom_type == "Polygon" else list(getattr(cut, "geoms", []))
        for part in parts:
            if part.geom_type == "Polygon" and part.area > 1e-6:
                _, y0, _, y1 = part.bounds
                boxes.append(box_between((x0, y0, -FLOOR_DEPTH), (x1, y1, 0.0)))
    return boxes


class Colliders:
    """What stops a body at each node of a floor's model, the same in every physics format.

    Parameters
    ----------
    scene : FloorScene
    """

    def __init__(self, scene: FloorScene) -> None:
        self._items = {item.id: item for item in scene.objects}

    def of(self, node: Node, mesh: Mesh) -> tuple[Box, ...] | None:
        """Return the boxes that a node collides with, in the frame of its mesh, before its scale.

        Returns
        -------
        tuple of Box or None
            Empty where nothing stops anybody; None where the mesh itself does: walls, floors, stairs, windows.
        """
        item = self._items.get(node.id)
        if item is not None:
            if item.size[2] <= FLAT and item.mount == "floor":
                return ()
            return (Box((0.0, 0.0, 0.0), _unscaled(item.size, node.scale)),)
        if node.group == "doors":
            return tuple(box for surface in mesh.surfaces for box in boxes_of(surface))
        return None


def _unscaled(size: Size3, scale: Size3) -> Size3:
    return size[0] / scale[0], size[1] / scale[1], size[2] / scale[2]


def is_loose(item: SceneObject) -> bool:
    """Whether an object can be picked up and would stay where it is without being held."""
    return item.pickupable and item.mount in ("floor", "surface", "inside")


@dataclass(frozen=True, slots=True)
class _Content:
    """A loose object in the frame of what it lies in."""

    bounds: Bounds
    carried: bool


def loose_colliders(scene: FloorScene, catalogue: Catalogue | None = None) -> dict[str, tuple[Box, ...]]:
    """Return the collision boxes of the objects that share room with a loose object or carry one.

    Parameters
    ----------
    scene : FloorScene
    catalogue : Catalogue, optional
        The shipped one when it is left out.

    Returns
    -------
    dict of str to tuple of Box
        By object id, in the object's own frame. Objects that are left out have their whole box.

    Notes
    -----
    A cavity has its floor at the loose object's lower face and is open to the front, or above where the object stands
    out, so that it can be taken. What an asset's boxes do not carry gets a thin board.
    """
    known = catalogue or load_catalogue()
    loose = [item for item in scene.objects if is_loose(item)]
    if not loose:
        return {}
    centers = np.array([item.position for item in loose])
    reach = np.array([np.hypot(item.size[0], item.size[1]) / 2 for item in loose])
    colliders = {}
    for item in scene.objects:
        own = float(np.hypot(item.size[0], item.size[1])) / 2
        away = np.hypot(centers[:, 0] - item.position[0], centers[:, 1] - item.position[1])
        near = np.flatnonzero(away < reach + own)
        contents = []
        for other in (loose[i] for i in near.tolist()):
            carried = other.parent == item.id
            content = _Content(_bounds_in(item, other), carried)
            inside = carried or (
                _volume(other) < _volume(item)
                and item.parent != other.id
                and _overlap(content.bounds, _own_bounds(item))
            )
            if other is not item and inside:
                contents.append(content)
        if contents:
            colliders[item.id] = tuple(_carved(item, known, contents))
    return colliders


def _volume(item: SceneObject) -> float:
    return item.size[0] * item.size[1] * item.size[2]


def _own_bounds(item: SceneObject) -> Bounds:
    w, d, h = (value / 2 for value in item.size)
    return -w, -d, -h, w, d, h


def _bounds_in(host: SceneObject, other: SceneObject) -> Bounds:
    """Return the box around another object in the host's frame."""
    turn = np.radians(other.rotation - host.rotation)
    c, s = abs(float(np.cos(turn))), abs(float(np.sin(turn)))
    w, d, h = (value / 2 for value in other.size)
    half = (w * c + d * s, w * s + d * c, h)
    angle = np.radians(-host.rotation)
    dx, dy = other.position[0] - host.position[0], other.position[1] - host.position[1]
    x = float(dx * np.cos(angle) - dy * np.sin(angle))
    y = float(dx * np.sin(angle) + dy * np.cos(angle))
    z = other.position[2] - host.position[2]
    return x - half[0], y - half[1], z - half[2], x + half[0], y + half[1], z + half[2]


def _overlap(one: Bounds, other: Bounds) -> bool:
    return all(min(one[k + 3], other[k + 3]) - max(one[k], other[k]) > DEEP for k in range(3))


def _carved(item: SceneObject, catalogue: Catalogue, contents: Sequence[_Content]) -> list[Box]:
    parts = _asset_boxes(item, catalogue)
    for content in contents:
        parts = [rest for part in parts for rest in _without(part, content.bounds)]
    for content in contents:
        x0, y0, z0, x1, y1, _ = content.bounds
        rests = content.carried and z0 < item.size[2] / 2 + LEVEL
        if rests and not any(_carries(part, content.bounds) for part in parts):
            parts.append((x0, y0, z0 - SHELF, x1, y1, z0))
    return [
        Box(
            ((part[0] + part[3]) / 2, (part[1] + part[4]) / 2, (part[2] + part[5]) / 2),
            (part[3] - part[0], part[4] - part[1], part[5] - part[2]),
        )
        for part in parts
    ]


def _asset_boxes(item: SceneObject, catalogue: Catalogue) -> list[Bounds]:
    """Return the boxes of an object's asset at the object's size."""
    asset = catalogue.assets.get(item.asset)
    if asset is None:
        return [_own_bounds(item)]
    scale = [mine / its for mine, its in zip(item.size, asset.size)]
    found = []
    for box in collision_boxes(asset):
        low = [(c - s / 2) * k for c, s, k in zip(box.center, box.size, scale)]
        high = [(c + s / 2) * k for c, s, k in zip(box.center, box.size, scale)]
        found.append((low[0], low[1], low[2], high[0], high[1], high[2]))
    return found


def _carries(part: Bounds, content: Bounds) -> bool:
    across = min(part[3], content[3]) - max(part[0], content[0])
    deep = min(part[4], content[4]) - max(part[1], content[1])
    area = (content[3] - content[0]) * (content[4] - content[1])
    return abs(part[5] - content[2]) < LEVEL and across > 0 and deep > 0 and across * deep > 0.6 * area


def _without(part: Bounds, content: Bounds) -> list[Bounds]:
    """Cut a content's cavity out of a box; at most five boxes are left."""
    if not _overlap(part, content):
        return [part]
    out_above = content[5] > part[5] - DEEP
    low = [content[0] - PLAY, content[1] - PLAY, content[2]]
    high = [content[3] + PLAY, content[4] + PLAY if out_above else part[4], part[5] if out_above else content[5] + PLAY]
    rest: list[Bounds] = []
    core = list(part)
    # Level cuts first: what carries stays one board below the whole cavity.
    for axis in (2, 0, 1):
        for edge, inner in ((axis, low[axis]), (axis + 3, high[axis])):
            lower = edge < 3
            outside = inner - core[edge] if lower else core[edge] - inner
            if outside > DEEP:
                piece = list(core)
                piece[edge + 3 if lower else edge - 3] = inner
                rest.append((piece[0], piece[1], piece[2], piece[3], piece[4], piece[5]))
            if outside > 0:
                core[edge] = inner
    return rest
