"""Positions of doors in the walls between two regions, ranked by the wall that they leave for furniture.

The cost of a position is the wall that furniture loses in both rooms: the piece taken, pieces too short to use, and
the adjacent wall where the approach to a door in a corner covers it.
"""

import math
from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
import numpy.typing as npt
import shapely
from shapely.geometry import Polygon

from mansion_msgs_py.shapes import Point, Segment
from mansion_scene.structure.boundaries import BoundarySegment
from mansion_scene.structure.dimensions import APPROACH_DEPTH, DOOR_GAP, INTERIOR_THICKNESS, WALL_END

__all__ = ["Frontage", "Position", "approach_zone", "choose_position", "ranked_positions"]

_POCKET = 0.6  # metres beside a door in which a cupboard against the adjacent wall fits
_SHORT_PIECE = 0.5  # metres of wall in which no furniture fits
_FURNITURE = 40.0  # what a piece of furniture in the way costs: more than any loss of wall
_CORNER_LOSS = 0.3  # metres of the adjacent wall that a door in a corner leaves to shallow furniture only


@dataclass(frozen=True)
class Frontage:
    """The free floor and wall of a region, as the positions of its doors see it.

    Attributes
    ----------
    net : Polygon
        Free floor between the walls.
    weight : float
        Value of a metre of its wall: little in circulation, nothing in a core.
    rings : tuple of arrays
        The boundary rings of `net`, each of shape (n, 2).
    zones : tuple of Polygon
        Approach zones of the doors that it has already.
    taken : tuple of Segment
        Their openings.
    standing : tuple of Polygon
        Footprints of furniture that stands there already.
    """

    net: Polygon
    weight: float
    rings: tuple[npt.NDArray[np.float64], ...]
    zones: tuple[Polygon, ...] = ()
    taken: tuple[Segment, ...] = ()
    standing: tuple[Polygon, ...] = ()

    @classmethod
    def without_doors(cls, net: Polygon, weight: float) -> "Frontage":
        """Return the frontage of a region that has no door yet."""
        shapely.prepare(net)
        return cls(net, weight, tuple(shapely.get_coordinates(ring) for ring in (net.exterior, *net.interiors)))


@dataclass(frozen=True)
class Position:
    """An opening of a boundary, between two distances from its start."""

    boundary: BoundarySegment
    low: float
    high: float

    @property
    def segment(self) -> Segment:
        """The clear opening on the boundary."""
        return self.boundary.at(self.low), self.boundary.at(self.high)

    @property
    def width(self) -> float:
        """Clear width, metres."""
        return self.high - self.low


def approach_zone(
    segment: Segment, inward: Point, *, depth: float = APPROACH_DEPTH, wall: float = INTERIOR_THICKNESS / 2
) -> Polygon:
    """Return the floor in front of an opening, from the wall's face `depth` into the room that `inward` points to."""
    (ax, ay), (bx, by) = segment
    nx, ny = inward
    near, far = wall, wall + depth
    zone: Polygon = shapely.polygons(
        [
            (ax + nx * near, ay + ny * near),
            (bx + nx * near, by + ny * near),
            (bx + nx * far, by + ny * far),
            (ax + nx * far, ay + ny * far),
        ]
    )
    return zone


def _free_intervals(boundary: BoundarySegment, taken: Sequence[Segment], margin: float) -> list[tuple[float, float]]:
    """Return where the boundary has neither wall ends nor openings of its line, with their distances."""
    (dx, dy), (x0, y0) = boundary.direction, boundary.start
    intervals = [(margin, boundary.length - margin)]
    for a, b in taken:
        if any(abs((p[0] - x0) * dy - (p[1] - y0) * dx) > INTERIOR_THICKNESS for p in (a, b)):
            continue
        low, high = sorted((p[0] - x0) * dx + (p[1] - y0) * dy for p in (a, b))
        low, high = low - DOOR_GAP, high + DOOR_GAP
        intervals = [
            piece
            for start, end in intervals
            for piece in ((start, min(end, low)), (max(start, high), end))
            if piece[1] - piece[0] > 1e-6
        ]
    return intervals


def _candidates(boundary: BoundarySegment, taken: Sequence[Segment], width: float, margin: float) -> list[Position]:
    positions = []
    for start, end in _free_intervals(boundary, taken, margin):
        room = end - start - width
        if room < -1e-6:
            continue
        room = max(room, 0.0)
        shift = _POCKET + INTERIOR_THICKNESS / 2 - margin
        offsets = sorted({0.0, min(shift, room), room / 2, max(room - shift, 0.0), room})
        positions += [Position(boundary, start + o, start + o + width) for o in offsets]
    return positions


def _worth(length: float) -> float:
    """Return the value of a piece of wall: nothing when short, and one long piece more than two of half its length."""
    usable = max(length - _SHORT_PIECE, 0.0)
    return usable + 0.01 * usable * usable


def _side_of(frontage: Frontage, position: Position) -> tuple[float, float] | None:
    """Return the distances of an opening from the two ends of the straight side of the room that it lies in."""
    (ax, ay), (bx, by) = position.segment
    dx, dy = position.boundary.direction
    mx, my = (ax + bx) / 2, (ay + by) / 2
    for coords in frontage.rings:
        across = (coords[:, 0] - mx) * dy - (coords[:, 1] - my) * dx
        along = (coords[:, 0] - mx) * dx + (coords[:, 1] - my) * dy
        on_line = np.abs(across) < INTERIOR_THICKNESS
        for i in np.nonzero(on_line[:-1] & on_line[1:])[0]:
            low, high = sorted((float(along[i]), float(along[i + 1])))
            if low <= 0.0 <= high:
                half = position.width / 2
                return -half - low, high - half
    return None


def _loss(frontage: Frontage, position: Position) -> float:
    ends = _side_of(frontage, position) if frontage.weight > 0.0 else None
    if ends is None:
        return 0.0
    side = ends[0] + ends[1] + position.width
    lost = _worth(side) - _worth(ends[0]) - _worth(ends[1])
    return lost + sum(_CORNER_LOSS for end in ends if end < _POCKET)


def _cost(position: Position, sides: Sequence[tuple[Frontage, Point]]) -> float:
    cost = 0.0
    for frontage, inward in sides:
        zone = approach_zone(position.segment, inward)
        cost += frontage.weight * _loss(frontage, position)
        if not frontage.net.covers(zone):
            cost += 20.0 * max(zone.area - frontage.net.intersection(zone).area - 1e-3, 0.0)
        cost += 6.0 * sum(zone.intersection(other).area for other in frontage.zones if zone.intersects(other))
        cost += sum(_FURNITURE + zone.intersection(other).area for other in frontage.standing if zone.intersects(other))
    return cost


def choose_position(
    boundaries: Sequence[BoundarySegment],
    frontages: Mapping[str, Frontage],
    width: float,
    *,
    margin: float = WALL_END,
    within: Polygon | None = None,
    center: Point | None = None,
) -> Position | None:
    """Return the best of `ranked_positions`; ``None`` when no boundary has that much free."""
    ranked = ranked_positions(boundaries, frontages, width, margin=margin, within=within, center=center)
    return ranked[0] if ranked else None


def ranked_positions(
    boundaries: Sequence[BoundarySegment],
    frontages: Mapping[str, Frontage],
    width: float,
    *,
    margin: float = WALL_END,
    within: Polygon | None = None,
    center: Point | None = None,
) -> list[Position]:
    """Return where the boundaries between two regions may open, best first.

    Parameters
    ----------
    boundaries : sequence of BoundarySegment
        Boundaries between one pair of regions.
    frontages : mapping
        Frontages by region id; the doors that both sides have so far are kept clear.
    width : float
        Clear width.
    margin : float
        Wall that stays between the opening and each end of its boundary.
    within : Polygon, optional
        The opening must lie in it, where it is given.
    center : Point, optional
        The opening should be abreast of it, where it is given.
    """
    found: list[tuple[float, int, Position]] = []
    for boundary in boundaries:
        dx, dy = boundary.direction
        sides = [(frontages[boundary.left], (-dy, dx))]
        if boundary.right is not None:
            sides.append((frontages[boundary.right], (dy, -dx)))
        taken = [segment for frontage, _ in sides for segment in frontage.taken]
        pieces = [boundary] if within is None else _clipped(boundary, within)
        for piece in pieces:
            for position in _candidates(piece, taken, width, margin):
                cost = _cost(position, sides) + _off_center(position, center)
                found.append((round(cost, 6), len(found), position))
    return [position for _, _, position in sorted(found, key=lambda entry: entry[:2])]


def _off_center(position: Position, center: Point | None) -> float:
    if center is None:
        return 0.0
    (ax, ay), (bx, by) = position.segment
    dx, dy = position.boundary.direction
    return 2.0 * abs((center[0] - (ax + bx) / 2) * dx + (center[1] - (ay + by) / 2) * dy)


def _clipped(boundary: BoundarySegment, within: Polygon) -> list[BoundarySegment]:
    """Return the part of a boundary inside a polygon."""
    part = shapely.LineString([boundary.start, boundary.end]).intersection(within)
    if part.geom_type != "LineString" or part.is_empty:
        return []
    ends = sorted((math.dist(boundary.start, point), (float(point[0]), float(point[1]))) for point in part.coords)
    return [replace(boundary, start=ends[0][1], end=ends[-1][1])]
