"""Rooms drawn between wall faces, moved on to the centre lines of their walls.

Edges of two rooms that face each other across no more than a wall belong to that wall. All edges on the supporting
lines of a wall are moved to the line in their middle, so that rooms stay what they are and share their boundaries.
"""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field

import shapely
from shapely.geometry import LineString, Polygon
from shapely.geometry.polygon import orient

from mansion_geometry.rings import corner_points, polygon_parts
from mansion_msgs_py.shapes import Point

__all__ = ["THICKEST_WALL", "on_centre_lines"]

THICKEST_WALL = 0.5
"""Metres between two rooms that count as a wall."""

_OVERLAP = 0.06  # metres by which edges of two rooms may lie in each other's room
_TOUCH = 1.5e-3
_FACING = 0.2  # metres of edges that run side by side
_PARALLEL = math.cos(math.radians(1.0))
_SAME_LINE = 3e-3
_SLIVER = 0.08  # metres up to which a strip of a room is one of its drawing alone
_DOUBLE = 1e-4  # metres up to which points are one, and a corner is on a straight line
_LOST = 5e-3  # square metres
_SPUR = 0.05  # sine of the least angle at which two moved lines are cut with each other


@dataclass
class _Edge:
    """An edge of a room, its interior on the left; `line` is the number of its supporting line."""

    room: int
    start: Point
    end: Point
    line: int = -1

    @property
    def length(self) -> float:
        return math.dist(self.start, self.end)

    @property
    def direction(self) -> Point:
        return (self.end[0] - self.start[0]) / self.length, (self.end[1] - self.start[1]) / self.length

    @property
    def canonical(self) -> tuple[Point, int]:
        """Direction towards +x (+y where vertical), and 1 where it is the edge's own, else -1."""
        dx, dy = self.direction
        own = dx > 1e-4 or (abs(dx) <= 1e-4 and dy > 0.0)
        return ((dx, dy), 1) if own else ((-dx, -dy), -1)

    @property
    def offset(self) -> float:
        (dx, dy), _ = self.canonical
        x, y = (self.start[0] + self.end[0]) / 2, (self.start[1] + self.end[1]) / 2
        return dx * y - dy * x

    def span(self, direction: Point) -> tuple[float, float]:
        """Return where it runs along a direction."""
        low, high = sorted(p[0] * direction[0] + p[1] * direction[1] for p in (self.start, self.end))
        return low, high


@dataclass
class _Wall:
    """Supporting lines that become one: their offsets, and which rooms lie on which of their sides."""

    offsets: list[float]
    sides: list[tuple[int, int, float, float]] = field(default_factory=list)

    def joined(self, other: "_Wall") -> "_Wall | None":
        """Return both together; ``None`` where a room lies between them, or they are too far apart."""
        offsets = [*self.offsets, *other.offsets]
        if max(offsets) - min(offsets) > THICKEST_WALL + _SAME_LINE:
            return None
        for room, side, low, high in self.sides:
            for another, facing, start, end in other.sides:
                if room == another and side != facing and min(high, end) - max(low, start) > _TOUCH:
                    return None
        return _Wall(offsets, [*self.sides, *other.sides])

    @property
    def middle(self) -> float:
        return (min(self.offsets) + max(self.offsets)) / 2


def on_centre_lines(shapes: Sequence[Polygon]) -> list[Polygon]:
    """Return rooms that share their boundaries; the same polygons where they do so already.

    Examples
    --------
    >>> from shapely.geometry import box
    >>> [room.bounds for room in on_centre_lines([box(0, 0, 3.9, 3), box(4.1, 0, 8, 3)])]
    [(0.0, 0.0, 4.0, 3.0), (4.0, 0.0, 8.0, 3.0)]
    """
    shapes = [_without_slivers(shape) for shape in shapes]
    rings = [_rings(shape) for shape in shapes]
    edges = [edge for room in rings for ring in room for edge in ring]
    for room, ring in ((room, ring) for room, per_room in enumerate(rings) for ring in per_room):
        for edge in ring:
            edge.room = room
    walls = _number_lines(edges)
    facing = _facing(edges, shapes)
    if all(abs(gap) <= _TOUCH for gap, _, _ in facing):
        return _without_gaps(shapes)
    owner = list(range(len(walls)))
    for _, one, other in sorted(facing):
        first, second = _root(owner, edges[one].line), _root(owner, edges[other].line)
        joined = walls[first].joined(walls[second]) if first != second else None
        if joined is not None:
            walls[first], owner[second] = joined, first
    targets = [walls[_root(owner, line)].middle for line in range(len(walls))]
    moved = [_moved(shape, per_room, targets) for shape, per_room in zip(shapes, rings)]
    return _without_gaps(moved)


def _without_slivers(shape: Polygon) -> Polygon:
    """Return a room without strips too thin for anything, as it is where it has none."""
    inner = polygon_parts(shape.buffer(-_SLIVER / 2, join_style="mitre"))
    if not inner:
        return shape
    kept = max(inner, key=lambda part: part.area).buffer(_SLIVER / 2, join_style="mitre").intersection(shape)
    lost = float(shape.area - kept.area)
    return kept if lost > _LOST and isinstance(kept, Polygon) else shape


def _rings(shape: Polygon) -> list[list[_Edge]]:
    found = []
    whole = orient(shape)
    for ring in (whole.exterior, *whole.interiors):
        points = [(float(x), float(y)) for x, y in corner_points(shapely.get_coordinates(ring)[:-1], straight=2e-4)]
        found.append([_Edge(0, points[k - 1], points[k]) for k in range(len(points))])
    return found


def _number_lines(edges: Sequence[_Edge]) -> list[_Wall]:
    """Give every edge the number of its supporting line, and return the lines."""
    order = sorted(range(len(edges)), key=lambda k: (_angle(edges[k]), edges[k].offset))
    walls: list[_Wall] = []
    last: _Edge | None = None
    for k in order:
        edge = edges[k]
        if last is None or _angle(last) != _angle(edge) or edge.offset - last.offset > _SAME_LINE:
            walls.append(_Wall([]))
        direction, side = edge.canonical
        edge.line = len(walls) - 1
        walls[-1].offsets.append(edge.offset)
        walls[-1].sides.append((edge.room, side, *edge.span(direction)))
        last = edge
    return walls


def _angle(edge: _Edge) -> int:
    (dx, dy), _ = edge.canonical
    return round(math.degrees(math.atan2(dy, dx)) * 5) % 900


def _facing(edges: Sequence[_Edge], shapes: Sequence[Polygon]) -> list[tuple[float, int, int]]:
    """Return the pairs of edges of two rooms between which there is a wall, with its thickness."""
    lines = [LineString([edge.start, edge.end]) for edge in edges]
    rooms = shapely.STRtree(list(shapes))
    first, second = shapely.STRtree(lines).query(lines, predicate="dwithin", distance=THICKEST_WALL)
    found = []
    for one, other in zip(first.tolist(), second.tolist()):
        if one >= other or edges[one].room == edges[other].room:
            continue
        between = _between(edges[one], edges[other])
        if between is None:
            continue
        gap, strip = between
        if gap <= _TOUCH or not _occupied(strip, rooms, shapes, (edges[one].room, edges[other].room)):
            found.append((round(abs(gap), 6), one, other))
    return found


def _between(edge: _Edge, other: _Edge) -> tuple[float, Polygon] | None:
    """Return the thickness of the wall between two edges that face each other, and its ground plan."""
    (dx, dy), (ex, ey) = edge.direction, other.direction
    if dx * ex + dy * ey > -_PARALLEL:
        return None
    x0, y0 = edge.start
    along = sorted((x - x0) * dx + (y - y0) * dy for x, y in (other.start, other.end))
    low, high = max(along[0], 0.0), min(along[1], edge.length)
    if high - low < min(_FACING, 0.9 * edge.length, 0.9 * other.length):
        return None
    mx, my = (other.start[0] + other.end[0]) / 2, (other.start[1] + other.end[1]) / 2
    gap = (mx - x0) * dy - (my - y0) * dx
    if not -_OVERLAP <= gap <= THICKEST_WALL:
        return None
    corners = [(t, d) for t, d in ((low, 0.0), (high, 0.0), (high, gap), (low, gap))]
    return gap, Polygon([(x0 + dx * t + dy * d, y0 + dy * t - dx * d) for t, d in corners])


def _occupied(strip: Polygon, tree: shapely.STRtree, shapes: Sequence[Polygon], own: tuple[int, int]) -> bool:
    """Whether another room lies between two."""
    inside = strip.buffer(-1e-3, join_style="mitre")
    return any(
        shapes[k].intersection(inside).area > 0.2 * strip.area for k in tree.query(strip).tolist() if k not in own
    )


def _root(owner: list[int], line: int) -> int:
    while owner[line] != line:
        line = owner[line]
    return line


def _moved(shape: Polygon, rings: Sequence[Sequence[_Edge]], targets: Sequence[float]) -> Polygon:
    made = Polygon(_corners(rings[0], targets), [_corners(ring, targets) for ring in rings[1:]])
    if not made.is_valid:
        made = max(polygon_parts(made.buffer(0)), key=lambda part: part.area, default=shape)
    return orient(made.simplify(_DOUBLE))


def _corners(ring: Sequence[_Edge], targets: Sequence[float]) -> list[Point]:
    """Return the corners of a ring whose edges have moved to their lines' targets."""
    corners = []
    for before, after in zip((ring[-1], *ring[:-1]), ring):
        (ax, ay), (bx, by) = before.canonical[0], after.canonical[0]
        c, d = targets[before.line], targets[after.line]
        turn = ax * by - ay * bx
        if abs(turn) > _SPUR:
            x, y = (bx * c - ax * d) / turn, (by * c - ay * d) / turn
        else:
            shift = (c - before.offset + d - after.offset) / 2
            x, y = after.start[0] - by * shift, after.start[1] + bx * shift
        corners.append((round(x, 4) + 0.0, round(y, 4) + 0.0))
    return corners


def _without_gaps(rooms: Sequence[Polygon]) -> list[Polygon]:
    """Return rooms without slight overlaps, and with what lies between them given to the one that has most of it."""
    shapes = list(rooms)
    tree = shapely.STRtree(shapes)
    first, second = tree.query(shapes, predicate="intersects")
    for i, j in zip(first.tolist(), second.tolist()):
        if i < j and shapes[i].intersection(shapes[j]).area > 1e-6:
            large, small = (i, j) if shapes[i].area >= shapes[j].area else (j, i)
            rest = polygon_parts(shapely.difference(shapes[large], shapes[small], grid_size=1e-4))
            shapes[large] = max(rest, key=lambda part: part.area, default=shapes[large])
    union = shapely.union_all(shapes, grid_size=1e-4)
    half = THICKEST_WALL / 2
    closed = union.buffer(half, join_style="mitre").buffer(-half, join_style="mitre")
    for piece in polygon_parts(closed.difference(union)):
        if piece.area < 1e-3:
            continue
        beside = [k for k, shape in enumerate(shapes) if shape.distance(piece) < 1e-2]
        if len(beside) > 1:
            k = max(beside, key=lambda k: (round(shapes[k].boundary.intersection(piece.buffer(2e-3)).length, 3), -k))
            grown = polygon_parts(shapely.union_all([shapes[k], piece], grid_size=1e-4))
            if len(grown) == 1:
                shapes[k] = grown[0]
    return [orient(shape) for shape in shapes]
