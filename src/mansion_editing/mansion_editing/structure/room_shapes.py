"""What the shape of a room must keep when its walls move: area, width, proportions, one piece."""

from collections.abc import Sequence
from dataclasses import dataclass

import shapely
from shapely import LineString, Polygon
from shapely.geometry.polygon import orient

from mansion_geometry.rings import polygon_parts
from mansion_geometry.wall_sizes import INTERIOR_THICKNESS
from mansion_knowledge import default_knowledge, is_class
from mansion_msgs_py.layout import LayoutRoom
from mansion_msgs_py.scene import SceneRoom
from mansion_msgs_py.shapes import Point, Ring, Segment

__all__ = ["ShapeLimits", "is_circulation", "layout_room", "limits_of", "polygon_of", "tidied"]

GRID = 1e-4
"""Metres to which corners are rounded."""

_SHARE_KEPT = 0.5
"""Share of its area that a neighbour keeps, however large it is."""

_SLENDER = 3.0
"""Length by width up to which a room may become slender; one that is more so already keeps what it has."""

_MORE_SLENDER = 1.5
"""Factor by which a room that is asked for may become more slender than it is."""

_NARROWEST = 1.2
"""Width that a room keeps, metres, where it has that much."""

_WIDE_ENOUGH = 2.4
"""Width that a room of 16 m2 and more keeps, metres, where it has that much."""

_LOST_TO_NOOKS = 0.02
"""Share of a room's area by which nooks narrower than its least width may grow."""

_STRADDLE = INTERIOR_THICKNESS / 2
"""Half a wall: how far a structural wall may reach into a room, metres."""

_ROUNDING = 4e-3


@dataclass(frozen=True)
class ShapeLimits:
    """What one room keeps.

    Attributes
    ----------
    area : float
        Least area, square metres.
    width : float
        Least width, metres.
    nooks : float
        Share of its area that is narrower now.
    slenderness : float
        Most that its length may be of its width.
    structural : tuple of LineString
        Lines of structural walls that may lie no further inside it.
    """

    area: float
    width: float
    nooks: float
    slenderness: float
    structural: tuple[LineString, ...] = ()

    def fault(self, shape: Polygon) -> str:
        """Return what a shape lacks, in words; empty for one that will do."""
        if shape.area < self.area - 1e-6:
            return f"keeps at least {self.area:.1f} m2"
        if _slenderness(shape) > self.slenderness + 1e-6:
            return "would become too slender"
        if _nooks(shape, self.width) > self.nooks + _LOST_TO_NOOKS:
            return f"keeps a width of {self.width:.1f} m"
        if any(_straddled(shape, line) > 0.05 for line in self.structural):
            return "would lie on both sides of a structural wall"
        return ""


def limits_of(shape: Polygon, room_type: str, structural: Sequence[Segment] = (), *, gives: bool = True) -> ShapeLimits:
    """Return what a room keeps.

    Parameters
    ----------
    shape : Polygon
        As it is.
    room_type : str
        Its type, whose least area the knowledge base has.
    structural : sequence of Segment
        Structural walls of the storey.
    gives : bool
        It is a neighbour, which keeps a share of its area and its proportions; the room that is asked for may have any
        area that its type allows, and stretch for it.
    """
    least = default_knowledge().room(room_type).least
    area = min(shape.area, max(least, _SHARE_KEPT * shape.area if gives else least))
    wanted = _WIDE_ENOUGH if area >= 16.0 else _NARROWEST
    width = wanted if _nooks(shape, wanted) < 0.1 else _NARROWEST
    lines = tuple(LineString(segment) for segment in structural)
    return ShapeLimits(
        area=area,
        width=width,
        nooks=_nooks(shape, width),
        slenderness=max(_SLENDER, _slenderness(shape)) * (1.0 if gives else _MORE_SLENDER),
        structural=tuple(line for line in lines if _straddled(shape, line) <= 0.05),
    )


def _slenderness(shape: Polygon) -> float:
    box = shapely.minimum_rotated_rectangle(shape)
    corners = shapely.get_coordinates(box)
    one, other = (float(shapely.LineString(corners[k : k + 2]).length) for k in (0, 1))
    return max(one, other) / max(min(one, other), 1e-6)


def _nooks(shape: Polygon, width: float) -> float:
    """Return the share of a shape that a square of a width does not get into."""
    inset = width / 2 - _ROUNDING
    opened = shape.buffer(-inset, join_style="mitre")
    pieces = [part for part in polygon_parts(opened) if part.area > 1e-4]
    if len(pieces) != 1:
        return 1.0
    return 1.0 - float(pieces[0].buffer(inset, join_style="mitre").intersection(shape).area) / float(shape.area)


def _straddled(shape: Polygon, line: LineString) -> float:
    return float(shape.buffer(-_STRADDLE, join_style="mitre").intersection(line).length)


def polygon_of(room: LayoutRoom) -> Polygon:
    """Return a room of a layout as a polygon."""
    return orient(Polygon(room.polygon, room.holes))


def layout_room(name: str, shape: Polygon) -> LayoutRoom:
    """Return a polygon as a room of a layout."""
    return LayoutRoom(id=name, polygon=_ring(shape.exterior), holes=[_ring(hole) for hole in shape.interiors])


def _ring(ring: shapely.LinearRing) -> Ring:
    return [(round(float(x), 4) + 0.0, round(float(y), 4) + 0.0) for x, y in ring.coords[:-1]]


def tidied(shape: shapely.Geometry) -> Polygon | None:
    """Return a shape on the grid of corners without points on its straight sides; None unless it is one piece."""
    parts = polygon_parts(shapely.set_precision(shape, GRID))
    whole = [part for part in parts if part.area > 1e-3]
    if len(whole) != 1:
        return None
    rings = [_corners(ring) for ring in (whole[0].exterior, *whole[0].interiors)]
    tidy = orient(Polygon(rings[0], rings[1:]))
    return tidy if tidy.is_valid else None


def _corners(ring: shapely.LinearRing) -> list[Point]:
    points = [(float(x), float(y)) for x, y in ring.coords[:-1]]
    return [p for i, p in enumerate(points) if not _on_side(points[i - 1], p, points[(i + 1) % len(points)])]


def _on_side(a: Point, p: Point, b: Point) -> bool:
    cross = (p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0])
    ahead = (p[0] - a[0]) * (b[0] - p[0]) + (p[1] - a[1]) * (b[1] - p[1])
    return abs(cross) <= 2 * GRID * max(abs(b[0] - a[0]), abs(b[1] - a[1])) and ahead > 0


def is_circulation(room: SceneRoom) -> bool:
    """Whether a room is there to walk through, so that it keeps its width and its place."""
    return is_class(room.room_type, "circulation") or default_knowledge().room(room.room_type).zone == "circulation"
