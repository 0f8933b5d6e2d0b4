"""Rings (closed polygons as point lists) and their conversion to and from shapely.

A ring does not repeat its first point; metres; counter-clockwise unless said otherwise.
"""

from collections.abc import Iterable, Sequence

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry import MultiPolygon, Polygon
from shapely.geometry.base import BaseGeometry

from mansion_geometry.compiled import Bools, Floats

__all__ = [
    "as_polygon",
    "corner_points",
    "dominant_angle",
    "largest_polygon",
    "oriented",
    "points_inside_ring",
    "polygon_parts",
    "ring_of",
    "rotated",
    "signed_area",
]

Points = Sequence[Sequence[float]] | NDArray[np.float64]


def points_inside_ring(ring: Points, xs: Floats, ys: Floats) -> Bools:
    """Return whether each of many points, by its x and y, lies in a ring (even-odd rule)."""
    inside: Bools = np.zeros(len(xs), dtype=bool)
    ax, ay = ring[-1]
    for bx, by in ring:
        if ay != by:
            inside ^= ((ay > ys) != (by > ys)) & (xs < ax + (ys - ay) * (bx - ax) / (by - ay))
        ax, ay = bx, by
    return inside


def signed_area(ring: Points) -> float:
    """Return the shoelace area of `ring`: positive when it runs counter-clockwise.

    Examples
    --------
    >>> signed_area([(0, 0), (2, 0), (2, 1), (0, 1)])
    2.0
    """
    points = np.asarray(ring, dtype=float)
    if len(points) < 3:
        return 0.0
    x, y = points[:, 0], points[:, 1]
    return float(0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y))


def oriented(ring: Points, *, ccw: bool = True) -> list[tuple[float, float]]:
    """Return the points of `ring` in counter-clockwise (or clockwise) order."""
    points = [(float(p[0]), float(p[1])) for p in ring]
    return points if (signed_area(points) >= 0.0) == ccw else points[::-1]


def polygon_parts(shape: BaseGeometry) -> list[Polygon]:
    """Return the non-empty polygons in `shape`; lines and points are dropped."""
    if isinstance(shape, Polygon):
        return [] if shape.is_empty else [shape]
    parts: list[Polygon] = []
    for part in getattr(shape, "geoms", ()):
        parts.extend(polygon_parts(part))
    return parts


def as_polygon(ring: Points, holes: Iterable[Points] = ()) -> Polygon | MultiPolygon:
    """Return a valid shape for `ring` less `holes`; a self-crossing ring is repaired, a degenerate one empty."""
    if len(ring) < 3:
        return Polygon()
    shape = Polygon(ring, [h for h in holes if len(h) >= 3])
    if not shape.is_valid:
        shape = shape.buffer(0)
    parts = polygon_parts(shape)
    if len(parts) == 1:
        return parts[0]
    return MultiPolygon(parts) if parts else Polygon()


def largest_polygon(shape: BaseGeometry) -> Polygon:
    """Return the largest polygon in `shape`; an empty polygon if there is none."""
    return max(polygon_parts(shape), key=lambda part: part.area, default=Polygon())


def ring_of(line: BaseGeometry, *, ccw: bool = True) -> list[tuple[float, float]]:
    """Return a closed shapely line as a ring in the wanted order, without the repeated point."""
    return oriented(shapely.get_coordinates(line)[:-1], ccw=ccw)


def corner_points(ring: Points, *, straight: float = 0.0087) -> NDArray[np.float64]:
    """Return the points at which `ring` turns.

    Parameters
    ----------
    ring : (n, 2) points
    straight : float
        Sine of the largest turn that counts as straight (half a degree).

    Returns
    -------
    (m, 2) array
    """
    points = np.asarray(ring, dtype=float)
    while len(points) > 3:
        before = points - np.roll(points, 1, axis=0)
        after = np.roll(points, -1, axis=0) - points
        length_before = np.hypot(before[:, 0], before[:, 1])
        length_after = np.hypot(after[:, 0], after[:, 1])
        turn = np.abs(before[:, 0] * after[:, 1] - before[:, 1] * after[:, 0])
        idle = (length_before < 1e-6) | (turn <= straight * length_before * length_after)
        if not idle.any():
            break
        points = np.delete(points, int(np.argmax(idle)), axis=0)
    return points


def dominant_angle(rings: Iterable[Points]) -> float:
    """Return the direction in which most edge length runs, modulo a quarter turn.

    Parameters
    ----------
    rings : iterable of rings

    Returns
    -------
    float
        Radians in [-pi/4, pi/4]; 0 for axis-parallel rings.

    Examples
    --------
    >>> dominant_angle([[(0, 0), (2, 0), (2, 1), (0, 1)]])
    0.0
    """
    bins: dict[int, list[float]] = {}
    for ring in rings:
        points = np.asarray(ring, dtype=float)
        edge = np.roll(points, -1, axis=0) - points
        length = np.hypot(edge[:, 0], edge[:, 1])
        angle = np.mod(np.arctan2(edge[:, 1], edge[:, 0]) + np.pi / 4, np.pi / 2) - np.pi / 4
        for value, weight in zip(angle.tolist(), length.tolist()):
            entry = bins.setdefault(round(value / np.radians(0.5)), [0.0, 0.0])
            entry[0] += weight
            entry[1] += weight * value
    if not bins:
        return 0.0
    axis = sum(bins.get(0, [0.0])[:1])
    key = max(sorted(bins), key=lambda k: bins[k][0])
    if axis >= 0.5 * bins[key][0]:
        return 0.0
    return float(bins[key][1] / bins[key][0])


def rotated(ring: Points, angle: float) -> list[tuple[float, float]]:
    """Return `ring` turned by `angle` radians about the origin (unchanged, bit for bit, for 0)."""
    if angle == 0.0:
        return [(float(p[0]), float(p[1])) for p in ring]
    c, s = float(np.cos(angle)), float(np.sin(angle))
    return [(c * float(p[0]) - s * float(p[1]), s * float(p[0]) + c * float(p[1])) for p in ring]
