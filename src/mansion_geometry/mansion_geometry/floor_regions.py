"""Where a disc robot may be, as exact polygons: the floor less what stands on it, eroded by the robot's radius.

`mansion_geometry.floor_grid` has the same floor as cells.
"""

from collections.abc import Iterable

import numpy as np
import shapely
from shapely.geometry import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from mansion_geometry.rings import polygon_parts
from mansion_msgs_py.shapes import Segment

__all__ = ["disc_positions", "disc_positions_among", "largest_first", "open_floor", "strip"]


def strip(segment: Segment, depth: float) -> Polygon:
    """Return the rectangle of a `depth` along a segment, metres: a door's way through its wall, say."""
    return LineString(segment).buffer(depth / 2, cap_style="flat")


def open_floor(floors: Iterable[BaseGeometry], solid: Iterable[BaseGeometry]) -> BaseGeometry:
    """Return all floors as one region, less what is solid."""
    return shapely.union_all(list(floors)).difference(shapely.union_all(list(solid)))


def disc_positions(floor: BaseGeometry, radius: float, *, quad_segs: int) -> list[Polygon]:
    """Return where the centre of a disc that stays on a floor may be, as connected parts.

    Parameters
    ----------
    floor : shapely geometry
    radius : float
        Metres.
    quad_segs : int
        Segments of a quarter of a circle about a convex corner of what is solid.
    """
    return polygon_parts(floor.buffer(-radius, quad_segs=quad_segs))


def disc_positions_among(
    floors: Iterable[BaseGeometry], solid: Iterable[BaseGeometry], radius: float, *, quad_segs: int
) -> list[Polygon]:
    """Return `disc_positions` of an `open_floor`, in a time that hardly grows faster than the number of solids.

    Notes
    -----
    What is left of A less B after an erosion is A eroded less B dilated. To grow small solids and unite them is cheap;
    to erode one floor with a hole for each of them is not.
    """
    grown = shapely.union_all(shapely.buffer(np.array(list(solid), dtype=object), radius, quad_segs=quad_segs))
    eroded = shapely.union_all(list(floors)).buffer(-radius, quad_segs=quad_segs)
    return polygon_parts(eroded.difference(grown))


def largest_first(parts: Iterable[Polygon]) -> list[Polygon]:
    """Return polygons by falling area, equal ones by their bounds."""
    return sorted(parts, key=lambda part: (-round(part.area, 6), part.bounds))
