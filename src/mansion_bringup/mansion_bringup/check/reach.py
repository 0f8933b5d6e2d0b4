"""Checks that a robot can get everywhere: the walkable region eroded by its radius, as exact polygons, not a grid."""

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass

import networkx as nx
import numpy as np
import shapely
from numpy.typing import NDArray
from shapely import LineString, Point, Polygon, STRtree
from shapely.geometry.base import BaseGeometry

from mansion_bringup.check.fault import Fault
from mansion_bringup.check.shapes import net_area, vertical
from mansion_geometry.doorways import PASSAGE_DEPTH, is_walkway
from mansion_geometry.floor_regions import disc_positions_among, strip
from mansion_geometry.object_footprints import WALKABLE_HEIGHT, footprints, oblique_margin
from mansion_geometry.robot_body import BODY_RADIUS, CLEARANCE, ROBOT_RADIUS, ROBOT_REACH
from mansion_msgs_py.scene import FloorScene, SceneObject

__all__ = ["Walk", "check_reach", "floor_reach", "walkable"]

SLACK = 0.03
"""Metres by which what is near may lie off, for the grid of 0.05 m on which furniture is placed."""

ENTRANCE_REACH = 0.8
"""How near to a core's entrance pose the robot must get, metres."""


@dataclass(frozen=True)
class Walk:
    """The pieces of a floor that the robot's centre can move in."""

    pieces: list[Polygon]
    tree: STRtree

    def near(self, shape: BaseGeometry, distance: float) -> set[int]:
        """Numbers of the pieces within `distance` of `shape`."""
        found = self.tree.query(shape, predicate="dwithin", distance=distance)
        return set(found.tolist())

    def all_near(self, shapes: "NDArray[np.object_]", distance: float, reached: set[int]) -> "NDArray[np.bool_]":
        """Whether each of some shapes is within `distance` of a piece that is reached."""
        numbers, pieces = self.tree.query(shapes, predicate="dwithin", distance=distance)
        near = np.zeros(len(shapes), dtype=bool)
        near[numbers[np.isin(pieces, list(reached))]] = True
        return near


def check_reach(
    scenes: Sequence[FloorScene],
    walks: Mapping[int, Walk] | None = None,
    judge: Callable[[FloorScene, Walk, set[int]], Iterable[Fault]] | None = None,
) -> Iterator[Fault]:
    """Yield what cannot be reached from the building's entrance.

    Parameters
    ----------
    scenes : sequence of FloorScene
    walks : mapping of int to Walk, optional
        What `walkable` returned for each floor, where that is known.
    judge : callable, optional
        Used instead of `floor_reach`, by a caller that remembers what it returned.
    """
    graph: nx.Graph[tuple[int, int] | str] = nx.Graph()
    walks = walks or {scene.floor: walkable(scene) for scene in scenes}
    starts: list[tuple[int, int]] = []
    for scene in scenes:
        walk = walks[scene.floor]
        graph.add_nodes_from((scene.floor, piece) for piece in range(len(walk.pieces)))
        for core in scene.cores:
            for piece in walk.near(Point(core.entrance[:2]), ENTRANCE_REACH):
                graph.add_edge(core.id, (scene.floor, piece))
        for door in scene.doors:
            if None in door.rooms and door.kind != "garage" and scene.floor == 1:
                starts += [(1, piece) for piece in walk.near(LineString(door.segment), 0.5)]
    if not starts:
        yield Fault("ENTRANCE", "floor 1", "no door leads outside from where a robot can stand")
        return
    reached = set().union(*(nx.node_connected_component(graph, start) for start in starts))
    for scene in scenes:
        pieces = {node[1] for node in reached if not isinstance(node, str) and node[0] == scene.floor}
        yield from (judge or floor_reach)(scene, walks[scene.floor], pieces)


def walkable(scene: FloorScene) -> Walk:
    """Return where the robot's centre can be on a floor."""
    rooms = [net_area(room) for room in scene.rooms if room.kind not in ("stair", "elevator")]
    cores = [core.id for core in scene.cores]
    inner = [door for door in scene.doors if door.is_open or door.kind != "entrance"]
    passages = [strip(door.segment, PASSAGE_DEPTH) for door in inner if is_walkway(door, cores)]
    solid = [item for item in scene.objects if _obstructs(item)]
    # What stands on a slant takes a little more floor from the robot.
    obstacles = shapely.buffer(footprints(solid), [oblique_margin(item) for item in solid])
    pieces = disc_positions_among([*rooms, *passages], obstacles, BODY_RADIUS, quad_segs=16)
    return Walk(pieces, STRtree(pieces))


def _obstructs(item: SceneObject) -> bool:
    low, high = vertical(item)
    return item.mount in ("floor", "wall") and low < CLEARANCE and high > WALKABLE_HEIGHT


def floor_reach(scene: FloorScene, walk: Walk, reached: set[int]) -> Iterator[Fault]:
    """Yield what cannot be reached on a floor, where a robot gets to some of its pieces.

    Parameters
    ----------
    reached : set of int
        Numbers of the pieces of `walk`.
    """
    if not reached:
        yield Fault("FLOOR_UNREACHABLE", f"floor {scene.floor}", "no stair or lift leads to it")
        return
    rooms = [room for room in scene.rooms if room.kind not in ("stair", "elevator")]
    inside = shapely.buffer(np.array([net_area(room) for room in rooms], dtype=object), -0.15)
    for room, near in zip(rooms, walk.all_near(inside, 0.0, reached), strict=True):
        if not near:
            yield Fault("ROOM_UNREACHABLE", room.id, "a robot cannot get in from the entrance")
    standing = [item for item in scene.objects if item.mount == "floor" and item.size[2] > WALKABLE_HEIGHT]
    beside = walk.all_near(footprints(standing), ROBOT_RADIUS + ROBOT_REACH + SLACK, reached)
    for item, near in zip(standing, beside, strict=True):
        if not near:
            yield Fault("OBJECT_UNREACHABLE", item.id, "a robot cannot get near it")
    yield from _spawn(scene, walk, reached)


def _spawn(scene: FloorScene, walk: Walk, reached: set[int]) -> Iterator[Fault]:
    where = f"floor {scene.floor}"
    if scene.spawn is None:
        yield Fault("SPAWN", where, "has no spawn pose")
    elif not walk.near(Point(scene.spawn.x, scene.spawn.y), SLACK) & reached:
        yield Fault("SPAWN", where, "the spawn pose is not in a free, reachable place")
