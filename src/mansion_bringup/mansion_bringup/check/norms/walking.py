"""Walking distances on a storey: straight lines around the corners of rooms and through doors."""

import math
from collections.abc import Sequence
from typing import TypeAlias

import networkx as nx
import numpy as np
import shapely
from shapely import Polygon

from mansion_bringup.check.norms.premises import rooms_of
from mansion_bringup.check.shapes import room_area
from mansion_msgs_py.scene import Door, FloorScene, SceneRoom
from mansion_msgs_py.shapes import Point

__all__ = ["Place", "Ways", "exit_doors", "middle_of", "ways_of"]

Place: TypeAlias = str | tuple[str, int]

Ways: TypeAlias = "nx.Graph[Place]"
"""Doors by id and corners by (room, number), with the metres between those that see each other in a room."""

_ASIDE = 0.3
"""Metres by which a door's middle may lie off its room's polygon: it is on the centre line of the wall."""


def exit_doors(scene: FloorScene) -> list[str]:
    """Return the doors that lead out of a storey: into the open at the ground, into stairs elsewhere."""
    if scene.floor == 1:
        doors = [door.id for door in scene.doors if None in door.rooms and door.kind not in ("garage", "balcony")]
        return doors or [door.id for door in scene.doors if None in door.rooms]
    stairs = {core.door for core in scene.cores if core.type == "stair"}
    return [door.id for door in scene.doors if door.id in stairs]


def ways_of(scene: FloorScene, rooms: Sequence[SceneRoom] | None = None) -> Ways:
    """Return the ways on a storey, or through some of its rooms only."""
    ways: Ways = nx.Graph()
    for room in rooms_of(scene) if rooms is None else rooms:
        _add_room(ways, room, [door for door in scene.doors if room.id in door.rooms])
    return ways


def _add_room(ways: Ways, room: SceneRoom, doors: Sequence[Door]) -> None:
    """Add a room's corners and doors to `ways`, and the lines between those that see each other."""
    shape = room_area(room)
    corners = [*room.polygon, *(point for ring in room.holes for point in ring)]
    nodes: list[Place] = [*(door.id for door in doors), *((room.id, i) for i in range(len(corners)))]
    places: list[Point] = [*(middle_of(door) for door in doors), *corners]
    ways.add_nodes_from(nodes)
    first, second = np.triu_indices(len(nodes), 1)
    if not len(first):
        return
    points = np.asarray(places)
    lines = shapely.linestrings(np.stack([points[first], points[second]], axis=1))
    seen = shapely.covers(_roomy(shape), lines)
    for one, other in zip(first[seen].tolist(), second[seen].tolist()):
        ways.add_edge(nodes[one], nodes[other], weight=math.dist(places[one], places[other]))


def _roomy(shape: Polygon) -> Polygon:
    wide = shape.buffer(_ASIDE, join_style="mitre")
    shapely.prepare(wide)
    return wide


def middle_of(door: Door) -> Point:
    """Return the middle of a door's opening."""
    (x0, y0), (x1, y1) = door.segment
    return (x0 + x1) / 2, (y0 + y1) / 2
