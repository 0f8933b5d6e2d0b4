"""Collision shapes for physics engines: floors, steps, doors and furniture as boxes and convex hulls."""

import itertools
from collections.abc import Sequence
from typing import TypeAlias

import numpy as np
from shapely.geometry import Polygon
from shapely.geometry import box as shapely_box

from mansion_assets.catalogue import Catalogue, load_catalogue
from mansion_assets.convex import Box as Piece
from mansion_assets.convex import Convex, Hull
from mansion_assets.mass_properties import MassProperties, mass_properties
from mansion_assets.meshes import collision_pieces
from mansion_export.meshes.model import Mesh, Node
from mansion_export.meshes.solids import Box, box_between, box_scaled, boxes_of
from mansion_geometry.building_models import object_mass
from mansion_geometry.robot_body import FLAT
from mansion_msgs_py.scene import FloorScene, SceneObject, StairDetails
from mansion_msgs_py.shapes import Point3, Size3

__all__ = [
    "Colliders",
    "Shape",
    "bounds_of",
    "ground_boxes",
    "lies_flat",
    "mass_properties_of",
    "piece_shape",
    "shape_scaled",
]

FLOOR_DEPTH = 0.2
"""Thickness of the ground below the finished floor, metres."""

Shape: TypeAlias = Box | Hull
"""A convex shape that collides."""


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
    catalogue : Catalogue, optional
        Where the assets are, when they are not all in the shipped one.
    """

    def __init__(self, scene: FloorScene, catalogue: Catalogue | None = None) -> None:
        self._items = {item.id: item for item in scene.objects}
        self._assets = (catalogue or load_catalogue()).assets

    def of(self, node: Node, mesh: Mesh) -> tuple[Shape, ...] | None:
        """Return the convex shapes that a node collides with, in the frame of its mesh, before its scale.

        Returns
        -------
        tuple of Box or Hull, or None
            Empty where nothing stops anybody; None where the mesh itself does: walls, floors, stairs, windows.
        """
        item = self._items.get(node.id)
        if item is not None:
            if lies_flat(item):
                return ()
            return self.of_object(item)
        if node.group == "doors":
            return tuple(box for surface in mesh.surfaces for box in boxes_of(surface))
        return None

    def of_object(self, item: SceneObject) -> tuple[Shape, ...]:
        """Return the shapes of an object, however flat it is."""
        asset = self._assets.get(item.asset)
        if asset is None:
            return (Box((0.0, 0.0, 0.0), (1.0, 1.0, 1.0)),)
        return tuple(piece_shape(piece) for piece in collision_pieces(asset))

    def mass_of(self, item: SceneObject) -> float:
        """Return the mass of an object in kilograms: what its asset states, or by its size."""
        asset = self._assets.get(item.asset)
        return object_mass(item.size) if asset is None or asset.mass is None else asset.mass


def lies_flat(item: SceneObject) -> bool:
    """Whether an object is a covering of the floor that stops nobody."""
    return item.size[2] <= FLAT and item.mount == "floor"


def piece_shape(piece: Convex) -> Shape:
    """Return a collision piece of an asset as a shape."""
    return piece if isinstance(piece, Hull) else Box(piece.center, piece.size)


def shape_scaled(shape: Shape, scale: Size3) -> Shape:
    """Return a shape in a frame that is stretched along its axes."""
    if isinstance(shape, Hull):
        return Hull(shape.vertices * np.array(scale), shape.faces)
    return box_scaled(shape, scale)


def mass_properties_of(shapes: Sequence[Shape], mass: float) -> MassProperties:
    """Return the mass, centre and inertia of a body of one density that these shapes make up."""
    return mass_properties(
        [shape if isinstance(shape, Hull) else Piece(shape.center, shape.size) for shape in shapes], mass
    )


def bounds_of(shape: Shape) -> tuple[Point3, Point3]:
    """Return the lowest and the highest corner of an axis-aligned shape."""
    if isinstance(shape, Hull):
        low, high = shape.vertices.min(axis=0).tolist(), shape.vertices.max(axis=0).tolist()
        return (low[0], low[1], low[2]), (high[0], high[1], high[2])
    (x, y, z), (w, d, h) = shape.center, shape.size
    return (x - w / 2, y - d / 2, z - h / 2), (x + w / 2, y + d / 2, z + h / 2)
