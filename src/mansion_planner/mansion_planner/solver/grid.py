"""Grids of rectangular cells over the free region: lines through the corners of its outline, refined where wanted.

Cells are cut off at the true outline: their areas, centroids and borders are those of the part inside the free region,
so that slanted outlines need no staircase.
"""

from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
import shapely
from numpy.typing import NDArray
from shapely.geometry.base import BaseGeometry

from mansion_geometry.compiled import Bools, Floats, Ints
from mansion_geometry.rings import polygon_parts
from mansion_planner.solver.problem import FloorModel

__all__ = [
    "AREA",
    "CX",
    "CY",
    "Cells",
    "Grid",
    "HB",
    "HS",
    "NEAR",
    "SAME_LINE",
    "VB",
    "VS",
    "major_lines",
    "make_grid",
    "refined_grid",
    "resample",
    "spaced_lines",
]

AREA, CX, CY, HB, VB, HS, VS, NEAR = range(8)
"""Last index of `Cells.geometry`."""


class Cells(NamedTuple):
    """A grid of cells between lines, with a frame of outside cells around it.

    ``geometry[j, i]`` holds the area and centroid of the part of cell (j, i) inside the free region (AREA, CX, CY), the
    length of its border with cell (j+1, i) (HB) and with (j, i+1) (VB), the structural wall on these (HS, VS), and the
    length of an obstacle's slanted side through the cell (NEAR), whose label is ``near[j, i]``.
    """

    xs: Floats
    ys: Floats
    geometry: Floats
    near: Ints
    free: Bools


SAME_LINE = 1e-5
"""Distance, metres, below which two lines are one."""

SHORT_EDGE = 0.02
"""Length, metres, up to which an edge of the outline gets no line."""

MOST_MAJOR_LINES = 90
"""Most lines along each axis that all grids of a floor share."""


@dataclass(frozen=True)
class Grid:
    """Cells and the label of everything that is no room.

    Attributes
    ----------
    cells : Cells
    base : (rows, columns) int array
        Label of obstacles and outside; -1 on free cells.
    exact : bool
        Every cell lies wholly inside or wholly outside: polygons follow from the lines alone.
    """

    cells: Cells
    base: Ints
    exact: bool


def _axis_lines(shapes: list[BaseGeometry], axis: int) -> list[tuple[float, float]]:
    """Return (coordinate, length) of all edges at right angles to `axis`."""
    found: list[tuple[float, float]] = []
    for shape in shapes:
        parts = polygon_parts(shape)
        lines = [line for part in parts for line in (part.exterior, *part.interiors)] or [shape]
        for line in lines:
            points = shapely.get_coordinates(line)
            step = np.abs(np.diff(points, axis=0))
            flat = (step[:, axis] <= 1e-6) & (step[:, 1 - axis] > SHORT_EDGE)
            ends = points[:-1][flat]
            found.extend(zip(ends[:, axis].tolist(), step[flat, 1 - axis].tolist()))
    return found


def major_lines(model: FloorModel) -> tuple[Floats, Floats]:
    """Return the x and y coordinates of all axis-parallel edges of outline, holes, obstacles and structural walls.

    Where there are very many (finely stepped outlines) only those of the longest edges are kept.
    """
    shapes: list[BaseGeometry] = [model.region, *(o.polygon for o in model.obstacles), *model.walls]
    result = []
    for axis in (0, 1):
        low, high = model.outline.bounds[axis], model.outline.bounds[axis + 2]
        weight: dict[float, float] = {low: 1e9, high: 1e9}
        for value, length in _axis_lines(shapes, axis):
            weight[value] = weight.get(value, 0.0) + length
        values = sorted(weight)
        merged: list[float] = []
        for value in values:
            if not merged or value - merged[-1] > SAME_LINE:
                merged.append(value)
        if len(merged) > MOST_MAJOR_LINES:
            merged = sorted(merged, key=lambda v: -weight[v])[:MOST_MAJOR_LINES]
        result.append(np.array(sorted(merged)))
    return result[0], result[1]


def spaced_lines(lines: Floats, spacing: float) -> Floats:
    """Return `lines` with others put between them so that no gap is much wider than `spacing`."""
    pieces = [lines[:1]]
    for a, b in zip(lines[:-1].tolist(), lines[1:].tolist()):
        parts = max(1, round((b - a) / spacing))
        pieces.append(a + (b - a) * np.arange(1, parts + 1) / parts)
    filled = np.concatenate(pieces)
    keep = np.concatenate([[True], np.diff(filled) > SAME_LINE])
    result: Floats = filled[keep]
    return result


def resample(grid: Grid, labels: Ints, finer: Grid) -> Ints:
    """Return the labels on `finer` cells, each taken from the old cell that holds its centre."""
    xs, ys = finer.cells.xs, finer.cells.ys
    column = np.searchsorted(grid.cells.xs, (xs[:-1] + xs[1:]) / 2, side="right") - 1
    row = np.searchsorted(grid.cells.ys, (ys[:-1] + ys[1:]) / 2, side="right") - 1
    column = np.clip(column, 0, labels.shape[1] - 1)
    row = np.clip(row, 0, labels.shape[0] - 1)
    taken: Ints = labels[np.ix_(row, column)]
    return np.where(finer.base >= 0, finer.base, taken)


def _boxes(xs: Floats, ys: Floats) -> NDArray[np.object_]:
    gx0, gy0 = np.meshgrid(xs[:-1], ys[:-1])
    gx1, gy1 = np.meshgrid(xs[1:], ys[1:])
    boxes: NDArray[np.object_] = shapely.box(gx0, gy0, gx1, gy1)
    return boxes


def _lengths_inside(model: FloorModel, x0: Floats, y0: Floats, x1: Floats, y1: Floats) -> Floats:
    """Return the lengths of segments inside the free region."""
    lines = shapely.linestrings(np.stack([np.stack([x0, y0], -1), np.stack([x1, y1], -1)], -2))
    lengths: Floats = shapely.length(shapely.intersection(lines, model.region))
    return lengths


def _labels(model: FloorModel, xs: Floats, ys: Floats) -> tuple[Ints, Floats, Floats, Floats, Bools]:
    """Classify the cells; return labels (-1 free), areas, centroids and which cells the outline crosses."""
    rooms = len(model.rooms)
    outside = rooms + len(model.obstacles)
    gx, gy = np.meshgrid((xs[:-1] + xs[1:]) / 2, (ys[:-1] + ys[1:]) / 2)
    size = np.outer(np.diff(ys), np.diff(xs))
    shapely.prepare(model.region)
    inside = shapely.contains_xy(model.region, gx, gy)
    base = np.where(inside, -1, outside)
    for k, obstacle in enumerate(model.obstacles):
        shapely.prepare(obstacle.polygon)
        base[~inside & shapely.contains_xy(obstacle.polygon, gx, gy)] = rooms + k
    area = np.where(inside, size, 0.0)
    crossed = np.zeros_like(inside)
    if not _rectilinear_on_lines(model, xs, ys):
        boxes = _boxes(xs, ys)
        touched = shapely.intersects(model.region.boundary, boxes)
        # A side that is nearly parallel to an axis may pass the last line by less than `SAME_LINE`; the frame stays
        # outside nevertheless, as the kernels look at the neighbours of every free cell.
        touched[[0, -1], :] = touched[:, [0, -1]] = False
        cut = shapely.intersection(boxes[touched], model.region)
        part = shapely.area(cut)
        whole = size[touched]
        partial = (part > 1e-9) & (part < whole * (1 - 1e-6))
        rows, columns = np.nonzero(touched)
        for (j, i), a, c in zip(zip(rows[partial], columns[partial]), part[partial], cut[partial]):
            crossed[j, i] = True
            base[j, i] = -1
            area[j, i] = a
            centre = shapely.centroid(c)
            gx[j, i], gy[j, i] = centre.x, centre.y
    return base, area, gx, gy, crossed


def _rectilinear_on_lines(model: FloorModel, xs: Floats, ys: Floats) -> bool:
    """Tell whether every edge of the free region runs along grid lines."""
    for part in polygon_parts(model.region):
        for line in (part.exterior, *part.interiors):
            points = shapely.get_coordinates(line)
            step = np.abs(np.diff(points, axis=0)).min(axis=1)
            if (step > 1e-6).any():
                return False
            for axis, lines in ((0, xs), (1, ys)):
                at = np.clip(np.searchsorted(lines, points[:, axis]), 1, len(lines) - 1)
                off = np.minimum(np.abs(lines[at] - points[:, axis]), np.abs(lines[at - 1] - points[:, axis]))
                if (off > 2 * SAME_LINE).any():
                    return False
    return True


def _borders(model: FloorModel, xs: Floats, ys: Floats, base: Ints, crossed: Bools) -> tuple[Floats, Floats]:
    """Return the border lengths of all cells (outside the frame); partly inside where the outline cuts them."""
    rows, columns = base.shape
    hb = np.zeros((rows, columns))
    vb = np.zeros((rows, columns))
    hb[:-1] = np.diff(xs)[None, :]
    vb[:, :-1] = np.diff(ys)[:, None]
    j, i = np.nonzero(crossed[:-1] | crossed[1:])
    if len(j):
        hb[j, i] = _lengths_inside(model, xs[i], ys[j + 1], xs[i + 1], ys[j + 1])
    j, i = np.nonzero(crossed[:, :-1] | crossed[:, 1:])
    if len(j):
        vb[j, i] = _lengths_inside(model, xs[i + 1], ys[j], xs[i + 1], ys[j + 1])
    return hb, vb


def _structure(model: FloorModel, xs: Floats, ys: Floats) -> tuple[Floats, Floats]:
    """Return the lengths of axis-parallel structural wall on each border."""
    rows, columns = len(ys) - 1, len(xs) - 1
    hs, vs = np.zeros((rows, columns)), np.zeros((rows, columns))
    for wall in model.walls:
        (x0, y0), (x1, y1) = shapely.get_coordinates(wall).tolist()
        if abs(y1 - y0) < 1e-6:
            at = int(np.argmin(np.abs(ys - y0)))
            overlap = np.minimum(xs[1:], max(x0, x1)) - np.maximum(xs[:-1], min(x0, x1))
            if 0 < at < rows and abs(ys[at] - y0) < 1e-3:
                hs[at - 1] += np.maximum(overlap, 0.0)
        elif abs(x1 - x0) < 1e-6:
            at = int(np.argmin(np.abs(xs - x0)))
            overlap = np.minimum(ys[1:], max(y0, y1)) - np.maximum(ys[:-1], min(y0, y1))
            if 0 < at < columns and abs(xs[at] - x0) < 1e-3:
                vs[:, at - 1] += np.maximum(overlap, 0.0)
    return hs, vs


def _slanted_contacts(model: FloorModel, xs: Floats, ys: Floats, base: Ints, crossed: Bools) -> tuple[Ints, Floats]:
    """Return, for crossed free cells, the obstacle whose side runs through the cell and for how long."""
    near = np.zeros(base.shape, np.int64)
    length = np.zeros(base.shape)
    cells = np.argwhere(crossed & (base < 0))
    if not len(cells) or not model.obstacles:
        return near, length
    boxes = shapely.box(xs[cells[:, 1]], ys[cells[:, 0]], xs[cells[:, 1] + 1], ys[cells[:, 0] + 1])
    for k, obstacle in enumerate(model.obstacles):
        inner = shapely.length(shapely.intersection(boxes, obstacle.polygon.boundary))
        edge = shapely.length(shapely.intersection(shapely.boundary(boxes), obstacle.polygon.boundary))
        for (j, i), s in zip(cells.tolist(), (inner - edge).tolist()):
            if s > length[j, i] + 1e-9:
                near[j, i], length[j, i] = len(model.rooms) + k, s
    return near, length


def make_grid(model: FloorModel, xs: Floats, ys: Floats) -> Grid:
    """Return the grid between the given lines, framed by a row and column of outside cells on each side.

    Parameters
    ----------
    xs, ys : arrays
        Ascending lines; the first and last are the outline's bounds.
    """
    xs = np.concatenate([[xs[0] - 1.0], xs, [xs[-1] + 1.0]])
    ys = np.concatenate([[ys[0] - 1.0], ys, [ys[-1] + 1.0]])
    base, area, cx, cy, crossed = _labels(model, xs, ys)
    hb, vb = _borders(model, xs, ys, base, crossed)
    hs, vs = _structure(model, xs, ys)
    near, near_length = _slanted_contacts(model, xs, ys, base, crossed)
    geometry = np.stack([area, cx, cy, hb, vb, hs, vs, near_length], axis=-1)
    cells = Cells(xs, ys, geometry, near, base < 0)
    return Grid(cells, base.astype(np.int64), not bool(crossed.any()))


def used_lines(grid: Grid, labels: Ints) -> tuple[Floats, Floats]:
    """Return the lines of `grid` (without its frame) along which labels change."""
    across = (labels[:, 1:] != labels[:, :-1]).any(axis=0)
    along = (labels[1:, :] != labels[:-1, :]).any(axis=1)
    return grid.cells.xs[1:-1][across], grid.cells.ys[1:-1][along]


def wall_lines(grid: Grid, labels: Ints) -> tuple[Floats, Floats]:
    """Return those of the used lines along which a wall runs.

    Along the others labels change only because a slanted side goes from cell to cell.
    """
    across = ((labels[:, 1:] != labels[:, :-1]) & _may_be_walls(grid, 1)).any(axis=0)
    along = ((labels[1:, :] != labels[:-1, :]) & _may_be_walls(grid, 0)).any(axis=1)
    return grid.cells.xs[1:-1][across], grid.cells.ys[1:-1][along]


def _may_be_walls(grid: Grid, axis: int) -> Bools:
    """Tell of each pair of neighbours along `axis` whether both are free, or one is and no slanted side cuts it."""
    free = np.moveaxis(grid.cells.free, axis, 0)
    if grid.exact:
        return np.moveaxis(np.ones_like(free[1:]), 0, axis)
    size = np.outer(np.diff(grid.cells.ys), np.diff(grid.cells.xs))
    whole = np.moveaxis(grid.cells.geometry[..., AREA] >= size * (1 - 1e-6), axis, 0) & free
    found: Bools = np.moveaxis((free[1:] & free[:-1]) | whole[1:] | whole[:-1], 0, axis)
    return found


def _beside(lines: Floats, major: Floats, offsets: tuple[float, ...]) -> Floats:
    """Return the major lines and `lines`, with others at the offsets on both sides of each that is not major."""
    moved = [major, lines]
    for offset in offsets:
        moved.extend([lines - offset, lines + offset])
    low, high = major[0], major[-1]
    merged = np.unique(np.concatenate(moved))
    merged = merged[(merged >= low) & (merged <= high)]
    fixed = np.concatenate([major, lines])
    gap = 0.4 * min(offsets)
    keep: list[float] = []
    for value in merged.tolist():
        near = fixed[np.argmin(np.abs(fixed - value))]
        if value != near and abs(value - near) < gap:
            continue
        if keep and value - keep[-1] < 1e-5:
            continue
        keep.append(value)
    return np.array(keep)


def refined_grid(
    model: FloorModel, major: tuple[Floats, Floats], grid: Grid, labels: Ints, offsets: tuple[float, ...]
) -> tuple[Grid, Ints]:
    """Return a grid of the used lines with finer ones around those of walls, and the partition's labels on it.

    Lines that only a slanted side crosses are kept and get no finer ones: else each refinement would multiply them.
    """
    walls, used = wall_lines(grid, labels), used_lines(grid, labels)
    xs, ys = (_beside(walls[k], np.union1d(major[k], used[k]), offsets) for k in (0, 1))
    finer = make_grid(model, xs, ys)
    return finer, resample(grid, labels, finer)
