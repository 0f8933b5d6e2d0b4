"""Straight lanes through a region of free floor: shortest paths that keep clear of its edge, with few corners.

Paths are Dijkstra's on a grid (Dijkstra, E. W. 1959, A note on two problems in connexion with graphs), where a step
near the edge costs more; then each run between forks is replaced by the fewest segments that are about as clear.
"""

import heapq
import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from itertools import pairwise

import numpy as np
import shapely
from shapely.geometry import LineString, Polygon

from mansion_msgs_py.shapes import Point, Segment

__all__ = ["FreeRegion", "central_point"]

STEPS = (0.1, 0.05, 0.025)
"""Grids that are tried, metres: a finer one where the coarser misses a passage."""

AMPLE = 0.4
"""Clearance beyond which more is no better, metres."""

PENALTY = 3.0
"""How many times its length a segment at the edge costs more."""


@dataclass(frozen=True, slots=True)
class FreeRegion:
    """A connected region of the floor where a robot's centre may be.

    Attributes
    ----------
    shape : Polygon
    """

    shape: Polygon
    _boundary: shapely.Geometry = field(init=False)

    def __post_init__(self) -> None:
        object.__setattr__(self, "_boundary", self.shape.boundary)
        shapely.prepare(self.shape)
        shapely.prepare(self._boundary)

    def contains(self, point: Point) -> bool:
        """Tell whether a point is in the region."""
        return bool(shapely.covers(self.shape, shapely.Point(point)))

    def connects(self, a: Point, b: Point) -> bool:
        """Tell whether the segment between two points stays in the region."""
        return bool(shapely.covers(self.shape, LineString([a, b])))

    def clearance(self, a: Point, b: Point) -> float:
        """Return how near the segment between two points comes to the region's edge, metres."""
        return float(shapely.distance(LineString([a, b]), self._boundary))

    def lane_tree(self, root: Point, goals: Sequence[Point]) -> list[Segment]:
        """Join points by segments that branch from one of them.

        Parameters
        ----------
        root : Point
        goals : sequence of Point
            All in the region.

        Returns
        -------
        list of Segment
            A goal that not even the finest of `STEPS` reaches is left out.
        """
        if len(goals) <= 2 and all(self._unobstructed(root, goal) for goal in goals):
            return [(root, goal) for goal in goals]
        best: dict[int, list[int]] = {}
        grid = _Grid(self, STEPS[0], [root, *goals])
        for step in STEPS:
            grid = _Grid(self, step, [root, *goals])
            best = grid.chains()
            if len(best) == len(goals):
                break
        return self._straightened(grid.points, best)

    def _unobstructed(self, a: Point, b: Point) -> bool:
        return self.connects(a, b) and self.clearance(a, b) > 0.0

    def _straightened(self, points: list[Point], chains: dict[int, list[int]]) -> list[Segment]:
        """Keep ends and forks of the chains, and between them only what straight segments need."""
        after: dict[int, int] = {}
        for chain in chains.values():
            after.update(pairwise(chain))
        forks: dict[int, int] = {}
        for node in after.values():
            forks[node] = forks.get(node, 0) + 1
        keep = {node for node, count in forks.items() if count > 1} | set(chains) | {0}
        segments = []
        for start in sorted(keep - {0}):
            chain = [start]
            while chain[-1] not in keep or len(chain) == 1:
                chain.append(after[chain[-1]])
            shortened = self._shortened([points[node] for node in chain])
            segments += list(pairwise(shortened))
        return segments

    def _shortened(self, chain: list[Point]) -> list[Point]:
        """Leave out points as long as the path stays about as far from the edge as it was."""
        kept, i = [chain[0]], 0
        beside = [self.clearance(a, b) for a, b in pairwise(chain)]
        while i < len(chain) - 1:
            j = len(chain) - 1
            while j > i + 1 and not self._as_clear(chain[i], chain[j], min(beside[i:j])):
                j -= 1
            kept.append(chain[j])
            i = j
        return kept

    def _as_clear(self, a: Point, b: Point, least: float) -> bool:
        return self.connects(a, b) and self.clearance(a, b) >= 0.7 * min(least, AMPLE)


def central_point(shape: Polygon, step: float = 0.1) -> Point:
    """Return a point with ample clearance, near the centroid; metres, rounded to millimetres."""
    points = _lattice(shape, step)
    if not len(points):
        point = shape.representative_point()
        return (round(point.x, 3), round(point.y, 3))
    room = shapely.distance(shapely.points(points), shape.boundary)
    middle = shape.centroid
    away = np.hypot(points[:, 0] - middle.x, points[:, 1] - middle.y)
    away[room < 0.75 * min(float(room.max()), 1.0)] = np.inf
    x, y = points[int(np.argmin(np.round(away, 6)))].tolist()
    return (x, y)


def _lattice(shape: Polygon, step: float) -> np.ndarray[tuple[int, ...], np.dtype[np.float64]]:
    """Return the points of a grid, on multiples of its step, that lie in a polygon."""
    x0, y0, x1, y1 = shape.bounds
    xs = np.arange(math.ceil(x0 / step), math.floor(x1 / step) + 1) * step
    ys = np.arange(math.ceil(y0 / step), math.floor(y1 / step) + 1) * step
    grid = np.stack(np.meshgrid(xs, ys), axis=-1).reshape(-1, 2).round(3)
    shapely.prepare(shape)
    inside: np.ndarray[tuple[int, ...], np.dtype[np.float64]] = grid[shapely.contains_xy(shape, grid[:, 0], grid[:, 1])]
    return inside


class _Grid:
    """A graph over a region: given points first, the root foremost, then the grid's."""

    def __init__(self, region: FreeRegion, step: float, given: Sequence[Point]) -> None:
        lattice = _lattice(region.shape, step)
        self.points: list[Point] = [*given, *((x, y) for x, y in lattice.tolist())]
        self._given = len(given)
        places = np.array(self.points)
        room = shapely.distance(shapely.points(places), region._boundary)
        pairs = self._pairs(lattice, np.array(given), step)
        segments = shapely.linestrings(np.stack([places[pairs[:, 0]], places[pairs[:, 1]]], axis=1))
        near = np.minimum(room[pairs[:, 0]], room[pairs[:, 1]])
        is_open = near > 2 * step
        is_open[~is_open] = shapely.covers(region.shape, segments[~is_open])
        pairs, near = pairs[is_open], near[is_open]
        length = np.hypot(*(places[pairs[:, 0]] - places[pairs[:, 1]]).T)
        tight = np.clip(1.0 - near / AMPLE, 0.0, 1.0)
        cost = length * (1.0 + PENALTY * tight**2)
        self._next: list[list[tuple[int, float]]] = [[] for _ in self.points]
        for (a, b), value in zip(pairs.tolist(), cost.tolist()):
            self._next[a].append((b, value))
            self._next[b].append((a, value))

    def _pairs(
        self,
        lattice: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
        given: np.ndarray[tuple[int, ...], np.dtype[np.float64]],
        step: float,
    ) -> np.ndarray[tuple[int, ...], np.dtype[np.int64]]:
        cells = np.rint(lattice / step).astype(int)
        index = {(i, j): n + self._given for n, (i, j) in enumerate(cells.tolist())}
        found = [
            (n, other)
            for (i, j), n in index.items()
            for di, dj in ((1, 0), (0, 1), (1, 1), (1, -1))
            if (other := index.get((i + di, j + dj))) is not None
        ]
        for k, point in enumerate(given):
            if len(lattice):
                away = np.hypot(*(lattice - point).T)
                near = np.flatnonzero(away < 2.1 * step) + self._given
                found += [(k, n) for n in near.tolist()]
        return np.array(found, dtype=np.int64).reshape(-1, 2)

    def chains(self) -> dict[int, list[int]]:
        """Return, for each given point but the first, the nodes from it to the first."""
        cost = [math.inf] * len(self.points)
        before = [0] * len(self.points)
        cost[0] = 0.0
        queue = [(0.0, 0)]
        while queue:
            value, node = heapq.heappop(queue)
            if value > cost[node]:
                continue
            for other, more in self._next[node]:
                if value + more < cost[other] - 1e-12:
                    cost[other], before[other] = value + more, node
                    heapq.heappush(queue, (value + more, other))
        found = {}
        for goal in range(1, self._given):
            if cost[goal] < math.inf:
                chain = [goal]
                while chain[-1]:
                    chain.append(before[chain[-1]])
                found[goal] = chain
        return found
