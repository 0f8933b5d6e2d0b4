"""Who shares which stretch of boundary: the edges of a floor's polygons, paired."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from mansion_msgs_py.shapes import Point, Ring

__all__ = ["Stretch", "stretches"]

FloatArray = npt.NDArray[np.float64]

COLLINEAR = 0.02
"""Metres by which two edges may lie apart and still be one boundary."""

SLIVER = 0.005
"""Shorter stretches are rounding, not boundary."""


@dataclass(frozen=True, slots=True)
class Stretch:
    """A straight piece of a polygon's boundary with the same neighbour all along.

    Attributes
    ----------
    start, end : Point
        In the direction that has the owner's interior on its left.
    owner : str
        Id of the polygon.
    neighbour : str or None
        Id of the polygon on the other side; ``None`` is outside.
    """

    start: Point
    end: Point
    owner: str
    neighbour: str | None

    @property
    def length(self) -> float:
        """Length in metres."""
        return float(np.hypot(self.end[0] - self.start[0], self.end[1] - self.start[1]))


def stretches(polygons: Mapping[str, Sequence[Ring]]) -> list[Stretch]:
    """Split the boundaries of polygons that tile a floor into stretches of one neighbour each.

    Parameters
    ----------
    polygons : mapping of str to sequence of Ring
        Outer ring and then holes of each polygon, in any orientation.

    Returns
    -------
    list of Stretch
        Two opposite ones with the same end points for each stretch that two polygons share, one for each stretch
        without a neighbour; in the order of `polygons` and of their vertices.

    Examples
    --------
    >>> left, right = [(0, 0), (1, 0), (1, 1), (0, 1)], [(1, 0), (2, 0), (2, 1), (1, 1)]
    >>> [s.neighbour for s in stretches({"a": [left], "b": [right]}) if s.owner == "a"]
    [None, 'b', None, None]
    """
    owners, starts, ends = _edges(polygons)
    if not owners:
        return []
    vectors = ends - starts
    lengths = np.hypot(vectors[:, 0], vectors[:, 1])
    units = vectors / lengths[:, None]
    shared: list[list[tuple[float, float, Stretch]]] = [[] for _ in owners]
    for i in range(len(owners)):
        for j, low, high in _opposites(i, owners, starts, ends, units, lengths):
            a, b = _along(starts[i], units[i], low), _along(starts[i], units[i], high)
            shared[i].append((low, high, Stretch(a, b, owners[i], owners[j])))
            t = float(np.dot(np.array(b) - starts[j], units[j]))
            shared[j].append((t, t + high - low, Stretch(b, a, owners[j], owners[i])))
    found: list[Stretch] = []
    for i, owner in enumerate(owners):
        found += _fill(owner, starts[i], units[i], float(lengths[i]), shared[i])
    return found


def _edges(polygons: Mapping[str, Sequence[Ring]]) -> tuple[list[str], FloatArray, FloatArray]:
    owners: list[str] = []
    starts: list[Point] = []
    ends: list[Point] = []
    for name, rings in polygons.items():
        for position, ring in enumerate(rings):
            points = list(ring)
            if (_signed_area(points) > 0) != (position == 0):
                points.reverse()
            for a, b in zip(points, points[1:] + points[:1]):
                if np.hypot(b[0] - a[0], b[1] - a[1]) > 1e-6:
                    owners.append(name)
                    starts.append(a)
                    ends.append(b)
    return owners, np.array(starts, dtype=float), np.array(ends, dtype=float)


def _opposites(
    i: int, owners: list[str], starts: FloatArray, ends: FloatArray, units: FloatArray, lengths: FloatArray
) -> list[tuple[int, float, float]]:
    """Later edges that run against edge `i` on its line, with the interval of `i` that they cover."""
    later = slice(i + 1, len(owners))
    ux, uy = units[i]
    against = units[later] @ units[i] < -0.999
    near_start = starts[later] - starts[i]
    near_end = ends[later] - starts[i]
    off = np.maximum(
        np.abs(near_start[:, 0] * uy - near_start[:, 1] * ux), np.abs(near_end[:, 0] * uy - near_end[:, 1] * ux)
    )
    low = np.maximum(near_end @ units[i], 0.0)
    high = np.minimum(near_start @ units[i], lengths[i])
    hits = np.flatnonzero(against & (off < COLLINEAR) & (high - low > SLIVER))
    return [(int(k) + i + 1, float(low[k]), float(high[k])) for k in hits if owners[int(k) + i + 1] != owners[i]]


def _fill(
    owner: str, start: FloatArray, unit: FloatArray, length: float, shared: list[tuple[float, float, Stretch]]
) -> list[Stretch]:
    """Shared stretches of one edge in order, and outer ones between them."""
    found: list[Stretch] = []
    reached = 0.0
    for low, high, stretch in sorted(shared, key=lambda item: item[0]):
        if low - reached > SLIVER:
            found.append(Stretch(_along(start, unit, reached), stretch.start, owner, None))
        found.append(stretch)
        reached = max(reached, high)
    if length - reached > SLIVER:
        found.append(Stretch(_along(start, unit, reached), _along(start, unit, length), owner, None))
    return found


def _along(start: FloatArray, unit: FloatArray, distance: float) -> Point:
    x, y = start + unit * distance
    return (round(float(x), 6), round(float(y), 6))


def _signed_area(ring: Sequence[Point]) -> float:
    return 0.5 * sum(a[0] * b[1] - b[0] * a[1] for a, b in zip(ring, list(ring[1:]) + list(ring[:1])))
