"""Where a disc robot may be, as exact polygons: the floor less what stands on it, eroded by the robot's radius.

`mansion_geometry.floor_grid` has the same floor as cells.
"""

from collections.abc import Iterable

import shapely
from shapely.geometry import LineString, Polygon
from shapely.geometry.base import BaseGeometry

from mansion_geometry.rings import polygon_parts
from mansion_msgs_py.shapes import Segment

__all__ = ["disc_positions", "largest_first", "open_floor", "strip"]


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


def largest_first(parts: Iterable[Polygon]) -> list[Polygon]:
    """Return polygons by falling area, equal ones by their bounds."""
    return sorted(parts, key=lambda part: (-round(part.area, 6), part.bounds))
