"""Clear floor: what is left around what stands in a room, and wall objects removed that obstruct doorways or paths."""

from collections.abc import Sequence
from typing import Final

import msgspec
import shapely
from shapely.geometry import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from mansion_geometry.floor_regions import disc_positions, largest_first
from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprint, footprints, oblique_margin
from mansion_geometry.rings import polygon_parts
from mansion_geometry.robot_body import BODY_RADIUS, CLEARANCE, ROBOT_RADIUS, ROBOT_REACH
from mansion_msgs_py.placement import PlacementOpening
from mansion_msgs_py.scene import SceneObject, SceneRoom
from mansion_scene.structure.dimensions import DOOR_HEIGHT
from mansion_scene.structure.regions import ring_points

__all__ = ["clear_of_ways", "floor_around"]

_DOORWAY = 0.8  # metres in front of a door that stay free
_REACH = ROBOT_RADIUS + ROBOT_REACH  # from the robot's centre to what it approaches
_ROUND = 16  # segments of a quarter of a circle: with few, the robot is narrower than it is


def clear_of_ways(
    hung: Sequence[SceneObject], standing: Sequence[SceneObject], net: Polygon, doors: Sequence[PlacementOpening]
) -> list[SceneObject]:
    """Return wall objects without those that hang low beside a door, or cut off a door or furniture.

    Parameters
    ----------
    hung : sequence of SceneObject
        Decoration of a room; only wall objects, and what lies on them, are removed.
    standing : sequence of SceneObject
        Furniture of the room.
    net : Polygon
        The room between the faces of its walls.
    doors : sequence of PlacementOpening
        Doors on the boundary of `net`.
    """
    dropped = _in_doorways(hung, net, doors)
    deep = [item for item in hung if item.id not in dropped and _in_the_way(item)]
    if deep:
        dropped |= _cutting_off(deep, standing, net, doors)
    return [item for item in hung if item.id not in dropped and item.parent not in dropped]


def _in_the_way(item: SceneObject) -> bool:
    low = item.bottom
    return item.mount == "wall" and low < CLEARANCE


def _in_doorways(hung: Sequence[SceneObject], net: Polygon, doors: Sequence[PlacementOpening]) -> set[str]:
    ways = shapely.union_all(
        [LineString(door.segment).buffer(_DOORWAY, cap_style="flat") for door in doors]
    ).intersection(net)
    shapely.prepare(ways)
    return {
        item.id
        for item in hung
        if item.mount == "wall" and item.bottom < DOOR_HEIGHT and footprint(item).intersection(ways).area > 1e-4
    }


def _cutting_off(
    deep: Sequence[SceneObject], standing: Sequence[SceneObject], net: Polygon, doors: Sequence[PlacementOpening]
) -> set[str]:
    """Return the ids to remove so that every goal is reached that could be reached without any of the objects."""
    upright = [item for item in standing if item.size[2] > WALKABLE_HEIGHT]
    goals = [*footprints(upright), *(LineString(door.segment) for door in doors)]
    free = net.difference(shapely.union_all(_bodies(upright)))
    shapes = {item.id: body for item, body in zip(deep, _bodies(deep), strict=True)}
    wanted: list[bool] = []
    dropped: set[str] = set()
    while len(dropped) < len(shapes):
        left = {name: shape for name, shape in shapes.items() if name not in dropped}
        reached = _reached(free.difference(shapely.union_all(list(left.values()))), goals)
        if all(reached):
            break
        wanted = wanted or _reached(free, goals)
        lost = next((k for k, ok in enumerate(reached) if wanted[k] and not ok), None)
        if lost is None:
            break
        dropped.add(min(left, key=lambda name: (left[name].distance(goals[lost]), name)))
    return dropped


def _bodies(items: Sequence[SceneObject]) -> list[Polygon]:
    """Return the floor that each object takes from the robot."""
    return list(shapely.buffer(footprints(items), [oblique_margin(item) for item in items], quad_segs=_ROUND))


def _reached(free: BaseGeometry, goals: Sequence[BaseGeometry]) -> list[bool]:
    """Tell which goals the robot reaches from the largest connected region in which its centre can move."""
    pieces = largest_first(disc_positions(free, BODY_RADIUS, quad_segs=_ROUND))
    if not pieces:
        return [False] * len(goals)
    largest = pieces[0]
    return [bool(near) for near in shapely.distance(largest, list(goals)) <= _REACH]


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
