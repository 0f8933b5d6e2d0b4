"""How many copies a room gets, and how a matrix of them spreads."""

import math

import numpy as np

from mansion_assets.catalogue.records import Count, MatrixShape

__all__ = ["copies", "grid", "room_extent"]

_AISLE = 0.7
"""Free strip that a matrix leaves along the walls, metres."""


def copies(count: int | Count, area: float, others: dict[str, int], rng: np.random.Generator) -> int:
    """Return the number of copies for a room of `area` square metres.

    Parameters
    ----------
    others : dict
        Copies of the items so far, for counts that follow ``each``.

    Notes
    -----
    A count by area varies by up to one in eight from room to room, so that rooms of one size differ.
    """
    if isinstance(count, int):
        return count
    if count.each:
        return min(count.max, max(count.min, round(others.get(count.each, 0) * count.times)))
    if count.per is None:
        return int(rng.integers(count.min, count.max + 1))
    wanted = area / count.per
    if wanted > 2.0:
        wanted *= 1.0 + 0.125 * float(rng.uniform(-1.0, 1.0))
    return min(count.max, max(count.min, math.floor(wanted + 1e-9)))


def room_extent(area: float, extent: tuple[float, float] | None) -> tuple[float, float]:
    """Return a room's longer and shorter side; 5:4 where only its area is known."""
    if extent is None:
        long = math.sqrt(area * 1.25)
        return long, area / long
    return max(extent), min(extent)


def grid(wanted: int, cell: tuple[float, float], shape: MatrixShape, extent: tuple[float, float]) -> tuple[int, int]:
    """Return rows and columns of at most `wanted` copies that fit a room.

    Parameters
    ----------
    cell : (float, float)
        Width and depth of a copy, its paired accessory included.
    extent : (float, float)
        Longer and shorter side of the room; columns run along either.

    Returns
    -------
    (int, int)
        (0, 0) where not even one copy fits.
    """
    best = (0, 0)
    for across, along in (extent, extent[::-1]):
        cols = _fitting(across, cell[0], shape.gap[0], shape.max_cols)
        rows = _fitting(along, cell[1], shape.gap[1], shape.max_rows)
        for r in range(1, rows + 1):
            c = min(cols, wanted // r)
            if c >= 1 and (r * c, -abs(c - 1.3 * r)) > (best[0] * best[1], -abs(best[1] - 1.3 * best[0])):
                best = (r, c)
    return best


def _fitting(length: float, size: float, gap: float, most: int) -> int:
    return max(0, min(most, math.floor((length - 2 * _AISLE + gap) / (size + gap) + 1e-9)))
