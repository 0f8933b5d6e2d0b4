"""Routes through a building: a graph of doors and cores, with walks, lifts and stairs as edges."""

import heapq
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import combinations
from math import dist

from mansion_geometry.doorways import is_passable, is_walkway
from mansion_msgs_py.scene import FloorScene
from mansion_msgs_py.shapes import Point

__all__ = ["Leg", "Ride", "RouteGraph"]

DOOR_COST = 5.0
"""Seconds for a door that has to be opened first."""


@dataclass(frozen=True)
class Leg:
    """One edge of a route: a walk to a door or a core (`via`), or a ride with the core `via`."""

    kind: str
    floor: int
    to_floor: int
    via: str
    seconds: float
    end: Point


@dataclass(frozen=True)
class Ride:
    """What a core costs between two floors it serves, seconds."""

    core: str
    kind: str
    start: int
    end: int
    seconds: float


Node = tuple[int, str]
_START: Node = (0, "<start>")


class RouteGraph:
    """Doors and core entrances of all floors, joined within rooms by walks and between floors by rides.

    Parameters
    ----------
    scenes : iterable of FloorScene
    rides : iterable of Ride
    speed : float
        Walking speed, metres a second.
    """

    def __init__(self, scenes: Iterable[FloorScene], rides: Iterable[Ride], speed: float) -> None:
        self.speed = speed
        self.places: dict[Node, Point] = {}
        self._rooms: dict[str, list[Node]] = {}
        self._edges: dict[Node, list[tuple[Node, str, float]]] = {}
        self._leaves: dict[Node, bool] = {}
        for scene in scenes:
            self._add_floor(scene)
        for ride in rides:
            start, end = (ride.start, ride.core), (ride.end, ride.core)
            if start in self.places and end in self.places:
                self._edges[start].append((end, ride.kind, ride.seconds))

    def _add_floor(self, scene: FloorScene) -> None:
        cores = {core.id for core in scene.cores}
        doors = {door.id: door for door in scene.doors}
        for core in scene.cores:
            node = (scene.floor, core.id)
            self.places[node] = (core.entrance[0], core.entrance[1])
            self._edges[node] = []
            for name in doors[core.door].rooms:
                if name is not None and name != core.id:
                    self._rooms.setdefault(name, []).append(node)
        for door in scene.doors:
            if not is_walkway(door, cores):
                continue
            node = (scene.floor, door.id)
            (ax, ay), (bx, by) = door.segment
            self.places[node] = ((ax + bx) / 2, (ay + by) / 2)
            self._edges[node] = []
            self._leaves[node] = not is_passable(door)
            for name in door.rooms:
                self._rooms.setdefault(str(name), []).append(node)
        for room in scene.rooms:
            for a, b in combinations(self._rooms.get(room.id, []), 2):
                seconds = dist(self.places[a], self.places[b]) / self.speed
                self._edges[a].append((b, "walk", seconds))
                self._edges[b].append((a, "walk", seconds))

    def route(
        self, start: tuple[int, str, Point], goal: tuple[int, str, Point], is_open: Mapping[str, bool]
    ) -> list[Leg] | None:
        """Return the legs of the quickest route, or ``None``.

        Parameters
        ----------
        start, goal : (floor, room, point)
        is_open : mapping
            Door id to whether it stands open, for doors that are not as in their scene.
        """
        end: Node = (goal[0], "")
        costs: dict[Node, float] = {}
        heap: list[tuple[float, Node, Node, str]] = []
        came: dict[Node, tuple[Node, str]] = {}
        if start[:2] == goal[:2]:
            heapq.heappush(heap, (dist(start[2], goal[2]) / self.speed, end, _START, "walk"))
        for node in self._rooms.get(start[1], []):
            seconds = dist(start[2], self.places[node]) / self.speed
            heapq.heappush(heap, (seconds, node, _START, "walk"))
        last = set(self._rooms.get(goal[1], []))
        while heap:
            cost, node, before, kind = heapq.heappop(heap)
            if node in costs:
                continue
            costs[node], came[node] = cost, (before, kind)
            if node == end:
                break
            if self._leaves.get(node) is not None and not is_open.get(node[1], not self._leaves[node]):
                cost += DOOR_COST
            for after, how, seconds in self._edges[node]:
                if after not in costs:
                    heapq.heappush(heap, (cost + seconds, after, node, how))
            if node in last:
                seconds = dist(self.places[node], goal[2]) / self.speed
                heapq.heappush(heap, (cost + seconds, end, node, "walk"))
        return self._legs(end, goal, start[0], costs, came) if end in costs else None

    def _legs(
        self,
        end: Node,
        goal: tuple[int, str, Point],
        floor: int,
        costs: dict[Node, float],
        came: dict[Node, tuple[Node, str]],
    ) -> list[Leg]:
        nodes: list[Node] = [end]
        while (before := came[nodes[-1]][0]) != _START:
            nodes.append(before)
        legs, passed = [], 0.0
        for node in reversed(nodes):
            place = goal[2] if node == end else self.places[node]
            seconds = costs[node] - passed
            legs.append(Leg(came[node][1], floor, node[0], node[1], seconds, place))
            floor, passed = node[0], costs[node]
        return legs
