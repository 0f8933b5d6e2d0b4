"""Support surfaces of a model: level faces with free space above them, on which objects can be put."""

from typing import Final, NamedTuple

import numpy as np

from mansion_assets.catalogue.asset import Surface
from mansion_geometry.compiled import Bools, Floats

__all__ = ["level_surfaces"]

_CELL: Final = 0.02
"""Metres of a cell of the raster in which rectangles are sought."""

_MOST_CELLS: Final = 160
"""Cells along the longest side."""

_LEVEL: Final = 0.985
"""Upward share of the normal of a level face."""

_SAME: Final = 0.01
"""Metres within which faces lie level."""

_LEAST_SIDE, _LEAST_SHARE = 0.12, 0.12
"""Metres of the shorter side of a surface, and its share of the footprint."""

_RIM: Final = 0.005
"""Metres of a level face along its edges that do not count."""

_ROOM: Final = 0.08
"""Metres free above a surface at least."""

_OPEN: Final = 1.0
"""Free height above what has nothing above it, metres."""

_MOST: Final = 8


class _Samples(NamedTuple):
    """Points all over the triangles, (n, 3), and whether each lies on a level face."""

    points: Floats
    level: Bools


def level_surfaces(corners: Floats, kind: str = "top") -> list[Surface]:
    """Return the level faces of a model that carry things, the highest first, at most 8.

    Parameters
    ----------
    corners : (m, 3, 3) array
        Corners of the triangles, metres, in the asset's frame.
    kind : str
        What the highest is called; others are shelves.
    """
    low, high = corners.reshape(-1, 3).min(axis=0), corners.reshape(-1, 3).max(axis=0)
    cell = max(_CELL, float((high - low)[:2].max()) / _MOST_CELLS)
    samples = _sampled(corners, cell / 2)
    footprint = float(np.prod((high - low)[:2]))
    found: list[Surface] = []
    for height in _heights(corners, footprint):
        here = samples.level & (np.abs(samples.points[:, 2] - height) <= _SAME)
        grid = _cells(samples.points[here], low, high, cell)
        above = samples.points[(samples.points[:, 2] > height + _SAME) & (samples.points[:, 2] < height + _ROOM)]
        rectangle = _largest(grid & ~_cells(above, low, high, cell))
        surface = _surface(rectangle, low, cell, height, kind if not found else "shelf", samples.points)
        if surface is not None and surface.w * surface.d >= _LEAST_SHARE * footprint:
            found.append(surface)
        if len(found) == _MOST:
            break
    return found


def _sampled(corners: Floats, step: float) -> _Samples:
    """Return points no further apart than `step` on every triangle."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    lengths = np.linalg.norm(normals, axis=1)
    upward = normals[:, 2] > _LEVEL * np.maximum(lengths, 1e-12)
    edges = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).max(axis=1)
    parts = np.clip(np.ceil(edges / step).astype(int), 1, 2 * _MOST_CELLS)
    points, level = [], []
    for count in np.unique(parts).tolist():
        mine = parts == count
        u, v = np.meshgrid(np.arange(count + 1) / count, np.arange(count + 1) / count, indexing="ij")
        inside = u + v <= 1.0 + 1e-9
        weights = np.stack([1.0 - u[inside] - v[inside], u[inside], v[inside]], axis=1)
        made = np.einsum("kc,mcx->mkx", weights, corners[mine])
        points.append(made.reshape(-1, 3))
        level.append(np.repeat(upward[mine], len(weights)))
    return _Samples(np.concatenate(points), np.concatenate(level))


def _heights(corners: Floats, footprint: float) -> list[float]:
    """Return the heights at which enough of the model is level, from above."""
    normals = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]) / 2
    areas = np.linalg.norm(normals, axis=1)
    up = normals[:, 2] > _LEVEL * np.maximum(areas, 1e-12)
    heights, areas = corners[up, :, 2].mean(axis=1), areas[up]
    found: list[float] = []
    for height in sorted(np.unique(np.round(heights, 3)).tolist(), reverse=True):
        near = np.abs(heights - height) <= _SAME
        if areas[near].sum() >= _LEAST_SHARE * footprint and not any(abs(height - h) <= 2 * _SAME for h in found):
            found.append(float(height))
    return found


def _cells(points: Floats, low: Floats, high: Floats, cell: float) -> Bools:
    """Return which cells of the footprint hold a point."""
    shape = np.maximum(np.ceil((high - low)[:2] / cell - 1e-6).astype(int), 1)
    grid = np.zeros(tuple(shape.tolist()), dtype=bool)
    if len(points):
        at = np.clip(((points[:, :2] - low[:2]) / cell).astype(int), 0, shape - 1)
        grid[at[:, 0], at[:, 1]] = True
    return grid


def _largest(grid: Bools) -> tuple[int, int, int, int]:
    """Return the first and the last-but-one column and row of the largest rectangle of cells that are all set."""
    best, found = 0, (0, 0, 0, 0)
    heights = np.zeros(grid.shape[1], dtype=int)
    for i in range(grid.shape[0]):
        heights = np.where(grid[i], heights + 1, 0)
        stack: list[int] = []
        for j, h in enumerate([*heights.tolist(), 0]):
            while stack and (int(heights[stack[-1]]) if stack[-1] < len(heights) else 0) >= h:
                top = int(heights[stack.pop()])
                start = stack[-1] + 1 if stack else 0
                if top * (j - start) > best:
                    best, found = top * (j - start), (i - top + 1, i + 1, start, j)
            stack.append(j)
    return found


def _surface(
    rectangle: tuple[int, int, int, int], low: Floats, cell: float, height: float, kind: str, points: Floats
) -> Surface | None:
    x0, x1 = (float(low[0]) + cell * n for n in rectangle[:2])
    y0, y1 = (float(low[1]) + cell * n for n in rectangle[2:])
    right, front = float(points[:, 0].max()), float(points[:, 1].max())
    x1, y1 = min(x1, right), min(y1, front)
    if min(x1 - x0, y1 - y0) < _LEAST_SIDE:
        return None
    x0, x1, y0, y1 = x0 + _RIM, x1 - _RIM, y0 + _RIM, y1 - _RIM
    over = (points[:, 0] > x0) & (points[:, 0] < x1) & (points[:, 1] > y0) & (points[:, 1] < y1)
    above = points[over & (points[:, 2] > height + _SAME), 2]
    clearance = min(_OPEN, float(above.min()) - height) if len(above) else _OPEN
    if clearance < _ROOM:
        return None
    return Surface(
        kind=kind, x=round((x0 + x1) / 2, 4), y=round((y0 + y1) / 2, 4), z=round(height, 4), w=round(x1 - x0, 4),
        d=round(y1 - y0, 4), clearance=round(clearance, 4),
    )  # fmt: skip
