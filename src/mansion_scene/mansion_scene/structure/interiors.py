"""The floor that walls leave free (net interiors), and the part of it that a robot can walk.

A room that is pinched to less than a passage is two rooms to a robot: only its largest walkable part counts, and doors
open on to nothing else.
"""

import math
from collections.abc import Mapping, Sequence, Set
from dataclasses import dataclass, replace

import shapely
from shapely.geometry import LineString, MultiLineString, Polygon
from shapely.geometry.polygon import orient

from mansion_geometry.robot_body import PASSAGE_WIDTH
from mansion_msgs_py.shapes import Point, Segment
from mansion_scene.structure.access import Pair, pair_key
from mansion_scene.structure.boundaries import BoundarySegment
from mansion_scene.structure.dimensions import CLEAR_WIDTH, INTERIOR_THICKNESS, NIB
from mansion_scene.structure.regions import FloorRegions

__all__ = ["Partition", "partition_floor", "usable_boundaries", "walkable_parts"]

_SHORTEST_OPEN = 0.7  # metres; a shorter open boundary keeps its wall
_SLIVER = 0.1  # square metres


@dataclass(frozen=True)
class Partition:
    """The walls of a floor before doors.

    Attributes
    ----------
    walls : list of BoundarySegment
        Boundaries that carry a wall, in the floor's order.
    open_boundaries : dict
        Boundaries without a wall between each open pair, with their clear openings, longest first.
    nets : dict
        Net interior of each region, counter-clockwise; the largest part where walls cut a region in two.
    solid : geometry
        Ground plan of all interior walls.
    cut_off : dict
        Floor in square metres that a region loses to parts too narrow to reach.
    """

    walls: list[BoundarySegment]
    open_boundaries: dict[Pair, list[tuple[BoundarySegment, Segment]]]
    nets: dict[str, Polygon]
    solid: shapely.Geometry
    cut_off: dict[str, float]


def partition_floor(
    floor: FloorRegions, boundaries: Sequence[BoundarySegment], open_pairs: frozenset[Pair]
) -> Partition:
    """Split boundaries into walls and open ones, and take the walls' bodies off the regions.

    Interior walls stand on both sides of their boundary, half in each region; outer walls stand outside the outline
    and take no floor. Net interiors are exact: each region less the union of the wall bodies, with mitred corners.
    """
    narrow: set[BoundarySegment] = set()
    while True:
        walls, gaps = _split(boundaries, open_pairs, narrow)
        solid = _solid([wall for wall in walls if not wall.exterior])
        clear = {pair: [_clear(gap, solid) for _, gap in found] for pair, found in gaps.items()}
        more = {boundary for pair, found in gaps.items() for boundary in _too_narrow(found, clear[pair])}
        if not more:
            break
        narrow |= more
    nets, cut_off = _nets(floor, solid)
    opened = {pair: _longest_first(found, clear[pair]) for pair, found in gaps.items()}
    return Partition(walls, {pair: parts for pair, parts in opened.items() if parts}, nets, solid, cut_off)


_Gaps = list[tuple[BoundarySegment, BoundarySegment]]
"""Boundaries between two rooms, each with the part of it that has no wall."""


def _split(
    boundaries: Sequence[BoundarySegment], open_pairs: frozenset[Pair], narrow: Set[BoundarySegment]
) -> tuple[list[BoundarySegment], dict[Pair, _Gaps]]:
    """Return the walls of a floor, and the gaps between each open pair, but none in a narrow boundary."""
    walls: list[BoundarySegment] = []
    gaps: dict[Pair, _Gaps] = {}
    for boundary in boundaries:
        pair = pair_key(boundary.left, boundary.right) if boundary.right is not None else None
        if pair in open_pairs and pair is not None and boundary.length >= _SHORTEST_OPEN and boundary not in narrow:
            nibs, gap = _with_nibs(boundary)
            walls.extend(nibs)
            gaps.setdefault(pair, []).append((boundary, gap))
        else:
            walls.append(boundary)
    return walls, gaps


def _too_narrow(gaps: _Gaps, clear: Sequence[Segment | None]) -> list[BoundarySegment]:
    """Return the boundaries whose gap is too narrow to pass, but not the widest gap of a pair."""
    widths = [0.0 if segment is None else math.dist(*segment) for segment in clear]
    widest = max(range(len(widths)), key=widths.__getitem__)
    return [
        boundary
        for index, ((boundary, _), width) in enumerate(zip(gaps, widths))
        if width < CLEAR_WIDTH and index != widest
    ]


def _longest_first(gaps: _Gaps, clear: Sequence[Segment | None]) -> list[tuple[BoundarySegment, Segment]]:
    parts = [(gap, segment) for (_, gap), segment in zip(gaps, clear) if segment is not None]
    return sorted(parts, key=lambda part: -part[0].length)


def _with_nibs(boundary: BoundarySegment) -> tuple[list[BoundarySegment], BoundarySegment]:
    """Keep a short wall at both ends of an open structural boundary, which carries the beam above."""
    # Walls that meet an end take half their thickness of the opening as well.
    if not boundary.structural or boundary.length < 2 * NIB + CLEAR_WIDTH + INTERIOR_THICKNESS:
        return [], boundary
    low, high = boundary.at(NIB), boundary.at(boundary.length - NIB)
    nibs = [replace(boundary, end=low), replace(boundary, start=high)]
    return nibs, replace(boundary, start=low, end=high)


def _solid(walls: Sequence[BoundarySegment]) -> shapely.Geometry:
    if not walls:
        return Polygon()
    lines = shapely.line_merge(MultiLineString([LineString([w.start, w.end]) for w in walls]))
    return shapely.union_all(
        shapely.buffer(
            shapely.get_parts(lines), INTERIOR_THICKNESS / 2, cap_style="flat", join_style="mitre", mitre_limit=5.0
        )
    )


def _nets(floor: FloorRegions, solid: shapely.Geometry) -> tuple[dict[str, Polygon], dict[str, float]]:
    polygons = [region.polygon for region in floor.regions]
    bodies = shapely.difference(polygons, solid, grid_size=1e-4)
    nets: dict[str, Polygon] = {}
    cut_off: dict[str, float] = {}
    for region, body in zip(floor.regions, bodies):
        parts = [part for part in shapely.get_parts(body) if part.geom_type == "Polygon"]
        parts.sort(key=lambda part: (-part.area, part.bounds))
        nets[region.id] = orient(parts[0]) if parts else Polygon()
        lost = sum(part.area for part in parts[1:])
        if lost > _SLIVER or not parts:
            cut_off[region.id] = lost if parts else region.polygon.area
    return nets, cut_off


def _clear(boundary: BoundarySegment, solid: shapely.Geometry) -> Segment | None:
    """Return the longest part of a boundary that no wall stands on."""
    line = LineString([boundary.start, boundary.end]).difference(solid)
    pieces = [part for part in shapely.get_parts(line) if part.length > 1e-3]
    if not pieces:
        return None
    longest = max(pieces, key=lambda part: part.length)
    (ax, ay), (bx, by) = longest.coords[0], longest.coords[-1]
    return (round(ax, 4), round(ay, 4)), (round(bx, 4), round(by, 4))


_INSIDE = 0.03  # metres beyond the wall's face at which a boundary is looked up
_SHORTEST = 0.3


def walkable_parts(nets: Mapping[str, Polygon]) -> dict[str, Polygon]:
    """Return the largest part of each net interior in which no way is narrower than `PASSAGE_WIDTH`.

    It is the morphological opening of the net interior by a square; empty where the region is narrower everywhere.
    """
    radius = PASSAGE_WIDTH / 2 - 1e-3
    parts: dict[str, Polygon] = {}
    eroded = shapely.buffer(list(nets.values()), -radius, join_style="mitre")
    for name, shape in zip(nets, eroded, strict=True):
        pieces = [piece for piece in shapely.get_parts(shape) if not piece.is_empty]
        if not pieces:
            parts[name] = Polygon()
            continue
        largest = max(pieces, key=lambda piece: (round(piece.area, 6), piece.bounds))
        grown = largest.buffer(radius, join_style="mitre")
        parts[name] = grown.intersection(nets[name]) if not nets[name].covers(grown) else grown
    return parts


def usable_boundaries(boundaries: Sequence[BoundarySegment], parts: Mapping[str, Polygon]) -> list[BoundarySegment]:
    """Return the parts of boundaries that have walkable floor on every side that is a region.

    Parameters
    ----------
    parts : mapping
        What `walkable_parts` returns; regions that it leaves out (cores) count as walkable.
    """
    usable: list[BoundarySegment] = []
    for boundary in boundaries:
        dx, dy = boundary.direction
        # An outer wall stands outside its boundary, an inner one on both sides of it.
        shift = _INSIDE if boundary.exterior else INTERIOR_THICKNESS / 2 + _INSIDE
        intervals = [(0.0, boundary.length)]
        for region, normal in ((boundary.left, (-dy, dx)), (boundary.right, (dy, -dx))):
            if region is not None and region in parts:
                beside = _intervals(boundary, (normal[0] * shift, normal[1] * shift), parts[region])
                intervals = _common(intervals, beside)
        usable.extend(_piece(boundary, low, high) for low, high in intervals)
    return usable


def _intervals(boundary: BoundarySegment, offset: Point, part: Polygon) -> list[tuple[float, float]]:
    """Return where a boundary, moved by an offset, runs inside a part, with half a wall's thickness at both ends.

    Openings keep at least that from the end of an interval, which elsewhere is the centre line of a wall.
    """
    (x0, y0), (x1, y1) = boundary.start, boundary.end
    moved = LineString([(x0 + offset[0], y0 + offset[1]), (x1 + offset[0], y1 + offset[1])])
    inside = [piece for piece in shapely.get_parts(moved.intersection(part)) if piece.length > 0]
    dx, dy = boundary.direction
    half = INTERIOR_THICKNESS / 2
    intervals = []
    for piece in inside:
        along = sorted((x - x0 - offset[0]) * dx + (y - y0 - offset[1]) * dy for x, y in piece.coords)
        low = 0.0 if along[0] < half + 1e-3 else along[0] - half
        high = boundary.length if along[-1] > boundary.length - half - 1e-3 else along[-1] + half
        intervals.append((low, high))
    return sorted(intervals)


def _common(first: Sequence[tuple[float, float]], second: Sequence[tuple[float, float]]) -> list[tuple[float, float]]:
    common = [(max(a, c), min(b, d)) for a, b in first for c, d in second]
    return [(low, high) for low, high in common if high - low > _SHORTEST]


def _piece(boundary: BoundarySegment, low: float, high: float) -> BoundarySegment:
    if low == 0.0 and high == boundary.length:
        return boundary
    return boundary.part(low, high)
