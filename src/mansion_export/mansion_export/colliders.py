"""Boxes that stand for floors, steps, furniture and door leaves where something collides with them."""

import itertools

import numpy as np
from shapely.geometry import Polygon, box

from mansion_export.model import Mesh, Node
from mansion_export.solids import Box, box_between
from mansion_msgs_py.scene import FloorScene, SceneObject, StairDetails

__all__ = ["collision_box", "ground_boxes"]

FLAT = 0.05
"""Lower objects, rugs say, stop nobody; metres."""

FLOOR_DEPTH = 0.2
"""Thickness of the ground below the finished floor, metres."""


def ground_boxes(scene: FloorScene) -> list[tuple[str, Box]]:
    """The ground of rooms, landings and lift cabins, and the steps of stairs, as upright boxes."""
    boxes = []
    for room in scene.rooms:
        for i, solid in enumerate(_strips(Polygon(room.polygon, room.holes), room.kind == "stair")):
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


def _strips(polygon: Polygon, skip: bool = False) -> list[Box]:
    """Cut a polygon into upright strips at its corners; exact where its sides are upright or level."""
    if skip:
        return []
    rings = [polygon.exterior, *polygon.interiors]
    xs = sorted({round(float(x), 6) for ring in rings for x, _ in ring.coords})
    _, low_y, _, high_y = polygon.bounds
    boxes = []
    for x0, x1 in itertools.pairwise(xs):
        cut = polygon.intersection(box(x0, low_y - 1.0, x1, high_y + 1.0))
        parts = [cut] if cut.geom_type == "Polygon" else list(getattr(cut, "geoms", []))
        for part in parts:
            if part.geom_type == "Polygon" and part.area > 1e-6:
                _, y0, _, y1 = part.bounds
                boxes.append(box_between((x0, y0, -FLOOR_DEPTH), (x1, y1, 0.0)))
    return boxes


def collision_box(node: Node, mesh: Mesh, item: SceneObject | None) -> Box | None:
    """Return the box of an object or door leaf in its body's frame, if it stops anybody."""
    if item is not None:
        if item.size[2] <= FLAT and item.mount == "floor":
            return None
        return Box((0.0, 0.0, 0.0), item.size)
    if node.group == "doors" and "/leaf" in node.id:
        points = np.concatenate([surface.vertices for surface in mesh.surfaces])
        low, high = points.min(0), points.max(0)
        center, size = (low + high) / 2, high - low
        return Box(tuple(center.tolist()), tuple(size.tolist()))
    return None
