"""Straight walls that two polygons share.

A wall is shared where an edge of one polygon and an edge of the other run alongside each other, in opposite
directions around their polygons, at most `gap` apart.
"""

from collections.abc import Iterable
from dataclasses import dataclass

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from mansion_geometry.rings import Points, oriented, polygon_parts

__all__ = ["SharedWall", "edge_array", "longest_wall", "ring_edges", "shared_walls", "total_length"]

PARALLEL = float(np.sin(np.radians(2.0)))


@dataclass(frozen=True)
class SharedWall:
    """One straight run of shared wall; `start` to `end` runs along the first polygon's boundary."""

    start: tuple[float, float]
    end: tuple[float, float]

    @property
    def length(self) -> float:
        """Metres."""
        return float(np.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1]))


def ring_edges(rings: Iterable[Points]) -> NDArray[np.float64]:
    """Return all edges of `rings` as rows x0, y0, x1, y1, collinear neighbours joined."""
    rows = []
    for ring in rings:
        points = _corners(np.asarray(ring, dtype=float))
        rows.append(np.hstack([points, np.roll(points, -1, axis=0)]))
    return np.vstack(rows) if rows else np.zeros((0, 4))


def _corners(points: NDArray[np.float64]) -> NDArray[np.float64]:
    """Drop the points on straight lines, all at once, then again until none is left."""
    while len(points) > 3:
        before = points - np.roll(points, 1, axis=0)
        after = np.roll(points, -1, axis=0) - points
        turn = np.abs(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0])
        scale = np.hypot(*before.T) * np.hypot(*after.T)
        idle = turn <= 1e-6 * scale + 1e-12
        idle &= ~np.roll(idle, 1)
        if not idle.any() or idle.sum() > len(points) - 3:
            break
        points = points[~idle]
    return points


def edge_array(shape: BaseGeometry) -> NDArray[np.float64]:
    """Return the edges of a polygon or multipolygon, its inside on their left."""
    rings: list[Points] = []
    for part in polygon_parts(shape):
        rings.append(oriented(shapely.get_coordinates(part.exterior)[:-1]))
        rings.extend(oriented(shapely.get_coordinates(line)[:-1], ccw=False) for line in part.interiors)
    return ring_edges(rings)


def shared_walls(first: NDArray[np.float64], second: NDArray[np.float64], gap: float = 0.01) -> list[SharedWall]:
    """Return the straight runs of `first`'s edges that `second`'s edges accompany.

    Parameters
    ----------
    first, second : (n, 4) arrays
        Edges as `edge_array` returns them.
    gap : float
        Largest distance between the two edges, metres; runs closer than this along a line are joined.

    Examples
    --------
    >>> from shapely.geometry import box
    >>> [w.length for w in shared_walls(edge_array(box(0, 0, 2, 2)), edge_array(box(2, 1, 4, 3)))]
    [1.0]
    """
    walls: list[SharedWall] = []
    if not len(first) or not len(second):
        return walls
    start, end = second[:, :2], second[:, 2:]
    along = end - start
    length = np.hypot(along[:, 0], along[:, 1])
    for x0, y0, x1, y1 in first.tolist():
        size = float(np.hypot(x1 - x0, y1 - y0))
        if size < 1e-9:
            continue
        ux, uy = (x1 - x0) / size, (y1 - y0) / size
        lo_t = (end[:, 0] - x0) * ux + (end[:, 1] - y0) * uy
        hi_t = (start[:, 0] - x0) * ux + (start[:, 1] - y0) * uy
        lo, hi = np.maximum(lo_t, 0.0), np.minimum(hi_t, size)
        lo_d = (end[:, 1] - y0) * ux - (end[:, 0] - x0) * uy
        hi_d = (start[:, 1] - y0) * ux - (start[:, 0] - x0) * uy
        span = np.where(hi_t - lo_t > 1e-12, hi_t - lo_t, 1.0)
        middle = lo_d + (hi_d - lo_d) * ((lo + hi) / 2 - lo_t) / span
        slant = np.abs(along[:, 1] * ux - along[:, 0] * uy)
        ok = (hi_t > lo_t) & (hi - lo > 1e-6) & (np.abs(middle) <= gap) & (slant <= PARALLEL * length)
        for a, b in _joined(sorted(zip(lo[ok].tolist(), hi[ok].tolist())), gap):
            walls.append(SharedWall((x0 + a * ux, y0 + a * uy), (x0 + b * ux, y0 + b * uy)))
    return walls


def _joined(spans: list[tuple[float, float]], gap: float) -> list[tuple[float, float]]:
    """Join sorted spans that touch within `gap`."""
    runs: list[tuple[float, float]] = []
    for a, b in spans:
        if runs and a <= runs[-1][1] + gap + 1e-6:
            runs[-1] = (runs[-1][0], max(runs[-1][1], b))
        else:
            runs.append((a, b))
    return runs


def longest_wall(walls: Iterable[SharedWall]) -> SharedWall | None:
    """Return the longest of `walls` (the first among equals), or None."""
    return max(walls, key=lambda wall: wall.length, default=None)


def total_length(walls: Iterable[SharedWall]) -> float:
    """Return the summed length of `walls` in metres."""
    return sum(wall.length for wall in walls)
