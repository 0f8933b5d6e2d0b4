"""Which boundary stretches carry walls, and the floor that walls leave free: net interiors."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import shapely
from shapely.geometry import LineString, MultiLineString, Polygon
from shapely.geometry.polygon import orient

from mansion_msgs_py.shapes import Segment
from mansion_scene.structure.access import Pair, pair_key
from mansion_scene.structure.dimensions import INTERIOR_THICKNESS, NIB
from mansion_scene.structure.regions import FloorRegions
from mansion_scene.structure.stretches import Stretch

__all__ = ["Partition", "partition_floor"]

_SHORTEST_OPEN = 0.7  # metres; a shorter open boundary keeps its wall
_SLIVER = 0.1  # square metres


@dataclass(frozen=True)
class Partition:
    """The walls of a floor before doors.

    Attributes
    ----------
    walls : list of Stretch
        Stretches that carry a wall, in the floor's order.
    open_stretches : dict
        For each open pair, the clear openings where no wall stands, with their stretches, longest first.
    nets : dict
        Net interior of each region, counter-clockwise; the largest part where walls cut a region in two.
    solid : geometry
        Ground plan of all interior walls.
    cut_off : dict
        Floor in square metres that a region loses to parts too narrow to reach.
    """

    walls: list[Stretch]
    open_stretches: dict[Pair, list[tuple[Stretch, Segment]]]
    nets: dict[str, Polygon]
    solid: shapely.Geometry
    cut_off: dict[str, float]


def partition_floor(floor: FloorRegions, stretches: Sequence[Stretch], open_pairs: frozenset[Pair]) -> Partition:
    """Split stretches into walls and open boundaries, and take the walls' bodies off the regions.

    Interior walls stand astride their stretch, half in each region; outer walls stand outside the outline and take
    nothing. Net interiors are exact: each region less the union of the wall bodies, with mitred corners.
    """
    walls: list[Stretch] = []
    opened: dict[Pair, list[Stretch]] = {}
    for stretch in stretches:
        pair = pair_key(stretch.left, stretch.right) if stretch.right is not None else None
        if pair in open_pairs and pair is not None and stretch.length >= _SHORTEST_OPEN:
            nibs, gap = _with_nibs(stretch)
            walls.extend(nibs)
            opened.setdefault(pair, []).append(gap)
        else:
            walls.append(stretch)
    solid = _solid([wall for wall in walls if not wall.exterior])
    nets, cut_off = _nets(floor, solid)
    return Partition(walls, _clear(opened, solid), nets, solid, cut_off)


def _with_nibs(stretch: Stretch) -> tuple[list[Stretch], Stretch]:
    """Keep a short wall at both ends of an open structural stretch, which carries the beam above."""
    if not stretch.structural or stretch.length < 2 * NIB + _SHORTEST_OPEN:
        return [], stretch
    low, high = stretch.at(NIB), stretch.at(stretch.length - NIB)

    def part(start: tuple[float, float], end: tuple[float, float]) -> Stretch:
        return Stretch(start, end, stretch.left, stretch.right, stretch.exterior, stretch.structural)

    return [part(stretch.start, low), part(high, stretch.end)], part(low, high)


def _solid(walls: Sequence[Stretch]) -> shapely.Geometry:
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


def _clear(
    opened: Mapping[Pair, Sequence[Stretch]], solid: shapely.Geometry
) -> dict[Pair, list[tuple[Stretch, Segment]]]:
    clear: dict[Pair, list[tuple[Stretch, Segment]]] = {}
    for pair, stretches in opened.items():
        parts: list[tuple[Stretch, Segment]] = []
        for stretch in stretches:
            line = LineString([stretch.start, stretch.end]).difference(solid)
            pieces = [part for part in shapely.get_parts(line) if part.length > 1e-3]
            if not pieces:
                continue
            longest = max(pieces, key=lambda part: part.length)
            (ax, ay), (bx, by) = longest.coords[0], longest.coords[-1]
            parts.append((stretch, ((round(ax, 4), round(ay, 4)), (round(bx, 4), round(by, 4)))))
        if parts:
            clear[pair] = sorted(parts, key=lambda part: -part[0].length)
    return clear
