"""The floor that is left to furnish around what stands in a room already."""

from collections.abc import Sequence
from typing import Final

import msgspec
import shapely
from shapely.geometry import Polygon

from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprint
from mansion_geometry.rings import polygon_parts
from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_scene.structure.regions import ring_points

__all__ = ["floor_around"]

_HEAD: Final = 2.2
"""Height above which what hangs leaves furniture its place, metres."""

_GAP: Final = 0.005


def floor_around(room: SceneRoom, standing: Sequence[SceneObject]) -> SceneRoom:
    """Return a room whose net interior is the largest part of its floor that objects leave free."""
    shapes = [footprint(item).buffer(_GAP, join_style="mitre") for item in standing if _takes_floor(item)]
    if not shapes:
        return room
    free = Polygon(room.net_polygon, room.net_holes).difference(shapely.union_all(shapes))
    parts = polygon_parts(free)
    if not parts:
        return room
    largest = max(parts, key=lambda part: part.area)
    return msgspec.structs.replace(
        room, net_polygon=ring_points(largest.exterior), net_holes=[ring_points(hole) for hole in largest.interiors]
    )


def _takes_floor(item: SceneObject) -> bool:
    low = item.bottom
    return item.mount in ("floor", "wall") and item.size[2] > WALKABLE_HEIGHT and low < _HEAD
