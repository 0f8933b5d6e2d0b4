"""Which footprints a disc robot can approach from a door: a raster of exact distances, apart from the solver's grid."""

from collections.abc import Sequence

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import LineString, Polygon

from mansion_geometry.free_space import connected_components
from mansion_msgs_py.placement import PlacementRoom

__all__ = ["approachable"]

Indices = npt.NDArray[np.int64]

_EPS = 1e-9


def approachable(
    room: PlacementRoom, shapes: Sequence[Polygon], *, radius: float = 0.20, reach: float = 0.30, cell: float = 0.05
) -> list[bool]:
    """Tell which footprints have a free cell within reach that is connected to a door.

    Parameters
    ----------
    room : PlacementRoom
    shapes : sequence of Polygon
        Footprints, obstacles all of them.
    radius, reach, cell : float
        The robot's radius, its reach beyond its body, the raster's cell, metres.
    """
    if not shapes:
        return []
    outline = Polygon(room.polygon, room.holes)
    doors = [LineString(door.segment) for door in room.doors]
    walls = outline.boundary
    for door in doors:
        walls = walls.difference(door.buffer(0.01, cap_style="flat"))
    x0, y0, x1, y1 = outline.bounds
    gx, gy = np.meshgrid(np.arange(x0 + cell / 2, x1, cell), np.arange(y0 + cell / 2, y1, cell))
    points = shapely.points(gx.ravel(), gy.ravel())
    free = shapely.contains_xy(outline, gx.ravel(), gy.ravel())
    free[free] = shapely.distance(walls, points[free]) >= radius - _EPS
    tree = shapely.STRtree(points)
    blocked, _ = _within(tree, shapes, radius - 2 * _EPS)
    free[blocked] = False
    labels, _ = connected_components((~free.reshape(gx.shape)).astype(np.int16))
    flat = labels.ravel()
    thresholds, _ = _within(tree, doors, 0.10 + _EPS)
    entered = np.unique(flat[thresholds])
    inside = np.isin(flat, entered[entered > 0])
    cells, owners = _within(tree, shapes, radius + reach + _EPS)
    reached = set(owners[inside[cells]].tolist())
    return [i in reached for i in range(len(shapes))]


def _within(tree: shapely.STRtree, shapes: Sequence[shapely.Geometry], distance: float) -> tuple[Indices, Indices]:
    """Return the points of `tree` within a distance of each shape, and which shape that is."""
    if not shapes:
        return np.zeros(0, dtype=int), np.zeros(0, dtype=int)
    owners, cells = tree.query(np.array(shapes), predicate="dwithin", distance=distance)
    return cells, owners
